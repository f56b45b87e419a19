#!/usr/bin/env bash
# The npm package of FastNoise Lite cannot warp: its function returns without a word and leaves the point where it was.
#
# Version:  fastnoise-lite 1.1.1 from npm, Node.js 20. The crate of the same name and version warps.
# Input:    points as objects with x and y (and z), all kinds of warp, an amplitude of 30.
# Guess:    as the crate does it: points move by up to the amplitude. All else of the two is the same: over all noises, fractals, distances
#           and rotations, with seeds that are negative or large, no value was off by 0.001.
# Seen:     no point moves. `DomainWrap` (so it is spelt; there is no `DomainWarp`) looks for an instance of the module's own classes Vector2
#           and Vector3, and the module exports only FastNoiseLite. As it is an ES module, its classes are no globals either: nothing that
#           a user can make is warped, and nothing is thrown.
# So:       a land that is to be the same in Rust and in a browser has no warped noise by this package, or warps by two noises of its own.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund fastnoise-lite@1.1.1
cat > warp.mjs <<'JAVASCRIPT'
import * as all from "fastnoise-lite";

const Noise = all.default;
const kinds = Object.values(Noise.DomainWarpType);
const moved = kinds.flatMap((kind) => {
  const noise = new Noise(1337);
  noise.SetDomainWarpType(kind);
  noise.SetDomainWarpAmp(30);
  return [{ x: 100.5, y: 200.25 }, { x: 100.5, y: 200.25, z: 7.75 }].filter((point) => {
    const before = { ...point };
    noise.DomainWrap(point);
    return Object.keys(point).some((axis) => point[axis] !== before[axis]);
  });
});
console.log(`exports: ${Object.keys(all)}; DomainWarp: ${typeof Noise.prototype.DomainWarp}; noise: ${new Noise(1337).GetNoise(100.5, 200.25)}`);
console.log(`of ${2 * kinds.length} points ${moved.length} moved`);
if (Object.keys(all).join() !== "default" || moved.length > 0 || kinds.length !== 3) throw new Error("this has changed");
JAVASCRIPT
node warp.mjs
