# shellcheck shell=bash
# summary: robots integrated at a fixed step in float and in 32-bit words, on this host or an emulated board, against double
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial plant [--board BOARD] [options]
Builds what is missing. Without a board: moves robots as one would, a second of a pick-and-place cycle by torques held for a tick, a
minute's free swing, by Runge-Kutta and semi-implicit steps in float and in fixed point, on this host. Prints what each is off from double and what
becomes of its energy, beside gates (doc/measurements/plant.md).
  --json FILE         the rows as an array of objects
  --board BOARD       stm32f405, stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram: an image integrates one robot in the board's emulator.
                      Besides the error: instructions and microseconds of the dearest step by the core's model, times real time,
                      whether the board has the host's bits, a picture
With a board:
  --robot ROBOT|HEADER  puma560 (default), scara, panda by a second of their cycles; any other of robots/ or the gallery, or a header, by a second
                      of a smooth motion inside its limits
  --type NAME         the header's struct, as ./axial run takes it
  --number float|fixed32...  float (with compensated sums), fixed32; default both
  --method runge_kutta_4|semi_implicit...  default runge_kutta_4
  --steps-per-tick 1|2|5|10...  steps per millisecond; default 1
  --swing             besides, a minute's free swing, of the puma560
  --output FOLDER     where the picture goes; default output/plant
Exits non-zero when a gate is missed: 1e-5 of the travel in float and 1e-4 in fixed32 by Runge-Kutta, 1e-4 of a swing's energy, and in
fixed32 the host's bits.
maintainers:
  --documents         alone: writes doc/data/plant.json, plant_boards.json, the picture and the tables of doc/measurements/plant.md
  --documents-robots  alone: nineteen robots of the gallery and one that the commit draws on two boards: plant_robots.json and its table of
                      that page. What was measured at this commit is not measured again
END_OF_USAGE
}

run() {
  local json
  if [[ ${1:-} == --documents ]]; then
    write_plant_documents
  elif [[ ${1:-} == --documents-robots ]]; then
    write_plant_robots
  elif [[ -n $(option_of --board '' "$@") ]]; then
    plant_on_board "$@"
  else
    json=$(option_of --json '' "$@")
    host_plant ${json:+--json "$json"}
  fi
}

host_plant() {
  build "$HOST_PRESET" plant_rows
  "$(plant_program plant_rows)" "$@"
}

plant_program() { echo "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/real_time/$1"; }
plant_py() { /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/plants/real_time/on_board.py" "$@"; }

readonly PLANTS=(scara puma560 panda)

plant_on_board() {
  local board robot name output number targets
  board=$(named_board "$@")
  [[ -n $board ]] || fail_usage "there is no board '$(option_of --board '' "$@")' for this; see ./axial plant --help"
  robot=$(option_of --robot puma560 "$@") name=$robot
  output=$(option_of --output output/plant "$@")
  number=$(option_of --number float,fixed32 "$@")
  ensure_packages
  ensure_runner "$board"
  if [[ " ${PLANTS[*]} " != *" $robot "* ]]; then
    take_own_robot "$robot" "$(option_of --type '' "$@")"
    write_own_robot "$board"
    write_own_robot "$HOST_PRESET"
    robot=own name=$OWN_NAME
  fi
  read -ra targets < <(plant_py targets "$robot" --number "$number")
  build "$board" "${targets[@]}"
  build "$HOST_PRESET" "plant_board-$robot"
  mkdir -p "$output"
  drop_options "--board --robot --type --output" "$@"
  plant_py run "$(plant_program "plant_board-$robot")" "$board" "$robot" --name "$name" --picture "$output/$name-$board" "${ARGUMENTS[@]}"
}

write_plant_documents() {
  local doc=$AXIAL_ROOT/doc board targets robot
  ensure_packages
  host_plant --json "$doc/data/plant.json"
  build "$HOST_PRESET" "${PLANTS[@]/#/plant_board-}"
  for board in "${BOARDS[@]}"; do
    targets=()
    for robot in "${PLANTS[@]}"; do targets+=("plant-$robot" "plant-fixed-$robot"); done
    ensure_runner "$board"
    build_what_fits "$board" "${targets[@]}"
  done
  printf '{"commit": "%s", "compiler": "%s", "flags": "-O2 -ffp-contract=off", "boards": "%s"}\n' "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" \
    "$(c++ --version | head -n 1)" "$(arm-none-eabi-g++ --version | head -n 1)" >"$doc/data/plant_provenance.json"
  plant_py documents "$(plant_program plant_board)" "$doc/data/plant_boards.json" "$AXIAL_ROOT/output/plant"
  cp "$AXIAL_ROOT/output/plant/puma560-stm32f405.png" "$doc/pictures/plant.png"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/plant_tables.py" "$doc/data" "$doc/measurements/plant.md"
}

# Of the gallery: arms of six and seven joints, from desks, of factories, legs, a finger, a SCARA.
readonly GALLERY_PLANTS=(so101 koch openarm wx250s piper z1 arx_l5 ur3e ur10e xarm6 lite6 fr3 iiwa14 gen3 rizon4 go2_leg spot_arm allegro_finger m1_pro)
readonly DRAWN_PLANT=$AXIAL_ROOT/output/plant/drawn.hpp

write_plant_robots() {
  local doc=$AXIAL_ROOT/doc robot
  mkdir -p "$AXIAL_ROOT/output/plant"
  /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/robots/commissioning/drawn_logs.py" "$(git -C "$AXIAL_ROOT" rev-parse --short=8 HEAD)" "${DRAWN_PLANT%.hpp}.json"
  "$AXIAL_ROOT/axial" import "${DRAWN_PLANT%.hpp}.json" --output "$DRAWN_PLANT"
  for robot in "${GALLERY_PLANTS[@]}" "$DRAWN_PLANT"; do
    write_plant_robot "$robot" stm32f405 float,fixed32
    write_plant_robot "$robot" rp2040_ram fixed32
  done
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/plant_tables.py" "$doc/data" "$doc/measurements/plant.md"
}

# write_plant_robot ROBOT BOARD NUMBER,...: its rows into plant_robots.json, unless they are there from this commit. In a shell of its own, so that
# one that does not fit ends no other.
write_plant_robot() {
  local kept=$AXIAL_ROOT/doc/data/plant_robots.json commit rows=$AXIAL_ROOT/output/plant/rows.json
  commit=$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")
  if ! plant_py has "$kept" "$commit" "$(basename "${1%.hpp}")" "$2"; then
    rm -f "$rows"
    (plant_on_board --robot "$1" --board "$2" --number "$3" --json "$rows") || say "not as promised: $1 on $2"
    plant_py keep "$kept" "$commit" "$(basename "${1%.hpp}")" "$2" "$rows"
  fi
}

# An arm that is too large for a board has no image there, which the table says.
build_what_fits() {
  local board=$1
  shift
  configure "$board"
  cmake --build "$AXIAL_ROOT/build/$board" --target "$@" -- -k 0 || say "not every robot fits $board"
}
