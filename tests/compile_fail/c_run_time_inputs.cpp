// expect: the C interface has no run-time inputs and no floating base
// within: 5 lines
#include <axial/c_interface/export.hpp>
#include <robots/planar2r.hpp>

#ifdef MENDED
using Arm = axial::Scene<robots::Planar2r, axial::Gravity, axial::Friction>;
#else
using Arm = axial::Scene<robots::Planar2r, axial::Gravity, axial::Payload>;
#endif
AXIAL_C_DECLARE(arm, 2, float);
AXIAL_C_EXPORT(arm, Arm, float)
