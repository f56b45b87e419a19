# scripts/kept.sh: what of a build is kept from one clone to the next.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  mkdir -p "$checkout/python"
  echo lock >"$checkout/python/Cargo.lock"
  printf '[profile.dev]\nopt-level = 1\n' >"$checkout/python/Cargo.toml"
  printf '[package]\nname = "riverseed-cli"\n[[test]]\nname = "program"\n' >"$checkout/crates/wasm/Cargo.toml"
  digits=0123456789abcdef
  deps=$checkout/target/debug/deps
  mkdir -p "$deps" "$checkout/target/debug/.fingerprint"/{glam,riverseed-cli}-$digits
  mkdir -p "$checkout/target/wasm/make/wasm32-unknown-unknown/release/deps"
  touch "$checkout/target/wasm/make/wasm32-unknown-unknown/release/deps/libglam-$digits.rlib"
  touch "$deps"/{libglam-$digits.rlib,glam-$digits.d,libriverseed_cli-$digits.rlib,program-$digits,program-$digits.program.0123456789abcdef-cgu.0.rcgu.o}
}

kept() { run on_machine "$checkout/scripts/kept.sh" "$@"; }
there() { [[ -e $checkout/target/debug/$1 ]] || fail "no $1"; }

@test "crates of others come back in a clone without a target, and ours do not" {
  kept keep
  succeeded
  rm -rf "$checkout/target"
  kept take
  succeeded
  there "deps/libglam-$digits.rlib"
  there "deps/glam-$digits.d"
  there ".fingerprint/glam-$digits"
  there "../wasm/make/wasm32-unknown-unknown/release/deps/libglam-$digits.rlib"
  [[ $(ls "$deps") != *program* && $(ls "$deps") != *riverseed* ]] || fail "ours are kept: $(ls "$deps")"
}

@test "a target that is there is left alone" {
  kept keep
  rm "$deps/libglam-$digits.rlib"
  kept take
  succeeded
  [[ ! -e $deps/libglam-$digits.rlib ]] || fail "it was put back"
}

@test "with another lock file, profile or compiler nothing is taken, and the older ones go when newer are kept" {
  kept keep
  mv "$checkout/target" "$checkout/built"
  for file in Cargo.lock python/Cargo.lock; do
    echo "# changed" >>"$checkout/$file"
    kept take
    [[ ! -e $checkout/target/debug ]] || fail "taken although $file has changed"
  done
  mv "$checkout/built" "$checkout/target"
  kept keep
  [[ $(find "$machine/cache/riverseed/crates" -mindepth 1 -maxdepth 1 | wc -l) == 1 ]] || fail "older ones stay"
}
