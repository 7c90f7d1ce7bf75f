//! Pictures of a few bodies, pixel by pixel.

use unisize_pictures::{Camera, Color, Drawing, Picture, PictureError, palette};

const SIZE: [usize; 2] = [64, 48];
const RED: Color = Color([220, 30, 30]);
const BLUE: Color = Color([30, 30, 220]);

fn camera() -> Camera {
    Camera::orbit([0.0; 3], 10.0)
}

fn picture(draw: impl FnOnce(&mut Drawing)) -> Picture {
    let mut drawing = Drawing::new();
    draw(&mut drawing);
    drawing.picture(&camera(), SIZE).unwrap()
}

fn pixels(picture: &Picture) -> Vec<Color> {
    let [width, height] = picture.size();
    let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    places
        .map(|(column, row)| picture.pixel(column, row).unwrap())
        .collect()
}

fn middle(picture: &Picture) -> Color {
    let [width, height] = picture.size();
    picture.pixel(width / 2, height / 2).unwrap()
}

fn is_reddish(Color([red, _, blue]): Color) -> bool {
    red > 2 * blue
}

fn is_bluish(Color([red, _, blue]): Color) -> bool {
    blue > 2 * red
}

#[test]
fn what_is_in_front_hides_what_is_behind() {
    for front_first in [true, false] {
        let picture = picture(|drawing| {
            let mut spheres = [(2.0, 0.8, RED), (-2.0, 2.0, BLUE)];
            if !front_first {
                spheres.reverse();
            }
            for (z, radius, color) in spheres {
                drawing.sphere([0.0, 0.0, z], radius, color);
            }
        });
        assert!(is_reddish(middle(&picture)));
        // The larger one behind looks out at the side.
        assert!(is_bluish(picture.pixel(32 + 9, 24).unwrap()));
    }
}

#[test]
fn bodies_pierce_each_other() {
    let picture = picture(|drawing| {
        drawing.cuboid([0.0; 3], [3.0, 0.5, 0.5], [0.0, 0.0, 0.0, 1.0], BLUE);
        drawing.capsule([[0.0, -2.0, 0.0], [0.0, 2.0, 0.0]], 0.8, RED);
    });
    assert!(is_reddish(middle(&picture)));
    assert!(is_reddish(picture.pixel(32, 12).unwrap()));
    assert!(is_bluish(picture.pixel(32 + 14, 24).unwrap()));
    assert!(is_bluish(picture.pixel(32 - 14, 24).unwrap()));
}

#[test]
fn what_is_behind_the_camera_is_not_seen() {
    let empty = picture(|_| {});
    let behind = picture(|drawing| {
        // The camera is inside of this one.
        drawing.sphere([0.0, 0.0, 10.0], 1.0, RED);
        drawing.sphere([0.0, 0.0, 12.0], 1.0, RED);
        drawing.capsule([[-1.0, 0.0, 13.0], [1.0, 0.0, 13.0]], 1.0, RED);
        drawing.cuboid([0.0, 0.0, 14.0], [1.0; 3], [0.0, 0.0, 0.0, 1.0], RED);
        drawing.line([[-1.0, 0.0, 12.0], [1.0, 0.0, 12.0]], 3.0, RED, 1.0);
    });
    assert_eq!(pixels(&behind), pixels(&empty));
    let in_front = picture(|drawing| drawing.sphere([0.0; 3], 1.0, RED));
    assert_ne!(pixels(&in_front), pixels(&empty));
}

#[test]
fn what_is_not_finite_is_skipped_and_counted() {
    let mut drawing = Drawing::new();
    drawing.sphere([0.0; 3], 1.0, RED);
    let alone = drawing.picture(&camera(), SIZE).unwrap();
    let (nan, infinite) = (f32::NAN, f32::INFINITY);
    drawing.sphere([nan, 0.0, 0.0], 1.0, BLUE);
    drawing.sphere([0.0; 3], infinite, BLUE);
    drawing.capsule([[0.0, nan, 0.0], [0.0; 3]], 1.0, BLUE);
    drawing.capsule([[-3e38, 0.0, 0.0], [3e38, 0.0, 0.0]], 1.0, BLUE);
    drawing.cuboid([0.0; 3], [1.0, -1.0, 1.0], [0.0, 0.0, 0.0, 1.0], BLUE);
    drawing.cuboid([0.0; 3], [1.0; 3], [0.0; 4], BLUE);
    drawing.disc([0.0, infinite], 1.0, BLUE);
    drawing.rectangle([0.0, 0.0], [1.0, 1.0], nan, BLUE);
    drawing.line([[nan; 3], [0.0; 3]], 1.0, BLUE, 1.0);
    drawing.ground(nan);
    assert_eq!(drawing.skipped(), 10);
    assert_eq!(
        pixels(&drawing.picture(&camera(), SIZE).unwrap()),
        pixels(&alone)
    );
}

#[test]
fn no_number_is_too_much() {
    let (nan, infinite) = (f32::NAN, f32::INFINITY);
    let numbers = [0.0, -1.0, 1e-40, 1e20, 3e38, infinite, nan];
    let mut drawing = Drawing::new();
    for x in numbers {
        for y in numbers {
            drawing.sphere([x, y, 0.0], y, RED);
            drawing.capsule([[x, y, x], [y, x, 1.0]], y, RED);
            drawing.cuboid([y, x, 0.0], [x, y, 1.0], [x, y, 1.0, 0.0], RED);
            drawing.disc([x, y], x, RED);
            drawing.rectangle([x, 0.0], [x, y], y, RED);
            drawing.line([[x, y, 0.0], [y, x, 0.0]], x, RED, y);
        }
    }
    drawing.ground_with_grid(-1.0, 1e-3);
    for number in numbers {
        for camera in [
            Camera::orbit([number, 0.0, 0.0], 10.0).turned(number),
            Camera::orbit([0.0; 3], number).raised(number),
            Camera::top_down([number, 0.0], 5.0).field_of_view(number),
            Camera::top_down([0.0; 2], number),
        ] {
            drawing.picture(&camera, [16, 9]).unwrap();
        }
    }
}

#[test]
fn any_size_is_a_picture_or_an_error() {
    let mut drawing = Drawing::new();
    drawing.ground(0.0);
    drawing.sphere([0.0; 3], 1.0, RED);
    for size in [[1, 1], [1, 300], [300, 1], [17, 33]] {
        assert_eq!(drawing.picture(&camera(), size).unwrap().size(), size);
    }
    for size in [[0, 5], [5, 0], [usize::MAX, 1], [5, Picture::MAX_SIDE + 1]] {
        let error = drawing.picture(&camera(), size).unwrap_err();
        assert!(matches!(error, PictureError::Size { .. }), "{error}");
    }
}

#[test]
fn later_figures_lie_on_earlier_ones() {
    let camera = Camera::top_down([0.0; 2], 4.0);
    for colors in [[RED, BLUE], [BLUE, RED]] {
        let mut drawing = Drawing::new();
        drawing.disc([0.0; 2], 1.5, colors[0]);
        drawing.rectangle([0.0; 2], [0.5; 2], 0.0, colors[1]);
        let picture = drawing.picture(&camera, SIZE).unwrap();
        assert_eq!(middle(&picture), colors[1]);
        assert_eq!(picture.pixel(32, 24 + 12).unwrap(), colors[0]);
    }
}

#[test]
fn figures_are_where_they_belong() {
    // Twelve pixels to a unit of length.
    let camera = Camera::top_down([0.0; 2], 4.0);
    let mut drawing = Drawing::new();
    drawing.background(BLUE, BLUE);
    drawing.disc([1.0, 1.0], 0.5, RED);
    let picture = drawing.picture(&camera, SIZE).unwrap();
    for column in 0..SIZE[0] {
        for row in 0..SIZE[1] {
            let (x, y) = (column as f32 + 0.5 - 44.0, row as f32 + 0.5 - 12.0);
            let color = picture.pixel(column, row).unwrap();
            match x.hypot(y) {
                ..5.0 => assert_eq!(color, RED, "{column} {row}"),
                7.0.. => assert_eq!(color, BLUE, "{column} {row}"),
                _ => {}
            }
        }
    }
}

#[test]
fn a_body_darkens_the_ground() {
    let camera = camera().raised(1.0);
    let mut drawing = Drawing::new();
    drawing.ground_with_grid(0.0, 1e6);
    let bare = drawing.picture(&camera, SIZE).unwrap();
    // Above the picture, with its shadow in it.
    drawing.sphere([-3.0, 7.0, 3.0], 1.0, palette::FIXED);
    let shaded = drawing.picture(&camera, SIZE).unwrap();
    let sum = |picture: &Picture| -> u32 {
        let bytes = pixels(picture).into_iter().flat_map(|color| color.0);
        bytes.map(u32::from).sum()
    };
    assert!(sum(&shaded) < sum(&bare));
}

#[test]
fn a_line_goes_from_end_to_end() {
    let camera = Camera::top_down([0.0; 2], 4.0);
    let mut drawing = Drawing::new();
    drawing.background(BLUE, BLUE);
    drawing.line([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]], 2.0, RED, 1.0);
    let picture = drawing.picture(&camera, SIZE).unwrap();
    for column in 22..42 {
        assert_eq!(picture.pixel(column, 24), Some(RED), "{column}");
    }
    for (column, row) in [(18, 24), (46, 24), (32, 21), (32, 27)] {
        assert_eq!(picture.pixel(column, row), Some(BLUE));
    }
}

#[test]
fn a_png_file_holds_the_pixels() {
    let picture = picture(|drawing| drawing.sphere([0.0; 3], 2.0, RED));
    let mut file = Vec::new();
    picture.write_png_to(&mut file).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!([info.width as usize, info.height as usize], SIZE);
    let expected: Vec<u8> = pixels(&picture)
        .into_iter()
        .flat_map(|color| color.0)
        .collect();
    assert_eq!(bytes, expected);
}

#[test]
fn a_file_that_cannot_be_written_is_named() {
    let path = std::env::temp_dir().join("no such folder").join("x.png");
    let error = picture(|_| {}).write_png(&path).unwrap_err();
    assert!(error.to_string().contains("no such folder"), "{error}");
    let frame = Picture::numbered("a/pour.png".as_ref(), 7);
    assert_eq!(frame, std::path::Path::new("a/pour-0007.png"));
}
