# shellcheck shell=bash
# summary: races the kernels on the host against Orocos KDL and DART, with gcc and clang; ratios, pictures

readonly BENCH_COMPILERS=(gcc clang)
readonly BENCH_PACKAGES=(clang libbenchmark-dev libdart-dev)

usage() {
  cat <<'END'
usage: ./axial bench [options]
Installs and builds what is missing (DART brings some 150 packages, the first time), compares every result with the
peers', then times both sides in alternating rounds, with gcc and with clang. Prints a table of ratios (peer's time
over ours: median and 95 % interval), writes JSON and pictures.
  --quick             fewer rounds
  --filter REGEX      only benchmarks whose names (algorithm/robot/scalar/peer) it finds
  --compiler NAME     only gcc or only clang
  --output FOLDER     where the files go; default output/bench
  --json FILE         the rows of all compilers once more, as an array of objects
  --documents         alone: measures anew and writes the tables and pictures of doc/speed.md
Exits non-zero when a build fails or a peer's result differs from ours; a time is never an error.
END
}

run() {
  local compilers=("${BENCH_COMPILERS[@]}") output=$AXIAL_ROOT/output/bench json='' documents=false race=()
  while (($#)); do
    case $1 in
      --quick) race+=(--quick) ;;
      --documents)
        (($# == 1 && ${#race[@]} == 0)) || fail_usage "--documents stands alone; see ./axial bench --help"
        documents=true output=$AXIAL_ROOT/doc/data
        ;;
      --filter | --compiler | --output | --json)
        (($# > 1)) || fail_usage "$1 needs a value; see ./axial bench --help"
        case $1 in
          --filter) race+=(--filter "$2") ;;
          --compiler) compilers=("$2") ;;
          --output) output=$2 ;;
          --json) json=$2 ;;
        esac
        shift
        ;;
      *) fail_usage "unknown option '$1'; see ./axial bench --help" ;;
    esac
    shift
  done
  [[ " ${BENCH_COMPILERS[*]} " == *" ${compilers[0]} "* ]] || fail_usage "unknown compiler '${compilers[0]}'; gcc or clang"
  ensure_packages "${BENCH_PACKAGES[@]}"
  race_all
  if $documents; then
    plot_speed speed_tables.py "$output" "$AXIAL_ROOT/doc/speed.md"
  fi
}

# With the variables of run.
race_all() {
  local compiler files=()
  mkdir -p "$output"
  for compiler in "${compilers[@]}"; do
    build "bench-$compiler" axial_bench
  done
  for compiler in "${compilers[@]}"; do
    say "racing, compiled by $compiler"
    files+=("$output/bench-$compiler.json")
    "$AXIAL_ROOT/build/bench-$compiler/tests/bench/axial_bench" "${race[@]}" --json "${files[-1]}"
  done
  if $documents; then
    plot_speed speed.py "$AXIAL_ROOT/doc/pictures" "${files[@]}" --provenance "$output/bench-provenance.json"
  else
    plot_speed speed.py "$output" "${files[@]}" ${json:+--json "$json"}
  fi
}

plot_speed() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/plot/$1" "${@:2}"; }
