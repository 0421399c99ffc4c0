// Another process, which finds the library by its search path alone.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace underact::device::openhaptics {
namespace {

std::string printedBy(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

}  // namespace

TEST(OpenHapticsProgram, FindsTheLibraryByTheSearchPathPushesAndEndsAtRest) {
  const std::string folder = std::string(UNDERACT_BINARY) + "/openhaptics";
  EXPECT_EQ(printedBy("env -u UNDERACT_OPENHAPTICS LD_LIBRARY_PATH='" + folder + "' '" UNDERACT_PROGRAM "'"),
            "Touch (vendor's driver)\npushed\nrests\nclosed\n");
}

TEST(OpenHapticsProgram, WithoutTheLibrarySaysWhatIsMissingAndTheCommand) {
  const std::string text = printedBy("env -u UNDERACT_OPENHAPTICS -u LD_LIBRARY_PATH '" UNDERACT_PROGRAM "'");
  EXPECT_NE(text.find("OpenHaptics, is not installed"), std::string::npos) << text;
  EXPECT_NE(text.find("sudo ./install"), std::string::npos) << text;
}

}  // namespace underact::device::openhaptics
