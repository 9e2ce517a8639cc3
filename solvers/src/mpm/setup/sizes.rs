//! The same scene in other sizes.

use std::sync::Arc;

use toml::Value;

use super::memory::node_bytes;
use super::{LONGEST, MpmSetup, Scheme};
use crate::scene::{Body, Fill, MOST_PARTICLES, Scene, SceneError, Shape, gibibytes};

/// A grid of more nodes is refused.
const MOST_NODES: u64 = 1 << 28;

/// Refuses a grid of too many nodes, and tells its size.
pub(super) fn check_nodes(grid: [usize; 3], dimensions: usize, scheme: Scheme) -> Result<(), String> {
    // At most 2^45.
    let nodes: u64 = grid.iter().map(|&nodes| nodes as u64).product();
    if nodes <= MOST_NODES {
        return Ok(());
    }
    let size = gibibytes((nodes * node_bytes(dimensions, scheme)) as f64);
    Err(format!(
        "has {nodes} nodes, which take {size}, and more than {MOST_NODES} (2^28) are refused without `sparse = true`"
    ))
}

/// The scene, which has this setup, on another grid.
///
/// # Errors
/// As [`Scene::with_grid`].
pub(super) fn with_grid(mut setup: MpmSetup, mut scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
    let old = setup.grid[0];
    let extents = resize(&mut setup, &scene, nodes)?;
    let dt = scene.dt * (old as f64 / nodes as f64);
    scene.rewrite(|table| {
        table.insert("grid".into(), extents);
        table.insert("dt".into(), dt.into());
    });
    Ok(Scene { dt, setup: Arc::new(setup), ..scene })
}

/// The scene, which has this setup, in another domain of the same cells.
///
/// # Errors
/// As [`Scene::with_room`].
pub(super) fn with_room(mut setup: MpmSetup, mut scene: Scene, nodes: usize) -> Result<Scene, SceneError> {
    let old = setup.grid[0];
    let extents = resize(&mut setup, &scene, nodes)?;
    setup.length *= nodes as f64 / old as f64;
    scene.rewrite(|table| {
        table.insert("grid".into(), extents);
        table.insert("length".into(), setup.length.into());
    });
    Ok(Scene { setup: Arc::new(setup), ..scene })
}

/// Gives a setup so many nodes along the first axis, and in proportion along the others; tells them as a scene does.
fn resize(setup: &mut MpmSetup, scene: &Scene, nodes: usize) -> Result<Value, SceneError> {
    let (old, least, dimensions) = (setup.grid[0], 2 * setup.wall + 4, setup.dimensions);
    for extent in &mut setup.grid[..dimensions] {
        *extent = (*extent as f64 * nodes as f64 / old as f64).round() as usize;
    }
    let key = format!("grid = {nodes}");
    if setup.grid[..dimensions].iter().any(|&extent| !(least..=LONGEST as usize).contains(&extent)) {
        return Err(scene.fault(key, format!("cannot be; an axis takes from {least} to {LONGEST} nodes")));
    }
    if !setup.sparse
        && let Err(fault) = check_nodes(setup.grid, dimensions, setup.transfer.scheme)
    {
        return Err(scene.fault(key, fault));
    }
    Ok(setup.grid[..dimensions].iter().map(|&extent| Value::from(extent as i64)).collect::<Vec<_>>().into())
}

/// The scene, which has this setup, with `count` particles: exactly so many where they are drawn at random, about so many
/// where they lie on a lattice, whose spacing is changed.
///
/// # Errors
/// If the spacing would leave its bounds, or positions are given one by one.
pub(super) fn with_particles(mut setup: MpmSetup, mut scene: Scene, count: usize) -> Result<Scene, SceneError> {
    let key = format!("particles = {count}");
    if count == 0 || count > MOST_PARTICLES {
        return Err(scene.fault(key, format!("is not from 1 to {MOST_PARTICLES}")));
    }
    let random = |body: &Body| match &body.shape {
        Shape::Box { fill: Fill::Random { particles, .. }, .. } => Some(*particles),
        _ => None,
    };
    let drawn: Vec<usize> = setup.bodies.iter().filter_map(random).collect();
    if setup.bodies.iter().any(|body| matches!(body.shape, Shape::Points(_))) {
        return Err(scene.fault(key, "cannot be, since the scene gives its particles one by one"));
    }
    if drawn.len() == setup.bodies.len() {
        let total: usize = drawn.iter().sum();
        let mut left = count;
        for (n, body) in setup.bodies.iter_mut().enumerate() {
            if let Shape::Box { fill: Fill::Random { particles, .. }, .. } = &mut body.shape {
                let share = (*particles as f64 / total as f64 * count as f64).round() as usize;
                *particles = if n + 1 == drawn.len() { left } else { share.min(left) };
                left -= *particles;
            }
        }
        let counts: Vec<_> = setup.bodies.iter().filter_map(random).collect();
        scene.rewrite(|table| {
            let bodies = table.get_mut("body").and_then(Value::as_array_mut).into_iter().flatten();
            for (body, count) in bodies.filter_map(Value::as_table_mut).zip(counts) {
                body.insert("particles".into(), (count as i64).into());
            }
        });
    } else if drawn.is_empty() {
        let volume: f64 = setup.bodies.iter().map(|body| body.shape.volume(setup.dimensions)).sum();
        let spacing = (volume / count as f64).powf(1.0 / setup.dimensions as f64) / setup.dx();
        if !(0.05..=1.0).contains(&spacing) {
            let message =
                format!("needs a spacing of {spacing:.3} cells, which is not from 0.05 to 1; change the grid too");
            return Err(scene.fault(key, message));
        }
        setup.spacing = spacing;
        scene.rewrite(|table| _ = table.insert("spacing".into(), spacing.into()));
    } else {
        return Err(scene.fault(key, "cannot be, since the scene has both random and regular bodies"));
    }
    Ok(Scene { setup: Arc::new(setup), ..scene })
}
