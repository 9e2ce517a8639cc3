//! A kernel stands in any module, under any path.
use allotrope::prelude::*;

mod outer {
    pub mod inner {
        use allotrope::prelude as language;

        #[language::kernel]
        pub(crate) fn fill(u: &mut language::Field<i32, _>, v: &allotrope::Field<i32, _>) {
            for p in u {
                u[p] = v[p] + super::ONE;
            }
        }
    }
    const ONE: i32 = 1;
}

fn main() {
    let (mut u, v) = (Field::<i32, Soa>::new([2]), Field::<i32, Aos>::new([2]));
    outer::inner::fill(&mut u, &v);
    assert_eq!(u.to_vec(), [1, 1]);
}
