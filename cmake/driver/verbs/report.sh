# shellcheck shell=bash
# summary: error against instructions of every kernel, robot, scalar and board; tables and a picture

usage() {
  cat <<'END'
usage: ./axial report [options]
Installs and builds what is missing, runs the kernels image of every robot on every board in QEMU, compares each result
with the oracle, prints a table and writes CSV, JSON and a picture of error against instructions.
  --robot NAME        only this robot
  --board NAME        only this board
  --output FOLDER     where the files go; default output/report
  --json FILE         the rows once more, as an array of objects
  --documents         alone: runs all reports, demos, sizes, counts and comparisons anew and writes the tables and pictures of README.md and doc/
Exits non-zero when an error is above its bound.
END
}

run() {
  ensure_packages
  build_host_sim
  build_boards
  if [[ ${1:-} == --documents ]]; then
    (($# == 1)) || fail_usage "--documents stands alone; see ./axial report --help"
    write_documents
  else
    host_sim report "$@"
  fi
}

# Raw data goes beside the documents; the tables and pictures are made from it.
write_documents() {
  "$AXIAL_ROOT/axial" size --documents
  "$AXIAL_ROOT/axial" counts --documents
  "$AXIAL_ROOT/axial" compare --documents
  "$AXIAL_ROOT/axial" numbers --documents
  "$AXIAL_ROOT/axial" exhaustive --documents
  "$AXIAL_ROOT/axial" stability --documents
  local doc=$AXIAL_ROOT/doc board robot
  host_sim report --output "$doc/data"
  for board in "${BOARDS[@]}"; do
    for robot in "$AXIAL_ROOT"/host_sim/trajectories/*.json; do
      robot=$(basename "$robot" .json)
      host_sim demo --robot "$robot" --board "$board" --output "$AXIAL_ROOT/output/demo" \
        --json "$doc/data/demo-$robot-$board.json"
    done
  done
  cp "$AXIAL_ROOT"/output/demo/scara-stm32f405.{csv,json,png,svg} "$doc/pictures/"
  mv "$doc"/data/report.{png,svg} "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/plot/tables.py" "$doc/data" "$AXIAL_ROOT/README.md" "$doc/accuracy.md"
}
