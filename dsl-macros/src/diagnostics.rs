//! Errors: codes, wording, and the sink that collects them.
//!
//! A macro reports everything it finds, at the user's tokens, and only then stops. Each error has a code that never
//! changes its meaning; a page of the reference explains each.

use std::fmt;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// Declares the one list of all codes. A new diagnostic is one line here.
macro_rules! codes {
    ($($(#[$doc:meta])* $name:ident = $code:ident,)*) => {
        /// A stable error code.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub(crate) enum Code { $($(#[$doc])* $name,)* }

        impl Code {
            /// All codes, in the order of their numbers.
            #[cfg(test)]
            pub(crate) const ALL: &'static [Code] = &[$(Code::$name,)*];

            /// The code as users see it, such as `A0101`.
            pub(crate) const fn text(self) -> &'static str {
                match self { $(Code::$name => stringify!($code),)* }
            }
        }
    };
}

codes! {
    /// `#[kernel]` on something that is not a function with a body.
    NotAFunction = A0101,
    /// An `async`, `const`, `extern` or `unsafe` kernel.
    KernelQualifier = A0102,
    /// An option of `#[kernel(..)]` that does not exist, or not yet.
    KernelOption = A0103,
    /// A field that is not taken by reference.
    FieldByValue = A0104,
    /// A field's parameter that is not a plain name.
    FieldPattern = A0105,
    /// A `_` where only the layout may be left open.
    OpenParameter = A0106,
    /// A member as a parameter whose type names its record.
    MemberType = A0107,
    /// A member of a single member or of a slice.
    MemberOfMember = A0108,
    /// A parallel loop over something that is not in the list of heads.
    LoopHead = A0110,
    /// A range with its end included, or without an end.
    LoopRange = A0111,
    /// A pattern of a parallel loop that is neither a name nor a tuple of names.
    LoopPattern = A0112,
    /// `for q in f.row(index)` as an outermost loop.
    RowHead = A0113,
    /// `#[scatter(..)]` that names no schedule, or not on a parallel loop.
    ScatterAttribute = A0115,
    /// `break`, `return`, `?` or `.await` out of a parallel loop.
    LoopEscape = A0116,
    /// `unroll!` with a form that cannot be unrolled.
    UnrollForm = A0117,
    /// `unroll!` or `ndrange!` that is not the head of a loop, or over no ranges.
    HeadMacro = A0118,
    /// A serial loop, over time say, outermost, where it would be the parallel one.
    OutermostLoop = A0119,
    /// A loop variable, field or reduction whose name is bound again.
    Rebinding = A0120,
    /// A macro that is handed a loop variable, a field or a reduction.
    OpaqueMacro = A0121,
    /// A macro defined in a parallel loop that mentions such a name.
    MacroDefinition = A0122,
    /// A member of a `#[func]` that is not taken as `Read<T, _, X>`.
    FuncMember = A0123,
    /// `#[relaxed]` on a loop that is not parallel.
    RelaxedPlace = A0124,
    /// `lanes` where there is nothing to gain, or what a loop in lanes cannot do.
    Lanes = A0125,
    /// A member written at an iteration's own index and read at another.
    InPlaceStencil = A0201,
    /// A member written at an index that several iterations may share.
    PlainScatter = A0202,
    /// A member accumulated into at any index and read.
    AccumulateBesideRead = A0203,
    /// A member accumulated into with operators of two groups.
    MixedOperators = A0204,
    /// A written member indexed with the loop's variables in different places.
    OwnPlaces = A0205,
    /// A member written plainly and accumulated into at any index.
    AccumulateBesideWrite = A0206,
    /// A write through `&Field`.
    SharedWrite = A0207,
    /// An index with the wrong number of axes.
    IndexCount = A0208,
    /// A constant offset wider than the border that `interior` leaves out.
    InteriorOffset = A0209,
    /// The value of an accumulation, which has none.
    AccumulateValue = A0210,
    /// A compound assignment that is no accumulation, at an index that is not the iteration's own.
    OperatorScatter = A0212,
    /// A field or a member bound to a variable, or a member without an index.
    Alias = A0213,
    /// A field or a member handed on whole inside a parallel loop.
    HandedOn = A0214,
    /// An entry of a list appended to, or removed from, a member.
    MemberAppend = A0215,
    /// A method of a field that cannot be called inside a parallel loop.
    FieldMethod = A0216,
    /// A reduction that is read in the loop that accumulates into it.
    ReductionRead = A0217,
    /// A reduction with operators of two groups.
    ReductionOperators = A0218,
    /// A variable from outside a parallel loop that the loop assigns.
    OuterAssigned = A0219,
    /// A reduction into a part of a variable beside one into more of it.
    ReductionPart = A0220,
    /// Elements as targets of a destructuring assignment.
    Destructuring = A0221,
    /// A `move` closure that accesses fields inside a parallel loop.
    MoveClosure = A0223,
    /// A member whose old values are taken, and which is used in another way.
    OldValueBeside = A0224,
    /// `fetch_add` and its like of a part of an element, or with other arguments.
    OldValueForm = A0225,
    /// An access beside `append` that could be at the entry that is being appended.
    AppendBeside = A0226,
    /// Activity that is asked for at an index where other iterations change it.
    ActivityBeside = A0227,
    /// An enum or a union as a record.
    NotAStruct = A0301,
    /// A record whose members have no names.
    UnnamedMembers = A0302,
    /// A record with a lifetime.
    BorrowingRecord = A0303,
    /// A record without members, or with too many.
    MemberCount = A0304,
    /// Fields where an element is to be one integer, or no enum at all.
    NotFieldless = A0305,
    /// An enum of which no variant has the value 0.
    NoZeroVariant = A0306,
    /// A variant whose value is no literal, or fits in no integer that elements have.
    Discriminant = A0307,
    /// A word in a layout that is neither node nor place.
    UnknownNode = A0401,
    /// An axis other than `i j k l`.
    UnknownAxis = A0403,
    /// An axis twice in one node.
    AxisTwice = A0404,
    /// A layout that leaves an axis out.
    MissingAxis = A0405,
    /// A size that is no positive integer, or too large.
    WrongSize = A0406,
    /// An inner node without a size.
    NoSize = A0407,
    /// More or fewer sizes than axes.
    SizeCount = A0408,
    /// A layout without a place.
    NoPlace = A0409,
    /// A word after the place.
    AfterPlace = A0410,
    /// A layout that does not begin with a node.
    NoNode = A0411,
    /// A member placed twice.
    PlacedTwice = A0412,
    /// Members placed without saying whose they are.
    NoRecord = A0413,
    /// A group of members that is none.
    WrongGroup = A0414,
    /// A placed member whose name is too long.
    LongName = A0415,
    /// Arguments that a node or a place does not take.
    WrongArguments = A0416,
    /// Something that is no chain of nodes.
    NotALayout = A0417,
    /// A `morton` block whose size is no power of two.
    NotAPowerOfTwo = A0418,
    /// A layout with more nodes of constant size than can be.
    TooManyNodes = A0419,
    /// `pad` that is not right before the place, or not by a power of two.
    WrongPad = A0420,
    /// A branch that names no members, over other axes, or one too many.
    WrongBranch = A0421,
    /// `hash` below another node, or with a size.
    WrongHash = A0422,
    /// `dynamic` above another node, or along axes that are not its own.
    WrongList = A0423,
    /// A list's maximum or chunk that cannot be.
    WrongMaximum = A0424,
    /// `%` of a number below zero.
    NegativeRemainder = A0501,
    /// `unroll!` that writes a body out very often.
    LargeUnroll = A0502,
    /// A field taken by `&mut` that is only read.
    OnlyRead = A0503,
    /// Two calls of `random` with the same arguments in one loop.
    EqualRandom = A0504,
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text())
    }
}

/// One error or warning: where, what, and what to write instead.
#[derive(Debug)]
pub(crate) struct Diagnostic {
    code: Code,
    at: TokenStream,
    message: String,
    lines: Vec<String>,
}

impl Diagnostic {
    /// Adds a line that says what to write instead.
    pub(crate) fn help(&mut self, text: impl Into<String>) -> &mut Self {
        self.lines.push(format!("= help: {}", text.into()));
        self
    }

    /// Adds a line that says why, or where the other half of a clash stands.
    pub(crate) fn note(&mut self, text: impl Into<String>) -> &mut Self {
        self.lines.push(format!("= note: {}", text.into()));
        self
    }

    /// The whole text: message, code, notes and helps.
    pub(crate) fn text(&self) -> String {
        let mut text = format!("{} [{}]", self.message, self.code);
        for line in &self.lines {
            text.push('\n');
            text.push_str(line);
        }
        text
    }

    /// A statement that rustc warns of, in these words.
    fn into_warning(self) -> TokenStream {
        let text = self.text();
        // rustc underlines the last name of a path, which has one span: that of the first token, which may be a group.
        let at = self.at.into_iter().next().map_or_else(Span::call_site, |token| token.span());
        let constant = Ident::new(self.code.text(), Span::mixed_site());
        let used = Ident::new(self.code.text(), at.resolved_at(Span::mixed_site()));
        let module = Ident::new("warning", Span::mixed_site());
        quote! {{
            mod #module {
                #[deprecated(note = #text)]
                pub(super) const #constant: () = ();
            }
            let () = #module::#used;
        }}
    }

    /// The code.
    #[cfg(test)]
    pub(crate) fn code(&self) -> Code {
        self.code
    }
}

/// Where an error stands: a reference to tokens, or a span.
pub(crate) trait Place {
    /// Tokens with the spans to underline.
    fn tokens(&self) -> TokenStream;
}

impl<T: ToTokens> Place for &T {
    fn tokens(&self) -> TokenStream {
        self.to_token_stream()
    }
}

impl Place for Span {
    fn tokens(&self) -> TokenStream {
        TokenTree::from(Ident::new("here", *self)).into()
    }
}

/// Collects the errors and warnings of one macro call.
#[derive(Debug, Default)]
pub(crate) struct Diagnostics {
    errors: Vec<Diagnostic>,
    warnings: Vec<Diagnostic>,
    syntax: TokenStream,
}

impl Diagnostics {
    /// Reports an error at `at`: the user's tokens (their first to their last is underlined), or a span.
    pub(crate) fn error(&mut self, code: Code, at: impl Place, message: impl Into<String>) -> &mut Diagnostic {
        let place = self.errors.len();
        self.errors.push(Diagnostic { code, at: at.tokens(), message: message.into(), lines: Vec::new() });
        &mut self.errors[place]
    }

    /// Warns of what compiles and is likely to be a mistake.
    pub(crate) fn warn(&mut self, code: Code, at: impl Place, message: impl Into<String>) -> &mut Diagnostic {
        let place = self.warnings.len();
        self.warnings.push(Diagnostic { code, at: at.tokens(), message: message.into(), lines: Vec::new() });
        &mut self.warnings[place]
    }

    /// Reports what is no Rust at all, in syn's words.
    pub(crate) fn syntax(&mut self, error: syn::Error) {
        self.syntax.extend(error.into_compile_error());
    }

    /// Whether there is no error.
    pub(crate) fn is_empty(&self) -> bool {
        self.errors.is_empty() && self.syntax.is_empty()
    }

    /// The codes of the errors so far; what is no Rust at all has none.
    pub(crate) fn codes(&self) -> impl Iterator<Item = Code> + '_ {
        self.errors.iter().map(|error| error.code)
    }

    /// The errors so far, in the order of their reports.
    #[cfg(test)]
    pub(crate) fn errors(&self) -> &[Diagnostic] {
        &self.errors
    }

    /// The warnings so far, in the order of their reports.
    #[cfg(test)]
    pub(crate) fn warnings(&self) -> &[Diagnostic] {
        &self.warnings
    }

    /// A use of something deprecated for each warning, as statements: the only warnings that stable Rust lets a macro make.
    pub(crate) fn into_warnings(self) -> TokenStream {
        self.warnings.into_iter().map(Diagnostic::into_warning).collect()
    }

    /// One `compile_error!` for each error, as items.
    pub(crate) fn into_compile_errors(self) -> TokenStream {
        let errors = self.errors.into_iter();
        let errors = errors.map(|error| syn::Error::new_spanned(&error.at, error.text()).into_compile_error());
        self.syntax.into_iter().chain(errors.flatten()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_distinct_and_ascending() {
        for pair in Code::ALL.windows(2) {
            assert!(pair[0].text() < pair[1].text(), "{} must stand before {}", pair[0], pair[1]);
        }
    }

    #[test]
    fn text_has_code_notes_and_helps() {
        let mut diagnostics = Diagnostics::default();
        diagnostics.error(Code::NotAFunction, &quote::quote!(x), "`x` is wrong").note("why").help("write `y`");
        assert_eq!(diagnostics.errors()[0].text(), "`x` is wrong [A0101]\n= note: why\n= help: write `y`");
        assert!(diagnostics.into_compile_errors().to_string().contains("compile_error"));
    }
}
