# shellcheck shell=bash
# summary: fits a robot's inertial parameters and friction to recorded motion, writes its header
# group: use

. "$DRIVER/identification.sh"

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial identify LOG.csv --robot NAME [options]
Installs and builds what is missing (python3-scipy, the first time). Fits base parameters to a log by weighted least squares, finds
physically consistent parameters of every link that have them, and says how sure each is (doc/guides/identification.md).
  LOG.csv             a header line, then time (s), q1... (rad or m), tau1... (N m or N, of the drives, on the joint's side) and, if they
                      were measured, qd1...; other columns are ignored. Even steps, 100 Hz or more; ./axial excite makes motions.
                      Where joints share drives, columns are the drives'
  --robot NAME        what it starts from: a name of robots/README.md, a header (of ./axial import, your own), a
                      Denavit-Hartenberg table (.json, host_sim/robots/description) or a URDF
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --tip LINK          where the chain of a URDF ends; default: every branch
  -o HEADER.hpp       writes the identified robot; the file's name becomes its name
  --validate IN_FILE  a second log, which the parameters must predict
  --cutoff NUMBER       of the zero-phase low-pass; default 10 Hz or a tenth of the log's rate; 0: none
  --residual-limit NUMBER  % of a joint's RMS torque that may stay unexplained, here and in the second log; default 5. Above it no header
                      is written, the exit status is 1, and exchanged columns, signs, zeros, scales and units of each joint are tried
                      for the one that mends it
  --torque-scale NUMBER  that torques are divided by: 1000 for N mm. Where it is given the units are taken for right; where not, torques
                      of 30 times what the description says, or of a 30th, are refused
  --keep rotors|friction  as the robot has them, not fitted; may stand twice
  --output FOLDER     report, predicted torques and picture; default output/identify
  --json FILE         the report once more, as an array of objects
maintainers:
  --documents         alone: identifies altered arms from logs that Orocos KDL made, to doc/data, doc/pictures and the tables of
                      doc/measurements/identified_arms.md (some minutes)
END_OF_USAGE
}

run() {
  (($#)) || fail_usage "which log? see ./axial identify --help"
  if [[ $1 == --documents ]]; then
    ensure_identification_packages
    build "$HOST_PRESET" robot_regressor
    write_identification_documents
  else
    of_own_or_named_robot identify.py "$@"
  fi
}

write_identification_documents() {
  local doc=$AXIAL_ROOT/doc
  build "$HOST_PRESET" simulated_log
  identification identification/study.py robot_regressor --simulator "$AXIAL_ROOT/build/$HOST_PRESET/tests/host_sim/simulated_log" \
    --output "$AXIAL_ROOT/output/identification" --documents "$doc"
  identification verdicts/verdicts.py robot_regressor --output "$AXIAL_ROOT/output/verdicts" --documents "$doc"
  printf '{"commit": "%s", "compiler": "%s", "libraries": "%s"}\n' "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" \
    "$(c++ --version | head -n 1)" "$(/usr/bin/python3 -E -c 'import numpy, scipy; print("NumPy", numpy.__version__ + ", SciPy", scipy.__version__)')" \
    | tee "$doc/data/identification_verdicts_provenance.json" >"$doc/data/identification_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/identification_tables.py" "$doc/data" "$doc/measurements/identified_arms.md"
}
