# cmake -DCOMPILER= -DOTHERS= -DSOURCE= -DROOT= -P check.cmake
# A result that is thrown away is an error, as it is in our presets.
set(command ${COMPILER} -std=c++17 -fsyntax-only -Werror=unused-result -I${ROOT}/firmware/include -I${ROOT} ${SOURCE})
file(STRINGS ${SOURCE} first LIMIT_COUNT 1)
string(REGEX REPLACE "^// expect: " "" expected "${first}")
string(REPLACE "\\;" ";" expected "${expected}") # file(STRINGS) escapes a semicolon
if(NOT first MATCHES "^// expect: .")
  message(FATAL_ERROR "${SOURCE} must begin with '// expect: <part of the message>'")
endif()

execute_process(COMMAND ${command} -DMENDED RESULT_VARIABLE mended ERROR_VARIABLE output)
if(NOT mended EQUAL 0)
  message(FATAL_ERROR "the mended source does not compile:\n${output}")
endif()

# "// standard: c++14": what the broken source is compiled as.
file(STRINGS ${SOURCE} head LIMIT_COUNT 4)
set(standard c++17)
if(head MATCHES "// standard: ([a-z0-9+]+)")
  set(standard ${CMAKE_MATCH_1})
endif()
list(TRANSFORM command REPLACE "-std=c\\+\\+17" "-std=${standard}")
execute_process(COMMAND ${command} RESULT_VARIABLE broken ERROR_VARIABLE output)
if(broken EQUAL 0)
  message(FATAL_ERROR "it compiles")
endif()
string(FIND "${output}" "${expected}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the message does not say '${expected}':\n${output}")
endif()

# "// within: 5 lines": what this compiler and the others say first.
if(NOT head MATCHES "// within: ([0-9]+) lines")
  return()
endif()
set(most ${CMAKE_MATCH_1})
foreach(compiler IN LISTS COMPILER OTHERS)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C ${compiler} -std=${standard} -fsyntax-only -I${ROOT}/firmware/include
                          -I${ROOT} ${SOURCE} ERROR_VARIABLE output)
  string(FIND "${output}" "${expected}" place)
  string(SUBSTRING "${output}" 0 ${place} before)
  string(REGEX REPLACE "[^\n]" "" ends "${before}")
  string(LENGTH "${ends}" lines_before)
  if(place EQUAL -1 OR NOT lines_before LESS most)
    message(FATAL_ERROR "${compiler} does not say '${expected}' within ${most} lines:\n${output}")
  endif()
  # "// at most: 12 lines" in all, but for Clang's line that counts its errors.
  string(REGEX REPLACE "\n[0-9]+ errors? generated\\.\n$" "\n" counted "${output}")
  string(REGEX REPLACE "[^\n]" "" ends "${counted}")
  string(LENGTH "${ends}" lines)
  if(head MATCHES "// at most: ([0-9]+) lines" AND lines GREATER CMAKE_MATCH_1)
    message(FATAL_ERROR "${compiler} says ${lines} lines:\n${output}")
  endif()
endforeach()
