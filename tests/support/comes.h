#pragma once
#include <chrono>
#include <thread>

namespace underact::test {

/// Whether the condition comes true within 20 s. Waited for, never measured: the machine may be busy.
template <class Condition>
bool comes(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace underact::test
