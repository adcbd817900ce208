# RV32IMAC (no FPU): small 32-bit RISC-V microcontrollers.

set(AXIAL_CPU_FLAGS
  -march=rv32imac          # integer multiply, atomics, short instructions
  -misa-spec=2.2           # of the edition that counts the control registers to I: named apart (_zicsr), they match none
                           # of the compiler's libraries
  -mabi=ilp32              # no FPU: floats in core registers, arithmetic by libgcc's routines
  -ffp-contract=off)       # nothing to fuse; stated so that constant folding follows the host's rules too

include(${CMAKE_CURRENT_LIST_DIR}/riscv64_unknown_elf.cmake)
