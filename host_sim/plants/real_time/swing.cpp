#include <host_sim/plants/real_time/measured.hpp>
#include <robots/puma560.hpp>

namespace host_sim::real_time {

std::vector<Row> swing_rows() {
  using R = robots::Puma560;
  std::vector<Row> rows;
  const auto rest = hanging<R>({0.0, 1.5, 1.5, 0.1, 0.2, 0.0});
  auto start = rest;
  for (int i = 0; i < R::chain.size; ++i)
    start[i] += i % 2 == 0 ? 0.15 : -0.15;
  FreeMinute<R>{start, rest}.add(rows, 1e-4);
  return rows;
}

}  // namespace host_sim::real_time
