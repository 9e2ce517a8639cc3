//! Hand-written twins of the kernels: what an expert would write for one layout. `unsafe` is allowed here.

pub(crate) mod bodies;
pub(crate) mod shell;
pub(crate) mod springs;
pub(crate) mod stencils;
pub(crate) mod streams;
pub(crate) mod transfer;

/// A list that begins at a cache line, as fields do: an expert aligns what vectors stream through.
pub(crate) struct Aligned<T> {
    buffer: Vec<T>,
    first: usize,
    len: usize,
}

impl<T: Copy> Aligned<T> {
    /// A copy of the values.
    pub(crate) fn new(values: &[T]) -> Self {
        const LINE: usize = 64;
        let spare = LINE / size_of::<T>();
        let mut buffer: Vec<T> = Vec::with_capacity(values.len() + spare);
        let first = buffer.as_ptr().align_offset(LINE);
        assert!(first <= spare, "the element divides a cache line");
        if let Some(&value) = values.first() {
            buffer.resize(first, value);
        }
        buffer.extend_from_slice(values);
        Self { buffer, first, len: values.len() }
    }
}

impl<T> core::ops::Deref for Aligned<T> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        &self.buffer[self.first..][..self.len]
    }
}

impl<T> core::ops::DerefMut for Aligned<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.buffer[self.first..][..self.len]
    }
}

/// Compiles a function for every instruction set and picks the one that a kernel would use.
macro_rules! versions {
    ($(#[$doc:meta])* pub fn $name:ident $(<$(const $c:ident: usize),* $(; $($g:ident: $b:path),+)?>)? ($($arg:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? $body:block) => {
        $(#[$doc])*
        pub(crate) fn $name $(<$(const $c: usize,)* $($($g: $b,)+)?>)? (cpu: allotrope::Cpu, $($arg: $ty),*) $(-> $ret)? {
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
