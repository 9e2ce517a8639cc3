//! What stands in the place of a kernel with errors: a function of the same type, so that nothing follows in its callers.
//!
//! Where the errors are of threads alone, its body is that of the kernel with its loops on one thread, where no two accesses meet:
//! editors see the user's names and types in it, and rustc reports its own errors beside the macro's. Else it does nothing.

use proc_macro2::TokenStream;
use syn::visit::{self, Visit};
use syn::{ExprClosure, ExprMethodCall, ItemFn};

use super::model::Kernel;
use super::{check, expand, lower};
use crate::diagnostics::{Code, Diagnostics};

/// Errors that a kernel on one thread has not.
const OF_THREADS: &[Code] = &[
    Code::OutermostLoop,
    Code::InPlaceStencil,
    Code::PlainScatter,
    Code::AccumulateBesideRead,
    Code::MixedOperators,
    Code::OwnPlaces,
    Code::AccumulateBesideWrite,
    Code::OperatorScatter,
];

/// The function in the place of a kernel with these errors.
pub(super) fn function(function: ItemFn, kernel: &Kernel, diagnostics: &Diagnostics) -> TokenStream {
    let of_threads = diagnostics.codes().all(|code| OF_THREADS.contains(&code));
    let stays = of_threads && !kernel.unchecked && !needs_threads(&function);
    stays
        .then(|| on_one_thread(function.clone()))
        .flatten()
        .unwrap_or_else(|| expand::fallback(function, kernel.unchecked))
}

fn on_one_thread(function: ItemFn) -> Option<TokenStream> {
    let kernel = lower::lower_on_one_thread(function);
    let mut others = Diagnostics::default();
    check::check(&kernel, &mut others);
    others.is_empty().then(|| expand::in_refused(&kernel))
}

/// Whether a body may be right in parallel loops alone: closures share views there and would each borrow a field here, and
/// extremes of variables are of reductions.
fn needs_threads(function: &ItemFn) -> bool {
    struct Found(bool);
    impl Visit<'_> for Found {
        fn visit_expr_closure(&mut self, _: &ExprClosure) {
            self.0 = true;
        }
        fn visit_expr_method_call(&mut self, call: &ExprMethodCall) {
            self.0 |= call.method == "min_assign" || call.method == "max_assign";
            visit::visit_expr_method_call(self, call);
        }
    }
    let mut found = Found(false);
    found.visit_item_fn(function);
    found.0
}
