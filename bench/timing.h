// How long work takes, and what is typical of several times.
#pragma once

#include <chrono>
#include <vector>

namespace prairie {

/// The value below which the given share of the values lies; at least one value.
double quantile(std::vector<double> values, double share);
double median(const std::vector<double>& values);

template <typename Work>
double elapsed_ms(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Median of `step(0)`, `step(1)`, …, each of which returns the milliseconds that it took.
template <typename Step>
double median_ms(int steps, const Step& step) {
  std::vector<double> times_ms;
  for (int n = 0; n < steps; ++n) times_ms.push_back(step(n));
  return median(times_ms);
}

}  // namespace prairie
