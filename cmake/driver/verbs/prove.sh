# shellcheck shell=bash
# summary: has Gappa and Coq check what fixed point certifies, on the programs that the kernels really execute
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial prove [options]
Installs gappa, with --coq also coq and its libraries (1.1 GB), and builds what is missing. Records the integer program that each
kernel executes, writes it as a script of Gappa beside the same kernel over the reals, and has Gappa prove the library's certified
errors and that no word overflows. Prints our bounds, Gappa's own, and who accepts them; doc/measurements/prove.md says what is assumed.
  --subject sine|cosine|reciprocal|scara_closed_form|scara_inverse_dynamics|puma560_joint3_step|
                      puma560_inverse_dynamics  default all
  --coq               Coq checks every certificate of Gappa's, and the polynomials of sine and cosine
  --limit NUMBER     of one run of Gappa or Coq; default 300
  --json FILE         an array of objects: subject, result, ours, theirs, bound, accepted, words, words_accepted, coq, seconds
Exits non-zero where a bound that doc/measurements/prove.md calls proved is not accepted.
maintainers:
  --documents         alone: all with Coq; writes doc/data/prove.json and the table of doc/measurements/prove.md
END_OF_USAGE
}

run() {
  if [[ ${1:-} == --documents ]]; then
    prove --coq --json "$AXIAL_ROOT/doc/data/prove.json"
    printf '{"commit": "%s"}\n' "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" >"$AXIAL_ROOT/doc/data/prove_provenance.json"
    /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/tables.py" "$AXIAL_ROOT/doc/data" "$AXIAL_ROOT/doc/measurements/prove.md"
  else
    prove "$@"
  fi
}

prove() {
  local packages=(gappa)
  if [[ " $* " == *" --coq "* ]]; then packages+=(coq libcoq-gappa libcoq-interval); fi
  ensure_packages "${packages[@]}"
  build "$HOST_PRESET" prove_scripts
  /usr/bin/python3 -E -B "$AXIAL_ROOT/host_sim/figures/prove/prove.py" --work "$AXIAL_ROOT/output/prove" \
    --scripts "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/figures/prove/prove_scripts" "$@"
}
