//! A parallel loop.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::Expr;

use super::names::{self, Ends, handle, hidden, label, numbered, paths, plain, private, span, still};
use super::rewrite::{Rewrite, Scope};
use super::{captures, contract, lanes, reductions};
use crate::kernel::access::{Plan, View, plan};
use crate::kernel::arithmetic::is_arithmetic;
use crate::kernel::key;
use crate::kernel::lanes::is_cut;
use crate::kernel::model::{Boundary, Branch, Call, Capture, Group, Head, Kernel, Loop, Sieve};

/// Of so many fields a body gets the memory. The runtime knows the number, too.
const MOST_STILL: usize = 4;

/// A loop under expansion.
pub(super) struct Launch<'a> {
    pub(super) kernel: &'a Kernel,
    pub(super) parallel: &'a Loop,
    pub(super) plan: Plan,
    held: Vec<&'a Capture>,
    /// Accesses relative to a checked base: the base's name and the offset.
    pub(super) based: BTreeMap<usize, (Ident, Expr)>,
    /// Accumulations around bases that do not lie within what may be reached.
    pub(super) far: BTreeSet<usize>,
    /// The views of those.
    pub(super) far_views: Rc<RefCell<BTreeSet<usize>>>,
    /// Where the blocks around checked bases are kept from one iteration to the next, each with its field's handle.
    pub(super) corners: Rc<RefCell<BTreeMap<Ident, TokenStream>>>,
}

impl Launch<'_> {
    /// What a captured name is replaced by.
    pub(super) fn captured(&self, name: &Ident) -> Option<TokenStream> {
        self.held.iter().find(|capture| capture.name == *name).map(|capture| captures::replacement(capture, name))
    }

    /// The local that holds a view. Its number tells it from all others, whatever the user's names are.
    pub(super) fn view_name(&self, number: usize) -> Ident {
        let planned = &self.plan.views[number];
        let path: String = planned.path.iter().map(|member| format!("_{}", plain(member))).collect();
        hidden(&format!("v{number}_{}{path}", plain(&self.kernel.fields[planned.field].name)))
    }

    /// The local that holds an own-index read of a member that a heavy loop only reads.
    pub(super) fn hoisted(&self, number: usize) -> Option<Ident> {
        let planned = &self.plan.views[number];
        let own = self.parallel.head.field() == Some(planned.field);
        let row = matches!(&planned.view, View::Row(offset) if offset.iter().all(|o| *o == 0));
        let plain = !self.parallel.unchecked.contains_key(&planned.field);
        (own && row && plain && !self.plan.light).then(|| numbered("h", number))
    }

    /// The base and offset of an access, where a base is checked.
    pub(super) fn based(&self, node: usize) -> Option<(Ident, TokenStream)> {
        self.based.get(&node).map(|(base, offset)| (base.clone(), offset.to_token_stream()))
    }
}

/// The tokens of a launch.
pub(super) fn launch(kernel: &Kernel, number: usize) -> TokenStream {
    let parallel = &kernel.loops[number];
    let launch = Launch {
        kernel,
        parallel,
        plan: plan(kernel, number),
        held: captures::held(parallel),
        based: BTreeMap::new(),
        far: BTreeSet::new(),
        far_views: Rc::default(),
        corners: Rc::default(),
    };
    let private = private();
    let (space, fits, task, run) = (hidden("space"), hidden("fits"), hidden("task"), hidden("run"));
    let (handles, boxes) = (launch.handles(), launch.boxes());
    let (bounds, over) = launch.space();
    let (fits_value, always_fits) = launch.fits();
    let pieces = reductions::pieces(parallel);
    let (before, partials, result, combines) = (&pieces.before, &pieces.partials, &pieces.result, &pieces.combines);
    let assert_shared = captures::assert_shared(parallel);
    let hold = captures::hold(parallel);
    let hold_traits = (!hold.is_empty()).then(|| quote!(use #private::{Hold as _, Lend as _};));
    let space_trait = (!always_fits).then(|| quote!(use #private::Space as _;));
    let wraps = launch.wraps();
    let options = launch.options(number);
    let key = key::key(kernel, number, &launch.plan).map(|key| launch.key(&key));
    let entry = match (&key, always_fits) {
        (Some(_), true) => quote!(launch_inside_keyed),
        (Some(_), false) => quote!(launch_keyed),
        (None, true) if launch.plan.targets.is_empty() => quote!(launch_own),
        (None, true) => quote!(launch_inside),
        (None, false) => quote!(launch),
    };
    let key = key.map(|key| quote!(#key,));
    let copies = launch.copies();
    let contract = kernel.contract.then(|| contract::prepare(&task));
    let (hide, settles) = (launch.hide_fields(), launch.settles());
    let targets = launch.targets();
    let any_views = launch.any_views(&|_| true);
    let rows = if launch.plan.written_out { quote!(rows) } else { quote!(runs) };
    let body = launch.run(&pieces);
    let far_views =
        launch.far_views.take().into_iter().filter(|&view| launch.plan.views[view].view == View::Accumulate);
    let far_views = far_views.map(|view| {
        let name = launch.view_name(view);
        let far = Ident::new(&format!("{name}_far"), name.span());
        quote!(let #far = #name.far();)
    });
    let far_views: TokenStream = far_views.collect();
    let known = launch.corners.take();
    let corners = known.iter().map(|(name, handle)| quote!(let #name = #handle.corners();));
    let attributes = &parallel.attributes;
    let (outs, out) = (hidden("outs"), hidden("out"));
    let (outs, combine) = if parallel.reductions.is_empty() {
        (TokenStream::new(), TokenStream::new())
    } else {
        (quote!(let #outs =), quote!(for #out in #outs { #combines }))
    };
    let tokens = quote! {
        {
            #hold_traits
            #space_trait
            #bounds
            #handles
            #boxes
            let #space = #over;
            let #fits = #fits_value;
            #before
            #assert_shared
            #wraps
            #outs #private::#entry(&#space, #options, #key #[inline(always)] |#task| {
                #contract
                #copies
                #hold
                #hide
                #any_views
                #far_views
                #targets
                #(#corners)*
                #partials
                #task.#rows(#[inline(always)] |#run| { #body });
                #result
            });
            #settles
            #combine
        }
    };
    // Attributes may stand on statements alone, and the loop could be its block's value.
    if attributes.is_empty() { tokens } else { quote!({ #(#attributes)* #tokens; }) }
}

impl Launch<'_> {
    fn handles(&self) -> TokenStream {
        let private = private();
        let kernel = plain(&self.kernel.function.sig.ident);
        let handles = self.plan.fields.iter().map(|(number, changes)| {
            let field = &self.kernel.fields[*number];
            let (handle, name, text) = (handle(field), &field.name, plain(&field.name));
            let site = quote!(&#private::Site { kernel: #kernel, field: #text });
            let path = field.storage.is_opaque().then(|| {
                let path = names::path(field);
                quote!(let #path = #private::path(&*#name);)
            });
            let still = self.still(*number).map(|_| {
                let still = still(&handle);
                quote!(let #still = #private::still(&*#name);)
            });
            match changes {
                true => quote!(#path let #handle = #private::exclusive(&mut *#name, #site);),
                false => quote!(#path let #handle = #private::shared(&*#name, #site); #still),
            }
        });
        handles.collect()
    }

    /// The place of a field's memory among those of which the body gets it: the first that the loop only reads.
    fn still(&self, field: usize) -> Option<usize> {
        let unchanged = self.plan.fields.iter().filter(|(_, changes)| !**changes).take(MOST_STILL);
        unchanged.enumerate().find_map(|(place, (&other, _))| (other == field).then_some(place))
    }

    /// The tag of a member.
    pub(super) fn tag(&self, field: usize, path: &[Ident]) -> TokenStream {
        let field = &self.kernel.fields[field];
        let (handle, whole) = (handle(field), names::path(field).to_token_stream());
        names::tag(field, &quote!(#handle.tags()), &whole, path)
    }

    /// What is evaluated before the loop takes its fields, and the space.
    fn space(&self) -> (TokenStream, TokenStream) {
        self.space_of(&self.parallel.head)
    }

    fn space_of(&self, head: &Head) -> (TokenStream, TokenStream) {
        let private = private();
        let host = Rewrite { kernel: self.kernel, scope: Scope::Host };
        match head {
            Head::Field(branch) => (TokenStream::new(), self.branch(branch, None)),
            Head::Interior { branch, width } => {
                let value = host.expr(width);
                if matches!(**width, Expr::Lit(_)) {
                    return (TokenStream::new(), self.branch(branch, Some(value)));
                }
                let local = Ident::new("__width", Span::mixed_site().located_at(span(width)));
                (quote!(let #local = #value;), self.branch(branch, Some(quote!(#local))))
            }
            Head::Sifted { base, sieve } => {
                let (bounds, space) = self.space_of(base);
                let at = match sieve {
                    Sieve::Border(at) | Sieve::Checkerboard(at) | Sieve::Colored(_, at) => span(at),
                };
                let sift = Ident::new("sift", Span::call_site().located_at(at));
                if let (Sieve::Border(width), Some(field)) = (sieve, head.field()) {
                    let (handle, value) = (handle(&self.kernel.fields[field]), host.expr(width));
                    let width = Ident::new("__width", Span::mixed_site().located_at(at));
                    let space = quote!(#private::#sift(#space, #handle.border(#width)));
                    return (quote!(#bounds let #width = #value;), space);
                }
                let (colour, value) = (hidden("colour"), colour_of(&host, sieve));
                (quote!(#bounds let #colour = #value;), quote!(#private::#sift(#space, #colour)))
            }
            Head::Ranges(ranges) => {
                let ranges = ranges.iter().map(|(start, end)| {
                    let (start, end) = (host.expr(start), host.expr(end));
                    quote!((#start)..(#end),)
                });
                let local = hidden("range");
                (quote!(let #local = #private::range((#(#ranges)*));), quote!(#local))
            }
            Head::Row { .. } | Head::Invalid => unreachable!("a kernel with an invalid head is not expanded"),
        }
    }

    /// All elements of a field but a border, in the order of one branch.
    fn branch(&self, branch: &Branch, width: Option<TokenStream>) -> TokenStream {
        let (private, handle) = (private(), handle(&self.kernel.fields[branch.field]));
        // A single member is of one branch, which its type tells.
        let whole = branch.path.is_empty() && !self.kernel.fields[branch.field].storage.is_opaque();
        match (whole, width) {
            (true, None) => quote!(#private::over(#handle)),
            (true, Some(width)) => quote!(#private::interior(#handle, #width)),
            (false, width) => {
                let tag = self.tag(branch.field, &branch.path);
                let width = width.unwrap_or_else(|| quote!(0));
                quote!(#private::of_branch(#handle, #tag, #width))
            }
        }
    }

    /// Whether all rows lie within their fields, and whether that needs no check.
    fn fits(&self) -> (TokenStream, bool) {
        let space = hidden("space");
        let mut checks: Vec<_> = self
            .plan
            .reach
            .iter()
            .map(|(field, (low, high))| {
                let handle = handle(&self.kernel.fields[*field]);
                let (low, high) = (self.offset(low), self.offset(high));
                quote!(#space.fits(#handle, #low, #high))
            })
            .collect();
        checks.extend(self.box_checks(&space));
        if checks.is_empty() {
            return (quote!(true), true);
        }
        if self.kernel.unchecked {
            let unchecked = names::unchecked();
            // That blocks are aligned is no bound, and nobody has promised it.
            let aligned = self.plan.reach.keys().map(|field| {
                let handle = handle(&self.kernel.fields[*field]);
                quote!(#space.aligned(#handle))
            });
            return (quote!(#(#aligned)&&* && #unchecked.fits(|| #(#checks)&&*)), false);
        }
        (quote!(#(#checks)&&*), false)
    }

    /// The checks that reads across the edges lead to the other colour.
    fn wraps(&self) -> TokenStream {
        let mut told: Vec<(usize, &[i32])> = Vec::new();
        let mut checks = TokenStream::new();
        for &node in &self.parallel.accesses {
            let access = self.kernel.access(node);
            let View::Beside(offset) = &self.plan.views[self.plan.view_of[&node]].view else { continue };
            if !matches!(access.boundary, Boundary::Wrapped) || told.contains(&(access.field, offset.as_slice())) {
                continue;
            }
            told.push((access.field, offset));
            let ends = Ends::of(&access.target);
            let handle = ends.local(&handle(&self.kernel.fields[access.field]));
            let check = ends.call(&handle, "wraps_evenly", self.offset(offset));
            checks.extend(quote!(#check;));
        }
        checks
    }

    /// Offsets as an array; none stand for zeros over an unknown number of axes.
    pub(super) fn offset(&self, offset: &[i32]) -> TokenStream {
        if self.parallel.rank.is_none() {
            return quote!([]);
        }
        let offset = offset.iter().map(|offset| {
            let size = Literal::u32_unsuffixed(offset.unsigned_abs());
            if *offset < 0 { quote!(-#size) } else { quote!(#size) }
        });
        quote!([#(#offset),*])
    }

    /// How far along each axis rows reach; no axes where they do not, which the runtime knows by the type.
    pub(super) fn halo(&self) -> TokenStream {
        let halo = self.plan.halo.as_deref().unwrap_or_default();
        if halo.iter().all(|&reach| reach == 0) { quote!([]) } else { self.offset(halo) }
    }

    fn options(&self, number: usize) -> TokenStream {
        let private = private();
        let kernel = plain(&self.kernel.function.sig.ident);
        let (fits, heavy) = (hidden("fits"), !self.plan.light);
        let scatter = match &self.parallel.scatter {
            Some(scatter) => {
                quote_spanned!(scatter.span()=> ::core::option::Option::Some(::allotrope::Scatter::#scatter))
            }
            None => quote!(::core::option::Option::None),
        };
        let targets = self.plan.targets.iter().enumerate().map(|(slot, (field, members))| {
            let handle = handle(&self.kernel.fields[*field]);
            let members = members.iter().map(|(path, group)| {
                let (tag, op) = (self.tag(*field, path), op(*group));
                quote!((#handle.member(#tag), #private::Op::#op))
            });
            quote!(&#handle.target(#slot, &[#(#members),*]))
        });
        let mut together = Vec::new();
        for planned in self.plan.views.iter().filter(|planned| planned.view.is_together()) {
            let (handle, tag) = (handle(&self.kernel.fields[planned.field]), self.tag(planned.field, &planned.path));
            together.push(quote!(#handle.is_aligned(#tag)));
        }
        let together = match together.as_slice() {
            [] => quote!(::core::option::Option::None),
            together => quote!(::core::option::Option::Some(#(#together)&&*)),
        };
        let mut known: Vec<_> = self
            .plan
            .fields
            .keys()
            .filter(|field| self.still(**field).is_some())
            .map(|field| {
                let still = still(&handle(&self.kernel.fields[*field]));
                quote!(#still.memory())
            })
            .collect();
        known.resize(MOST_STILL, quote!(&[]));
        let ordered = self.parallel.topology.iter().any(|topology| topology.call == Call::Append);
        quote! {
            #private::Options {
                kernel: #kernel, number: #number, fits: #fits, heavy: #heavy, scatter: #scatter, targets: &[#(#targets),*], still: [#(#known),*], together: #together, ordered: #ordered
            }
        }
    }

    /// Copies of the handles in the job's frame.
    pub(super) fn copies(&self) -> TokenStream {
        let task = hidden("task");
        let copies = self.plan.fields.keys().map(|field| {
            let handle = handle(&self.kernel.fields[*field]);
            let (paths, still) = (paths(&handle), still(&handle));
            let of_job = match self.still(*field) {
                Some(place) => quote!(of_task(&#paths, &#task, #place, &#still)),
                None => quote!(of_job(&#paths)),
            };
            quote!(let #paths = #handle.paths(); let #handle = #handle.#of_job;)
        });
        copies.collect()
    }

    /// Hides the fields' names, so that what was not rewritten does not compile.
    pub(super) fn hide_fields(&self) -> TokenStream {
        let private = private();
        let names: Vec<_> = self.kernel.fields.iter().map(|field| &field.name).collect();
        if names.is_empty() {
            return TokenStream::new();
        }
        quote!(#(let #names = #private::NotAnAccess;)* let _ = (#(&#names,)*);)
    }

    /// What of a field this job may reach: of its copy, perhaps, where it accumulates.
    pub(super) fn accumulated(&self, field: usize) -> TokenStream {
        let handle = handle(&self.kernel.fields[field]);
        match self.plan.targets.iter().position(|(target, _)| *target == field) {
            Some(slot) => numbered("target", slot).into_token_stream(),
            None => quote!(#handle.all()),
        }
    }

    /// What this job accumulates into.
    fn targets(&self) -> TokenStream {
        let task = hidden("task");
        let targets = self.plan.targets.iter().enumerate().map(|(slot, (field, _))| {
            let (target, handle) = (numbered("target", slot), handle(&self.kernel.fields[*field]));
            quote!(let #target = #handle.of_target(&#task, #slot);)
        });
        targets.collect()
    }

    /// The views that hold for the whole job, of those that are wanted.
    pub(super) fn any_views(&self, wanted: &dyn Fn(usize) -> bool) -> TokenStream {
        let task = hidden("task");
        let views =
            self.plan.views.iter().enumerate().filter(|(number, _)| wanted(*number)).map(|(number, planned)| {
                let (name, handle) = (self.view_name(number), handle(&self.kernel.fields[planned.field]));
                let tag = self.tag(planned.field, &planned.path);
                match &planned.view {
                    View::Any => quote!(let #name = #handle.read(#tag);),
                    View::OwnFree => quote!(let #name = #handle.own_free(&#task, #tag);),
                    View::Accumulate => {
                        let slot = self.plan.targets.iter().position(|(field, _)| *field == planned.field);
                        let slot = slot.unwrap_or_default();
                        quote!(let #name = #handle.accumulate(&#task, #slot, #tag);)
                    }
                    View::Beside(offset) => {
                        let offset = self.offset(offset);
                        quote!(let #name = #handle.beside(&#task, #tag, #offset);)
                    }
                    View::Together => quote!(let #name = #handle.together(&#task, #tag);),
                    View::AccumulateTogether => quote!(let #name = #handle.accumulate_together(&#task, #tag);),
                    View::Own | View::Row(_) => TokenStream::new(),
                }
            });
        views.collect()
    }

    /// The views of a run that are wanted: what makes them, what ends them, and what is read at the start of an element.
    pub(super) fn run_views(&self, wanted: &dyn Fn(usize) -> bool) -> (TokenStream, TokenStream, TokenStream) {
        let (run, cell) = (hidden("run"), hidden("cell"));
        let (mut views, mut flushes, mut hoists) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
        for (number, planned) in self.plan.views.iter().enumerate().filter(|(number, _)| wanted(*number)) {
            let (name, handle) = (self.view_name(number), handle(&self.kernel.fields[planned.field]));
            let (tag, private) = (self.tag(planned.field, &planned.path), private());
            let whose = match self.parallel.head.field() == Some(planned.field) {
                true => quote!(#private::OfLoop),
                false => quote!(#private::Other),
            };
            match &planned.view {
                View::Own if self.holds_back(planned.field) => {
                    let buffer = numbered("buffer", number);
                    views.extend(
                        quote!(let #buffer = #private::buffer(); let #name = #handle.held(&#run, #tag, &#buffer, #whose);),
                    );
                    flushes.extend(quote!(#name.flush(&#run);));
                }
                View::Own => views.extend(quote!(let #name = #handle.own(&#run, #tag, #whose);)),
                View::Row(offset) => {
                    let (offset, copy) = (self.offset(offset), numbered("copy", number));
                    views.extend(quote!(let #copy = #private::buffer(); let #name = #handle.row(&#run, #tag, #offset, #whose, &#copy);));
                }
                _ => {}
            }
            if let Some(hoisted) = self.hoisted(number) {
                hoists.extend(quote!(let #hoisted = #name.get(&#cell);));
            }
        }
        (views, flushes, hoists)
    }

    /// What happens in a run: its views, and its elements.
    fn run(&self, pieces: &reductions::Pieces) -> TokenStream {
        let (run, cell) = (hidden("run"), hidden("cell"));
        let (views, flushes, hoists) = self.run_views(&|_| true);
        let halo = self.halo();
        let variables = self.variables();
        let rewrite = Rewrite { kernel: self.kernel, scope: Scope::Parallel(self) };
        let body = rewrite.block(&self.parallel.body);
        let element = label("element");
        let body = if self.parallel.continues { quote!(#element: #body) } else { body };
        let reductions::Pieces { strips, identities, puts, absorbs, .. } = pieces;
        let element = quote!(#variables #hoists #identities #body #puts);
        let each = match self.width().map(Literal::usize_unsuffixed) {
            Some(width) => {
                let (private, part, batch) = (private(), hidden("part"), hidden("batch"));
                let lanes = lanes::body(self, rewrite, pieces, hoists);
                quote! {
                    #run.batches(#private::Width::<#width>, #halo, #[inline(always)] |#part| match #part {
                        #private::Part::Batch(#batch) => { #lanes }
                        #private::Part::Cell(#cell) => { #element }
                    });
                }
            }
            None if !self.plan.views.is_empty() && is_arithmetic(self.kernel, self.parallel, &self.plan) => {
                let views = (0..self.plan.views.len()).map(|number| self.view_name(number));
                quote!(#run.each_or_all(#halo, #(#views.is_float())&&*, #[inline(always)] |#cell| { #element });)
            }
            None => {
                let each = if self.plan.written_out { quote!(each) } else { quote!(each_of_pieces) };
                quote!(#run.#each(#halo, #[inline(always)] |#cell| { #element });)
            }
        };
        let each = if self.parallel.reductions.is_empty() {
            each
        } else {
            quote!(#run.strips(#[inline(always)] |#run| { #strips #each #absorbs });)
        };
        quote!(#views #each #flushes)
    }

    /// How many elements go through the body together.
    pub(super) fn width(&self) -> Option<usize> {
        self.kernel.lanes.as_ref().filter(|_| is_cut(&self.parallel.body))?.lanes
    }

    /// Whether what is written to a field waits until the end of a run: where rows are read from elsewhere, which the compiler cannot tell
    /// from the written ones.
    fn holds_back(&self, field: usize) -> bool {
        let apart = self.plan.views.iter().any(|planned| match &planned.view {
            View::Row(offset) => planned.field != field || offset.iter().any(|o| *o != 0),
            View::Own => planned.field != field,
            _ => false,
        });
        self.plan.light && apart && !self.plan.overlapping.contains(&field)
    }

    /// Binds the loop's variables.
    pub(super) fn variables(&self) -> TokenStream {
        let cell = hidden("cell");
        let patterns =
            self.parallel.variables.iter().map(|name| name.as_ref().map_or_else(|| quote!(_), |name| quote!(#name)));
        let names: Vec<_> = self.parallel.variables.iter().flatten().collect();
        let used = (!names.is_empty()).then(|| quote!(let _ = (#(&#names,)*);));
        if self.parallel.tuple {
            quote!(let (#(#patterns,)*) = #cell.tuple(); #used)
        } else {
            quote!(#(let #patterns = #cell.index();)* #used)
        }
    }
}

/// The sieve of a colour, whose panics stand at the user's tokens.
pub(super) fn colour_of(rewrite: &Rewrite<'_>, sieve: &Sieve) -> TokenStream {
    let private = private();
    let (name, arguments, at) = match sieve {
        Sieve::Border(_) => unreachable!("a border has no colour"),
        Sieve::Checkerboard(colour) => (quote!(Checkerboard), rewrite.expr(colour), span(colour)),
        Sieve::Colored(modulus, colour) => {
            let (modulus, value) = (rewrite.expr(modulus), rewrite.expr(colour));
            (quote!(Colored), quote!(#modulus, #value), span(colour))
        }
    };
    let new = Ident::new("new", Span::call_site().located_at(at));
    quote!(#private::#name::#new(#arguments))
}

fn op(group: Group) -> TokenStream {
    match group {
        Group::Sum => quote!(Add),
        Group::Product => quote!(Mul),
        Group::Min => quote!(Min),
        Group::Max => quote!(Max),
        Group::And => quote!(And),
        Group::Or => quote!(Or),
        Group::Xor => quote!(Xor),
    }
}

impl<'a> Launch<'a> {
    /// The same launch in a stretch where more bases are checked.
    pub(super) fn with_based(&self, based: BTreeMap<usize, (Ident, Expr)>) -> Launch<'a> {
        Launch {
            kernel: self.kernel,
            parallel: self.parallel,
            plan: self.plan.clone(),
            held: self.held.clone(),
            based,
            far: self.far.clone(),
            far_views: Rc::clone(&self.far_views),
            corners: Rc::clone(&self.corners),
        }
    }

    /// The same launch where bases do not lie within what may be reached.
    pub(super) fn with_far(&self, far: BTreeSet<usize>) -> Launch<'a> {
        Launch { far: &self.far | &far, ..self.with_based(self.based.clone()) }
    }
}
