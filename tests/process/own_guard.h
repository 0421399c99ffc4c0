#pragma once
#include <filesystem>
#include <string>

#include "tests/support/scratch_folder.h"

namespace underact::test {

/// underact-guard in a place where it can be taken away.
class OwnGuard {
 public:
  OwnGuard() : path_(scratch_.file("underact-guard")) { std::filesystem::copy_file(UNDERACT_GUARD, path_); }
  const std::string& path() const { return path_; }
  void hide() const { std::filesystem::rename(path_, path_ + ".away"); }
  void bringBack() const { std::filesystem::rename(path_ + ".away", path_); }

 private:
  test::ScratchFolder scratch_;
  std::string path_;
};

}  // namespace underact::test
