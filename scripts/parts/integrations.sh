# The part integrations: the generators that apt has, for the tests of integrations/. A test whose program is not there is skipped.
# shellcheck shell=bash

setup_integrations() {
  get_generator hugo hugo
  get_generator jekyll jekyll
  get_generator php php-cli
  get_generator pandoc pandoc
}

# get_generator COMMAND PACKAGE
get_generator() {
  have "$1" || apt_get "1 minute" "$2" || say "$1 cannot be had here: its integration is not tested"
}
