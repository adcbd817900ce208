#!/usr/bin/env bash
# Tests of ./axial that install, build and run nothing. usage: driver_test.sh CASE
set -uo pipefail
AXIAL=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/axial

fail() { echo "$*" >&2; exit 1; }

# expect STATUS COMMAND...: runs it; its output is in $out, its messages in $err
expect() {
  local wanted=$1 status errors
  shift
  errors=$(mktemp)
  out=$("$@" 2>"$errors" </dev/null)
  status=$?
  err=$(<"$errors")
  rm -f "$errors"
  ((status == wanted)) || fail "$*: exit status $status, expected $wanted; $out $err"
}

# verbs: the names of all
verbs() {
  local file
  for file in "$(dirname "$AXIAL")"/cmake/driver/verbs/*.sh; do basename "$file" .sh; done
}

HelpShowsAtMostFourteenVerbs() {
  expect 0 "$AXIAL" help
  local group count
  for group in use measure maintain; do
    grep -q "^$group:$" <<<"$out" || fail "no group $group in: $out"
  done
  count=$(grep -cE '^  [a-z]' <<<"$out")
  ((count >= 10 && count <= 14)) || fail "$count verbs"
}

HelpNamesEveryVerb() {
  expect 0 "$AXIAL" help --all
  local verb
  for verb in $(verbs); do
    grep -qE "^  $verb +[a-z]" <<<"$out" || fail "no line for $verb in: $out"
  done
}

NoVerbShowsHelp() {
  expect 0 "$AXIAL"
  [[ $out == *usage:* ]] || fail "no usage"
}

EveryVerbHasHelp() {
  local verb
  for verb in $(verbs); do
    expect 0 "$AXIAL" "$verb" --help
    [[ $out == "usage: ./axial $verb"* ]] || fail "$verb --help says: $out"
  done
}

HelpIsAskedForBehindOtherWords() {
  expect 0 "$AXIAL" import arm.urdf --tip wrist --help
  [[ $out == "usage: ./axial import"* && $out != *"For maintainers:"* ]] || fail "said: $out"
  expect 0 "$AXIAL" size --scene puma560 -h --all
  [[ $out == "usage: ./axial size"* && $out == *"For maintainers:"* ]] || fail "said: $out"
}

MaintainersOptionsAreHidden() {
  local verb
  for verb in $(verbs); do
    expect 0 "$AXIAL" "$verb" --help
    ! grep -qE '^ +--(documents|update-|on-board)' <<<"$out" || fail "$verb --help shows: $out"
  done
  expect 0 "$AXIAL" size --help --all
  [[ $out == *--update-budgets* && $out == *--documents* ]] || fail "said: $out"
}

UnknownVerbIsRefused() {
  for verb in dance ../build 'demo test' -x; do
    expect 2 "$AXIAL" "$verb"
    [[ -z $out && $err == *"unknown verb '$verb'"* ]] || fail "said: $out $err"
  done
}

# expect_refused TEXT COMMAND...: with status 2 and TEXT, where no program but those that read text is on the PATH: nothing can be
# installed or built.
expect_refused() {
  local text=$1 folder tool
  shift
  folder=$(mktemp -d)
  for tool in bash env dirname basename sed cat sort awk head realpath grep; do ln -s "$(command -v $tool)" "$folder/$tool"; done
  expect 2 env PATH="$folder" bash "$AXIAL" "$@"
  rm -rf "$folder"
  [[ -z $out && $err == *"$text"* ]] || fail "$*: said: $out $err"
}

OptionsAreCheckedBeforeAnythingIsBuilt() {
  local verb
  for verb in $(verbs); do
    expect_refused "unknown option '--no-such-option'" "$verb" --no-such-option
  done
  expect_refused "--json needs a value" demo --json
  expect_refused "--documents stands alone" counts --documents --json x
  expect_refused "unknown argument 'all'" test all
}

# A header that no compiler takes is said by its own error, before anything is built.
HeadersThatDoNotCompileAreSaid() {
  local folder verb
  folder=$(mktemp -d)
  header() { sed "$1" "$(dirname "$AXIAL")/tests/driver/two_links.hpp" >"$folder/arm.hpp"; }
  require() { bash -c 'set -euo pipefail; AXIAL_ROOT=$1; . "$1/cmake/driver/progress.sh"; . "$1/cmake/driver/own.sh"
    mkdir -p "$2/build"; take_own_robot "$2/arm.hpp" "${3:-}"; AXIAL_ROOT=$2; mkdir -p "$2/firmware"
    ln -sfn "$1/firmware/include" "$2/firmware/include"; write_own_robot preset' - "$(dirname "$AXIAL")" "$folder" "${1:-}"; }
  header ''
  expect 0 require
  header 's/mass(/wieght(/'
  expect 1 require
  [[ $err == *"arm.hpp does not compile:"*"error: "*"wieght"* && $(wc -l <<<"$err") -le 7 ]] || fail "said: $err"
  header '0,/mass(/s/mass([^)]*)/mass(-1.0)/'
  expect 1 require
  [[ $err == *"link_index<0>:"*"axial: the mass of a link is negative"* && $(wc -l <<<"$err") -le 4 ]] || fail "said: $err"
  header ''
  expect 1 require Nobody
  [[ $err == *"there is no struct 'Nobody' in it"* ]] || fail "said: $err"
  rm -rf "$folder"
}

# What a header's Mechanics do not name is said before an hour is built for it.
LoadsThatNobodyTakesAreSaid() {
  local folder
  folder=$(mktemp -d)
  require() { bash -c 'set -euo pipefail; AXIAL_ROOT=$1; HOST_PRESET=preset; . "$1/cmake/driver/progress.sh"; . "$1/cmake/driver/own.sh"
    . "$1/cmake/driver/verbs/hil.sh"; take_own_robot "$2/arm.hpp"; AXIAL_ROOT=$2
    for part in firmware hal; do ln -sfn "$1/$part" "$2/$part"; done; write_own_robot preset; require_load' - "$(dirname "$AXIAL")" "$folder"; }
  cp "$(dirname "$AXIAL")/tests/driver/two_links.hpp" "$folder/arm.hpp"
  expect 1 require
  [[ $err == *"takes no load: name 'static constexpr bool payload = true;' in its Mechanics"* && $(wc -l <<<"$err") == 1 ]] || fail "said: $err"
  sed -i 's/^struct .*{$/&\n  struct Mechanics {\n    static constexpr bool payload = true;\n  };/' "$folder/arm.hpp"
  expect 0 require
  rm -rf "$folder"
}

# A robot of robots/ or of its gallery is known by its name, and by the way to its header.
RobotsAreFoundByName() {
  local robots root
  root=$(dirname "$AXIAL")
  robots=$(cd "$root/robots" && ls gallery/*/*.hpp puma560.hpp)
  bash -c 'AXIAL_ROOT=$1; . "$1/cmake/driver/own.sh"; cd "$1/robots"
    for header in $2; do
      for name in "$(basename "$header" .hpp)" "$header"; do [[ $(own_header "$name") == "$1/robots/$header" ]] || echo "$name"; done
    done
    own_header nobody; own_header "puma5*"' - "$root" "$robots" | { ! grep .; } || fail "not found, or found and should not be"
}

# The struct of a header is found in whatever namespaces and structs it stands.
StructsOfHeadersAreFound() {
  local header found
  header=$(mktemp)
  cat >"$header" <<'END'
namespace my { namespace arms {  // struct Other { static constexpr auto chain = 0; };
enum class Kind { a, b };
struct First { static constexpr auto chain = axial::chain(axial::revolute()); };
  template <class T> struct Twin : Base<T> {
    struct Second { constexpr static auto chain = axial::chain(axial::revolute()); };
  };
}  // namespace arms
struct Unlike { double chain[2] = {1.0, 2.0}; }; }
END
  found=$(bash -c '. "$1/cmake/driver/own.sh"; robot_type "$2"' - "$(dirname "$AXIAL")" "$header")
  rm -f "$header"
  [[ $found == my::arms::Twin::Second ]] || fail "found: $found"
}

ValuesAreChecked() {
  expect_refused "unknown robot 'pumma'; there are panda" demo --robot pumma
  expect_refused "unknown board 'stm32f4'; there are" run x.hpp --board stm32f4
  expect_refused "unknown number 'fixed'; there are float fixed32" run x.hpp --number=fixed
  expect_refused "unknown compiler 'icc'; there are gcc clang" bench --compiler icc
  expect_refused "unknown scalar 'flaot'" size --scalar float,flaot
  expect_refused "there is no header 'mine.hpp'" cost mine.hpp
  expect_refused "there is no header 'mine.hpp'" ranges --robot mine.hpp
  expect_refused "there is no file 'no.urdf'" import no.urdf --strict
  expect_refused "there is no file 'mine.hpp'" excite --robot mine.hpp
  expect_refused "there is no file 'mine.hpp'" commission mine.hpp
  expect_refused "which robot? --robot; see ./axial excite --help" excite
  expect_refused "there is no file 'no.csv'" identify no.csv --robot scara
  expect_refused "--trajectory: there is no file 'no.json'" demo --trajectory no.json
  expect_refused "--budget is 'many'; give a number" choose --robot scara --board nrf51 --budget many
  expect_refused "--stride is '-1'; give a whole number" exhaustive --stride -1
}

# With an npm that brings something else under that name.
AnotherEmulatorIsRefused() {
  local folder
  folder=$(mktemp -d)
  # shellcheck disable=SC2016
  printf '#!/bin/bash\n[[ $1 == pack ]] && echo other >"${@: -2:1}/rp2040js-1.4.1.tgz"\n' >"$folder/npm"
  chmod +x "$folder/npm"
  expect 1 env "PATH=$folder:$PATH" bash -c "source '$(dirname "$AXIAL")/cmake/driver/progress.sh'
    source '$(dirname "$AXIAL")/cmake/driver/runner.sh'; fetch_rp2040js '$folder/emulator'"
  [[ $err == *'another checksum'* ]] || fail "says: $err"
  [[ ! -e $folder/emulator/package ]] || fail "unpacked it all the same"
  rm -r "$folder"
}

# With a dpkg-query that knows what is installed. A name that stands twice among those wanted was once asked for each time.
MissingPackagesAreNamedOnce() {
  local folder root said
  folder=$(mktemp -d) root=$(dirname "$AXIAL")
  printf '#!/bin/bash\nshift 2\nprintf "installed %%s\\n" "$@" | grep -v absent\n' >"$folder/dpkg-query"
  chmod +x "$folder/dpkg-query"
  # shellcheck disable=SC2016
  said=$(PATH=$folder:$PATH AXIAL_ROOT=$root bash -c 'source "$0/packages.sh"; missing_packages "${PACKAGES[@]}" absent cmake absent "${PACKAGES[@]}"' \
    "$root/cmake/driver")
  rm -rf "$folder"
  [[ $said == absent ]] || fail "said: $said"
}

# With a xacro and an importer that tell what they are given.
XacroIsExpanded() {
  local folder said
  folder=$(mktemp -d)
  mkdir -p "$folder/build/here/host_sim/robots/import"
  printf '#!/bin/bash\nsed "s/\${mass}/2.5/" "$1"\n' >"$folder/xacro"
  printf '#!/bin/bash\necho "$1 as $(basename "$2"): $(<"$2")"\n' >"$folder/build/here/host_sim/robots/import/import"
  chmod +x "$folder/xacro" "$folder/build/here/host_sim/robots/import/import"
  # shellcheck disable=SC2016
  echo '<mass value="${mass}"/>' >"$folder/arm.urdf.xacro"
  # shellcheck disable=SC2016
  said=$(PATH=$folder:$PATH AXIAL_ROOT=$folder HOST_PRESET=here bash -c \
    'source "$0/progress.sh"; source "$0/verbs/import.sh"; import_expanded --strict "$1"' "$(dirname "$AXIAL")/cmake/driver" "$folder/arm.urdf.xacro")
  rm -rf "$folder"
  [[ $said == *"was expanded by "*'--strict as arm.urdf.xacro: <mass value="2.5"/>' ]] || fail "said: $said"
}

# A PATH without apt and dpkg, and without the tools: a list of what to install.
ForeignSystemGetsAList() {
  local folder
  folder=$(mktemp -d)
  for tool in bash env dirname basename sed cat; do ln -s "$(command -v $tool)" "$folder/$tool"; done
  expect 1 env PATH="$folder" bash "$AXIAL" demo
  rm -rf "$folder"
  [[ $err == *"no apt"* && $err == *gcc-arm-none-eabi* && $err == *qemu-system-arm* ]] || fail "said: $err"
}

# Failures of a command, by timeout and for want of a program, and a build without tests; what passed or was skipped is not named.
FailedTestsAreNamed() {
  local build
  build=$(mktemp -d)
  cat >"$build/CTestTestfile.cmake" <<'END'
add_test(passes /bin/true)
add_test(fails /bin/bash -c "echo first; seq 1 40; echo last >&2; exit 3")
add_test(hangs /bin/sleep 5)
add_test(absent /no/such/program)
add_test(skipped /bin/false)
set_tests_properties(hangs PROPERTIES TIMEOUT 1)
set_tests_properties(skipped PROPERTIES SKIP_RETURN_CODE 1)
END
  ctest --test-dir "$build" --output-junit results.xml >/dev/null 2>&1
  expect 0 /usr/bin/python3 -E -B "$(dirname "$AXIAL")/cmake/driver/failed_tests.py" "$build" /no/such/build
  rm -r "$build"
  [[ $(grep -c '^axial: failed: ' <<<"$out") == 4 ]] || fail "not the four failures: $out"
  [[ $out == *"failed: fails (after "*last* && $out != *first* ]] || fail "not the end of what the test printed: $out"
  [[ $out == *"failed: hangs (after 1 s)"* && $out == *"failed: absent"* && $out == *"the build in /no/such/build"* ]] || fail "$out"
}

ScriptsPassShellcheck() {
  command -v shellcheck >/dev/null || exit 77
  local root
  root=$(dirname "$AXIAL")
  shellcheck -e SC1091 "$AXIAL" "$root"/.ci/run "$root"/cmake/driver/*.sh "$root"/cmake/driver/verbs/*.sh
}

"$1"
