//! `riverseed render`: a recipe as a picture, as data, or as the files for a game; one map or many.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};

use clap::ArgMatches;

use super::form::{Form, form_of};
use super::grow::progress;
use super::map::{Files, Options};
use super::order::Order;
use super::output::Output;
use super::{Failure, batch, say, stdout};

/// Writes the requested files.
pub fn render(matches: &ArgMatches) -> Result<(), Failure> {
    let order = Order::of(matches)?;
    let wanted = matches.get_many::<PathBuf>("output").into_iter().flatten();
    let wanted = wanted.map(|path| Wanted::of(path)).collect::<Result<Vec<_>, _>>()?;
    if wanted.iter().any(|wanted| wanted.path.is_none()) {
        stdout::check()?;
    }
    let forms: Vec<Form> = wanted.iter().map(|wanted| wanted.form).collect();
    let options = Options::of(matches, &forms, &order.recipe)?;
    order.say_what_is_idle(&forms.iter().map(|form| form.is_picture()).collect::<Vec<_>>());
    match matches.get_one::<OsString>("seeds") {
        Some(seeds) => batch::render(matches, seeds, &order, &wanted, options),
        None => {
            let threads = std::thread::available_parallelism().unwrap_or(NonZero::<usize>::MIN);
            render_one(order, &wanted, &forms, options.on_threads(threads))
        }
    }
}

/// A requested file.
pub struct Wanted<'a> {
    pub form: Form,
    /// `None` for standard output.
    pub path: Option<&'a Path>,
}

impl<'a> Wanted<'a> {
    fn of(path: &'a Path) -> Result<Self, Failure> {
        match path.to_str() {
            Some("-") => Ok(Self { form: Form::Json, path: None }),
            _ => Ok(Self { form: form_of(path)?, path: Some(path) }),
        }
    }
}

fn render_one(order: Order, wanted: &[Wanted<'_>], forms: &[Form], options: Options) -> Result<(), Failure> {
    let outputs = wanted.iter().map(|wanted| wanted.path.map(Output::open).transpose());
    let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
    let mut outputs: Vec<_> = forms.iter().zip(outputs).collect();
    // Files come first, because the reader of standard output may stop early.
    outputs.sort_by_key(|(_, output)| !output.as_ref().is_some_and(Output::is_file));
    let progress = progress(&order.recipe, options.longest(forms));
    let files = Files::make(order, forms, options, &progress, &say)?;
    for (form, output) in outputs {
        match output {
            Some(output) => output.write(|out| files.write(*form, out))?,
            None => {
                let mut out = BufWriter::new(io::stdout().lock());
                files.write(*form, &mut out)?;
                out.flush()?;
            }
        }
    }
    progress.finish_and_clear();
    Ok(())
}
