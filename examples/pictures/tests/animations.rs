//! GIF files, read back.

use gif::{ColorOutput, DecodeOptions, DisposalMethod};
use unisize_pictures::{Animation, Camera, Color, Drawing, Picture, PictureError, palette};

const SIZE: [usize; 2] = [80, 60];

/// A ball at this share of its way across the picture.
fn frame(share: f32) -> Picture {
    let mut drawing = Drawing::new();
    drawing.ground(-1.0);
    drawing.sphere([4.0 * share - 2.0, 0.0, 0.0], 0.8, palette::by_index(2));
    let camera = Camera::orbit([0.0; 3], 8.0).raised(0.3);
    drawing.picture(&camera, SIZE).unwrap()
}

fn animation(shares: &[f32]) -> Animation {
    let mut animation = Animation::new(25);
    for &share in shares {
        animation.push(frame(share)).unwrap();
    }
    animation
}

fn written(animation: &Animation) -> Vec<u8> {
    let mut file = Vec::new();
    animation.write_gif_to(&mut file).unwrap();
    file
}

/// The pixels that a viewer shows, and for how long.
type Shown = (Vec<[u8; 3]>, u16);

/// What a viewer shows, with the repetitions.
fn shown(file: &[u8]) -> (Vec<Shown>, gif::Repeat) {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(file).unwrap();
    let size = [decoder.width() as usize, decoder.height() as usize];
    assert_eq!(size, SIZE);
    let mut canvas = vec![[0; 3]; size[0] * size[1]];
    let mut frames = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        assert_eq!(frame.dispose, DisposalMethod::Keep);
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let width = frame.width as usize;
            let (column, row) = (index % width, index / width);
            if pixel[3] != 0 {
                let place = (frame.top as usize + row) * size[0] + frame.left as usize + column;
                canvas[place] = [pixel[0], pixel[1], pixel[2]];
            }
        }
        frames.push((canvas.clone(), frame.delay));
    }
    (frames, decoder.repeat())
}

/// The largest and the mean difference of a channel.
fn difference(shown: &[[u8; 3]], picture: &Picture) -> (u8, f64) {
    let mut largest = 0;
    let mut sum = 0.0;
    for (index, pixel) in shown.iter().enumerate() {
        let Color(expected) = picture.pixel(index % SIZE[0], index / SIZE[0]).unwrap();
        for channel in 0..3 {
            let difference = pixel[channel].abs_diff(expected[channel]);
            largest = largest.max(difference);
            sum += f64::from(difference);
        }
    }
    (largest, sum / (3 * shown.len()) as f64)
}

#[test]
fn a_gif_file_holds_the_frames() {
    let shares = [0.0, 0.2, 0.4, 0.6, 0.8, 1.0];
    let file = written(&animation(&shares).hold(1.0));
    let (frames, repeat) = shown(&file);
    assert_eq!(frames.len(), shares.len());
    assert_eq!(repeat, gif::Repeat::Infinite);
    for ((pixels, delay), share) in frames.iter().zip(shares) {
        let (largest, mean) = difference(pixels, &frame(share));
        assert!(largest < 40 && mean < 3.0, "{largest} {mean} at {share}");
        assert_eq!(*delay, if share == 1.0 { 104 } else { 4 });
    }
}

#[test]
fn fewer_colours_take_less_room() {
    let shares = [0.0, 0.3, 0.6, 0.9];
    let many = written(&animation(&shares));
    let few = written(&animation(&shares).colors(32));
    assert!(few.len() < many.len() * 4 / 5);
    let (frames, _) = shown(&few);
    let colors: std::collections::BTreeSet<_> = frames.iter().flat_map(|frame| &frame.0).collect();
    assert!((8..=32).contains(&colors.len()), "{}", colors.len());
}

#[test]
fn what_does_not_move_takes_no_room() {
    let one = written(&animation(&[0.5])).len();
    let same = written(&animation(&[0.5; 10])).len();
    let moving = written(&animation(&[
        0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9,
    ]))
    .len();
    assert!(same < one + 10 * 40, "{one} {same}");
    assert!(moving < 5 * one, "{one} {moving}");
}

#[test]
fn the_loop_may_fade() {
    let mut animation = animation(&[0.0, 1.0]).tolerance(0);
    animation.fade_to_start(3);
    assert_eq!(animation.len(), 5);
    let (frames, _) = shown(&written(&animation));
    let away = |frame: usize| difference(&frames[frame].0, &self::frame(0.0)).1;
    assert!(away(1) > away(2) && away(2) > away(3) && away(3) > away(4));
}

#[test]
fn few_colours_are_kept_as_they_are() {
    let camera = Camera::top_down([0.0; 2], 2.0);
    let flat = |color: Color| {
        let mut drawing = Drawing::new();
        drawing.background(color, color);
        drawing.picture(&camera, SIZE).unwrap()
    };
    let colors = [[0, 0, 0], [255, 255, 255], [1, 2, 3], [250, 128, 7]];
    let mut animation = Animation::new(0).tolerance(0);
    for color in colors {
        animation.push(flat(Color(color))).unwrap();
    }
    let (frames, _) = shown(&written(&animation));
    for ((pixels, _), color) in frames.iter().zip(colors) {
        assert!(pixels.iter().all(|pixel| *pixel == color));
    }
}

#[test]
fn frames_must_fit() {
    let mut file = Vec::new();
    let error = Animation::new(25).write_gif_to(&mut file).unwrap_err();
    assert!(matches!(error, PictureError::NoFrames));
    let mut animation = animation(&[0.0]);
    let other = Drawing::new().picture(&Camera::orbit([0.0; 3], 1.0), [7, 5]);
    let error = animation.push(other.unwrap()).unwrap_err();
    assert!(error.to_string().contains("7 by 5"), "{error}");
    assert_eq!(animation.len(), 1);
}
