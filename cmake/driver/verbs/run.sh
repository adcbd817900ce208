# shellcheck shell=bash
# summary: runs any robot header on an emulated board: torques of a smooth motion, checked

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial run HEADER [options]
Installs and builds what is missing: an image that computes the torques of a smooth motion inside the limits that the robot of this
header declares (a file of ./axial import, or your own), starts it in QEMU, prints time, positions and torques, and holds them against
axial::Model in double.
  --board NAME        stm32f405 (default), stm32f100, nrf51, rv32_virt
  --number NAME       float (default), fixed32
  --type NAME         the robot's struct, such as robots::MyArm; default: the one that holds the last chain of the header
  --csv FILE          time, positions, torques, exact torques
  --json FILE         board, largest error, largest torque
Exits with 1 when the error is above 1e-5 (float) or 1e-4 (fixed32) of the largest torque.
END_OF_USAGE
}

run() {
  local header=${1:-} type='' number=float argument board rest=()
  [[ -n $header && $header != -* ]] || fail_usage "name a robot header; see ./axial run --help"
  shift
  [[ -f $header ]] || fail "there is no header '$header'; ./axial import writes one"
  board=$(named_board "$@")
  while (($#)); do
    argument=$1
    case $argument in
      --type | --number | --board | --csv | --json)
        (($# > 1)) || fail_usage "$argument needs a value; see ./axial run --help"
        case $argument in
          --type) type=$2 ;;
          --number) number=$2 && rest+=(--number "$2") ;;
          *) rest+=("$argument" "$2") ;;
        esac
        shift
        ;;
      *) fail_usage "unknown option '$argument'; see ./axial run --help" ;;
    esac
    shift
  done
  [[ $number == float || $number == fixed32 ]] || fail_usage "unknown number '$number'; there are float and fixed32"
  [[ -n $board ]] || fail_usage "unknown board; there are ${BOARDS[*]}"
  run_header "$(realpath "$header")" "${type:-$(robot_type "$header")}" "$board" "$number" "${rest[@]}"
}

# run_header HEADER TYPE BOARD NUMBER OPTION...
run_header() {
  local header=$1 type=$2 board=$3 number=$4 host=${AXIAL_HOST_PRESET:-host-release}
  shift 4
  [[ -n $type ]] || fail "$header: no struct with 'static constexpr auto chain' was found; name it: --type robots::MyArm"
  ensure_packages
  write_own_robot "$AXIAL_ROOT/build/$board/own" "$header" "$type"
  write_own_robot "$AXIAL_ROOT/build/$host/own" "$header" "$type"
  build "$board" "run-$number"
  build "$host" run
  "$AXIAL_ROOT/build/$host/host_sim/run/run" "$@"
}

# The last struct before the last chain, in the namespace that is open there.
robot_type() {
  awk '/^namespace [a-z_:]+ *\{/ { space = $2 "::" }
       /^(struct|class) [A-Za-z_0-9]+/ { name = $2 }
       /static constexpr auto chain/ { found = space name }
       END { print found }' "$1"
}

# write_own_robot FOLDER HEADER TYPE: only when something changes, so that nothing is compiled twice.
write_own_robot() {
  local folder=$1 text
  text=$(printf '#pragma once\n// Written by ./axial run.\n#include "%s"\n\nnamespace axial::apps {\nusing Robot = %s;\n}\n' "$2" "$3")
  mkdir -p "$folder"
  [[ -f $folder/robot.hpp && $(<"$folder/robot.hpp") == "$text" ]] || printf '%s\n' "$text" >"$folder/robot.hpp"
}
