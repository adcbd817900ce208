# shellcheck shell=bash
# summary: error against work of every kernel, robot, number system and board: data, pictures, one HTML page, all documents
# group: measure

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial report [options]
Installs and builds what is missing. Sets the error of every kernel that firmware/apps/size/matrix.txt lists (on the host, over
seeded states, against 113-bit arithmetic) beside the instructions that it executes in QEMU, its time by a model of the core, and its bytes; marks
what no other beats in either; adds feed-forward at two rates, simulations and stability (doc/measurements/work_precision.md). Prints a table,
writes CSV, JSON, pictures and one self-contained HTML page.
  --robot ROBOT       only this robot
  --board BOARD       only this board
  --sizes IN_FILE     rows of ./axial size, such as doc/data/size.json, instead of measuring them
  --output FOLDER     where the files go; default output/report
  --json FILE         the rows once more, as an array of objects
maintainers:
  --on-board          the boards' own results instead: runs the kernels image of every robot on every board in QEMU and compares
                      each result with the oracle; may be followed by the options above; default output/on_board. Exits non-zero
                      when an error is above its bound
  --documents         stands alone: runs all reports, demos, sizes, counts and comparisons anew and writes the tables and pictures of
                      README.md and doc/
  --work-precision-anew  alone: as the next, with errors that doc/data/work_precision.json has already
  --work-precision    stands alone: those of doc/measurements/work_precision.md and of doc/guides/choosing.md, from the sizes and
                      simulations that are in doc/data
END_OF_USAGE
}

run() {
  ensure_packages
  case ${1:-} in
    --documents) write_documents ;;
    --work-precision) write_work_precision ;;
    --work-precision-anew) AXIAL_ERRORS=$AXIAL_ROOT/doc/data/work_precision.json write_work_precision ;;
    --on-board)
      shift
      build_host_sim
      build_boards
      host_sim on-board "$@"
      ;;
    *)
      take_sizes "$@"
      report_work_precision "${ARGUMENTS[@]}"
      ;;
  esac
}

report_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/report/report.py" "$@"; }

# What the report has an error of: size alone measures more.
report_work_precision() {
  local folder choice=() files=() status=0 robot
  robot=$(option_of --robot '' "$@")
  while (($# > 0)); do
    case $1 in
      --robot | --board) choice+=("$1" "$2") ;;
      --output | --json) files+=("$1" "$2") ;;
    esac
    shift 2
  done
  folder=$(mktemp -d)
  measure_and_report "$folder" || status=$?
  rm -r "$folder"
  return "$status"
}

# measure_and_report FOLDER: of choice, into files.
measure_and_report() {
  if [[ -z ${AXIAL_SIZES:-} ]]; then
    "$AXIAL_ROOT/axial" size "${choice[@]}" --contract off --scene bare,sine_cosines,full_parameters,base_parameters,elastic \
      --output "$1/size" >"$1/size.log" || return
  fi
  "$AXIAL_ROOT/axial" compare --output "$1/separation" >"$1/separation.log" || return
  measure_errors "$1/errors" "$robot" || return
  report_py --errors "$1/errors" --sizes "${AXIAL_SIZES:-$1/size/size.json}" --separation "$1/separation/separation.json" \
    --more "$AXIAL_ROOT/doc/data" "${choice[@]}" "${files[@]}"
}

# Raw data goes beside the documents; the tables and pictures are made from it. Every probe is measured once and every error
# computed once: what follows takes them from AXIAL_SIZES and AXIAL_ERRORS. What waits for QEMU or keeps one processor busy runs
# beside the boards' compilers; it alone builds host programs meanwhile.
write_documents() {
  local doc=$AXIAL_ROOT/doc folder beside status=0
  folder=$(mktemp -d)
  build "$HOST_PRESET" host_sim errors counts compare exhaustive loop work_precision
  build_loop_images
  write_each loop motion stability exhaustive &
  beside=$!
  build_measured_images
  "$AXIAL_ROOT/axial" size --documents
  wait "$beside" || status=1
  measure_errors "$folder"
  export AXIAL_SIZES=$doc/data/size.json AXIAL_ERRORS=$folder
  write_each counts compare numbers &
  beside=$!
  say "every kernel on every board, $SECONDS s so far"
  host_sim on-board --output "$doc/data"
  run_demos
  wait "$beside" || status=1
  write_work_precision
  rm -r "$folder"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/plot/demo.py" "$AXIAL_ROOT"/output/demo/scara-stm32f405.{csv,json}
  cp "$AXIAL_ROOT"/output/demo/scara-stm32f405.{csv,json,png} "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/tables.py" "$doc/data" "$AXIAL_ROOT/README.md" "$doc/measurements/accuracy.md"
  say "all documents in $SECONDS s"
  ((status == 0)) || fail "a comparison failed: its lines are above"
}

# write_each VERB...: one that fails does not stop the others.
write_each() {
  local verb status=0
  for verb; do
    "$AXIAL_ROOT/axial" "$verb" --documents || status=1
  done
  return "$status"
}

# The images that documents show: not those of tests.
build_measured_images() {
  local board robot targets=()
  for robot in "$AXIAL_ROOT"/host_sim/robots/trajectories/*.json; do
    robot=$(basename "$robot" .json)
    targets+=("kernels-$robot" "feedforward-$robot")
  done
  for board in "${QEMU_BOARDS[@]}"; do
    build "$board" "${targets[@]}"
  done
}

write_work_precision() {
  local doc=$AXIAL_ROOT/doc errors=${AXIAL_ERRORS:-}
  if [[ -z $errors ]]; then
    errors=$(mktemp -d)
    measure_errors "$errors"
  fi
  report_py --errors "$errors" --sizes "$doc/data/size.json" --separation "$doc/data/separation.json" --more "$doc/data" \
    --provenance "$doc/data/size_provenance.json" --output "$doc/data" >/dev/null
  [[ -n ${AXIAL_ERRORS:-} ]] || rm -r "$errors"
  mv "$doc"/data/work_precision*.png "$doc/pictures/"
  rm "$doc/data/work_precision.html"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/work_precision_tables.py" "$doc/data" "$doc/measurements/work_precision.md"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/choice_tables.py" "$doc/data" "$doc/guides/choosing.md"
}

# The main job of every robot and board, as many at once as there are processors.
run_demos() {
  local robots board robot
  robots=("$AXIAL_ROOT"/host_sim/robots/trajectories/*.json)
  for board in "${QEMU_BOARDS[@]}"; do
    for robot in "${robots[@]}"; do
      printf '%s %s\n' "$(basename "$robot" .json)" "$board"
    done
  done | xargs -P "$(nproc)" -L 1 "$DRIVER/demo_of.sh" "$AXIAL_ROOT"
}
