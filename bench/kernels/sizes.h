#pragma once
// The sizes that kernels run at.

#include <benchmark/benchmark.h>

namespace rinceau::bench {

/// Of Google Benchmark's arguments: the size of the input.
inline int size_of(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

/// Sizes from 1,000 to `largest` by tens, seconds of the whole process, and the growth fitted to them. The inputs are made
/// of so many things as nearly as they can be; what the growth is fitted to is said by set_size().
inline void at_sizes(benchmark::internal::Benchmark* kernel, int largest) {
    kernel->RangeMultiplier(10)->Range(1'000, largest)->Complexity()->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}
inline void to_100000(benchmark::internal::Benchmark* kernel) { at_sizes(kernel, 100'000); }
inline void to_10000(benchmark::internal::Benchmark* kernel) { at_sizes(kernel, 10'000); }

/// How many things the input really has.
inline void set_size(benchmark::State& state, std::size_t size) {
    state.SetComplexityN(static_cast<benchmark::IterationCount>(size));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(size));
}

}  // namespace rinceau::bench
