// What resists a force at the tool: the inertia of the arm as the tool feels it, and its inverse.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/tool/tool_motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A symmetric 6 x 6 matrix over the tool's directions: 0 to 2 turn about world x, y, z, 3 to 5 move along them.
template <class T>
struct ToolMatrix {
  static constexpr int size = 6;  ///< directions
  T values[21] = {};              ///< lower triangle, row by row
  Status status{};                ///< see the function that answered it

  [[nodiscard]] constexpr T& operator()(int i, int j) { return values[at(i, j)]; }  ///< entry (i, j), either way round
  /// Entry (i, j), either way round.
  [[nodiscard]] constexpr const T& operator()(int i, int j) const { return values[at(i, j)]; }

 private:
  [[nodiscard]] static constexpr int at(int i, int j) { return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i; }
};

/// The directions of a task: true for those that it is about.
struct Directions {
  bool of[6] = {true, true, true, true, true, true};  ///< turns about x, y, z; moves along x, y, z
};
inline constexpr Directions all_directions{};                                        ///< a pose
inline constexpr Directions position_only{{false, false, false, true, true, true}};  ///< a point

namespace detail {

template <class T>
using Column = MotionVector<Vec3<T>, Vec3<T>>;

// m += s v v^T
template <class T>
AXIAL_INLINE constexpr void add_square(ToolMatrix<T>& m, const T& s, const Column<T>& v) {
  const T entries[] = {v.angular.x, v.angular.y, v.angular.z, v.linear.x, v.linear.y, v.linear.z};
  for (int i = 0, k = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j, ++k)
      m.values[k] = m.values[k] + s * entries[i] * entries[j];
}

// u - s v
template <class T>
AXIAL_INLINE constexpr Column<T> less(const Column<T>& u, const T& s, const Column<T>& v) {
  return {u.angular - s * v.angular, u.linear - s * v.linear};
}

// Eliminates joint k from M and from the columns, which are then those of joints that leave it free.
template <class R, class T>
constexpr void eliminate(MassMatrix<R, T>& m, Jacobian<R, T>& columns, int k, const T& inverse) {
  for (int i = 0; i < k; ++i) {
    const T gain = m(k, i) * inverse;
    for (int j = 0; j <= i; ++j)
      m.set(i, j, m(i, j) - gain * m(k, j));
    columns[i] = less(columns[i], gain, columns[k]);
  }
}

// A pivot, judged against what it was before anything was subtracted.
template <class T>
constexpr bool is_left(const T& pivot, const T& whole, const T& least) {
  return pivot > least * whole;
}

}  // namespace detail

/// How a wrench at the tool accelerates it, with free joints: a = J M^-1 J^T w, per kg, per kg m and per kg m^2; what
/// the joints make of velocities and gravity comes on top. Rotors and the payload count as the scene names them. It
/// exists at every position, and is singular where the tool cannot move in some direction. Status: near_singular names
/// a joint that nothing resists, which counts as locked; else that of jacobian().
template <class S, class T>
[[nodiscard]] constexpr ToolMatrix<T> tool_mobility(const Positions<robot_of<S>, T>& q,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_real<T>();
  auto m = mass_matrix<S>(q, in);
  auto columns = jacobian<S>(q, in);
  const auto whole = m;
  ToolMatrix<T> result;
  int lost = -1;
  for (int k = joint_count<S>; k-- > 0;) {
    const bool left = detail::is_left(m(k, k), whole(k, k), T(16) * std::numeric_limits<T>::epsilon());
    const T inverse = left ? T(1) / m(k, k) : T(0);
    detail::add_square(result, inverse, columns[k]);
    detail::eliminate(m, columns, k, inverse);
    lost = left ? lost : k;
  }
  result.status = columns.status.ok() && lost >= 0 ? Status{Status::Code::near_singular, lost} : columns.status;
  return result;
}

/// Task-space inertia, the inverse of tool_mobility() over the task's directions (Khatib 1987): kg m^2, kg m, kg; zero
/// in the others. Near a singularity the other directions nearly determine some direction: where less than `least` of
/// its mobility is its own (0.001: about 2 degrees), the answer is zero and the status near_singular, about no joint.
/// An arm of fewer than six joints is always singular over all six: name the directions that it moves in.
template <class T>
[[nodiscard]] constexpr ToolMatrix<T> task_space_inertia(const ToolMatrix<T>& mobility,
                                                         const Directions& task = all_directions,
                                                         const T& least = T(0.001)) {
  // Each sweep over a diagonal entry keeps the matrix symmetric; all of them make it minus the inverse.
  constexpr T rounding = T(16) * std::numeric_limits<T>::epsilon();
  T a[6][6] = {};
  bool singular = false;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      a[i][j] = mobility(i, j);
  for (int k = 0; k < 6; ++k) {
    if (!task.of[k]) continue;
    const bool left = detail::is_left(a[k][k], mobility(k, k), rounding);
    singular = singular || !left;
    const T inverse = left ? T(1) / a[k][k] : T(0);
    for (int i = 0; i < 6; ++i) {
      const T gain = a[i][k] * inverse;
      for (int j = 0; j < 6; ++j)
        if (i != k && j != k && task.of[i] && task.of[j]) a[i][j] = a[i][j] - gain * a[k][j];
    }
    for (int i = 0; i < 6; ++i)
      if (i != k) a[i][k] = a[i][k] * inverse, a[k][i] = a[k][i] * inverse;
    a[k][k] = -inverse;
  }
  for (int k = 0; k < 6; ++k)
    singular = singular || (task.of[k] && !detail::is_left(T(1), -a[k][k] * mobility(k, k), least));
  ToolMatrix<T> result;
  result.status = mobility.status.ok() && singular ? Status{Status::Code::near_singular, -1} : mobility.status;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j)
      if (result.status.ok() && task.of[i] && task.of[j]) result(i, j) = -a[i][j];
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
