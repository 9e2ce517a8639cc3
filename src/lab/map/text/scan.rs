//! Words, numbers and signs of a text, and errors that tell where in it something is wrong.

use std::iter::Peekable;
use std::ops::Range;
use std::str::CharIndices;

use crate::lab::errors::LabError;

/// The most brackets in one another.
const DEEPEST: usize = 16;

/// A text of the command line, and what it is: `record`, `layout`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Text<'a> {
    pub(super) what: &'static str,
    pub(super) text: &'a str,
}

impl<'a> Text<'a> {
    /// What is wrong at a place: one line that names the text, the place, and what to write.
    pub(super) fn error(self, at: &Range<usize>, message: impl AsRef<str>) -> LabError {
        let Self { what, text } = self;
        let column = text[..at.start].chars().count() + 1;
        let piece = text[at.clone()].trim();
        let place = if piece.is_empty() { format!("column {column}") } else { format!("column {column}, `{piece}`") };
        LabError::usage(format!("{what} `{text}`: {place}: {}", message.as_ref()))
    }

    /// The tokens of the text, and one of nothing at its end.
    pub(super) fn tokens(self) -> Result<Tokens<'a>, LabError> {
        let (mut tokens, mut depth) = (Vec::new(), 0usize);
        let mut signs = self.text.char_indices().peekable();
        while let Some((start, sign)) = signs.next() {
            match sign {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                sign if sign.is_whitespace() => continue,
                _ => {}
            }
            if depth > DEEPEST {
                return Err(self
                    .error(&(start..start + 1), format!("more than {DEEPEST} brackets in one another; write fewer")));
            }
            let (end, kind) = match sign {
                '0'..='9' => (word_end(self.text, &mut signs), Kind::Number),
                sign if sign.is_alphabetic() || sign == '_' => (word_end(self.text, &mut signs), Kind::Word),
                sign if "()[]{}<>,:;.+=!-".contains(sign) => (start + sign.len_utf8(), Kind::Sign(sign)),
                sign => {
                    let end = start + sign.len_utf8();
                    return Err(self.error(&(start..end), format!("no {} has such a sign; leave it out", self.what)));
                }
            };
            tokens.push(Token { kind, at: start..end });
        }
        let end = self.text.len();
        tokens.push(Token { kind: Kind::End, at: end..end });
        Ok(Tokens { text: self, tokens, next: 0 })
    }
}

/// The end of the word or number that the last sign began.
fn word_end(text: &str, signs: &mut Peekable<CharIndices<'_>>) -> usize {
    while signs.next_if(|(_, sign)| sign.is_alphanumeric() || *sign == '_').is_some() {}
    signs.peek().map_or(text.len(), |&(at, _)| at)
}

/// The known name that was probably meant. Capitals count for nothing.
pub(super) fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let known: Vec<(String, &str)> = known.into_iter().map(|known| (known.to_lowercase(), known)).collect();
    let near = allotrope_solvers::nearest(name, known.iter().map(|(small, _)| small.as_str()))?;
    known.iter().find(|(small, _)| small == near).map(|&(_, known)| known)
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Word,
    Number,
    Sign(char),
    End,
}

/// A word, a number or a sign, and where it stands.
#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: Kind,
    pub(super) at: Range<usize>,
}

/// Tokens that are read one after another.
#[derive(Debug)]
pub(super) struct Tokens<'a> {
    pub(super) text: Text<'a>,
    tokens: Vec<Token>,
    next: usize,
}

impl<'a> Tokens<'a> {
    /// The token that comes so many behind the next one.
    pub(super) fn peek(&self, ahead: usize) -> &Token {
        &self.tokens[(self.next + ahead).min(self.tokens.len() - 1)]
    }

    /// Takes the next token.
    pub(super) fn take(&mut self) -> Token {
        let token = self.peek(0).clone();
        self.next = (self.next + 1).min(self.tokens.len());
        token
    }

    /// Takes a sign, if it comes next.
    pub(super) fn sign(&mut self, sign: char) -> bool {
        let here = self.peek(0).kind == Kind::Sign(sign);
        if here {
            self.take();
        }
        here
    }

    /// Takes a sign that has to be there.
    pub(super) fn wants(&mut self, sign: char, what: &str) -> Result<(), LabError> {
        if self.sign(sign) { Ok(()) } else { Err(self.error(what)) }
    }

    /// What a token reads.
    pub(super) fn read(&self, token: &Token) -> &'a str {
        &self.text.text[token.at.clone()]
    }

    /// The next token is none that can stand there.
    pub(super) fn error(&self, message: impl AsRef<str>) -> LabError {
        let at = &self.peek(0).at;
        match self.peek(0).kind {
            Kind::End => self.text.error(at, format!("the {} ends here; {}", self.text.what, message.as_ref())),
            _ => self.text.error(at, message),
        }
    }

    /// Takes a number.
    pub(super) fn number(&mut self, what: &str) -> Result<(u128, Range<usize>), LabError> {
        if self.peek(0).kind != Kind::Number {
            return Err(self.error(what));
        }
        let token = self.take();
        let digits = self.read(&token).replace('_', "");
        let number =
            digits.strip_suffix("usize").unwrap_or(&digits).parse().map_err(|_| self.text.error(&token.at, what))?;
        Ok((number, token.at))
    }
}
