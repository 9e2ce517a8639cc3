//! `#[func]`: a function on values and on members to read, which kernels hand to it.
//!
//! It stays the function that it is. A parameter `Read<T, _, X>` becomes an argument-position `impl Readable<T, X>`, and `q[index]`
//! a call of its `get`; all else that may be done with a member is a method.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::parse::Parser;
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};
use syn::{Expr, FnArg, Ident, ItemFn, Pat, PathArguments, Token, Type, parse_quote};

use super::expand::names::Ends;
use super::lower::macros::{KNOWN, collect, word};
use super::lower::root;
use super::model::Spot;
use super::syntax::{bare, bare_type, compound, last_segment, name_of, type_arguments};
use super::text::text;
use crate::diagnostics::{Code, Diagnostics};

/// Expands a function, or reports all its errors beside a function of the same type, so that nothing follows from them.
pub(crate) fn expand(options: TokenStream, item: TokenStream) -> TokenStream {
    let mut diagnostics = Diagnostics::default();
    let mut function = match syn::parse2::<ItemFn>(item.clone()) {
        Ok(function) => function,
        Err(error) => {
            if syn::parse2::<syn::Item>(item.clone()).is_err() && syn::parse2::<syn::TraitItemFn>(item.clone()).is_err()
            {
                diagnostics.syntax(error);
                return diagnostics.into_compile_errors();
            }
            diagnostics
                .error(Code::NotAFunction, &item, "`#[func]` goes on a function with a body")
                .help("write `#[func] fn name(q: Read<f32, _>, i: i32) -> f32 { .. }`");
            let errors = diagnostics.into_compile_errors();
            return quote!(#errors #item);
        }
    };
    if !options.is_empty() {
        let message = format!("`#[func]` has no option `{}`", text(&options));
        diagnostics.error(Code::KernelOption, &options, message).help("write `#[func]` alone");
    }
    let mut members = Vec::new();
    for input in &mut function.sig.inputs {
        if let FnArg::Typed(parameter) = input {
            members.extend(member(parameter, &mut diagnostics));
        }
    }
    Body { members, diagnostics: &mut diagnostics }.visit_block_mut(&mut function.block);
    let errors = (!diagnostics.is_empty()).then(|| {
        *function.block = parse_quote!({ loop {} });
        function.attrs.push(parse_quote!(#[allow(unused, clippy::all)]));
        diagnostics.into_compile_errors()
    });
    // A function that stood by itself would be compiled for the plainest processor, and a member copied for each call.
    let inline = !function.attrs.iter().any(|attribute| attribute.path().is_ident("inline"));
    let inline = inline.then(|| quote!(#[inline(always)]));
    quote!(#errors #inline #[allow(unused_parens, clippy::deref_addrof)] #function)
}

/// The name of a parameter that is a member to read, whose type is opened.
fn member(parameter: &mut syn::PatType, diagnostics: &mut Diagnostics) -> Option<Ident> {
    let (borrowed, inner) = match bare_type(&parameter.ty) {
        Type::Reference(reference) => (true, &*reference.elem),
        other => (false, other),
    };
    let segment = last_segment(inner).filter(|segment| segment.ident == "Read")?;
    let PathArguments::AngleBracketed(all) = &segment.arguments else { return None };
    let arguments = type_arguments(segment);
    if borrowed || arguments.len() != all.args.len() || !(2..=3).contains(&arguments.len()) {
        diagnostics
            .error(Code::FuncMember, &parameter.ty, "a `#[func]` takes a member to read as `Read<T, _, X>`, by value")
            .note("it names the values, the layout (`_` for any) and the axes, and can be copied as it is")
            .help("write `Read<f32, _>`, or with axes `Read<f32, _, Ij>`");
        *parameter.ty = parse_quote!(impl ::core::marker::Sized);
        return None;
    }
    let open = |ty: &&Type| matches!(ty, Type::Infer(_));
    for (place, what) in [(0, "values"), (2, "axes")] {
        if let Some(ty) = arguments.get(place).filter(|ty| open(ty)) {
            diagnostics
                .error(Code::OpenParameter, *ty, format!("a member's {what} cannot be left open"))
                .note("`_` stands for any layout, and for nothing else")
                .help("write them out, or take a type parameter");
        }
    }
    let value = arguments.first().filter(|ty| !open(ty)).map_or_else(|| quote!(f32), |ty| quote!(#ty));
    let axes = arguments.get(2).filter(|ty| !open(ty)).map_or_else(|| quote!(::allotrope::I), |ty| quote!(#ty));
    let layout = arguments.get(1).filter(|ty| !open(ty)).map(|layout| quote!(, Layout = #layout));
    let span = segment.ident.span();
    let opened = quote_spanned!(span=> impl ::allotrope::Readable<#value, #axes #layout>);
    *parameter.ty = Type::Verbatim(opened);
    match &*parameter.pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => Some(name.ident.clone()),
        pat => {
            diagnostics
                .error(Code::FieldPattern, pat, "a member's parameter needs a plain name")
                .note("the function finds reads by the member's name")
                .help("write `name: Read<..>`");
            None
        }
    }
}

/// The walk that turns `q[index]` into reads.
struct Body<'a> {
    members: Vec<Ident>,
    diagnostics: &'a mut Diagnostics,
}

impl Body<'_> {
    fn is_member(&self, expr: &Expr) -> bool {
        name_of(expr).is_some_and(|name| self.members.contains(name))
    }

    /// Whether an assignment's left side is an element of a member, which is an error.
    fn refuse_write(&mut self, left: &Expr, whole: &dyn ToTokens) {
        let Some(target) = root(left).filter(|root| !root.part.is_empty() && self.members.contains(&root.name)) else {
            return;
        };
        let name = target.name;
        self.diagnostics
            .error(
                Code::SharedWrite,
                &whole.to_token_stream(),
                format!("`{name}` is written, and a `#[func]` only reads members"),
            )
            .note("the kernel that calls it takes the member to be read at any index")
            .help("return the value, and write it in the kernel");
    }
}

impl VisitMut for Body<'_> {
    fn visit_expr_mut(&mut self, expr: &mut Expr) {
        match &*expr {
            Expr::Assign(assign) => self.refuse_write(&assign.left, &assign),
            Expr::Binary(binary) if compound(&binary.op).is_some() => self.refuse_write(&binary.left, &binary),
            Expr::MethodCall(call) if call.method == "min_assign" || call.method == "max_assign" => {
                self.refuse_write(&call.receiver, &call);
            }
            _ => {}
        }
        let spot = Spot::new(expr);
        visit_mut::visit_expr_mut(self, expr);
        let Expr::Index(index) = &*expr else { return };
        if self.is_member(&index.expr) {
            let ends = Ends::of(&spot);
            let (member, index) = (bare(&index.expr), &index.index);
            *expr = Expr::Verbatim(ends.read(ends.call(member, "get", quote!(#index))));
        }
    }

    fn visit_pat_mut(&mut self, pat: &mut Pat) {
        if let Pat::Ident(name) = pat
            && self.members.contains(&name.ident)
        {
            let message = format!("`{}` is a member of this function and cannot be bound again", name.ident);
            self.diagnostics
                .error(Code::Rebinding, &name.ident, message)
                .note("the function tells reads apart by the names in them")
                .help("choose another name");
        }
        visit_mut::visit_pat_mut(self, pat);
    }

    fn visit_macro_mut(&mut self, call: &mut syn::Macro) {
        let mut mentioned = Vec::new();
        collect(call.tokens.clone(), &mut mentioned);
        let Some(name) = mentioned.iter().find(|name| self.members.contains(name)) else { return };
        let list = Punctuated::<Expr, Token![,]>::parse_terminated.parse2(call.tokens.clone());
        match list {
            Ok(mut list) if KNOWN.contains(&word(call).as_str()) => {
                list.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
                call.tokens = list.into_token_stream();
            }
            _ => {
                let message = format!(
                    "`{name}` is handed to the macro `{}!`, which the function does not know",
                    text(&call.path)
                );
                self.diagnostics
                    .error(Code::OpaqueMacro, &*call, message)
                    .note("the macro could hide a read")
                    .help("bind the value with `let` first, and hand that to the macro");
            }
        }
    }

    // Items have names of their own, and types hold no reads.
    fn visit_item_mut(&mut self, _: &mut syn::Item) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
}
