//! Changes of tokens: deterministic, so that a found input is found again.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::Input;

/// Tokens that ask for trouble: words of Rust and of the language, numbers at the ends of types, strings with braces.
const WORDS: &str = "self Self crate super _ async await const extern unsafe move ref mut dyn impl where static union enum struct \
    fn for in loop while if else match return break continue let as pub use mod type trait box yield try macro_rules \
    u v p q i j k n x s t r#type r#in r#fn é Field Member MemberMut Read Record X T I Ij Ijk Ijkl O IVec2 IVec3 Vec2 usize i32 f32 \
    unroll ndrange serial ordered relaxed scatter Atomic Private Colored interior border checkerboard colored row len shape \
    clamped wrapped or min_assign max_assign append activate fetch_add swap compare_exchange get_unchecked random members \
    dense pointer bitmasked hash dynamic morton aos soa split place pad ij ijk ji iji xy ivec2 vec2 assert println format vec \
    matches dbg panic write __allotrope_node kernel lanes grad unchecked finite derive cfg allow inline doc field \
    0 1 2 3 -1 7 255 256 65536 2147483647 2147483648 4294967296 18446744073709551616 1u8 2i64 0x10 1_000 1.5 1e30 \
    \"\" \"{}\" \"{p}\" \"{u:?}\" \"{:>n$.x$}\" \"{{\" \"{\" \"}\" \"{é}\" \"{0}\" \"{self}\" \"{r#type}\" \"{ p }\" b\"x\" c\"x\" 'a' \
    'a 'static 'element = == != += -= *= /= %= <<= >>= &= |= ^= && || ! ? . .. ..= ... , ; : :: -> => & * + - / % < > @ # $ ~";

/// How deep groups may lie in each other.
const DEPTH: usize = 24;

/// Tokens, groups open.
#[derive(Clone)]
enum Tree {
    Token(TokenTree),
    Group(Delimiter, Vec<Tree>),
}

fn open(tokens: TokenStream) -> Vec<Tree> {
    let tree = |token| match token {
        TokenTree::Group(group) => Tree::Group(group.delimiter(), open(group.stream())),
        token => Tree::Token(token),
    };
    tokens.into_iter().map(tree).collect()
}

fn close(trees: &[Tree]) -> TokenStream {
    let token = |tree: &Tree| match tree {
        Tree::Token(token) => token.clone(),
        Tree::Group(delimiter, trees) => TokenTree::Group(Group::new(*delimiter, close(trees))),
    };
    trees.iter().map(token).collect()
}

fn depth(trees: &[Tree]) -> usize {
    trees.iter().map(|tree| if let Tree::Group(_, inner) = tree { 1 + depth(inner) } else { 0 }).max().unwrap_or(0)
}

/// What a token is to the grammar, roughly: another of its kind may stand in its place.
fn kind_of(tree: &Tree) -> usize {
    match tree {
        Tree::Token(TokenTree::Ident(_)) => 0,
        Tree::Token(TokenTree::Literal(_)) => 1,
        Tree::Token(_) => 2,
        Tree::Group(delimiter, _) => 3 + *delimiter as usize,
    }
}

/// The number of lists of tokens: the outermost and one a group.
fn lists(trees: &[Tree]) -> usize {
    1 + trees.iter().map(|tree| if let Tree::Group(_, inner) = tree { lists(inner) } else { 0 }).sum::<usize>()
}

/// Calls `change` with the list of that number.
fn at<T>(trees: &mut Vec<Tree>, number: &mut usize, change: &mut dyn FnMut(&mut Vec<Tree>) -> T) -> Option<T> {
    if *number == 0 {
        return Some(change(trees));
    }
    *number -= 1;
    trees.iter_mut().find_map(|tree| match tree {
        Tree::Group(_, inner) => {
            let size = lists(inner);
            if *number < size {
                at(inner, number, change)
            } else {
                *number -= size;
                None
            }
        }
        Tree::Token(_) => None,
    })
}

/// The input with one token or group less, or one group opened: every way.
pub(super) fn cuts(tokens: &TokenStream) -> Vec<TokenStream> {
    let trees = open(tokens.clone());
    let mut all = Vec::new();
    for list in 0..lists(&trees) {
        let size = at(&mut trees.clone(), &mut list.clone(), &mut |list| list.len()).unwrap_or(0);
        for place in 0..size {
            let mut cut = trees.clone();
            at(&mut cut, &mut list.clone(), &mut |list| list.remove(place));
            all.push(close(&cut));
        }
    }
    all
}

/// Makes inputs from seeds.
pub(super) struct Mutator<'a> {
    state: u64,
    seeds: &'a [Input],
    words: Vec<Tree>,
}

impl<'a> Mutator<'a> {
    pub(super) fn new(seed: u64, seeds: &'a [Input]) -> Self {
        let tokens = |word: &str| open(word.parse().unwrap_or_default());
        Self { state: seed, seeds, words: WORDS.split_whitespace().flat_map(tokens).collect() }
    }

    fn below(&mut self, n: usize) -> usize {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) as usize % n.max(1)
    }

    /// The next input: a seed, changed a few times.
    pub(super) fn next(&mut self) -> Input {
        let seeds = self.seeds;
        let seed = &seeds[self.below(seeds.len())];
        let (mut options, mut trees) = (open(seed.options.clone()), open(seed.tokens.clone()));
        let most = [1, 2, 8][self.below(3)];
        for _ in 0..1 + self.below(most) {
            if self.below(12) == 0 {
                self.change(&mut options);
            } else {
                self.change(&mut trees);
            }
        }
        Input { of: seed.of, options: close(&options), tokens: close(&trees) }
    }

    /// A few tokens of another seed, or a word.
    fn foreign(&mut self) -> Vec<Tree> {
        if self.below(2) == 0 {
            let word = self.below(self.words.len());
            return vec![self.words[word].clone()];
        }
        let seeds = self.seeds;
        let seed = &seeds[self.below(seeds.len())];
        let mut trees = open(seed.tokens.clone());
        let mut list = self.below(lists(&trees));
        let (start, count) = (self.below(64), 1 + self.below(8));
        let take = &mut |list: &mut Vec<Tree>| {
            let start = start % list.len().max(1);
            list.iter().skip(start).take(count).cloned().collect()
        };
        at(&mut trees, &mut list, take).unwrap_or_default()
    }

    fn change(&mut self, trees: &mut Vec<Tree>) {
        let kind = self.below(12);
        let foreign = self.foreign();
        let (first, second, count) = (self.below(1 << 20), self.below(1 << 20), 1 + self.below(3));
        let delimiter = [Delimiter::Parenthesis, Delimiter::Bracket, Delimiter::Brace, Delimiter::None][self.below(4)];
        let mut list = self.below(lists(trees));
        let before = trees.clone();
        at(trees, &mut list, &mut |list| {
            let size = list.len().max(1);
            let (first, second) = (first % size, second % size);
            let last = (first + count).min(list.len());
            match kind {
                _ if list.is_empty() => list.extend(foreign.clone()),
                0 => drop(list.drain(first..last)),
                1 => {
                    let copy = list[first..last].to_vec();
                    drop(list.splice(second..second, copy));
                }
                2 => list.swap(first, second),
                3 | 4 => drop(list.splice(first..last, foreign.clone())),
                5 | 6 => drop(list.splice(first..first, foreign.clone())),
                7..=9 => {
                    let same = foreign.iter().find(|tree| kind_of(tree) == kind_of(&list[first]));
                    list[first] = same.unwrap_or(&list[second]).clone();
                }
                10 => {
                    let inner = list[first..last].to_vec();
                    drop(list.splice(first..last, [Tree::Group(delimiter, inner)]));
                }
                _ => {
                    if let Tree::Group(_, inner) = list[first].clone() {
                        drop(list.splice(first..=first, inner));
                    }
                }
            }
        });
        if depth(trees) > DEPTH {
            *trees = before;
        }
    }
}
