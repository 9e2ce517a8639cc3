//! Variables that parallel loops accumulate into.

use allotrope::prelude::*;

#[kernel]
fn statistics(u: &Field<f32, _>, mut least: f32) -> (f64, f32, f32, i32, u8) {
    let (mut sum, mut most) = (0.0f64, f32::NEG_INFINITY);
    let mut count = 0;
    let mut signs = 0u8;
    for p in u {
        if u[p] == 0.0 {
            continue;
        }
        sum += u[p] as f64;
        least.min_assign(u[p]);
        most.max_assign(u[p]);
        count += 1;
        signs |= if u[p] < 0.0 { 1 } else { 2 };
    }
    (sum, least, most, count, signs)
}

fn wave<L: Layout<I>>(n: usize) -> Field<f32, L> {
    let mut u = Field::<f32, L>::new([n]);
    (0..n).for_each(|i| u.set(i, if i % 10 == 0 { 0.0 } else { ((i * 37 % 101) as f32 - 50.0) / 7.0 }));
    u
}

#[test]
fn several_reductions_in_one_loop() {
    fn run<L: Layout<I>>(n: usize) {
        let u = wave::<L>(n);
        let (sum, least, most, count, signs) = statistics(&u, 100.0);
        let values: Vec<f32> = u.iter().filter(|x| *x != 0.0).collect();
        let expected: f64 = values.iter().map(|x| f64::from(*x)).sum();
        assert!((sum - expected).abs() <= 1e-9 * n as f64, "{sum} {expected}");
        assert_eq!(least, values.iter().copied().fold(100.0, f32::min));
        assert_eq!(most, values.iter().copied().fold(f32::NEG_INFINITY, f32::max));
        assert_eq!((count as usize, signs), (values.len(), if n > 30 { 3 } else { signs }));
    }
    for n in [0, 1, 5, 1000, 100_003] {
        run::<Aos>(n);
        run::<layout!(dense(i).dense(i, 6).soa)>(n);
    }
}

#[kernel]
fn sum(u: &Field<f32, _>) -> f32 {
    let mut sum = 0.0;
    for p in u {
        sum += u[p];
    }
    sum
}

#[test]
fn results_have_the_same_bits_on_any_number_of_threads() {
    let u = wave::<Soa>(123_457);
    let run = |threads| Schedule { threads, ..Schedule::default() }.run(|| sum(&u)).to_bits();
    assert_eq!(run(1), run(2));
    assert_eq!(run(1), run(5));
}

#[kernel]
fn moments(u: &Field<Vec2, _, Ij>) -> (Vec2, f64, i64) {
    let mut centre = Vec2::ZERO;
    let mut product = 1.0;
    let mut left = 100;
    for (i, j) in u.interior(1) {
        for k in 0..2 {
            centre += u[(i, j)] * k as f32;
        }
        product *= 1.0 + 0.01 * j as f64;
        left -= 1;
    }
    (centre, product, left)
}

#[test]
fn vectors_products_and_differences() {
    let mut u = Field::<Vec2, Blocked<4>>::new([6, 7]);
    u.fill(vec2(1.0, -2.0));
    let (centre, product, left) = moments(&u);
    assert_eq!((centre, left), (vec2(20.0, -40.0), 80));
    let expected: f64 = (1..6).map(|j| (1.0 + 0.01 * j as f64).powi(4)).product();
    assert!((product - expected).abs() < 1e-12);
}

#[kernel]
fn triangle(n: u64) -> u64 {
    let mut sum = 0;
    for i in 0..n {
        sum += i;
    }
    sum
}

#[test]
fn loops_without_fields_reduce() {
    assert_eq!(triangle(100_001), 100_000 * 100_001 / 2);
    assert_eq!(triangle(0), 0);
}
