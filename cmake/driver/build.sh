# shellcheck shell=bash
# Configuring and building presets.

readonly QEMU_BOARDS=(stm32f405 stm32f100 nrf51 rv32_virt)
readonly RUNNER_BOARD=rp2040 # in an emulator of its own, slower than QEMU: tests build and run these images alone
readonly RUNNER_IMAGES=(selftest{,-scara,-puma560} fixed{,-derivatives,-motions}-{scara,puma560} feedforward-{scara,puma560} feedforward-fixed-{scara,puma560}
  injection-scara kernels-scara faults overflow tracking-fixed-scara arm-fixed-scara
  size-puma560-bare-inverse_dynamics-unrolled-off{,-fixed32} size-scara-bare-inverse_dynamics-unrolled-off-double)
readonly RAM_IMAGES=(selftest{,-scara} size-puma560-bare-inverse_dynamics-unrolled-off{,-fixed32}) # of rp2040_ram
readonly CORE_BOARD=rp2350_riscv # its core in an emulator, without peripherals
readonly CORE_IMAGES=(selftest{,-scara,-puma560} fixed{,-derivatives,-motions}-{scara,puma560} size-puma560-bare-inverse_dynamics-unrolled-off{,-fixed32})
readonly BOARDS=("${QEMU_BOARDS[@]}" "$RUNNER_BOARD" rp2040_ram)
# Of the documents' closed loops, in fixed point: the smallest one. Its UART queues six bytes, which QEMU fills at once.
readonly LOOP_BOARD=nrf51

# Of the host's programs; tests of the driver take the one that they are part of.
readonly HOST_PRESET=${AXIAL_HOST_PRESET:-host-release}

# build PRESET [TARGET...]: configures when there is something new to configure, then builds.
build() {
  local preset=$1
  shift
  configure "$preset" || return
  say "building $preset"
  cmake --build "$AXIAL_ROOT/build/$preset" --parallel "$(nproc)" ${1:+--target "$@"}
}

configure() {
  local preset=$1 directory=$AXIAL_ROOT/build/$1
  if [[ ! -f $directory/build.ninja || $AXIAL_ROOT/CMakePresets.json -nt $directory/build.ninja ]]; then
    with_progress "configuring $preset" "$AXIAL_ROOT/build/$preset.log" \
      cmake -S "$AXIAL_ROOT" --preset "$preset" || return
  else
    # Anew where a list of sources has changed: a test that was just added has to be known.
    ninja -C "$directory" build.ninja >>"$AXIAL_ROOT/build/$preset.log" 2>&1 || fail "configuring $preset: failed; see build/$preset.log"
  fi
}

# was_found PRESET NAME: whether CMake has found what it knows as that.
was_found() { grep -qsE "^$2:PATH=/" "$AXIAL_ROOT/build/$1/CMakeCache.txt"; }

# look_again PRESET NAME...: what was configured before a package was there is configured anew.
look_again() {
  local name
  for name in "${@:2}"; do
    if ! was_found "$1" "$name"; then rm -f "$AXIAL_ROOT/build/$1/build.ninja"; fi
  done
}

# images_of BOARD: what its tests run; nothing where that is all that it has.
images_of() {
  case $1 in
    "$RUNNER_BOARD") printf '%s\n' "${RUNNER_IMAGES[@]}" ;;
    rp2040_ram) printf '%s\n' "${RAM_IMAGES[@]}" ;;
    rp2040_second_core) echo selftest ;;
    "$CORE_BOARD") printf '%s\n' "${CORE_IMAGES[@]}" ;;
    mps2_an500) echo faults ;;
  esac
}

build_boards() {
  local board images
  for board in "${QEMU_BOARDS[@]}" "$RUNNER_BOARD" rp2040_ram; do
    mapfile -t images < <(images_of "$board")
    build "$board" "${images[@]}"
  done
}

# option_of NAME DEFAULT OPTION...: what the options give NAME, as --name value or --name=value.
option_of() {
  local name=$1 value=$2
  shift 2
  while (($#)); do
    case $1 in
      "$name") value=${2:-} ;;
      "$name"=*) value=${1#*=} ;;
    esac
    shift
  done
  echo "$value"
}

# The board that options name, or the first one; nothing for an unknown one, which is left to the program: it says what there is.
named_board() {
  local board known
  board=$(option_of --board "${BOARDS[0]}" "$@")
  for known in "${BOARDS[@]}"; do
    if [[ $board == "$known" ]]; then echo "$board"; fi
  done
}

build_loop_images() { build "$LOOP_BOARD" tracking-fixed-scara tracking-fixed-puma560; }

build_host_sim() { build "$HOST_PRESET" host_sim; }

host_sim() { "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/host_sim" "$@"; }

# drop_options "NAME..." OPTION...: ARGUMENTS are the others; each of those names has a value.
drop_options() {
  local names=" $1 "
  shift
  ARGUMENTS=()
  while (($#)); do
    if [[ $names == *" $1 "* ]]; then shift; else ARGUMENTS+=("$1"); fi
    shift
  done
}

# take_sizes OPTION...: AXIAL_SIZES is the file of an option --sizes, made absolute; ARGUMENTS are the other options.
take_sizes() {
  local file
  file=$(option_of --sizes '' "$@")
  if [[ -n $file ]]; then
    AXIAL_SIZES=$(realpath "$file") && export AXIAL_SIZES
  fi
  drop_options --sizes "$@"
}

# measure_errors FOLDER [ROBOT]: the errors of every kernel (host_sim/figures/errors), of all robots or one, a file per robot.
measure_errors() {
  local program=errors${2:+-$2}
  build "$HOST_PRESET" "$program"
  mkdir -p "$1"
  say "errors of ${2:-every robot}'s kernels against 113-bit arithmetic"
  { if [[ -n ${2:-} ]]; then echo "$2"; else robots_with_trajectories; fi; } |
    AXIAL_ERRORS_PROGRAM=$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/errors/$program xargs -P "$(nproc)" -I ROBOT "$DRIVER/errors_of.sh" ROBOT "$1/errors-ROBOT.json"
}
