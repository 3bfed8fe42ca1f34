//! Puts the memory map of the target where the linker looks for it.

use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Of the board that QEMU has with such a processor.
    let map = match env::var("TARGET")?.as_str() {
        "thumbv6m-none-eabi" => "memory/microbit.x",
        _ => "memory/mps2-an386.x",
    };
    let out = env::var("OUT_DIR")?;
    fs::copy(map, Path::new(&out).join("memory.x"))?;
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rerun-if-changed=memory");
    Ok(())
}
