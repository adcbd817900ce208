// expect: to non-scalar type
#include <axial/fixed/words/round.hpp>

using S = axial::Arithmetic<std::int32_t, true, false>;
axial::Fx<10, S> x{1};
#ifdef MENDED
axial::Fx<20, S> y = axial::round_to<20>(x * x);
#else
axial::Fx<20, S> y = x * x;
#endif
