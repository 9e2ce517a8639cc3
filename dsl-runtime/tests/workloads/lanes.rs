//! Bodies over vector lanes: each kernel is written once and compiled with and without them, and gives the same bits.

use allotrope::prelude::*;

use super::{on_threads, scattered};

#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Walker {
    at: Vec2,
    steps: u16,
    lost: bool,
    heat: f64,
}

/// The kernels, with these options.
macro_rules! kernels {
    ($name:ident, $($option:tt)*) => {
        #[allow(dead_code, reason = "not all numbers of lanes are compiled for all kernels")]
        mod $name {
            use super::*;

            /// Uniform loops in one another, and what is kept around them.
            #[kernel($($option)*)]
            pub(super) fn forces(x: &Field<Vec3, _>, a: &mut Field<Vec3, _>) -> (f32, f32) {
                let (mut total, mut most) = (0.0, 0.0f32);
                let count = x.len() as i32;
                for i in a {
                    let here = x[i];
                    let mut sum = Vec3::ZERO;
                    for j in 0..count {
                        let arm = x[j] - here;
                        for power in 1..3 {
                            sum += arm / (arm.length_squared() + 0.01).powi(power);
                        }
                    }
                    a[i] = sum - a[i];
                    total += sum.x;
                    most.max_assign(sum.y);
                }
                (total, most)
            }

            /// Each lane leaves its loop by itself, and the number of them is no multiple of lanes.
            #[kernel($($option)*)]
            pub(super) fn julia(counts: &mut Field<u32, _, Ij>, im: f32) -> u32 {
                let [width, height] = counts.shape().map(|n| n as i32);
                let mut all = 0u32;
                for (i, j) in counts {
                    let mut re = (2 * i - width) as f32 / height as f32;
                    let mut z = (2 * j - height) as f32 / height as f32;
                    let mut count = 0;
                    while count < 50 && re * re + z * z < 400.0 {
                        (re, z) = (re * re - z * z - 0.8, 2.0 * re * z + im);
                        count += 1;
                    }
                    counts[(i, j)] = count;
                    all += count;
                }
                all
            }

            /// Branches around loops, loops of each lane's own length, names that hide one another, and variables of many types.
            #[kernel($($option)*)]
            pub(super) fn walk(walkers: &mut Field<Walker, _>, field: &Field<f32, _>) {
                let length = field.len();
                for i in walkers {
                    let mut at = walkers.at[i];
                    let mut lost = false;
                    let mut place = (i as usize * 7) % length;
                    let mut heat = walkers.heat[i];
                    let step: u16 = 3;
                    let mut seen = [0u8; 3];
                    if at.x > 0.0 {
                        for k in i..i + (i % 5) {
                            place = (place + k as usize) % length;
                            heat += f64::from(field[place]);
                            let at = k % 3;
                            seen[at as usize] += 1;
                        }
                    } else if at.y > 0.0 {
                        while place > 3 {
                            place /= 2;
                            at += Vec2::new(field[place], 1.0);
                            while at.x > 1.0 {
                                at.x -= 0.75;
                                heat *= 0.5;
                            }
                            heat += 1.0;
                        }
                        lost = place == 2;
                    } else {
                        at = -at;
                    }
                    // From here on another variable, made of the one that it hides.
                    let heat = {
                        heat += 0.125;
                        heat as f32
                    };
                    let mut rounds = 0;
                    for _ in 0..rounds + i % 3 {
                        rounds += 2;
                        if rounds > 3 {
                            lost = !lost;
                        }
                    }
                    walkers.at[i] = at;
                    walkers.heat[i] = f64::from(heat) + f64::from(seen[0]) + 10.0 * f64::from(seen[1]);
                    walkers.steps[i] += step + rounds as u16;
                    walkers.lost[i] = lost;
                }
            }

            /// A stencil that is read in loops, away from the border.
            #[kernel($($option)*)]
            pub(super) fn smooth(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
                for (i, j) in v.interior(1) {
                    let mut value = u[(i, j)];
                    let mut rounds = 0;
                    while rounds < 8 && value > 0.1 {
                        value = 0.25 * (value + u[(i, j - 1)] + u[(i, j + 1)] + u[(i - 1, j)]);
                        rounds += 1;
                    }
                    v[(i, j)] += value;
                }
            }

            /// Would overflow and leave the field, if a lane went on that has left its loop.
            #[kernel($($option)*)]
            pub(super) fn to_the_end(ends: &mut Field<u8, _>, list: &Field<i32, _>) {
                for i in ends {
                    let mut at = i;
                    let mut jumps = 0u8;
                    while at >= 0 {
                        at = list[at];
                        jumps += 1;
                    }
                    ends[i] = jumps;
                }
            }
        }
    };
}

kernels!(one_by_one,);
kernels!(four, lanes = 4);
kernels!(sixteen, lanes = 16);

/// Asserts that what a kernel gives is the same in lanes, to the bit, under each instruction set.
macro_rules! alike {
    ($kernel:ident in $($lanes:ident)* => $run:expr) => {
        on_threads(|| {
            let alone = {
                use one_by_one::$kernel;
                $run
            };
            $({
                use $lanes::$kernel;
                assert_eq!($run, alone, stringify!($lanes));
            })*
        })
    };
}

/// A field of these elements.
fn field_of<R: Record, L: Layout<I>>(values: impl ExactSizeIterator<Item = R>) -> Field<R, L> {
    let mut field = Field::new([values.len()]);
    values.enumerate().for_each(|(n, value)| field.set(n, value));
    field
}

fn forces_in<L: Layout<I>>() {
    let x = field_of::<Vec3, L>((0..85).map(|n| Vec3::new(scattered(n), scattered(n + 1000), scattered(n + 2000))));
    alike!(forces in sixteen => {
        let mut a = Field::<Vec3, L>::new([85]);
        forces(&x, &mut a);
        let ((total, most), a) = (forces(&x, &mut a), a.to_vec());
        (total.to_bits(), most.to_bits(), a.iter().map(|a| a.to_array().map(f32::to_bits)).collect::<Vec<_>>())
    });
}

#[test]
fn uniform_loops() {
    forces_in::<Aos>();
    forces_in::<AoSoA<32>>();
    forces_in::<layout!(pointer(i, 8).dense(i, 16).soa)>();
}

fn julia_in<L: Layout<Ij>>() {
    alike!(julia in four sixteen => {
        let mut counts = Field::<u32, L>::new([23, 90]);
        (julia(&mut counts, 0.19), counts.to_vec())
    });
}

#[test]
fn loops_that_lanes_leave_by_themselves() {
    julia_in::<Aos>();
    julia_in::<Blocked<16>>();
}

fn walk_in<L: Layout<I>>() {
    let walkers: Vec<Walker> = (0..150)
        .map(|n| Walker { at: 3.0 * Vec2::new(scattered(n), scattered(n + 500)), heat: n as f64, ..Walker::default() })
        .collect();
    let field = field_of::<f32, Soa>((0..37).map(|n| 2.0 * scattered(n).abs()));
    alike!(walk in four sixteen => {
        let mut walkers = field_of::<Walker, L>(walkers.iter().copied());
        walk(&mut walkers, &field);
        walk(&mut walkers, &field);
        walkers.iter().collect::<Vec<_>>()
    });
    let mut walkers = field_of::<Walker, L>(walkers.iter().copied());
    sixteen::walk(&mut walkers, &field);
    let lost = walkers.iter().filter(|walker| walker.lost).count();
    assert!((10..140).contains(&lost) && walkers.iter().any(|walker| walker.steps > 5), "{lost} lost");
}

#[test]
fn branches_and_loops_of_each_lanes_own() {
    walk_in::<Aos>();
    walk_in::<layout!(pointer(i, 8).dense(i, 32).aos)>();
}

fn smooth_in<L: Layout<Ij>>() {
    let values: Vec<f32> = (0..60 * 70).map(|n| scattered(n).abs()).collect();
    let mut u = Field::<f32, L>::new([60, 70]);
    u.copy_from_slice(&values);
    alike!(smooth in sixteen => {
        let mut v = Field::<f32, L>::new([60, 70]);
        smooth(&u, &mut v);
        v.to_vec()
    });
}

#[test]
fn rows_that_lead_into_other_blocks() {
    smooth_in::<Soa>();
    smooth_in::<Blocked<32>>();
    smooth_in::<layout!(pointer(ij, 4).dense(ij, 32).soa)>();
}

#[test]
fn lanes_that_have_ended_do_nothing() {
    // Place n leads to n - 1 - n % 3; the lane that starts at 250 jumps longest.
    let list = field_of::<i32, Soa>((0..251).map(|n| n - 1 - n % 3));
    alike!(to_the_end in sixteen => {
        let mut ends = Field::<u8, Soa>::new([251]);
        to_the_end(&mut ends, &list);
        ends.to_vec()
    });
}

#[test]
fn a_panic_in_a_lane_tells_kernel_field_and_index() {
    let list = Field::<i32, Soa>::new([40]).with_background(77);
    let mut ends = Field::<u8, Soa>::new([40]);
    let run = std::panic::AssertUnwindSafe(|| sixteen::to_the_end(&mut ends, &list));
    let panic = std::panic::catch_unwind(run).unwrap_err();
    let message = panic.downcast_ref::<String>().unwrap();
    assert!(message.contains("to_the_end") && message.contains("`list`") && message.contains("77"), "{message}");
}
