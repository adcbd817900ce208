// Plants in double, of one arm or of two at once.
#pragma once

#include <axial/batch.hpp>

namespace host_sim::collide {

/// Both numbers in the lanes of a batch.
inline axial::Batch<double, 2> lanes_of(double first, double second) {
  return axial::Batch<double, 2>::of([&](int lane) { return lane == 0 ? first : second; });
}
/// Run-time inputs of two plants, of which a payload is all that there may be.
template <class Scene>
axial::Inputs<Scene, axial::Batch<double, 2>> lanes_of(const axial::Inputs<Scene, double> (&in)[2]) {
  axial::Inputs<Scene, axial::Batch<double, 2>> both;
  if constexpr (Scene::template has<axial::Payload>) {
    const auto& a = in[0].payload;
    const auto& b = in[1].payload;
    const auto &x = a.inertia_com, &y = b.inertia_com;
    both.payload = {lanes_of(a.mass, b.mass),
                    {lanes_of(a.com.x, b.com.x), lanes_of(a.com.y, b.com.y), lanes_of(a.com.z, b.com.z)},
                    {lanes_of(x.xx, y.xx), lanes_of(x.yy, y.yy), lanes_of(x.zz, y.zz), lanes_of(x.xy, y.xy),
                     lanes_of(x.xz, y.xz), lanes_of(x.yz, y.yz)}};
  }
  return both;
}

/// One Runge-Kutta step of `period` (s) under efforts that are held; T is double or a batch.
template <class Scene, class Values, class T>
void advance(Values& q, Values& qd, const Values& tau, const axial::Inputs<Scene, T>& in, double period) {
  const T h(period), half(0.5 * period), sixth(period / 6.0), two(2.0);
  const auto acceleration = [&](const Values& at, const Values& speed) {
    const auto answer = axial::forward_dynamics<Scene>(at, speed, tau, in);
    Values qdd{};
    for (int i = 0; i < Values::size; ++i)
      qdd[i] = answer[i];
    return qdd;
  };
  const auto moved = [](const Values& x, const Values& rate, const T& time) {
    Values y{};
    for (int i = 0; i < Values::size; ++i)
      y[i] = x[i] + time * rate[i];
    return y;
  };
  const Values a1 = acceleration(q, qd), v2 = moved(qd, a1, half);
  const Values a2 = acceleration(moved(q, qd, half), v2), v3 = moved(qd, a2, half);
  const Values a3 = acceleration(moved(q, v2, half), v3), v4 = moved(qd, a3, h);
  const Values a4 = acceleration(moved(q, v3, h), v4);
  for (int i = 0; i < Values::size; ++i) {
    q[i] = q[i] + sixth * (qd[i] + two * v2[i] + two * v3[i] + v4[i]);
    qd[i] = qd[i] + sixth * (a1[i] + two * a2[i] + two * a3[i] + a4[i]);
  }
}
/// advance() of two plants at once, in 0.6 of the time without options for wider vectors: the same to rounding, where
/// nothing is fused to the bit.
template <class Scene, class Values>
void advance_both(Values (&q)[2], Values (&qd)[2], const Values (&tau)[2], const axial::Inputs<Scene, double> (&in)[2],
                  double period) {
  auto positions = axial::load<2>(q), speeds = axial::load<2>(qd);
  advance<Scene>(positions, speeds, axial::load<2>(tau), lanes_of<Scene>(in), period);
  axial::store(positions, q), axial::store(speeds, qd);
}

}  // namespace host_sim::collide
