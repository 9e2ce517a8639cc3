//! `_` for a layout becomes an argument-position `impl`.

use quote::quote;
use syn::visit_mut::{self, VisitMut};
use syn::{FnArg, GenericArgument, PathArguments, Signature, Type, parse_quote};

/// Opens every `_` that stands for a field's layout.
pub(crate) fn open_layouts(signature: &mut Signature) {
    for input in &mut signature.inputs {
        if let FnArg::Typed(parameter) = input {
            OpenLayouts.visit_type_mut(&mut parameter.ty);
        }
    }
}

struct OpenLayouts;

impl VisitMut for OpenLayouts {
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
            *layout = Type::Verbatim(quote!(impl ::allotrope::Layout<#axes>));
        }
    }
}
