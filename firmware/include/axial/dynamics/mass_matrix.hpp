// Joint-space mass matrix by composite rigid bodies (CRBA) with successive axial screws.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/recursion/reflection.hpp>
#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/inboard_inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Symmetric N x N matrix; the lower triangle is stored. Entry (i, j): kg m^2 between revolute joints, kg m mixed, kg
/// between prismatic ones.
template <class S, class T>
struct MassMatrix {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T values[size * (size + 1) / 2];             ///< lower triangle, row by row

  AXIAL_INLINE constexpr T& operator()(int i, int j) { return values[at(i, j)]; }  ///< entry (i, j), either way round
  /// Sets entry (i, j); structural zeros become numbers.
  template <class V>
  AXIAL_INLINE constexpr void set(int i, int j, const V& value) {
    values[at(i, j)] = static_cast<T>(value);
  }
  /// Entry (i, j), either way round.
  AXIAL_INLINE constexpr const T& operator()(int i, int j) const { return values[at(i, j)]; }

 private:
  AXIAL_INLINE static constexpr int at(int i, int j) { return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i; }
};

/// Mass matrix of a scene.
template <class S, class T>
using MassMatrixOf = MassMatrix<subject_of<S, T>, T>;

namespace crba {

/// A composite body beyond its joint (turned and shifted by it, which leaves what it is about the joint's own axis),
/// and as its parent bears it.
template <class B, class P>
struct InwardResult {
  B turned{};     ///< beyond its joint
  P on_parent{};  ///< in the parent's frame
};
template <class B, class P>
InwardResult(B, P) -> InwardResult<B, P>;

/// Force that accelerates a composite body by one unit of its joint: I^c phi; the same on either side of the joint's
/// screw, whose axis is phi's.
template <class B>
AXIAL_INLINE constexpr auto unit_force(Revolute, const B& body) {
  const auto& h = body.first_moment;
  return ForceVector{Vec3{body.inertia.xz, body.inertia.yz, body.inertia.zz}, Vec3{-h.y, h.x, Zero{}}};
}
/// Prismatic overload.
template <class B>
AXIAL_INLINE constexpr auto unit_force(Prismatic, const B& body) {
  const auto& h = body.first_moment;
  return ForceVector{Vec3{h.y, -h.x, Zero{}}, along_z(mass_along_z(body.mass))};
}

/// Revolute overload for a body whose mass is not the same in all directions.
template <class A, class C, class L>
AXIAL_INLINE constexpr auto unit_force(Revolute joint, const ArticulatedInertia<A, C, L>& body) {
  auto column = joint_column(joint, body);
  return ForceVector{column.angular, column.linear};
}
/// Prismatic overload for a body whose mass is not the same in all directions.
template <class A, class C, class L>
AXIAL_INLINE constexpr auto unit_force(Prismatic joint, const ArticulatedInertia<A, C, L>& body) {
  auto column = joint_column(joint, body);
  return ForceVector{column.angular, column.linear};
}

/// A link with its payload and, underwater, its added mass: then a general symmetric 6x6.
template <class Links, class Loads, class I>
AXIAL_INLINE constexpr auto own_body(const Links& links, const Loads& loads, I i) {
  auto link = links.link(i);
  if constexpr (Links::Scene::template has<Underwater>)
    return link.shape(articulated(loads.body(link)) + water_of(links, i).inertia());
  else
    return link.shape(link.formatted(loads.body(link)));
}

/// The force of joint i at link j, with the moment of its rotor where link j carries that.
template <class Links, class I, class J, class F>
AXIAL_INLINE constexpr auto at_link(const Links& links, I i, J j, const F& force) {
  static_cast<void>(detail::RotorsIncluded<typename Links::Scene>{});
  if constexpr (Links::Scene::template has<RotorDynamics>)
    return with_rotor(links, i, j, force);
  else
    return force;
}

/// Carries the force of joint i, beyond the screw of link j, towards the base and sets the row M(i, .) on its way.
template <class Links, class Screws, class F, class I, class J, class Matrix>
AXIAL_INLINE constexpr void climb(const Links& links, const Screws& screws, const F& force, I i, J j, Matrix& m) {
  if constexpr (Links::unrolled) {
    constexpr int parent = Links::template parent_of<J::value>;
    if constexpr (parent >= 0) {
      auto link = links.link(j);
      auto at_parent = at_link(links, i, Index<parent>{}, to_parent(link.x(), force, link.outer()));
      links.link(Index<parent>{}).on_joint([&](auto joint) AXIAL_INLINE {
        m.set(i, Index<parent>{}, along_joint(joint, at_parent));
      });
      climb(links, screws, to_parent(screws[Index<parent>{}], at_parent, links.link(Index<parent>{})), i,
            Index<parent>{}, m);
    }
  } else {
    auto carried = force;
    for (int k = j; links.parent_index(k) >= 0; k = links.parent_index(k)) {
      auto link = links.link(k);
      if (k != j) carried = to_parent(screws[k], carried, link);
      const int parent = links.parent_index(k);
      carried = at_link(links, i, parent, to_parent(link.x(), carried, link.outer()));
      links.link(parent).on_joint([&](auto joint) { m.set(i, parent, along_joint(joint, carried)); });
    }
  }
}

/// The composite bodies of all joints.
template <class Links, class Input, class Screws>
AXIAL_INLINE constexpr auto composite_bodies(const Links& links, const Input& in, const Screws& screws) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto own = [&](auto i) AXIAL_INLINE { return own_body(links, loads, i); };
  return inward(links, own, [&](auto i, const auto& body) AXIAL_INLINE {
    auto link = links.link(i);
    auto turned = link.shape(to_parent(screws[i], body, link));
    return InwardResult{turned, link.shape(to_parent(link.x_inboard(), inboard_part(turned), link.outer()))};
  });
}

/// The algorithm over any form of links and the screws at q: sets the entries of joints that move each other, the rest
/// stay as they are. `m.set(i, j, value)` sees structural zeros as such.
template <class Links, class Input, class Screws, class Matrix>
AXIAL_INLINE constexpr void entries(const Links& links, const Input& in, const Screws& screws, Matrix& m) {
  auto bodies = composite_bodies(links, in, screws);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    auto force =
        link.on_joint([&](auto joint) AXIAL_INLINE { return link.shape(unit_force(joint, bodies[i].turned)); });
    link.on_joint([&](auto joint) AXIAL_INLINE {
      m.set(i, i, link.sum(quantity::JointInertia{}, along_joint(joint, force), link.rotor()));
    });
    climb(links, screws, force, i, i, m);
  });
}
/// Writes the mass matrix from q itself, whatever the form in which joint values stand.
struct CompositeMatrix {
  /// the algorithm
  template <class Links, class Input, class Q, class Matrix>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, const Q& q, Matrix& m) {
    entries(links, in, joint_screws(links, in, links.read(q)), m);
  }
};

}  // namespace crba

/// Mass matrix M(q), with the rotor inertias and the payload that the scene names; symmetric positive definite.
/// Source: composite rigid bodies (Walker and Orin 1982) with the spatial-inertia congruence of McMillan and Orin 1995,
/// Table II; underwater with added mass, as 6x6 inertias (Table II, symmetric 6x6). In: q (rad or m). Out: M(i, j).
template <class S, class T>
[[nodiscard]] constexpr MassMatrixOf<S, T> mass_matrix(const Positions<robot_of<S>, T>& q,
                                                       const Inputs<S, T>& in = no_inputs<S, T>()) {
  MassMatrixOf<S, T> m{};
  execute<crba::CompositeMatrix>(links_of<S, T, BaseParameters, recursion::CompositeBodies>(), in, q, m);
  return m;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr MassMatrix<M, T> mass_matrix(const Model<N, F...>& model, const Positions<M, T>& q,
                                                     const Inputs<M, T>& in = no_inputs<M, T>()) {
  MassMatrix<M, T> m{};
  execute<crba::CompositeMatrix>(model.template links<T>(), in, q, m);
  return m;
}

}  // namespace axial

#include <axial/options/end.hpp>
