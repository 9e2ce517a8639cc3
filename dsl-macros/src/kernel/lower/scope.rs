//! Which names stand for what.

use syn::Ident;

/// A variable of the kernel.
#[derive(Clone)]
pub(super) struct Variable {
    name: Ident,
    pub(super) kind: Kind,
}

/// What a variable is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A local or a parameter taken by value.
    Value,
    /// A parameter of type `&T`, or `&self`.
    Reference,
    /// A parameter of type `&mut T`, or `&mut self`.
    Exclusive,
}

/// The scopes around the present place, innermost last.
#[derive(Default)]
pub(super) struct Scopes {
    scopes: Vec<Vec<Variable>>,
}

impl Scopes {
    pub(super) fn enter(&mut self) {
        self.scopes.push(Vec::new());
    }

    pub(super) fn leave(&mut self) {
        self.scopes.pop();
    }

    /// The number of scopes around the present place.
    pub(super) fn depth(&self) -> usize {
        self.scopes.len()
    }

    pub(super) fn bind(&mut self, name: &Ident, kind: Kind) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.push(Variable { name: name.clone(), kind });
        }
    }

    /// The innermost variable of that name, and the depth of its scope.
    pub(super) fn find(&self, name: &Ident) -> Option<(usize, &Variable)> {
        self.scopes.iter().enumerate().rev().find_map(|(depth, scope)| {
            scope.iter().rev().find(|variable| variable.name == *name).map(|variable| (depth, variable))
        })
    }
}
