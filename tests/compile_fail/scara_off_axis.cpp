// expect: closed_form::scara needs centres of mass on the links' x axes
#include <axial/axial.hpp>

struct Robot {
#ifdef MENDED
  static constexpr double y = 0.0;
#else
  static constexpr double y = 0.05;
#endif
  static constexpr auto chain =
      axial::chain(axial::revolute().mass(1).com(0.1, 0, 0), axial::revolute().a(0.3).mass(1).com(0.1, y, 0),
                   axial::prismatic().a(0.2).alpha_deg(180).mass(1));
};

axial::Joints<Robot, float> q{};
auto terms = axial::closed_form::scara<Robot>(q);
