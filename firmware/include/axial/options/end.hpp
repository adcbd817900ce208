// Ends what begin.hpp began: from here on the user's options hold again.
#if defined(__GNUC__) && !defined(__clang__) && !defined(AXIAL_USER_OPTIONS)
#pragma GCC pop_options
#endif
