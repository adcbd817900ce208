# shellcheck shell=bash
# summary: finds wrong torque scales, signs, axes, zeros and tilted tables from held poses
# group: use, rare

readonly COMMISSION_PACKAGES=(python3-scipy) # least squares

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial commission ROBOT POSES.csv [options]
Installs and builds what is missing (python3-scipy, the first time). From static poses, each approached from both sides, once bare and once
with a known mass at the tool: every drive's torque scale, sign and offset, joint zero and friction; gravity's direction (a tilted table);
exchanged drives, turned axes. Says how sure each is and what the poses cannot tell (doc/guides/commissioning.md). Exit status 1 where the
data is not explained, or something is wrong that no header mends.
Where joints share drives, positions, torques and faults are the drives'.
  ROBOT               a header (./axial import, your own), a name of robots/README.md, a Denavit-Hartenberg table (.json) or a URDF
  POSES.csv           a header line, then a row a hold: mass (kg at the tool, 0: bare), side (+1 or -1: whether positions grew or fell before
                      it came to rest; or side1, side2, ... joint by joint), q1... (rad or m), tau1... (N m or N, as reported)
  -o FILE             the mended header; with --suggest the poses, default poses.csv
  --suggest           chooses poses inside the limits that tell most (D-optimal) and writes the CSV to fill in
  --mass NUMBER       kg at the tool, for --suggest
  --poses N           how many, for --suggest; default 12
  --seed N            other candidates, for --suggest; default 1
  --at X,Y,Z          where the mass is, metres in the tool's axes; default 0,0,0
  --type NAME         of a header: the robot's struct; default: the one that holds its last chain
  --tip LINK          where the chain of a URDF ends; default: every branch
  --residual-limit NUMBER  % of a joint's RMS torque that may stay unexplained; default 10
  --output FOLDER     report and picture; default output/commission
  --json FILE         the report once more, as an array of objects
maintainers:
  --documents         alone: thirty simulated arms by Orocos KDL, sixty logs without a fault and sixty with one, to doc/data, doc/pictures and
                      doc/measurements/commissioned_arms.md (some minutes)
END_OF_USAGE
}

run() {
  (($#)) || fail_usage "which robot, which poses? see ./axial commission --help"
  if [[ $1 == --documents ]]; then
    ensure_packages "${COMMISSION_PACKAGES[@]}"
    write_commissioning_documents
    return
  fi
  if [[ $1 == -* ]]; then fail_usage "the robot comes first: a header, a name, a table or a URDF; see ./axial commission --help"; fi
  require_robot_file "$1"
  ensure_packages "${COMMISSION_PACKAGES[@]}"
  choose_program gravity_parts "$@"
  drop_options "--type" "${@:2}"
  build "$HOST_PRESET" "${CHOSEN[0]}" >&2
  commissioning commissioning/commission.py "${CHOSEN[@]}" "${ARGUMENTS[@]}"
}

# commissioning SCRIPT PROGRAM ARGUMENT...: matrices here are small: threads of the linear algebra would only wait for each other.
commissioning() {
  OPENBLAS_NUM_THREADS=1 /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/robots/$1" \
    --program "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/robots/commissioning/$2" "${@:3}"
}

write_commissioning_documents() {
  local doc=$AXIAL_ROOT/doc
  build "$HOST_PRESET" gravity_parts
  build "$HOST_PRESET" simulated_log
  commissioning commissioning/study.py gravity_parts --simulator "$AXIAL_ROOT/build/$HOST_PRESET/tests/host_sim/simulated_log" \
    --output "$AXIAL_ROOT/output/commissioning" --documents "$doc"
  commissioning verdicts/accusations.py gravity_parts --output "$AXIAL_ROOT/output/accusations" --documents "$doc"
  printf '{"commit": "%s", "compiler": "%s", "libraries": "%s"}\n' "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" \
    "$(c++ --version | head -n 1)" "$(/usr/bin/python3 -E -c 'import numpy, scipy; print("NumPy", numpy.__version__ + ", SciPy", scipy.__version__)')" \
    | tee "$doc/data/accusations_provenance.json" >"$doc/data/commissioning_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/commissioning_tables.py" "$doc/data" "$doc/measurements/commissioned_arms.md"
}
