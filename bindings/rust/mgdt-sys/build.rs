// SPDX-License-Identifier: MIT
//! Finds libmgdt: in MGDT_LIB_DIR if that is set, or else through pkg-config.

use std::env;
use std::path::Path;
use std::process::{exit, Command};

fn main() {
    for name in [
        "MGDT_LIB_DIR",
        "PKG_CONFIG",
        "PKG_CONFIG_PATH",
        "PKG_CONFIG_LIBDIR",
        "PKG_CONFIG_SYSROOT_DIR",
    ] {
        println!("cargo:rerun-if-env-changed={}", name);
    }
    println!("cargo:rerun-if-changed=build.rs");

    let found = match env::var("MGDT_LIB_DIR") {
        Ok(folder) if !folder.is_empty() => in_folder(&folder),
        _ => by_pkg_config(),
    };
    match found {
        Ok(folders) => {
            for folder in folders {
                println!("cargo:rustc-link-search=native={}", folder);
            }
            println!("cargo:rustc-link-lib=mgdt");
        }
        Err(tried) => {
            eprintln!(
                "mgdt-sys: libmgdt was not found.\n{}\n\
                 Install mgdt, and set MGDT_LIB_DIR to the folder of libmgdt.so or \
                 PKG_CONFIG_PATH to that of mgdt.pc.",
                tried
            );
            exit(1);
        }
    }
}

fn in_folder(folder: &str) -> Result<Vec<String>, String> {
    let names = ["libmgdt.so", "libmgdt.dylib", "mgdt.lib", "libmgdt.dll.a"];
    if names
        .iter()
        .any(|name| Path::new(folder).join(name).exists())
    {
        Ok(vec![folder.to_string()])
    } else {
        Err(format!(
            "MGDT_LIB_DIR is {}, which holds none of {}.",
            folder,
            names.join(", ")
        ))
    }
}

/// The folders that pkg-config names; none if the linker looks there by itself.
fn by_pkg_config() -> Result<Vec<String>, String> {
    let program = env::var("PKG_CONFIG").unwrap_or_else(|_| "pkg-config".to_string());
    let arguments = ["--libs-only-L", "mgdt >= 1.1"];
    let asked = format!(
        "MGDT_LIB_DIR is not set; {} {}",
        program,
        arguments.join(" ")
    );
    let output = Command::new(&program)
        .args(arguments)
        .output()
        .map_err(|e| format!("{}: {}", asked, e))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("{}: {}", asked, said.trim()));
    }
    // A blank within a folder's name comes with a backslash before it.
    let said = String::from_utf8_lossy(&output.stdout).replace("\\ ", "\0");
    Ok(said
        .split_whitespace()
        .filter_map(|word| word.strip_prefix("-L"))
        .map(|folder| folder.replace('\0', " "))
        .collect())
}
