// Run-time models of random chains and trees, beside the oracle's description of each.
#pragma once

#include <gtest/gtest.h>
#include <cases/to_axial.hpp>

#include <property/support.hpp>

namespace property {

/// Calls f(random, model, chain, n) for `count` random chains and as many trees of up to `most_joints` joints, the
/// chain in 113 bits; it tells whether it compared an answer that is called ok, which two of three have to be.
template <class M, class F>
void expect_on_random_models(unsigned seed, int count, int most_joints, const F& f) {
  for (const bool tree : {false, true}) {
    oracle::RandomChains random(tree ? seed + 1 : seed);
    int compared = 0;
    for (int k = 0; k < count; ++k) {
      const int n = 1 + random.below(most_joints);
      SCOPED_TRACE(testing::Message() << (tree ? "tree " : "chain ") << k << " of " << n);
      const auto described = tree ? random.tree(n) : random.chain(n);
      const bool ok = f(random, cases::to_model<M>(described), oracle::convert<oracle::quad>(described), n);
      compared += ok ? 1 : 0;
    }
    EXPECT_GE(3 * compared, 2 * count) << compared << " of " << count << " answers are called ok";
  }
}

}  // namespace property
