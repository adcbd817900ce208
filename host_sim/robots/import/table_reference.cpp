// A table of Denavit-Hartenberg rows as Orocos KDL has it, read from the JSON a second time: by nothing that reads it
// for the description, in KDL's own frames of either convention.
#include <host_sim/robots/import/reference.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace importer {
namespace {

using Json = nlohmann::json;
using Of = Change::Of;

constexpr double degree = 3.14159265358979323846 / 180.0;

std::vector<double> list(const Json& of, const std::string& key, std::size_t size) {
  auto values = of.value(key, std::vector<double>{});
  values.resize(size);
  return values;
}
/// In radians, whichever of the two keys is there.
double angle(const Json& row, const std::string& key) { return row.value(key, row.value(key + "_deg", 0.0) * degree); }

class TableReader {
 public:
  TableReader(const std::string& text, const std::vector<Change>& changes, Reference& result)
      : robot_(Json::parse(text)), changes_(changes), result_(result) {
    classical_ = robot_.at("convention") == "classical";
  }

  void read() {
    result_.world = pose("base"), result_.tool = pose("tool");
    if (robot_.count("gravity") != 0) {
      const auto g = list(robot_, "gravity", 3);
      result_.gravity = KDL::Vector(g[0], g[1], g[2]);
    } else {
      result_.gravity = KDL::Vector(0.0, 0.0, -9.81);
    }
    std::string before = "base";
    segments_[before] = "root";
    for (const auto& row : robot_.at("links")) {
      const std::string number = std::to_string(result_.joints.size() + 1), name = row.value("name", "link" + number);
      add(row, name, segments_.at(row.value("parent", before)));
      before = name;
    }
    const std::size_t n = result_.joints.size();
    result_.drives = static_cast<int>(n), result_.offsets.assign(n, 0.0);
    result_.ratios.assign(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i)
      result_.ratios[i][i] = 1.0;
  }

 private:
  /// A number as it is said to be read.
  double changed(Of of, const std::string& name, std::size_t index, double written) const {
    for (const auto& change : changes_) {
      if (change.of != of || change.name != name || change.index != index) continue;
      if (std::abs(change.written - written) > 1e-15)
        throw description::Refused("'" + name + "': a number is said to be changed that the file has not");
      auto& farthest = of == Of::row_length ? result_.changed_length : result_.changed_angle;
      host_sim::note_size(farthest, change.read - written);
      return change.read;
    }
    return written;
  }
  KDL::Frame pose(const std::string& key) const {
    const Json of = robot_.value(key, Json::object());
    const auto xyz = list(of, "xyz", 3);
    auto rpy = list(of, of.count("rpy_deg") != 0 ? "rpy_deg" : "rpy", 3);
    for (double& each : rpy)
      each *= of.count("rpy_deg") != 0 ? degree : 1.0;
    KDL::Rotation rotation = KDL::Rotation::RPY(rpy[0], rpy[1], rpy[2]);
    if (of.count("rotation") != 0) {
      const auto given = list(of, "rotation", 9);
      std::copy(given.begin(), given.end(), rotation.data);
    }
    for (std::size_t k = 0; k < 9; ++k)
      rotation.data[k] = changed(Of::pose_rotation, key, k, rotation.data[k]);
    return {rotation, KDL::Vector(xyz[0], xyz[1], xyz[2])};
  }
  static KDL::RigidBodyInertia body(const Json& row) {
    const double mass = row.value("mass", 0.0);
    const auto c = list(row, "com", 3), about_centre = list(row, "inertia_com", 6),
               about_origin = list(row, "inertia_origin", 6);
    const bool origin = row.count("inertia_origin") != 0;
    const auto& j = origin ? about_origin : about_centre;
    const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    const auto moved = [&](std::size_t k, std::size_t l) {
      return origin ? mass * ((k == l ? square : 0.0) - c[k] * c[l]) : 0.0;
    };
    return KDL::RigidBodyInertia(mass, KDL::Vector(c[0], c[1], c[2]),
                                 KDL::RotationalInertia(j[0] - moved(0, 0), j[1] - moved(1, 1), j[2] - moved(2, 2),
                                                        j[3] - moved(0, 1), j[4] - moved(0, 2), j[5] - moved(1, 2)));
  }
  void add(const Json& row, const std::string& link, const std::string& parent) {
    const auto length = [&](const char* key, std::size_t index) {
      return changed(Of::row_length, link, index, row.value(key, 0.0));
    };
    const auto turn = [&](const char* key, std::size_t index) {
      return changed(Of::row_angle, link, index, angle(row, key));
    };
    const double a = length("a", 0), d = length("d", 1), alpha = turn("alpha", 0), theta = turn("theta", 1);
    const KDL::Frame branch(KDL::Rotation::RotZ(turn("gamma", 2)), KDL::Vector(0.0, 0.0, length("b", 2)));
    const KDL::Frame axis = classical_ ? KDL::Frame::Identity() : branch * KDL::Frame::DH_Craig1989(a, alpha, 0, 0);
    const KDL::Frame row_frame =
        classical_ ? KDL::Frame::DH(a, alpha, d, theta) : branch * KDL::Frame::DH_Craig1989(a, alpha, d, theta);
    const auto type = row.at("type") == "prismatic" ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    const std::string name = segment_name(static_cast<int>(result_.joints.size()) + 1);
    result_.tree.addSegment(KDL::Segment(name, KDL::Joint(name, axis.p, axis.M.UnitZ(), type), row_frame, body(row)),
                            parent);
    const double gear = row.value("gear", 1.0);
    result_.joints.push_back(name), result_.rotors.push_back(gear * gear * row.value("rotor_inertia", 0.0));
    segments_[link] = result_.tool_segment = name;
    add_limits(row);
  }
  void add_limits(const Json& row) {
    WrittenLimits limits;
    const bool degrees = row.count("position_limits_deg") != 0;
    const auto range = list(row, degrees ? "position_limits_deg" : "position_limits", 2);
    limits.positions = degrees || row.count("position_limits") != 0;
    limits.lower = range[0] * (degrees ? degree : 1.0), limits.upper = range[1] * (degrees ? degree : 1.0);
    limits.speed = row.value("speed_limit", 0.0), limits.effort = row.value("effort_limit", 0.0);
    limits.damping = row.value("viscous", 0.0);
    limits.stiffness = list(row, "spring", 2)[0], limits.rest = list(row, "spring", 2)[1];
    const Json dry = row.value("coulomb", Json(0.0));
    limits.friction = dry.is_array() ? dry[0].get<double>() : dry.get<double>();
    limits.backward = dry.is_array() ? -dry[1].get<double>() : limits.friction;
    result_.limits.push_back(limits);
  }

  Json robot_;
  const std::vector<Change>& changes_;
  Reference& result_;
  bool classical_ = false;
  std::map<std::string, std::string> segments_;  ///< of links, by name
};

}  // namespace

Reference reference_of(const std::string& text, const std::vector<Change>& changes, double changed_angle_bound) {
  Reference result;
  result.changed_angle_bound = 1e-12 + changed_angle_bound;
  TableReader(text, changes, result).read();
  return result;
}

}  // namespace importer
