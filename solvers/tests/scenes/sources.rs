//! Scenes that include others, and values that are overridden.

use std::path::{Path, PathBuf};

use allotrope_solvers::Scene;
use allotrope_solvers::mpm::Spline;
use allotrope_solvers::scene::{Contact, Folder};

use super::{GOOD, own};

/// A folder of this test's own with files in it.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    for (file, text) in files {
        let path = folder.join(file);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    folder
}

fn load(folder: &Path, file: &str) -> Result<Scene, String> {
    // What messages say of the folder is of no account.
    let shown = format!("{}/", folder.display());
    Scene::load(&folder.join(file)).map_err(|error| error.to_string().replace(&shown, ""))
}

fn over(overrides: &[&str]) -> Result<Scene, String> {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Scene::parse_with(GOOD, "test.toml", Folder::Path(env!("CARGO_TARGET_TMPDIR").into()), &overrides)
        .map_err(|error| error.to_string())
}

#[test]
fn files_are_included_and_merged_key_by_key() {
    let folder = folder(
        "include",
        &[
            ("good.toml", GOOD),
            ("a.toml", "include = \"good.toml\"\ngravity = [1, 0]\n[material]\nstiffness = 200\n"),
            ("b.toml", "steps = 7\nspacing = 1.0\n"),
            ("c.toml", "include = [\"a.toml\", \"b.toml\"]\nspacing = 0.25\n[material]\ndensity = 2\n"),
            ("d.toml", "include = \"c.toml\"\n[[body]]\nshape = \"ball\"\ncenter = [1, 0.5]\nradius = 0.1\n"),
        ],
    );
    let scene = load(&folder, "d.toml").unwrap();
    assert_eq!((scene.gravity, scene.steps, own(&scene).spacing, scene.dt), ([1.0, 0.0, 0.0], 7, 0.25, 4e-4));
    assert_eq!((own(&scene).materials[0].density, own(&scene).materials[0].model.wave_modulus()), (2.0, 200.0));
    assert_eq!(own(&scene).bodies.len(), 1);
    // The text is the whole of it.
    let again = Scene::parse(&scene.text, "again", Folder::BuiltIn).unwrap();
    assert_eq!((again.difference(&scene.text), again.particles()), (None, scene.particles()));
    assert!(!scene.text.contains("include"), "{}", scene.text);
}

#[test]
fn files_stand_beside_those_that_name_them() {
    let points =
        GOOD.split_once("[[body]]").unwrap().0.to_string() + "[[body]]\nshape = \"points\"\nfile = \"p.txt\"\n";
    let folder = folder(
        "beside",
        &[
            ("more/points.toml", &points),
            ("more/p.txt", "0.5 0.5\n"),
            ("more/up.toml", "include = \"../steps.toml\"\n"),
            ("steps.toml", "steps = 3\n"),
            ("top.toml", "include = [\"more/points.toml\", \"./more/up.toml\"]\n"),
        ],
    );
    let scene = load(&folder, "top.toml").unwrap();
    assert_eq!((scene.particles().unwrap().x, scene.steps), (vec![[0.5, 0.5, 0.0]], 3));
}

#[test]
fn built_in_scenes_can_be_included() {
    let scene = Scene::parse("include = \"mpm88.toml\"\ndt = 1e-4\n", "slow", Folder::BuiltIn).unwrap();
    assert_eq!((scene.dt, own(&scene).grid), (1e-4, [128, 128, 1]));
    let fault = |text: &str, file: &str| Scene::parse(text, file, Folder::BuiltIn).unwrap_err().to_string();
    assert_eq!(
        fault("include = \"mpm89.toml\"", "slow"),
        "scene `slow`: `include = \"mpm89.toml\"` needs `mpm89.toml`, which is not among the files of the built-in scenes"
    );
    assert_eq!(
        fault("include = \"mpm88.toml\"", "mpm88"),
        "scene `mpm88`: `include = \"mpm88.toml\"` goes round in a circle: `mpm88.toml`, `mpm88.toml`"
    );
}

#[test]
fn faults_of_includes_name_their_file() {
    let folder = folder(
        "faults",
        &[
            ("good.toml", GOOD),
            ("none.toml", "include = [\"good.toml\", \"nowhere.toml\"]\n"),
            ("number.toml", "include = 3\n"),
            ("numbers.toml", "include = [\"good.toml\", 3]\n"),
            ("circle.toml", "include = \"more/circle.toml\"\n"),
            ("more/circle.toml", "include = \"../circle.toml\"\n"),
            ("not.toml", "steps = 3\ndt = = 1\n"),
            ("of_not.toml", "include = \"not.toml\"\n"),
            ("slow.toml", "dt = -1\n"),
            ("of_slow.toml", "include = [\"good.toml\", \"slow.toml\"]\n"),
            ("own.toml", "include = [\"good.toml\", \"slow.toml\"]\ndt = -2\n"),
        ],
    );
    let cases = [
        (
            "none.toml",
            "scene `none.toml`: `include = [\"good.toml\", \"nowhere.toml\"]` needs `nowhere.toml`, which cannot be read:",
        ),
        (
            "number.toml",
            "scene `number.toml`: `include = 3` is a whole number, where the name of a file or a list of names is wanted",
        ),
        (
            "numbers.toml",
            "scene `numbers.toml`: `include = [\"good.toml\", 3]` holds a whole number, where the name of a file or a list \
             of names is wanted",
        ),
        (
            "circle.toml",
            "scene `more/circle.toml`: `include = \"../circle.toml\"` goes round in a circle: `circle.toml`, \
             `more/circle.toml`, `circle.toml`",
        ),
        ("of_not.toml", "scene `not.toml`: line 2 is not TOML: "),
        (
            "of_slow.toml",
            "scene `of_slow.toml`: `dt = -1` must be above zero; write, for example, `dt = 2e-4` (from `slow.toml`)",
        ),
    ];
    for (file, wanted) in cases {
        let message = load(&folder, file).unwrap_err();
        assert!(message.starts_with(wanted) && message.lines().count() == 1, "{message}\n  wanted {wanted}");
    }
    let own = load(&folder, "own.toml").unwrap_err();
    assert_eq!(own, "scene `own.toml`: `dt = -2` must be above zero; write, for example, `dt = 2e-4`");
}

#[test]
fn values_are_overridden() {
    let scene = over(&[
        "dt=1e-4",
        "body.0.velocity=[1, 0]",
        "body.1.radius = 0.1",
        "walls.floor.contact=sticky",
        "transfer={ scheme = \"pic\" }",
        "transfer.spline=\"cubic\"",
        "dt=2e-4",
    ])
    .unwrap();
    assert_eq!((scene.dt, own(&scene).bodies[0].velocity), (2e-4, [1.0, 0.0, 0.0]));
    assert_eq!((own(&scene).walls[1][0].contact, own(&scene).transfer.spline), (Contact::Sticky, Spline::Cubic));
    let plain = Scene::parse(GOOD, "test.toml", Folder::BuiltIn).unwrap();
    assert_eq!(plain.difference(&scene.text).unwrap(), "`body[0].velocity` is not given here and [1, 0] there");
    // They come after includes, and before nothing.
    let folder = folder("over", &[("good.toml", GOOD), ("top.toml", "include = \"good.toml\"\ndt = 3e-4\n")]);
    let scene = Scene::load_with(&folder.join("top.toml"), &["dt=1e-4".into(), "length=4".into()]).unwrap();
    assert_eq!((scene.dt, own(&scene).length), (1e-4, 4.0));
}

#[test]
fn faulty_overrides_are_named() {
    let cases = [
        ("dt", "the override `dt` is not `key=value`; write, for example, `dt=1e-4`"),
        ("=3", "the override `=3` has an empty key before its `=`; write, for example, `body.0.velocity=[1, 0]`"),
        ("dt=", "the override `dt=` has no value after its `=`"),
        ("gravity=[0, 1", "the override `gravity=[0, 1` has a value that is not TOML"),
        ("dt=1\nlength=2", "has a value that is not TOML"),
        (
            "include=x.toml",
            "the override `include=x.toml` comes too late, since files are included first; write it into the scene",
        ),
        (
            "body.2.radius=1",
            "the override `body.2.radius=1` names no element of `body`, a list of 2; they are counted from 0, as in `body.0`",
        ),
        (
            "body.radius=1",
            "the override `body.radius=1` names no element of `body`, a list of 2; they are counted from 0, as in `body.0`",
        ),
        ("dt.x=1", "the override `dt.x=1` goes into `dt`, which is a number"),
        ("dt=fast", "`dt = \"fast\"` is a text, where a number is wanted (from the override `dt=fast`)"),
        (
            "body.1.raduis=1",
            "`body[1].raduis` is not a key of a scene; did you mean `radius`? (from the override `body.1.raduis=1`)",
        ),
        ("gravity.0=nan", "`gravity = [nan, -9.8]` is not a finite number (from the override `gravity.0=nan`)"),
        ("walls.flor.contact=slip", "`walls.flor` is not a key of a scene; did you mean `floor`? (from the override"),
    ];
    for (text, wanted) in cases {
        let message = over(&["seed=3", text]).map(|_| ()).expect_err(text);
        assert!(message.starts_with("scene `test.toml`: ") && message.contains(wanted), "{message}\n  wanted {wanted}");
    }
    // A fault of another key is not the override's.
    let message = over(&["dt=1e-4", "length=-1"]).unwrap_err();
    assert!(message.ends_with("(from the override `length=-1`)"), "{message}");
}
