//! Particles that are joined, as by springs: dots with lines between them.

use allotrope_solvers::Simulation;

use super::canvas::Canvas;
use super::colour::Colour;

/// Radius of a dot, in distances between particles at rest.
pub(super) const DOT: f64 = 0.2;

/// Half the width of a line, in the same.
pub(super) const LINE: f64 = 0.07;

/// Radii of dots in a plane, in pixels.
const DOTS: [f64; 2] = [2.0, 7.0];

/// Half the widths of lines in a plane, in pixels.
const LINES: [f64; 2] = [0.6, 2.0];

/// A particle where it is seen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dot<P> {
    pub(super) at: P,
    pub(super) colour: Colour,
}

/// The dots of all particles, and the two ends of each line. A line that joins what is not there is none.
pub(super) fn dots_and_lines<P: Copy>(
    simulation: &dyn Simulation,
    colours: Vec<Colour>,
    place: impl Fn([f64; 3]) -> P,
) -> (Vec<Dot<P>>, Vec<[Dot<P>; 2]>) {
    let dots: Vec<_> = simulation.positions().into_iter().map(place).zip(colours).collect();
    let dots: Vec<_> = dots.into_iter().map(|(at, colour)| Dot { at, colour }).collect();
    let end = |n: u32| dots.get(n as usize).copied();
    let lines = simulation.links().into_iter().filter_map(|[a, b]| Some([end(a)?, end(b)?])).collect();
    (dots, lines)
}

/// The colour of a line between two colours: darker than both, so that dots stand out.
pub(super) fn between(ends: &[Dot<impl Copy>; 2]) -> Colour {
    ends[0].colour.mix(ends[1].colour, 0.5) * 0.55
}

/// Draws dots and lines in a plane, at columns and rows of the canvas; neighbours at rest are `spacing` pixels apart.
pub(super) fn draw(canvas: &mut Canvas, dots: &[Dot<[f64; 2]>], lines: &[[Dot<[f64; 2]>; 2]], spacing: f64) {
    let half = (LINE * spacing).clamp(LINES[0], LINES[1]);
    for ends in lines {
        capsule(canvas, ends[0].at, ends[1].at, half, between(ends));
    }
    let radius = (DOT * spacing).clamp(DOTS[0], DOTS[1]);
    for dot in dots {
        capsule(canvas, dot.at, dot.at, radius, dot.colour);
    }
}

/// Mixes in all that lies within `radius` pixels of a line, with smooth edges.
fn capsule(canvas: &mut Canvas, from: [f64; 2], to: [f64; 2], radius: f64, colour: Colour) {
    let arm = [to[0] - from[0], to[1] - from[1]];
    let square = arm[0] * arm[0] + arm[1] * arm[1];
    let reach = radius + 1.0;
    let clip = |a: f64, b: f64, end: usize| {
        let [low, high] = [a.min(b) - reach, a.max(b) + reach].map(|x| x.clamp(0.0, end as f64));
        low as usize..high.ceil() as usize
    };
    for row in clip(from[1], to[1], canvas.height) {
        for column in columns_of(row as f64, from, to, reach, canvas.width) {
            let place = [column as f64 - from[0], row as f64 - from[1]];
            let along = (place[0] * arm[0] + place[1] * arm[1]) / square.max(f64::MIN_POSITIVE);
            let along = along.clamp(0.0, 1.0);
            let distance = (place[0] - along * arm[0]).hypot(place[1] - along * arm[1]);
            let share = (radius + 0.5 - distance).clamp(0.0, 1.0) as f32;
            let pixel = &mut canvas.pixels[row * canvas.width + column];
            *pixel = pixel.mix(colour, share);
        }
    }
}

/// The columns that a row of pixels may have in common with the surroundings of a line.
fn columns_of(row: f64, from: [f64; 2], to: [f64; 2], reach: f64, width: usize) -> std::ops::Range<usize> {
    let rise = to[1] - from[1];
    // The part of the line whose rows are near enough: all of a level one.
    let part = |edge: f64| ((row + edge * reach - from[1]) / rise).clamp(0.0, 1.0);
    let ends = if rise.abs() < 1e-9 { [0.0, 1.0] } else { [part(-1.0), part(1.0)] };
    let columns = ends.map(|share| from[0] + share * (to[0] - from[0]));
    let [low, high] = [columns[0].min(columns[1]) - reach, columns[0].max(columns[1]) + reach];
    low.clamp(0.0, width as f64) as usize..high.ceil().clamp(0.0, width as f64) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: Colour = Colour([1.0; 3]);

    fn canvas() -> Canvas {
        Canvas::of(60, 40, |_, _| Colour::default())
    }

    /// The light of all pixels, which is the area of what is white.
    fn area(canvas: &Canvas) -> f64 {
        canvas.pixels.iter().map(|pixel| f64::from(pixel.0[0])).sum()
    }

    #[test]
    fn a_line_has_its_width_and_its_length_in_any_direction() {
        for to in [[40.0, 20.0], [10.0, 35.0], [40.0, 35.0], [12.0, 3.0], [40.0, 21.0]] {
            let mut canvas = canvas();
            capsule(&mut canvas, [10.0, 20.0], to, 2.0, WHITE);
            let length = (to[0] - 10.0_f64).hypot(to[1] - 20.0);
            let wanted = 4.0 * length + std::f64::consts::PI * 4.0;
            assert!((area(&canvas) / wanted - 1.0).abs() < 0.03, "to {to:?}: {} for {wanted}", area(&canvas));
        }
    }

    #[test]
    fn what_leaves_the_picture_is_cut_off() {
        let mut canvas = canvas();
        capsule(&mut canvas, [-100.0, 20.0], [200.0, 20.0], 1.5, WHITE);
        assert!((area(&canvas) - 3.0 * 60.0).abs() < 1.0, "{}", area(&canvas));
        capsule(&mut canvas, [-50.0, -50.0], [-20.0, -90.0], 5.0, WHITE);
        capsule(&mut canvas, [500.0, 50.0], [f64::MAX, 90.0], 5.0, WHITE);
        assert!((area(&canvas) - 3.0 * 60.0).abs() < 1.0, "{}", area(&canvas));
    }
}
