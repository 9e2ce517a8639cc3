//! Words that the language has and this version has not.
use allotrope::prelude::*;

type Sparse = layout!(pointer(ij, 16).dense(ij, 8).aos);
type Masked = layout!(dense(ij).bitmasked(ij, 8).soa);
type Hashed = layout!(hash(ijk).dense(ijk, 8).aos);
type Lists = layout!(dense(i).dynamic(j, 1024, chunk = 32).aos);
type Branches = layout!(dense(ij).aos + dense(ij, 8).soa);

fn main() {}
