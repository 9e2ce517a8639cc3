//! `while` and `loop` inside work on the own element.
use allotrope::prelude::*;

#[kernel]
fn roots(u: &mut Field<f64, _>) -> u32 {
    let mut steps = 0;
    for p in u {
        let target = u[p];
        let mut guess = target;
        while (guess * guess - target).abs() > 1e-12 * target {
            guess = 0.5 * (guess + target / guess);
            steps += 1;
        }
        let mut last = u[p];
        loop {
            u[p] = 0.5 * (u[p] + target / u[p]);
            if (u[p] - last).abs() < 1e-12 {
                break;
            }
            last = u[p];
        }
        u[p] -= guess;
    }
    steps
}

fn main() {
    let mut u = Field::<f64, Soa>::new([3]);
    (0..3).for_each(|i| u.set(i, (i + 2) as f64));
    assert!(roots(&mut u) > 6);
    assert!(u.iter().all(|x| x.abs() < 1e-9));
}
