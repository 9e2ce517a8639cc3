//! How a scene moves velocity between particles and grid.

use crate::SceneError;
use crate::scene::Keys;

/// What particles hand to the grid, and take from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scheme {
    /// A velocity a particle (Harlow 1964).
    Pic,
    /// The grid's change of velocity (Brackbill & Ruppel 1986), `blend` of it with `1 - blend` of PIC.
    Flip {
        /// From zero, which is PIC, to one.
        blend: f64,
    },
    /// An affine velocity field a particle (Jiang et al. 2015).
    Apic,
    /// A polynomial velocity field a particle (Fu et al. 2017).
    PolyPic {
        /// How many modes: in 2D 1, 3, 4, 6 or 9; in 3D 1, 4, 8, 11 or 27.
        modes: usize,
    },
}

/// The B-spline by which a particle spreads over the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spline {
    /// 2 nodes an axis.
    Linear,
    /// 3 nodes an axis.
    Quadratic,
    /// 4 nodes an axis.
    Cubic,
}

impl Spline {
    /// Nodes along each axis that a particle meets.
    pub fn width(self) -> usize {
        match self {
            Self::Linear => 2,
            Self::Quadratic => 3,
            Self::Cubic => 4,
        }
    }
}

/// How stress becomes momentum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forces {
    /// By the gradients of the weights (Sulsky et al. 1994).
    Gradients,
    /// By the moving least squares of Hu et al. 2018, for quadratic and cubic splines.
    LeastSquares,
}

/// How velocity moves between particles and grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transfer {
    /// What is handed over.
    pub scheme: Scheme,
    /// To which nodes.
    pub spline: Spline,
    /// What stress does there.
    pub forces: Forces,
}

impl Default for Transfer {
    fn default() -> Self {
        Self { scheme: Scheme::Apic, spline: Spline::Quadratic, forces: Forces::LeastSquares }
    }
}

pub(super) const KEYS: &[&str] = &["scheme", "spline", "forces", "blend", "modes"];

impl Transfer {
    /// Reads a table `[transfer]` of a scene of so many dimensions.
    pub(super) fn read(keys: &Keys<'_>, dimensions: usize) -> Result<Self, SceneError> {
        const SCHEMES: &[(&str, &str)] = &[("apic", "apic"), ("pic", "pic"), ("flip", "flip"), ("polypic", "polypic")];
        let name = keys.choice("scheme", "scheme", SCHEMES)?.unwrap_or("apic");
        for (key, of) in [("blend", "flip"), ("modes", "polypic")] {
            if keys.has(key) && name != of {
                return Err(keys.fault(key, format!("belongs to `scheme = \"{of}\"`, and the scheme is `{name}`")));
            }
        }
        let scheme = match name {
            "pic" => Scheme::Pic,
            "flip" => Scheme::Flip { blend: keys.between("blend", 0.0, 1.0)?.unwrap_or(0.95) },
            "polypic" => Scheme::PolyPic { modes: read_modes(keys, dimensions)? },
            _ => Scheme::Apic,
        };
        let splines = [("linear", Spline::Linear), ("quadratic", Spline::Quadratic), ("cubic", Spline::Cubic)];
        let spline = keys.choice("spline", "spline", &splines)?.unwrap_or(Spline::Quadratic);
        match (scheme, spline) {
            (Scheme::PolyPic { .. }, Spline::Linear | Spline::Cubic) => {
                let message = "does not go with `scheme = \"polypic\"`, whose modes are those of 3 nodes an axis; write \
                               `spline = \"quadratic\"` or another scheme";
                return Err(keys.fault("spline", message));
            }
            (Scheme::Apic, Spline::Linear) => {
                let message = "does not go with `scheme = \"apic\"`, which divides by the spread of a particle's nodes, \
                               and linear weights have none where it meets a node; write `spline = \"quadratic\"`, or \
                               `scheme = \"flip\"` or `\"pic\"`";
                return Err(keys.fault("spline", message));
            }
            _ => {}
        }
        let forces = [("gradients", Forces::Gradients), ("least-squares", Forces::LeastSquares)];
        let forces = match (keys.choice("forces", "way to compute forces", &forces)?, spline) {
            (Some(Forces::LeastSquares), Spline::Linear) => {
                let message = "does not go with `spline = \"linear\"`: it divides by the spread of a particle's nodes, \
                               and linear weights have none where it meets a node; write `forces = \"gradients\"`";
                return Err(keys.fault("forces", message));
            }
            (Some(forces), _) => forces,
            (None, Spline::Linear) => Forces::Gradients,
            (None, _) => Forces::LeastSquares,
        };
        Ok(Self { scheme, spline, forces })
    }
}

/// The number of polynomials: whole families of those of which the least squares are independent.
fn read_modes(keys: &Keys<'_>, dimensions: usize) -> Result<usize, SceneError> {
    let choices: &[usize] = if dimensions == 2 { &[1, 3, 4, 6, 9] } else { &[1, 4, 8, 11, 27] };
    let all = 3usize.pow(dimensions as u32);
    let modes = keys.whole("modes", 1, all as i64)?.map_or(all, |modes| modes as usize);
    if choices.contains(&modes) {
        return Ok(modes);
    }
    let choices: Vec<_> = choices.iter().map(usize::to_string).collect();
    Err(keys.fault("modes", format!("cannot be; in {dimensions}D it is one of {}", choices.join(", "))))
}
