//! Compiles the C++ peer, optimized whatever the profile is.

fn main() {
    let source = "cpp/cgal.cpp";
    println!("cargo::rerun-if-changed={source}");
    cc::Build::new()
        .cpp(true)
        .std("c++17")
        .opt_level(3)
        .define("NDEBUG", None)
        .file(source)
        // Headers of others.
        .warnings(false)
        .compile("peers_cgal");
}
