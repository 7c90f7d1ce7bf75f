//! Compiles the C++ peer, optimized whatever the profile is.

fn main() {
    let source = "cpp/cgal.cpp";
    println!("cargo::rerun-if-changed={source}");
    let compiled = cc::Build::new()
        .cpp(true)
        .std("c++17")
        .opt_level(3)
        .define("NDEBUG", None)
        .file(source)
        // Headers of others.
        .warnings(false)
        .try_compile("peers_cgal");
    if let Err(error) = compiled {
        println!("cargo::error={error}");
        println!("cargo::error=Is CGAL there? On Debian: apt-get install g++ libcgal-dev");
    }
}
