//! A struct is no function.
use allotrope::prelude::*;

#[func]
struct Wrong;

fn main() {}
