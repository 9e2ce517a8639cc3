//! What a step touches in each layout, as `allotrope count` has told it.

use super::super::html::{Table, inline, svg_part};
use super::{Findings, Html, Section};
use crate::lab::counts::{Layout, Member, Report};
use crate::lab::errors::LabError;
use crate::lab::map::escaped;
use crate::lab::table::mebibytes;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let Some(counts) = &findings.counts else { return Ok(None) };
    let body = shown(counts, &findings.commands.count(counts.steps));
    Ok(Some(Section { id: "counts", title: "What a step touches", body }))
}

fn shown(counts: &Report, command: &str) -> Html {
    let steps = if counts.steps == 1 { "one step".to_string() } else { format!("{} steps", counts.steps) };
    let [first, second] = counts.caches.map(|[bytes, ways]| format!("{} KiB of {ways} ways", bytes >> 10));
    let html = Html::default()
        .paragraph(&format!(
            "Times differ from machine to machine; counts do not. These are of {steps} from the start of the scene, on one thread. All layouts make the same \
             accesses, but spread them over more or fewer cache lines of {} bytes. Each member is counted by itself: useful bytes are those of a line that the member has touched. Misses are \
             those of a model: {first} before {second}. Shared lines are those that two threads would both write, each with half of a loop.",
            counts.line
        ))
        .table(&sums(counts))
        .command("By a program that was built with `--features probe`, these counts are made by:", command);
    let html = counts
        .layouts
        .iter()
        .fold(html, |html, layout| html.heading(&format!("`{}` loop by loop", layout.layout)).table(&loops(layout)));
    heat(counts).into_iter().fold(html, |html, (field, figures)| {
        html.heading(&format!("How often the lines of `{field}` were touched"))
            .markup(&format!("<div class=\"maps\" data-heat=\"{}\">\n{figures}</div>", escaped(field)))
    })
}

/// The most rows of a map of heat.
const ROWS: usize = 40;

/// The maps of all layouts, field by field.
fn heat(counts: &Report) -> Vec<(&str, String)> {
    let mut fields: Vec<(&str, String)> = Vec::new();
    for Layout { layout, heat, .. } in &counts.layouts {
        for map in heat {
            let caption = inline(&format!("in `{layout}`"));
            let figure = format!(
                "<figure><figcaption>{caption}</figcaption>{}</figure>\n",
                svg_part(&map.coarser(ROWS).svg(&map.field), 0)
            );
            match fields.iter_mut().find(|(field, _)| *field == map.field) {
                Some((_, figures)) => *figures += &figure,
                None => fields.push((&map.field, figure)),
            }
        }
    }
    fields
}

const COLUMNS: [&str; 6] = ["accesses", "MiB", "cache lines", "useful bytes a line", "misses, first", "misses, second"];

fn numbers(sum: &Member) -> [String; 6] {
    let [first, second] = sum.misses;
    [
        sum.count.to_string(),
        mebibytes(sum.bytes),
        sum.lines.to_string(),
        format!("{:.1}", sum.useful_bytes_a_line()),
        first.to_string(),
        second.to_string(),
    ]
}

/// The layouts side by side; the one with the fewest misses of the second cache stands out.
fn sums(counts: &Report) -> Table {
    let misses = |layout: &Layout| layout.total().misses[1];
    let fewest = counts.layouts.iter().map(misses).min();
    let row = |layout: &Layout| {
        let shared = [layout.shared_lines().to_string()];
        let cells = [format!("`{}`", layout.layout)].into_iter().chain(numbers(&layout.total())).chain(shared);
        (cells.collect(), Some(misses(layout)) == fewest)
    };
    Table {
        caption: "all loops together; the layout with the fewest misses of the second cache stands out".into(),
        headline: ["layout"].into_iter().chain(COLUMNS).chain(["shared lines"]).map(String::from).collect(),
        words: 1,
        rows: counts.layouts.iter().map(row).collect(),
    }
}

/// What each loop touches in a layout.
fn loops(layout: &Layout) -> Table {
    let rows = layout.loops.iter().map(|row| {
        let times = if row.launches > 1 { format!(", {} times", row.launches) } else { String::new() };
        let name = format!("`{}`, loop {}{times}", row.kernel, row.number + 1);
        ([name].into_iter().chain(numbers(&row.total())).collect(), false)
    });
    Table {
        caption: format!("`{}`: each parallel loop", layout.layout),
        headline: ["loop"].into_iter().chain(COLUMNS).map(String::from).collect(),
        words: 1,
        rows: rows.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::counts::{HeatMap, Loop};

    #[test]
    fn layouts_stand_side_by_side_and_loop_by_loop() {
        let layout = |name: &str, misses: u64| Layout {
            layout: name.into(),
            bytes: 1 << 20,
            loops: vec![Loop {
                kernel: "clear".into(),
                number: 0,
                launches: 2,
                shared_lines: 3,
                members: vec![Member {
                    count: 100,
                    bytes: 400,
                    lines: 10,
                    useful_bytes: 320,
                    misses: [misses, misses],
                    ..Member::default()
                }],
            }],
            heat: vec![HeatMap { field: "grid".into(), lines: 3, together: 1, touches: vec![4, 0, 9] }],
        };
        let counts = Report {
            solver: "mpm".into(),
            scene: "mpm88".into(),
            steps: 1,
            line: 64,
            caches: [[32 << 10, 8], [2 << 20, 16]],
            layouts: vec![layout("aos+row", 9), layout("soa+soa", 5)],
        };
        let html = shown(&counts, "allotrope count mpm");
        let text = html.text();
        assert!(
            text.contains("These are of one step") && text.contains("32 KiB of 8 ways before 2048 KiB of 16 ways"),
            "{text}"
        );
        assert!(text.contains("allotrope count mpm") && text.contains("<code>clear</code>, loop 1, 2 times"), "{text}");
        assert!(text.contains("<td class=\"number\">32.0</td>"), "{text}");
        let maps = text.split_once("<div class=\"maps\" data-heat=\"grid\">").expect("maps of heat").1;
        assert!(
            maps.matches("the hottest was touched 9 times").count() == 2 && maps.contains("in <code>soa+soa</code>")
        );
        let table = sums(&counts);
        assert_eq!(table.rows.iter().map(|(_, stands_out)| *stands_out).collect::<Vec<_>>(), [false, true]);
    }
}
