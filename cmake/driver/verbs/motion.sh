# shellcheck shell=bash
# summary: error against work of the library's integrators, on smooth and stiff motions
# group: measure, rare

readonly MOTION_PACKAGES=(libsundials-dev) # reference motions

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial motion [options]
Installs and builds what is missing (SUNDIALS brings some 90 packages, the first time). Integrates smooth and stiff motions by every
integrator of the library, in double and in float, at many steps: error at the end against CVODE and ARKODE, evaluations of forward
dynamics, processor time over that of a reference kernel. Prints a table, writes JSON (fields as ./axial report) and a picture
(doc/measurements/simulation.md). The stability scenarios of motions are in ./axial stability.
  --output FOLDER     where the files go; default output/motion
  --json FILE         the rows once more, as an array of objects
maintainers:
  --documents         alone: writes doc/data/simulation.json, doc/pictures and the tables of doc/measurements/simulation.md
END_OF_USAGE
}

run() {
  local output=$AXIAL_ROOT/output/motion json='' documents=false
  if [[ ${1:-} == --documents ]]; then
    documents=true output=$AXIAL_ROOT/doc/data
    shift
  fi
  while (($#)); do
    case $1 in
      --output | --json)
        if [[ $1 == --json ]]; then json=$2; else output=$2; fi
        shift
        ;;
    esac
    shift
  done
  ensure_packages "${MOTION_PACKAGES[@]}"
  # What was configured before SUNDIALS was there looks again.
  if ! grep -qs '^AXIAL_SUNDIALS_INCLUDE:PATH=/' "$AXIAL_ROOT/build/$HOST_PRESET/CMakeCache.txt"; then
    rm -f "$AXIAL_ROOT/build/$HOST_PRESET/build.ninja"
  fi
  build "$HOST_PRESET" work_precision
  mkdir -p "$output"
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/simulation/work_precision" --json "$output/simulation.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/plot/simulation.py" "$output/simulation.json"
  [[ -z $json ]] || cp "$output/simulation.json" "$json"
  say "picture $output/simulation.png, data $output/simulation.json"
  if $documents; then write_motion_documents; fi
}

write_motion_documents() {
  local doc=$AXIAL_ROOT/doc
  mv "$doc"/data/simulation.png "$doc/pictures/"
  printf '{"commit": "%s", "compiler": "%s", "flags": "-O2 -ffp-contract=off"}\n' \
    "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" "$(c++ --version | head -n 1)" >"$doc/data/motion_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/simulation_tables.py" "$doc/data" "$doc/measurements/simulation.md"
}
