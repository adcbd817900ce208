// Separated terms in values of drives that joints share.
#pragma once

#include <axial/dynamics/separation.hpp>
#include <axial/links/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// A, B, C and G of the drives from those of the joints, efforts and rates by G: A_u = G^T A G, and likewise the
/// coefficients of products. Only those of the four that Out has room for are computed.
template <class Out, class S, class T, class Links, class Input, class U>
constexpr Out separated(const Links& links, const Input& in, const U& u) {
  static_assert(!Links::Scene::template has<RotorDynamics>,
                "axial: separate() has no rotors as bodies; take RotorDynamics out of the scene, or use "
                "inverse_dynamics, bias_torque and mass_matrix");
  using Joint = typename Links::JointScene;
  using Whole = Separated<Joint, T>;
  const auto joints = separation::collected<Whole, Joint, T>(links.joints(), in, links.positions(u));
  constexpr int n = Links::size, m = Links::capacity;
  Out out{};
  // What the joints' coefficients of one effort make of a pair of drives: sum of C_j G_jk G_jl and half of B_jp.
  const auto pair_of = [&](int i, int k, int l) {
    T sum(Zero{});
    for (int j = 0; j < n; ++j) {
      const T jk = links.ratio(j, k), jl = links.ratio(j, l);
      sum = sum + joints.C[i][j] * (jk * jl);
      for (int p = j + 1; p < n; ++p)
        sum = sum + joints.B[i][Whole::pair(j, p)] *
                        (NumberTraits<T>::constant(0.5) * (jk * links.ratio(p, l) + jl * links.ratio(p, k)));
    }
    return sum;
  };
  links.each_drive([&](auto a) {
    const int d = a;
    for (int i = 0; i < n; ++i) {
      const T felt = links.ratio(i, d);
      if constexpr (std::is_base_of_v<SeparatedG<S, T>, Out>) out.G[d] = out.G[d] + felt * joints.G[i];
      for (int k = 0; k < m; ++k) {
        if constexpr (std::is_base_of_v<SeparatedA<S, T>, Out>)
          for (int j = 0; j < n; ++j)
            out.A[d][k] = out.A[d][k] + felt * joints.A[i][j] * links.ratio(j, k);
        if constexpr (std::is_base_of_v<SeparatedC<S, T>, Out>) out.C[d][k] = out.C[d][k] + felt * pair_of(i, k, k);
        if constexpr (std::is_base_of_v<SeparatedB<S, T>, Out>)
          for (int l = k + 1; l < m; ++l) {
            T& entry = out.B[d][Out::pair(k, l)];
            entry = entry + NumberTraits<T>::constant(2.0) * (felt * pair_of(i, k, l));
          }
      }
    }
    if constexpr (std::is_base_of_v<SeparatedA<S, T>, Out>) out.A[d][d] = out.A[d][d] + links.drives().link(a).rotor();
  });
  if constexpr (std::is_same_v<Out, Separated<S, T>>) out.status = joints.status;
  return out;
}

}  // namespace driven
}  // namespace axial

#include <axial/options/end.hpp>
