//! Prints the hashes of all scenes on this machine, for the engine of this name, as `node.mjs golden` does for WebAssembly.

fn main() {
    let engine = std::env::args().nth(1).expect("the name of the engine");
    for scene in unisize_web::scenes() {
        let hash = unisize_web::golden(&scene).unwrap_or_else(|_| unreachable!("it is listed"));
        println!("{engine} {scene} {hash}");
    }
}
