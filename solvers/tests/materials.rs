//! Laws of materials against closed forms, published steps and their own energies.

use allotrope::prelude::*;
use allotrope_solvers::linear::{Matrix, Polar};
use allotrope_solvers::mpm::materials::{Elastic, Model, Sand, Snow, Updated, cone_slope, fluid};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

const MODELS: [fn() -> Model; 5] = [
    || Model::Fluid { stiffness: 400.0 },
    || Model::NeoHookean(Elastic::new(1.0, 0.3)),
    || Model::Corotated(Elastic::new(1.0, 0.3)),
    || Model::Snow(Snow::new(1.4e5, 0.2)),
    || Model::Sand(Sand::new(3.537e5, 0.3)),
];

fn near(value: f32, expected: f64, tolerance: f64) {
    assert!((f64::from(value) - expected).abs() <= tolerance, "{value} is not {expected} to {tolerance:e}");
}

fn all_near(values: &[f32], expected: &[f64], tolerance: f64) {
    assert_eq!(values.len(), expected.len());
    values.iter().zip(expected).for_each(|(value, expected)| near(*value, *expected, tolerance));
}

/// Uniformly from -1 to 1.
fn unit(random: &mut ChaCha8Rng) -> f32 {
    (f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0) as f32
}

/// What tests of either dimension make and take apart.
trait Tested: Matrix {
    fn random(random: &mut ChaCha8Rng) -> Self;
    fn inverse_of(self) -> Self;
    fn components(self) -> Vec<f32>;
}

impl Tested for Mat2 {
    fn random(random: &mut ChaCha8Rng) -> Self {
        Mat2::from_cols_array(&std::array::from_fn(|_| unit(random)))
    }

    fn inverse_of(self) -> Self {
        self.inverse()
    }

    fn components(self) -> Vec<f32> {
        self.to_cols_array().to_vec()
    }
}

impl Tested for Mat3 {
    fn random(random: &mut ChaCha8Rng) -> Self {
        Mat3::from_cols_array(&std::array::from_fn(|_| unit(random)))
    }

    fn inverse_of(self) -> Self {
        self.inverse()
    }

    fn components(self) -> Vec<f32> {
        self.to_cols_array().to_vec()
    }
}

/// The largest component.
fn largest<M: Tested>(matrix: M) -> f32 {
    matrix.components().iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// A matrix that the material bears without yielding, which is not the identity.
fn borne<M: Tested>(model: &Model, random: &mut ChaCha8Rng) -> M {
    let (center, spread) = match model {
        Model::Snow(_) => (0.992, 0.004),
        Model::Sand(_) => (0.97, 0.002),
        _ => (1.0, 0.15),
    };
    let Polar { rotation, .. } = M::random(random).polar();
    rotation * (M::isotropic(center) + M::random(random) * spread)
}

#[test]
fn constants_are_those_of_the_papers() {
    let snow = Snow::new(1.4e5, 0.2);
    near(snow.elastic.mu, 58333.3333, 6e-3);
    near(snow.elastic.lambda, 38888.8889, 6e-3);
    assert_eq!((snow.hardening, snow.compression, snow.stretch), (10.0, 2.5e-2, 7.5e-3));
    let sand = Sand::new(3.537e5, 0.3);
    near(sand.elastic.mu, 136038.4615, 1e-2);
    near(sand.elastic.lambda, 204057.6923, 1e-2);
    assert_eq!((sand.friction, sand.volume_correction), ([35.0, 9.0, 0.2, 10.0], true));
    let names: Vec<_> = MODELS.iter().map(|model| model().name()).collect();
    assert_eq!(names, ["fluid", "neo-hookean", "corotated", "snow", "sand"]);
    let moduli = MODELS.map(|model| model().wave_modulus());
    let expected = [400.0, 1.3461538, 1.3461538, 155555.5555 * std::f64::consts::E, 476134.6153];
    for (modulus, expected) in moduli.iter().zip(expected) {
        assert!((modulus / expected - 1.0).abs() < 1e-6, "{modulus} is not {expected}");
    }
}

#[test]
fn nothing_happens_to_what_is_at_rest() {
    for model in MODELS.map(|model| model()) {
        let plastic = model.initial_plastic();
        let plane = model.update(Mat2::IDENTITY, plastic);
        let space = model.update(Mat3::IDENTITY, plastic);
        assert_eq!(plane, Updated { deformation_gradient: Mat2::IDENTITY, plastic, kirchhoff_stress: Mat2::ZERO });
        assert_eq!(space, Updated { deformation_gradient: Mat3::IDENTITY, plastic, kirchhoff_stress: Mat3::ZERO });
        assert_eq!((model.energy(Mat2::IDENTITY, plastic), model.energy(Mat3::IDENTITY, plastic)), (0.0, 0.0));
    }
}

#[test]
fn a_fluid_follows_the_divergence_to_first_order() {
    let model = Model::Fluid { stiffness: 400.0 };
    let step = Mat2::from_cols_array(&[2e-4, 5e-4, -3e-4, 1e-4]);
    let updated = model.update(Mat2::IDENTITY + step, [0.9, 0.0]);
    near(updated.plastic[0], 0.9 * (1.0 + 3e-4), 1e-7);
    assert_eq!(updated.plastic[1], 0.0);
    assert_eq!(updated.deformation_gradient, Mat2::IDENTITY);
    let expected = 400.0 * (0.9 * (1.0 + 3e-4) - 1.0);
    all_near(&updated.kirchhoff_stress.to_cols_array(), &[expected, 0.0, 0.0, expected], 1e-4);
    near(model.energy(updated.deformation_gradient, updated.plastic), expected * expected / 800.0, 1e-5);

    // The determinant differs by the second order and the third.
    let step = Mat3::from_diagonal(vec3(1e-2, -2e-2, 3e-2));
    near(fluid::volume_ratio(1.0, Mat3::IDENTITY + step), 1.02, 2e-7);
    let updated = model.update(Mat3::IDENTITY + step, [1.0, 0.0]);
    near(updated.plastic[0] - (Mat3::IDENTITY + step).determinant(), 5.06e-4, 1e-6);
    near(updated.kirchhoff_stress.y_axis.y, 8.0, 1e-4);
}

/// Stretch, lateral stretch where it is free, and the stress per area at rest, of a cube of `E = 1` and `nu = 0.3`.
type Uniaxial = [(f64, f64, f64); 6];

const NEO_HOOKEAN: Uniaxial = [
    (0.8, 1.06733837, -0.24000538),
    (0.9, 1.03170243, -0.10872219),
    (1.1, 0.97149295, 0.09307743),
    (1.25, 0.93356010, 0.21260478),
    (1.5, 0.88017459, 0.37828018),
    (2.0, 0.79807754, 0.64674466),
];

const COROTATED: Uniaxial = [
    (0.8, 1.06213350, -0.21730199),
    (0.9, 1.03062768, -0.10390234),
    (1.1, 0.97073005, 0.09679246),
    (1.25, 0.92976442, 0.23249387),
    (1.5, 0.86933210, 0.44286862),
    (2.0, 0.77317017, 0.83668387),
];

#[test]
fn solids_stretched_along_an_axis_bear_what_closed_forms_tell() {
    let elastic = Elastic::new(1.0, 0.3);
    for (model, table) in [(Model::NeoHookean(elastic), NEO_HOOKEAN), (Model::Corotated(elastic), COROTATED)] {
        for (stretch, lateral, stress) in table {
            let f = Mat3::from_diagonal(dvec3(stretch, lateral, lateral).as_vec3());
            let tau = model.update(f, [0.0; 2]).kirchhoff_stress;
            // Along the axis P l, across it nothing.
            near(tau.x_axis.x, stress * stretch, 4e-7 * stretch * stretch);
            all_near(&[tau.y_axis.y, tau.z_axis.z, tau.x_axis.y, tau.y_axis.z], &[0.0; 4], 4e-7);
        }
    }
    // Far out, and in plane strain.
    let model = Model::NeoHookean(elastic);
    for (stretch, lateral, stress) in [(0.5, 1.21076739, -0.93535206), (3.0, 0.68811103, 1.09314144)] {
        let tau = model.update(Mat3::from_diagonal(dvec3(stretch, lateral, lateral).as_vec3()), [0.0; 2]);
        near(tau.kirchhoff_stress.x_axis.x, stress * stretch, 1e-6);
    }
    for (stretch, lateral, stress) in
        [(0.8, 1.09487606, -0.26863153), (1.1, 0.95904309, 0.10148124), (1.5, 0.82492364, 0.40243615)]
    {
        let tau = model.update(Mat2::from_diagonal(dvec2(stretch, lateral).as_vec2()), [0.0; 2]).kirchhoff_stress;
        all_near(&tau.to_cols_array(), &[stress * stretch, 0.0, 0.0, 0.0], 4e-7);
    }
}

#[test]
fn solids_sheared_bear_what_closed_forms_tell() {
    let (elastic, gamma) = (Elastic::new(1.0, 0.3), 0.5f64);
    let mu = 1.0 / 2.6;
    let (plane, space) = (mat2(Vec2::X, vec2(gamma as f32, 1.0)), mat3(Vec3::X, vec3(gamma as f32, 1.0, 0.0), Vec3::Z));
    let neo_hookean = Model::NeoHookean(elastic);
    let expected = [mu * gamma * gamma, mu * gamma, mu * gamma, 0.0];
    all_near(&neo_hookean.update(plane, [0.0; 2]).kirchhoff_stress.to_cols_array(), &expected, 1e-7);
    let tau = neo_hookean.update(space, [0.0; 2]).kirchhoff_stress;
    let block = [tau.x_axis.x, tau.x_axis.y, tau.y_axis.x, tau.y_axis.y];
    all_near(&block, &expected, 1e-7);
    assert_eq!(tau.z_axis, Vec3::ZERO);

    // The polar rotation of a simple shear turns by an angle of tangent gamma / 2; then 2 mu (F - R) F^T.
    let norm = (1.0 + gamma * gamma / 4.0).sqrt();
    let (cosine, sine) = (1.0 / norm, -gamma / 2.0 / norm);
    let f = DMat2::from_cols(DVec2::X, dvec2(gamma, 1.0));
    let expected = (f - DMat2::from_cols(dvec2(cosine, sine), dvec2(-sine, cosine))) * f.transpose() * (2.0 * mu);
    let tau = Model::Corotated(elastic).update(plane, [0.0; 2]).kirchhoff_stress;
    all_near(&tau.to_cols_array(), &expected.to_cols_array(), 3e-7);
    let tau = Model::Corotated(elastic).update(space, [0.0; 2]).kirchhoff_stress;
    all_near(&[tau.x_axis.x, tau.x_axis.y, tau.y_axis.x, tau.y_axis.y], &expected.to_cols_array(), 3e-7);
}

#[test]
fn small_strains_have_their_linear_stress_to_four_digits() {
    let elastic = Elastic::new(1.0, 0.3);
    // Exact in single precision.
    let strain = 0.5f32.powi(13);
    let f = Mat3::from_diagonal(vec3(1.0 + strain, 1.0, 1.0));
    for model in [Model::NeoHookean(elastic), Model::Corotated(elastic)] {
        let tau = model.update(f, [0.0; 2]).kirchhoff_stress;
        let expected = elastic.wave_modulus() * f64::from(strain);
        near(tau.x_axis.x, expected, 3e-4 * expected);
        let energy = 0.5 * expected * f64::from(strain);
        near(model.energy(f, [0.0; 2]), energy, 3e-4 * energy);
    }
}

#[test]
fn snow_yields_as_published() {
    let snow = Snow::new(1.4e5, 0.2);
    let f = mat2(vec2(1.02, 0.0), vec2(0.01, 0.95));
    let sigma = f.svd().sigma;
    all_near(&sigma, &[1.02036803, 0.94965735], 1e-7);
    let (clamped, plastic_volume) = snow.return_map(sigma, 1.0);
    all_near(&clamped, &[1.0075, 0.975], 1e-7);
    near(plastic_volume, 0.98644780, 4e-7);

    let updated = Model::Snow(snow).update(f, [1.0, 0.0]);
    let elastic = updated.deformation_gradient;
    all_near(&elastic.to_cols_array(), &[1.00732391, -0.00273356, 0.00732976, 0.97515055], 2e-7);
    let plastic = elastic.inverse() * f;
    all_near(&plastic.to_cols_array(), &[1.01256327, 0.00283844, 0.00283844, 0.9742165], 3e-7);
    near(updated.plastic[0], 0.98644780, 4e-7);
    // The fixed corotated stress of harder snow.
    let expected = snow.hardened(updated.plastic[0]).corotated_stress(elastic);
    assert!(updated.kirchhoff_stress.abs_diff_eq(expected, 0.1), "{} {expected}", updated.kirchhoff_stress);
    near(updated.kirchhoff_stress.determinant() / expected.determinant(), 1.0, 1e-4);

    for (volume, factor) in [(0.9, std::f64::consts::E), (1.0, 1.0), (1.1, 0.36787944)] {
        near(snow.hardening_factor(volume), factor, 1e-6 * factor);
    }
    near(snow.hardened(0.9).mu, 58333.3333 * std::f64::consts::E, 0.2);
}

#[test]
fn snow_that_is_crushed_or_torn_remains_finite() {
    let snow = Model::Snow(Snow::new(1.4e5, 0.2));
    for f in [
        Mat3::ZERO,
        Mat3::from_diagonal(vec3(1.0, 1.0, -1.0)),
        Mat3::isotropic(-1e6),
        Mat3::isotropic(1e30),
        Mat3::from_diagonal(vec3(1e20, 1e-20, 0.0)),
    ] {
        let mut plastic = snow.initial_plastic();
        for _ in 0..100 {
            let updated = snow.update(f, plastic);
            plastic = updated.plastic;
            assert!((0.6..=20.0).contains(&plastic[0]), "{f}: {plastic:?}");
            assert!(updated.deformation_gradient.is_finite() && updated.kirchhoff_stress.is_finite(), "{f}");
            assert!(snow.energy(updated.deformation_gradient, plastic).is_finite(), "{f}");
        }
    }
}

#[test]
fn friction_hardens_as_published() {
    let sand = Sand::new(3.537e5, 0.3);
    for (hardening, angle) in [(0.0, 25.0), (0.1, 26.080192), (1.0, 34.181269), (5.0, 47.875780)] {
        near(sand.friction_angle(hardening), angle, 2e-7 * angle);
    }
    assert_eq!(sand.friction_angle(1e30), 35.0);
    for (angle, slope) in [(25.0, 0.26776504), (30.0, 0.32659863), (35.0, 0.38601933), (45.0, 0.50359979)] {
        near(cone_slope(angle), slope, 3e-7 * slope);
    }
}

/// Sand whose angle of friction is always 30 degrees, without correction of volume.
fn plain_sand() -> Sand {
    Sand { friction: [30.0, 0.0, 0.2, 0.0], volume_correction: false, ..Sand::new(3.537e5, 0.3) }
}

#[test]
fn sand_yields_as_published() {
    let sand = plain_sand();
    // Expansion, elastic compression twice, shear. Logarithms of numbers near one keep seven digits of one only.
    let (sigma, plastic) = sand.return_map([1.01, 1.0, 0.995], [0.0; 2]);
    assert_eq!(sigma, [1.0; 3]);
    near(plastic[0], 0.0111415735, 1e-7);
    for elastic in [[0.99, 0.98, 0.97], [0.999, 0.95, 0.9]] {
        assert_eq!(sand.return_map(elastic, [0.25, 0.0]), (elastic, [0.25, 0.0]));
    }
    let (sigma, plastic) = sand.return_map([1.02, 0.95, 1.0], [0.0; 2]);
    all_near(&sigma, &[1.00906168, 0.9638917, 0.99627176], 2e-7);
    near(plastic[0], 0.0184645637, 2e-7);

    let (sigma, plastic) = sand.return_map([1.02, 0.95], [1.0, 0.0]);
    all_near(&sigma, &[1.00243878, 0.96664257], 2e-7);
    near(plastic[0], 1.0245603863, 2e-7);
    assert_eq!(sand.return_map([0.99, 0.97], [0.0; 2]), ([0.99, 0.97], [0.0; 2]));
}

#[test]
fn sheared_sand_lies_on_the_cone_and_even_pressure_inside() {
    let model = Model::Sand(plain_sand());
    let Updated { kirchhoff_stress: tau, deformation_gradient, .. } =
        model.update(Mat3::from_diagonal(vec3(1.02, 0.95, 1.0)), [0.0; 2]);
    let pressure = tau.trace() / 3.0;
    let shear = (tau - Mat3::isotropic(pressure)).norm_squared().sqrt();
    // The criterion is written for deviatoric strain: `|s| + (d lambda + 2 mu) tr(eps) alpha <= 0`.
    near(shear / (-3.0 * pressure * cone_slope(30.0)), 1.0, 1e-5);
    near(deformation_gradient.determinant(), 1.02 * 0.95, 3e-7);

    let even = Mat3::isotropic(0.99);
    let updated = model.update(even, [0.0; 2]);
    assert_eq!((updated.deformation_gradient, updated.plastic), (even, [0.0; 2]));
    near(updated.kirchhoff_stress.x_axis.x, (2.0 * 136038.4615 + 3.0 * 204057.6923) * 0.99f64.ln(), 0.2);
}

#[test]
fn sand_gives_back_the_volume_that_it_gained() {
    let sand = Sand { volume_correction: true, ..plain_sand() };
    let model = Model::Sand(sand);
    // Expansion by 3 % in each direction: remembered, without stress.
    let expanded = model.update(Mat3::isotropic(1.03), model.initial_plastic());
    assert!(expanded.kirchhoff_stress == Mat3::ZERO);
    near(expanded.plastic[1], 3.0 * 1.03f64.ln(), 3e-7);
    let hardened = expanded.plastic[0];
    // At rest nothing more is gained, and nothing hardens.
    let rested = model.update(expanded.deformation_gradient, expanded.plastic);
    near(rested.plastic[1], 3.0 * 1.03f64.ln(), 3e-7);
    near(rested.plastic[0], f64::from(hardened), 1e-6);
    // Compression by 2 % of the same is not resisted; by 2 % more it is, beyond the first per cent.
    let closing = model.update(rested.deformation_gradient * 0.98, rested.plastic);
    assert!(closing.kirchhoff_stress == Mat3::ZERO);
    near(closing.plastic[1], 3.0 * (1.03f64 * 0.98).ln(), 3e-7);
    let closed = model.update(closing.deformation_gradient * 0.98, closing.plastic);
    assert_eq!(closed.plastic[1], 0.0);
    near(closed.deformation_gradient.determinant(), (1.03f64 * 0.98 * 0.98).powi(3), 1e-6);
    let expected = (2.0 * 136038.4615 + 3.0 * 204057.6923) * (1.03f64 * 0.98 * 0.98).ln();
    near(closed.kirchhoff_stress.y_axis.y, expected, 1.0);

    // Without correction the gain is for ever.
    let forgetful = Model::Sand(plain_sand());
    let expanded = forgetful.update(Mat3::isotropic(1.03), [0.0; 2]);
    assert_eq!(expanded.plastic[1], 0.0);
    let closing = forgetful.update(expanded.deformation_gradient * 0.98, expanded.plastic);
    near(closing.kirchhoff_stress.x_axis.x, (2.0 * 136038.4615 + 3.0 * 204057.6923) * 0.98f64.ln(), 0.3);
}

/// `v_c` as in Tampubolon et al. 2017, eq. 26, which accumulates differences of logarithms of determinants.
#[test]
fn the_correction_of_volume_is_the_published_sum() {
    let model = Model::Sand(Sand::new(3.537e5, 0.3));
    let mut random = ChaCha8Rng::seed_from_u64(6);
    let (mut f, mut plastic, mut sum) = (Mat3::IDENTITY, model.initial_plastic(), 0f64);
    let mut corrected = 0;
    for _ in 0..2000 {
        let trial = (Mat3::IDENTITY + Mat3::random(&mut random) * 0.01) * f;
        let updated = model.update(trial, plastic);
        sum += trial.as_dmat3().determinant().ln() - updated.deformation_gradient.as_dmat3().determinant().ln();
        (f, plastic) = (updated.deformation_gradient, updated.plastic);
        assert!(plastic[1] >= 0.0);
        near(plastic[1], sum, 1e-4);
        corrected += usize::from(plastic[1] > 0.0);
    }
    assert!((200..1800).contains(&corrected), "{corrected} steps with a correction");
}

#[test]
fn sand_that_is_crushed_or_torn_remains_finite() {
    let sand = Model::Sand(Sand::new(3.537e5, 0.3));
    for f in [
        Mat3::ZERO,
        Mat3::from_diagonal(vec3(1.0, 1.0, -1.0)),
        Mat3::from_diagonal(vec3(1.0, 1e-30, 1e-30)),
        Mat3::isotropic(-1e6),
        Mat3::isotropic(1e30),
    ] {
        let mut plastic = sand.initial_plastic();
        for _ in 0..100 {
            let updated = sand.update(f, plastic);
            plastic = updated.plastic;
            assert!(plastic.iter().all(|value| value.is_finite()), "{f}");
            assert!(updated.deformation_gradient.is_finite() && updated.kirchhoff_stress.is_finite(), "{f}");
            assert!(updated.deformation_gradient.determinant() > 0.0, "{f}");
            assert!(sand.energy(updated.deformation_gradient, plastic).is_finite(), "{f}");
        }
        let plane = sand.update(Mat2::ZERO, sand.initial_plastic());
        assert!(plane.deformation_gradient.is_finite() && plane.kirchhoff_stress.is_finite());
    }
}

/// Of `energy(F + h D)` by `h`, to fourth order, against `P : D` where `P = tau F^-T`.
fn stress_is_the_derivative<M: Tested>(model: &Model, random: &mut ChaCha8Rng) {
    let f: M = borne(model, random);
    let plastic = model.initial_plastic();
    let updated = model.update(f, plastic);
    assert_eq!((updated.deformation_gradient, updated.plastic), (f, plastic), "{} yields", model.name());
    let piola = updated.kirchhoff_stress * f.inverse_of().transpose();
    let direction = M::random(random);
    let h = 0.01;
    let energy = |h: f32| f64::from(model.energy(f + direction * h, plastic));
    let derivative = (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * f64::from(h));
    let expected: f32 = piola.components().iter().zip(direction.components()).map(|(p, d)| p * d).sum();
    let scale = f64::from(largest(piola)) + 1e-2 * model.wave_modulus();
    assert!((derivative - f64::from(expected)).abs() < 5e-4 * scale, "{}: {derivative} {expected}", model.name());
}

#[test]
fn stress_is_the_derivative_of_energy() {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    // The fluid's energy is of second order only; see below.
    for model in MODELS[1..].iter().map(|model| model()) {
        for _ in 0..200 {
            stress_is_the_derivative::<Mat2>(&model, &mut random);
            stress_is_the_derivative::<Mat3>(&model, &mut random);
        }
    }
    // J dE/dJ is stiffness (J - 1) J, which the stress is but for a factor of J.
    let [before, after] = [0.999, 1.001].map(|scale| fluid::energy(400.0, 0.95 * scale));
    let stress: Mat2 = fluid::stress(400.0, 0.95);
    near((after - before) / (2.0 * 0.95 * 0.001) / stress.x_axis.x, 1.0, 1e-3);
}

fn is_indifferent<M: Tested>(model: &Model, random: &mut ChaCha8Rng) {
    // Beyond yield, too.
    let f = borne::<M>(model, random) + M::random(random) * 0.05;
    let turn = M::random(random).polar().rotation;
    let plastic = model.initial_plastic();
    let (here, there) = (model.update(f, plastic), model.update(turn * f, plastic));
    let scale = model.wave_modulus() as f32;
    let turned = turn * here.kirchhoff_stress * turn.transpose();
    let name = model.name();
    assert!(largest(there.kirchhoff_stress - turned) < 2e-6 * scale, "{name}: stress");
    assert!(largest(there.deformation_gradient - turn * here.deformation_gradient) < 2e-6, "{name}: deformation");
    for (there, here) in there.plastic.iter().zip(here.plastic) {
        assert!((there - here).abs() < 2e-6, "{name}: {there} {here}");
    }
    let energies = [here, there].map(|updated| model.energy(updated.deformation_gradient, updated.plastic));
    assert!((energies[0] - energies[1]).abs() < 1e-6 * scale, "{name}: {energies:?}");
    // It is symmetric, and does not depend on how the rest state is turned.
    let tau = here.kirchhoff_stress;
    assert!(largest(tau - tau.transpose()) < 1e-6 * scale, "{name}: symmetry");
    let inside = model.update(f * turn, plastic);
    assert!(largest(inside.kirchhoff_stress - tau) < 2e-6 * scale, "{name}: isotropy");
}

#[test]
fn laws_do_not_depend_on_the_frame() {
    let mut random = ChaCha8Rng::seed_from_u64(8);
    for model in MODELS[1..].iter().map(|model| model()) {
        for _ in 0..500 {
            is_indifferent::<Mat2>(&model, &mut random);
            is_indifferent::<Mat3>(&model, &mut random);
        }
    }
}

#[test]
fn a_corotated_solid_turned_inside_out_is_pushed_back() {
    let model = Model::Corotated(Elastic::new(1.0, 0.3));
    let f = Mat3::from_diagonal(vec3(1.0, 1.0, -0.1));
    let tau = model.update(f, [0.0; 2]).kirchhoff_stress;
    // 2 mu (s - 1) s + lambda (J - 1) J with s = J = -0.1.
    near(tau.z_axis.z, 0.11 * (2.0 / 2.6 + 0.3 / 0.52), 1e-6);
    assert!(model.energy(f, [0.0; 2]) > model.energy(Mat3::from_diagonal(vec3(1.0, 1.0, 0.1)), [0.0; 2]));
    // Neo-Hookean solids have no such state, and say so.
    assert!(Model::NeoHookean(Elastic::new(1.0, 0.3)).update(f, [0.0; 2]).kirchhoff_stress.is_nan());
}
