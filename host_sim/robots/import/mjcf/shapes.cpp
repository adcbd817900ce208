#include <host_sim/robots/import/mjcf/shapes.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace importer::mjcf {
namespace {

/// How much there is of a shape (m^3, or m^2 of its surface) and its moments for a mass of 1.
struct Shape {
  Real content = 0.0L;
  Vector moments = Vector::Zero();
};
using Sizes = std::array<Real, 3>;

Shape turned(Real content, Real along, Real across) { return {content, {across, across, along}}; }

/// Half as long as `h`, without the half spheres at the ends.
Shape capsule(Real r, Real h, bool shell) {
  const Real middle = shell ? 4.0L * pi * r * h : 2.0L * pi * r * r * h,
             ends = shell ? 4.0L * pi * r * r : 4.0L / 3.0L * pi * r * r * r, sum = middle + ends;
  const Real m = middle / sum, e = ends / sum;
  if (shell)
    return turned(sum, m * r * r + e * 2.0L / 3.0L * r * r,
                  m * (r * r / 2.0L + h * h / 3.0L) + e * (2.0L / 3.0L * r * r + h * h + h * r));
  return turned(sum, m * r * r / 2.0L + e * 0.4L * r * r,
                m * (r * r / 4.0L + h * h / 3.0L) + e * (0.4L * r * r + h * h + 0.75L * h * r));
}
Shape cylinder(Real r, Real h, bool shell) {
  if (!shell) return turned(2.0L * pi * r * r * h, r * r / 2.0L, r * r / 4.0L + h * h / 3.0L);
  const Real side = 4.0L * pi * r * h, lids = 2.0L * pi * r * r, sum = side + lids, s = side / sum, l = lids / sum;
  return turned(sum, s * r * r + l * r * r / 2.0L, s * (r * r / 2.0L + h * h / 3.0L) + l * (r * r / 4.0L + h * h));
}
Shape sphere(Real r, bool shell) {
  const Real moment = (shell ? 2.0L / 3.0L : 0.4L) * r * r;
  return {shell ? 4.0L * pi * r * r : 4.0L / 3.0L * pi * r * r * r, {moment, moment, moment}};
}
Shape box(const Sizes& s, bool shell) {
  const Vector squares(s[0] * s[0], s[1] * s[1], s[2] * s[2]);
  Vector means = squares / 3.0L;  // of the square of each coordinate
  Real content = 8.0L * s[0] * s[1] * s[2];
  if (shell) {
    const Vector faces = 8.0L * Vector(s[1] * s[2], s[0] * s[2], s[0] * s[1]);
    content = faces.sum();
    for (int k = 0; k < 3; ++k)
      means[k] = squares[k] * (faces[k] + (content - faces[k]) / 3.0L) / content;
  }
  return {content, {means[1] + means[2], means[0] + means[2], means[0] + means[1]}};
}
Shape ellipsoid(const Sizes& s) {
  const Vector squares(s[0] * s[0], s[1] * s[1], s[2] * s[2]);
  return {4.0L / 3.0L * pi * s[0] * s[1] * s[2],
          {(squares[1] + squares[2]) / 5.0L, (squares[0] + squares[2]) / 5.0L, (squares[0] + squares[1]) / 5.0L}};
}

/// As many sizes as a shape has; with fromto, all but the one that is half its length.
Sizes sizes_of(const Attributes& geom, const std::string& type, double half_length) {
  const std::size_t wanted = type == "sphere" ? 1 : type == "capsule" || type == "cylinder" ? 2 : 3;
  const bool between = half_length > 0.0 && wanted > 1;
  const std::size_t least = between ? 1 : wanted;
  const auto given = geom.numbers("size", 0, 3);
  if (given.size() < least)
    geom.refuse("size is '" + geom.word("size", "") + "', and a " + type + " has " + std::to_string(least) + " numbers",
                "give radius, or half lengths, in m");
  Sizes sizes{};
  std::copy(given.begin(), given.end(), sizes.begin());
  if (between && wanted == 3) sizes[1] = sizes[0];
  if (between) sizes[wanted - 1] = half_length;
  for (std::size_t k = 0; k < wanted; ++k)
    if (!(sizes[k] > 0.0L && sizes[k] < 1e6L))
      geom.refuse("size is '" + geom.word("size", "") + "'", "give radius, or half lengths, in m and above 0");
  return sizes;
}
Shape shape_of(const Attributes& geom, const std::string& type, double half_length) {
  const bool shell = geom.flag("shellinertia", false);
  const Sizes s = sizes_of(geom, type, half_length);
  if (type == "sphere") return sphere(s[0], shell);
  if (type == "capsule") return capsule(s[0], s[1], shell);
  if (type == "cylinder") return cylinder(s[0], s[1], shell);
  if (type == "box") return box(s, shell);
  if (shell) geom.refuse("shellinertia of an ellipsoid has no closed form", "give the body an <inertial>");
  return ellipsoid(s);
}

/// Principal moments and axes of a body's inertia.
Eigen::SelfAdjointEigenSolver<Matrix> principal(const Body& body) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(body.inertia);
}

}  // namespace

std::optional<Body> body_of_geom(const Attributes& geom, const Settings& settings) {
  const std::string type =
      geom.one_of("type", {"sphere", "capsule", "ellipsoid", "cylinder", "box", "plane", "hfield", "mesh", "sdf"});
  const double group = geom.number("group", 0.0), mass = geom.number("mass", -1.0);
  if (type == "plane" || type == "hfield" || group < settings.first_group || group > settings.last_group || mass == 0.0)
    return std::nullopt;
  const double density = geom.number("density", 1000.0);
  if (mass < 0.0 && density == 0.0) return std::nullopt;
  if (mass < -1.0 || (mass < 0.0 && geom.has("mass")) || density < 0.0)
    geom.refuse("mass or density is below 0", "give kg, or kg/m^3, above 0");
  if (geom.has("mesh") || type == "mesh" || type == "sdf")
    geom.refuse("its mass and inertia are those of mesh '" + geom.word("mesh", "") + "', which is not computed here",
                "give the body an <inertial>: MuJoCo writes one where it saves a model (mj_saveLastXML, with "
                "<compiler saveinertial=\"true\"/>)");
  double half_length = 0.0;
  const Pose pose = pose_of(geom, settings, half_length);
  const Shape shape = shape_of(geom, type, half_length);
  const Real kg = mass > 0.0 ? Real(mass) : density * shape.content;
  return Body{kg, pose.position, pose.rotation * Matrix((kg * shape.moments).asDiagonal()) * pose.rotation.transpose()};
}

Body body_of_inertial(const Attributes& inertial, const Settings& settings) {
  inertial.allow("pos quat axisangle euler xyaxes zaxis mass diaginertia fullinertia");
  if (!inertial.has("mass") || !inertial.has("pos"))
    inertial.refuse(std::string("has no ") + (inertial.has("mass") ? "pos" : "mass"), "give pos, mass and diaginertia");
  const auto diagonal = inertial.numbers("diaginertia", 3, 3), full = inertial.numbers("fullinertia", 6, 6);
  if (!diagonal.empty() && !full.empty()) inertial.refuse("diaginertia and fullinertia are given", "keep one of them");
  const Pose pose = pose_of(inertial, settings);
  if (!full.empty() && !inertial.only_one({"quat", "axisangle", "euler", "xyaxes", "zaxis"}).empty())
    inertial.refuse("fullinertia and an orientation are given", "fullinertia is in axes of the body: keep one");
  Body body{inertial.number("mass", 0.0), pose.position, Matrix::Zero()};
  if (!full.empty()) body.inertia << full[0], full[3], full[4], full[3], full[1], full[5], full[4], full[5], full[2];
  if (!diagonal.empty())
    body.inertia =
        pose.rotation * Matrix(Vector(diagonal[0], diagonal[1], diagonal[2]).asDiagonal()) * pose.rotation.transpose();
  return body;
}

Body bounded(const Body& body, const Settings& settings) {
  Body result = body;
  if (settings.least_mass > 0.0) result.mass = std::max(result.mass, Real(settings.least_mass));
  if (settings.least_moment <= 0.0 && !settings.balance) return result;
  const auto solver = principal(body);
  Vector moments = solver.eigenvalues();
  if (settings.least_moment > 0.0) moments = moments.cwiseMax(Real(settings.least_moment));
  if (settings.balance && moments[0] + moments[1] < moments[2] - 1e-14L) moments = Vector::Constant(moments.mean());
  result.inertia = solver.eigenvectors() * Matrix(moments.asDiagonal()) * solver.eigenvectors().transpose();
  return result;
}

}  // namespace importer::mjcf
