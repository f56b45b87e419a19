# The part node: Node.js, and the packages of www.

load machine
setup() { new_machine; }

@test "a Node.js that is too old is named, with what is needed" {
  put_node 18.20.4
  offer nodejs 18.20.4
  set_up node
  failed
  said "Node.js 18.20.4 ($usr/bin/node) does not serve: 20.19, 22.12 or newer is needed"
  called 0 "apt-get install"
}

@test "a Node.js between the versions that Vite runs on is refused too" {
  for version in 20.18.9 21.7.0 22.11.0; do
    put_node $version
    set_up node
    failed
    said "Node.js $version"
  done
  for version in 20.19.0 22.12.0 24.0.0; do
    put_node $version
    set_up node
    succeeded
  done
}

@test "a Node.js of apt's that is too old is renewed, lists first" {
  put_node 18.20.4
  offer nodejs 18.20.4 20.19.2
  offer npm 9
  set_up node
  succeeded
  called 1 "apt-get update"
  called 1 "apt-get install nodejs npm"
}

@test "a Node.js from elsewhere is not shadowed by apt's: it is named" {
  before=$machine/nvm
  put node "$before"
  echo 18.0.0 >"$machine/node-version"
  rm "$usr/bin/node"
  offer nodejs 20.19.2
  set_up node
  failed
  said "Node.js 18.0.0 ($machine/nvm/node)"
  called 0 "apt-get"
}

@test "a machine without Node.js whose archive has only an old one is told so" {
  rm "$usr/bin/node"
  offer nodejs 18.20.4
  set_up node
  failed
  said "nodejs 18.20.4, wanted: nodejs>=20.19"
  said "Node.js is missing"
}

@test "packages are installed once" {
  set_up node
  succeeded
  set_up node
  succeeded
  called 1 "npm install"
}

@test "packages of another lock file are installed again" {
  set_up node
  echo >>"$checkout/www/package-lock.json"
  set_up node
  succeeded
  called 2 "npm install"
}

@test "packages that another system installed are made again" {
  set_up node
  sed -i.old 's/"system":"[^"]*"/"system":"plan9 mips node 20"/' "$checkout/www/node_modules/.installed.json"
  set_up node
  succeeded
  said "made on another system"
  called 2 "npm install"
  [[ $(cat "$checkout/www/node_modules/.installed.json") != *plan9* ]]
}

@test "packages that lost their files are installed again, even if npm takes them to be there" {
  set_up node
  rm "$checkout/www/node_modules/smol-toml/package.json"
  set_up node
  succeeded
  [[ -e $checkout/www/node_modules/smol-toml/package.json ]]
}

@test "what npm did not install is named" {
  touch "$machine/npm-does-nothing"
  mkdir -p "$checkout/www/node_modules"
  set_up node
  failed
  said "npm did not install what www/package-lock.json names"
  said "node_modules/smol-toml"
}
