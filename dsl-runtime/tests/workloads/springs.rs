//! Masses and springs: a scatter to both ends, and an update with component writes.

use allotrope::prelude::*;

use crate::{close, on_threads, scattered};

#[derive(Record, Clone, Copy, Default)]
struct Mass {
    x: Vec2,
    v: Vec2,
    f: Vec2,
    fixed: bool,
}

#[derive(Record, Clone, Copy, Default)]
struct Spring {
    ends: [u32; 2],
    rest: f32,
}

/// The force along the line between two masses, on the first.
fn force(d: Vec2, rate: Vec2, rest: f32, stiffness: f32, damping: f32) -> Vec2 {
    let n = d.normalize_or_zero();
    -(stiffness * (d.length() / rest - 1.0) + damping * rate.dot(n)) * n
}

#[kernel]
fn spring_forces(springs: &Field<Spring, _>, masses: &mut Field<Mass, _>, stiffness: f32, damping: f32) {
    for s in springs {
        let [a, b] = springs.ends[s];
        let f = force(masses.x[a] - masses.x[b], masses.v[a] - masses.v[b], springs.rest[s], stiffness, damping);
        masses.f[a] += f;
        masses.f[b] -= f;
    }
}

#[kernel]
fn symplectic_euler(masses: &mut Field<Mass, _>, gravity: Vec2, dt: f32) {
    for p in masses {
        if !masses.fixed[p] {
            masses.v[p] += dt * (gravity + masses.f[p]);
            masses.x[p] += dt * masses.v[p];
            if masses.x[p].y < 0.0 {
                masses.x[p].y = 0.0;
                masses.v[p].y = 0.0;
            }
        }
        masses.f[p] = Vec2::ZERO;
    }
}

/// A grid of masses, 8 by 8, whose neighbours are joined.
fn cloth() -> (Vec<Mass>, Vec<Spring>) {
    let masses = (0..64).map(|n| Mass {
        x: vec2((n % 8) as f32 + 0.1 * scattered(n), (n / 8) as f32 * 0.3 + 0.1 * scattered(n + 99)),
        fixed: n == 56 || n == 63,
        ..Mass::default()
    });
    let mut springs = Vec::new();
    for n in 0..64u32 {
        if n % 8 < 7 {
            springs.push(Spring { ends: [n, n + 1], rest: 1.0 });
        }
        if n / 8 < 7 {
            springs.push(Spring { ends: [n, n + 8], rest: 0.3 });
        }
    }
    (masses.collect(), springs)
}

fn reference(mut masses: Vec<Mass>, springs: &[Spring], steps: usize) -> Vec<Mass> {
    for _ in 0..steps {
        for spring in springs {
            let [a, b] = spring.ends.map(|end| end as usize);
            let f = force(masses[a].x - masses[b].x, masses[a].v - masses[b].v, spring.rest, 20.0, 0.5);
            masses[a].f += f;
            masses[b].f -= f;
        }
        for mass in &mut masses {
            if !mass.fixed {
                mass.v += 0.01 * (vec2(0.0, -1.0) + mass.f);
                mass.x += 0.01 * mass.v;
                if mass.x.y < 0.0 {
                    (mass.x.y, mass.v.y) = (0.0, 0.0);
                }
            }
            mass.f = Vec2::ZERO;
        }
    }
    masses
}

#[test]
fn a_cloth_falls_as_in_plain_rust() {
    fn run<M: Layout<I>, S: Layout<I>>() {
        let (start, list) = cloth();
        let expected = reference(start.clone(), &list, 20);
        let flat = |masses: &[Mass]| -> Vec<f32> { masses.iter().flat_map(|m| [m.x.x, m.x.y, m.v.x, m.v.y]).collect() };
        assert!(expected.iter().any(|mass| mass.x.y == 0.0), "some reach the floor");
        on_threads(|| {
            let mut masses = Field::<Mass, M>::new([64]);
            start.iter().enumerate().for_each(|(n, mass)| masses.set(n, *mass));
            let mut springs = Field::<Spring, S>::new([list.len()]);
            list.iter().enumerate().for_each(|(n, spring)| springs.set(n, *spring));
            for _ in 0..20 {
                spring_forces(&springs, &mut masses, 20.0, 0.5);
                symplectic_euler(&mut masses, vec2(0.0, -1.0), 0.01);
            }
            close(&flat(&masses.iter().collect::<Vec<_>>()), &flat(&expected), 1e-5);
        });
    }
    run::<Aos, Soa>();
    run::<Split, Aos>();
    run::<AoSoA<4>, AoSoA<8>>();
}
