// Ends what begin.hpp began: from here on the user's options hold again.
#if defined(__GNUC__) && !defined(__clang__)
#ifndef AXIAL_USER_OPTIONS
#pragma GCC pop_options
#endif
#pragma GCC diagnostic pop
#endif
