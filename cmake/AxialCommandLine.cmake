# axial_command_line(<source>...): sources that read a program's options and call what does the work. CLI11 costs the compiler
# twice the time with optimisation, and nobody waits for options.
function(axial_command_line)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-O0;-g0")
endfunction()
