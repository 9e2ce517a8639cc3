//! Many threads that make the same blocks and append to the same lists.

use allotrope::prelude::*;

#[kernel]
fn everywhere(
    keys: &[u32],
    grid: &mut Field<u32, _, Ij>,
    lists: &mut Field<u32, layout!(hash(i).dynamic(j, 100_000, chunk = 32).aos), Ij>,
) {
    for k in keys {
        let at = ivec2((keys[k] % 97) as i32, (keys[k] / 97 % 89) as i32);
        grid[at] += 1;
        grid.activate(at + ivec2(1, 1));
        lists.append(at.x % 5, keys[k]);
    }
}

fn stress<L: Layout<Ij>>(make: impl Fn() -> Field<u32, L, Ij>) {
    let keys: Vec<u32> = (0..20_000u32).map(|n| n.wrapping_mul(2_654_435_761) >> 12).collect();
    let mut expected = vec![0u32; 100 * 100];
    for &k in &keys {
        expected[(k % 97) as usize * 100 + (k / 97 % 89) as usize] += 1;
    }
    for (round, scatter) in
        [Scatter::Atomic, Scatter::Private, Scatter::Atomic, Scatter::Atomic].into_iter().enumerate()
    {
        let mut grid = make();
        let mut lists = Field::<u32, layout!(hash(i).dynamic(j, 100_000, chunk = 32).aos), Ij>::unbounded();
        Schedule { threads: 16, grain: 16, scatter, ..Schedule::default() }
            .run(|| everywhere(&keys, &mut grid, &mut lists));
        for i in 0..97 {
            for j in 0..89 {
                assert_eq!(grid.get([i, j]), expected[i * 100 + j], "round {round} at {i} {j}");
                if expected[i * 100 + j] > 0 {
                    assert!(grid.is_active([i, j]) && grid.is_active([i + 1, j + 1]));
                }
            }
        }
        let mut blocks: Vec<_> = grid.blocks().map(|at| (at.x, at.y)).collect();
        blocks.sort_unstable();
        assert!(blocks.windows(2).all(|pair| pair[0] != pair[1]), "each block once");
        let mut all: Vec<u32> = lists.active_iter().map(|(_, key)| key).collect();
        all.sort_unstable();
        let mut sorted = keys.clone();
        sorted.sort_unstable();
        assert_eq!(all, sorted);
    }
}

#[test]
fn sixteen_threads_on_pointers() {
    stress(|| Field::<u32, layout!(pointer(ij, 4).pointer(ij, 4).bitmasked(ij, 4).aos)>::new([100, 100]));
}

#[test]
fn sixteen_threads_on_a_hash() {
    stress(Field::<u32, layout!(hash(ij).bitmasked(ij, 2).aos), Ij>::unbounded);
    stress(Field::<u32, SparseHash<4>, Ij>::unbounded);
}
