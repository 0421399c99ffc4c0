#pragma once
#include <unistd.h>

#include <fstream>
#include <string>

namespace underact::test {

/// Bytes of a process that are in memory, as Linux counts them; 0: there is no such process.
inline double residentBytes(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace underact::test
