//! Globals are Rust's: their names are no fields.
use allotrope::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicI32, Ordering};

const TABLE: [i32; 3] = [5, 6, 7];
static OFFSET: i32 = 100;
static VISITED: AtomicI32 = AtomicI32::new(0);
static LAST: Mutex<Vec<i32>> = Mutex::new(Vec::new());

#[kernel]
fn look_up(u: &mut Field<i32, _>) {
    const LOCAL: i32 = 1000;
    for p in u {
        u[p] = TABLE[p as usize % TABLE.len()] + OFFSET + LOCAL;
        VISITED.fetch_add(1, Ordering::Relaxed);
        if p == 2 {
            LAST.lock().unwrap().push(p);
        }
    }
}

fn main() {
    let mut u = Field::<i32, Soa>::new([4]);
    look_up(&mut u);
    assert_eq!(u.to_vec(), [1105, 1106, 1107, 1105]);
    assert_eq!(VISITED.load(Ordering::Relaxed), 4);
    assert_eq!(*LAST.lock().unwrap(), [2]);
}
