// How much eliminating M(q) loses against ABA, over the whole chain or tree: what route.hpp judges by.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

inline constexpr double infinite_loss = 1e300;  ///< of a matrix that double cannot tell from a singular one

/// Inverse in place of a positive definite matrix, Gauss-Jordan without pivoting. Diagonal entries are 1 to begin with;
/// false where a pivot is lost.
template <int N>
constexpr bool invert(double (&c)[N][N], int n) {
  for (int k = 0; k < n; ++k) {
    if (!(c[k][k] > 1e-13)) return false;
    const double pivot = 1.0 / c[k][k];
    c[k][k] = 1.0;
    for (int j = 0; j < n; ++j)
      c[k][j] *= pivot;
    for (int i = 0; i < n; ++i) {
      const double factor = c[i][k];
      if (i == k || !(factor < 0.0 || factor > 0.0)) continue;
      c[i][k] = 0.0;
      for (int j = 0; j < n; ++j)
        c[i][j] -= factor * c[k][j];
    }
  }
  return true;
}

/// C^-1 of C = S^-1 M S^-1 with S = sqrt(diag M), S, and how far M in float is from M: in roundings of S_i S_j, at
/// least a quarter of one.
template <int N>
struct RoundedMatrix {
  double inverse[N][N] = {}, change[N][N] = {}, root[N] = {};
  bool invertible = true;

  template <class Exact, class Float>
  constexpr RoundedMatrix(const Exact& m, const Float& rounded, int n) {
    constexpr double rounding = 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon());
    for (int i = 0; i < n; ++i) {
      invertible = invertible && m(i, i) > 0.0;
      root[i] = square_root(m(i, i));
    }
    for (int i = 0; invertible && i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double size = root[i] * root[j], exact = m(i, j);
        const double apart = magnitude(static_cast<double>(rounded(i, j)) - exact) / (size * rounding);
        inverse[i][j] = exact / size, change[i][j] = apart > 0.25 ? apart : 0.25;
      }
    invertible = invertible && invert(inverse, n);
  }
};

/// What M's rounding makes of an effort on any one joint, in roundings of the largest acceleration that the effort
/// gives: |M^-1| |dM| |M^-1 e|.
template <int N>
constexpr double error_of_matrix(const RoundedMatrix<N>& m, int n) {
  double spread[N][N] = {}, worst = 0.0;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k)
      for (int l = 0; l < n; ++l)
        spread[j][l] += m.change[j][k] * magnitude(m.inverse[k][l]);
  for (int l = 0; l < n; ++l) {
    double largest = 0.0, error = 0.0;
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int j = 0; j < n; ++j)
        sum += magnitude(m.inverse[i][j]) * spread[j][l];
      const double moved = magnitude(m.inverse[i][l]) / m.root[i];
      largest = moved > largest ? moved : largest;
      error = sum / m.root[i] > error ? sum / m.root[i] : error;
    }
    worst = error > worst * largest ? error / largest : worst;
  }
  return worst;
}

/// Error of an elimination at one configuration, in roundings of the largest acceleration, from M there in double and
/// in float. To first order; measured errors of random chains were at most some three times it (tests/property).
template <int N, class Exact, class Float>
constexpr double elimination_error(const Exact& m, const Float& rounded, int n) {
  const RoundedMatrix<N> matrix(m, rounded, n);
  return matrix.invertible ? error_of_matrix(matrix, n) : infinite_loss;
}

inline constexpr int loss_samples = 12;  ///< configurations at which the error is computed

/// Where joint `joint` stands in configuration `sample` of them: inside its limits; without limits a revolute joint
/// anywhere on its circle, a slide as far as the arm's links are long. The first one is the arm as it is drawn.
constexpr double sampled_position(const LinkParameters* links, int size, int sample, int joint) {
  constexpr double half_turn = 3.14159265358979, unlimited = LinkParameters::unlimited;
  const auto& link = links[joint];
  double reach = half_turn;
  if (link.type == JointType::prismatic) {
    reach = 0.0;
    for (int i = 0; i < size; ++i)
      reach += magnitude(links[i].a) + magnitude(links[i].d);
  }
  const double low = link.position_min > -unlimited ? link.position_min : -reach;
  const double high = link.position_max < unlimited ? link.position_max : low + 2.0 * reach;
  if (sample == 0) return low > 0.0 ? low : high < 0.0 ? high : 0.0;
  const double step = 0.6180339887498949 + 0.1234567891 * joint;  // no two joints in step
  const double place = 0.25 + step * sample * (joint + 1);
  return low + (place - static_cast<double>(static_cast<int>(place))) * (high - low);
}

/// What of a scene M(q) feels, in the looped form.
template <class Scene, class... Features>
using FeltScene = std::conditional_t<Scene::template has<RotorInertia>,
                                     axial::Scene<typename Scene::Robot, Looped, RotorInertia, Features...>,
                                     axial::Scene<typename Scene::Robot, Looped, Features...>>;

// The declared payload at its largest, its centre of mass along one axis after the other.
template <class Robot, class T>
constexpr PayloadBody<T> largest_payload(int sample) {
  constexpr PayloadLimit limit = Robot::chain.payload_limit;
  const T arm = static_cast<T>(limit.com_reach), none = T(0), j = static_cast<T>(limit.inertia);
  const int axis = sample % 3;
  return {static_cast<T>(limit.mass),
          {axis == 0 ? arm : none, axis == 1 ? arm : none, axis == 2 ? arm : none},
          {j, j, j, none, none, none}};
}

template <class Scene, bool loaded, class T>
constexpr auto sampled_matrix(int sample) {
  using Robot = typename Scene::Robot;
  Positions<robot_of<Scene>, T> q{};
  for (int i = 0; i < Robot::chain.size; ++i)  // in double too the angle that float has
    q[i] = static_cast<T>(static_cast<float>(sampled_position(Robot::chain.links, Robot::chain.size, sample, i)));
  if constexpr (loaded) {
    Inputs<FeltScene<Scene, Payload>, T> in{};
    in.payload = largest_payload<Robot, T>(sample);
    return mass_matrix<FeltScene<Scene, Payload>>(q, in);
  } else {
    return mass_matrix<FeltScene<Scene>>(q);
  }
}

// One constant a configuration: compilers bound the steps of each.
template <class Scene, bool loaded, int sample>
inline constexpr double sampled_loss =
    elimination_error<Scene::Robot::chain.size>(sampled_matrix<Scene, loaded, double>(sample),
                                                sampled_matrix<Scene, loaded, float>(sample), Scene::Robot::chain.size);
template <class Scene, bool loaded, int... Sample>
constexpr double worst_loss(std::integer_sequence<int, Sample...>) {
  const double losses[] = {sampled_loss<Scene, loaded, Sample>...};
  double worst = 0.0;
  for (const double loss : losses)
    worst = loss > worst ? loss : worst;
  return worst;
}

/// The worst error of an elimination over the sampled configurations, in roundings of the largest acceleration. A
/// run-time payload counts as none and at the declared maximum; where none is declared it may lose anything.
template <class Scene>
constexpr double elimination_loss() {
  using Samples = std::make_integer_sequence<int, loss_samples>;
  constexpr double empty = worst_loss<Scene, false>(Samples{});
  if constexpr (!Scene::template has<Payload>) {
    return empty;
  } else if constexpr (!Scene::Robot::chain.payload_limit.declared) {
    return infinite_loss;
  } else {
    constexpr double loaded = worst_loss<Scene, true>(Samples{});
    return empty > loaded ? empty : loaded;
  }
}

/// Roundings of the largest acceleration that an elimination may lose where it is taken by default: sixteen times what
/// ABA loses of itself on well-conditioned arms, which grows with their joints to four roundings at seven of them. Half
/// as much where joints slide and axes are not all parallel: then slides and turns accelerate each other, and unlike
/// units are of unlike sizes.
constexpr double acceptable_loss(const LinkParameters* links, int size) {
  bool slides = false, twisted = false;
  for (int i = 0; i < size; ++i) {
    slides = slides || links[i].type == JointType::prismatic;
    twisted = twisted || magnitude(links[i].alpha.sin) > 0.0;
  }
  return (slides && twisted ? 32.0 : 64.0) * (size < 7 ? size : 7) / 7.0;
}
/// Whether an elimination of the scene's M(q) stays within that.
template <class Scene>
inline constexpr bool elimination_loses_little = elimination_loss<Scene>() <=
                                                 acceptable_loss(Scene::Robot::chain.links, Scene::Robot::chain.size);

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
