// expect: rotors as bodies are a header of their own
#include <axial/dynamics/inverse_dynamics.hpp>
#ifdef MENDED
#include <axial/transmissions/rotor_dynamics.hpp>
#endif
#include <robots/scara.hpp>

using S = axial::Scene<robots::Scara, axial::Gravity, axial::RotorInertia, axial::RotorDynamics>;

auto tau(const axial::Joints<robots::Scara, float>& q) { return axial::inverse_dynamics<S>(q, q, q); }
