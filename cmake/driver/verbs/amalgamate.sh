# shellcheck shell=bash
# summary: the library as one header, with robots where asked, for projects that take a single file
# group: use

usage() {
  cat <<'END'
usage: ./axial amalgamate [options]
Writes the whole library and its C interface as one header that includes nothing but the compiler's own. Installs and builds nothing.
  -o, --output FILE   default axial.hpp, in the current folder; - for standard output
  --robot NAME        also robots/NAME.hpp, or the robot of a header that is named by its file; may be given several times
  --header NAME       also this header of the library, such as axial/simulation/motion.hpp
END
}

run() { /usr/bin/python3 -E "$AXIAL_ROOT/cmake/amalgamate/amalgamate.py" "$@"; }
