//! What acts on masses beside springs.

use allotrope_solvers::mass_spring::Attractor;

use super::*;

fn alone(at: Mass, parameters: Parameters) -> Plain {
    Plain::with(parameters, &[at], &[]).unwrap()
}

#[test]
fn gravity_and_drag_have_their_closed_forms() {
    let (dt, drag, g, steps) = (0.01, 0.7, -9.8, 200);
    let q = f64::exp(-dt * drag);
    // v_n = g dt q (1 - q^n) / (1 - q).
    let expected = g * dt * q * (1.0 - q.powi(steps)) / (1.0 - q);
    for integrator in [Integrator::SymplecticEuler, Integrator::ForwardEuler, Integrator::Beta(1.0)] {
        let parameters = Parameters { gravity: dvec3(0.0, g, 0.0), drag, ..with(integrator, dt) };
        let mut system = alone(mass(DVec3::ZERO, 3.0), parameters);
        advance(&mut system, steps as usize);
        let v = system.mass(0).v.y;
        assert!((v / expected - 1.0).abs() < 1e-12, "{integrator:?}: {v}, not {expected}");
    }
}

#[test]
fn an_attractor_is_a_spring_of_length_zero_for_each_mass() {
    let attractor = Attractor { place: dvec3(1.0, 2.0, 3.0), strength: 4.0 };
    let (dt, steps) = (0.05, 100);
    let z: f64 = 2.0 * dt;
    for (integrator, phase, amplitude) in [
        (Integrator::SymplecticEuler, 2.0 * (0.5 * z).asin(), 1.0),
        (Integrator::ImplicitMidpoint, 2.0 * (0.5 * z).atan(), 1.0),
        (Integrator::Beta(1.0), z.atan(), (1.0 + z * z).powf(-0.5)),
    ] {
        let parameters = Parameters { attractor, ..with(integrator, dt) };
        let mut one = alone(mass(dvec3(2.0, 2.0, 3.0), 5.0), parameters);
        let (mut x, mut last) = (vec![1.0], 0.0);
        for _ in 0..steps {
            advance(&mut one, 1);
            last = one.mass(0).x.y;
            x.push(one.mass(0).x.x - 1.0);
        }
        // x_{n+1} - 2 a cos(phase) x_n + a^2 x_{n-1} = 0.
        for three in x.windows(3) {
            let rest = three[2] - 2.0 * amplitude * phase.cos() * three[1] + amplitude * amplitude * three[0];
            assert!(rest.abs() < 1e-12, "{integrator:?}: {rest:e}");
        }
        assert!((last - 2.0).abs() < 1e-14, "nothing pulls sidewards");
    }
}

#[test]
fn walls_stop_what_goes_through_them_along_their_normal() {
    let parameters = Parameters {
        walls: [DVec3::ZERO, DVec3::ONE],
        gravity: dvec3(0.0, -10.0, 0.0),
        ..with(Integrator::SymplecticEuler, 0.01)
    };
    let thrown = Mass { v: dvec3(0.3, 0.0, 0.0), ..mass(dvec3(0.2, 0.1, 0.5), 1.0) };
    let mut system = alone(thrown, parameters);
    advance(&mut system, 60);
    let Mass { x, v, .. } = system.mass(0);
    assert_eq!((x.y, v.y, v.x), (0.0, 0.0, 0.3));
    assert!((x.x - (0.2 + 0.6 * 0.3)).abs() < 1e-12);
    advance(&mut system, 300);
    let Mass { x, v, .. } = system.mass(0);
    assert_eq!((x, v), (dvec3(1.0, 0.0, 0.5), DVec3::ZERO));
}

/// A fixed mass is a wall: two springs on one are as one spring of both.
#[test]
fn fixed_masses_do_not_move_whatever_pulls_them() {
    let (mut masses, springs) = net(4, 4);
    masses[5].fixed = true;
    masses[10].fixed = true;
    let attractor = Attractor { place: dvec3(9.0, 0.0, 0.0), strength: 3.0 };
    for integrator in [Integrator::SymplecticEuler, Integrator::Beta(1.0), Integrator::ImplicitMidpoint] {
        let parameters = Parameters { attractor, gravity: DVec3::NEG_Y, ..with(integrator, 5e-3) };
        let mut system = Plain::with(parameters, &masses, &springs).unwrap();
        advance(&mut system, 100);
        for held in [5, 10] {
            assert_eq!((system.mass(held).x, system.mass(held).v), (masses[held].x, masses[held].v), "{integrator:?}");
        }
        assert_ne!(system.mass(6).x, masses[6].x);
    }
}

#[test]
fn what_is_not_finite_is_told_with_the_first_mass() {
    let mut system = oscillator(1e6, 1.0, 0.0, with(Integrator::SymplecticEuler, 1.0));
    let error = (0..10_000).find_map(|_| system.step().err()).expect("it blows up").to_string();
    assert_eq!(error, "mass 1 is not finite; make `dt = 1e0` smaller");
}
