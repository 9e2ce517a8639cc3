//! Instruction sets: loop bodies are compiled for several, and one is chosen when the program runs.

use core::fmt;
use std::str::FromStr;
use std::sync::OnceLock;

/// An instruction set that loop bodies are compiled for.
///
/// Builds with debug assertions have one version of each loop, for what every processor of the architecture has, whatever is chosen: they
/// would take much longer to build.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Cpu {
    /// What every processor of the architecture has.
    Baseline,
    /// x86-64 with AVX2 and FMA.
    Avx2,
    /// x86-64 with AVX-512 (F, BW, CD, DQ, VL).
    Avx512,
}

impl Cpu {
    /// All of them, the plainest first.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// Whether this processor has it.
    pub fn available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => {
                // All that the version's `#[target_feature]` names.
                is_x86_feature_detected!("avx2")
                    && is_x86_feature_detected!("fma")
                    && is_x86_feature_detected!("bmi1")
                    && is_x86_feature_detected!("bmi2")
                    && is_x86_feature_detected!("lzcnt")
                    && is_x86_feature_detected!("popcnt")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.available()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("avx512cd")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The best that this processor has.
    pub fn best() -> Self {
        Self::ALL.into_iter().rev().find(|cpu| cpu.available()).unwrap_or(Self::Baseline)
    }

    /// What `ALLOTROPE_CPU` asks for, or else the best.
    ///
    /// # Errors
    /// Where the variable names no instruction set, or one that the processor lacks.
    pub fn from_environment() -> Result<Self, String> {
        match std::env::var("ALLOTROPE_CPU") {
            Ok(name) => {
                let cpu: Self = name.parse().map_err(|error| format!("ALLOTROPE_CPU: {error}"))?;
                if cpu.available() {
                    Ok(cpu)
                } else {
                    Err(format!("ALLOTROPE_CPU={name}: this processor lacks it; the best it has is `{}`", Self::best()))
                }
            }
            Err(_) => Ok(Self::best()),
        }
    }

    pub(crate) fn chosen() -> Self {
        static CHOSEN: OnceLock<Cpu> = OnceLock::new();
        *CHOSEN.get_or_init(|| Self::from_environment().unwrap_or_else(|error| panic!("{error}")))
    }
}

impl fmt::Display for Cpu {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        })
    }
}

impl FromStr for Cpu {
    type Err = String;
    fn from_str(name: &str) -> Result<Self, String> {
        Self::ALL
            .into_iter()
            .find(|cpu| cpu.to_string() == name)
            .ok_or_else(|| format!("`{name}` is no instruction set: it is `baseline`, `avx2` or `avx512`"))
    }
}
