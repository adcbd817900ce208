# shellcheck shell=bash
# summary: motions to record for ./axial identify: Fourier series inside the robot's limits
# group: use, rare

readonly IDENTIFICATION_PACKAGES=(python3-scipy) # filters, decompositions, optimisation

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial excite --robot NAME [options]
Installs and builds what is missing (python3-scipy, the first time). Optimises Fourier series for the condition number of the regressor,
inside the limits of position, speed, acceleration and, by the robot's own parameters, torque; at rest at both ends. Writes set-points
(time, q, qd, qdd), which ./axial demo --trajectory takes too, and a picture. Where joints share drives, they are
the drives'. The same options give the same motion (doc/guides/identification.md).
  --robot NAME        a name of robots/README.md, a Denavit-Hartenberg table (.json,
                      host_sim/description) or a URDF
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
  ensure_packages "${IDENTIFICATION_PACKAGES[@]}"
  build "$HOST_PRESET" robot_regressor
  # Matrices here are small: threads of the linear algebra would only wait for each other.
  OPENBLAS_NUM_THREADS=1 /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/identification/excite.py" \
    --program "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/identification/robot_regressor" "$@"
}
