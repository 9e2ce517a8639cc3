//! The function and its parameters.

use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{FnArg, GenericArgument, Pat, PathArguments, Type};

use crate::diagnostics::{Code, Diagnostics};
use crate::kernel::model::Kernel;
use crate::kernel::syntax::last_segment;
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
    if kernel.options.is_empty() {
        return;
    }
    let word = kernel.options.clone().into_iter().next().map(|token| token.to_string()).unwrap_or_default();
    if ["unchecked", "lanes", "grad", "finite"].contains(&word.as_str()) {
        let message = format!("`#[kernel({word})]` is not available in this version");
        diagnostics.error(Code::KernelOption, &kernel.options, message).help("write `#[kernel]`");
    } else {
        let message = format!("`#[kernel]` has no option `{}`", text(&kernel.options));
        diagnostics.error(Code::KernelOption, &kernel.options, message).help("write `#[kernel]` alone");
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
        let cure = "remove `unsafe`; write an `unsafe` block around what needs it";
        refuse("unsafe", word, "every access is checked, so that callers have nothing to promise", cure);
    }
    if let Some(word) = &signature.abi {
        let cure = "remove it, and call the kernel from an `extern` function";
        refuse("extern", word, "a field's type depends on its layout, which no other language can name", cure);
    }
}

fn parameter(parameter: &syn::PatType, diagnostics: &mut Diagnostics) {
    if let Some(attribute) = parameter.attrs.iter().find(|attribute| attribute.path().is_ident("field")) {
        let message = "`#[field]` on a parameter is not available in this version";
        diagnostics.error(Code::ParameterKind, attribute, message).help("write the parameter's type as `&Field<..>`");
    }
    Open { diagnostics }.visit_type(&parameter.ty);
    let inner = match &*parameter.ty {
        Type::Reference(reference) => &*reference.elem,
        other => other,
    };
    let name = last_segment(inner).map(|segment| segment.ident.to_string()).unwrap_or_default();
    match (name.as_str(), &*parameter.ty) {
        ("Member" | "MemberMut", _) => {
            diagnostics
                .error(
                    Code::ParameterKind,
                    &parameter.ty,
                    "a single member as a kernel's parameter is not available in this version",
                )
                .help("take the whole field: `&Field<R, _>`, and name the member in the kernel");
        }
        ("Field", Type::Reference(_)) if !matches!(&*parameter.pat, Pat::Ident(_)) => {
            diagnostics
                .error(Code::FieldPattern, &parameter.pat, "a field's parameter needs a plain name")
                .note("the kernel finds accesses by the field's name")
                .help("write `name: &Field<..>`");
        }
        ("Field", Type::Reference(_)) => {}
        ("Field", ty) => {
            let ty = type_text(ty);
            diagnostics
                .error(Code::FieldByValue, &parameter.ty, "a kernel takes its fields by reference")
                .help(format!("write `&{ty}` to read it or `&mut {ty}` to write it"));
        }
        _ => {}
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
        if segment.ident != "Field" {
            return;
        }
        for (place, argument) in arguments.args.iter().enumerate() {
            let what = match place {
                0 => "record",
                2 => "axes",
                _ => continue,
            };
            if let GenericArgument::Type(open @ Type::Infer(_)) = argument {
                let cure = if place == 0 {
                    "write the record's type; for any record, a type parameter `R: Record`"
                } else {
                    "write `O`, `I`, `Ij`, `Ijk` or `Ijkl`; for any axes, a type parameter `X: Axes`"
                };
                self.diagnostics
                    .error(Code::OpenParameter, open, format!("a field's {what} cannot be left open"))
                    .note("`_` stands for any layout, and for nothing else")
                    .help(cure);
            }
        }
    }
}
