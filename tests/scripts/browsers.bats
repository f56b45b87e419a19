# The parts browser and firefox.

load machine
setup() {
  new_machine
  offer chromium 156.0.8078.79-1
  offer chromium-headless-shell 156.0.8078.79-1
  offer firefox-esr 153.7.0esr-1
}

@test "Chromium is installed where there is none, once" {
  set_up browser
  succeeded
  set_up browser
  succeeded
  called 1 "apt-get install chromium$"
}

@test "a Chromium without windows comes with it, once" {
  set_up browser
  set_up browser
  succeeded
  called 1 "apt-get install chromium-headless-shell"
}

@test "an archive without that one has the tests run in Chromium as it is" {
  rm "$machine"/lists/chromium-headless-shell "$machine"/archive/chromium-headless-shell
  set_up browser
  succeeded
  called 1 "apt-get install"
  called 0 "apt-get update"
}

@test "beside a browser of one's own no other is installed" {
  program my-chrome 156.0.1.2
  variables=(CHROME="$usr/bin/my-chrome")
  set_up browser
  succeeded
  called 0 "apt-get install"
}

@test "packages that old lists name, and the archive has no more, are found after refreshing them" {
  offer chromium 140.0.1.2-1 156.0.8078.79-1
  touch "$machine/only-the-newest"
  set_up browser
  succeeded
  called 1 "apt-get update"
}

@test "a browser of one's own that does not run is named" {
  printf '#!/bin/sh\nexit 1\n' >"$usr/bin/my-chrome"
  chmod +x "$usr/bin/my-chrome"
  variables=(CHROME="$usr/bin/my-chrome")
  set_up browser
  failed
  said "my-chrome: does not say its version"
}

@test "a machine whose archive has no Chromium, as Ubuntu's, is told where one is" {
  rm "$machine"/lists/* "$machine"/archive/*
  touch "$machine/archive/nothing"
  set_up browser
  failed
  said "chromium: missing"
  said "Ubuntu's archive has"
  called 1 "apt-get update"
  called 0 "apt-get install"
}

@test "a Firefox that only says where to get it, as Ubuntu's, is not taken for one" {
  rm "$machine"/lists/firefox-esr "$machine"/archive/firefox-esr
  printf '#!/bin/sh\necho "Command %s requires the firefox snap to be installed."; exit 1\n' firefox >"$usr/bin/firefox"
  chmod +x "$usr/bin/firefox"
  set_up firefox
  failed
  said "does not say its version"
  said "on Ubuntu"
}

@test "Firefox is installed where there is none" {
  set_up firefox
  succeeded
  set_up firefox
  called 1 "apt-get install firefox-esr"
}
