# The parts browser (Chromium, its driver, and Chromium without windows) and firefox.
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
  apt_get "1 minute" chromium chromium-driver || true
  find_browsers
  is_chromium_there && return
  die "Chromium and chromedriver are needed, of one version. Here are:" \
    "  $(told_of "${CHROME:-chromium}")" "  $(told_of "${CHROMEDRIVER:-chromedriver}")" \
    "Install both (on Debian: chromium, chromium-driver), or name yours in CHROME and CHROMEDRIVER. Ubuntu's archive has" \
    "neither: 'npx @puppeteer/browsers install chrome@stable', and the same with chromedriver@stable, gets them."
}

# A driver drives browsers of its own major version.
is_chromium_there() {
  [[ -n $CHROME && -n $CHROMEDRIVER ]] || return
  local browser
  browser=$(version_of "$CHROME")
  [[ -n $browser && ${browser%%.*} == "$(version_of "$CHROMEDRIVER" | cut -d . -f 1)" ]]
}

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
