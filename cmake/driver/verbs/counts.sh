# shellcheck shell=bash
# summary: multiplications, additions, divisions, sine-cosine pairs of every algorithm and robot, beside published ones

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial counts [options]
Installs and builds what is missing. The compiler counts what every algorithm needs for every robot and for the count
models of robots/models, and forward dynamics is compared with quadruple precision over seeded states (doc/counts.md).
Prints a table beside openSYMORO and what a trace could reach, writes JSON and a picture.
  --robot NAME        only this robot or count model
  --output FOLDER     where the files go; default output/counts
  --json FILE         the rows once more, as an array of objects
  --documents         alone: writes doc/data/counts*.json and congruences.json, doc/pictures/counts.* and the tables of doc/counts.md
  --update-pins       alone: writes tests/host_sim/operation_counts.json, the counts that tests expect
Exits non-zero when a count model needs more operations than openSYMORO, or the closed form more than published.
END_OF_USAGE
}

run() {
  ensure_packages
  build host-release counts
  case ${1:-} in
    --documents)
      (($# == 1)) || fail_usage "--documents stands alone; see ./axial counts --help"
      write_counts_documents
      ;;
    --update-pins)
      (($# == 1)) || fail_usage "--update-pins stands alone; see ./axial counts --help"
      counts_py --update-pins
      ;;
    *) counts_py "$@" ;;
  esac
}

counts_py() {
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/counts/counts.py" "$AXIAL_ROOT/build/host-release/host_sim/counts/counts" "$@"
}

write_counts_documents() {
  local doc=$AXIAL_ROOT/doc
  counts_py --output "$doc/data" --provenance "$doc/data/counts_provenance.json" \
    --cache "$AXIAL_ROOT/build/host-release/CMakeCache.txt"
  "$AXIAL_ROOT/build/host-release/host_sim/counts/counts" --congruences >"$doc/data/congruences.json.new"
  mv "$doc/data/congruences.json.new" "$doc/data/congruences.json"
  mv "$doc"/data/counts.{png,svg} "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/plot/count_tables.py" "$doc/data" "$doc/counts.md"
}
