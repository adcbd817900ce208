# ccache makes a clean build after a small change quick; nothing needs it.
find_program(AXIAL_CCACHE ccache)
mark_as_advanced(AXIAL_CCACHE)
if(AXIAL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${AXIAL_CCACHE})
endif()
