//! The command line.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use allotrope::MAX_THREADS;
use allotrope_solvers::{Scene, SolverInfo, nearest};
use clap::error::{ContextKind, ErrorKind};
use clap::{Args, Parser, Subcommand};

use super::errors::LabError;
use super::machine::{self, NamedSchedule};
use super::{bench, list, output, run};

/// The layout laboratory: runs one simulation in many data layouts, and shows what each costs.
#[derive(Debug, Parser)]
#[command(name = "allotrope", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Tells which solvers, scenes, layouts and schedules there are
    List,
    /// Runs a scene in one layout and writes pictures of it
    Run(RunArguments),
    /// Runs a scene in many layouts, checks that they agree, and compares their speed
    Bench(BenchArguments),
}

/// What is asked of `allotrope run`.
#[derive(Args, Debug)]
pub struct RunArguments {
    #[command(flatten)]
    what: What,
    /// The layout, particles+grid [default: the first that `list` tells]
    #[arg(long, value_name = "L")]
    layout: Option<String>,
    /// How the grid is accumulated: auto, serial, private or atomic
    #[arg(long, value_name = "S", default_value = "auto")]
    schedule: String,
    /// Pictures to write, from the start to the end
    #[arg(long, value_name = "N", default_value_t = 60, conflicts_with = "every")]
    #[arg(value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    frames: u64,
    /// Steps from one picture to the next, instead of `--frames`
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    every: Option<u64>,
    /// The folder for the pictures; it is made if it is not there
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
}

/// What is asked of `allotrope bench`.
#[derive(Args, Debug)]
pub struct BenchArguments {
    #[command(flatten)]
    what: What,
    /// The layouts, with commas between them, or `all`
    #[arg(long, value_name = "A,B", default_value = "all")]
    layouts: String,
    /// How the grid is accumulated, with commas between: auto, serial, private, atomic
    #[arg(long, value_name = "A,B", default_value = "auto")]
    schedules: String,
    /// Writes the results to a file too, as one line of JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

#[derive(Args, Debug)]
struct What {
    /// The solver; `list` tells which there are
    solver: String,
    /// The scene: a built-in name, or a TOML file [default: the first that `list` tells]
    #[arg(long, value_name = "S")]
    scene: Option<String>,
    /// Another number of particles than the scene's
    #[arg(long, value_name = "N", value_parser = count)]
    particles: Option<usize>,
    /// Another number of nodes along the first axis than the scene's; the time step is scaled with the cells
    #[arg(long, value_name = "N", value_parser = count)]
    grid: Option<usize>,
    /// Steps after which particles are sorted by cell, 0 for never [default: the scene's; with --particles above 65536,
    /// 32]
    #[arg(long, value_name = "N")]
    reorder: Option<u64>,
    /// Threads [default: ALLOTROPE_THREADS, or as many as the processor runs]
    #[arg(long, value_name = "N", value_parser = threads)]
    threads: Option<usize>,
    /// Steps to take [default: the scene's; of `bench`, what takes about 20 seconds, 1100 at most]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    steps: Option<u64>,
}

const COMMANDS: [&str; 3] = ["list", "run", "bench"];

fn count(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(0) => Err("it must be at least 1".into()),
        Ok(count) => Ok(count),
        Err(_) => Err("a whole number above zero is wanted".into()),
    }
}

fn threads(text: &str) -> Result<usize, String> {
    match count(text)? {
        many if many > MAX_THREADS => Err(format!("{many} threads are more than the {MAX_THREADS} that are supported")),
        some => Ok(some),
    }
}

/// More particles than this are sorted by cell unless the command says otherwise: grid and particles no longer fit into
/// a core's second cache, and a scattered access costs more than the sort does.
const SORTED_ABOVE: usize = 1 << 16;

/// How often they are sorted: within so many steps the fastest of them cross some cells, and the cost of a sort is
/// spread thin.
const SORTED_EVERY: u64 = 32;

impl What {
    fn solver(&self) -> Result<&'static SolverInfo, LabError> {
        allotrope_solvers::solver(&self.solver).map_err(LabError::usage)
    }

    /// The scene as it was asked for. What looks like a file (with a dot or a separator in its name, or there) is read
    /// as one.
    fn scene(&self, solver: &SolverInfo) -> Result<Scene, LabError> {
        let name = self.scene.as_deref().unwrap_or(solver.scenes[0].name);
        let built_in = solver.scenes.iter().any(|scene| scene.name == name);
        let file = name.contains(['/', '\\', '.']) || Path::new(name).is_file();
        let mut scene = if file && !built_in { Scene::load(Path::new(name))? } else { solver.scene(name)? };
        if scene.solver != solver.name {
            allotrope_solvers::solver(&scene.solver)
                .map_err(|fault| LabError::usage(format!("scene `{name}`: `solver` is wrong: {fault}")))?;
            return Err(LabError::usage(format!(
                "scene `{name}` is for the solver `{}`, not `{}`",
                scene.solver, solver.name
            )));
        }
        if let Some(nodes) = self.grid {
            scene = scene.with_grid(nodes)?;
        }
        if let Some(particles) = self.particles {
            scene = scene.with_particles(particles)?;
            if particles > SORTED_ABOVE && scene.reorder == 0 {
                scene.reorder = SORTED_EVERY;
            }
        }
        scene.reorder = self.reorder.unwrap_or(scene.reorder);
        Ok(scene)
    }
}

/// The words between commas, each once.
fn words(list: &str) -> Vec<&str> {
    let mut words: Vec<&str> = Vec::new();
    for word in list.split(',').map(str::trim).filter(|word| !word.is_empty()) {
        if !words.contains(&word) {
            words.push(word);
        }
    }
    words
}

/// Reads a command line. Help and version are printed, and end the program.
///
/// # Errors
/// One line that tells what is wrong, and what was probably meant.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Cli, LabError> {
    Cli::try_parse_from(arguments).map_err(|error| match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            error.exit()
        }
        _ => LabError::usage(brief(&error)),
    })
}

/// A clap error in one line: its first paragraph, and the nearest name where it knows one.
fn brief(error: &clap::Error) -> String {
    let text = error.to_string();
    let first: Vec<&str> = text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
    let message = first.join(" ");
    let message = message.strip_prefix("error: ").unwrap_or(&message).replace('\'', "`");
    let near = [ContextKind::SuggestedArg, ContextKind::SuggestedSubcommand, ContextKind::SuggestedValue]
        .into_iter()
        .find_map(|kind| error.get(kind))
        .map(|near| near.to_string())
        .or_else(|| nearest(&error.get(ContextKind::InvalidSubcommand)?.to_string(), COMMANDS).map(str::to_string));
    match near {
        Some(near) => format!("{message}; did you mean `{near}`?"),
        None if error.kind() == ErrorKind::ValueValidation => message,
        None => format!("{message}; `allotrope --help` tells what there is"),
    }
}

impl Cli {
    /// Does what was asked for.
    ///
    /// # Errors
    /// One line that tells why it cannot be done.
    pub fn execute(self) -> Result<(), LabError> {
        machine::check()?;
        match self.command {
            Command::List => output::print(&list::text()),
            Command::Run(arguments) => arguments.execute(),
            Command::Bench(arguments) => arguments.execute(),
        }
    }
}

impl RunArguments {
    fn execute(self) -> Result<(), LabError> {
        let solver = self.what.solver()?;
        let scene = self.what.scene(solver)?;
        let layout = match &self.layout {
            Some(name) => solver.layout(name).map_err(LabError::usage)?,
            None => &solver.layouts[0],
        };
        let schedule = NamedSchedule::find(&self.schedule).map_err(LabError::usage)?;
        let steps = self.what.steps.unwrap_or(scene.steps);
        let every = self.every.unwrap_or_else(|| (steps / self.frames).max(1));
        run::run(&run::Plan {
            solver,
            scene,
            layout: layout.name,
            schedule,
            threads: self.what.threads,
            steps,
            every,
            out: self.out,
        })
    }
}

impl BenchArguments {
    fn execute(self) -> Result<(), LabError> {
        let solver = self.what.solver()?;
        let scene = self.what.scene(solver)?;
        let layouts = if self.layouts.trim() == "all" {
            solver.layouts.iter().map(|layout| layout.name).collect()
        } else {
            let named: Result<Vec<_>, _> = words(&self.layouts).into_iter().map(|name| solver.layout(name)).collect();
            named.map_err(LabError::usage)?.into_iter().map(|layout| layout.name).collect::<Vec<_>>()
        };
        let schedules: Result<Vec<_>, _> = words(&self.schedules).into_iter().map(NamedSchedule::find).collect();
        let schedules = schedules.map_err(LabError::usage)?;
        if layouts.is_empty() || schedules.is_empty() {
            return Err(LabError::usage("`--layouts` and `--schedules` each want at least one name"));
        }
        let name = self.what.scene.clone().unwrap_or_else(|| solver.scenes[0].name.to_string());
        let plan =
            bench::Plan { solver, name, scene, layouts, schedules, threads: self.what.threads, steps: self.what.steps };
        bench::bench(&plan, self.json.as_deref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
        let names: Vec<_> = Cli::command().get_subcommands().map(|command| command.get_name().to_string()).collect();
        assert_eq!(names, COMMANDS);
    }

    #[test]
    fn words_are_told_apart_and_kept_once() {
        assert_eq!(words("a, b,,a"), ["a", "b"]);
        assert!(words(" , ").is_empty());
    }
}
