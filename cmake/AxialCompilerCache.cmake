# ccache makes a clean build after a small change quick; nothing needs it. It stores what is compiled with precompiled headers
# only if told that their macros, and those of date and time, do not matter.
find_program(AXIAL_CCACHE ccache)
mark_as_advanced(AXIAL_CCACHE)
if(AXIAL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros ${AXIAL_CCACHE})
endif()
