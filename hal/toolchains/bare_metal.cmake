# What every bare-metal build shares. A CPU file sets AXIAL_CPU_FLAGS; a compiler's file sets AXIAL_TOOLS (the prefix of
# its programs) and, where it needs them, AXIAL_LIBRARY_FLAGS and AXIAL_LIBRARY_LINK_FLAGS, and then includes this one.

set(CMAKE_SYSTEM_NAME Generic)

set(CMAKE_C_COMPILER ${AXIAL_TOOLS}gcc)
set(CMAKE_CXX_COMPILER ${AXIAL_TOOLS}g++)
set(CMAKE_ASM_COMPILER ${AXIAL_TOOLS}gcc)

# CMake's compiler check must not link: without a board there is no memory map to link into.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)

if(NOT DEFINED AXIAL_LIVE_RANGE_FLAG)
  set(AXIAL_LIVE_RANGE_FLAG -flive-range-shrinkage)  # move definitions to their uses before allocation
endif()

string(JOIN " " AXIAL_COMMON_FLAGS
  ${AXIAL_CPU_FLAGS}
  ${AXIAL_LIBRARY_FLAGS}
  -O2                      # the level that every published size and count refers to
  -g                       # symbols for the debugger; takes no flash
  -ffunction-sections      # one section a function and object, so that the linker
  -fdata-sections          # can drop what an image does not use
  # Long straight-line code lives or dies by its registers: what these four save, ./axial size --flags tells
  # (doc/measurements/size.md, "Compiler flags"). The headers choose the same where a user's build does not
  # (firmware/include/axial/options).
  -fno-schedule-insns      # scheduling before register allocation lengthens lifetimes and spills more
  -fno-tree-ter            # keep the order in which the kernels are written
  ${AXIAL_LIVE_RANGE_FLAG}
  -frename-registers       # lets what is spilled share registers that fall free later
  -fno-math-errno          # sqrt is the instruction alone, not the instruction and a call that would set errno
  -fstack-usage)           # a .su file beside each object: stack bytes of every function

string(JOIN " " AXIAL_CXX_ONLY_FLAGS
  -fno-exceptions          # an error is a status here; unwinding tables would cost flash
  -fno-rtti                # nothing is virtual
  -fno-threadsafe-statics) # one core; a guard would pull in library code

# The flags above are the whole truth: no build type adds to them, and a build folder that is older than a change of them
# gets the change.
set(CMAKE_C_FLAGS "${AXIAL_COMMON_FLAGS}" CACHE STRING "set by the toolchain file" FORCE)
set(CMAKE_CXX_FLAGS "${AXIAL_COMMON_FLAGS} ${AXIAL_CXX_ONLY_FLAGS}" CACHE STRING "set by the toolchain file" FORCE)
foreach(type DEBUG RELEASE RELWITHDEBINFO MINSIZEREL)
  set(CMAKE_C_FLAGS_${type} "" CACHE STRING "set by the toolchain file" FORCE)
  set(CMAKE_CXX_FLAGS_${type} "" CACHE STRING "set by the toolchain file" FORCE)
endforeach()

string(JOIN " " CMAKE_EXE_LINKER_FLAGS_INIT
  -nostartfiles            # start-up code is ours: hal/<core>/start_up.cpp
  ${AXIAL_LIBRARY_LINK_FLAGS}
  -Wl,--gc-sections        # drop unused sections
  -Wl,--fatal-warnings)    # a linker warning is a mistake in the memory map
