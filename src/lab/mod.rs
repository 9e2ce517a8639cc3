//! The laboratory's commands, and what they are made of.

pub mod bench;
pub mod chart;
pub mod checkpoint;
pub mod cli;
pub mod compare;
pub mod convert_cost;
pub mod counts;
pub mod errors;
pub mod export;
pub mod hardware;
pub mod list;
pub mod machine;
pub mod map;
pub mod output;
pub mod peers;
pub mod render;
pub mod report;
pub mod run;
pub mod scene;
pub mod search;
mod shell;
pub mod signals;
pub mod statistics;
pub mod sweep;
pub mod table;
