//! Macros: those of the standard library are read as expressions, all others are left alone and remembered.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{Parse, ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit_mut::VisitMut;
use syn::{Expr, Ident, Lit, Macro, Pat, Stmt, Token};

use super::Lower;
use crate::kernel::model::{MacroArguments, MacroCall, Node, OpaqueMacro, Spot, What, node_of};
use crate::kernel::syntax::name_of;

/// Macros whose arguments are expressions.
pub(in crate::kernel) const KNOWN: &[&str] = &[
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "debug_assert_ne",
    "print",
    "println",
    "eprint",
    "eprintln",
    "format",
    "format_args",
    "write",
    "writeln",
    "panic",
    "matches",
    "vec",
    "dbg",
    "todo",
    "unreachable",
    "unimplemented",
];

/// The words of the language that look like macros.
const HEADS: &[&str] = &["unroll", "ndrange"];

impl Lower {
    /// Makes a statement that calls a known macro an expression statement.
    pub(super) fn known_macro_statement(&self, statement: &mut Stmt, tail: bool) {
        let Stmt::Macro(call) = &*statement else { return };
        let word = word(&call.mac);
        if KNOWN.contains(&word.as_str()) && arguments(&call.mac).is_some() || HEADS.contains(&word.as_str()) {
            let semi = call.semi_token.or_else(|| (!tail).then(Default::default));
            let expr = Expr::Macro(syn::ExprMacro { attrs: call.attrs.clone(), mac: call.mac.clone() });
            *statement = Stmt::Expr(expr, semi);
        }
    }

    pub(super) fn visit_macro(&mut self, expr: &mut Expr) {
        if node_of(expr).is_some() {
            return;
        }
        let Expr::Macro(call) = &*expr else { return };
        let name = word(&call.mac);
        if HEADS.contains(&name.as_str()) {
            return self.find(What::HeadMacro { name }, &call.mac.path.clone());
        }
        let known = KNOWN.contains(&name.as_str()).then(|| arguments(&call.mac)).flatten();
        let Some(mut arguments) = known else {
            let call = call.mac.clone();
            return self.opaque_macro(&call, false);
        };
        let mac = call.mac.clone();
        self.format_captures(&arguments);
        self.scopes.enter();
        match &mut arguments {
            MacroArguments::List(list) => list.iter_mut().for_each(|argument| self.visit_macro_argument(argument)),
            MacroArguments::Repeat(value, count) => {
                self.visit_expr_mut(value);
                self.visit_expr_mut(count);
            }
            MacroArguments::Matches { value, pattern, guard } => {
                self.visit_expr_mut(value);
                self.bind_pattern(pattern);
                if let Some(guard) = guard {
                    self.visit_expr_mut(guard);
                }
            }
        }
        self.scopes.leave();
        *expr = self.node(Node::Macro(MacroCall { call: mac.clone(), arguments }), mac.path.span());
    }

    /// `value`, or `name = value` in a format macro.
    fn visit_macro_argument(&mut self, argument: &mut Expr) {
        match argument {
            Expr::Assign(named) => self.visit_expr_mut(&mut named.right),
            other => self.visit_expr_mut(other),
        }
    }

    /// The names that format strings capture inline: they cannot be rewritten.
    fn format_captures(&mut self, arguments: &MacroArguments) {
        let MacroArguments::List(list) = arguments else { return };
        let named = |name: &str| {
            list.iter()
                .any(|argument| matches!(argument, Expr::Assign(a) if name_of(&a.left).is_some_and(|n| n == name)))
        };
        for argument in list {
            let Expr::Lit(literal) = argument else { continue };
            let Lit::Str(format) = &literal.lit else { continue };
            for name in inline_names(&format.value()).into_iter().filter(|name| !named(name)) {
                let ident = Ident::new(&name, format.span());
                let Some(number) = self.parallel() else {
                    self.kernel.handed_on.extend(self.field(&ident));
                    continue;
                };
                let reduction = self.kernel.loops[number].reductions.iter().any(|reduction| reduction.name == ident);
                if let Some(field) = self.field(&ident) {
                    self.find(What::BareField { field }, format);
                } else if reduction {
                    self.find(What::ReductionRead { name: name.clone() }, format);
                } else if let Some(kind) = self.outer(&ident) {
                    self.capture(&ident, kind);
                }
                self.kernel.loops[number].hidden.insert(name);
            }
        }
    }

    /// Remembers what a macro that the kernel does not know mentions.
    pub(super) fn opaque_macro(&mut self, call: &Macro, definition: bool) {
        let mut mentions = Vec::new();
        collect(call.tokens.clone(), &mut mentions);
        let name = if definition { "macro_rules".to_owned() } else { call.path.to_token_stream().to_string() };
        let Some(number) = self.parallel() else {
            let fields: Vec<usize> = mentions.iter().filter_map(|name| self.field(name)).collect();
            return self.kernel.handed_on.extend(fields);
        };
        let found = &mut self.kernel.loops[number];
        found.hidden.extend(mentions.iter().map(ToString::to_string));
        let spot = Spot::new(call);
        found.macros.push(OpaqueMacro { name, spot, mentions, definition });
    }
}

pub(in crate::kernel) fn word(call: &Macro) -> String {
    call.path.segments.last().map(|segment| segment.ident.to_string()).unwrap_or_default()
}

/// The arguments of a known macro, if they read as expressions.
fn arguments(call: &Macro) -> Option<MacroArguments> {
    match word(call).as_str() {
        "matches" => call.parse_body::<Matches>().ok().map(|found| found.0),
        "vec" => {
            let repeat = |input: ParseStream<'_>| {
                let value = input.parse()?;
                input.parse::<Token![;]>()?;
                Ok(MacroArguments::Repeat(Box::new(value), input.parse().map(Box::new)?))
            };
            repeat.parse2(call.tokens.clone()).ok().or_else(|| list(call))
        }
        _ => list(call),
    }
}

fn list(call: &Macro) -> Option<MacroArguments> {
    let list = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(call.tokens.clone()).ok()?;
    Some(MacroArguments::List(list.into_iter().collect()))
}

/// `value, pattern if guard`.
struct Matches(MacroArguments);

impl Parse for Matches {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let value = input.parse().map(Box::new)?;
        input.parse::<Token![,]>()?;
        let pattern = Pat::parse_multi_with_leading_vert(input).map(Box::new)?;
        let guard = if input.peek(Token![if]) {
            input.parse::<Token![if]>()?;
            Some(input.parse().map(Box::new)?)
        } else {
            None
        };
        input.parse::<Option<Token![,]>>()?;
        Ok(Self(MacroArguments::Matches { value, pattern, guard }))
    }
}

/// All names in tokens, groups included.
pub(in crate::kernel) fn collect(tokens: TokenStream, names: &mut Vec<Ident>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => names.push(name),
            TokenTree::Group(group) => collect(group.stream(), names),
            TokenTree::Literal(literal) => {
                // A string may be a format string that captures inline.
                let span = literal.span();
                if let Ok(Lit::Str(format)) = syn::parse2::<Lit>(TokenTree::Literal(literal).into()) {
                    names.extend(inline_names(&format.value()).iter().map(|name| Ident::new(name, span)));
                }
            }
            TokenTree::Punct(_) => {}
        }
    }
}

/// The names in `{name}` and `{name:..}` and `{:width$}` of a format string.
fn inline_names(format: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = format;
    while let Some(open) = rest.find('{') {
        rest = &rest[open + 1..];
        if let Some(escaped) = rest.strip_prefix('{') {
            rest = escaped;
            continue;
        }
        let Some(close) = rest.find('}') else { break };
        let (name, spec) = rest[..close].split_once(':').unwrap_or((&rest[..close], ""));
        found.extend(is_name(name.trim()).then(|| name.trim().to_owned()));
        for parameter in spec.split('$').rev().skip(1) {
            let start = parameter.rfind(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(0, |place| place + 1);
            found.extend(is_name(&parameter[start..]).then(|| parameter[start..].to_owned()));
        }
        rest = &rest[close + 1..];
    }
    found
}

fn is_name(text: &str) -> bool {
    // Format strings know no raw names.
    !text.starts_with("r#") && syn::parse_str::<Ident>(text).is_ok()
}

#[cfg(test)]
mod tests {
    use super::inline_names;

    #[test]
    fn inline_captures_are_found() {
        assert_eq!(inline_names("{a} {{b}} {c:?} {0} {:>width$.prec$} {}"), ["a", "c", "prec", "width"]);
    }
}
