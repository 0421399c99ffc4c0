#pragma once

namespace underact::test {

/// Counts what this thread allocates, frees and locks while it lives. Eigen calls malloc itself, past operator new, so
/// it is malloc that is counted.
class Watch {
 public:
  Watch();
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  long allocations() const;
  long frees() const;
  long locks() const;
};

}  // namespace underact::test
