#include <host_sim/figures/counts/congruence_rows.hpp>

#include <cases/scenarios.hpp>
#include <cases/to_axial.hpp>
#include <host_sim/figures/counts/congruences.hpp>
#include <host_sim/tools/analysis/largest.hpp>
#include <oracle/compare.hpp>

#include <cstdio>
#include <memory>

namespace counts {

namespace {

using axial::Counting;

template <class... V>
void need(const axial::Vec3<V...>& v) {
  v.x.need(), v.y.need(), v.z.need();
}

/// N of a revolute joint: row and column 3 are zero.
template <class Congruence>
axial::Operations cost_of() {
  using namespace axial;
  const auto trace = std::make_unique<Trace>();
  const auto run = [&] { return Counting(*trace); };
  const auto vec = [&] { return Vec3{run(), run(), run()}; };
  constexpr Zero o;
  const ArticulatedInertia n{Sym3{run(), run(), o, run(), o, o}, Mat3{vec(), vec(), ZeroVec3{}},
                             Sym3{run(), run(), run(), run(), run(), run()}};
  const auto z = z_screw(run(), run(), Counting::constant(0.37));
  const auto x = x_screw(Counting::constant(0.71), Counting::constant(0.69), Counting::constant(0.53))
                     .with_turn(std::false_type{});
  const ArticulatedInertia<Sym3<Counting>, Mat3<Vec3<Counting>>, Sym3<Counting>> seen =
      Congruence::template to_parent<Counting>(x, z, n);
  const auto& [angular, coupling, linear] = seen;
  for (const auto* s : {&angular, &linear})
    need(Vec3{s->xx, s->yy, s->zz}), need(Vec3{s->xy, s->xz, s->yz});
  need(coupling.x), need(coupling.y), need(coupling.z);
  return trace->operations();
}

template <class Congruence, class T>
double error(const cases::Scenario& rods, const LongChain& model, const cases::Values& exact) {
  axial::Joints<LongChain, T> q{}, still{};
  for (int i = 0; i < rods.size(); ++i)
    q[i] = static_cast<T>(rods.q[std::size_t(i)]);
  const auto qdd = forward_dynamics_by<Congruence>(model, q, still, still);
  return oracle::relative_error(oracle::Vector<T>(qdd.values, qdd.values + rods.size()), exact);
}

}  // namespace

std::vector<CongruenceRow> congruence_rows() {
  std::vector<CongruenceRow> rows;
  for_each_congruence([&](auto way) {
    for (const int links : {10, 30, 100, 300})
      rows.push_back({way.name, cost_of<decltype(way)>(), links, 0.0, 0.0});
  });
  for (const auto& scenario : cases::rods()) {
    if (scenario.name.find("moving") != std::string::npos) continue;
    std::fprintf(stderr, "counts: congruences over %s\n", scenario.name.c_str());
    const auto model = std::make_unique<LongChain>(cases::to_model<LongChain>(scenario.chain));
    const auto exact = cases::reference_acceleration(scenario);
    for_each_congruence([&](auto way) {
      for (auto& row : rows)
        if (row.congruence == way.name && row.links == scenario.size()) {
          host_sim::note_size(row.in_float, error<decltype(way), float>(scenario, *model, exact));
          host_sim::note_size(row.in_double, error<decltype(way), double>(scenario, *model, exact));
        }
    });
  }
  return rows;
}

}  // namespace counts
