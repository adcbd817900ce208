#include <host_sim/robots/description/comment.hpp>
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/engine.hpp>
#include <host_sim/robots/import/reference.hpp>
#include <host_sim/tools/analysis/largest.hpp>
#include <host_sim/tools/system/temporary_folder.hpp>

#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <nlohmann/json.hpp>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

extern char** environ;

namespace importer {
namespace {

using host_sim::note_size;

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Whether a program ended well, in a minute.
bool run(std::vector<std::string> words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (auto& word : words)
    arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return false;
  for (int i = 0; i < 6000; ++i) {
    int status = 0;
    if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, SIGKILL), waitpid(child, nullptr, 0);
  return false;
}

class Comparison {
 public:
  Comparison(const EngineTree& read, unsigned seed, int states) : read_(read), tree_(read.tree) {
    std::vector<std::string> order;
    for (std::size_t i = 1; i < tree_.links.size(); ++i)
      if (tree_.links[i].joint.moves()) movers_.push_back(i), order.push_back(tree_.links[i].joint.name);
    reference_ = reference_of(tree_, tree_, {}, read.gravity, order);
    for (const auto& name : reference_.joints)
      order_.push_back(GetTreeElementQNr(reference_.tree.getSegment(name)->second));
    std::mt19937 random(seed);
    for (int i = 0; i < states; ++i)
      add_state(random);
  }

  Json questions(const std::string& file) const {
    Json links = Json::array(), held = Json::array();
    for (std::size_t i = 0; i < tree_.links.size(); ++i) {
      links.push_back(name_of(i));
      const auto& joint = tree_.links[i].joint;
      if (joint.held) held.push_back({{"link", i}, {"at", joint.held_at}});
    }
    return {{"file", fs::absolute(file).string()},
            {"links", links},
            {"movers", movers_},
            {"held", held},
            {"states", states_}};
  }
  EngineFigures compare(const Json& answer) {
    figures_.states = static_cast<int>(states_.size());
    figures_.bound = read_.is_diagonalised ? 1e-6 : 1e-9;
    for (std::size_t i = 0; i < states_.size(); ++i)
      compare_state(states_[i], answer.at("states").at(i));
    compare_bodies(answer.at("bodies")), compare_joints(answer.at("joints"));
    figures_.torque = over(figures_.torque, torque_scale_),
    figures_.mass_matrix = over(figures_.mass_matrix, mass_scale_);
    figures_.engine = answer.at("version").get<std::string>();
    return figures_;
  }

 private:
  using Values = std::vector<double>;
  static double over(double error, double scale) { return error == 0.0 ? 0.0 : error / scale; }
  const SourceJoint& joint(std::size_t k) const { return tree_.links[movers_[k]].joint; }
  Json name_of(std::size_t i) const {
    const auto& names = read_.names[i];
    return {{"kind", names.kind},
            {"name", names.name},
            {"joint", names.joint},
            {"body", names.body},
            {"which", names.which}};
  }

  void add_state(std::mt19937& random) {
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Values q, qd, qdd;
    for (std::size_t k = 0; k < movers_.size(); ++k) {
      const double span = joint(k).kind == Kind::prismatic ? 1.0 : 3.14159;
      q.push_back(joint(k).has_limits ? between(joint(k).lower, joint(k).upper) : between(-span, span));
      qd.push_back(between(-2.0, 2.0)), qdd.push_back(between(-5.0, 5.0));
    }
    states_.push_back({{"q", q}, {"qd", qd}, {"qdd", qdd}});
  }
  KDL::JntArray kdl(const Values& values) const {
    KDL::JntArray result(static_cast<unsigned>(movers_.size()));
    for (std::size_t k = 0; k < movers_.size(); ++k)
      result(order_[k]) = values[k];
    return result;
  }
  Values torque(const KDL::Vector& gravity, const Values& q, const Values& qd, const Values& qdd) const {
    KDL::TreeIdSolver_RNE solver(reference_.tree, gravity);
    KDL::JntArray tau(static_cast<unsigned>(movers_.size()));
    if (solver.CartToJnt(kdl(q), kdl(qd), kdl(qdd), {}, tau) < 0) throw description::Refused("KDL refuses the robot");
    Values result;
    for (std::size_t k = 0; k < movers_.size(); ++k)
      result.push_back(tau(order_[k]) + joint(k).rotor * qdd[k]);
    return result;
  }
  std::string segment(std::size_t link) const { return link == 0 ? "root" : segment_name(tree_.links[link].name); }

  void compare_state(const Json& state, const Json& answer) {
    const Values q = state.at("q"), qd = state.at("qd"), qdd = state.at("qdd");
    compare_poses(q, answer.at("poses"));
    const Values ours = torque(reference_.gravity, q, qd, qdd), theirs = answer.at("torque");
    for (std::size_t k = 0; k < movers_.size(); ++k)
      note_size(figures_.torque, ours[k] - theirs.at(k)), note_size(torque_scale_, theirs[k]);
    const Values none(movers_.size());
    for (std::size_t l = 0; l < movers_.size(); ++l) {
      Values unit = none;
      unit[l] = 1.0;
      const Values column = torque(KDL::Vector::Zero(), q, none, unit), other = answer.at("mass_matrix").at(l);
      for (std::size_t k = 0; k < movers_.size(); ++k)
        note_size(figures_.mass_matrix, column[k] - other.at(k)), note_size(mass_scale_, other[k]);
    }
  }
  KDL::Frame pose_of(const KDL::JntArray& q, std::size_t link) {
    KDL::TreeFkSolverPos_recursive solver(reference_.tree);
    KDL::Frame pose;
    if (solver.JntToCart(q, pose, segment(link)) < 0) throw description::Refused("KDL knows no " + segment(link));
    return pose;
  }
  void compare_poses(const Values& q, const Json& poses) {
    const auto positions = kdl(q);
    for (std::size_t i = 0; i < tree_.links.size(); ++i) {
      if (poses.at(i).is_null()) continue;
      const Values theirs = poses.at(i);
      const KDL::Frame ours = pose_of(positions, i);
      double square = 0.0, length = 1.0;
      for (std::size_t k = 0; k < 3; ++k)
        square += std::pow(ours.p.data[k] - theirs.at(k), 2), length = std::max(length, std::abs(theirs[k]));
      note_size(figures_.pose, std::sqrt(square) / length);
      for (std::size_t k = 0; k < 9; ++k)
        note_size(figures_.pose, ours.M.data[k] - theirs.at(3 + k));
    }
  }
  /// In the first state: mass, centre of mass, inertia about it, in axes of the root.
  void compare_bodies(const Json& bodies) {
    const auto q = kdl(states_.at(0).at("q"));
    for (std::size_t i = 0; i < tree_.links.size(); ++i) {
      if (!read_.names[i].weighs) continue;
      const Values theirs = bodies.at(i);
      const auto& link = tree_.links[i];
      const auto& c = link.inertial.position;
      const auto& j = link.inertia;
      const auto& r = link.inertial.rotation;
      const KDL::Frame pose = pose_of(q, i);
      const KDL::Rotation axes = pose.M * KDL::Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
      const KDL::RotationalInertia inertia(j[0], j[1], j[2], j[3], j[4], j[5]);
      const auto tensor =
          (KDL::Frame(axes) * KDL::RigidBodyInertia(0.0, KDL::Vector::Zero(), inertia)).getRotationalInertia();
      const KDL::Vector centre = pose * KDL::Vector(c[0], c[1], c[2]), other(theirs.at(1), theirs.at(2), theirs.at(3));
      note_size(figures_.body, over(std::abs(link.mass - theirs.at(0)), std::abs(theirs[0])));
      if (theirs[0] > 0.0) note_size(figures_.body, length_of(centre - other));
      for (std::size_t k = 0; k < 9; ++k)
        note_size(figures_.body, over(std::abs(tensor.data[k] - theirs.at(4 + k)), theirs[4] + theirs[8] + theirs[12]));
    }
  }
  void compare_joints(const Json& joints) {
    for (std::size_t k = 0; k < movers_.size(); ++k) {
      const auto& own = joint(k);
      const Json& other = joints.at(k);
      const auto same = [&](double ours, const char* name) {
        const double theirs = other.at(name);
        note_size(figures_.joint, std::abs(ours - theirs) / std::max(1.0, std::abs(theirs)));
      };
      if (own.has_limits != other.at("limited").get<bool>()) note_size(figures_.joint, 1.0);
      if (own.has_limits) same(own.lower, "lower"), same(own.upper, "upper");
      same(own.damping, "damping"), same(own.friction, "friction"), same(own.rotor, "rotor");
      same(own.stiffness, "stiffness");
      if (own.stiffness != 0.0) same(own.rest, "rest");
      if (!other.contains("leader")) continue;  // an engine that tells more of a joint
      if (own.leader != other.at("leader").get<std::string>()) note_size(figures_.joint, 1.0);
      same(own.ratio, "ratio"), same(own.offset, "offset"), same(own.speed, "speed"), same(own.effort, "effort");
    }
  }

  const EngineTree& read_;
  const SourceTree& tree_;
  std::vector<std::size_t> movers_;  ///< links whose joints move
  Reference reference_;
  std::vector<unsigned> order_;
  std::vector<Json> states_;
  EngineFigures figures_;
  double torque_scale_ = 0.0, mass_scale_ = 0.0;
};

EngineFigures without(const EngineTree& read, const std::string& reason) {
  EngineFigures figures;
  figures.asked = read.engine, figures.why_not = description::harmless(reason);
  return figures;
}

}  // namespace

std::string engine_questions(const std::string& file, const EngineTree& read, unsigned seed, int states) {
  return Comparison(read, seed, states).questions(file).dump(-1, ' ', false, Json::error_handler_t::replace);
}

EngineFigures compared_with_engine(const EngineTree& read, unsigned seed, int states, const std::string& answer) {
  const Json found = Json::parse(answer, nullptr, false);
  try {
    if (found.contains("refused"))
      return without(read, "it refuses the file: " + found.at("refused").get<std::string>());
    return Comparison(read, seed, states).compare(found);
  } catch (const Json::exception&) {
    return without(read, "its answer is none");
  }
}

EngineFigures ask_engine(std::vector<std::string> program, const std::string& file, const EngineTree& read,
                         unsigned seed, int states) {
  if (program.empty()) return without(read, "it is not here");
  const host_sim::TemporaryFolder scratch;
  states = std::min(states, 20);
  std::ofstream(scratch.file("questions.json")) << engine_questions(file, read, seed, states);
  for (const char* name : {"questions.json", "answer.json"})
    program.push_back(scratch.file(name));
  if (!run(program)) return without(read, program.front() + " did not run it");
  return compared_with_engine(read, seed, states, description::read_text(scratch.file("answer.json")));
}

}  // namespace importer
