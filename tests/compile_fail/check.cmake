# cmake -DCOMPILER= -DSOURCE= -DROOT= -P check.cmake
# A result that is thrown away is an error, as it is in our presets.
set(command ${COMPILER} -std=c++17 -fsyntax-only -Werror=unused-result -I${ROOT}/firmware/include -I${ROOT} ${SOURCE})
file(STRINGS ${SOURCE} first LIMIT_COUNT 1)
string(REGEX REPLACE "^// expect: " "" expected "${first}")
if(expected STREQUAL first OR expected STREQUAL "")
  message(FATAL_ERROR "${SOURCE} must begin with '// expect: <part of the message>'")
endif()

execute_process(COMMAND ${command} -DMENDED RESULT_VARIABLE mended ERROR_VARIABLE output)
if(NOT mended EQUAL 0)
  message(FATAL_ERROR "the mended source does not compile:\n${output}")
endif()

execute_process(COMMAND ${command} RESULT_VARIABLE broken ERROR_VARIABLE output)
if(broken EQUAL 0)
  message(FATAL_ERROR "it compiles")
endif()
string(FIND "${output}" "${expected}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the message does not say '${expected}':\n${output}")
endif()
