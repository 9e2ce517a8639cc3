//! Colours of members, which the colour-blind can tell apart.

/// Okabe and Ito's colours without black, "Color Universal Design", 2008, and whether ink on them is black.
const COLOURS: [(&str, bool); 8] = [
    ("#56b4e9", true),
    ("#e69f00", true),
    ("#009e73", true),
    ("#f0e442", true),
    ("#0072b2", false),
    ("#d55e00", true),
    ("#cc79a7", true),
    ("#999999", true),
];

/// How a member is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Fill {
    pub(super) colour: &'static str,
    /// Of text on it.
    pub(super) ink: &'static str,
    /// Which stripes lie over it: members beyond the eighth have the colours again, striped.
    pub(super) stripes: usize,
}

/// The fill of a member.
pub(super) fn of(member: usize) -> Fill {
    let (colour, dark) = COLOURS[member % COLOURS.len()];
    Fill { colour, ink: if dark { "#111827" } else { "#ffffff" }, stripes: member / COLOURS.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_member_has_a_fill_of_its_own() {
        let fills: Vec<Fill> = (0..allotrope::MAX_MEMBERS).map(of).collect();
        for (n, fill) in fills.iter().enumerate() {
            assert!(fill.stripes < 3 && !fills[..n].contains(fill));
        }
    }

    /// Text is read at a contrast of 4.5 on, says WCAG 2.1.
    #[test]
    fn text_stands_out() {
        let luminance = |colour: &str| {
            let parts = [1, 3, 5].map(|at| u8::from_str_radix(&colour[at..at + 2], 16).unwrap());
            let linear = parts.map(|part| match f64::from(part) / 255.0 {
                dark if dark <= 0.04045 => dark / 12.92,
                light => ((light + 0.055) / 1.055).powf(2.4),
            });
            0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
        };
        for member in 0..8 {
            let fill = of(member);
            let (a, b) = (luminance(fill.colour), luminance(fill.ink));
            let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
            assert!(contrast >= 4.5, "{fill:?}: {contrast}");
        }
    }
}
