// Ends what begin.hpp began: from here on the user's options hold again.
#if defined(__GNUC__) && !defined(__clang__)
#if !defined(AXIAL_USER_OPTIONS) || defined(AXIAL_OPTIONS_SET_BACK)
#pragma GCC pop_options
#undef AXIAL_OPTIONS_SET_BACK
#endif
#pragma GCC diagnostic pop
#endif
