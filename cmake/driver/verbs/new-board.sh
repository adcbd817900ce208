# shellcheck shell=bash
# summary: writes the skeleton of a board of your own, which configures and builds at once
# group: use

usage() {
  cat <<'END'
usage: ./axial new-board NAME --like BOARD [--cpu CPU]
Writes hal/boards/NAME, a copy of BOARD (a folder of hal/boards) under the new name, and its presets in CMakePresets.json.
  --like NAME         the board that is most like it: same core family, a serial port of the same kind
  --cpu CPU           another CPU than that board's: cortex-m0, cortex-m3, cortex-m4f, cortex-m7, cortex-m33, rv32imac
doc/guides/porting.md goes on from there.
END
}

run() { /usr/bin/python3 -E "$AXIAL_ROOT/cmake/new_board/new_board.py" "$@"; }
