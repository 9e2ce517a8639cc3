//! Enums as members of records, in arrays and as bare fields.

use allotrope::prelude::*;

#[derive(Element, Clone, Copy, Debug, Default, PartialEq)]
#[repr(i16)]
enum Phase {
    Ice = -300,
    #[default]
    Water = 0,
    Steam = 300,
}

#[derive(Record, Clone, Copy, Debug, Default, PartialEq)]
struct Parcel {
    heat: f32,
    phase: Phase,
    history: [Phase; 3],
}

fn phase_of(heat: f32) -> Phase {
    if heat < 0.0 {
        Phase::Ice
    } else if heat > 1.0 {
        Phase::Steam
    } else {
        Phase::Water
    }
}

#[kernel]
fn change(parcels: &mut Field<Parcel, _, Ij>, phases: &mut Field<Phase, _, Ij>) {
    for (i, j) in parcels {
        let now = phase_of(parcels.heat[(i, j)]);
        let [_, second, third] = parcels.history[(i, j)];
        parcels.history[(i, j)] = [second, third, parcels.phase[(i, j)]];
        parcels.phase[(i, j)] = now;
        phases[(i, j)] = match parcels.phase[(i, j)] {
            Phase::Ice => Phase::Steam,
            Phase::Water => Phase::Water,
            Phase::Steam => Phase::Ice,
        };
    }
}

#[kernel]
fn copy(from: &Field<Parcel, _, Ij>, to: &mut Field<Parcel, _, Ij>) {
    for ij in to {
        to[ij] = from[ij];
    }
}

fn check<L: Layout<Ij>, L2: Layout<Ij>>() {
    let mut parcels = Field::<Parcel, L>::new([7, 9]);
    assert_eq!(parcels.get([3, 4]), Parcel::default());
    let heat = |i: usize, j: usize| (i * 9 + j) as f32 / 20.0 - 1.0;
    for (i, j) in (0..7).flat_map(|i| (0..9).map(move |j| (i, j))) {
        parcels.set([i, j], Parcel { heat: heat(i, j), phase: Phase::Steam, history: [Phase::Ice; 3] });
    }
    let mut phases = Field::<Phase, L2>::new([7, 9]);
    change(&mut parcels, &mut phases);
    let mut copied = Field::<Parcel, L2>::new([7, 9]);
    copy(&parcels, &mut copied);
    for (i, j) in (0..7).flat_map(|i| (0..9).map(move |j| (i, j))) {
        let phase = phase_of(heat(i, j));
        let history = [Phase::Ice, Phase::Ice, Phase::Steam];
        assert_eq!(copied.get([i, j]), Parcel { heat: heat(i, j), phase, history });
        let opposite = match phase {
            Phase::Ice => Phase::Steam,
            Phase::Water => Phase::Water,
            Phase::Steam => Phase::Ice,
        };
        assert_eq!(phases.get([i, j]), opposite);
    }
    assert_eq!(copied.relayout::<L>().members().phase.to_vec(), parcels.members().phase.to_vec());
}

#[test]
fn enums_are_kept_in_every_place() {
    check::<Aos, Soa>();
    check::<Soa, Split>();
    check::<Split, Blocked<4>>();
    check::<Blocked<4>, AoSoA<4>>();
    check::<AoSoA<4>, Aos>();
}
