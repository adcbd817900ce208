# shellcheck shell=bash
# summary: what ran where: boards, their emulators, the tests of every check, silicon
# group: maintain, rare

usage() {
  cat <<'END'
usage: ./axial boards [options]
Lists every board of hal/boards: CPU, memory, the machine of QEMU that runs it, which tests every check runs there, which figures of
doc/data were measured there, and whether it ran on silicon. Builds and runs nothing.
  --json FILE         the rows as an array of objects
maintainers:
  --documents         also writes the table of doc/measurements/boards.md
  --check             instead: ends with 1 where that table says what is not so, or leaves a board out
END
}

run() {
  command -v cmake >/dev/null || ensure_packages
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/boards/boards/boards.py" "$@"
}
