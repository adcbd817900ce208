#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/numbers.hpp>

#include <algorithm>
#include <cmath>

namespace description {
namespace {

constexpr double longest_arm = 20.0;  // m between two joints; beyond it they are most likely millimetres

class Inspector {
 public:
  Inspector(const Link& link, bool as_published) : link_(link), p_(link.parameters), as_published_(as_published) {}

  std::vector<Finding> all() {
    found_ = body_findings(link_.name, p_, as_published_);
    geometry(), drive(), friction(), limits(), range();
    return found_;
  }

 private:
  void refuse(const std::string& what, const std::string& remedy) {
    found_.push_back({true, link_.name, what, remedy});
  }
  void warn(const std::string& what, const std::string& remedy) { found_.push_back({false, link_.name, what, remedy}); }
  /// What axial compiles only where it is accepted.
  void doubt(const std::string& what, const std::string& correct) {
    found_.push_back({false, link_.name, what, correct_or_keep(as_published_, correct), !as_published_});
  }
  std::string joint() const { return "joint '" + link_.joint + "': "; }

  void geometry() {
    struct Length {
      const char* name;
      double value;
    };
    for (const auto& [name, value] : {Length{"a", p_.a}, Length{"d", p_.d}, Length{"b", p_.b}}) {
      if (!usable(value))
        refuse(joint() + name + " is " + number(value) + " m", "give metres");
      else if (axial::detail::is_far(value))
        doubt(joint() + name + " is " + number(value, 4) + " m",
              "give metres, not millimetres; if two axes were meant to be parallel, see --snap");
      else if (std::abs(value) > longest_arm)
        warn(joint() + name + " is " + number(value, 4) + " m",
             "if these are millimetres, give metres; if two axes were meant to be parallel, see --snap");
    }
    for (const auto& angle : {p_.alpha, p_.theta, p_.gamma})
      if (!usable(angle.radians)) refuse(joint() + "an angle is " + number(angle.radians) + " rad", "give radians");
  }
  void drive() {
    if (!usable(p_.rotor_inertia) || p_.rotor_inertia < 0.0)
      refuse(joint() + "rotor inertia is " + number(p_.rotor_inertia) + " kg m^2", "give kg m^2 >= 0, motor side");
    if (!usable(p_.gear) || (p_.rotor_inertia != 0.0 && p_.gear == 0.0))
      refuse(joint() + "gear ratio is " + number(p_.gear), "give motor turns a joint turn");
    if (!usable(p_.spring_stiffness) || !usable(p_.spring_rest))
      refuse(joint() + "spring is " + number(p_.spring_stiffness) + ", " + number(p_.spring_rest),
             "give its stiffness and its position of rest");
  }
  void friction() {
    if (!usable(p_.viscous) || p_.viscous < 0.0)
      refuse(joint() + "viscous friction is " + number(p_.viscous) + " and would feed energy in", "give a value >= 0");
    if (!usable(p_.coulomb_forward) || !usable(p_.coulomb_backward) || p_.coulomb_forward < 0.0 ||
        p_.coulomb_backward > 0.0)
      refuse(joint() + "Coulomb friction is " + number(p_.coulomb_forward) + " forward and " +
                 number(p_.coulomb_backward) + " backward, and would feed energy in",
             "give a forward value >= 0 and a backward value <= 0");
    const double dry = std::max(p_.coulomb_forward, -p_.coulomb_backward);
    if (!usable(p_.static_friction) || (p_.static_friction != 0.0 && p_.static_friction < dry))
      refuse(
          joint() + "static friction is " + number(p_.static_friction) + ", below the Coulomb friction " + number(dry),
          "give the larger");
    if (p_.static_friction != 0.0 && !(p_.stribeck_speed >= 1e-9))
      refuse(joint() + "Stribeck speed is " + number(p_.stribeck_speed), "give at least 1e-9 rad/s or m/s");
    if (p_.smooth_speed != 0.0 && !(p_.smooth_speed >= 1e-9))
      refuse(joint() + "smooth_speed is " + number(p_.smooth_speed), "give at least 1e-9, or leave it out for a step");
  }
  void limits() {
    if (!(p_.position_min < p_.position_max))
      refuse(joint() + "position limits are upside down: " + number(p_.position_min) + " to " + number(p_.position_max),
             "give the lower one first; a joint that cannot move is a fixed joint");
    limit("speed", p_.speed_limit), limit("acceleration", p_.acceleration_limit), limit("effort", p_.effort_limit);
  }
  void range() {
    const std::string limits = number(p_.position_min) + " to " + number(p_.position_max);
    if (p_.mass > axial::detail::bound::mass) doubt("mass is beyond 1000 kg: " + number(p_.mass), "give kilograms");
    switch (axial::detail::range_problem(p_)) {
      case axial::detail::Problem::position_limits_look_like_degrees:
        return doubt(joint() + "position limits look like degrees: " + limits + " rad", "give radians");
      case axial::detail::Problem::position_limits_are_beyond_1000_rad:
        return doubt(joint() + "position limits are beyond 1000 rad: " + limits, "give radians");
      case axial::detail::Problem::position_limits_are_beyond_100_m:
        return doubt(joint() + "position limits are beyond 100 m: " + limits, "give metres");
      default:
        if (axial::detail::is_far(p_.com)) doubt("centre of mass is beyond 100 m", "give metres");
    }
  }
  void limit(const std::string& of, double value) {
    if (!(value > 0.0)) refuse(joint() + of + " limit is " + number(value), "give a value > 0, or leave it out");
  }

  const Link& link_;
  const axial::LinkParameters& p_;
  bool as_published_;
  std::vector<Finding> found_;
};

bool has_body(const axial::LinkParameters& p) {
  return p.mass > 0.0 || std::any_of(p.inertia_com, p.inertia_com + 6, [](double v) { return v != 0.0; });
}

/// Joints that nothing resists: no rotor, and no body from there outwards.
void unresisted(const Description& robot, std::vector<Finding>& found) {
  std::vector<bool> carries(robot.links.size());
  for (int i = robot.size(); i-- > 0;) {
    const auto k = static_cast<std::size_t>(i);
    const auto& p = robot.links[k].parameters;
    if (has_body(p)) carries[k] = true;
    const int parent = robot.parent(i);
    if (carries[k] && parent >= 0 && parent < i) carries[static_cast<std::size_t>(parent)] = true;
    if (!carries[k] && p.rotor_inertia == 0.0)
      found.push_back({false, robot.links[k].name,
                       "joint '" + robot.links[k].joint + "' moves nothing that has inertia",
                       "forward dynamics needs a body from there outwards, or rotor_inertia"});
  }
}

/// m: how far a robot reaches at most, by the lengths of its rows and the travel of its slides.
double size_of(const Description& robot) {
  double sum = 0.0, centre = 0.0;
  for (const Link& link : robot.links) {
    const auto& p = link.parameters;
    sum += std::hypot(p.a, p.d, p.b);
    const double travel = std::max(std::abs(p.position_min), std::abs(p.position_max));
    if (p.type == axial::JointType::prismatic && std::isfinite(travel)) sum += travel;
    centre = std::max(centre, std::hypot(p.com[0], p.com[1], p.com[2]));
  }
  const double* tool = robot.tool.position;
  return sum + std::max(centre, std::hypot(tool[0], tool[1], tool[2]));
}

/// Inertias of bodies larger than the robot: most likely in other units.
void absurd_inertias(const Description& robot, std::vector<Finding>& found) {
  constexpr double least = 0.1;  // m: of robots that hardly have lengths; of one without any nothing is said
  const double reach = size_of(robot), size = std::max(least, reach);
  if (!(reach > 0.0)) return;
  for (const Link& link : robot.links) {
    const auto& p = link.parameters;
    const double largest = std::max({p.inertia_com[0], p.inertia_com[1], p.inertia_com[2]});
    const double radius = p.mass > 0.0 ? std::sqrt(std::max(0.0, largest) / p.mass) : 0.0;
    if (radius > size)
      found.push_back({false, link.name,
                       "joint '" + link.joint + "' moves " + number(p.mass, 4) + " kg with an inertia of " +
                           number(largest, 4) + " kg m^2: a radius of gyration of " + number(radius, 3) +
                           " m, in a robot of " + number(size, 3) + " m",
                       "give kg m^2 about the centre of mass, not g or mm"});
  }
}

void check_robot(const Description& robot, std::vector<Finding>& found) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    found.push_back({true, "", what, remedy});
  };
  if (robot.links.empty())
    refuse("there is no joint that moves", "an arm needs at least one revolute or prismatic joint");
  if (robot.size() > most_links)
    refuse("there are " + std::to_string(robot.size()) + " joints",
           "import at most 64; --root and --tip cut one chain");
  const auto& g = robot.gravity;
  if (!usable(g.x) || !usable(g.y) || !usable(g.z)) refuse("gravity is not finite", "give three numbers in m/s^2");
  if (frames_are_far(robot))
    found.push_back({false, "", "the base or the tool is more than 100 m away",
                     correct_or_keep(robot.as_published, "give metres"), !robot.as_published});
  for (int i = 0; i < robot.size(); ++i)
    if (robot.parent(i) < axial::LinkParameters::base || robot.parent(i) >= i)
      refuse("the parent of link '" + robot.links[static_cast<std::size_t>(i)].name + "' does not stand before it",
             "list links from the base outwards");
}

/// Of joints that share drives: what axial does not compile.
void shared_drives(const Description& robot, std::vector<Finding>& found) {
  if (!shares_drives(robot) || robot.size() > most_links) return;
  const auto g = drive_matrix(robot);
  using axial::detail::Problem;
  for (int i = 0; i < robot.size(); ++i) {
    const Link& link = robot.links[static_cast<std::size_t>(i)];
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
      found.push_back({true, link.name, "joint '" + link.joint + "' " + what, remedy});
    };
    if (axial::detail::drive_numbers_problem(link.parameters) != Problem::none)
      refuse("shares drives by a ratio that is 0 or not finite, or with limits upside down", "give ratios and limits");
    const auto problem = axial::detail::shared_drives_problem(g, link.parameters, i);
    if (problem == Problem::drives_are_no_drives_of_the_chain)
      refuse("is moved by what is not there, has no drive, or follows it", "name joints with a drive, six at most");
    else if (problem != Problem::none)
      refuse("has no drive of its own, but an effort limit, a rotor or friction", "give them to what moves it");
  }
  const auto all = [&] {
    for (int i = 0; i < robot.size(); ++i)
      if (g.mover_of(i) < 0) return false;
    return g.independent;
  };
  if (!all())
    found.push_back({true, "", "the drives do not move the joints independently of each other",
                     "every drive moves a joint of its own, every joint is moved"});
}

}  // namespace

std::string Finding::text() const { return (link.empty() ? "" : "link '" + link + "': ") + what + "; " + remedy; }

bool frames_are_far(const Description& robot) {
  return axial::detail::is_far(robot.base.position) || axial::detail::is_far(robot.tool.position) ||
         axial::detail::is_far(robot.payload_limit.com_reach) || axial::detail::is_far(robot.tool_limit.reach);
}

std::vector<Finding> findings(const Description& robot) {
  std::vector<Finding> found;
  check_robot(robot, found);
  for (const Link& link : robot.links) {
    const auto more = Inspector(link, robot.as_published).all();
    found.insert(found.end(), more.begin(), more.end());
  }
  if (robot.base_body) {
    const auto more = body_findings("base", *robot.base_body, robot.as_published);
    found.insert(found.end(), more.begin(), more.end());
  }
  unresisted(robot, found), absurd_inertias(robot, found);
  shared_drives(robot, found);
  return found;
}

std::string lines(const std::vector<Finding>& found, bool errors) {
  std::string text;
  for (const Finding& finding : found)
    if (finding.error == errors) text += (text.empty() ? "" : "\n") + finding.text();
  return text;
}

std::string lines_to_accept(const std::vector<Finding>& found) {
  std::string text;
  for (const Finding& finding : found)
    if (finding.must_be_accepted) text += (text.empty() ? "" : "\n") + finding.text();
  return text;
}

std::vector<Finding> check(const Description& robot) {
  auto found = findings(robot);
  const std::string errors = lines(found, true);
  if (!errors.empty()) throw Refused(errors);
  return found;
}

}  // namespace description
