//! Calls that ask which elements of a field are active, and change it.

use proc_macro2::TokenStream;
use quote::quote;

use super::launch::Launch;
use super::names::{Ends, handle};
use super::rewrite::{Rewrite, Scope};
use crate::kernel::model::{Call, Topology};

/// A call in a parallel loop or outside.
pub(super) fn call(rewrite: &Rewrite<'_>, topology: &Topology) -> TokenStream {
    let arguments: Vec<_> = topology.arguments.iter().map(|argument| rewrite.expr(argument)).collect();
    let (ends, field) = (Ends::of(&topology.spot), &rewrite.kernel.fields[topology.field]);
    let name = match topology.call {
        Call::RowLen => "row_len".to_owned(),
        _ => topology.method.to_string(),
    };
    let Scope::Parallel(launch) = rewrite.scope else {
        return ends.call(&field.name, &name, quote!(#(#arguments),*));
    };
    let handle = ends.local(&handle(field));
    if topology.call.is_of_lists() {
        return ends.call(&handle, &name, quote!(#(#arguments),*));
    }
    let tag = launch.tag(topology.field, &topology.path);
    ends.call(&handle, &name, quote!(#tag, #(#arguments),*))
}

impl Launch<'_> {
    /// Makes inactive what the loop has deactivated and removed, when it has ended.
    pub(super) fn settles(&self) -> TokenStream {
        let mut fields: Vec<usize> = Vec::new();
        for topology in self.parallel.topology.iter().filter(|topology| topology.call.is_deferred()) {
            if !fields.contains(&topology.field) {
                fields.push(topology.field);
            }
        }
        let handles = fields.iter().map(|field| handle(&self.kernel.fields[*field]));
        quote!(#(#handles.settle();)*)
    }
}
