# What every bare-metal RISC-V build shares: Debian's gcc-riscv64-unknown-elf with picolibc. A CPU file sets
# AXIAL_CPU_FLAGS and then includes this one.

set(CMAKE_SYSTEM_PROCESSOR riscv)
set(AXIAL_TOOLS riscv64-unknown-elf- CACHE INTERNAL "Prefix of the compiler's programs")

# Debian has no C++ headers for this compiler. Those of its Arm newlib, for the same compiler version and the same sizes of
# every type, serve: only what lives in headers is used, and nothing of libstdc++ is linked.
file(GLOB cxx_headers /usr/include/newlib/c++/12.*)
if(NOT cxx_headers)
  message(FATAL_ERROR "No C++ headers in /usr/include/newlib/c++: install libstdc++-arm-none-eabi-dev")
endif()

set(AXIAL_LIBRARY_FLAGS
  --specs=picolibc.specs   # memcpy and the like; C headers. Linking sees these flags too
  -fno-asynchronous-unwind-tables)  # nothing unwinds
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${cxx_headers} ${cxx_headers}/arm-none-eabi)
set(AXIAL_LIBRARY_LINK_FLAGS -nodefaultlibs)  # there is no libstdc++ to link
set(CMAKE_CXX_STANDARD_LIBRARIES "-lm -lc -lgcc")

include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
