//! Layouts as words with arguments: `dense(ij).dense(ij, (4, 2)).place([v], [split(m)])`.

use std::ops::Range;

use super::scan::{Kind, Text, Tokens};
use crate::lab::errors::LabError;

/// A word of a chain, with its arguments if it has some.
#[derive(Debug)]
pub(super) struct Word<'a> {
    pub(super) name: &'a str,
    pub(super) at: Range<usize>,
    pub(super) arguments: Option<Vec<Argument<'a>>>,
}

/// An argument, and where it stands.
#[derive(Debug)]
pub(super) struct Argument<'a> {
    pub(super) at: Range<usize>,
    pub(super) value: Value<'a>,
}

/// What an argument is.
#[derive(Debug)]
pub(super) enum Value<'a> {
    /// `ij`, `node.v`
    Name(&'a str),
    /// `16`
    Number(u128),
    /// `(4, 2)`
    Tuple(Vec<Argument<'a>>),
    /// `[v, m]`
    List(Vec<Argument<'a>>),
    /// `split(v)`
    Call(&'a str, Vec<Argument<'a>>),
    /// `chunk = 8`
    Named(&'a str, Box<Argument<'a>>),
}

/// What the text of a layout is.
pub(super) enum Syntax<'a> {
    /// `AoSoA<16>`
    Named { name: &'a str, at: Range<usize>, size: Option<(u128, Range<usize>)> },
    /// Chains with `+` between them.
    Chains(Vec<Vec<Word<'a>>>),
}

/// Reads a layout. The record that it may name before a colon is skipped, since it is given apart.
pub(super) fn parse(text: Text<'_>) -> Result<Syntax<'_>, LabError> {
    let mut tokens = text.tokens()?;
    let wrapped = tokens.read(tokens.peek(0)) == "layout" && tokens.peek(1).kind == Kind::Sign('!');
    if wrapped {
        tokens.take();
        tokens.take();
        tokens.wants('(', "`layout!` is followed by `(..)`, or left out")?;
    }
    skip_record(&mut tokens);
    if tokens.peek(0).kind == Kind::Word && tokens.read(tokens.peek(0)).starts_with(char::is_uppercase) {
        return named(&mut tokens, wrapped);
    }
    let mut chains = vec![chain(&mut tokens)?];
    while tokens.sign('+') {
        chains.push(chain(&mut tokens)?);
    }
    if wrapped {
        tokens.wants(')', "close `layout!(` with `)`")?;
    }
    if tokens.peek(0).kind != Kind::End {
        return Err(tokens.error("a `.` and another word, or nothing, is wanted here"));
    }
    Ok(Syntax::Chains(chains))
}

/// Skips `Node:`, `records::Node:` and `Node<X>:`.
fn skip_record(tokens: &mut Tokens<'_>) {
    let mut ahead = 0;
    loop {
        match tokens.peek(ahead).kind {
            Kind::Sign(':') if tokens.peek(ahead + 1).kind == Kind::Sign(':') => ahead += 2,
            Kind::Sign(':') => break,
            Kind::Word | Kind::Sign('<' | '>' | ',') => ahead += 1,
            _ => return,
        }
    }
    for _ in 0..=ahead {
        tokens.take();
    }
}

fn named<'a>(tokens: &mut Tokens<'a>, wrapped: bool) -> Result<Syntax<'a>, LabError> {
    let word = tokens.take();
    let name = tokens.read(&word);
    let size = if tokens.sign('<') {
        let size = tokens.number(&format!("the size of a block is wanted: `{name}<16>`"))?;
        tokens.wants('>', "close the size with `>`")?;
        Some(size)
    } else {
        None
    };
    if wrapped || tokens.peek(0).kind != Kind::End {
        let message = format!(
            "`{name}` is a layout of its own, with nothing before or behind it; nodes are written small, as in `dense(ij).aos`"
        );
        return Err(tokens.text.error(&word.at, message));
    }
    Ok(Syntax::Named { name, at: word.at, size })
}

fn chain<'a>(tokens: &mut Tokens<'a>) -> Result<Vec<Word<'a>>, LabError> {
    let mut words = Vec::new();
    loop {
        if tokens.peek(0).kind != Kind::Word {
            return Err(tokens.error("the name of a node or a place is wanted, as in `dense(ij).aos`"));
        }
        let token = tokens.take();
        let (name, mut at) = (tokens.read(&token), token.at);
        let arguments = if tokens.sign('(') { Some(arguments(tokens, ')')?) } else { None };
        if arguments.is_some() {
            // What is wrong with a node is shown with its arguments only where these are at fault.
            at.end = at.start + name.len();
        }
        words.push(Word { name, at, arguments });
        if !tokens.sign('.') {
            return Ok(words);
        }
    }
}

/// Arguments up to the sign that closes them.
fn arguments<'a>(tokens: &mut Tokens<'a>, close: char) -> Result<Vec<Argument<'a>>, LabError> {
    let mut list = Vec::new();
    loop {
        if tokens.sign(close) {
            return Ok(list);
        }
        list.push(argument(tokens)?);
        if !tokens.sign(',') && tokens.peek(0).kind != Kind::Sign(close) {
            return Err(tokens.error(format!("a comma or `{close}` is wanted here")));
        }
    }
}

fn argument<'a>(tokens: &mut Tokens<'a>) -> Result<Argument<'a>, LabError> {
    let start = tokens.peek(0).at.start;
    let value = match tokens.peek(0).kind {
        Kind::Number => Value::Number(tokens.number("a whole number is wanted here")?.0),
        Kind::Sign('(') => {
            tokens.take();
            Value::Tuple(arguments(tokens, ')')?)
        }
        Kind::Sign('[') => {
            tokens.take();
            Value::List(arguments(tokens, ']')?)
        }
        Kind::Word => word(tokens)?,
        _ => return Err(tokens.error("axes, a number, or members in brackets are wanted here")),
    };
    Ok(Argument { at: start..end(tokens), value })
}

/// A name, a path, or what begins with one.
fn word<'a>(tokens: &mut Tokens<'a>) -> Result<Value<'a>, LabError> {
    let first = tokens.take();
    let name = tokens.read(&first);
    if tokens.sign('(') {
        return Ok(Value::Call(name, arguments(tokens, ')')?));
    }
    if tokens.sign('=') {
        return Ok(Value::Named(name, Box::new(argument(tokens)?)));
    }
    let mut path = first.at;
    while tokens.sign('.') {
        if tokens.peek(0).kind != Kind::Word {
            return Err(tokens.error("the name of a member of the inner record is wanted behind the `.`"));
        }
        path.end = tokens.take().at.end;
    }
    Ok(Value::Name(&tokens.text.text[path]))
}

/// Where the last token that was taken ends.
fn end(tokens: &Tokens<'_>) -> usize {
    tokens.text.text[..tokens.peek(0).at.start].trim_end().len()
}
