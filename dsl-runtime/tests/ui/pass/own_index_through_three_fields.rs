//! What is written at the own index may be read there.
use allotrope::prelude::*;

#[kernel]
fn chain(a: &mut Field<i32, _>, b: &mut Field<i32, _>, c: &mut Field<i32, _>) {
    for p in a {
        b[p] = a[p] + 1;
        c[p] = b[p] * 2;
        a[p] = c[p] - b[p];
    }
}

fn main() {
    let (mut a, mut b, mut c) = (Field::<i32, Soa>::new([3]), Field::<i32, Aos>::new([3]), Field::<i32, Soa>::new([3]));
    (0..3).for_each(|i| a.set(i, i as i32));
    chain(&mut a, &mut b, &mut c);
    assert_eq!((a.to_vec(), c.to_vec()), (vec![1, 2, 3], vec![2, 4, 6]));
}
