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
  --json FILE         the figures of every joint once more, as an array of objects
Exits non-zero when an error is above its bound or a frame is lost.
END
}

run() {
  local board
  board=$(named_board "$@")
  ensure_packages
  build_host_sim
  [[ -z $board ]] || build "$board"
  host_sim demo "$@"
}
