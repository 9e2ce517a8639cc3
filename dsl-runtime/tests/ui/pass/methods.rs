//! A kernel may be a method, and reads its `self`.
use allotrope::prelude::*;

struct Solver {
    step: i32,
    table: Vec<i32>,
}

impl Solver {
    #[kernel]
    fn advance(&self, u: &mut Field<i32, _>) {
        for p in u {
            u[p] += self.step * self.table[p as usize % self.table.len()] + Self::bias(p);
        }
    }

    #[kernel]
    fn count(&mut self, u: &Field<i32, _>) {
        let mut sum = 0;
        for p in u {
            sum += u[p];
        }
        self.step = sum;
    }

    fn bias(p: i32) -> i32 {
        -p
    }
}

fn main() {
    let mut solver = Solver { step: 2, table: vec![10, 20] };
    let mut u = Field::<i32, Soa>::new([3]);
    solver.advance(&mut u);
    assert_eq!(u.to_vec(), [20, 39, 18]);
    solver.count(&u);
    assert_eq!(solver.step, 77);
}
