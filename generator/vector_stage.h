// Marks a function whose loop over a block of blades the compiler may turn into instructions for 4 or 8 of
// them. AVX2 is used where the processor has it; fused multiply-add, which would round differently, stays off
// (-ffp-contract=off), so that results are the same everywhere.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PRAIRIE_VECTOR_STAGE __attribute__((noinline, flatten, target_clones("arch=x86-64-v3", "default")))
#else
#define PRAIRIE_VECTOR_STAGE
#endif
