//! The main loop: simulate a step, draw it, and handle the user's input.

use crate::camera::Eye;
use crate::figures::{Figures, shown};
use crate::history::History;
use crate::lines::{Line, strip_lines, usual_size};
use crate::options::Options;
use crate::panel::{self, Controls, Wishes};
use crate::setup::Setup;
use crate::stage::Stage;
use crate::window;
use anyhow::{Context, Result};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use kiss3d::camera::Camera3d;
use kiss3d::color::Color;
use kiss3d::event::{Action, Key, WindowEvent};
use kiss3d::glamx::Vec3;
use kiss3d::window::Window;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::time::{Duration, Instant};
use unisize_pictures::{Drawing, palette};

/// The number of steps on the chart.
const HISTORY: usize = 300;

/// The simulated time of a step.
const STEP: Duration = Duration::from_nanos(1_000_000_000 / 60);

/// Frames until the layout of the panel has settled.
const SETTLED: usize = 4;

/// The most lines of the grid on the ground in each direction.
const GRID_LINES: f32 = 120.0;

/// Runs until the window is closed or its picture is taken.
///
/// # Errors
/// If the window cannot be opened or the picture cannot be written.
pub(crate) fn run(options: &Options) -> Result<()> {
    let mut viewer = Viewer::new(options)?;
    if let Some(path) = &options.screenshot {
        for _ in 0..options.after {
            viewer.step();
        }
        viewer.controls.is_paused = true;
        for _ in 0..SETTLED {
            viewer.frame();
        }
        return viewer.take_picture(path);
    }
    while viewer.frame() {}
    Ok(())
}

struct Viewer {
    window: Window,
    controls: Controls,
    /// The setup of the broad phases that are on stage.
    setup: Setup,
    stage: Box<dyn Stage>,
    history: History,
    figures: Figures,
    eye: Eye,
    /// The initial distance of the camera: about the size of the scene.
    reach: f32,
    /// When the next step is due.
    due: Instant,
}

impl Viewer {
    fn new(options: &Options) -> Result<Self> {
        let setup = options.setup();
        let window = window::open(options.size())?;
        let stage = options.scene.open(options.bodies(), &setup);
        let eye = Eye::new(&stage.camera(), free_aspect(&window));
        Ok(Self {
            window,
            controls: Controls {
                scene: options.scene,
                bodies: options.bodies(),
                setup,
                shows_pairs: options.pairs,
                shows_strips: options.strips,
                is_paused: options.paused,
                repeats: false,
            },
            setup,
            stage,
            history: History::new(HISTORY),
            figures: Figures::new(),
            reach: eye.distance(),
            eye,
            due: Instant::now(),
        })
    }

    /// Simulates a step if one is due, and draws. Returns whether the window is still open.
    fn frame(&mut self) -> bool {
        let now = Instant::now();
        if !self.controls.is_paused && now >= self.due {
            self.step();
            // Where steps take longer than they should, simulated time slows down and no backlog builds up.
            self.due = now.max(self.due + STEP);
        }
        self.draw();
        let mut wishes = Wishes::default();
        let (controls, stage, history) = (&mut self.controls, &*self.stage, &self.history);
        self.window
            .draw_ui(|ctx| wishes = panel::show(ctx, controls, stage, history));
        let is_open = pollster::block_on(self.window.render_3d(self.figures.root(), &mut self.eye));
        self.read_keys(&mut wishes);
        self.fulfil(wishes);
        is_open
    }

    fn step(&mut self) {
        if self.controls.repeats && self.stage.steps() >= self.stage.length() {
            self.restart();
        }
        self.history.push(self.stage.step());
    }

    fn restart(&mut self) {
        self.stage = self.controls.scene.open(self.controls.bodies, &self.setup);
        self.history.clear();
    }

    fn read_keys(&mut self, wishes: &mut Wishes) {
        if self.window.is_egui_capturing_keyboard() {
            return;
        }
        for event in self.window.events().iter() {
            match event.value {
                WindowEvent::Key(Key::Space, Action::Press, _) => {
                    self.controls.is_paused = !self.controls.is_paused;
                }
                WindowEvent::Key(Key::N, Action::Press, _) => wishes.step = true,
                WindowEvent::Key(Key::R, Action::Press, _) => wishes.restart = true,
                _ => {}
            }
        }
    }

    fn fulfil(&mut self, wishes: Wishes) {
        if self.setup != self.controls.setup {
            self.setup = self.controls.setup;
            self.stage.change(&self.setup);
        }
        if wishes.restart {
            self.restart();
        }
        if wishes.restart || wishes.camera {
            self.eye = Eye::new(&self.stage.camera(), free_aspect(&self.window));
            self.reach = self.eye.distance();
        }
        if wishes.step {
            self.controls.is_paused = true;
            self.step();
        }
    }

    fn draw(&mut self) {
        let size = [self.window.width(), self.window.height()];
        let panel = panel_width(&self.window);
        self.eye.fit(self.window.canvas(), size, panel);
        let mut drawing = Drawing::new();
        self.stage.draw(&mut drawing);
        let [upper, lower] = drawing.background_colors();
        self.window
            .set_background_color(shown(upper.mix(lower, 0.5)));
        self.figures.show(&drawing, self.eye.target(), self.reach);
        if let Some([height, pitch]) = drawing.ground_and_pitch() {
            self.draw_grid(height, pitch);
        }
        if self.controls.shows_strips {
            let extents = self.stage.extents();
            let strips = strip_lines(&extents, self.stage.strips(), self.eye.eye().into());
            self.draw_lines(&strips, 0.002 * self.reach, panel::STRIPS, 1.0);
        }
        if self.controls.shows_pairs {
            // In front of the bodies, which would hide them.
            let nearer = 0.6 * usual_size(&self.stage.extents());
            let pairs = self.stage.pair_lines();
            self.draw_lines(&pairs, nearer, panel::PAIRS, 1.0);
        }
    }

    fn draw_grid(&mut self, height: f32, pitch: f32) {
        let half = 2.0 * self.reach;
        let mut pitch = pitch;
        while half / pitch > GRID_LINES {
            pitch *= 10.0;
        }
        let middle = self.eye.target();
        let mut lines: Vec<Line> = Vec::new();
        for axis in [0, 2] {
            let across = 2 - axis;
            let first = ((middle[axis] - half) / pitch).ceil();
            let last = ((middle[axis] + half) / pitch).floor();
            for number in first as i32..=last as i32 {
                let mut line = [[height; 3]; 2];
                for (end, side) in line.iter_mut().zip([-half, half]) {
                    end[axis] = number as f32 * pitch;
                    end[across] = middle[across] + side;
                }
                lines.push(line);
            }
        }
        self.draw_lines(&lines, 0.0, palette::GRID, 1.0);
    }

    /// Draws lines, moved towards the eye by `nearer`.
    fn draw_lines(
        &mut self,
        lines: &[Line],
        nearer: f32,
        color: unisize_pictures::Color,
        width: f32,
    ) {
        let color: Color = shown(color);
        for line in lines {
            let [start, end] = line.map(|end| self.eye.nearer(Vec3::from(end), nearer));
            self.window.draw_line(start, end, color, width, false);
        }
    }

    fn take_picture(&self, path: &Path) -> Result<()> {
        let cannot = || format!("cannot write {}", path.display());
        let file = BufWriter::new(File::create(path).with_context(cannot)?);
        // Areas of one colour compress best without a filter.
        let quality = (CompressionType::Best, FilterType::NoFilter);
        let encoder = PngEncoder::new_with_quality(file, quality.0, quality.1);
        let picture = self.window.snap_image();
        picture.write_with_encoder(encoder).with_context(cannot)
    }
}

/// The width of the panel in pixels.
fn panel_width(window: &Window) -> f32 {
    panel::WIDTH * window.scale_factor() as f32
}

/// The aspect ratio of the part of the window beside the panel.
fn free_aspect(window: &Window) -> f32 {
    let free = window.width() as f32 - panel_width(window);
    free.max(1.0) / window.height().max(1) as f32
}
