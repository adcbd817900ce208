// expect: AXIAL_C_DECLARE and AXIAL_C_EXPORT disagree about the numbers
// within: 5 lines
#include <axial/c_interface/export.hpp>
#include <robots/planar2r.hpp>

#ifdef MENDED
AXIAL_C_DECLARE(arm, 2, double);
#else
AXIAL_C_DECLARE(arm, 2, float);
#endif
AXIAL_C_EXPORT(arm, robots::Planar2r, double)
