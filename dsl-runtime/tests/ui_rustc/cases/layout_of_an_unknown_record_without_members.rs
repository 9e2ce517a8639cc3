//! A record that a layout names exists.
use allotrope::prelude::*;

type Elsewhere = layout!(Nodes: dense(ij).aos); //~ E0425

fn main() {}
