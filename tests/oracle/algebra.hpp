// Small vectors, matrices and one solver: all that the oracle needs, over any of its number types.
#pragma once

#include <oracle/scalar.hpp>
#include <vector>

namespace oracle {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};
};

template <class T>
Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator*(T s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// 3x3 matrix by its columns.
template <class T>
struct Mat3 {
  Vec3<T> c0{T(1), T(0), T(0)}, c1{T(0), T(1), T(0)}, c2{T(0), T(0), T(1)};
};

template <class T>
Vec3<T> operator*(const Mat3<T>& A, const Vec3<T>& b) {
  return b.x * A.c0 + b.y * A.c1 + b.z * A.c2;
}
template <class T>
Mat3<T> operator*(const Mat3<T>& A, const Mat3<T>& B) {
  return {A * B.c0, A * B.c1, A * B.c2};
}
template <class T>
Mat3<T> operator+(const Mat3<T>& A, const Mat3<T>& B) {
  return {A.c0 + B.c0, A.c1 + B.c1, A.c2 + B.c2};
}
template <class T>
Mat3<T> operator-(const Mat3<T>& A, const Mat3<T>& B) {
  return {A.c0 - B.c0, A.c1 - B.c1, A.c2 - B.c2};
}
template <class T>
Mat3<T> transpose(const Mat3<T>& A) {
  return {{A.c0.x, A.c1.x, A.c2.x}, {A.c0.y, A.c1.y, A.c2.y}, {A.c0.z, A.c1.z, A.c2.z}};
}
/// The matrix of a x ( ).
template <class T>
Mat3<T> skew(const Vec3<T>& a) {
  return {{T(0), a.z, -a.y}, {-a.z, T(0), a.x}, {a.y, -a.x, T(0)}};
}

/// Pose of a frame in another: columns of `rotation` are its axes, `position` its origin.
template <class T>
struct Pose {
  Mat3<T> rotation{};
  Vec3<T> position{};
};

template <class T>
Pose<T> operator*(const Pose<T>& A, const Pose<T>& B) {
  return {A.rotation * B.rotation, A.rotation * B.position + A.position};
}

template <class T>
using Vector = std::vector<T>;

/// Dense matrix, row major.
template <class T>
class Matrix {
 public:
  Matrix() = default;
  Matrix(int rows, int columns) : rows_(rows), columns_(columns), values_(std::size_t(rows) * std::size_t(columns)) {}

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  T& operator()(int i, int j) { return values_[index(i, j)]; }
  const T& operator()(int i, int j) const { return values_[index(i, j)]; }

 private:
  std::size_t index(int i, int j) const { return std::size_t(i) * std::size_t(columns_) + std::size_t(j); }

  int rows_ = 0, columns_ = 0;
  std::vector<T> values_;
};

template <class T>
Vector<T> operator*(const Matrix<T>& A, const Vector<T>& b) {
  Vector<T> result(std::size_t(A.rows()), T(0));
  for (int i = 0; i < A.rows(); ++i)
    for (int j = 0; j < A.columns(); ++j)
      result[std::size_t(i)] += A(i, j) * b[std::size_t(j)];
  return result;
}

/// x of A x = b for a symmetric positive definite A: Gauss' elimination without pivoting, which is L D L^T.
template <class T>
Vector<T> solve(Matrix<T> A, Vector<T> b) {
  const int n = A.rows();
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < n; ++i) {
      const T l = A(i, j) / A(j, j);
      for (int k = j + 1; k < n; ++k)
        A(i, k) -= l * A(j, k);
      b[std::size_t(i)] -= l * b[std::size_t(j)];
    }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k)
      b[std::size_t(i)] -= A(i, k) * b[std::size_t(k)];
    b[std::size_t(i)] /= A(i, i);
  }
  return b;
}

}  // namespace oracle
