// Ranges: what bounds the quantities of every link, and in which formats they are kept. doc/guides/ranges.md is the
// proof.
#pragma once

#include <axial/derivatives/derivative_rounding.hpp>
#include <axial/fixed/balls/ball.hpp>
#include <axial/fixed/balls/terms.hpp>
#include <axial/links/link_view.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What limits a robot's joint: as its author declared it. Travel is the largest |d + q| of a slide.
struct JointRange {
  /// rad/s or m/s, rad/s^2 or m/s^2, m, N m or N; at most
  double speed = 0.0, acceleration = 0.0, travel = 0.0, effort = 0.0;
  /// how far its words are from what they stand for, in the same units (rad or m of a position)
  double position_error = 0.0, speed_error = 0.0, acceleration_error = 0.0;
  int effort_format = unknown;           ///< exponent of its effort where that is given (fixed_joints.hpp)
  static constexpr int unknown = -1000;  ///< no exponent is given
};

/// What a scene puts on a robot besides its links.
struct LoadRange {
  double gravity_across = 0.0, gravity_along = 0.0;  ///< m/s^2, across and along z of frame 0
  /// kg, kg m, kg m^2; about the origin of the last link's frame
  double payload_mass = 0.0, payload_moment = 0.0, payload_inertia = 0.0;
  double tip_force = 0.0, tip_moment = 0.0;     ///< N, N m
  double base_offset = 0.0, tool_offset = 0.0;  ///< m, of frame 0 in the world and of the tool on the last link
  double tool_reach = 0.0;                      ///< m, of any tool that the robot has room for
  bool rotors = false, friction = false, springs = false;  ///< whether the scene names them
  bool gravity_given = false, tool_given = false;          ///< whether gravity, the tool is a run-time input, words
};

namespace detail {

/// One value for each quantity that a link keeps.
template <class T>
struct PerQuantity {
  /// Value of a quantity of the link.
  ///@{
  T angular_velocity{}, angular_acceleration{}, linear_acceleration{}, gravity{};
  T moment{}, force{};
  T rotational_inertia{}, first_moment{}, mass{};
  T joint_inertia{}, angular_gain{}, linear_gain{}, joint_effort{}, joint_acceleration{}, length{};
  T linear_velocity{}, axis_acceleration{}, flow_moment{}, flow_momentum{};
  T unit_moment{}, unit_force{}, position_moment{}, position_force{};
  ///@}

  /// Where a quantity stands.
  ///@{
  static constexpr auto at(quantity::AngularVelocity) { return &PerQuantity::angular_velocity; }
  static constexpr auto at(quantity::AngularAcceleration) { return &PerQuantity::angular_acceleration; }
  static constexpr auto at(quantity::LinearAcceleration) { return &PerQuantity::linear_acceleration; }
  static constexpr auto at(quantity::Moment) { return &PerQuantity::moment; }
  static constexpr auto at(quantity::Force) { return &PerQuantity::force; }
  static constexpr auto at(quantity::RotationalInertia) { return &PerQuantity::rotational_inertia; }
  static constexpr auto at(quantity::FirstMoment) { return &PerQuantity::first_moment; }
  static constexpr auto at(quantity::Mass) { return &PerQuantity::mass; }
  static constexpr auto at(quantity::JointInertia) { return &PerQuantity::joint_inertia; }
  static constexpr auto at(quantity::AngularGain) { return &PerQuantity::angular_gain; }
  static constexpr auto at(quantity::LinearGain) { return &PerQuantity::linear_gain; }
  static constexpr auto at(quantity::JointEffort) { return &PerQuantity::joint_effort; }
  static constexpr auto at(quantity::JointAcceleration) { return &PerQuantity::joint_acceleration; }
  static constexpr auto at(quantity::Length) { return &PerQuantity::length; }
  static constexpr auto at(quantity::GravityAcceleration) { return &PerQuantity::gravity; }
  static constexpr auto at(quantity::LinearVelocity) { return &PerQuantity::linear_velocity; }
  static constexpr auto at(quantity::AxisAcceleration) { return &PerQuantity::axis_acceleration; }
  static constexpr auto at(quantity::FlowMoment) { return &PerQuantity::flow_moment; }
  static constexpr auto at(quantity::FlowMomentum) { return &PerQuantity::flow_momentum; }
  static constexpr auto at(quantity::UnitMoment) { return &PerQuantity::unit_moment; }
  static constexpr auto at(quantity::UnitForce) { return &PerQuantity::unit_force; }
  static constexpr auto at(quantity::PositionMoment) { return &PerQuantity::position_moment; }
  static constexpr auto at(quantity::PositionForce) { return &PerQuantity::position_force; }
  ///@}
  /// The value of a quantity.
  ///@{
  template <class Quantity>
  constexpr const T& of(Quantity quantity) const {
    return this->*at(quantity);
  }
  template <class Quantity>
  constexpr T& of(Quantity quantity) {
    return this->*at(quantity);
  }
  ///@}
};
template <class... Quantities>
struct QuantityList {
  static constexpr int count = sizeof...(Quantities);
  template <class T>
  static constexpr T PerQuantity<T>::*members[] = {PerQuantity<T>::at(Quantities{})...};
};
/// Every quantity of a link.
using AllQuantities =
    QuantityList<quantity::AngularVelocity, quantity::AngularAcceleration, quantity::LinearAcceleration,
                 quantity::Moment, quantity::Force, quantity::RotationalInertia, quantity::FirstMoment, quantity::Mass,
                 quantity::JointInertia, quantity::AngularGain, quantity::LinearGain, quantity::JointEffort,
                 quantity::JointAcceleration, quantity::Length, quantity::GravityAcceleration, quantity::LinearVelocity,
                 quantity::AxisAcceleration, quantity::FlowMoment, quantity::FlowMomentum, quantity::UnitMoment,
                 quantity::UnitForce, quantity::PositionMoment, quantity::PositionForce>;

}  // namespace detail

/// Exponents of the quantities of one link: value = raw 2^-exponent.
using LinkFormat = detail::PerQuantity<int>;
/// Bounds of the quantities of one link, of a vector of its norm (SI): how large they can be and how exact they are.
struct LinkRange : detail::PerQuantity<Ball> {
  Ball rotation{};            ///< of the rows of its rotation
  bool turns_across = false;  ///< whether the link turns about more than its joint's axis
  double least = 0.0;         ///< inertia that its joint feels, at least; below it has a status, kg m^2 or kg
  double drive = 0.0;         ///< effort that drives a joint besides the bias, at most
  double share = 0.0;         ///< of a joint in qdd^T M qdd, at most
};
/// All values of a link, in one order whatever they are.
template <class T>
inline constexpr auto& all_quantities = detail::AllQuantities::members<T>;

/// What an analysis is asked for. Formats, and how large quantities are, take one run of a kernel on bounds; errors in
/// these formats take another, which code that computes has no use for.
enum class Wanted { formats, errors };

/// Ranges and formats of all links.
template <int N>
struct Ranges {
  LinkRange range[N] = {};    ///< of the quantities of each link
  LinkFormat format[N] = {};  ///< of the same quantities
  int halvings = 0;           ///< of a drive that is solved for first, where formats are those of the declared motion
};

/// What one step for all links makes of a robot: one format per quantity, constants in columns of one exponent each.
struct SharedSteps {
  bool shared = false;   ///< whether one format serves all links
  LinkFormat format{};   ///< of all links
  double viscous = 0.0;  ///< largest of all joints: N m s/rad or N s/m
};

/// Everything that an analysis looks at.
template <int N>
struct Mechanism {
  TreeLinkConstants<double> links[N];  ///< constants of each link
  JointRange joints[N];                ///< declared limits of each joint
  DriveConstants<double> drives[N];    ///< friction and spring of each joint
  LoadRange loads;                     ///< what the scene puts on the robot
  SharedSteps steps{};                 ///< in the looped form

  /// Index of the link that carries joint i, negative for the base.
  constexpr int parent(int i) const { return links[i].parent; }
  /// Distance of a link's origin from its parent's: a and d are at right angles, whatever the joint's angle.
  constexpr double origin_distance(int i) const {
    const auto& c = links[i];
    const double d = joints[i].travel;
    return magnitude(c.branch.b) + square_root(c.a * c.a + d * d);
  }

  /// The exponent of a quantity that reaches `size` on one link, or of all links.
  constexpr int format(const WordRounding& r, int LinkFormat::*quantity, double size) const {
    return steps.shared ? steps.format.*quantity : r.exponent(size);
  }
  /// Exponents of the base's motion.
  constexpr LinkFormat base_format() const { return steps.shared ? steps.format : LinkFormat{}; }
};

namespace detail {

/// A bound of the spectral norm of a link's inertia.
constexpr double norm_of(const TreeLinkConstants<double>& c) {
  return largest_row({c.jxx, c.jyy, c.jzz, c.jxy, c.jxz, c.jyz});
}
constexpr double length_of(double x, double y, double z) { return square_root(x * x + y * y + z * z); }

/// What has no limit was refused (formats/joint_formats.hpp); something finite stands for it, to say no more.
constexpr JointRange joint_range(const LinkParameters& p) {
  const auto finite = [](double limit) { return is_bounded(limit) ? limit : 1.0; };
  JointRange r{finite(p.speed_limit), finite(p.acceleration_limit), magnitude(p.d), p.effort_limit};
  if (p.type == JointType::prismatic && is_bounded(p.position_max) && is_bounded(-p.position_min)) {
    const double low = magnitude(p.d + p.position_min), high = magnitude(p.d + p.position_max);
    r.travel = low > high ? low : high;
  }
  return r;
}

template <class Scene>
constexpr LoadRange load_range() {
  using Robot = typename Scene::Robot;
  const auto& g = Robot::chain.gravity;
  LoadRange loads;
  if (Scene::template has<Gravity>)
    loads.gravity_across = length_of(g.x, g.y, 0.0), loads.gravity_along = magnitude(g.z);
  loads.gravity_given = Scene::template has<RuntimeGravity>;
  if (loads.gravity_given) loads.gravity_across = loads.gravity_along = length_of(g.x, g.y, g.z);
  loads.rotors = Scene::template has<RotorInertia>;
  loads.friction = Scene::template has<Friction>;
  const auto &base = Robot::chain.base.pose.position, &tool = Robot::chain.tool.pose.position;
  loads.base_offset = length_of(base[0], base[1], base[2]), loads.tool_offset = length_of(tool[0], tool[1], tool[2]);
  const double reach = Robot::chain.tool_limit.reach;
  loads.tool_reach = reach > loads.tool_offset ? reach : loads.tool_offset;
  loads.tool_given = Scene::template has<RuntimeTool>;
  loads.springs = Scene::template has<JointSprings>;
  if constexpr (Scene::template has<Payload>) {
    constexpr PayloadLimit most = Robot::chain.payload_limit;
    loads.payload_mass = most.mass, loads.payload_moment = most.mass * most.com_reach;
    loads.payload_inertia = 3.0 * most.inertia + most.mass * most.com_reach * most.com_reach;
  }
  if constexpr (Scene::template has<TipWrench>)
    loads.tip_force = Robot::chain.tip_wrench_limit.force, loads.tip_moment = Robot::chain.tip_wrench_limit.moment;
  return loads;
}

template <class Scene, class Parameters, int... I>
constexpr auto mechanism(std::integer_sequence<int, I...>) {
  using Robot = typename Scene::Robot;
  return Mechanism<sizeof...(I)>{{robot_constants<Robot, Parameters>.links[I]...},
                                 {joint_range(Robot::chain.links[I])...},
                                 {drive_constants(Robot::chain.links[I])...},
                                 load_range<Scene>()};
}

// Whether a pair from the caller, the sine and cosine of q alone, is turned by a joint's theta and rounded.
template <class Scene>
constexpr bool turns_given_pairs() {
  bool any = false;
  if constexpr (Scene::template has<SineCosines>)
    for (const auto& link : Scene::Robot::chain.links) {
      const bool quarter = link.theta.sin == 0.0 || (link.theta.cos == 0.0 && !Scene::template has<Looped>);
      any = any || (link.type == JointType::revolute && !quarter);
    }
  return any;
}

}  // namespace detail

/// Rounding of a scene's kernels over the arithmetic S. Turning a pair keeps the length of its error and rounds twice.
template <class Scene, class S>
constexpr WordRounding rounding_in() {
  WordRounding r = rounding_of<S>(Scene::template has<Looped>);
  const int unit = r.bits - 2;
  bounds::Terms turn;
  turn.add_product(2 * unit), turn.add_product(2 * unit);
  if (detail::turns_given_pairs<Scene>()) r.turn_error += turn.rounding(unit, r) + r.ulp(unit);
  return r;
}

namespace detail {
/// The robot that formats follow from; of a run-time model, which was refused, one with as many joints.
template <class Model>
struct ModelStandIn {
  static constexpr auto chain = with_every_limit(Chain<Model::chain.size>{});
};
template <class Robot>
using described_robot = std::conditional_t<is_described<Robot>, Robot, ModelStandIn<Robot>>;
template <class Robot>
inline constexpr auto& described_chain = described_robot<Robot>::chain;

/// Whether links have a kind of friction, of a scene that names friction.
template <class Scene>
constexpr bool rubs_by(double LinkParameters::*friction) {
  bool any = false;
  for (const LinkParameters& link : described_chain<typename Scene::Robot>.links)
    any = any || link.*friction != 0.0;
  return any && Scene::template has<Friction>;
}
/// What of a scene fixed point has no proved range for, yet. Offered says a sentence of each.
template <class Scene>
struct Unranged {
  template <class Feature>
  static constexpr bool has = Scene::template has<Feature>;
  static constexpr bool model = !is_described<typename Scene::Robot>;
  static constexpr bool base_motion = has<BaseMotion> || has<FloatingBase>;
  static constexpr bool water = has<Underwater>;
  static constexpr bool wrenches = has<ExternalWrenches>;
  static constexpr bool rotor_bodies = has<RotorDynamics>;
  static constexpr bool springs = has<JointSprings>;
  static constexpr bool composite_bodies = has<CompositeBody>;
  static constexpr bool stribeck = rubs_by<Scene>(&LinkParameters::static_friction);
  static constexpr bool smooth_speed = rubs_by<Scene>(&LinkParameters::smooth_speed);
  static constexpr bool any = model || base_motion || water || wrenches || rotor_bodies || springs ||
                              composite_bodies || stribeck || smooth_speed;
};
/// What is analysed and computed of a scene in fixed point: the scene, or, where it was refused, one that has nothing,
/// so that nothing more is said.
template <class Scene>
using sound_scene =
    std::conditional_t<Unranged<Scene>::any,
                       axial::Scene<described_robot<typename Scene::Robot>, Gravity, RotorInertia>, Scene>;
}  // namespace detail

/// A robot as an analysis sees it.
template <class Scene, class Parameters>
inline constexpr auto mechanism_of = detail::mechanism<detail::sound_scene<Scene>, Parameters>(
    std::make_integer_sequence<int, Scene::Robot::chain.size>{});

}  // namespace axial

#include <axial/options/end.hpp>
