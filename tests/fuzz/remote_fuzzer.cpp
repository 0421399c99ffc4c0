#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/remote_judge.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong = underact::test::judgeRemote({data, size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "%s\n", wrong.c_str());
  std::abort();
}
