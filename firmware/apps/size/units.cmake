# Units: sources of several kernels. Those of a robot, its numbers and a contract are compiled together, which saves a third of
# the time. What shares more than steps that are inlined anyway is in another unit, so that each comes out as if it were
# alone: an algorithm and one that calls it, unrolled and compact forms, and on RISC-V all that has real constants, which a
# source keeps in one pool. Of a user's robot each kernel is in its own: only those asked for are compiled.

set(calling_algorithms "^(forward_dynamics|feedforward|torque_by_separation|separated_torque)|_(derivatives|along|feedforward)$")

# unit_of(<variable> <set> <robot> <scene> <algorithm> <variant> <contract> <numbers>): the name of its source
function(unit_of variable set robot scene algorithm variant contract numbers)
  suffix(ending ${numbers})
  set(unit ${set}-${robot}-${variant}-${contract}${ending})
  if(algorithm MATCHES "${calling_algorithms}")
    string(APPEND unit -${algorithm})
  endif()
  if(robot STREQUAL own OR (AXIAL_TOOLS MATCHES riscv AND NOT numbers MATCHES fixed))
    string(APPEND unit -of-${scene}-${algorithm})
  endif()
  set(${variable} ${unit} PARENT_SCOPE)
endfunction()

# unit(<unit> <robot> <contract> <numbers>): the object of a source that write_units makes
function(unit unit robot contract numbers)
  if(TARGET size-kernels-${unit})
    return()
  endif()
  add_library(size-kernels-${unit} OBJECT EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${unit}.cpp)
  use_library(size-kernels-${unit} ${robot} ${numbers})
  target_precompile_headers(size-kernels-${unit} REUSE_FROM size-headers)
  # No debug data: a third of the time. Nor a note that GCC 10 mended how it passes some structures.
  target_compile_options(size-kernels-${unit} PRIVATE -ffp-contract=${contract} -g0 -Wno-psabi)
  set_property(GLOBAL APPEND PROPERTY axial_units ${unit})
endfunction()

# name_of(<variable> <scene> <algorithm> <variant> <numbers>): a kernel's name in its object
function(name_of variable scene algorithm variant numbers)
  suffix(ending ${numbers})
  string(REPLACE "-" "_" ending "${ending}")
  set(${variable} ${scene}_${algorithm}_${variant}${ending} PARENT_SCOPE)
endfunction()

set(tag_of_unrolled "")
set(tag_of_compact ", Looped")
# add_kernel(<unit> <kernel> <scene> <algorithm> <variant>): one kernel more
function(add_kernel unit kernel scene algorithm variant)
  set_property(GLOBAL APPEND_STRING PROPERTY axial_kernels_${unit} "\
extern \"C\" void ${kernel}(void* argument) {
  run<algorithms::${algorithm}, System::scene<scenes::${scene}, Robot${tag_of_${variant}}>>(argument);
}
")
endfunction()

# write_units(): every unit's source, once all kernels are known
function(write_units)
  get_property(units GLOBAL PROPERTY axial_units)
  foreach(unit IN LISTS units)
    get_property(kernels GLOBAL PROPERTY axial_kernels_${unit})
    configure_file(kernels.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/${unit}.cpp @ONLY)
  endforeach()
endfunction()

# cut_out(<object> <unit> <kernel>): one kernel of a unit as axial_kernel, with what it needs alone: even routines that only
# other kernels call would make the linker choose others from the compiler's library.
function(cut_out object unit kernel)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
  add_custom_command(OUTPUT ${object} DEPENDS $<TARGET_OBJECTS:size-kernels-${unit}> VERBATIM
    COMMAND ${CMAKE_CXX_COMPILER} ${flags} -r -nostdlib -Wl,--gc-sections,-e,${kernel},-u,${kernel}
            $<TARGET_OBJECTS:size-kernels-${unit}> -o ${object}
    COMMAND ${CMAKE_OBJCOPY} -w --strip-unneeded --keep-symbol=$* --redefine-sym ${kernel}=axial_kernel ${object})
  set_source_files_properties(${object} PROPERTIES HEADER_FILE_ONLY TRUE)  # link_last links it
endfunction()

# link_last(<image> <object>): behind all that an image has, next to the compiler's library, where RISC-V's calls are short
function(link_last image object)
  target_sources(${image} PRIVATE ${object})
  target_link_libraries(${image} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${object})
  set_target_properties(${image} PROPERTIES LINK_DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/${object})
endfunction()
