# shellcheck shell=bash
# summary: closes the loop with the firmware in QEMU: tracking errors with and without feed-forward, and what spoils them
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial loop [options]
Installs and builds what is missing, starts the tracking firmware of a board in its emulator and lets it drive a plant in double, in lock-step
at 1 kHz over the serial line: feed-forward and a proportional-derivative torque, then the feedback alone (at most 10 s of it). Prints
tracking errors of the tool point, writes JSON, the CSV of the first 4 s and a picture (doc/measurements/simulation.md).
  --robot ROBOT|DRIVEN  scara (default) or puma560; whose joints share drives, by pd: scara_quill, palletiser, wrist_arm (lqr and ekf too), gripper;
                      puma560 is the default of --controller lqr, elastic and --export
  --board BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram
  --number float|fixed32  what the firmware computes in; default float
  --controller pd|lqr|ekf|elastic  default pd. lqr: a linear-quadratic regulator whose gains the board computes from the arm's derivatives, on the stm32f405 in
                      float, brings the arm back from a push of 0.1 rad on every joint; beside pd (doc/measurements/linearisation.md).
                      elastic: an arm behind harmonic drives of 12 Hz, by the feed-forward of elastic joints beside that of rigid ones
                      (doc/measurements/elastic.md)
                      ekf: pd of what an extended Kalman filter on the board makes of noisy encoders, beside pd of their differences
  --seconds NUMBER    of motion; default 10 (a few hundred ticks a second run in QEMU: 60 s take some minutes)
  --sweep             besides, the same sources on the host: wrong parameters, friction, coarse encoders, late torques; of elastic: stiffness
  --check             only: image and host, told the same, give the same torques (fixed32: bits; float: within 4 last places)
  --export tinympc|json  instead: the arm linearised at a point of its motion, discretised, with weights and bounds, for solvers of other people:
                      a header in the layout of TinyMPC's examples, or JSON; any robot that has a cycle in host_sim/robots/trajectories
  --at NUMBER, --tick NUMBER, --horizon N, --rho NUMBER  of an export: s into the cycle (1), s of a step (0.01), stages (10), TinyMPC's penalty (1e-3)
  --output FOLDER     where the files go; default output/loop, output/lqr or output/ekf
  --json FILE         the rows once more, as an array of objects
Exits non-zero when feed-forward cuts the error less than 20-fold with exact parameters, or an answer is refused; with lqr when the arm is
not back within half a second, a torque is beyond its limit, or pd follows the motion better;
with ekf when velocities are less than ten times as exact as differences (twice where encoders count steps of drives, which are finer);
with elastic when the tool's error is not ten times below rigid feed-forward's.
maintainers:
  --documents         alone: 60 s of each robot (20 s where joints share drives) with sweeps, on the nrf51 in fixed32, to doc/data, doc/pictures and the tables of
                      doc/measurements/simulation.md
  --linearisation-documents  alone: the Puma 560 by lqr and ekf with sweeps, to doc/data, doc/pictures and doc/measurements/linearisation.md
  --elastic-documents  alone: both robots by elastic with sweeps, to doc/data and doc/measurements/elastic.md
END_OF_USAGE
}

run() {
  ensure_packages
  case "${1:-} $(option_of --controller "$(option_of --export pd "$@")" "$@")" in
    --documents*) build "$HOST_PRESET" loop && write_loop_documents ;;
    --linearisation-documents*) build "$HOST_PRESET" pushes observers && write_linearisation_documents ;;
    --elastic-documents*) build "$HOST_PRESET" elastic && write_elastic_documents ;;
    *lqr | *ekf | *elastic) regulate "$@" ;;
    *tinympc | *json) build "$HOST_PRESET" linearise && "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/loop/linearise" "$@" ;;
    *) build "$HOST_PRESET" loop && build_board_of_loop "$@" && drop_options --controller "$@" && loop_program "${ARGUMENTS[@]}" ;;
  esac
}

# The program of --controller lqr, ekf or elastic.
regulating() {
  case $1 in
    lqr) echo pushes ;;
    ekf) echo observers ;;
    *) echo elastic ;;
  esac
}

regulate() {
  local name
  name=$(option_of --controller '' "$@")
  build "$HOST_PRESET" "$(regulating "$name")"
  build_regulators "$name" "$(option_of --robot puma560 "$@")"
  drop_options --controller "$@"
  regulating_program "$name" "${ARGUMENTS[@]}"
}

regulating_program() {
  local name=$1
  shift
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/loop/$(regulating "$name")" "$@"
}

build_regulators() {
  if [[ ${1:-} == elastic ]]; then
    build stm32f405 elastic-scara elastic-puma560
  elif [[ ${2:-} == wrist_arm ]]; then # built only when asked for
    build stm32f405 {lqr,ekf,tracking}-wrist_arm
  else
    build stm32f405 {lqr,ekf}-{scara,puma560} tracking-scara tracking-puma560
  fi
}

loop_program() { "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/loop/loop" "$@"; }

build_board_of_loop() {
  local board robot
  board=$(named_board "$@")
  ensure_runner "$board"
  robot=$(option_of --robot scara "$@")
  build "$board" tracking-scara tracking-fixed-scara tracking-puma560 tracking-fixed-puma560
  case $robot in # built only when asked for
    scara_quill | palletiser | wrist_arm | gripper) build "$board" "tracking-$robot" "tracking-fixed-$robot" ;;
  esac
}

write_loop_documents() {
  local doc=$AXIAL_ROOT/doc number=fixed32 robot
  build_loop_images
  for robot in scara puma560; do
    loop_program --robot "$robot" --board "$LOOP_BOARD" --number "$number" --seconds 60 --sweep --output "$AXIAL_ROOT/output/loop" \
      --json "$doc/data/loop-$robot.json" --provenance "$doc/data/loop_provenance.json"
    cp "$AXIAL_ROOT/output/loop/loop-$robot-$number.png" "$doc/pictures/loop-$robot.png"
  done
  for robot in scara_quill palletiser; do
    build "$LOOP_BOARD" "tracking-fixed-$robot"
    loop_program --robot "$robot" --board "$LOOP_BOARD" --number "$number" --seconds 20 --sweep --output "$AXIAL_ROOT/output/loop" \
      --json "$doc/data/loop-$robot.json" --provenance "$doc/data/driven_loop_provenance.json"
  done
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/simulation_tables.py" "$doc/data" "$doc/measurements/simulation.md"
}

write_linearisation_documents() {
  local doc=$AXIAL_ROOT/doc
  build_regulators
  regulating_program lqr --robot puma560 --seconds 10 --sweep --output "$AXIAL_ROOT/output/lqr" --json "$doc/data/lqr-puma560.json" \
    --provenance "$doc/data/linearisation_provenance.json"
  regulating_program ekf --robot puma560 --seconds 10 --sweep --output "$AXIAL_ROOT/output/ekf" --json "$doc/data/ekf-puma560.json"
  cp "$AXIAL_ROOT/output/lqr/lqr-puma560.png" "$AXIAL_ROOT/output/ekf/ekf-puma560.png" "$doc/pictures"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/linearisation_tables.py" "$doc/data" "$doc/measurements/linearisation.md"
}

write_elastic_documents() {
  local doc=$AXIAL_ROOT/doc robot
  build_regulators elastic
  for robot in puma560 scara; do
    regulating_program elastic --robot "$robot" --sweep --output "$AXIAL_ROOT/output/elastic" --json "$doc/data/elastic-$robot.json" \
      --provenance "$doc/data/elastic_provenance.json"
  done
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/elastic_tables.py" "$doc/data" "$doc/measurements/elastic.md"
}
