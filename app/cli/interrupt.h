#pragma once

namespace underact::cli {

/// While one lives, SIGINT and SIGTERM (Ctrl+C) set a flag in place of ending the program, so that results are still
/// printed. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  bool came() const;
};

}  // namespace underact::cli
