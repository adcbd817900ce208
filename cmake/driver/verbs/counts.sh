# shellcheck shell=bash
# summary: multiplications, additions, divisions, sine-cosine pairs of every algorithm and robot, beside published ones
# group: measure

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial counts [options]
Installs and builds what is missing. The compiler counts what every algorithm needs for every robot and for the count
models of robots/models, and forward dynamics is compared with quadruple precision over seeded states (doc/measurements/counts.md).
Prints a table beside openSYMORO and what a trace could reach, writes JSON and a picture.
  --robot MODEL|HEADER  only this robot or count model, built alone; or the robot of a header (./axial import, your own)
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --output FOLDER     where the files go; default output/counts
  --json FILE         the rows once more, as an array of objects
Exits non-zero when a count model needs more operations than openSYMORO, or the closed form more than published.
maintainers:
  --documents         alone: writes doc/data/counts*.json and congruences.json, doc/pictures/counts.* and the tables of doc/measurements/counts.md
  --update-pins       alone: writes tests/host_sim/figures/operation_counts.json, the counts that tests expect
END_OF_USAGE
}

run() {
  case ${1:-} in
    --documents)
      write_counts_documents
      ;;
    --update-pins)
      counts_py counts --update-pins
      ;;
    *) count_chosen "$@" ;;
  esac
}

# counts_py PROGRAM OPTION...: builds the program.
counts_py() {
  local program=$1
  shift
  ensure_packages
  build "$HOST_PRESET" "$program"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/counts/counts.py" "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/counts/$program" "$@"
}

# A program for each robot that is counted by itself, one for all, one for a user's.
count_chosen() {
  local robot type
  robot=$(option_of --robot '' "$@")
  type=$(option_of --type '' "$@")
  if [[ -z $robot ]]; then
    counts_py counts "$@"
  elif [[ $robot == model_* || -f $AXIAL_ROOT/host_sim/robots/trajectories/$robot.json ]]; then
    counts_py "counts-$robot" "$@"
  else
    take_own_robot "$robot" "$type"
    write_own_robot "$HOST_PRESET"
    drop_options "--robot --type" "$@"
    counts_py counts-own "${ARGUMENTS[@]}"
  fi
}

write_counts_documents() {
  local doc=$AXIAL_ROOT/doc
  counts_py counts --output "$doc/data" --provenance "$doc/data/counts_provenance.json" \
    --cache "$AXIAL_ROOT/build/$HOST_PRESET/CMakeCache.txt"
  build "$HOST_PRESET" congruences
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/counts/congruences" >"$doc/data/congruences.json.new"
  mv "$doc/data/congruences.json.new" "$doc/data/congruences.json"
  mv "$doc"/data/counts.png "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/count_tables.py" "$doc/data" "$doc/measurements/counts.md"
}
