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

# until_said FILE TEXT PID: waits until a command has said something, or has ended.
until_said() {
  until grep -q "$2" "$1"; do
    kill -0 "$3" 2>/dev/null || return 1
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
  until_said "$machine/said" "another set-up is at work" $second
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
  until [[ -e $machine/building ]]; do
    kill -0 $first || return 1
    sleep 0.05
  done
  on_machine make -C "$checkout" wasm >"$machine/second" 2>&1 &
  local second=$!
  until_said "$machine/second" "another build of the wasm packages is at work" $second
  touch "$machine/release"
  wait $first
  wait $second
  called 2 "wasm-pack"
  grep -q "with ''" "$checkout/www/pkg/riverseed_bg.wasm"
  grep -q "with 'tools'" "$checkout/www/pkg-tools/riverseed_tools_bg.wasm"
}
