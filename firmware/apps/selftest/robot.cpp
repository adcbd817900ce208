/// The dynamics of one robot on the target, against a closed form and against themselves, in float and in double.

#include <robot.hpp>

#include <string_view>

#include <axial/axial.hpp>

#include "../states.hpp"
#include "check.hpp"
#include "verdict.hpp"

namespace axial::apps {
namespace {

constexpr std::uint32_t seed = 0x20240921;
constexpr int states = 20;
constexpr int joints = joint_count<Robot>;
constexpr bool is_scara = std::string_view(Robot::name) == "scara";
/// Soft double takes flash: a board with less tests float alone.
constexpr bool has_room_for_double = hal::Board::flash_bytes >= 256 * 1024;

/// Bounds on |error| over the largest value of the vector (or 1).
template <class T>
struct Tolerance;
template <>
struct Tolerance<float> {
  static constexpr float sum = 4e-6f;        ///< 64 roundings of 2^-24
  static constexpr float inversion = 1e-4f;  ///< what the project states for float
};
template <>
struct Tolerance<double> {
  static constexpr double sum = 8e-15;        ///< 64 roundings of 2^-53
  static constexpr double inversion = 1e-11;  ///< what the project states for double
};

template <class T>
T magnitude(T x) {
  return x < 0 ? -x : x;
}

template <class T>
bool agree(const T* a, const T* b, T tolerance) {
  T scale = 1;
  for (int i = 0; i < joints; ++i)
    scale = magnitude(b[i]) > scale ? magnitude(b[i]) : scale;
  for (int i = 0; i < joints; ++i) {
    if (!(magnitude(a[i] - b[i]) <= tolerance * scale)) return false;
  }
  return true;
}

/// tau = M(q) qdd + bias(q, qd).
template <class T>
bool splits_into_mass_and_bias(const MotionState<Robot, T>& s, const Joints<Robot, T>& tau) {
  auto sum = bias_torque<Robot>(s.q, s.qd);
  const auto m = mass_matrix<Robot>(s.q);
  for (int r = 0; r < joints; ++r)
    for (int c = 0; c < joints; ++c)
      sum[r] += m(r, c) * s.qdd[c];
  return agree(&sum[0], &tau[0], Tolerance<T>::sum);
}

template <class T>
bool is_undone_by_forward_dynamics(const MotionState<Robot, T>& s, const Joints<Robot, T>& tau) {
  const auto qdd = forward_dynamics<Robot>(s.q, s.qd, tau);
  return qdd.status.ok() && agree(&qdd[0], &s.qdd[0], Tolerance<T>::inversion);
}

/// The paper's closed form shares no code with the recursion.
template <class T>
bool equals_the_closed_form(const MotionState<Robot, T>& s, const Joints<Robot, T>& tau) {
  if constexpr (is_scara) {
    const auto closed = closed_form::scara_torque<Robot>(s.q, s.qd, s.qdd);
    return agree(&closed[0], &tau[0], Tolerance<T>::sum);
  } else {
    return true;
  }
}

template <class T>
[[gnu::noinline]] void check_state(Checks& check, const MotionState<Robot, T>& s) {
  const auto tau = inverse_dynamics<Robot>(s.q, s.qd, s.qdd);
  check.that(splits_into_mass_and_bias(s, tau), "tau = M qdd + bias");
  check.that(is_undone_by_forward_dynamics(s, tau), "forward dynamics undoes inverse dynamics");
  check.that(equals_the_closed_form(s, tau), "inverse dynamics equals the closed form");
}

template <class T>
void check_states(Checks& check) {
  Random random(seed);
  for (int i = 0; i < states; ++i)
    check_state(check, next_state<Robot, T>(random));
}

}  // namespace
}  // namespace axial::apps

int main() {
  using namespace axial::apps;
  Board::start();
  Checks checks;
  Board::print(Robot::name);
  Board::print("\n");
  check_states<float>(checks);
  if constexpr (has_room_for_double) check_states<double>(checks);
  give_verdict(checks);
}
