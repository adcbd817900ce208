// expect: closed_form::scara needs three joints: revolute, revolute, prismatic (RRP)
#include <axial/axial.hpp>
#include <robots/planar2r.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
using Robot = robots::Scara;
#else
using Robot = robots::Planar2r;
#endif

axial::Joints<Robot, float> q{};
auto terms = axial::closed_form::scara<Robot>(q);
