# shellcheck shell=bash
# summary: a URDF, an MJCF, an SDF or a Denavit-Hartenberg table as a verified constexpr header
# group: use

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial import FILE [options]
       ./axial import --documents
Installs and builds what is missing, reads a URDF (any chain or tree of revolute, continuous, prismatic and fixed joints), an MJCF (hinges and
slides; a free joint is a base that floats), an SDF (revolute, continuous, prismatic, fixed; by libsdformat) or a JSON table of Denavit-Hartenberg rows, classical or modified (format:
host_sim/robots/description/README.md), turns it into MDH rows, verifies poses, torques and mass matrix against Orocos KDL on random
states, an MJCF against MuJoCo itself too, an SDF against DART, and writes a header with source, assumptions, warnings and the figures in its comment.
Numbers that are read as others than they are written are counted, and listed by --json. Mimic joints and transmissions of a URDF become joints that share drives.
A xacro file is expanded by the program xacro where that is installed. Of a header that is there, lines that end in "// kept" stay.
  --root LINK         where the chain starts; default: the file's root
  --tip LINK          where it ends, the tool's frame, a site or <frame> too; joints beside the chain are held at 0. Default: every branch (a tree)
  --name NAME         of the robot; default: the file's
  -o, --output FILE   the header; default <name>.hpp
  --json FILE         figures, assumptions and warnings once more
  --gravity NUMBER NUMBER NUMBER  m/s^2 in axes of the root link; default: an MJCF's or an SDF's, or 0 0 -9.81
  --right-angles NUMBER  rad: an angle or an axis this near to a special one is that one, and lengths finer than the
                      file's digits are 0 or what they nearly are; default 1e-5, 0 reads what is written
  --to-speed NUMBER   acceleration limits that are missing reach full speed in this time; default 0.25
  --position-limit, --speed-limit, --effort-limit NUMBER  where a joint has none, or 0 is written: rad, m either way; a
                      second; N m, N; default a turn or 1 m, half a turn or 1 m/s, none
  --hold-mimic        holds joints that mimic another one where that one is 0, and carries their bodies along
  --snap              makes joints' angles and axes exact that are within 0.005 rad of a multiple of 90 degrees
  --states N, --seed N  random states to verify on; default 100, 1
  --as-published      keeps inertias, lengths and limits that no robot should have: .accept(axial::as_published)
  --without-engine    does not fetch MuJoCo for an MJCF (11 MB, once), nor DART for an SDF (145 packages), nor ask it
  --strict            writes nothing where there are warnings
Exits with 1 and says link, value and remedy when a description cannot be used or the figures miss their bounds (poses 1e-12, torques
and mass matrix 1e-9 relative, bodies 1e-11; DART and MuJoCo 1e-9, 1e-6 where it diagonalises an inertia); warnings (no inertia, triangle inequality violated, ...) go to stderr and into the header.
maintainers:
  --documents         alone: imports tests/data/descriptions, writes doc/data/import.json and the table of doc/measurements/imported.md
END_OF_USAGE
}

run() {
  (($#)) || fail_usage "name a URDF, an MJCF, an SDF or a table; see ./axial import --help"
  build_import "$@"
  if [[ $1 == --documents ]]; then
    /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/robots/import/measured/catalogue.py" "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/robots/import/import" \
      "$AXIAL_ROOT/tests/data/descriptions" "$AXIAL_ROOT/doc/data" "$AXIAL_ROOT/doc/measurements/imported.md"
    return
  fi
  import_expanded "$@"
}

# Options after FILE, or before it: only the file that is xacro changes. It keeps its name, which the header tells.
import_expanded() {
  local arguments=() engine=$AXIAL_ROOT/build/mujoco-js-$MUJOCO_VERSION argument folder='' i status=0
  local dart=$AXIAL_ROOT/build/$HOST_PRESET/host_sim/robots/import/dart_engine
  for argument; do
    if [[ $argument == --without-engine ]]; then engine=''; else arguments+=("$argument"); fi
  done
  for i in "${!arguments[@]}"; do
    if [[ -n $engine ]] && is_mjcf "${arguments[i]}" && ensure_mujoco "$engine"; then
      arguments+=(--engine "$engine/package")
    elif [[ -n $engine && -x $dart ]] && is_sdf "${arguments[i]}"; then
      arguments+=(--engine "$dart")
    fi
    is_xacro "${arguments[i]}" || continue
    folder=$(mktemp -d)
    expand_xacro "${arguments[i]}" "$folder/$(basename "${arguments[i]}")"
    arguments[i]=$folder/$(basename "${arguments[i]}")
    break
  done
  "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/robots/import/import" "${arguments[@]}" || status=$?
  [[ -z $folder ]] || rm -r "$folder"
  return "$status"
}

# Whether a file holds what only xacro understands, and there is a xacro. Without one the importer says what to do.
is_xacro() { [[ $1 != -* && -f $1 ]] && command -v xacro >/dev/null && grep -qE '<xacro:|\$\{|\$\(' "$1"; }

# A URDF may have an element of that name below its robot.
is_mjcf() { [[ $1 != -* && -f $1 ]] && grep -q '<mujoco[ >]' "$1" && ! grep -q '<robot' "$1"; }

expand_xacro() {
  xacro "$1" >"$2" || fail "$1: xacro refuses it"
  say "$1 was expanded by $(command -v xacro)"
}

is_sdf() { [[ $1 != -* && -f $1 ]] && grep -q '<sdf[ >]' "$1" && ! grep -qE '<(robot|mujoco)[ >]' "$1"; }

# build_import [FILE or option...]: an SDF wants more, which may not be had; the importer says then what is missing.
build_import() {
  local argument packages=() found=(AXIAL_URDFDOM_INCLUDE)
  ensure_packages
  for argument; do
    if is_sdf "$argument"; then packages=(libsdformat-dev) found+=(sdformat12_DIR); fi
  done
  if ((${#packages[@]})) && [[ " $* " != *" --without-engine "* ]]; then packages+=(libdart-dev) found+=(DART_DIR); fi
  if ((${#packages[@]})); then (ensure_packages "${packages[@]}") || true; fi
  look_again "$HOST_PRESET" "${found[@]}"
  build "$HOST_PRESET" import >&2
  if ((${#packages[@]} > 1)) && was_found "$HOST_PRESET" sdformat12_DIR && was_found "$HOST_PRESET" DART_DIR; then
    build "$HOST_PRESET" dart_engine >&2
  fi
}
