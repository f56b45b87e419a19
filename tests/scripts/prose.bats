# scripts/prose.mjs: which openings it counts, and when `make prose` fails.

load machine

# Counts the comments of standard input, as a module that has been rewritten.
prose() {
  local root=$BATS_TEST_TMPDIR
  mkdir -p "$root/src/land" "$root/scripts"
  sed '/^const DONE = /,/];/c const DONE = ["src/land"];' "$project/scripts/prose.mjs" >"$root/scripts/prose.mjs"
  cat >"$root/src/land/grid.rs"
  run "$real_node" "$root/scripts/prose.mjs"
}

@test "a module that has been rewritten may not open its comments with noun clauses" {
  prose <<<$'/// Whether it is land.\n/// So.\nfn a() {}\n/// Paints it.\nfn b() {}\n//// Of a rule.'
  ((status == 1))
  [[ $output == *"src/land "*" 2  50 %  done"* ]]
}

@test "verb phrases pass, and so do words that only begin alike" {
  prose <<<$'//! Land.\n\n/// Offsets it.\nfn a() {}\n/// However.\nfn b() {}'
  ((status == 0))
  [[ $output == *"src/land "*" 3   0 %  done"* ]]
}
