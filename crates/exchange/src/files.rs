//! The files of one finished map. What several of them hold is made once.

use std::io::{self, Write};

use riverseed::Map;
use riverseed::export::rasters::Rasters;
use riverseed::glam::Vec2;
use riverseed::paint::{PaintError, Painted};
use riverseed::picture::Picture;
use riverseed::relief::ReliefError;
use thiserror::Error;

use crate::engine::EngineError;
use crate::form::Form;
use crate::memory;
use crate::options::Options;
use crate::rasters::rasters;
use crate::write::{Source, write};

/// Reasons why there are no files of a map.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FilesError {
    /// There are no such rasters.
    #[error(transparent)]
    Rasters(#[from] EngineError),
    /// There is no such picture.
    #[error(transparent)]
    Paint(#[from] PaintError),
    /// There is no relief for the picture.
    #[error(transparent)]
    Relief(#[from] ReliefError),
    /// There was not enough memory.
    #[error(transparent)]
    Memory(#[from] io::Error),
}

/// The files of a finished map.
#[derive(Debug)]
pub struct Files {
    map: Map,
    /// The attractors that the tree grew to, if a file lists them.
    attractors: Option<Vec<Vec2>>,
    picture: Option<Picture>,
    rasters: Option<Rasters>,
    options: Options,
}

impl Files {
    /// Makes what files in these forms hold. The map must have its relief if one of them `has_relief`; the picture, from
    /// [`Options::picture`], is painted by [`Files::paint_part`].
    ///
    /// # Errors
    /// Fails if there are no rasters of the given size, or if there is not enough memory.
    pub fn make(map: Map, forms: &[Form], options: Options, mut picture: Option<Picture>) -> Result<Self, FilesError> {
        // An engine's are of a size of its own, and made when its pack is written; all others are the same.
        let with_rasters = forms.iter().find(|form| form.has_rasters() && !matches!(form, Form::Engine(_)));
        let rasters = with_rasters.map_or(Ok(None), |form| rasters(*form, &map, &options))?;
        if let Some(picture) = &mut picture {
            memory::ask_for_picture(&map, picture.pixmap())?;
            picture.refine(&map, options.threads())?;
        }
        Ok(Self { map, attractors: None, picture, rasters, options })
    }

    /// Adds the attractors that the tree grew to, which JSON lists then.
    #[must_use]
    pub fn with_attractors(self, attractors: Option<Vec<Vec2>>) -> Self {
        Self { attractors, ..self }
    }

    /// Paints a part of the picture, if there is one, so that a program can do other work in between. Returns `true` if
    /// there is more to paint.
    pub fn paint_part(&mut self) -> bool {
        self.picture.as_mut().is_some_and(|picture| picture.paint_map_part(&self.map) == Painted::Part)
    }

    /// Returns what has to be said to readers of files in these forms, since bare heights cannot say it by themselves.
    pub fn note(&self, forms: &[Form]) -> Option<String> {
        let Rasters { columns, rows, scale, .. } =
            self.rasters.as_ref().filter(|_| forms.contains(&Form::RawHeights))?;
        let (sea_level, step) = (scale.sea_level, scale.metres_a_step);
        Some(format!(".r16 has {columns} x {rows} pixels; {sea_level} is the sea's surface, and a step is {step:.6} m"))
    }

    /// Writes a file in one of the forms that were asked for.
    ///
    /// # Errors
    /// Fails for other forms, if there is not enough memory, and with the writer's errors.
    pub fn write(&self, form: Form, out: &mut dyn Write) -> io::Result<()> {
        let Self { map, attractors, picture, rasters: shared, options } = self;
        memory::ask_for_file(map, form)?;
        let own = if matches!(form, Form::Engine(_)) { rasters(form, map, options)? } else { None };
        let source = Source {
            map,
            rasters: own.as_ref().or(shared.as_ref()),
            picture: picture.as_ref().map(Picture::pixmap),
            attractors: attractors.as_deref(),
            has_svg_text: options.has_svg_text,
            sheet: options.sheet(),
            has_beds: options.has_beds(form),
        };
        write(form, out, &source)
    }
}
