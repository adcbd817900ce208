# What each source of the host's builds costs its compiler, for structure.NoSourceIsHeavy and ./axial test --costs: a line per object in
# compile_costs.txt. In front of a compiler cache, which costs nothing.
if(NOT CMAKE_CROSSCOMPILING)
  list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/testing/compile_cost.py ${PROJECT_BINARY_DIR}/compile_costs.txt)
endif()
