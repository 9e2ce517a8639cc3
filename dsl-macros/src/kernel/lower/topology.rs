//! Calls that ask which elements of a field are active, and change it.

use syn::Expr;
use syn::visit_mut::VisitMut;

use super::Lower;
use super::targets::Base;
use crate::kernel::model::{Call, Node, Place, Spot, Topology, What};
use crate::kernel::text::text;

/// The methods: what each does, how many arguments it takes, in words, and an example of them.
const METHODS: &[(&str, Call, usize, &str, &str)] = &[
    ("append", Call::Append, 2, "the index of a list and a record", "i, record"),
    ("try_append", Call::Append, 2, "the index of a list and a record", "i, record"),
    ("remove", Call::Remove, 1, "the index of an entry", "(i, k)"),
    ("activate", Call::Activate, 1, "one index", "(i, j)"),
    ("deactivate", Call::Deactivate, 1, "one index", "(i, j)"),
    ("is_active", Call::IsActive, 1, "one index", "(i, j)"),
    ("row_len", Call::RowLen, 1, "the index of a list", "i"),
    ("len", Call::RowLen, 1, "the index of a list", "i"),
];

impl Lower {
    /// `field.append(index, record)` and its like; `false` if it is none, or one that the top level calls as it is.
    pub(super) fn topology(&mut self, expr: &mut Expr, base: &Base) -> bool {
        let Expr::MethodCall(call) = &*expr else { return false };
        let name = call.method.to_string();
        let Some(&(_, kind, takes, words, example)) = METHODS.iter().find(|(known, ..)| *known == name) else {
            return false;
        };
        // `f.len()` counts all elements.
        if name == "len" && call.args.is_empty() {
            return false;
        }
        let (spot, method, receiver) = (Spot::new(expr), call.method.clone(), text(&call.receiver));
        let mut arguments: Vec<Expr> = call.args.iter().cloned().collect();
        let place = arguments.first().map_or(Place::Computed, |index| self.place(index));
        arguments.iter_mut().for_each(|argument| self.visit_expr_mut(argument));
        if arguments.len() != takes {
            let what = What::TopologyArguments { field: receiver, name, takes: words, example };
            self.find(what, &spot.tokens);
            return true;
        }
        if kind.is_of_lists() && !base.path.is_empty() {
            self.find(What::MemberAppend { field: base.field, name }, &spot.tokens);
            return true;
        }
        if !self.in_parallel_loop() && !kind.is_of_lists() && !base.path.is_empty() {
            // Outside of loops, members have no methods of this kind.
            return false;
        }
        let (field, path, span) = (base.field, base.path.clone(), spot.tokens.clone());
        let topology = Topology { field, path, call: kind, method, arguments, place, spot };
        self.note_topology(&topology);
        *expr = self.node(Node::Topology(Box::new(topology)), syn::spanned::Spanned::span(&span));
        true
    }

    /// Notes a call in the parallel loop around, if there is one; else, that the top level has the field.
    pub(super) fn note_topology(&mut self, topology: &Topology) {
        if topology.call.is_of_lists() {
            self.kernel.listed.insert(topology.field);
        }
        match self.parallel() {
            Some(number) => self.kernel.loops[number].topology.push(topology.clone()),
            None => {
                self.kernel.handed_on.insert(topology.field);
            }
        }
    }

    fn in_parallel_loop(&self) -> bool {
        self.parallel().is_some()
    }
}
