//! Variables from outside a parallel loop, held in the job's own frame.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::Ident;

use super::names::{Ends, hidden, plain, private};
use crate::kernel::model::{Capture, Loop};

/// The captures of a loop that can be held: their names mean one thing in all of it.
pub(super) fn held(parallel: &Loop) -> Vec<&Capture> {
    let single = |capture: &&Capture| {
        !parallel.bound.contains(&capture.name) && !parallel.hidden.contains(&capture.name.to_string())
    };
    parallel.captures.iter().filter(single).collect()
}

/// What a held name is replaced by where it is used.
pub(super) fn replacement(capture: &Capture, used: &Ident) -> TokenStream {
    let ends = Ends::at(used.span());
    let held = ends.local(&local(&capture.name));
    let inside = Span::mixed_site().located_at(used.span());
    let value = match capture.reference {
        true => quote_spanned!(inside=> #held.get()),
        false => quote_spanned!(inside=> *#held.get()),
    };
    ends.group(value, used.span()).into_token_stream()
}

/// Copies or lends each capture, in the job's frame.
pub(super) fn hold(parallel: &Loop) -> TokenStream {
    let private = private();
    held(parallel)
        .into_iter()
        .map(|capture| {
            let (local, name) = (local(&capture.name), &capture.name);
            match capture.reference {
                true => quote!(let #local = #private::Wrap(#name).hold();),
                false => quote!(let #local = #private::Wrap(&#name).hold();),
            }
        })
        .collect()
}

/// Checks, at the user's name, that each captured variable may be shared between threads.
pub(super) fn assert_shared(parallel: &Loop) -> TokenStream {
    let private = private();
    let captures = parallel.captures.iter();
    captures
        .map(|capture| {
            let name = &capture.name;
            quote_spanned!(name.span()=> #private::assert_shared(&#name);)
        })
        .collect()
}

fn local(name: &Ident) -> Ident {
    hidden(&format!("held_{}", plain(name)))
}
