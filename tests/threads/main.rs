//! With any number of threads, the same events in the same order.

mod dim2;
mod dim3;
