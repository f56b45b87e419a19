// GDAL reads the files for geographic information systems: without a word of warning, and with nothing lost on the way
// there and back.
//
//     node tests/gis.mjs target/debug/riverseed
//
// Needs GDAL's programs (`make test-gis` gets them). It prints what it has read, and fails if a promise is broken.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const [program] = process.argv.slice(2);

// The metres across a map of the usual span, and those of a degree.
const ACROSS = 200_000;
const DEGREE = 111_320;
const NAME = "Riverseed map, metres from its centre";

const LINKS = {
  island: "country=usual&seed=kauri&attractors=900",
  lake: "country=usual&seed=leven&land=basin&attractors=300",
  lakeland: "country=usual&seed=saimaa&sea=0.3&attractors=900&lakes=0.7&deltas=0.7",
  valley: "country=usual&seed=matai&land=valley&attractors=400&aspect=0.5",
  // Oxbow lakes, no sea, and a seed and a title that would like to be markup, a statement and a path.
  hostile:
    "country=usual&seed=%3Cb%3E%22%27%29%3B--..%2F..%2Fx&names=t.%3Cscript%3E%26%27&land=rectangle&attractors=500&oxbows=1" +
    "&meander-rounds=300&meander-strength=1&flat-share=1&great-rivers=16&neck=3&width=16",
};
const LAYERS = ["heights", "land", "rivers", "flow", "basins", "water", "depth"];
const FEATURES = {
  land: ["land"],
  lakes: ["water"],
  basins: ["basin"],
  deltas: ["delta"],
  distributaries: ["distributary"],
  oxbow_lakes: ["oxbow"],
  rivers: ["river"],
  segments: ["segment"],
  reaches: ["reach"],
  ridges: ["ridge"],
  places: ["sea", "gulf", "lake", "island", "bay", "cape", "strait", "range"],
};
// East and south of each direction of ESRI.
const WAYS = { 1: [1, 0], 2: [1, 1], 4: [0, 1], 8: [-1, 1], 16: [-1, 0], 32: [-1, -1], 64: [0, -1], 128: [1, -1] };

/** Runs a program that must have nothing to warn about. */
function quiet(command, ...args) {
  const { status, stdout, stderr } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 1 << 28 });
  assert.equal(stderr, "", `${command} ${args.join(" ")}`);
  assert.equal(status, 0, `${command} ${args.join(" ")}`);
  assert.doesNotMatch(stdout, /warning|error/i);
  return stdout;
}

/** The values of a raster as GDAL reads it, little-endian. */
function values(file, folder, kind) {
  const raw = join(folder, "raw.bin");
  quiet("gdal_translate", "-q", "-of", "ENVI", file, raw);
  const bytes = readFileSync(raw);
  return new kind(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}

/** Checks where an image lies, to so many of its pixels, and what it says of itself. Returns its size. */
function place(file, [width, height], link, slack) {
  // Not as JSON: for that, this GDAL looks for an ellipsoid in any system, and a plane has none.
  const info = quiet("gdalinfo", file);
  const pair = (words) =>
    info
      .match(new RegExp(`${words} \\(?(-?[\\d.]+), ?(-?[\\d.]+)`))
      .slice(1)
      .map(Number);
  const [[west, north], [pixel, down]] = [pair("Origin ="), pair("Pixel Size =")];
  const off = [west + ACROSS / 2, north - ((height / width) * ACROSS) / 2];
  assert.ok(
    off.every((metres) => Math.abs(metres) <= pixel * slack),
    `${file}: ${west} ${north}`,
  );
  assert.ok(Math.abs(pixel + down) < 0.01, `${file}: pixels of ${pixel} by ${down}`);
  assert.ok(info.includes(`ENGCRS["${NAME}"`) && info.includes('LENGTHUNIT["metre",1'), info);
  assert.ok(info.split("\n").includes(`  riverseed=${link}`), info);
  return pair("Size is");
}

/** Checks that every cell of land is higher than the one that its water runs to, or as high in a lake. Returns how many are. */
function falls(heights, flow, isLake, [columns, rows]) {
  let count = 0;
  for (let cell = 0; cell < heights.length; cell += 1) {
    const [east, south] = WAYS[flow[cell]] ?? [0, 0];
    const [column, row] = [(cell % columns) + east, Math.floor(cell / columns) + south];
    if (heights[cell] <= 0 || column < 0 || row < 0 || column >= columns || row >= rows) continue;
    assert.ok(east || south, `cell ${cell} has land and no way`);
    const next = row * columns + column;
    const isLevel = isLake(cell) && isLake(next) && heights[next] === heights[cell];
    assert.ok(heights[next] < heights[cell] || isLevel, `water of cell ${cell} runs up`);
    count += 1;
  }
  return count;
}

const degrees = (metres) => Math.round((metres / DEGREE) * 1e6) / 1e6 + 0;
const back = (coordinates) =>
  typeof coordinates[0] === "number"
    ? [degrees(coordinates[0]), degrees(coordinates[1]), ...coordinates.slice(2)]
    : coordinates.map(back);

/** The properties of a feature of GeoJSON as the layer has them. */
function expected({ kind, ...properties }, layer) {
  return { ...(layer === "places" ? { kind } : {}), ...properties };
}

/** Checks that GDAL's copy of a layer as GeoJSON has the features of our own. Returns how many there are. */
function layerIsWhole(geopackage, layer, features, folder) {
  const copy = join(folder, `${layer}.copy.geojson`);
  quiet("ogr2ogr", "-f", "GeoJSON", "-lco", "RFC7946=NO", "-lco", "COORDINATE_PRECISION=9", copy, geopackage, layer);
  const { features: copies } = JSON.parse(readFileSync(copy, "utf8"));
  const own = features.filter(({ properties }) => FEATURES[layer].includes(properties.kind));
  assert.equal(copies.length, own.length, layer);
  own.forEach(({ geometry, properties }, i) => {
    assert.equal(copies[i].geometry.type, geometry.type);
    assert.deepEqual(back(copies[i].geometry.coordinates), geometry.coordinates, `${layer} ${i}`);
    for (const [name, value] of Object.entries(expected(properties, layer))) {
      const found = copies[i].properties[name];
      const isNear = typeof value === "number" && Math.abs(found - value) <= Math.abs(value) * 1e-12;
      assert.ok(found === value || isNear, `${layer} ${i}: ${name} is ${found}, not ${value}`);
    }
  });
  return own.length;
}

function check(name, link, folder) {
  const out = (ending) => join(folder, `${name}.${ending}`);
  const endings = ["gpkg", "tif", "geojson", "json", ...LAYERS.map((layer) => `${layer}.tif`)];
  execFileSync(program, [
    "render",
    link,
    "--size",
    "300",
    "--geojson-segments",
    ...endings.flatMap((ending) => ["-o", out(ending)]),
  ]);
  assert.equal(readdirSync(folder).length, endings.length, "nothing is written elsewhere");
  const collection = JSON.parse(readFileSync(out("geojson"), "utf8"));
  const { domain } = JSON.parse(readFileSync(out("json"), "utf8"));

  const report = quiet("ogrinfo", "-al", "-so", out("gpkg"));
  assert.equal(report.split(`ENGCRS["${NAME}"`).length - 1, Object.keys(FEATURES).length, "each layer has its system");
  assert.ok(report.includes(`riverseed=${collection.riverseed}`));
  if (collection.title) assert.ok(report.includes(`title=${collection.title}`));
  const counts = Object.keys(FEATURES).map((layer) => layerIsWhole(out("gpkg"), layer, collection.features, folder));
  assert.equal(
    counts.reduce((sum, count) => sum + count),
    collection.features.length,
    "every feature is in a layer",
  );

  const sides = [domain.width, domain.height];
  // A picture has whole pixels on both sides, so its border is cut by less than one.
  place(out("tif"), sides, collection.riverseed, 1);
  const [size] = LAYERS.map((layer) => place(out(`${layer}.tif`), sides, collection.riverseed, 1e-4));
  const heights = values(out("heights.tif"), folder, Float32Array);
  const land = values(out("land.tif"), folder, Uint8Array);
  assert.ok(
    heights.every((height, i) => height > 0 === land[i] > 0),
    "what is higher than the sea is land",
  );
  const water = values(out("water.tif"), folder, Uint8Array);
  const depths = values(out("depth.tif"), folder, Float32Array);
  assert.ok(
    heights.every((height, i) => (height > 0 ? water[i] > 0 || depths[i] === 0 : water[i] > 0 && depths[i] === -height)),
    "there is a depth where water stands",
  );
  const isLake = (cell) => heights[cell] > 0 && water[cell] > 0;
  const cells = falls(heights, values(out("flow.tif"), folder, Uint8Array), isLake, size);
  console.log(
    `${name}: ${collection.features.length} features in ${counts.filter(Boolean).length} layers, ${cells} cells fall`,
  );
  return counts;
}

/** Checks that GDAL takes a file's word for its coordinate system, and that the definition in a GeoPackage is that of its own list. */
function systemsAreKnown(folder) {
  const link = "country=usual&seed=kauri&attractors=300";
  for (const number of [32601, 32633, 32760, 3395, 3857, 6933]) {
    const [gpkg, tif] = ["gpkg", "land.tif"].map((ending) => join(folder, `${number}.${ending}`));
    execFileSync(program, ["render", link, "-o", gpkg, "-o", tif, "--crs", `EPSG:${number}`]);
    assert.ok(quiet("gdalinfo", tif).includes(`ID["EPSG",${number}]`));
    assert.ok(quiet("ogrinfo", "-al", "-so", gpkg).includes(`ID["EPSG",${number}]`));
    const definition = `SELECT definition FROM gpkg_spatial_ref_sys WHERE srs_id = ${number}`;
    const [, own] = quiet("ogrinfo", "-q", gpkg, "-sql", definition).match(/definition \(String\) = (.*)/);
    const text = join(folder, `${number}.wkt`);
    writeFileSync(text, own);
    // Its parameters, without names: what makes a place.
    const numbers = (words) =>
      quiet("gdalsrsinfo", "-o", "proj4", words)
        .trim()
        .split(" ")
        .filter((part) => !/datum|ellps|type|wktext|towgs84|no_defs/.test(part));
    assert.deepEqual(numbers(text), numbers(`EPSG:${number}`));
  }
  const bare = join(folder, "bare.land.tif");
  execFileSync(program, ["render", link, "-o", bare, "--crs", "none"]);
  assert.doesNotMatch(quiet("gdalinfo", bare), /Coordinate System is:\s*\S+CRS/);
}

const inFolder = (work) => {
  const folder = mkdtempSync(join(tmpdir(), "riverseed-gis-"));
  try {
    return work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
};

const seen = new Array(Object.keys(FEATURES).length).fill(0);
for (const [name, link] of Object.entries(LINKS)) {
  inFolder((folder) => check(name, link, folder)).forEach((count, i) => {
    seen[i] += count;
  });
}
inFolder(systemsAreKnown);
assert.ok(seen.every(Boolean), `every layer has a feature somewhere: ${seen}`);
