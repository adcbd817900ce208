# shellcheck shell=bash
# summary: which kernel to take inside an error or an instruction or byte budget, with the line of code that selects it

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial choose --robot NAME --board NAME [options]
From the data of the report (doc/data/work_precision.json), without building anything: the cheapest configuration inside an error,
the most exact one inside a budget, their runners-up, and the lines of code that select them. Without --error and --budget: the
Pareto front.
  --algorithm NAME    inverse_dynamics (default; closed form and separation are among its ways), forward_dynamics, mass_matrix,
                      gravity, bias, forward_kinematics or jacobian
  --error E           largest error relative to the joint's largest value, for example 1e-4
  --budget N          at most so many instructions, or bytes
  --unit UNIT         instructions (default) or bytes (flash, static RAM and stack)
  --torque            of forward dynamics: the error as the torque that it stands for
  --pairs             sine-cosine pairs come from the caller (an encoder table, a CORDIC)
  --json FILE         the choices once more, as an array of objects
  --verify            builds and runs what was chosen: its lines compile, its error, instructions and bytes are those that were promised
Exits with 1 when nothing is inside (and says what is nearest) or a promise does not hold, with 2 for an unknown name.
END_OF_USAGE
}

run() {
  local argument verify=
  for argument in "$@"; do
    [[ $argument == --verify ]] && verify=yes
  done
  [[ -z $verify ]] || build_chosen "$@"
  choose_py "$@"
}

choose_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/report/choose.py" "$@"; }

# The probes and the host's program of what is chosen: a line each, "preset target...".
build_chosen() {
  local lines preset targets
  ensure_packages
  lines=$(choose_py --targets "$@") || exit
  while read -r preset targets; do
    read -ra targets <<<"$targets"
    build "$preset" "${targets[@]}"
  done <<<"$lines"
}
