// expect: the length of a pointer is given by axial::pointed<N>(pointer)
// within: 5 lines
// at most: 12 lines
#include <axial/axial.hpp>
#include <robots/scara.hpp>

#ifdef MENDED
constexpr auto values(const float* q) { return axial::pointed<3>(q); }
#else
constexpr auto values(const float* q) { return q; }
#endif

auto effort(axial::FeedforwardState<robots::Scara, float>& state, const float* q) {
  return axial::feedforward<robots::Scara>(state, values(q), values(q), values(q));
}
