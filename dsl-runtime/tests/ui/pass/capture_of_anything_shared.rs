//! References, slices, closures and structs come in from outside.
use allotrope::prelude::*;

struct Setup<'a> {
    scale: f32,
    curve: &'a [f32],
}

#[kernel]
fn apply(u: &mut Field<f32, _>, setup: &Setup<'_>, list: Vec<f32>, names: &[String], pair: (f32, f32)) {
    let local = [1.0, 2.0];
    let curve = setup.curve;
    let at = |k: i32| curve[k as usize];
    for p in u {
        let Setup { scale, .. } = setup;
        u[p] = scale * at(p) + list[0] + names.len() as f32 + pair.1 + local.iter().sum::<f32>();
    }
    drop(list);
}

fn main() {
    let mut u = Field::<f32, Soa>::new([2]);
    let setup = Setup { scale: 2.0, curve: &[10.0, 20.0] };
    apply(&mut u, &setup, vec![100.0], &["a".to_owned()], (0.0, 5.0));
    assert_eq!(u.to_vec(), [129.0, 149.0]);
}
