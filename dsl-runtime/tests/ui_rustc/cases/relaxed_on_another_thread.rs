//! Elements that iterations meet in are reached by the iteration's own thread: alone, it may do so plainly.
use allotrope::prelude::*;

#[kernel]
fn wrong(at: &Field<u32, _>, marks: &mut Field<u32, _>) {
    #[relaxed]
    for p in at {
        let place = at[p];
        std::thread::scope(|threads| {
            threads.spawn(|| marks[place] = 1); //~ E0277
        });
    }
}

fn main() {}
