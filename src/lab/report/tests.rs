//! What tests of several parts share.

use crate::lab::bench::{Named, Report, Row};

/// A row of a comparison, whose two kernels take three quarters and a quarter of a step.
pub(super) fn row(layout: &str, ms: f64) -> Row {
    Row {
        layout: layout.into(),
        schedule: "auto".into(),
        ms_per_step: ms,
        spread: 0.01,
        kernels: Named(vec![("scatter".into(), 0.75 * ms), ("grid".into(), 0.25 * ms)]),
        bytes: 1 << 20,
        state_error: 0.0,
        counted: Named::default(),
    }
}

/// A comparison of some rows.
pub(super) fn report(rows: Vec<Row>) -> Report {
    let (solver, scene, isa) = ("net".into(), "cloth".into(), "baseline".into());
    Report { solver, scene, particles: 1000, grid: Vec::new(), threads: 1, isa, rows }
}
