//! The parameters' types: `_` for a layout becomes an argument-position `impl`, and so does a member of any record.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{FnArg, GenericArgument, PathArguments, Signature, Type, parse_quote};

use super::names::private;
use crate::kernel::model::{FieldParam, Kernel, Storage};
use crate::kernel::parse::is_marked;
use crate::kernel::syntax::{bare_type, last_segment, type_arguments};

/// Opens every `_` that stands for a field's layout, and every member's record. `listed` tells which parameters' layouts have lists.
pub(crate) fn open_layouts(signature: &mut Signature, listed: impl Fn(&str) -> bool) {
    for input in &mut signature.inputs {
        if let FnArg::Typed(parameter) = input {
            let marked = is_marked(parameter);
            parameter.attrs.retain(|attribute| !attribute.path().is_ident("field"));
            let (referring, changed) = match bare_type(&parameter.ty) {
                Type::Reference(reference) => (true, reference.mutability.is_some()),
                _ => (false, false),
            };
            let listed = matches!(&*parameter.pat, syn::Pat::Ident(name) if listed(&name.ident.to_string()));
            OpenLayouts { referring, changed, marked, listed }.visit_type_mut(&mut parameter.ty);
        }
    }
}

/// Checks, at each slice's type, that a kernel can use it as a field.
pub(super) fn assert_slices(kernel: &Kernel) -> TokenStream {
    let private = private();
    let element = |field: &FieldParam| match &field.ty {
        Type::Reference(reference) => match bare_type(&reference.elem) {
            Type::Slice(slice) if field.storage == Storage::Slice => Some((*slice.elem).clone()),
            _ => None,
        },
        _ => None,
    };
    let elements = kernel.fields.iter().filter_map(element);
    elements.map(|element| quote_spanned!(element.span()=> #private::assert_packed::<#element>();)).collect()
}

struct OpenLayouts {
    /// Whether the parameter is taken by reference.
    referring: bool,
    /// Whether the parameter is taken by `&mut`.
    changed: bool,
    /// Whether it bears `#[field]`.
    marked: bool,
    /// Whether its lists are used.
    listed: bool,
}

impl OpenLayouts {
    /// `Member<T, L, X>` is `impl AnyMember<T, X, Layout = L>`.
    fn member(&self, ty: &Type) -> Option<Type> {
        let segment = last_segment(ty).filter(|segment| segment.ident == "Member")?;
        let PathArguments::AngleBracketed(all) = &segment.arguments else { return None };
        let mut arguments = type_arguments(segment);
        let open = Type::Verbatim(quote!(_));
        if arguments.len() != all.args.len() || arguments.len() < 2 {
            arguments = vec![&open];
        }
        let (&value, layout) = (arguments.first()?, arguments.get(1));
        let any = if self.changed { quote!(AnyMemberMut) } else { quote!(AnyMember) };
        // What is left open here is an error that is told, and rustc need not repeat it.
        let value = if matches!(value, Type::Infer(_) | Type::Verbatim(_)) { quote!(f32) } else { quote!(#value) };
        let axes = match arguments.get(2) {
            Some(axes) if !matches!(axes, Type::Infer(_)) => quote!(#axes),
            _ => quote!(::allotrope::I),
        };
        let layout = layout.filter(|layout| !matches!(layout, Type::Infer(_))).map(|layout| quote!(, Layout = #layout));
        let unsized_too = self.referring.then(|| quote!(+ ?Sized));
        let span = segment.ident.span();
        Some(Type::Verbatim(quote_spanned!(span=> (impl ::allotrope::#any<#value, #axes #layout> #unsized_too))))
    }
}

impl VisitMut for OpenLayouts {
    fn visit_type_mut(&mut self, ty: &mut Type) {
        visit_mut::visit_type_mut(self, ty);
        if self.marked && matches!(ty, Type::Infer(_)) {
            *ty = parse_quote!(::allotrope::layout::Aos);
        }
        if let Some(member) = self.member(ty) {
            *ty = member;
        }
    }

    fn visit_path_segment_mut(&mut self, segment: &mut syn::PathSegment) {
        visit_mut::visit_path_segment_mut(self, segment);
        let PathArguments::AngleBracketed(arguments) = &mut segment.arguments else { return };
        if segment.ident != "Field" {
            return;
        }
        // Record and axes cannot be open: where they are, the error is told, and rustc need not repeat it.
        if let Some(GenericArgument::Type(record @ Type::Infer(_))) = arguments.args.first_mut() {
            *record = parse_quote!(f32);
        }
        if let Some(GenericArgument::Type(axes @ Type::Infer(_))) = arguments.args.get_mut(2) {
            *axes = parse_quote!(::allotrope::I);
        }
        let axes = match arguments.args.get(2) {
            Some(GenericArgument::Type(axes)) => quote!(#axes),
            _ => quote!(::allotrope::I),
        };
        if let Some(GenericArgument::Type(layout)) = arguments.args.get_mut(1)
            && matches!(layout, Type::Infer(_))
        {
            *layout = Type::Verbatim(match self.listed {
                true => quote!(impl ::allotrope::layout::ListLayout<#axes>),
                false => quote!(impl ::allotrope::Layout<#axes>),
            });
        }
    }
}
