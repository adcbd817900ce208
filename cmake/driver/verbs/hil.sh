# shellcheck shell=bash
# summary: a controller on one emulated board, the arm that it drives on another; the same loop around an arm on this host
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial hil HEADER|ROBOT [options]
Installs and builds what is missing: the tracking image of a robot for one board, an image that stands in for its arm for another. Starts both in
their emulators, joins their serial ports and runs them in lock-step: encoders and set-points to one, torques to the other. Then the same loop around
an arm in double on this host. Prints both tracking errors, writes JSON, CSV and a picture (doc/guides/two_boards.md).
  HEADER|ROBOT        a robot header by a smooth motion inside its limits (a file of ./axial import, or your own; it declares limits of effort);
                      scara (default) or puma560 by their cycles
  --plant BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram: the arm's
  --controller BOARD  likewise: the controller's
  --number float|fixed32  what the controller computes in; default float
  --plant-number float|fixed32  what the arm is integrated in; default float
  --seconds NUMBER    of motion; default 2 (some hundred ticks a second run)
  --carry KG          taken by the arm at a quarter of the motion and put down at three; its Mechanics name a payload
  --controller-port DEVICE[:BAUD]  the controller's board is on the desk, at this serial port, with its image in it; 2 Mbit/s where none is named
  --plant-port DEVICE[:BAUD]       likewise the arm's
  --faults            besides, eleven faults of the line between them, and whether each ends as doc/guides/faults.md says: a minute
  --type NAME         the header's struct, as ./axial run takes it
  --output FOLDER     where the files go; default output/hil
  --json FILE         the rows once more, as an array of objects
Exits non-zero when the tracking error is more than 2 % from that around the host's arm, the controller's board gives another torque than its source
on this host (fixed32: bits; float: 4 last places), a set-point is refused, or a fault ends otherwise.
maintainers:
  --documents         alone: writes doc/data/hil.json, the picture and the tables of doc/measurements/hil.md
END_OF_USAGE
}

run() {
  ensure_packages
  if [[ ${1:-} == --documents ]]; then
    write_hil_documents
    return
  fi
  local robot=scara type
  if [[ $# -gt 0 && $1 != -* ]]; then
    robot=$1
    shift
  fi
  type=$(option_of --type '' "$@")
  drop_options --type "$@"
  two_boards "$robot" "$type" "${ARGUMENTS[@]}"
}

# two_boards ROBOT TYPE OPTION...
two_boards() {
  local robot=$1 type=$2 plant controller
  shift 2
  plant=$(hil_board --plant "$@")
  controller=$(hil_board --controller "$@")
  ensure_runner "$plant"
  ensure_runner "$controller"
  if [[ $robot != scara && $robot != puma560 ]]; then
    take_own_robot "$robot" "$type"
    robot=own
    write_own_robot "$plant"
    write_own_robot "$controller"
    write_own_robot "$HOST_PRESET"
    [[ ! $(option_of --carry '' "$@") =~ [1-9] ]] || require_load
  fi
  build "$controller" "$(hil_image tracking "$(option_of --number float "$@")")-$robot"
  build "$plant" "$(hil_image arm "$(option_of --plant-number float "$@")")-$robot"
  build "$HOST_PRESET" "hil-$robot"
  say_image "$controller" tracking "$robot" "$(option_of --number float "$@")" "$(option_of --controller-port '' "$@")"
  say_image "$plant" arm "$robot" "$(option_of --plant-number float "$@")" "$(option_of --plant-port '' "$@")"
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/two_boards/hil-$robot" "$@"
}

require_load() {
  require_of_own_robot "$HOST_PRESET" firmware/apps/plant/mechanics.hpp 'axial::apps::plant::has_payload<axial::apps::plant::MechanicsOf<Robot>>' \
    "$OWN_NAME takes no load: name 'static constexpr bool payload = true;' in its Mechanics (doc/guides/two_boards.md)"
}

# say_image BOARD APP ROBOT NUMBER PORT: what a board on the desk has to run.
say_image() {
  [[ -z $5 ]] || say "at ${5%:*} the board has to run build/$1/images/$(hil_image "$2" "$4")-$3.elf"
}

# hil_board OPTION ARGUMENT...: the board that an option names.
hil_board() {
  local board
  board=$(option_of "$1" stm32f405 "${@:2}")
  [[ " ${BOARDS[*]} " == *" $board "* ]] || fail_usage "there is no board '$board' for this; see ./axial hil --help"
  echo "$board"
}

hil_image() {
  case $2 in
    float) echo "$1" ;;
    fixed32) echo "$1-fixed" ;;
    *) fail_usage "a number is float or fixed32, not '$2'" ;;
  esac
}

# Robot, number of both, controller, arm, seconds; the first with faults, and drawn.
readonly HIL_DOCUMENTED=("scara float stm32f405 stm32f405 60 --faults" "puma560 float stm32f405 stm32f405 10" "puma560 fixed32 stm32f405 stm32f100 10"
  "scara fixed32 nrf51 nrf51 10" "scara fixed32 nrf51 rv32_virt 10" "scara float rv32_virt nrf51 10" "scara fixed32 rp2040 rp2040 1"
  "tests/driver/worn_links.hpp fixed32 nrf51 stm32f100 10" "tests/driver/elastic_links.hpp float stm32f405 stm32f405 10")

write_hil_documents() {
  local doc=$AXIAL_ROOT/doc output=$AXIAL_ROOT/output/hil row robot number controller plant seconds faults
  local -a rows=()
  cd "$AXIAL_ROOT" || return
  mkdir -p "$output/documents"
  for row in "${HIL_DOCUMENTED[@]}"; do
    read -r robot number controller plant seconds faults <<<"$row"
    rows+=("$output/documents/${#rows[@]}.json")
    two_boards "$robot" '' --number "$number" --plant-number "$number" --controller "$controller" --plant "$plant" --seconds "$seconds" \
      --output "$output" --json "${rows[-1]}" ${faults:+"$faults"}
    [[ -z $faults ]] || cp "$output/hil-$robot.png" "$doc/pictures/hil.png"
  done
  printf '{"commit": "%s", "compiler": "%s", "boards": "%s"}\n' "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" "$(c++ --version | head -n 1)" \
    "$(arm-none-eabi-g++ --version | head -n 1)" >"$doc/data/hil_provenance.json"
  /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/figures/pages/two_board_tables.py" "$doc" "${rows[@]}"
}
