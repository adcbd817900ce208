# shellcheck shell=bash
# summary: the library as a package of Arduino, PlatformIO, ESP-IDF, Zephyr, CMSIS, vcpkg or Conan
# group: maintain

usage() {
  cat <<'END'
usage: ./axial package NAME -o FOLDER
Writes the headers with the manifests of an ecosystem into a new folder. Installs and builds nothing. Debian: cpack -G DEB in a build of the project.
  NAME                 arduino, cmsis, conan, esp_idf, platformio, vcpkg or zephyr
  -o, --output FOLDER  a folder that is not there yet, or empty
END
}

run() { /usr/bin/python3 -E -B "$AXIAL_ROOT/cmake/packages/package.py" "$@"; }
