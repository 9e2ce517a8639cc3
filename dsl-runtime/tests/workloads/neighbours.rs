//! Smoothed particles in sorted cells: count, running sum, stable sort of whole records, density and acceleration over neighbours.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[derive(Record, Clone, Copy, Default)]
struct Particle {
    x: Vec2,
    v: Vec2,
    a: Vec2,
    rho: f32,
    p: f32,
}

/// A grid of cells as wide as the support radius.
#[derive(Clone, Copy)]
struct Bins {
    side: i32,
    radius: f32,
}

impl Bins {
    fn cell(&self, x: Vec2) -> IVec2 {
        (x / self.radius).floor().as_ivec2()
    }
    fn key(&self, x: Vec2) -> i32 {
        let cell = self.cell(x);
        cell.x * self.side + cell.y
    }
    /// The number of a cell beside that of a place, where there is one.
    fn neighbour(&self, x: Vec2, by: IVec2) -> Option<i32> {
        let cell = self.cell(x) + by;
        let inside = cell.cmpge(IVec2::ZERO).all() && cell.cmplt(IVec2::splat(self.side)).all();
        inside.then_some(cell.x * self.side + cell.y)
    }
}

/// The cubic spline in two dimensions, and the fluid.
#[derive(Clone, Copy)]
struct Cubic {
    radius: f32,
    mass: f32,
    rho0: f32,
    bulk: f32,
    gravity: Vec2,
}

impl Cubic {
    fn w(&self, r: f32) -> f32 {
        let (h, q) = (0.5 * self.radius, r / (0.5 * self.radius));
        let sigma = 10.0 / (7.0 * std::f32::consts::PI * h * h);
        sigma * if q < 1.0 { 1.0 - 1.5 * q * q + 0.75 * q * q * q } else { 0.25 * (2.0 - q).max(0.0).powi(3) }
    }
    fn gradient(&self, d: Vec2) -> Vec2 {
        let (h, r) = (0.5 * self.radius, d.length());
        let q = r / h;
        let sigma = 10.0 / (7.0 * std::f32::consts::PI * h * h);
        let slope = if q < 1.0 { -3.0 * q + 2.25 * q * q } else { -0.75 * (2.0 - q).max(0.0).powi(2) };
        if r > 0.0 { sigma * slope / (h * r) * d } else { Vec2::ZERO }
    }
    fn viscosity(&self, d: Vec2, v: Vec2) -> f32 {
        let approach = v.dot(d).min(0.0);
        -0.1 * approach / (d.length_squared() + 0.01 * self.radius * self.radius)
    }
}

#[kernel]
fn count(ps: &Field<Particle, _>, count: &mut Field<u32, _>, bins: &Bins) {
    for p in ps {
        count[bins.key(ps.x[p])] += 1;
    }
}

#[kernel]
fn density(ps: &mut Field<Particle, _>, start: &Field<u32, _>, bins: &Bins, k: &Cubic) {
    for p in ps {
        let x = ps.x[p];
        let mut rho = 0.0;
        for (a, b) in unroll!(-1..2, -1..2) {
            let Some(cell) = bins.neighbour(x, ivec2(a, b)) else { continue };
            for q in start[cell]..start[cell + 1] {
                rho += k.mass * k.w((x - ps.x[q]).length());
            }
        }
        ps.rho[p] = rho;
        ps.p[p] = k.bulk * ((rho / k.rho0).powi(7) - 1.0);
    }
}

#[kernel]
fn acceleration(ps: &mut Field<Particle, _>, start: &Field<u32, _>, bins: &Bins, k: &Cubic) {
    for p in ps {
        let (x, v) = (ps.x[p], ps.v[p]);
        let own = ps.p[p] / ps.rho[p].powi(2);
        let mut a = k.gravity;
        for (i, j) in unroll!(-1..2, -1..2) {
            let Some(cell) = bins.neighbour(x, ivec2(i, j)) else { continue };
            for q in start[cell]..start[cell + 1] {
                let d = x - ps.x[q];
                a -= k.mass * (own + ps.p[q] / ps.rho[q].powi(2) + k.viscosity(d, v - ps.v[q])) * k.gradient(d);
            }
        }
        ps.a[p] = a;
    }
}

#[test]
fn forces_are_those_of_all_pairs() {
    fn run<P: Layout<I>, C: Layout<I>>() {
        let bins = Bins { side: 5, radius: 0.2 };
        let k = Cubic { radius: 0.2, mass: 0.01, rho0: 1.0, bulk: 0.1, gravity: vec2(0.0, -9.8) };
        let start: Vec<Particle> = (0..120)
            .map(|n| Particle {
                x: 0.5 + 0.49 * vec2(scattered(n), scattered(n + 500)),
                v: vec2(scattered(n + 1000), scattered(n + 1500)),
                ..Particle::default()
            })
            .collect();
        on_threads(|| {
            let mut ps = Field::<Particle, P>::new([start.len()]);
            start.iter().enumerate().for_each(|(n, particle)| ps.set(n, *particle));
            let mut counts = Field::<u32, C>::new([26]);
            count(&ps, &mut counts, &bins);
            let found = |key: i32| start.iter().filter(|p| bins.key(p.x) == key).count() as u32;
            assert!((0..25).all(|key| counts.get(key) == found(key)));
            assert_eq!(counts.exclusive_scan(), 120);
            ps.reorder_by_key(|p| bins.key(p.x) as u32);
            density(&mut ps, &counts, &bins, &k);
            acceleration(&mut ps, &counts, &bins, &k);

            let sorted: Vec<Particle> = ps.iter().collect();
            let rho: Vec<f32> =
                sorted.iter().map(|p| sorted.iter().map(|q| k.mass * k.w((p.x - q.x).length())).sum()).collect();
            close(&ps.members().rho.to_vec(), &rho, 1e-5);
            let pressure = |rho: f32| k.bulk * ((rho / k.rho0).powi(7) - 1.0);
            let force = |n: usize| {
                let (p, own) = (&sorted[n], pressure(rho[n]) / rho[n].powi(2));
                let pair = |(m, q): (usize, &Particle)| {
                    let d = p.x - q.x;
                    k.mass * (own + pressure(rho[m]) / rho[m].powi(2) + k.viscosity(d, p.v - q.v)) * k.gradient(d)
                };
                k.gravity - sorted.iter().enumerate().map(pair).sum::<Vec2>()
            };
            let expected: Vec<f32> = (0..sorted.len()).flat_map(|n| force(n).to_array()).collect();
            let ours: Vec<f32> = sorted.iter().flat_map(|p| p.a.to_array()).collect();
            close(&ours, &expected, 1e-4);
        });
    }
    run::<Aos, Aos>();
    run::<Soa, Aos>();
    run::<AoSoA<8>, Soa>();
}
