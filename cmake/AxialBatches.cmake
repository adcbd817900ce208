# axial_compile_in_batches(<library>...): their sources, eight to a compilation, for what they include takes longer to read than they do: a third of
# the seconds. Names that are a source's own differ within a library. AXIAL_BATCHES=OFF is for whoever asks how each source is compiled.
option(AXIAL_BATCHES "Sources of the host's libraries are compiled eight at a time, of test programs as JOIN says" ON)
mark_as_advanced(AXIAL_BATCHES)
function(axial_compile_in_batches)
  if(AXIAL_BATCHES)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
