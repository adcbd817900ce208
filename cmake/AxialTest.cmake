# axial_add_test(<name> <source>... [LIBS <library>...] [DEFINES <definition>...] [TIMEOUT <seconds>] [COST <seconds>] [SPLIT <parts>] [FEW_SPLIT <parts>]
#   [JOIN <sources> [APART <source>...]] [OPTIONS <option>...] [FEW_ROBOTS_SANITIZED] [ARITHMETIC_SANITIZED | ADDRESS_SANITIZED])
#
# A GoogleTest program linked to axial::axial, our warnings and the oracle; every TEST becomes a ctest test named
# <folder>.<Suite.Test>, with <folder>.<name> as its label. With FEW_ROBOTS_SANITIZED it is defined AXIAL_FEW_ROBOTS under
# sanitizers, and runs whole without them too. With ARITHMETIC_SANITIZED sanitizers see its arithmetic and the bounds of its arrays
# alone, a third of the time to compile: for kernels, which follow no pointer; every_kernel_test runs each kernel under the address sanitizer.
# In tests/property that is the default, and ADDRESS_SANITIZED asks for all of them. COST is how long the longest of its tests takes: those
# of over a minute begin first, so that no processor waits for the last one. With SPLIT n the one source becomes n programs, <name>_1 to
# <name>_n, with a part of its tests each (cmake/testing/split.py), FEW_SPLIT of them where there are few robots: the compiler of none
# takes over a minute or a gigabyte. With JOIN n its sources are compiled as n (cmake/testing/join.py), but for those that stand APART.
#
# Every test runs once: under the address and undefined-behaviour sanitizers (AXIAL_TESTS is sanitized), and those that these builds
# do without, in an ordinary build (unsanitized). Both together are all.
include(GoogleTest)

# What ./axial test chooses from: folder, program, where its sources are, these (with :<part>/<parts> behind one that is split).
set(AXIAL_TEST_PROGRAMS ${PROJECT_BINARY_DIR}/test_programs.txt)
file(WRITE ${AXIAL_TEST_PROGRAMS} "")

set(AXIAL_TESTS all CACHE STRING "all, sanitized or unsanitized")
set_property(CACHE AXIAL_TESTS PROPERTY STRINGS all sanitized unsanitized)

# Folders of tests/ that sanitizers see; the others start programs, images and compilers.
set(AXIAL_SANITIZED_FOLDERS oracle cases hal unit property simulation host_sim description import)
# Programs of these folders that sanitizers do without: every algorithm for many robots, minutes to compile when instrumented. They judge
# errors, not times: nothing is inlined by force, which would take the compiler up to three times as long.
set(AXIAL_UNSANITIZED_TESTS counts_test scene_counts_test tree_counts_test derivative_counts_test robots_test unrolled_test scenes_test shared_drives_test driven_derivatives_test driven_wrenches_test driven_rotors_test driven_turns_test driven_floating_base_test drawn_derivatives_test recorded_bounds_test shared_drives_fixed_test driven_forward_fixed_test driven_tool_fixed_test driven_payload_fixed_test driven_separation_fixed_test driven_derivatives_fixed_test drive_clusters_test driven_motion_test rotor_dynamics_test derivatives_test batch_elastic_test fixed_derivatives_test untuned_derivatives_test looped_derivatives_test along_test gallery_test drawn_machine_test
  floating_base_test underwater_test operation_counts_test errors_test forward_overflow_test fixed_error_test repeated_solves_test repeated_solves_by_halves_test motion_test cycle_test loop_test pushes_test observers_test
  linear_arm_test driven_regulator_test regulator_test c_interface_test
  untuned_forward_derivatives_test looped_forward_derivatives_test forward_derivatives_test forward_derivatives_bounds_test)

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

# axial_precompiled(<variable> <option>...): a target whose precompiled <gtest/gtest.h>, half a second of each source, programs with these options share.
function(axial_precompiled variable)
  string(MAKE_C_IDENTIFIER "axial_precompiled${ARGN}" name)
  if(NOT TARGET ${name})
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_compile_options(${name} PRIVATE ${ARGN})
    target_link_libraries(${name} PRIVATE GTest::gtest)
    target_precompile_headers(${name} PRIVATE <gtest/gtest.h> <cmath> <string> <vector>)
  endif()
  set(${variable} ${name} PARENT_SCOPE)
endfunction()

# axial_test_program(<folder> <name> <source>...): a program of tests, with what axial_add_test has parsed.
function(axial_test_program folder name)
  add_executable(${name} ${ARGN})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINES})
  if(arg_ARITHMETIC_SANITIZED AND AXIAL_TESTS STREQUAL sanitized)
    target_compile_options(${name} PRIVATE ${AXIAL_ARITHMETIC_SANITIZERS})
  endif()
  if(is_unsanitized)
    target_compile_options(${name} PRIVATE ${AXIAL_ERRORS_OPTIMISATION} -g0 -DAXIAL_USER_OPTIONS -DAXIAL_INLINE=)
  endif()
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  if(NOT ARGN MATCHES "[.]c(;|$)")
    get_target_property(options ${name} COMPILE_OPTIONS)
    list(FILTER options INCLUDE REGEX "^-(O|fno-sanitize)")
    axial_precompiled(precompiled ${options})
    target_precompile_headers(${name} REUSE_FROM ${precompiled})
  endif()
  target_link_libraries(${name} PRIVATE axial::axial axial_warnings ${arg_LIBS} GTest::gtest_main)
  if(TARGET axial_oracle)
    target_link_libraries(${name} PRIVATE axial_oracle)
  endif()
  gtest_discover_tests(${name} TEST_PREFIX ${folder}. NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS ${folder}.${name} TIMEOUT ${arg_TIMEOUT} COST ${arg_COST})
endfunction()

function(axial_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "FEW_ROBOTS_SANITIZED;ARITHMETIC_SANITIZED;ADDRESS_SANITIZED" "TIMEOUT;COST;SPLIT;FEW_SPLIT;JOIN" "LIBS;DEFINES;OPTIONS;APART")
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR FILENAME folder)
  axial_test_is_left_out(${name} ${folder} ${arg_FEW_ROBOTS_SANITIZED} left_out)
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
    set(arg_SPLIT ${arg_FEW_SPLIT})
  endif()
  if(folder IN_LIST AXIAL_ARITHMETIC_SANITIZED_FOLDERS AND NOT arg_ADDRESS_SANITIZED)
    set(arg_ARITHMETIC_SANITIZED TRUE)
  endif()
  set(is_unsanitized FALSE)
  if(name IN_LIST AXIAL_UNSANITIZED_TESTS)
    set(is_unsanitized TRUE)
  endif()
  if(NOT arg_SPLIT)
    set(compiled ${arg_UNPARSED_ARGUMENTS})
    list(APPEND arg_UNPARSED_ARGUMENTS ${arg_APART})
    if(arg_JOIN AND AXIAL_BATCHES)
      axial_joined_sources(${name} ${arg_JOIN} compiled)
    endif()
    axial_test_program(${folder} ${name} ${compiled} ${arg_APART})
    if(arg_JOIN AND AXIAL_BATCHES)
      axial_compiles_elsewhere(${name} ${arg_UNPARSED_ARGUMENTS})
    endif()
    list(JOIN arg_UNPARSED_ARGUMENTS " " sources)
    file(APPEND ${AXIAL_TEST_PROGRAMS} "${folder} ${name} ${CMAKE_CURRENT_SOURCE_DIR} ${sources}\n")
    return()
  endif()
  foreach(part RANGE 1 ${arg_SPLIT})
    axial_part_of_source(${arg_UNPARSED_ARGUMENTS} ${part} ${arg_SPLIT} source)
    axial_test_program(${folder} ${name}_${part} ${source})
    axial_compiles_elsewhere(${name}_${part} ${arg_UNPARSED_ARGUMENTS})
    target_compile_options(${name}_${part} PRIVATE -Wno-unused)  # what the other parts' tests need
    file(APPEND ${AXIAL_TEST_PROGRAMS} "${folder} ${name}_${part} ${CMAKE_CURRENT_SOURCE_DIR} ${arg_UNPARSED_ARGUMENTS}:${part}/${arg_SPLIT}\n")
  endforeach()
endfunction()

# axial_compiles_elsewhere(<program> <source>...): of sources that are written anew, what stands beside them is found; #line makes headers of them.
function(axial_compiles_elsewhere program)
  foreach(source ${ARGN})
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE whole)
    cmake_path(GET whole PARENT_PATH place)
    target_include_directories(${program} PRIVATE ${place})
  endforeach()
  target_compile_options(${program} PRIVATE -Wno-subobject-linkage)
endfunction()

# axial_joined_sources(<name> <count> <variable>): a program's sources as so many, of neighbours, written when one of them changes: small sources
# take the compiler less time together. cmake/testing/join.py says which can not be.
function(axial_joined_sources name count variable)
  set(join ${PROJECT_SOURCE_DIR}/cmake/testing/join.py)
  set(made ${${variable}})
  list(FILTER made EXCLUDE REGEX "[.]cpp$")  # headers that are written first
  list(FILTER ${variable} INCLUDE REGEX "[.]cpp$")
  list(LENGTH ${variable} all)
  set(from 0)
  foreach(part RANGE 1 ${count})
    math(EXPR to "${all} * ${part} / ${count}")
    math(EXPR length "${to} - ${from}")
    list(SUBLIST ${variable} ${from} ${length} sources)
    list(TRANSFORM sources PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    set(written ${CMAKE_CURRENT_BINARY_DIR}/joined/${name}_${part}.cpp)
    add_custom_command(OUTPUT ${written} DEPENDS ${sources} ${join} VERBATIM COMMAND /usr/bin/python3 -E -B ${join} ${written} ${sources})
    list(APPEND made ${written})
    set(from ${to})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/joined)
  set(${variable} ${made} PARENT_SCOPE)
endfunction()

# axial_part_of_source(<source> <part> <parts> <variable>): a part of a source's tests, written when the source changes.
function(axial_part_of_source source part parts variable)
  cmake_path(GET source STEM stem)
  set(written ${CMAKE_CURRENT_BINARY_DIR}/parts/${stem}_${part}.cpp)
  set(split ${PROJECT_SOURCE_DIR}/cmake/testing/split.py)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/parts)
  add_custom_command(OUTPUT ${written} DEPENDS ${source} ${split} VERBATIM
    COMMAND /usr/bin/python3 -E -B ${split} ${CMAKE_CURRENT_SOURCE_DIR}/${source} ${part} ${parts} ${written})
  set(${variable} ${written} PARENT_SCOPE)
endfunction()

# axial_test_needs(<test> [TARGETS <target>...] [IMAGES <board>[/<image>]...]): what ./axial test builds before a test that is no program of
# ours; of a board without an image, all that ./axial test builds for it.
function(axial_test_needs test)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TARGETS;IMAGES")
  list(TRANSFORM arg_TARGETS PREPEND "target:")
  list(TRANSFORM arg_IMAGES PREPEND "image:")
  set_property(TEST ${test} APPEND PROPERTY LABELS ${arg_TARGETS} ${arg_IMAGES})
endfunction()
