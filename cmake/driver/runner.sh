# shellcheck shell=bash
# What runs in node: the emulator of a board that QEMU has not, and MuJoCo. Packages of npm's, each at one version and by its checksum, in build/.

readonly RP2040JS_VERSION=1.4.1
readonly RP2040JS_SHA512=633af9c46ed9c1bb40e74218014d64fe84a84b20c084fb53e6a0bf436785029a0bb80604f0341b3c830fb3fd2487821eb5de0fd0ea4a93708891f36a8dcaf9ea

readonly MUJOCO_VERSION=0.0.7
readonly MUJOCO_SHA512=3170ae758a3e4029dc144415c43cbd1a310b38644d2ac4ae70aa47833f6135e4525973f4d7186d66be4636f637d11becfe6b5f57f8cf6f7b88b226173c9d95da

# ensure_runner BOARD: nothing for a board of QEMU.
ensure_runner() {
  grep -q '"runner"' "$AXIAL_ROOT/hal/boards/$1/board.json" 2>/dev/null || return 0
  { command -v node && command -v npm; } >/dev/null || ensure_packages nodejs npm
  { command -v node && command -v npm; } >/dev/null || fail "not found: node and npm, which run and fetch the emulator of $1"
  fetch_rp2040js "$AXIAL_ROOT/build/rp2040js-$RP2040JS_VERSION"
}

# fetch_rp2040js FOLDER
fetch_rp2040js() { fetch_package "$1" rp2040js "$RP2040JS_VERSION" "$RP2040JS_SHA512"; }

# ensure_mujoco FOLDER: fails where it cannot be had, having said so; what wants it goes on without.
ensure_mujoco() {
  { command -v node && command -v npm; } >/dev/null || (ensure_packages nodejs npm) || return 1
  (fetch_package "$1" mujoco-js "$MUJOCO_VERSION" "$MUJOCO_SHA512")
}

# fetch_package FOLDER NAME VERSION SHA512: into FOLDER/package, whole or not at all.
fetch_package() {
  local folder=$1 name=$2 version=$3
  local archive=$folder/$name-$version.tgz
  [[ ! -f $folder/package/package.json ]] || return 0
  mkdir -p "$folder"
  with_progress "fetching $name $version" "$folder.log" npm pack --silent --pack-destination "$folder" "$name@$version" || return 1
  sha512sum --check --status <<<"$4  $archive" || fail "$name $version: what came has another checksum"
  tar -xzf "$archive" -C "$folder"
}
