//! Loops that compute more than they move: direct n-body forces, the Julia set, a histogram, and a launch of nothing.

use allotrope::prelude::*;

/// The acceleration of every body by all of them, softened.
#[kernel(lanes = 16)]
pub fn gravitate(x: &Field<Vec3, _>, a: &mut Field<Vec3, _>) {
    let count = x.len() as i32;
    for i in a {
        let here = x[i];
        let mut sum = Vec3::ZERO;
        for j in 0..count {
            let arm = x[j] - here;
            let inverse = 1.0 / (arm.length_squared() + 1e-4).sqrt();
            sum += arm * (inverse * inverse * inverse);
        }
        a[i] = sum;
    }
}

/// Iterations of z^2 + c until |z| reaches 20, at most 50.
#[kernel(lanes = 16)]
pub fn julia(counts: &mut Field<u32, _, Ij>, im: f32) {
    let [width, height] = counts.shape().map(|n| n as i32);
    for (i, j) in counts {
        let mut re = (2 * i - width) as f32 / height as f32;
        let mut z = (2 * j - height) as f32 / height as f32;
        let mut count = 0;
        while count < 50 && re * re + z * z < 400.0 {
            (re, z) = (re * re - z * z - 0.8, 2.0 * re * z + im);
            count += 1;
        }
        counts[(i, j)] = count;
    }
}

/// How many keys there are of each kind.
#[kernel]
pub fn histogram(keys: &Field<i32, _>, counts: &mut Field<i32, _>) {
    for k in keys {
        counts[keys[k]] += 1;
    }
}

/// A launch with hardly any work.
#[kernel]
pub fn empty(one: &mut Field<f32, _>) {
    for i in one {
        one[i] = 1.0;
    }
}
