//! Algorithms over all records, against plain loops: the same bits for any number of threads and any layout.

use allotrope::Permutation;
use allotrope::prelude::*;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use super::{Numbers, Point, on, panic_of};

/// Records in one part, of which results are combined in order.
const PART: usize = 1 << 15;
/// Lengths around those at which parts begin.
const LENGTHS: [usize; 8] = [0, 1, 2, 1000, PART - 1, PART, PART + 1, 3 * PART + 77];
const THREADS: [usize; 4] = [1, 2, 3, 8];

#[test]
fn records_are_copied_between_layouts_of_one_shape() {
    let mut points = Field::<Point, Aos>::new([150, 301]);
    for n in 0..150 * 301 {
        points.set([n / 301, n % 301], Point::numbered(n));
    }
    let mut same = Field::<Point, Aos>::new([150, 301]);
    same.copy_from(&points);
    assert!(same.iter().eq(points.iter()));
    for threads in THREADS {
        let mut other = Field::<Point, layout!(dense(ji).dense(ij, (3, 4)).split)>::new([150, 301]);
        on(threads, || other.copy_from(&points));
        assert!(other.iter().eq(points.iter()));
        assert!(on(threads, || points.relayout::<Blocked<8>>()).iter().eq(points.iter()));
    }
    let mut one = Field::<u8, Soa>::new([]);
    one.copy_from(&Field::<u8, Aos>::new([]).with_background(7));
    assert_eq!(one.get(()), 7);
}

#[test]
fn a_field_of_another_shape_is_not_copied() {
    let mut to = Field::<u8, Aos>::new([2, 3]).with_background(5);
    let from = Field::<u8, Soa>::new([3, 2]);
    let error = to.try_copy_from(&from).unwrap_err();
    assert_eq!((&error.shape[..], &error.other[..]), (&[2, 3][..], &[3, 2][..]));
    let text = "a field of shape [2, 3] cannot take the records of one of shape [3, 2]";
    assert_eq!(error.to_string(), text);
    let panic = panic_of(|| to.copy_from(&from));
    assert!(panic.contains("Field<u8, ..>") && panic.contains(text), "{panic}");
    assert_eq!(to.to_vec(), [5; 6]);
}

#[test]
fn the_first_number_that_is_not_finite_is_found() {
    #[derive(Record, Clone, Copy, Default)]
    struct Cell {
        kind: u8,
        heat: f64,
        stress: Mat2,
        count: i32,
    }
    fn check<L: Layout<Ij>>() {
        let (rows, columns) = (300, 257);
        let mut cells = Field::<Cell, L>::try_new([rows, columns]).expect("a field");
        cells.fill(Cell { kind: 255, count: -1, heat: f64::MAX, stress: Mat2::from_cols_array(&[f32::MIN; 4]) });
        assert!(cells.find_nonfinite().is_none(), "the greatest numbers are finite, and integers are always");
        let mut numbers = Numbers(3);
        let mut first: Option<(usize, usize)> = None;
        for _ in 0..6 {
            let n = numbers.next() as usize % (rows * columns);
            let at = [n / columns, n % columns];
            let component = numbers.next() as usize % 5;
            let mut cell = cells.get(at);
            match component {
                0 => cell.heat = f64::NEG_INFINITY,
                c => cell.stress.as_mut()[c - 1] = f32::NAN,
            }
            cells.set(at, cell);
            first = Some(first.map_or((n, component), |first| first.min((n, component))));
            let (n, component) = first.expect("one at least");
            for threads in THREADS {
                let found = on(threads, || cells.find_nonfinite()).expect("one at least");
                assert_eq!(found.index, ivec2((n / columns) as i32, (n % columns) as i32));
                match component {
                    0 => {
                        assert_eq!((found.member, found.component), (Some("heat"), 0));
                        assert_eq!(found.value, f64::NEG_INFINITY);
                    }
                    c => {
                        assert_eq!((found.member, found.component), (Some("stress"), c - 1));
                        assert!(found.value.is_nan());
                    }
                }
            }
        }
    }
    check::<Aos>();
    check::<layout!(dense(ji).dense(ij, 4).split)>();
}

#[test]
fn numbers_that_are_not_finite_say_where_they_are() {
    let mut u = Field::<f32, Soa>::new([4]);
    u.set(2, f32::INFINITY);
    assert_eq!(u.find_nonfinite().expect("one").to_string(), "component 0 at [2] is inf");
    assert_eq!(u.find_nonfinite().expect("one").member, None);
    assert!(Field::<u64, Soa>::new([4]).with_background(u64::MAX).find_nonfinite().is_none());
    assert!(Field::<f64, Soa>::new([0]).with_background(f64::NAN).find_nonfinite().is_none());
}

#[test]
fn iteration_goes_from_both_ends() {
    let mut u = Field::<u32, layout!(dense(ji).dense(ijk, 2).soa)>::new([3, 4, 2]);
    let values: Vec<u32> = (0..24).collect();
    u.copy_from_slice(&values);
    assert!(u.iter().rev().eq(values.iter().copied().rev()));
    let mut both = u.iter();
    for n in 0..12 {
        assert_eq!((both.next(), both.next_back()), (Some(n), Some(23 - n)));
    }
    assert_eq!((both.len(), both.next(), both.next_back()), (0, None, None));
}

/// Rayon hands work over through the standard library, which the thread sanitizer does not see into.
#[cfg(not(allotrope_joined_threads))]
#[test]
fn parallel_iteration_keeps_the_order() {
    fn check<L: Layout<Ijk>>() {
        for shape in [[0, 4, 5], [1, 1, 1], [7, 30, 11], [64, 33, 20]] {
            let mut u = Field::<u32, L>::try_new(shape).expect("a field");
            let values: Vec<u32> = (0..u.len() as u32).collect();
            u.copy_from_slice(&values);
            assert_eq!(u.par_iter().collect::<Vec<_>>(), values);
            assert_eq!((&u).into_par_iter().with_max_len(3).collect::<Vec<_>>(), values);
            assert_eq!(u.par_iter().len(), values.len());
            assert_eq!(u.par_iter().rev().collect::<Vec<_>>(), values.iter().rev().copied().collect::<Vec<_>>());
            let pairs: u64 = u.par_iter().zip(&values).map(|(a, &b)| u64::from(a == b)).sum();
            assert_eq!(pairs, values.len() as u64);
        }
    }
    check::<Aos>();
    check::<Morton<4>>();
    check::<layout!(dense(kji).dense(j, 3).soa)>();
}

/// A field of numbers of very different sizes, of which every order of adding has other bits.
fn uneven<L: Layout<I>>(len: usize) -> Field<f32, L> {
    let mut numbers = Numbers(len as u64);
    let values: Vec<f32> = (0..len).map(|_| (numbers.unit() * 40.0 - 20.0).exp2() as f32).collect();
    let mut u = Field::<f32, L>::new([len]);
    u.copy_from_slice(&values);
    u
}

#[test]
fn reductions_have_one_order() {
    for len in LENGTHS {
        let u = uneven::<Aos>(len);
        // The order that the documentation tells, as plain loops.
        let parts =
            u.to_vec().chunks(PART).filter_map(|part| part.iter().copied().reduce(|a, b| a + b)).collect::<Vec<_>>();
        let expected = parts.into_iter().fold(0.5, |a, b| a + b);
        let split = u.relayout::<AoSoA<16>>();
        for threads in THREADS {
            let bits = |sum: f32| sum.to_bits();
            assert_eq!(bits(on(threads, || u.reduce(0.5, |a, b| a + b))), bits(expected));
            assert_eq!(bits(on(threads, || split.reduce(0.5, |a, b| a + b))), bits(expected));
            assert_eq!(bits(on(threads, || split.members().0.reduce(0.5, |a, b| a + b))), bits(expected));
            assert_eq!(bits(on(threads, || u.map_reduce(|x| 2.0 * x, 1.0, |a, b| a + b))), bits(2.0 * expected));
        }
    }
}

#[test]
fn reductions_need_not_commute() {
    let len = 2 * PART + 5;
    let u = Field::<u8, Soa>::new([len]);
    for threads in THREADS {
        // The first and the last place, and how many there are: a monoid that does not commute.
        let mut place = Field::<[u32; 2], Aos>::new([len]);
        place.copy_from_slice(&(0..len as u32).map(|n| [n, n]).collect::<Vec<_>>());
        let ends = on(threads, || place.map_reduce(Some, None, |a, b| Some([a.or(b)?[0], b.or(a)?[1]])));
        assert_eq!(ends, Some([0, len as u32 - 1]));
        assert_eq!(on(threads, || u.map_reduce(|_| 1usize, 0, |a, b| a + b)), len);
    }
}

#[test]
fn reductions_run_serially_inside_of_a_launch() {
    #[kernel]
    fn totals(u: &mut Field<f32, _>, of: Vec<Field<f32, Soa>>) {
        for p in u {
            u[p] = of[p as usize % of.len()].reduce(0.0, |a, b| a + b);
        }
    }
    let of = vec![uneven::<Soa>(PART + 9), uneven::<Soa>(10)];
    let expected: Vec<f32> = of.iter().map(|field| field.reduce(0.0, |a, b| a + b)).collect();
    let mut u = Field::<f32, Aos>::new([64]);
    Schedule { threads: 3, grain: 1, ..Schedule::default() }.run(|| totals(&mut u, of));
    assert!(u.iter().enumerate().all(|(p, sum)| sum == expected[p % 2]));
}

#[test]
fn scans_sum_what_is_before() {
    fn check<L: Layout<I>>() {
        for len in LENGTHS {
            let mut numbers = Numbers(len as u64);
            let counts: Vec<u32> = (0..len).map(|_| (numbers.next() % 100) as u32).collect();
            let mut sum = 0;
            let expected: Vec<u32> = counts.iter().map(|count| (sum, sum += count).0).collect();
            for threads in THREADS {
                let mut u = Field::<u32, L>::try_new([len]).expect("a field");
                u.copy_from_slice(&counts);
                assert_eq!(on(threads, || u.exclusive_scan()), sum);
                assert_eq!(u.to_vec(), expected);
            }
        }
    }
    check::<Aos>();
    check::<layout!(dense(i).dense(i, 48).soa)>();
}

#[test]
fn scans_of_floats_have_one_order() {
    for len in LENGTHS {
        let values = uneven::<Aos>(len).to_vec();
        let mut total = 0.0f32;
        let mut expected = Vec::new();
        for part in values.chunks(PART) {
            let mut sum = 0.0;
            for value in part {
                expected.push((total + sum).to_bits());
                sum += value;
            }
            total += sum;
        }
        for threads in THREADS {
            let mut u = uneven::<AoSoA<8>>(len);
            assert_eq!(on(threads, || u.exclusive_scan()).to_bits(), total.to_bits());
            assert_eq!(u.iter().map(f32::to_bits).collect::<Vec<_>>(), expected);
            assert!(u.iter().is_sorted(), "sums of positive numbers never fall");
        }
    }
}

#[test]
fn scans_of_one_member_leave_the_others() {
    let mut points = Field::<Point, AoSoA<4>>::new([10]);
    for n in 0..10 {
        points.set(n, Point::numbered(n));
    }
    assert_eq!(points.members_mut().id.exclusive_scan(), 45);
    assert_eq!(points.members_mut().mass.exclusive_scan(), 50.0);
    for n in 0..10 {
        let (before, point) = ((0..n).sum::<u32>(), points.get(n));
        assert_eq!((point.id, point.mass), (before, before as f32 + 0.5 * n as f32));
        assert_eq!(point.x, Point::numbered(n).x);
    }
}

#[test]
fn sums_that_overflow_are_refused_and_change_nothing() {
    let len = 2 * PART + 100;
    // Up by one until the type is full; a later part falls again, so that no sum of a part or of all overflows.
    let mut values = vec![0i16; len];
    values[..i16::MAX as usize].fill(1);
    values[PART + 7] = 3;
    values[PART + 8] = -30_000;
    let mut u = Field::<i16, Soa>::new([len]);
    u.copy_from_slice(&values);
    for threads in THREADS {
        let error = on(threads, || u.try_exclusive_scan()).unwrap_err();
        assert_eq!((error.index, error.scalar), (PART + 7, "i16"));
        let panic = panic_of(|| on(threads, || u.exclusive_scan()));
        assert!(panic.contains("the sum up to element 32775 overflows `i16`"), "{panic}");
        assert_eq!(u.to_vec(), values);
    }
    // One less, and all sums fit.
    u.set(0, 0);
    u.set(PART + 7, 1);
    assert_eq!(u.exclusive_scan(), i16::MAX - 30_000);
}

#[test]
fn parts_may_overflow_where_sums_do_not() {
    let len = PART + 300;
    let mut values = vec![0i8; len];
    values[0] = -100;
    values[PART..PART + 200].fill(1);
    let mut u = Field::<i8, Aos>::new([len]);
    u.copy_from_slice(&values);
    assert_eq!(u.exclusive_scan(), 100);
    assert_eq!((u.get(PART), u.get(PART + 150), u.get(len - 1)), (-100, 50, 100));
}

/// A permutation that looks random, as new places.
fn shuffled(len: usize) -> Vec<u32> {
    let mut numbers = Numbers(len as u64 + 5);
    let mut places: Vec<u32> = (0..len as u32).collect();
    for n in (1..len).rev() {
        places.swap(n, numbers.next() as usize % (n + 1));
    }
    places
}

#[test]
fn scatter_puts_records_at_their_places() {
    for len in LENGTHS {
        let places = shuffled(len);
        let order = Permutation::from_new_places(&places).expect("a permutation");
        assert_eq!(order.new_places(), places);
        assert_eq!((order.len(), order.is_empty()), (len, len == 0));
        let mut source = Field::<Point, AoSoA<4>>::new([len]);
        for n in 0..len {
            source.set(n, Point::numbered(n as u32));
        }
        let mut expected = vec![Point::default(); len];
        for (n, &place) in places.iter().enumerate() {
            expected[place as usize] = source.get(n);
        }
        for threads in THREADS {
            let mut to = Field::<Point, Split>::new([len]);
            on(threads, || to.scatter(&order, &source));
            assert!(to.iter().eq(expected.iter().copied()));
            let mut back = Field::<Point, Aos>::new([len]);
            on(threads, || back.scatter(&order.inverse(), &to));
            assert!(back.iter().eq(source.iter()));
        }
        assert_eq!(order.inverse().inverse(), order);
        assert_eq!(order.inverse().old_places(), order.new_places());
    }
}

#[test]
fn scatter_follows_a_reorder() {
    let len = PART + 1000;
    let places = shuffled(len);
    let mut keys = Field::<u32, Soa>::new([len]);
    keys.copy_from_slice(&places);
    let mut companions = Field::<f64, Soa>::new([len]);
    companions.copy_from_slice(&places.iter().map(|&key| f64::from(key) / 2.0).collect::<Vec<_>>());
    let order = on(3, || keys.reorder_by_key(|&key| key));
    let mut sorted = companions.clone();
    sorted.scatter(&order, &companions);
    assert!(sorted.iter().zip(keys.iter()).all(|(companion, key)| companion == f64::from(key) / 2.0));
    assert!(keys.iter().is_sorted());
}

#[test]
fn scatter_of_other_lengths_is_refused() {
    let order = Permutation::from_new_places(&[1, 0, 2]).expect("a permutation");
    let (three, four) = (Field::<u8, Aos>::new([3]), Field::<u8, Aos>::new([4]));
    let panic = panic_of(|| four.clone().scatter(&order, &three));
    assert_eq!(panic, "`scatter`: a field of 4 elements, a permutation of 3 and a source of 3");
    let panic = panic_of(|| three.clone().scatter(&order, &four));
    assert_eq!(panic, "`scatter`: a field of 3 elements, a permutation of 3 and a source of 4");
    assert!(panic_of(|| four.clone().scatter(&order, &four)).contains("a permutation of 3"));
}

#[test]
fn lists_that_are_no_permutations_are_refused() {
    let error = Permutation::from_new_places(&[0, 3, 1]).unwrap_err();
    assert_eq!(error.to_string(), "record 1 goes to place 3, but there are 3 places");
    let error = Permutation::from_new_places(&[1, 0, 0]).unwrap_err();
    assert_eq!(error.to_string(), "record 2 goes to place 0, and so does one before it");
    assert!(Permutation::from_new_places(&[]).expect("nothing to order").is_empty());
}
