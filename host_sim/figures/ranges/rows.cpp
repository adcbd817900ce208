#include <host_sim/figures/ranges/rows.hpp>

#include <axial/fixed.hpp>

#include <analysed.hpp>
#include <stdexcept>

namespace ranges {
namespace {

using axial::Ball;
using axial::LinkFormat;
using axial::LinkRange;

/// Whether a drive makes the quantity, which is in proportion to it.
bool is_driven(Ball LinkRange::*range) {
  for (const auto& quantity : axial::detail::driven_quantities)
    if (quantity.size == range) return true;
  return false;
}

/// A quantity that a recursion keeps; its unit for a revolute joint, and for a prismatic one. Without a format of its
/// own it has that of sines and cosines.
struct Quantity {
  const char *name, *unit, *prismatic_unit;
  Ball LinkRange::*range;
  int LinkFormat::*format;
};

constexpr Quantity quantities[] = {
    {"angular velocity", "rad/s", "rad/s", &LinkRange::angular_velocity, &LinkFormat::angular_velocity},
    {"angular acceleration", "rad/s^2", "rad/s^2", &LinkRange::angular_acceleration, &LinkFormat::angular_acceleration},
    {"linear acceleration", "m/s^2", "m/s^2", &LinkRange::linear_acceleration, &LinkFormat::linear_acceleration},
    {"moment", "N m", "N m", &LinkRange::moment, &LinkFormat::moment},
    {"force", "N", "N", &LinkRange::force, &LinkFormat::force},
    {"rotational inertia", "kg m^2", "kg m^2", &LinkRange::rotational_inertia, &LinkFormat::rotational_inertia},
    {"first moment", "kg m", "kg m", &LinkRange::first_moment, &LinkFormat::first_moment},
    {"mass", "kg", "kg", &LinkRange::mass, &LinkFormat::mass},
    {"joint inertia", "kg m^2", "kg", &LinkRange::joint_inertia, &LinkFormat::joint_inertia},
    {"angular gain", "1", "1/m", &LinkRange::angular_gain, &LinkFormat::angular_gain},
    {"linear gain", "1/m", "1", &LinkRange::linear_gain, &LinkFormat::linear_gain},
    {"joint effort", "N m", "N", &LinkRange::joint_effort, &LinkFormat::joint_effort},
    {"joint acceleration", "rad/s^2", "m/s^2", &LinkRange::joint_acceleration, &LinkFormat::joint_acceleration},
    {"length", "m", "m", &LinkRange::length, &LinkFormat::length},
    {"rotation", "1", "1", &LinkRange::rotation, nullptr},
};

/// An algorithm's recursion and parameters, as its kernel's links have them.
template <class RecursionType, class DefaultParameters>
struct Analysis {
  using Recursion = RecursionType;
  using Parameters = DefaultParameters;
  static constexpr bool is_forward = std::is_same_v<Recursion, axial::recursion::ArticulatedBodies> ||
                                     std::is_same_v<Recursion, axial::recursion::ArticulatedBodiesAtRest>;
  // Columns of the mass matrix are forces of a unit acceleration.
  static constexpr const char* per = std::is_same_v<Recursion, axial::recursion::CompositeBodies> ? " a unit" : "";
  const char* name;
};

// Calls visit(analysis) for every algorithm.
template <class Visit>
void for_each_algorithm(const Visit& visit) {
  using namespace axial::recursion;
  visit(Analysis<NewtonEuler, axial::BaseParameters>{"inverse_dynamics"});
  visit(Analysis<ArticulatedBodiesAtRest, axial::FullParameters>{"forward_dynamics"});
  visit(Analysis<ArticulatedBodies, axial::FullParameters>{"forward_dynamics_classical"});
  visit(Analysis<CompositeBodies, axial::BaseParameters>{"mass_matrix"});
  visit(Analysis<Kinematics, axial::FullParameters>{"forward_kinematics"});
}

template <class Visit>
void for_each_robot(const Visit& visit) {
  Analysed::for_each(visit);
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : ", ") + name;
  return all;
}

template <int N>
std::vector<Row> rows_of(const axial::Ranges<N>& ranges, const axial::LinkParameters (&links)[N], const char* robot,
                         int sine_exponent, const std::string& per) {
  std::vector<Row> rows;
  for (int i = 0; i < N; ++i)
    for (const Quantity& quantity : quantities) {
      const Ball& ball = ranges.range[i].*quantity.range;
      if (!(ball.size > 0.0)) continue;
      const bool revolute = links[i].type == axial::JointType::revolute;
      const int exponent = quantity.format == nullptr ? sine_exponent : ranges.format[i].*quantity.format;
      const bool is_load = quantity.range == &LinkRange::moment || quantity.range == &LinkRange::force;
      const std::string unit = revolute ? quantity.unit : quantity.prismatic_unit;
      rows.push_back({robot, i, quantity.name, is_load ? unit + per : unit, ball.size, exponent,
                      ball.error > 0.0 ? std::optional<double>(ball.error) : std::nullopt,
                      is_driven(quantity.range) ? ranges.halvings : 0});
    }
  return rows;
}

// What a drive answers, after the links: a row at the link that owns it.
struct OfDrives {
  const char *quantity, *unit;
};
template <class Errors, class Size, class Exponent, class Bounds>
void add_drives(std::vector<Row>& rows, const char* robot, const OfDrives& kind, const Errors& g, const Size& size,
                const Exponent& exponent, const Bounds& errors) {
  for (int k = 0; k < g.drives; ++k)
    rows.push_back({robot, g.owner[k], kind.quantity, kind.unit, size(k), exponent(k), errors[k]});
}

// Joints that share drives: links as far as the drives take them, then what each drive answers.
template <class S, class Analysis, class Arithmetic>
std::vector<Row> analysed_with_drives(const char* robot) {
  using Recursion = typename Analysis::Recursion;
  using T = axial::Stored<typename Arithmetic::Word>;
  using Errors = axial::detail::DriveErrors<S, T>;
  using Sizes = axial::detail::DriveSizes<S, typename Arithmetic::Word>;
  if constexpr (Analysis::is_forward) {
    throw std::runtime_error("joints of '" + std::string(robot) +
                             "' share drives: forward dynamics has ranges of M and of efforts alone; there are: "
                             "inverse_dynamics, mass_matrix, forward_kinematics");
  } else {
    auto rows = rows_of(Errors::joint_ranges(Recursion{}), Sizes::Joint::Robot::chain.links, robot, Arithmetic::unit,
                        Analysis::per);
    if constexpr (std::is_same_v<Recursion, axial::recursion::NewtonEuler>)
      add_drives(
          rows, robot, {"drive effort", "N m or N"}, Sizes::g, Sizes::effort,
          [](int k) { return axial::EffortsOf<S, T>::exponent(k); }, Errors::efforts(0.0));
    if constexpr (std::is_same_v<Recursion, axial::recursion::CompositeBodies>)
      add_drives(
          rows, robot, {"drive inertia", "kg m^2 or kg"}, Sizes::g, Sizes::inertia,
          [](int k) { return axial::MassMatrixOf<S, T>::exponent(k, k); }, Errors::rows());
    return rows;
  }
}

template <class Robot, class Arithmetic>
struct SceneIn {  // drives have errors in the arithmetic that a scene names
  template <class... Tags>
  using With = axial::scene_of<axial::Scene<Robot, axial::Gravity, axial::RotorInertia, Tags...>>;
  using Nearest = std::conditional_t<Arithmetic::high_word, With<axial::HighWord>, With<>>;
  using Down =
      std::conditional_t<Arithmetic::high_word, With<axial::RoundDown, axial::HighWord>, With<axial::RoundDown>>;
  using type = std::conditional_t<Arithmetic::nearest, Nearest, Down>;
};

// The choice as types, one step at a time.
template <class Robot, class Analysis, class Arithmetic>
std::vector<Row> analysed() {
  using Scene = axial::scene_of<Robot>;
  if constexpr (axial::detail::has_shared_drives<Scene>) {
    return analysed_with_drives<typename SceneIn<Robot, Arithmetic>::type, Analysis, Arithmetic>(Robot::name);
  } else {
    using Parameters = axial::detail::with_rotors<Scene, typename Analysis::Parameters>;
    return rows_of(
        axial::detail::analysed<Scene, Parameters, Arithmetic, typename Analysis::Recursion>(axial::Wanted::errors),
        Robot::chain.links, Robot::name, Arithmetic::unit, Analysis::per);
  }
}
template <class Robot, class Analysis, class Word>
std::vector<Row> rounded(const Choice& choice) {
  using axial::Arithmetic;
  if (choice.high_word)
    return choice.nearest ? analysed<Robot, Analysis, Arithmetic<Word, true, true>>()
                          : analysed<Robot, Analysis, Arithmetic<Word, false, true>>();
  return choice.nearest ? analysed<Robot, Analysis, Arithmetic<Word, true, false>>()
                        : analysed<Robot, Analysis, Arithmetic<Word, false, false>>();
}
template <class Robot, class Analysis>
std::vector<Row> in_words(const Choice& choice) {
  if (choice.word == 32) return rounded<Robot, Analysis, std::int32_t>(choice);
  if (choice.word == 16) return rounded<Robot, Analysis, std::int16_t>(choice);
  throw std::runtime_error("no words of " + std::to_string(choice.word) + " bits; there are: 16, 32");
}

}  // namespace

std::vector<std::string> algorithms() {
  std::vector<std::string> names;
  for_each_algorithm([&](auto algorithm) { names.push_back(algorithm.name); });
  return names;
}

std::vector<std::string> robots() {
  std::vector<std::string> names;
  for_each_robot([&](auto robot) { names.push_back(robot.name); });
  return names;
}

std::vector<std::string> robots(const std::string& algorithm) {
  std::vector<std::string> names;
  for_each_algorithm([&](auto known) {
    if (algorithm != known.name) return;
    for_each_robot([&](auto robot) {
      using Scene = axial::scene_of<typename decltype(robot)::Robot>;
      if (!(decltype(known)::is_forward && axial::detail::has_shared_drives<Scene>)) names.push_back(robot.name);
    });
  });
  return names;
}

std::vector<Row> rows(const std::string& robot, const Choice& choice) {
  std::optional<std::vector<Row>> found;
  bool known_robot = false;
  for_each_robot([&](auto named) {
    if (robot != named.name) return;
    known_robot = true;
    for_each_algorithm([&](auto algorithm) {
      if (choice.algorithm == algorithm.name)
        found = in_words<typename decltype(named)::Robot, decltype(algorithm)>(choice);
    });
  });
  if (!known_robot) throw std::runtime_error("unknown robot '" + robot + "'; there are: " + listed(robots()));
  if (!found)
    throw std::runtime_error("unknown algorithm '" + choice.algorithm + "'; there are: " + listed(algorithms()));
  return *found;
}

}  // namespace ranges
