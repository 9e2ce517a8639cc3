//! Hand-written twins of the kernels: what an expert would write for one layout. `unsafe` is allowed here.

pub mod stencils;
pub mod streams;
pub mod transfer;

/// Compiles a function for every instruction set and picks the one that a kernel would use.
macro_rules! versions {
    ($(#[$doc:meta])* pub fn $name:ident $(<$(const $c:ident: usize),* $(; $($g:ident: $b:path),+)?>)? ($($arg:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? $body:block) => {
        $(#[$doc])*
        pub fn $name $(<$(const $c: usize,)* $($($g: $b,)+)?>)? (cpu: allotrope::Cpu, $($arg: $ty),*) $(-> $ret)? {
            #[inline(always)]
            fn body $(<$(const $c: usize,)* $($($g: $b,)+)?>)? ($($arg: $ty),*) $(-> $ret)? $body
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
            fn avx2 $(<$(const $c: usize,)* $($($g: $b,)+)?>)? ($($arg: $ty),*) $(-> $ret)? {
                body $(::<$($c,)* $($($g,)+)?>)? ($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
            fn avx512 $(<$(const $c: usize,)* $($($g: $b,)+)?>)? ($($arg: $ty),*) $(-> $ret)? {
                body $(::<$($c,)* $($($g,)+)?>)? ($($arg),*)
            }
            match cpu {
                // SAFETY: `Cpu` values that the caller may hold are available on this machine.
                #[cfg(target_arch = "x86_64")]
                allotrope::Cpu::Avx512 => unsafe { avx512 $(::<$($c,)* $($($g,)+)?>)? ($($arg),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                allotrope::Cpu::Avx2 => unsafe { avx2 $(::<$($c,)* $($($g,)+)?>)? ($($arg),*) },
                _ => body $(::<$($c,)* $($($g,)+)?>)? ($($arg),*),
            }
        }
    };
}
pub(crate) use versions;
