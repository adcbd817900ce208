// expect: the linearly implicit step does not know joints that share drives
#include <axial/axial.hpp>
#include <axial/simulation/integrators.hpp>
#include <robots/gripper.hpp>

struct Drive {
  template <class Instant, class Tau, class In>
  constexpr void operator()(const Instant&, Tau&, In&) const {}
};
#ifdef MENDED
using Method = axial::RungeKutta4;
#else
using Method = axial::LinearlyImplicitEuler;
#endif

auto step(axial::CompensatedMotion<robots::Gripper, double>& x) { return axial::advance<Method>(x, 1e-3, Drive{}); }
