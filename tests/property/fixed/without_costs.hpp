// What the sequences of firmware/apps take for a counter where there is none.
#pragma once

#include <cstdint>

namespace property {

/// Runs the code; every cost is 0.
struct WithoutCosts {
  template <class Code>
  std::uint32_t operator()(Code& code) const {
    code();
    return 0;
  }
};

}  // namespace property
