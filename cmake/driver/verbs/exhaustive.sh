# shellcheck shell=bash
# summary: the integer sine, cosine and reciprocal over all their arguments: largest errors, where, picture

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial exhaustive [options]
Installs and builds what is missing. Compares sine and cosine of all 2^32 binary angles and the reciprocals of all positive
32-bit integers with long double: largest error and where, rms, symmetry. Prints a table, writes JSON and a picture.
  --output FOLDER     where the files go; default output/exhaustive
  --json FILE         the rows once more, as an array of objects
  --threads N         default 2
  --stride N          only every N-th block of 4096 arguments; default 1, all
  --documents         alone: writes doc/data/sincos_exhaustive.json and doc/pictures/sincos_exhaustive.*
Exits non-zero when an error is above what the headers promise, or sin(-x) is not -sin(x).
END_OF_USAGE
}

run() {
  ensure_packages
  build host-release exhaustive
  if [[ ${1:-} == --documents ]]; then
    (($# == 1)) || fail_usage "--documents stands alone; see ./axial exhaustive --help"
    write_exhaustive_documents
  else
    exhaustive "$@"
  fi
}

exhaustive() {
  "$AXIAL_ROOT/build/host-release/host_sim/exhaustive/exhaustive" --commit "$("$AXIAL_ROOT/host_sim/system/commit.sh")" "$@"
}

write_exhaustive_documents() {
  local doc=$AXIAL_ROOT/doc folder
  folder=$(mktemp -d)
  exhaustive --output "$folder"
  mv "$folder/sincos_exhaustive.json" "$doc/data/"
  mv "$folder"/sincos_exhaustive.{png,svg} "$doc/pictures/"
  rm -r "$folder"
}
