//! Complete links, so that tests and golden pictures do not depend on defaults of the table.

use riverseed::recipe::preset;

/// Three rivers that leave a plain rectangle: the values of keys that a test's link leaves out.
const PLAIN: &str = "growth=colonize&aspect=1.5&land=rectangle&sea=0.5&roughness=0.5&mouths=3&attractors=6000&curl=0&stretch=8&trim=20&simplify=60&width=14\
                     &meander-rounds=24&meander-elsewhere=0.3&great-rivers=1&flat-share=0.25&style=ink&labels=none";

/// Adds all values of [`PLAIN`] that neither the link nor its preset names. Drainage has the table's valleys, space
/// colonization none.
pub fn plain(link: &str) -> String {
    let valleys = if link.contains("growth=drainage") { "" } else { "&valleys=0" };
    let whole = format!("{PLAIN}{valleys}");
    let named = |key: &str| link.split('&').any(|pair| pair.split('=').next() == Some(key)) || preset_names(link, key);
    let rest = whole.split('&').filter(|pair| !pair.split('=').next().is_some_and(named));
    [link].into_iter().filter(|link| !link.is_empty()).chain(rest).collect::<Vec<_>>().join("&")
}

fn preset_names(link: &str, key: &str) -> bool {
    let preset = link.split('&').find_map(|pair| pair.strip_prefix("preset=")).and_then(preset::find);
    preset.is_some_and(|preset| preset.values.iter().any(|(named, _)| named.parameter().name == key))
}
