//! Rows become vector instructions: shown from the machine code of this very test, whose kernels' bodies all have a row as their innermost loop.
//!
//! Skipped, with a message, where bodies have no versions (builds with debug assertions, other architectures) and where `objdump` is missing.

use allotrope::prelude::*;

#[derive(Record, Clone, Copy, Default)]
struct Pair {
    u: f32,
    v: f32,
}

#[kernel]
fn saxpy(a: f32, x: &Field<f32, _>, y: &mut Field<f32, _>) {
    for i in y {
        y[i] += a * x[i];
    }
}

#[kernel]
fn scale(by: f32, x: &mut Field<Pair, _>) {
    for i in x {
        x.u[i] *= by;
    }
}

#[kernel]
fn jacobi(u: &Field<f32, _, Ij>, v: &mut Field<f32, _, Ij>) {
    for (i, j) in v.interior(1) {
        v[(i, j)] = 0.25 * (u[(i - 1, j)] + u[(i + 1, j)] + u[(i, j - 1)] + u[(i, j + 1)]);
    }
}

#[kernel]
fn jacobi_member(field: &mut Field<Pair, _, Ij>) {
    for (i, j) in field.interior(1) {
        field.v[(i, j)] =
            0.25 * (field.u[(i - 1, j)] + field.u[(i + 1, j)] + field.u[(i, j - 1)] + field.u[(i, j + 1)]);
    }
}

#[kernel]
fn laplacian(p: &Field<f32, _, Ijk>, q: &mut Field<f32, _, Ijk>) {
    for (i, j, k) in q.interior(1) {
        q[(i, j, k)] = p[(i - 1, j, k)]
            + p[(i + 1, j, k)]
            + p[(i, j - 1, k)]
            + p[(i, j + 1, k)]
            + p[(i, j, k - 1)]
            + p[(i, j, k + 1)]
            - 6.0 * p[(i, j, k)];
    }
}

/// Runs every kernel in every layout with long rows, so that they are compiled; gives how many pairs there are.
fn compiled() -> usize {
    let mut pairs = 0;
    macro_rules! lines {
        ($($layout:ty),*) => {$({
            let (x, mut y) = (Field::<f32, $layout>::new([100]), Field::<f32, $layout>::new([100]));
            saxpy(2.0, &x, &mut y);
            pairs += 1;
        })*};
    }
    macro_rules! members {
        ($($layout:ty),*) => {$({
            scale(2.0, &mut Field::<Pair, $layout>::new([100]));
            pairs += 1;
        })*};
    }
    macro_rules! planes {
        ($($layout:ty),*) => {$({
            let (u, mut v) = (Field::<f32, $layout>::new([40, 40]), Field::<f32, $layout>::new([40, 40]));
            jacobi(&u, &mut v);
            pairs += 1;
        })*};
    }
    macro_rules! member_planes {
        ($($layout:ty),*) => {$({
            jacobi_member(&mut Field::<Pair, $layout>::new([40, 40]));
            pairs += 1;
        })*};
    }
    macro_rules! spaces {
        ($($layout:ty),*) => {$({
            let (p, mut q) = (Field::<f32, $layout>::new([20, 20, 20]), Field::<f32, $layout>::new([20, 20, 20]));
            laplacian(&p, &mut q);
            pairs += 1;
        })*};
    }
    lines!(Aos, layout!(dense(i).dense(i, 64).aos));
    // One layout alone of those that lead to the same code, which the compiler keeps once.
    members!(Soa, AoSoA<32>);
    planes!(Aos, Blocked<32>);
    member_planes!(Soa, layout!(dense(ij).dense(ij, 32).soa));
    spaces!(Aos, layout!(dense(ijk).dense(ijk, 16).aos));
    pairs
}

/// An instruction of a listing: where it stands, and its text.
type Instruction<'a> = (u64, &'a str);

/// The functions of a listing whose names contain a text.
fn functions<'a>(listing: &'a str, named: &str) -> Vec<Vec<Instruction<'a>>> {
    let mut found: Vec<Vec<Instruction<'a>>> = Vec::new();
    let mut inside = false;
    for line in listing.lines() {
        if line.ends_with(">:") {
            inside = line.contains(named);
            found.extend(inside.then(Vec::new));
        } else if let (true, Some((address, text))) = (inside, line.trim().split_once(':'))
            && let (Ok(address), Some(function)) = (u64::from_str_radix(address, 16), found.last_mut())
        {
            function.push((address, text.trim()));
        }
    }
    found
}

/// The innermost loops of a function: what stands between a jump backwards and its target, if no other such stretch lies within.
fn innermost_loops<'a, 'f>(function: &'f [Instruction<'a>]) -> Vec<&'f [Instruction<'a>]> {
    let place = |address| function.iter().position(|&(at, _)| at == address);
    let stretch = |(end, &(_, text)): (usize, &Instruction<'a>)| {
        let mut words = text.split_whitespace();
        words.next().filter(|operation| operation.starts_with('j'))?;
        let start = place(u64::from_str_radix(words.next()?, 16).ok()?)?;
        (start <= end).then_some((start, end))
    };
    let loops: Vec<(usize, usize)> = function.iter().enumerate().filter_map(stretch).collect();
    let innermost = |&(start, end): &(usize, usize)| {
        !loops.iter().any(|&(first, last)| (first, last) != (start, end) && start <= first && last <= end)
    };
    loops.iter().copied().filter(innermost).map(|(start, end)| &function[start..=end]).collect()
}

/// Whether a loop adds or multiplies whole registers of floats.
fn is_packed(stretch: &[Instruction<'_>]) -> bool {
    stretch.iter().any(|(_, text)| {
        let operation = text.split_whitespace().next().unwrap_or_default();
        let sums = ["vadd", "vmul", "vsub", "vfmadd", "vfnmadd", "vfmsub"].iter().any(|sum| operation.starts_with(sum));
        sums && operation.ends_with("ps") && (text.contains("%ymm") || text.contains("%zmm"))
    })
}

fn has_packed_loop(function: &[Instruction<'_>]) -> bool {
    innermost_loops(function).into_iter().any(is_packed)
}

#[test]
fn rows_become_packed_instructions() {
    let pairs = compiled();
    if cfg!(debug_assertions) || cfg!(not(target_arch = "x86_64")) {
        eprintln!("skipped: loop bodies have one version in this build, for every processor of the architecture");
        return;
    }
    let this = std::env::current_exe().unwrap();
    let disassembled = std::process::Command::new("objdump").args(["-d", "--no-show-raw-insn"]).arg(this).output();
    let Ok(output) = disassembled else {
        eprintln!("skipped: `objdump` is not installed");
        return;
    };
    let listing = String::from_utf8_lossy(&output.stdout);
    for set in ["avx2", "avx512"] {
        let versions = functions(&listing, &format!("8versions{}{set}", set.len()));
        assert!(versions.len() >= pairs, "{set}: {} functions for {pairs} pairs of kernel and layout", versions.len());
        for version in versions {
            let shown: Vec<String> = version.iter().map(|(at, text)| format!("{at:x}: {text}")).collect();
            assert!(has_packed_loop(&version), "{set}: no packed loop in\n{}", shown.join("\n"));
        }
    }
}

#[test]
fn scalar_loops_are_told_from_packed_ones() {
    let listing = |operation: &str, register: &str| {
        format!(
            "\n00000010 <_ZN8versions4avx217h0E>:\n  10:\tvmulps %ymm0,%ymm1,%ymm2\n  14:\t{operation} (%rdi),{register},{register}\n  \
             18:\tadd    $0x4,%rdi\n  1c:\tjne    14 <_ZN8versions4avx217h0E+0x4>\n  1e:\tret\n\n00000020 <other>:\n  20:\tret\n"
        )
    };
    let is_packed = |listing: &str| {
        let found = functions(listing, "8versions4avx2");
        assert_eq!((found.len(), found[0].len()), (1, 5));
        has_packed_loop(&found[0])
    };
    assert!(is_packed(&listing("vaddps", "%ymm0")));
    assert!(is_packed(&listing("vfmadd231ps", "%zmm0")));
    // What stands before the loop does not count, nor do single floats.
    assert!(!is_packed(&listing("vaddss", "%xmm0")));
    assert!(!is_packed(&listing("vmovups", "%ymm0")));
}
