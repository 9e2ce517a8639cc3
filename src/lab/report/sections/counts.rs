//! Counts that were made elsewhere, of accesses or of what caches miss, where there are some: any JSON.

use serde_json::Value;

use super::super::html::Table;
use super::{Findings, Html, Section};
use crate::lab::errors::LabError;

pub(super) fn section(findings: &Findings) -> Result<Option<Section>, LabError> {
    let Some(counts) = &findings.counts else { return Ok(None) };
    Ok(Some(Section { id: "counts", title: "Counts", body: shown(Html::default(), "counts", counts) }))
}

/// A value with what is in it: lists of objects as tables, objects as names with their values.
fn shown(mut html: Html, name: &str, value: &Value) -> Html {
    match value {
        Value::Array(values) if values.iter().any(is_deep) => {
            values.iter().fold(html, |html, value| shown(html.heading(&headline(name, value)), name, value))
        }
        Value::Array(values) if values.iter().any(Value::is_object) => html.table(&table(name, values)),
        Value::Array(values) => html.list(&values.iter().map(plain).collect::<Vec<_>>()),
        Value::Object(values) => {
            let (deep, flat): (Vec<_>, Vec<_>) =
                values.iter().partition(|(_, value)| value.is_object() || value.is_array());
            if !flat.is_empty() {
                html =
                    html.terms(&flat.into_iter().map(|(name, value)| (words(name), plain(value))).collect::<Vec<_>>());
            }
            for (name, value) in deep {
                html = shown(html.heading(&words(name)), name, value);
            }
            html
        }
        value => html.paragraph(&plain(value)),
    }
}

/// Whether an object holds more than fits into a row of a table: other objects.
fn is_deep(value: &Value) -> bool {
    let inner =
        |value: &Value| value.is_object() || value.as_array().is_some_and(|all| all.iter().any(Value::is_object));
    value.as_object().is_some_and(|object| object.values().any(inner))
}

/// What an object of a list is: its first word, `layout aos`.
fn headline(name: &str, value: &Value) -> String {
    let first = value.as_object().and_then(|object| object.iter().find(|(_, value)| value.is_string()));
    first.map_or(words(name), |(key, value)| format!("{} `{}`", words(key), plain(value)))
}

/// A table of objects, whose columns are all keys that one of them has: words first.
fn table(name: &str, values: &[Value]) -> Table {
    let mut columns: Vec<&String> = Vec::new();
    for key in values.iter().filter_map(Value::as_object).flat_map(|object| object.keys()) {
        if !columns.contains(&key) {
            columns.push(key);
        }
    }
    let numbers = |key: &&String| values.iter().filter_map(|value| value.get(key.as_str())).any(Value::is_number);
    columns.sort_by_key(numbers);
    let of_words = columns.iter().filter(|key| !numbers(key)).count();
    let cell = |value: &Value, key: &str| value.get(key).map_or("\u{2013}".into(), plain);
    let rows = values.iter().map(|value| (columns.iter().map(|key| cell(value, key)).collect(), false));
    Table {
        caption: words(name),
        headline: columns.iter().map(|key| words(key)).collect(),
        words: of_words.max(1),
        rows: rows.collect(),
    }
}

/// A value in a line.
fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Null => "\u{2013}".into(),
        other => other.to_string(),
    }
}

/// A key as words.
fn words(key: &str) -> String {
    key.replace('_', " ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn any_value_is_shown() {
        let counts = json!({
            "unit": "bytes a step <all>",
            "layouts": [{"bytes_read": 12, "layout": "aos"}, {"layout": "soa", "lines": 3}],
            "notes": ["a", 1],
        });
        let html = shown(Html::default(), "counts", &counts);
        let text = html.text();
        assert!(text.contains("<dt>unit</dt><dd>bytes a step &lt;all&gt;</dd>"), "{text}");
        assert!(text.contains("<h3>layouts</h3>") && text.contains("<li>a</li>\n<li>1</li>"), "{text}");
        assert!(
            text.contains("<th scope=\"col\">layout</th><th scope=\"col\" class=\"number\">bytes read</th>"),
            "{text}"
        );
        assert!(
            text.contains("<th scope=\"row\">soa</th><td class=\"number\">\u{2013}</td><td class=\"number\">3</td>"),
            "{text}"
        );
        let deep = json!([{"layout": "aos", "loops": [{"kernel": "p2g", "count": 9}]}]);
        let deep = shown(Html::default(), "layouts", &deep);
        assert!(deep.text().contains("<h3>layout <code>aos</code></h3>") && deep.text().contains("<h3>loops</h3>"));
        assert!(deep.text().contains("<th scope=\"row\">p2g</th><td class=\"number\">9</td>"), "{deep:?}");
        assert!(shown(Html::default(), "counts", &json!(7)).text().contains("<p>7</p>"));
    }
}
