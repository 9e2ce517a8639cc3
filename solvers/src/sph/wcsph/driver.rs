//! A run of a scene, whatever its dimensions, its layout and the way neighbours are found.

use std::time::{Duration, Instant};

use allotrope::MemoryMap;
use allotrope::prelude::*;
use allotrope::spatial::*;

use super::{Extremes, Fault, Fluid, Medium, Part, TimeStep, Walls, WcsphSetup};
use crate::mpm::convert::{saved_vectors, triple, vector, vectors};
use crate::scene::{Particles, Reorder, Scene, place};
use crate::sph::Smoothing;
use crate::sph::neighbours::{Crowded, Options, Search};
use crate::{Array, Energy, SceneError, Simulation, State, StepError, Totals, Values};

/// A fluid with its clock, and the order in which its particles were given.
pub(super) struct Driver<X: Spatial, P: Layout<I>, S: Search<X>> {
    medium: Medium<X, P, S>,
    scene: Scene,
    setup: WcsphSetup,
    /// For each place in memory, which particle of the scene lies there.
    identity: Vec<u32>,
    steps: u64,
    time: f64,
    last: TimeStep,
}

impl<X: Spatial, P: Layout<I>, S: Search<X>> Driver<X, P, S> {
    pub(super) fn new(scene: &Scene, setup: &WcsphSetup, particles: &Particles) -> Result<Self, SceneError> {
        let memory = |fault: allotrope::ShapeError| SceneError::memory(&*scene.file, fault.to_string());
        let fluid = fluid::<X>(scene, setup)?;
        let places = setup.wall_places().map_err(|fault| scene.fault("sides", fault))?;
        let places: Vec<X::Vec<f32>> = places.into_iter().map(vector::<X, f32>).collect();
        let walls = Walls::new(&places, &fluid.kernel).map_err(memory)?;
        let start: Vec<_> =
            particles.x.iter().zip(&particles.v).map(|(x, v)| (vector::<X, f32>(*x), vector::<X, f32>(*v))).collect();
        let options = Options {
            skin: (setup.skin * setup.smoothing_length()) as f32,
            most: setup.most,
            upper: vector::<X, f32>(setup.extent),
            ..Options::new(start.len())
        };
        let medium = Medium::new(&start, walls, fluid, setup.density, &options).map_err(memory)?;
        let speed_squared = start.iter().map(|(_, v)| v.length_squared()).fold(0.0, f32::max);
        let extremes = Extremes { acceleration_squared: 0.0, speed_squared, density: fluid.density };
        let bound = TimeStep::new(&fluid, &extremes, f64::INFINITY).dt;
        if !setup.adaptive && scene.dt > bound {
            let message = format!(
                "is unstable: with sound at {:.4} and smoothing lengths of {:.6} it must be at most {bound:.3e}, or \
                 `adaptive = true`",
                setup.fluid.sound,
                setup.smoothing_length()
            );
            return Err(scene.fault(format!("dt = {:e}", scene.dt), message));
        }
        let identity = (0..start.len() as u32).collect();
        let last = TimeStep { dt: scene.dt, ..TimeStep::new(&fluid, &extremes, scene.dt) };
        Ok(Self { medium, scene: scene.clone(), setup: setup.clone(), identity, steps: 0, time: 0.0, last })
    }

    /// Whether the particles are to be sorted before the next step.
    fn is_sorted_now(&self) -> bool {
        if self.medium.must_be_sorted() {
            return self.medium.is_stale();
        }
        match self.setup.reorder {
            Reorder::Never => false,
            Reorder::Every(steps) => self.steps.is_multiple_of(steps),
            Reorder::Decayed => true,
        }
    }

    /// Gravity, which may rise from zero: by `(sin((t / T - 1 / 2) pi) + 1) / 2` (Adami et al. 2012).
    fn gravity(&self) -> X::Vec<f32> {
        let gravity = vector::<X, f32>(self.scene.gravity);
        if self.time >= self.setup.ramp {
            return gravity;
        }
        gravity * (0.5 * (((self.time / self.setup.ramp - 0.5) * std::f64::consts::PI).sin() + 1.0)) as f32
    }

    fn find_neighbours(&mut self) -> Result<(), StepError> {
        if self.is_sorted_now() {
            let order = self.medium.sort();
            self.identity = order.old_places().iter().map(|&old| self.identity[old as usize]).collect();
        }
        if self.medium.is_stale() {
            self.medium.find_neighbours().map_err(|crowded| self.fault(Fault::Crowded(crowded)))?;
        }
        Ok(())
    }

    /// Why the next step cannot be done, with the first particle to blame, in the order given.
    fn fault(&self, fault: Fault) -> StepError {
        let step = self.steps + 1;
        let dimensions = self.scene.dimensions;
        let message = match fault {
            Fault::Crowded(Crowded { particle, count, most, in_cell }) => {
                let at = place(triple::<X>(self.medium.particles.get(particle).x), dimensions);
                let (where_, cure) = if in_cell {
                    ("in its cell", "take a layout with sorted cells")
                } else {
                    ("near it", "raise `neighbours.most`")
                };
                let named = self.identity[particle];
                format!(
                    "particle {named} at {at} has {count} particles {where_}, and its list holds at most {most}; {cure}"
                )
            }
            Fault::Broken(count) => {
                let most = (self.setup.smoothing_length() / self.last.dt) as f32;
                let particles = self.medium.particles.iter().zip(&self.identity);
                let is_broken = |v: X::Vec<f32>, rho: f32| !(v.length() <= most && rho > 0.0);
                let broken = particles.filter(|(particle, _)| is_broken(particle.v, particle.rho));
                let named = broken.min_by_key(|(_, identity)| **identity);
                let others = if count > 1 { format!(", and {} others", count - 1) } else { String::new() };
                let what = named.map_or("a particle".to_string(), |(particle, identity)| {
                    let (x, v) =
                        (place(triple::<X>(particle.x), dimensions), place(triple::<X>(particle.v), dimensions));
                    format!("particle {identity} at {x} has the velocity {v} and the density {}", particle.rho)
                });
                format!(
                    "{what}{others}: it is not finite, or moves more than a smoothing length a step; make `dt = {}` \
                     smaller, or `fluid.sound` larger",
                    self.scene.dt
                )
            }
        };
        StepError { step, message }
    }

    fn in_given_order<T: Clone + Default>(&self, value: impl Fn(super::Particle<X>) -> T) -> Vec<T> {
        let mut values = vec![T::default(); self.identity.len()];
        for (particle, &identity) in self.medium.particles.iter().zip(&self.identity) {
            values[identity as usize] = value(particle);
        }
        values
    }
}

/// The constants of a scene's fluid.
fn fluid<X: Spatial>(scene: &Scene, setup: &WcsphSetup) -> Result<Fluid<X>, SceneError> {
    let kernel = Smoothing::new(setup.kernel, X::RANK, setup.smoothing_length());
    let kernel = kernel.ok_or_else(|| scene.fault("dimensions", "are not 1, 2 or 3"))?;
    let (exponent, stiffness, offset) = setup.fluid.law();
    Ok(Fluid {
        kernel,
        mass: (setup.fluid.density * setup.particle_volume()) as f32,
        density: setup.fluid.density as f32,
        sound: setup.fluid.sound as f32,
        exponent,
        stiffness: stiffness as f32,
        offset: offset as f32,
        suction: setup.fluid.suction,
        gravity: vector::<X, f32>(scene.gravity),
        alpha: setup.fluid.alpha as f32,
        beta: setup.fluid.beta as f32,
        local_sound: setup.fluid.local_sound,
        tension: setup.fluid.tension as f32,
        boundary: setup.boundary,
        friction: setup.friction as f32,
    })
}

impl<X: Spatial, P: Layout<I>, S: Search<X>> Simulation for Driver<X, P, S> {
    fn kernel_names(&self) -> &'static [&'static str] {
        Part::NAMES
    }

    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        let mut last = Instant::now();
        let mut lap = |part: Part| {
            let now = Instant::now();
            spent[part as usize] += now - last;
            last = now;
        };
        self.find_neighbours()?;
        lap(Part::Neighbours);
        self.medium.fluid.gravity = self.gravity();
        let advanced = self.medium.advance(self.scene.dt, self.setup.adaptive, lap);
        self.last = advanced.map_err(|fault| self.fault(fault))?;
        self.steps += 1;
        self.time += self.last.dt;
        Ok(())
    }

    fn steps(&self) -> u64 {
        self.steps
    }

    fn dt(&self) -> f64 {
        self.last.dt
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn largest_dt(&self) -> Option<f64> {
        Some(self.last.force.min(self.last.sound).min(self.last.speed))
    }

    fn step_bounds(&self) -> Vec<(&'static str, f64)> {
        let TimeStep { force, sound, speed, .. } = self.last;
        vec![("forces", force), ("sound", sound), ("speed", speed)]
    }

    fn dimensions(&self) -> usize {
        self.scene.dimensions
    }

    fn particles(&self) -> usize {
        self.identity.len()
    }

    fn extent(&self) -> [f64; 3] {
        self.setup.extent
    }

    fn spacing(&self) -> f64 {
        self.setup.spacing
    }

    fn bytes(&self) -> usize {
        self.medium.bytes()
    }

    fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        self.medium.memory_maps()
    }

    fn positions(&self) -> Vec<[f64; 3]> {
        self.in_given_order(|particle| triple::<X>(particle.x))
    }

    fn velocities(&self) -> Vec<[f64; 3]> {
        self.in_given_order(|particle| triple::<X>(particle.v))
    }

    fn particle_arrays(&self) -> Vec<Array> {
        vec![
            vectors::<X>("position", self.in_given_order(|particle| particle.x).into_iter()),
            vectors::<X>("velocity", self.in_given_order(|particle| particle.v).into_iter()),
            Array::floats("density", self.in_given_order(|particle| [particle.rho])),
            Array::floats("pressure", self.pressures().into_iter().map(|pressure| [pressure as f32])),
        ]
    }

    fn materials(&self) -> Vec<String> {
        vec!["fluid".into()]
    }

    fn pressures(&self) -> Vec<f64> {
        self.in_given_order(|particle| f64::from(particle.push) * f64::from(particle.rho).powi(2))
    }

    fn save(&self) -> State {
        let particles = &self.medium.particles;
        let mut arrays = vec![
            vectors::<X>("position", particles.iter().map(|particle| particle.x)),
            vectors::<X>("velocity", particles.iter().map(|particle| particle.v)),
            Array::floats("density", particles.iter().map(|particle| [particle.rho])),
            Array::whole("identity", self.identity.clone()),
            Array { name: "clock", components: 1, values: Values::F64(vec![self.time, self.last.dt, self.moved()]) },
        ];
        if S::LASTS {
            arrays.push(vectors::<X>("anchor", self.medium.anchors.iter()));
        }
        State { steps: self.steps, arrays }
    }

    fn restore(&mut self, state: &State) -> Result<(), String> {
        let count = self.identity.len();
        let identity = state.whole("identity", count)?;
        let mut sorted = identity.to_vec();
        sorted.sort_unstable();
        if !sorted.iter().copied().eq(0..count as u32) {
            return Err("array `identity` does not name each particle once".into());
        }
        let x = saved_vectors::<X>(state, "position", count)?;
        let v = saved_vectors::<X>(state, "velocity", count)?;
        let rho = state.floats::<1>("density", count)?;
        let anchor = S::LASTS.then(|| saved_vectors::<X>(state, "anchor", count)).transpose()?;
        let clock = state.arrays.iter().find(|array| array.name == "clock").map(|array| &array.values);
        let Some(Values::F64(clock)) = clock else { return Err("array `clock` is missing".into()) };
        let &[time, dt, moved] = &clock[..] else { return Err("array `clock` does not hold three values".into()) };
        for (p, &[rho]) in rho.iter().enumerate() {
            self.medium.set(p, x(p), v(p), rho);
        }
        self.medium.moved = moved as f32;
        if let Some(anchor) = anchor {
            (0..count).for_each(|p| self.medium.anchors.set(p, anchor(p)));
        }
        self.identity.copy_from_slice(identity);
        (self.steps, self.time, self.last.dt) = (state.steps, time, dt);
        self.medium.restore_neighbours().map_err(|crowded| crowded.to_string())
    }

    /// Kinetic, and what the equation of state stores: the integral of `p / rho^2`.
    fn energy(&self) -> Energy {
        let fluid = &self.medium.fluid;
        let (mass, density, stiffness) = (f64::from(fluid.mass), f64::from(fluid.density), f64::from(fluid.stiffness));
        let stored = |rho: f64| {
            let (ratio, power) = (rho / density, fluid.exponent - 1);
            let own = if power == 0 { ratio.ln() } else { (ratio.powi(power) - 1.0) / f64::from(power) };
            stiffness / density * (own + f64::from(fluid.offset) * (1.0 / ratio - 1.0))
        };
        let mut energy = Energy::default();
        for particle in self.medium.particles.iter() {
            let v = triple::<X>(particle.v);
            energy.kinetic += 0.5 * mass * v.iter().map(|v| v * v).sum::<f64>();
            energy.elastic += mass * stored(f64::from(particle.rho));
        }
        energy
    }

    fn totals(&self) -> Totals {
        let mass = f64::from(self.medium.fluid.mass);
        let mut totals = Totals { mass: 0.0, momentum: [0.0; 3], angular_momentum: [0.0; 3] };
        for particle in self.medium.particles.iter() {
            let (x, v) = (triple::<X>(particle.x), triple::<X>(particle.v));
            totals.mass += mass;
            for axis in 0..3 {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                totals.momentum[axis] += mass * v[axis];
                totals.angular_momentum[axis] += mass * (x[a] * v[b] - x[b] * v[a]);
            }
        }
        totals
    }
}

impl<X: Spatial, P: Layout<I>, S: Search<X>> Driver<X, P, S> {
    /// How far particles may have moved since neighbours were found; not a number of its own where they never last.
    fn moved(&self) -> f64 {
        if S::LASTS { f64::from(self.medium.moved) } else { 0.0 }
    }
}
