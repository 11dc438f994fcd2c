#pragma once

/// Attribute of functions that are compiled for several processors, selected at run time.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define STEMWARE_TARGET_CLONES __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define STEMWARE_TARGET_CLONES
#endif
