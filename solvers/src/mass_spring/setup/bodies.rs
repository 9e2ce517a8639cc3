//! Masses one by one, in chains and in sheets, and the springs between them.

use std::f64::consts::PI;

use allotrope::prelude::*;

use crate::SceneError;
use crate::mass_spring::records::{Bond, Mass, Spring};
use crate::scene::{Keys, MOST_PARTICLES};

/// What was read until now.
pub(super) struct Builder {
    dimensions: usize,
    pub(super) masses: Vec<Mass>,
    pub(super) springs: Vec<Spring>,
}

/// Which masses of a chain are held.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    None,
    Start,
    Both,
}

/// Which masses of a sheet are held.
#[derive(Clone, Copy, PartialEq)]
enum Edge {
    None,
    FirstCorners,
    FirstRow,
}

/// Stiffness and dashpot, and the length at rest, if one is given.
pub(super) fn read_bond(keys: &Keys<'_>) -> Result<(Bond, Option<f64>), SceneError> {
    let stiffness = keys.positive("stiffness", "1000.0")?;
    let dashpot = keys.between("dashpot", 0.0, 1e30)?.unwrap_or(0.0);
    Ok((Bond { stiffness, rest: 0.0, dashpot }, keys.between("rest", 0.0, 1e30)?))
}

fn read_mass(keys: &Keys<'_>) -> Result<f64, SceneError> {
    if keys.has("mass") { keys.positive("mass", "1.0") } else { Ok(1.0) }
}

impl Builder {
    pub(super) fn new(dimensions: usize) -> Self {
        Self { dimensions, masses: Vec::new(), springs: Vec::new() }
    }

    fn vector(&self, keys: &Keys<'_>, key: &str) -> Result<DVec3, SceneError> {
        let example = if self.dimensions == 2 { "[0.5, 0.5]" } else { "[0.5, 0.5, 0.5]" };
        Ok(keys.required_vector(key, self.dimensions, example)?.into())
    }

    /// Refuses more masses than there is room for.
    fn room(&self, keys: &Keys<'_>, count: usize) -> Result<(), SceneError> {
        if self.masses.len().saturating_add(count) <= MOST_PARTICLES {
            return Ok(());
        }
        Err(keys.fault("masses", format!("are too many: more than {MOST_PARTICLES} are refused")))
    }

    /// A spring, as long as its masses are apart if it is not told.
    fn join(&mut self, a: usize, b: usize, bond: Bond, rest: Option<f64>) {
        let rest = rest.unwrap_or_else(|| self.masses[a].x.distance(self.masses[b].x));
        self.springs.push(Spring { ends: [a as u32, b as u32], bond: Bond { rest, ..bond } });
    }

    /// `[[mass]]`.
    pub(super) fn mass(&mut self, keys: &Keys<'_>) -> Result<(), SceneError> {
        keys.only("a mass", &["position", "velocity", "mass", "fixed"], &[])?;
        self.masses.push(Mass {
            x: self.vector(keys, "position")?,
            v: keys.vector("velocity", self.dimensions)?.unwrap_or_default().into(),
            mass: read_mass(keys)?,
            fixed: keys.flag("fixed")?.unwrap_or(false),
            ..Mass::default()
        });
        Ok(())
    }

    /// `[[spring]]`.
    pub(super) fn spring(&mut self, keys: &Keys<'_>) -> Result<(), SceneError> {
        keys.only("a spring", &["between", "stiffness", "rest", "dashpot"], &[])?;
        let Some(ends) = keys.numbers::<2>("between", 2)? else {
            return Err(keys.fault("between", "is missing; write, for example, `between = [0, 1]`"));
        };
        let known = |end: &f64| end.fract() == 0.0 && (0.0..self.masses.len() as f64).contains(end);
        if !ends.iter().all(known) || ends[0] == ends[1] {
            let count = self.masses.len();
            return Err(keys.fault("between", format!("are not the numbers of two masses, from 0 to {}", count - 1)));
        }
        let (bond, rest) = read_bond(keys)?;
        let [a, b] = ends.map(|end| end as usize);
        self.join(a, b, bond, rest);
        Ok(())
    }

    /// `[[chain]]`: masses in a line, each joined with the next. A wave displaces them along it, as the mode of that
    /// number of a chain held at both ends.
    pub(super) fn chain(&mut self, keys: &Keys<'_>) -> Result<(), SceneError> {
        let known = ["from", "to", "masses", "mass", "stiffness", "rest", "dashpot", "hold", "wave", "amplitude"];
        keys.only("a chain", &known, &[])?;
        let (from, to) = (self.vector(keys, "from")?, self.vector(keys, "to")?);
        let count = keys.whole("masses", 2, MOST_PARTICLES as i64)?;
        let count =
            count.ok_or_else(|| keys.fault("masses", "is missing; write, for example, `masses = 10`"))? as usize;
        self.room(keys, count)?;
        let held = [("none", Ends::None), ("start", Ends::Start), ("both", Ends::Both)];
        let held = keys.choice("hold", "choice of held masses", &held)?.unwrap_or(Ends::None);
        let (mass, (bond, rest)) = (read_mass(keys)?, read_bond(keys)?);
        let wave = keys.whole("wave", 1, count as i64)?.unwrap_or(1) as f64;
        let amplitude = keys.number("amplitude")?.unwrap_or(0.0);
        let (first, last) = (self.masses.len(), (count - 1) as f64);
        for n in 0..count {
            let fixed = (n == 0 && held != Ends::None) || (n + 1 == count && held == Ends::Both);
            self.masses.push(Mass { x: from.lerp(to, n as f64 / last), mass, fixed, ..Mass::default() });
        }
        for n in first..first + count - 1 {
            self.join(n, n + 1, bond, rest);
        }
        let line = (to - from).normalize_or_zero();
        for (n, mass) in self.masses[first..].iter_mut().enumerate().filter(|(_, mass)| !mass.fixed) {
            mass.x += line * (amplitude * (wave * PI * n as f64 / last).sin());
        }
        Ok(())
    }

    /// `[[sheet]]`: masses in rows, joined with the next along both sides, across both diagonals (`shear`), and with the
    /// next but one (`bend`).
    pub(super) fn sheet(&mut self, keys: &Keys<'_>) -> Result<(), SceneError> {
        let known = [
            "corner",
            "along",
            "across",
            "masses",
            "mass",
            "stiffness",
            "shear",
            "bend",
            "dashpot",
            "velocity",
            "hold",
        ];
        keys.only("a sheet", &known, &[])?;
        let [corner, along, across] = ["corner", "along", "across"].map(|key| self.vector(keys, key));
        let (corner, along, across) = (corner?, along?, across?);
        let [rows, columns, _] = keys.extents("masses", 2, 2, MOST_PARTICLES as i64)?;
        self.room(keys, rows.saturating_mul(columns))?;
        let held = [("none", Edge::None), ("first-corners", Edge::FirstCorners), ("first-row", Edge::FirstRow)];
        let held = keys.choice("hold", "choice of held masses", &held)?.unwrap_or(Edge::None);
        let (mass, (bond, _)) = (read_mass(keys)?, read_bond(keys)?);
        let v: DVec3 = keys.vector("velocity", self.dimensions)?.unwrap_or_default().into();
        let other = |key| {
            keys.between(key, 0.0, 1e30).map(|k| k.filter(|k| *k > 0.0).map(|stiffness| Bond { stiffness, ..bond }))
        };
        let (shear, bend) = (other("shear")?, other("bend")?);
        let first = self.masses.len();
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            let (s, t) = (i as f64 / (rows - 1) as f64, j as f64 / (columns - 1) as f64);
            let corner_of_row = j == 0 || j + 1 == columns;
            let fixed = i == 0 && (held == Edge::FirstRow || (held == Edge::FirstCorners && corner_of_row));
            let v = if fixed { DVec3::ZERO } else { v };
            self.masses.push(Mass { x: corner + along * s + across * t, v, mass, fixed, ..Mass::default() });
        }
        let at = |i: usize, j: usize| first + i * columns + j;
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))) {
            let steps =
                [(Some(bond), 0, 1), (Some(bond), 1, 0), (shear, 1, 1), (shear, 1, -1), (bend, 0, 2), (bend, 2, 0)];
            for (bond, down, right) in steps {
                let (row, column) = (i + down, j as i64 + right);
                if let Some(bond) = bond
                    && row < rows
                    && (0..columns as i64).contains(&column)
                {
                    self.join(at(i, j), at(row, column as usize), bond, None);
                }
            }
        }
        Ok(())
    }
}
