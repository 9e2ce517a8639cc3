//! The error codes of the macros: what is wrong, why, and what to write instead.
//!
//! Each error of `#[derive(Record)]`, `layout!` and `#[kernel]` ends with a code in brackets, which never changes its meaning:
//! `A01..` and `A02..` are kernels, `A03..` records, `A04..` layouts, `A05..` warnings of kernels. Each has a page here, with an example of both.

macro_rules! pages {
    ($($code:ident)*) => {$(
        #[doc = include_str!(concat!("../errors/", stringify!($code), ".md"))]
        #[allow(non_snake_case, reason = "the code as errors show it")]
        pub mod $code {}
    )*};
}

pages! {
    A0101 A0102 A0103 A0104 A0105 A0106 A0107 A0108
    A0110 A0111 A0112 A0113 A0115 A0116 A0117 A0118 A0119
    A0120 A0121 A0122 A0123 A0124 A0125
    A0201 A0202 A0203 A0204 A0205 A0206 A0207 A0208 A0209
    A0210 A0212 A0213 A0214 A0215 A0216 A0217 A0218 A0219
    A0220 A0221 A0223 A0224 A0225 A0226 A0227
    A0301 A0302 A0303 A0304 A0305 A0306 A0307
    A0401 A0403 A0404 A0405 A0406 A0407 A0408 A0409
    A0410 A0411 A0412 A0413 A0414 A0415 A0416 A0417 A0418 A0419
    A0420 A0421 A0422 A0423 A0424
    A0501 A0502 A0503 A0504
}
