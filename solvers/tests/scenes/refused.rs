//! Values that are refused, and the exact message of each.

use super::{GOOD, parse};

const MATERIAL: &str = "[material]\nstiffness = 400\ndensity = 1.5";

/// Asserts the message of the good scene in which a piece is replaced; an empty piece is appended.
fn assert_refused(cases: &[(&str, &str, &str)]) {
    for (piece, by, wanted) in cases {
        assert!(GOOD.contains(piece), "{piece}");
        let text = if piece.is_empty() { format!("{GOOD}\n{by}") } else { GOOD.replace(piece, by) };
        let message = parse(&text).map(|_| ()).expect_err(by);
        assert_eq!(message, format!("scene `test.toml`: {wanted}"), "{by}");
    }
}

#[test]
fn faulty_materials_are_refused() {
    assert_refused(&[
        (
            MATERIAL,
            "[material]\nmodel = \"honey\"\ndensity = 1",
            "`material.model = \"honey\"` is no model; known are `fluid`, `neo-hookean`, `corotated`, `snow`, `sand`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"snow\"\nstiffness = 400\ndensity = 1",
            "`material.stiffness = 400` is not a key of a material of the model `snow`, which takes `young`, `poisson`, `hardening`, `compression`, `stretch`, `density`, `model`, `name`",
        ),
        (
            MATERIAL,
            "[material]\nstiffness = 400\nyoung = 1e5\ndensity = 1",
            "`material.young = 100000.0` is not a key of a material of the model `fluid`, which takes `stiffness`, `density`, `model`, `name`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"corotated\"\nyoung = 1e5\npoison = 0.3\ndensity = 1",
            "`material.poison` is not a key of a scene; did you mean `poisson`?",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"corotated\"\nyoung = -1e5\npoisson = 0.3\ndensity = 1",
            "`material.young = -100000.0` must be above zero; write, for example, `young = 1e5`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"corotated\"\nyoung = 1e5\ndensity = 1",
            "`material.poisson` is missing; write, for example, `poisson = 0.3`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"corotated\"\nyoung = 1e5\npoisson = 0.5\ndensity = 1",
            "`material.poisson = 0.5` must be above -1 and below 0.5, where a solid would bear no change of volume; write, for example, `poisson = 0.3`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"neo-hookean\"\nyoung = 1e5\npoisson = -1\ndensity = 1",
            "`material.poisson = -1` must be above -1 and below 0.5, where a solid would bear no change of volume; write, for example, `poisson = 0.3`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"neo-hookean\"\nyoung = 1e30\npoisson = 0.4999999999\ndensity = 1",
            "`material.poisson = 0.4999999999` is too near its bound for `young = 1e30` in single precision",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"snow\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\ncompression = 1",
            "`material.compression = 1` is not above 0 and below 1, at which snow would be flat",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"snow\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nstretch = 0",
            "`material.stretch = 0` must be above zero; write, for example, `stretch = 7.5e-3`",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"snow\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nhardening = -1",
            "`material.hardening = -1` is not from 0 to 100",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"sand\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nfriction_angles = [35, 9, 0.2]",
            "`material.friction_angles = [35, 9, 0.2]` holds 3, where a list of 4 numbers is wanted",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"sand\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nfriction_angles = [35, 9, 0, 10]",
            "`material.friction_angles = [35, 9, 0, 10]` lets the angle of friction grow without bounds; the third number must be above zero",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"sand\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nfriction_angles = [85, 9, 0.2, 10]",
            "`material.friction_angles = [85, 9, 0.2, 10]` comes to an angle of friction of 98.2559 degrees, which is not from 0 to 90",
        ),
        (
            MATERIAL,
            "[material]\nmodel = \"sand\"\nyoung = 1e5\npoisson = 0.2\ndensity = 400\nvolume_correction = 1",
            "`material.volume_correction = 1` is a whole number, where true or false is wanted",
        ),
        (MATERIAL, "[material]\nname = \"\"\nstiffness = 400\ndensity = 1", "`material.name = \"\"` is empty"),
        (
            MATERIAL,
            "material = []",
            "`material = []` is missing; write a table `[material]` with `stiffness` and `density`, or another `model`",
        ),
        (
            MATERIAL,
            "material = [1]",
            "`material = [1]` holds a whole number, where a table `[material]` or a list of tables `[[material]]` is wanted",
        ),
        (
            MATERIAL,
            "[[material]]\nname = \"oil\"\nstiffness = 1\ndensity = 1\n[[material]]\nstiffness = 1\ndensity = 1",
            "`material[1].name` is missing; write, for example, `name = \"fluid\"`",
        ),
        (
            MATERIAL,
            "[[material]]\nname = \"oil\"\nstiffness = 1\ndensity = 1\n[[material]]\nname = \"oil\"\nstiffness = 1\ndensity = 1",
            "`material[1].name = \"oil\"` is the name of an earlier material too; bodies ask for a material by it",
        ),
        (
            MATERIAL,
            "[[material]]\nname = \"oil\"\nstiffness = 1\ndensity = 1\n[[material]]\nname = \"water\"\nstiffness = 1\ndensity = -1",
            "`material[1].density = -1` must be above zero; write, for example, `density = 1.0`",
        ),
        (
            "spin = 3.0",
            "material = \"fluit\"",
            "`body[1].material = \"fluit\"` is not the name of a material; did you mean `fluid`?",
        ),
    ]);
}

#[test]
fn faulty_bodies_are_refused() {
    assert_refused(&[
        ("spin = 3.0", "aligned = 1", "`body[1].aligned = 1` is a whole number, where true or false is wanted"),
        (
            "to = [1.0, 0.5]",
            "to = [1.0, 0.5]\naligned = true\nparticles = 8",
            "`body[0].particles = 8` asks for random particles, and `aligned` puts them on the grid's lattice; leave one out",
        ),
        (
            "to = [1.0, 0.5]",
            "to = [1.0, 0.5]\naligned = true\njitter = 0.5",
            "`body[0].jitter = 0.5` moves particles, and `aligned` puts them on the grid's lattice; leave one out",
        ),
        ("gravity = [0, -9.8]", "seed = -1", "`seed = -1` holds -1, which is not from 0 to 9223372036854775807"),
    ]);
}

#[test]
fn faulty_transfers_are_refused() {
    assert_refused(&[
        ("", "[transfer]\nscheme = \"apix\"", "`transfer.scheme = \"apix\"` is no scheme; did you mean `apic`?"),
        ("", "[transfer]\nschema = \"apic\"", "`transfer.schema` is not a key of a scene; did you mean `scheme`?"),
        ("", "[transfer]\nscheme = \"flip\"\nblend = 1.5", "`transfer.blend = 1.5` is not from 0 to 1"),
        (
            "",
            "[transfer]\nscheme = \"pic\"\nblend = 0.5",
            "`transfer.blend = 0.5` belongs to `scheme = \"flip\"`, and the scheme is `pic`",
        ),
        (
            "",
            "[transfer]\nmodes = 4",
            "`transfer.modes = 4` belongs to `scheme = \"polypic\"`, and the scheme is `apic`",
        ),
        (
            "",
            "[transfer]\nscheme = \"polypic\"\nmodes = 5",
            "`transfer.modes = 5` cannot be; in 2D it is one of 1, 3, 4, 6, 9",
        ),
        (
            "",
            "[transfer]\nscheme = \"polypic\"\nmodes = 27",
            "`transfer.modes = 27` holds 27, which is not from 1 to 9",
        ),
        (
            "",
            "[transfer]\nscheme = \"polypic\"\nspline = \"cubic\"",
            "`transfer.spline = \"cubic\"` does not go with `scheme = \"polypic\"`, whose modes are those of 3 nodes an axis; write `spline = \"quadratic\"` or another scheme",
        ),
        (
            "",
            "[transfer]\nspline = \"linear\"",
            "`transfer.spline = \"linear\"` does not go with `scheme = \"apic\"`, which divides by the spread of a particle's nodes, and linear weights have none where it meets a node; write `spline = \"quadratic\"`, or `scheme = \"flip\"` or `\"pic\"`",
        ),
        (
            "",
            "[transfer]\nscheme = \"flip\"\nspline = \"linear\"\nforces = \"least-squares\"",
            "`transfer.forces = \"least-squares\"` does not go with `spline = \"linear\"`: it divides by the spread of a particle's nodes, and linear weights have none where it meets a node; write `forces = \"gradients\"`",
        ),
        (
            "",
            "[transfer]\nforces = \"mls\"",
            "`transfer.forces = \"mls\"` is no way to compute forces; known are `gradients`, `least-squares`",
        ),
        (
            "gravity = [0, -9.8]",
            "wall = 3\ntransfer = { spline = \"cubic\" }",
            "`wall = 3` holds 3, which is not from 4 to 64",
        ),
        (
            "gravity = [0, -9.8]",
            "transfer = \"apic\"",
            "`transfer = \"apic\"` is a text, where a table `[transfer]` is wanted",
        ),
    ]);
}

#[test]
fn faulty_walls_are_refused() {
    assert_refused(&[
        ("", "[walls]\ncontact = \"stick\"", "`walls.contact = \"stick\"` is no contact; did you mean `sticky`?"),
        ("", "[walls]\nfriction = -0.1", "`walls.friction = -0.1` must be zero, which is none, or above"),
        (
            "",
            "[walls]\ncontact = \"slip\"\nfriction = 0.1",
            "`walls.friction = 0.1` belongs to `contact = \"separate\"`, and the contact is `slip`",
        ),
        (
            "",
            "[walls]\nvelocity = [1, 0]",
            "`walls.velocity = [1, 0]` would move the wall `left` out of its plane; its component along axis 0 must be zero, or the wall's own table must tell another velocity",
        ),
        (
            "",
            "[walls.ceiling]\nvelocity = [1, 1]",
            "`walls.ceiling.velocity = [1, 1]` would move the wall `ceiling` out of its plane; its component along axis 1 must be zero",
        ),
        (
            "",
            "[walls.front]\ncontact = \"slip\"",
            "`walls.front = { contact = \"slip\" }` is a wall of `dimensions = 3`; in the plane there is none",
        ),
        ("", "[walls.flor]\ncontact = \"slip\"", "`walls.flor` is not a key of a scene; did you mean `floor`?"),
        (
            "",
            "[walls]\nfloor = \"slip\"",
            "`walls.floor = \"slip\"` is a text, where a table `[walls.floor]` is wanted",
        ),
        (
            "",
            "[walls.floor]\nfriktion = 0.5",
            "`walls.floor.friktion` is not a key of a scene; did you mean `friction`?",
        ),
    ]);
}

#[test]
fn faulty_colliders_are_refused() {
    assert_refused(&[
        (
            "",
            "[[collider]]\nshape = \"cone\"",
            "`collider[0].shape = \"cone\"` is no shape; known are `ball`, `box`, `half-space`, `mesh`",
        ),
        (
            "",
            "[[collider]]\nshape = \"points\"",
            "`collider[0].shape = \"points\"` is no shape; known are `ball`, `box`, `half-space`, `mesh`",
        ),
        ("", "[[collider]]\ncenter = [1, 1]", "`collider[0].shape` is missing; write, for example, `shape = \"box\"`"),
        (
            "",
            "[[collider]]\nshape = \"ball\"\ncenter = [1, 0.5]\nradius = 0",
            "`collider[0].radius = 0` must be above zero; write, for example, `radius = 0.2`",
        ),
        (
            "",
            "[[collider]]\nshape = \"ball\"\ncenter = [1, 0.5]\nradius = 0.1\nspin = 1",
            "`collider[0].spin` is not a key of a scene; known are `center`, `radius`, `shape`, `contact`, `friction`, `velocity`",
        ),
        (
            "",
            "[[collider]]\nshape = \"ball\"\ncenter = [1, 0.5]\nradius = 0.1\nnormal = [0, 1]",
            "`collider[0].normal = [0, 1]` is not a key of a collider of the shape `ball`, which takes `center`, `radius`, `shape`, `contact`, `friction`, `velocity`",
        ),
        (
            "",
            "[[collider]]\nshape = \"box\"\nfrom = [1, 0.5]\nto = [1.5, 0.5]",
            "`collider[0].to = [1.5, 0.5]` must lie above `from`, and on axis 1 0.5 does not lie above 0.5",
        ),
        (
            "",
            "[[collider]]\nshape = \"half-space\"\npoint = [1, 0.5]\nnormal = [0, 0]",
            "`collider[0].normal = [0, 0]` has no length, and so no direction; write, for example, `normal = [0, 1]`",
        ),
        (
            "",
            "[[collider]]\nshape = \"half-space\"\npoint = [1, 0.5]\nnormal = [0, 0, 1]",
            "`collider[0].normal = [0, 0, 1]` holds 3, where a list of 2 numbers is wanted",
        ),
        (
            "",
            "[[collider]]\nshape = \"mesh\"\nfile = \"bunny.obj\"",
            "`collider[0].shape = \"mesh\"` needs `dimensions = 3`",
        ),
        (
            "",
            "[collider]\nshape = \"ball\"",
            "`collider = { shape = \"ball\" }` is a table, where a list of tables `[[collider]]` is wanted",
        ),
        ("", "[camera]\nzoom = 2", "`camera = { zoom = 2 }` is for `dimensions = 3`; the whole of a plane is seen"),
    ]);
}
