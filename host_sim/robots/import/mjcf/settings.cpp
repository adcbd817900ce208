#include <host_sim/robots/import/mjcf/settings.hpp>

#include <cctype>
#include <cmath>

namespace importer::mjcf {
namespace {

constexpr const char* compiler_words =
    "angle eulerseq autolimits inertiafromgeom boundmass boundinertia balanceinertia settotalmass inertiagrouprange "
    "coordinate meshdir texturedir assetdir strippath discardvisual fusestatic usethread convexhull exactmeshinertia "
    "alignfree saveinertial fitaabb fitdiameter";

void read_compiler(const Element& element, Settings& s) {
  const Attributes a({&element});
  a.allow(compiler_words);
  if (a.word("coordinate", "local") != "local")
    a.refuse("coordinate='" + a.word("coordinate", "") + "'", "give poses in their parents' frames, as MuJoCo asks");
  if (a.has("angle")) s.angle = a.one_of("angle", {"degree", "radian"}) == "radian" ? 1.0L : pi / 180.0L;
  s.sequence = a.word("eulerseq", s.sequence);
  if (s.sequence.size() != 3 || s.sequence.find_first_not_of("xyzXYZ") != std::string::npos)
    a.refuse("eulerseq is '" + s.sequence + "'", "give three of x, y, z, X, Y, Z");
  s.limits_by_range = a.flag("autolimits", s.limits_by_range);
  if (a.has("inertiafromgeom")) s.inertia_from_geoms = a.one_of("inertiafromgeom", {"auto", "true", "false"});
  s.balance = a.flag("balanceinertia", s.balance);
  s.least_mass = a.number("boundmass", s.least_mass), s.least_moment = a.number("boundinertia", s.least_moment);
  s.total_mass = a.number("settotalmass", s.total_mass);
  if (const auto groups = a.numbers("inertiagrouprange", 2, 2); !groups.empty())
    s.first_group = groups[0], s.last_group = groups[1];
}

void read_option(const Element& element, Settings& s) {
  const Attributes a({&element});
  if (const auto g = a.numbers("gravity", 3, 3); !g.empty()) s.gravity = g;
  for (const char* medium : {"density", "viscosity"})
    if (a.number(medium, 0.0) != 0.0)
      a.refuse(
          std::string(medium) + " is " + a.word(medium, "") + ": bodies are dragged and carried by what they move in",
          "set it to 0; axial has water, by hand: .added_mass(), .buoyancy(), .drag_linear()");
  for (const auto& child : element.children) {
    if (child.name != "flag") continue;
    const Attributes flags({&child});
    for (const char* part : {"equality", "passive", "spring", "damper", "frictionloss"})
      if (flags.word(part, "enable") != "enable")
        flags.refuse(std::string(part) + "='" + flags.word(part, "") + "': joints have it and it is switched off",
                     "take what is not there out of the joints, and this flag");
    if (flags.word("gravity", "enable") == "disable") s.gravity = {0.0, 0.0, 0.0};
  }
}

Matrix about(char axis, Real angle) {
  const Vector unit = axis == 'x' ? Vector::UnitX() : axis == 'y' ? Vector::UnitY() : Vector::UnitZ();
  return Eigen::AngleAxis<Real>(angle, unit).toRotationMatrix();
}
Vector vector(const std::vector<double>& v, std::size_t first = 0) { return {v[first], v[first + 1], v[first + 2]}; }
Vector unit(const Attributes& a, const std::string& what, const Vector& v) {
  if (!(v.norm() > 1e-9L && v.norm() < 1e9L)) a.refuse(what + " has no direction", "give one that is not 0");
  return v.normalized();
}
/// The shortest rotation from z to a direction; half a turn about x for its opposite.
Matrix from_z(const Vector& to) {
  const Vector axis = Vector::UnitZ().cross(to);
  const Real angle = std::atan2(axis.norm(), to[2]);
  const Vector about_this = axis.norm() < 1e-15L ? Vector(Vector::UnitX()) : Vector(axis.normalized());
  return Eigen::AngleAxis<Real>(angle, about_this).toRotationMatrix();
}
Matrix euler(const std::vector<double>& angles, const Settings& settings) {
  Matrix result = Matrix::Identity();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<unsigned char>(settings.sequence[k]);
    const Matrix next = about(static_cast<char>(std::tolower(axis)), angles[k] * settings.angle);
    result = std::isupper(axis) != 0 ? Matrix(next * result) : Matrix(result * next);
  }
  return result;
}
Matrix frame_of_axes(const Attributes& a, const std::vector<double>& v) {
  const Vector x = unit(a, "xyaxes", vector(v)), given = vector(v, 3),
               y = unit(a, "xyaxes' second axis", given - x.dot(given) * x);
  Matrix result;
  result << x, y, x.cross(y);
  return result;
}
Matrix rotation_of(const Attributes& a, const Settings& settings) {
  // A quaternion gives way to any other that is there, be it a class's: as in MuJoCo.
  a.only_one({"quat", "axisangle", "euler", "xyaxes", "zaxis"});
  std::string kind = a.only_one({"axisangle", "euler", "xyaxes", "zaxis"});
  if (kind.empty() && a.has("quat")) kind = "quat";
  if (kind == "euler") return euler(a.numbers(kind, 3, 3), settings);
  if (kind == "xyaxes") return frame_of_axes(a, a.numbers(kind, 6, 6));
  if (kind == "zaxis") return from_z(unit(a, kind, vector(a.numbers(kind, 3, 3))));
  if (kind == "axisangle") {
    const auto v = a.numbers(kind, 4, 4);
    return Eigen::AngleAxis<Real>(v[3] * settings.angle, unit(a, kind, vector(v))).toRotationMatrix();
  }
  if (kind.empty()) return Matrix::Identity();
  const auto v = a.numbers(kind, 4, 4);
  Eigen::Quaternion<Real> q(v[0], v[1], v[2], v[3]);
  if (!(q.norm() > 1e-9L && q.norm() < 1e9L)) a.refuse("quat is '" + a.word(kind, "") + "'", "give w x y z, not all 0");
  return q.normalized().toRotationMatrix();
}

}  // namespace

Settings settings_of(const Element& root) {
  Settings result;
  result.angle = pi / 180.0L;
  for (const auto& section : root.children) {
    if (section.name == "compiler") read_compiler(section, result);
    if (section.name == "option") read_option(section, result);
  }
  return result;
}

Vector vector_of(const Attributes& element, const std::string& name) {
  const auto v = element.numbers(name, 3, 3);
  return v.empty() ? Vector(Vector::Zero()) : vector(v);
}

Pose pose_of(const Attributes& element, const Settings& settings) {
  return {rotation_of(element, settings), vector_of(element, "pos")};
}
Pose pose_of(const Attributes& element, const Settings& settings, double& half_length) {
  const auto ends = element.numbers("fromto", 6, 6);
  if (ends.empty()) return pose_of(element, settings);
  const Vector way = vector(ends) - vector(ends, 3);
  half_length = static_cast<double>(way.norm() / 2.0L);
  return {from_z(unit(element, "fromto", way)), (vector(ends) + vector(ends, 3)) / 2.0L};
}

}  // namespace importer::mjcf
