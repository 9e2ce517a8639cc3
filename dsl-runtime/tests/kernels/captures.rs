//! What a parallel loop uses of its kernel's variables, and names that must not meet those of the expansion.

use allotrope::prelude::*;

/// Members whose names the expansion might use.
#[derive(Record, Clone, Copy, Default)]
struct Tricky {
    x: i32,
    r#type: i32,
    get: i32,
}

#[kernel]
fn names(cell: &mut Field<Tricky, _>, cell_x: &Field<i32, _>, run: &Field<i32, _>, space: i32, held_task: &i32) {
    let (task, value, target, v0_cell, at) = (1, 2, 3, 4, 5);
    for p in cell {
        cell.x[p] = cell_x[p] + run[p] + space + held_task + task + value + target + v0_cell + at;
        cell.r#type[p] += cell.x[p];
        cell.get[p] = cell.r#type[p] + cell_x.len() as i32;
    }
}

#[test]
fn any_names_may_be_used() {
    let (mut cell, mut other) = (Field::<Tricky, Aos>::new([4]), Field::<i32, Soa>::new([4]));
    other.fill(100);
    names(&mut cell, &other, &other, 1000, &10_000);
    assert!(cell.iter().all(|c| (c.x, c.r#type, c.get) == (11_215, 11_215, 11_219)));
}

/// A parameter that is no `Copy`.
struct Table {
    rows: Vec<f32>,
}

impl Table {
    fn at(&self, i: i32) -> f32 {
        self.rows[i as usize % self.rows.len()]
    }
}

#[kernel]
#[allow(clippy::too_many_arguments)]
fn captured(
    u: &mut Field<f32, _>,
    table: &Table,
    owned: Vec<f32>,
    slice: &[f32],
    f: impl Fn(f32) -> f32 + Sync,
    g: &(dyn Fn(f32) -> f32 + Sync),
    Vec2 { x, y }: Vec2,
    changed: &mut f32,
) {
    let scale = 2.0;
    let make = |x: f32| Vec2 { x, y };
    for p in u {
        let own = Vec2 { x, y: 1.0 };
        let twice = |scale: f32| scale * 2.0;
        u[p] = table.at(p) + owned[0] + slice[1] + f(own.x) + g(own.y) + make(scale).x + twice(*changed);
        debug_assert!(scale == 2.0, "{scale} {y:?}");
    }
    *changed = scale;
}

#[test]
fn variables_of_all_kinds_are_captured() {
    let mut u = Field::<f32, Soa>::new([5]);
    let mut changed = 0.25;
    let table = Table { rows: vec![1.0, 2.0] };
    captured(&mut u, &table, vec![10.0], &[0.0, 100.0], |x| x * 1000.0, &|x| x + 0.5, vec2(3.0, 4.0), &mut changed);
    let expected = |p: usize| table.rows[p % 2] + 10.0 + 100.0 + 3000.0 + 1.5 + 2.0 + 0.5;
    assert!((0..5).all(|p| u.get(p) == expected(p)));
    assert_eq!(changed, 2.0);
}

/// A kernel's receiver that is neither `Copy` nor behind a reference.
struct Owner(Vec<i32>);

impl Owner {
    #[kernel]
    fn into_field(self, u: &mut Field<i32, _>) -> usize {
        for p in u {
            u[p] = self.0[p as usize];
        }
        self.0.len()
    }

    #[kernel]
    fn count(&mut self, u: &Field<i32, _>) {
        let mut count = 0;
        for p in u {
            if u[p] == self.0[0] {
                count += 1;
            }
        }
        self.0.push(count);
    }
}

#[test]
fn receivers_of_all_kinds() {
    let mut u = Field::<i32, Aos>::new([3]);
    let mut owner = Owner(vec![4, 5, 4]);
    assert_eq!(Owner(owner.0.clone()).into_field(&mut u), 3);
    owner.count(&u);
    assert_eq!(owner.0, [4, 5, 4, 2]);
}
