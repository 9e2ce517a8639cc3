//! The book's examples, as tests of the documentation. The book is no part of the package.

macro_rules! chapters {
    ($($name:ident)*) => {$(
        #[doc = include_str!(concat!("../../docs/book/src/", stringify!($name), ".md"))]
        pub mod $name {}
    )*};
}

chapters! {
    why_layouts first_kernel records_layouts_fields loops_and_races accumulation sparse_fields generic_kernels layouts_compared springs wcsph expansion adding from_taichi
}
