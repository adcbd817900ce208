// Every duel that there is.
#pragma once

#include <bench/duel.hpp>

namespace bench {

std::vector<Duel> all_duels();

}  // namespace bench
