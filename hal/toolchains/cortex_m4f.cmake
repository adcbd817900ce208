# Cortex-M4 with the single-precision FPU (ARMv7E-M): STM32F405 and its kin.

set(AXIAL_CPU_FLAGS
  -mcpu=cortex-m4          # instruction set and pipeline model
  -mthumb                  # the only state a Cortex-M has
  -mfloat-abi=hard         # float arguments and results in FPU registers
  -mfpu=fpv4-sp-d16        # single precision only: a double is a library call, which a test on symbols forbids
  -ffp-contract=off)       # no fused multiply-add: it takes 3 cycles here, as vmul and vadd do together, so it gains
                           # only code size; off, float results equal the host's bit for bit

include(${CMAKE_CURRENT_LIST_DIR}/arm_none_eabi.cmake)
