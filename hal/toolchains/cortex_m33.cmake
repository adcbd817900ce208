# Cortex-M33 with the single-precision FPU (ARMv8-M Mainline): STM32U5, nRF5340 and their kin.

set(AXIAL_CPU_FLAGS
  -mcpu=cortex-m33         # instruction set and pipeline model
  -mthumb                  # the only state a Cortex-M has
  -mfloat-abi=hard         # float arguments and results in FPU registers
  -mfpu=fpv5-sp-d16        # single precision only: a double is a library call
  -ffp-contract=off)       # float results equal the host's bit for bit

include(${CMAKE_CURRENT_LIST_DIR}/arm_none_eabi.cmake)
