//! Steps beyond the bound of explicit integrators.

use allotrope_solvers::mass_spring::Attractor;

use super::*;

fn bound(masses: &[Mass], springs: &[Spring], integrator: Integrator) -> f64 {
    let parameters = Parameters { integrator, unstable: false, ..Parameters::default() };
    Plain::with(parameters, masses, springs).unwrap().largest_step().unwrap()
}

#[test]
fn bounds_are_exact_where_they_are_known() {
    let (m, k) = (0.3, 70.0);
    let wall = [fixed(DVec3::ZERO), mass(DVec3::X, m)];
    let euler = Integrator::SymplecticEuler;
    let one = [spring(0, 1, k, 1.0)];
    assert!((bound(&wall, &one, euler) - 2.0 * (m / k).sqrt()).abs() < 1e-15);
    let pair = [mass(DVec3::ZERO, m), mass(DVec3::X, m)];
    assert!((bound(&pair, &one, euler) - (2.0 * m / k).sqrt()).abs() < 1e-15);
    let chain: Vec<Mass> = (0..50).map(|n| mass(DVec3::X * f64::from(n), m)).collect();
    let springs: Vec<Spring> = (0..49).map(|n| spring(n, n + 1, k, 1.0)).collect();
    assert!((bound(&chain, &springs, euler) - (m / k).sqrt()).abs() < 1e-15);
    assert_eq!(bound(&chain, &[], euler), f64::INFINITY);
    assert_eq!(bound(&pair, &one, Integrator::ForwardEuler), 0.0);
    for integrator in [Integrator::Beta(0.5), Integrator::Beta(1.0), Integrator::ImplicitMidpoint] {
        let system = Plain::with(with(integrator, 100.0), &pair, &one).unwrap();
        assert_eq!(system.largest_step(), None);
    }
}

#[test]
fn longer_steps_are_refused_with_the_bound_and_nothing_moves() {
    let (k, dt) = (100.0, 0.21);
    let stable = Parameters { dt, unstable: false, ..Parameters::default() };
    let mut system = oscillator(k, 1.0, 0.0, stable);
    let error = system.step().unwrap_err().to_string();
    assert!(error.starts_with("steps of 2.1e-1 s are beyond the bound of stability, 2.000e-1 s; "), "{error}");
    assert_eq!(system.mass(1).x, DVec3::X);

    let euler = Parameters { integrator: Integrator::ForwardEuler, dt: 1e-9, ..stable };
    let error = oscillator(k, 1.0, 0.0, euler).step().unwrap_err().to_string();
    assert!(error.starts_with("forward Euler is stable with no step"), "{error}");
}

/// The largest displacement in 2000 steps of the end of a chain that hangs on a wall, by a length of step.
fn swing(dt: f64, damping: f64, integrator: Integrator) -> f64 {
    let n = 12;
    let mut masses = vec![fixed(DVec3::ZERO)];
    masses.extend((1..=n).map(|at| mass(DVec3::X * f64::from(at), 1.0)));
    masses[n as usize].x.x += 0.01;
    masses[3].x.x -= 0.01;
    let bond = Bond { stiffness: 100.0, rest: 1.0, dashpot: damping };
    let springs: Vec<Spring> = (0..n as u32).map(|at| Spring { ends: [at, at + 1], bond }).collect();
    let mut system = Plain::with(with(integrator, dt), &masses, &springs).unwrap();
    let mut most = 0.0f64;
    for _ in 0..2000 {
        if system.step().is_err() {
            return f64::INFINITY;
        }
        most = most.max((system.mass(n as usize).x.x - f64::from(n)).abs());
        if most > 1.0 {
            return most;
        }
    }
    most
}

#[test]
fn within_the_bound_motion_stays_and_beyond_it_grows() {
    // A chain of 12 on a wall has w = 2 sqrt(k / m) cos(pi / 25): nearly the bound's.
    let bound = 0.1 / (std::f64::consts::PI / 25.0).cos();
    let euler = Integrator::SymplecticEuler;
    assert!(swing(0.999 * bound, 0.0, euler) < 0.1);
    assert!(swing(1.001 * bound, 0.0, euler) > 1.0);
    // With dashpots: w^2 dt^2 + 2 c dt = 4 at c = dashpot w^2 / k.
    let w2 = 400.0 * (std::f64::consts::PI / 25.0).cos().powi(2);
    let c = 2.0 * w2 / 100.0;
    let damped = 4.0 / (c + (c * c + 4.0 * w2).sqrt());
    assert!(swing(0.999 * damped, 2.0, euler) < 0.1);
    assert!(swing(1.01 * damped, 2.0, euler) > 1.0);
    // Forward Euler: dt below dashpot / stiffness.
    let forward = Integrator::ForwardEuler;
    assert!(swing(0.0095, 1.0, forward) < 0.1);
    assert!(swing(0.012, 1.0, forward) > 1.0);
}

#[test]
fn bounds_follow_springs_masses_and_attractors() {
    let stable = Parameters { dt: 0.15, unstable: false, ..Parameters::default() };
    let mut system = oscillator(100.0, 1.0, 0.0, stable);
    advance(&mut system, 1);
    system.add_masses(&[fixed(dvec3(10.0, 0.0, 0.0))]).unwrap();
    system.add_springs(&[spring(1, 2, 300.0, 10.0)]).unwrap();
    assert!((system.largest_step().unwrap() - 0.1).abs() < 1e-15);
    assert!(system.step().is_err());
    system.set_mass(1, mass(DVec3::X, 4.0)).unwrap();
    assert!((system.largest_step().unwrap() - 0.2).abs() < 1e-15);
    advance(&mut system, 1);
    let attractor = Attractor { place: DVec3::ZERO, strength: 300.0 };
    system.set_parameters(Parameters { attractor, ..stable }).unwrap();
    assert!((system.largest_step().unwrap() - 0.1).abs() < 1e-15);
}
