# shellcheck shell=bash
# The emulator of a board that QEMU has not: a package of npm's, at one version and by its checksum, in build/.

readonly RP2040JS_VERSION=1.4.1
readonly RP2040JS_SHA512=633af9c46ed9c1bb40e74218014d64fe84a84b20c084fb53e6a0bf436785029a0bb80604f0341b3c830fb3fd2487821eb5de0fd0ea4a93708891f36a8dcaf9ea

# ensure_runner BOARD: nothing for a board of QEMU.
ensure_runner() {
  grep -q '"runner"' "$AXIAL_ROOT/hal/boards/$1/board.json" 2>/dev/null || return 0
  { command -v node && command -v npm; } >/dev/null || ensure_packages nodejs npm
  { command -v node && command -v npm; } >/dev/null || fail "not found: node and npm, which run and fetch the emulator of $1"
  fetch_rp2040js "$AXIAL_ROOT/build/rp2040js-$RP2040JS_VERSION"
}

# fetch_rp2040js FOLDER: into FOLDER/package, whole or not at all.
fetch_rp2040js() {
  local folder=$1
  local archive=$folder/rp2040js-$RP2040JS_VERSION.tgz
  [[ ! -f $folder/package/package.json ]] || return 0
  mkdir -p "$folder"
  with_progress "fetching rp2040js $RP2040JS_VERSION" "$folder.log" \
    npm pack --silent --pack-destination "$folder" "rp2040js@$RP2040JS_VERSION" || return 1
  sha512sum --check --status <<<"$RP2040JS_SHA512  $archive" || fail "rp2040js $RP2040JS_VERSION: what came has another checksum"
  tar -xzf "$archive" -C "$folder"
}
