#pragma once

/// Marks a function whose loops over a fixed number of lanes are compiled twice, for AVX2 and for
/// the baseline of the platform; the processor decides at run time. Both give the same bits:
/// nothing is contracted or reordered. Its source file is listed in mdbd_vectorised() of the build.
#if defined(__x86_64__) && defined(__has_attribute) && !defined(__SANITIZE_ADDRESS__)
#define MDBD_VECTORISED __attribute__((target_clones("avx2", "default")))
#else
#define MDBD_VECTORISED
#endif

/// Marks what a vectorised function calls, lambdas too, if it is to be compiled for each
/// instruction set: it becomes part of its caller.
#if defined(__has_attribute)
#define MDBD_PART_OF_CALLER __attribute__((always_inline))
#else
#define MDBD_PART_OF_CALLER
#endif

/// Before a loop over lanes: keeps the compiler from unrolling it before it can be vectorised.
#if defined(__GNUC__) && !defined(__clang__)
#define MDBD_LANES _Pragma("GCC unroll 1")
#else
#define MDBD_LANES
#endif
