//! The panel: controls, numbers, and charts.

use crate::chart;
use crate::choice::Choice;
use crate::history::History;
use crate::setup::{KernelName, RAPIERS_MARGIN, Setup};
use crate::stage::{Scene, Stage};
use kiss3d::egui::{
    Align2, Color32, ComboBox, Context, DragValue, Frame, Grid, RichText, ScrollArea, Slider, Ui,
    Window, vec2,
};
use unisize_pictures::Color;

/// The width of the panel in points.
pub(crate) const WIDTH: f32 = 330.0;

/// The colours of the lines of pairs and of strips.
pub(crate) const PAIRS: Color = Color([0xff, 0xf1, 0xd0]);
pub(crate) const STRIPS: Color = Color([0xc0, 0xa8, 0xff]);

/// Means are over this many steps.
const MEAN_OF: usize = 60;

/// The state of the controls.
pub(crate) struct Controls {
    pub(crate) scene: Scene,
    /// Applied at the next restart.
    pub(crate) bodies: usize,
    pub(crate) setup: Setup,
    pub(crate) shows_pairs: bool,
    pub(crate) shows_strips: bool,
    pub(crate) is_paused: bool,
    /// Whether a scene restarts when it is over.
    pub(crate) repeats: bool,
}

/// The buttons pressed in this frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Wishes {
    pub(crate) step: bool,
    pub(crate) restart: bool,
    pub(crate) camera: bool,
}

/// Draws the panel along the right edge of the window.
pub(crate) fn show(
    ctx: &Context,
    controls: &mut Controls,
    stage: &dyn Stage,
    history: &History,
) -> Wishes {
    let height = ctx.content_rect().height();
    let frame = Frame::window(&ctx.global_style())
        .inner_margin(10.0)
        .corner_radius(0.0)
        .shadow(kiss3d::egui::Shadow::NONE);
    let inner = vec2(WIDTH - 22.0, height - 22.0);
    let shown = Window::new("panel")
        .title_bar(false)
        .resizable(false)
        .movable(false)
        .anchor(Align2::RIGHT_TOP, vec2(0.0, 0.0))
        .frame(frame)
        .fixed_size(inner)
        .show(ctx, |ui| {
            ui.set_min_size(inner);
            ui.visuals_mut().override_text_color = Some(Color32::from_gray(200));
            let area = ScrollArea::vertical().auto_shrink(false);
            let contents = area.show(ui, |ui| {
                let wishes = scene(ui, controls);
                ui.separator();
                broad_phase(ui, controls);
                ui.separator();
                numbers(ui, controls, stage, history);
                ui.separator();
                chart::show(ui, history);
                wishes
            });
            contents.inner
        });
    shown.and_then(|shown| shown.inner).unwrap_or_default()
}

/// The choice of a scene, and the control of its time.
fn scene(ui: &mut Ui, controls: &mut Controls) -> Wishes {
    let mut wishes = Wishes::default();
    ui.horizontal(|ui| {
        let before = controls.scene;
        ComboBox::from_id_salt("scene")
            .selected_text(controls.scene.name())
            .show_ui(ui, |ui| {
                for scene in Scene::ALL {
                    ui.selectable_value(&mut controls.scene, scene, scene.name());
                }
            });
        if controls.scene != before {
            controls.bodies = controls.scene.bodies();
            wishes.restart = true;
        }
        ui.add(
            DragValue::new(&mut controls.bodies)
                .speed(50)
                .range(1..=1_000_000)
                .suffix(" bodies"),
        )
        .on_hover_text("from the next restart on");
    });
    ui.horizontal(|ui| {
        let pause = if controls.is_paused {
            "Resume"
        } else {
            "Pause"
        };
        if ui.button(pause).on_hover_text("space").clicked() {
            controls.is_paused = !controls.is_paused;
        }
        wishes.step = ui.button("Step").on_hover_text("N").clicked();
        wishes.restart |= ui.button("Restart").on_hover_text("R").clicked();
        wishes.camera = ui
            .button("Camera")
            .on_hover_text("back to its place")
            .clicked();
        ui.checkbox(&mut controls.repeats, "repeat")
            .on_hover_text("restart when the scene is over");
    });
    wishes
}

/// The choice of a broad phase, and what is drawn of it.
fn broad_phase(ui: &mut Ui, controls: &mut Controls) {
    let setup = &mut controls.setup;
    ui.horizontal(|ui| {
        for choice in [Choice::Unisize, Choice::Default] {
            ui.radio_value(&mut setup.choice, choice, choice.name())
                .on_hover_text(choice.line());
        }
    });
    ui.checkbox(&mut setup.times_both, "time both on the same world");
    ui.horizontal(|ui| {
        ui.label("kernel");
        ComboBox::from_id_salt("kernel")
            .selected_text(setup.kernel.name())
            .width(96.0)
            .show_ui(ui, |ui| {
                for kernel in KernelName::ALL {
                    ui.selectable_value(&mut setup.kernel, kernel, kernel.name());
                }
            });
        ui.label("margin");
        ui.spacing_mut().slider_width = 50.0;
        let margin = Slider::new(&mut setup.margin, 0.0..=0.1)
            .fixed_decimals(3)
            // Each change makes a new broad phase, so there are few steps.
            .step_by(0.005);
        ui.add(margin).on_hover_text(
            "how far a collider may move before its box is renewed, in units of length",
        );
    });
    ui.horizontal(|ui| {
        ui.checkbox(&mut controls.shows_pairs, colored("draw pairs", PAIRS));
        ui.checkbox(&mut controls.shows_strips, colored("draw strips", STRIPS))
            .on_hover_text("their number is exact, their place an estimate");
    });
}

/// The times and the facts, in two columns.
fn numbers(ui: &mut Ui, controls: &Controls, stage: &dyn Stage, history: &History) {
    let [broad_phase, step] = chart::means(history, MEAN_OF);
    Grid::new("numbers")
        .num_columns(2)
        .spacing([12.0, 2.0])
        .min_col_width(132.0)
        .show(ui, |ui| {
            for (name, means) in [("broad phase", broad_phase), ("whole step", step)] {
                ui.label(name)
                    .on_hover_text(format!("the mean of the last {MEAN_OF} steps"));
                ui.horizontal(|ui| {
                    for (mean, color) in means.into_iter().zip([chart::UNISIZE, chart::DEFAULT]) {
                        if let Some(mean) = mean {
                            let text = format!("{mean:.3} ms");
                            ui.label(RichText::new(text).color(color));
                        }
                    }
                });
                ui.end_row();
            }
            for fact in stage.facts() {
                ui.label(fact.name).on_hover_text(fact.hint);
                ui.label(RichText::new(fact.value).color(Color32::WHITE));
                ui.end_row();
            }
            if let Some(agree) = stage.agree() {
                ui.label("pairs of both");
                let comparable = controls.setup.margin == RAPIERS_MARGIN;
                ui.label(match (agree, comparable) {
                    (true, _) => RichText::new("the same").color(Color32::WHITE),
                    (false, true) => RichText::new("DIFFERENT").color(Color32::LIGHT_RED),
                    (false, false) => RichText::new("different, because the margins are"),
                });
                ui.end_row();
            }
        });
}

fn colored(text: &str, Color([red, green, blue]): Color) -> RichText {
    RichText::new(text).color(Color32::from_rgb(red, green, blue))
}
