#!/usr/bin/env bash
# Somebody else's project gets the library, each way in a temporary folder. usage: consumer_test.sh CASE
set -euo pipefail
HERE=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
ROOT=$(cd "$HERE/../.." && pwd)
FOLDER=$(mktemp -d)
trap 'rm -rf "$FOLDER"' EXIT

fail() { echo "$*" >&2; exit 1; }
quietly() { "$@" >"$FOLDER/log" 2>&1 || { cat "$FOLDER/log" >&2; fail "failed: $*"; }; }

# install_axial: to $FOLDER/installed, as a user would who wants only the headers
install_axial() {
  quietly cmake -S "$ROOT" -B "$FOLDER/axial" -DAXIAL_OWN_BUILD=OFF
  quietly cmake --install "$FOLDER/axial" --prefix "$FOLDER/installed"
}

# build_program WAY [DEFINITION...]: configures, builds and runs program/
build_program() {
  local way=$1
  shift
  quietly cmake -S "$HERE/program" -B "$FOLDER/program" -DWAY="$way" -DAXIAL_SOURCE="$ROOT" "$@"
  quietly cmake --build "$FOLDER/program"
  "$FOLDER/program/consumer"
}

FindPackage() {
  install_axial
  build_program find_package -DCMAKE_PREFIX_PATH="$FOLDER/installed"
}

AddSubdirectory() { build_program add_subdirectory; }

FetchContent() { build_program fetch_content; }

PkgConfig() {
  command -v pkg-config >/dev/null || exit 77
  install_axial
  local flags
  read -ra flags <<<"$(PKG_CONFIG_PATH=$FOLDER/installed/share/pkgconfig pkg-config --cflags 'axial >= 0.1')"
  quietly g++ "${flags[@]}" "$HERE/program/main.cpp" -o "$FOLDER/consumer"
  "$FOLDER/consumer"
}

InstallsHeadersAlone() {
  install_axial
  local file found=0
  while read -r file; do
    case $file in
      include/axial/*.hpp | include/axial/axial.h | include/axial/version.h | include/robots/*.hpp) found=$((found + 1)) ;;
      share/cmake/axial/*.cmake | share/pkgconfig/axial.pc) ;;
      *) fail "installs $file" ;;
    esac
  done < <(cd "$FOLDER/installed" && find . -type f -printf '%P\n')
  ((found > 100)) || fail "only $found headers"
}

TooNewAVersionIsRefused() {
  install_axial
  sed 's/find_package(axial 0.1 /find_package(axial 0.2 /' "$HERE/program/CMakeLists.txt" >"$FOLDER/CMakeLists.txt"
  ! cmake -S "$FOLDER" -B "$FOLDER/program" -DWAY=find_package -DCMAKE_PREFIX_PATH="$FOLDER/installed" \
    >"$FOLDER/log" 2>&1 || fail "0.2 is accepted"
  [[ $(tr -s ' \n' ' ' <"$FOLDER/log") == *'compatible with requested version "0.2"'* ]] || fail "$(<"$FOLDER/log")"
}

amalgamate() { quietly "$ROOT/axial" amalgamate --robot planar2r -o "$1"; }

SingleHeader() {
  amalgamate "$FOLDER/axial.hpp"
  quietly g++ -std=c++17 -Wall -Wextra -Werror -DAXIAL_SINGLE_HEADER -I"$FOLDER" "$HERE/program/main.cpp" -o "$FOLDER/consumer"
  "$FOLDER/consumer"
}

# A header that the importer wrote goes with the one header: included before it and after it, or taken into it.
SingleHeaderWithAnImportedRobot() {
  local robot=$FOLDER/imported/kr5_sixx.hpp way
  [[ -x $AXIAL_IMPORT ]] || exit 77
  mkdir "$FOLDER/apart" "$FOLDER/together" "$FOLDER/imported"
  quietly "$AXIAL_IMPORT" "$ROOT/tests/data/descriptions/kr5_sixx_r650.urdf" --name kr5_sixx -o "$robot"
  amalgamate "$FOLDER/apart/axial.hpp"
  cp "$robot" "$FOLDER/apart/"
  quietly "$ROOT/axial" amalgamate --robot "$robot" -o "$FOLDER/together/axial.hpp"
  ! grep -F "$(dirname "$robot")" "$FOLDER/together/axial.hpp" || fail "names this machine's folder"
  printf '#include "axial.hpp"\n#include "kr5_sixx.hpp"\n' >"$FOLDER/apart/first.cpp"
  printf '#include "kr5_sixx.hpp"\n#include "axial.hpp"\n' >"$FOLDER/apart/last.cpp"
  printf '#include "axial.hpp"\n' >"$FOLDER/together/within.cpp"
  for way in apart/first apart/last together/within; do
    echo 'int main() { return axial::joint_count<robots::Kr5Sixx> == 6 ? 0 : 1; }' >>"$FOLDER/$way.cpp"
    quietly g++ -std=c++17 -Wall -Wextra -Werror -I"$(dirname "$FOLDER/$way")" "$FOLDER/$way.cpp" -o "$FOLDER/consumer"
    "$FOLDER/consumer" || fail "$way"
  done
}

SingleHeaderIsTheSameTwice() {
  amalgamate "$FOLDER/axial.hpp"
  amalgamate "$FOLDER/again.hpp"
  cmp "$FOLDER/axial.hpp" "$FOLDER/again.hpp"
  ! grep -nE '^[[:space:]]*#include *[<"](axial|robots|hal)/' "$FOLDER/axial.hpp" || fail "is not whole"
}

# Everything that the header says must compile where there is no host: on a core with a floating-point unit, and on the
# smallest, whose products are another header's.
SingleHeaderForArm() {
  command -v arm-none-eabi-g++ >/dev/null || exit 77
  amalgamate "$FOLDER/axial.hpp"
  echo '#include "axial.hpp"' >"$FOLDER/alone.cpp"
  local core
  for core in "cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16" "cortex-m0"; do
    # shellcheck disable=SC2086
    quietly arm-none-eabi-g++ -std=c++17 -mthumb -mcpu=$core -Wall -Wextra -Werror -fno-exceptions -fno-rtti \
      -fsyntax-only "$FOLDER/alone.cpp"
  done
}

UnknownRobotIsRefused() {
  local status=0
  "$ROOT/axial" amalgamate --robot no_such_arm -o "$FOLDER/axial.hpp" 2>"$FOLDER/log" || status=$?
  ((status == 2)) || fail "exit status $status"
  grep -q "no robot 'no_such_arm'.*planar2r" "$FOLDER/log" || fail "$(<"$FOLDER/log")"
}

# Programs that nobody edits any more, by the headers as installed: with each compiler, in strict C++17, and in C99.
ProgramsOf0_1() {
  local programs=$HERE/written_for_0_1 include=(-I"$FOLDER/installed/include") compiler source
  (cd "$programs" && sha256sum --check --strict --quiet SHA256SUMS) || fail "a program of 0.1 was edited; write it anew for a new version"
  install_axial
  for compiler in "g++ gcc" "clang++ clang"; do
    read -r cxx c <<<"$compiler"
    command -v "$cxx" >/dev/null || continue
    for source in main_job arrays_and_models scenes fixed_point coupled control_loop; do
      quietly "$cxx" -std=c++17 -pedantic -Wall -Wextra -Werror -O1 "${include[@]}" "$programs/$source.cpp" -o "$FOLDER/$source"
      "$FOLDER/$source" || fail "$source, by $cxx, answers $?"
    done
    quietly "$c" -std=c99 -pedantic -Wall -Wextra -Werror "${include[@]}" -c "$programs/in_c.c" -o "$FOLDER/in_c.o"
    quietly "$cxx" -std=c++17 -O1 "${include[@]}" "$programs/arm_in_c.cpp" "$FOLDER/in_c.o" -o "$FOLDER/in_c"
    "$FOLDER/in_c" || fail "the program in C, by $c, answers $?"
  done
}

# Every file that doc/guides/embedding.md, eigen.md and c.md show.
EmbeddingPage() {
  install_axial
  local page=$FOLDER/page include=(-I"$FOLDER/installed/include") strict=(-pedantic -Wall -Wextra -Werror)
  local shown
  for shown in embedding eigen c; do
    /usr/bin/python3 -E "$HERE/../documents/shown_files.py" "$ROOT/doc/guides/$shown.md" "$page"
  done
  quietly cmake -S "$page/package" -B "$page/package/build" -DCMAKE_PREFIX_PATH="$FOLDER/installed"
  quietly cmake --build "$page/package/build"
  quietly "$page/package/build/firmware"
  quietly cmake -S "$page/sources" -B "$page/sources/build" -DAXIAL_SOURCE="$ROOT"
  quietly cmake --build "$page/sources/build"
  quietly "$page/sources/build/firmware"
  quietly gcc -std=c99 "${strict[@]}" "${include[@]}" -c "$page/c/main.c" -o "$page/main.o"
  quietly g++ -std=c++17 "${strict[@]}" "${include[@]}" "$page/c/my_arm.cpp" "$page/main.o" -o "$page/in_c"
  quietly g++ -std=c++17 "${strict[@]}" "${include[@]}" -c "$page/c/springs.cpp" -o "$page/springs.o"
  quietly "$page/in_c"
  [[ -d /usr/include/eigen3 ]] || return 0
  quietly g++ -std=c++17 "${include[@]}" -isystem /usr/include/eigen3 "$page/with_eigen.cpp" -o "$page/with_eigen"
  quietly "$page/with_eigen"
}

# copy_of_the_project: what git keeps (and is not yet told of), without documents, to $FOLDER/axial
copy_of_the_project() {
  mkdir "$FOLDER/axial"
  (cd "$ROOT" && git ls-files -z --cached --others --exclude-standard -- . ':!doc' ':!tests/data' |
    xargs -0 tar --ignore-failed-read -cf - 2>/dev/null) | tar -xf - -C "$FOLDER/axial"
}

# A skeleton runs the self-test of the instruments and all that ends in a restart at once, here on a Cortex-M7.
NewBoardRuns() {
  copy_of_the_project
  quietly "$FOLDER/axial/axial" new-board my_board --like mps2_an500
  cd "$FOLDER/axial"
  quietly cmake --preset my_board
  quietly cmake --build --preset my_board --target selftest faults
  local image
  for image in selftest faults; do
    AXIAL_IMAGES_ROOT=$PWD/build PYTHONPATH=tests/target /usr/bin/python3 -B -c \
      'import emulator, sys; code, text = emulator.run("my_board", sys.argv[1]); print(text); sys.exit(code)' $image
  done
}

# The board that doc/guides/porting.md and its code pages port: the self-test of the instruments, and a torque over its serial port.
PortingPage() {
  copy_of_the_project
  cd "$FOLDER/axial"
  quietly ./axial new-board mps2_an386 --like mps2_an500 --cpu cortex-m4f
  local page
  for page in porting porting_serial porting_board; do
    /usr/bin/python3 -E "$HERE/../documents/shown_files.py" "$ROOT/doc/guides/$page.md" "$FOLDER/shown"
  done
  cp -r "$FOLDER/shown/." .
  quietly cmake --preset mps2_an386
  quietly cmake --build --preset mps2_an386 --target selftest feedforward-scara
  AXIAL_IMAGES_ROOT=$PWD/build PYTHONPATH=tests/target /usr/bin/python3 -B "$HERE/ported_board.py" mps2_an386
}

# Every board serves as a model.
NewBoardCompilesFromEachBoard() {
  copy_of_the_project
  cd "$FOLDER/axial"
  local like name
  echo '#include <board.hpp>
static_assert(axial::hal::Board::flash_bytes > 0);' >"$FOLDER/board.cpp"
  for like in stm32f405 stm32f100 nrf51 rp2040 rp2040_ram mps2_an500 mps2_an505; do
    name=like_$like
    quietly ./axial new-board "$name" --like "$like"
    quietly arm-none-eabi-g++ -std=c++17 -mcpu=cortex-m0 -mthumb -Wall -Wextra -Werror -DAXIAL_SEMIHOSTING=1 -fno-exceptions \
      -fno-rtti -fsyntax-only -I. -I"hal/boards/$name" "$FOLDER/board.cpp"
  done
  for like in rv32_virt rp2350_riscv; do
    name=like_$like
    quietly ./axial new-board "$name" --like "$like"
    quietly cmake --preset "$name"
    quietly cmake --build --preset "$name" --target axial_board
  done
}

BadBoardsAreRefused() {
  copy_of_the_project
  local options wanted
  while IFS='|' read -r options wanted; do
    # shellcheck disable=SC2086
    ! "$FOLDER/axial/axial" new-board $options 2>"$FOLDER/log" || fail "accepts $options"
    grep -q -e "$wanted" "$FOLDER/log" || fail "$options: $(<"$FOLDER/log")"
  done <<'END'
My-Board --like stm32f405|'My-Board' is no name of a board
nrf51 --like stm32f405|hal/boards/nrf51 is there already
my_board --like esp32|no board 'esp32'; --like takes one of: .*nrf51
my_board --like nrf51 --cpu z80|no toolchain for the CPU 'z80'; --cpu takes one of: .*cortex-m0
my_board --like nrf51 --cpu rv32imac|of different architectures
host-debug --like nrf51|is no name of a board
my_board|--like
END
  [[ ! -e $FOLDER/axial/hal/boards/my_board ]] || fail "leaves something behind"
}

"$1"
