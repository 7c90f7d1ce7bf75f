//! Turns what patched copies of Rapier tell their dependents into a `cfg`: the scenes for 0.36 need their seam.

fn main() {
    for package in ["rapier2d", "rapier3d", "rapier2d_f64", "rapier3d_f64"] {
        println!("cargo::rustc-check-cfg=cfg(opened_{package})");
        let seam = format!("DEP_OPENED_{}_SEAM", package.to_uppercase());
        println!("cargo::rerun-if-env-changed={seam}");
        if std::env::var_os(seam).is_some() {
            println!("cargo::rustc-cfg=opened_{package}");
        }
    }
}
