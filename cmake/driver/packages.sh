# shellcheck shell=bash
# What the verbs need, and how a Debian gets it.

readonly PACKAGES=(
  build-essential cmake ninja-build                                            # host compiler and build
  gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib     # firmware compiler, Arm
  gcc-riscv64-unknown-elf                                                      # firmware compiler, RISC-V
  qemu-system-arm qemu-system-misc                                             # the emulated boards
  libgtest-dev liborocos-kdl-dev libeigen3-dev liburdfdom-dev                  # tests, independent dynamics, descriptions
  nlohmann-json3-dev libcli11-dev                                              # host_sim
  python3-matplotlib python3-numpy                                             # pictures
)
readonly COMMANDS=(
  g++ cmake ninja arm-none-eabi-g++ riscv64-unknown-elf-g++ qemu-system-arm qemu-system-riscv32 /usr/bin/python3
)

# ensure_packages [PACKAGE...]: PACKAGES and those.
ensure_packages() {
  local wanted=("${PACKAGES[@]}" "$@")
  if ! command -v dpkg-query >/dev/null; then
    ensure_commands "${wanted[@]}"
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "${wanted[@]}")
  ((${#missing[@]} == 0)) && return
  command -v apt-get >/dev/null || fail "please install: ${missing[*]}"
  install_packages "${missing[@]}"
}

# Each once, for comm counts: a name that stands twice among those wanted would be missing once.
missing_packages() {
  LC_ALL=C comm -23 <(printf '%s\n' "$@" | LC_ALL=C sort -u) <(installed_packages "$@" | LC_ALL=C sort -u)
}

installed_packages() {
  dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' || true
}

# Not a Debian: whatever the names of the packages are there, these commands tell whether they are installed.
ensure_commands() {
  local name missing=()
  for name in "${COMMANDS[@]}"; do
    command -v "$name" >/dev/null || missing+=("$name")
  done
  ((${#missing[@]} == 0)) && return
  {
    echo "axial: not found: ${missing[*]}"
    echo "This system has no apt. Please install, under whatever names it has for these Debian 12 packages:"
    printf '  %s\n' "$@"
  } >&2
  exit 1
}

install_packages() {
  local log=$AXIAL_ROOT/build/packages.log
  can_be_root || fail "please install as root: apt-get install --no-install-recommends $*"
  if ! compgen -G '/var/lib/apt/lists/*Packages*' >/dev/null; then
    with_progress "reading package lists" "$log" apt_get update
  fi
  with_progress "installing $# packages" "$log" apt_get install --no-install-recommends "$@" && return
  with_progress "refreshing package lists" "$log" apt_get update
  with_progress "installing $# packages" "$log" apt_get install --no-install-recommends "$@"
}

# Asks for the password here, where there is still a terminal to ask on.
can_be_root() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null || return 1
  if [[ -t 0 ]]; then sudo -v; else sudo -n true 2>/dev/null; fi
}

apt_get() {
  local root=()
  ((EUID == 0)) || root=(sudo -n)
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@"
}
