mod derivatives;
mod errors;
mod values;
