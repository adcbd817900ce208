# shellcheck shell=bash
# summary: sets Newton-Euler against separation against the closed form: operations, instructions, errors, two rates
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial compare [options]
Installs and builds what is missing. Compares the ways to a torque for RRP, RRPR, 6R and 7R arms: recursive Newton-Euler,
the Automatic Separation Method, the SCARA's closed form; operations, instructions on a Cortex-M4F and a Cortex-M0 in QEMU,
errors against the oracle, and the error of a feed-forward whose terms are refreshed slowly (doc/measurements/separation.md).
  --output FOLDER     where the files go; default output/separation
  --sizes IN_FILE     rows of ./axial size, such as doc/data/size.json, instead of measuring them
  --json FILE         the rows once more, as an array of objects
maintainers:
  --documents         alone: writes doc/data/separation*.json, doc/pictures/separation.* and the tables of doc/measurements/separation.md
END_OF_USAGE
}

run() {
  ensure_packages
  if [[ ${1:-} == --documents ]]; then
    write_separation_documents
  else
    take_sizes "$@"
    set -- "${ARGUMENTS[@]}"
    compare_py "$@"
  fi
}

# Errors, counts and sizes go to a folder of their own, which is what the table is made from.
compare_py() {
  build "$HOST_PRESET" compare operation_counts
  local program=$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures folder board
  folder=$(mktemp -d)
  mkdir "$folder/sizes"
  "$program/compare/compare" "$AXIAL_ROOT/host_sim/robots/trajectories" >"$folder/errors.json"
  "$program/counts/operation_counts" >"$folder/counts.json"
  if [[ -n ${AXIAL_SIZES:-} ]]; then # measured already
    cp "$AXIAL_SIZES" "$folder/sizes/"
  else
    for board in stm32f405 nrf51; do
      "$AXIAL_ROOT/axial" size --board "$board" --scene bare --algorithm inverse_dynamics,separation,separated_torque,closed_form --scalar float \
        --output "$folder/size" --json "$folder/sizes/$board.json" >/dev/null
    done
  fi
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/compare/compare.py" "$folder"/{errors,counts}.json "$folder/sizes" "$@"
  rm -r "$folder"
}

write_separation_documents() {
  local doc=$AXIAL_ROOT/doc
  compare_py --output "$doc/data" --provenance "$doc/data/separation_provenance.json"
  mv "$doc"/data/separation.png "$doc/pictures/"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/separation_tables.py" "$doc/data" "$doc/measurements/separation.md"
}
