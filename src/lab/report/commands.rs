//! The commands that make the numbers of a page again.

use super::Plan;
use crate::lab::machine;
use crate::lab::shell::quoted;

/// What all commands have in common.
#[derive(Clone, Debug)]
pub(in crate::lab) struct Commands {
    /// What has to be in the environment: an instruction set, say.
    environment: String,
    solver: String,
    /// Options of the scene.
    scene: Vec<String>,
    layouts: String,
    schedules: String,
    threads: usize,
    /// The words of the report's own command.
    whole: Vec<String>,
}

impl Commands {
    pub(super) fn of(plan: &Plan) -> Self {
        let instructions =
            std::env::var("ALLOTROPE_CPU").map_or(String::new(), |set| format!("ALLOTROPE_CPU={} ", quoted(&set)));
        let schedules: Vec<&str> = plan.bench.schedules.iter().map(|schedule| schedule.name).collect();
        Self {
            environment: instructions,
            solver: plan.bench.solver.name.to_string(),
            scene: plan.scene.clone(),
            layouts: plan.bench.layouts.join(","),
            schedules: schedules.join(","),
            threads: machine::threads(plan.bench.threads),
            whole: plan.command.clone(),
        }
    }

    /// The page itself.
    pub(in crate::lab) fn report(&self) -> String {
        self.line(&self.whole)
    }

    /// The comparison of all layouts over so many steps.
    pub(in crate::lab) fn bench(&self, steps: u64) -> String {
        self.line(&self.compared(&["--steps".into(), steps.to_string()]))
    }

    /// The same, in which processor and system count.
    pub(in crate::lab) fn bench_hardware(&self) -> String {
        self.line(&self.compared(&["--hardware".into()]))
    }

    /// The same at some sizes.
    pub(in crate::lab) fn sweep(&self, points: &[String], steps: u64) -> String {
        let words = ["--steps", &steps.to_string(), "--sweep", "size", "--points", &points.join(","), "--out", "sizes"];
        self.line(&self.compared(&words.map(String::from)))
    }

    /// A run to the last step, with pictures of both ends.
    pub(in crate::lab) fn run(&self, layout: &str, schedule: &str, steps: u64) -> String {
        let (threads, steps) = (self.threads.to_string(), steps.to_string());
        let options =
            ["--layout", layout, "--schedule", schedule, "--threads", &threads, "--steps", &steps, "--frames", "1"];
        self.line(&self.with("run", &options.map(String::from)))
    }

    /// A search among layouts, schedules and intervals of sorting.
    pub(in crate::lab) fn search(&self) -> String {
        self.line(&self.with("search", &["--budget", "60", "--threads", &self.threads.to_string()].map(String::from)))
    }

    /// What so many steps touch.
    pub(in crate::lab) fn count(&self, steps: u64) -> String {
        let options = ["--layouts", &self.layouts, "--steps", &steps.to_string()].map(String::from);
        self.line(&self.with("count", &[&options[..], &["--json".into(), "counts.json".into()]].concat()))
    }

    fn compared(&self, more: &[String]) -> Vec<String> {
        let threads = self.threads.to_string();
        let options = ["--layouts", &self.layouts, "--schedules", &self.schedules, "--threads", &threads];
        self.with("bench", &[&options.map(String::from), more].concat())
    }

    fn with(&self, command: &str, options: &[String]) -> Vec<String> {
        [&[command.into(), self.solver.clone()], &self.scene[..], options].concat()
    }

    fn line(&self, words: &[String]) -> String {
        let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
        format!("{}allotrope {}", self.environment, words.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_lines_of_a_shell() {
        let commands = Commands {
            environment: String::new(),
            solver: "mpm".into(),
            scene: ["--scene", "my scene.toml", "--set", "body.0.velocity=[1, 0]"].map(String::from).into(),
            layouts: "aos+row,soa+soa".into(),
            schedules: "auto".into(),
            threads: 2,
            whole: ["report", "mpm"].map(String::from).into(),
        };
        assert_eq!(commands.report(), "allotrope report mpm");
        let scene = "--scene 'my scene.toml' --set 'body.0.velocity=[1, 0]'";
        let wanted =
            format!("allotrope bench mpm {scene} --layouts aos+row,soa+soa --schedules auto --threads 2 --steps 110");
        assert_eq!(commands.bench(110), wanted);
        let wanted =
            format!("allotrope run mpm {scene} --layout soa+soa --schedule auto --threads 2 --steps 9 --frames 1");
        assert_eq!(commands.run("soa+soa", "auto", 9), wanted);
        assert!(commands.bench_hardware().ends_with(" --threads 2 --hardware"));
        let points = ["512", "2048"].map(String::from);
        assert!(commands.sweep(&points, 11).ends_with(" --steps 11 --sweep size --points 512,2048 --out sizes"));
    }
}
