// The status line beside an arm that can be guarded.
#include "app/gui/feature/status_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <QLabel>

#include "core/servo/host.h"

namespace underact::gui {
namespace {

/// An arm that gives no sample, and can be told zero from outside the program.
class ToldPort final : public servo::DevicePort {
 public:
  ~ToldPort() override { ::close(fd_); }
  bool read(arm::Sample& /*sample*/) noexcept override { return false; }
  void write(const safety::GatedForce& /*force*/) noexcept override {}
  void cut() noexcept override {}
  servo::ZeroForceMessage zeroForceMessage() const override { return {fd_, "0"}; }
  servo::DeviceInfo info() const override { return {"Arm behind a file", false, true}; }

 private:
  int fd_ = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
};

}  // namespace

TEST(StatusLine, AnArmThatNothingGuardsIsSaidInTheStatusLine) {
  servo::HostOptions options;
  options.guard_program = "/there/is/none";
  servo::Host host(std::make_unique<ToldPort>(), options);
  StatusLine line(host, 0.88);
  auto* const guard = line.findChild<QLabel*>("status.guard");
  ASSERT_NE(guard, nullptr);
  EXPECT_TRUE(guard->isHidden()) << "no tick yet";
  host.begin();
  line.present(host.snapshot());
  EXPECT_FALSE(guard->isHidden());
  EXPECT_EQ(guard->text(), "not guarded");
  EXPECT_TRUE(guard->toolTip().startsWith("Nothing guards the arm: ")) << guard->toolTip().toStdString();
}

}  // namespace underact::gui
