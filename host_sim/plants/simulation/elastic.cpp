#include <firmware/apps/plant/elastic_joint.hpp>
#include <host_sim/plants/simulation/elastic.hpp>

#include <stdexcept>

namespace host_sim::simulation {

namespace {

using axial::LinkParameters;

using axial::apps::plant::body_of;
using axial::apps::plant::is_elastic;
using axial::apps::plant::motor_of;

void check(const LinkParameters& link, std::size_t i) {
  const std::string joint = "joint " + std::to_string(i + 1) + ": ";
  if (!(link.rotor_inertia > 0.0)) throw std::runtime_error(joint + "an elastic joint needs its rotor_inertia");
  if (link.spring_stiffness != 0.0)
    throw std::runtime_error(joint + "a plant with elastic joints has no other springs");
}

}  // namespace

ElasticArm::ElasticArm(const std::string& robot, const std::vector<LinkParameters>& links,
                       const std::vector<double>& damping) {
  std::vector<LinkParameters> chain;
  std::vector<int> last;  // joint of the chain that carries what link i carries
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& link = links[i];
    LinkParameters first = is_elastic(link) ? motor_of(link) : link;
    if (link.parent >= 0) first.parent = last[static_cast<std::size_t>(link.parent)];
    motor_.push_back(static_cast<int>(chain.size()));
    chain.push_back(first);
    if (is_elastic(link)) {
      check(link, i);
      chain.push_back(body_of(link, damping.empty() ? 0.0 : damping[i]));
    }
    last.push_back(static_cast<int>(chain.size()) - 1);
    spring_.push_back(is_elastic(link) ? last.back() : -1);
    stiffness_.push_back(link.stiffness);
  }
  model_ = model_of(robot, chain);
}

Motion<double> ElasticArm::state(const Values<double>& q, const Values<double>& qd, const Values<double>& tau_l) const {
  Motion<double> x;
  for (int i = 0; i < joints(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double deflection = -tau_l[i] / stiffness_[k];
    x.q[motor_[k]] = q[i] - deflection, x.qd[motor_[k]] = qd[i];
    if (spring_[k] >= 0) x.q[spring_[k]] = deflection;
  }
  return x;
}

Values<double> ElasticArm::motors(const Values<double>& states) const {
  Values<double> result{};
  for (int i = 0; i < joints(); ++i)
    result[i] = states[motor_[static_cast<std::size_t>(i)]];
  return result;
}

Values<double> ElasticArm::deflections(const Values<double>& states) const {
  Values<double> result{};
  for (int i = 0; i < joints(); ++i)
    if (const int spring = spring_[static_cast<std::size_t>(i)]; spring >= 0) result[i] = states[spring];
  return result;
}

Values<double> ElasticArm::whole(const Values<double>& states) const {
  Values<double> result = motors(states);
  const auto more = deflections(states);
  for (int i = 0; i < joints(); ++i)
    result[i] += more[i];
  return result;
}

Values<double> ElasticArm::efforts(const Values<double>& tau_m) const {
  Values<double> result{};
  for (int i = 0; i < joints(); ++i)
    result[motor_[static_cast<std::size_t>(i)]] = tau_m[i];
  return result;
}

std::vector<LinkParameters> elastic_links(const std::string& robot, const std::vector<LinkParameters>& links,
                                          double resonance) {
  auto bare = links, result = links;
  Values<double> middle{};
  for (std::size_t i = 0; i < links.size(); ++i) {
    bare[i].rotor_inertia = 0.0;
    middle[static_cast<int>(i)] = 0.5 * (links[i].position_min + links[i].position_max);
  }
  const auto mass = axial::mass_matrix(model_of(robot, bare), middle, {});
  const double w = 2.0 * 3.14159265358979323846 * resonance;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double own = mass(static_cast<int>(i), static_cast<int>(i));
    result[i].stiffness = w * w * own;
    if (!(links[i].rotor_inertia > 0.0)) result[i].rotor_inertia = own, result[i].gear = 1.0;
  }
  return result;
}

}  // namespace host_sim::simulation
