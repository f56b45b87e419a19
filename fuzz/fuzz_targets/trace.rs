//! Any small picture is traced to an outline that fits a recipe, or refused with a reason. The first byte is the width;
//! each other byte is a pixel: one of the colours with a meaning, or a grey.
#![no_main]

use libfuzzer_sys::fuzz_target;
use riverseed_fuzz::check_trace;

/// The greatest number of pixels: larger pictures take longer and show nothing else.
const MOST: usize = 64 * 64;

fuzz_target!(|data: &[u8]| {
    let Some((&width, pixels)) = data.split_first() else { return };
    let width = usize::from(width).max(1);
    let height = pixels.len().min(MOST) / width;
    let rgba: Vec<u8> = pixels[..width * height].iter().flat_map(|&pixel| colour(pixel)).collect();
    check_trace(width as u32, height as u32, &rgba);
});

fn colour(pixel: u8) -> [u8; 4] {
    match pixel {
        b'.' => [0, 0, 0, 255],
        b'#' => [255, 255, 255, 255],
        b'^' => [255, 0, 0, 255],
        b' ' => [255, 255, 255, 0],
        grey => [grey, grey, grey, 255],
    }
}
