#pragma once
#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace underact::mesh {

/// Calls work(begin, end) for pieces of [0, count), in as many threads as there are processors. The result for an index
/// must not depend on the others. Not for the servo thread.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  constexpr std::size_t kWorthAThread = 4096;
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t threads = std::clamp<std::size_t>(count / kWorthAThread, 1, processors);
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < threads; ++k)
    others.emplace_back([&work, count, threads, k] { work(count * k / threads, count * (k + 1) / threads); });
  work(std::size_t{0}, count / threads);
  for (std::thread& other : others) other.join();
}

}  // namespace underact::mesh
