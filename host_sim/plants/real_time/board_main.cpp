// plant_board: a robot's motions in the words of a board's image, and a verdict on what the board answered; on_board.py
// runs the board.
#include <firmware/apps/run/motion.hpp>
#include <host_sim/plants/real_time/board.hpp>
#include <host_sim/plants/real_time/swing.hpp>
#include <host_sim/tools/output/command_line.hpp>
#include <host_sim/tools/output/files.hpp>

#include <robot.hpp>

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace {

using namespace host_sim::real_time;
using axial::apps::Robot;

/// A second of the robot's pick-and-place cycle; of a header's of a smooth motion inside its limits, from where every
/// joint turns back, at rest, on which a controller kept the arm.
DrivenSecond<Robot> second() {
  constexpr int ticks = 1000;
  if (AXIAL_HAS_CYCLE != 0) return {};
  Course course;
  for (int k = 0; k < ticks; ++k) {
    std::vector<double> q, qd, qdd;
    for (int i = 0; i < Robot::chain.size; ++i) {
      constexpr double quarter_turn = 1.57079632679489661923;
      const auto motion = axial::apps::run::motion<Robot>(i, quarter_turn / axial::apps::run::rate(i) + k * tick);
      q.push_back(motion.q), qd.push_back(motion.qd), qdd.push_back(motion.qdd);
    }
    course.q.push_back(q), course.qd.push_back(qd), course.qdd.push_back(qdd);
  }
  return {driven_near<Robot>(course)};
}

struct Request {
  std::string number, motion;
  Steps steps;
  std::vector<Reported> states;
};
Request request_of(const nlohmann::json& asked) {
  Request request{
      asked.at("number"),
      asked.at("motion"),
      {asked.at("method") == "runge_kutta_4", asked.at("choice"), asked.at("steps"), asked.at("report_every")},
      {}};
  for (const auto& state : asked.value("states", nlohmann::json::array()))
    request.states.push_back({state.at(0), state.at(1)});
  return request;
}

nlohmann::json json_of(const Judged& judged) {
  return {{"same_bits", judged.same_bits}, {"difference", judged.difference}};
}

template <class T>
nlohmann::json driven_answer(const Request& request) {
  const auto motion = second();
  const OnBoard<Robot, T> board(motion.motion);
  if (request.states.empty()) return {{"words", board.words(request.steps)}};
  const Judged judged = board.judge(request.steps, request.states, motion.reference);
  if (judged.errors.empty()) throw std::runtime_error("no state after a whole tick was reported");
  auto answer = json_of(judged);
  answer["error"] = judged.errors.back();
  answer["growth"] = growth_of(motion.motion);
  answer["way"] = {{"positions", judged.positions}, {"errors", judged.errors}};
  return answer;
}

template <class T>
nlohmann::json free_answer(const Request& request) {
  if constexpr (std::is_same_v<Robot, robots::Puma560>) {
    const auto minute = puma560_minute();
    const OnBoard<Robot, T> board(minute.start);
    if (request.states.empty()) return {{"words", board.words(request.steps)}};
    auto answer = json_of(board.judge(request.steps, request.states, {}));
    answer["energy_drift"] = board.energy_drift(request.states) / minute.swings;
    return answer;
  } else {
    throw std::runtime_error(std::string(Robot::name) + " has no free swing here; puma560 has");
  }
}

template <class T>
nlohmann::json answer(const Request& request) {
  return request.motion == "driven" ? driven_answer<T>(request) : free_answer<T>(request);
}

}  // namespace

int main(int count, char** arguments) {
  std::string asked, answered;
  host_sim::CommandLine line("a robot's motion in words for a board, and a verdict on the board's states",
                             "plant_board");
  line.option("--request", asked, "number, motion, method, choice, steps, report_every; states, to be judged")
      .required();
  line.option("--answer", answered, "the words, or the verdict").required();
  return line.run(count, arguments, [&] {
    const Request request = request_of(nlohmann::json::parse(std::ifstream(asked)));
    host_sim::write_json(answered,
                         request.number == "float" ? answer<float>(request) : answer<axial::Fixed32>(request));
    return 0;
  });
}
