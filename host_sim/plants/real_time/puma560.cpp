#include <host_sim/plants/real_time/measured.hpp>
#include <robots/puma560.hpp>

namespace host_sim::real_time {

std::vector<Row> puma560_rows() {
  std::vector<Row> rows;
  const DrivenSecond<robots::Puma560> second;
  second.add<axial::RungeKutta4>(rows, 1, 1e-5, 1e-4);
  second.add<axial::SemiImplicitEuler>(rows, 10, 1e-4, 1e-4);
  return rows;
}

}  // namespace host_sim::real_time
