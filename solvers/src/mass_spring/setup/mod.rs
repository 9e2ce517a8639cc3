//! What a scene of this solver has beside what all scenes have.

mod bodies;

use std::sync::Arc;

use allotrope::prelude::*;

use super::parameters::{Attractor, Integrator, Method, Parameters};
use super::records::{Bond, Mass, Spring};
use super::system::springs_within;
use super::topology::{EditError, check_masses, check_springs};
use crate::SceneError;
use crate::linear::Stop;
use crate::scene::{Basics, Keys, Particles, Scene, Setup};
use bodies::{Builder, read_bond};

/// The keys of a scene that [`read`] reads.
pub(super) const KEYS: &[&str] = &[
    "size",
    "walls",
    "drag",
    "attractor",
    "integrator",
    "unstable",
    "solve",
    "mass",
    "chain",
    "sheet",
    "spring",
    "connect",
];

/// Integrators by their names in scenes.
const INTEGRATORS: &[(&str, Integrator)] = &[
    ("symplectic-euler", Integrator::SymplecticEuler),
    ("forward-euler", Integrator::ForwardEuler),
    ("half-implicit-euler", Integrator::Beta(0.5)),
    ("backward-euler", Integrator::Beta(1.0)),
    ("implicit-midpoint", Integrator::ImplicitMidpoint),
];

/// What a scene of this solver has beside what all scenes have.
#[derive(Clone, Debug)]
pub struct SpringsSetup {
    /// Metres along each axis of the domain; zero along axes that the scene does not have.
    pub size: [f64; 3],
    /// How time runs, and what acts on masses.
    pub parameters: Parameters,
    /// The masses with which the scene starts.
    pub masses: Vec<Mass>,
    /// The springs between them.
    pub springs: Vec<Spring>,
}

/// Reads this solver's part of a scene.
pub(super) fn read(keys: &Keys<'_>, basics: &Basics<'_>) -> Result<Arc<dyn Setup>, SceneError> {
    let dimensions = basics.dimensions;
    let size = keys.required_vector("size", dimensions, if dimensions == 2 { "[1, 1]" } else { "[1, 1, 1]" })?;
    if size[..dimensions].iter().any(|side| *side <= 0.0) {
        return Err(keys.fault("size", "must be above zero along each axis"));
    }
    let mut builder = Builder::new(dimensions);
    keys.all_tables("mass")?.iter().try_for_each(|keys| builder.mass(keys))?;
    keys.all_tables("chain")?.iter().try_for_each(|keys| builder.chain(keys))?;
    keys.all_tables("sheet")?.iter().try_for_each(|keys| builder.sheet(keys))?;
    keys.all_tables("spring")?.iter().try_for_each(|keys| builder.spring(keys))?;
    let Builder { masses, mut springs, .. } = builder;
    if masses.is_empty() {
        return Err(keys.fault("mass", "is missing; write `[[mass]]`, `[[chain]]` or `[[sheet]]`"));
    }
    if let Some(keys) = keys.table("connect", &["radius", "stiffness", "rest", "dashpot"])? {
        let radius = keys.positive("radius", "0.15")?;
        let (bond, rest) = read_bond(&keys)?;
        let x: Vec<DVec3> = masses.iter().map(|mass| mass.x).collect();
        let joined = springs_within(&x, &springs, 0, radius, |d| Bond { rest: rest.unwrap_or(d), ..bond });
        springs.extend(joined);
    }
    check(keys, &masses, &springs)?;
    let parameters = read_parameters(keys, basics, size)?;
    Ok(Arc::new(SpringsSetup { size, parameters, masses, springs }))
}

fn check(keys: &Keys<'_>, masses: &[Mass], springs: &[Spring]) -> Result<(), SceneError> {
    check_masses(masses).and_then(|()| check_springs(masses.len(), &[], springs)).map_err(|error| match error {
        EditError::Mass { .. } => keys.fault("mass", format!("is wrong: {error}")),
        _ => keys.fault("spring", format!("is wrong, counted with those of chains and sheets before it: {error}")),
    })
}

fn read_parameters(keys: &Keys<'_>, basics: &Basics<'_>, size: [f64; 3]) -> Result<Parameters, SceneError> {
    let default = Parameters::default();
    let attractor = match keys.table("attractor", &["place", "strength"])? {
        None => default.attractor,
        Some(keys) => Attractor {
            place: keys.required_vector("place", basics.dimensions, "[0.5, 0.5]")?.into(),
            strength: keys.positive("strength", "100.0")?,
        },
    };
    let (method, stop) = match keys.table("solve", &["method", "damping", "tolerance", "iterations"])? {
        None => (default.method, default.stop),
        Some(keys) => read_solve(&keys, default.stop)?,
    };
    let walls = if keys.flag("walls")?.unwrap_or(false) {
        // Along an axis that the scene does not have there is nothing to stop.
        let high = |side: f64| if side > 0.0 { side } else { f64::INFINITY };
        [DVec3::from(size.map(|side| if side > 0.0 { 0.0 } else { f64::NEG_INFINITY })), size.map(high).into()]
    } else {
        default.walls
    };
    Ok(Parameters {
        dt: basics.dt,
        integrator: keys.choice("integrator", "integrator", INTEGRATORS)?.unwrap_or(default.integrator),
        method,
        stop,
        gravity: basics.gravity.into(),
        drag: keys.between("drag", 0.0, 1e6)?.unwrap_or(0.0),
        attractor,
        walls,
        unstable: keys.flag("unstable")?.unwrap_or(false),
    })
}

fn read_solve(keys: &Keys<'_>, default: Stop) -> Result<(Method, Stop), SceneError> {
    let damping = keys.between("damping", 1e-3, 2.0)?;
    let methods = [("conjugate-gradients", false), ("jacobi", true)];
    let method = match (keys.choice("method", "method", &methods)?.unwrap_or(false), damping) {
        (true, damping) => Method::Jacobi(damping.unwrap_or(1.0)),
        (false, None) => Method::ConjugateGradients,
        (false, Some(_)) => return Err(keys.fault("damping", "is for `method = \"jacobi\"`")),
    };
    let tolerance = keys.between("tolerance", 1e-15, 0.5)?.unwrap_or(default.tolerance);
    let most = keys.whole("iterations", 1, 1 << 30)?.map_or(default.most, |most| most as usize);
    Ok((method, Stop { tolerance, most, ..default }))
}

impl Setup for SpringsSetup {
    fn extent(&self) -> [f64; 3] {
        self.size
    }

    fn particles(&self, _scene: &Scene) -> Result<Particles, SceneError> {
        Ok(Particles {
            x: self.masses.iter().map(|mass| mass.x.to_array()).collect(),
            v: self.masses.iter().map(|mass| mass.v.to_array()).collect(),
            c: vec![[[0.0; 3]; 3]; self.masses.len()],
            material: vec![0; self.masses.len()],
        })
    }
}
