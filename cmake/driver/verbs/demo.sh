# shellcheck shell=bash
# summary: streams a pick-and-place cycle to the emulated firmware; torques, errors, cost, a picture
# group: use

usage() {
  cat <<'END'
usage: ./axial demo [options]
Installs and builds what is missing, starts the feed-forward firmware of a board in its emulator, streams a pick-and-place
cycle to it tick by tick, compares every torque with the oracle, prints a table and writes CSV, JSON and a picture.
  --robot ROBOT|DRIVEN  scara (default), scara_rrpr, puma560, panda, planar2r; whose joints share drives: scara_quill, palletiser,
                      wrist_arm, gripper. Of these values, torques and errors are the drives'
  --board BOARD       stm32f405 (default), stm32f100, nrf51, rv32_virt, rp2040, rp2040_ram
  --number float|fixed32  what the firmware computes in; default float (fixed32: 32-bit fixed point; the wire stays float)
  --trajectory IN_FILE  way-points (.json as in host_sim/robots/trajectories) or set-points (.csv: time, q..., qd..., qdd...)
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
  ensure_runner "$board"
  build_host_sim
  build "$board" "$image"
  host_sim demo "$@"
}

# The image that options name.
demo_image() {
  local robot app
  robot=$(option_of --robot scara "$@")
  case $(option_of --number float "$@") in
    float) app=feedforward ;;
    fixed32) app=feedforward-fixed ;;
  esac
  echo "$app-$robot"
}
