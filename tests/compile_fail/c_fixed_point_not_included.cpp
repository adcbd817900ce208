// expect: fixed point is a plug-in: add #include <axial/fixed/c_interface/fixed_calls.hpp>
#include <axial/c_interface/export.hpp>
#ifdef MENDED
#include <axial/fixed/c_interface/fixed_calls.hpp>
#endif
#include <robots/planar2r.hpp>

AXIAL_C_DECLARE(arm, 2, fixed32);
AXIAL_C_EXPORT(arm, robots::Planar2r, fixed32)
