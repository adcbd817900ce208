# shellcheck shell=bash
# summary: runs any robot header on an emulated board: torques of a smooth motion, checked
# group: use

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial run HEADER [options]
Installs and builds what is missing: an image that computes the torques of a smooth motion inside the limits that the robot of this
header declares (a file of ./axial import, or your own), starts it in the board's emulator, prints time, positions and torques, and holds them against
axial::Model in double.
  --board BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040
  --number float|fixed32  default float
  --type NAME         the robot's struct, such as robots::MyArm; default: the one that holds the last chain of the header
  --csv FILE          time, positions, torques, exact torques
  --json FILE         board, largest error, largest torque
Exits with 1 when the error is above 1e-5 (float) or 1e-4 (fixed32) of the largest torque.
END_OF_USAGE
}

run() {
  local header=${1:-} board number rest=()
  [[ -n $header && $header != -* ]] || fail_usage "name a robot header; see ./axial run --help"
  shift
  board=$(named_board "$@")
  number=$(option_of --number float "$@")
  take_own_robot "$header" "$(option_of --type '' "$@")"
  while (($#)); do
    [[ $1 == --type ]] || rest+=("$1" "$2")
    shift 2
  done
  ensure_packages
  ensure_runner "$board"
  write_own_robot "$board"
  write_own_robot "$HOST_PRESET"
  build "$board" "run-$number"
  build "$HOST_PRESET" run
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/run/run" "${rest[@]}"
}
