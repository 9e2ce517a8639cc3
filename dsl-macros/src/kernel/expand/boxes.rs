//! Indices that are checked once a launch, box against box: multiples of the loop's variables.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::Index;

use super::launch::Launch;
use super::names::{handle, numbered, private};
use crate::kernel::access::View;
use crate::kernel::model::{Access, Linear, Place, Slot};

impl Launch<'_> {
    /// The places of each box, evaluated before the loop.
    pub(super) fn boxes(&self) -> TokenStream {
        let boxes = self.plan.boxes.iter().enumerate().map(|(number, (_, places))| {
            let (name, own) = (box_name(number), self.owns(number));
            let places = places.iter().map(|place| self.box_place(place, own));
            quote!(let #name = (#(#places,)*);)
        });
        boxes.collect()
    }

    /// Whether an access of a box is to an iteration's own element.
    fn owns(&self, number: usize) -> bool {
        let of = |node: &usize| self.plan.views[self.plan.view_of[node]].view == View::OwnFree;
        self.plan.box_of.iter().any(|(node, found)| *found == number && of(node))
    }

    fn box_place(&self, place: &Linear, own: bool) -> TokenStream {
        let private = private();
        if let (true, Linear { variable: Some((variable, 1)), offset: 0, name: None }) = (own, place) {
            return quote!(#private::Var::<#variable>);
        }
        let (variable, factor) = place.variable.unwrap_or((0, 0));
        let (factor, constant) = (Literal::i32_unsuffixed(factor), Literal::i32_unsuffixed(place.offset));
        let mut offset = quote!(#constant);
        let mut moved = (0, 0);
        if let Some(added) = &place.name {
            match added.range {
                Some((start, end)) if added.subtracted => moved = (-(end - 1), -start),
                Some((start, end)) => moved = (start, end - 1),
                None => {
                    let name = &added.name;
                    let sum = if added.subtracted { quote!(saturating_sub) } else { quote!(saturating_add) };
                    offset = quote!(i64::#sum(#constant, #private::wide(#name)));
                }
            }
        }
        let (low, high) = (Literal::i32_unsuffixed(moved.0), Literal::i32_unsuffixed(moved.1));
        quote!(#private::Linear::<#variable>::new(#factor, #offset, #low, #high))
    }

    /// The checks of all boxes.
    pub(super) fn box_checks(&self, space: &Ident) -> Vec<TokenStream> {
        let check = |(number, (field, _)): (usize, &(usize, Vec<Linear>))| {
            let (name, handle) = (box_name(number), handle(&self.kernel.fields[*field]));
            quote!(#space.holds(#handle, #name))
        };
        self.plan.boxes.iter().enumerate().map(check).collect()
    }

    /// The places of an access that was checked with its box, and a closure that sees to the types of its names.
    pub(super) fn boxed(&self, node: usize, access: &Access, index: &TokenStream) -> Option<TokenStream> {
        let number = *self.plan.box_of.get(&node)?;
        let (name, private) = (box_name(number), private());
        let places = &self.plan.boxes[number].1;
        let parts = places.iter().enumerate().map(|(place, linear)| {
            let part = Index::from(place);
            match &linear.name {
                Some(added) if added.range.is_some() => {
                    let (moved, minus) = (&added.name, added.subtracted.then(|| quote!(-)));
                    quote!(#name.#part.by(#minus #private::wide(#moved)))
                }
                _ => quote!(#name.#part),
            }
        });
        let parts = quote!(#private::Boxed((#(#parts,)*)));
        let named = places.iter().any(|place| place.name.is_some());
        // Variables in an own index stand by themselves.
        let plain =
            matches!(&access.place, Place::Places(slots) if !slots.iter().any(|slot| matches!(slot, Slot::Free)));
        Some(if named && !plain { quote!({ let _ = || #index; #parts }) } else { parts })
    }
}

fn box_name(number: usize) -> Ident {
    numbered("box", number)
}
