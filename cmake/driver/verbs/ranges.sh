# shellcheck shell=bash
# summary: bounds, formats and certified errors of fixed point: every quantity of every link
# group: measure

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial ranges [options]
Installs and builds what is missing. Prints for every quantity of every link what bounds it inside the robot's declared
limits, the exponent that fixed point keeps it with, and the certified error: how far the computed quantity can be from
the exact one. That of a joint's effort is the error of the result; of joints that share drives, that of a drive's effort, which stands after the
links, at the one that owns the drive. Of the bare robot: gravity, and rotors where it has them.
  --robot MODEL|HEADER  only this robot; or the robot of a header (./axial import, your own), which must declare limits
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --algorithm inverse_dynamics|forward_dynamics|forward_dynamics_classical|mass_matrix|forward_kinematics
                      default inverse_dynamics; forward_dynamics (its articulated bodies; the bias is inverse_dynamics)
  --word 16|32        default 32
  --rounding nearest|down  default nearest
  --multiply exact|high_word  default exact; high_word: upper words of products
  --json FILE         the rows as an array of objects
END_OF_USAGE
}

run() {
  local robot program=ranges
  robot=$(option_of --robot '' "$@")
  ARGUMENTS=("$@")
  if [[ -n $robot ]] && ! is_built_in "$robot"; then
    take_own_robot "$robot" "$(option_of --type '' "$@")"
    write_own_robot "$HOST_PRESET"
    drop_options "--robot --type" "$@"
    program=ranges-own
  fi
  ensure_packages
  build "$HOST_PRESET" "$program" >&2
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/ranges/$program" "${ARGUMENTS[@]}"
}

# is_built_in NAME: whether the program of all robots has it.
is_built_in() {
  local header=$AXIAL_ROOT/robots/$1.hpp type
  [[ -f $header ]] || return 1
  type=$(robot_type "$header")
  grep -q "^set(robots .*\b${type#robots::}\b" "$AXIAL_ROOT/host_sim/figures/ranges/CMakeLists.txt"
}
