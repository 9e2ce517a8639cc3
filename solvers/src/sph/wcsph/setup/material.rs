//! What flows.

use crate::SceneError;
use crate::scene::Keys;

/// How pressure follows density.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// `c^2 rho_0 / n ((rho / rho_0)^n - 1)` with a whole number `n` (Becker & Teschner 2007).
    Tait(i32),
    /// `c^2 (rho - rho_0)`.
    Linear,
    /// `c^2 rho`.
    IdealGas,
}

/// What flows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Water {
    /// At rest, in kg/m^3.
    pub density: f64,
    /// The speed of sound at rest in m/s.
    pub sound: f64,
    /// How pressure follows density.
    pub state: State,
    /// Whether pressure may be below zero.
    pub suction: bool,
    /// The linear factor of the artificial viscosity, ..
    pub alpha: f64,
    /// .. the quadratic one, ..
    pub beta: f64,
    /// .. and whether it takes the speed of sound at the densities of both particles.
    pub local_sound: bool,
    /// Of surface tension, in m^3/(kg s^2).
    pub tension: f64,
}

pub(super) const KEYS: &[&str] =
    &["density", "sound", "state", "exponent", "suction", "alpha", "beta", "viscosity", "tension"];

impl Water {
    pub(super) fn read(keys: &Keys<'_>) -> Result<Self, SceneError> {
        let states = [("tait", State::Tait(7)), ("linear", State::Linear), ("ideal-gas", State::IdealGas)];
        let mut state = keys.choice("state", "equation of state", &states)?.unwrap_or(State::Tait(7));
        if let Some(exponent) = keys.whole("exponent", 1, 15)? {
            if !matches!(state, State::Tait(_)) {
                return Err(keys.fault("exponent", "belongs to `state = \"tait\"`"));
            }
            state = State::Tait(exponent as i32);
        }
        let papers = [("becker-teschner", false), ("monaghan", true)];
        let local_sound = keys.choice("viscosity", "viscosity", &papers)?.unwrap_or(false);
        if !local_sound && keys.has("beta") {
            return Err(keys.fault("beta", "belongs to `viscosity = \"monaghan\"`"));
        }
        Ok(Self {
            density: keys.positive("density", "1000.0")?,
            sound: keys.positive("sound", "50.0")?,
            state,
            suction: keys.flag("suction")?.unwrap_or(false),
            alpha: keys.between("alpha", 0.0, 10.0)?.unwrap_or(0.1),
            beta: keys.between("beta", 0.0, 10.0)?.unwrap_or(0.0),
            local_sound,
            tension: keys.between("tension", 0.0, 1e12)?.unwrap_or(0.0),
        })
    }

    /// Exponent, stiffness in Pa and offset of [`Fluid`](crate::sph::wcsph::Fluid).
    pub(in crate::sph::wcsph) fn law(&self) -> (i32, f64, f64) {
        let modulus = self.density * self.sound * self.sound;
        match self.state {
            State::Tait(exponent) => (exponent, modulus / f64::from(exponent), 1.0),
            State::Linear => (1, modulus, 1.0),
            State::IdealGas => (1, modulus, 0.0),
        }
    }
}
