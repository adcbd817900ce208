# usage: cmake -DMODULE=FOLDER -P zephyr.cmake: prints the include folders that the module's CMake adds.
cmake_minimum_required(VERSION 3.20)
function(zephyr_include_directories)
  foreach(folder IN LISTS ARGN)
    message(STATUS "include ${folder}")
  endforeach()
endfunction()
set(CONFIG_AXIAL y)
include(${MODULE}/CMakeLists.txt)
