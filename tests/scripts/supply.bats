# scripts/supply.sh: what stops `make check` of notices, licences and advisories. And the parts supply and mutants.

load machine
setup() {
  new_machine
  put_rustup 1.95.0
  echo "MIT: the authors of glam" >"$machine/notices"
  mkdir "$checkout/python"
  cp "$machine/notices" "$checkout/THIRD-PARTY.txt"
  cp "$machine/notices" "$checkout/python/THIRD-PARTY.txt"
}

supply() { run on_machine "$checkout/scripts/supply.sh" "$@"; }

@test "notices, licences, duplicates, sources and advisories are all checked" {
  supply check
  succeeded
  [[ $output == "" ]] || fail "it said something"
  for folder in . python; do
    called 1 "cargo fetch --quiet --locked --manifest-path $folder/"
    called 1 "cargo about generate --frozen --workspace --all-features --fail --manifest-path $folder/"
    called 1 "cargo deny .*--manifest-path $folder/.* licenses bans sources"
    called 1 "cargo deny .*--manifest-path $folder/.* advisories"
  done
}

@test "what has passed once is known, until a file changes" {
  supply passed
  failed
  supply check
  supply passed
  succeeded
  echo "[workspace]" >>"$checkout/Cargo.toml"
  supply passed
  failed
}

@test "what has passed on one machine is known on another, and what has failed is not" {
  supply check
  cp -R "$checkout/.cargo" "$machine/committed"
  rm -rf "$machine/cache" "$checkout/.cargo"
  cp -R "$machine/committed" "$checkout/.cargo"
  supply passed
  succeeded
  echo "[workspace]" >>"$checkout/Cargo.toml"
  touch "$machine/licence-refused"
  supply check
  failed
  supply passed
  failed
}

@test "notices that are out of date stop the check, and are left as they are" {
  echo "MIT: the authors of libm" >>"$machine/notices"
  supply check
  ((status == 1))
  said "THIRD-PARTY.txt is out of date: run 'make notices'"
  [[ $(cat "$checkout/THIRD-PARTY.txt") == "MIT: the authors of glam" ]]
}

@test "notices of the Python package that are out of date stop the check" {
  echo "MIT: the authors of pyo3" >>"$checkout/python/THIRD-PARTY.txt"
  supply check
  ((status == 1))
  said "python/THIRD-PARTY.txt is out of date: run 'make notices'"
}

@test "notices that are missing stop the check" {
  rm "$checkout/THIRD-PARTY.txt"
  supply check
  failed
  said "run 'make notices'"
  [[ ! -e $checkout/THIRD-PARTY.txt ]]
}

@test "make notices writes what the check then accepts" {
  echo "MIT: the authors of libm" >>"$machine/notices"
  supply notices
  succeeded
  supply check
  succeeded
}

@test "notices that cannot be made stop the check, with the exit code" {
  touch "$machine/licence-unknown"
  supply check
  ((status == 5))
  said "failed to satisfy license requirements"
  never_said "out of date"
}

@test "a licence that is not allowed stops the check, with the exit code" {
  touch "$machine/licence-refused"
  supply check
  ((status == 4))
  said "license is not allowed"
}

@test "a known advisory stops the check, and is told" {
  echo "error[vulnerability]: RUSTSEC-2026-0001" >"$machine/advisories"
  supply check
  ((status == 1))
  said "RUSTSEC-2026-0001"
}

@test "a database of advisories that cannot be reached is left out with a word" {
  echo "[ERROR] failed to fetch advisory database https://example.org" >"$machine/advisories"
  supply check
  succeeded
  said "Advisories are not looked up: their database cannot be reached from here."
}

@test "without a command that it knows, it tells them" {
  supply chekc
  ((status == 2))
  said "scripts/supply.sh notices"
  said "scripts/supply.sh check"
  called 0 "cargo"
}

@test "the tools of supply and mutants are got once" {
  set_up supply mutants
  succeeded
  set_up supply mutants
  succeeded
  called 1 "cargo install cargo-about@"
  called 1 "cargo install cargo-deny@"
  called 1 "cargo install cargo-mutants@"
  called 3 "cargo install"
}
