// The same arm in words of 32 bits: formats, bounds and the border to real numbers.
#include "arm.hpp"

#include <axial/fixed.hpp>
#include <axial/fixed/error_bound.hpp>

#include <cmath>
#include <cstdint>

using axial::Fixed32;

static_assert(axial::error_bound<Arm>(axial::algorithm::inverse_dynamics).worst() < 1e-3);

int main() {
  const axial::Joints<Arm, double> q{0.3, -0.5, 0.1}, qd{1.0, 0.5, 0.2}, qdd{2.0, 0.0, 1.0};
  const auto asked = axial::to_fixed_request<Arm, std::int32_t>(q, qd, qdd);
  const auto tau = axial::inverse_dynamics<Arm>(asked.q, asked.qd, asked.qdd);
  const auto words = axial::to_real<double>(tau);
  const auto exact = axial::inverse_dynamics<Arm>(q, qd, qdd);
  axial::FeedforwardState<Arm, Fixed32> state{};
  const auto safe = axial::feedforward<Arm>(state, asked.q, asked.qd, asked.qdd);
  const auto acc = axial::certified_forward_dynamics<Arm>(asked.q, asked.qd, tau);
  bool right = asked.status.ok() && safe.status.ok() && acc.status.ok();
  for (int i = 0; i < 3; ++i)
    right = right && std::fabs(words[i] - exact[i]) < 1e-3 && safe.tau[i].raw == tau[i].raw;
  return right ? 0 : 1;
}
