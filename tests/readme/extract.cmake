# cmake -DREADME=... -DOUTPUT=... -P extract.cmake: writes the first C++ block of the README to a file.
file(READ ${README} text)
string(REGEX MATCH "```cpp\n([^`]*)```" block "${text}")
if(NOT block)
  message(FATAL_ERROR "${README} has no C++ block")
endif()
file(WRITE ${OUTPUT} "${CMAKE_MATCH_1}")
