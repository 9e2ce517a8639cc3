//! An unchecked kernel is unsafe to call, and its body is safe code all the same (H27); accesses without checks are unsafe.
use allotrope::prelude::*;

static mut COUNT: usize = 0;

unsafe fn no_promise() {}

#[kernel(unchecked)]
fn count(u: &mut Field<f32, _>) {
    COUNT += 1; //~ E0133
    for i in u {
        u[i] = 1.0;
        no_promise(); //~ E0133
    }
    // SAFETY: it promises nothing.
    unsafe { no_promise() };
}

#[kernel]
fn reads(u: &Field<f32, _>, v: &mut Field<f32, _>) {
    for i in v {
        v[i] = u.get_unchecked(3); //~ E0133
    }
    v.set_unchecked(0, 1.0); //~ E0133
}

fn main() {
    let mut u = Field::<f32, Aos>::new([3]);
    count(&mut u); //~ E0133
    reads(&u.clone(), &mut u);
}
