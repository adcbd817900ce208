# axial_command_line(<source>...): sources that read a program's options, call what does the work and write what it found.
# Nobody waits for them; the headers that they include cost the compiler twice the time with optimisation.
function(axial_command_line)
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-O0;-g0;-DAXIAL_USER_OPTIONS")
endfunction()
