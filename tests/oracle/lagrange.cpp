#include <oracle/lagrange.hpp>

namespace oracle {
namespace {

template <class T>
Mat3<T> rotation_x(T sine, T cosine) {
  return {{T(1), T(0), T(0)}, {T(0), cosine, sine}, {T(0), -sine, cosine}};
}
template <class T>
Mat3<T> rotation_z(T sine, T cosine) {
  return {{cosine, sine, T(0)}, {-sine, cosine, T(0)}, {T(0), T(0), T(1)}};
}

template <class T>
Pose<T> branch_pose(const Link<T>& link) {
  T sine, cosine;
  sincos_of_constant(link.gamma, sine, cosine);
  return {rotation_z(sine, cosine), {T(0), T(0), link.b}};
}

template <class T>
Pose<T> pose_in_parent(const Link<T>& link, T q) {
  T sine, cosine;
  sincos_of_constant(link.alpha, sine, cosine);
  const Pose<T> x_screw = branch_pose(link) * Pose<T>{rotation_x(sine, cosine), {link.a, T(0), T(0)}};
  if (link.type == Joint::revolute) {
    const T angle = link.theta + q;
    return x_screw * Pose<T>{rotation_z(sin(angle), cos(angle)), {T(0), T(0), link.d}};
  }
  sincos_of_constant(link.theta, sine, cosine);
  return x_screw * Pose<T>{rotation_z(sine, cosine), {T(0), T(0), link.d + q}};
}

/// Everything of one configuration in axes of frame 0: joint axes, origins, centres of mass, inertias.
template <class T>
class Configuration {
 public:
  Configuration(const Chain<T>& chain, const Vector<T>& q) : chain_(chain), poses_(link_poses(chain, q)) {
    for (int k = 0; k < chain.size(); ++k) {
      const Mat3<T>& R = poses_[std::size_t(k)].rotation;
      centres_.push_back(R * chain[k].com + poses_[std::size_t(k)].position);
      inertias_.push_back(R * chain[k].inertia * transpose(R));
    }
  }

  const Vec3<T>& axis(int j) const { return poses_[std::size_t(j)].rotation.c2; }
  const Vec3<T>& origin(int j) const { return poses_[std::size_t(j)].position; }
  const Vec3<T>& centre(int k) const { return centres_[std::size_t(k)]; }
  const Mat3<T>& inertia(int k) const { return inertias_[std::size_t(k)]; }

  /// Velocity of a point of link k per unit of qd_j.
  Vec3<T> linear(int k, const Vec3<T>& point, int j) const {
    if (!chain_.moves(j, k)) return {};
    return turns(j) ? cross(axis(j), point - origin(j)) : axis(j);
  }
  /// Angular velocity of link k per unit of qd_j.
  Vec3<T> angular(int k, int j) const { return turns(j) && chain_.moves(j, k) ? axis(j) : Vec3<T>{}; }

  /// d angular(k, j) / dq_l: the axis of joint j turns with joint l.
  Vec3<T> angular_derivative(int k, int j, int l) const { return cross(angular(j, l), angular(k, j)); }

  /// d linear(k, centre(k), j) / dq_l by the product rule.
  Vec3<T> linear_derivative(int k, int j, int l) const {
    if (!chain_.moves(j, k)) return {};
    const Vec3<T> axis_rate = cross(angular(j, l), axis(j));
    if (!turns(j)) return axis_rate;
    const Vec3<T> lever_rate = linear(k, centre(k), l) - linear(j, origin(j), l);
    return cross(axis_rate, centre(k) - origin(j)) + cross(axis(j), lever_rate);
  }

  /// d inertia(k) / dq_l = w x I - I w x.
  Mat3<T> inertia_derivative(int k, int l) const {
    const Mat3<T> W = skew(angular(k, l));
    return W * inertia(k) - inertia(k) * W;
  }

 private:
  bool turns(int j) const { return chain_[j].type == Joint::revolute; }

  const Chain<T>& chain_;
  std::vector<Pose<T>> poses_;
  std::vector<Vec3<T>> centres_;
  std::vector<Mat3<T>> inertias_;
};

template <class T>
T& at(Vector<T>& v, int i) {
  return v[std::size_t(i)];
}
template <class T>
const T& at(const Vector<T>& v, int i) {
  return v[std::size_t(i)];
}

template <class T>
Vector<T> zeros(const Chain<T>& chain) {
  return Vector<T>(chain.links.size(), T(0));
}

/// Columns of link k's Jacobians, or of their derivatives, gathered once so that sums over pairs stay cheap.
template <class T>
struct Columns {
  std::vector<Vec3<T>> linear, angular;
};

template <class T>
Columns<T> columns(const Configuration<T>& at, int k, int n) {
  Columns<T> result;
  for (int j = 0; j < n; ++j) {
    result.linear.push_back(at.linear(k, at.centre(k), j));
    result.angular.push_back(at.angular(k, j));
  }
  return result;
}

template <class T>
Columns<T> column_derivatives(const Configuration<T>& at, int k, int l, int n) {
  Columns<T> result;
  for (int j = 0; j < n; ++j) {
    result.linear.push_back(at.linear_derivative(k, j, l));
    result.angular.push_back(at.angular_derivative(k, j, l));
  }
  return result;
}

/// Adds d(m Jv^T Jv + Jw^T I Jw)/dq_l of link k to dM.
template <class T>
void add_derivative(const Configuration<T>& at, T mass, int k, int l, const Columns<T>& J, Matrix<T>& dM) {
  const int n = dM.rows();
  const Columns<T> dJ = column_derivatives(at, k, l, n);
  const Mat3<T> I = at.inertia(k), dI = at.inertia_derivative(k, l);
  for (int j = 0; j < n; ++j) {
    const auto jj = std::size_t(j);
    const Vec3<T> Iw = I * J.angular[jj], Idw = I * dJ.angular[jj], dIw = dI * J.angular[jj];
    for (int i = 0; i < n; ++i) {
      const auto ii = std::size_t(i);
      dM(i, j) += mass * (dot(dJ.linear[ii], J.linear[jj]) + dot(J.linear[ii], dJ.linear[jj])) +
                  dot(dJ.angular[ii], Iw) + dot(J.angular[ii], dIw) + dot(J.angular[ii], Idw);
    }
  }
}

}  // namespace

template <class T>
std::vector<Pose<T>> link_poses(const Chain<T>& chain, const Vector<T>& q) {
  std::vector<Pose<T>> poses;
  for (int i = 0; i < chain.size(); ++i) {
    const Pose<T> local = pose_in_parent(chain[i], at(q, i));
    poses.push_back(chain[i].parent < 0 ? local : poses[std::size_t(chain[i].parent)] * local);
  }
  return poses;
}

template <class T>
Pose<T> tool_pose(const Chain<T>& chain, const Vector<T>& q) {
  return chain.base * link_poses(chain, q).back() * chain.tool;
}

template <class T>
Jacobian<T> tool_jacobian(const Chain<T>& chain, const Vector<T>& q) {
  const Configuration<T> configuration(chain, q);
  const Vec3<T> point = (link_poses(chain, q).back() * chain.tool).position;
  const int n = chain.size();
  Jacobian<T> J{{3, n}, {3, n}};
  for (int j = 0; j < n; ++j) {
    const Vec3<T> v = chain.base.rotation * configuration.linear(n - 1, point, j);
    const Vec3<T> w = chain.base.rotation * configuration.angular(n - 1, j);
    J.linear(0, j) = v.x, J.linear(1, j) = v.y, J.linear(2, j) = v.z;
    J.angular(0, j) = w.x, J.angular(1, j) = w.y, J.angular(2, j) = w.z;
  }
  return J;
}

template <class T>
Matrix<T> mass_matrix(const Chain<T>& chain, const Vector<T>& q) {
  const Configuration<T> configuration(chain, q);
  const int n = chain.size();
  Matrix<T> M(n, n);
  for (int k = 0; k < n; ++k) {
    const Columns<T> J = columns(configuration, k, n);
    for (int j = 0; j < n; ++j) {
      const Vec3<T> momentum = chain[k].mass * J.linear[std::size_t(j)];
      const Vec3<T> spin = configuration.inertia(k) * J.angular[std::size_t(j)];
      for (int i = 0; i < n; ++i)
        M(i, j) += dot(J.linear[std::size_t(i)], momentum) + dot(J.angular[std::size_t(i)], spin);
    }
  }
  for (int i = 0; i < n; ++i)
    M(i, i) += chain[i].gear * chain[i].gear * chain[i].rotor_inertia;
  return M;
}

template <class T>
std::vector<Matrix<T>> mass_matrix_derivatives(const Chain<T>& chain, const Vector<T>& q) {
  const Configuration<T> configuration(chain, q);
  const int n = chain.size();
  std::vector<Matrix<T>> derivatives(chain.links.size(), Matrix<T>(n, n));
  for (int k = 0; k < n; ++k) {
    const Columns<T> J = columns(configuration, k, n);
    for (int l = 0; l <= k; ++l)
      if (chain.moves(l, k)) add_derivative(configuration, chain[k].mass, k, l, J, derivatives[std::size_t(l)]);
  }
  return derivatives;
}

template <class T>
Vector<T> coriolis_torque(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd) {
  const auto dM = mass_matrix_derivatives(chain, q);
  const int n = chain.size();
  Vector<T> c = zeros(chain);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int l = 0; l < n; ++l)
        at(c, i) += (dM[std::size_t(l)](i, j) - dM[std::size_t(i)](j, l) / T(2)) * at(qd, j) * at(qd, l);
  return c;
}

template <class T>
Vector<T> gravity_torque(const Chain<T>& chain, const Vector<T>& q) {
  const Configuration<T> configuration(chain, q);
  Vector<T> g = zeros(chain);
  for (int k = 0; k < chain.size(); ++k)
    for (int i = 0; i <= k; ++i)
      at(g, i) -= chain[k].mass * dot(chain.gravity, configuration.linear(k, configuration.centre(k), i));
  return g;
}

template <class T>
Vector<T> friction_torque(const Chain<T>& chain, const Vector<T>& qd) {
  Vector<T> friction = zeros(chain);
  for (int i = 0; i < chain.size(); ++i) {
    const Link<T>& link = chain[i];
    const T rate = at(qd, i);
    const int sign = rate > T(0) ? 1 : rate < T(0) ? -1 : 0;
    const T coulomb = sign > 0 ? link.coulomb_forward : -link.coulomb_backward;
    T dry = coulomb;
    if (link.static_friction != T(0)) {
      const T ratio = rate / link.stribeck_speed;
      dry += (link.static_friction - coulomb) / (T(1) + ratio * ratio);
    }
    if (link.smooth_speed > T(0) && abs(rate) < link.smooth_speed) {
      const T x = abs(rate) / link.smooth_speed;
      dry *= x * (T(3) - x * x) / T(2);
    }
    at(friction, i) = link.viscous * rate + T(sign) * dry;
  }
  return friction;
}

template <class T>
Vector<T> spring_torque(const Chain<T>& chain, const Vector<T>& q) {
  Vector<T> spring = zeros(chain);
  for (int i = 0; i < chain.size(); ++i)
    at(spring, i) = chain[i].spring_stiffness * (at(q, i) - chain[i].spring_rest);
  return spring;
}

template <class T>
Vector<T> wrench_torque(const Chain<T>& chain, const Vector<T>& q, const Wrench<T>& wrench, int link) {
  const Configuration<T> configuration(chain, q);
  const int k = link < 0 ? chain.size() - 1 : link;
  const Pose<T> frame = link_poses(chain, q)[std::size_t(k)];
  const Vec3<T> force = frame.rotation * wrench.force, moment = frame.rotation * wrench.moment;
  Vector<T> torque = zeros(chain);
  for (int i = 0; i <= k; ++i)
    at(torque, i) = dot(configuration.linear(k, frame.position, i), force) + dot(configuration.angular(k, i), moment);
  return torque;
}

namespace {

/// c + g + friction + springs - J^T w: the torque that leaves the chain without acceleration.
template <class T>
Vector<T> bias_torque(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd, const Load<T>& load) {
  Vector<T> bias = coriolis_torque(chain, q, qd);
  const Vector<T> g = gravity_torque(chain, q), tip = wrench_torque(chain, q, load.tip);
  const Vector<T> friction = load.friction ? friction_torque(chain, qd) : zeros(chain);
  for (int i = 0; i < chain.size(); ++i)
    at(bias, i) += at(g, i) + at(friction, i) - at(tip, i);
  if (load.springs) {
    const Vector<T> spring = spring_torque(chain, q);
    for (int i = 0; i < chain.size(); ++i)
      at(bias, i) += at(spring, i);
  }
  for (int k = 0; k < static_cast<int>(load.links.size()); ++k) {
    const Vector<T> pushed = wrench_torque(chain, q, load.links[std::size_t(k)], k);
    for (int i = 0; i < chain.size(); ++i)
      at(bias, i) -= at(pushed, i);
  }
  return bias;
}

}  // namespace

template <class T>
Vector<T> inverse_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd, const Vector<T>& qdd,
                           const Load<T>& load) {
  Vector<T> tau = mass_matrix(chain, q) * qdd;
  const Vector<T> bias = bias_torque(chain, q, qd, load);
  for (int i = 0; i < chain.size(); ++i)
    at(tau, i) += at(bias, i);
  return tau;
}

template <class T>
Vector<T> forward_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd, const Vector<T>& tau,
                           const Load<T>& load) {
  Vector<T> drive = tau;
  const Vector<T> bias = bias_torque(chain, q, qd, load);
  for (int i = 0; i < chain.size(); ++i)
    at(drive, i) -= at(bias, i);
  return solve(mass_matrix(chain, q), drive);
}

template <class T>
T kinetic_energy(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd) {
  const Configuration<T> configuration(chain, q);
  T energy(0);
  for (int k = 0; k < chain.size(); ++k) {
    Vec3<T> v{}, w{};
    for (int j = 0; j <= k; ++j) {
      v = v + at(qd, j) * configuration.linear(k, configuration.centre(k), j);
      w = w + at(qd, j) * configuration.angular(k, j);
    }
    const T rotor = chain[k].gear * chain[k].gear * chain[k].rotor_inertia;
    energy += (chain[k].mass * dot(v, v) + dot(w, configuration.inertia(k) * w) + rotor * at(qd, k) * at(qd, k)) / T(2);
  }
  return energy;
}

template <class T>
T potential_energy(const Chain<T>& chain, const Vector<T>& q) {
  const Configuration<T> configuration(chain, q);
  T energy(0);
  for (int k = 0; k < chain.size(); ++k)
    energy -= chain[k].mass * dot(chain.gravity, configuration.centre(k));
  return energy;
}

#define ORACLE_LAGRANGE(T)                                                                                   \
  template std::vector<Pose<T>> link_poses(const Chain<T>&, const Vector<T>&);                               \
  template Pose<T> tool_pose(const Chain<T>&, const Vector<T>&);                                             \
  template Jacobian<T> tool_jacobian(const Chain<T>&, const Vector<T>&);                                     \
  template Matrix<T> mass_matrix(const Chain<T>&, const Vector<T>&);                                         \
  template std::vector<Matrix<T>> mass_matrix_derivatives(const Chain<T>&, const Vector<T>&);                \
  template Vector<T> coriolis_torque(const Chain<T>&, const Vector<T>&, const Vector<T>&);                   \
  template Vector<T> gravity_torque(const Chain<T>&, const Vector<T>&);                                      \
  template Vector<T> friction_torque(const Chain<T>&, const Vector<T>&);                                     \
  template Vector<T> spring_torque(const Chain<T>&, const Vector<T>&);                                       \
  template Vector<T> wrench_torque(const Chain<T>&, const Vector<T>&, const Wrench<T>&, int);                \
  template Vector<T> inverse_dynamics(const Chain<T>&, const Vector<T>&, const Vector<T>&, const Vector<T>&, \
                                      const Load<T>&);                                                       \
  template Vector<T> forward_dynamics(const Chain<T>&, const Vector<T>&, const Vector<T>&, const Vector<T>&, \
                                      const Load<T>&);                                                       \
  template T kinetic_energy(const Chain<T>&, const Vector<T>&, const Vector<T>&);                            \
  template T potential_energy(const Chain<T>&, const Vector<T>&)

ORACLE_LAGRANGE(double);
ORACLE_LAGRANGE(long double);
ORACLE_LAGRANGE(quad);

}  // namespace oracle
