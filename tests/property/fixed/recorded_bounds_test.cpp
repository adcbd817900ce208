// Certified bounds, sizes and formats as recorded_bounds.json has them: the tests beside this one see a bound that is
// too small or far too large, this one any other change, so that each is meant. AXIAL_RECORD=1 writes that file anew,
// of the tests that run.
#include <axial/axial.hpp>
#include <axial/control/payload_estimator.hpp>
#include <axial/fixed.hpp>
// Behind the library.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include "recorded_robots.hpp"

namespace {

using namespace axial;
using namespace property::recorded;
using nlohmann::json;

/// A sum of logarithms in which every number has a weight of its own: a factor of any of them, or two that change
/// places, move it.
class Digest {
 public:
  void add(double number) {
    const double size = std::fabs(number), kept = std::isnan(number) ? 1e-100 : std::fmin(std::fmax(size, 1e-60), 1e60);
    sum_ += (1.0 + 0.01 * count_++) * std::log2(kept) + (number < 0.0 ? 0.5 : 0.0);
  }
  void add(int number) { sum_ += (1.0 + 0.01 * count_++) * number; }
  /// Of a struct that holds nothing but doubles.
  template <class Numbers>
  void add_all(const Numbers& numbers) {
    static_assert(std::is_trivially_copyable_v<Numbers> && sizeof(Numbers) % sizeof(double) == 0);
    std::vector<double> all(sizeof(Numbers) / sizeof(double));
    std::memcpy(all.data(), &numbers, sizeof(Numbers));
    for (const double number : all)
      add(number);
  }
  [[nodiscard]] double value() const { return sum_; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// Holds what it is given to the file, or writes it there.
class Recorded {
 public:
  Recorded() : all_(json::parse(std::ifstream(file()))), records_(std::getenv("AXIAL_RECORD") != nullptr) {}
  ~Recorded() {
    if (!records_) return;
    std::ofstream out(file());
    const char* before = "{\n";
    for (const auto& [name, digests] : all_.items())
      out << before << json(name) << ": " << digests.dump(), before = ",\n";
    out << "\n}\n";
  }
  /// Digests of one thing, such as those of links.
  void see(const std::string& name, std::vector<double> now) {
    if (records_) {
      for (double& each : now)
        each = std::round(1e6 * each) / 1e6;
      all_[name] = now;
    }
    const auto then = all_.value(name, std::vector<double>{});
    ASSERT_EQ(now.size(), then.size()) << name << ": not recorded, or of another robot";
    for (std::size_t i = 0; i < now.size(); ++i)
      EXPECT_NEAR(now[i], then[i], 1e-5) << name << ", " << i << ": by a factor of up to "
                                         << std::exp2(now[i] - then[i])
                                         << "; where that is meant, AXIAL_RECORD=1 records it";
  }

 private:
  static std::string file() { return AXIAL_ROOT "/tests/property/fixed/recorded_bounds.json"; }
  json all_;
  bool records_;
};

/// What an analysis finds: a row for each link, its sizes, its errors and its formats.
template <int N>
void put_ranges(Recorded& recorded, const std::string& name, const Ranges<N>& found) {
  std::vector<double> sizes, errors, formats;
  for (int i = 0; i < N; ++i) {
    Digest size, error, format;
    const LinkRange& range = found.range[i];
    for (const auto quantity : all_quantities<Ball>)
      size.add((range.*quantity).size), error.add((range.*quantity).error);
    size.add(range.rotation.size), error.add(range.rotation.error);
    for (const double each : {range.least, range.drive, range.share})
      size.add(each);
    for (const auto quantity : all_quantities<int>)
      format.add(found.format[i].*quantity);
    sizes.push_back(size.value()), errors.push_back(error.value()), formats.push_back(format.value());
  }
  formats.push_back(found.halvings);
  recorded.see(name + " sizes", sizes), recorded.see(name + " errors", errors),
      recorded.see(name + " formats", formats);
}
template <class Recursion, class S, class T>
void put_analysis(Recorded& recorded, const std::string& name, const char* recursion) {
  using Errors = detail::ErrorsOf<S, T>;
  put_ranges(
      recorded, name + " " + recursion,
      detail::analysed<typename Errors::Joint, typename Errors::Base, typename Errors::A, Recursion>(Wanted::errors));
}

/// What is certified of an algorithm's answers.
template <class S, class T, class Algorithm>
void put_bound(Recorded& recorded, const std::string& name, const char* algorithm, Algorithm asked) {
  const auto bound = error_bound<S, T>(asked);
  Digest digest;
  digest.add_all(bound);
  recorded.see(name + " bound of " + algorithm, {digest.value()});
}

struct Tuning {
  static constexpr double period = 1e-3, gain = 50.0, deviation = 0.003, memory = 10.0;
};

template <class S, class T>
void put_motion(Recorded& recorded, const std::string& name) {
  put_analysis<recursion::NewtonEuler, S, T>(recorded, name, "NewtonEuler");
  put_bound<S, T>(recorded, name, "inverse_dynamics", algorithm::inverse_dynamics);
  put_bound<S, T>(recorded, name, "requested_torque", algorithm::RequestedTorque{});
  put_bound<S, T>(recorded, name, "actuator_power", algorithm::actuator_power);
}
template <class S, class T>
void put_forward(Recorded& recorded, const std::string& name) {
  put_analysis<recursion::ArticulatedBodiesAtRest, S, T>(recorded, name, "ArticulatedBodiesAtRest");
  put_bound<S, T>(recorded, name, "forward_dynamics", algorithm::forward_dynamics);
}
template <class S, class T>
void put_tool(Recorded& recorded, const std::string& name) {
  put_analysis<recursion::Kinematics, S, T>(recorded, name, "Kinematics");
  put_bound<S, T>(recorded, name, "forward_kinematics", algorithm::forward_kinematics);
  put_bound<S, T>(recorded, name, "jacobian", algorithm::jacobian);
  put_bound<S, T>(recorded, name, "tool_pose", algorithm::ToolPose{});
  put_bound<S, T>(recorded, name, "transpose_times", algorithm::TransposeTimes{});
}
template <class S, class T>
void put_momenta(Recorded& recorded, const std::string& name) {
  put_analysis<recursion::Momenta, S, T>(recorded, name, "Momenta");
  put_analysis<recursion::CompositeBodies, S, T>(recorded, name, "CompositeBodies");
  put_bound<S, T>(recorded, name, "mass_matrix", algorithm::mass_matrix);
  put_bound<S, T>(recorded, name, "momentum", algorithm::Momentum{});
  put_bound<S, T>(recorded, name, "momentum_drift", algorithm::MomentumDrift{});
  put_bound<S, T>(recorded, name, "collision_detector", algorithm::CollisionDetector<Tuning>{});
}
template <class S, class T>
void put_terms(Recorded& recorded, const std::string& name) {
  put_bound<S, T>(recorded, name, "separation", algorithm::separation);
  put_bound<S, T>(recorded, name, "separated_torque", algorithm::separated_torque);
  put_bound<S, T>(recorded, name, "derivatives", algorithm::inverse_dynamics_derivatives);
}
template <class S, class T>
void put_all(Recorded& recorded, const std::string& name) {
  put_motion<S, T>(recorded, name), put_forward<S, T>(recorded, name), put_tool<S, T>(recorded, name),
      put_momenta<S, T>(recorded, name), put_terms<S, T>(recorded, name);
}

template <class R, class... More>
using Feels = Scene<R, Gravity, RotorInertia, More...>;

}  // namespace

TEST(RecordedBounds, OfAnArmOfSix) {
  Recorded recorded;
  put_motion<Feels<robots::Puma560, Friction>, Fixed32>(recorded, "puma560");
  put_forward<Feels<robots::Puma560>, Fixed32>(recorded, "puma560");
}
TEST(RecordedBounds, OfASlideAndAWrist) {
  Recorded recorded;
  put_all<Feels<Crane, Friction>, Fixed32>(recorded, "crane");
}
TEST(RecordedBounds, OfOneStepForAllLinks) {
  Recorded recorded;
  using S = Feels<Crane, Looped>;
  put_motion<S, Fixed32>(recorded, "crane looped"), put_tool<S, Fixed32>(recorded, "crane looped");
  put_momenta<S, Fixed32>(recorded, "crane looped");
  put_bound<S, Fixed32>(recorded, "crane looped", "derivatives", algorithm::inverse_dynamics_derivatives);
}
TEST(RecordedBounds, OfOtherArithmetics) {
  Recorded recorded;
  put_motion<Feels<Crane, HighWord>, Fixed32>(recorded, "crane high word");
  put_motion<Feels<Crane, RoundDown>, Fixed32>(recorded, "crane down");
  put_motion<Feels<Crane>, Fixed16>(recorded, "crane 16");
  put_forward<Feels<Crane, HighWord>, Fixed32>(recorded, "crane high word");
}
TEST(RecordedBounds, OfAPayloadsEstimator) {
  Recorded recorded;
  using S = Feels<Crane, RangeCheck>;
  put_bound<S, Fixed32>(recorded, "crane", "payload_estimator", algorithm::PayloadEstimator<Tuning>{});
  put_bound<Feels<Belt, RangeCheck>, Fixed32>(recorded, "belt", "payload_estimator",
                                              algorithm::PayloadEstimator<Tuning>{});
}
TEST(RecordedBounds, OfWhatAChainDeclares) {
  Recorded recorded;
  put_motion<Feels<Crane, SineCosines>, Fixed32>(recorded, "crane sine_cosines");
  put_motion<Feels<Crane, Payload, TipWrench>, Fixed32>(recorded, "crane payload");
  put_forward<Feels<Crane, Payload, TipWrench>, Fixed32>(recorded, "crane payload");
  put_tool<Feels<Crane, RuntimeTool>, Fixed32>(recorded, "crane tool");
}
TEST(RecordedBounds, OfATree) {
  Recorded recorded;
  put_all<Feels<Hand>, Fixed32>(recorded, "hand");
}
TEST(RecordedBounds, OfTheDeclaredMotion) {
  Recorded recorded;
  put_forward<Feels<Feather>, Fixed32>(recorded, "feather");
}
TEST(RecordedBounds, OfOneStepForATree) {
  Recorded recorded;
  using S = Feels<Hand, Looped>;
  put_motion<S, Fixed32>(recorded, "hand looped"), put_tool<S, Fixed32>(recorded, "hand looped");
  put_momenta<S, Fixed32>(recorded, "hand looped");
}
TEST(RecordedBounds, OfJointsThatShareDrives) {
  Recorded recorded;
  put_all<Feels<Belt, Friction>, Fixed32>(recorded, "belt");
}
TEST(RecordedBounds, OfTheClosedForm) {
  Recorded recorded;
  using S = Feels<robots::Scara>;
  put_bound<S, Fixed32>(recorded, "scara", "closed_form", algorithm::closed_form);
  put_bound<Feels<BentScara>, Fixed32>(recorded, "bent scara", "closed_form", algorithm::closed_form);
  put_bound<S, Fixed32>(recorded, "scara", "closed_form_separation", algorithm::closed_form_separation);
  put_bound<S, Fixed16>(recorded, "scara 16", "closed_form", algorithm::closed_form);
}
