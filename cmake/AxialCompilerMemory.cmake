# GCC collects its garbage from 256 MB on, again and again while it compiles templates; its objects are the same without that.
# Here from 150 MB on: from 500 on it takes 4 % less of a processor and up to 240 MB more, and no source may take over a gigabyte.
function(axial_collect_garbage_later)
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR share "${memory} / ${processors}")
  if(share GREATER 1500)
    add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:SHELL:--param ggc-min-heapsize=150000>")
  endif()
endfunction()

# Checks of addresses as calls instead of some instructions each: the same checks, of an instrumented source a seventh less of a processor.
# A program that runs for long takes OPTIONS ${AXIAL_ADDRESS_CHECKS_IN_LINE}, GCC's default: it runs in half of the time.
set(AXIAL_ADDRESS_CHECKS_IN_LINE)
function(axial_check_addresses_by_calls)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_FLAGS_DEBUG MATCHES "-fsanitize=address")
    add_compile_options($<$<CONFIG:Debug>:--param=asan-instrumentation-with-call-threshold=0>)
    set(AXIAL_ADDRESS_CHECKS_IN_LINE --param=asan-instrumentation-with-call-threshold=7000 PARENT_SCOPE)
  endif()
endfunction()

axial_collect_garbage_later()
axial_check_addresses_by_calls()
