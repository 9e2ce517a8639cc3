//! Masses and springs against closed forms, in all layouts.

#[path = "mass_spring/edits.rs"]
mod edits;
#[path = "mass_spring/layouts.rs"]
mod layouts;
#[path = "mass_spring/matrix.rs"]
mod matrix;
#[path = "mass_spring/oscillator.rs"]
mod oscillator;
#[path = "mass_spring/scenes.rs"]
mod scenes;
#[path = "mass_spring/stability.rs"]
mod stability;
#[path = "mass_spring/surroundings.rs"]
mod surroundings;

use allotrope::prelude::*;
use allotrope_solvers::mass_spring::{Bond, Integrator, List, Mass, MassSpring, Parameters, Spring};

type Plain = MassSpring<Aos, List>;

fn mass(x: DVec3, mass: f64) -> Mass {
    Mass { x, mass, ..Mass::default() }
}

fn fixed(x: DVec3) -> Mass {
    Mass { fixed: true, ..mass(x, 1.0) }
}

fn spring(a: u32, b: u32, stiffness: f64, rest: f64) -> Spring {
    Spring { ends: [a, b], bond: Bond { stiffness, rest, dashpot: 0.0 } }
}

/// A mass of 1 kg on a spring of length 10 m, displaced by so much from its rest at 0: so far from where it turns round,
/// the spring is linear.
fn oscillator(k: f64, x: f64, v: f64, parameters: Parameters) -> Plain {
    let moving = Mass { v: dvec3(v, 0.0, 0.0), ..mass(dvec3(x, 0.0, 0.0), 1.0) };
    Plain::with(parameters, &[fixed(dvec3(-10.0, 0.0, 0.0)), moving], &[spring(0, 1, k, 10.0)]).unwrap()
}

fn with(integrator: Integrator, dt: f64) -> Parameters {
    Parameters { integrator, dt, unstable: true, ..Parameters::default() }
}

fn advance<M: Layout<I>, C: allotrope_solvers::mass_spring::Connectivity<M>>(
    system: &mut MassSpring<M, C>,
    steps: usize,
) {
    (0..steps).for_each(|_| _ = system.step().unwrap());
}

/// A net of `n x m` masses of different weights, shaken, with springs along and across, none of them slack at first.
fn net(n: usize, m: usize) -> (Vec<Mass>, Vec<Spring>) {
    let at = |i: usize, j: usize| (i * m + j) as u32;
    let shake = |seed, place| random::<DVec3>(seed, place) - 0.5;
    let masses = (0..n * m).map(|place| {
        let x = dvec3((place / m) as f64, (place % m) as f64, 0.0) + shake(1, place) * 0.2;
        Mass { x, v: shake(2, place), mass: 0.5 + random::<f64>(3, place), ..Mass::default() }
    });
    let mut springs = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        let mut join = |there: bool, i2: usize, j2: usize, rest: f64| {
            if there {
                let stiffness = 20.0 + 10.0 * random::<f64>(4, springs.len());
                let bond = Bond { stiffness, rest, dashpot: 0.3 };
                springs.push(Spring { ends: [at(i, j), at(i2, j2)], bond });
            }
        };
        join(i + 1 < n, i + 1, j, 0.6);
        join(j + 1 < m, i, j + 1, 0.6);
        join(i + 1 < n && j + 1 < m, i + 1, j + 1, 0.8);
        join(i + 1 < n && j > 0, i + 1, j.wrapping_sub(1), 0.8);
    }
    (masses.collect(), springs)
}
