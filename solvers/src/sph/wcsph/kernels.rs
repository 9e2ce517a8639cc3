//! The step, in a plane and in space, whatever the layout and the way neighbours are found.

use allotrope::prelude::*;
use allotrope::spatial::*;

use super::clock::Extremes;
use super::{Boundary, Fluid, Particle, WallParticle};
use crate::sph::Smoothing;
use crate::sph::neighbours::{Sorted, Walk};

/// Notes where the particles are.
#[kernel(contract)]
pub fn note<X: Spatial>(particles: &Field<Particle<X>, _>, x: &mut Field<X::Vec<f32>, Soa>) {
    for p in x {
        x[p] = particles.x[p];
    }
}

/// Density by summation, `rho_a = sum_b m W_ab`, and what follows from it (Monaghan 1992).
#[kernel(contract)]
pub fn sum_density<X: Spatial, W: Walk<X>>(
    particles: &mut Field<Particle<X>, _>,
    near: &Field<u32, W::Layout, W::Axes>,
    walk: &W,
    walls: &Field<WallParticle<X>, Soa>,
    near_walls: &Field<u32, Soa>,
    walk_walls: &Sorted<X>,
    fluid: &Fluid<X>,
) {
    for p in particles {
        let x = particles.x[p];
        let mut sum = 0.0;
        walk.each(near, p, x, |q| sum += fluid.kernel.weight((x - particles.x[q]).length_squared()));
        let mut wall = 0.0;
        if fluid.boundary == Boundary::Volumes {
            walk_walls.each(near_walls, p, x, |b| {
                wall += walls.volume[b] * fluid.kernel.weight((x - walls.x[b]).length_squared());
            });
        }
        let rho = fluid.mass * sum + fluid.density * wall;
        let (push, sound) = fluid.state(rho);
        particles.rho[p] = rho;
        particles.push[p] = push;
        particles.sound[p] = sound;
    }
}

/// Density by the continuity equation, `d rho_a / dt = sum_b m (v_a - v_b) . grad_a W_ab`, over a step, and what follows from
/// it (Monaghan 1992).
#[allow(clippy::too_many_arguments, reason = "two sets of neighbours")]
#[kernel(contract)]
pub fn advance_density<X: Spatial, W: Walk<X>>(
    particles: &mut Field<Particle<X>, _>,
    near: &Field<u32, W::Layout, W::Axes>,
    walk: &W,
    walls: &Field<WallParticle<X>, Soa>,
    near_walls: &Field<u32, Soa>,
    walk_walls: &Sorted<X>,
    fluid: &Fluid<X>,
    dt: f32,
) {
    for p in particles {
        let (x, v) = (particles.x[p], particles.v[p]);
        let mut sum = 0.0;
        walk.each(near, p, x, |q| {
            let d = x - particles.x[q];
            let squared = d.length_squared();
            if squared < fluid.kernel.support_squared() {
                sum += (v - particles.v[q]).dot(d) * fluid.kernel.slope(squared);
            }
        });
        let mut wall = 0.0;
        if fluid.boundary == Boundary::Volumes {
            walk_walls.each(near_walls, p, x, |b| {
                let d = x - walls.x[b];
                wall += walls.volume[b] * v.dot(d) * fluid.kernel.slope(d.length_squared());
            });
        }
        let rho = particles.rho[p] + dt * (fluid.mass * sum + fluid.density * wall);
        let (push, sound) = fluid.state(rho);
        particles.rho[p] = rho;
        particles.push[p] = push;
        particles.sound[p] = sound;
    }
}

/// What follows from the density.
#[kernel(contract)]
pub fn renew_state<X: Spatial>(particles: &mut Field<Particle<X>, _>, fluid: &Fluid<X>) {
    for p in particles {
        let (push, sound) = fluid.state(particles.rho[p]);
        particles.push[p] = push;
        particles.sound[p] = sound;
    }
}

/// Accelerations: `-sum_b m (p_a / rho_a^2 + p_b / rho_b^2 + Pi_ab) grad_a W_ab + g` (Monaghan 1992), surface tension
/// `-kappa sum_b m W_ab (x_a - x_b)` (Becker & Teschner 2007, which is not normalised), and walls. Returns what bounds the
/// step.
#[kernel(contract)]
pub fn accelerate<X: Spatial, W: Walk<X>>(
    particles: &mut Field<Particle<X>, _>,
    near: &Field<u32, W::Layout, W::Axes>,
    walk: &W,
    walls: &Field<WallParticle<X>, Soa>,
    near_walls: &Field<u32, Soa>,
    walk_walls: &Sorted<X>,
    fluid: &Fluid<X>,
) -> Extremes {
    let (mut strongest, mut fastest, mut densest) = (0.0f32, 0.0f32, 0.0f32);
    for p in particles {
        let (x, v) = (particles.x[p], particles.v[p]);
        let (rho, push, sound) = (particles.rho[p], particles.push[p], particles.sound[p]);
        let mut pairs = X::Vec::<f32>::zero();
        walk.each(near, p, x, |q| {
            let d = x - particles.x[q];
            let squared = d.length_squared();
            if squared < fluid.kernel.support_squared() {
                let approach = (v - particles.v[q]).dot(d);
                let viscosity = fluid.viscosity(approach, squared, sound + particles.sound[q], rho + particles.rho[q]);
                let mut factor = (push + particles.push[q] + viscosity) * fluid.kernel.slope(squared);
                if fluid.tension > 0.0 {
                    factor += fluid.tension * fluid.kernel.weight(squared);
                }
                pairs += d * factor;
            }
        });
        let pressure = push * (rho * rho);
        let weight = fluid.gravity * rho;
        let inv_rest = (fluid.density * fluid.density).recip();
        let mut wall = X::Vec::<f32>::zero();
        walk_walls.each(near_walls, p, x, |b| {
            let d = x - walls.x[b];
            let squared = d.length_squared();
            if squared < fluid.kernel.support_squared() {
                wall -= d * match fluid.boundary {
                    Boundary::Volumes => {
                        let viscosity = fluid.friction * fluid.viscosity(v.dot(d), squared, 2.0 * sound, 2.0 * rho);
                        // The pressure beside a wall goes on in it as in water at rest; where it would pull, there is none.
                        let beyond = (pressure - weight.dot(d)).max(0.0) * inv_rest;
                        let factor = push.max(0.0) + beyond + viscosity;
                        fluid.density * walls.volume[b] * factor * fluid.kernel.slope(squared)
                    }
                    Boundary::Repulsion => -fluid.repulsion(squared),
                };
            }
        });
        let a = fluid.gravity + wall - pairs * fluid.mass;
        particles.a[p] = a;
        strongest.max_assign(a.length_squared());
        fastest.max_assign(v.length_squared());
        densest.max_assign(rho);
    }
    Extremes { acceleration_squared: strongest, speed_squared: fastest, density: densest }
}

/// Velocities over a step. Returns the square of the fastest, and how many particles would move farther than `most` or are not finite.
#[kernel(contract)]
pub fn kick<X: Spatial>(particles: &mut Field<Particle<X>, _>, dt: f32, most: f32) -> (f32, u32) {
    let (mut fastest, mut broken) = (0.0f32, 0);
    for p in particles {
        let v = particles.v[p] + particles.a[p] * dt;
        particles.v[p] = v;
        fastest.max_assign(v.length_squared());
        // False for what is not a number.
        let sound = (v * dt).length_squared() <= most * most && particles.rho[p] > 0.0;
        broken += u32::from(!sound);
    }
    (fastest, broken)
}

/// Positions over a step, with the velocities at its end (symplectic Euler).
#[kernel(contract)]
pub fn drift<X: Spatial>(particles: &mut Field<Particle<X>, _>, dt: f32) {
    for p in particles {
        particles.x[p] += particles.v[p] * dt;
    }
}

/// The volumes for which particles of walls stand, `1 / sum_c W_bc` (Akinci et al. 2012).
#[kernel(contract)]
pub fn measure<X: Spatial>(
    walls: &mut Field<WallParticle<X>, Soa>,
    near: &Field<u32, Soa>,
    walk: &Sorted<X>,
    kernel: &Smoothing,
) {
    for b in walls {
        let x = walls.x[b];
        let mut sum = 0.0;
        walk.each(near, b, x, |c| sum += kernel.weight((x - walls.x[c]).length_squared()));
        walls.volume[b] = 1.0 / sum;
    }
}
