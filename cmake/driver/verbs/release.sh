# shellcheck shell=bash
# summary: measures every page at one commit, resumably; or shows at which commit each is
# group: maintain, rare

usage() {
  cat <<'END'
usage: ./axial release --pages
       ./axial release --measure [--only REGEX]
  --pages       the commit of each page; ends with 1 where they are not one
  --measure     runs what measures them, part by part, hours in all, each bounded; parts done at this commit are not done again
  --only REGEX  of --measure: only commands that match
END
}

run() { /usr/bin/python3 -E -B "$AXIAL_ROOT/cmake/release/release.py" "$@"; }
