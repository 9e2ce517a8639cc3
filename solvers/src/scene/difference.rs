//! In what two scenes differ.

use toml::{Table, Value};

use super::keys::short;

/// Keys that change nothing of what is simulated.
const WITHOUT_EFFECT: &[&str] = &["about", "camera", "steps"];

/// The first key, in alphabetical order, whose value differs between two texts in TOML, with both values; without those
/// that have no effect on what is simulated.
pub(super) fn first(here: &str, there: &str) -> Option<String> {
    let (Ok(mut here), Ok(mut there)) = (here.parse::<Table>(), there.parse::<Table>()) else {
        return (here != there).then(|| "one of them is not TOML".into());
    };
    for key in WITHOUT_EFFECT {
        here.remove(*key);
        there.remove(*key);
    }
    of_tables("", &here, &there)
}

fn of_tables(prefix: &str, here: &Table, there: &Table) -> Option<String> {
    let mut keys: Vec<_> = here.keys().chain(there.keys()).collect();
    keys.sort_unstable();
    keys.dedup();
    keys.into_iter().find_map(|key| of_values(&format!("{prefix}{key}"), here.get(key), there.get(key)))
}

fn of_values(path: &str, here: Option<&Value>, there: Option<&Value>) -> Option<String> {
    match (here, there) {
        (Some(Value::Table(here)), Some(Value::Table(there))) => of_tables(&format!("{path}."), here, there),
        (Some(Value::Array(a)), Some(Value::Array(b))) if a.iter().chain(b).any(Value::is_table) => {
            (0..a.len().max(b.len())).find_map(|n| of_values(&format!("{path}[{n}]"), a.get(n), b.get(n)))
        }
        (here, there) if equal(here, there) => None,
        (here, there) => {
            let value = |value: Option<&Value>| value.map_or("not given".into(), short);
            Some(format!("`{path}` is {} here and {} there", value(here), value(there)))
        }
    }
}

/// Whether two values are the same; a whole number is the same as it is with a decimal point.
fn equal(here: Option<&Value>, there: Option<&Value>) -> bool {
    match (here, there) {
        (Some(Value::Array(a)), Some(Value::Array(b))) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| equal(Some(a), Some(b)))
        }
        (Some(Value::Integer(n)), Some(Value::Float(x))) | (Some(Value::Float(x)), Some(Value::Integer(n))) => {
            *n as f64 == *x
        }
        (here, there) => here == there,
    }
}
