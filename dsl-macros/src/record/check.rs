//! The rules of records; every error is collected, none ends the check.

use syn::{Data, DeriveInput, Fields};

use crate::diagnostics::{Code, Diagnostics};

/// The most members that a record may have.
pub(super) const MOST_MEMBERS: usize = 24;

/// Reports all that keeps an item from being a record.
pub(super) fn check(item: &DeriveInput, errors: &mut Diagnostics) {
    let name = &item.ident;
    match &item.data {
        Data::Struct(data) => check_fields(item, &data.fields, errors),
        Data::Enum(data) => {
            errors
                .error(
                    Code::NotAStruct,
                    &data.enum_token,
                    format!("the enum `{name}` cannot be a record, since its values do not all have the same members"),
                )
                .help("write a struct with named members, one of them an integer that says which case it is");
        }
        Data::Union(data) => {
            errors
                .error(
                    Code::NotAStruct,
                    &data.union_token,
                    format!("the union `{name}` cannot be a record, since its members share their memory"),
                )
                .help("write a struct with named members");
        }
    }
    for lifetime in item.generics.lifetimes() {
        errors
            .error(
                Code::BorrowingRecord,
                lifetime,
                format!("the record `{name}` has a lifetime, and a field owns what it holds"),
            )
            .help("store an index into another field instead of a reference");
    }
}

fn check_fields(item: &DeriveInput, fields: &Fields, errors: &mut Diagnostics) {
    let name = &item.ident;
    match fields {
        Fields::Named(fields) => {
            if fields.named.is_empty() {
                errors
                    .error(
                        Code::MemberCount,
                        name,
                        format!("the record `{name}` has no members, so a field of it holds nothing"),
                    )
                    .help("give it a member");
            }
            for blank in fields.named.iter().filter_map(|field| field.ident.as_ref()).filter(|name| *name == "_") {
                errors
                    .error(Code::UnnamedMembers, blank, format!("a member of the record `{name}` has no name"))
                    .help("name it, as kernels must name what they access");
            }
            if let Some(surplus) = fields.named.iter().nth(MOST_MEMBERS) {
                let count = fields.named.len();
                errors
                    .error(
                        Code::MemberCount,
                        &surplus.ident,
                        format!("the record `{name}` has {count} members, and a record has {MOST_MEMBERS} at most"),
                    )
                    .help("join members of one type in an array, or make two records and two fields");
            }
        }
        Fields::Unnamed(fields) => {
            errors
                .error(
                    Code::UnnamedMembers,
                    fields,
                    format!("the members of the record `{name}` have no names, by which kernels could tell them apart"),
                )
                .help(format!("write `struct {name} {{ x: .. }}`"));
        }
        Fields::Unit => {
            errors
                .error(
                    Code::UnnamedMembers,
                    name,
                    format!("the record `{name}` has no members, so a field of it holds nothing"),
                )
                .help(format!("write `struct {name} {{ x: .. }}`"));
        }
    }
}
