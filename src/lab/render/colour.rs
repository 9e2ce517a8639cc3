//! Colours in linear light, and scales of them.

use std::ops::{Add, Mul};

/// Red, green and blue in linear light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Colour(pub(super) [f32; 3]);

impl Add for Colour {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|c| self.0[c] + other.0[c]))
    }
}

impl Mul<f32> for Colour {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}

impl Colour {
    /// From a hexadecimal sRGB colour.
    pub(super) fn hex(rgb: u32) -> Self {
        Self([16, 8, 0].map(|shift| {
            let component = (rgb >> shift & 255) as f32 / 255.0;
            if component <= 0.04045 { component / 12.92 } else { ((component + 0.055) / 1.055).powf(2.4) }
        }))
    }

    /// Bytes of sRGB; what is too bright is clipped.
    pub(super) fn srgb(self) -> [u8; 3] {
        self.0.map(|light| {
            let light = light.clamp(0.0, 1.0);
            let component = if light <= 0.003_130_8 { light * 12.92 } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
            (component * 255.0).round() as u8
        })
    }

    /// Between this colour and another.
    pub(super) fn mix(self, other: Self, share: f32) -> Self {
        self * (1.0 - share) + other * share
    }
}

/// The background.
pub(super) const NIGHT: u32 = 0x0b0f1a;

/// The scale of speeds, from rest to fast: deep blue over turquoise and cream to orange.
const SPEEDS: [u32; 5] = [0x1d4fb8, 0x2a93e0, 0x5fd9d3, 0xf4f0b4, 0xff9a4a];

/// The scale of pressures, from tension over none, which is grey, to compression.
const PRESSURES: [u32; 5] = [0x2166c8, 0x7fb2e6, 0xd9d6d0, 0xf0925e, 0xc4202c];

/// A scale of colours, ready for use.
pub(super) struct Scale([Colour; 5]);

impl Scale {
    /// The scale of speeds.
    pub(super) fn speeds() -> Self {
        Self(SPEEDS.map(Colour::hex))
    }

    /// The scale of pressures; none lies in the middle.
    pub(super) fn pressures() -> Self {
        Self(PRESSURES.map(Colour::hex))
    }

    /// The colour at a place from zero to one.
    pub(super) fn at(&self, tone: f32) -> Colour {
        let place = tone.clamp(0.0, 1.0) * (self.0.len() - 1) as f32;
        let below = (place as usize).min(self.0.len() - 2);
        self.0[below].mix(self.0[below + 1], place - below as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_comes_back() {
        for rgb in [0x000000, 0xffffff, 0x0b0f1a, 0xff9a4a] {
            let [r, g, b] = Colour::hex(rgb).srgb().map(u32::from);
            assert_eq!(r << 16 | g << 8 | b, rgb);
        }
    }

    #[test]
    fn scales_run_from_end_to_end() {
        for (scale, colours) in [(Scale::speeds(), SPEEDS), (Scale::pressures(), PRESSURES)] {
            assert_eq!(scale.at(0.0), Colour::hex(colours[0]));
            assert_eq!(scale.at(0.25), Colour::hex(colours[1]));
            assert_eq!(scale.at(0.5), Colour::hex(colours[2]));
            assert_eq!(scale.at(1.0), Colour::hex(colours[4]));
        }
    }
}
