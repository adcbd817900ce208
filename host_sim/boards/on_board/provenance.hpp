// What figures were measured with: boards' compilers and flags, and the commit.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace host_sim {

/// {"commit": ..., "boards": {<board>: {"compiler": ..., "flags": ...}}}, as far as the build folders tell.
nlohmann::json provenance();

}  // namespace host_sim
