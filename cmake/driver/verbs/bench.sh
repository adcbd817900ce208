# shellcheck shell=bash
# summary: races the kernels on the host against Orocos KDL and DART, with gcc and clang; ratios, pictures
# group: measure

readonly BENCH_COMPILERS=(gcc clang)
readonly BENCH_PACKAGES=(clang libbenchmark-dev)

usage() {
  cat <<'END'
usage: ./axial bench [options]
Installs and builds what is missing (DART brings some 150 packages, the first time; --without-dart does without), compares every result with the
peers', then times both sides in alternating rounds, with gcc and with clang. Prints a table of ratios (peer's time
over ours: median and 95 % interval), writes JSON and pictures.
  --quick             fewer rounds
  --filter REGEX      only benchmarks whose names (algorithm/robot/scalar/peer) it finds
  --compiler gcc|clang  only this one
  --robot puma560|panda|scara|scara_rrpr...  only these are compiled; serial chains always race
  --processor NAME    our kernels for this processor, as -march= calls it: haswell has AVX2 and no AVX-512; default native
  --without-dart      only against Orocos KDL
  --output FOLDER     where the files go; default output/bench
  --json FILE         the rows of all compilers once more, as an array of objects
Exits non-zero when a build fails or a peer's result differs from ours; a time is never an error.
maintainers:
  --documents         alone: measures anew and writes the tables and pictures of doc/measurements/speed.md
END
}

run() {
  local compilers=("${BENCH_COMPILERS[@]}") output=$AXIAL_ROOT/output/bench json='' documents=false race=()
  local robots=puma560,panda,scara,scara_rrpr peers=kdl,dart processor=native
  while (($#)); do
    case $1 in
      --quick) race+=(--quick) ;;
      --without-dart) peers=kdl ;;
      --documents) documents=true output=$AXIAL_ROOT/doc/data ;;
      *)
        case $1 in
          --filter) race+=(--filter "$2") ;;
          --compiler) compilers=("$2") ;;
          --robot) robots=$2 ;;
          --processor) processor=$2 ;;
          --output) output=$2 ;;
          --json) json=$2 ;;
        esac
        shift
        ;;
    esac
    shift
  done
  local packages=("${BENCH_PACKAGES[@]}")
  [[ $peers != *dart* ]] || packages+=(libdart-dev)
  ensure_packages "${packages[@]}"
  race_all "$processor"
  if $documents; then
    race+=(--filter "one state")
    race_all haswell
    plot_speed pages/speed_tables.py "$output" "$AXIAL_ROOT/doc/measurements/speed.md"
  fi
}

# race_all PROCESSOR: with the variables of run. Each processor has its own build and, unless native, its own file.
race_all() {
  local compiler files=() of=''
  [[ $1 == native ]] || of=-$1
  mkdir -p "$output"
  for compiler in "${compilers[@]}"; do
    with_progress "configuring bench-$compiler$of" "$AXIAL_ROOT/build/bench-$compiler$of.log" cmake -S "$AXIAL_ROOT" --preset "bench-$compiler" \
      -B "$AXIAL_ROOT/build/bench-$compiler$of" "-DAXIAL_BENCH_PROCESSOR=$1" "-DAXIAL_BENCH_ROBOTS=$robots" "-DAXIAL_BENCH_PEERS=$peers"
    build "bench-$compiler$of" axial_bench
  done
  for compiler in "${compilers[@]}"; do
    say "racing, compiled by $compiler for $1"
    files+=("$output/bench-$compiler$of.json")
    "$AXIAL_ROOT/build/bench-$compiler$of/tests/bench/axial_bench" "${race[@]}" --json "${files[-1]}"
  done
  if ! $documents; then
    plot_speed plot/speed.py "$output" "${files[@]}" ${json:+--json "$json"}
  elif [[ $1 == native ]]; then
    plot_speed plot/speed.py "$AXIAL_ROOT/doc/pictures" "${files[@]}" --provenance "$output/bench-provenance.json"
  fi
}

plot_speed() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/$1" "${@:2}"; }
