//! Pictures of a plane: particles as soft splats that flow together, each in its colour; particles that are joined as dots
//! with lines between them. A line, which has no height, lies in the middle of a strip.

use allotrope_solvers::Simulation;

use super::canvas::Canvas;
use super::collider;
use super::colour::{Colour, NIGHT};
use super::{Camera, SIDE, wires};

/// Standard deviation of a splat, in distances between particles at rest.
const WIDTH: f64 = 0.8;

/// The height of a strip over its length.
const STRIP: f64 = 0.125;

pub(super) fn draw(camera: &Camera, simulation: &dyn Simulation) -> Canvas {
    let [width, height, _] = simulation.extent();
    let (height, lift) =
        if simulation.dimensions() == 1 { (STRIP * width, 0.5 * STRIP * width) } else { (height, 0.0) };
    let scale = SIDE as f64 / width.max(height);
    let (columns, rows) = (((width * scale).round() as usize).max(1), ((height * scale).round() as usize).max(1));
    let spacing = simulation.spacing() * scale;
    let deviation = (WIDTH * spacing).max(0.7);
    let reach = (2.5 * deviation).ceil() as i64;

    // Density of splats in each pixel, and their mean colour times it. A particle at rest adds, over a spacing squared,
    // one.
    let mut density = vec![0f32; columns * rows];
    let mut coloured = vec![Colour::default(); columns * rows];
    let unit = spacing * spacing / (2.0 * std::f64::consts::PI * deviation * deviation);
    let place = |x: [f64; 3]| [x[0] * scale - 0.5, rows as f64 - 0.5 - (x[1] + lift) * scale];
    let (dots, lines) = wires::dots_and_lines(simulation, camera.colours(simulation), place);
    let splats = if lines.is_empty() { &dots[..] } else { &[] };
    for &wires::Dot { at: [column, row], colour } in splats {
        for r in (row.round() as i64 - reach).max(0)..=(row.round() as i64 + reach).min(rows as i64 - 1) {
            for c in (column.round() as i64 - reach).max(0)..=(column.round() as i64 + reach).min(columns as i64 - 1) {
                let square = (c as f64 - column).powi(2) + (r as f64 - row).powi(2);
                let weight = (unit * (-0.5 * square / (deviation * deviation)).exp()) as f32;
                let pixel = r as usize * columns + c as usize;
                density[pixel] += weight;
                coloured[pixel] = coloured[pixel] + colour * weight;
            }
        }
    }

    let colliders = collider::at(&camera.colliders, simulation.time());
    let night = Colour::hex(NIGHT);
    let (tank, border) = (Colour::hex(0x141b2d), Colour::hex(0x33415f));
    let wall = simulation.margin() * scale;
    let cover = |column: usize, row: usize| 1.0 - (-2.2 * density[row * columns + column]).exp();
    let mut canvas = Canvas::of(columns, rows, |column, row| {
        // Distance into the tank; its wall is drawn two pixels wide.
        let inward =
            [column, columns - 1 - column, row, rows - 1 - row].into_iter().min().unwrap_or(0) as f64 + 0.5 - wall;
        let back = if inward < -2.0 {
            night
        } else if inward < 0.0 {
            border
        } else {
            tank
        };
        let here = row * columns + column;
        // Colliders stand before fluid, whose soft edge is wider than the gap between them; the wall before both.
        let solid = |colour: Colour| {
            if inward < 0.0 {
                return colour;
            }
            let x = [(column as f64 + 0.5) / scale, (rows as f64 - row as f64 - 0.5) / scale - lift, 0.0];
            colliders.iter().fold(colour, |colour, shape| {
                let (grey, share) = collider::flat(shape.distance(x) * scale);
                colour.mix(grey, share)
            })
        };
        if density[here] < 1e-3 {
            return solid(back);
        }
        // Light from above left makes the surface stand out.
        let (left, right) = (cover(column.saturating_sub(3), row), cover((column + 3).min(columns - 1), row));
        let (above, below) = (cover(column, row.saturating_sub(3)), cover(column, (row + 3).min(rows - 1)));
        let light = 1.0 + 0.5 * (right - left + below - above).clamp(-1.0, 1.0);
        let fluid = coloured[here] * (1.0 / density[here]);
        solid(back.mix(fluid * light, cover(column, row)))
    });
    if !lines.is_empty() {
        wires::draw(&mut canvas, &dots, &lines, spacing);
    }
    canvas
}
