# scripts/integrations.sh: when the integrations are left out. And the part integrations.

load machine
setup() {
  new_machine
  mkdir -p "$checkout/integrations" "$checkout/target/package"
  echo '{}' >"$checkout/integrations/package.json"
  echo '{}' >"$checkout/integrations/package-lock.json"
  touch "$checkout/integrations/.npmrc"
}

integrations() { run on_machine "$checkout/scripts/integrations.sh" "$@"; }

# put_npm STATUS: an npm whose `ci` ends so.
put_npm() {
  printf '#!/bin/sh\necho "npm $3" >>"$machine/calls"\nmkdir -p "$2/node_modules"\nexit %s\n' "$1" >"$usr/bin/npm"
}

@test "the generators that apt has are got once, and the others left out with a word" {
  offer hugo 0.111.3-1
  offer php-cli 2:8.2+93
  offer pandoc 2.17.1.1-2
  for _ in 1 2; do
    set_up integrations
    succeeded
    said "jekyll cannot be had here: its integration is not tested"
    never_said "hugo cannot"
  done
  called 1 "apt-get install hugo"
  called 1 "apt-get install php-cli"
  called 1 "apt-get install pandoc"
}

@test "WordPress is unpacked once, and not installed" {
  printf '#!/bin/sh\nmkdir -p "$3/usr/share/wordpress/wp-includes"\n' >"$usr/bin/dpkg-deb"
  chmod +x "$usr/bin/dpkg-deb"
  set_up integrations
  succeeded
  said "WordPress cannot be had here: its integration is not tested"
  offer wordpress 6.1.9+dfsg1-0
  for _ in 1 2; do
    set_up integrations
    succeeded
    [[ -d $machine/cache/riverseed/wordpress/wp-includes ]]
  done
  called 1 "apt-get download wordpress"
  called 0 "apt-get install wordpress"
}

@test "where the packages cannot be had the tests are left out, with a word, and asked for again the next time" {
  put_npm 1
  for _ in 1 2; do
    integrations test target/debug/riverseed
    succeeded
    said "The integrations are not tested: the generators' packages cannot be had from npm."
  done
  called 2 "npm ci"
}

@test "a plugin that cannot be packed is a failure" {
  put_npm 1
  integrations wordpress
  ((status == 1))
  said "The WordPress plugin is not packed: the generators' packages cannot be had from npm."
}

@test "packages are kept as long as the lock file is the same" {
  put_npm 0
  for _ in 1 2; do
    integrations test target/debug/riverseed
    ((status == 1))
    said "target/package has no npm package: run make tarball"
  done
  called 1 "npm ci"
  echo '{ "other": true }' >"$checkout/integrations/package-lock.json"
  integrations test target/debug/riverseed
  called 2 "npm ci"
}

@test "without a command that it knows, it tells them" {
  integrations tset
  ((status == 2))
  said "scripts/integrations.sh test"
  said "scripts/integrations.sh wordpress"
}
