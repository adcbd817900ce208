// The exponential of a matrix, for the reference of a regulator.
#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

namespace regulator_reference {

Eigen::MatrixXd exponential(const Eigen::MatrixXd& m);
Eigen::MatrixXd exponential(const Eigen::MatrixXd& m) { return m.exp(); }

}  // namespace regulator_reference
