#include "core/servo/cpu_load.h"

#include <algorithm>
#include <cstddef>

#include "core/system/thread.h"

namespace underact::servo {

constexpr std::size_t kNumbers = std::size_t{4} << 20U;  // 32 MB: more than the caches hold

CpuLoad::CpuLoad() {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int core = 0; core < cores; ++core) threads_.emplace_back(&CpuLoad::work, this, core);
}

CpuLoad::~CpuLoad() {
  ends_ = true;
  for (std::thread& thread : threads_) thread.join();
}

void CpuLoad::work(int core) {
  system::nameThread("underact-busy");
  system::runOnCore(core);  // where it is refused, the system distributes them
  std::vector<double> numbers(kNumbers, 1.0);
  double sum = 1.0;
  while (!ends_.load(std::memory_order_relaxed)) {
    for (std::size_t at = 0; at < numbers.size() && !ends_.load(std::memory_order_relaxed); ++at) {
      sum = 0.5 * sum + 1.0 / (1.0 + numbers[at]);
      numbers[at] = sum;
    }
    rounds_.fetch_add(1, std::memory_order_relaxed);
  }
}

}  // namespace underact::servo
