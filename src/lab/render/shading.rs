//! What the colours of particles tell.

use allotrope_solvers::scene::Substance;
use allotrope_solvers::{Simulation, nearest};

use super::colour::Colour;

/// What the colours of particles tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// How fast they are: deep blue, turquoise, cream, orange.
    Velocity,
    /// What they are of.
    Material,
    /// Blue where they are pulled apart, grey at rest, red where they are pressed together.
    Pressure,
}

/// The shadings by the names by which they are asked for.
pub const SHADINGS: &[(&str, Shading)] =
    &[("velocity", Shading::Velocity), ("material", Shading::Material), ("pressure", Shading::Pressure)];

impl Shading {
    /// The shading of that name; if there is none, why.
    pub fn find(name: &str) -> Result<Self, String> {
        let names = SHADINGS.iter().map(|(name, _)| *name);
        SHADINGS.iter().find(|(known, _)| *known == name).map(|(_, shading)| *shading).ok_or_else(|| {
            match nearest(name, names.clone()) {
                Some(near) => format!("there is no shading `{name}`; did you mean `{near}`?"),
                None => format!("there is no shading `{name}`; known are `{}`", names.collect::<Vec<_>>().join("`, `")),
            }
        })
    }

    /// The name by which it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Self::Velocity => "velocity",
            Self::Material => "material",
            Self::Pressure => "pressure",
        }
    }

    /// The shading that is taken if none is asked for: by material where there are several, else by velocity.
    pub fn fitting(simulation: &dyn Simulation) -> Self {
        if simulation.materials().len() > 1 { Self::Material } else { Self::Velocity }
    }
}

/// Colours of materials that say by their name what they are.
const NAMED: &[(&str, u32)] = &[
    ("water", 0x2f86e0),
    ("snow", 0xe4ecf5),
    ("sand", 0xd9a441),
    ("soil", 0x8f6a45),
    ("honey", 0xe8a010),
    ("lava", 0xf2561d),
    ("jelly", 0xe0487a),
];

/// Colours of the other fluids, in turn.
const FLUIDS: &[u32] = &[0x2f86e0, 0x27b8b0, 0x7fa8ff, 0x1d5fae];

/// Colours of everything else, in turn.
const SOLIDS: &[u32] = &[0xe5524a, 0x58b85c, 0x9a6be0, 0xe88f3c, 0xd46fb8, 0xc8c25a];

/// A colour for each material, at least one: by its name where that tells one, else by its kind and place in the list. As long as
/// there are enough of them, no two materials have the same.
pub(super) fn material_colours(materials: &[Substance<'_>]) -> Vec<Colour> {
    let mut taken: Vec<u32> = Vec::new();
    for material in materials {
        let name = material.name.to_lowercase();
        let named = NAMED.iter().filter(|(word, _)| name.contains(word)).map(|(_, colour)| colour);
        let (own, others) = if material.fluid { (FLUIDS, SOLIDS) } else { (SOLIDS, FLUIDS) };
        let mut wanted = named.chain(own).chain(others).copied();
        let free = wanted.find(|colour| !taken.contains(colour));
        taken.push(free.unwrap_or(own[taken.len() % own.len()]));
    }
    if taken.is_empty() {
        taken.push(SOLIDS[0]);
    }
    taken.into_iter().map(Colour::hex).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn material(name: &str, fluid: bool) -> Substance<'_> {
        Substance { name, density: 1.0, fluid }
    }

    #[test]
    fn names_are_found_or_a_near_one_is_told() {
        for (name, shading) in SHADINGS {
            assert_eq!(Shading::find(name), Ok(*shading));
        }
        assert_eq!(Shading::find("materail").unwrap_err(), "there is no shading `materail`; did you mean `material`?");
        let message = "there is no shading `heat`; known are `velocity`, `material`, `pressure`";
        assert_eq!(Shading::find("heat").unwrap_err(), message);
    }

    #[test]
    fn materials_are_told_apart() {
        let names =
            [("red", false), ("sand", false), ("Wet Snow", false), ("sea", true), ("water", true), ("b", false)];
        let colours = material_colours(&names.map(|(name, fluid)| material(name, fluid)));
        let hex = |n: usize| colours[n].srgb();
        assert_eq!((hex(0), hex(1), hex(2)), ([0xe5, 0x52, 0x4a], [0xd9, 0xa4, 0x41], [0xe4, 0xec, 0xf5]));
        // The blue of water is the first of fluids too: who comes second takes another.
        assert_eq!((hex(3), hex(4)), ([0x2f, 0x86, 0xe0], [0x27, 0xb8, 0xb0]));
        for a in 0..colours.len() {
            for b in 0..a {
                let far = hex(a).iter().zip(hex(b)).map(|(a, b)| a.abs_diff(b)).max();
                assert!(far >= Some(48), "{} and {}", names[a].0, names[b].0);
            }
        }
        assert_eq!(material_colours(&vec![material("", true); 30]).len(), 30);
        assert_eq!(material_colours(&[]).len(), 1);
    }
}
