//! `trimalla-bindgen STUDIO.wasm FOLDER`: writes `studio.js` and `studio_bg.wasm`, which a page loads.
//!
//! The program `wasm-bindgen` does the same. This one is locked to the version of the studio.

use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let [input, folder] = match <[String; 2]>::try_from(std::env::args().skip(1).collect::<Vec<_>>()) {
        Ok(arguments) => arguments,
        Err(_) => {
            eprintln!("usage: trimalla-bindgen STUDIO.wasm FOLDER");
            return ExitCode::FAILURE;
        }
    };
    let mut bindgen = Bindgen::new();
    bindgen
        .input_path(input)
        .out_name("studio")
        .typescript(false)
        .omit_default_module_path(false)
        .remove_name_section(true)
        .remove_producers_section(true);
    match bindgen.web(true).and_then(|bindgen| bindgen.generate(folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
