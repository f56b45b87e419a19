//! The README of an engine's pack: the scale, and how to import the files step by step.
//!
//! No engine runs where Riverseed is tested. The texts say so, and say where each fact comes from.

use super::sizes::name;
use super::splat::GROUNDS;
use super::terrain::Terrain;
use crate::form::Engine;

/// Writes the first lines of a README, which depend on nothing that has to be computed.
pub fn head(engine: Engine, link: &str, side: u32, picture: [u32; 2], has_beds: bool) -> String {
    let ground =
        if has_beds { "Under rivers the ground is lowered to their beds" } else { "Rivers have no beds in the ground" };
    format!(
        "A map by Riverseed, for {}. This link draws it again:\n  {link}\n\
         The landscape has {side} x {side} pixels, and the picture in the middle of map.png has {} x {}.\n\
         {ground}; splines.json has the height of the water.\n\n",
        name(engine),
        picture[0],
        picture[1]
    )
}

/// Makes the text after the head.
pub fn body(engine: Engine, terrain: &Terrain) -> String {
    format!("{}{}{}{UNCHECKED}", scale(terrain), steps(engine, terrain), files(engine))
}

const UNCHECKED: &str = "\nUNCHECKED\n\
    The numbers above follow from the files, and are tested. The steps come from the engine's documentation and source:\n\
    Riverseed's tests run no engine. If a step is wrong in your version, please report it.\n";

fn scale(terrain: &Terrain) -> String {
    let [deepest, highest] = terrain.range();
    let size = (terrain.columns - 1) as f64 * terrain.metres_a_pixel;
    format!(
        "SCALE\n\
         A pixel is {pixel} m wide, and the landscape {size} m. The map is {span} km wide: that is the span of the link.\n\
         With another span, the landscape has another size; a smaller one is steeper, as in nature, and span=20 is one to walk\n\
         through. Rivers are as wide as those of nature that drain as much land, whatever the width that is drawn.\n\
         To make this one smaller or larger, multiply all three axes by the same number.\n\
         Heights: 0 is {deepest} m, {sea} is the sea's surface, 65535 is {highest} m. One step is {step} m.\n\
         The first row of every picture and of heights.r16 is the northernmost.\n\n",
        pixel = number(terrain.metres_a_pixel, 4),
        size = number(size, 2),
        span = number(f64::from(terrain.map().x) * terrain.scale.metres_a_unit / 1000.0, 2),
        deepest = number(deepest, 2),
        highest = number(highest, 2),
        sea = terrain.sea_level,
        step = number(terrain.metres_a_step, 6),
    )
}

fn steps(engine: Engine, terrain: &Terrain) -> String {
    match engine {
        Engine::Unreal => unreal(terrain),
        Engine::Unity => unity(terrain),
        Engine::Godot => godot(terrain),
    }
}

/// Writes the steps for Unreal Engine.
///
/// An actor's scale of 100 makes 512 m of all values: a step is a 128th of the scale in centimetres, and the value 32768
/// lies at the actor's own height (`LandscapeDataAccess.h`).
fn unreal(terrain: &Terrain) -> String {
    const STEPS_A_SCALE: f64 = 128.0;
    const MIDDLE: f64 = 32_768.0;
    let step = terrain.metres_a_step * 100.0;
    let (sections, components) = (2, (terrain.columns - 1) / 126);
    format!(
        "STEPS\n\
         1. Landscape mode, Manage, New, Import from File: heights.r16, {side} x {side}.\n\
         2. Section Size 63 x 63 quads, Sections Per Component {sections} x {sections}, Number of Components {components} x {components}.\n\
         3. Scale: X {pixel}, Y {pixel}, Z {z}. (Z is the height of a step in centimetres, times 128.)\n\
         4. Location: Z {lift} (centimetres). The sea's surface is then at Z = 0: value {sea}.\n\
         5. Layers: assign a material with the layers low, steep, shore and high, and import layers/low.png and so on as their\n\
         \x20  masks. They add up to 255 in every pixel.\n\
         6. Sea: a Water Body Ocean, or a plane, at Z = 0.\n\
         7. Rivers: splines.json has the points of one spline for each river, in centimetres: X and Y from the landscape's corner\n\
         \x20  with the least X and Y, Z from the sea's surface. Add X and Y of the landscape's Location to each point (the one in its\n\
         \x20  Details once it is made, which is that corner), and leave Z as it is. Do not attach the splines to the landscape: they would\n\
         \x20  take its scale and its height. Width and depth are those of a Water Body River's points.\n\
         8. normals.png: turn off sRGB, and set the compression to Normalmap. Green points down, as Unreal expects.\n\n",
        side = terrain.columns,
        pixel = number(terrain.metres_a_pixel * 100.0, 4),
        z = number(step * STEPS_A_SCALE, 6),
        lift = number((MIDDLE - f64::from(terrain.sea_level)) * step, 2),
        sea = terrain.sea_level,
    )
}

/// Unity's importer divides a value by 65536 (`TerrainWizards.cs`), and takes the first row for the southernmost.
fn unity(terrain: &Terrain) -> String {
    let size = (terrain.columns - 1) as f64 * terrain.metres_a_pixel;
    format!(
        "STEPS\n\
         1. Make a Terrain. In its settings, Import Raw: heights.r16 (rename it to heights.raw if it is not listed).\n\
         2. Depth 16 bit, Resolution {side}, Byte Order Windows, Flip Vertically on: the first row is the northernmost.\n\
         3. Terrain Size: X {size}, Y {height}, Z {size}. (Y is the height of a step, times 65536.)\n\
         4. Position: Y {lift}. The sea's surface is then at Y = 0.\n\
         5. splat.png has four layers in red, green, blue and alpha, which add up to 1: low, steep, shore, high. Set them\n\
         \x20  by a script with TerrainData.SetAlphamaps, or import them as a splatmap with the Terrain Toolbox. Turn off sRGB, and\n\
         \x20  flip this file vertically too.\n\
         6. Sea: a plane at Y = 0.\n\
         7. Rivers: splines.json has the points of one spline for each river, in metres: X east and Z north\n\
         \x20  from the Terrain's corner, Y from the sea's surface. Add X and Z of the Terrain's Position to each point, and leave Y\n\
         \x20  as it is. Do not make the splines children of the Terrain: they would take its height of {lift}.\n\
         8. normals.png: set the texture type to Normal map. Green points up, as Unity expects.\n\n",
        side = terrain.columns,
        size = number(size, 2),
        height = number(terrain.metres_a_step * 65_536.0, 3),
        lift = number(-f64::from(terrain.sea_level) * terrain.metres_a_step, 3),
    )
}

/// Writes the steps for Godot.
///
/// The importer of Terrain3D divides a value by 65535 (`terrain_3d_util.cpp`).
fn godot(terrain: &Terrain) -> String {
    let [deepest, highest] = terrain.range();
    format!(
        "STEPS\n\
         Godot has no landscapes of its own. These steps are for the add-on Terrain3D; HTerrain takes the same file and range.\n\
         1. Open addons/terrain_3d/tools/importer.tscn, and choose heights.r16 as the height file.\n\
         2. R16 Range: {deepest} to {highest}. R16 Size: {side} x {side}. The sea's surface is then at Y = 0.\n\
         3. Color File: map.png, if its size is that of the heights (--size {side}); otherwise leave it out.\n\
         4. Run the import, save the data, and set Vertex Spacing to {pixel}. (At 1 the ground would be that many times narrower, and just as high.)\n\
         5. splat.png has four kinds of ground for a shader, in red, green, blue and alpha, which add up to 1: low, steep, shore, high.\n\
         6. Sea: a plane at Y = 0.\n\
         7. Rivers: splines.json has the points of one Curve3D for each river, in metres: X east and Z south\n\
         \x20  from the landscape's north-western corner, Y from the sea's surface. Add X and Z of the place of that corner to each\n\
         \x20  point, measured after Vertex Spacing is set, and leave Y as it is. A Curve3D has no width or depth: read them from the file.\n\
         8. normals.png: import it as a normal map. Green points up, as Godot expects.\n\n",
        side = terrain.columns,
        pixel = number(terrain.metres_a_pixel, 4),
        deepest = number(deepest, 3),
        highest = number(highest, 3),
    )
}

fn files(engine: Engine) -> String {
    let grounds: Vec<String> = match engine {
        Engine::Unreal => {
            GROUNDS.iter().map(|(name, what)| format!("layers/{name}.png\n  The share of {what}.\n")).collect()
        }
        Engine::Unity | Engine::Godot => {
            vec![format!("splat.png\n  The shares of {}.\n", GROUNDS.map(|(_, what)| what).join("; "))]
        }
    };
    format!(
        "FILES\n\
         heights.r16\n  16-bit heights, little-endian, without a header.\n\
         {}\
         normals.png\n  The direction that the ground faces.\n\
         land.png\n  255 is land, 0 is sea.\n\
         rivers.png\n  16-bit width of the river in thousandths of a unit, 0 where there is none.\n\
         splines.json\n  The rivers as lines in space, with width and depth.\n\
         map.png\n  The picture, square like the landscape.\n",
        grounds.concat()
    )
}

/// Writes a number with at most this many decimal places.
fn number(number: f64, places: usize) -> String {
    let text = format!("{number:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}
