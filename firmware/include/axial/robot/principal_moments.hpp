// Could matter have this inertia? Principal moments of a tensor, and by how much they break what bodies obey.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// True where an inertia tensor about a centre of mass (xx yy zz xy xz yz) belongs to a distribution of mass >= 0: its
/// pseudo-inertia tr(J)/2 1 - J is positive semidefinite, which says the triangle inequality in every axes
/// (Wensing, Kim and Slotine 2018). `tolerance` is relative to the trace.
[[nodiscard]] constexpr bool physically_consistent(const double (&j)[6], double mass, double tolerance = 1e-9) {
  const double trace = j[0] + j[1] + j[2], slack = tolerance * trace;
  if (mass < 0.0 || trace < 0.0) return false;
  if (mass == 0.0) return j[0] == 0.0 && j[1] == 0.0 && j[2] == 0.0 && j[3] == 0.0 && j[4] == 0.0 && j[5] == 0.0;
  const double xx = 0.5 * trace - j[0] + slack, yy = 0.5 * trace - j[1] + slack, zz = 0.5 * trace - j[2] + slack;
  const double xy = -j[3], xz = -j[4], yz = -j[5];
  const double minor_xy = xx * yy - xy * xy, minor_xz = xx * zz - xz * xz, minor_yz = yy * zz - yz * yz;
  const double determinant = xx * minor_yz - xy * (xy * zz - xz * yz) + xz * (xy * yz - xz * yy);
  return xx >= 0.0 && yy >= 0.0 && zz >= 0.0 && minor_xy >= 0.0 && minor_xz >= 0.0 && minor_yz >= 0.0 &&
         determinant >= 0.0;
}

namespace detail {

/// Characteristic polynomial of a symmetric tensor (xx yy zz xy xz yz): ((x - trace) x + minors) x - determinant.
struct CharacteristicPolynomial {
  double trace = 0.0, minors = 0.0, determinant = 0.0;

  constexpr explicit CharacteristicPolynomial(const double (&j)[6])
      : trace(j[0] + j[1] + j[2]),
        minors(j[0] * j[1] + j[0] * j[2] + j[1] * j[2] - j[3] * j[3] - j[4] * j[4] - j[5] * j[5]),
        determinant(j[0] * (j[1] * j[2] - j[5] * j[5]) - j[3] * (j[3] * j[2] - j[4] * j[5]) +
                    j[4] * (j[3] * j[5] - j[4] * j[1])) {}

  /// The root next to `x`, which lies beyond all three: there Newton's method is monotone. A double root takes the most
  /// steps, each halving what is left; what is within rounding of 0 ends them.
  constexpr double root_from(double x) const {
    const double size = x < 0.0 ? -x : x, rounding = 1e-16 * size * size * size;
    for (int i = 0; i < 60; ++i) {
      const double value = ((x - trace) * x + minors) * x - determinant, slope = (3.0 * x - 2.0 * trace) * x + minors;
      if (value <= rounding && value >= -rounding) break;
      x -= value / slope;
    }
    return x;
  }
};

}  // namespace detail

/// Eigenvalues of an inertia tensor, kg m^2, in rising order.
struct PrincipalMoments {
  double least = 0.0, middle = 0.0, largest = 0.0;  ///< kg m^2
};

/// Principal moments of a tensor (xx yy zz xy xz yz) in any axes; to about 1e-7 of the largest where two are equal,
/// 1e-4 where three are.
[[nodiscard]] constexpr PrincipalMoments principal_moments(const double (&j)[6]) {
  double size = 0.0;
  for (const double entry : j)
    size = entry > size ? entry : -entry > size ? -entry : size;
  if (size == 0.0) return {};
  const double scaled[] = {j[0] / size, j[1] / size, j[2] / size, j[3] / size, j[4] / size, j[5] / size};
  constexpr double bound = 3.1;  // entries of at most 1: no eigenvalue is larger than a row's sum
  const detail::CharacteristicPolynomial polynomial(scaled);
  const double largest = polynomial.root_from(bound), least = polynomial.root_from(-bound);
  return {size * least, size * (polynomial.trace - largest - least), size * largest};
}

/// By how much no body can have these moments, as a share: a least moment below 0, of the largest; a largest one above
/// the sum of the others (a negative one counts as 0), of that sum. 0 where matter could have them.
struct InertiaDefect {
  double negative = 0.0, triangle = 0.0;  ///< shares, >= 0
};
/// Defect of given moments.
[[nodiscard]] constexpr InertiaDefect inertia_defect(const PrincipalMoments& m) {
  constexpr double beyond_measure = 1e30;  // share of nothing
  InertiaDefect defect;
  if (m.least < 0.0) defect.negative = m.largest > 0.0 ? -m.least / m.largest : beyond_measure;
  const double others = m.middle + (m.least > 0.0 ? m.least : 0.0), excess = m.largest - others;
  if (excess > 0.0) defect.triangle = others > 0.0 ? excess / others : beyond_measure;
  return defect;
}

}  // namespace axial

#include <axial/options/end.hpp>
