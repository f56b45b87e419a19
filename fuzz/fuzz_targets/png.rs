//! Any file is refused with a reason or read into a picture with four bytes a pixel, which can be traced.
#![no_main]

use std::io::Cursor;

use libfuzzer_sys::fuzz_target;
use riverseed::import::png;
use riverseed_fuzz::check_trace;

/// The greatest number of pixels of a picture that is also traced: larger ones take longer and show nothing else.
const MOST: usize = 64 * 64;

fuzz_target!(|data: &[u8]| {
    match png::read(Cursor::new(data)) {
        Ok(image) => {
            let pixels = image.width as usize * image.height as usize;
            assert_eq!(image.rgba.len(), 4 * pixels);
            if pixels <= MOST {
                check_trace(image.width, image.height, &image.rgba);
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
