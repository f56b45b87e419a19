# scripts/wasm.mjs: when the wasm packages are built again, with which flags, and what they may weigh.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  put_wasm_tools
  mkdir -p "$checkout/www/node_modules"
  cp -R "$project/www/node_modules/smol-toml" "$checkout/www/node_modules/"
  module=$checkout/www/pkg-make/riverseed_bg.wasm
  metadata "$machine/home/.cargo/registry/src/index-1/glam-0.34.2"
}

# A build that is held would wait for ever.
teardown() { touch "$machine/release"; }

# metadata FOLDER: where cargo says that a crate lies.
metadata() {
  echo "{ \"packages\": [ { \"source\": null, \"manifest_path\": \"$checkout/Cargo.toml\" },
    { \"source\": \"registry\", \"manifest_path\": \"$1/Cargo.toml\" } ] }" >"$machine/metadata.json"
}

build() { run on_machine "$checkout/scripts/env.sh" node "$checkout/scripts/wasm.mjs" "$@"; }

# built TIMES: builds, and judges how many packages have been built by now.
built() {
  build
  succeeded
  called "$1" "wasm-pack"
}

@test "packages are built once" {
  built 3
  built 3
}

@test "a module that is gone is built again" {
  built 3
  rm "$module"
  built 4
  [[ -s $module ]]
}

@test "a module that was cut short is built again" {
  built 3
  printf 'mod' >"$module"
  built 4
  grep -q "module with" "$module"
}

@test "a script of a package that was edited is built again" {
  built 3
  echo "// mine" >>"$checkout/www/pkg-make/riverseed.js"
  built 4
}

@test "another compiler, bindgen or optimiser builds all again" {
  built 3
  echo 1.96.0 >"$toolchain/rust-version"
  put_wasm 1.96.0 "$toolchain"
  built 6
  program wasm-opt "version 133"
  built 9
}

@test "a changed source or setting builds all again, a changed command line none" {
  built 3
  echo "pub fn lake() {}" >>"$checkout/src/lib.rs"
  built 6
  echo "# changed" >>"$checkout/.cargo/config.toml"
  built 9
  mkdir -p "$checkout/crates/cli/src"
  echo "fn main() {}" >"$checkout/crates/cli/src/main.rs"
  built 9
}

@test "a build that failed is not taken for one" {
  built 3
  echo "pub fn lake() {}" >>"$checkout/src/lib.rs"
  touch "$machine/does-not-compile"
  build
  failed
  said "wasm-pack failed"
  rm "$machine/does-not-compile"
  forget_calls
  built 3
}

@test "as many packages are built at a time as there are processors, each in a folder of its own" {
  touch "$machine/hold"
  build_beside() { on_machine "$checkout/scripts/env.sh" node "$checkout/scripts/wasm.mjs"; }
  build_beside &
  local building=$! together
  together=$(node -e 'console.log(Math.min(3, os.availableParallelism()))')
  local tries=2000
  until (($(compgen -G "$machine/building-*" | wc -l) == together)); do
    ((--tries)) || fail "only $(ls -d "$machine"/building-*) at a time"
    sleep 0.05
  done
  touch "$machine/release"
  wait $building
  local key
  for key in make label engine; do grep -q -- "--target-dir $checkout/target/wasm/$key " "$machine/calls" || fail "no folder for $key"; done
}

@test "a cargo folder with a space in its path is one flag" {
  metadata "/Users/Jane Doe/.cargo/registry/src/index-1/glam-0.34.2"
  built 3
  grep -qF -- '--config target.wasm32-unknown-unknown.rustflags=["--remap-path-prefix=/Users/Jane Doe/.cargo/registry/src/index-1=crates"]' "$machine/calls"
}

@test "crates that lie in the checkout are found: there need be no registry" {
  metadata "$checkout/vendor/glam"
  built 3
  grep -qF -- "--remap-path-prefix=$checkout/vendor=crates" "$machine/calls"
}

# demo TIMES: makes what the demo needs, and judges how many modules have been compiled for it by now.
demo() {
  build demo
  succeeded
  called "$1" "cargo build"
}

@test "the demo has every package, of one module, without wasm-pack" {
  put wasm-bindgen
  demo 1
  called 3 "wasm-bindgen"
  called 0 "wasm-pack"
  local package
  for package in make/riverseed label/riverseed_label engine/riverseed_engine; do
    grep -q -- "--features label,engine " "$checkout/www/pkg-${package}_bg.wasm"
  done
  demo 1
}

@test "the demo takes packages that are to be handed out, and never becomes one" {
  put wasm-bindgen
  built 3
  demo 0
  echo "pub fn lake() {}" >>"$checkout/src/lib.rs"
  demo 1
  built 6
}

@test "a module above its limit stops the check of weights, and no build" {
  sed -i.old 's/^budget = .*/budget = { brotli = 3, gzip = 3 }/' "$checkout/wasm-pack.toml"
  build
  succeeded
  said "TOO LARGE"
  said "The limits hold for rustc 1.96.0 and wasm-opt 132; here are rustc 1.95.0"
  build weigh
  failed
  said "TOO LARGE"
}

@test "modules within their limits pass the check of weights" {
  built 3
  build weigh
  succeeded
  never_said "TOO LARGE"
}

@test "a widget above its limit stops the check of weights, and no build" {
  mkdir -p "$checkout/www/dist-widget" "$checkout/www/pkg-engine"
  cat >"$checkout/www/pkg-engine/riverseed_engine.js" <<'ENGINE'
export const initSync = () => {};
export class River {
  advance() { return false; }
  lettersFor() { return "letters"; }
}
ENGINE
  echo 1 >"$checkout/www/pkg-engine/riverseed_engine_bg.wasm"
  local name
  for name in core.js worker.js tag-page-backend.js river-seed.classic.js riverseed_bg.wasm riverseed_label_bg.wasm; do echo 1 >"$checkout/www/dist-widget/$name"; done
  head -c 20000 /dev/urandom >"$checkout/www/dist-widget/river-seed.js"
  run on_machine node "$checkout/www/scripts/weigh-widget.mjs"
  succeeded
  said "TOO LARGE"
  run on_machine node "$checkout/www/scripts/weigh-widget.mjs" --strict
  failed
  echo 1 >"$checkout/www/dist-widget/river-seed.js"
  run on_machine node "$checkout/www/scripts/weigh-widget.mjs" --strict
  succeeded
}

@test "make check stops at weights, make demo, make wasm and make test do not" {
  steps() { run env -u MAKEFLAGS -u MAKELEVEL make -C "$project" --dry-run --no-print-directory "$1"; }
  steps check
  succeeded
  said "wasm.mjs weigh"
  said "run weigh"
  local target
  for target in demo wasm test; do
    steps $target
    succeeded
    said "scripts/wasm.mjs"
    never_said "wasm.mjs weigh"
    never_said "run weigh"
  done
}

@test "in one call of make nothing is built or tested twice" {
  run env -u MAKEFLAGS -u MAKELEVEL make -C "$project" --dry-run --no-print-directory check test-all
  succeeded
  said "cargo test"
  local twice
  twice=$(grep -v 'scripts/setup.sh\|scripts/laps.sh' <<<"$output" | sort | uniq -d)
  [[ -z $twice ]] || fail "twice: $twice"
}
