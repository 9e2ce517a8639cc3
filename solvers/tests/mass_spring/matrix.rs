//! The matrix of an implicit step, and what solves it.

use allotrope_solvers::linear::{Operator, Stop};
use allotrope_solvers::mass_spring::{Attractor, Connectivity, Matrix, Method, Rows, StepMatrix};

use super::layouts::{Pointer, in_all_layouts};
use super::*;

type Vectors = Field<DVec3, Aos>;

fn vectors(values: &[DVec3]) -> Vectors {
    let mut field = Field::<DVec3, Aos>::new([values.len()]);
    field.copy_from_slice(values);
    field
}

fn dot(a: &Vectors, b: &Vectors) -> f64 {
    a.iter().zip(b.iter()).map(|(a, b)| a.dot(b)).sum()
}

fn some(seed: u64, count: usize) -> Vectors {
    vectors(&(0..count).map(|n| random::<DVec3>(seed, n) - 0.5).collect::<Vec<_>>())
}

fn examine<M: Layout<I>, C: Connectivity<M>>(name: &str) {
    let (mut masses, springs) = net(6, 5);
    masses[3].fixed = true;
    let attractor = Attractor { place: DVec3::X, strength: 2.0 };
    let parameters = Parameters { attractor, ..with(Integrator::Beta(1.0), 0.05) };
    let system = MassSpring::<M, C>::with(parameters, &masses, &springs).unwrap();
    let a = StepMatrix::new(system.masses(), system.connectivity(), &parameters);
    let product = |x: &Vectors| {
        let mut y = x.clone();
        let curvature = a.apply(x, &mut y);
        assert!((curvature - dot(x, &y)).abs() < 1e-12 * dot(x, &y).abs());
        y
    };
    // Symmetric over free masses, whatever they weigh, and positive.
    let free = |mut x: Vectors| {
        x.set(3, DVec3::ZERO);
        x
    };
    let (u, v) = (free(some(31, masses.len())), free(some(32, masses.len())));
    let (uv, vu) = (dot(&u, &free(product(&v))), dot(&v, &free(product(&u))));
    assert!((uv - vu).abs() < 1e-12 * dot(&u, &u), "{name}: {uv} and {vu}");
    assert!(dot(&u, &product(&u)) > 0.0, "{name}");
    // Its diagonal is what it gives of unit vectors.
    let mut diagonal = u.clone();
    a.diagonal(&mut diagonal);
    for (n, axis) in (0..masses.len()).flat_map(|n| (0..3).map(move |axis| (n, axis))) {
        let mut unit = vectors(&vec![DVec3::ZERO; masses.len()]);
        unit.set(n, DVec3::AXES[axis]);
        let entry = product(&unit).get(n)[axis];
        assert!((entry - diagonal.get(n)[axis]).abs() < 1e-12 * entry, "{name}: {n}, {axis}");
    }
}

#[test]
fn the_matrix_is_symmetric_and_positive_in_all_layouts() {
    in_all_layouts!(examine());
}

/// `I - a M^-1 df/dx` itself is symmetric for equal masses, and not for others.
#[test]
fn divided_by_the_masses_it_is_symmetric_for_equal_ones_alone() {
    let asymmetry = |equal: bool| {
        let (mut masses, springs) = net(4, 4);
        if equal {
            masses.iter_mut().for_each(|mass| mass.mass = 0.7);
        }
        let parameters = with(Integrator::Beta(1.0), 0.05);
        let system = Plain::with(parameters, &masses, &springs).unwrap();
        let a = StepMatrix::new(system.masses(), system.connectivity(), &parameters);
        let divided = |x: &Vectors| {
            let mut y = x.clone();
            a.apply(x, &mut y);
            (0..masses.len()).for_each(|n| y.set(n, y.get(n) / masses[n].mass));
            y
        };
        let (u, v) = (some(33, masses.len()), some(34, masses.len()));
        (dot(&u, &divided(&v)) - dot(&v, &divided(&u))).abs() / dot(&u, &u)
    };
    assert!(asymmetry(true) < 1e-13 && asymmetry(false) > 1e-4, "{} and {}", asymmetry(true), asymmetry(false));
}

/// Central differences of the force are the derivative by position; stretched springs alone, as compressed ones are
/// made stiffer sideways. Its printed form: `k ((1 - l / |d|) (I - n n) + n n)`.
#[test]
fn resistance_is_the_derivative_of_the_force() {
    use allotrope_solvers::mass_spring::Rates;
    let bond = Bond { stiffness: 7.0, rest: 0.8, dashpot: 0.5 };
    let (d, e) = (dvec3(0.9, -0.4, 0.3), dvec3(0.2, 0.7, -0.5));
    let h = 1e-5;
    let difference = (bond.force(d + e * h, DVec3::ZERO) - bond.force(d - e * h, DVec3::ZERO)) / (2.0 * h);
    let rates = |stiffness, damping| Rates { stiffness, damping };
    assert!((bond.resistance(d, e, rates(1.0, 0.0)) + difference).length() < 1e-8);
    let damped = bond.force(d, e) - bond.force(d, DVec3::ZERO);
    assert!((bond.resistance(d, e, rates(0.0, 1.0)) + damped).length() < 1e-14);
    let n = d.normalize();
    let printed = ((e - n * n.dot(e)) * (1.0 - bond.rest / d.length()) + n * n.dot(e)) * bond.stiffness;
    assert!((bond.resistance(d, e, rates(1.0, 0.0)) - printed).length() < 1e-14);
    // Compressed to half its length, it would push masses off its line: that part is left out.
    let short = bond.resistance(d * 0.4, e, rates(1.0, 0.0));
    assert!((short - n * n.dot(e) * bond.stiffness).length() < 1e-14 && short.dot(e) >= 0.0);
}

fn velocities<M: Layout<I>, C: Connectivity<M>>(name: &str, expected: &[DVec3]) {
    let (masses, springs) = net(6, 5);
    for (method, bound) in
        [(Method::ConjugateGradients, 1e-9), (Method::Jacobi(1.0), 1e-9), (Method::Jacobi(0.8), 1e-9)]
    {
        let stop = Stop { check_symmetry: false, ..Stop::at(1e-11) };
        let parameters = Parameters { method, stop, ..with(Integrator::Beta(1.0), 0.05) };
        let mut system = MassSpring::<M, C>::with(parameters, &masses, &springs).unwrap();
        let report = system.step().unwrap().unwrap();
        assert!(report.iterations > 3 && report.residual() <= 1e-11 * report.residuals[0] * 1.001);
        let error = system.masses().iter().zip(expected).map(|(mass, v)| mass.v.distance(*v)).fold(0.0, f64::max);
        assert!(error < bound, "{name}, {method:?}: off by {error:e}");
    }
}

/// The same step by elimination of the assembled matrix `M - dt^2 df/dx - dt df/dv`.
#[test]
fn jacobi_and_conjugate_gradients_give_the_velocity_of_the_linearised_step() {
    let (masses, springs) = net(6, 5);
    let (n, dt) = (3 * masses.len(), 0.05);
    let (mut rows, mut b) = (vec![vec![0.0; n]; n], vec![0.0; n]);
    for (m, mass) in masses.iter().enumerate() {
        for axis in 0..3 {
            rows[3 * m + axis][3 * m + axis] += mass.mass;
            b[3 * m + axis] += mass.mass * mass.v[axis];
        }
    }
    for spring in &springs {
        let [p, q] = spring.ends.map(|end| end as usize);
        let (d, bond) = (masses[p].x - masses[q].x, spring.bond);
        let (length, line) = (d.length(), d.normalize());
        let side = bond.stiffness * (1.0 - bond.rest / length).max(0.0);
        let elastic = line * -(bond.stiffness * (length - bond.rest));
        // Of `M v + dt (f + ..)` the dashpot's part at the old velocity cancels in backward Euler.
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let (nn, unit) = (line[i] * line[j], f64::from(u8::from(i == j)));
            let block = dt * dt * (side * (unit - nn) + bond.stiffness * nn) + dt * bond.dashpot * nn;
            for (one, other, sign) in [(p, p, 1.0), (q, q, 1.0), (p, q, -1.0), (q, p, -1.0)] {
                rows[3 * one + i][3 * other + j] += sign * block;
            }
        }
        for axis in 0..3 {
            b[3 * p + axis] += dt * elastic[axis];
            b[3 * q + axis] -= dt * elastic[axis];
        }
    }
    // The matrix is positive: no pivots are needed.
    for step in 0..n {
        for row in step + 1..n {
            let factor = rows[row][step] / rows[step][step];
            if factor != 0.0 {
                let (upper, lower) = rows.split_at_mut(row);
                lower[0].iter_mut().zip(&upper[step]).for_each(|(entry, above)| *entry -= factor * above);
                b[row] -= factor * b[step];
            }
        }
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|column| rows[row][column] * b[column]).sum();
        b[row] = (b[row] - known) / rows[row][row];
    }
    let expected: Vec<DVec3> = b.as_chunks().0.iter().map(|&v| DVec3::from_array(v)).collect();
    in_all_layouts!(velocities(&expected));
}

#[test]
fn a_solution_that_is_not_reached_is_told_and_nothing_moves() {
    let (masses, springs) = net(6, 5);
    let stop = Stop { check_symmetry: false, most: 2, ..Stop::at(1e-12) };
    for method in [Method::ConjugateGradients, Method::Jacobi(1.0)] {
        let parameters = Parameters { method, stop, ..with(Integrator::Beta(1.0), 0.2) };
        let mut system = Plain::with(parameters, &masses, &springs).unwrap();
        let error = system.step().unwrap_err().to_string();
        let start = "the implicit step was not solved: not converged after the 2 iterations that were allowed";
        assert!(error.starts_with(start), "{error}");
        assert!(system.positions().iter().zip(&masses).all(|(x, mass)| *x == mass.x));
        // With more iterations the same step is done as if nothing had been.
        system.set_parameters(Parameters { stop: Stop { most: 1000, ..stop }, ..parameters }).unwrap();
        let mut other = Plain::with(*system.parameters(), &masses, &springs).unwrap();
        advance(&mut system, 1);
        advance(&mut other, 1);
        assert!(system.positions() == other.positions());
    }
}
