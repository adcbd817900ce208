# shellcheck shell=bash
# summary: contacts of a simulated Panda: how soon a momentum observer reports them, what it takes for one that is none
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial collide [options]
Installs and builds what is missing. Moves a simulated Panda at 1 kHz with quantised encoders, noisy torques and wrong parameters,
once without contacts and once with one of 5 % of a joint's effort limit every 1.5 s; a momentum observer in float and in fixed point
watches; then payloads of a Panda and a Puma 560 are weighed. Prints delays and false alarms, writes JSON, the CSV of the first seconds and a picture (doc/guides/observer.md).
  --seconds NUMBER    of motion, once without and once with contacts; default 600
  --seed NUMBER       of motion and noise; default 3
  --output FOLDER     where the files go; default output/collide
  --json FILE         the rows once more, as an array of objects
Exits non-zero when a contact is missed or found after more than 10 ms, when there is a false alarm, or a payload
is weighed worse than to 25 g or 10 g m.
maintainers:
  --documents         alone: writes doc/data, doc/pictures and the tables of doc/guides/observer.md and payload.md
END_OF_USAGE
}

run() {
  ensure_packages
  build "$HOST_PRESET" collide
  if [[ ${1:-} == --documents ]]; then
    write_collide_documents
  else
    collide_program "$@"
  fi
}

collide_program() { "$AXIAL_ROOT/build/$HOST_PRESET/host_sim/plants/collide/collide" "$@"; }

write_collide_documents() {
  local doc=$AXIAL_ROOT/doc output=$AXIAL_ROOT/output/collide
  collide_program --output "$output" --json "$doc/data/collide.json"
  cp "$output"/collide.png "$doc/pictures/"
  printf '{"commit": "%s", "compiler": "%s", "flags": "-O2 -ffp-contract=off"}\n' \
    "$("$AXIAL_ROOT/host_sim/tools/system/commit.sh")" "$(c++ --version | head -n 1)" >"$doc/data/collide_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/observer_tables.py" "$doc/data" "$doc/guides/observer.md"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/observer_tables.py" "$doc/data" "$doc/guides/payload.md"
}
