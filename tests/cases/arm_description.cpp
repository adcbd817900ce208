#include <cases/arm_description.hpp>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace cases {
namespace {

using json = nlohmann::json;

int quarters(const json& word) {
  static const std::map<std::string, int> known{{"0", 0}, {"pi/2", 1}, {"-pi/2", -1}};
  return known.at(word.get<std::string>());
}

oracle::Vec3<double> vector_of(const json& v) { return {v.at(0), v.at(1), v.at(2)}; }

/// Row by row above the diagonal, or the diagonal alone.
oracle::Mat3<double> inertia(const json& arm, std::size_t i) {
  if (const auto full = arm.find("inertia_com_xx_xy_xz_yy_yz_zz"); full != arm.end()) {
    const json& v = full->at(i);
    return oracle::symmetric<double>(v.at(0), v.at(3), v.at(5), v.at(1), v.at(2), v.at(4));
  }
  const json& v = arm.at("inertia_com_xx_yy_zz").at(i);
  return oracle::symmetric<double>(v.at(0), v.at(1), v.at(2), 0.0, 0.0, 0.0);
}

DescribedJoint joint(const json& arm, std::size_t i) {
  const json &limits = arm.at("limits"), &rpy = arm.at("origin_rpy").at(i);
  const bool both_sides = limits.contains("position");
  const double high = limits.at(both_sides ? "position" : "position_max").at(i);
  const double low = both_sides ? -high : limits.at("position_min").at(i).get<double>();
  return {vector_of(arm.at("origin_xyz").at(i)),
          quarters(rpy.at(0)),
          quarters(rpy.at(1)),
          quarters(rpy.at(2)),
          arm.at("mass").at(i),
          vector_of(arm.at("com").at(i)),
          inertia(arm, i),
          low,
          high};
}

}  // namespace

ArmDescription load_arm(const std::string& name) {
  std::ifstream file(AXIAL_TEST_DATA "/rival_models.json");
  const json source = json::parse(file);
  for (const json& arm : source.at("robots")) {
    if (arm.at("name") != name) continue;
    ArmDescription result{{}, arm.at("limits").at("speed"), arm.at("limits").at("acceleration")};
    for (std::size_t i = 0; i < arm.at("mass").size(); ++i)
      result.joints.push_back(joint(arm, i));
    return result;
  }
  throw std::out_of_range("no such arm: " + name);
}

}  // namespace cases
