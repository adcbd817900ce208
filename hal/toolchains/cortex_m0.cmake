# Cortex-M0 (ARMv6-M, no FPU, no long multiply): nRF51 and its kin.

set(AXIAL_CPU_FLAGS
  -mcpu=cortex-m0          # instruction set and pipeline model
  -mthumb                  # the only state a Cortex-M has
  -mfloat-abi=soft         # no FPU: floats in core registers, arithmetic by libgcc's routines
  -ffp-contract=off)       # nothing to fuse; stated so that constant folding follows the host's rules too

set(AXIAL_LIVE_RANGE_FLAG "")  # shrinking makes fixed point spill here: a tenth more instructions, two thirds more stack

include(${CMAKE_CURRENT_LIST_DIR}/arm_none_eabi.cmake)
