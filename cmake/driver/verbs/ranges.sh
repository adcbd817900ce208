# shellcheck shell=bash
# summary: bounds, formats and certified errors of fixed point: every quantity of every link

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial ranges [options]
Installs and builds what is missing. Prints for every quantity of every link what bounds it inside the robot's declared
limits, the exponent that fixed point keeps it with, and the certified error: how far the computed quantity can be from
the exact one. That of a joint's effort is the error of the result. Of the bare robot: gravity, and rotors where it has them.
  --robot NAME        only this robot
  --algorithm NAME    inverse_dynamics (default), forward_dynamics (its articulated bodies; the bias is inverse_dynamics),
                      forward_dynamics_classical, mass_matrix, forward_kinematics
  --word BITS         16 or 32 (default)
  --rounding NAME     nearest (default) or down
  --multiply NAME     exact (default) or high_word: upper words of products
  --json FILE         the rows as an array of objects
END_OF_USAGE
}

run() {
  ensure_packages
  build host-release ranges >&2
  "$AXIAL_ROOT/build/host-release/host_sim/ranges/ranges" "$@"
}
