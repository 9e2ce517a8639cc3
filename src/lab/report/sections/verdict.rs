//! What to choose, why, and how sure that is.

use super::super::ranking::{FEWEST, Ranked};
use super::{Findings, Html, Section, code, either, listed};
use crate::lab::errors::LabError;
use crate::lab::table::{error_digits, four_digits};

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let (ranking, repetitions) = (&findings.ranking[..], findings.about.repetitions);
    let mut body = Html::default().verdict(&verdict(ranking, repetitions));
    let reasons: Vec<String> = [why(ranking), loss(ranking), memory(ranking)].into_iter().flatten().collect();
    body = body.list(&reasons).heading("How sure is that?").list(&sureness(findings));
    if ranking.len() > 1 {
        let what = "To decide between what is level here, and to try schedules and intervals of sorting too, search for longer:";
        body = body.command(what, &findings.commands.search());
    }
    body = body.command("This page is made again by:", &findings.commands.report());
    Ok(Some(Section { id: "choice", title: "What to choose", body }))
}

/// The best, what is level with it, and the margin to the next.
pub(in crate::lab::report) fn verdict(ranking: &[Ranked], repetitions: u64) -> String {
    let [best, others @ ..] = ranking else { return "There is nothing to choose from.".into() };
    let level: Vec<&String> = others.iter().filter(|one| one.is_level).map(|one| &one.name).collect();
    let time = format!("a step takes {} ms", four_digits(best.ms));
    match others {
        [] => format!("There was one layout alone, `{}`: {time}.", best.name),
        _ if repetitions < FEWEST => format!(
            "`{}` was the fastest ({time}), but {repetitions} repetitions are too few to tell layouts apart: take at least {FEWEST} steps.",
            best.name
        ),
        [next, ..] if level.is_empty() => format!(
            "Choose `{}`: {time}. The next, `{}`, takes {:.3} times as long ({}).",
            best.name,
            next.name,
            next.ratio,
            interval(next)
        ),
        _ if level.len() == others.len() => format!(
            "`{}` was the fastest ({time}), but these measurements do not tell it from {}: any of them will do.",
            best.name,
            listed(&code(level))
        ),
        _ => {
            let next = others.iter().find(|one| !one.is_level);
            let next = next.map_or(String::new(), |next| {
                format!(
                    " `{}`, the first that is slower beyond the noise, takes {:.3} times as long ({}).",
                    next.name,
                    next.ratio,
                    interval(next)
                )
            });
            format!(
                "Choose {}: `{}` was the fastest ({time}), but these measurements do not tell the others from it.{next}",
                either(&code([&best.name].into_iter().chain(level))),
                best.name
            )
        }
    }
}

fn interval(one: &Ranked) -> String {
    let [low, high] = one.ratio_interval;
    format!("95 % interval {low:.3} to {high:.3}")
}

/// Where the best spends its time, and where it gains most over the slowest.
fn why(ranking: &[Ranked]) -> Option<String> {
    let [best, others @ ..] = ranking else { return None };
    let total: f64 = best.kernels.iter().map(|(_, time)| time).sum();
    let (longest, time) = best.kernels.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let mut text =
        format!("With `{}`, {:.0} % of a step is spent in the part `{longest}`.", best.name, 100.0 * time / total);
    let slowest = others.last().filter(|one| !one.is_level)?;
    let gains = slowest.kernels.iter().filter_map(|(name, time)| {
        let own = best.kernels.iter().find(|(other, _)| other == name)?.1;
        Some((name, time - own))
    });
    let (most, gain) = gains.max_by(|a, b| a.1.total_cmp(&b.1))?;
    text += &format!(
        " Against the slowest, `{}`, it gains most in the part `{most}`: {} of {} ms a step.",
        slowest.name,
        four_digits(gain),
        four_digits(slowest.ms - best.ms)
    );
    Some(text)
}

/// What the worst choice costs.
fn loss(ranking: &[Ranked]) -> Option<String> {
    let slowest = ranking.last().filter(|one| !one.is_level)?;
    Some(format!(
        "The worst choice, `{}`, takes {:.2} times as long as the best ({}).",
        slowest.name,
        slowest.ratio,
        interval(slowest)
    ))
}

/// How much memory the best takes, and what takes less.
fn memory(ranking: &[Ranked]) -> Option<String> {
    let (best, least) = (ranking.first()?, ranking.iter().min_by_key(|one| one.bytes)?);
    let mebibytes = |one: &Ranked| format!("{:.2} MiB", one.bytes as f64 / f64::from(1 << 20));
    let less = if least.bytes < best.bytes {
        format!("the least is {} with `{}`", mebibytes(least), least.name)
    } else {
        "no other takes less".into()
    };
    Some(format!("`{}` takes {} of memory; {less}.", best.name, mebibytes(best)))
}

/// What speaks for and against the numbers.
fn sureness(findings: &Findings) -> Vec<String> {
    let (about, ranking, here) = (&findings.about, &findings.ranking, &findings.surroundings);
    let widest = ranking.iter().map(|one| one.spread).fold(0.0, f64::max);
    let outliers: usize = ranking.iter().map(|one| one.outliers).sum();
    let slowest = ranking.iter().map(|one| one.slowest).fold(0.0, f64::max);
    let mut said = Vec::new();
    if ranking.len() > 1 {
        said.push(format!(
            "All {} ended in the same state before anything was timed: after {} steps no position differed by more than {} m.",
            ranking.len(),
            about.verified,
            error_digits(about.agreement)
        ));
    }
    said.push(format!(
        "{} steps of each were timed in {} repetitions, in turn, so that whatever slows the machine meets all alike.",
        about.steps, about.repetitions
    ));
    said.push(format!(
        "Repetitions of one layout differ by up to {:.1} % (the width of their middle half); {outliers} of {} lie far off, the slowest at {slowest:.2} times its median.",
        100.0 * widest,
        about.repetitions as usize * ranking.len()
    ));
    if let Some(load) = here.load {
        let busy = if load > 0.5 { ", which disturbs times" } else { "" };
        said.push(format!("Before that, {load:.1} programs on average wanted to run on this machine{busy}."));
    }
    if here.is_virtual {
        said.push("The machine is a virtual one: others that cannot be seen from here may disturb it.".into());
    }
    if cfg!(debug_assertions) {
        said.push("The program was built with checks, which take time too: do not choose by these numbers.".into());
    }
    said.push("The intervals tell of the noise in this run. With another scene, another size, other threads or another machine the order may be another.".into());
    said
}

#[cfg(test)]
mod tests {
    use super::super::super::ranking::rank;
    use super::super::super::tests::{report, row};
    use super::*;

    fn ranking(times: &[(&str, f64)], repetitions: usize) -> Vec<Ranked> {
        let samples: Vec<Vec<f64>> = times
            .iter()
            .enumerate()
            .map(|(n, (_, time))| (0..repetitions).map(|k| time + 0.02 * ((k * 7 + 3 * n) % 11) as f64 - 0.1).collect())
            .collect();
        rank(&report(times.iter().map(|(name, time)| row(name, *time)).collect()), &samples)
    }

    #[test]
    fn the_verdict_tells_how_sure_it_is() {
        let clear = verdict(&ranking(&[("aos", 1.0), ("soa", 2.0)], 11), 11);
        assert!(
            clear.starts_with(
                "Choose `aos`: a step takes 1.000 ms. The next, `soa`, takes 2.000 times as long (95 % interval 1."
            ),
            "{clear}"
        );
        let level = verdict(&ranking(&[("aos", 1.0), ("split", 1.001), ("soa", 2.0)], 11), 11);
        assert!(
            level.starts_with("Choose `aos` or `split`: `aos` was the fastest (a step takes 1.000 ms), but"),
            "{level}"
        );
        assert!(level.contains(" `soa`, the first that is slower beyond the noise, takes 2.000 times"), "{level}");
        let none = verdict(&ranking(&[("aos", 1.0), ("split", 1.001)], 11), 11);
        assert!(none.contains("do not tell it from `split`: any of them will do"), "{none}");
        let few = verdict(&ranking(&[("aos", 1.0), ("soa", 2.0)], 3), 3);
        assert!(few.contains("3 repetitions are too few"), "{few}");
        assert!(verdict(&ranking(&[("aos", 1.0)], 11), 11).starts_with("There was one layout alone, `aos`"));
    }

    #[test]
    fn the_reason_is_the_kernel_that_gains_most() {
        let ranking = ranking(&[("aos", 1.0), ("soa", 2.0)], 11);
        // A row's kernels take three quarters and a quarter of a step.
        let wanted = "With `aos`, 75 % of a step is spent in the part `scatter`. Against the slowest, `soa`, it gains most in the part \
                      `scatter`: 0.7500 of 1.000 ms a step.";
        assert_eq!(why(&ranking).as_deref(), Some(wanted));
        assert!(loss(&ranking).is_some_and(|text| text.contains("`soa`, takes 2.00 times")));
        assert_eq!(memory(&ranking).as_deref(), Some("`aos` takes 1.00 MiB of memory; no other takes less."));
    }
}
