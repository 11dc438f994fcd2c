#pragma once

/// Attribute of functions that are compiled for several processors, selected at run time. The thread
/// sanitizer crashes in the selection, which the loader calls before the sanitizer is ready.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&             \
  !defined(__SANITIZE_THREAD__)
#define STEMWARE_TARGET_CLONES __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define STEMWARE_TARGET_CLONES
#endif
