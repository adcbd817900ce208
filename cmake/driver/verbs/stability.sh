# shellcheck shell=bash
# summary: forward dynamics and integrators on stiff and extreme cases: errors, gates, other engines
# group: measure, rare

STABILITY_PACKAGES=(libsundials-dev)
readonly PEER_PACKAGES=(libdart-dev libsimbody-dev libbullet-dev)

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial stability [options]
Installs and builds what is missing. Solves and derives the scenarios ST1 to ST17 (long chains, size and mass ratios, massless links near
gimbal lock, rotors, speeds, scales, ...) by every route in double, float and, where they fit declared limits, fixed point: forward
and backward error against quadruple precision beside the gates (doc/measurements/stability.md). Then the motions of ST18 to ST22, by every
integrator. Prints tables, writes JSON and pictures.
  --scenario NAME     only scenarios whose names hold NAME
  --compare           also KDL, DART, Simbody and Bullet on 50 perturbed instances of each (2 minutes; DART brings some 150
                      packages, the first time)
  --output FOLDER     where the files go; default output/stability
  --json FILE         the rows once more, as an array of objects
Exits non-zero when an error is outside its gate, or an engine is more than ten times more exact than ours.
maintainers:
  --documents         alone: everything, into doc/data/stability*, doc/pictures/stability* and the tables of doc/measurements/stability.md
END_OF_USAGE
}

run() {
  local output=$AXIAL_ROOT/output/stability json='' scenario='' compare=false documents=false
  while (($#)); do
    case $1 in
      --compare) compare=true ;;
      --documents)
        documents=true compare=true output=$AXIAL_ROOT/doc/data
        ;;
      --scenario | --output | --json)
        case $1 in
          --scenario) scenario=$2 ;;
          --output) output=$2 ;;
          --json) json=$2 ;;
        esac
        shift
        ;;
    esac
    shift
  done
  if $compare; then STABILITY_PACKAGES+=("${PEER_PACKAGES[@]}"); fi
  ensure_packages "${STABILITY_PACKAGES[@]}"
  measure_stability
}

# With the variables of run. Each program writes rows with the fields of all; a gate that is missed does not stop the others.
measure_stability() {
  local status=0 files=()
  mkdir -p "$output"
  rm -rf "$output/rows"
  if $compare; then ask_for_peers; fi
  if [[ -n $scenario ]]; then
    stability_rows tests/stability stability --scenario "$scenario" || status=$?
    stability_rows host_sim/plants/simulation stability_motion --filter "$scenario" || status=$?
  else
    stability_rows tests/stability stability --ablation || status=$?
    stability_rows host_sim/plants/simulation stability_motion || status=$?
  fi
  if $compare; then
    stability_rows tests/stability/peers stability_peers ${scenario:+--scenario "$scenario"} || status=$?
  fi
  ((${#files[@]} > 0)) || fail "no scenario's name holds '$scenario'"
  if $documents; then
    plot_stability plot/stability.py "$AXIAL_ROOT/doc/pictures" "${files[@]}" --data "$output"
    plot_stability pages/stability_tables.py "$output" "$AXIAL_ROOT/doc/measurements/stability.md"
  else
    plot_stability plot/stability.py "$output" "${files[@]}" --data "$output" ${json:+--json "$json"}
  fi
  rm -r "$output/rows"
  return "$status"
}

# The engines may have been installed since the build was configured.
ask_for_peers() {
  local cache=$AXIAL_ROOT/build/$HOST_PRESET/CMakeCache.txt
  if [[ ! -f $cache ]] || ! grep -q '^AXIAL_PEERS:BOOL=ON' "$cache"; then
    with_progress "configuring host-release with other engines" "$AXIAL_ROOT/build/$HOST_PRESET.log" \
      cmake -S "$AXIAL_ROOT" --preset "$HOST_PRESET" -DAXIAL_PEERS=ON || exit
  fi
}

# stability_rows FOLDER PROGRAM [OPTION...]: builds it, runs it, notes its rows in `files`.
stability_rows() {
  local program=$AXIAL_ROOT/build/$HOST_PRESET/$1/$2 file=$output/rows/$2.json log=$output/rows/$2.log status=0
  mkdir -p "$output/rows"
  build "$HOST_PRESET" "$2" || exit
  { "$program" "${@:3}" --json "$file" 2>&1 1>&3 | tee "$log" >&2; status=${PIPESTATUS[0]}; } 3>&1
  if [[ -f $file ]]; then
    files+=("$file")
  elif [[ -n $scenario ]] && grep -q "no scenario's name holds" "$log"; then
    status=0 # another program's
  else
    exit "$status"
  fi
  return "$status"
}

plot_stability() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/$1" "${@:2}"; }
