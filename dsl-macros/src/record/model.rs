//! What the user meant: a name and members, with their spans.

use syn::{Data, DeriveInput, Fields, Generics, Ident, Type, Visibility};

/// A struct that is to be a record.
pub(super) struct Record<'a> {
    pub(super) name: &'a Ident,
    pub(super) generics: &'a Generics,
    pub(super) members: Vec<Member<'a>>,
}

/// One member of a record.
pub(super) struct Member<'a> {
    pub(super) name: &'a Ident,
    pub(super) visibility: &'a Visibility,
    pub(super) element: &'a Type,
}

/// The record in an item; an item that is no struct with named fields has no members.
pub(super) fn model(item: &DeriveInput) -> Record<'_> {
    let members = match &item.data {
        Data::Struct(data) => match &data.fields {
            Fields::Named(fields) => fields
                .named
                .iter()
                .filter_map(|field| {
                    Some(Member { name: field.ident.as_ref()?, visibility: &field.vis, element: &field.ty })
                })
                .collect(),
            Fields::Unnamed(_) | Fields::Unit => Vec::new(),
        },
        Data::Enum(_) | Data::Union(_) => Vec::new(),
    };
    Record { name: &item.ident, generics: &item.generics, members }
}
