// How much eliminating M(q) loses against ABA, over the whole chain or tree: what route.hpp judges by.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/scalar/math.hpp>

namespace axial {
namespace detail {

inline constexpr int loss_samples = 12;  ///< configurations that the loss is computed at

/// M(q) over its diagonal, C = M_ij / sqrt(M_ii M_jj), or its inverse; and the roots of the diagonal.
template <int N>
struct ScaledMatrix {
  double of[N][N] = {};  ///< C or its inverse
  double root[N] = {};   ///< sqrt(M_ii)
  bool positive = true;  ///< whether M is positive definite, as far as double can tell
};

// C by its inverse, Gauss-Jordan in place: a positive definite matrix needs no pivoting.
template <int N>
constexpr void invert(ScaledMatrix<N>& c) {
  for (int k = 0; k < N; ++k) {
    c.positive = c.positive && c.of[k][k] > 1e-13;
    if (!c.positive) return;
    const double pivot = 1.0 / c.of[k][k];
    c.of[k][k] = 1.0;
    for (int j = 0; j < N; ++j)
      c.of[k][j] *= pivot;
    for (int i = 0; i < N; ++i) {
      const double factor = c.of[i][k];
      if (i == k || !(factor < 0.0 || factor > 0.0)) continue;
      c.of[i][k] = 0.0;
      for (int j = 0; j < N; ++j)
        c.of[i][j] -= factor * c.of[k][j];
    }
  }
}

// Where a joint is sampled: inside its limits, a revolute joint without limits anywhere on its circle, a slide without
// limits as far as the arm's links are long.
template <class Robot>
constexpr double sampled_position(int sample, int joint) {
  constexpr double half_turn = 3.14159265358979, unlimited = LinkParameters::unlimited;
  const auto& link = Robot::chain.links[joint];
  double reach = half_turn;
  if (link.type == JointType::prismatic) {
    reach = 0.0;
    for (const auto& other : Robot::chain.links)
      reach += magnitude(other.a) + magnitude(other.d);
  }
  const double low = link.position_min > -unlimited ? link.position_min : -reach;
  const double high = link.position_max < unlimited ? link.position_max : low + 2.0 * reach;
  const double first = low > 0.0 ? low : high < 0.0 ? high : 0.0;  // the arm as it is drawn, as near as limits allow
  const double step = 0.6180339887498949 + 0.1234567891 * joint;   // irrational enough: no two joints in step
  const double place = 0.25 + step * sample * (joint + 1);
  return sample == 0 ? first : low + (place - static_cast<double>(static_cast<int>(place))) * (high - low);
}

// The scene's structure as the looped form sees it: its rotors, and the declared payload at its largest.
template <class Scene>
struct SampledScene {
  using Robot = typename Scene::Robot;
  using type = std::conditional_t<
      Scene::template has<Payload>,
      std::conditional_t<Scene::template has<RotorInertia>, axial::Scene<Robot, Looped, RotorInertia, Payload>,
                         axial::Scene<Robot, Looped, Payload>>,
      std::conditional_t<Scene::template has<RotorInertia>, axial::Scene<Robot, Looped, RotorInertia>,
                         axial::Scene<Robot, Looped>>>;
};

template <class Scene, class T>
constexpr auto sampled_matrix(int sample, bool loaded) {
  using Sampled = typename SampledScene<Scene>::type;
  using Robot = typename Scene::Robot;
  Positions<Robot, T> q{};
  for (int i = 0; i < Robot::chain.size; ++i)
    q[i] = static_cast<T>(static_cast<float>(sampled_position<Robot>(sample, i)));
  Inputs<Sampled, T> in{};
  if constexpr (Scene::template has<Payload>) {
    constexpr PayloadLimit limit = Robot::chain.payload_limit;
    const T arm = static_cast<T>(loaded ? limit.com_reach : 0.0), j = static_cast<T>(loaded ? limit.inertia : 0.0);
    in.payload.mass = static_cast<T>(loaded ? limit.mass : 0.0);
    in.payload.com = {sample % 3 == 0 ? arm : T(0), sample % 3 == 1 ? arm : T(0), sample % 3 == 2 ? arm : T(0)};
    in.payload.inertia_com = {j, j, j, T(0), T(0), T(0)};
  }
  return mass_matrix<Sampled>(q, in);
}

/// Error of an elimination at one configuration, in roundings of the largest acceleration: the larger of what M's own
/// rounding makes of an effort on the weakest joint, |M^-1| |dM| |M^-1 e|, with dM as float really has it (at least a
/// quarter of a rounding), and of what the bias torque's rounding makes, ||(M^-1)_i sqrt(diag M)|| ||sqrt(diag M)||.
template <class Scene, int sample, bool loaded>
constexpr double loss_at() {
  constexpr int n = Scene::Robot::chain.size;
  constexpr double beyond = 1e300, rounding = 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const auto m = sampled_matrix<Scene, double>(sample, loaded);
  const auto rounded = sampled_matrix<Scene, float>(sample, loaded);
  ScaledMatrix<n> c;
  double diagonal = 0.0, change[n][n] = {}, spread[n][n] = {};
  for (int i = 0; i < n; ++i) {
    if (!(m(i, i) > 0.0)) return beyond;
    c.root[i] = square_root(m(i, i)), diagonal += m(i, i);
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double size = c.root[i] * c.root[j];
      const double error = magnitude(static_cast<double>(rounded(i, j)) - m(i, j)) / (size * rounding);
      c.of[i][j] = m(i, j) / size, change[i][j] = error > 0.25 ? error : 0.25;
    }
  invert(c);
  if (!c.positive) return beyond;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n; ++l)
        spread[j][l] += change[j][k] * magnitude(c.of[k][l]);
  double worst = 0.0;
  for (int l = 0; l < n; ++l) {
    double largest = 0.0;
    for (int k = 0; k < n; ++k) {
      const double moved = magnitude(c.of[k][l]) / c.root[k];
      largest = moved > largest ? moved : largest;
    }
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int j = 0; j < n; ++j)
        sum += magnitude(c.of[i][j]) * spread[j][l];
      const double error = sum / (c.root[i] * largest);
      worst = error > worst ? error : worst;
    }
  }
  for (int i = 0; i < n; ++i) {
    double row = 0.0;
    for (int j = 0; j < n; ++j)
      row += c.of[i][j] * c.of[i][j];
    const double error = square_root(row * diagonal) / c.root[i];
    worst = error > worst ? error : worst;
  }
  return worst;
}
// One constant a configuration: compilers bound the steps of each.
template <class Scene, int sample, bool loaded>
inline constexpr double sampled_loss = loss_at<Scene, sample, loaded>();
template <class Scene, bool loaded, int... Sample>
constexpr double worst_loss(std::integer_sequence<int, Sample...>) {
  double worst = 0.0;
  ((worst = sampled_loss<Scene, Sample, loaded> > worst ? sampled_loss<Scene, Sample, loaded> : worst), ...);
  return worst;
}

/// The worst error of an elimination over sampled configurations, in roundings of the largest acceleration. A payload
/// counts at the declared maximum, and as beyond all bounds where none is declared.
template <class Scene>
constexpr double elimination_loss() {
  using Samples = std::make_integer_sequence<int, loss_samples>;
  if constexpr (!Scene::template has<Payload>) {
    return worst_loss<Scene, false>(Samples{});
  } else if constexpr (!Scene::Robot::chain.payload_limit.declared) {
    return 1e300;
  } else {
    constexpr double empty = worst_loss<Scene, false>(Samples{}), loaded = worst_loss<Scene, true>(Samples{});
    return empty > loaded ? empty : loaded;
  }
}

/// Roundings of the largest acceleration that an elimination may lose where it is taken by default: sixteen times four,
/// which is what ABA loses of itself on well-conditioned arms.
inline constexpr double acceptable_loss = 64.0;
/// Whether an elimination of the scene's M(q) stays within that.
template <class Scene>
inline constexpr bool elimination_loses_little = elimination_loss<Scene>() <= acceptable_loss;

}  // namespace detail
}  // namespace axial
