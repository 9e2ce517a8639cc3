//! Bodies in lanes: cut at their inner loops, each stretch runs for a batch of elements before the next.
//!
//! Within a stretch the code is the user's, on scalars; what it keeps for a later stretch goes through an array of lanes. What has left a loop, or
//! does not enter a branch, is masked out. Each element thus does what it would do alone, in the same order.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote, quote_spanned};
use syn::{Block, Expr, ExprForLoop, ExprIf, Local, Pat, RangeLimits, Stmt};

use super::launch::Launch;
use super::names::{hidden, numbered, private};
use super::reductions::Pieces;
use super::rewrite::Rewrite;
use crate::kernel::lanes::{Cut, cut};
use crate::kernel::syntax::{bare, names};

/// The body of a loop for a batch. `hoists` is what is read at the start of an element.
pub(super) fn body(launch: &Launch<'_>, rewrite: Rewrite<'_>, pieces: &Pieces, hoists: TokenStream) -> TokenStream {
    let width = launch.width().map(Literal::usize_unsuffixed).unwrap_or_else(|| Literal::usize_unsuffixed(1));
    let mut lanes = Lanes { launch, rewrite, width, kept: Vec::new(), locals: 0 };
    let mut start = Stretch::default();
    let identities = &pieces.identities;
    for statement in locals(&quote!(#hoists #identities)) {
        start.declare(&statement.pat);
        start.push(statement.to_token_stream());
    }
    lanes.block(start, &launch.parallel.body, &pieces.puts, None)
}

/// The declarations that an expansion consists of.
fn locals(tokens: &TokenStream) -> Vec<Local> {
    let block: Block = syn::parse_quote!({ #tokens });
    let local = |statement| match statement {
        Stmt::Local(local) => Some(local),
        _ => None,
    };
    block.stmts.into_iter().filter_map(local).collect()
}

/// A function of the type that keeps a variable, at whose name errors about it stand.
fn of_lanes(name: &Ident, function: &str) -> TokenStream {
    let (private, function) = (private(), Ident::new(function, Span::call_site()));
    let located = quote!(#private::Lanes::#function).into_iter().map(|mut token| {
        token.set_span(token.span().located_at(name.span()));
        token
    });
    located.collect()
}

/// A variable of the body that is in scope.
struct Kept {
    name: Ident,
    mutable: bool,
    /// Where it is kept for all lanes; none for one that is the same in all, and hides others.
    lanes: Option<Ident>,
}

/// Statements that all lanes run, one lane after another.
#[derive(Default)]
struct Stretch {
    tokens: TokenStream,
    /// The variables that it declares, and whether as `mut`.
    declared: Vec<(Ident, bool)>,
}

impl Stretch {
    fn push(&mut self, tokens: TokenStream) {
        self.tokens.extend(tokens);
    }

    fn declare(&mut self, pat: &Pat) {
        names(pat, &mut |name, mutable| {
            self.declared.retain(|(other, _)| other != name);
            self.declared.push((name.clone(), mutable));
        });
    }
}

/// A condition that is evaluated at the end of a stretch, and where it goes.
struct Condition<'a> {
    tokens: TokenStream,
    /// The mask of those where it holds, and the bits of all of them.
    holds: (&'a Ident, &'a Ident),
    /// The same of those where it does not.
    fails: Option<(&'a Ident, &'a Ident)>,
}

/// The names in some tokens.
#[derive(Default)]
struct Mentions {
    names: BTreeSet<String>,
    /// Whether a format string could name any variable.
    any: bool,
}

impl Mentions {
    fn of(tokens: &TokenStream) -> Self {
        let mut mentions = Self::default();
        mentions.add(tokens);
        mentions
    }

    fn add(&mut self, tokens: &TokenStream) {
        for token in tokens.clone() {
            match token {
                TokenTree::Ident(name) => {
                    self.names.insert(name.to_string());
                }
                TokenTree::Group(group) => self.add(&group.stream()),
                TokenTree::Literal(literal) => {
                    let text = literal.to_string();
                    self.any |= text.ends_with(['"', '#']) && text.contains('{');
                }
                TokenTree::Punct(_) => {}
            }
        }
    }

    fn has(&self, name: &Ident) -> bool {
        self.any || self.names.contains(&name.to_string())
    }
}

struct Lanes<'a> {
    launch: &'a Launch<'a>,
    rewrite: Rewrite<'a>,
    width: Literal,
    /// From the outermost scope inwards.
    kept: Vec<Kept>,
    /// How many locals the expansion has.
    locals: usize,
}

impl Lanes<'_> {
    fn local(&mut self, name: &str) -> Ident {
        self.locals += 1;
        numbered(&format!("{name}_"), self.locals)
    }

    fn width(&self) -> TokenStream {
        let (private, width) = (private(), &self.width);
        quote!(#private::Width::<#width>)
    }

    /// The variables that the code sees and mentions, of those that lanes keep.
    fn used(&self, mentions: &Mentions) -> Vec<&Kept> {
        let hidden = |n: usize| self.kept[n + 1..].iter().any(|later| later.name == self.kept[n].name);
        let visible = self.kept.iter().enumerate().filter(|(n, _)| !hidden(*n)).map(|(_, kept)| kept);
        visible.filter(|kept| kept.lanes.is_some() && mentions.has(&kept.name)).collect()
    }

    /// Whether code could give something else in each lane.
    fn varies(&self, tokens: &TokenStream) -> bool {
        let mentions = Mentions::of(tokens);
        mentions.has(&hidden("cell"))
            || self.launch.parallel.variables.iter().flatten().any(|variable| mentions.has(variable))
            || !self.used(&mentions).is_empty()
    }

    /// A block: its statements after those of `stretch`, and `end` behind them.
    fn block(&mut self, stretch: Stretch, block: &Block, end: &TokenStream, mask: Option<&Ident>) -> TokenStream {
        self.statements(stretch, block, end, mask, None)
    }

    fn statements(
        &mut self,
        mut stretch: Stretch,
        block: &Block,
        end: &TokenStream,
        mask: Option<&Ident>,
        condition: Option<Condition<'_>>,
    ) -> TokenStream {
        let scope = self.kept.len();
        let rewritten: Vec<TokenStream> = block.stmts.iter().map(|statement| self.rewritten(statement)).collect();
        let mut tokens = TokenStream::new();
        let items = block.stmts.iter().filter(|statement| matches!(statement, Stmt::Item(_)));
        items.for_each(|item| item.to_tokens(&mut tokens));
        for (n, statement) in block.stmts.iter().enumerate() {
            let mut later = Mentions::of(end);
            rewritten[n..].iter().for_each(|tokens| later.add(tokens));
            match (cut(statement), statement) {
                (Cut::No, Stmt::Item(_)) => {}
                (Cut::No, Stmt::Local(local)) => {
                    if let Some(uniform) = self.uniform(local, &rewritten[n], &stretch) {
                        tokens.extend(self.flush(&mut stretch, &later, mask));
                        tokens.extend(uniform);
                    } else {
                        self.push_local(local, &rewritten[n], &mut stretch, &later, mask, &mut tokens);
                    }
                }
                (Cut::No, _) => stretch.push(rewritten[n].clone()),
                (cut, _) => {
                    tokens.extend(self.flush(&mut stretch, &later, mask));
                    let inner = match cut {
                        Cut::For(inner) => self.for_loop(inner, mask),
                        Cut::While(inner) => {
                            let condition = self.rewrite.expr(&inner.cond);
                            self.while_loop(condition, Stretch::default(), &inner.body, mask)
                        }
                        Cut::If(branch) => self.branch(branch, mask),
                        Cut::No => unreachable!("told apart above"),
                    };
                    match inner {
                        Some(inner) => tokens.extend(inner),
                        None => stretch.push(rewritten[n].clone()),
                    }
                }
            }
        }
        stretch.push(end.clone());
        // The condition stands outside of the block, and does not see the variables that it declares.
        match condition {
            Some(condition) if self.kept.len() == scope => {
                let inner = std::mem::take(&mut stretch.tokens);
                let stretch = Stretch { tokens: quote!({ #inner }), declared: Vec::new() };
                tokens.extend(self.run(stretch, &Mentions::default(), mask, Some(condition)));
            }
            condition => {
                tokens.extend(self.flush(&mut stretch, &Mentions::default(), mask));
                self.kept.truncate(scope);
                if condition.is_some() {
                    tokens.extend(self.run(Stretch::default(), &Mentions::default(), mask, condition));
                }
            }
        }
        self.kept.truncate(scope);
        tokens
    }

    fn rewritten(&self, statement: &Stmt) -> TokenStream {
        let mut statement = statement.clone();
        if let Stmt::Expr(_, semicolon @ None) = &mut statement {
            *semicolon = Some(Default::default());
        }
        self.rewrite.statements(&Block { brace_token: Default::default(), stmts: vec![statement] })
    }

    /// A declaration whose value is the same in all lanes, which then is evaluated once.
    fn uniform(&mut self, local: &Local, rewritten: &TokenStream, stretch: &Stretch) -> Option<TokenStream> {
        let init = local.init.as_ref().filter(|init| init.diverge.is_none())?;
        let mut declared = Vec::new();
        names(&local.pat, &mut |name, mutable| declared.push((name.clone(), mutable)));
        let value = self.rewrite.expr(&init.expr);
        let mentions = Mentions::of(&value);
        let waits = stretch.declared.iter().any(|(name, _)| mentions.has(name));
        let calls = value.to_string().contains("! ");
        if waits || calls || declared.is_empty() || declared.iter().any(|(_, mutable)| *mutable) || self.varies(&value)
        {
            return None;
        }
        let uniform = declared.into_iter().map(|(name, mutable)| Kept { name, mutable, lanes: None });
        self.kept.extend(uniform);
        Some(rewritten.clone())
    }

    /// A declaration of a variable that lanes keep.
    fn push_local(
        &mut self,
        local: &Local,
        rewritten: &TokenStream,
        stretch: &mut Stretch,
        later: &Mentions,
        mask: Option<&Ident>,
        tokens: &mut TokenStream,
    ) {
        let mut declared = Mentions::default();
        names(&local.pat, &mut |name, _| {
            declared.names.insert(name.to_string());
        });
        let hides = self.used(&declared).iter().any(|kept| kept.mutable);
        if !hides {
            stretch.declare(&local.pat);
            stretch.push(rewritten.clone());
            return;
        }
        // What is hidden is kept as it is after the value of what hides it, which therefore has a stretch of its own.
        tokens.extend(self.flush(stretch, later, mask));
        let (Some(init), value) = (&local.init, self.local("value")) else { return };
        let (init, pat) = (self.rewrite.expr(&init.expr), &local.pat);
        let before = Stretch { tokens: quote!(let #value = #init;), declared: vec![(value.clone(), false)] };
        let wanted = Mentions { names: BTreeSet::from([value.to_string()]), any: false };
        tokens.extend(self.run(before, &wanted, mask, None));
        let after = Stretch { tokens: quote!(let #pat = #value;), declared: Vec::new() };
        *stretch = after;
        stretch.declare(&local.pat);
        // From here on the name is another variable's.
        let hidden: Vec<Ident> = self.used(&declared).iter().map(|kept| kept.name.clone()).collect();
        self.kept.extend(hidden.into_iter().map(|name| Kept { name, mutable: false, lanes: None }));
    }

    /// Runs what there is of a stretch.
    fn flush(&mut self, stretch: &mut Stretch, later: &Mentions, mask: Option<&Ident>) -> TokenStream {
        let stretch = std::mem::take(stretch);
        if stretch.tokens.is_empty() { TokenStream::new() } else { self.run(stretch, later, mask, None) }
    }

    /// A stretch over all lanes.
    fn run(
        &mut self,
        stretch: Stretch,
        later: &Mentions,
        mask: Option<&Ident>,
        condition: Option<Condition<'_>>,
    ) -> TokenStream {
        let width = self.width();
        let [lane, cell, batch, on] = ["lane", "cell", "batch", "on"].map(hidden);
        let (variables, inner) = (self.launch.variables(), &stretch.tokens);
        let mut mentions = Mentions::of(inner);
        if let Some(condition) = &condition {
            mentions.add(&condition.tokens);
        }
        let (mut loads, mut outs, mut stores) = (TokenStream::new(), Vec::new(), Vec::new());
        for Kept { name, mutable, lanes } in self.used(&mentions) {
            let mutability = mutable.then(|| quote!(mut));
            let get = of_lanes(name, "get");
            loads.extend(quote_spanned!(name.span()=> let #mutability #name = #get(&#lanes, #lane);));
            if *mutable {
                outs.push(name.clone());
                stores.push(lanes.clone());
            }
        }
        let mut declarations = TokenStream::new();
        for (name, mutable) in stretch.declared.iter().filter(|(name, _)| later.has(name)) {
            let lanes = self.local("lanes");
            let new = of_lanes(name, "new");
            declarations.extend(quote_spanned!(name.span()=> let mut #lanes = #new(#width);));
            outs.push(name.clone());
            stores.push(Some(lanes.clone()));
            self.kept.push(Kept { name: name.clone(), mutable: *mutable, lanes: Some(lanes) });
        }
        let each_of = |function| outs.iter().map(move |name| of_lanes(name, function));
        let (set, set_masked, nothing_of) = (each_of("set"), each_of("set_masked"), each_of("nothing"));
        let judge = condition.as_ref().map(|Condition { tokens, .. }| quote!(let #on: bool = #tokens;));
        let told = condition.as_ref().map(|Condition { holds: (holds, bits), fails, .. }| {
            let lets = mask.map_or_else(|| quote!(true), |mask| quote!(#mask.lets(#lane)));
            let fails = fails.map(|(fails, bits)| quote!(#bits |= #fails.set(#lane, #lets & !#on);));
            quote!(#fails #bits |= #holds.set(#lane, #on);)
        });
        let each = match mask {
            None => quote! {
                #variables #loads #inner #judge
                #(#set(&mut #stores, #lane, #outs);)*
                #told
            },
            Some(mask) if outs.is_empty() && condition.is_none() => quote! {
                if #mask.lets(#lane) { #variables #loads #inner }
            },
            Some(mask) => {
                let (last, nothing) = condition.as_ref().map(|_| (quote!(#on), quote!(false))).unzip();
                quote! {
                    let (#(#outs,)* #last) = if #mask.lets(#lane) {
                        #variables #loads #inner #judge
                        (#(#outs,)* #last)
                    } else {
                        (#(#nothing_of(&#stores),)* #nothing)
                    };
                    #(#set_masked(&mut #stores, &#mask, #lane, #outs);)*
                    #told
                }
            }
        };
        quote! {
            #declarations
            #[allow(unused, clippy::all)]
            for (#lane, #cell) in #batch.cells() { #each }
        }
    }

    /// A loop that each lane leaves where its condition fails.
    fn while_loop(
        &mut self,
        condition: TokenStream,
        start: Stretch,
        body: &Block,
        mask: Option<&Ident>,
    ) -> Option<TokenStream> {
        let nothing = TokenStream::new();
        if start.tokens.is_empty() && !self.varies(&condition) {
            let inner = self.block(start, body, &nothing, mask);
            return Some(quote!(while #condition { #inner }));
        }
        let (private, width) = (private(), self.width());
        let (on, any) = (self.local("on"), self.local("any"));
        let judged = || Some(Condition { tokens: condition.clone(), holds: (&on, &any), fails: None });
        let first = self.run(Stretch::default(), &Mentions::default(), mask, judged());
        let inner = self.statements(start, body, &nothing, Some(&on), judged());
        Some(quote! {
            let (mut #on, mut #any) = (#private::Mask::new(#width), 0u32);
            #first
            while #any != 0 { #any = 0; #inner }
        })
    }

    /// A loop over what is the same in all lanes, or over a range of each lane's own; all others are none of lanes.
    fn for_loop(&mut self, inner: &ExprForLoop, mask: Option<&Ident>) -> Option<TokenStream> {
        let (pat, over) = (&inner.pat, self.rewrite.expr(&inner.expr));
        let mut declared = Vec::new();
        names(pat, &mut |name, mutable| declared.push((name.clone(), mutable)));
        if !self.varies(&over) && !declared.iter().any(|(_, mutable)| *mutable) {
            let scope = self.kept.len();
            self.kept.extend(declared.into_iter().map(|(name, mutable)| Kept { name, mutable, lanes: None }));
            let body = self.block(Stretch::default(), &inner.body, &TokenStream::new(), mask);
            self.kept.truncate(scope);
            return Some(quote!(for #pat in #over { #body }));
        }
        let Expr::Range(range) = bare(&inner.expr) else { return None };
        let (Some(start), RangeLimits::HalfOpen(_), Some(end)) = (&range.start, &range.limits, &range.end) else {
            return None;
        };
        let (private, scope) = (private(), self.kept.len());
        let (start, end) = (self.rewrite.expr(start), self.rewrite.expr(end));
        let (next, last) = (self.local("next"), self.local("last"));
        let ends = Stretch {
            tokens: quote!(let (mut #next, #last) = #private::ends((#start)..(#end));),
            declared: vec![(next.clone(), true), (last.clone(), false)],
        };
        let wanted = Mentions { names: BTreeSet::from([next.to_string(), last.to_string()]), any: false };
        let ends = self.run(ends, &wanted, mask, None);
        let mut each = Stretch { tokens: quote!(let #pat = #next; #next += 1;), declared: Vec::new() };
        each.declare(pat);
        let inner = self.while_loop(quote!(#next < #last), each, &inner.body, mask)?;
        self.kept.truncate(scope);
        Some(quote!({ #ends #inner }))
    }

    /// A branch around loops.
    fn branch(&mut self, branch: &ExprIf, mask: Option<&Ident>) -> Option<TokenStream> {
        let condition = self.rewrite.expr(&branch.cond);
        let otherwise = branch.else_branch.as_ref().map(|(_, other)| match &**other {
            Expr::Block(block) => block.block.clone(),
            other => Block { brace_token: Default::default(), stmts: vec![Stmt::Expr(other.clone(), None)] },
        });
        let nothing = TokenStream::new();
        if !self.varies(&condition) {
            let then = self.block(Stretch::default(), &branch.then_branch, &nothing, mask);
            let otherwise = otherwise.map(|block| {
                let block = self.block(Stretch::default(), &block, &nothing, mask);
                quote!(else { #block })
            });
            return Some(quote!(if #condition { #then } #otherwise));
        }
        let (private, width) = (private(), self.width());
        let [on, any, off, other] = ["on", "any", "off", "other"].map(|name| self.local(name));
        let fails = otherwise.as_ref().map(|_| (&off, &other));
        let condition = Condition { tokens: condition, holds: (&on, &any), fails };
        let judge = self.run(Stretch::default(), &Mentions::default(), mask, Some(condition));
        let then = self.block(Stretch::default(), &branch.then_branch, &nothing, Some(&on));
        let (declare, otherwise) = otherwise
            .map(|block| {
                let block = self.block(Stretch::default(), &block, &nothing, Some(&off));
                let declare = quote!(let (mut #off, mut #other) = (#private::Mask::new(#width), 0u32););
                (declare, quote!(if #other != 0 { #block }))
            })
            .unzip();
        Some(quote! {
            let (mut #on, mut #any) = (#private::Mask::new(#width), 0u32);
            #declare
            #judge
            if #any != 0 { #then }
            #otherwise
        })
    }
}
