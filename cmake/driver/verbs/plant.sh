# shellcheck shell=bash
# summary: robots integrated at a fixed step in float and in 32-bit words, against double
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial plant [options]
Builds what is missing. Moves robots as a board would: a second of a pick-and-place cycle by torques held for a tick, a minute's free
swing, by Runge-Kutta and semi-implicit steps in float and in fixed point, on this host. Prints what each is off from double and what
becomes of its energy, beside gates (doc/measurements/plant.md).
  --json FILE         the rows as an array of objects
Exits non-zero when a gate is missed.
maintainers:
  --documents         alone: writes doc/data/plant.json and the table of doc/measurements/plant.md
END_OF_USAGE
}

run() {
  local json='' documents=false
  case ${1:-} in
    --json) json=$2 ;;
    --documents) documents=true json=$AXIAL_ROOT/doc/data/plant.json ;;
  esac
  build "$HOST_PRESET" plant_rows
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/real_time/plant_rows" ${json:+--json "$json"}
  if $documents; then write_plant_documents; fi
}

write_plant_documents() {
  local doc=$AXIAL_ROOT/doc
  printf '{"commit": "%s", "compiler": "%s", "flags": "-O2 -ffp-contract=off"}\n' \
    "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" "$(c++ --version | head -n 1)" >"$doc/data/plant_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/plant_tables.py" "$doc/data" "$doc/measurements/plant.md"
}
