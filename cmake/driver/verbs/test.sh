# shellcheck shell=bash
# summary: runs the essence of the tests in about eleven minutes, with --deep the rest: on the host, under sanitizers, on emulated boards
# group: maintain

usage() {
  cat <<'END'
usage: ./axial test [options]
Installs what is missing, builds what its tests need and runs them: the essence (tests/essence.txt), with --deep all other tests. Host programs
run under the address and undefined-behaviour sanitizers, or without them where they would take minutes to compile; boards run in emulators.
  --deep          all tests that are not the essence, for hours
  --part K/N      of --deep, the K-th of N parts of about equal cost; CI runs one of them, which the commit tells
  --filter REGEX  only the tests whose names match (folder.Suite.Test), of either; only programs that hold one are built
  --list          say what would be built and run, and what it costs a processor
  --quick         the essence: an older name
maintainers:
  --record        write the part of --part into tests/passed.json when it has passed
  --costs         write what was built and run here into tests/costs.json, by which parts are cut, and the table of compile_cost.md
END
}

readonly HALVES=(sanitized unsanitized)
declare -grA PRESET_OF=([sanitized]=host-sanitize [unsanitized]=host-unsanitized)
readonly STEPS=4

plan() { /usr/bin/python3 -E -B "$AXIAL_ROOT/cmake/testing/plan.py" "$@"; }

run() {
  local select=() part='' list=false record=false
  while (($#)); do
    case $1 in
      --deep) select+=(--deep) ;;
      --part | --filter)
        select+=("$1" "$2")
        [[ $1 == --filter ]] || part=$2
        shift
        ;;
      --list) list=true ;;
      --record) record=true ;;
      --costs) plan record && /usr/bin/python3 -E -B "$AXIAL_ROOT/cmake/testing/compile_table.py" && return ;;
    esac
    shift
  done
  [[ -z $part ]] || check_part "$part" "${select[@]}"
  ! $record || [[ -n $part ]] || fail_usage "--record is of --part; see ./axial test --help --all"
  ensure_packages python3-scipy python3-yaml doxygen clang clang-format clang-tidy libbenchmark-dev hunspell hunspell-en-gb # what runs of other verbs need
  if ((${#select[@]})); then
    look_for_sdf
    (ensure_packages chromium) || say "no chromium: the tests of pages for a browser will be skipped"
  fi
  step 1 "reading which tests there are"
  configure_halves || fail "the host's builds could not be configured"
  if $list; then
    plan list "${select[@]}"
    return
  fi
  test_selection "${select[@]}" || return 1
  if $record; then plan passed "$part"; fi
}

# What the importer is tested with in the deep half; the essence does without.
look_for_sdf() {
  local half
  ensure_packages libsdformat-dev
  for half in "${HALVES[@]}"; do look_again "${PRESET_OF[$half]}" sdformat12_DIR; done
}

# check_part K/N OPTION...
check_part() {
  [[ " ${*:2} " == *" --deep "* ]] || fail_usage "--part is of --deep; see ./axial test --help"
  if [[ ! $1 =~ ^[1-9][0-9]*/[1-9][0-9]*$ ]] || ((${1%/*} > ${1#*/})); then
    fail_usage "--part is '$1'; give K/N with 1 <= K <= N"
  fi
}

# step NUMBER TEXT: where a run of tests is, and how long it has taken.
step() { say "step $1 of $STEPS, after $((SECONDS / 60)) min $((SECONDS % 60)) s: $2"; }

configure_halves() {
  local half
  for half in "${HALVES[@]}"; do configure "${PRESET_OF[$half]}" || return; done
}

# Both halves' tests are run even if something fails: one round shows all there is to mend.
test_selection() {
  local half status=0 presets=()
  plan choose "$@" || status=$?
  ((status != 3)) || fail "no test is called so: ${*: -1}"
  ((status == 0)) || return $status
  step 2 "building the boards' images"
  build_planned_images || status=1
  for half in "${HALVES[@]}"; do
    [[ -s $AXIAL_ROOT/build/plan/$half.targets ]] || grep -q "^$half/" "$AXIAL_ROOT/build/plan/items" || continue
    step $((3 + (${#presets[@]} > 0))) "the host's tests, $half"
    presets+=("${PRESET_OF[$half]}")
    test_half "$half" || status=1
  done
  if ((status == 0)); then say "all chosen tests passed, in $((SECONDS / 60)) min $((SECONDS % 60)) s"; else say_failures "${presets[@]}"; fi
  say "not run: $(plan rest); ./axial test --deep runs the rest, --deep --part K/N a part, --filter REGEX what you name"
  return $status
}

# A file per board: the images that tests need, "all" for what a build without names makes, which leaves out some that tests name.
build_planned_images() {
  local file board images usual status=0
  for file in "$AXIAL_ROOT"/build/plan/*.images; do
    [[ -f $file ]] || continue
    board=$(basename "$file" .images)
    mapfile -t images <"$file"
    (ensure_runner "$board") || say "the tests of $board will be skipped: its emulator could not be installed"
    mapfile -t usual < <(images_of "$board")
    if [[ ${images[0]} == all && ${#usual[@]} != 0 ]]; then images=("${usual[@]}" "${images[@]:1}"); fi
    build "$board" "${images[@]}" || status=1
  done
  return $status
}

# test_half HALF: a program that does not build costs its own tests alone.
test_half() {
  local half=$1 preset=${PRESET_OF[$1]} targets numbers waiting=0 status=0
  local results=$AXIAL_ROOT/build/$preset/results.xml
  rm -f "$results"
  mapfile -t targets <"$AXIAL_ROOT/build/plan/$half.targets"
  if ((${#targets[@]})); then
    say "building $preset: ${#targets[@]} targets"
    NINJA_STATUS='[%f/%t, %e s] ' cmake --build "$AXIAL_ROOT/build/$preset" --parallel "$(nproc)" --target "${targets[@]}" -- -k 0 || status=1
  fi
  numbers=$(plan numbers "$half")
  [[ -n $numbers ]] || return $status
  say "testing $preset"
  if [[ $half == unsanitized ]]; then waiting=1; fi # of them wait for an emulated board's clock half of their time
  ctest --test-dir "$AXIAL_ROOT/build/$preset" -I "$numbers" --parallel "$(($(nproc) + waiting))" --output-on-failure --no-tests=error \
    --output-junit "$results" </dev/null || status=1
  return $status
}

# Last of all, and together: the first run's are thousands of lines above.
say_failures() { /usr/bin/python3 -E -B "$DRIVER/failed_tests.py" "${@/#/$AXIAL_ROOT/build/}" >&2; }
