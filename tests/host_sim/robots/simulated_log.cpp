// simulated_log: the log that an altered arm would leave, by Orocos KDL and the oracle's friction, and its parameters.
// Where joints share drives: by the oracle's recursion over the tree and a matrix G written here by hand, in values of
// the drives. Nothing of the library's dynamics is used. The truth is written as the standard parameters of each link:
// m, m c, inertia about the origin (xx yy zz xy xz yz), gear^2 J, viscous, Coulomb forward and backward.
#include <host_sim/robots/identification/robot_file.hpp>
#include <host_sim/robots/trajectory/files.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/kdl_chain.hpp>
#include <oracle/recursive.hpp>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <random>
#include <stdexcept>

namespace {

using Link = oracle::Link<double>;
using Chain = oracle::Chain<double>;
using Random = std::mt19937_64;

struct Options {
  std::string robot, motion, log, truth;
  unsigned seed = 0;
  double spread = 0.3;  ///< of the alterations, a share
  double counts = 0.0;  ///< of an encoder a turn or, on a slide, a metre; 0: exact
  double noise = 0.0;   ///< of torque, standard deviation over the joint's RMS
};

Eigen::Matrix3d matrix(const oracle::Mat3<double>& m) {
  Eigen::Matrix3d result;
  result << m.c0.x, m.c1.x, m.c2.x, m.c0.y, m.c1.y, m.c2.y, m.c0.z, m.c1.z, m.c2.z;
  return result;
}
Eigen::Vector3d vector(const oracle::Vec3<double>& v) { return {v.x, v.y, v.z}; }

// Bodies that matter has: a published set of parameters need not be one, and point masses are at the border of it.
void make_consistent(Link& link) {
  link.mass = std::max(link.mass, 0.5);
  const Eigen::Matrix3d inertia = matrix(link.inertia);
  const Eigen::Matrix3d second = 0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia;
  const double least = second.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff();
  const double missing = 2.0 * std::max(0.0, link.mass * 4e-4 - least);
  link.inertia.c0.x += missing, link.inertia.c1.y += missing, link.inertia.c2.z += missing;
}

// Every figure off by up to `spread`; drives that declare nothing get a rotor and friction.
void alter(Link& link, double effort, double speed, double spread, Random& random) {
  std::uniform_real_distribution<double> uniform(1.0 - spread, 1.0 + spread);
  make_consistent(link);
  link.mass *= uniform(random);
  for (double* c : {&link.com.x, &link.com.y, &link.com.z})
    *c *= uniform(random);
  const double inertia = uniform(random);
  for (auto* column : {&link.inertia.c0, &link.inertia.c1, &link.inertia.c2})
    column->x *= inertia, column->y *= inertia, column->z *= inertia;
  if (!(link.rotor_inertia > 0.0)) link.gear = 1.0, link.rotor_inertia = 0.01 * effort / speed;
  link.rotor_inertia *= uniform(random);
  link.viscous = (link.viscous > 0.0 ? link.viscous : 0.02 * effort / speed) * uniform(random);
  link.coulomb_forward = (link.coulomb_forward > 0.0 ? link.coulomb_forward : 0.02 * effort) * uniform(random);
  link.coulomb_backward = (link.coulomb_backward < 0.0 ? link.coulomb_backward : -0.02 * effort) * uniform(random);
}

nlohmann::json parameters(const Link& link) {
  const Eigen::Vector3d c = vector(link.com), first = link.mass * c;
  const Eigen::Matrix3d I =
      matrix(link.inertia) + link.mass * (c.dot(c) * Eigen::Matrix3d::Identity() - c * c.transpose());
  return {link.mass,
          first[0],
          first[1],
          first[2],
          I(0, 0),
          I(1, 1),
          I(2, 2),
          I(0, 1),
          I(0, 2),
          I(1, 2),
          link.gear * link.gear * link.rotor_inertia,
          link.viscous,
          link.coulomb_forward,
          link.coulomb_backward};
}

/// What moves the joints of a tree: q = g u, and the links at which rotor and friction of each drive stand.
struct Drives {
  std::vector<std::vector<double>> g;
  std::vector<int> owner;
  std::vector<double> turn;  ///< a turn of its encoder, in units of the drive
};

const double pi = std::acos(-1.0);

/// By hand, from how these robots are built.
Drives drives_of(const std::string& robot, int joints) {
  const double screw = 0.020 / (2.0 * pi), turn = 2.0 * pi;
  if (robot == "scara_quill")
    return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, screw, -screw}, {0, 0, 0, 1}}, {0, 1, 2, 3}, {turn, turn, turn, turn}};
  if (robot == "palletiser")  // upper arm u2, forearm u3, both from the horizontal; the flange stays level
    return {{{1, 0, 0, 0},
             {0, 1, 0, 0},
             {0, 0, 1, 0},
             {0, 1, -1, 0},
             {0, -1, 1, 0},
             {0, 1, 0, 0},
             {0, -1, 0, 0},
             {0, 0, 1, 0},
             {0, 0, -1, 0},
             {0, 0, 0, 1}},
            {0, 1, 2, 9},
            {turn, turn, turn, turn}};
  if (robot == "wrist_arm")
    return {{{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 1, 0, 0}, {0, 0, 0, 0.5, 0.5}, {0, 0, 0, 0.5, -0.5}},
            {0, 1, 2, 3, 4},
            {turn, turn, turn, turn, turn}};
  if (robot == "gripper")  // roll; both fingers slide alike, each in its own direction
    return {{{1, 0}, {0, 1}, {0, 1}}, {0, 1}, {turn, 1.0}};
  Drives own;
  for (int i = 0; i < joints; ++i) {
    own.g.emplace_back(static_cast<std::size_t>(joints), 0.0);
    own.g.back()[static_cast<std::size_t>(i)] = 1.0;
    own.owner.push_back(i);
  }
  return own;
}

struct Arm {
  Chain chain;   ///< without rotors and friction where drives are shared
  Chain motors;  ///< links with rotor and friction of each drive, in the order of drives
  Drives drives;
  std::vector<Link> links;  ///< with everything, as the truth has them
  bool shared() const { return !drives.turn.empty(); }
  int values() const { return motors.size(); }
};

oracle::Vector<double> times(const std::vector<std::vector<double>>& g, const oracle::Vector<double>& u) {
  oracle::Vector<double> q;
  for (const auto& row : g) {
    q.push_back(0.0);
    for (std::size_t k = 0; k < u.size(); ++k)
      q.back() += row[k] * u[k];
  }
  return q;
}

void remove_drive(Link& link) {
  link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = 0.0;
}

Arm altered_arm(const Options& options) {
  Arm arm;
  Random random(options.seed);
  const auto robot = host_sim::identification::find_robot(options.robot, "");
  arm.drives = drives_of(options.robot, robot.size());
  for (int i = 0; i < robot.size(); ++i) {
    const axial::LinkParameters& link = robot.links[static_cast<std::size_t>(i)].parameters;
    arm.chain.links.push_back(oracle::link_from_axial<double>(link, robot.parent(i)));
    alter(arm.chain.links.back(), link.effort_limit, link.speed_limit, options.spread, random);
    if (std::count(arm.drives.owner.begin(), arm.drives.owner.end(), i) == 0) remove_drive(arm.chain.links.back());
  }
  arm.links = arm.chain.links;
  for (const int i : arm.drives.owner)
    arm.motors.links.push_back(arm.chain[i]);
  if (arm.shared())
    for (Link& link : arm.chain.links)
      remove_drive(link);
  arm.chain.base = oracle::pose_from_axial<double>(robot.base);
  arm.chain.tool = oracle::pose_from_axial<double>(robot.tool);
  arm.chain.gravity = {robot.gravity.x, robot.gravity.y, robot.gravity.z};
  return arm;
}

/// G^T tau of the joints, and the rotors.
oracle::Vector<double> driven_torque(const Arm& arm, const host_sim::SetPoint& point) {
  const auto& g = arm.drives.g;
  const auto tau =
      oracle::recursive_inverse_dynamics(arm.chain, times(g, point.q), times(g, point.qd), times(g, point.qdd));
  oracle::Vector<double> result;
  for (std::size_t k = 0; k < point.q.size(); ++k) {
    const Link& motor = arm.motors[static_cast<int>(k)];
    result.push_back(motor.gear * motor.gear * motor.rotor_inertia * point.qdd[k]);
    for (std::size_t i = 0; i < g.size(); ++i)
      result.back() += g[i][k] * tau[i];
  }
  return result;
}

std::vector<oracle::Vector<double>> torques(const Arm& arm, const host_sim::Trajectory& motion) {
  std::unique_ptr<oracle::KdlChain> kdl;
  if (!arm.shared()) kdl = std::make_unique<oracle::KdlChain>(arm.chain);
  std::vector<oracle::Vector<double>> result;
  for (const host_sim::SetPoint& point : motion) {
    result.push_back(kdl ? kdl->inverse_dynamics(point.q, point.qd, point.qdd) : driven_torque(arm, point));
    const auto friction = oracle::friction_torque(arm.motors, point.qd);
    for (std::size_t i = 0; i < friction.size(); ++i)
      result.back()[i] += friction[i];
  }
  return result;
}

void add_noise(std::vector<oracle::Vector<double>>& torque, double share, Random& random) {
  for (std::size_t i = 0; i < torque.front().size(); ++i) {
    double sum = 0.0;
    for (const auto& row : torque)
      sum += row[i] * row[i];
    std::normal_distribution<double> noise(0.0, share * std::sqrt(sum / static_cast<double>(torque.size())));
    for (auto& row : torque)
      row[i] += noise(random);
  }
}

double encoder(const Arm& arm, int k, double q, double counts) {
  if (!(counts > 0.0)) return q;
  const double turn = arm.shared()                                   ? arm.drives.turn[static_cast<std::size_t>(k)]
                      : arm.chain[k].type == oracle::Joint::revolute ? 2.0 * pi
                                                                     : 1.0;
  const double step = turn / counts;
  return step * std::round(q / step);
}

void write_log(const Options& options, const Arm& arm, const host_sim::Trajectory& motion) {
  Random random(options.seed + 1);
  auto torque = torques(arm, motion);
  if (options.noise > 0.0) add_noise(torque, options.noise, random);
  std::ofstream file(options.log);
  file.precision(17);
  file << "time";
  for (const char* name : {"q", "tau"})
    for (int i = 1; i <= arm.values(); ++i)
      file << ',' << name << i;
  file << '\n';
  for (std::size_t k = 0; k < motion.size(); ++k) {
    file << motion[k].time;
    for (int i = 0; i < arm.values(); ++i)
      file << ',' << encoder(arm, i, motion[k].q[static_cast<std::size_t>(i)], options.counts);
    for (const double value : torque[k])
      file << ',' << value;
    file << '\n';
  }
}

void run(const Options& options) {
  const Arm arm = altered_arm(options);
  write_log(options, arm, host_sim::read_set_points(options.motion, arm.values()));
  nlohmann::json truth;
  for (const Link& link : arm.links)
    for (const auto& value : parameters(link))
      truth.push_back(value);
  std::ofstream(options.truth) << truth.dump() << '\n';
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  host_sim::CommandLine line("the log of an altered arm by Orocos KDL, and its standard parameters", "simulated_log");
  line.option("--robot", options.robot, "name or table").required();
  line.option("--motion", options.motion, "set-points: time, q, qd, qdd").required();
  line.option("--log", options.log).required();
  line.option("--truth", options.truth).required();
  line.option("--seed", options.seed);
  line.option("--spread", options.spread, "of the alterations, a share");
  line.option("--counts", options.counts, "of an encoder a turn or a metre; 0: exact");
  line.option("--noise", options.noise, "of torque, over the joint's RMS");
  return line.run(count, arguments, [&] {
    run(options);
    return 0;
  });
}
