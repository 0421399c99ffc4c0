#pragma once
#include <boost/lockfree/spsc_queue.hpp>

namespace underact::servo {

/// Writes to every page of an empty queue once, so that the servo thread has no page fault there.
template <class T>
void touchPages(boost::lockfree::spsc_queue<T>& queue) {
  while (queue.push(T{})) {
  }
  queue.reset();
}

}  // namespace underact::servo
