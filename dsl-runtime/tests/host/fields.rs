//! One field: made, read and written, its members taken apart, its records put into order.

use allotrope::ShapeError;
use allotrope::prelude::*;

use super::{Point, panic_of};

#[test]
fn a_new_field_holds_zeros() {
    let points = Field::<Point, AoSoA<4>>::new([10]);
    assert_eq!((points.shape(), points.len(), points.is_empty()), ([10], 10, false));
    assert!(points.iter().all(|point| point == Point::default()));
    assert_eq!(points.bytes(), 3 * 4 * 16);
}

#[test]
fn extents_give_the_axes() {
    let line: Field<f32, Soa, I> = Field::<f32, Soa>::new([3]);
    let plane: Field<f32, Soa, Ij> = Field::<f32, Soa>::new([3, 4]);
    let volume: Field<f32, Soa, Ijk> = Field::<f32, Soa>::new([3, 4, 5]);
    assert_eq!((line.len(), plane.len(), volume.len()), (3, 12, 60));
    assert_eq!((line.shape(), plane.shape(), volume.shape()), ([3], [3, 4], [3, 4, 5]));
}

#[test]
fn a_field_may_be_empty() {
    let mut none = Field::<Point, Blocked<4>>::new([0, 5]);
    assert_eq!((none.len(), none.is_empty(), none.shape(), none.bytes()), (0, true, [0, 5], 0));
    assert_eq!(none.iter().count(), 0);
    none.fill(Point::numbered(1));
    none.members_mut().mass.copy_from_slice(&[]);
    assert_eq!(none.members().x.to_vec(), []);
    assert!(none.try_get([0, 0]).is_err());
    assert!(none.relayout::<Soa>().is_empty());
}

#[test]
fn extents_beyond_an_index_are_refused() {
    let error = Field::<u8, Aos>::try_new([4, 1 << 31]).unwrap_err();
    assert_eq!(error, ShapeError::Extent { axis: "j", extent: 1 << 31 });
    assert_eq!(error.to_string(), "axis `j` has 2147483648 elements, more than the 2147483647 that an index counts");
}

#[test]
fn overflowing_bytes_are_refused() {
    let most = i32::MAX as usize;
    for error in [
        Field::<f64, Aos>::try_new([most, most, 1000]).unwrap_err(),
        Field::<Mat4, Blocked<4>>::try_new([most, most, 1000]).unwrap_err(),
        Field::<f64, Aos>::try_new([most, most, most]).unwrap_err(),
    ] {
        assert!(matches!(error, ShapeError::TooLarge { .. }), "{error}");
        assert!(error.to_string().contains("does not fit in the address space"), "{error}");
    }
}

#[test]
fn memory_that_the_system_refuses_is_an_error() {
    // 2^61 bytes: they count, but no system has them.
    let error = Field::<f64, Aos>::try_new([1 << 30, 1 << 28]).unwrap_err();
    assert_eq!(error, ShapeError::OutOfMemory { shape: vec![1 << 30, 1 << 28], bytes: 1 << 61 });
    assert!(panic_of(|| Field::<f64, Aos>::new([1 << 30, 1 << 28])).contains("2305843009213693952 bytes"));
}

#[test]
fn an_axis_that_the_root_does_not_name_ends_with_its_block() {
    type Pairs = layout!(dense(i).dense(j, 2).aos);
    assert_eq!(Field::<f32, Pairs>::new([100, 2]).len(), 200);
    let error = Field::<f32, Pairs>::try_new([100, 3]).unwrap_err();
    assert_eq!(error, ShapeError::Axis { axis: "j", extent: 3, most: 2 });
}

#[test]
fn any_integers_are_an_index() {
    let mut u = Field::<u32, Blocked<2>>::new([3, 4]);
    u.set([1, 2], 12);
    u.set((2u8, 3i64), 23);
    u.set(ivec2(0, 1), 1);
    assert_eq!((u.get((1usize, 2i32)), u.get(uvec2(2, 3)), u.get([0u32, 1])), (12, 23, 1));
    let mut line = Field::<u32, Aos>::new([4]);
    line.set(3u64, 7);
    assert_eq!((line.get(3i8), line.get((3,)), line.get([3usize])), (7, 7, 7));
    let mut volume = Field::<u32, Aos>::new([2, 3, 4]);
    volume.set((1, 2, 3), 9);
    assert_eq!((volume.get(ivec3(1, 2, 3)), volume.get([1i64, 2, 3])), (9, 9));
}

#[test]
fn an_index_out_of_range_is_an_error_or_a_panic() {
    let mut points = Field::<Point, Soa>::new([3, 4]);
    for index in [(3, 0), (0, 4), (-1, 0), (0, i64::MIN), (i64::from(u32::MAX) + 1, 0)] {
        let error = points.try_get(index).unwrap_err();
        assert_eq!((error.index.clone(), error.shape.clone()), (vec![index.0, index.1], vec![3, 4]));
        let text = format!("index [{}, {}] is out of range of shape [3, 4]", index.0, index.1);
        assert_eq!(error.to_string(), text);
        assert_eq!(points.try_set(index, Point::numbered(1)).unwrap_err(), error);
        for panic in [
            panic_of(|| points.get(index)),
            panic_of(|| points.members().mass.get(index)),
            panic_of(|| points.set(index, Point::numbered(1))),
            panic_of(|| points.members_mut().mass.set(index, 1.0)),
            panic_of(|| points.members_mut().mass.get(index)),
        ] {
            assert!(panic.contains("Point") && panic.contains(&text), "{panic}");
        }
    }
    assert!(points.iter().all(|point| point == Point::default()), "a refused index writes nothing");
    assert_eq!(points.try_set((2, 3), Point::numbered(5)), Ok(()));
    assert_eq!(points.try_get((2, 3)), Ok(Point::numbered(5)));
}

#[test]
fn iteration_is_row_major_and_knows_its_length() {
    let mut u = Field::<i32, layout!(dense(ji).dense(ij, 2).soa)>::new([2, 3]);
    u.copy_from_slice(&[1, 2, 3, 4, 5, 6]);
    let mut records = u.iter();
    assert_eq!(records.len(), 6);
    assert_eq!(records.next(), Some(1));
    assert_eq!(records.len(), 5);
    assert_eq!(records.collect::<Vec<_>>(), [2, 3, 4, 5, 6]);
    assert_eq!((&u).into_iter().sum::<i32>(), 21);
    assert_eq!((u.get([0, 2]), u.get([1, 0])), (3, 4));
    assert_eq!(u.to_vec(), [1, 2, 3, 4, 5, 6]);
}

#[test]
fn fill_reaches_every_element() {
    let mut points = Field::<Point, layout!(dense(ij).dense(ij, 4).split)>::new([5, 6]);
    points.fill(Point::numbered(3));
    assert_eq!(points.iter().collect::<Vec<_>>(), [Point::numbered(3); 30]);
}

#[test]
fn members_are_reached_one_by_one() {
    let mut points = Field::<Point, layout!(Point: dense(ij).dense(j, 2).place([x, id], [mass]))>::new([2, 3]);
    let masses = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let mut members = points.members_mut();
    members.mass.copy_from_slice(&masses);
    members.x.fill(vec2(1.0, 2.0));
    members.id.set((1, 2), 9);
    assert_eq!((members.id.get((1, 2)), members.id.to_vec()), (9, vec![0, 0, 0, 0, 0, 9]));
    let members = points.members();
    assert_eq!((members.mass.to_vec(), members.mass.get((1, 0))), (masses.to_vec(), 4.0));
    assert_eq!(members.x.to_vec(), [vec2(1.0, 2.0); 6]);
    assert_eq!(points.get((1, 2)), Point { x: vec2(1.0, 2.0), mass: 6.0, id: 9 });
}

#[test]
fn two_members_can_be_held_at_once() {
    let mut points = Field::<Point, Aos>::new([3]);
    let members = points.members_mut();
    let (mut mass, mut id) = (members.mass, members.id);
    mass.fill(2.0);
    id.fill(7);
    mass.set(1, 3.0);
    assert_eq!((points.get(1).mass, points.get(1).id), (3.0, 7));
}

#[test]
fn a_slice_of_another_length_is_refused() {
    let mut points = Field::<Point, Soa>::new([2, 3]);
    for values in [&[1.0; 5][..], &[1.0; 7]] {
        let panic = panic_of(|| points.members_mut().mass.copy_from_slice(values));
        assert!(panic.contains(&format!("{} values for a field of 6 elements", values.len())), "{panic}");
    }
    assert_eq!(points.members().mass.to_vec(), [0.0; 6]);
}

#[test]
fn relayout_and_clone_copy() {
    let mut points = Field::<Point, Aos>::new([5, 7]);
    for n in 0..35 {
        points.set([n / 7, n % 7], Point::numbered(n));
    }
    let split = points.relayout::<layout!(dense(ji).dense(ij, (3, 2)).split)>();
    let mut copy = split.clone();
    assert_eq!(split.iter().collect::<Vec<_>>(), points.iter().collect::<Vec<_>>());
    copy.fill(Point::default());
    points.fill(Point::default());
    assert_eq!(split.get([4, 6]), Point::numbered(34), "the copies are independent");
}

#[test]
fn a_layout_that_cannot_hold_the_shape_is_refused_by_relayout() {
    let field = Field::<f32, Aos>::new([3, 5]);
    let panic = panic_of(|| field.relayout::<layout!(dense(i).dense(j, 4).aos)>());
    assert!(panic.contains("axis `j` has 5 elements, but the layout holds 4 along it"), "{panic}");
}

#[test]
fn reorder_sorts_whole_records_stably() {
    fn check<L: Layout<I>>(key: impl Fn(u32) -> u64 + Sync) {
        let mut points = Field::<Point, L>::try_new([40]).expect("a field");
        for n in 0..40 {
            points.set(n, Point::numbered(n));
        }
        let before: Vec<Point> = points.iter().collect();
        let mut expected = before.clone();
        expected.sort_by_key(|point| key(point.id)); // stable
        let order = points.reorder_by_key(|point| key(point.id));
        let after: Vec<Point> = points.iter().collect();
        assert_eq!(after, expected);
        for (now, &old) in order.old_places().iter().enumerate() {
            assert_eq!(after[now], before[old as usize]);
        }
        for (old, &now) in order.new_places().iter().enumerate() {
            assert_eq!(after[now as usize], before[old]);
        }
    }
    // Few keys with many equal ones; keys too far apart to be counted.
    check::<Aos>(|n| u64::from(n * 7 % 5));
    check::<AoSoA<16>>(|n| u64::from(n * 7 % 5));
    check::<layout!(dense(i).dense(i, 3).split)>(|n| u64::MAX - u64::from(n % 6) * (1 << 50));
}

#[test]
fn reorder_of_nothing_and_of_equals_keeps_the_order() {
    let mut none = Field::<u32, Aos>::new([0]);
    assert_eq!(none.reorder_by_key(|&value| value).old_places(), []);
    let mut equals = Field::<u32, Soa>::new([5]);
    equals.copy_from_slice(&[5, 3, 9, 1, 4]);
    assert_eq!(equals.reorder_by_key(|_| 7u8).old_places(), [0, 1, 2, 3, 4]);
    assert_eq!(equals.to_vec(), [5, 3, 9, 1, 4]);
}

#[test]
fn debug_shows_shape_and_first_records() {
    let mut u = Field::<u32, Aos>::new([20]);
    u.fill(7);
    let text = format!("{u:?}");
    assert!(text.contains("shape [20]") && text.contains("7, 7") && text.ends_with("and 4 more"), "{text}");
}
