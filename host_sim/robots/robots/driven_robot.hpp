// A robot as the oracle sees it, with the drives that its joints share.
#pragma once

#include <axial/axial.hpp>
#include <oracle/driven.hpp>
#include <oracle/from_axial.hpp>

namespace host_sim {

/// A robot by what its joint values belong to: its links, or its drives where joints share them.
template <class R>
using DrivesOf = typename axial::scene_of<R>::Robot;

/// The chain of a robot in numbers T, with its drives. G is what the library reads from the links' words, so tests hold
/// it to matrices written by hand.
template <class T, class R>
oracle::DrivenChain<T> driven_robot() {
  const auto chain = oracle::of_robot<T, R>();
  if constexpr (!axial::detail::shares_drives_in<DrivesOf<R>>) {
    return oracle::DrivenChain<T>(chain);
  } else {
    constexpr auto& g = axial::detail::drive_matrix<R>;
    oracle::Drives<T> drives{oracle::Matrix<T>(R::chain.size, g.drives), {}, {}};
    for (int i = 0; i < R::chain.size; ++i) {
      drives.q0.push_back(T(g.offset[i]));
      for (int k = 0; k < g.drives; ++k)
        drives.g(i, k) = T(g.ratio[i][k]);
    }
    for (int k = 0; k < g.drives; ++k) {
      const auto& link = chain[g.owner[k]];
      drives.inertia.push_back(link.gear * link.gear * link.rotor_inertia);
    }
    return oracle::DrivenChain<T>(chain, std::move(drives));
  }
}

}  // namespace host_sim
