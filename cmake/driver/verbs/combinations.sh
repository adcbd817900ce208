# shellcheck shell=bash
# summary: compiles and runs every pair of what a user may combine, by gcc and clang; holds what is not offered to its sentence
# group: maintain, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial combinations [options]
Installs what is missing. Compiles a covering array of numbers, features, routes, joints, twists, trees and inertias with every
algorithm that each row offers, and runs it: answers agree with a run-time model in double, fixed point within its certified error.
What is not offered (doc/guides/not_offered.md has the list) must not compile, and must say its sentence first. Ends with status 1 where
something is wrong. Minutes of one processor for each compiler.
  --compiler gcc|clang  default both, one after the other
  --part I/N          only every N-th, from the I-th on (I from 0)
  --only TEXT         only what has this text in its description, algorithm or sentence
  --jobs N            compilers at once; default one a processor
  --json FILE         an array of objects: compiler, combination, algorithm, refused, passed, message
  --list              says the combinations and what each offers
END_OF_USAGE
}

run() {
  ensure_packages clang
  /usr/bin/python3 -E -B "$AXIAL_ROOT/tests/combinations/check.py" "$@"
}
