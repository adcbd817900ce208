// Nothing allocates: every way to the heap is trapped while the kernels run.
#include <cstdlib>
#include <new>
#include <robots/robots.hpp>

#include <property/support.hpp>

namespace {
bool trapped = false;
int allocations = 0;
}  // namespace

// Not inlined: GCC 12 would see malloc behind new and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (trapped) ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

struct Trap {
  Trap() { trapped = true, allocations = 0; }
  ~Trap() { trapped = false; }
};

template <class R>
float run_everything() {
  axial::Joints<R, float> q{}, qd{}, qdd{};
  for (int i = 0; i < R::chain.size; ++i)
    q[i] = 0.1F, qd[i] = 0.2F, qdd[i] = 0.3F;
  axial::FeedforwardState<R, float> state;
  const auto tau = axial::feedforward<R>(state, q, qd, qdd).tau;
  const auto looped = axial::inverse_dynamics<axial::Scene<R, axial::Gravity, axial::Looped>>(q, qd, qdd);
  const auto acceleration = axial::forward_dynamics<R>(q, qd, tau);
  const auto m = axial::mass_matrix<R>(q);
  const auto tool = axial::forward_kinematics<R>(q).tool;
  return tau[0] + looped[0] + acceleration[0] + m(0, 0) + tool.position.x + axial::jacobian<R>(q)[0].linear.y;
}

}  // namespace

TEST(NoAllocation, TheTrapWorks) {
  Trap trap;
  ::operator delete(::operator new(16));
  EXPECT_EQ(allocations, 1);
}

TEST(NoAllocation, KernelsDoNotTouchTheHeap) {
  float sum = 0.0F;
  {
    Trap trap;
    sum = run_everything<robots::Scara>() + run_everything<robots::Puma560>() + run_everything<robots::Panda>();
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_NE(sum, 0.0F);
}
