//! Products that are added to something, rounded once where the processor can.

use allotrope::prelude::*;

#[kernel(contract)]
fn sums(x: &Field<Vec2, _>, y: &mut Field<Vec2, _>, m: Mat2, a: f32) -> f32 {
    let mut total = 0.0;
    for i in y {
        let whole = 2 * i + 1;
        let mut sum = 0.25;
        for j in 0..3 {
            sum += x[i].x * (a - j as f32);
        }
        sum -= a * 0.5;
        y[i] = m * x[i] + Vec2::splat(sum) - a * y[i];
        y[i].x += a * (whole as f32);
        total += y[i].x * y[i].y;
    }
    total
}

#[kernel]
fn scatter_plainly(x: &Field<f32, _>, grid: &mut Field<f32, _>, a: f32) {
    for i in x {
        let cell = 2 * i;
        grid[cell] += x[i] * a + 1.0;
    }
}

/// A sum in a variable that its own factors change.
#[kernel(contract)]
fn changed_meanwhile(y: &mut Field<f32, _>, a: f32) {
    for i in y {
        let mut sum = 1.0;
        sum += a * {
            sum *= 2.0;
            3.0
        };
        sum -= a * {
            sum += 8.0;
            0.5
        };
        y[i] = sum;
    }
}

#[test]
fn operands_are_evaluated_as_in_rust() {
    let mut y = Field::<f32, Soa>::new([3]);
    changed_meanwhile(&mut y, 4.0);
    assert_eq!(y.to_vec(), [20.0; 3]);
}

/// The same as `sums`, every sum written out.
fn by_hand(x: Vec2, y: Vec2, m: Mat2, a: f32, i: usize, fused: bool) -> Vec2 {
    let fma = |a: f32, b: f32, c: f32| if fused { a.mul_add(b, c) } else { a * b + c };
    let mut sum = 0.25;
    for j in 0..3 {
        sum = fma(x.x, a - j as f32, sum);
    }
    sum = fma(-a, 0.5, sum);
    let splat = Vec2::splat(sum);
    let product = match fused {
        true => m.y_axis.mul_add(Vec2::splat(x.y), m.x_axis.mul_add(Vec2::splat(x.x), splat)),
        false => m * x + splat,
    };
    let mut y = vec2(fma(-a, y.x, product.x), fma(-a, y.y, product.y));
    y.x = fma(a, (2 * i + 1) as f32, y.x);
    y
}

#[test]
fn products_are_rounded_with_what_they_are_added_to() {
    let (a, m) = (0.123_456_7, Mat2::from_cols_array(&[1.1, -0.7, 0.3, 0.9]));
    let place = |n: usize| vec2((n * 7919 % 1009) as f32 / 1009.0, (n * 104_729 % 997) as f32 / 997.0);
    let mut x = Field::<Vec2, Soa>::new([1000]);
    (0..1000).for_each(|n| x.set(n, place(n)));
    let mut differ = 0;
    for cpu in super::instruction_sets() {
        let mut y = x.clone();
        let schedule = Schedule { cpu: Some(cpu), ..Schedule::default() };
        schedule.run(|| sums(&x, &mut y, m, a));
        // Builds with debug assertions have the version for every processor alone.
        let fused = cfg!(any(target_feature = "fma", target_arch = "aarch64"))
            || cpu != Cpu::Baseline && cfg!(not(debug_assertions));
        for (n, y) in y.iter().enumerate() {
            assert_eq!(y, by_hand(place(n), place(n), m, a, n, fused), "{cpu}, element {n}");
            differ += usize::from(y != by_hand(place(n), place(n), m, a, n, !fused));
        }
    }
    assert!(differ > 100, "one rounding is another result than two");
}

#[test]
fn sums_elsewhere_are_the_same_bits_under_each_instruction_set() {
    let mut x = Field::<f32, Soa>::new([1000]);
    (0..1000).for_each(|n| x.set(n, (n * 7919 % 1009) as f32 / 1009.0));
    for cpu in super::instruction_sets() {
        let mut grid = Field::<f32, Soa>::new([2000]);
        Schedule { cpu: Some(cpu), ..Schedule::default() }.run(|| scatter_plainly(&x, &mut grid, 0.3));
        for n in 0..1000 {
            assert_eq!(grid.get(2 * n), x.get(n) * 0.3 + 1.0, "{cpu}, element {n}");
        }
    }
}
