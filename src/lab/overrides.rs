//! Values of a scene's TOML that are set on the command line, and in what two scenes differ.

use toml::{Table, Value};

use super::errors::LabError;

/// The text of a scene with other values, each given as `key=value`, where the key may lead into tables and lists
/// (`body.0.velocity=[0, 1]`). What is no TOML is left as it is, for the reader of scenes to refuse.
///
/// # Errors
/// If one is not of this form, or leads into what is neither a table nor a list.
pub fn merged(text: &str, set: &[String]) -> Result<String, LabError> {
    let Ok(mut table) = text.parse::<Table>() else { return Ok(text.to_string()) };
    if set.is_empty() {
        return Ok(text.to_string());
    }
    for one in set {
        let fault = |why: &str| LabError::usage(format!("`--set {one}` {why}"));
        let (path, value) = one
            .split_once('=')
            .map(|(path, value)| (path.trim(), value.trim()))
            .filter(|(path, value)| !path.split('.').any(str::is_empty) && !value.is_empty())
            .ok_or_else(|| fault("is not of the form `KEY=VALUE`, such as `dt=1e-4`"))?;
        let (above, key) = path.rsplit_once('.').map_or((None, path), |(above, key)| (Some(above), key));
        let mut place = &mut table;
        let mut steps = above.into_iter().flat_map(|above| above.split('.'));
        while let Some(step) = steps.next() {
            let next = place.entry(step).or_insert_with(|| Value::Table(Table::new()));
            place = match next {
                Value::Table(table) => table,
                Value::Array(list) => {
                    let count = list.len();
                    let item = steps.next().and_then(|n| list.get_mut(n.parse::<usize>().ok()?));
                    let item = item.and_then(Value::as_table_mut);
                    item.ok_or_else(|| {
                        fault(&format!("leads into the list `{step}` of {count} tables, which are counted from 0"))
                    })?
                }
                _ => return Err(fault(&format!("leads into `{step}`, which is a value"))),
            };
        }
        place.insert(key.to_string(), value_of(value));
    }
    toml::to_string(&table).map_err(|error| LabError::failure(format!("a scene cannot be written as TOML: {error}")))
}

/// A value of TOML; what is none is a text without its quotes, as shells take them away.
fn value_of(text: &str) -> Value {
    let read = format!("value = {text}").parse::<Table>().ok().filter(|table| table.len() == 1);
    read.and_then(|mut table| table.remove("value")).unwrap_or_else(|| Value::String(text.to_string()))
}

/// The first key in which two scenes differ, with both values. Comments and the order of keys are no difference.
pub fn difference(there: &str, here: &str) -> Option<String> {
    match (there.parse::<Table>(), here.parse::<Table>()) {
        (Ok(there), Ok(here)) => differing(&Value::Table(there), &Value::Table(here), ""),
        _ => (there != here).then(|| "one of the two is not TOML".to_string()),
    }
}

fn differing(there: &Value, here: &Value, path: &str) -> Option<String> {
    let below = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    let one_sided = |key: &str, there: Option<&Value>, here: Option<&Value>| match (there, here) {
        (Some(there), Some(here)) => differing(there, here, &below(key)),
        (None, None) => None,
        _ => {
            let told = |value: Option<&Value>| value.map_or("not set".to_string(), short);
            Some(format!("`{}` is {} there and {} here", below(key), told(there), told(here)))
        }
    };
    match (there, here) {
        (Value::Table(there), Value::Table(here)) => {
            let mut keys: Vec<&String> = there.keys().chain(here.keys()).collect();
            keys.sort();
            keys.into_iter().find_map(|key| one_sided(key, there.get(key), here.get(key)))
        }
        (Value::Array(there), Value::Array(here))
            if [there, here].iter().any(|list| list.iter().any(Value::is_table)) =>
        {
            (0..there.len().max(here.len())).find_map(|n| one_sided(&n.to_string(), there.get(n), here.get(n)))
        }
        _ if same(there, here) => None,
        _ => Some(format!("`{path}` is {} there and {} here", short(there), short(here))),
    }
}

/// Whether two values mean the same: `1` and `1.0` do.
fn same(a: &Value, b: &Value) -> bool {
    let number = |value: &Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        _ => match (number(a), number(b)) {
            (Some(a), Some(b)) => a == b,
            _ => a == b,
        },
    }
}

/// A value for a message.
fn short(value: &Value) -> String {
    match value {
        Value::Table(_) => "a table".to_string(),
        Value::Float(number) if *number != 0.0 && number.abs() < 1e-2 => format!("{number:e}"),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCENE: &str = "# A scene.\ndt = 2e-4\n[material]\ndensity = 1.0\n[[body]]\nshape = \"box\"\nto = [1, 2.0]\n";

    fn set(values: &[&str]) -> Result<String, String> {
        let values: Vec<_> = values.iter().map(|value| value.to_string()).collect();
        merged(SCENE, &values).map_err(|error| error.to_string())
    }

    #[test]
    fn values_are_set_where_their_keys_lead() {
        assert_eq!(set(&[]).unwrap(), SCENE, "comments are kept where nothing is set");
        let text = set(&["dt=1e-4", "material.density = 2.5", "body.0.shape=ball", "walls.kind=\"slip\""]).unwrap();
        let table: Table = text.parse().unwrap();
        assert_eq!(table["dt"].as_float(), Some(1e-4));
        assert_eq!(table["material"]["density"].as_float(), Some(2.5));
        assert_eq!(table["body"][0]["shape"].as_str(), Some("ball"));
        assert_eq!(table["walls"]["kind"].as_str(), Some("slip"));
    }

    #[test]
    fn what_leads_nowhere_is_refused() {
        for wrong in ["dt", "=3", "dt=", "material..density=1"] {
            let wanted = format!("`--set {wrong}` is not of the form `KEY=VALUE`, such as `dt=1e-4`");
            assert_eq!(set(&[wrong]), Err(wanted));
        }
        assert_eq!(set(&["dt.x=1"]), Err("`--set dt.x=1` leads into `dt`, which is a value".into()));
        let list = "leads into the list `body` of 1 tables, which are counted from 0";
        assert_eq!(set(&["body.1.to=1"]), Err(format!("`--set body.1.to=1` {list}")));
        assert_eq!(set(&["body.shape=ball"]), Err(format!("`--set body.shape=ball` {list}")));
    }

    #[test]
    fn the_first_difference_is_told_with_both_values() {
        let with = |value: &str| difference(SCENE, &set(&[value]).unwrap());
        assert_eq!(with("dt=0.0002"), None);
        assert_eq!(with("body.0.to=[1.0, 2]"), None);
        assert_eq!(with("dt=1e-4").unwrap(), "`dt` is 2e-4 there and 1e-4 here");
        assert_eq!(with("body.0.to=[1.0, 3.0]").unwrap(), "`body.0.to` is [1, 2.0] there and [1.0, 3.0] here");
        assert_eq!(with("seed=7").unwrap(), "`seed` is not set there and 7 here");
        assert_eq!(with("walls.kind=slip").unwrap(), "`walls` is not set there and a table here");
        assert_eq!(difference("a", "b").unwrap(), "one of the two is not TOML");
    }
}
