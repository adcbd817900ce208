# Cortex-M7 with a single-precision FPU (ARMv7E-M): STM32F746 and its kin; parts with double precision run it too.

set(AXIAL_CPU_FLAGS
  -mcpu=cortex-m7          # instruction set and pipeline model
  -mthumb                  # the only state a Cortex-M has
  -mfloat-abi=hard         # float arguments and results in FPU registers
  -mfpu=fpv5-sp-d16        # single precision only: a double is a library call
  -ffp-contract=fast)      # a fused multiply-add issues every cycle here and saves the add

include(${CMAKE_CURRENT_LIST_DIR}/arm_none_eabi.cmake)
