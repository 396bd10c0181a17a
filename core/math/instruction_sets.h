// SPDX-License-Identifier: Apache-2.0
// Choosing among versions of a kernel at run time, so that one build runs everywhere. The choice is the same
// for the whole run: results repeat to the bit.
#pragma once

/// Stands before a loop in which no pass depends on an earlier one; the compiler cannot see that by itself.
#if defined(__clang__)
#define NOCTULE_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define NOCTULE_INDEPENDENT _Pragma("GCC ivdep")
#endif

#if defined(__x86_64__)
#include <immintrin.h>
#define NOCTULE_AVX2 __attribute__((target("avx2,fma")))
#if defined(__clang__)  // clang does not know a wish for a width
#define NOCTULE_AVX512 __attribute__((target("avx512f,avx2,fma")))
#else
#define NOCTULE_AVX512 __attribute__((target("avx512f,avx2,fma,prefer-vector-width=512")))
#endif

namespace noctule {

inline bool hasAvx2() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
}

inline bool hasAvx512() {
    static const bool has = hasAvx2() && __builtin_cpu_supports("avx512f");
    return has;
}

}  // namespace noctule
#endif
