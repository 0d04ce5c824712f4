// What of the library other libraries see: the declarations of headers that are installed.
// Everything else is hidden in it.
#pragma once

#if defined(__GNUC__) && !defined(_WIN32)
#define WARPLUT_PUBLIC [[gnu::visibility("default")]]
#define WARPLUT_HIDDEN [[gnu::visibility("hidden")]]
#else
#define WARPLUT_PUBLIC
#define WARPLUT_HIDDEN
#endif
