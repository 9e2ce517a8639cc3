//! Everything that a program in Allotrope uses: `use allotrope::prelude::*;`

pub use crate::axes::{Axes, I, Ij, Ijk, Ijkl, O};
pub use crate::field::Field;
pub use crate::launch::cpu::Cpu;
pub use crate::layout::{AoSoA, Aos, Blocked, Layout, Morton, Soa, Sparse, SparseHash, Split};
pub use crate::random::random;
pub use crate::real::Real;
pub use crate::record::Record;
pub use crate::schedule::{Scatter, Schedule};
pub use allotrope_macros::{Element, Record, func, kernel, layout};
pub use glam::{
    BVec2, BVec3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4, IVec2, IVec3, IVec4, Mat2, Mat3, Mat4, Quat, UVec2,
    UVec3, UVec4, Vec2, Vec3, Vec3A, Vec4, dvec2, dvec3, dvec4, ivec2, ivec3, ivec4, mat2, mat3, mat4, quat, uvec2,
    uvec3, uvec4, vec2, vec3, vec3a, vec4,
};
