#include <host_sim/robots/identification/parameters.hpp>

namespace host_sim::identification {

namespace {

enum Name { m, mx, my, mz, xx, yy, zz, xy, xz, yz, rotor, viscous, forward, backward };

// m (c^2 1 - c c^T) of a point mass, as xx yy zz xy xz yz.
std::array<double, 6> of_point(double mass, const double (&c)[3]) {
  const double x = c[0], y = c[1], z = c[2];
  return {mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),
          -mass * x * y,          -mass * x * z,          -mass * y * z};
}

}  // namespace

Parameters to_parameters(const axial::LinkParameters& link) {
  Parameters p{link.mass, link.mass * link.com[0], link.mass * link.com[1], link.mass * link.com[2]};
  const auto point = of_point(link.mass, link.com);
  for (std::size_t i = 0; i < 6; ++i)
    p[xx + i] = link.inertia_com[i] + point[i];
  p[rotor] = link.gear * link.gear * link.rotor_inertia;
  p[viscous] = link.viscous, p[forward] = link.coulomb_forward, p[backward] = link.coulomb_backward;
  return p;
}

axial::LinkParameters with_parameters(axial::LinkParameters link, const Parameters& p) {
  link.mass = p[m];
  for (std::size_t i = 0; i < 3; ++i)
    link.com[i] = p[m] > 0.0 ? p[mx + i] / p[m] : 0.0;
  const auto point = of_point(link.mass, link.com);
  for (std::size_t i = 0; i < 6; ++i)
    link.inertia_com[i] = p[xx + i] - point[i];
  link.rotor_inertia = p[rotor] / (link.gear * link.gear);
  link.viscous = p[viscous], link.coulomb_forward = p[forward], link.coulomb_backward = p[backward];
  return link;
}

axial::LinkParameters without_parameters(const axial::LinkParameters& link) { return with_parameters(link, {}); }

}  // namespace host_sim::identification
