//! Everything that can be drawn: `sample.png` in space, `plane.png` in the plane, and `many.png`, 100,000 spheres.
//!
//! `cargo run --release --package unisize-pictures --example sample -- FOLDER`

use std::error::Error;
use std::f32::consts::{FRAC_1_SQRT_2, TAU};
use std::path::PathBuf;
use std::time::Instant;
use unisize_pictures::{Camera, Drawing, Legend, Picture, palette, thousands};

const SIZE: [usize; 2] = [800, 450];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".to_owned()));
    for (name, picture) in [
        ("sample.png", space()?),
        ("plane.png", plane()?),
        ("many.png", many()?),
    ] {
        let path = folder.join(name);
        picture.write_png(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}

fn space() -> Result<Picture, Box<dyn Error>> {
    let mut drawing = Drawing::new();
    drawing.ground(0.0);
    for index in 0..8 {
        let angle = index as f32 * TAU / 8.0;
        let (sine, cosine) = angle.sin_cos();
        let color = palette::by_index(index);
        drawing.sphere([3.5 * cosine, 0.5, 3.5 * sine], 0.5, color);
        drawing.capsule(
            [
                [2.2 * cosine, 0.25, 2.2 * sine],
                [1.6 * cosine, 1.4, 1.6 * sine],
            ],
            0.25,
            color,
        );
        let turned = [0.0, (-angle / 2.0).sin(), 0.0, (-angle / 2.0).cos()];
        drawing.cuboid(
            [5.0 * cosine, 0.35, 5.0 * sine],
            [0.35, 0.35, 0.7],
            turned,
            palette::by_share(index as f32 / 7.0),
        );
    }
    let tilted = [0.0, 0.0, FRAC_1_SQRT_2 / 2.0, 0.935];
    drawing.cuboid([0.0, 1.2, 0.0], [0.8, 0.4, 0.6], tilted, palette::FIXED);
    drawing.sphere([0.2, 1.7, 0.2], 0.6, palette::by_index(0));
    for index in 0..8 {
        let place = |index: usize| {
            let (sine, cosine) = (index as f32 * TAU / 8.0).sin_cos();
            [3.5 * cosine, 0.5, 3.5 * sine]
        };
        drawing.line([place(index), place(index + 1)], 2.0, palette::MARK, 0.9);
    }
    let camera = Camera::orbit([0.0, 0.4, 0.0], 14.0)
        .turned(0.5)
        .raised(0.45);
    let mut picture = drawing.picture(&camera, SIZE)?;
    picture.legend(
        &Legend::new("unisize")
            .fact("bodies", thousands(26))
            .fact("pairs", thousands(1_234))
            .fact("broad phase", "0.12 ms"),
    );
    Ok(picture)
}

fn plane() -> Result<Picture, Box<dyn Error>> {
    let mut drawing = Drawing::new();
    for index in 0..120 {
        let angle = index as f32 * 2.4;
        let away = (index as f32).sqrt() * 0.42;
        let center = [away * angle.cos(), away * angle.sin()];
        let color = palette::by_share(index as f32 / 120.0);
        if index % 2 == 0 {
            drawing.disc(center, 0.3, color);
        } else {
            drawing.rectangle(center, [0.3, 0.2], angle, color);
        }
        drawing.line(
            [[0.0; 3], [center[0], center[1], 0.0]],
            1.0,
            palette::MARK,
            0.3,
        );
    }
    let mut picture = drawing.picture(&Camera::top_down([0.0; 2], 11.0), SIZE)?;
    picture.legend(&Legend::new("plane").fact("bodies", 120));
    Ok(picture)
}

fn many() -> Result<Picture, Box<dyn Error>> {
    let mut drawing = Drawing::new();
    drawing.ground_with_grid(0.0, 5.0);
    for index in 0..100_000_usize {
        let [x, y, z] = [index % 50, index / 2500, index / 50 % 50].map(|cell| cell as f32);
        let jitter = (index as f32 * 12.9898).sin() * 0.3;
        drawing.sphere(
            [x - 24.5 + jitter, y + 0.5, z - 24.5 - jitter],
            0.5,
            palette::by_share(y / 40.0 + 0.3 * jitter),
        );
    }
    let camera = Camera::orbit([0.0, 15.0, 0.0], 110.0)
        .turned(0.6)
        .raised(0.4);
    let start = Instant::now();
    let mut picture = drawing.picture(&camera, SIZE)?;
    println!(
        "100,000 spheres in {:.0} ms",
        start.elapsed().as_secs_f64() * 1e3
    );
    picture.legend(&Legend::new("many").fact("bodies", thousands(100_000)));
    Ok(picture)
}
