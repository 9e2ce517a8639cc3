//! The command line.

mod bench;
mod compare;
mod convert_cost;
mod counts;
mod examples;
mod map;
mod report;
mod run;
mod scene;
mod scenes;
mod search;
mod values;

use std::ffi::OsString;

use allotrope_solvers::nearest;
use clap::error::{ContextKind, ErrorKind};
use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;

pub use self::bench::BenchArguments;
pub use self::compare::CompareCommand;
pub use self::convert_cost::ConvertCostArguments;
pub use self::counts::CountArguments;
pub use self::map::MapArguments;
pub use self::report::ReportArguments;
pub use self::run::RunArguments;
pub use self::scene::SceneCommand;
pub use self::search::SearchArguments;
use super::errors::LabError;
use super::{list, machine, output, signals};

/// The layout laboratory: runs one simulation in many data layouts, and shows what each costs.
#[derive(Debug, Parser)]
#[command(name = "allotrope", version, arg_required_else_help = true, after_help = examples::ALL)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Tells which solvers, scenes, layouts and schedules there are
    #[command(after_help = examples::LIST)]
    List,
    /// Runs a scene in one layout and writes pictures of it
    #[command(after_help = examples::RUN)]
    Run(Box<RunArguments>),
    /// Runs a scene in many layouts, checks that they agree, and compares their speed
    #[command(after_help = examples::BENCH)]
    Bench(BenchArguments),
    /// Compares layouts as `bench` does, and writes a page about it for people who have read nothing else
    #[command(after_help = examples::REPORT)]
    Report(ReportArguments),
    /// Finds the best layout, schedule and interval of sorting for a scene
    #[command(after_help = examples::SEARCH)]
    Search(SearchArguments),
    /// Tells what it costs to go on in another layout, and after how many steps that pays
    #[command(after_help = examples::CONVERT_COST)]
    ConvertCost(ConvertCostArguments),
    /// Counts what a step touches in each layout: accesses, cache lines, misses of modelled caches
    #[command(after_help = examples::COUNT)]
    Count(CountArguments),
    /// Compares our workloads with other systems'
    #[command(subcommand, after_help = examples::COMPARE)]
    Compare(CompareCommand),
    /// Draws where the members of records lie in a layout
    #[command(after_help = examples::MAP)]
    Map(MapArguments),
    /// Reads scenes without running them
    #[command(subcommand, after_help = examples::SCENE)]
    Scene(SceneCommand),
    /// Prints what a shell needs to complete the command line
    #[command(after_help = examples::COMPLETIONS)]
    Completions(CompletionsArguments),
}

impl Command {
    /// Whether it tells how long something takes.
    fn measures(&self) -> bool {
        matches!(self, Self::Bench(_) | Self::Search(_) | Self::ConvertCost(_) | Self::Compare(_) | Self::Report(_))
    }
}

/// What is asked of `allotrope completions`.
#[derive(Args, Debug)]
struct CompletionsArguments {
    /// The shell
    shell: Shell,
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
        .or_else(|| {
            nearest(&error.get(ContextKind::InvalidSubcommand)?.to_string(), commands().iter().map(String::as_str))
                .map(str::to_string)
        });
    match near {
        Some(near) => format!("{message}; did you mean `{near}`?"),
        None if error.kind() == ErrorKind::ValueValidation => message,
        None => format!("{message}; `allotrope --help` tells what there is"),
    }
}

/// The names of the commands.
fn commands() -> Vec<String> {
    Cli::command().get_subcommands().map(|command| command.get_name().to_string()).collect()
}

impl Cli {
    /// Does what was asked for.
    ///
    /// # Errors
    /// One line that tells why it cannot be done.
    pub fn execute(self) -> Result<(), LabError> {
        machine::check()?;
        signals::tell_limits()?;
        if cfg!(feature = "probe") && self.command.measures() {
            eprintln!(
                "note: built with `--features probe`, in which every access asks whether it is counted: times are longer than those of other builds"
            );
        }
        match self.command {
            Command::List => output::print(&list::text()),
            Command::Run(arguments) => arguments.execute(),
            Command::Bench(arguments) => arguments.execute(),
            Command::Report(arguments) => arguments.execute(),
            Command::Search(arguments) => arguments.execute(),
            Command::ConvertCost(arguments) => arguments.execute(),
            Command::Count(arguments) => arguments.execute(),
            Command::Compare(command) => command.execute(),
            Command::Map(arguments) => arguments.execute(),
            Command::Scene(command) => command.execute(),
            Command::Completions(arguments) => arguments.execute(),
        }
    }
}

impl CompletionsArguments {
    fn execute(self) -> Result<(), LabError> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "allotrope", &mut script);
        output::print(&String::from_utf8_lossy(&script))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    /// All commands, and those below them.
    fn every(command: &clap::Command) -> Vec<clap::Command> {
        let below = command.get_subcommands().flat_map(every);
        [command.clone()].into_iter().chain(below).collect()
    }

    /// The words of a line of a shell, of which some stand in quotes, up to its comment.
    fn words(line: &str) -> Vec<String> {
        let mut words = Vec::new();
        for (n, piece) in line.split('\'').enumerate() {
            match n % 2 {
                0 => words.extend(piece.split('#').next().unwrap_or_default().split_whitespace().map(String::from)),
                _ => words.push(piece.into()),
            }
        }
        words
    }

    #[test]
    fn help_ends_with_examples_that_can_be_parsed() {
        for command in every(&Cli::command()) {
            let help = command.get_after_help().map(|help| help.to_string()).unwrap_or_default();
            let lines: Vec<_> = help.lines().filter(|line| line.starts_with("  allotrope ")).collect();
            assert!(!lines.is_empty(), "`{}` has no examples", command.get_name());
            for line in lines {
                let parsed = Cli::try_parse_from(words(line));
                assert!(parsed.is_ok(), "{line}: {}", parsed.unwrap_err());
            }
        }
    }
}
