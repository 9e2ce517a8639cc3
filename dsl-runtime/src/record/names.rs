//! The names of a record's elements: those of inner records are paths, `node.v`.

use core::marker::PhantomData;

use super::{ElementList, Entry, MAX_MEMBERS, Record};

/// The most bytes that the paths of the elements of a record's inner records may have, all together.
const MOST_BYTES: usize = 2048;

/// The names of the elements of the records `R`.
pub(crate) struct Names<R>(PhantomData<R>);

impl<R: Record> Names<R> {
    const PATHS: &'static Paths = &Paths::of(R::NAMES, R::Elements::ENTRIES);
    const LIST: &'static [&'static str; MAX_MEMBERS] = &list(R::NAMES, R::Elements::ENTRIES, Self::PATHS);
    /// A name for each of [`ElementList::MEMBERS`].
    pub(crate) const ALL: &'static [&'static str] = Self::LIST.split_at(R::Elements::MEMBERS.len()).0;
}

/// The paths of all elements of inner records, one after another.
struct Paths {
    bytes: [u8; MOST_BYTES],
    used: usize,
}

impl Paths {
    const fn of(names: &[&str], entries: &[Entry]) -> Self {
        assert!(names.len() == entries.len(), "a record has a name for each of its members");
        let mut this = Self { bytes: [0; MOST_BYTES], used: 0 };
        let mut e = 0;
        while e < entries.len() {
            let mut inner = 0;
            while inner < entries[e].names.len() {
                this = this.with(names[e]).with(".").with(entries[e].names[inner]);
                inner += 1;
            }
            e += 1;
        }
        this
    }

    const fn with(mut self, text: &str) -> Self {
        let text = text.as_bytes();
        assert!(self.used + text.len() <= MOST_BYTES, "the names of the members of a record in a record are too long");
        let mut b = 0;
        while b < text.len() {
            self.bytes[self.used] = text[b];
            self.used += 1;
            b += 1;
        }
        self
    }
}

/// The names one by one, those of elements that are no inner record's as they are.
const fn list(names: &[&'static str], entries: &[Entry], paths: &'static Paths) -> [&'static str; MAX_MEMBERS] {
    let mut list = [""; MAX_MEMBERS];
    let (mut rest, mut count, mut e): (&'static [u8], _, _) = (&paths.bytes, 0, 0);
    while e < entries.len() {
        if entries[e].names.is_empty() {
            list[count] = names[e];
            count += 1;
        }
        let mut inner = 0;
        while inner < entries[e].names.len() {
            let (path, after) = rest.split_at(names[e].len() + 1 + entries[e].names[inner].len());
            list[count] = match core::str::from_utf8(path) {
                Ok(path) => path,
                Err(_) => panic!("names are texts"),
            };
            rest = after;
            count += 1;
            inner += 1;
        }
        e += 1;
    }
    list
}
