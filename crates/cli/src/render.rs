//! `riverseed render`: a recipe as a picture, as data, or as the files for a game; one map or many.

use std::ffi::OsString;
use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use clap::ArgMatches;
use riverseed::recipe::Key;
use riverseed_exchange::{Form, Options};

use super::grow::progress;
use super::map::{all_threads, make, options};
use super::order::Order;
use super::output::Output;
use super::wanted::Wanted;
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
    let options = options(matches, &forms, &order.recipe)?;
    // Seeds whose words draw their countries use different values.
    if matches.get_one::<OsString>("seeds").is_none() || order.recipe.is_named(Key::Country) {
        order.say_what_is_idle(&forms.iter().map(|form| form.is_picture()).collect::<Vec<_>>());
    }
    match matches.get_one::<OsString>("seeds") {
        Some(seeds) => batch::render(matches, seeds, &order, &wanted, options),
        None => render_one(order, &wanted, &forms, Options { threads: Some(all_threads()), ..options }),
    }
}

fn render_one(order: Order, wanted: &[Wanted<'_>], forms: &[Form], options: Options) -> Result<(), Failure> {
    let outputs = wanted.iter().map(|wanted| wanted.path.map(Output::open).transpose());
    let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
    let mut outputs: Vec<_> = forms.iter().zip(outputs).collect();
    // Files come first, because the reader of standard output may stop early.
    outputs.sort_by_key(|(_, output)| !output.as_ref().is_some_and(Output::is_file));
    let progress = progress(&order.recipe, options.longest(forms));
    let files = make(order, forms, options, &progress, &say)?;
    for (form, output) in outputs {
        match output {
            Some(output) => output.write(|out| Ok(files.write(*form, out)?))?,
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
