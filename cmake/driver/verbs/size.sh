# shellcheck shell=bash
# summary: flash, RAM, stack, instructions of every kernel, robot, scene and board; budgets that tests assert
# group: measure, rare

usage() {
  cat <<'END'
usage: ./axial size [options]
Installs and builds what is missing: a small image for each combination of firmware/apps/size/matrix.txt. Tells for each
its flash and static RAM (beside an image without a kernel), its worst-case stack, the instructions that a call executes
in its emulator, and the cycles and microseconds that they take by a model of its core (doc/measurements/size.md). Prints a table, writes CSV, JSON and a picture.
  --board ANY_BOARD   only this board
  --robot ROBOT...    only these, commas between
  --scene WORD...     likewise
  --algorithm WORD...  likewise
  --scalar WORD...    likewise: float, double, fixed32 to nearest, fixed32_down, fixed32_high (upper words of products), fixed16
  --variant WORD...   likewise: unrolled, compact
  --contract WORD...  likewise: off, fast
  --quick             only the combinations that tests use
  --output FOLDER     where the files go; default output/size
  --json FILE         the rows once more, as an array of objects
  --flags             the compiler flags instead: some sets of them (host_sim/boards/size/flags.txt), compiled for seven kernels on the
                      Cortex-M4F and the Cortex-M7, without QEMU; writes flags.csv. May be followed by --json FILE and
                      the option --output, or by --documents alone: writes doc/data/flags* and their table (part of --documents)
  --builds            user's builds instead: the Panda's kernels at every level of GCC and Clang (doc/measurements/builds.md). May be
                      followed by --json FILE, or by --documents alone: writes doc/data/any_build* and that page's tables
On rp2040, whose emulator counts cycles, those of every kernel are also held to it. Exits non-zero when something cannot be bounded or
counts disagree.
maintainers:
  --documents         stands alone: measures all anew and writes doc/data/size.*, doc/pictures/size.* and the tables of doc/measurements/size.md
  --anew ANY_BOARD    first: measures one board again, or those of its probes that further options choose, and puts the rows, and their
                      commit, into doc/data/size.* and the tables; then ./axial report --work-precision-anew
  --update-budgets    alone: writes tests/target/budgets.json, 2 % above what is measured now
END
}

run() {
  ensure_packages
  case ${1:-} in
    --documents)
      (($# == 1)) || fail_usage "--documents stands alone; see ./axial size --help"
      write_size_documents
      ;;
    --flags)
      shift
      compare_flags "$@"
      ;;
    --builds)
      shift
      compare_builds "$@"
      ;;
    --anew)
      (($# >= 2)) || fail_usage "--anew takes a board; see ./axial size --help"
      build_probes --board "${@:2}"
      size_py anew --board "${@:2}" "$AXIAL_ROOT/doc/data"
      write_size_tables
      ;;
    --update-budgets)
      (($# == 1)) || fail_usage "--update-budgets stands alone; see ./axial size --help"
      build_probes --quick
      size_py budgets --quick --scene bare "$AXIAL_ROOT/tests/target/budgets.json"
      ;;
    *)
      build_probes "$@"
      size_py measure "$@"
      ;;
  esac
}

compare_flags() {
  if [[ ${1:-} == --documents ]]; then
    (($# == 1)) || fail_usage "--flags --documents stands alone; see ./axial size --help"
    write_flag_data
    write_size_tables
  else
    configure_flag_boards
    flags_py measure "$@"
  fi
}

compare_builds() {
  local board targets data=$AXIAL_ROOT/doc/data
  for board in $(builds_py boards); do
    build "$board" size-empty-scara
    read -ra targets < <(builds_py targets "$board")
    build "$board" "${targets[@]}"
  done
  if [[ ${1:-} == --documents ]]; then
    (($# == 1)) || fail_usage "--builds --documents stands alone; see ./axial size --help"
    builds_py measure --json "$data/any_build.json"
    builds_py provenance "$data/any_build_provenance.json"
    /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/any_build_tables.py" "$data" "$AXIAL_ROOT/doc/measurements/builds.md"
  else
    builds_py measure "$@"
  fi
}

builds_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/boards/size/builds.py" "$@"; }

flags_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/boards/size/flags.py" "$@"; }

configure_flag_boards() {
  local board
  for board in $(flags_py boards); do
    build "$board" size-empty-scara
  done
}

write_flag_data() {
  configure_flag_boards
  flags_py measure --output "$AXIAL_ROOT/doc/data"
  flags_py provenance "$AXIAL_ROOT/doc/data/flags_provenance.json"
}

size_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/boards/size/size.py" "$@"; }

# The chosen probes of the chosen boards. The first build of a board configures it, which lists its probes.
build_probes() {
  local board chosen targets
  chosen=$(size_py boards "$@")
  for board in $chosen; do
    ensure_runner "$board"
    build "$board" size-empty-scara
    read -ra targets < <(size_py targets "$@" --board "$board")
    ((${#targets[@]} == 0)) || build "$board" "${targets[@]}"
  done
}

write_size_documents() {
  local doc=$AXIAL_ROOT/doc
  build_probes
  size_py measure --output "$doc/data"
  size_py provenance "$doc/data/size_provenance.json"
  mv "$doc"/data/size.png "$doc/pictures/"
  write_flag_data
  write_size_tables
}

write_size_tables() {
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/tables.py" "$AXIAL_ROOT/doc/data" "$AXIAL_ROOT/doc/measurements/size.md"
}
