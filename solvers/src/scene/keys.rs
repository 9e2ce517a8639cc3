//! Reads typed, checked values from a TOML table, so that every fault names the file, the key and the value.

use toml::{Table, Value};

use super::{Reorder, SceneError};
use crate::nearest::hint;

/// A table of a scene whose keys are known: what solvers read their own part from.
#[derive(Clone, Debug)]
pub struct Keys<'a> {
    file: &'a str,
    /// Where the table stands in the file: empty, or `material.`.
    prefix: String,
    table: &'a Table,
}

impl<'a> Keys<'a> {
    /// # Errors
    /// If a key is not among the known ones: the nearest of them is named.
    pub(crate) fn new(file: &'a str, prefix: String, table: &'a Table, known: &[&str]) -> Result<Self, SceneError> {
        let keys = Self { file, prefix, table };
        match table.keys().find(|key| !known.contains(&key.as_str())) {
            Some(key) => Err(keys.unknown(key, known)),
            None => Ok(keys),
        }
    }

    fn unknown(&self, key: &str, known: &[&str]) -> SceneError {
        let message = format!("is not a key of a scene{}", hint(key, known.iter().copied()));
        SceneError::at(self.file, format!("{}{key}", self.prefix), message)
    }

    /// What a choice made in this table takes: the keys of `takes`. `what` tells the choice, as in "a body of the shape
    /// `ball`".
    ///
    /// # Errors
    /// If there is a key of `others`, which other choices take, or one that is not known at all.
    pub(crate) fn only(&self, what: &str, takes: &[&str], others: &[&str]) -> Result<(), SceneError> {
        match self.table.keys().find(|key| !takes.contains(&key.as_str())) {
            Some(key) if others.contains(&key.as_str()) => {
                Err(self.fault(key, format!("is not a key of {what}, which takes `{}`", takes.join("`, `"))))
            }
            Some(key) => Err(self.unknown(key, takes)),
            None => Ok(()),
        }
    }

    /// The one of `choices` that the text of a key names, if it is there; `what` tells what they are.
    pub(crate) fn choice<T: Copy>(
        &self,
        key: &str,
        what: &str,
        choices: &[(&str, T)],
    ) -> Result<Option<T>, SceneError> {
        let Some(name) = self.text(key)? else { return Ok(None) };
        match choices.iter().find(|(known, _)| *known == name) {
            Some((_, value)) => Ok(Some(*value)),
            None => {
                let message = format!("is no {what}{}", hint(name, choices.iter().map(|(name, _)| *name)));
                Err(self.fault(key, message))
            }
        }
    }

    /// What `read` takes from a file of the scene that a key names.
    pub(crate) fn file<T>(
        &self,
        key: &str,
        example: &str,
        read: impl FnOnce(&str) -> Result<T, String>,
    ) -> Result<T, SceneError> {
        read(self.required_text(key, example)?).map_err(|fault| self.fault(key, fault))
    }

    pub(crate) fn flag(&self, key: &str) -> Result<Option<bool>, SceneError> {
        match self.table.get(key) {
            None => Ok(None),
            Some(Value::Boolean(flag)) => Ok(Some(*flag)),
            Some(other) => Err(self.fault(key, format!("is {}, where true or false is wanted", kind(other)))),
        }
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// The fault of a key's value.
    pub(crate) fn fault(&self, key: &str, message: impl Into<String>) -> SceneError {
        let key = match self.table.get(key) {
            Some(value) => format!("{}{key} = {}", self.prefix, short(value)),
            None => format!("{}{key}", self.prefix),
        };
        SceneError::at(self.file, key, message)
    }

    fn missing(&self, key: &str, example: &str) -> SceneError {
        self.fault(key, format!("is missing; write, for example, `{key} = {example}`"))
    }

    fn required<T>(&self, key: &str, example: &str, value: Option<T>) -> Result<T, SceneError> {
        value.ok_or_else(|| self.missing(key, example))
    }

    pub(crate) fn text(&self, key: &str) -> Result<Option<&'a str>, SceneError> {
        match self.table.get(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(other) => Err(self.fault(key, format!("is {}, where a text in quotes is wanted", kind(other)))),
        }
    }

    pub(crate) fn required_text(&self, key: &str, example: &str) -> Result<&'a str, SceneError> {
        let value = self.text(key)?;
        self.required(key, example, value)
    }

    /// A whole number within bounds.
    pub(crate) fn whole(&self, key: &str, least: i64, most: i64) -> Result<Option<i64>, SceneError> {
        self.table.get(key).map(|value| self.whole_value(key, value, least, most)).transpose()
    }

    fn whole_value(&self, key: &str, value: &Value, least: i64, most: i64) -> Result<i64, SceneError> {
        match value {
            Value::Integer(n) if (least..=most).contains(n) => Ok(*n),
            Value::Integer(n) => Err(self.fault(key, format!("holds {n}, which is not from {least} to {most}"))),
            other => Err(self.fault(key, format!("is {}, where a whole number is wanted", kind(other)))),
        }
    }

    /// A number of steps, or `"auto"`.
    pub(crate) fn reorder(&self, key: &str) -> Result<Option<Reorder>, SceneError> {
        match self.table.get(key) {
            Some(Value::String(text)) if text == "auto" => Ok(Some(Reorder::Decayed)),
            Some(Value::String(_)) => Err(self.fault(key, "is no number of steps, 0 for never, or \"auto\"")),
            _ => Ok(self.whole(key, 0, i64::MAX)?.map(|steps| Reorder::every(steps as u64))),
        }
    }

    /// A finite number.
    pub(crate) fn number(&self, key: &str) -> Result<Option<f64>, SceneError> {
        self.table.get(key).map(|value| self.number_value(key, value)).transpose()
    }

    fn number_value(&self, key: &str, value: &Value) -> Result<f64, SceneError> {
        let number = match value {
            Value::Integer(n) => *n as f64,
            Value::Float(x) => *x,
            other => return Err(self.fault(key, format!("is {}, where a number is wanted", kind(other)))),
        };
        if number.is_finite() { Ok(number) } else { Err(self.fault(key, "is not a finite number")) }
    }

    /// A finite number within `least` and `most`, which belong to it.
    pub(crate) fn between(&self, key: &str, least: f64, most: f64) -> Result<Option<f64>, SceneError> {
        match self.number(key)? {
            Some(number) if !(least..=most).contains(&number) => {
                Err(self.fault(key, format!("is not from {least} to {most}")))
            }
            number => Ok(number),
        }
    }

    /// A finite number above zero, in the range of `f32`, in which it is computed.
    pub(crate) fn positive(&self, key: &str, example: &str) -> Result<f64, SceneError> {
        let value = self.number(key)?;
        let number = self.required(key, example, value)?;
        if number <= 0.0 {
            return Err(self.fault(key, format!("must be above zero; write, for example, `{key} = {example}`")));
        }
        if !(1e-30..=1e30).contains(&number) {
            return Err(self.fault(key, "is out of range; single precision holds from 1e-30 to 1e30 here"));
        }
        Ok(number)
    }

    /// A vector of as many numbers as the scene has dimensions.
    pub(crate) fn vector(&self, key: &str, dimensions: usize) -> Result<Option<[f64; 3]>, SceneError> {
        self.numbers(key, dimensions)
    }

    /// A list of `count` finite numbers, with zeros after them up to `N`.
    pub(crate) fn numbers<const N: usize>(&self, key: &str, count: usize) -> Result<Option<[f64; N]>, SceneError> {
        let Some(value) = self.table.get(key) else { return Ok(None) };
        let Value::Array(items) = value else {
            return Err(self.fault(key, format!("is {}, where a list of {count} numbers is wanted", kind(value))));
        };
        if items.len() != count {
            return Err(self.fault(key, format!("holds {}, where a list of {count} numbers is wanted", items.len())));
        }
        let mut numbers = [0.0; N];
        for (number, item) in numbers.iter_mut().zip(items) {
            *number = self.number_value(key, item)?;
        }
        Ok(Some(numbers))
    }

    pub(crate) fn required_vector(&self, key: &str, dimensions: usize, example: &str) -> Result<[f64; 3], SceneError> {
        let value = self.vector(key, dimensions)?;
        self.required(key, example, value)
    }

    /// One whole number for all axes, or a list of one an axis.
    pub(crate) fn extents(
        &self,
        key: &str,
        dimensions: usize,
        least: i64,
        most: i64,
    ) -> Result<[usize; 3], SceneError> {
        let mut extents = [1; 3];
        match self.table.get(key) {
            None => return Err(self.missing(key, "128")),
            Some(Value::Array(items)) if items.len() == dimensions => {
                for (extent, item) in extents.iter_mut().zip(items) {
                    *extent = self.whole_value(key, item, least, most)? as usize;
                }
            }
            Some(Value::Array(items)) => {
                return Err(self.fault(key, format!("holds {} extents, where {dimensions} are wanted", items.len())));
            }
            Some(value) => extents[..dimensions].fill(self.whole_value(key, value, least, most)? as usize),
        }
        Ok(extents)
    }

    /// A table below this one.
    pub(crate) fn table(&self, key: &str, known: &[&str]) -> Result<Option<Keys<'a>>, SceneError> {
        match self.table.get(key) {
            None => Ok(None),
            Some(Value::Table(table)) => Keys::new(self.file, format!("{}{key}.", self.prefix), table, known).map(Some),
            Some(other) => {
                let message = format!("is {}, where a table `[{}{key}]` is wanted", kind(other), self.prefix);
                Err(self.fault(key, message))
            }
        }
    }

    /// A table, or those of a list. Their keys are not checked.
    pub(crate) fn table_or_tables(&self, key: &str) -> Result<Vec<Keys<'a>>, SceneError> {
        let wanted = format!("a table `[{key}]` or a list of tables `[[{key}]]` is wanted");
        match self.table.get(key) {
            None => Ok(Vec::new()),
            Some(Value::Table(table)) => {
                Ok(vec![Keys { file: self.file, prefix: format!("{}{key}.", self.prefix), table }])
            }
            Some(Value::Array(items)) => self.items(key, items, &wanted),
            Some(other) => Err(self.fault(key, format!("is {}, where {wanted}", kind(other)))),
        }
    }

    /// The tables of a list, `[[key]]`. Their keys are not checked.
    pub(crate) fn all_tables(&self, key: &str) -> Result<Vec<Keys<'a>>, SceneError> {
        match self.table.get(key) {
            None => Ok(Vec::new()),
            Some(Value::Array(items)) => self.items(key, items, &format!("a list of tables `[[{key}]]` is wanted")),
            Some(other) => {
                Err(self.fault(key, format!("is {}, where a list of tables `[[{key}]]` is wanted", kind(other))))
            }
        }
    }

    fn items(&self, key: &str, items: &'a [Value], wanted: &str) -> Result<Vec<Keys<'a>>, SceneError> {
        let read = |(n, item): (usize, &'a Value)| match item {
            Value::Table(table) => Ok(Keys { file: self.file, prefix: format!("{}{key}[{n}].", self.prefix), table }),
            other => Err(self.fault(key, format!("holds {}, where {wanted}", kind(other)))),
        };
        items.iter().enumerate().map(read).collect()
    }
}

pub(crate) fn kind(value: &Value) -> &'static str {
    match value {
        Value::String(_) => "a text",
        Value::Integer(_) => "a whole number",
        Value::Float(_) => "a number",
        Value::Boolean(_) => "true or false",
        Value::Datetime(_) => "a date",
        Value::Array(_) => "a list",
        Value::Table(_) => "a table",
    }
}

/// A value on one line of bearable length.
pub(crate) fn short(value: &Value) -> String {
    let text: String = value.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    if text.chars().count() <= 60 { text } else { format!("{}..", text.chars().take(57).collect::<String>()) }
}
