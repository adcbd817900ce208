# shellcheck shell=bash
# summary: seconds and memory that each kernel costs the compiler: numbers, robots, gcc, clang, Cortex-M4F and host
# group: measure, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial compile-cost [options]
       ./axial compile-cost --large
Installs what is missing. Compiles one source for each kernel, robot, number system and build, one at a time, and asks the system
what the compiler's processes used: processor seconds and peak memory, the least of three runs (doc/measurements/compile_cost.md). Prints a
table, writes JSON. Half an hour of one processor for all of them.
  --build cortex_m4f-O2|cortex_m4f-O0|host-gcc-O2|host-clang-O2...  only these: --build host-gcc-O2,host-clang-O2
  --robot puma560|panda...  only these
  --number float|double|fixed32...  only these
  --kernel NAME       only this one, or a list (headers: a source that includes the library and calls nothing)
  --runs N            of each; default 3
  --output FOLDER     where the file goes; default output/compile_cost
  --json FILE         the rows once more, as an array of objects
  --large             alone: forward dynamics of chains and trees of 6 to 50 joints instead (doc/measurements/compile_time.md), one run of each
maintainers:
  --large-documents   alone: measures those anew and writes doc/data/compile_time*.json and the tables of doc/measurements/compile_time.md
  --documents         alone: measures all anew and writes doc/data/compile_cost*.json and the tables of doc/measurements/compile_cost.md
END_OF_USAGE
}

run() {
  ensure_packages clang
  if [[ ${1:-} == --documents ]]; then
    write_compile_cost_documents
  elif [[ ${1:-} == --large ]]; then
    large_robots_py
  elif [[ ${1:-} == --large-documents ]]; then
    write_compile_time_documents
  else
    compile_cost_py "$@"
  fi
}

compile_cost_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/compile_cost/compile_cost.py" "$@"; }

large_robots_py() { /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/compile_cost/large_robots.py" "$@"; }

write_compile_time_documents() {
  local doc=$AXIAL_ROOT/doc
  large_robots_py --output "$doc/data"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/compile_time_tables.py" "$doc/data" "$doc/measurements/compile_time.md"
}

write_compile_cost_documents() {
  local doc=$AXIAL_ROOT/doc
  compile_cost_py --output "$doc/data"
  compile_cost_py provenance "$doc/data/compile_cost_provenance.json"
  /usr/bin/python3 -E "$AXIAL_ROOT/host_sim/figures/pages/compile_cost_tables.py" "$doc/data" "$doc/measurements/compile_cost.md"
}
