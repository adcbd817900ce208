#include <bench/ours.hpp>
#include <bench/serial.hpp>
#include <cases/to_axial.hpp>
#include <stdexcept>

namespace bench {
namespace {

// As OfRobot (ours.hpp), for a model that is filled at run time.
template <class Model>
struct OfModel {
  Model model;

  template <class V>
  [[gnu::noinline]] auto call(Choice<Algorithm::mass_matrix>, const V& q, const V&, const V&) const {
    return axial::mass_matrix(model, q);
  }
  template <class V>
  [[gnu::noinline]] auto call(Choice<Algorithm::forward_dynamics>, const V& q, const V& qd, const V& tau) const {
    return axial::forward_dynamics(model, q, qd, tau);
  }
};

template <int N>
std::unique_ptr<Contender> of_size(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states) {
  using Model = axial::Model<N, axial::Gravity, axial::RotorInertia, axial::Unbranched>;
  const OfModel<Model> caller{cases::to_model<Model>(chain)};
  if (algorithm == Algorithm::composite_body) {
    using Composite = axial::Model<N, axial::Gravity, axial::CompositeBody, axial::Unbranched>;
    const OfModel<Composite> composite{cases::to_model<Composite>(chain)};
    return std::make_unique<Ours<Composite, double, Algorithm::forward_dynamics, OfModel<Composite>>>(states,
                                                                                                      composite);
  }
  if (algorithm == Algorithm::mass_matrix)
    return std::make_unique<Ours<Model, double, Algorithm::mass_matrix, OfModel<Model>>>(states, caller);
  return std::make_unique<Ours<Model, double, Algorithm::forward_dynamics, OfModel<Model>>>(states, caller);
}

}  // namespace

std::unique_ptr<Contender> ours_serial(Algorithm algorithm, const oracle::Chain<double>& chain, const States& states) {
  switch (chain.size()) {
    case 2:
      return of_size<2>(algorithm, chain, states);
    case 4:
      return of_size<4>(algorithm, chain, states);
    case 8:
      return of_size<8>(algorithm, chain, states);
    case 16:
      return of_size<16>(algorithm, chain, states);
    case 32:
      return of_size<32>(algorithm, chain, states);
    case 64:
      return of_size<64>(algorithm, chain, states);
    default:
      throw std::invalid_argument("ours_serial: no kernel for " + std::to_string(chain.size()) + " joints");
  }
}

}  // namespace bench
