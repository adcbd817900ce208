# shellcheck shell=bash
# summary: a URDF or a Denavit-Hartenberg table as a verified constexpr header

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial import FILE [options]
       ./axial import --documents
Installs and builds what is missing, reads a URDF (any chain or tree of revolute, continuous, prismatic and fixed joints) or a JSON table
of Denavit-Hartenberg rows, classical or modified (format: host_sim/description/README.md), turns it into MDH rows, verifies poses, torques
and mass matrix against Orocos KDL on random states, and writes a header with source, assumptions, warnings and the figures in its comment.
  --root LINK         where the chain starts; default: the URDF's root
  --tip LINK          where it ends, the tool's frame; joints beside the chain are held at 0. Default: every branch (a tree)
  --name NAME         of the robot; default: the file's
  -o, --output FILE   the header; default <name>.hpp
  --json FILE         figures, assumptions and warnings once more
  --gravity X Y Z     m/s^2 in axes of the root link; default 0 0 -9.81 (URDF only)
  --right-angles RAD  an angle this near to a multiple of 90 degrees is one; default 1e-5, 0 reads what is written
  --to-speed SECONDS  acceleration limits that are missing reach full speed in this time; default 0.25
  --states N, --seed N  random states to verify on; default 100, 1
  --strict            writes nothing where there are warnings
  --documents         alone: imports tests/data/descriptions, writes doc/data/import.json and the table of doc/import.md
Exits with 1 and says link, value and remedy when a description can not be used or the figures miss their bounds (poses 1e-12, torques
and mass matrix 1e-9 relative); warnings (no inertia, triangle inequality violated, ...) go to stderr and into the header.
END_OF_USAGE
}

run() {
  (($#)) || fail_usage "name a URDF or a table; see ./axial import --help"
  build_import
  if [[ $1 == --documents ]]; then
    (($# == 1)) || fail_usage "--documents stands alone; see ./axial import --help"
    /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/import/catalogue.py" "$AXIAL_ROOT/build/host-release/host_sim/import/import" \
      "$AXIAL_ROOT/tests/data/descriptions" "$AXIAL_ROOT/doc/data" "$AXIAL_ROOT/doc/import.md"
    return
  fi
  "$AXIAL_ROOT/build/host-release/host_sim/import/import" "$@"
}

build_import() {
  ensure_packages
  # What was configured before urdfdom was there looks again.
  if ! grep -qs '^AXIAL_URDFDOM_INCLUDE:PATH=/' "$AXIAL_ROOT/build/host-release/CMakeCache.txt"; then
    rm -f "$AXIAL_ROOT/build/host-release/build.ninja"
  fi
  build host-release import >&2
}
