# cmake -DROOT=<project> -P tests.cmake: the names of the target tests, a line each. It reads the list that ctest gets.
function(add_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "COMMAND")
  message(NOTICE ${arg_NAME})
endfunction()
function(set_tests_properties)
endfunction()
function(add_executable)
endfunction()
function(target_link_libraries)
endfunction()
# Whatever is installed here: the list is that of a complete system.
function(find_program variable)
  set(${variable} ON PARENT_SCOPE)
endfunction()

include(${ROOT}/tests/target/CMakeLists.txt)
