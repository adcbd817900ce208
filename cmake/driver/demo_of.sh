#!/usr/bin/env bash
# The demo of one robot and board for the documents, which show one picture only. usage: demo_of.sh ROOT ROBOT BOARD
set -euo pipefail
root=$1 robot=$2 board=$3
echo "axial: $robot on $board"
"$root/build/${AXIAL_HOST_PRESET:-host-release}/host_sim/host_sim" demo --robot "$robot" --board "$board" --without-picture \
  --output "$root/output/demo" --json "$root/doc/data/demo-$robot-$board.json" >/dev/null
