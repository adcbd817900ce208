# Prints the C++ flags of a toolchain file: cmake -DTOOLCHAIN=FILE -P toolchain_flags.cmake. A build folder may still have older
# ones, because CMake reads them when it configures it for the first time.

include(${TOOLCHAIN})
execute_process(COMMAND ${CMAKE_COMMAND} -E echo "${AXIAL_COMMON_FLAGS} ${AXIAL_CXX_ONLY_FLAGS}")
