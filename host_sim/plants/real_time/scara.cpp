#include <host_sim/plants/real_time/measured.hpp>
#include <robots/scara.hpp>

namespace host_sim::real_time {

std::vector<Row> scara_rows() {
  std::vector<Row> rows;
  const DrivenSecond<robots::Scara> second;
  second.add<axial::RungeKutta4>(rows, 1, 1e-5, 1e-3);
  second.add<axial::SemiImplicitEuler>(rows, 1, 1e-3, 1e-3);
  return rows;
}

}  // namespace host_sim::real_time
