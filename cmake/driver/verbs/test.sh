# shellcheck shell=bash
# summary: builds everything and runs every test: on the host, under sanitizers, on the boards in QEMU
# group: maintain

usage() {
  cat <<'END'
usage: ./axial test [--quick] [--filter REGEX]
Installs what is missing, builds the images of all boards and the host programs, and runs all tests, each once: on the host
under the address and undefined-behaviour sanitizers, or without them where they would take minutes to compile, and on the
boards in QEMU.
  --filter REGEX  only the tests whose names match (folder.Suite.Test)
  --quick         host only: all of its tests in one build, no images, no boards, no sanitizers
END
}

run() {
  local quick=false select=()
  while (($#)); do
    case $1 in
      --quick) quick=true ;;
      --filter)
        select=(--tests-regex "$2")
        shift
        ;;
    esac
    shift
  done
  ensure_packages python3-scipy python3-yaml doxygen clang clang-format clang-tidy libbenchmark-dev # what runs of other verbs need
  if $quick; then
    test_preset host-debug --no-tests=error "${select[@]}" --label-exclude target
  else
    test_everything "${select[@]}"
  fi
}

# Both runs happen even if the first fails: one round shows all there is to mend.
test_everything() {
  local status=0 preset
  (ensure_runner "$RUNNER_BOARD") || say "the tests of $RUNNER_BOARD will be skipped: its emulator could not be installed"
  build_boards
  for preset in host-unsanitized host-sanitize; do
    test_preset "$preset" "$@" || status=1
  done
  (($# == 0)) || some_test_matches "$@" || fail "no test is called so: $2"
  if ((status == 0)); then say "all tests passed"; else say_failures host-unsanitized host-sanitize; fi
  return $status
}

# Last of all, and together: the first run's are thousands of lines above.
say_failures() { /usr/bin/python3 -E -B "$DRIVER/failed_tests.py" "${@/#/$AXIAL_ROOT/build/}" >&2; }

some_test_matches() {
  local preset
  for preset in host-unsanitized host-sanitize; do
    ctest --test-dir "$AXIAL_ROOT/build/$preset" --show-only "$@" | grep -q 'Total Tests: 0' || return 0
  done
  return 1
}

test_preset() {
  local preset=$1 results=$AXIAL_ROOT/build/$1/results.xml
  shift
  rm -f "$results"
  build "$preset" || return 1
  say "testing $preset"
  ctest --test-dir "$AXIAL_ROOT/build/$preset" --parallel "$(nproc)" --output-on-failure --output-junit "$results" "$@" </dev/null
}
