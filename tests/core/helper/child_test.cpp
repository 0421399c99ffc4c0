#include "core/helper/child.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>

namespace underact::helper {

TEST(Child, IsNotStartedWhereThereIsNoDescriptorLeftToGiveIt) {
  const int null_fd = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ASSERT_GE(null_fd, 0);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none_left{static_cast<rlim_t>(null_fd) + 1, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none_left), 0);
  const Child child({.program = "/bin/true", .argument = {}, .input_fd = null_fd, .output_fd = null_fd});
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_FALSE(child.runs());  // it would have this program's own input and output
  EXPECT_TRUE(child.error() == EMFILE || child.error() == EINVAL) << child.error();
  ::close(null_fd);
}

}  // namespace underact::helper
