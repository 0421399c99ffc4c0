// A list of the folder finds a new session's file before anything is in it, again and again, and holds it for a moment.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "core/record/session_writer.h"
#include "tests/support/scratch_folder.h"

namespace underact::record {

TEST(NewSession, IsMadeThoughItsFileIsLookedAtJustThen) {
  constexpr int kTimes = 200;
  const test::ScratchFolder folder;
  const auto nameOf = [&folder](int time) { return folder.file("s" + std::to_string(time) + ".h5"); };
  std::atomic<int> next{0}, looked_at{0};
  std::thread list([&] {
    while (next < kTimes) {
      const int fd = ::open(nameOf(next).c_str(), O_RDONLY | O_CLOEXEC);
      if (fd < 0) continue;
      if (::flock(fd, LOCK_SH | LOCK_NB) == 0) ++looked_at;
      ::close(fd);
    }
  });
  for (; next < kTimes; ++next) {
    const auto made = SessionWriter::create(nameOf(next), {});
    EXPECT_TRUE(made) << next << ": " << (made ? "" : made.problems().front().sentence);
  }
  list.join();
  EXPECT_GT(looked_at, 0);
}

}  // namespace underact::record
