#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <regex>
#include <string>

namespace underact::architecture {
namespace {

/// Every library that the program is loaded with, its libraries' libraries among them.
std::string librariesOf(const std::string& program) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(("ldd '" + program + "' 2>&1").c_str(), "r"),
                                                             pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

const std::regex kWindowLibrary("libQt[0-9]|libvtk|libGL|libX11");

TEST(UnderactCli, LinksNeitherQtNorVtk) {
  const std::string libraries = librariesOf(std::string(UNDERACT_BINARY) + "/underact-cli");
  ASSERT_NE(libraries.find("libc.so"), std::string::npos) << libraries;
  EXPECT_FALSE(std::regex_search(libraries, kWindowLibrary)) << libraries;
}

#ifdef UNDERACT_HAS_WINDOW
TEST(Underact, LinksBothSoTheTestAboveCanSee) {
  const std::string libraries = librariesOf(std::string(UNDERACT_BINARY) + "/underact");
  EXPECT_TRUE(std::regex_search(libraries, std::regex("libQt6Widgets"))) << libraries;
  EXPECT_TRUE(std::regex_search(libraries, std::regex("libvtk"))) << libraries;
  EXPECT_FALSE(std::regex_search(libraries, std::regex("libQt5"))) << "Qt 5 and Qt 6 in one process: " << libraries;
}
#endif

}  // namespace
}  // namespace underact::architecture
