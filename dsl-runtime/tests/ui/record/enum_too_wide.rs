//! An enum is stored in 32 bits at most.
use allotrope::prelude::*;

#[derive(Element, Clone, Copy)]
#[repr(u64)]
enum Wide {
    Nothing,
}

fn main() {}
