//! A kernel stands in a function.
use allotrope::prelude::*;

fn main() {
    #[kernel]
    fn fill(u: &mut Field<i32, _>) {
        #[kernel]
        fn inner(u: &mut Field<i32, _>) {
            for p in u {
                u[p] = p;
            }
        }
        inner(u);
        for p in u {
            u[p] += 1;
        }
    }
    let mut u = Field::<i32, Soa>::new([2]);
    fill(&mut u);
    assert_eq!(u.to_vec(), [1, 2]);
}
