//! The ranking as people read it.

use super::tuned::Tuned;
use super::{About, Found, Header};
use crate::lab::machine;
use crate::lab::scene::size;
use crate::lab::statistics::{median, median_ratio_interval};
use crate::lab::table::{Table, error_digits, four_digits};

/// The interval of the ratio of one's times to the best's in the same steps.
fn interval(found: &Found, best: &Found) -> [f64; 2] {
    let common = found.pieces.len().min(best.pieces.len());
    median_ratio_interval(&found.pieces[..common], &best.pieces[..common])
}

/// The ratio of one's time to the best's in the same steps.
fn ratio(found: &Found, best: &Found) -> f64 {
    let common = found.pieces.len().min(best.pieces.len());
    median(&found.pieces[..common]) / median(&best.pieces[..common])
}

fn name(found: &Found) -> String {
    format!("{} with schedule {} and reorder {}", found.layout, found.schedule, found.reorder)
}

/// Scene and machine, what was checked, the ranking, how sure its first place is, and the line for `--tuned`.
pub(super) fn text(header: &Header, found: &[Found], about: &About, tuned: &Tuned) -> String {
    let best = &found[0];
    let mut table = Table::new(["layout", "schedule", "reorder", "rounds", "ms/step", "ratio", "95 % interval"], 3);
    for one in found {
        let [low, high] = interval(one, best);
        table.row([
            one.layout.to_string(),
            one.schedule.to_string(),
            one.reorder.to_string(),
            one.rounds.to_string(),
            four_digits(median(&one.pieces)),
            format!("{:.3}", ratio(one, best)),
            format!("{low:.3} to {high:.3}"),
        ]);
    }
    format!(
        "{} {}: {}\n{}, {} threads, {}\nall {} end in the same state: after {} steps positions differ by at most {}\n\
         {} rounds of interleaved pieces in {:.1} s, the last to step {} ({:.4} s simulated); ratios are those in the same steps\n\n{}\n{}\n\n{}",
        header.solver,
        header.scene,
        size(header.particles, "", &header.grid),
        machine::processor(),
        header.threads,
        header.isa,
        found.len(),
        about.verified,
        error_digits(about.agreement),
        about.rounds,
        about.seconds,
        about.verified + about.steps,
        about.time,
        table.text(),
        verdict(found),
        tuned.line(),
    )
}

/// The best, and how sure that is.
fn verdict(found: &[Found]) -> String {
    let best = &found[0];
    let level: Vec<String> = found[1..].iter().filter(|one| interval(one, best)[0] <= 1.0).map(name).collect();
    match (found.get(1), &level[..]) {
        (None, _) => format!("{}: there was nothing to choose from", name(best)),
        (Some(next), []) => {
            let [low, high] = interval(next, best);
            format!("{}: the next takes {:.3} times as long ({low:.3} to {high:.3})", name(best), ratio(next, best))
        }
        (_, level) => format!(
            "{}, which these measurements do not tell from {}: any of them will do, or search for longer",
            name(best),
            level.join(", ")
        ),
    }
}

#[cfg(test)]
mod tests {
    use allotrope_solvers::scene::Reorder;

    use super::*;

    fn found(layout: &'static str, times: [f64; 6]) -> Found {
        Found { layout, schedule: "auto", reorder: Reorder::Never, pieces: times.into(), rounds: 1 }
    }

    #[test]
    fn the_verdict_tells_how_sure_it_is() {
        let best = found("aos", [1.0, 1.1, 1.0, 1.1, 1.0, 1.1]);
        let slower = found("soa", [1.3, 1.4, 1.3, 1.5, 1.3, 1.4]);
        let level = found("split", [1.1, 1.0, 1.1, 1.0, 1.1, 1.05]);
        let one = verdict(&[best.clone(), slower.clone()]);
        assert!(
            one.starts_with("aos with schedule auto and reorder 0: the next takes 1.286 times as long (1.2"),
            "{one}"
        );
        let two = verdict(&[best.clone(), level, slower]);
        assert!(two.contains("do not tell from split with schedule auto and reorder 0: any"), "{two}");
        assert!(verdict(&[best]).ends_with("nothing to choose from"));
    }
}
