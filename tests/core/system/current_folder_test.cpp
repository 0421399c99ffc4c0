#include "core/system/current_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace underact::system {
namespace {

TEST(CurrentFolder, IsLeftOutOfAListOfFolders) {
  EXPECT_EQ(absoluteFolders("/usr/bin:/bin"), "/usr/bin:/bin");
  EXPECT_EQ(absoluteFolders(":/usr/bin"), "/usr/bin");
  EXPECT_EQ(absoluteFolders("/usr/bin:"), "/usr/bin");
  EXPECT_EQ(absoluteFolders("/usr/bin::/bin"), "/usr/bin:/bin");
  EXPECT_EQ(absoluteFolders(".:/usr/bin:./bin:../bin:bin:~/bin:/bin"), "/usr/bin:/bin");
  for (const char* nothing : {"", ":", ".", ".:", "::", "bin"}) EXPECT_EQ(absoluteFolders(nothing), "") << nothing;
}

/// In a process of its own: the environment is the whole process's.
int after(const char* name, const char* value, const char* wanted) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv(name, value, 1);
    keepOutCurrentFolder();
    const char* const now = std::getenv(name);
    ::_exit(now == nullptr ? (wanted == nullptr ? 0 : 1) : (wanted != nullptr && std::string(now) == wanted ? 0 : 2));
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  return status;
}

TEST(CurrentFolder, IsKeptOutOfTheEnvironment) {
  EXPECT_EQ(after("PATH", ":/usr/bin", "/usr/bin"), 0);
  EXPECT_EQ(after("PATH", "", "/usr/local/bin:/usr/bin:/bin"), 0) << "an empty list is one empty element";
  EXPECT_EQ(after("PATH", ".", "/usr/local/bin:/usr/bin:/bin"), 0)
      << "no PATH at all would mean another for each shell";
  EXPECT_EQ(after("QT_PLUGIN_PATH", "plugins", nullptr), 0);
  EXPECT_EQ(after("LD_LIBRARY_PATH", ":/opt/lib", "/opt/lib"), 0);
  EXPECT_EQ(after("PYTHONUSERBASE", "/home/t/.local", "/home/t/.local"), 0);
  EXPECT_EQ(after("HOME", ".", "."), 0) << "no place of code";
}

}  // namespace
}  // namespace underact::system
