# The parts browser (Chromium, and Chromium without windows) and firefox.
# shellcheck shell=bash

setup_browser() {
  setup_chromium
  # A page without a window costs a third of one with: tests by the hundred are worth a package. They run without it too,
  # so no lists are refreshed for it.
  if [[ $HEADLESS_SHELL != "$CHROME" || -n $own_chrome ]] || ! offers chromium-headless-shell; then return; fi
  apt_get "half a minute, for faster tests" chromium-headless-shell || say "tests run in Chromium as it is, which takes longer"
  find_browsers
}

setup_chromium() {
  is_chromium_there && return
  apt_get "1 minute" chromium || true
  find_browsers
  is_chromium_there && return
  die "Chromium is missing, or does not run ($(told_of "${CHROME:-chromium}")). Install it (on Debian: chromium), or name yours in CHROME." \
    "Ubuntu's archive has none: 'npx @puppeteer/browsers install chrome@stable' gets it."
}

is_chromium_there() { [[ -n $CHROME && -n $(version_of "$CHROME") ]]; }

setup_firefox() {
  is_firefox_there && return
  apt_get "half a minute" firefox-esr || true
  find_browsers
  is_firefox_there ||
    die "Firefox is missing, or does not run ($(told_of "${FIREFOX:-firefox}")). Install it (on Debian: firefox-esr; on Ubuntu the" \
      "snap firefox, or 'npx @puppeteer/browsers install firefox@stable'), or name yours in FIREFOX."
}

is_firefox_there() { [[ -n $FIREFOX && -n $(version_of "$FIREFOX") ]]; }

# A program and its version, in words.
told_of() {
  local version
  version=$(version_of "$1")
  echo "$1: ${version:-$(have "$1" && echo "does not say its version" || echo missing)}"
}
