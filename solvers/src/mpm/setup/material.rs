//! Materials of a scene.

use crate::SceneError;
use crate::mpm::materials::{Elastic, Model, Sand, Snow};
use crate::scene::Keys;

/// What bodies are of.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// By which bodies ask for it.
    pub name: String,
    /// At rest, in kg/m^3.
    pub density: f64,
    /// How it bears being deformed.
    pub model: Model,
}

/// What each model takes beside `name`, `model` and `density`.
const MODELS: &[(&str, &[&str])] = &[
    ("fluid", &["stiffness"]),
    ("neo-hookean", &["young", "poisson"]),
    ("corotated", &["young", "poisson"]),
    ("snow", &["young", "poisson", "hardening", "compression", "stretch"]),
    ("sand", &["young", "poisson", "friction_angles", "volume_correction"]),
];

/// The materials of a scene, at least one, of different names.
pub(super) fn read(keys: &Keys<'_>) -> Result<Vec<Material>, SceneError> {
    let tables = keys.table_or_tables("material")?;
    if tables.is_empty() {
        let message = "is missing; write a table `[material]` with `stiffness` and `density`, or another `model`";
        return Err(keys.fault("material", message));
    }
    let mut materials: Vec<Material> = Vec::new();
    for table in &tables {
        let material = Material::read(table, tables.len() == 1)?;
        if materials.iter().any(|other| other.name == material.name) {
            return Err(table.fault("name", "is the name of an earlier material too; bodies ask for a material by it"));
        }
        materials.push(material);
    }
    Ok(materials)
}

impl Material {
    fn read(keys: &Keys<'_>, alone: bool) -> Result<Self, SceneError> {
        let models: Vec<_> = MODELS.iter().map(|model| (model.0, model)).collect();
        let &(model, own) = keys.choice("model", "model", &models)?.unwrap_or(&MODELS[0]);
        let takes = [own, &["density", "model", "name"]].concat();
        let others: Vec<_> = MODELS.iter().flat_map(|(_, keys)| *keys).copied().collect();
        keys.only(&format!("a material of the model `{model}`"), &takes, &others)?;
        let name = match keys.text("name")? {
            Some("") => return Err(keys.fault("name", "is empty")),
            Some(name) => name,
            None if alone => model,
            None => keys.required_text("name", &format!("\"{model}\""))?,
        };
        let density = keys.positive("density", "1.0")?;
        let model = match model {
            "fluid" => Model::Fluid { stiffness: keys.positive("stiffness", "400.0")? as f32 },
            "neo-hookean" => Model::NeoHookean(elastic(keys)?),
            "corotated" => Model::Corotated(elastic(keys)?),
            "snow" => Model::Snow(snow(keys)?),
            _ => Model::Sand(sand(keys)?),
        };
        Ok(Self { name: name.into(), density, model })
    }
}

fn elastic(keys: &Keys<'_>) -> Result<Elastic, SceneError> {
    let (young, poisson) = elasticity(keys)?;
    Ok(Elastic::new(young, poisson))
}

/// Young's modulus and Poisson's ratio, of which Lamé's constants are finite.
fn elasticity(keys: &Keys<'_>) -> Result<(f64, f64), SceneError> {
    let young = keys.positive("young", "1e5")?;
    let Some(poisson) = keys.number("poisson")? else {
        return Err(keys.fault("poisson", "is missing; write, for example, `poisson = 0.3`"));
    };
    if !(-1.0 < poisson && poisson < 0.5) {
        let message = "must be above -1 and below 0.5, where a solid would bear no change of volume; write, for \
                       example, `poisson = 0.3`";
        return Err(keys.fault("poisson", message));
    }
    let Elastic { mu, lambda } = Elastic::new(young, poisson);
    if !mu.is_finite() || !lambda.is_finite() {
        return Err(keys.fault("poisson", format!("is too near its bound for `young = {young:e}` in single precision")));
    }
    Ok((young, poisson))
}

fn snow(keys: &Keys<'_>) -> Result<Snow, SceneError> {
    let (young, poisson) = elasticity(keys)?;
    let mut snow = Snow::new(young, poisson);
    if let Some(hardening) = keys.between("hardening", 0.0, 100.0)? {
        snow.hardening = hardening as f32;
    }
    if let Some(compression) = keys.number("compression")? {
        if !(0.0 < compression && compression < 1.0) {
            return Err(keys.fault("compression", "is not above 0 and below 1, at which snow would be flat"));
        }
        snow.compression = compression as f32;
    }
    if keys.has("stretch") {
        snow.stretch = keys.positive("stretch", "7.5e-3")? as f32;
    }
    Ok(snow)
}

fn sand(keys: &Keys<'_>) -> Result<Sand, SceneError> {
    let (young, poisson) = elasticity(keys)?;
    let mut sand = Sand::new(young, poisson);
    if let Some(angles) = keys.numbers("friction_angles", 4)? {
        check_friction(angles).map_err(|fault| keys.fault("friction_angles", fault))?;
        sand.friction = angles.map(|angle| angle as f32);
    }
    if let Some(correct) = keys.flag("volume_correction")? {
        sand.volume_correction = correct;
    }
    Ok(sand)
}

/// The angle of friction is `h0 + (h1 q - h3) exp(-h2 q)` in degrees, where the hardening `q` grows from zero (Klár et
/// al. 2016, "Drucker-Prager elastoplasticity for sand animation"). It must remain one.
fn check_friction([h0, h1, h2, h3]: [f64; 4]) -> Result<(), String> {
    if h2 < 0.0 || (h2 == 0.0 && h1 != 0.0) {
        return Err("lets the angle of friction grow without bounds; the third number must be above zero".into());
    }
    let angle = |q: f64| h0 + (h1 * q - h3) * (-h2 * q).exp();
    // At the start, where it is extreme between, and at last.
    let turning = if h1 == 0.0 || h2 == 0.0 { 0.0 } else { (1.0 / h2 + h3 / h1).max(0.0) };
    let last = if h2 == 0.0 { angle(0.0) } else { h0 };
    match [angle(0.0), angle(turning), last].into_iter().find(|angle| !(0.0..90.0).contains(angle)) {
        Some(angle) => Err(format!("comes to an angle of friction of {angle:.4} degrees, which is not from 0 to 90")),
        None => Ok(()),
    }
}
