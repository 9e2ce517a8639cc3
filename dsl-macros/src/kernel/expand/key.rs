//! Where the iterations of a loop accumulate, found before they run.

use proc_macro2::TokenStream;
use quote::quote;

use super::captures;
use super::launch::Launch;
use super::names::{handle, hidden, label, private};
use super::rewrite::{Rewrite, Scope};
use super::unroll::array;
use crate::kernel::key::{Key, Reach, Step};
use crate::kernel::syntax::names;

impl Launch<'_> {
    /// The key as an argument of the launch.
    pub(super) fn key(&self, key: &Key) -> TokenStream {
        let (private, space, slot, certain) = (private(), hidden("space"), key.slot, key.certain);
        let (task, run, cell, sink) = (hidden("task"), hidden("run"), hidden("cell"), hidden("sink"));
        let (low, high) = match &key.reach {
            Reach::All(low, high) => (array(&[*low]), array(&[*high])),
            Reach::Axes(axes) => {
                let (low, high): (Vec<_>, Vec<_>) = axes.iter().copied().unzip();
                (array(&low), array(&high))
            }
        };
        let wanted = |number: usize| key.reads.iter().any(|node| self.plan.view_of[node] == number);
        let (copies, hold, hide) = (self.copies(), captures::hold(self.parallel), self.hide_fields());
        let (any_views, (views, _, hoists)) = (self.any_views(&wanted), self.run_views(&wanted));
        let halo = self.halo();
        let (variables, element) = (self.variables(), label("element"));
        let rewrite = Rewrite { kernel: self.kernel, scope: Scope::Parallel(self) };
        let steps = key.steps.iter().map(|step| match step {
            Step::Let(local) => {
                let init = local.init.as_ref().map(|init| rewrite.expr(&init.expr));
                let (pat, mut bound) = (&local.pat, Vec::new());
                names(pat, &mut |name, _| bound.push(name.clone()));
                quote!(let #pat = #init; let _ = (#(&#bound,)*);)
            }
            Step::Guard(condition) => {
                let condition = rewrite.expr(condition);
                quote!(if #condition { break #element (::core::option::Option::None); })
            }
        });
        let target = handle(&self.kernel.fields[self.plan.targets[key.slot].0]);
        let index = key.index.as_ref().map_or_else(|| quote!(#cell.index()), |index| rewrite.expr(index));
        quote! {
            #private::key(&#space, #slot, #low, #high, #certain, &|#task, #sink| {
                #copies
                #hold
                #hide
                #any_views
                #task.runs(#[inline(always)] |#run| {
                    #views
                    #run.each(#halo, #[inline(always)] |#cell| {
                        #variables
                        #hoists
                        #sink.put(&#cell, #element: { #(#steps)* ::core::option::Option::Some(#target.key(#index)) });
                    });
                });
            })
        }
    }
}
