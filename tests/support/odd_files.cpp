#include "tests/support/odd_files.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

namespace underact::test {
namespace {

void makeSocket(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(path.size(), sizeof address.sun_path);
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
  EXPECT_EQ(::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << path;
  ::close(fd);
}

}  // namespace

std::vector<OddFile> oddFiles(const ScratchFolder& folder, const std::string& ending) {
  const auto at = [&](const char* name) { return folder.file(name + ending); };
  EXPECT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink(at("pipe"), at("link"));
  makeSocket(at("socket"));
  std::filesystem::create_symlink("/dev/zero", at("zero"));
  std::filesystem::create_directory(at("folder"));
  folder.write("huge" + ending, "");
  std::filesystem::resize_file(at("huge"), std::uint64_t{1} << 40);  // sparse
  return {{"a pipe", at("pipe")},     {"a link to a pipe", at("link")},
          {"a socket", at("socket")}, {"a device that never ends", at("zero")},
          {"a device", "/dev/null"},  {"a folder", at("folder")},
          {"no file", at("none")},    {"1 TiB of nothing", at("huge")}};
}

}  // namespace underact::test
