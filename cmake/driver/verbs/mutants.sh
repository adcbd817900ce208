# shellcheck shell=bash
# summary: changes one place of the library at a time; the test that is said to see it must fail
# group: maintain, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial mutants [options]
Each mutant of tests/mutants changes one place of the sources, in a copy of them. The test that the table names for it, compiled
with the change, must fail, and pass without. Ends with status 1 if one survives, with 2 if the table is at fault.
  --only REGEX  only mutants whose names match
  --part K/N    the K-th of N parts of the same size
  --rotate N    one part of N: which one, the commit tells
  --essence N   N mutants, drawn by the commit, against the essence of the tests alone: at least 85 in 100 are killed
  --draw N      N mutants made from the code by operators, each against tests of its file until one notices; goes on where it was interrupted
  --seed N      of --essence and --draw: draw by this number
  --seconds N   of --draw: of compiling and running that a mutant is worth (default 40), in seconds of the tests' recorded costs
  --again       of --draw: try those once more that no test noticed
  --record      remember in tests/mutants/killers.json which test killed which: it is compiled alone next time
  --list        say which mutants there are, and run none
  --check       only see whether the text that each changes stands in its file, once
  --jobs N      mutants at a time (default: as many as processors)
  --json FILE   the rows as an array of objects: mutant, file, killed_by (empty: survived)
END_OF_USAGE
}

run() {
  ensure_packages
  /usr/bin/python3 -E -B "$AXIAL_ROOT/tests/mutants/mutants.py" "$@"
}
