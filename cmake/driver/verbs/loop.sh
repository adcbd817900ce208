# shellcheck shell=bash
# summary: closes the loop with the firmware in QEMU: tracking errors with and without feed-forward, and what spoils them
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial loop [options]
Installs and builds what is missing, starts the tracking firmware of a board in its emulator and lets it drive a plant in double, in lock-step
at 1 kHz over the serial line: feed-forward and a proportional-derivative torque, then the feedback alone (at most 10 s of it). Prints
tracking errors of the tool point, writes JSON, the CSV of the first 4 s and a picture (doc/measurements/simulation.md).
  --robot scara|puma560  default scara
  --board BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040
  --number float|fixed32  what the firmware computes in; default float
  --seconds NUMBER    of motion; default 10 (a few hundred ticks a second run in QEMU: 60 s take some minutes)
  --sweep             besides, the same sources on the host: wrong parameters, friction, coarse encoders, late torques
  --check             only: image and host, told the same, give the same torques (fixed32: bits; float: within 4 last places)
  --output FOLDER     where the files go; default output/loop
  --json FILE         the rows once more, as an array of objects
Exits non-zero when feed-forward cuts the error less than 20-fold with exact parameters, or an answer is refused.
maintainers:
  --documents         alone: 60 s of each robot with sweeps, on the nrf51 in fixed32, to doc/data, doc/pictures and the tables of
                      doc/measurements/simulation.md
END_OF_USAGE
}

run() {
  ensure_packages
  build "$HOST_PRESET" loop
  if [[ ${1:-} == --documents ]]; then
    write_loop_documents
  else
    build_board_of_loop "$@"
    loop_program "$@"
  fi
}

loop_program() { "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/loop/loop" "$@"; }

build_board_of_loop() {
  local board
  board=$(named_board "$@")
  ensure_runner "$board"
  build "$board" tracking-scara tracking-fixed-scara tracking-puma560 tracking-fixed-puma560
}

write_loop_documents() {
  local doc=$AXIAL_ROOT/doc number=fixed32 robot
  build_loop_images
  for robot in scara puma560; do
    loop_program --robot "$robot" --board "$LOOP_BOARD" --number "$number" --seconds 60 --sweep --output "$AXIAL_ROOT/output/loop" \
      --json "$doc/data/loop-$robot.json" --provenance "$doc/data/loop_provenance.json"
    cp "$AXIAL_ROOT/output/loop/loop-$robot-$number.png" "$doc/pictures/loop-$robot.png"
  done
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/plot/simulation_tables.py" "$doc/data" "$doc/measurements/simulation.md"
}
