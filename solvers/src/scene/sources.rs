//! Puts a scene's table together: the files that it includes, its own text, and what the command line overrides.

use toml::{Table, Value};

use super::keys::kind;
use super::{Folder, SceneError};

/// More files than this, one including the next, are taken for a mistake.
const DEEPEST: usize = 32;

/// A scene's table, and where each part of it comes from.
pub(super) struct Sources {
    pub(super) table: Table,
    /// Included files, each after those that it includes itself, by their names in messages.
    included: Vec<(String, Table)>,
    /// The scene's own text.
    own: Table,
    overrides: Vec<Override>,
}

/// A value that replaces another.
struct Override {
    text: String,
    path: Vec<String>,
    value: Value,
}

impl Sources {
    /// Reads the text of the file named `file` and what it includes, and applies the overrides.
    pub(super) fn read(text: &str, file: &str, folder: &Folder, overrides: &[String]) -> Result<Self, SceneError> {
        let mut own = table_of(text, file)?;
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        // Built-in scenes go by their names, and are included by their files'.
        let name = if matches!(folder, Folder::BuiltIn) { format!("{name}.toml") } else { name.into() };
        let mut sources = Self { table: Table::new(), included: Vec::new(), own: Table::new(), overrides: Vec::new() };
        let included = own.remove("include");
        sources.include(included, file, &mut vec![name], folder)?;
        merge(&mut sources.table, &own);
        sources.own = own;
        for text in overrides {
            let parsed = Override::parse(text).map_err(|fault| overridden(file, text, &fault))?;
            apply(&mut sources.table, &parsed).map_err(|fault| overridden(file, text, &fault))?;
            sources.overrides.push(parsed);
        }
        Ok(sources)
    }

    /// Merges the files that the last of `chain` includes; `file` is its name in messages.
    fn include(
        &mut self,
        included: Option<Value>,
        file: &str,
        chain: &mut Vec<String>,
        folder: &Folder,
    ) -> Result<(), SceneError> {
        let Some(value) = included else { return Ok(()) };
        let fault =
            |message: String| SceneError::at(file, format!("include = {}", super::keys::short(&value)), message);
        for name in names(&value).map_err(&fault)? {
            let name = beside(chain.last().map_or("", String::as_str), name);
            if chain.contains(&name) || chain.len() > DEEPEST {
                return Err(fault(format!("goes round in a circle: `{}`, `{name}`", chain.join("`, `"))));
            }
            let bytes = folder.read(&name).map_err(|why| fault(format!("needs `{name}`, which {why}")))?;
            let Ok(text) = String::from_utf8(bytes) else {
                return Err(fault(format!("needs `{name}`, which is not a text in UTF-8")));
            };
            let label = folder.label(&name);
            let mut table = table_of(&text, &label)?;
            let further = table.remove("include");
            find_files_from(&mut table, &name);
            chain.push(name);
            self.include(further, &label, chain, folder)?;
            chain.pop();
            merge(&mut self.table, &table);
            self.included.push((label, table));
        }
        Ok(())
    }

    /// Adds to a fault where the faulty value comes from, if that is not the scene's own text.
    pub(super) fn with_origin(&self, error: SceneError) -> SceneError {
        let path = error.path();
        if path.is_empty() {
            return error;
        }
        let touches = |other: &Override| other.path.iter().zip(&path).all(|(a, b)| a == b);
        if let Some(last) = self.overrides.iter().rev().find(|other| touches(other)) {
            return error.with_note(&format!("from the override `{}`", last.text));
        }
        let holds = |table: &Table| {
            let mut path = path.iter();
            let first = path.next().and_then(|key| table.get(key));
            path.try_fold(first, |value, key| Some(Some(child(value?, key)?))).flatten().is_some()
        };
        match self.included.iter().rev().find(|(_, table)| holds(table)) {
            Some((label, _)) if !holds(&self.own) => error.with_note(&format!("from `{label}`")),
            _ => error,
        }
    }
}

/// The table that a text in TOML is.
pub(super) fn table_of(text: &str, file: &str) -> Result<Table, SceneError> {
    text.parse().map_err(|error: toml::de::Error| {
        let before = error.span().and_then(|span| text.get(..span.start)).unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
        SceneError::new(file, format!("line {line} is not TOML: {message}"))
    })
}

/// The files that the value of `include` names.
fn names(value: &Value) -> Result<Vec<&str>, String> {
    let wanted = "where the name of a file or a list of names is wanted";
    let name = |value: &'_ Value| format!("is {}, {wanted}", kind(value));
    match value {
        Value::String(text) => Ok(vec![text]),
        Value::Array(items) => {
            items.iter().map(|item| item.as_str().ok_or_else(|| format!("holds {}, {wanted}", kind(item)))).collect()
        }
        other => Err(name(other)),
    }
}

/// The path of a file that is named in the file `from`, beside which it stands.
fn beside(from: &str, name: &str) -> String {
    if name.starts_with('/') || std::path::Path::new(name).is_absolute() {
        return name.into();
    }
    let mut parts: Vec<&str> = from.split('/').collect();
    parts.pop();
    for part in name.split('/') {
        match (part, parts.last()) {
            ("." | "", _) => {}
            ("..", Some(last)) if *last != ".." && !last.is_empty() => _ = parts.pop(),
            _ => parts.push(part),
        }
    }
    parts.join("/")
}

/// Changes the files that an included table names, which stand beside it, to where they stand from the scene.
fn find_files_from(table: &mut Table, from: &str) {
    for key in ["body", "collider"] {
        let items = table.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten();
        for value in items.filter_map(|item| item.as_table_mut()?.get_mut("file")) {
            if let Value::String(name) = value {
                *name = beside(from, name);
            }
        }
    }
}

/// Puts a table over another: tables are merged, other values replaced.
fn merge(under: &mut Table, over: &Table) {
    for (key, value) in over {
        match (under.get_mut(key), value) {
            (Some(Value::Table(under)), Value::Table(over)) => merge(under, over),
            _ => _ = under.insert(key.clone(), value.clone()),
        }
    }
}

fn overridden(file: &str, text: &str, fault: &str) -> SceneError {
    SceneError::new(file, format!("the override `{text}` {fault}"))
}

impl Override {
    fn parse(text: &str) -> Result<Self, String> {
        let Some((path, value)) = text.split_once('=') else {
            return Err("is not `key=value`; write, for example, `dt=1e-4`".into());
        };
        let path: Vec<String> = path.trim().split('.').map(|key| key.trim().to_string()).collect();
        if path.iter().any(String::is_empty) {
            return Err("has an empty key before its `=`; write, for example, `body.0.velocity=[1, 0]`".into());
        }
        if path[0] == "include" {
            return Err("comes too late, since files are included first; write it into the scene".into());
        }
        Ok(Self { text: text.into(), path, value: value_of(value.trim())? })
    }
}

/// A value in TOML, or a bare word as a text.
fn value_of(text: &str) -> Result<Value, String> {
    let parsed = format!("value = {text}\n").parse::<Table>();
    match parsed
        .ok()
        .filter(|table| table.len() == 1 && !text.contains('\n'))
        .and_then(|mut table| table.remove("value"))
    {
        Some(value) => Ok(value),
        None if text.is_empty() => Err("has no value after its `=`".into()),
        None if text.contains(['"', '\'', '[', ']', '{', '}', ',', '=', '#', '\n']) => {
            Err("has a value that is not TOML".into())
        }
        None => Ok(Value::String(text.into())),
    }
}

/// Replaces a value, and makes the tables that are missing above it.
fn apply(table: &mut Table, by: &Override) -> Result<(), String> {
    let Some((last, above)) = by.path.split_last() else { return Ok(()) };
    let Some((first, further)) = above.split_first() else {
        table.insert(last.clone(), by.value.clone());
        return Ok(());
    };
    let mut place = table.entry(first).or_insert_with(|| Table::new().into());
    let mut name = first.clone();
    for key in further {
        place = enter(place, &name, key)?;
        name = format!("{name}.{key}");
    }
    *enter(place, &name, last)? = by.value.clone();
    Ok(())
}

/// What lies under a key of a table, made if it is missing, or under a number of a list.
fn enter<'a>(value: &'a mut Value, name: &str, key: &str) -> Result<&'a mut Value, String> {
    match value {
        Value::Table(table) => Ok(table.entry(key).or_insert_with(|| Table::new().into())),
        Value::Array(items) => {
            let count = items.len();
            key.parse::<usize>().ok().and_then(|n| items.get_mut(n)).ok_or_else(|| {
                format!("names no element of `{name}`, a list of {count}; they are counted from 0, as in `{name}.0`")
            })
        }
        other => Err(format!("goes into `{name}`, which is {}", kind(other))),
    }
}

/// What lies under a key of a table or a number of a list.
fn child<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    match value {
        Value::Table(table) => table.get(key),
        Value::Array(items) => items.get(key.parse::<usize>().ok()?),
        _ => None,
    }
}
