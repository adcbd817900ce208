#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>

namespace oracle {
namespace {

/// Motion: angular velocity and velocity of the body's point at the origin. Force: moment about the origin and force.
template <class T>
struct Six {
  Vec3<T> angular{}, linear{};
};

template <class T>
Six<T> operator+(const Six<T>& a, const Six<T>& b) {
  return {a.angular + b.angular, a.linear + b.linear};
}
template <class T>
Six<T> operator-(const Six<T>& a, const Six<T>& b) {
  return {a.angular - b.angular, a.linear - b.linear};
}
template <class T>
Six<T> operator*(T s, const Six<T>& a) {
  return {s * a.angular, s * a.linear};
}
template <class T>
T dot(const Six<T>& a, const Six<T>& b) {
  return dot(a.angular, b.angular) + dot(a.linear, b.linear);
}

/// Rate of a motion vector that rides on a body with velocity v.
template <class T>
Six<T> cross_motion(const Six<T>& v, const Six<T>& m) {
  return {cross(v.angular, m.angular), cross(v.angular, m.linear) + cross(v.linear, m.angular)};
}
/// Rate of a force vector that rides on a body with velocity v.
template <class T>
Six<T> cross_force(const Six<T>& v, const Six<T>& f) {
  return {cross(v.angular, f.angular) + cross(v.linear, f.linear), cross(v.angular, f.linear)};
}

/// Dense 6x6 inertia in 3x3 blocks: moment = A w + B v, force = B^T w + C v.
template <class T>
struct Inertia6 {
  Mat3<T> A, B, C;
};

template <class T>
Mat3<T> scaled(T s, const Mat3<T>& M) {
  return {s * M.c0, s * M.c1, s * M.c2};
}
template <class T>
Mat3<T> outer(const Vec3<T>& a, const Vec3<T>& b) {
  return {b.x * a, b.y * a, b.z * a};
}

template <class T>
Six<T> operator*(const Inertia6<T>& I, const Six<T>& v) {
  return {I.A * v.angular + I.B * v.linear, transpose(I.B) * v.angular + I.C * v.linear};
}
template <class T>
Inertia6<T> operator+(const Inertia6<T>& a, const Inertia6<T>& b) {
  return {a.A + b.A, a.B + b.B, a.C + b.C};
}

/// I - U U^T / D.
template <class T>
Inertia6<T> reflected(const Inertia6<T>& I, const Six<T>& U, T D) {
  const Six<T> K = (T(1) / D) * U;
  return {I.A - outer(U.angular, K.angular), I.B - outer(U.angular, K.linear), I.C - outer(U.linear, K.linear)};
}

/// Per link, about the origin of frame 0: joint axis, inertia, velocity, velocity-product acceleration.
template <class T>
struct Body {
  Six<T> S, v, c;
  Inertia6<T> I;
  Six<T> bias;  ///< v x* I v
};

template <class T>
Inertia6<T> inertia_about_origin(const Link<T>& link, const Pose<T>& pose) {
  const Mat3<T> C = skew(pose.rotation * link.com + pose.position);
  const Mat3<T> about_com = pose.rotation * link.inertia * transpose(pose.rotation);
  return {about_com - scaled(link.mass, C * C), scaled(link.mass, C), scaled(link.mass, Mat3<T>{})};
}

template <class T>
Six<T> joint_axis(const Link<T>& link, const Pose<T>& pose) {
  const Vec3<T> z = pose.rotation.c2;
  return link.type == Joint::revolute ? Six<T>{z, cross(pose.position, z)} : Six<T>{{}, z};
}

template <class T>
std::vector<Body<T>> bodies_at(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd) {
  const auto poses = link_poses(chain, q);
  std::vector<Body<T>> bodies;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Link<T>& link = chain.links[i];
    Body<T> body;
    body.S = joint_axis(link, poses[i]);
    body.v = qd[i] * body.S;
    if (link.parent >= 0) body.v = body.v + bodies[std::size_t(link.parent)].v;
    body.c = cross_motion(body.v, qd[i] * body.S);
    body.I = inertia_about_origin(link, poses[i]);
    body.bias = cross_force(body.v, body.I * body.v);
    bodies.push_back(body);
  }
  return bodies;
}

/// The tip wrench about the origin of frame 0.
template <class T>
Six<T> tip_force(const Chain<T>& chain, const Vector<T>& q, const Wrench<T>& wrench) {
  const Pose<T> tip = link_poses(chain, q).back();
  const Vec3<T> force = tip.rotation * wrench.force;
  return {tip.rotation * wrench.moment + cross(tip.position, force), force};
}

template <class T>
T rotor(const Link<T>& link) {
  return link.gear * link.gear * link.rotor_inertia;
}

/// Acceleration of frame 0 that stands for gravity.
template <class T>
Six<T> base_acceleration(const Chain<T>& chain) {
  return {{}, T(-1) * chain.gravity};
}

template <class T>
Vector<T> friction_or_none(const Chain<T>& chain, const Vector<T>& qd, const Load<T>& load) {
  return load.friction ? friction_torque(chain, qd) : Vector<T>(chain.links.size(), T(0));
}

}  // namespace

template <class T>
Vector<T> recursive_inverse_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd,
                                     const Vector<T>& qdd, const Load<T>& load) {
  const auto bodies = bodies_at(chain, q, qd);
  const std::size_t n = bodies.size();
  std::vector<Six<T>> a(n), f(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int parent = chain.links[i].parent;
    a[i] = (parent < 0 ? base_acceleration(chain) : a[std::size_t(parent)]) + bodies[i].c + qdd[i] * bodies[i].S;
    f[i] = bodies[i].I * a[i] + bodies[i].bias;
  }
  f[n - 1] = f[n - 1] - tip_force(chain, q, load.tip);
  Vector<T> tau = friction_or_none(chain, qd, load);
  for (std::size_t i = n; i-- > 0;) {
    tau[i] += dot(bodies[i].S, f[i]) + rotor(chain.links[i]) * qdd[i];
    if (const int parent = chain.links[i].parent; parent >= 0) f[std::size_t(parent)] = f[std::size_t(parent)] + f[i];
  }
  return tau;
}

template <class T>
Vector<T> recursive_forward_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd,
                                     const Vector<T>& tau, const Load<T>& load) {
  auto bodies = bodies_at(chain, q, qd);
  const std::size_t n = bodies.size();
  const Vector<T> friction = friction_or_none(chain, qd, load);
  bodies[n - 1].bias = bodies[n - 1].bias - tip_force(chain, q, load.tip);
  std::vector<Six<T>> U(n);
  Vector<T> D(n), u(n);
  for (std::size_t i = n; i-- > 0;) {
    Body<T>& body = bodies[i];
    U[i] = body.I * body.S;
    D[i] = dot(body.S, U[i]) + rotor(chain.links[i]);
    u[i] = tau[i] - friction[i] - dot(body.S, body.bias);
    if (chain.links[i].parent < 0) continue;
    Body<T>& parent = bodies[std::size_t(chain.links[i].parent)];
    const Inertia6<T> seen = reflected(body.I, U[i], D[i]);
    parent.I = parent.I + seen;
    parent.bias = parent.bias + body.bias + seen * body.c + (u[i] / D[i]) * U[i];
  }
  std::vector<Six<T>> a(n);
  Vector<T> qdd(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int parent = chain.links[i].parent;
    const Six<T> carried = (parent < 0 ? base_acceleration(chain) : a[std::size_t(parent)]) + bodies[i].c;
    qdd[i] = (u[i] - dot(U[i], carried)) / D[i];
    a[i] = carried + qdd[i] * bodies[i].S;
  }
  return qdd;
}

#define ORACLE_RECURSIVE(T)                                                                                            \
  template Vector<T> recursive_inverse_dynamics(const Chain<T>&, const Vector<T>&, const Vector<T>&, const Vector<T>&, \
                                                const Load<T>&);                                                       \
  template Vector<T> recursive_forward_dynamics(const Chain<T>&, const Vector<T>&, const Vector<T>&, const Vector<T>&, \
                                                const Load<T>&)

ORACLE_RECURSIVE(double);
ORACLE_RECURSIVE(long double);
ORACLE_RECURSIVE(quad);

}  // namespace oracle
