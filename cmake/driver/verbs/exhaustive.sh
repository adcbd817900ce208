# shellcheck shell=bash
# summary: the integer sine, cosine and reciprocal over all their arguments: largest errors, where, picture
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial exhaustive [options]
Installs and builds what is missing. Compares sine and cosine of all 2^32 binary angles and the reciprocals of all positive
32-bit integers with exact ones: largest error and where, rms, symmetry. Prints a table, writes JSON and a picture.
  --output FOLDER     where the files go; default output/exhaustive
  --json FILE         the rows once more, as an array of objects
  --threads N         default 2
  --stride N          only every N-th block of 4096 arguments; default 1, all
  --ranges            comes first: fixed point instead, overflows of every kernel and robot over random states and corners, certified
                      errors and bounds under a search that tries to exceed them; takes --json and, of what follows,
  --states N          of a kernel; default 1000000
  --robot NAME        default all
  --overflows         counts overflows only
  --processes N       default 2
Exits non-zero when an error is above what the headers promise, or sin(-x) is not -sin(x).
maintainers:
  --documents         stands alone: writes doc/data/sincos_exhaustive.json and doc/pictures/sincos_exhaustive.*; behind --ranges: 25 000 000
                      states of a kernel, 10^8 of a robot, of every robot (20 minutes); writes doc/data/fixed_overflows.json and the table
                      of doc/guides/ranges.md
END_OF_USAGE
}

run() {
  ensure_packages
  if [[ ${1:-} == --ranges ]]; then
    shift
    build "$HOST_PRESET" exhaustive_ranges
    if [[ ${1:-} == --documents ]]; then
      (($# == 1)) || fail_usage "--ranges --documents stands alone; see ./axial exhaustive --help"
      exhaustive_program exhaustive_ranges --overflows --states 25000000 --json "$AXIAL_ROOT/doc/data/fixed_overflows.json"
      /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/tables.py" "$AXIAL_ROOT/doc/data" "$AXIAL_ROOT/doc/guides/ranges.md"
    else
      exhaustive_program exhaustive_ranges "$@"
    fi
    return
  fi
  build "$HOST_PRESET" exhaustive
  if [[ ${1:-} == --documents ]]; then
    (($# == 1)) || fail_usage "--documents stands alone; see ./axial exhaustive --help"
    write_exhaustive_documents
  else
    exhaustive "$@"
  fi
}

exhaustive() {
  exhaustive_program exhaustive "$@"
}

exhaustive_program() {
  local program=$1
  shift
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/exhaustive/$program" --commit "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" "$@"
}

write_exhaustive_documents() {
  local doc=$AXIAL_ROOT/doc folder
  folder=$(mktemp -d)
  exhaustive --output "$folder"
  mv "$folder/sincos_exhaustive.json" "$doc/data/"
  mv "$folder"/sincos_exhaustive.png "$doc/pictures/"
  rm -r "$folder"
}
