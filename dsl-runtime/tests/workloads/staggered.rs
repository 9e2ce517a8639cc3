//! Velocities on the faces of cells: semi-Lagrangian advection through a function of a member, walls, divergence.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[func]
fn bilinear(q: Read<f32, _, Ij>, x: Vec2) -> f32 {
    let base = x.floor();
    let f = x - base;
    let c = base.as_ivec2();
    let low = q.clamped(c) * (1.0 - f.x) + q.clamped(c + ivec2(1, 0)) * f.x;
    let high = q.clamped(c + ivec2(0, 1)) * (1.0 - f.x) + q.clamped(c + ivec2(1, 1)) * f.x;
    low * (1.0 - f.y) + high * f.y
}

#[kernel]
fn advect_u(u: &Field<f32, _, Ij>, v: &Field<f32, _, Ij>, next: &mut Field<f32, _, Ij>, dt_over_dx: f32) {
    for (i, j) in next {
        let x = vec2(i as f32, j as f32 + 0.5);
        let velocity = |x: Vec2| vec2(bilinear(u, x - vec2(0.0, 0.5)), bilinear(v, x - vec2(0.5, 0.0)));
        let middle = x - 0.5 * dt_over_dx * velocity(x);
        next[(i, j)] = bilinear(u, x - dt_over_dx * velocity(middle) - vec2(0.0, 0.5));
    }
}

#[kernel]
fn no_flux(u: &mut Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>, n: i32, m: i32) {
    for j in 0..m {
        u[(0, j)] = 0.0;
        u[(n, j)] = 0.0;
    }
    for i in 0..n {
        v[(i, 0)] = 0.0;
        v[(i, m)] = 0.0;
    }
}

#[kernel]
fn divergence(u: &Field<f32, _, Ij>, v: &Field<f32, _, Ij>, div: &mut Field<f32, _, Ij>) {
    for (i, j) in div {
        div[(i, j)] = u[(i + 1, j)] - u[(i, j)] + v[(i, j + 1)] - v[(i, j)];
    }
}

/// Values by rows, and their extents.
struct Faces(Vec<f32>, usize, usize);

impl Faces {
    fn at(&self, i: i32, j: i32) -> f32 {
        self.0[i.clamp(0, self.1 as i32 - 1) as usize * self.2 + j.clamp(0, self.2 as i32 - 1) as usize]
    }
    fn bilinear(&self, x: f32, y: f32) -> f32 {
        let (i, j) = (x.floor() as i32, y.floor() as i32);
        let (a, b) = (x - x.floor(), y - y.floor());
        let low = self.at(i, j) * (1.0 - a) + self.at(i + 1, j) * a;
        let high = self.at(i, j + 1) * (1.0 - a) + self.at(i + 1, j + 1) * a;
        low * (1.0 - b) + high * b
    }
}

#[test]
fn a_step_of_advection_is_as_in_plain_rust() {
    fn run<U: Layout<Ij>, V: Layout<Ij>>() {
        let (n, m) = (9, 7);
        let faces = |n: usize, m: usize, seed: usize| Faces((0..n * m).map(|c| scattered(c + seed)).collect(), n, m);
        let (mut us, mut vs) = (faces(n + 1, m, 0), faces(n, m + 1, 500));
        let mut u = Field::<f32, U>::new([n + 1, m]);
        u.copy_from_slice(&us.0);
        let mut v = Field::<f32, V>::new([n, m + 1]);
        v.copy_from_slice(&vs.0);
        no_flux(&mut u, &mut v, n as i32, m as i32);
        for j in 0..m {
            (us.0[j], us.0[n * m + j]) = (0.0, 0.0);
        }
        for i in 0..n {
            (vs.0[i * (m + 1)], vs.0[i * (m + 1) + m]) = (0.0, 0.0);
        }
        close(&u.to_vec(), &us.0, 0.0);
        close(&v.to_vec(), &vs.0, 0.0);
        let moved: Vec<f32> = (0..(n + 1) * m)
            .map(|c| {
                let (x, y) = ((c / m) as f32, (c % m) as f32 + 0.5);
                let velocity = |x: f32, y: f32| (us.bilinear(x, y - 0.5), vs.bilinear(x - 0.5, y));
                let (a, b) = velocity(x, y);
                let (a, b) = velocity(x - 0.5 * 1.3 * a, y - 0.5 * 1.3 * b);
                us.bilinear(x - 1.3 * a, y - 1.3 * b - 0.5)
            })
            .collect();
        let flow: Vec<f32> = (0..n * m)
            .map(|c| {
                let (i, j) = ((c / m) as i32, (c % m) as i32);
                us.at(i + 1, j) - us.at(i, j) + vs.at(i, j + 1) - vs.at(i, j)
            })
            .collect();
        on_threads(|| {
            let mut next = Field::<f32, U>::new([n + 1, m]);
            advect_u(&u, &v, &mut next, 1.3);
            close(&next.to_vec(), &moved, 1e-5);
            let mut div = Field::<f32, V>::new([n, m]);
            divergence(&u, &v, &mut div);
            close(&div.to_vec(), &flow, 1e-6);
        });
    }
    run::<Aos, Aos>();
    run::<Soa, Blocked<2>>();
    run::<Morton<4>, layout!(dense(ji).aos)>();
}
