//! Direct n-body forces, the Julia set and a histogram over slices.

use super::versions;

versions! {
    /// Accelerations by coordinates apart: 16 bodies at a time are summed over all others, a lane each.
    pub fn gravitate(x: &[[f32; 3]], a: &mut [[f32; 3]]) {
        const LANES: usize = 16;
        for (bodies, out) in x.chunks(LANES).zip(a.chunks_mut(LANES)) {
            let mut here = [[0.0f32; LANES]; 3];
            for (lane, body) in bodies.iter().enumerate() {
                for axis in 0..3 {
                    here[axis][lane] = body[axis];
                }
            }
            let mut sum = [[0.0f32; LANES]; 3];
            for other in x {
                for lane in 0..LANES {
                    let arm = [other[0] - here[0][lane], other[1] - here[1][lane], other[2] - here[2][lane]];
                    let inverse = 1.0 / (arm[0] * arm[0] + arm[1] * arm[1] + arm[2] * arm[2] + 1e-4).sqrt();
                    let factor = inverse * inverse * inverse;
                    for axis in 0..3 {
                        sum[axis][lane] += arm[axis] * factor;
                    }
                }
            }
            for (lane, out) in out.iter_mut().enumerate() {
                *out = [sum[0][lane], sum[1][lane], sum[2][lane]];
            }
        }
    }
}

versions! {
    /// Rows in groups of 16 points, which go on together until all have left or 50 iterations are done.
    pub fn julia(width: usize, height: usize, im: f32, counts: &mut [u32]) {
        const LANES: usize = 16;
        for (i, row) in counts.chunks_exact_mut(height).enumerate() {
            for (first, out) in (0..).step_by(LANES).zip(row.chunks_exact_mut(LANES)) {
                let mut re = [(2 * i as i32 - width as i32) as f32 / height as f32; LANES];
                let mut z: [f32; LANES] =
                    std::array::from_fn(|lane| (2 * (first + lane as i32) - height as i32) as f32 / height as f32);
                let mut count = [0u32; LANES];
                for _ in 0..50 {
                    let mut within = 0;
                    for lane in 0..LANES {
                        let inside = u32::from(re[lane] * re[lane] + z[lane] * z[lane] < 400.0);
                        // Those that left stay where they are.
                        let (next_re, next_z) =
                            (re[lane] * re[lane] - z[lane] * z[lane] - 0.8, 2.0 * re[lane] * z[lane] + im);
                        re[lane] = if inside == 1 { next_re } else { re[lane] };
                        z[lane] = if inside == 1 { next_z } else { z[lane] };
                        count[lane] += inside;
                        within += inside;
                    }
                    if within == 0 {
                        break;
                    }
                }
                out.copy_from_slice(&count);
            }
        }
    }
}

versions! {
    /// Four tables, so that equal keys one after another do not wait for each other; then their sum.
    pub fn histogram(keys: &[i32], counts: &mut [i32]) {
        let mut tables = [[0i32; 256]; 4];
        let (chunks, rest) = keys.as_chunks::<4>();
        for chunk in chunks {
            for (table, &key) in tables.iter_mut().zip(chunk) {
                table[key as usize & 255] += 1;
            }
        }
        for &key in rest {
            tables[0][key as usize & 255] += 1;
        }
        for (key, count) in counts.iter_mut().enumerate() {
            *count += tables.iter().map(|table| table[key]).sum::<i32>();
        }
    }
}
