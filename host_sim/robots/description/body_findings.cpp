// Mass, centre of mass and inertia of one link.
#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/numbers.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace description {
namespace {

constexpr double rounding = 1e-6;  // of published tensors, relative to their trace: printed with few digits

bool all_usable(const double* values, int count) {
  return std::all_of(values, values + count, [](double v) { return usable(v); });
}

std::string list(const double* values, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += (i ? ", " : "") + number(values[i]);
  return text;
}

Eigen::Vector3d principal_moments(const double (&j)[6]) {
  Eigen::Matrix3d tensor;
  tensor << j[0], j[3], j[4], j[3], j[1], j[5], j[4], j[5], j[2];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
}

void check_numbers(const std::string& link, const axial::LinkParameters& p, std::vector<Finding>& found) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    found.push_back({true, link, what, remedy});
  };
  if (!usable(p.mass)) refuse("mass is " + number(p.mass) + " kg", "give kilograms between 0 and 1e9");
  if (p.mass < 0.0) refuse("mass is negative: " + number(p.mass) + " kg", "give kilograms >= 0");
  if (!all_usable(p.com, 3)) refuse("centre of mass is (" + list(p.com, 3) + ") m", "give metres below 1e9");
  if (!all_usable(p.inertia_com, 6))
    refuse("inertia is (" + list(p.inertia_com, 6) + ") kg m^2", "give kg m^2 below 1e9: xx yy zz xy xz yz");
}

void check_moments(const std::string& link, const axial::LinkParameters& p, bool as_published,
                   std::vector<Finding>& found) {
  const Eigen::Vector3d moments = principal_moments(p.inertia_com);
  const double least = moments[0], middle = moments[1], largest = moments[2],
               slack = rounding * std::abs(moments.sum());
  const axial::InertiaDefect defect = axial::inertia_defect({least, middle, largest});
  const auto report = [&](double share, const std::string& what, const std::string& correct) {
    const bool beyond = share > axial::detail::bound::inertia_defect;
    found.push_back({false, link, what,
                     beyond ? correct_or_keep(as_published, correct) : correct + ", or leave them: it is little",
                     beyond && !as_published});
  };
  const std::string moments_are = number(least, 4) + ", " + number(middle, 4) + ", " + number(largest, 4) + " kg m^2";
  if (least < -slack)
    report(defect.negative > defect.triangle ? defect.negative : defect.triangle,
           "inertia is not positive definite: its least principal moment is negative: " + moments_are,
           "check signs and order of the entries (xx yy zz xy xz yz, about the centre of mass)");
  else if (largest > least + middle + slack)
    report(defect.triangle,
           "inertia violates the triangle inequality by " +
               (defect.triangle > 10.0 ? "more than 1000" : number(100.0 * defect.triangle, 3)) +
               " %: principal moments " + moments_are,
           "no body has it: check the entries");
}

}  // namespace

std::string correct_or_keep(bool as_published, const std::string& correct) {
  return as_published ? "kept as published" : correct + ", or keep what was published with --as-published";
}

bool needs_acceptance(const axial::LinkParameters& p) {
  axial::detail::Given given;
  given.note(axial::detail::Quantity::mass);
  return axial::detail::doubtful_problem(p, given, axial::detail::bound::mass) != axial::detail::Problem::none;
}

std::vector<Finding> body_findings(const std::string& link, const axial::LinkParameters& p, bool as_published) {
  std::vector<Finding> found;
  check_numbers(link, p, found);
  if (!found.empty()) return found;
  const bool no_inertia = std::all_of(p.inertia_com, p.inertia_com + 6, [](double v) { return v == 0.0; });
  if (no_inertia && p.mass > 0.0)
    found.push_back({false, link, "has a mass of " + number(p.mass) + " kg and no inertia",
                     "it is taken as a point mass; give its inertia about the centre of mass"});
  else if (no_inertia)
    found.push_back({false, link, "has neither mass nor inertia", "give both, or leave it massless on purpose"});
  else if (p.mass == 0.0)
    found.push_back({false, link, "has an inertia and a mass of 0 kg",
                     correct_or_keep(as_published, "no body has it: give its mass"), !as_published});
  if (!no_inertia && p.mass > 0.0) check_moments(link, p, as_published, found);
  return found;
}

}  // namespace description
