# What every bare-metal Arm build shares: Debian's gcc-arm-none-eabi with newlib. A CPU file sets AXIAL_CPU_FLAGS and then
# includes this one.

set(CMAKE_SYSTEM_PROCESSOR arm)
set(AXIAL_TOOLS arm-none-eabi- CACHE INTERNAL "Prefix of the compiler's programs")

set(AXIAL_LIBRARY_LINK_FLAGS
  --specs=nano.specs)      # the small newlib for memcpy and the like. No nosys.specs: whatever would need the
                           # heap or a file then fails to link, because _sbrk and _write do not exist

include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
