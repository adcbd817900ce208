# shellcheck shell=bash
# The emulator of a board that QEMU has not: a package of the npm registry, at one version and by its checksum, in build/.

readonly RP2040JS_VERSION=1.4.1
readonly RP2040JS_SHA512=633af9c46ed9c1bb40e74218014d64fe84a84b20c084fb53e6a0bf436785029a0bb80604f0341b3c830fb3fd2487821eb5de0fd0ea4a93708891f36a8dcaf9ea

# ensure_runner BOARD: nothing for a board of QEMU.
ensure_runner() {
  [[ $1 == "$RUNNER_BOARD" ]] || return 0
  ensure_packages nodejs ca-certificates curl
  command -v node >/dev/null || fail "not found: node, which runs the emulator of $1"
  fetch_rp2040js "$AXIAL_ROOT/build/rp2040js-$RP2040JS_VERSION"
}

# fetch_rp2040js FOLDER: into FOLDER/package, whole or not at all.
fetch_rp2040js() {
  local folder=$1 archive=$1.tgz
  [[ ! -f $folder/package/package.json ]] || return 0
  mkdir -p "$folder"
  with_progress "fetching rp2040js $RP2040JS_VERSION" "$folder.log" \
    curl --fail --silent --show-error --location --retry 3 -o "$archive" "$(npm_registry)/rp2040js/-/rp2040js-$RP2040JS_VERSION.tgz" || return 1
  sha512sum --check --status <<<"$RP2040JS_SHA512  $archive" || fail "rp2040js $RP2040JS_VERSION: what came has another checksum"
  tar -xzf "$archive" -C "$folder"
}

# Where npm would look.
npm_registry() {
  local registry=${npm_config_registry:-}
  if [[ -z $registry ]] && command -v npm >/dev/null; then registry=$(npm config get registry 2>/dev/null); fi
  registry=${registry:-https://registry.npmjs.org}
  echo "${registry%/}"
}
