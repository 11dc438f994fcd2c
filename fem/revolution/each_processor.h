#pragma once

/// Mark of a function whose loops are compiled for several kinds of processors; the program takes those of
/// the one that it runs on.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define STEMWARE_FOR_EACH_PROCESSOR __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define STEMWARE_FOR_EACH_PROCESSOR
#endif
