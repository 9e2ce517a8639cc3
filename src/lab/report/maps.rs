//! Where the records of the compared layouts lie, as pictures.

use super::html::svg_part;
use crate::lab::bench::contender::Contender;
use crate::lab::map::Drawing;

/// The most cache lines that are drawn of a field.
const LINES: usize = 8;

/// The memory of a field, and the layouts in which it is the same.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::lab) struct Drawn {
    /// The field.
    pub(in crate::lab) field: String,
    /// The layouts of the solver whose field lies so.
    pub(in crate::lab) layouts: Vec<String>,
    /// The picture.
    pub(in crate::lab) svg: String,
}

/// The pictures of all fields, field by field, and the layouts of which there is none.
pub(super) fn draw(contenders: &[Contender]) -> (Vec<Drawn>, Vec<String>) {
    let (mut drawn, mut missing): (Vec<Drawn>, Vec<String>) = (Vec::new(), Vec::new());
    let mut seen: Vec<&str> = Vec::new();
    for Contender { layout, simulation, .. } in contenders {
        // What was run with several schedules has its layout once.
        if seen.contains(layout) {
            continue;
        }
        seen.push(layout);
        let maps = simulation.memory_maps();
        if maps.is_empty() {
            missing.push(layout.to_string());
        }
        for (field, map) in maps {
            let svg = Drawing { title: field.into(), subtitle: String::new(), lines: LINES }.svg(&map);
            match drawn.iter_mut().find(|other| other.field == field && other.svg == svg) {
                Some(same) => same.layouts.push(layout.to_string()),
                None => {
                    let (field, layouts) = (field.to_string(), vec![layout.to_string()]);
                    drawn.push(Drawn { field, layouts, svg });
                }
            }
        }
    }
    let mut fields: Vec<String> = Vec::new();
    for Drawn { field, .. } in &drawn {
        if !fields.contains(field) {
            fields.push(field.clone());
        }
    }
    drawn.sort_by_key(|one| fields.iter().position(|field| *field == one.field));
    for (n, one) in drawn.iter_mut().enumerate() {
        one.svg = svg_part(&one.svg, n);
    }
    (drawn, missing)
}
