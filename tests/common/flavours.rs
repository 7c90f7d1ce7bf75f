//! Calls a macro of the test crate for each flavour of Rapier whose feature is on. Arguments are the name of a module, the crate, its module in
//! unisize, and the files with the code for its dimension and for its version.

#[allow(unused_macros)]
macro_rules! for_each_027 {
    ($make:ident) => {
        #[cfg(feature = "rapier2d-027")]
        $make!(dim2, rapier2d, rapier2d_027, "dim2.rs", "rapier_027.rs");
        #[cfg(feature = "rapier3d-027")]
        $make!(dim3, rapier3d, rapier3d_027, "dim3.rs", "rapier_027.rs");
        #[cfg(feature = "rapier2d-f64-027")]
        $make!(
            dim2_f64,
            rapier2d_f64,
            rapier2d_f64_027,
            "dim2.rs",
            "rapier_027.rs"
        );
        #[cfg(feature = "rapier3d-f64-027")]
        $make!(
            dim3_f64,
            rapier3d_f64,
            rapier3d_f64_027,
            "dim3.rs",
            "rapier_027.rs"
        );
    };
}

#[allow(unused_macros)]
macro_rules! for_each_036 {
    ($make:ident) => {
        #[cfg(feature = "rapier2d-036")]
        $make!(
            dim2_036,
            rapier2d_036,
            rapier2d_036,
            "dim2.rs",
            "rapier_036.rs"
        );
        #[cfg(feature = "rapier3d-036")]
        $make!(
            dim3_036,
            rapier3d_036,
            rapier3d_036,
            "dim3.rs",
            "rapier_036.rs"
        );
        #[cfg(feature = "rapier2d-f64-036")]
        $make!(
            dim2_f64_036,
            rapier2d_f64_036,
            rapier2d_f64_036,
            "dim2.rs",
            "rapier_036.rs"
        );
        #[cfg(feature = "rapier3d-f64-036")]
        $make!(
            dim3_f64_036,
            rapier3d_f64_036,
            rapier3d_f64_036,
            "dim3.rs",
            "rapier_036.rs"
        );
    };
}
