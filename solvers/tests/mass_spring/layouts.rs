//! The same masses in every layout.

use allotrope_solvers::mass_spring::{Connectivity, Matrix, Rows};

use super::*;

pub(super) type Pointer = layout!(pointer(ij).bitmasked(ij, 8).soa);

/// Calls a generic function in each pair of layouts.
macro_rules! in_all_layouts {
    ($run:ident($($argument:expr),*)) => {
        $run::<Aos, List>("aos+list", $($argument),*);
        $run::<Soa, List<Soa>>("soa+list", $($argument),*);
        $run::<Aos, Rows>("aos+rows", $($argument),*);
        $run::<Split, Rows>("split+rows", $($argument),*);
        $run::<Aos, Matrix<Soa>>("aos+dense", $($argument),*);
        $run::<Aos, Matrix<Pointer>>("aos+pointer", $($argument),*);
        $run::<AoSoA<16>, Matrix<Sparse<4>>>("aosoa16+sparse4", $($argument),*);
    };
}
pub(super) use in_all_layouts;

const INTEGRATORS: [Integrator; 5] = [
    Integrator::ForwardEuler,
    Integrator::SymplecticEuler,
    Integrator::Beta(0.5),
    Integrator::Beta(1.0),
    Integrator::ImplicitMidpoint,
];

fn after<M: Layout<I>, C: Connectivity<M>>(integrator: Integrator, steps: usize) -> Vec<DVec3> {
    let (mut masses, springs) = net(9, 7);
    masses[0].fixed = true;
    let parameters = Parameters { gravity: dvec3(0.0, -1.0, 0.5), drag: 0.1, ..with(integrator, 2e-3) };
    let mut system = MassSpring::<M, C>::with(parameters, &masses, &springs).unwrap();
    advance(&mut system, steps);
    assert_eq!(system.mass(0).x, masses[0].x, "held");
    system.positions()
}

fn follow<M: Layout<I>, C: Connectivity<M>>(name: &str, expected: &[Vec<DVec3>]) {
    for threads in [1, 3] {
        Schedule { threads, grain: 8, ..Schedule::default() }.run(|| {
            for (integrator, expected) in INTEGRATORS.into_iter().zip(expected) {
                let x = after::<M, C>(integrator, 100);
                let error = x.iter().zip(expected).map(|(x, y)| x.distance(*y)).fold(0.0, f64::max);
                assert!(error < 1e-9, "{name}, {integrator:?}, {threads} threads: off by {error:e}");
            }
        });
    }
}

#[test]
fn all_layouts_give_the_same_motion() {
    let expected: Vec<_> = INTEGRATORS.map(|integrator| after::<Aos, List>(integrator, 100)).into();
    let moved = expected[0][5].distance(net(9, 7).0[5].x);
    assert!(moved > 0.05, "they move: {moved}");
    in_all_layouts!(follow(&expected));
}

fn conserve<M: Layout<I>, C: Connectivity<M>>(name: &str) {
    let (masses, springs) = net(9, 7);
    let mut system = MassSpring::<M, C>::with(with(Integrator::SymplecticEuler, 2e-3), &masses, &springs).unwrap();
    let totals = |system: &MassSpring<M, C>| {
        system.masses().iter().fold((DVec3::ZERO, DVec3::ZERO, 0.0), |(p, l, scale), mass| {
            let own = mass.v * mass.mass;
            (p + own, l + mass.x.cross(own), scale + own.length())
        })
    };
    let (momentum, angular, scale) = totals(&system);
    advance(&mut system, 1000);
    let (momentum_after, angular_after, _) = totals(&system);
    let (lost, turned) = (momentum.distance(momentum_after) / scale, angular.distance(angular_after) / (10.0 * scale));
    assert!(lost < 1e-13 && turned < 1e-13, "{name}: {lost:e} of momentum, {turned:e} of its moment");
}

#[test]
fn momentum_and_angular_momentum_stay_to_round_off() {
    in_all_layouts!(conserve());
}

/// What implicit steps conserve is limited by how far their systems are solved.
#[test]
fn implicit_steps_keep_momentum_as_far_as_they_are_solved() {
    for integrator in [Integrator::Beta(0.5), Integrator::Beta(1.0), Integrator::ImplicitMidpoint] {
        let (masses, springs) = net(9, 7);
        let mut system = Plain::with(with(integrator, 2e-2), &masses, &springs).unwrap();
        let momentum = |system: &Plain| system.masses().iter().map(|mass| mass.v * mass.mass).sum::<DVec3>();
        let start = momentum(&system);
        advance(&mut system, 200);
        let lost = momentum(&system).distance(start);
        assert!(lost < 1e-8, "{integrator:?}: {lost:e}");
    }
}

#[test]
fn deterministic_runs_are_the_same_bits_on_any_number_of_threads() {
    let run = |threads| {
        Schedule { threads, grain: 8, deterministic: true, ..Schedule::default() }.run(|| {
            (after::<Aos, List>(Integrator::SymplecticEuler, 50), after::<Aos, List>(Integrator::Beta(1.0), 50))
        })
    };
    assert!(run(1) == run(3));
}

#[test]
fn what_is_in_a_plane_stays_in_it() {
    let (mut masses, springs) = net(5, 5);
    masses.iter_mut().for_each(|mass| (mass.x.z, mass.v.z) = (0.0, 0.0));
    for integrator in INTEGRATORS {
        let mut system = Plain::with(with(integrator, 2e-3), &masses, &springs).unwrap();
        advance(&mut system, 50);
        assert!(system.masses().iter().all(|mass| mass.x.z == 0.0 && mass.v.z == 0.0), "{integrator:?}");
    }
}
