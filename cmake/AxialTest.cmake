# axial_add_test(<name> <source>... [LIBS <library>...] [DEFINES <definition>...] [TIMEOUT <seconds>] [COST <seconds>] [FEW_ROBOTS_SANITIZED]
#   [ARITHMETIC_SANITIZED | ADDRESS_SANITIZED])
#
# A GoogleTest program linked to axial::axial, our warnings and the oracle; every TEST becomes a ctest test named
# <folder>.<Suite.Test> with the folder below tests/ as its label. With FEW_ROBOTS_SANITIZED it is defined AXIAL_FEW_ROBOTS under
# sanitizers, and runs whole without them too. With ARITHMETIC_SANITIZED sanitizers see its arithmetic and the bounds of its arrays
# alone, a third of the time to compile: for kernels, which follow no pointer; every_kernel_test runs each kernel under the address sanitizer.
# In tests/property that is the default, and ADDRESS_SANITIZED asks for all of them. COST is how long the longest of its tests takes: those
# of over a minute begin first, so that no processor waits for the last one.
#
# Every test runs once: under the address and undefined-behaviour sanitizers (AXIAL_TESTS is sanitized), and those that these builds
# do without, in an ordinary build (unsanitized). Both together are all.
include(GoogleTest)

set(AXIAL_TESTS all CACHE STRING "all, sanitized or unsanitized")
set_property(CACHE AXIAL_TESTS PROPERTY STRINGS all sanitized unsanitized)

# Folders of tests/ that sanitizers see; the others start programs, images and compilers.
set(AXIAL_SANITIZED_FOLDERS oracle cases hal unit property simulation host_sim description import)
# Programs of these folders that sanitizers do without: every algorithm for many robots, minutes to compile when instrumented. They judge
# errors, not times: nothing is inlined by force, which would take the compiler up to three times as long.
set(AXIAL_UNSANITIZED_TESTS counts_test robots_test unrolled_test scenes_test shared_drives_test driven_derivatives_test driven_wrenches_test driven_rotors_test driven_turns_test driven_floating_base_test drawn_derivatives_test shared_drives_fixed_test driven_forward_fixed_test driven_tool_fixed_test driven_payload_fixed_test driven_separation_fixed_test driven_derivatives_fixed_test drive_clusters_test driven_motion_test driven_regressor_test rotor_dynamics_test derivatives_test fixed_derivatives_test untuned_derivatives_test looped_derivatives_test along_test
  floating_base_test underwater_test operation_counts_test errors_test forward_overflow_test fixed_error_test repeated_solves_test repeated_solves_by_halves_test motion_test cycle_test loop_test pushes_test observers_test
  linear_arm_test driven_regulator_test regulator_test c_interface_test
  untuned_forward_derivatives_test looped_forward_derivatives_test forward_derivatives_test)

# Folders of kernels over many robots.
set(AXIAL_ARITHMETIC_SANITIZED_FOLDERS property)

set(AXIAL_ARITHMETIC_SANITIZERS -fno-sanitize=address,null,alignment,object-size,vptr,pointer-overflow)

# axial_arithmetic_sanitized(<source>...): sources that do little but instantiate kernels; the standard library's own assertions watch
# their containers.
function(axial_arithmetic_sanitized)
  if(AXIAL_TESTS STREQUAL sanitized)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS ${AXIAL_ARITHMETIC_SANITIZERS})
  endif()
endfunction()

# axial_test_is_left_out(<name> <label> <both> <variable>): whether this build does without it.
function(axial_test_is_left_out name label both variable)
  set(instrumented FALSE)
  if(label IN_LIST AXIAL_SANITIZED_FOLDERS AND NOT name IN_LIST AXIAL_UNSANITIZED_TESTS)
    set(instrumented TRUE)
  endif()
  set(${variable} FALSE PARENT_SCOPE)
  if((AXIAL_TESTS STREQUAL sanitized AND NOT instrumented) OR (AXIAL_TESTS STREQUAL unsanitized AND instrumented AND NOT both))
    set(${variable} TRUE PARENT_SCOPE)
  endif()
endfunction()

function(axial_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FEW_ROBOTS_SANITIZED;ARITHMETIC_SANITIZED;ADDRESS_SANITIZED" "TIMEOUT;COST" "LIBS;DEFINES")
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME label)
  axial_test_is_left_out(${name} ${label} ${arg_FEW_ROBOTS_SANITIZED} left_out)
  if(left_out)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  if(NOT arg_COST)
    set(arg_COST 0)
  endif()
  if(arg_FEW_ROBOTS_SANITIZED AND AXIAL_TESTS STREQUAL sanitized)
    list(APPEND arg_DEFINES AXIAL_FEW_ROBOTS=1)
  endif()
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINES})
  if(label IN_LIST AXIAL_ARITHMETIC_SANITIZED_FOLDERS AND NOT arg_ADDRESS_SANITIZED)
    set(arg_ARITHMETIC_SANITIZED TRUE)
  endif()
  if(arg_ARITHMETIC_SANITIZED AND AXIAL_TESTS STREQUAL sanitized)
    target_compile_options(${name} PRIVATE ${AXIAL_ARITHMETIC_SANITIZERS})
  endif()
  if(name IN_LIST AXIAL_UNSANITIZED_TESTS)
    target_compile_options(${name} PRIVATE ${AXIAL_ERRORS_OPTIMISATION} -g0 -DAXIAL_USER_OPTIONS -DAXIAL_INLINE=)
  endif()
  target_link_libraries(${name} PRIVATE axial::axial axial_warnings ${arg_LIBS} GTest::gtest_main)
  if(TARGET axial_oracle)
    target_link_libraries(${name} PRIVATE axial_oracle)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${label}. NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT} COST ${arg_COST})
endfunction()
