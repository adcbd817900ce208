#include <bench/catalogue.hpp>
#include <bench/peers.hpp>
#include <bench/robots.hpp>
#include <bench/serial.hpp>
#include <bench/states.hpp>
#include <oracle/from_axial.hpp>
#include <raced.hpp>

namespace bench {
namespace {

constexpr int robot_states = 256, serial_states = 32;
constexpr double agreement = 1e-9;        // double
constexpr double float_agreement = 1e-3;  // 2^-24 times condition numbers up to some 1e4

#ifdef AXIAL_BENCH_DART
constexpr bool dart_races = true;
#else
constexpr bool dart_races = false;
#endif

template <class T>
constexpr bool is_float = sizeof(T) == sizeof(float);

using Made = std::unique_ptr<Contender>;

template <class T>
Duel duel(const std::string& algorithm, const std::string& robot, const std::string& peer, const States& states,
          Made ours, Made theirs) {
  Duel result;
  result.algorithm = algorithm, result.robot = robot, result.peer = peer;
  result.scalar = is_float<T> ? "float" : "double";
  result.joints = states.joints, result.states = states.count;
  result.tolerance = is_float<T> ? float_agreement : agreement;
  result.ours = static_cast<Made&&>(ours), result.theirs = static_cast<Made&&>(theirs);
  return result;
}

constexpr Algorithm algorithms[] = {Algorithm::inverse_dynamics,
                                    Algorithm::gravity,
                                    Algorithm::bias,
                                    Algorithm::mass_matrix,
                                    Algorithm::forward_dynamics,
                                    Algorithm::articulated_body,
                                    Algorithm::split_articulated_body,
                                    Algorithm::composite_body};

template <class Robot, class T>
void add_robot(std::vector<Duel>& duels, const std::string& name) {
  const auto chain = oracle::of_robot<double, Robot>(), bare = oracle::without_rotors(chain);
  const States states = random_states(chain, robot_states), bare_states = random_states(bare, robot_states);
  for (const Algorithm algorithm : algorithms) {
    const auto race = [&](const char* peer, Rotors rotors, Made theirs) {
      const States& same = rotors == Rotors::with ? states : bare_states;
      duels.push_back(duel<T>(name_of(algorithm), name, peer, same, ours<Robot, T>(algorithm, rotors, same),
                              static_cast<Made&&>(theirs)));
    };
    if (Made batch = batches<Robot, T>(algorithm, states))
      duels.push_back(duel<T>(name_of(algorithm), name, "one state", states, static_cast<Made&&>(batch),
                              ours<Robot, T>(algorithm, Rotors::with, states)));
    race("kdl", Rotors::with, make_kdl(algorithm, chain, states));
    if (is_forward(algorithm)) race("kdl_vereshchagin", Rotors::with, make_vereshchagin(chain, states));
    if constexpr (dart_races)
      if (algorithm <= Algorithm::forward_dynamics)
        race("dart", Rotors::without, make_dart(algorithm, bare, bare_states));
  }
}

/// The peer is what they are derivatives of, ours too: the derivatives' values are its answer.
template <class Robot, class T>
void add_derivatives(std::vector<Duel>& duels, const std::string& name) {
  const States states = random_states(oracle::of_robot<double, Robot>(), robot_states);
  const auto race = [&](Algorithm derived, const char* peer, Algorithm plain) {
    duels.push_back(duel<T>(name_of(derived), name, peer, states, derivatives<Robot, T>(derived, states),
                            ours<Robot, T>(plain, Rotors::with, states)));
  };
  race(Algorithm::inverse_dynamics_derivatives, "inverse dynamics", Algorithm::inverse_dynamics);
  race(Algorithm::forward_dynamics_derivatives, "forward dynamics", Algorithm::forward_dynamics);
}

}  // namespace

std::vector<Duel> all_duels() {
  std::vector<Duel> duels;
  Raced::for_each([&](auto named) {
    using Robot = typename decltype(named)::Robot;
    add_robot<Robot, double>(duels, named.name);
    add_robot<Robot, float>(duels, named.name);
    add_derivatives<Robot, double>(duels, named.name);
    add_derivatives<Robot, float>(duels, named.name);
  });
  for (const int joints : serial_joints) {
    const auto chain = serial_chain(joints);
    const States states = random_states(chain, serial_states);
    const auto name = "serial_" + std::to_string(joints);
    const auto race = [&](Algorithm algorithm, const char* peer, Made theirs) {
      duels.push_back(duel<double>(name_of(algorithm), name, peer, states, ours_serial(algorithm, chain, states),
                                   static_cast<Made&&>(theirs)));
    };
    const Algorithm forward = Algorithm::forward_dynamics, matrix = Algorithm::mass_matrix;
    race(forward, "kdl_vereshchagin", make_vereshchagin(chain, states));
    race(forward, "kdl", make_kdl(forward, chain, states));
    if constexpr (dart_races) race(forward, "dart", make_dart(forward, chain, states));
    race(matrix, "kdl", make_kdl(matrix, chain, states));
    race(Algorithm::composite_body, "kdl", make_kdl(forward, chain, states));
  }
  return duels;
}

}  // namespace bench
