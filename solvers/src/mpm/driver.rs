//! A step of any medium, whatever its dimensions and layouts.

use std::time::{Duration, Instant};

use allotrope::MemoryMap;

use super::medium::{Medium, Particle};
use super::order::Order;
use super::setup::{MpmSetup, Spline};
use super::stability::fastest;
use crate::scene::{Particles, Reorder, Scene, Setup, place};
use crate::{Array, Energy, SceneError, Simulation, State, StepError, Totals};

// Places in `kernel_names`; sorting comes last.
const SCATTER: usize = 0;
const GRID: usize = 1;
const GATHER: usize = 2;
const MATERIAL: usize = 3;

/// A medium with its clock, and the order in which its particles were given.
pub(super) struct Driver {
    medium: Box<dyn Medium>,
    scene: Scene,
    setup: MpmSetup,
    /// For each place in memory, which particle of the scene lies there.
    identity: Vec<u32>,
    order: Order,
    steps: u64,
}

impl Driver {
    pub(super) fn new<M: Medium + 'static>(
        scene: &Scene,
        setup: &MpmSetup,
        particles: &Particles,
    ) -> Result<Self, SceneError> {
        let medium = M::new(scene, setup, particles).map_err(|fault| SceneError::memory(&*scene.file, fault))?;
        let identity = (0..particles.x.len() as u32).collect();
        let medium = Box::new(medium);
        Ok(Self { medium, scene: scene.clone(), setup: setup.clone(), identity, order: Order::default(), steps: 0 })
    }

    /// Whether the particles are to be sorted before the next step.
    fn is_sorted_now(&mut self) -> bool {
        match self.setup.reorder {
            Reorder::Never => false,
            Reorder::Every(steps) => self.steps.is_multiple_of(steps),
            Reorder::Decayed => self.order.has_decayed(self.steps, self.medium.len(), |place| self.medium.cell(place)),
        }
    }

    fn sort(&mut self) {
        let order = self.medium.reorder();
        self.identity = order.old_places().iter().map(|&old| self.identity[old as usize]).collect();
        if self.setup.reorder == Reorder::Decayed {
            self.order.renew(self.medium.len(), |place| self.medium.cell(place));
        }
    }

    fn particle(&self, place: usize) -> Particle {
        self.medium.particle(place)
    }

    /// The mass of a particle in kg.
    fn mass(&self, particle: &Particle) -> f64 {
        self.setup.particle_volume() * self.setup.materials[particle.material as usize].density
    }

    fn in_given_order<T: Clone + Default>(&self, value: impl Fn(Particle) -> T) -> Vec<T> {
        let mut values = vec![T::default(); self.identity.len()];
        for (place, &particle) in self.identity.iter().enumerate() {
            values[particle as usize] = value(self.particle(place));
        }
        values
    }

    /// Why the step that was just done is meaningless: the first particle, in the order given, that is not finite or
    /// too fast.
    fn broken(&self, count: u32) -> StepError {
        let fastest = self.setup.dx() / self.scene.dt;
        let speed = |v: [f64; 3]| v.iter().map(|component| component * component).sum::<f64>().sqrt();
        let sound = |particle: &Particle| {
            particle.x.iter().all(|x| x.is_finite()) && speed(particle.v) <= fastest * (1.0 - 1e-6)
        };
        let particles = self.in_given_order(|particle| particle);
        let first = particles.iter().position(|particle| !sound(particle)).unwrap_or(0);
        let Particle { x, v, material, .. } = particles[first];
        let material = &self.setup.materials[material as usize].name;
        let at = place(x, self.scene.dimensions);
        let what = if x.iter().chain(&v).all(|component| component.is_finite()) {
            format!(
                "particle {first} ({material}) at {at} moved more than a cell, at {:.3} of at most {fastest:.3}",
                speed(v)
            )
        } else {
            format!(
                "particle {first} ({material}) is not finite, at {at} with the velocity {}",
                place(v, self.scene.dimensions)
            )
        };
        let others = if count > 1 { format!(", and {} others", count - 1) } else { String::new() };
        StepError { step: self.steps, message: format!("{what}{others}; make `dt = {}` smaller", self.scene.dt) }
    }
}

impl Simulation for Driver {
    fn kernel_names(&self) -> &'static [&'static str] {
        match (self.medium.deforms(), self.setup.reorder != Reorder::Never) {
            (false, false) => &["scatter", "grid", "gather"],
            (false, true) => &["scatter", "grid", "gather", "sort"],
            (true, false) => &["scatter", "grid", "gather", "material"],
            (true, true) => &["scatter", "grid", "gather", "material", "sort"],
        }
    }

    fn step_timed(&mut self, spent: &mut [Duration]) -> Result<(), StepError> {
        let (mut last, sort) = (Instant::now(), spent.len() - 1);
        let mut lap = |kernel: usize| {
            let now = Instant::now();
            spent[kernel] += now - last;
            last = now;
        };
        if self.is_sorted_now() {
            self.sort();
        }
        if self.setup.reorder != Reorder::Never {
            lap(sort);
        }
        self.medium.clear();
        lap(GRID);
        self.medium.scatter();
        lap(SCATTER);
        let suspicious = self.medium.update_grid(self.time());
        lap(GRID);
        self.medium.gather();
        lap(GATHER);
        if self.medium.deforms() {
            self.medium.deform();
            lap(MATERIAL);
        }
        self.steps += 1;
        // At the rim of a body nodes of hardly any mass may be fast while no particle is.
        let broken = if suspicious > 0 { self.medium.broken() } else { 0 };
        if broken == 0 { Ok(()) } else { Err(self.broken(broken)) }
    }

    fn steps(&self) -> u64 {
        self.steps
    }

    fn dt(&self) -> f64 {
        self.scene.dt
    }

    fn time(&self) -> f64 {
        self.steps as f64 * self.scene.dt
    }

    fn largest_dt(&self) -> Option<f64> {
        Some(self.setup.largest_step(fastest(&self.velocities())))
    }

    fn dimensions(&self) -> usize {
        self.scene.dimensions
    }

    fn particles(&self) -> usize {
        self.medium.len()
    }

    fn grid_shape(&self) -> Vec<usize> {
        self.setup.grid[..self.scene.dimensions].to_vec()
    }

    fn extent(&self) -> [f64; 3] {
        self.setup.extent()
    }

    /// A particle comes to rest where all nodes around it belong to the wall.
    fn margin(&self) -> f64 {
        (self.setup.wall as f64 - 0.5 * self.setup.transfer.spline.width() as f64) * self.setup.dx()
    }

    fn spacing(&self) -> f64 {
        self.setup.spacing * self.setup.dx()
    }

    fn bytes(&self) -> usize {
        self.medium.bytes()
    }

    fn memory_maps(&self) -> Vec<(&'static str, MemoryMap<'_>)> {
        let [particles, grid] = self.medium.memory_maps();
        vec![("particles", particles), ("grid", grid)]
    }

    fn positions(&self) -> Vec<[f64; 3]> {
        self.in_given_order(|particle| particle.x)
    }

    fn velocities(&self) -> Vec<[f64; 3]> {
        self.in_given_order(|particle| particle.v)
    }

    fn particle_arrays(&self) -> Vec<Array> {
        let single = |v: [f64; 3]| v.map(|component| component as f32);
        let vectors = |name, of: fn(&Particle) -> [f64; 3]| {
            let values = self.in_given_order(|particle| single(of(&particle)));
            match self.scene.dimensions {
                2 => Array::floats(name, values.into_iter().map(|[x, y, _]| [x, y])),
                _ => Array::floats(name, values),
            }
        };
        vec![
            vectors("position", |particle| particle.x),
            vectors("velocity", |particle| particle.v),
            Array::floats("pressure", self.in_given_order(|particle| [particle.pressure as f32])),
            Array::whole("material", self.material_of()),
        ]
    }

    fn grid_arrays(&self) -> Vec<Array> {
        self.medium.nodes()
    }

    fn materials(&self) -> Vec<String> {
        self.setup.materials.iter().map(|material| material.name.clone()).collect()
    }

    fn material_of(&self) -> Vec<u32> {
        self.in_given_order(|particle| particle.material)
    }

    fn pressures(&self) -> Vec<f64> {
        self.in_given_order(|particle| particle.pressure)
    }

    fn save(&self) -> State {
        let mut arrays = self.medium.members();
        arrays.push(Array::whole("identity", self.identity.clone()));
        arrays.push(self.order.save());
        State { steps: self.steps, arrays }
    }

    fn restore(&mut self, state: &State) -> Result<(), String> {
        let identity = state.whole("identity", self.identity.len())?;
        let mut sorted = identity.to_vec();
        sorted.sort_unstable();
        if !sorted.iter().copied().eq(0..identity.len() as u32) {
            return Err("array `identity` does not name each particle once".into());
        }
        let order = Order::restore(state)?;
        self.medium.set_members(state)?;
        self.identity.copy_from_slice(identity);
        self.order = order;
        self.steps = state.steps;
        Ok(())
    }

    fn energy(&self) -> Energy {
        let mut energy = Energy::default();
        for particle in (0..self.medium.len()).map(|place| self.particle(place)) {
            energy.kinetic += 0.5 * self.mass(&particle) * particle.v.iter().map(|v| v * v).sum::<f64>();
            energy.elastic += self.setup.particle_volume() * particle.elastic;
        }
        energy
    }

    /// The affine part of the angular momentum is `m dx^2 / 4` times twice the antisymmetric part of the gradient
    /// (quadratic splines; a third for cubic ones; Jiang et al. 2017, "An angular momentum conserving affine-particle-in-cell method").
    fn totals(&self) -> Totals {
        let moment = match self.setup.transfer.spline {
            Spline::Linear => 0.0,
            Spline::Quadratic => self.setup.dx().powi(2) / 4.0,
            Spline::Cubic => self.setup.dx().powi(2) / 3.0,
        };
        let mut totals = Totals { mass: 0.0, momentum: [0.0; 3], angular_momentum: [0.0; 3] };
        for place in 0..self.medium.len() {
            let particle = self.particle(place);
            let Particle { x, v, c, .. } = particle;
            let mass = self.mass(&particle);
            let inertia = mass * moment;
            totals.mass += mass;
            for axis in 0..3 {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                totals.momentum[axis] += mass * v[axis];
                totals.angular_momentum[axis] += mass * (x[a] * v[b] - x[b] * v[a]) + inertia * (c[b][a] - c[a][b]);
            }
        }
        totals
    }

    fn grid_mass(&self) -> Option<f64> {
        Some(self.medium.grid_mass())
    }
}
