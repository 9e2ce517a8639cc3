//! All that is wrong with a layout is told at once, and nothing else.
use allotrope::prelude::*;

fn main() {
    let mut field = Field::<f32, layout!(dense(xi).dense(ij, 0).dens(ij, 4).place([v]).aos)>::new([8, 8]);
    field.set([1, 2], 3.0);
    let values: Vec<f32> = field.relayout::<layout!(dense(ij).dense(ij))>().to_vec();
    assert_eq!(values.len(), 64);
}
