//! How a scene moves velocity between particles and grid.

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
