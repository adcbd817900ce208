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

HelpNamesEveryVerb() {
  expect 0 "$AXIAL" help
  for verb in demo test combinations report size counts compile-cost compare exhaustive prove ranges numbers stability choose motion loop mutants bench amalgamate reference import run new-board boards clean help; do
    grep -qE "^  $verb +[a-z]" <<<"$out" || fail "no line for $verb in: $out"
  done
}

NoVerbShowsHelp() {
  expect 0 "$AXIAL"
  [[ $out == *usage:* ]] || fail "no usage"
}

EveryVerbHasHelp() {
  for verb in demo test combinations report size counts compile-cost compare exhaustive prove ranges numbers stability choose motion loop mutants bench amalgamate reference import run new-board boards clean; do
    expect 0 "$AXIAL" "$verb" --help
    [[ $out == "usage: ./axial $verb"* ]] || fail "$verb --help says: $out"
  done
}

UnknownVerbIsRefused() {
  for verb in dance ../build 'demo test' -x; do
    expect 2 "$AXIAL" "$verb"
    [[ -z $out && $err == *"unknown verb '$verb'"* ]] || fail "said: $out $err"
  done
}

UnknownOptionIsRefused() {
  for verb in test stability motion mutants bench amalgamate reference new-board boards clean; do
    expect 2 "$AXIAL" "$verb" --no-such-option
    [[ -z $out && -n $err ]] || fail "said: $out $err"
  done
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

ScriptsPassShellcheck() {
  command -v shellcheck >/dev/null || exit 77
  local root
  root=$(dirname "$AXIAL")
  shellcheck -e SC1091 "$AXIAL" "$root"/.ci/run "$root"/cmake/driver/*.sh "$root"/cmake/driver/verbs/*.sh
}

"$1"
