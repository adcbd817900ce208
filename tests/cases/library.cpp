#include <axial/axial.hpp>
#include <cases/implementation.hpp>
#include <cases/to_axial.hpp>
#include <oracle/convert.hpp>

namespace cases {
namespace {

/// The library's run-time model in its looped form: base and tool included, friction and tip wrench as the state says.
template <class T>
class Library : public Implementation {
 public:
  using Implementation::Implementation;

  std::optional<Values> evaluate(const CaseFile& file, const State& state, const std::string& quantity) const override {
    const Model model = to_model<Model>(chain_of(file, state));
    const int n = model.size();
    const auto q = joints(state.q), qd = joints(state.qd);
    const auto in = inputs(state);
    if (quantity == "tau") return values(axial::inverse_dynamics(model, q, qd, joints(state.qdd), in), n);
    if (quantity == "qdd") return values(axial::forward_dynamics(model, q, qd, joints(state.tau), in), n);
    if (quantity == "M") return matrix(axial::mass_matrix(model, q, in), n);
    if (quantity == "cor") return coriolis(file, state);
    if (quantity == "grav") return values(axial::gravity_torque(model, q, std::decay_t<decltype(in)>{}), n);
    const auto tool = axial::forward_kinematics(model, q, in).tool;
    if (quantity == "pose") return pose_rows(pose(tool));
    return jacobian(axial::jacobian(model, q, in), n, quantity == "jace" ? pose(tool).rotation : oracle::Mat3<T>{});
  }

 private:
  static constexpr int capacity = 16;
  using Model = axial::Model<capacity, axial::Gravity, axial::RotorInertia, axial::Friction, axial::TipWrench>;

  static oracle::Chain<double> chain_of(const CaseFile& file, const State& state) {
    auto chain = oracle::convert<double>(file.chain_at(state));
    if (state.load.friction) return chain;
    for (auto& link : chain.links)
      link.viscous = link.coulomb_forward = link.coulomb_backward = 0.0;
    return chain;
  }
  /// The bias torque of a scene that names neither gravity nor friction.
  static Values coriolis(const CaseFile& file, const State& state) {
    using Bare = axial::Model<capacity, axial::RotorInertia>;
    const auto model = to_model<Bare>(oracle::convert<double>(file.chain_at(state)));
    return values(axial::bias_torque(model, joints<Bare>(state.q), joints<Bare>(state.qd)), model.size());
  }
  static axial::Inputs<Model, T> inputs(const State& state) {
    const auto tip = oracle::convert<T>(state.load.tip);
    axial::Inputs<Model, T> in;
    in.tip_wrench = {{tip.moment.x, tip.moment.y, tip.moment.z}, {tip.force.x, tip.force.y, tip.force.z}};
    return in;
  }

  template <class M = Model>
  static axial::Joints<M, T> joints(const oracle::Vector<double>& source) {
    axial::Joints<M, T> result{};
    for (std::size_t i = 0; i < source.size(); ++i)
      result[static_cast<int>(i)] = static_cast<T>(source[i]);
    return result;
  }
  template <class M>
  static Values values(const axial::Joints<M, T>& source, int n) {
    return Values(source.values, source.values + n);
  }
  template <class M>
  static Values matrix(const M& source, int n) {
    Values result;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        result.push_back(source(i, j));
    return result;
  }
  static oracle::Pose<T> pose(const axial::WorldPose<T>& source) {
    const auto& R = source.rotation;
    const auto& p = source.position;
    return {{{R.x.x, R.y.x, R.z.x}, {R.x.y, R.y.y, R.z.y}, {R.x.z, R.y.z, R.z.z}}, {p.x, p.y, p.z}};
  }
  template <class J>
  static Values jacobian(const J& source, int n, const oracle::Mat3<T>& axes) {
    oracle::Matrix<T> linear(3, n), angular(3, n);
    for (int j = 0; j < n; ++j) {
      const auto &v = source[j].linear, &w = source[j].angular;
      linear(0, j) = v.x, linear(1, j) = v.y, linear(2, j) = v.z;
      angular(0, j) = w.x, angular(1, j) = w.y, angular(2, j) = w.z;
    }
    return jacobian_rows(in_axes(axes, linear), in_axes(axes, angular));
  }
};

}  // namespace

ImplementationList library() {
  constexpr double in_double = 1e-10, in_float = 2e-5;  // what the project promises
  return {std::make_shared<Library<double>>("library_double", in_double),
          std::make_shared<Library<float>>("library_float", in_float)};
}

}  // namespace cases
