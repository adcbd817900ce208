#include <host_sim/plants/simulation/models.hpp>

#include <robots/robots.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace host_sim::simulation {

namespace {

struct Description {
  std::string name;
  std::vector<axial::LinkParameters> links;
  bool shares_drives;
  axial::GravityVector gravity;
  axial::FixedPose base, tool;
};

template <class Robot>
Description described() {
  const auto& chain = Robot::chain;
  Description d{Robot::name, {}, chain.shares_drives(), chain.gravity, chain.base.pose, chain.tool.pose};
  for (int i = 0; i < chain.size; ++i) {
    d.links.push_back(chain.links[i]);
    d.links.back().parent = chain.parent(i) < 0 ? axial::LinkParameters::base : chain.parent(i);
  }
  return d;
}

const std::vector<Description>& descriptions() {
  static const std::vector<Description> all = [] {
    std::vector<Description> list;
    const auto describe = [&](auto robot) { list.push_back(described<typename decltype(robot)::Robot>()); };
    robots::All::for_each(describe);
    robots::Trees::for_each(describe);
    robots::SharedDrives::for_each(describe);
    return list;
  }();
  return all;
}

const Description& find(const std::string& robot) {
  std::string names;
  for (const Description& d : descriptions()) {
    if (d.name == robot) return d;
    names += (names.empty() ? "" : ", ") + d.name;
  }
  throw std::runtime_error("unknown robot '" + robot + "'; there are: " + names);
}

template <class M>
void add(M& model, const axial::LinkParameters& link) {
  if (!model.add(link)) throw std::runtime_error("a plant has twelve joints at most");
}
void add(Model& model, const axial::Link& link) { add(model, link.parameters()); }

/// A model of links that stands as a description does.
template <class M>
M placed(const Description& d, const std::vector<axial::LinkParameters>& links) {
  if (d.shares_drives != std::is_same_v<M, DrivenModel>)
    throw std::runtime_error("joints of '" + d.name + "' " + (d.shares_drives ? "" : "do not ") +
                             "share drives: its model is robot_model() or, of those that do, driven_model()");
  M model;
  for (const auto& link : links)
    add(model, link);
  model.set_gravity(d.gravity.x, d.gravity.y, d.gravity.z);
  model.set_base(d.base);
  model.set_tool(d.tool);
  return model;
}

std::vector<std::string> names_where(bool shares_drives) {
  std::vector<std::string> names;
  for (const Description& d : descriptions())
    if (d.shares_drives == shares_drives) names.push_back(d.name);
  return names;
}

// Stored on the way: GCC 12 forgets the rounding where it vectorises two such casts beside each other (-O2).
double as_float(double x) {
  const volatile auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest);
}

}  // namespace

Model robot_model(const std::string& robot) { return model_of(robot, find(robot).links); }

std::vector<axial::LinkParameters> robot_links(const std::string& robot) { return find(robot).links; }

Model model_of(const std::string& robot, const std::vector<axial::LinkParameters>& links) {
  return placed<Model>(find(robot), links);
}

std::vector<std::string> robot_names() { return names_where(false); }

axial::LinkParameters carrying(axial::LinkParameters link, const axial::PayloadBody<double>& load) {
  using Point = axial::Vec3<double>;
  const double mass = link.mass + load.mass;
  const Point own{link.com[0], link.com[1], link.com[2]};
  const Point centre = (1.0 / mass) * (link.mass * own + load.mass * load.com);
  const auto& j = load.inertia_com;
  const double added[] = {j.xx, j.yy, j.zz, j.xy, j.xz, j.yz};
  for (int i = 0; i < 6; ++i)
    link.inertia_com[i] += added[i];
  const auto shift = [&](const Point& from, double m) {  // parallel axes: m (r . r - r r^T)
    const Point r = from - centre;
    const double squares[] = {
        r.y * r.y + r.z * r.z, r.x * r.x + r.z * r.z, r.x * r.x + r.y * r.y, -r.x * r.y, -r.x * r.z, -r.y * r.z};
    for (int i = 0; i < 6; ++i)
      link.inertia_com[i] += m * squares[i];
  };
  shift(own, link.mass), shift(load.com, load.mass);
  link.mass = mass, link.com[0] = centre.x, link.com[1] = centre.y, link.com[2] = centre.z;
  return link;
}

DrivenModel driven_model(const std::string& robot) { return driven_model_of(robot, find(robot).links); }

DrivenModel driven_model_of(const std::string& robot, const std::vector<axial::LinkParameters>& links) {
  return placed<DrivenModel>(find(robot), links);
}

std::vector<std::string> driven_robot_names() { return names_where(true); }

bool shares_drives(const std::string& robot) { return find(robot).shares_drives; }

std::vector<axial::LinkParameters> robot_values(const std::string& robot) {
  const Description& d = find(robot);
  if (!d.shares_drives) return d.links;
  axial::LinkParameters all[axial::joint_count<DrivenModel>] = {};
  std::copy(d.links.begin(), d.links.end(), all);
  const auto g = axial::drive_matrix_of(all);
  std::vector<axial::LinkParameters> drives;
  for (int k = 0; k < g.drives && g.owner[k] < static_cast<int>(d.links.size()); ++k) {
    const auto& owner = all[g.owner[k]];
    const bool alone = g.is_alone(g.owner[k]);
    drives.push_back(axial::detail::drive_by_itself(owner, alone));
    drives.back().type = alone ? owner.type : axial::JointType::revolute;
  }
  return drives;
}

Model pendulum() {
  Model model;
  model.set_gravity(0.0, -9.81, 0.0);
  add(model, axial::revolute().mass(1.0).com(1.0, 0.0, 0.0));
  return model;
}

Model rods(int n) {
  Model model;
  model.set_gravity(0.0, -9.8125, 0.0);
  const double across = as_float(1.0 / 12.0), along = std::ldexp(1.0, -10);
  for (int i = 0; i < n; ++i)
    add(model, axial::revolute().a(i == 0 ? 0.0 : 1.0).mass(1.0).com(0.5, 0.0, 0.0).inertia_com(along, across, across));
  return model;
}

Model babyboot() {
  constexpr double g_cm2 = 1e-7;
  Model model;
  model.set_gravity(9.81, 0.0, 0.0);
  // z is the pivot's axis, and -y of frame 1 points down the rod, about which joint 2 turns.
  add(model, axial::revolute().theta_deg(90).mass(0.01).com(0.0, -0.075, 0.0).inertia_com(0.0, 0.0, 50.0 * g_cm2));
  add(model, axial::revolute()
                 .alpha_deg(90)
                 .mass(0.1)
                 .com(0.0, 0.0, 0.2)
                 .inertia_com(500.0 * g_cm2, 2500.0 * g_cm2, 2000.0 * g_cm2));
  return model;
}

Values<double> nominal_pose() { return {0.25, -0.75, 1.25, 0.5, -1.0, 0.375}; }

Model sprung_arm(double stiffness, const Values<double>& rest, double damping) {
  constexpr double masses[] = {8.0, 6.0, 4.0, 2.0, 1.0, 0.5};
  constexpr double a[] = {0.0, 0.0625, 0.4375, 0.0625, 0.0, 0.0}, d[] = {0.5, 0.0, 0.125, 0.4375, 0.0, 0.125};
  constexpr int quarters[] = {0, 1, 0, 1, -1, 1};
  const double slim = as_float(1.0 / 384.0), wide = as_float(5.0 / 768.0);  // a box of 1 kg
  Model model;
  model.set_gravity(0.0, 0.0, -9.8125);
  for (int i = 0; i < 6; ++i)
    add(model, axial::revolute()
                   .alpha_deg(90.0 * quarters[i])
                   .a(a[i])
                   .d(d[i])
                   .mass(masses[i])
                   .com(0.0625, -0.03125, 0.125)
                   .inertia_com(as_float(masses[i] * slim), as_float(masses[i] * wide), as_float(masses[i] * wide))
                   .spring(stiffness, rest[i])
                   .viscous(damping));
  return model;
}

Model leg() {
  Model model;
  model.set_gravity(0.0, 0.0, -9.8125);
  add(model, axial::prismatic().mass(2.0).inertia_com(0.01, 0.01, 0.01));
  add(model, axial::revolute().alpha_deg(-90).mass(0.5).com(0.125, 0.0, 0.0).inertia_com(0.0005, 0.0026, 0.0026));
  add(model, axial::revolute().a(0.25).mass(0.25).com(0.125, 0.0, 0.0).inertia_com(0.00025, 0.0013, 0.0013));
  axial::FixedPose foot;
  foot.position[0] = 0.25;
  model.set_tool(foot);
  return model;
}

double energy(const Model& model, const Values<double>& q, const Values<double>& qd) {
  return axial::energy(model, q, qd, {}).total();
}

double energy(const DrivenModel& model, const axial::Joints<DrivenModel, double>& u,
              const axial::Joints<DrivenModel, double>& ud) {
  return axial::energy(model, u, ud, {}).total();
}

}  // namespace host_sim::simulation
