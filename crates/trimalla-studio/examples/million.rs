//! How the studio answers with a million triangles: time of a frame's input, time of its drawing, time until a running
//! refinement is cancelled, memory.
//!
//! `cargo run --example million [POINTS]`; the window is drawn by software where there is no card.

use std::time::{Duration, Instant};

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use trimalla_studio::Studio;

fn main() {
    let points: usize = std::env::args().nth(1).and_then(|word| word.parse().ok()).unwrap_or(500_000);
    let mut harness = Harness::builder()
        .with_size(Vec2::new(1280.0, 860.0))
        .wgpu()
        .build_eframe(|created| Studio::new(created.wgpu_render_state.as_ref().map(|state| state.target_format)));
    let begin = Instant::now();
    harness.state_mut().enter(&format!("Generate random {points} 1\nTriangulate"));
    settle(&mut harness);
    println!("opened after {:.2} s, {} resident", begin.elapsed().as_secs_f64(), resident());
    let (input, frame) = times(&mut harness, |harness, i| {
        harness.event(Event::PointerMoved(Pos2::new(400.0 + i, 400.0)));
        harness.event(Event::PointerButton {
            pos: Pos2::new(400.0 + i, 400.0),
            button: PointerButton::Middle,
            pressed: i < 1.0,
            modifiers: Default::default(),
        });
    });
    println!("panning:  input answered within {input}, drawn within {frame}");
    let (input, frame) = times(&mut harness, |harness, i| {
        harness.event(Event::PointerMoved(Pos2::new(500.0, 400.0)));
        harness.event(Event::Zoom(if i < 30.0 { 1.3 } else { 0.7 }));
    });
    println!("zooming:  input answered within {input}, drawn within {frame}");
    let (mut longest_input, mut cancels) = (Duration::ZERO, Vec::new());
    for wait in [20, 100, 300, 700, 1500, 3000] {
        harness.get_by_role_and_label(Role::Button, "Refine").click();
        // A click takes a frame or two.
        for _ in 0..4 {
            harness.step();
        }
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_millis(wait) {
            let start = Instant::now();
            harness.step();
            longest_input = longest_input.max(start.elapsed());
            let _ = harness.render();
        }
        harness.step();
        if harness.state().document().is_some() {
            cancels.push("ended before".to_owned());
            harness.state_mut().enter("Undo");
            settle(&mut harness);
            continue;
        }
        harness.get_by_role_and_label(Role::Button, "Cancel").click();
        let start = Instant::now();
        harness.step();
        while harness.state().document().is_none() {
            std::thread::sleep(Duration::from_millis(1));
            harness.step();
        }
        let time = milliseconds(start.elapsed());
        let has_ended = harness.state().document().is_some_and(|document| document.figures().vertices > points);
        cancels.push(if has_ended { format!("{time} for the picture of what had ended") } else { time });
        if has_ended {
            harness.state_mut().enter("Undo");
        }
        settle(&mut harness);
    }
    println!("refining: input answered within {}, {} resident", milliseconds(longest_input), resident());
    println!("cancelled after {}, at six moments of the work", cancels.join(", "));
    println!("{} resident", resident());
}

/// The longest time of the input and of the drawing of 60 frames.
fn times(harness: &mut Harness<'_, Studio>, act: impl Fn(&mut Harness<'_, Studio>, f32)) -> (String, String) {
    let mut longest = [Duration::ZERO; 2];
    for i in 0..60 {
        act(harness, i as f32);
        let start = Instant::now();
        harness.step();
        longest[0] = longest[0].max(start.elapsed());
        let start = Instant::now();
        harness.render().expect("a frame is drawn");
        longest[1] = longest[1].max(start.elapsed());
    }
    (milliseconds(longest[0]), milliseconds(longest[1]))
}

fn settle(harness: &mut Harness<'_, Studio>) {
    for _ in 0..20_000 {
        harness.step();
        if harness.state().document().is_some() {
            break;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    harness.step();
    let _ = harness.render();
}

fn milliseconds(time: Duration) -> String {
    format!("{:.1} ms", 1e3 * time.as_secs_f64())
}

/// The memory of the process.
fn resident() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).unwrap_or("unknown");
    line.trim().to_owned()
}
