# shellcheck shell=bash
# summary: the API reference as browsable pages: every public name, and the documents
# group: maintain, rare

usage() {
  cat <<'END_OF_USAGE'
usage: ./axial reference [options]
Installs Doxygen if it is missing and writes pages of the public headers, a module for each folder of firmware/include/axial, with
README.md as the first one and doc/ as guides; some 10 s. Ends with status 1 where a public name has no comment, and lists them.
  --output FOLDER     where the pages go; default output/reference
  --json FILE         names without a comment and malformed comments, as an array of objects
  --check             writes no pages
END_OF_USAGE
}

run() {
  command -v doxygen >/dev/null || ensure_packages doxygen
  /usr/bin/python3 -E "$AXIAL_ROOT/cmake/reference/reference.py" "$@"
}
