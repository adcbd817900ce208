# axial_add_test(<name> <source>... [LIBS <library>...] [DEFINES <definition>...] [TIMEOUT <seconds>])
#
# A GoogleTest program linked to axial::axial, our warnings and the oracle; every TEST becomes a ctest test named
# <folder>.<Suite.Test> with the folder below tests/ as its label.
include(GoogleTest)

set(AXIAL_TESTS_LEFT_OUT "" CACHE STRING "Test programs that this build does without")

function(axial_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TIMEOUT" "LIBS;DEFINES")
  if(name IN_LIST AXIAL_TESTS_LEFT_OUT)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME label)
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINES})
  target_link_libraries(${name} PRIVATE axial::axial axial_warnings ${arg_LIBS} GTest::gtest_main)
  if(TARGET axial_oracle)
    target_link_libraries(${name} PRIVATE axial_oracle)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${label}. NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT})
endfunction()
