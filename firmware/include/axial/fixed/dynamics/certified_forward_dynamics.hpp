// Forward dynamics in fixed point with a certificate of each answer: its residual by inverse dynamics, and the
// structure's answers to one drive per joint as an approximate inverse of the mass matrix.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/dynamics/driven_certificate.hpp>
#include <axial/fixed/dynamics/enclosure.hpp>
#include <axial/fixed/dynamics/forward_dynamics.hpp>
#include <axial/fixed/dynamics/inverse_dynamics.hpp>
#include <axial/fixed/error_bound.hpp>
#include <axial/fixed/recursion/steps.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// What of an enclosure no state changes: accelerations in words of requests, efforts in words of motions.
template <class S, class T>
struct Certificate {
  using Scene = scene_of<S>;
  using Needs = Joints<Scene, T, role::MotionEffort>;
  using Requests = Accelerations<robot_of<S>, T>;
  using Answers = FreeAccelerations<S, T>;
  static constexpr int size = joint_count<S>;

  std::int32_t need_error[size] = {}, twice_error[size] = {};  ///< of inverse dynamics, and of a difference of two
  int column_shift[size] = {}, widest = 0;           ///< of the structure's accelerations to those of requests
  int drive_shift[size] = {};                        ///< of the structure's efforts to those of motions
  std::int64_t inside[size] = {}, tight[size] = {};  ///< declared acceleration; a bound that is of use

  static constexpr Certificate made() {
    Certificate c;
    c.limit();
    if constexpr (!Scene::template has<Looped>) c.use_structure(std::make_integer_sequence<int, size>{});
    return c;
  }

 private:
  constexpr void limit() {
    double largest = 0.0;
    for (const auto& link : detail::described_by<S>::chain.links)
      largest = link.acceleration_limit > largest ? link.acceleration_limit : largest;
    for (int i = 0; i < size; ++i) {
      const double unit = power_of_two(Requests::exponent(i));
      inside[i] = static_cast<std::int64_t>(detail::described_by<S>::chain.links[i].acceleration_limit * unit);
      tight[i] = static_cast<std::int64_t>(largest * unit / 128.0);
    }
  }
  template <int... I>
  constexpr void use_structure(std::integer_sequence<int, I...>) {
    using Structure = decltype(links_of<Scene, T, FullParameters, recursion::ArticulatedBodiesAtRest>());
    constexpr int accelerations[] = {decltype(Structure::link(Index<I>{}))::format.joint_acceleration...};
    constexpr int efforts[] = {decltype(Structure::link(Index<I>{}))::format.joint_effort...};
    constexpr auto& needs = ranges_for<Scene, typename T::Word, BaseParameters, recursion::MotionEfforts>;
    for (int i = 0; i < size; ++i) {
      need_error[i] = rounded_up(needs.range[i].joint_effort.error * power_of_two(Needs::exponent(i)));
      twice_error[i] = 2 * need_error[i];
      column_shift[i] = Requests::exponent(i) - accelerations[i];
      widest = i == 0 || column_shift[i] > widest ? column_shift[i] : widest;
      drive_shift[i] = Needs::exponent(i) - efforts[i];
    }
  }
};
template <class S, class T>
inline constexpr auto certificate_of = Certificate<S, T>::made();

/// Accelerations of the structure under a drive of joint `j` alone, as large as formats leave room for; returns the
/// exponent of that drive's word.
template <int solves = 3, class Links, class Screws, class Structure>
AXIAL_INLINE constexpr int unit_response(const Links& links, const Screws& screws, const Structure& structure, int j,
                                         std::int32_t* answer) {
  constexpr int first = smaller(12, 26 - Links::halvings()), start = first < 4 ? 4 : first, most = 28;
  int magnified = 0;
  for (int k = 0; k < solves; ++k) {
    Headroom room(magnified);
    stage<has_few_registers>([&]() AXIAL_INLINE {
      const auto drive = map_links(links, [&](auto i) AXIAL_INLINE {
        constexpr int to = decltype(links.link(i))::format.joint_effort;
        return Fx<to, typename Links::Scalar>{select(static_cast<int>(i) == j, 1 << (start + magnified), 0)};
      });
      static_cast<void>(aba::respond(links, screws, structure, drive, room,
                                     [&](auto i, const auto& own) AXIAL_INLINE { answer[i] = own.raw; }));
    });
    if (k + 1 < solves) magnified = aba::least_of(magnified + room.magnification(), most - start);
  }
  return start + magnified;
}

/// What was answered for joint i, in the words of requests.
template <class S, class T>
AXIAL_INLINE constexpr std::int64_t in_requests(const CertifiedDynamics<S, T>& answer, int i) {
  using C = Certificate<S, T>;
  const int up = C::Requests::exponent(i) - C::Answers::exponent(i);
  return up > 0 ? std::int64_t{answer[i].raw} * (std::int64_t{1} << (up > 31 ? 31 : up))
                : std::int64_t{answer[i].raw >> (up < -31 ? 31 : -up)};
}

/// The answer in the words of requests, held within what is declared; false where it was beyond.
template <class S, class T>
AXIAL_INLINE constexpr bool requested(const CertifiedDynamics<S, T>& answer, typename Certificate<S, T>::Requests& x) {
  using C = Certificate<S, T>;
  bool inside = true;
  for (int i = 0; i < C::size; ++i) {
    const std::int64_t most = certificate_of<S, T>.inside[i], raw = in_requests(answer, i);
    const bool below = is_less_wide(raw, -most), above = is_less_wide(most, raw);
    const auto held = static_cast<std::int32_t>(select_wide(below, -most, select_wide(above, most, raw)));
    x.values[i] = {held};
    inside = inside & !below & !above;
  }
  return inside;
}

/// The corrected answer and its bound, of a system in words of requests.
template <class S, class T, class System>
AXIAL_INLINE constexpr bool publish(CertifiedDynamics<S, T>& answer, const System& system,
                                    const typename Certificate<S, T>::Requests& x, bool known) {
  using C = Certificate<S, T>;
  return publish_in_words<C::size>(
      answer, system, certificate_of<S, T>.tight, known, [&x](int i) AXIAL_INLINE { return x[i].raw; },
      [](int i) AXIAL_INLINE { return C::Requests::exponent(i) - C::Answers::exponent(i); });
}

/// The system at a state: columns by the structure, and what M makes of them and of x by one inverse dynamics.
template <class S, class T>
AXIAL_INLINE constexpr void fill(Enclosure<joint_count<S>>& system, const Positions<robot_of<S>, T>& q,
                                 const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
                                 const typename Certificate<S, T>::Requests& x, const Inputs<S, T>& in) {
  using C = Certificate<S, T>;
  constexpr const auto& c = certificate_of<S, T>;
  const auto links = links_of<scene_of<S>, T, FullParameters, recursion::ArticulatedBodiesAtRest>();
  const auto needs_links = links_of<scene_of<S>, T, BaseParameters, recursion::MotionEfforts>();
  const auto at = links.read(q);
  const auto screws = joint_screws(links, in, at);
  const auto structure = aba::structure_at_rest(links, in, screws);
  typename C::Needs needs{}, bias{};
  for (int k = -1; k <= C::size; ++k) {
    typename C::Requests moving = x;
    if (k < C::size) moving = {};
    if (k >= 0 && k < C::size) {
      std::int32_t column[C::size] = {};
      const int drive = unit_response(links, screws, structure, k, column);
      set_shifted_column<C::size>(c, system, k, column, drive);
      for (int i = 0; i < C::size; ++i)
        moving.values[i] = {system.inverse[i][k]};
    }
    stage<has_few_registers>([&]() AXIAL_INLINE {
      rnea::efforts(needs_links, in, at, screws, needs_links.read(qd), needs_links.read(moving), needs);
    });
    if (k < 0) bias = needs;
    if (k >= 0 && k < C::size) {
      std::int64_t made[C::size] = {};
      for (int i = 0; i < C::size; ++i)
        made[i] = std::int64_t{needs[i].raw} - bias[i].raw;
      system.set_defects(k, made, c.twice_error);
    }
  }
  const auto given = links.read(tau);
  const auto left = links.read(needs);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    system.residual[i] = exact_difference(given[i], left[i]);
    system.residual_error[i] = c.need_error[i];
  });
}

}  // namespace detail

/// Forward dynamics in 32 bits with a bound of each acceleration's error. The plain answer's residual by inverse
/// dynamics, of proved error, is solved for once more, which refines the answer, and bounds what is left of it whatever
/// the solve lost to rounding (enclosure.hpp).
/// In and out as forward_dynamics(), and `bound`: |exact - acceleration| in its format, where the robot is what it
/// declares and the inputs are what their words say. Status: that of the plain answer; else inaccurate where a bound is
/// above a 128th of the largest declared acceleration, and acceleration_limit where it is so because the answer is
/// beyond what is declared. The largest word stands for a bound that is not known.
/// Cost: forward dynamics, and for each joint an inverse dynamics and three solves. Where joints share drives M in
/// words takes the place of inverse dynamics, answers may be of any size, and what a bound is compared with is the
/// drive's own declared acceleration.
template <class S, class T>
[[nodiscard]] constexpr CertifiedDynamics<S, T> certified_forward_dynamics(const Positions<robot_of<S>, T>& q,
                                                                           const Velocities<robot_of<S>, T>& qd,
                                                                           const EffortsOf<S, T>& tau,
                                                                           const Inputs<S, T>& in = no_inputs<S, T>()) {
  static_assert(std::is_same_v<T, Fixed32>, "axial: answers are certified in Fixed32");
  if constexpr (!std::is_same_v<T, Fixed32>) {
    return {};
  } else if constexpr (detail::has_shared_drives<S>) {
    return detail::DrivenCertificate<S, T>::answer(q, qd, tau, in);
  } else {
    using C = detail::Certificate<S, T>;
    CertifiedDynamics<S, T> answer{};
    static_cast<ForwardDynamics<S, T>&>(answer) = forward_dynamics<S>(q, qd, tau, in);
    typename C::Requests x{};
    const bool inside = detail::requested<S>(answer, x);

    detail::Enclosure<C::size> system;
    detail::fill<S, T>(system, q, qd, tau, x, in);
    const bool answered = detail::is_answer(answer.status.code), known = system.enclose() & answered;
    const bool tight = detail::publish<S, T>(answer, system, x, known);
    answer.status = detail::certified_status(answer.status, inside, tight);
    return answer;
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
