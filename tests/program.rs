//! The program, as it is called.

use std::path::Path;
use std::process::{Command, Output};

use allotrope_lab::lab::bench::Report;
use allotrope_lab::lab::convert_cost;
use allotrope_lab::lab::counts;
use allotrope_lab::lab::peers::Report as Comparison;

fn allotrope(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    command.args(arguments).env_remove("ALLOTROPE_CPU").env_remove("ALLOTROPE_THREADS");
    command.output().unwrap()
}

fn succeeds(arguments: &[&str]) -> String {
    let output = allotrope(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The one line with which a command is refused.
fn refused(arguments: &[&str]) -> String {
    let output = allotrope(arguments);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && message.lines().count() == 1, "{arguments:?}: {message}");
    message.strip_prefix("error: ").unwrap().trim_end().to_string()
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn list_tells_what_there_is() {
    let text = succeeds(&["list"]);
    for name in [
        "mpm",
        "mpm88",
        "bunny",
        "aos+row",
        "soa+soa",
        "hot+row",
        "aosoa16+blocked4",
        "aos+hash4",
        "private",
        "atomic",
        "mpm88-1m",
    ] {
        assert!(text.split_whitespace().any(|word| word.trim_end_matches(':') == name), "{name}");
    }
}

#[test]
fn a_run_that_breaks_down_stops_with_one_line_and_status_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fast.toml");
    let fast = include_str!("../solvers/scenes/mpm88.toml").replace("[0.0, -9.8]", "[0.0, -2e5]");
    std::fs::write(&path, fast).unwrap();
    let out = folder.path().join("out");
    let output = allotrope(&["run", "mpm", "--scene", path.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.starts_with("error: stopped at step 1: particle 0 (fluid) at (") && message.lines().count() == 1,
        "{message}"
    );
    let last = out.join("frame_0000.png");
    assert!(message.ends_with(&format!("; last good frame: {}\n", last.display())), "{message}");
    assert_eq!(names(&out), ["frame_0000.png"]);
}

#[test]
fn run_writes_pictures_that_show_the_fluid() {
    for (scene, size, steps) in [("mpm88", (800, 800), "20"), ("bunny", (800, 700), "4")] {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("made/here");
        let text = succeeds(&[
            "run",
            "mpm",
            "--scene",
            scene,
            "--layout",
            "aos+sparse4",
            "--steps",
            steps,
            "--frames",
            "2",
            "--out",
            out.to_str().unwrap(),
        ]);
        assert!(text.contains(&format!("{steps} steps")) && text.contains("steps a second"), "{text}");
        assert_eq!(names(&out), ["frame_0000.png", "frame_0001.png", "frame_0002.png", "sheet.png"]);
        let picture = |n: usize| image::open(out.join(format!("frame_000{n}.png"))).unwrap().to_rgb8();
        let (first, last) = (picture(0), picture(2));
        assert_eq!(first.dimensions(), size);
        assert_ne!(first, last, "{scene} does not move");
        // Fluid is bluish or warm and bright; there is about as much of it as the scene holds.
        let bright = first.pixels().filter(|pixel| pixel.0.iter().any(|&component| component > 120)).count() as f64;
        let share = bright / f64::from(size.0 * size.1);
        assert!((0.04..0.3).contains(&share), "{scene}: {share}");
    }
}

#[test]
fn bench_tells_which_layouts_it_leaves_out() {
    let text = succeeds(&["bench", "mpm", "--particles", "1000", "--steps", "11"]);
    let left_out: Vec<_> = text.lines().filter(|line| line.starts_with("left out: ")).collect();
    assert!(left_out.len() == 1 && left_out[0].starts_with("left out: hot+row; every member"), "{text}");
    let text = succeeds(&["bench", "mpm", "--particles", "1000", "--steps", "11", "--layouts", "aos+row,soa+soa"]);
    assert!(!text.contains("left out"), "{text}");
}

#[test]
fn search_finds_what_run_and_bench_take() {
    let folder = tempfile::tempdir().unwrap();
    let (file, out) = (folder.path().join("tuned.toml"), folder.path().join("out"));
    let (file, out) = (file.to_str().unwrap(), out.to_str().unwrap());
    let layouts = ["--layouts", "aos+row,aos+sparse4", "--schedules", "serial,private", "--intervals", "0,8"];
    let asked =
        ["search", "mpm", "--particles", "1000", "--grid", "32", "--threads", "2", "--budget", "1", "--out", file];
    let text = succeeds(&[&asked[..], &layouts].concat());
    assert!(text.contains("all 8 end in the same state: after "), "{text}");
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with("aos+") && line.contains(" to ")).collect();
    let ranking: Vec<Vec<&str>> =
        rows.iter().map(|row| row.split_whitespace().collect()).filter(|row: &Vec<_>| row.len() == 9).collect();
    assert_eq!(ranking.len(), 8, "{text}");
    // Three rounds: eight, four, two, and what cannot be told from them, which on a busy machine may be all.
    let rounds: Vec<usize> = ranking.iter().map(|row| row[3].parse().unwrap()).collect();
    assert!(rounds.is_sorted_by(|a, b| a >= b) && rounds[..2] == [3, 3], "{text}");
    assert_eq!((ranking[0][5], ranking[0][6]), ("1.000", "1.000"));
    let line = std::fs::read_to_string(file).unwrap();
    let [layout, schedule, reorder] = [ranking[0][0], ranking[0][1], ranking[0][2]];
    let start = format!(
        "mpm = {{ layout = \"{layout}\", schedule = \"{schedule}\", reorder = \"{reorder}\", scene = \"mpm88\""
    );
    assert!(line.starts_with(&start) && text.ends_with(&line), "{line}\n{text}");

    let text = succeeds(&["run", "mpm", "--tuned", file, "--steps", "3", "--frames", "0", "--out", out]);
    assert!(text.starts_with(&format!("mpm of scene mpm88 in {layout}: ")), "{text}");
    let text = succeeds(&["bench", "mpm", "--tuned", file, "--particles", "1000", "--steps", "11"]);
    assert!(text.lines().any(|row| row.split_whitespace().take(2).eq([layout, schedule])), "{text}");
}

#[test]
fn run_tells_what_bounds_the_steps() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let text = succeeds(&["run", "wcsph", "--scene", "hydrostatic", "--steps", "30", "--out", out.to_str().unwrap()]);
    let line = text.lines().find_map(|line| line.strip_prefix("the last step took ")).expect(&text);
    let numbers: Vec<f64> = line.split([' ', ',']).filter_map(|word| word.parse().ok()).collect();
    assert!(["forces", "sound"].iter().all(|what| line.contains(what)) && numbers.len() >= 3, "{line}");
    let least = numbers[1..].iter().copied().fold(f64::INFINITY, f64::min);
    assert!(numbers[0] <= least * 1.005 && numbers[0] > 0.0, "{line}");
}

#[test]
fn bench_compares_layouts_and_writes_its_report() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bench.json");
    let text = succeeds(&[
        "bench",
        "mpm",
        "--layouts",
        "aos+row,aosoa16+blocked4",
        "--schedules",
        "private,serial",
        "--particles",
        "2000",
        "--grid",
        "48",
        "--threads",
        "2",
        "--steps",
        "22",
        "--json",
        path.to_str().unwrap(),
    ]);
    assert!(text.contains("2000 particles, 48 x 48 nodes") && text.contains("2 threads"), "{text}");
    assert!(text.contains("all 4 end in the same state") && text.contains("in 11 interleaved repetitions"), "{text}");
    let table: Vec<&str> = text.lines().skip_while(|line| !line.starts_with("layout")).collect();
    assert_eq!(table.len(), 5, "{text}");
    for column in ["schedule", "ms/step", "spread", "scatter", "grid", "gather", "ns/particle", "MiB", "ratio"] {
        assert!(table[0].contains(column), "{column}");
    }

    let line = std::fs::read_to_string(&path).unwrap();
    assert_eq!(line.lines().count(), 1);
    assert_eq!(names(folder.path()), ["bench.json"]);
    assert!(
        line.starts_with(r#"{"solver":"mpm","scene":"mpm88","particles":2000,"grid":[48,48],"threads":2,"isa":""#),
        "{line}"
    );
    let keys = [
        r#""rows":[{"layout":"aos+row","schedule":"private","ms_per_step":"#,
        r#","spread":"#,
        r#","kernels":{"scatter":"#,
        r#","grid":"#,
        r#","gather":"#,
        r#","bytes":"#,
        r#","state_error":0.0},{"#,
    ];
    let mut rest = line.as_str();
    for key in keys {
        (_, rest) = rest.split_once(key).unwrap_or_else(|| panic!("{key} is not in its place in {line}"));
    }

    let report: Report = serde_json::from_str(&line).unwrap();
    let rows: Vec<_> = report.rows.iter().map(|row| (row.layout.as_str(), row.schedule.as_str())).collect();
    let layouts = [
        ("aos+row", "private"),
        ("aos+row", "serial"),
        ("aosoa16+blocked4", "private"),
        ("aosoa16+blocked4", "serial"),
    ];
    assert_eq!(rows, layouts);
    for row in &report.rows {
        assert!(row.ms_per_step > 0.0 && row.spread >= 0.0 && row.state_error < 1e-6, "{row:?}");
        assert!((2000 * 36 + 48 * 48 * 12..200_000).contains(&row.bytes), "{row:?}");
        let kernels: f64 = row.kernels.0.iter().map(|(_, time)| time).sum();
        // Medians of the parts against the median of the whole, on a machine that may be busy.
        assert!(row.kernels.0.len() == 3 && (0.3..2.0).contains(&(kernels / row.ms_per_step)), "{row:?}");
    }
}

/// A sweep in a folder, and what it prints.
fn sweep(axis: &str, points: &str, more: &[&str], out: &Path) -> Output {
    let layouts = ["--layouts", "aos+row,soa+soa", "--steps", "11", "--sweep", axis, "--points", points, "--out"];
    allotrope(&[&["bench", "mpm"], &layouts[..], &[out.to_str().unwrap()], more].concat())
}

/// The first columns of the lines of a sweep's table of numbers.
fn columns(out: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(out.join("sweep.csv")).unwrap();
    text.lines().skip(1).map(|line| line.split(',').take(6).collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn a_sweep_goes_on_where_it_was_interrupted() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("sizes");
    let done = sweep("size", "2048,512", &["--threads", "1"], &out);
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(text.contains(": 2 points along `size`\n"), "{text}");
    assert!(text.contains("point 1 of 2: 2048 particles: 2048 particles, 64 x 64 nodes, best "), "{text}");
    assert_eq!(names(&out), ["sweep.csv", "sweep.json", "sweep.svg"]);
    let both = ["512 512 32x32 1 aos+row auto", "512 512 32x32 1 soa+soa auto"];
    let more = ["2048 2048 64x64 1 aos+row auto", "2048 2048 64x64 1 soa+soa auto"];
    assert_eq!(columns(&out), [both, more].concat());
    let first = std::fs::read_to_string(out.join("sweep.csv")).unwrap();

    // What is there is taken over to the bit, and what is missing is measured.
    let text = String::from_utf8(sweep("size", "512,1152,2048", &["--threads", "1"], &out).stdout).unwrap();
    assert!(text.contains(": 3 points along `size`; 2 of them are there already\n"), "{text}");
    assert!(text.contains("point 3 of 3: 1152 particles: ") && !text.contains("point 1 of 3"), "{text}");
    let last = std::fs::read_to_string(out.join("sweep.csv")).unwrap();
    let lines: Vec<_> = last.lines().collect();
    assert_eq!(lines.len(), 7);
    assert_eq!([&lines[..3], &lines[5..]].concat().join("\n"), first.trim_end());
    let chart = std::fs::read_to_string(out.join("sweep.svg")).unwrap();
    assert_eq!(chart.matches("<circle").count(), 6);
    assert!(chart.contains("\nsoa+soa\n") && chart.contains("nanoseconds a particle and step"), "{chart}");

    // Nothing else goes on in its folder, and nothing that is damaged.
    let refused = |output: Output, wanted: &str| {
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), message.trim_end()), (Some(2), wanted));
    };
    let file = out.join("sweep.json");
    let wrong = |what: &str| {
        format!(
            "error: sweep `{}` is another one: {what}; take another folder by `--out`, or remove it",
            file.display()
        )
    };
    refused(sweep("threads", "1", &[], &out), &wrong("`axis` is \"threads\" here and \"size\" there"));
    let dt = ["--threads", "1", "--set", "dt=1e-4"];
    refused(sweep("size", "512", &dt, &out), &wrong("the scene has other values"));
    refused(sweep("size", "512", &["--threads", "2"], &out), &wrong("`threads` is 2 here and 1 there"));
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, &text[..text.len() / 2]).unwrap();
    let output = sweep("size", "512", &["--threads", "1"], &out);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.starts_with(&format!("error: sweep `{}` is damaged: ", file.display())), "{message}");
    assert_eq!((output.status.code(), message.lines().count()), (Some(2), 1));
}

#[test]
fn threads_and_orders_are_swept() {
    let folder = tempfile::tempdir().unwrap();
    let size = ["--particles", "2000", "--grid", "48"];
    let threads = folder.path().join("threads");
    assert!(sweep("threads", "2,1", &size, &threads).status.success());
    let row = |threads: usize, layout| format!("{threads} 2000 48x48 {threads} {layout} auto");
    assert_eq!(columns(&threads), [row(1, "aos+row"), row(1, "soa+soa"), row(2, "aos+row"), row(2, "soa+soa")]);
    let densities = folder.path().join("densities");
    assert!(sweep("particles-per-cell", "2,0.5", &["--grid", "64", "--threads", "1"], &densities).status.success());
    // Some 655 of the 64 x 64 cells are filled at the start.
    let counts: Vec<usize> =
        columns(&densities).iter().map(|line| line.split(' ').nth(1).unwrap().parse().unwrap()).collect();
    assert!(
        (300..380).contains(&counts[0]) && counts[1] == counts[0] && counts[2].abs_diff(4 * counts[0]) < 4,
        "{counts:?}"
    );
    let parts = folder.path().join("parts");
    assert!(sweep("sparsity", "0.05,0.1", &["--grid", "64", "--threads", "1"], &parts).status.success());
    let domains: Vec<String> =
        columns(&parts).iter().map(|line| line.split(' ').take(3).collect::<Vec<_>>().join(" ")).collect();
    // The same particles in 27 x 27 cells, which are so large a part of the domain.
    assert_eq!(domains, ["0.05 8192 120x120", "0.05 8192 120x120", "0.1 8192 85x85", "0.1 8192 85x85"]);
    let orders = folder.path().join("orders");
    let done = sweep("order", "auto,0,4", &[&size[..], &["--threads", "1"]].concat(), &orders);
    let text = String::from_utf8(done.stdout).unwrap();
    assert!(
        text.contains("point 3 of 3: particles sorted every 4 steps: 2000 particles, 48 x 48 nodes, best "),
        "{text}"
    );
    let columns: Vec<_> = columns(&orders).iter().map(|line| line.split(' ').next().unwrap().to_string()).collect();
    assert_eq!(columns, ["0", "0", "4", "4", "auto", "auto"]);
    assert!(std::fs::read_to_string(orders.join("sweep.svg")).unwrap().contains("\nsoa+soa, auto\n"));
}

#[test]
fn a_change_of_layouts_tells_what_it_costs_and_when_it_pays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cost.json");
    let size = ["--particles", "2000", "--grid", "48", "--threads", "1", "--steps", "22", "--json"];
    let command = ["convert-cost", "mpm", "aos+row", "aosoa16+blocked4"];
    let text = succeeds(&[&command[..], &size, &[path.to_str().unwrap()]].concat());
    assert!(text.starts_with("mpm mpm88: 2000 particles, 48 x 48 nodes\n"), "{text}");
    assert!(text.contains("the state goes over whole, and both go on alike: after 22 steps"), "{text}");
    assert!(
        text.contains("22 steps each, in 11 interleaved repetitions") && text.contains("\naosoa16+blocked4  "),
        "{text}"
    );
    assert!(
        text.contains("\naos+row to aosoa16+blocked4: ") && text.lines().last().unwrap().contains("pays"),
        "{text}"
    );

    let line = std::fs::read_to_string(&path).unwrap();
    let report: convert_cost::Report = serde_json::from_str(&line).unwrap();
    assert_eq!((report.from.layout.as_str(), report.to.layout.as_str()), ("aos+row", "aosoa16+blocked4"));
    let change = &report.change;
    assert!(change.read_ms > 0.0 && change.write_ms > 0.0 && change.ms < 1e3, "{report:?}");
    let [low, high] = change.gain_interval_ms;
    assert!(low <= change.gain_ms && change.gain_ms <= high, "{report:?}");
    // It pays where the gain is above the noise, and then for its cost.
    assert_eq!(change.pays_after.is_some(), low > 0.0);
    if let (Some(steps), Some([early, late])) = (change.pays_after, change.pays_between) {
        assert!(early <= steps && steps <= late, "{report:?}");
        assert!((steps as f64 - change.ms / change.gain_ms).abs() <= 1.0 + 1e-3 * steps as f64, "{report:?}");
    }
}

#[test]
fn counts_are_those_of_the_kernels_in_every_layout() {
    let folder = tempfile::tempdir().unwrap();
    let (json, heat) = (folder.path().join("counts.json"), folder.path().join("heat"));
    let places = ["--json", json.to_str().unwrap(), "--out", heat.to_str().unwrap()];
    let size = ["--particles", "2000", "--grid", "48", "--layouts", "aos+row,soa+soa,aos+sparse4"];
    if !allotrope::probe::AVAILABLE {
        assert!(refused(&["count", "mpm"]).contains("`cargo run --release --features probe -- count ..`"));
        return;
    }
    let text = succeeds(&[&["count", "mpm"][..], &size, &places].concat());
    assert!(text.starts_with("mpm mpm88: what one step from the start of the scene touch, on one thread\n"), "{text}");
    let report: counts::Report = serde_json::from_str(&std::fs::read_to_string(&json).unwrap()).unwrap();
    let named = |layout: &counts::Layout, kernel: &str| {
        layout.loops.iter().find(|row| row.kernel == kernel).unwrap_or_else(|| panic!("{kernel} in {layout:?}")).clone()
    };
    let of = |row: &counts::Loop, member: &str, access: &str| -> u64 {
        row.members.iter().filter(|m| m.member == member && m.access == access).map(|m| m.count).sum()
    };
    for layout in &report.layouts {
        // Nine nodes a particle, whatever the layout.
        let (scatter, gather) = (named(layout, "particle_to_grid"), named(layout, "grid_to_particle"));
        for (member, access, times) in
            [("v", "accumulate", 9), ("m", "accumulate", 9), ("x", "read", 1), ("c", "read", 1)]
        {
            assert_eq!(of(&scatter, member, access), times * 2000, "{member} in {}", layout.layout);
        }
        assert_eq!((of(&gather, "v", "read"), of(&gather, "c", "write")), (9 * 2000, 2000), "{}", layout.layout);
    }
    let [rows, split, sparse] = report.layouts.as_slice() else { panic!("three layouts") };
    // A dense grid is emptied as a whole; of a sparse one there are but the blocks around particles.
    assert_eq!(of(&named(rows, "clear"), "m", "write"), 48 * 48);
    assert!(of(&named(sparse, "update_grid"), "m", "read") < 48 * 48);
    // `update_grid` reads and writes all of a node: of use is all of a line in both; `x` and `v` alone are in rows of their own in the second.
    let useful = |layout: &counts::Layout| {
        let row = named(layout, "particle_to_grid");
        row.members.iter().find(|m| m.member == "x").unwrap().useful_bytes_a_line()
    };
    assert!(useful(split) > 60.0 && useful(rows) < 20.0, "{} and {}", useful(split), useful(rows));
    let pictures = names(&heat);
    let both = ["heat-aos+row-grid.png", "heat-aos+row-grid.svg"].map(String::from);
    assert!(both.iter().all(|name| pictures.contains(name)) && pictures.len() == 12, "{pictures:?}");
    // 48 x 48 nodes of 12 bytes, of which the scatter touches those around particles.
    let map = rows.heat.iter().find(|map| map.field == "grid").unwrap();
    assert_eq!((map.lines, map.touches.len()), (48 * 48 * 12 / 64, 48 * 48 * 12 / 64));
    let svg = std::fs::read_to_string(heat.join("heat-aos+row-grid.svg")).unwrap();
    let hottest = map.touches.iter().max().unwrap();
    assert!(
        svg.contains(&format!(
            "27648 bytes; a square is a cache line of 64 bytes; the hottest was touched {hottest} times"
        )),
        "{svg}"
    );
    let again = succeeds(&[&["count", "mpm"][..], &size].concat());
    assert_eq!(again, text, "the same numbers each time");
    let detail = succeeds(&["count", "springs", "--steps", "2"]);
    assert!(detail.starts_with("springs ") && detail.contains("what 2 steps"), "{detail}");
}

#[test]
fn our_workloads_are_measured_where_taichi_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let json = folder.path().join("taichi.json");
    let python = folder.path().join("python3");
    let arguments = ["compare", "taichi", "--workloads", "launch,histogram", "--pairs", "5", "--threads", "2"];
    let places = ["--python", python.to_str().unwrap(), "--json", json.to_str().unwrap()];
    let output = allotrope(&[&arguments[..], &places].concat());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{told}");
    assert!(told.starts_with(&format!("`{}` cannot be run: ", python.display())), "{told}");
    assert!(told.contains("pip install taichi==1.7.4"), "{told}");
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(table.contains("no Taichi; medians of 5 pairs"), "{table}");
    let report: Comparison = serde_json::from_str(&std::fs::read_to_string(json).unwrap()).unwrap();
    assert_eq!((report.threads, report.pairs), (2, 5));
    let names: Vec<&str> = report.rows.iter().map(|row| &*row.workload).collect();
    assert_eq!(names, ["launch", "histogram"]);
    assert!(report.rows.iter().all(|row| row.ours_ms > 0.0 && row.taichi_ms.is_none() && row.ratio.is_none()));
    assert!(report.rows[1].bandwidth_fraction.is_some_and(|fraction| fraction > 0.0));
    assert_eq!(report.mean_ratio(), None);
}

#[test]
fn a_bench_of_many_particles_sorts_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bench.json");
    let json = path.to_str().unwrap();
    succeeds(&[
        "bench",
        "mpm",
        "--layouts",
        "soa+soa",
        "--particles",
        "70000",
        "--grid",
        "256",
        "--steps",
        "2",
        "--json",
        json,
    ]);
    let report: Report = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    assert!(report.rows[0].kernels.0.iter().any(|(name, _)| name == "sort"));
}

/// A run of a moment into a folder.
fn moment<'a>(out: &'a Path, more: &[&'a str]) -> Vec<&'a str> {
    let small = ["run", "mpm", "--particles", "500", "--grid", "32", "--steps", "9", "--every", "4", "--out"];
    [&small[..], &[out.to_str().unwrap()], more].concat()
}

#[test]
fn run_makes_what_is_asked_for_of_its_frames() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let text = succeeds(&moment(&out, &["--gif", "--no-sheet", "--export", "vtk,ply,npz"]));
    let last = format!("4 pictures in {} with animation.gif, particles.pvd, grid.pvd\n", out.display());
    assert!(text.ends_with(&last), "{text}");
    let mut wanted = vec!["animation.gif".to_string(), "grid.pvd".into(), "particles.pvd".into()];
    for frame in 0..4 {
        wanted.push(format!("frame_{frame:04}.png"));
        wanted.push(format!("grid_{frame:04}.vti"));
        wanted.extend(["npz", "ply", "vtp"].map(|ending| format!("particles_{frame:04}.{ending}")));
    }
    wanted.sort();
    assert_eq!(names(&out), wanted);
    // The last frame comes after the last step, though it is out of turn.
    let series = std::fs::read_to_string(out.join("particles.pvd")).unwrap();
    let step = 2e-4 * 128.0 / 32.0;
    for (frame, steps) in [0, 4, 8, 9].into_iter().enumerate() {
        let line = series.lines().find(|line| line.contains(&format!("particles_{frame:04}.vtp"))).unwrap();
        let time: f64 = line.split("timestep=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
        assert!((time - f64::from(steps) * step).abs() < 1e-12, "{line}");
    }
    let film = std::fs::File::open(out.join("animation.gif")).unwrap();
    let film = image::codecs::gif::GifDecoder::new(std::io::BufReader::new(film)).unwrap();
    assert_eq!(image::AnimationDecoder::into_frames(film).count(), 4);

    let none = folder.path().join("none");
    let text = succeeds(&["run", "mpm", "--steps", "2", "--frames", "0", "--out", none.to_str().unwrap()]);
    assert!(text.contains("2 steps (to 0.000 s simulated)") && !text.contains("picture in"), "{text}");
    assert!(names(&none).is_empty());
}

#[test]
fn progress_is_told_as_it_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let text = succeeds(&moment(&out, &["--progress", "json"]));
    let events: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let names: Vec<_> = events.iter().map(|event| event["event"].as_str().unwrap()).collect();
    assert_eq!(names, ["start", "frame", "frame", "frame", "frame", "end"]);
    assert_eq!((&events[0]["particles"], &events[0]["seeds"][0]), (&500.into(), &88.into()));
    assert_eq!(
        (&events[2]["number"], &events[2]["step"], events[2]["file"].as_str()),
        (&1.into(), &4.into(), out.join("frame_0001.png").to_str())
    );
    assert_eq!((&events[5]["reason"], &events[5]["frames"]), (&"finished".into(), &4.into()));

    let text = succeeds(&moment(&out, &["--progress", "none"]));
    assert!(text.lines().count() == 2 && text.lines().next().unwrap().ends_with(", seed 88"), "{text}");
    assert_eq!(succeeds(&moment(&out, &["--progress", "plain"])).lines().count(), 6);
    for quiet in [&["--quiet"][..], &["--quiet", "--progress", "json"], &["--quiet", "--mp4"]] {
        let output = allotrope(&moment(&out, quiet));
        assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{quiet:?}");
    }
}

/// Of colours and cursors, where nobody sees them.
#[test]
fn no_escapes_are_written_into_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let run = moment(&out, &["--progress", "bar"]);
    for arguments in [&run[..], &["--help"], &["run", "--help"], &["rnu"], &["list"], &["scene", "show", "mpm88"]] {
        let output = allotrope(arguments);
        assert!(!output.stdout.contains(&0x1b) && !output.stderr.contains(&0x1b), "{arguments:?}");
        assert!(!output.stdout.is_empty() || !output.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn map_draws_layouts() {
    let record = "v: Vec2, m: f32";
    let printed = succeeds(&["map", record, "Blocked<4>", "--shape", "10,12"]);
    assert!(printed.starts_with("<svg ") && printed.ends_with("</svg>\n"), "{printed}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.svg");
    let file = path.to_str().unwrap();
    let text = succeeds(&["map", record, "Blocked<4>", "--shape", "10,12", "--out", file]);
    let about = "27 lines, 1,728 bytes, of which 83.3 % hold elements";
    assert_eq!(
        text,
        format!("Blocked<4> = dense(ij).dense(ij, 4).aos, 10 x 12 elements: {about}\nwritten to {file}\n")
    );
    assert_eq!(std::fs::read_to_string(&path).unwrap(), printed);
    assert!(printed.contains(about) && printed.contains(">v: Vec2, 8 bytes<"), "{printed}");

    // What is wrong leaves what was there.
    let message = refused(&["map", record, "Bocked<4>", "--out", file]);
    assert!(message.ends_with("there is no layout `Bocked`; did you mean `Blocked`?"), "{message}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), printed);

    let active = ["--shape", "8,8", "--active", "-4..4,-4..4"];
    let text = succeeds(&[&["map", "f32", "hash(ij).dense(ij, 4).soa", "--out", file][..], &active].concat());
    assert!(text.contains(" elements: 4 lines, 256 bytes in 4 allocated blocks\n"), "{text}");

    let page = folder.path().join("page.html");
    let layouts = ["map", record, "Aos", "Soa", "Sparse<4>", "--shape", "10,12", "--active", "0,0"];
    let text = succeeds(&[&layouts[..], &["--html", page.to_str().unwrap()]].concat());
    assert!(text.lines().count() == 4 && text.contains("in 1 allocated block\n"), "{text}");
    let html = std::fs::read_to_string(&page).unwrap();
    assert_eq!((html.matches("<svg ").count(), html.matches("<figure").count()), (3, 3));
    // Nothing is fetched.
    let fetched = html.replace("http://www.w3.org/2000/svg", "");
    assert!(!fetched.contains("http") && !fetched.contains("src=") && !fetched.contains("<script"), "{html}");
}

#[test]
fn what_the_help_of_map_shows_can_be_done() {
    let folder = tempfile::tempdir().unwrap();
    let help = succeeds(&["map", "--help"]);
    let mut drawn = 0;
    for line in help.lines().filter_map(|line| line.strip_prefix("  allotrope ")) {
        // Every second piece stands in quotes.
        let pieces = line.split('\'').enumerate();
        let words =
            pieces.flat_map(|(n, piece)| if n % 2 == 0 { piece.split_whitespace().collect() } else { vec![piece] });
        let words: Vec<&str> = words.collect();
        let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
        let output = command.args(&words).current_dir(folder.path()).output().unwrap();
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        let picture = std::fs::read_to_string(folder.path().join(words[words.len() - 1])).unwrap();
        assert!(picture.contains("<svg ") && picture.contains("fill=\"#56b4e9\""), "{line}");
        drawn += 1;
    }
    assert!(drawn >= 8, "{help}");
}

#[test]
fn scenes_are_shown_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeeds(&["scene", "show", "mpm88"]);
    assert_eq!(succeeds(&["scene", "show", "mpm88", "--solver", "mpm"]), text);
    let path = folder.path().join("my.toml");
    std::fs::write(&path, &text).unwrap();
    let file = path.to_str().unwrap();
    let line = succeeds(&["scene", "check", file, file]);
    let about = format!("{file}: 2D, 8192 particles of fluid, 128 x 128 nodes, ");
    assert!(line.lines().count() == 2 && line.lines().all(|line| line.starts_with(&about)), "{line}");
    assert!(line.contains("MiB, dt 2e-4 of at most 2.67e-4, in aos+row, soa+soa, aosoa16+blocked4, "), "{line}");
    // All that are wrong are told, and what is right is told too.
    let output = allotrope(&["scene", "check", "a.toml", file, "b.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stdout).unwrap().starts_with(&about));
    let errors = String::from_utf8(output.stderr).unwrap();
    let names: Vec<_> =
        errors.lines().map(|line| line.starts_with("error: scene `") && line.contains(".toml")).collect();
    assert_eq!(names, [true, true], "{errors}");
}

#[test]
fn completions_are_there_for_all_shells() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = succeeds(&["completions", shell]);
        assert!(script.contains("allotrope") && script.contains("checkpoint-every"), "{shell}");
    }
}

#[test]
fn a_run_goes_on_without_a_film_where_ffmpeg_is_not_installed() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    let output = command.args(moment(&out, &["--mp4"])).env("PATH", folder.path()).output().unwrap();
    let note = "note: `ffmpeg` is not installed, and so there is no `animation.mp4`; `--gif` needs no other program\n";
    assert_eq!((output.status.code(), String::from_utf8(output.stderr).unwrap().as_str()), (Some(0), note));
    assert!(names(&out).contains(&"sheet.png".to_string()));
}

#[test]
fn checks_of_scenes_pass_fail_and_are_missing() {
    let text = succeeds(&["run", "mpm", "--scene", "disks", "--check", "--layout", "hot+row"]);
    let rows = text.lines().filter(|line| line.contains("ok") && line.contains("Sulsky")).count();
    assert!(rows == 9 && text.contains("measured") && text.contains("expected") && text.contains("source"), "{text}");

    // Lighter disks have less energy.
    let output = allotrope(&["run", "mpm", "--scene", "disks", "--check", "--set", "material.density=900.0"]);
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("checks failed; the first: kinetic energy at the start in J is 2.28"), "{message}");

    let message = refused(&["run", "mpm", "--scene", "three-materials", "--check"]);
    assert!(
        message.starts_with("scene `three-materials` has no check; those that have one are `mpm88`, "),
        "{message}"
    );
}

#[test]
fn a_layout_that_makes_no_sense_is_refused_with_the_reason() {
    let message = refused(&["run", "mpm", "--layout", "hot+row"]);
    assert!(message.contains("every member of a fluid's particles is used by both transfers"), "{message}");
    let flip = ["run", "mpm", "--scene", "disks", "--set", "transfer.scheme=\"flip\"", "--layout", "hot+row"];
    if !cfg!(feature = "all-layouts") {
        let message = refused(&flip);
        assert!(message.contains("build with `--features all-layouts`; those that fit are `aos+row`"), "{message}");
    }
    let text = succeeds(&["bench", "mpm", "--scene", "disks", "--steps", "22", "--threads", "2"]);
    assert!(text.contains("hot+row") && text.contains("material"), "{text}");
}
