//! A layout that names members says whose they are.
use allotrope::prelude::*;

type Nobody = layout!(Nodes: dense(ij).place([v], [m])); //~ E0422 E0425

fn main() {}
