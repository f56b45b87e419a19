# scripts/crate.sh: what a packed crate has to hold, and may weigh.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  local paper
  for paper in LICENSE-APACHE LICENSE-MIT THIRD-PARTY.txt; do echo "text of $paper" >"$checkout/$paper"; done
  packed=$machine/packed/riverseed-$(sed -n 's/^version = "\(.*\)"/\1/p' "$project/Cargo.toml")
  limit_kb=$(sed -n 's/^limit_kb=\([0-9]*\).*/\1/p' "$project/scripts/crate.sh")
  mkdir -p "$packed"
  cp "$checkout"/{LICENSE-*,THIRD-PARTY.txt} "$packed"
}

pack() { run on_machine "$checkout/scripts/crate.sh" "${1-pack}"; }

@test "a crate that is small and has its papers is packed" {
  pack
  succeeded
  said "bytes of $((limit_kb * 1000))"
  called 1 "cargo package --offline --no-verify"
}

@test "to verify is to compile what is in it, to publish to ask the registry and upload nothing" {
  echo "[package]" >"$packed/Cargo.toml"
  pack verify
  succeeded
  called 1 "cargo check .*--manifest-path target/package/unpacked/Cargo.toml"
  [[ $(cat "$checkout/target/package/unpacked/Cargo.toml") == $'[package]\n[workspace]' ]] || fail "it is no workspace of its own"
  pack publish
  succeeded
  called 1 "cargo publish --dry-run"
}

@test "a crate without its notices, or a licence, is refused" {
  local paper
  for paper in LICENSE-APACHE LICENSE-MIT THIRD-PARTY.txt; do
    rm "$packed/$paper"
    pack
    ((status == 1)) || fail "packed without $paper"
    said "The crate lacks $paper as it is here"
    cp "$checkout/$paper" "$packed"
  done
}

@test "a crate with other notices than the checkout's is refused" {
  : >"$packed/THIRD-PARTY.txt"
  pack
  ((status == 1))
  said "The crate lacks THIRD-PARTY.txt as it is here"
}

@test "a crate that is too large is refused" {
  head -c $((limit_kb * 1000 + 1000)) /dev/urandom >"$packed/golden.png"
  pack
  ((status == 1))
  said "TOO LARGE"
}

@test "a warning is a failure, but that of a dry run" {
  echo "warning: aborting upload due to dry run" >"$machine/cargo-says"
  pack publish
  succeeded
  echo "warning: manifest has no description" >"$machine/cargo-says"
  pack
  ((status == 1))
  said "manifest has no description"
}

@test "a crate that does not pack is told in cargo's words, and an older one is not taken for it" {
  pack
  succeeded
  touch "$machine/does-not-pack"
  echo "error: failed to verify package tarball" >"$machine/cargo-says"
  pack
  ((status == 1))
  said "failed to verify package tarball"
  never_said "bytes of"
}

@test "without a command that it knows, it tells them" {
  pack unpack
  ((status == 2))
  said "scripts/crate.sh verify"
  called 0 "cargo"
}
