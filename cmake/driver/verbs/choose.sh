# shellcheck shell=bash
# summary: which kernel to take inside an error or an instruction or byte budget, with the line of code that selects it
# group: use

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial choose --robot ROBOT --board BOARD [options]
From the data of the report (doc/data/work_precision.json), without building anything; of a header from an image of each way on that board
and its errors on this machine, which takes a minute: the cheapest configuration inside an error,
the most exact one inside a budget, their runners-up, and the lines of code that select them. Without --error and --budget: the
Pareto front.
  --robot ROBOT|HEADER  a robot of the report, or a header (./axial import, your own) that declares limits
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --board ANY_BOARD   of the report; of a header any
  --algorithm NAME    inverse_dynamics (default; closed form and separation are among its ways), forward_dynamics, mass_matrix,
                      gravity, bias, forward_kinematics, jacobian, inverse_dynamics_derivatives or
                      forward_dynamics_derivatives
  --error NUMBER      largest error relative to the joint's largest value, for example 1e-4
  --budget NUMBER     at most so many instructions, or bytes
  --unit instructions|bytes  default instructions; bytes are flash, static RAM and stack
  --torque            of forward dynamics: the error as the torque that it stands for
  --pairs             sine-cosine pairs come from the caller (an encoder table, a CORDIC)
  --json FILE         the choices once more, as an array of objects
  --verify            builds and runs what was chosen: its lines compile, its error, instructions and bytes are those that were promised
Exits with 1 when nothing is inside (and says what is nearest) or a promise does not hold, with 2 for an unknown name.
END_OF_USAGE
}

run() {
  local robot board argument verify=
  robot=$(option_of --robot '' "$@")
  board=$(option_of --board '' "$@")
  [[ -n $robot && -n $board ]] || fail_usage "name --robot and --board; see ./axial choose --help"
  for argument in "$@"; do
    [[ $argument == --verify ]] && verify=yes
  done
  if [[ ! -f $AXIAL_ROOT/host_sim/robots/trajectories/$robot.json ]]; then
    [[ -z $verify ]] || fail_usage "--verify is of the report's robots: a header is measured anew each time"
    choose_own "$robot" "$board" "$@"
    return
  fi
  [[ -z $verify ]] || build_chosen "$@"
  choose_py "$@"
}

choose_py() {
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/report/choose.py" --host "$AXIAL_ROOT/build/$HOST_PRESET" "$@"
}

# The probes and the host's program of what is chosen: a line each, "preset target...".
build_chosen() {
  local lines preset targets
  lines=$(choose_py --targets "$@") || exit
  ensure_packages
  while read -r preset targets; do
    ensure_runner "$preset"
    read -ra targets <<<"$targets"
    build "$preset" "${targets[@]}"
  done <<<"$lines"
}

# choose_own HEADER BOARD OPTION...
choose_own() {
  local header=$1 board=$2 algorithm targets rows
  shift 2
  take_own_robot "$header" "$(option_of --type '' "$@")"
  algorithm=$(option_of --algorithm inverse_dynamics "$@")
  ensure_packages
  ensure_runner "$board"
  prepare_own_images "$board"
  write_own_robot "$HOST_PRESET"
  targets=$(own_py targets "$board" "$algorithm") || exit 2
  read -ra targets <<<"$targets"
  build_own_images "$board" "${targets[@]}"
  build "$HOST_PRESET" "errors-own_$algorithm"
  rows=$(mktemp)
  own_py rows "$board" "$algorithm" "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/errors/errors-own_$algorithm" "$rows"
  drop_options "--robot --type" "$@"
  choose_py --robot own --type "$OWN_TYPE" --header "$OWN_HEADER" --data "$rows" "${ARGUMENTS[@]}"
  rm -f "$rows"
}

own_py() { /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/figures/report/own.py" "$@"; }
