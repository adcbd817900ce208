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
  --markdown          write the tables into README.md and doc/accuracy.md, their data into doc/data
END
}

run() {
  ensure_packages
  build_host_sim
  build_boards
  host_sim report "$@"
}
