//! The program `allotrope`, the layout laboratory: `allotrope --help` tells what it does.

use std::process::ExitCode;

fn main() -> ExitCode {
    allotrope_lab::main(std::env::args_os())
}
