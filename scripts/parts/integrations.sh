# The part integrations: the generators that apt has, for the tests of integrations/, and the files of WordPress, which is not
# installed, since it is a server. A test whose program is not there is skipped.
# shellcheck shell=bash

setup_integrations() {
  get_generator hugo hugo
  get_generator jekyll jekyll
  get_generator php php-cli
  get_generator pandoc pandoc
  get_wordpress
}

# get_generator COMMAND PACKAGE
get_generator() {
  have "$1" || apt_get "1 minute" "$2" || say "$1 cannot be had here: its integration is not tested"
}

# Unpacks WordPress as apt has it, in a folder of its own in the cache.
get_wordpress() {
  local folder=$RIVERSEED_CACHE/wordpress new=$RIVERSEED_CACHE/wordpress.new
  [[ ! -d $folder ]] || return 0
  rm -rf "$new"
  mkdir -p "$new"
  if apt_download "half a minute" wordpress "$new" && dpkg-deb -x "$new"/*.deb "$new/all"; then
    mv "$new/all/usr/share/wordpress" "$folder"
  else
    say "WordPress cannot be had here: its integration is not tested"
  fi
  rm -rf "$new"
}
