mod derivatives;
mod errors;
#[rustfmt::skip]
mod printed;
mod rust;
mod values;
