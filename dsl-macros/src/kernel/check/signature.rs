//! The function and its parameters.

use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{FnArg, GenericArgument, Pat, PathArguments, Type};

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::{Kernel, Storage};
use crate::kernel::parse::{is_marked, storage};
use crate::kernel::syntax::{bare_type, last_segment, type_arguments};
use crate::kernel::text::{text, type_text};

pub(super) fn check(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    options(kernel, diagnostics);
    qualifiers(kernel, diagnostics);
    for input in &kernel.function.sig.inputs {
        if let FnArg::Typed(parameter) = input {
            self::parameter(parameter, diagnostics);
        }
    }
}

fn options(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    for option in &kernel.unknown_options {
        let word = option.clone().into_iter().next().map(|token| token.to_string()).unwrap_or_default();
        if ["grad", "finite"].contains(&word.as_str()) {
            let message = format!("`#[kernel({word})]` is not available in this version");
            diagnostics.error(Code::KernelOption, option, message).help("write `#[kernel]`");
        } else {
            let message = format!("`#[kernel]` has no option `{}`", text(option));
            diagnostics
                .error(Code::KernelOption, option, message)
                .help("write `#[kernel]`, `#[kernel(lanes = 16)]` to run loops with inner loops on vectors, `#[kernel(contract)]` to let `a * b + c` be rounded once, or `#[kernel(unchecked)]` to leave index checks out");
        }
    }
}

fn qualifiers(kernel: &Kernel, diagnostics: &mut Diagnostics) {
    let signature = &kernel.function.sig;
    let mut refuse = |word: &str, at: &dyn ToTokens, why: &str, cure: &str| {
        let message = format!("a kernel cannot be `{word}`");
        diagnostics.error(Code::KernelQualifier, &at.to_token_stream(), message).note(why).help(cure);
    };
    if let Some(word) = &signature.asyncness {
        let cure = "remove `async`; a caller may run the kernel in a task of its own";
        refuse(
            "async",
            word,
            "its loops run to their end before the next statement, and no thread may wait inside",
            cure,
        );
    }
    if let Some(word) = &signature.constness {
        refuse("const", word, "its loops start threads, which cannot be done at compile time", "remove `const`");
    }
    if let Some(word) = &signature.unsafety {
        let (why, cure) = if kernel.unchecked {
            ("`unchecked` makes it an `unsafe fn`, and the body stays safe code", "remove `unsafe`")
        } else {
            let cure = "remove `unsafe`; write an `unsafe` block around what needs it, or `#[kernel(unchecked)]`";
            ("every access is checked, so that callers have nothing to promise", cure)
        };
        refuse("unsafe", word, why, cure);
    }
    if let Some(word) = &signature.abi {
        let cure = "remove it, and call the kernel from an `extern` function";
        refuse("extern", word, "a field's type depends on its layout, which no other language can name", cure);
    }
}

fn parameter(parameter: &syn::PatType, diagnostics: &mut Diagnostics) {
    Open { diagnostics }.visit_type(&parameter.ty);
    let marked = is_marked(parameter);
    let (referring, inner) = match bare_type(&parameter.ty) {
        Type::Reference(reference) => (true, &*reference.elem),
        other => (false, other),
    };
    let Some(storage) = storage(inner, marked, || false) else {
        if last_segment(inner).is_some_and(|segment| segment.ident == "MemberMut") {
            diagnostics
                .error(Code::MemberType, &parameter.ty, "a kernel takes a member to change as `&mut Member<T, _, X>`")
                .note("`MemberMut` names the record and the layout that the member is of, and a kernel serves any")
                .help("write the type of its values and its axes: `&mut Member<f32, _, Ij>`");
        }
        return;
    };
    let ty = type_text(&parameter.ty);
    if !referring {
        let what = if storage == Storage::Member { "members" } else { "fields" };
        diagnostics
            .error(Code::FieldByValue, &parameter.ty, format!("a kernel takes its {what} by reference"))
            .help(format!("write `&{ty}` to read it or `&mut {ty}` to write it"));
    } else if !matches!(&*parameter.pat, Pat::Ident(_)) {
        let (what, example) = match storage {
            Storage::Member => ("member", "Member<..>"),
            Storage::Slice => ("slice", "[..]"),
            Storage::Field | Storage::Alias => ("field", "Field<..>"),
        };
        diagnostics
            .error(Code::FieldPattern, &parameter.pat, format!("a {what}'s parameter needs a plain name"))
            .note(format!("the kernel finds accesses by the {what}'s name"))
            .help(format!("write `name: &{example}`"));
    }
    match storage {
        Storage::Member => member(inner, diagnostics),
        Storage::Alias => AliasOpen { diagnostics }.visit_type(inner),
        Storage::Field | Storage::Slice => {}
    }
}

/// `Member<T, L, X>` names no record.
fn member(ty: &Type, diagnostics: &mut Diagnostics) {
    let Some(segment) = last_segment(ty) else { return };
    let PathArguments::AngleBracketed(arguments) = &segment.arguments else { return };
    let types = type_arguments(segment).len();
    if types != arguments.args.len() || !(2..=3).contains(&types) {
        diagnostics
            .error(
                Code::MemberType,
                ty,
                "a kernel's member names its values, its layout and its axes, and nothing else",
            )
            .note("which record it is a member of is left open, so that the kernel serves any")
            .help("write `Member<f32, _>`, or with axes `Member<f32, _, Ij>`");
    }
}

/// Finds `_` in an alias of a field.
struct AliasOpen<'a> {
    diagnostics: &'a mut Diagnostics,
}

impl Visit<'_> for AliasOpen<'_> {
    fn visit_type_infer(&mut self, open: &syn::TypeInfer) {
        self.diagnostics
            .error(Code::OpenParameter, open, "an alias of a field cannot be left open by `_`")
            .note("the kernel does not see which parameter of the alias is the layout, nor over which axes")
            .help("write `impl Layout<Ij>` with the field's axes in its place");
    }
}

/// Finds `_` where no layout stands.
struct Open<'a> {
    diagnostics: &'a mut Diagnostics,
}

impl Visit<'_> for Open<'_> {
    fn visit_path_segment(&mut self, segment: &syn::PathSegment) {
        visit::visit_path_segment(self, segment);
        let PathArguments::AngleBracketed(arguments) = &segment.arguments else { return };
        let (kind, holds) = match segment.ident.to_string().as_str() {
            "Field" => ("field", "record"),
            "Member" => ("member", "value"),
            _ => return,
        };
        for (place, argument) in arguments.args.iter().enumerate() {
            let what = match place {
                0 => holds,
                2 => "axes",
                _ => continue,
            };
            if let GenericArgument::Type(open @ Type::Infer(_)) = argument {
                let cure = if place == 0 && kind == "member" {
                    "write the type of its values; for any number, a type parameter `T: Real`"
                } else if place == 0 {
                    "write the record's type; for any record, a type parameter `R: Record`"
                } else {
                    "write `O`, `I`, `Ij`, `Ijk` or `Ijkl`; for any axes, a type parameter `X: Axes`"
                };
                self.diagnostics
                    .error(Code::OpenParameter, open, format!("a {kind}'s {what} cannot be left open"))
                    .note("`_` stands for any layout, and for nothing else")
                    .help(cure);
            }
        }
    }
}
