// Eigen's view of this library's values: maps, nothing copied. For programs that have Eigen; no other header includes
// it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>

#include <Eigen/Core>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
template <class T, class E>
constexpr bool same_layout(int count) {
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_copyable_v<T>,
                "axial: an Eigen map needs a plain struct of numbers");
  static_assert(alignof(T) == alignof(E), "axial: an Eigen map needs the alignment of its number");
  return sizeof(T) == static_cast<std::size_t>(count) * sizeof(E);
}
/// The numbers of what is `Held`, from the first on, as a matrix.
template <class Held, class Matrix, class T>
auto mapped(T* first) {
  static_assert(same_layout<Held, std::remove_const_t<T>>(Matrix::SizeAtCompileTime));
  return Eigen::Map<std::conditional_t<std::is_const_v<T>, const Matrix, Matrix>>(first);
}

/// Entry (i, j) of a mass matrix, as Eigen asks for it.
template <class S, class T>
struct EntryOf {
  const MassMatrix<S, T>* matrix;
  T operator()(Eigen::Index i, Eigen::Index j) const { return (*matrix)(static_cast<int>(i), static_cast<int>(j)); }
};
}  // namespace detail

/// Joint values as a column vector, to read and to write. In floating point; fixed point has words, not numbers.
template <class S, class T>
[[nodiscard]] auto as_eigen(Joints<S, T>& values) {
  return detail::mapped<Joints<S, T>, Eigen::Matrix<T, Joints<S, T>::size, 1>>(values.values);
}
/// Overload for values to read alone.
template <class S, class T>
[[nodiscard]] auto as_eigen(const Joints<S, T>& values) {
  return detail::mapped<Joints<S, T>, Eigen::Matrix<T, Joints<S, T>::size, 1>>(values.values);
}

/// A vector, such as the position of a pose.
template <class T>
[[nodiscard]] auto as_eigen(const Vec3<T, T, T>& v) {
  return detail::mapped<Vec3<T, T, T>, Eigen::Matrix<T, 3, 1>>(&v.x);
}

/// A rotation matrix, such as that of a pose; rows follow one another.
template <class T>
[[nodiscard]] auto as_eigen(const Mat3<Vec3<T>>& m) {
  return detail::mapped<Mat3<Vec3<T>>, Eigen::Matrix<T, 3, 3, Eigen::RowMajor>>(&m.x.x);
}

/// The 6 x N Jacobian, angular part first.
template <class S, class T>
[[nodiscard]] auto as_eigen(const Jacobian<S, T>& jacobian) {
  return detail::mapped<decltype(jacobian.columns), Eigen::Matrix<T, 6, joint_count<S>>>(
      &jacobian.columns[0].angular.x);
}

/// The mass matrix as an N x N expression that reads the stored triangle; `m` must outlive it. Assign it to an
/// Eigen::Matrix for a dense copy.
template <class S, class T>
[[nodiscard]] auto as_eigen(const MassMatrix<S, T>& m) {
  constexpr int n = MassMatrix<S, T>::size;
  static_assert(detail::same_layout<MassMatrix<S, T>, T>(n * (n + 1) / 2));
  return Eigen::Matrix<T, n, n>::NullaryExpr(detail::EntryOf<S, T>{&m});
}
/// A temporary would be gone before it is read.
template <class S, class T>
auto as_eigen(const MassMatrix<S, T>&&) = delete;

}  // namespace axial

#include <axial/options/end.hpp>
