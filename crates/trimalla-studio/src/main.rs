//! The studio in a window: `trimalla-studio [FILE or SCRIPT.tri]`; for `wasm32` the studio in a page.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    use std::process::ExitCode;
    use trimalla_studio::{Studio, Window};

    let file = std::env::args_os().nth(1);
    let size = eframe::egui::vec2(1280.0, 860.0);
    let viewport = eframe::egui::ViewportBuilder::default()
        .with_inner_size(size)
        .with_min_inner_size([640.0, 480.0])
        .with_title("trimalla");
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let shown = eframe::run_native(
        "trimalla",
        options,
        Box::new(move |created| {
            let mut studio = Studio::new(created.wgpu_render_state.as_ref().map(|state| state.target_format));
            if let Some(file) = &file {
                studio.open(&file.to_string_lossy());
            }
            Ok(Box::new(Window::new(studio)))
        }),
    );
    match shown {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: no window can be shown: {error}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(target_arch = "wasm32")]
fn main() {
    trimalla_studio::web::start();
}
