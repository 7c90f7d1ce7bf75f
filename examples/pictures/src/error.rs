//! Errors.

use std::io;
use std::path::PathBuf;

/// Why a picture or an animation cannot be made or written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// A picture without pixels, or with a side longer than [`Picture::MAX_SIDE`](crate::Picture::MAX_SIDE).
    #[error(
        "a picture cannot be {width} by {height} pixels: a side has 1 to {}",
        crate::Picture::MAX_SIDE
    )]
    Size {
        /// The width in pixels.
        width: usize,
        /// The height in pixels.
        height: usize,
    },
    /// A frame that differs in size from the first.
    #[error("a frame of {} by {} pixels does not fit an animation of {} by {}", frame[0], frame[1], animation[0], animation[1])]
    FrameSize {
        /// Width and height of the frame.
        frame: [usize; 2],
        /// Width and height of the frames before it.
        animation: [usize; 2],
    },
    /// An animation without frames.
    #[error("an animation has at least one frame")]
    NoFrames,
    /// A PNG file could not be encoded or written.
    #[error("cannot encode a PNG file")]
    Png(#[from] png::EncodingError),
    /// A GIF file could not be encoded or written.
    #[error("cannot encode a GIF file")]
    Gif(#[from] gif::EncodingError),
    /// A file could not be created or written.
    #[error("cannot write {}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}
