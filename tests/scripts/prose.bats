# scripts/prose.mjs: which openings it counts, and when `make prose` fails.

load machine

# Counts the comments of standard input, a file of src/land, where only the modules of $1 have not been rewritten.
prose() {
  local root=$BATS_TEST_TMPDIR
  mkdir -p "$root/src/land" "$root/scripts"
  sed "s|^const NOT_YET = .*|const NOT_YET = [$1];|" "$project/scripts/prose.mjs" >"$root/scripts/prose.mjs"
  cat >"$root/src/land/grid.${2:-rs}"
  run "$real_node" "$root/scripts/prose.mjs"
}

@test "a function's comment may not open with an article or a clause" {
  prose '' <<<$'/// The land.\n/// So.\nfn a() {}\n/// Paints it.\n#[cold]\n// Rarely.\npub(crate) const fn b() {}\n//// Of a rule.'
  ((status == 1))
  [[ $output =~ src/land\ +2\ +50\ %\ +0\ +0\ % ]]
}

@test "a type's or a module's comment may open with an article, but not with a noun clause" {
  prose '' <<<$'//! The land.\n\n/// The sea.\n#[derive(\n    Debug\n)]\nstruct A {\n    /// Whether it is deep.\n    b: bool,\n}'
  ((status == 1))
  [[ $output =~ src/land\ +0\ +0\ %\ +3\ +33\ % ]]
}

@test "functions, methods and callbacks of TypeScript are told from all else" {
  prose '' ts <<<$'/** The a. */\nexport async function a() {}\n/** The b. */\n#b(): void {}\n/** The c. */\nconst c = (d: D) => d;
/** The e. */\nchanged: () => void;\n/** The f. */\nget f(): F {}\n/** The g. */\nreadonly g: G;'
  [[ $output =~ src/land\ +4\ +100\ %\ +2\ +0\ % ]]
}

@test "verb phrases pass, and so do words that only begin alike" {
  prose '' <<<$'/// Offsets it.\nfn a() {}\n/// Allows it.\nfn b() {}'
  ((status == 0))
  [[ $output =~ src/land\ +2\ +0\ % ]]
}

@test "a module that has not been rewritten may have any number of them" {
  prose '"src/land"' <<<$'/// The land.\nfn a() {}'
  ((status == 0))
  [[ $output == *"100 %"*"not yet"* ]]
}
