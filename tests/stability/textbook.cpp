#include <array>
#include <cmath>
#include <oracle/scalar.hpp>
#include <stability/textbook.hpp>

namespace stability {
namespace {

using oracle::Mat3;
using oracle::Vec3;

template <class T>
using Vec6 = std::array<T, 6>;  // angular, linear; moment, force
template <class T>
using Mat6 = std::array<Vec6<T>, 6>;

template <class T>
Vec3<T> cast(const Vec3<double>& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}
template <class T>
Mat3<T> cast(const Mat3<double>& M) {
  return {cast<T>(M.c0), cast<T>(M.c1), cast<T>(M.c2)};
}
template <class T>
Vec3<T> angular(const Vec6<T>& v) {
  return {v[0], v[1], v[2]};
}
template <class T>
Vec3<T> linear(const Vec6<T>& v) {
  return {v[3], v[4], v[5]};
}
template <class T>
Vec6<T> join(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}
template <class T>
Vec6<T> plus(Vec6<T> a, const Vec6<T>& b) {
  for (std::size_t i = 0; i < 6; ++i)
    a[i] += b[i];
  return a;
}
template <class T>
Vec6<T> times(const Mat6<T>& M, const Vec6<T>& v) {
  Vec6<T> result{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      result[i] += M[i][j] * v[j];
  return result;
}
template <class T>
T inner(const Vec6<T>& a, const Vec6<T>& b) {
  T result(0);
  for (std::size_t i = 0; i < 6; ++i)
    result += a[i] * b[i];
  return result;
}

template <class T>
Mat3<T> block(const Mat6<T>& I, std::size_t row, std::size_t column) {
  const auto at = [&](std::size_t j) {
    return Vec3<T>{I[row][column + j], I[row + 1][column + j], I[row + 2][column + j]};
  };
  return {at(0), at(1), at(2)};
}
template <class T>
void place(Mat6<T>& I, std::size_t row, std::size_t column, const Mat3<T>& block) {
  const Vec3<T> columns[] = {block.c0, block.c1, block.c2};
  for (std::size_t j = 0; j < 3; ++j)
    I[row][column + j] = columns[j].x, I[row + 1][column + j] = columns[j].y, I[row + 2][column + j] = columns[j].z;
}
template <class T>
Mat6<T> inertia(const Mat3<T>& A, const Mat3<T>& B, const Mat3<T>& C) {
  Mat6<T> I{};
  place(I, 0, 0, A), place(I, 0, 3, B), place(I, 3, 0, transpose(B)), place(I, 3, 3, C);
  return I;
}

/// A link at a position of its joint: where its frame stands in the parent's, and its inertia.
template <class T>
struct Body {
  Mat3<T> rotation;  ///< columns: the link's axes in the parent's
  Vec3<T> position;
  std::size_t axis;  ///< of the joint in a Vec6
  T rotor;
  Mat6<T> I;
  Vec3<T> moment;  ///< first
  Mat3<T> about_origin;
};

template <class T>
Body<T> body_at(const oracle::Link<double>& link, T q) {
  double sa = 0.0, ca = 0.0;
  oracle::sincos_of_constant(link.alpha, sa, ca);
  const T s = static_cast<T>(sa), c = static_cast<T>(ca);
  const bool turns = link.type == oracle::Joint::revolute;
  const T angle = static_cast<T>(link.theta) + (turns ? q : T(0)), shift = static_cast<T>(link.d) + (turns ? T(0) : q);
  const T sine = std::sin(angle), cosine = std::cos(angle), mass = static_cast<T>(link.mass);
  Body<T> body;
  body.rotation = {{cosine, c * sine, s * sine}, {-sine, c * cosine, s * cosine}, {T(0), -s, c}};
  body.position = {static_cast<T>(link.a), -s * shift, c * shift};
  body.axis = turns ? 2 : 5;
  body.rotor = static_cast<T>(link.gear * link.gear * link.rotor_inertia);
  const Vec3<T> com = cast<T>(link.com);
  const Mat3<T> cross = skew(com);
  const auto scaled = [mass](const Mat3<T>& M) { return Mat3<T>{mass * M.c0, mass * M.c1, mass * M.c2}; };
  body.moment = mass * com;
  body.about_origin = cast<T>(link.inertia) - scaled(cross * cross);
  body.I = inertia(body.about_origin, scaled(cross), scaled(Mat3<T>{}));
  return body;
}

/// A motion of the parent, in the link's axes at its origin.
template <class T>
Vec6<T> to_child(const Body<T>& b, const Vec6<T>& m) {
  const Mat3<T> to = transpose(b.rotation);
  return join(to * angular(m), to * (linear(m) + cross(angular(m), b.position)));
}
template <class T>
Vec6<T> to_parent(const Body<T>& b, const Vec6<T>& f) {
  const Vec3<T> force = b.rotation * linear(f);
  return join(b.rotation * angular(f) + cross(b.position, force), force);
}

template <class T>
Mat6<T> to_parent_by_blocks(const Body<T>& b, const Mat6<T>& I) {
  const auto turned = [&](const Mat3<T>& M) { return b.rotation * M * transpose(b.rotation); };
  const Mat3<T> A = turned(block(I, 0, 0)), B = turned(block(I, 0, 3)), C = turned(block(I, 3, 3));
  const Mat3<T> p = skew(b.position), moved = B + p * C;
  return inertia(A - B * p + p * transpose(moved), moved, C);
}
template <class T>
Mat6<T> to_parent_densely(const Body<T>& b, const Mat6<T>& I) {
  Mat6<T> X{}, IX{}, result{};  // motions of the parent to the link's
  const Mat3<T> to = transpose(b.rotation);
  place(X, 0, 0, to), place(X, 3, 3, to), place(X, 3, 0, Mat3<T>{} * (to * (Mat3<T>{{}, {}, {}} - skew(b.position))));
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t k = 0; k < 6; ++k)
        IX[i][j] += I[i][k] * X[k][j];
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t k = 0; k < 6; ++k)
        result[i][j] += X[k][i] * IX[k][j];
  return result;
}

template <class T>
T product(Update update, T uj, T uk, T d) {
  if (update == Update::quotient) return uj * uk / d;
  if (update == Update::gain) return uj * (uk * (T(1) / d));
  int exponent = 0;
  std::frexp(d, &exponent);
  return std::ldexp(uj, -exponent) * uk / std::ldexp(d, -exponent);
}

/// Velocity, what the joint's motion adds to the acceleration, and the force that the motion takes.
template <class T>
struct Motion {
  Vec6<T> v{}, c{}, p{};
};

template <class T>
Motion<T> motion_of(const Body<T>& b, const Vec6<T>& parent, T qd, bool angular_bias) {
  Motion<T> m;
  m.v = to_child(b, parent);
  Vec6<T> joint{};
  joint[b.axis] = qd;
  m.v = plus(m.v, joint);
  const Vec3<T> w = angular(m.v), turn = angular(joint), slide = linear(joint);
  const Vec6<T> momentum = times(b.I, m.v);
  if (angular_bias) {
    const Vec3<T> before = angular(parent);
    const Vec3<T> carried = transpose(b.rotation) * cross(before, cross(before, b.position));
    m.c = join(cross(w, turn), carried + T(2) * cross(w, slide));
    m.p = join(cross(w, b.about_origin * w), cross(w, cross(w, b.moment)));
  } else {
    m.c = join(cross(w, turn), cross(linear(m.v), turn) + cross(w, slide));
    m.p = join(cross(w, angular(momentum)) + cross(linear(m.v), linear(momentum)), cross(w, linear(momentum)));
  }
  return m;
}

}  // namespace

template <class T>
oracle::Vector<double> textbook(const cases::Scenario& scenario, const Variant& variant) {
  const std::size_t n = scenario.q.size();
  std::vector<Body<T>> bodies;
  std::vector<Motion<T>> motions;
  for (std::size_t i = 0; i < n; ++i) {
    bodies.push_back(body_at(scenario.chain.links[i], static_cast<T>(scenario.q[i])));
    const Vec6<T> before = i == 0 ? Vec6<T>{} : motions[i - 1].v;
    motions.push_back(motion_of(bodies[i], before, static_cast<T>(scenario.qd[i]), variant.angular_bias));
  }
  std::vector<Vec6<T>> U(n);
  std::vector<T> D(n), u(n);
  for (std::size_t i = n; i-- > 0;) {
    const Body<T>& b = bodies[i];
    const std::size_t s = b.axis;
    const Vec6<T> p = motions[i].p;
    const T tau = static_cast<T>(scenario.tau[i]);
    for (std::size_t k = 0; k < 6; ++k)
      U[i][k] = b.I[k][s];
    D[i] = U[i][s] + b.rotor, u[i] = tau - p[s];
    if (i == 0) break;
    Mat6<T> seen = b.I;
    for (std::size_t j = 0; j < 6; ++j)
      for (std::size_t k = 0; k < 6; ++k)
        seen[j][k] -= product(variant.update, U[i][j], U[i][k], D[i]);
    Vec6<T> passed = p;
    for (std::size_t k = 0; k < 6; ++k)
      passed[k] += U[i][k] * (u[i] / D[i]);
    if (variant.exact_row) {
      for (std::size_t k = 0; k < 6; ++k)
        seen[s][k] = seen[k][s] = U[i][k] / D[i] * b.rotor;
      if (!(b.rotor > T(0)))
        passed[s] = tau;
      else if (variant.rotor_force)
        passed[s] = p[s] * (b.rotor / D[i]) + U[i][s] / D[i] * tau;
    }
    const Vec6<T> bias = to_parent(b, plus(passed, times(seen, motions[i].c)));
    const Mat6<T> carried = variant.dense ? to_parent_densely(b, seen) : to_parent_by_blocks(b, seen);
    for (std::size_t k = 0; k < 6; ++k)
      bodies[i - 1].I[k] = plus(bodies[i - 1].I[k], carried[k]);
    motions[i - 1].p = plus(motions[i - 1].p, bias);
  }
  Vec6<T> a = join(Vec3<T>{}, T(-1) * cast<T>(scenario.chain.gravity));
  oracle::Vector<double> qdd;
  for (std::size_t i = 0; i < n; ++i) {
    a = plus(to_child(bodies[i], a), motions[i].c);
    const T own = (u[i] - inner(U[i], a)) / D[i];
    a[bodies[i].axis] += own;
    qdd.push_back(static_cast<double>(own));
  }
  return qdd;
}

template oracle::Vector<double> textbook<double>(const cases::Scenario&, const Variant&);
template oracle::Vector<double> textbook<float>(const cases::Scenario&, const Variant&);

}  // namespace stability
