# shellcheck shell=bash
# summary: runs any robot header on an emulated board: torques of a smooth motion, checked
# group: use

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial run HEADER [options]
Installs and builds what is missing: an image that computes the torques of a smooth motion inside the limits that the robot of this
header declares (a file of ./axial import, or your own), starts it in the board's emulator, prints time, positions and torques, and holds them against
axial::Model in double.
  --board BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram
  --number float|fixed32  default float
  --type NAME         the robot's struct, such as robots::MyArm; default: the one that holds the last chain of the header
  --csv FILE          time, positions, torques, exact torques
  --uf2 FILE          besides, the image as a file for the drive that a Raspberry Pi Pico shows (boards rp2040, rp2040_ram)
  --json FILE         board, largest error, largest torque
Exits with 1 when the error is above 1e-5 (float) or 1e-4 (fixed32) of the largest torque.
END_OF_USAGE
}

run() {
  local header=${1:-} board number uf2 rest=()
  [[ -n $header && $header != -* ]] || fail_usage "name a robot header; see ./axial run --help"
  shift
  board=$(named_board "$@")
  number=$(option_of --number float "$@")
  uf2=$(option_of --uf2 '' "$@")
  [[ -z $uf2 || $board == rp2040* ]] || fail_usage "--uf2 is for the boards rp2040 and rp2040_ram"
  take_own_robot "$header" "$(option_of --type '' "$@")"
  while (($#)); do
    [[ $1 == --type || $1 == --uf2 ]] || rest+=("$1" "$2")
    shift 2
  done
  ensure_packages
  ensure_runner "$board"
  write_own_robot "$board"
  write_own_robot "$HOST_PRESET"
  build "$board" "run-$number"
  [[ -z $uf2 ]] || "$AXIAL_ROOT/host_sim/boards/rp2040/uf2.py" "$AXIAL_ROOT/build/$board/images/run-$number.elf" "$uf2"
  build "$HOST_PRESET" run
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/boards/run/run" "${rest[@]}"
}
