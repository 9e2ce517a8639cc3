//! Tuples of records: the members of a record as the runtime sees them. One list of arities, up to [`MAX_MEMBERS`].

use super::{At, Bare, ElementList, Entry, MAX_MEMBERS, MemberSpec, PartMut, PartRef, Record, Tag, Under, sealed};
use crate::element::Element;
use crate::field::Handle;

/// How many elements come before an entry.
const fn offset(entries: &[Entry], entry: usize) -> usize {
    let (mut offset, mut e) = (0, 0);
    while e < entry {
        offset += entries[e].members.len();
        e += 1;
    }
    offset
}

/// The elements of all entries, one after another, and how many they are.
const fn flattened(entries: &[Entry]) -> ([MemberSpec; MAX_MEMBERS], usize) {
    let mut all = [entries[0].members[0]; MAX_MEMBERS];
    let (mut count, mut e) = (0, 0);
    while e < entries.len() {
        let mut m = 0;
        while m < entries[e].members.len() {
            assert!(
                count < MAX_MEMBERS,
                "a record has 24 members at most, those of the records in it counted one by one"
            );
            all[count] = entries[e].members[m];
            count += 1;
            m += 1;
        }
        e += 1;
    }
    (all, count)
}

impl<E: Element> At<0> for Bare<E> {
    type Entry = E;
    const OFFSET: usize = 0;
}

macro_rules! list {
    ($($entry:ident $n:literal),+) => {
        impl<$($entry: Record),+> sealed::List for ($($entry,)+) {}
        impl<$($entry: Record),+> ElementList for ($($entry,)+) {
            const BARE: bool = false;
            const PACKED: bool = false;
            const ENTRIES: &'static [Entry] = &[$(Entry::of::<$entry>()),+];
            const MEMBERS: &'static [MemberSpec] = {
                let (all, count): &'static ([MemberSpec; MAX_MEMBERS], usize) = &const { flattened(Self::ENTRIES) };
                all.split_at(*count).0
            };
            type Members<'a, R, P, L, X> = ($(PartRef<'a, $entry, R, Under<P, Tag<Self, $n>>, L, X>,)+);
            type MembersMut<'a, R, P, L, X> = ($(PartMut<'a, $entry, R, Under<P, Tag<Self, $n>>, L, X>,)+);
            type Part<'a, T: Record, R, P, L, X> = T::Members<'a, R, P, L, X>;
            type PartMut<'a, T: Record, R, P, L, X> = T::MembersMut<'a, R, P, L, X>;
            fn members<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::Members<'a, R, P, L, X> {
                ($($entry::Elements::part::<$entry, R, Under<P, Tag<Self, $n>>, L, X>(handle),)+)
            }
            fn members_mut<'a, R, P, L, X>(handle: Handle<'a, R, L, X>) -> Self::MembersMut<'a, R, P, L, X> {
                ($($entry::Elements::part_mut::<$entry, R, Under<P, Tag<Self, $n>>, L, X>(handle),)+)
            }
            fn part<'a, T: Record<Elements = Self>, R, P, L, X>(
                handle: Handle<'a, R, L, X>,
            ) -> Self::Part<'a, T, R, P, L, X> {
                T::members::<R, P, L, X>(Self::members::<R, P, L, X>(handle))
            }
            fn part_mut<'a, T: Record<Elements = Self>, R, P, L, X>(
                handle: Handle<'a, R, L, X>,
            ) -> Self::PartMut<'a, T, R, P, L, X> {
                T::members_mut::<R, P, L, X>(Self::members_mut::<R, P, L, X>(handle))
            }
            #[inline(always)]
            unsafe fn gather(at: impl Fn(usize) -> (*mut u8, usize) + Copy) -> Self {
                ($({
                    // SAFETY: the caller promises readable members; `at` names each one's first component and their distance.
                    let elements = unsafe {
                        $entry::Elements::gather(
                            #[inline(always)]
                            |m| at(<Self as At<$n>>::OFFSET + m),
                        )
                    };
                    $entry::from_elements(elements)
                },)+)
            }
            #[inline(always)]
            #[allow(non_snake_case, reason = "the variables are named after the types")]
            unsafe fn scatter(self, at: impl Fn(usize) -> (*mut u8, usize) + Copy) {
                let ($($entry,)+) = self;
                $({
                    let elements = $entry.into_elements();
                    // SAFETY: the caller promises writable members; `at` names each one's first component and their distance.
                    unsafe {
                        elements.scatter(
                            #[inline(always)]
                            |m| at(<Self as At<$n>>::OFFSET + m),
                        )
                    }
                })+
            }
            fn wrong(member: usize, bytes: &[u8]) -> Option<i64> {
                $(
                    let first = <Self as At<$n>>::OFFSET;
                    if (first..first + $entry::Elements::MEMBERS.len()).contains(&member) {
                        return $entry::Elements::wrong(member - first, bytes);
                    }
                )+
                None
            }
        }
    };
}

list!(E0 0);
list!(E0 0, E1 1);
list!(E0 0, E1 1, E2 2);
list!(E0 0, E1 1, E2 2, E3 3);
list!(E0 0, E1 1, E2 2, E3 3, E4 4);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18, E19 19);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18, E19 19, E20 20);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18, E19 19, E20 20, E21 21);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18, E19 19, E20 20, E21 21, E22 22);
list!(E0 0, E1 1, E2 2, E3 3, E4 4, E5 5, E6 6, E7 7, E8 8, E9 9, E10 10, E11 11, E12 12, E13 13, E14 14, E15 15, E16 16, E17 17, E18 18, E19 19, E20 20, E21 21, E22 22, E23 23);

macro_rules! at {
    ($n:literal $pick:ident; $($entry:ident),+) => {
        impl<$($entry: Record),+> At<$n> for ($($entry,)+) {
            type Entry = $pick;
            const OFFSET: usize = offset(Self::ENTRIES, $n);
        }
    };
}

at!(0 E0; E0);
at!(0 E0; E0, E1);
at!(1 E1; E0, E1);
at!(0 E0; E0, E1, E2);
at!(1 E1; E0, E1, E2);
at!(2 E2; E0, E1, E2);
at!(0 E0; E0, E1, E2, E3);
at!(1 E1; E0, E1, E2, E3);
at!(2 E2; E0, E1, E2, E3);
at!(3 E3; E0, E1, E2, E3);
at!(0 E0; E0, E1, E2, E3, E4);
at!(1 E1; E0, E1, E2, E3, E4);
at!(2 E2; E0, E1, E2, E3, E4);
at!(3 E3; E0, E1, E2, E3, E4);
at!(4 E4; E0, E1, E2, E3, E4);
at!(0 E0; E0, E1, E2, E3, E4, E5);
at!(1 E1; E0, E1, E2, E3, E4, E5);
at!(2 E2; E0, E1, E2, E3, E4, E5);
at!(3 E3; E0, E1, E2, E3, E4, E5);
at!(4 E4; E0, E1, E2, E3, E4, E5);
at!(5 E5; E0, E1, E2, E3, E4, E5);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(19 E19; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(19 E19; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(20 E20; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(19 E19; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(20 E20; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(21 E21; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(19 E19; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(20 E20; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(21 E21; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(22 E22; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22);
at!(0 E0; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(1 E1; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(2 E2; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(3 E3; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(4 E4; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(5 E5; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(6 E6; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(7 E7; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(8 E8; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(9 E9; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(10 E10; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(11 E11; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(12 E12; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(13 E13; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(14 E14; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(15 E15; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(16 E16; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(17 E17; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(18 E18; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(19 E19; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(20 E20; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(21 E21; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(22 E22; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
at!(23 E23; E0, E1, E2, E3, E4, E5, E6, E7, E8, E9, E10, E11, E12, E13, E14, E15, E16, E17, E18, E19, E20, E21, E22, E23);
