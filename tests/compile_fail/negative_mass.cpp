// expect: mass_is_negative_give_kg_of_0_or_more
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>

#ifdef MENDED
constexpr double mass = 1.0;
#else
constexpr double mass = -1.0;
#endif

struct Robot {
  static constexpr auto chain = axial::chain(axial::revolute().mass(1.0).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01),
                                             axial::revolute().mass(mass).com(0.1, 0, 0).inertia_com(0.01, 0.01, 0.01));
};
// Kernels say nothing more of a robot that does not compile.
axial::FeedforwardState<Robot, float> state{};
auto effort(const axial::Joints<Robot, float>& q) { return axial::inverse_dynamics<Robot>(q, q, q); }
auto accelerate(const axial::Joints<Robot, float>& q) { return axial::forward_dynamics<Robot>(q, q, q); }
auto inertia(const axial::Joints<Robot, float>& q) { return axial::mass_matrix<Robot>(q); }
auto terms(const axial::Joints<Robot, float>& q) { return axial::separate<Robot>(q); }
auto pose(const axial::Joints<Robot, float>& q) { return axial::forward_kinematics<Robot>(q); }
auto step(const axial::Joints<Robot, float>& q) { return axial::feedforward<Robot>(state, q, q, q); }
