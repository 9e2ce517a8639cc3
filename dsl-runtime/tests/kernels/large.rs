//! Fields of more than 2^31 and 2^32 elements. Memory that is not touched costs nothing.

use allotrope::prelude::*;

#[kernel]
fn mark_middle(u: &mut Field<u8, _, Ij>, width: u32) -> i64 {
    let mut sum = 0;
    for (i, j) in u.interior(width) {
        u[(i, j)] += 1;
        sum += i64::from(i) * 1_000_000 + i64::from(j);
    }
    sum
}

#[kernel]
fn mark_row(u: &mut Field<u8, _, Ij>, row: i32, from: i32, at: &Field<u32, _>) {
    let end = u.shape()[1] as i32;
    for j in from..end {
        u[(row, j)] += 2;
    }
    for p in at {
        u[(row, at[p])] += 3;
    }
}

#[test]
fn more_than_two_to_the_32_elements() {
    fn run<L: Layout<Ij>>() {
        let n = 65_600usize;
        let Ok(mut u) = Field::<u8, L>::try_new([n, n]) else {
            return eprintln!("not run: {} bytes are refused on this machine", n * n);
        };
        assert!(u.len() > 1 << 32 && u.bytes() > 1 << 32);
        // The middle lies beyond 2^31, the last row beyond 2^32.
        let middle = n as i64 / 2;
        let expected: i64 =
            (middle - 8..middle + 8).flat_map(|i| (middle - 8..middle + 8).map(move |j| i * 1_000_000 + j)).sum();
        assert_eq!(mark_middle(&mut u, n as u32 / 2 - 8), expected);
        let mut at = Field::<u32, Aos>::new([3]);
        at.fill(n as u32 - 1);
        mark_row(&mut u, n as i32 - 1, n as i32 - 5, &at);
        let middle = n / 2;
        let found = |i: usize, j: usize| u.get((i, j));
        assert_eq!((found(middle - 8, middle + 7), found(middle - 9, middle), found(middle, middle + 8)), (1, 0, 0));
        assert_eq!((found(n - 1, n - 1), found(n - 1, n - 5), found(n - 1, n - 6), found(0, n - 1)), (11, 2, 0, 0));
    }
    run::<Aos>();
    run::<AoSoA<16>>();
    run::<Blocked<8>>();
    run::<layout!(dense(ji).soa)>();
}
