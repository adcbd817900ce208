# What every bare-metal RISC-V build shares: Debian's gcc-riscv64-unknown-elf without a library. A CPU file
# sets AXIAL_CPU_FLAGS and then includes this one.

set(CMAKE_SYSTEM_PROCESSOR riscv)
set(AXIAL_TOOLS riscv64-unknown-elf- CACHE INTERNAL "Prefix of the compiler's programs")

# Debian has no C++ headers for this compiler. Those of its Arm newlib, for the same compiler version and the same sizes of
# every type, serve, with newlib's C headers: only what lives in headers is used.
file(GLOB cxx_headers /usr/include/newlib/c++/12.*)
if(NOT cxx_headers)
  message(FATAL_ERROR "No C++ headers in /usr/include/newlib/c++: install libstdc++-arm-none-eabi-dev")
endif()
set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES ${cxx_headers} ${cxx_headers}/arm-none-eabi /usr/include/newlib)

set(AXIAL_LIBRARY_FLAGS -fno-asynchronous-unwind-tables)  # nothing unwinds
set(AXIAL_LIBRARY_LINK_FLAGS ${AXIAL_CPU_LINK_FLAGS} -nodefaultlibs)  # memcpy and its like are ours: hal/riscv/memory_functions.cpp
set(CMAKE_CXX_STANDARD_LIBRARIES -lgcc)       # soft float

include(${CMAKE_CURRENT_LIST_DIR}/bare_metal.cmake)
