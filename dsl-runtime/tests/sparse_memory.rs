//! Memory does not grow over rounds. A program of its own, since it asks for that of the whole process.

use allotrope::prelude::*;

/// This process' resident memory in KiB.
fn resident() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    status.lines().find_map(|line| line.strip_prefix("VmRSS:")?.trim().split(' ').next()?.parse().ok())
}

#[test]
fn rounds_of_activation_take_no_more_memory() {
    let mut field = Field::<f32, layout!(hash(ij).pointer(ij, 4).bitmasked(ij, 8).aos), Ij>::unbounded();
    let mut tiles = Field::<f32, Sparse<16>>::new([4096, 4096]);
    let mut lists = Field::<u32, layout!(dense(i).dynamic(j, 64, chunk = 8).aos)>::new([64]);
    let (mut bytes, mut after_hundred) = (0, None);
    for round in 0..100_000i32 {
        let at = [(round * 37) % 5000 - 2500, (round * 91) % 4000 - 2000];
        field.set(at, 1.0);
        field.deactivate(at);
        let at = [(round * 37) % 4096, (round * 91) % 4096];
        tiles.set(at, 1.0);
        tiles.deactivate(at);
        lists.append(round % 64, 1);
        if round % 64 == 63 {
            if round % 128 == 63 { lists.clear() } else { lists.truncate(0) }
        }
        if round == 99 {
            (bytes, after_hundred) = (field.bytes() + tiles.bytes() + lists.bytes(), resident());
        }
    }
    field.prune();
    assert!(field.bytes() <= bytes + (1 << 18), "{} bytes, {bytes} after a hundred rounds", field.bytes());
    assert_eq!((field.active_len(), tiles.active_len(), tiles.blocks().len()), (0, 0, 0));
    if let (Some(before), Some(after)) = (after_hundred, resident()) {
        assert!(after < before + 8 * 1024, "{after} KiB after all, {before} after a hundred rounds");
    }
}
