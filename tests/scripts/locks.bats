# One at a time: set-ups on a machine, builds of the wasm packages in a checkout.

load machine
setup() {
  command -v flock >/dev/null || skip "no flock here, so nothing is locked"
  new_machine
}
teardown() {
  [[ -d ${machine-} ]] || return 0 # skipped
  touch "$machine/release"
  [[ ! -e $machine/helper ]] || kill "$(cat "$machine/helper")"
}

# eventually PID CONDITION…: waits until a condition holds. Fails if the process that is to bring it about has ended, or
# takes minutes, which is for ever.
eventually() {
  local tries=2000
  until "${@:2}"; do
    kill -0 "$1" && ((--tries)) || return 1
    sleep 0.05
  done
}

@test "a second set-up says that it waits, and then goes on" {
  put_rustup 1.95.0
  mkdir -p "$machine/cache/riverseed"
  exec 8>"$machine/cache/riverseed/lock"
  flock 8
  on_machine "$checkout/scripts/setup.sh" rust >"$machine/said" 2>&1 8>&- &
  local second=$!
  eventually $second grep -q "another set-up is at work" "$machine/said"
  exec 8>&-
  wait $second
}

@test "a program that set-up leaves behind does not hold the next one up" {
  put_wasm_tools
  offer_debian_rust
  touch "$machine/leaves-a-helper"
  set_up wasm
  succeeded
  kill -0 "$(cat "$machine/helper")"
  flock -n "$machine/cache/riverseed/lock" true
}

@test "a command that was run alone leaves its lock to nobody" {
  run on_machine "$checkout/scripts/lib/lock.sh" "$machine/lock" "another" \
    bash -c '"$real/tail" -f /dev/null >/dev/null 2>&1 & echo $! >"$machine/helper"'
  succeeded
  kill -0 "$(cat "$machine/helper")"
  flock -n "$machine/lock" true
}

@test "a command that is run alone has its own exit code" {
  run on_machine "$checkout/scripts/lib/lock.sh" "$machine/lock" "another" bash -c "exit 7"
  ((status == 7))
}

@test "two makes in one checkout build one after the other" {
  put_rustup 1.95.0
  put_wasm 1.95.0 "$toolchain"
  put_wasm_tools
  echo '{ "packages": [] }' >"$machine/metadata.json"
  touch "$machine/hold"
  on_machine make -C "$checkout" wasm >"$machine/first" 2>&1 &
  local first=$!
  eventually $first compgen -G "$machine/building-*" >/dev/null
  on_machine make -C "$checkout" wasm >"$machine/second" 2>&1 &
  local second=$!
  eventually $second grep -q "another build of the wasm packages is at work" "$machine/second"
  touch "$machine/release"
  wait $first
  wait $second
  called 3 "wasm-pack"
  grep -q "with ''" "$checkout/www/pkg-make/riverseed_bg.wasm"
  grep -q "with 'label'" "$checkout/www/pkg-label/riverseed_label_bg.wasm"
  grep -q "with 'engine'" "$checkout/www/pkg-engine/riverseed_engine_bg.wasm"
}
