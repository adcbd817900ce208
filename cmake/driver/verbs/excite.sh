# shellcheck shell=bash
# summary: motions to record for ./axial identify: Fourier series inside the robot's limits
# group: use, rare

. "$DRIVER/identification.sh"

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial excite --robot NAME [options]
Installs and builds what is missing (python3-scipy, the first time). Optimises Fourier series for the condition number of the regressor,
inside the limits of position, speed, acceleration and, by the robot's own parameters, torque; at rest at both ends. Writes set-points
(time, q, qd, qdd), which ./axial demo --trajectory takes too, and a picture. Where joints share drives, they are
the drives'. The same options give the same motion (doc/guides/identification.md).
  --robot NAME        a name of robots/README.md, a header (of ./axial import, your own), a
                      Denavit-Hartenberg table (.json, host_sim/robots/description) or a URDF
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --tip LINK          where the chain of a URDF ends; default: every branch
  -o FILE.csv         default excitation.csv
  --duration NUMBER      of the motion, one period; default 10
  --rate NUMBER         of the set-points; default 1000
  --harmonics N       default 8
  --rounds N          of the optimisation; default 20; 0: the best of 60 random motions
  --seed N            another motion; default 1
  --json FILE         peaks over limits and condition numbers, an array of objects
END_OF_USAGE
}

run() {
  of_own_or_named_robot excite.py "$@"
}
