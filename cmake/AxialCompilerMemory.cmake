# GCC collects its garbage from 256 MB on, again and again while it compiles templates; its objects are the same without that.
# Here from 150 MB on, of tests under sanitizers from 300: that takes 3 to 9 % less of a processor than 150, and from 450 on sources take
# over a gigabyte, which none may.
function(axial_collect_garbage_later)
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR share "${memory} / ${processors}")
  set(kilobytes 150000)
  if(AXIAL_TESTS STREQUAL sanitized)
    set(kilobytes 300000)
  endif()
  if(share GREATER 1500)
    add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:SHELL:--param ggc-min-heapsize=${kilobytes}>")
  endif()
endfunction()

axial_collect_garbage_later()
