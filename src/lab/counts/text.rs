//! Counts, for people.

use std::fmt::Write;

use super::report::{Layout, Member, Report};
use crate::lab::table::{Table, mebibytes};

/// Layouts of which all members are told; of more, the sums are.
const IN_DETAIL: usize = 2;

/// What was touched: the layouts side by side, and of few of them each member in each loop.
pub(super) fn text(report: &Report) -> String {
    let [first, second] = report.caches.map(|[bytes, ways]| format!("{} KiB of {ways} ways", bytes >> 10));
    let steps = if report.steps == 1 { "one step".to_string() } else { format!("{} steps", report.steps) };
    let mut text = format!(
        "{} {}: what {steps} from the start of the scene touch, on one thread\nmodelled caches: {first} before {second}; \
         lines of {} bytes\n\n{}\n",
        report.solver,
        report.scene,
        report.line,
        sums(report).text()
    );
    text.push_str(
        "each member is counted by itself, so that a line which holds two is two lines; useful: bytes of it that the member had touched\n\
         shared: lines that two threads would both write, each with half of a loop\n",
    );
    if report.layouts.len() > IN_DETAIL {
        let _ = writeln!(text, "`--layouts {}` tells it member by member", report.layouts[0].layout);
        return text;
    }
    for layout in &report.layouts {
        let _ = write!(text, "\n{}\n{}", layout.layout, members(layout).text());
    }
    text
}

/// A number with its thousands apart.
fn apart(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// What one line of counts tells of all that was touched.
fn columns(sum: &Member) -> [String; 6] {
    let [first, second] = sum.misses;
    [
        apart(sum.count),
        mebibytes(sum.bytes),
        apart(sum.lines),
        format!("{:.1}", sum.useful_bytes_a_line()),
        apart(first),
        apart(second),
    ]
}

const COLUMNS: [&str; 6] = ["accesses", "MiB", "lines", "useful", "L1 misses", "L2 misses"];

fn sums(report: &Report) -> Table {
    let mut table = Table::new(["layout"].into_iter().chain(COLUMNS).chain(["shared", "held MiB"]), 1);
    for layout in &report.layouts {
        let row = [layout.layout.clone()].into_iter().chain(columns(&layout.total()));
        table.row(row.chain([apart(layout.shared_lines()), mebibytes(layout.bytes as u64)]));
    }
    table
}

fn members(layout: &Layout) -> Table {
    let mut table = Table::new(["loop", "member", "access", "index"].into_iter().chain(COLUMNS), 4);
    for row in &layout.loops {
        let several = layout.loops.iter().filter(|other| other.kernel == row.kernel).count() > 1;
        let mut name = if several { format!("{} {}", row.kernel, row.number) } else { row.kernel.clone() };
        if row.launches > 1 {
            let _ = write!(name, " x {}", row.launches);
        }
        for member in &row.members {
            let words = [std::mem::take(&mut name), member.path(), member.access.clone(), member.index.clone()];
            table.row(words.into_iter().chain(columns(member)));
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::counts::report::Loop;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!([0, 999, 1000, 1_234_567].map(apart), ["0", "999", "1 000", "1 234 567"]);
    }

    #[test]
    fn few_layouts_are_told_member_by_member() {
        let member = |member: &str, access: &str, count| Member {
            field: "grid".into(),
            member: member.into(),
            access: access.into(),
            index: "own".into(),
            count,
            bytes: 4 * count,
            lines: count / 4,
            useful_bytes: 4 * count,
            misses: [count / 4, 0],
        };
        let layout = |name: &str| Layout {
            layout: name.into(),
            heat: Vec::new(),
            bytes: 1 << 20,
            loops: vec![Loop {
                kernel: "clear".into(),
                number: 0,
                launches: 2,
                shared_lines: 1,
                members: vec![member("v", "write", 2000), member("m", "write", 1000)],
            }],
        };
        let mut report = Report {
            solver: "mpm".into(),
            scene: "mpm88".into(),
            steps: 2,
            line: 64,
            caches: [[32 << 10, 8], [2 << 20, 16]],
            layouts: vec![layout("aos+row")],
        };
        let one = text(&report);
        assert!(one.starts_with("mpm mpm88: what 2 steps from the start of the scene touch, on one thread\n"), "{one}");
        assert!(
            one.contains("\naos+row     3 000  0.01    750    16.0        750          0       1      1.00\n"),
            "{one}"
        );
        assert!(
            one.contains("\nclear x 2  grid.v  write   own       2 000  0.01    500    16.0        500          0\n"),
            "{one}"
        );
        assert!(one.contains("\n           grid.m  write   own       1 000"), "{one}");
        report.layouts.extend([layout("soa+soa"), layout("hot+row")]);
        let many = text(&report);
        assert!(
            !many.contains("clear") && many.ends_with("\n`--layouts aos+row` tells it member by member\n"),
            "{many}"
        );
    }
}
