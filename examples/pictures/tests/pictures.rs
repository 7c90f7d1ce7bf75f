//! Pictures of a few bodies, pixel by pixel, and an animation that is read back.

use gif::{ColorOutput, DecodeOptions};
use unisize_pictures::{Animation, Camera, Color, Drawing, Legend, Picture};

const SIZE: [usize; 2] = [64, 48];
const RED: Color = Color([220, 30, 30]);
const BLUE: Color = Color([30, 30, 220]);
const UPRIGHT: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

fn picture(camera: Camera, draw: impl FnOnce(&mut Drawing)) -> Picture {
    let mut drawing = Drawing::new();
    draw(&mut drawing);
    drawing.picture(&camera, SIZE).unwrap()
}

fn in_front() -> Camera {
    Camera::orbit([0.0; 3], 10.0)
}

fn brightness(picture: &Picture, [column, row]: [usize; 2]) -> u32 {
    let Color(channels) = picture.pixel(column, row).unwrap();
    channels.into_iter().map(u32::from).sum()
}

fn is_reddish(picture: &Picture, [column, row]: [usize; 2]) -> bool {
    let Color([red, _, blue]) = picture.pixel(column, row).unwrap();
    u16::from(red) > 2 * u16::from(blue)
}

#[test]
fn what_is_in_front_hides_what_is_behind() {
    for front_first in [true, false] {
        let picture = picture(in_front(), |drawing| {
            let mut spheres = [(2.0, 0.8, RED), (-2.0, 2.0, BLUE)];
            if !front_first {
                spheres.reverse();
            }
            for (z, radius, color) in spheres {
                drawing.sphere([0.0, 0.0, z], radius, color);
            }
        });
        assert!(is_reddish(&picture, [32, 24]));
        // The larger one behind looks out at the side.
        assert!(!is_reddish(&picture, [32 + 9, 24]));
    }
}

#[test]
fn bodies_reach_as_far_as_they_should() {
    // A unit of length in the middle is this many pixels.
    let scale = 24.0 / 0.35_f32.tan() / 10.0;
    let column = |x: f32| (32.0 + x * scale) as usize;
    type Draw = fn(&mut Drawing);
    let bodies: [(Draw, f32); 3] = [
        (|drawing| drawing.sphere([0.0; 3], 1.5, RED), 1.5),
        (
            |drawing| drawing.capsule([[-2.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 0.5, RED),
            2.5,
        ),
        (
            |drawing| drawing.cuboid([0.0; 3], [2.0, 1.0, 0.1], UPRIGHT, RED),
            2.0,
        ),
    ];
    for (draw, reach) in bodies {
        let picture = picture(in_front(), draw);
        assert!(is_reddish(&picture, [column(reach - 0.2), 24]), "{reach}");
        assert!(is_reddish(&picture, [column(0.2 - reach), 24]), "{reach}");
        assert!(!is_reddish(&picture, [column(reach + 0.3), 24]), "{reach}");
    }
}

#[test]
fn in_the_plane_the_later_is_on_top() {
    let camera = Camera::top_down([0.0; 2], 4.8);
    let picture = picture(camera, |drawing| {
        drawing.disc([0.0; 2], 2.0, BLUE);
        drawing.rectangle([0.0; 2], [1.0, 0.2], std::f32::consts::FRAC_PI_2, RED);
    });
    assert_eq!(picture.pixel(32, 24), Some(RED));
    assert_eq!(picture.pixel(32, 24 + 8), Some(RED), "it is upright");
    assert_eq!(picture.pixel(32 + 8, 24), Some(BLUE));
}

#[test]
fn a_body_casts_a_shadow_away_from_the_sun() {
    let camera = in_front().raised(1.0);
    let [lit, shaded] = [false, true].map(|has_ball| {
        picture(camera, |drawing| {
            drawing.ground(0.0);
            if has_ball {
                drawing.sphere([0.0, 2.0, 0.0], 0.5, RED);
            }
        })
    });
    // The shadow of the ball's middle is at (0.9, 0, -0.93).
    let darker = |place| brightness(&shaded, place) * 10 < brightness(&lit, place) * 9;
    let places = || (0..SIZE[1]).flat_map(|row| (0..SIZE[0]).map(move |column| [column, row]));
    assert!(places().any(|place| place[0] > 34 && darker(place) && !is_reddish(&shaded, place)));
    assert!(!places().any(|place| place[0] < 26 && darker(place)));
}

#[test]
fn nothing_panics() {
    let numbers = [f32::NAN, f32::INFINITY, -1.0, 0.0, 1e30];
    let picture = picture(in_front(), |drawing| {
        for x in numbers {
            drawing.sphere([x, 0.0, 0.0], x, RED);
            drawing.capsule([[x; 3], [0.0; 3]], x, RED);
            drawing.cuboid([x, 0.0, 90.0], [x; 3], [x; 4], RED);
            drawing.rectangle([x; 2], [x; 2], x, RED);
        }
    });
    assert_eq!(picture.size(), SIZE);
    for size in [[0, 9], [9, 0], [9, 100_000]] {
        assert!(Drawing::new().picture(&in_front(), size).is_err());
    }
}

#[test]
fn an_animation_shows_its_frames() {
    let frame = |x: f32| {
        let mut frame = picture(in_front(), |drawing| {
            drawing.sphere([x, 0.0, 0.0], 1.0, RED)
        });
        frame.legend(&Legend::new("a").fact("longer than the picture is wide", 1234));
        frame
    };
    let frames = [-1.0, 0.0, 0.0, 2.0].map(frame);
    let mut animation = Animation::new(255, 6);
    assert!(
        animation.write_gif_to(Vec::new()).is_err(),
        "there are no frames"
    );
    frames
        .iter()
        .for_each(|frame| animation.push(frame).unwrap());
    let mut file = Vec::new();
    animation.write_gif_to(&mut file).unwrap();

    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(&file[..]).unwrap();
    let mut shown = vec![[0; 3]; SIZE[0] * SIZE[1]];
    for frame in &frames {
        let part = decoder.read_next_frame().unwrap().unwrap();
        for (at, pixel) in part.buffer.chunks_exact(4).enumerate() {
            let (column, row) = (at % part.width as usize, at / part.width as usize);
            let place = (part.top as usize + row) * SIZE[0] + part.left as usize + column;
            if pixel[3] != 0 {
                shown[place] = [pixel[0], pixel[1], pixel[2]];
            }
        }
        let differences = shown.iter().enumerate().flat_map(|(at, shown)| {
            let Color(expected) = frame.pixel(at % SIZE[0], at / SIZE[0]).unwrap();
            [0, 1, 2].map(|channel| f64::from(shown[channel].abs_diff(expected[channel])))
        });
        let mean = differences.sum::<f64>() / (3 * shown.len()) as f64;
        assert!(mean < 3.0, "{mean}");
    }
    assert!(decoder.read_next_frame().unwrap().is_none());
}
