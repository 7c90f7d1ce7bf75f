//! With any number of threads, the same events in the same order.

mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;
