# shellcheck shell=bash
# summary: what your arm costs on a board: instructions, cycles, flash, RAM, stack of every kernel and of the safe loop
# group: use

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial cost HEADER [options]
Installs and builds what is missing: an image for each kernel of the robot of this header (of ./axial import, your own, or a name of
robots/README.md), bare: with gravity and rotors. Tells the instructions that a call executes in the board's emulator (the dearest of 8 states), cycles
and microseconds by a model of its core that is named, flash and static RAM beside an image without a kernel, and the deepest stack
that the machine code can reach. On rp2040 cycles are those of a
warm cache, and the interval's upper end those of an empty one; rp2040_ram and rp2350_riscv have code in RAM. The safe loop is axial::feedforward: inverse
dynamics, limits, status, last safe torque.
  --board ANY_BOARD   stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram,
                      rp2350_riscv, mps2_an500, mps2_an505
  --number float|fixed32  default float
  --type NAME         the robot's struct, such as robots::MyArm; default: the one that holds the last chain of the header
  --json FILE         the rows once more, as an array of objects
Exits with 1 where a kernel does not compile, does not fit the board or has no bounded stack; what is not offered for joints that share
drives, or for a joint that moves no mass, is said with its reason, and is no error.
END_OF_USAGE
}

run() {
  local header=${1:-} board number
  [[ -n $header && $header != -* ]] || fail_usage "name a robot header; see ./axial cost --help"
  shift
  board=$(option_of --board "${BOARDS[0]}" "$@")
  number=$(option_of --number float "$@")
  take_own_robot "$header" "$(option_of --type '' "$@")"
  ensure_packages
  measure_cost "$board" "$number" "$(option_of --json '' "$@")"
}

# measure_cost BOARD NUMBER JSON
measure_cost() {
  local targets status=0
  ensure_runner "$1"
  prepare_own_images "$1"
  read -ra targets < <(cost_py targets "$1" "$2")
  build_own_images "$1" "${targets[@]}" || status=1
  cost_py measure "$1" "$2" --name "$OWN_NAME" ${3:+--json "$3"} || status=1
  return "$status"
}

cost_py() { /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/boards/cost/cost.py" "$@"; }
