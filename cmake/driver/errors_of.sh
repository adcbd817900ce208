#!/usr/bin/env bash
# The errors of a robot's kernels, by the program AXIAL_ERRORS_PROGRAM. usage: errors_of.sh ROBOT FILE
exec "$AXIAL_ERRORS_PROGRAM" --robot "$1" >"$2"
