//! Masses and springs that come while it runs, and those that are refused.

use allotrope_solvers::mass_spring::{EditError, Matrix};

use super::*;

const BOND: Bond = Bond { stiffness: 30.0, rest: 0.5, dashpot: 0.1 };

#[test]
fn what_is_added_while_it_runs_moves_as_if_it_had_been_there() {
    let (masses, springs) = net(6, 5);
    let parameters = with(Integrator::SymplecticEuler, 1e-3);
    let mut whole = Plain::with(parameters, &masses, &springs).unwrap();
    advance(&mut whole, 20);
    // The same, made in two parts, the second after those steps.
    let added = [Mass { v: DVec3::Y, ..mass(dvec3(0.3, 5.5, 0.1), 0.4) }, fixed(dvec3(6.0, 6.0, 0.0))];
    let mut grown = Plain::with(parameters, &masses, &springs).unwrap();
    advance(&mut grown, 20);
    grown.add_masses(&added).unwrap();
    grown.add_springs(&[spring(4, 30, 20.0, 0.5), spring(30, 31, 10.0, 3.0)]).unwrap();
    let all: Vec<Mass> = whole.masses().iter().chain(added).collect();
    let joined = [whole.springs(), &[spring(4, 30, 20.0, 0.5), spring(30, 31, 10.0, 3.0)]].concat();
    let mut whole = Plain::with(parameters, &all, &joined).unwrap();
    advance(&mut whole, 50);
    advance(&mut grown, 50);
    assert!(whole.positions() == grown.positions());
    assert_ne!(grown.mass(30).x, added[0].x);
    assert_eq!(grown.mass(31).x, added[1].x);
}

#[test]
fn neighbours_within_a_radius_are_joined_once() {
    let count = 200;
    let x: Vec<DVec3> = (0..count).map(|n| random::<DVec3>(41, n) * 3.0 - 1.0).collect();
    let masses: Vec<Mass> = x.iter().map(|&x| mass(x, 1.0)).collect();
    let mut system = Plain::with(Parameters::default(), &masses, &[spring(7, 3, 1.0, 0.1)]).unwrap();
    let near = |first: usize| {
        let all = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
        all.filter(|&(a, b)| b >= first && x[a].distance(x[b]) < 0.6 && (a, b) != (3, 7)).count()
    };
    assert!(near(0) > 300);
    assert_eq!(system.connect_within(0.6, 150, BOND).unwrap(), near(150));
    assert_eq!(system.connect_within(0.6, 0, BOND).unwrap(), near(0) - near(150));
    assert_eq!(system.connect_within(0.6, 0, BOND).unwrap(), 0);
    assert_eq!(system.springs().len(), 1 + near(0));
}

#[test]
fn what_makes_no_sense_is_refused_and_changes_nothing() {
    let mut system = oscillator(1.0, 1.0, 0.0, with(Integrator::SymplecticEuler, 0.01));
    for (wrong, fault) in [
        (spring(0, 2, 1.0, 1.0), "spring 0 joins mass 2, and there are 2"),
        (spring(1, 1, 1.0, 1.0), "spring 0 joins mass 1 with itself"),
        (spring(1, 0, 1.0, 1.0), "spring 0 joins masses 1 and 0, which are joined already"),
        (spring(1, 0, f64::NAN, 1.0), "spring 0 joins masses 1 and 0, which are joined already"),
    ] {
        assert_eq!(system.add_springs(&[wrong]).unwrap_err().to_string(), fault);
    }
    system.add_masses(&[mass(DVec3::Y, 1.0)]).unwrap();
    for (stiffness, rest) in [(0.0, 1.0), (-1.0, 1.0), (f64::NAN, 1.0), (1.0, -1.0), (1.0, f64::INFINITY)] {
        let error = system.add_springs(&[spring(1, 2, stiffness, rest)]).unwrap_err();
        assert!(matches!(error, EditError::Spring { spring: 0, .. }), "{error}");
    }
    for (x, weight) in [(DVec3::ZERO, 0.0), (DVec3::ZERO, -1.0), (DVec3::NAN, 1.0), (DVec3::ZERO, f64::NAN)] {
        let error = system.add_masses(&[mass(DVec3::ZERO, 1.0), mass(x, weight)]).unwrap_err();
        assert!(matches!(error, EditError::Mass { mass: 1, .. }), "{error}");
    }
    assert_eq!((system.masses().len(), system.springs().len()), (3, 1));
}

#[test]
fn a_dense_table_of_too_many_masses_is_refused() {
    let masses = vec![mass(DVec3::ZERO, 1.0); 2049];
    let error = MassSpring::<Aos, Matrix<Soa>>::with(Parameters::default(), &masses, &[]).unwrap_err();
    assert_eq!(error.to_string(), "2049 masses are more than the 2048 of this layout");
    MassSpring::<Aos, Matrix<Sparse<4>>>::with(Parameters::default(), &masses, &[]).unwrap();
}

#[test]
fn a_system_without_anything_steps() {
    let mut system = Plain::new(Parameters::default()).unwrap();
    advance(&mut system, 2);
    system.add_masses(&[mass(DVec3::ZERO, 1.0)]).unwrap();
    advance(&mut system, 2);
    assert_eq!(system.mass(0).x, DVec3::ZERO);
}
