#include <axial/axial.hpp>
#include <cases/to_axial.hpp>
#include <limits>
#include <memory>
#include <stability/routes.hpp>

namespace stability {
namespace {

constexpr int capacity = 300;

template <class Model, class T>
Answer solve_by(const cases::Scenario& s) {
  const auto model = std::make_unique<Model>(cases::to_model<Model>(s.chain));
  axial::Joints<Model, T> q{}, qd{}, tau{};
  for (int i = 0; i < model->size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    q[i] = static_cast<T>(s.q[k]), qd[i] = static_cast<T>(s.qd[k]), tau[i] = static_cast<T>(s.tau[k]);
  }
  const auto result = axial::forward_dynamics(*model, q, qd, tau);
  return {oracle::Vector<double>(result.values, result.values + model->size()), result.status};
}

template <class Model>
Answer solve_by(const cases::Scenario& s, Scalar scalar) {
  return scalar == Scalar::in_double ? solve_by<Model, double>(s) : solve_by<Model, float>(s);
}

template <class... Tag>
using Model = axial::Model<capacity, axial::Gravity, axial::RotorInertia, axial::Unbranched, Tag...>;

}  // namespace

const char* name_of(Route route) {
  constexpr const char* names[] = {"articulated_body", "split_articulated_body", "composite_body"};
  return names[static_cast<int>(route)];
}
const char* name_of(Scalar scalar) { return scalar == Scalar::in_double ? "double" : "float"; }
const char* name_of(const axial::Status& status) {
  using Code = axial::Status::Code;
  switch (status.code) {
    case Code::ok:
      return "ok";
    case Code::near_singular:
      return "near_singular";
    case Code::inaccurate:
      return "inaccurate";
    case Code::not_finite:
      return "not_finite";
    default:
      return "other";
  }
}
double epsilon_of(Scalar scalar) {
  return scalar == Scalar::in_double ? std::numeric_limits<double>::epsilon()
                                     : double{std::numeric_limits<float>::epsilon()};
}

Answer solve(const cases::Scenario& scenario, Route route, Scalar scalar) {
  switch (route) {
    case Route::articulated_body:
      return solve_by<Model<>>(scenario, scalar);
    case Route::split_articulated_body:
      return solve_by<Model<axial::SplitArticulatedBody>>(scenario, scalar);
    default:
      return solve_by<Model<axial::CompositeBody>>(scenario, scalar);
  }
}

}  // namespace stability
