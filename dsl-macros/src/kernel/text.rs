//! Tokens as one would write them, for messages.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::ToTokens;

/// The tokens as one would write them.
pub(crate) fn text(tokens: &impl ToTokens) -> String {
    let mut out = String::new();
    write(tokens.to_token_stream(), &mut out);
    out.trim().to_owned()
}

/// A type as one would write it.
pub(crate) fn type_text(ty: &syn::Type) -> String {
    text(ty).replace(" < ", "<").replace(" >", ">")
}

fn write(tokens: TokenStream, out: &mut String) {
    // Whether the last token was an operator that binds to what follows (`-x`, `&x`), and whether it was joined.
    let mut joined = false;
    let mut operand = false;
    // Whether the bar of a closure's parameters is open.
    let mut closure = false;
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Brace => (" { ", " }"),
                    Delimiter::None => ("", ""),
                };
                out.push_str(open);
                write(group.stream(), out);
                out.push_str(close);
                operand = true;
                joined = false;
            }
            TokenTree::Punct(punct) if closure && punct.as_char() == '|' => {
                trim(out);
                out.push_str("| ");
                (closure, operand, joined) = (false, false, false);
            }
            TokenTree::Punct(punct) => {
                let tight = matches!(punct.as_char(), '.' | '!' | ':' | '#' | '\'' | '?') || joined && !spaced(out);
                let prefix = !operand && !joined && matches!(punct.as_char(), '-' | '&' | '*' | '|');
                closure |= prefix && punct.as_char() == '|' && punct.spacing() == Spacing::Alone;
                match punct.as_char() {
                    ',' | ';' => {
                        trim(out);
                        out.push(punct.as_char());
                        out.push(' ');
                    }
                    c if tight || prefix => out.push(c),
                    c => {
                        if !joined && !out.ends_with(' ') {
                            out.push(' ');
                        }
                        out.push(c);
                        if punct.spacing() == Spacing::Alone {
                            out.push(' ');
                        }
                    }
                }
                joined = punct.spacing() == Spacing::Joint;
                operand = punct.as_char() == '?';
            }
            word => {
                let word = word.to_string();
                if out.ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | ')' | ']' | '}')) {
                    out.push(' ');
                }
                out.push_str(&word);
                operand = !matches!(word.as_str(), "for" | "in" | "return" | "let" | "mut" | "if" | "match" | "while");
                if !operand {
                    out.push(' ');
                }
                joined = false;
            }
        }
    }
}

fn spaced(out: &str) -> bool {
    out.trim_end().ends_with(['+', '-', '*', '/', '%', '=', '<', '>', '|', '&', '^'])
}

fn trim(out: &mut String) {
    out.truncate(out.trim_end().len());
}

#[cfg(test)]
mod tests {
    use super::text;

    #[track_caller]
    fn same(source: &str) {
        assert_eq!(text(&source.parse::<proc_macro2::TokenStream>().unwrap()), source);
    }

    #[test]
    fn expressions_read_as_written() {
        same("u[(i - 1, j)]");
        same("grid.v[base + offset] += weight * (m * v)");
        same("for t in 0..n");
        same("for (i, j) in ndrange!(0..n, -1..m)");
        same("bins[keys[i]] |= 1");
        same("f(x, -y)?");
        same("u[ij + ivec2(1, 0)]");
        same("let old = m[q]");
        same("m[q] <<= 2");
        same("a == b && !c");
        same("(0..n).map(|_| 0)");
        same("f(|a, b| a | b)");
    }
}
