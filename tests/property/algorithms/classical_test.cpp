// Classical chains against first principles in their own frames: homogeneous transforms, Lagrange's equations with
// Jacobians of the centres of mass, the derivatives of M as central differences in quadruple precision.
#include <axial/robot/classical.hpp>

#include <array>
#include <axial/links/model.hpp>
#include <cases/case_file.hpp>
#include <cases/to_axial.hpp>
#include <tuple>

#include <property/support.hpp>

namespace {

using oracle::quad;
using Vec = oracle::Vec3<quad>;
using Mat = oracle::Mat3<quad>;
using Pose = oracle::Pose<quad>;
using Values = oracle::Vector<quad>;

constexpr double exact = 1e-13;  // relative to the largest of the vector, as in trees_test.cpp

/// A row of a classical table: Rz(theta) Tz(d) Tx(a) Rx(alpha).
struct Row {
  bool prismatic = false;
  quad theta, d, a, alpha, mass, rotor;
  Vec com;
  Mat inertia;
};

Pose turn_z(quad angle) {
  quad s = 0, c = 0;
  oracle::sincos_of_constant(angle, s, c);
  return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}, {}};
}
Pose turn_x(quad angle) {
  quad s = 0, c = 0;
  oracle::sincos_of_constant(angle, s, c);
  return {{{1, 0, 0}, {0, c, s}, {0, -s, c}}, {}};
}
Pose shift(quad x, quad z) { return {{}, {x, 0, z}}; }

struct Arm {
  std::vector<Row> rows;
  Vec gravity;
  Pose tool;

  std::size_t size() const { return rows.size(); }
  /// Classical frames 0 to N.
  std::vector<Pose> frames(const Values& q) const {
    std::vector<Pose> result{Pose{}};
    for (std::size_t i = 0; i < size(); ++i) {
      const Row& r = rows[i];
      const quad theta = r.prismatic ? r.theta : r.theta + q[i], d = r.prismatic ? r.d + q[i] : r.d;
      result.push_back(result.back() * turn_z(theta) * shift(0, d) * shift(r.a, 0) * turn_x(r.alpha));
    }
    return result;
  }
  /// M and the torque that holds the arm still.
  std::pair<oracle::Matrix<quad>, Values> at(const Values& q) const {
    const auto frame = frames(q);
    const int n = int(size());
    oracle::Matrix<quad> M(n, n);
    Values g(size(), quad(0));
    for (std::size_t k = 0; k < size(); ++k) {
      const Mat R = frame[k + 1].rotation, inertia = R * rows[k].inertia * oracle::transpose(R);
      const Vec com = R * rows[k].com + frame[k + 1].position;
      std::vector<Vec> linear, angular;
      for (std::size_t i = 0; i <= k; ++i) {
        const Vec z = frame[i].rotation.c2, none{};
        linear.push_back(rows[i].prismatic ? z : oracle::cross(z, com - frame[i].position));
        angular.push_back(rows[i].prismatic ? none : z);
        g[i] -= rows[k].mass * oracle::dot(linear[i], gravity);
      }
      for (std::size_t i = 0; i <= k; ++i)
        for (std::size_t j = 0; j <= k; ++j)
          M(int(i), int(j)) +=
              rows[k].mass * oracle::dot(linear[i], linear[j]) + oracle::dot(angular[i], inertia * angular[j]);
    }
    for (std::size_t i = 0; i < size(); ++i)
      M(int(i), int(i)) += rows[i].rotor;
    return {M, g};
  }
  Values torque(const Values& q, const Values& qd, const Values& qdd) const {
    constexpr double h = 1e-11;  // truncation h^2, rounding 1e-34 / h
    const auto [M, g] = at(q);
    Values tau = M * qdd;
    for (std::size_t l = 0; l < size(); ++l) {
      Values ahead = q, behind = q;
      ahead[l] += h, behind[l] -= h;
      const auto up = at(ahead).first, down = at(behind).first;
      for (std::size_t i = 0; i < size(); ++i)
        for (std::size_t j = 0; j < size(); ++j) {
          const quad slope = (up(int(i), int(j)) - down(int(i), int(j))) / (quad(2) * h);
          tau[i] += slope * qd[j] * qd[l];
          tau[l] -= slope * qd[i] * qd[j] / 2;
        }
      tau[l] += g[l];
    }
    return tau;
  }
};

/// A random link of the oracle, read as a row of a classical table.
Row row(const oracle::Link<double>& link) {
  const auto l = oracle::convert<quad>(oracle::Chain<double>{{link}, {}, {}, {}}).links[0];
  return {l.type == oracle::Joint::prismatic, l.theta, l.d,      l.a, l.alpha, l.mass,
          l.gear * l.gear * l.rotor_inertia,  l.com,   l.inertia};
}
axial::ClassicalLink classical(const oracle::Link<double>& l) {
  const auto start = l.type == oracle::Joint::prismatic ? axial::classical_prismatic() : axial::classical_revolute();
  int quarters = 0;
  const auto twisted =
      oracle::is_right_angle(l.alpha, quarters) ? start.alpha_deg(90.0 * quarters) : start.alpha(l.alpha);
  const auto& I = l.inertia;
  return twisted.theta(l.theta)
      .d(l.d)
      .a(l.a)
      .mass(l.mass)
      .com(l.com.x, l.com.y, l.com.z)
      .inertia_com(I.c0.x, I.c1.y, I.c2.z, I.c0.y, I.c0.z, I.c1.z)
      .rotor_inertia(l.rotor_inertia, l.gear);
}

/// The library's torque of a chain, features beyond gravity and rotors given.
template <class... Features, int N, class State>
oracle::Vector<double> torque(const axial::Chain<N>& chain, const State& state, const oracle::Vec3<double>& gravity) {
  using AnyChain = axial::Model<N, axial::Gravity, axial::RotorInertia, Features...>;
  AnyChain model;
  for (const auto& link : chain.links)
    EXPECT_TRUE(model.add(link));
  model.set_gravity(gravity.x, gravity.y, gravity.z);
  const auto tau = axial::inverse_dynamics(model, property::joints<AnyChain, double>(state.q),
                                           property::joints<AnyChain, double>(state.qd),
                                           property::joints<AnyChain, double>(state.qdd));
  return property::vector<AnyChain, double>(tau, N);
}

template <class Count>
class RandomClassicalChain : public testing::Test {
 protected:
  static constexpr int n = Count::value;
  explicit RandomClassicalChain() : random_(20250 + n) {}

  void draw() {
    auto table = random_.chain(n);
    for (auto& link : table.links)
      links_[std::size_t(&link - table.links.data())] = classical(link);
    arm = {};
    for (const auto& link : table.links)
      arm.rows.push_back(row(link));
    gravity = table.gravity, arm.gravity = oracle::convert<quad>(gravity);
    arm.tool.position = {0.25, -0.5, 0.125};
    chain = std::apply(
        [](const auto&... link) {
          // random tensors miss what matter can have by more than published ones do
          return axial::classical_chain(axial::accept(axial::as_published), link..., axial::tool(0.25, -0.5, 0.125));
        },
        links_);
    state = {random_.vector(n, 3.0), random_.vector(n, 2.0), random_.vector(n, 4.0)};
  }

  oracle::RandomChains random_;
  std::array<axial::ClassicalLink, n> links_ = filled(std::make_index_sequence<n>{});
  Arm arm;
  oracle::Vec3<double> gravity;
  axial::Chain<n> chain{};
  property::State state;

 private:
  template <std::size_t... I>
  static std::array<axial::ClassicalLink, n> filled(std::index_sequence<I...>) {
    return {((void)I, axial::classical_revolute())...};
  }
};
template <int N>
using Count = std::integral_constant<int, N>;
using Counts = testing::Types<Count<1>, Count<2>, Count<3>, Count<5>, Count<7>>;
TYPED_TEST_SUITE(RandomClassicalChain, Counts);

TYPED_TEST(RandomClassicalChain, TorqueIsThatOfTheClassicalFrames) {
  for (int k = 0; k < 20; ++k) {
    this->draw();
    const auto tau = torque(this->chain, this->state, this->gravity);
    const auto reference = this->arm.torque(oracle::convert<quad>(this->state.q), oracle::convert<quad>(this->state.qd),
                                            oracle::convert<quad>(this->state.qdd));
    EXPECT_LE(oracle::relative_error(tau, reference), exact) << k;
  }
}

Values numbers(const Pose& pose) {
  const auto& R = pose.rotation;
  const auto& p = pose.position;
  return {R.c0.x, R.c0.y, R.c0.z, R.c1.x, R.c1.y, R.c1.z, R.c2.x, R.c2.y, R.c2.z, p.x, p.y, p.z};
}

/// Classical frame i is MDH frame i times Rx(alpha_i) Tx(a_i), the twist and length that lead on to the next joint.
TYPED_TEST(RandomClassicalChain, EveryFrameIsWhereTheTransformsPutIt) {
  for (int k = 0; k < 20; ++k) {
    this->draw();
    const auto q = oracle::convert<quad>(this->state.q);
    const auto expected = this->arm.frames(q);
    const auto modified = oracle::from_axial<quad>(this->chain);
    const auto poses = oracle::link_poses(modified, q);
    for (std::size_t i = 0; i < this->arm.size(); ++i) {
      const Row& r = this->arm.rows[i];
      const Pose far = poses[i] * turn_x(r.alpha) * shift(r.a, 0);
      EXPECT_LE(oracle::relative_error(numbers(far), numbers(expected[i + 1])), exact) << k << " " << i;
    }
    const Pose tool = oracle::tool_pose(modified, q);
    EXPECT_LE(oracle::relative_error(numbers(tool), numbers(expected.back() * this->arm.tool)), exact) << k;
  }
}

constexpr axial::ClassicalLink drive(const axial::ClassicalLink& link, double rotor, double gear, double viscous,
                                     double forward, double backward) {
  const double ratio = gear < 0.0 ? -gear : gear;
  return link.rotor_inertia(rotor, gear).viscous(viscous * gear * gear).coulomb(forward * ratio, backward * ratio);
}

/// Robotics Toolbox's classical table of the Puma 560; drives on the motor side.
constexpr auto puma = axial::classical_chain(
    axial::accept(axial::as_published),
    drive(axial::classical_revolute().d(0.67183).alpha_deg(90).inertia_com(0, 0.35, 0), 200e-6, -62.6111, 1.48e-3,
          0.395, -0.435),
    drive(axial::classical_revolute().a(0.4318).mass(17.4).com(-0.3638, 0.006, 0.2275).inertia_com(0.13, 0.524, 0.539),
          200e-6, 107.815, 0.817e-3, 0.126, -0.071),
    drive(axial::classical_revolute()
              .d(0.15005)
              .a(0.0203)
              .alpha_deg(-90)
              .mass(4.8)
              .com(-0.0203, -0.0141, 0.07)
              .inertia_com(0.066, 0.086, 0.0125),
          200e-6, -53.7063, 1.38e-3, 0.132, -0.105),
    drive(axial::classical_revolute()
              .d(0.4318)
              .alpha_deg(90)
              .mass(0.82)
              .com(0, 0.019, 0)
              .inertia_com(1.8e-3, 1.3e-3, 1.8e-3),
          33e-6, 76.0364, 71.2e-6, 11.2e-3, -16.9e-3),
    drive(axial::classical_revolute().alpha_deg(-90).mass(0.34).inertia_com(0.3e-3, 0.4e-3, 0.3e-3), 33e-6, 71.923,
          82.6e-6, 9.26e-3, -14.5e-3),
    drive(axial::classical_revolute().mass(0.09).com(0, 0, 0.032).inertia_com(0.15e-3, 0.15e-3, 0.04e-3), 33e-6, 76.686,
          36.7e-6, 3.96e-3, -10.5e-3));

TEST(ClassicalPuma, HasTheTorquesOfTheToolboxCases) {
  const auto file = cases::load_case("rtb_py_puma560");
  int compared = 0;
  for (const auto& state : file.states) {
    const auto reference = state.reference.find("tau");
    if (reference == state.reference.end() || state.id == "rne_fext") continue;  // that one has a tip wrench
    const auto gravity = oracle::convert<double>(file.chain_at(state).gravity);
    const auto actual =
        state.load.friction ? torque<axial::Friction>(puma, state, gravity) : torque<>(puma, state, gravity);
    EXPECT_LE(oracle::relative_error(actual, reference->second), exact) << state.id;
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

}  // namespace
