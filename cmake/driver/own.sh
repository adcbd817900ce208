# shellcheck shell=bash
# A user's robot: a header, or the name of one in robots/. Programs and images that are about it include build/<preset>/own/robot.hpp.

# own_header HEADER|NAME: its file, of robots/ or the gallery where it is a name; nothing where there is none.
own_header() {
  local kept
  for kept in "$1" "$AXIAL_ROOT/robots/$1.hpp" "$AXIAL_ROOT"/robots/gallery/*/"$1.hpp"; do
    if [[ -f $kept ]]; then
      realpath "$kept"
      return
    fi
  done
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

# choose_program NAME ROBOT OPTION...: CHOSEN is a program of the host and the robot that it reads: NAME, and NAME-own for a header.
# shellcheck disable=SC2034 # verbs use it
choose_program() {
  CHOSEN=("$1" "$2")
  if [[ $2 == *.hpp || $2 == *.h ]]; then
    take_own_robot "$2" "$(option_of --type '' "${@:3}")"
    [[ -z $(option_of --tip '' "${@:3}") ]] || fail_usage "--tip is for a URDF; '$2' is none"
    write_own_robot "$HOST_PRESET"
    CHOSEN=("$1-own" "$OWN_HEADER")
  fi
}

# require_robot_file ROBOT: a name, or a file that is there.
require_robot_file() {
  if [[ $1 == *[./]* && ! -f $1 ]]; then fail_usage "there is no file '$1'"; fi
}

# The struct that holds the last chain, with the namespaces and structs around it.
robot_type() {
  awk '{ line = $0; sub(/\/\/.*/, "", line); gsub(/"[^"]*"/, "", line)
         while (match(line, /namespace +[A-Za-z_0-9:]+|(struct|class) +[A-Za-z_0-9]+|(static constexpr|constexpr static)( const)? auto chain|[{};]/)) {
           word = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH)
           if (word == "{") { around[++depth] = name; name = "" }
           else if (word == "}") { if (depth > 0) --depth }
           else if (word == ";") name = ""
           else if (word ~ /chain$/) {
             found = ""
             for (i = 1; i <= depth; ++i) if (around[i] != "") found = found (found == "" ? "" : "::") around[i]
           } else { sub(/^[a-z]+ +/, "", word); name = word }
         } }
       END { print found }' "$1"
}

# write_own_robot PRESET: only when something changes, so that nothing is compiled twice. The type is a name for what the header has, and
# has a name where the header gives none. A header that no compiler takes ends here.
write_own_robot() {
  local folder=$AXIAL_ROOT/build/$1/own text
  text=$(printf '#pragma once\n// Written by ./axial.\n#include "%s"\n\nnamespace axial::apps {\nstruct Robot : %s {\n  static constexpr const char* name = "%s";\n};\n}\n' \
    "$OWN_HEADER" "$OWN_TYPE" "$OWN_NAME")
  mkdir -p "$folder"
  [[ -f $folder/robot.hpp && $(<"$folder/robot.hpp") == "$text" ]] || printf '%s\n' "$text" >"$folder/robot.hpp"
  require_own_robot_compiles "$folder/robot.hpp"
}

# require_own_robot_compiles FILE: what stands wrong in the user's header is said once, not by every program that includes it: the
# compiler's errors, and which link breaks which rule of descriptions.
require_own_robot_compiles() {
  local said
  said=$(LC_ALL=C "${CXX:-g++}" -std=c++17 -fsyntax-only -w -I"$AXIAL_ROOT/firmware/include" -I"$AXIAL_ROOT" -x c++ "$1" 2>&1) && return
  if grep -q "^$1:.* error: " <<<"$said"; then fail "$OWN_HEADER: there is no struct '$OWN_TYPE' in it; name one: --type robots::MyArm"; fi
  {
    echo "axial: $OWN_HEADER does not compile:"
    sed -nE -e 's/.*call to non-.*malformed::.*Of = ([^]]*)\].*/  \1:/p' -e 's/.*< (axial: .*)/  \1/p' \
      -e '/malformed::/!s/^([^ ]+: (fatal )?error: .*)/  \1/p' <<<"$said" | head -n 6
  } >&2
  exit 1
}

# require_of_own_robot PRESET HEADER CONDITION SENTENCE: what a program of it would say when it is built, in minutes. HEADER knows the condition;
# what else a compiler may have to say comes with the program.
require_of_own_robot() {
  local said
  said=$(printf '#include "%s"\n#include <%s>\nusing axial::apps::Robot;\nstatic_assert(%s, "axial: it does not hold");\n' \
    "$AXIAL_ROOT/build/$1/own/robot.hpp" "$2" "$3" |
    "${CXX:-g++}" -std=c++17 -fsyntax-only -w -I"$AXIAL_ROOT/firmware/include" -I"$AXIAL_ROOT" -x c++ - 2>&1) && return
  ! grep -q 'axial: it does not hold' <<<"$said" || fail "$4"
}

# prepare_own_images BOARD: after take_own_robot. Images of another robot are removed, lest one that does not build now is measured.
prepare_own_images() {
  write_own_robot "$1"
  configure "$1"
  cmake --build "$AXIAL_ROOT/build/$1" --target build.ninja >/dev/null # the list of probes is as old as that
  rm -f "$AXIAL_ROOT/build/$1/probes"/own-*.elf "$AXIAL_ROOT/build/$1/probes"/empty-own*.elf
}

# build_own_images BOARD TARGET...: all that can be built; then what the compiler and the linker said of the others. False unless all
# of these are kernels that the library does not offer for joints that share drives, or for a joint that moves no mass.
build_own_images() {
  local board=$1 log=$AXIAL_ROOT/build/$1-own.log said status=0
  shift
  rm -f "$log"
  with_progress "building $# images of $OWN_NAME for $board" "$log" keep_building "$board" "$@"
  grep -q '^not all was built$' "$log" || return 0
  said=$(/usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/boards/size/refused.py" "$log") || status=1
  {
    echo "axial: not every kernel of $OWN_NAME could be built; $log has all that the compiler said:"
    echo "$said"
  } >&2
  return "$status"
}

# keep_building PRESET TARGET...: for OWN_BUILD_SECONDS at most, where that is set.
keep_building() {
  local board=$1
  shift
  timeout "${OWN_BUILD_SECONDS:-0}" cmake --build "$AXIAL_ROOT/build/$board" --parallel "$(nproc)" --target "$@" -- -k 0 || echo "not all was built"
}
