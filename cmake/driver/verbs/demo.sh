# shellcheck shell=bash
# summary: streams a pick-and-place cycle to the firmware in QEMU; torques, errors, cost, a picture

usage() {
  cat <<'END'
usage: ./axial demo [options]
Installs and builds what is missing, starts the feed-forward firmware of a board in QEMU, streams a pick-and-place
cycle to it tick by tick, compares every torque with the oracle, prints a table and writes CSV, JSON and a picture.
  --robot NAME        scara (default), scara_rrpr, puma560, panda, planar2r
  --board NAME        stm32f405 (default), stm32f100, nrf51, rv32_virt
  --number NAME       what the firmware computes in: float (default), fixed32 (32-bit fixed point; the wire stays float)
  --trajectory FILE   way-points (.json as in host_sim/trajectories) or set-points (.csv: time, q..., qd..., qdd...)
  --output FOLDER     where the files go; default output/demo
  --without-picture   data alone
  --json FILE         the figures of every joint once more, as an array of objects
Exits non-zero when an error is above its bound or a frame is lost.
END
}

run() {
  local board image
  board=$(named_board "$@")
  image=$(demo_image "$@")
  ensure_packages
  build_host_sim
  [[ -z $board || -z $image ]] || build "$board" "$image"
  host_sim demo "$@"
}

# The image that options name; nothing for an unknown robot or number, which is left to the program.
demo_image() {
  local robot app
  robot=$(option_of --robot scara "$@")
  case $(option_of --number float "$@") in
    float) app=feedforward ;;
    fixed32) app=feedforward-fixed ;;
    *) return ;;
  esac
  [[ ! -f $AXIAL_ROOT/host_sim/trajectories/$robot.json ]] || echo "$app-$robot"
}
