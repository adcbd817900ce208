# Cortex-M0+ (ARMv6-M, no FPU, no long multiply): RP2040 and its kin.

set(AXIAL_CPU_FLAGS
  -mcpu=cortex-m0plus      # instruction set and pipeline model: two stages, a taken branch takes 2 cycles
  -mthumb                  # the only state a Cortex-M has
  -mfloat-abi=soft         # no FPU: floats in core registers, arithmetic by libgcc's routines
  -ffp-contract=off)       # nothing to fuse; stated so that constant folding follows the host's rules too

set(AXIAL_LIVE_RANGE_FLAG "")  # as on the Cortex-M0, whose instructions these are: shrinking makes fixed point spill

include(${CMAKE_CURRENT_LIST_DIR}/arm_none_eabi.cmake)
