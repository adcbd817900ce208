#!/usr/bin/env bash
# The errors of a robot's kernels. usage: errors_of.sh ROOT ROBOT FILE
exec "$1/build/host-release/host_sim/errors/errors" --robot "$2" >"$3"
