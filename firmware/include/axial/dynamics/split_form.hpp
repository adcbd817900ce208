// Forward dynamics in the split form: the bias torque by RNEA, then the structure at rest under what is left of tau.
#pragma once

#include <axial/dynamics/free_response.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace aba {

/// One answer in numbers of unlimited range, each acceleration as it comes.
struct PlainAnswer {
  /// Writes the accelerations under tau - bias.
  template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
  AXIAL_INLINE static constexpr auto of(const Links& links, const Screws& screws, const Structure& structure,
                                        const Tau& tau, const Bias& bias, A& qdd) {
    auto drive = map_links(links, [&](auto i) AXIAL_INLINE { return tau[i] - bias[i]; });
    Unwatched watch;
    const auto lost = respond(links, screws, structure, drive, watch,
                              [&](auto i, const auto& own) AXIAL_INLINE { links.write(qdd, i, own); });
    return status_of<Links>(lost, false);
  }
};

/// How the structure answers what drives it, over links that compute by `Scalar`; a number system with formats has its
/// own way.
template <class Scalar>
struct SplitAnswer {
  /// the way over these links
  template <class Links>
  using Over = PlainAnswer;
};

/// The algorithm over any form of links; `bias_links` are those of the bias torque, which may be of base parameters.
struct SplitForm {
  /// status of the accelerations that it writes
  template <class Links, class BiasLinks, class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const BiasLinks& bias_links, const Input& in, const Q& q,
                                         const V& qd, const Tau& tau, A& qdd) {
    auto at = links.read(q);
    auto screws = joint_screws(links, in, at);
    auto bias = bias_links.no_efforts();
    if constexpr (detail::stages_apart<Links>)
      detail::called([&]()
                         AXIAL_INLINE { rnea::efforts(bias_links, in, at, screws, links.read(qd), NoMotion{}, bias); });
    else
      rnea::efforts(bias_links, in, at, screws, links.read(qd), NoMotion{}, bias);
    auto structure = structure_at_rest(links, in, screws);
    auto given = links.read(tau);
    auto left = links.read(bias);
    using Answer = typename SplitAnswer<typename Links::Scalar>::template Over<Links>;
    return Answer::of(links, screws, structure, given, left, qdd);
  }
};

}  // namespace aba
}  // namespace axial

#include <axial/options/end.hpp>
