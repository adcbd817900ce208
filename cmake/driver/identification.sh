# shellcheck shell=bash
# What ./axial identify and ./axial excite share.

ensure_identification_packages() { ensure_packages python3-scipy; } # filters, decompositions, optimisation

# of_own_or_named_robot SCRIPT OPTION...: with the program that knows the robot of --robot.
of_own_or_named_robot() {
  local script=$1 robot
  shift
  robot=$(option_of --robot '' "$@")
  [[ -n $robot ]] || fail_usage "which robot? --robot; see ./axial ${script%.py} --help"
  require_robot_file "$robot"
  ensure_identification_packages
  choose_program robot_regressor "$robot" "$@"
  drop_options "--robot --type" "$@"
  build "$HOST_PRESET" "${CHOSEN[0]}"
  identification "identification/$script" "${CHOSEN[0]}" --robot "${CHOSEN[1]}" "${ARGUMENTS[@]}"
}

# identification SCRIPT PROGRAM ARGUMENT...: matrices here are small: threads of the linear algebra would only wait for each other.
identification() {
  OPENBLAS_NUM_THREADS=1 /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/robots/$1" \
    --program "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/robots/identification/$2" "${@:3}"
}
