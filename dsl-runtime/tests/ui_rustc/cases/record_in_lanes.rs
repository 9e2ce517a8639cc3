//! Lanes keep elements, and no whole records.
use allotrope::prelude::*;

#[derive(Record, Clone, Copy)]
struct Parcel {
    heat: f32,
    rounds: u32,
}

#[kernel(lanes = 16)]
fn cool(parcels: &mut Field<Parcel, _>) {
    for i in parcels {
        let mut parcel = parcels[i]; //~ E0277
        while parcel.heat > 1.0 {
            parcel.heat *= 0.5;
            parcel.rounds += 1;
        }
        parcels[i] = parcel;
    }
}

fn main() {}
