//! A broad phase that is written in the midst of a simulation and read again goes on as if nothing had happened: the same
//! events in the same order. And whatever is read that was not so written does no harm.

mod boxes;
mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;
