# Hazard3 as the RP2350 has it: RV32IMAC with bit manipulation, no FPU.

set(AXIAL_CPU_FLAGS
  -march=rv32imac_zicsr_zifencei_zba_zbb_zbkb  # of what the part has, Zcb and Zcmp are younger than this compiler,
                           # and with Zbs it ends in an internal error at the constant 0x800
  -mabi=ilp32              # no FPU: floats in core registers, arithmetic by libgcc's routines
  -ffp-contract=off)       # nothing to fuse; stated so that constant folding follows the host's rules too

# The last -march chooses the compiler's library; it has one for RV32IMAC by this edition of its name, and none with Zba.
set(AXIAL_CPU_LINK_FLAGS -march=rv32imac -misa-spec=2.2)

include(${CMAKE_CURRENT_LIST_DIR}/riscv64_unknown_elf.cmake)
