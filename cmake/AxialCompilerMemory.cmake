# GCC collects its garbage from 256 MB on, again and again while it compiles templates; its objects are the same without that.
# Here from 1 GB on, where each of as many compilers as there are processors has 3 GB: a sanitized test takes nearly 2.
function(axial_collect_garbage_later)
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR share "${memory} / ${processors}")
  if(share GREATER 3000)
    add_compile_options("$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:SHELL:--param ggc-min-heapsize=500000>")
  endif()
endfunction()

axial_collect_garbage_later()
