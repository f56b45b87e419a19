# Every command of this project. Each first gets what it needs and lacks (scripts/setup.sh), so a fresh clone can start
# with any of them; the first one takes some minutes, most of them for tools.

.NOTPARALLEL: # cargo and the browsers use every core by themselves
SHELL := bash

setup := scripts/setup.sh
run := scripts/env.sh
wasm := scripts/env.sh --wasm
npm := $(run) npm --silent --prefix www run
lap := @scripts/laps.sh lap
wasm32 := --target wasm32-unknown-unknown --no-default-features

# The tests that compare with committed files.
GOLDEN_TESTS := --test all -- digest golden schema

free_port := require("net").createServer().listen(0, "127.0.0.1", function () { console.log(this.address().port); this.close() })

.PHONY: help
help: ## this list
	@echo "make TARGET, where TARGET is"
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  %-18s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

# ---- use it

.PHONY: demo
demo: ## build what the page needs, as fast as can be, and serve it here; its address is printed
	@$(setup) rust bindgen node
	@$(run) scripts/lib/lock.sh target/wasm.lock "another build of the wasm packages" node scripts/wasm.mjs demo
	@$(npm) dev -- --host 127.0.0.1

.PHONY: site
site: widget ## build the page, with the widget's files, into www/dist, to be served from any folder of any server
	@$(npm) build
	$(lap) "the page, built"

.PHONY: widget
widget: wasm ## build <river-seed> into www/dist-widget, and weigh it
	@$(npm) build:widget
	$(lap) "the element, built"

.PHONY: wasm
wasm: ## build the wasm packages into www/pkg-make, www/pkg-label and www/pkg-engine, and weigh them
	@$(setup) rust wasm node
	@$(run) scripts/lib/lock.sh target/wasm.lock "another build of the wasm packages" node scripts/wasm.mjs
	$(lap) "the wasm packages, built"

.PHONY: package
package: tarball ## pack what is published into target/package: the npm package, and the crate, by a dry run
	scripts/crate.sh publish

.PHONY: tarball
tarball: widget
	@$(npm) package

.PHONY: wordpress
wordpress: tarball ## the WordPress plugin as a zip, with the element in it, in target/package
	@scripts/integrations.sh wordpress

.PHONY: wheel
wheel: widget ## the Python package as a wheel, in target/package
	@$(setup) rust
	@scripts/python.sh wheel

# ---- prove it

# The first tier, of minutes, tries each promise once; the second is everything else. In the browser a test of the first has @core in its
# title; in Rust a test of the second is ignored (`#[ignore = "second tier"]`); in TypeScript without a browser `tests/tier.ts` divides the cases.
.PHONY: test
test: clock test-rust test-page test-browser ## the tests of the first tier, and how long each part of them takes
	@scripts/laps.sh table

.PHONY: test-all
test-all: test test-more ## every test there is
	@scripts/laps.sh table

.PHONY: test-more
test-more: test-scripts test-rust-more test-crate test-python test-page-more test-browser-more lighthouse test-firefox test-package \
  test-hydrology test-gis test-plot test-batch test-notebooks test-integrations

# What no landing waits for: every test there is, other processors, newest versions, fresh seeds, foreign input, faults put in.
.PHONY: nightly
nightly: ## everything, some hours; then the line to add to docs/nightly.txt
	@scripts/nightly.sh

.PHONY: clock
clock:
	@scripts/laps.sh start

.PHONY: test-scripts
test-scripts: ## what set-up, builds and checks decide, with stand-ins for apt, rustup, npm and the like
	@$(setup) node
	$(run) www/node_modules/bats/bin/bats tests/scripts
	$(lap) "set-up, builds and checks"

.PHONY: test-rust
test-rust: ## the core and the command line, natively
	@$(setup) rust
	$(run) cargo test --all-features
	$(lap) "Rust, natively"

.PHONY: test-rust-more
test-rust-more: ## the slow ones of them; SHARE=turn the share whose turn it is, with what was touched
	@$(setup) rust node
	scripts/suite.sh rust
	$(lap) "Rust, natively: what is slow"

.PHONY: test-crate
test-crate: ## the crate as its users have it: packed, and compiled by itself
	@$(setup) rust
	scripts/crate.sh verify
	$(lap) "the crate, packed and compiled"

# The command line as the tests of the core have it: built with other features, all would be compiled again.
.PHONY: program
program:
	@$(setup) rust
	@$(run) cargo test --quiet --all-features --no-run --package riverseed-cli

# These six are skipped, with a word, where GDAL, or Python or its packages, cannot be had.
.PHONY: test-hydrology
test-hydrology: program ## another's hydrology library finds nothing to fill on the relief, and our rivers where we drew them; the recipes of docs/hydrology.md run
	@scripts/hydrology.sh target/debug/riverseed
	$(lap) "relief, read by a hydrology library"

.PHONY: test-gis
test-gis: program ## another's geographic library reads our files for GIS without a warning, and gives back what we wrote
	@$(setup) node
	@scripts/gis.sh target/debug/riverseed
	$(lap) "files for GIS, read by GDAL"

.PHONY: test-plot
test-plot: program ## the software of plotters reads our lines: a layer for each pen, in millimetres, on the sheet
	@scripts/plot.sh target/debug/riverseed
	$(lap) "lines, read by the software of plotters"

.PHONY: test-batch
test-batch: program ## a distributed engine makes the maps that one call makes, also if a worker is killed
	@scripts/batch.sh target/debug/riverseed
	$(lap) "many maps, by a distributed engine"

.PHONY: test-python
test-python: program widget ## the Python package, as a wheel that is built and installed: the bytes of the command line, arrays, threads, types
	@scripts/python.sh test target/debug/riverseed
	$(lap) "the Python package"

.PHONY: test-notebooks
test-notebooks: widget ## its widget in JupyterLab and marimo, in Chromium, and the notebook that measures fifty networks
	@$(setup) rust browser
	@scripts/notebooks.sh
	$(lap) "the Python package, in notebooks"

.PHONY: test-page
test-page: wasm ## the TypeScript, without a browser
	$(npm) test
	$(lap) "TypeScript, without a browser"

.PHONY: test-page-more
test-page-more: wasm ## what of that is slow: which parameters do nothing, in all recipes
	RIVERSEED_TIER=second $(npm) test -- tests/unit/idle.test.ts
	$(lap) "TypeScript, without a browser: what is slow"

# On a free port, since a page served by another checkout must not be what is tested.
e2e := PORT=$$(node -e '$(free_port)') $(npm) e2e --

.PHONY: test-browser
test-browser: site widget ## the page and the widget in Chromium, end to end: each promise once
	@$(setup) browser
	@$(e2e) --grep @core
	$(lap) "page and element in Chromium: each promise once"

.PHONY: test-browser-more
test-browser-more: site widget ## the same in all windows, colours and inputs; SHARE=turn the share whose turn it is, with what was touched
	@$(setup) browser
	@scripts/suite.sh browser
	$(lap) "page and element in Chromium: all else"

# Skipped, with a word, where its package cannot be had.
.PHONY: lighthouse
lighthouse: site ## what Lighthouse says of the site: accessibility, best practices, search engines, and that nothing moves
	@$(setup) browser
	@$(npm) lighthouse
	$(lap) "Lighthouse"

.PHONY: test-firefox
test-firefox: site ## the page in a second engine
	@$(setup) firefox
	$(npm) firefox
	$(lap) "the page in Firefox"

.PHONY: test-arch
test-arch: ## the same rivers and pixels on 64-bit ARM, in an emulator; not part of `make test`
	@$(setup) rust
	scripts/arch.sh

.PHONY: newest
newest: ## the committed digests with the newest versions of all dependencies that Cargo.toml allows; not part of `make test`
	@$(setup) rust
	scripts/newest.sh

.PHONY: test-package
test-package: tarball ## the npm package, as its users have it: in Node, with frameworks, in two browsers
	@$(setup) browser firefox
	@$(npm) package:unpack
	$(npm) package:test
	@PORT=$$(node -e '$(free_port)') $(npm) package:e2e
	$(lap) "the npm package, as its users have it"

# Each is skipped, with a word, where its generator cannot be had.
.PHONY: test-integrations
test-integrations: tarball program ## blogs by five generators, a WordPress page and the like, built with integrations/ and opened in a browser
	@$(setup) browser integrations
	@scripts/integrations.sh test target/debug/riverseed
	$(lap) "integrations"

.PHONY: check
check: clock widget ## format, lints, types, documentation, weights and licences: not one warning
	@$(setup) lint
	@scripts/supply.sh passed || { $(setup) supply && scripts/supply.sh check; }
	@$(run) node scripts/wasm.mjs weigh
	@$(npm) weigh
	@$(run) node scripts/prose.mjs
	$(run) shellcheck --external-sources --check-sourced scripts/*.sh findings/*.sh .ci/run tests/scripts/*.ba* tests/scripts/stand-ins/*
	$(run) cargo fmt --check
	$(run) cargo fmt --check --manifest-path fuzz/Cargo.toml
	$(run) cargo fmt --check --manifest-path python/Cargo.toml
	$(run) cargo clippy --quiet --all-targets --all-features -- -D warnings
	CUSTOM_LIBFUZZER_PATH=target/unlinked $(run) cargo clippy --quiet --locked --manifest-path fuzz/Cargo.toml --target-dir target -- -D warnings
	$(run) cargo clippy --quiet --locked --manifest-path python/Cargo.toml --target-dir target/python -- -D warnings
	scripts/python.sh check
	$(wasm) cargo clippy --quiet $(wasm32) --package riverseed-wasm -- -D warnings
	$(wasm) cargo clippy --quiet $(wasm32) --package riverseed-wasm --features engine -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(run) cargo doc --quiet --no-deps --all-features
	scripts/crate.sh pack
	$(npm) types
	$(npm) lint
	cd www && ../$(run) biome check --error-on-warnings ../python/riverseed/static/widget.js ../python/tests/notebooks
	$(lap) "formats, lints, types, licences"

.PHONY: supply
supply: ## licences, notices and advisories of all crates, also where the same files have passed before
	@$(setup) supply
	@scripts/supply.sh check

.PHONY: prose
prose: ## count how doc comments begin, module by module; fails where a module that has been rewritten slips back
	@$(setup) node
	@$(run) node scripts/prose.mjs

# ---- look for faults that the tests do not know

.PHONY: explore
explore: ## try all properties on fresh seeds, MINUTES=10 long
	@$(setup) rust
	@MINUTES=$(or $(MINUTES),10) scripts/explore.sh $(PROPERTIES)

.PHONY: fuzz
fuzz: ## give foreign input to all that reads it, SECONDS=60 a target
	@$(setup) fuzz || { echo "Fuzzing is left out: see above."; exit 0; }; scripts/fuzz.sh $(or $(SECONDS),60) $(TARGETS)

# Where nothing else looks closely. Properties try few cases there: what one in many sees is no test of these files.
FILES ?= src/export/**/*.rs src/session.rs src/recipe/**/*.rs
.PHONY: mutants
mutants: ## break files, session and recipes in small ways, and list what no fast test sees; FILES=src/session.rs only there
	@$(setup) mutants
	PROPTEST_CASES=10 $(run) cargo mutants --colors never --all-features $(FILES:%=--file '%')

.PHONY: findings
findings: ## does others' software still do what findings/ says? With packages from registries; not part of `make test`
	@$(run) bash -c 'for one in findings/*.sh; do echo "$$one"; bash "$$one" || failed=1; done; exit $${failed:-0}'

# ---- measure and tend it

.PHONY: bench
bench: site widget ## the figures of docs/benchmarks.md: natively, as wasm in Node, and in the page
	@$(setup) browser
	@$(run) node scripts/wasm.mjs figures
	@$(run) node benches/run.mjs

.PHONY: notices
notices: ## write THIRD-PARTY.txt, here and in python, the notices of the crates that are handed out, after a change of Cargo.lock
	@$(setup) supply
	@$(run) scripts/supply.sh notices

.PHONY: goldens
goldens: ## redraw the golden pictures and digests; then look at them and say in the commit why they changed
	@$(setup) rust
	@echo "A run that refreshes goldens fails on purpose; the run after it must pass."
	-@RIVERSEED_REFRESH=1 $(run) cargo test --all-features --quiet --no-fail-fast $(GOLDEN_TESTS)
	@$(run) cargo test --all-features --quiet $(GOLDEN_TESTS)
	@git status --short tests

.PHONY: docs
docs: ## write what is generated again: the parameters (docs/ and www/src/engine/parameters.json), the JSON form, the figures, the tables of the element
	@$(setup) rust node
	@echo "A run that writes pages fails on purpose; the run after it must pass."
	-@RIVERSEED_REFRESH=1 $(run) cargo test --all-features --quiet --no-fail-fast --test all --test program -- documents schema
	@$(npm) element-page
	@$(run) cargo test --all-features --quiet --test all --test program -- documents schema
	@git status --short docs www/src/engine/parameters.json

.PHONY: clean
clean: ## remove what was built here; tools in ~/.cache/riverseed and www/node_modules stay
	rm -rf target www/pkg-make www/pkg-label www/pkg-engine www/dist www/dist-widget www/tests/consumers/node_modules www/test-results www/playwright-report
