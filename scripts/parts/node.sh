# The part node: Node.js, and the packages of www/package-lock.json.
# shellcheck shell=bash

setup_node() {
  is_node_fit || get_node
  have npm || apt_get "1 minute" npm || true
  [[ -n $(version_of npm) ]] || die "npm is missing: it comes with Node.js from https://nodejs.org, or as a package of its own."
  case $(node scripts/packages.mjs) in
    whole) return ;;
    foreign) say "www/node_modules was made on another system, or for another Node.js: it is made again" && rm -rf www/node_modules ;;
  esac
  install_packages
  # A folder that has lost files may look whole to npm.
  [[ $(node scripts/packages.mjs) == whole ]] || { rm -rf www/node_modules && install_packages; }
  [[ $(node scripts/packages.mjs) == whole ]] ||
    die "npm did not install what www/package-lock.json names:" "$(node scripts/packages.mjs missing | head -n 5)"
}

# Versions that Vite runs on.
is_node_fit() {
  local found
  found=$(version_of node)
  at_least "$found" 22.12 || { at_least "$found" 20.19 && [[ $found == 20.* ]]; }
}

get_node() {
  comes_from_elsewhere node || apt_get "1 minute" "nodejs>=20.19" npm || true
  is_node_fit && return
  have node || die "Node.js is missing. Install 20.19, 22.12 or newer (https://nodejs.org), then run this again."
  die "Node.js $(version_of node) ($(command -v node)) does not serve: 20.19, 22.12 or newer is needed (https://nodejs.org)."
}

install_packages() {
  say "installing the packages of www (half a minute)"
  # Not `npm ci`: it wants the lock file to know Biome's programs for every system, and not every registry has them all.
  npm --prefix www install --no-save --no-audit --no-fund --loglevel=error ||
    die "npm could not install the packages: see its words above."
  node scripts/packages.mjs stamp
}
