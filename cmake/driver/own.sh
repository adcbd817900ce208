# shellcheck shell=bash
# A user's robot: a header, or the name of one in robots/. Programs and images that are about it include build/<preset>/own/robot.hpp.

# own_header HEADER|NAME: its file; nothing where there is none.
own_header() {
  if [[ -f $1 ]]; then
    realpath "$1"
  elif [[ -f $AXIAL_ROOT/robots/$1.hpp ]]; then
    echo "$AXIAL_ROOT/robots/$1.hpp"
  fi
}

# take_own_robot HEADER|NAME [TYPE]: sets OWN_HEADER, OWN_TYPE and OWN_NAME, or says what is missing.
take_own_robot() {
  OWN_HEADER=$(own_header "$1")
  [[ -n $OWN_HEADER ]] || fail_usage "there is no header '$1', and no robot called so; ./axial import writes a header"
  OWN_TYPE=${2:-$(robot_type "$OWN_HEADER")}
  [[ -n $OWN_TYPE ]] || fail_usage "$1: no struct with 'static constexpr auto chain' was found; name it: --type robots::MyArm"
  OWN_NAME=$(sed -n 's/.*const char\* name = "\([a-zA-Z0-9_]*\)".*/\1/p' "$OWN_HEADER" | head -n 1)
  OWN_NAME=${OWN_NAME:-$(basename "${OWN_HEADER%.*}")}
}

# The last struct before the last chain, in the namespace that is open there.
robot_type() {
  awk '/^namespace [a-z_:]+ *\{/ { space = $2 "::" }
       /^(struct|class) [A-Za-z_0-9]+/ { name = $2 }
       /static constexpr auto chain/ { found = space name }
       END { print found }' "$1"
}

# write_own_robot PRESET: only when something changes, so that nothing is compiled twice. The type is a name for what the header has, and
# has a name where the header gives none.
write_own_robot() {
  local folder=$AXIAL_ROOT/build/$1/own text
  text=$(printf '#pragma once\n// Written by ./axial.\n#include "%s"\n\nnamespace axial::apps {\nstruct Robot : %s {\n  static constexpr const char* name = "%s";\n};\n}\n' \
    "$OWN_HEADER" "$OWN_TYPE" "$OWN_NAME")
  mkdir -p "$folder"
  [[ -f $folder/robot.hpp && $(<"$folder/robot.hpp") == "$text" ]] || printf '%s\n' "$text" >"$folder/robot.hpp"
}

# prepare_own_images BOARD: after take_own_robot. Images of another robot are removed, lest one that does not build now is measured.
prepare_own_images() {
  write_own_robot "$1"
  configure "$1"
  cmake --build "$AXIAL_ROOT/build/$1" --target build.ninja >/dev/null # the list of probes is as old as that
  rm -f "$AXIAL_ROOT/build/$1/probes"/own-*.elf "$AXIAL_ROOT/build/$1/probes"/empty-own*.elf
}

# build_own_images BOARD TARGET...: all that can be built; then what the compiler and the linker said of the others. False unless all
# of these are kernels that the library does not offer for joints that share drives.
build_own_images() {
  local board=$1 log=$AXIAL_ROOT/build/$1-own.log said status=0
  shift
  rm -f "$log"
  with_progress "building $# images of $OWN_NAME for $board" "$log" keep_building "$board" "$@"
  grep -q '^not all was built$' "$log" || return 0
  said=$(/usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/size/refused.py" "$log") || status=1
  {
    echo "axial: not every kernel of $OWN_NAME could be built; $log has all that the compiler said:"
    echo "$said"
  } >&2
  return "$status"
}

keep_building() {
  local board=$1
  shift
  cmake --build "$AXIAL_ROOT/build/$board" --parallel "$(nproc)" --target "$@" -- -k 0 || echo "not all was built"
}
