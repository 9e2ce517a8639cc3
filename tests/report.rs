//! The page of `allotrope report`: it holds all that it shows, tells what it should, and fits on any screen.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Makes a report and gives its text.
fn report(out: &Path, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_allotrope"));
    command
        .arg("report")
        .args(arguments)
        .arg("--out")
        .arg(out)
        .env_remove("ALLOTROPE_CPU")
        .env_remove("ALLOTROPE_THREADS");
    let output = command.output().unwrap();
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    let path = out.join("report.html");
    assert!(told.ends_with(&format!("written to {}\n", path.display())), "{told}");
    assert_eq!(std::fs::read_dir(out).unwrap().count(), 1, "one file");
    std::fs::read_to_string(path).unwrap()
}

/// The values of an attribute, wherever it stands.
fn values<'a>(html: &'a str, attribute: &str) -> Vec<&'a str> {
    html.split(&format!(" {attribute}=\"")).skip(1).filter_map(|rest| Some(rest.split_once('"')?.0)).collect()
}

/// Nothing is fetched from anywhere.
fn is_self_contained(html: &str) {
    assert!(!html.contains("http:") && !html.contains("https:") && !html.contains("@import"));
    let sources = [values(html, "src"), values(html, "href"), values(html, "xlink:href")].concat();
    let outside: Vec<_> =
        sources.iter().filter(|source| !source.starts_with("data:") && !source.starts_with('#')).collect();
    assert!(outside.is_empty() && !sources.is_empty(), "{outside:?}");
    let ids = values(html, "id");
    let inner = sources.iter().filter_map(|source| source.strip_prefix('#'));
    for target in inner.chain(html.split("url(#").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0))) {
        assert_eq!(ids.iter().filter(|id| **id == target).count(), 1, "one `{target}`");
    }
    assert!(html.split("url(").skip(1).all(|rest| rest.starts_with('#')));
}

/// Each element that begins ends, in its place.
fn is_well_formed(html: &str) {
    assert!(html.starts_with("<!DOCTYPE html>\n") && html.ends_with("</html>\n"));
    let (mut open, mut rest) = (Vec::new(), &html["<!DOCTYPE html>".len()..]);
    while let Some((_, tag)) = rest.split_once('<') {
        let (tag, behind) = tag.split_once('>').expect("a tag ends");
        rest = behind;
        let name = tag.trim_start_matches('/').split([' ', '\n', '/']).next().unwrap();
        assert!(
            name.bytes().all(|sign| sign.is_ascii_alphanumeric()) && tag.matches('"').count().is_multiple_of(2),
            "<{tag}>"
        );
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "</{name}>");
        } else if !tag.ends_with('/') && !["meta", "link", "img"].contains(&name) {
            open.push(name);
            // Their text is none of elements.
            if ["style", "script"].contains(&name) {
                rest = &rest[rest.find(&format!("</{name}>")).expect("it ends")..];
            }
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// The commands in the page.
fn commands(html: &str) -> Vec<String> {
    let blocks = html.split("<pre tabindex=\"0\"><code>").skip(1);
    let texts =
        blocks.filter_map(|rest| Some(rest.split_once("</code>")?.0.replace("<span>", "").replace("</span>", "")));
    texts.collect()
}

/// The numbers in the page.
fn data(html: &str) -> serde_json::Value {
    let (_, rest) = html.split_once("<script type=\"application/json\" id=\"data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// A browser that can be found.
fn browser() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome-headless-shell"];
    let path = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&path).collect();
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|file| file.is_file())
}

/// Widths in pixels of a phone and of a table's screen.
const WIDTHS: [usize; 2] = [360, 1200];

/// Put first into the page: notes what goes wrong, and tells how wide the window is, by how much the page is wider, and what that was.
const PROBE: &str = "<script>
const root = document.documentElement;
const wrong = [];
addEventListener('error', event => wrong.push(event.message || 'load of ' + event.target.tagName), true);
document.addEventListener('securitypolicyviolation', event => wrong.push(event.violatedDirective));
addEventListener('load', () => parent.postMessage(`${innerWidth} ${root.scrollWidth - root.clientWidth} ${wrong.join(' ')}`, '*'));
</script>";

/// Opens the page in frames of all widths, where there is a browser, and gives what [`PROBE`] tells.
fn opened(html: &str) -> Option<String> {
    let Some(browser) = browser() else {
        println!("there is no chromium or chrome in PATH: the page was not opened");
        return None;
    };
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    file("page.html", html.replacen("<head>", &format!("<head>{PROBE}"), 1));
    let frames: String = WIDTHS
        .iter()
        .map(|width| format!("<iframe src='page.html' width={width} height=800 frameborder=0></iframe>"))
        .collect();
    file(
        "frames.html",
        format!("<title></title><script>onmessage = event => document.title += `[${{event.data}}]`;</script>{frames}"),
    );
    let output = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--virtual-time-budget=10000",
            "--dump-dom",
        ])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .arg(folder.path().join("frames.html"))
        .output()
        .unwrap();
    let dom = String::from_utf8_lossy(&output.stdout);
    let title = dom.split_once("<title>").and_then(|(_, rest)| Some(rest.split_once("</title>")?.0));
    Some(title.unwrap_or_else(|| panic!("{}", String::from_utf8_lossy(&output.stderr))).to_string())
}

/// The page is no wider than any screen, and nothing goes wrong in it.
fn fits_on_screens(html: &str) {
    let Some(told) = opened(html) else { return };
    for width in WIDTHS {
        assert!(told.contains(&format!("[{width} 0 ]")), "{told}");
    }
}

#[test]
fn what_does_not_fit_or_is_fetched_is_found() {
    let page = "<!DOCTYPE html><html><head></head><body><div style='width: 500px'>wide</div><img src='none.png'></body></html>";
    let Some(told) = opened(page) else { return };
    assert!(told.contains("[1200 0 load of IMG]") && told.contains("[360 ") && !told.contains("[360 0 "), "{told}");
}

/// What all pages have, with some layouts of a solver.
fn check(html: &str, solver: &str, layouts: &[&str]) {
    is_self_contained(html);
    is_well_formed(html);
    for layout in layouts {
        // In the table, among the bars and below the maps.
        assert!(html.matches(&format!("<code>{layout}</code>")).count() >= 4, "{layout}");
    }
    let commands = commands(html);
    for command in ["bench", "run", "search", "report"] {
        let start = format!("allotrope {command} {solver} ");
        assert!(commands.iter().any(|line| line.starts_with(&start)), "{command}: {commands:?}");
    }
    for id in ["choice", "scene", "ranking", "kernels", "maps", "hardware", "method"] {
        assert!(html.contains(&format!("<section id=\"{id}\"")) && html.contains(&format!("href=\"#{id}\"")), "{id}");
    }
    assert_eq!(html.matches("src=\"data:image/png;base64,iVBORw0KGgo").count(), 2, "pictures of both ends");
    assert!(html.contains(" UTC</dd>") && html.contains("Instruction set") && html.contains("Threads"));
    // All repetitions of all rows, and rows of the table from the fastest on.
    let data = data(html);
    let rows = data["report"]["rows"].as_array().unwrap();
    assert_eq!(rows.len(), layouts.len());
    let samples = data["samples_ms"].as_array().unwrap();
    assert!(samples.len() == rows.len() && samples.iter().all(|row| row.as_array().unwrap().len() == 11));
    let ranking = html.split_once("<section id=\"ranking\"").unwrap().1;
    let ranking = ranking.split_once("<tbody>").unwrap().1.split_once("</tbody>").unwrap().0;
    let ratios = ranking.split("<tr").skip(1).map(|row| row.split("<td class=\"number\">").nth(2).unwrap());
    let ratios: Vec<f64> = ratios.map(|cell| cell.split('<').next().unwrap().parse().unwrap()).collect();
    assert!(ratios.len() == layouts.len() && ratios[0] == 1.0 && ratios.is_sorted(), "{ratios:?}");
    fits_on_screens(html);
}

#[test]
fn a_page_about_a_fluid_on_a_grid() {
    let folder = tempfile::tempdir().unwrap();
    let counts = folder.path().join("counts.json");
    let member = r#"{"field":"grid","member":"m","access":"read","index":"own","count":1234567,"bytes":4938268,"lines":77161,"useful_bytes":4938268,"misses":[77161,5]}"#;
    let row = format!(r#"{{"kernel":"update_grid","number":0,"launches":1,"shared_lines":0,"members":[{member}]}}"#);
    let heat = r#"{"field":"grid","lines":5,"together":1,"touches":[0,1,20,300,1]}"#;
    let layouts = format!(r#"[{{"layout":"aos+row","bytes":1048576,"loops":[{row}],"heat":[{heat}]}}]"#);
    let report_of = |scene: &str| {
        format!(
            r#"{{"solver":"mpm","scene":"{scene}","steps":1,"line":64,"caches":[[32768,8],[2097152,16]],"layouts":{layouts}}}"#
        )
    };
    std::fs::write(&counts, report_of("mpm88")).unwrap();
    let size = ["mpm", "--particles", "2000", "--grid", "64", "--threads", "2", "--steps", "11"];
    let bunny = folder.path().join("bunny.json");
    std::fs::write(&bunny, report_of("bunny")).unwrap();
    let refused = Command::new(env!("CARGO_BIN_EXE_allotrope"))
        .args(["report", "mpm", "--counts", bunny.to_str().unwrap()])
        .output()
        .unwrap();
    let message = String::from_utf8(refused.stderr).unwrap();
    assert!(
        refused.status.code() == Some(2) && message.ends_with(" has counts of mpm bunny, not of mpm mpm88\n"),
        "{message}"
    );
    let more = ["--layouts", "aos+row,soa+soa,aosoa16+blocked4,aos+hash4", "--sweep", "--budget", "0.1", "--counts"];
    let html = report(&folder.path().join("out"), &[&size[..], &more, &[counts.to_str().unwrap()]].concat());
    check(&html, "mpm", &["aos+row", "soa+soa", "aosoa16+blocked4", "aos+hash4"]);
    let commands = commands(&html);
    let wanted = "allotrope bench mpm --particles 2000 --grid 64 --layouts aos+row,soa+soa,aosoa16+blocked4,aos+hash4 --schedules auto \
                  --threads 2 --steps 11";
    assert!(commands.iter().any(|line| line == wanted), "{commands:?}");
    let sweep = commands.iter().find(|line| line.contains(" --sweep size ")).expect("the sweep's command");
    assert!(sweep.ends_with(" --sweep size --points 125,500,2000,8000 --out sizes"), "{sweep}");
    assert!(html.contains("<section id=\"sizes\""));
    // Commands do what is said of them; searches take a minute.
    let counted = |line: &str| !line.contains(" count ") || allotrope::probe::AVAILABLE;
    for line in commands.iter().filter(|line| !line.contains(" search ") && !line.contains('\'') && counted(line)) {
        let words = line.split(' ').skip(1);
        let output =
            Command::new(env!("CARGO_BIN_EXE_allotrope")).args(words).current_dir(folder.path()).output().unwrap();
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
    }
    assert!(folder.path().join("sizes/sweep.svg").is_file());
    let picture = std::fs::read(folder.path().join("allotrope-out/frame_0001.png")).unwrap();
    let shown = image::load_from_memory(&picture).unwrap();
    assert!(html.contains(&format!("<img width=\"{}\" height=\"{}\"", shown.width(), shown.height())));
    assert!(html.contains("<section id=\"counts\"") && html.contains("1234567"));
    // Layouts that share a field share its map.
    assert!(html.contains("in <code>aos+row</code> and <code>aos+hash4</code><"), "particles lie alike");
    let maps = html.split_once("<section id=\"maps\"").unwrap().1.split_once("</section>").unwrap().0;
    assert_eq!(maps.matches("<figure><figcaption>in ").count(), 3 + 4);
    let heat = html.split_once("data-heat=\"grid\"").unwrap().1.split_once("</section>").unwrap().0;
    assert!(heat.contains("in <code>aos+row</code>") && heat.contains("the hottest was touched 300 times"), "{heat}");
    // What the processor counted, or why it did not.
    let counted = html.split_once("<section id=\"hardware\"").unwrap().1.split_once("</section>").unwrap().0;
    assert!(counted.contains("page faults"), "{counted}");
}

#[test]
fn a_page_about_smoothed_particles() {
    let folder = tempfile::tempdir().unwrap();
    let html = report(&folder.path().join("out"), &["wcsph", "--scene", "hydrostatic", "--steps", "11"]);
    let solver = allotrope_solvers::solver("wcsph").unwrap();
    let layouts: Vec<&str> = solver.layouts.iter().map(|layout| layout.name).collect();
    check(&html, "wcsph", &layouts);
    assert!(!html.contains("<section id=\"counts\"") && !html.contains("<section id=\"sizes\""));
    assert!(html.contains("data-field=\"neighbours\""));
}

#[test]
fn a_page_about_masses_and_springs() {
    let folder = tempfile::tempdir().unwrap();
    let html = report(&folder.path().join("out"), &["springs", "--steps", "11"]);
    assert!(html.contains("data-field=\"masses\"") && html.contains("data-field=\"lists of springs\""));
    is_well_formed(&html);
    is_self_contained(&html);
    // Their number is the scene's own.
    let out = folder.path().join("sizes");
    let arguments = ["report", "springs", "--steps", "11", "--sweep", "--out", out.to_str().unwrap()];
    let output = Command::new(env!("CARGO_BIN_EXE_allotrope")).args(arguments).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && message.lines().count() == 1, "{message}");
    assert!(message.contains("has as many particles as its scenes tell"), "{message}");
}
