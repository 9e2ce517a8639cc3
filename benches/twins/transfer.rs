//! Particle to grid and back, for particles and grids in several layouts. Addresses go without checks but one a particle.

use allotrope::prelude::*;

use super::versions;
use allotrope_lab::workloads::transfer::{Mpm, quadratic_weights};

/// Particles in some layout.
pub trait Points {
    /// How many.
    fn len(&self) -> usize;
    /// Position of particle `p`, which is below `len`.
    fn x(&self, p: usize) -> Vec2;
    /// Its velocity.
    fn v(&self, p: usize) -> Vec2;
    /// Its affine matrix.
    fn c(&self, p: usize) -> Mat2;
    /// Its volume ratio.
    fn j(&self, p: usize) -> f32;
    /// Puts all of them.
    fn put(&mut self, p: usize, x: Vec2, v: Vec2, c: Mat2, j: f32);
}

/// Nine floats a particle, interleaved: x, v, c, j.
#[derive(Clone)]
pub struct Interleaved(pub Vec<[f32; 9]>);

/// A list for each member.
#[derive(Clone)]
pub struct Apart {
    /// Positions.
    pub x: Vec<[f32; 2]>,
    /// Velocities.
    pub v: Vec<[f32; 2]>,
    /// Affine matrices.
    pub c: Vec<[f32; 4]>,
    /// Volume ratios.
    pub j: Vec<f32>,
}

/// Sixteen particles, each member apart.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct Block {
    /// Positions.
    pub x: [[f32; 2]; 16],
    /// Velocities.
    pub v: [[f32; 2]; 16],
    /// Affine matrices.
    pub c: [[f32; 4]; 16],
    /// Volume ratios.
    pub j: [f32; 16],
}

/// Blocks of sixteen particles.
#[derive(Clone)]
pub struct Blocks(pub Vec<Block>);

impl Points for Interleaved {
    #[inline(always)]
    fn len(&self) -> usize {
        self.0.len()
    }
    #[inline(always)]
    fn x(&self, p: usize) -> Vec2 {
        // SAFETY: `p` is below `len`.
        let r = unsafe { self.0.get_unchecked(p) };
        vec2(r[0], r[1])
    }
    #[inline(always)]
    fn v(&self, p: usize) -> Vec2 {
        // SAFETY: `p` is below `len`.
        let r = unsafe { self.0.get_unchecked(p) };
        vec2(r[2], r[3])
    }
    #[inline(always)]
    fn c(&self, p: usize) -> Mat2 {
        // SAFETY: `p` is below `len`.
        let r = unsafe { self.0.get_unchecked(p) };
        Mat2::from_cols_array(&[r[4], r[5], r[6], r[7]])
    }
    #[inline(always)]
    fn j(&self, p: usize) -> f32 {
        // SAFETY: `p` is below `len`.
        unsafe { self.0.get_unchecked(p)[8] }
    }
    #[inline(always)]
    fn put(&mut self, p: usize, x: Vec2, v: Vec2, c: Mat2, j: f32) {
        let c = c.to_cols_array();
        // SAFETY: `p` is below `len`.
        unsafe { *self.0.get_unchecked_mut(p) = [x.x, x.y, v.x, v.y, c[0], c[1], c[2], c[3], j] };
    }
}

impl Points for Apart {
    #[inline(always)]
    fn len(&self) -> usize {
        self.j.len()
    }
    #[inline(always)]
    fn x(&self, p: usize) -> Vec2 {
        // SAFETY: `p` is below `len`, which all lists share.
        Vec2::from_array(unsafe { *self.x.get_unchecked(p) })
    }
    #[inline(always)]
    fn v(&self, p: usize) -> Vec2 {
        // SAFETY: as above.
        Vec2::from_array(unsafe { *self.v.get_unchecked(p) })
    }
    #[inline(always)]
    fn c(&self, p: usize) -> Mat2 {
        // SAFETY: as above.
        Mat2::from_cols_array(unsafe { self.c.get_unchecked(p) })
    }
    #[inline(always)]
    fn j(&self, p: usize) -> f32 {
        // SAFETY: as above.
        unsafe { *self.j.get_unchecked(p) }
    }
    #[inline(always)]
    fn put(&mut self, p: usize, x: Vec2, v: Vec2, c: Mat2, j: f32) {
        // SAFETY: as above.
        unsafe {
            *self.x.get_unchecked_mut(p) = x.to_array();
            *self.v.get_unchecked_mut(p) = v.to_array();
            *self.c.get_unchecked_mut(p) = c.to_cols_array();
            *self.j.get_unchecked_mut(p) = j;
        }
    }
}

impl Points for Blocks {
    #[inline(always)]
    fn len(&self) -> usize {
        16 * self.0.len()
    }
    #[inline(always)]
    fn x(&self, p: usize) -> Vec2 {
        // SAFETY: `p` is below `len`.
        Vec2::from_array(unsafe { *self.0.get_unchecked(p / 16).x.get_unchecked(p % 16) })
    }
    #[inline(always)]
    fn v(&self, p: usize) -> Vec2 {
        // SAFETY: `p` is below `len`.
        Vec2::from_array(unsafe { *self.0.get_unchecked(p / 16).v.get_unchecked(p % 16) })
    }
    #[inline(always)]
    fn c(&self, p: usize) -> Mat2 {
        // SAFETY: `p` is below `len`.
        Mat2::from_cols_array(unsafe { self.0.get_unchecked(p / 16).c.get_unchecked(p % 16) })
    }
    #[inline(always)]
    fn j(&self, p: usize) -> f32 {
        // SAFETY: `p` is below `len`.
        unsafe { *self.0.get_unchecked(p / 16).j.get_unchecked(p % 16) }
    }
    #[inline(always)]
    fn put(&mut self, p: usize, x: Vec2, v: Vec2, c: Mat2, j: f32) {
        // SAFETY: `p` is below `len`.
        unsafe {
            let block = self.0.get_unchecked_mut(p / 16);
            *block.x.get_unchecked_mut(p % 16) = x.to_array();
            *block.v.get_unchecked_mut(p % 16) = v.to_array();
            *block.c.get_unchecked_mut(p % 16) = c.to_cols_array();
            *block.j.get_unchecked_mut(p % 16) = j;
        }
    }
}

/// Nodes of a square grid in some layout, row by row.
pub trait Nodes {
    /// Adds to node `n`, which exists.
    fn add(&mut self, n: usize, v: Vec2, m: f32);
    /// The velocity of node `n`, which exists.
    fn v(&self, n: usize) -> Vec2;
}

/// Velocity and mass of each node together.
pub struct NodeRecords(pub Vec<[f32; 3]>);

/// Velocities and masses apart.
pub struct NodeLists {
    /// Velocities.
    pub v: Vec<[f32; 2]>,
    /// Masses.
    pub m: Vec<f32>,
}

impl Nodes for NodeRecords {
    #[inline(always)]
    fn add(&mut self, n: usize, v: Vec2, m: f32) {
        // SAFETY: the caller's node exists.
        let node = unsafe { self.0.get_unchecked_mut(n) };
        node[0] += v.x;
        node[1] += v.y;
        node[2] += m;
    }
    #[inline(always)]
    fn v(&self, n: usize) -> Vec2 {
        // SAFETY: the caller's node exists.
        let node = unsafe { self.0.get_unchecked(n) };
        vec2(node[0], node[1])
    }
}

impl Nodes for NodeLists {
    #[inline(always)]
    fn add(&mut self, n: usize, v: Vec2, m: f32) {
        // SAFETY: the caller's node exists in both lists.
        unsafe {
            let to = self.v.get_unchecked_mut(n);
            to[0] += v.x;
            to[1] += v.y;
            *self.m.get_unchecked_mut(n) += m;
        }
    }
    #[inline(always)]
    fn v(&self, n: usize) -> Vec2 {
        // SAFETY: the caller's node exists.
        Vec2::from_array(unsafe { *self.v.get_unchecked(n) })
    }
}

/// The first node of a particle's stencil, and the particle's place relative to it.
///
/// # Panics
/// Where the stencil leaves the grid: positions are data, so that even an expert checks them once a particle.
#[inline(always)]
fn stencil(x: Vec2, side: usize, mpm: &Mpm) -> (usize, Vec2) {
    let x = x * mpm.inv_dx;
    let base = (x - 0.5).as_ivec2();
    let inside = base.x >= 0 && base.y >= 0 && base.x as usize + 2 < side && base.y as usize + 2 < side;
    if !inside {
        outside();
    }
    (base.x as usize * side + base.y as usize, x - base.as_vec2())
}

#[cold]
fn outside() -> ! {
    panic!("a particle has left the grid")
}

versions! {
    /// Scatters mass and momentum.
    pub fn particle_to_grid<; P: Points, N: Nodes>(points: &P, grid: &mut N, side: usize, mpm: &Mpm) {
        let mpm = *mpm;
        for p in 0..points.len() {
            let (base, fx) = stencil(points.x(p), side, &mpm);
            let w = quadratic_weights(fx);
            let momentum = mpm.mass * points.v(p);
            let affine = mpm.stress(points.j(p)) + mpm.mass * points.c(p);
            for i in 0..3 {
                for j in 0..3 {
                    let dpos = (vec2(i as f32, j as f32) - fx) * mpm.dx;
                    let weight = w[i].x * w[j].y;
                    grid.add(base + i * side + j, weight * (momentum + affine * dpos), weight * mpm.mass);
                }
            }
        }
    }
}

versions! {
    /// Gathers velocities and moves the particles.
    pub fn grid_to_particle<; P: Points, N: Nodes>(points: &mut P, grid: &N, side: usize, mpm: &Mpm) {
        let mpm = *mpm;
        for p in 0..points.len() {
            let x = points.x(p);
            let (base, fx) = stencil(x, side, &mpm);
            let w = quadratic_weights(fx);
            let (mut v, mut c) = (Vec2::ZERO, Mat2::ZERO);
            for i in 0..3 {
                for j in 0..3 {
                    let dpos = vec2(i as f32, j as f32) - fx;
                    let weighted = w[i].x * w[j].y * grid.v(base + i * side + j);
                    v += weighted;
                    c += Mat2::from_cols(weighted * dpos.x, weighted * dpos.y);
                }
            }
            let c = c * (4.0 * mpm.inv_dx);
            let j = points.j(p) * (1.0 + mpm.dt * (c.x_axis.x + c.y_axis.y));
            points.put(p, x + mpm.dt * v, v, c, j);
        }
    }
}
