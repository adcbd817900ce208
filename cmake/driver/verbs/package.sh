# shellcheck shell=bash
# summary: the library as a package of Arduino, PlatformIO, ESP-IDF, Zephyr, CMSIS, vcpkg, Conan or Debian, or as all of them
# group: maintain

usage() {
  cat <<'END'
usage: ./axial package NAME -o FOLDER
Writes the headers with the manifests of an ecosystem into a new folder: arduino, cmsis, conan, esp_idf, platformio, vcpkg, zephyr, or
debian (a tree for dpkg-deb). NAME all writes every package of this version as one file each, the single header and their checksums:
the same to the byte wherever they are made. Installs nothing.
  -o, --output FOLDER  a folder that is not there yet, or empty
END
}

run() { /usr/bin/python3 -E -B "$AXIAL_ROOT/cmake/packages/package.py" "$@"; }
