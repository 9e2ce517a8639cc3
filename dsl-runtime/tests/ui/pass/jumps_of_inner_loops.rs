//! Inner loops may be left, by their labels too.
use allotrope::prelude::*;

#[kernel]
fn search(u: &mut Field<i32, _>) {
    for p in u {
        'rows: for a in 0..10 {
            for b in 0..10 {
                if b > a {
                    continue 'rows;
                }
                if a * b > 20 {
                    break 'rows;
                }
                u[p] += 1;
            }
        }
        let found = 'found: {
            if u[p] > 3 {
                break 'found u[p];
            }
            0
        };
        u[p] = loop {
            if found > p {
                break found;
            }
        };
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([2]);
    search(&mut u);
    assert_eq!(u.to_vec(), [20, 20]);
}
