//! What a generic kernel is called with must be what it asks for.
use allotrope::prelude::*;

#[kernel]
fn scale<T: Real>(u: &mut Field<T, _>, by: T) {
    for i in u {
        u[i] *= by;
    }
}

#[kernel]
fn any<T: allotrope::Element>(u: &mut Field<T, _>, by: T) {
    for i in u {
        u[i] += by; //~ E0368
    }
}

#[kernel]
fn same<L: Layout<I>>(u: &Field<f32, L>, v: &mut Field<f32, L>) {
    for i in v {
        v[i] = u[i];
    }
}

fn main() {
    scale(&mut Field::<i32, Soa>::new([3]), 2); //~ E0277
    scale::<f64>(&mut Field::<f32, Soa>::new([3]), 2.0); //~ E0308
    same(&Field::<f32, Aos>::new([3]), &mut Field::<f32, Soa>::new([3])); //~ E0308
}
