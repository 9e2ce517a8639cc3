//! saxpy and sum over slices.

use super::versions;

versions! {
    /// `y = a x + y`.
    pub fn saxpy(a: f32, x: &[f32], y: &mut [f32]) {
        for (y, x) in y.iter_mut().zip(x) {
            *y += a * x;
        }
    }
}

versions! {
    /// The sum, in 64 lanes: four vectors of the widest registers.
    pub fn sum(x: &[f32]) -> f32 {
        let mut lanes = [0.0f32; 64];
        let chunks = x.chunks_exact(64);
        let rest: f32 = chunks.remainder().iter().sum();
        for chunk in chunks {
            for (lane, x) in lanes.iter_mut().zip(chunk) {
                *lane += x;
            }
        }
        rest + lanes.iter().sum::<f32>()
    }
}

versions! {
    /// What an iteration of conjugate gradients moves, without the stencil: two arrays read and one written, then three
    /// read and two of them written.
    pub fn conjugate_gradients(scale: f64, old: &[f64], new: &mut [f64], x: &mut [f64], r: &mut [f64]) {
        for ((new, old), r) in new.iter_mut().zip(old).zip(&*r) {
            *new = r + scale * old;
        }
        for ((x, r), new) in x.iter_mut().zip(r).zip(&*new) {
            *x += scale * new;
            *r -= scale * new;
        }
    }
}
