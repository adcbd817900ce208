# shellcheck shell=bash
# summary: removes build/ and output/

usage() {
  echo "usage: ./axial clean"
  echo "Removes build/ and output/; installed packages stay."
}

run() {
  (($# == 0)) || fail_usage "clean takes no arguments; see ./axial clean --help"
  rm -rf "$AXIAL_ROOT/build" "$AXIAL_ROOT/output"
}
