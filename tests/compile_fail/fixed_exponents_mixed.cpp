// expect: to non-scalar type
#include <axial/fixed/words/round.hpp>

using S = axial::Arithmetic<std::int32_t, true, false>;
axial::Fx<20, S> x{1};
#ifdef MENDED
axial::Fx<21, S> y = axial::round_to<21>(x);
#else
axial::Fx<21, S> y = x;
#endif
