# shellcheck shell=bash
# summary: sets fixed point against float and double: errors, instructions and bytes of a torque on every board
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial numbers [options]
Installs and builds what is missing. Computes the same torques in 16-bit and 32-bit fixed point (rounded to nearest, rounded
down, upper words of products), float and double, on the same seeded states: errors against quadruple precision on the host,
instructions and bytes on every board in QEMU (doc/measurements/number_systems.md). Prints a table, writes CSV, JSON and a picture.
  --robot ROBOT       only this robot
  --sizes IN_FILE     rows of ./axial size, such as doc/data/size.json, instead of measuring them
  --output FOLDER     where the files go; default output/numbers
  --json FILE         the rows once more, as an array of objects
maintainers:
  --documents         alone: writes doc/data/number_systems*, doc/pictures/number_systems.* and the tables of doc/measurements/number_systems.md
END_OF_USAGE
}

run() {
  ensure_packages
  if [[ ${1:-} == --documents ]]; then
    write_number_documents
  else
    take_sizes "$@"
    drop_options --robot "${ARGUMENTS[@]}"
    numbers_py "$(option_of --robot '' "$@")" "${ARGUMENTS[@]}"
  fi
}

# numbers_py ROBOT OPTION...: of all where ROBOT is empty. Errors and sizes go to a folder of their own, which is what the table is made from; unless they were measured already.
numbers_py() {
  local robot=$1 folder status=0
  shift
  folder=$(mktemp -d)
  mkdir "$folder/sizes"
  if [[ -n ${AXIAL_SIZES:-} ]]; then
    cp "$AXIAL_SIZES" "$folder/sizes/"
  else
    measure_sizes "$folder" "$robot"
  fi
  [[ -n ${AXIAL_ERRORS:-} ]] || measure_errors "$folder/errors" "$robot"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/numbers/numbers.py" "${AXIAL_ERRORS:-$folder/errors}" "$folder/sizes" "$@" || status=$?
  rm -r "$folder"
  return "$status"
}

measure_sizes() {
  local board
  for board in "${QEMU_BOARDS[@]}"; do
    "$AXIAL_ROOT/axial" size --board "$board" --scene bare --algorithm inverse_dynamics,closed_form --variant unrolled --contract off ${2:+--robot "$2"} \
      --output "$1/size" --json "$1/sizes/$board.json" >/dev/null
  done
}

write_number_documents() {
  local doc=$AXIAL_ROOT/doc
  numbers_py '' --output "$doc/data" --provenance "$doc/data/number_systems_provenance.json" \
    --cache "$AXIAL_ROOT/build/$HOST_PRESET/CMakeCache.txt"
  mv "$doc"/data/number_systems.png "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/number_system_tables.py" "$doc/data" \
    "$AXIAL_ROOT/tests/target/promised_instructions.json" "$doc/measurements/number_systems.md"
}
