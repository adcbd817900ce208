// One face for everything that can answer a case: the oracle, KDL and the library.
#pragma once

#include <cases/case_file.hpp>
#include <memory>

namespace cases {

class Implementation {
 public:
  Implementation(const char* name, double tolerance) : name_(name), tolerance_(tolerance) {}
  virtual ~Implementation() = default;

  const char* name() const { return name_; }
  /// Admissible error relative to the largest magnitude of a quantity in its file.
  double tolerance() const { return tolerance_; }
  /// A quantity of the case format at a state; nothing where the implementation does not offer it.
  virtual std::optional<Values> evaluate(const CaseFile& file, const State& state,
                                         const std::string& quantity) const = 0;

 private:
  const char* name_;
  double tolerance_;
};

using ImplementationList = std::vector<std::shared_ptr<const Implementation>>;

/// The oracle in quad, long double and double, its O(N) second reference in quad, and Orocos KDL.
ImplementationList references();
/// The library's looped run-time model in double and float.
ImplementationList library();

/// [v; w], row by row.
template <class T>
Values jacobian_rows(const oracle::Matrix<T>& linear, const oracle::Matrix<T>& angular) {
  Values rows;
  for (const auto* block : {&linear, &angular})
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < block->columns(); ++j)
        rows.push_back(quad((*block)(i, j)));
  return rows;
}

/// R^T A: the columns of A in the axes that R holds.
template <class T>
oracle::Matrix<T> in_axes(const oracle::Mat3<T>& R, const oracle::Matrix<T>& A) {
  oracle::Matrix<T> result(3, A.columns());
  for (int j = 0; j < A.columns(); ++j) {
    const oracle::Vec3<T> column{A(0, j), A(1, j), A(2, j)};
    result(0, j) = dot(R.c0, column), result(1, j) = dot(R.c1, column), result(2, j) = dot(R.c2, column);
  }
  return result;
}

/// Homogeneous 4x4 matrix, row by row.
template <class T>
Values pose_rows(const oracle::Pose<T>& X) {
  const auto& R = X.rotation;
  const auto& p = X.position;
  return {R.c0.x, R.c1.x, R.c2.x, p.x, R.c0.y, R.c1.y, R.c2.y, p.y, R.c0.z, R.c1.z, R.c2.z, p.z, 0, 0, 0, 1};
}

}  // namespace cases
