#include <host_sim/plants/simulation/integrate.hpp>

namespace host_sim::simulation {

namespace {

template <class Visit>
auto with(Method method, const Visit& visit) {
  switch (method) {
    case Method::semi_implicit:
      return visit(axial::SemiImplicitEuler{});
    case Method::rk4:
      return visit(axial::RungeKutta4{});
    case Method::linearly_implicit:
      break;
  }
  return visit(axial::LinearlyImplicitEuler{});
}

}  // namespace

const char* name(Method method) {
  constexpr const char* names[] = {"semi_implicit_euler", "rk4", "linearly_implicit_euler"};
  return names[static_cast<int>(method)];
}

int evaluations(Method method) {
  return with(method, [](auto m) { return decltype(m)::evaluations; });
}

template <class X>
axial::Status step(Method method, const typename X::Subject& model, X& x, typename X::Scalar h,
                   const DriveOf<X>& drive) {
  return with(method, [&](auto m) { return axial::advance<decltype(m)>(model, x, h, drive); });
}
template axial::Status step(Method, const Model&, Motion<double>&, double, const Drive<double>&);
template axial::Status step(Method, const Model&, CompensatedMotion<double>&, double,
                            const DriveOf<CompensatedMotion<double>>&);
template axial::Status step(Method, const Model&, Motion<float>&, float, const Drive<float>&);
template axial::Status step(Method, const Model&, CompensatedMotion<float>&, float,
                            const DriveOf<CompensatedMotion<float>>&);
template axial::Status step(Method, const DrivenModel&, DrivenMotion&, double, const DriveOf<DrivenMotion>&);

template <class T>
Motion<double> exact_state(const Motion<T>& x) {
  Motion<double> wide;
  for (int i = 0; i < Values<T>::size; ++i)
    wide.q[i] = static_cast<double>(x.q[i]), wide.qd[i] = static_cast<double>(x.qd[i]);
  wide.steps = x.steps;
  return wide;
}
template <class T>
Motion<double> exact_state(const CompensatedMotion<T>& x) {
  Motion<double> wide = exact_state<T>(static_cast<const Motion<T>&>(x));
  for (int i = 0; i < Values<T>::size; ++i)
    wide.q[i] += static_cast<double>(x.q_rest[i]), wide.qd[i] += static_cast<double>(x.qd_rest[i]);
  return wide;
}
template Motion<double> exact_state(const Motion<double>&);
template Motion<double> exact_state(const Motion<float>&);
template Motion<double> exact_state(const CompensatedMotion<double>&);
template Motion<double> exact_state(const CompensatedMotion<float>&);

double step_limit(Method method, const Model& model, const Values<double>& q, const Stiffness<double>& drive) {
  return with(method, [&](auto m) { return axial::step_limit<decltype(m)>(model, q, {}, drive); });
}

double step_limit(Method method, const DrivenModel& model, const axial::Joints<DrivenModel, double>& u,
                  const axial::DriveStiffness<DrivenModel, double>& drive) {
  return with(method, [&](auto m) { return axial::step_limit<decltype(m)>(model, u, {}, drive); });
}

}  // namespace host_sim::simulation
