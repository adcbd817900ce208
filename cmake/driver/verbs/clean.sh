# shellcheck shell=bash
# summary: removes build/ and output/
# group: maintain, rare

usage() {
  echo "usage: ./axial clean"
  echo "Removes build/ and output/; installed packages stay."
}

run() {
  rm -rf "$AXIAL_ROOT/build" "$AXIAL_ROOT/output"
}
