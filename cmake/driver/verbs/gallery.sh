# shellcheck shell=bash
# summary: what every robot of robots/ costs on five boards in float and fixed point, with its error: a table, a page for the browser
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial gallery [options]
Installs and builds what is missing. Measures torque, gravity, forward dynamics and the safe loop of each robot as ./axial cost does, and their
errors as ./axial choose does, cell by cell: a robot in a number system on a board. What was measured from the same sources is not measured
again, so that a run that was interrupted goes on where it was. A cell that cannot be says why. All of them take hours of a processor.
  --robot MACHINE|HEADER...  only these: of robots/ and robots/gallery, or headers of your own; default all of robots/
  --board stm32f405|stm32f100|nrf51|rp2040|rp2350_riscv...  only these
  --number float|fixed32...  only these
  --minutes N         begins no further cell after so many minutes; 0 measures nothing and shows what there is
  --json FILE         the rows, as an array of objects
  --html FILE         one page for a browser that needs no other file: choose robot, board and number system, see cost, error and code
Exits with 0 also where cells cannot be or were left for the next run: both are said.
maintainers:
  --documents         first, --minutes N may follow: writes doc/data/gallery*.json, the pictures and doc/measurements/gallery.md from what there is
END_OF_USAGE
}

export OWN_BUILD_SECONDS=900 # the longest that images of a cell, or its errors, are built

run() {
  local minutes
  if [[ " $* " == *" --documents "* ]] && [[ $1 != --documents || ($# != 1 && ($# != 3 || $2 != --minutes)) ]]; then
    fail_usage "--documents stands alone, or --minutes N behind it; see ./axial gallery --help --all"
  fi
  minutes=$(option_of --minutes '' "$@")
  ensure_packages
  if [[ ${1:-} == --documents ]]; then
    measure_cells "$minutes"
    write_gallery_documents
  else
    drop_options "--minutes --json --html" "$@"
    measure_cells "$minutes" "${ARGUMENTS[@]}"
    drop_options --minutes "$@"
    gallery_py show "${ARGUMENTS[@]}"
  fi
}

gallery_py() { /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/figures/gallery/gallery.py" "$@"; }

# measure_cells MINUTES CHOICE...: in as many lanes as there are processors; a place's build belongs to one lane.
measure_cells() {
  local minutes=$1 place lane lanes
  shift
  while read -r place; do ensure_runner "$place"; done < <(gallery_py cells "$@" | cut -d ' ' -f 1 | sort -u)
  lanes=$(nproc)
  for ((lane = 0; lane < lanes; ++lane)); do
    measure_lane "$minutes" --lane "$lane/$lanes" "$@" &
  done
  wait
}

# measure_lane MINUTES CHOICE...: each cell in a shell of its own, so that one that ends it leaves the others.
measure_lane() {
  local minutes=$1 cells cell place number header count=0
  shift
  mapfile -t cells < <(gallery_py cells "$@")
  for cell in "${cells[@]}"; do
    if [[ -n $minutes ]] && ((SECONDS >= 60 * minutes)); then break; fi
    count=$((count + 1))
    say "cell $count of ${#cells[@]}, after $((SECONDS / 60)) min: $cell"
    read -r place number header <<<"$cell"
    (measure_cell "$place" "$number" "$header") </dev/null || say "not measured: $cell"
  done
  ((count == ${#cells[@]})) || say "$((${#cells[@]} - count)) cells are left for the next run"
}

# measure_cell PLACE NUMBER HEADER
measure_cell() {
  local place=$1 number=$2 targets
  take_own_robot "$3"
  if [[ $place == host ]]; then
    measure_cell_errors "$number" "$3"
    return
  fi
  ensure_runner "$place"
  prepare_own_images "$place"
  read -ra targets < <(gallery_py targets "$place" "$number")
  build_own_images "$place" "${targets[@]}" 2>/dev/null || true # what was not built says why
  gallery_py measure "$place" "$number" "$3" "$OWN_TYPE"
}

# measure_cell_errors NUMBER HEADER
measure_cell_errors() {
  local program=errors-own_gallery-$1 log=$AXIAL_ROOT/build/$HOST_PRESET-own.log
  write_own_robot "$HOST_PRESET"
  configure "$HOST_PRESET"
  rm -f "$log"
  with_progress "building the errors of $OWN_NAME in $1" "$log" keep_building "$HOST_PRESET" "$program"
  if grep -q '^not all was built$' "$log"; then
    gallery_py failed "$1" "$2" "$log"
  else
    gallery_py errors "$1" "$2" "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/errors/$program"
  fi
}

write_gallery_documents() {
  local doc=$AXIAL_ROOT/doc
  gallery_py documents "$doc/data"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/plot/gallery.py" "$doc/data/gallery.json" "$doc/pictures/gallery"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/gallery_tables.py" "$doc/data" "$doc/measurements/gallery.md"
}
