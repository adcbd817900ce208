# shellcheck shell=bash
# Configuring and building presets.

readonly BOARDS=(stm32f405 stm32f100 nrf51 rv32_virt)
readonly SELFTEST_BOARDS=(mps2_an505) # run the self-tests alone
readonly FAULT_BOARDS=(mps2_an500)    # run the image of faults alone
# Of the documents' closed loops, in fixed point: the smallest one. Its UART queues six bytes, which QEMU fills at once.
readonly LOOP_BOARD=nrf51

# build PRESET [TARGET...]: configures when there is something new to configure, then builds.
build() {
  local preset=$1 directory=$AXIAL_ROOT/build/$1
  shift
  if [[ ! -f $directory/build.ninja || $AXIAL_ROOT/CMakePresets.json -nt $directory/build.ninja ]]; then
    with_progress "configuring $preset" "$AXIAL_ROOT/build/$preset.log" \
      cmake -S "$AXIAL_ROOT" --preset "$preset" || return
  fi
  say "building $preset"
  cmake --build "$directory" --parallel "$(nproc)" ${1:+--target "$@"}
}

build_boards() {
  local board
  for board in "${BOARDS[@]}" "${SELFTEST_BOARDS[@]}"; do
    build "$board"
  done
  for board in "${FAULT_BOARDS[@]}"; do
    build "$board" faults
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

build_host_sim() { build host-release host_sim; }

host_sim() { "$AXIAL_ROOT/build/host-release/host_sim/host_sim" "$@"; }

# measure_errors FOLDER: the errors of every kernel (host_sim/errors), a file a robot.
measure_errors() {
  build host-release errors
  mkdir -p "$1"
  say "errors of every kernel against 113-bit arithmetic"
  printf '%s\n' scara scara_rrpr puma560 panda planar2r |
    xargs -P "$(nproc)" -I ROBOT "$DRIVER/errors_of.sh" "$AXIAL_ROOT" ROBOT "$1/errors-ROBOT.json"
}
