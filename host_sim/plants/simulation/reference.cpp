#include <host_sim/plants/simulation/reference.hpp>

#include <stdexcept>

#ifdef AXIAL_SUNDIALS

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>
#include <string>

namespace host_sim::simulation {

namespace {

constexpr long most_steps = 1'000'000;

void check(int code, const char* what) {
  if (code < 0) throw std::runtime_error(std::string("SUNDIALS: ") + what + " says " + std::to_string(code));
}

struct Problem {
  const Model& model;
  const Drive<double>& drive;
  long evaluations = 0;
};

/// y is q, then qd.
int rate(realtype time, N_Vector y, N_Vector dy, void* data) {
  auto& problem = *static_cast<Problem*>(data);
  const int n = problem.model.size();
  const double* at = N_VGetArrayPointer(y);
  double* rates = N_VGetArrayPointer(dy);
  Values<double> q{}, qd{}, tau{};
  for (int i = 0; i < n; ++i)
    q[i] = at[i], qd[i] = at[n + i];
  axial::Inputs<Model, double> in;
  Stiffness<double> ignored;
  problem.drive({q, qd, time}, tau, in, ignored);
  const auto a = axial::forward_dynamics(problem.model, q, qd, tau, in);
  ++problem.evaluations;
  for (int i = 0; i < n; ++i)
    rates[i] = qd[i], rates[n + i] = a[i];
  return 0;
}

struct Context {
  SUNContext value = nullptr;
  Context() { check(SUNContext_Create(nullptr, &value), "a context"); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { SUNContext_Free(&value); }
};

struct Free {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
template <class Pointer>
using Owned = std::unique_ptr<std::remove_pointer_t<Pointer>, Free>;

void by_cvode(int formulas, SUNContext context, N_Vector y, double seconds, double tolerance, Problem& problem) {
  const auto free = [](void* p) { CVodeFree(&p); };
  const std::unique_ptr<void, decltype(free)> solver(CVodeCreate(formulas, context), free);
  const Owned<SUNMatrix> matrix(SUNDenseMatrix(N_VGetLength(y), N_VGetLength(y), context));
  const Owned<SUNLinearSolver> linear(SUNLinSol_Dense(y, matrix.get(), context));
  check(CVodeInit(solver.get(), rate, 0.0, y), "CVodeInit");
  check(CVodeSStolerances(solver.get(), tolerance, tolerance), "CVodeSStolerances");
  check(CVodeSetUserData(solver.get(), &problem), "CVodeSetUserData");
  check(CVodeSetLinearSolver(solver.get(), linear.get(), matrix.get()), "CVodeSetLinearSolver");
  check(CVodeSetMaxNumSteps(solver.get(), most_steps), "CVodeSetMaxNumSteps");
  check(CVodeSetStopTime(solver.get(), seconds), "CVodeSetStopTime");
  double reached = 0.0;
  check(CVode(solver.get(), seconds, y, &reached, CV_NORMAL), "CVode");
}

void by_arkode(SUNContext context, N_Vector y, double seconds, double tolerance, Problem& problem) {
  const auto free = [](void* p) { ERKStepFree(&p); };
  const std::unique_ptr<void, decltype(free)> solver(ERKStepCreate(rate, 0.0, y, context), free);
  check(ERKStepSetTableNum(solver.get(), ARKODE_FEHLBERG_13_7_8), "ERKStepSetTableNum");
  check(ERKStepSStolerances(solver.get(), tolerance, tolerance), "ERKStepSStolerances");
  check(ERKStepSetUserData(solver.get(), &problem), "ERKStepSetUserData");
  check(ERKStepSetMaxNumSteps(solver.get(), most_steps), "ERKStepSetMaxNumSteps");
  check(ERKStepSetStopTime(solver.get(), seconds), "ERKStepSetStopTime");
  double reached = 0.0;
  check(ERKStepEvolve(solver.get(), seconds, y, &reached, ARK_NORMAL), "ERKStepEvolve");
}

}  // namespace

bool has_references() { return true; }

Reference reference(ReferenceMethod method, const Model& model, const Motion<double>& start, double seconds,
                    const Drive<double>& drive, double tolerance) {
  const int n = model.size();
  const Context context;
  const Owned<N_Vector> y(N_VNew_Serial(2 * n, context.value));
  double* state = N_VGetArrayPointer(y.get());
  for (int i = 0; i < n; ++i)
    state[i] = start.q[i], state[n + i] = start.qd[i];
  Problem problem{model, drive};
  if (method == ReferenceMethod::arkode_erk)
    by_arkode(context.value, y.get(), seconds, tolerance, problem);
  else
    by_cvode(method == ReferenceMethod::cvode_bdf ? CV_BDF : CV_ADAMS, context.value, y.get(), seconds, tolerance,
             problem);
  Reference result;
  result.evaluations = problem.evaluations;
  for (int i = 0; i < n; ++i)
    result.end.q[i] = state[i], result.end.qd[i] = state[n + i];
  return result;
}

}  // namespace host_sim::simulation

#else

namespace host_sim::simulation {

bool has_references() { return false; }

Reference reference(ReferenceMethod, const Model&, const Motion<double>&, double, const Drive<double>&, double) {
  throw std::runtime_error("this build has no SUNDIALS; install libsundials-dev and configure anew");
}

}  // namespace host_sim::simulation

#endif
