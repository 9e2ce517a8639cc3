//! Matrices that are held, in their layouts.

use allotrope::prelude::*;
use allotrope_solvers::linear::{
    CsrMatrix, DenseMatrix, Entry, EntryError, Laplacian, Operator, Report, RowMatrix, Stop, Vector,
    conjugate_gradients, jacobi, preconditioned_conjugate_gradients,
};

type Line = Field<f64, Aos>;

pub(super) fn line(values: &[f64]) -> Line {
    let mut field = Field::<f64, Aos>::new([values.len()]);
    field.copy_from_slice(values);
    field
}

pub(super) fn dense(rows: &[&[f64]]) -> DenseMatrix {
    let mut entries = Field::<f64, Aos>::new([rows.len(), rows.len()]);
    entries.copy_from_slice(&rows.concat());
    DenseMatrix::new(entries)
}

/// The 5-point Laplacian on `n x m` nodes, in rows `i m + j`.
fn laplacian(n: usize, m: usize) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..m).map(move |j| (i, j))) {
        let row = i * m + j;
        entries.push((row, row, 4.0));
        let mut beside = |there: bool, column: usize| {
            if there {
                entries.push((row, column, -1.0));
            }
        };
        beside(j + 1 < m, row + 1);
        beside(i + 1 < n, row + m);
        beside(i > 0, row.wrapping_sub(m));
        beside(j > 0, row.wrapping_sub(1));
    }
    entries
}

/// Solves with conjugate gradients from zero.
fn solve<A: Operator<Value = f64, Axes = I, Layout = Aos>>(a: &A, b: &Vector<A>) -> (Report, Vec<f64>) {
    let mut x = b.clone();
    x.fill(0.0);
    let report = conjugate_gradients(a, b, &mut x, &Stop::at(1e-6)).unwrap();
    (report, x.to_vec())
}

/// Gauss' elimination with pivots.
fn eliminate(mut rows: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for step in 0..n {
        let pivot = (step..n).max_by(|&i, &j| rows[i][step].abs().total_cmp(&rows[j][step].abs())).unwrap();
        rows.swap(step, pivot);
        b.swap(step, pivot);
        for row in step + 1..n {
            let factor = rows[row][step] / rows[step][step];
            let (upper, lower) = rows.split_at_mut(row);
            lower[0].iter_mut().zip(&upper[step]).for_each(|(entry, above)| *entry -= factor * above);
            b[row] -= factor * b[step];
        }
    }
    for row in (0..n).rev() {
        let known: f64 = (row + 1..n).map(|column| rows[row][column] * b[column]).sum();
        b[row] = (b[row] - known) / rows[row][row];
    }
    b
}

#[test]
fn one_matrix_in_three_layouts_gives_the_same_bits() {
    let (n, m) = (15, 15);
    let entries = laplacian(n, m);
    let b = line(&vec![1.0; n * m]);
    let (report, x) = solve(&DenseMatrix::<Aos>::of_entries(n * m, &entries).unwrap(), &b);
    assert_eq!(report.iterations, 24);
    assert!((x[7 * m + 7] / 256.0 - 0.07344576).abs() < 1e-6);
    let blocked = solve(&DenseMatrix::<Blocked<4>>::of_entries(n * m, &entries).unwrap(), &b);
    let rows = solve(&RowMatrix::of_entries(n * m, &entries).unwrap(), &b);
    let csr = solve(&CsrMatrix::<Soa>::of_entries(n * m, &entries).unwrap(), &b);
    let interleaved = solve(&CsrMatrix::<Aos>::of_entries(n * m, &entries).unwrap(), &b);
    for (name, other) in [("blocked", blocked), ("rows", rows), ("csr", csr), ("interleaved", interleaved)] {
        assert!(other.0 == report && other.1 == x, "{name}");
    }

    let mut grid = Field::<f64, Aos>::new([n, m]);
    grid.fill(1.0);
    let mut free = grid.clone();
    free.fill(0.0);
    let without = conjugate_gradients(&Laplacian::new(), &grid, &mut free, &Stop::at(1e-6)).unwrap();
    assert_eq!(without.iterations, report.iterations);
    assert!(free.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-10 * b.abs()));
}

/// The program of the notes: random numbers from -1/2 to 1/2, a tenth of the rows more on the diagonal. Not every seed
/// converges so fast, since the diagonal does not dominate; this one does.
#[test]
fn jacobi_solves_a_dense_matrix_of_twenty_rows() {
    let n = 20;
    let rows: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| random::<f64>(7, (i, j)) - 0.5 + if i == j { 0.1 * n as f64 } else { 0.0 }).collect())
        .collect();
    let right: Vec<f64> = (0..n).map(|i| 100.0 * random::<f64>(8, i)).collect();
    let a = dense(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>());
    let b = line(&right);
    let exact = eliminate(rows.clone(), right.clone());
    let mut counts = Vec::new();
    for damping in [1.0, 0.7] {
        let mut x = line(&vec![0.0; n]);
        let report = jacobi(&a, &b, &mut x, damping, &Stop { most: 400, ..Stop::at(1e-10) }).unwrap();
        let error = x.iter().zip(&exact).map(|(x, exact)| (x - exact).abs()).fold(0.0, f64::max);
        assert!(error < 1e-7, "{error}");
        for (row, right) in rows.iter().zip(&right) {
            let product: f64 = row.iter().zip(x.iter()).map(|(a, x)| a * x).sum();
            assert!((product - right).abs() < 1e-4);
        }
        counts.push(report.iterations);
    }
    assert!(counts[0] <= 100, "{counts:?}");
    assert!(counts[1] != counts[0], "damping changes the iteration: {counts:?}");
}

/// `D A D` with a diagonal `D` over six orders of magnitude: scaling by the diagonal undoes it.
#[test]
fn the_diagonal_preconditions_a_badly_scaled_matrix() {
    let (n, m) = (12, 12);
    let scale = |row: usize| 10f64.powf(3.0 * random::<f64>(9, row));
    let entries: Vec<Entry> =
        laplacian(n, m).into_iter().map(|(row, column, a)| (row, column, a * scale(row) * scale(column))).collect();
    let a = CsrMatrix::<Soa>::of_entries(n * m, &entries).unwrap();
    let exact: Vec<f64> = (0..n * m).map(|row| 1.0 / scale(row)).collect();
    let mut b = line(&exact);
    a.apply(&line(&exact), &mut b);
    let (mut x, mut y) = (line(&vec![0.0; n * m]), line(&vec![0.0; n * m]));
    let scaled = preconditioned_conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-10)).unwrap();
    let plain = conjugate_gradients(&a, &b, &mut y, &Stop::at(1e-10)).unwrap();
    assert!(scaled.iterations < 60 && plain.iterations > 5 * scaled.iterations, "{scaled:?} and {plain:?}");
    for (row, (x, exact)) in x.iter().zip(&exact).enumerate() {
        assert!((x - exact).abs() < 1e-6 * exact.abs().max(1e-2), "{row}: {x}, not {exact}");
    }
}

/// In exact arithmetic as many iterations as there are rows are enough (Hestenes & Stiefel 1952, theorem 5:1).
#[test]
fn conjugate_gradients_end_after_as_many_iterations_as_rows() {
    let n = 8;
    let half: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| random::<f64>(11, (i, j)) - 0.5).collect()).collect();
    let mut entries = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let product: f64 = (0..n).map(|k| half[i][k] * half[j][k]).sum();
        entries.push((i, j, product + if i == j { 0.5 } else { 0.0 }));
    }
    let b = line(&[1.0, -2.0, 3.0, 0.5, 0.0, 1.5, -1.0, 2.0]);
    let mut x = line(&vec![0.0; n]);
    let a = DenseMatrix::<Aos>::of_entries(n, &entries).unwrap();
    let report = conjugate_gradients(&a, &b, &mut x, &Stop::at(1e-10)).unwrap();
    assert!(report.iterations <= n, "{report:?}");
}

#[test]
fn entries_of_one_place_add_up_and_those_outside_are_refused() {
    let entries = [(1, 1, 2.0), (0, 0, 1.0), (1, 1, 3.0), (0, 1, 0.5)];
    let x = line(&[1.0, 10.0]);
    let mut y = x.clone();
    CsrMatrix::<Soa>::of_entries(2, &entries).unwrap().apply(&x, &mut y);
    assert_eq!(y.to_vec(), [6.0, 50.0]);
    RowMatrix::of_entries(2, &entries).unwrap().apply(&x, &mut y);
    assert_eq!(y.to_vec(), [6.0, 50.0]);
    let outside = EntryError::Outside { entry: 1, row: 0, column: 2, size: 2 };
    assert_eq!(RowMatrix::of_entries(2, &[(0, 0, 1.0), (0, 2, 1.0)]).unwrap_err(), outside);
    assert_eq!(CsrMatrix::<Soa>::of_entries(2, &[(0, 0, 1.0), (0, 2, 1.0)]).unwrap_err(), outside);
    assert_eq!(outside.to_string(), "entry 1 is at (0, 2), outside of a matrix of 2 x 2");
    let long: Vec<Entry> = (0..4097).map(|column| (0, column, 1.0)).collect();
    let error = RowMatrix::of_entries(5000, &long).unwrap_err();
    assert_eq!(error, EntryError::Long { row: 0, entries: 4097, most: 4096 });
}
