# axial_warnings: what our own tests, tools and images are compiled with. Never linked to axial::axial.
add_library(axial_warnings INTERFACE)
if(AXIAL_DEVELOPER)
  target_compile_options(axial_warnings INTERFACE -Wall -Wextra -Wconversion -Wdouble-promotion -Werror)
endif()
