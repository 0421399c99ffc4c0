#include "device/openhaptics/find_arms.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/openhaptics/contains.h"
#include "tests/support/scratch_folder.h"

namespace underact::device::openhaptics {
namespace {

namespace fs = std::filesystem;

/// A machine with an arm on USB, as its files show it.
class LookForTouch : public testing::Test {
 protected:
  LookForTouch() {
    fs::create_directories(folder.file("usb"));
    fs::create_directories(folder.file("dev"));
    fs::create_directories(folder.file("home/config"));
    where.usb = folder.file("usb");
    where.nodes = folder.file("dev");
    where.home = folder.file("home");
    where.shared = folder.file("shared");
  }
  void plug(const std::string& port, const std::string& vendor, const std::string& product, const std::string& node) {
    const std::string device = "usb/" + port;
    fs::create_directories(folder.file(device));
    folder.write(device + "/idVendor", vendor + "\n");
    folder.write(device + "/idProduct", product + "\n");
    folder.write(device + "/serial", "0042\n");
    const std::string below = node.rfind("tty", 0) == 0 ? ":1.0/tty/" : ":1.0/0003:2988:0304.0001/hidraw/";
    fs::create_directories(folder.file(device + "/" + port + below + node));
  }
  void makeNode(const std::string& node, mode_t mode) {
    folder.write("dev/" + node, "");
    ASSERT_EQ(chmod(folder.file("dev/" + node).c_str(), mode), 0);
  }
  Found theOne(const std::vector<Missing>& library = {}) const {
    const std::vector<Found> found = findArms(where, library);
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? Found{} : found.front();
  }

  test::ScratchFolder folder;
  SearchPaths where;
};

/// Root may do everything; where root runs the tests, it is somebody else for a while.
class AsNobody {
 public:
  explicit AsNobody(const std::string& scratch) {
    if (geteuid() != 0) return;
    fs::permissions(scratch, fs::perms(0755));
    changed_ = setresuid(kNobody, kNobody, 0) == 0;
  }
  ~AsNobody() {
    if (changed_ && setresuid(0, 0, 0) != 0) abort();
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  bool changed_ = false;
};

}  // namespace

TEST_F(LookForTouch, AnArmWithAllThatItNeedsMissesNothing) {
  plug("1-1", "2988", "0302", "ttyACM0");
  makeNode("ttyACM0", 0600);
  const Found one = theOne();
  EXPECT_EQ(one.title, "Touch or Omni on USB, serial 0042");
  EXPECT_TRUE(one.missing.empty()) << one.missing.front().sentence;
}

TEST_F(LookForTouch, FormerIdentitiesAndHidAreArmsTooAndOthersAreNone) {
  plug("1-1", "0301", "2988", "ttyACM0");
  plug("1-2", "2988", "0304", "hidraw0");
  plug("1-3", "046d", "c626", "hidraw1");
  plug("1-4", "0301", "1111", "hidraw2");
  EXPECT_EQ(findArms(where, {}).size(), 2U);
}

TEST_F(LookForTouch, ANodeThatMayNotBeUsedGetsTheRuleThatMendsIt) {
  plug("1-1", "2988", "0302", "ttyACM0");
  plug("1-2", "2988", "0304", "hidraw3");
  makeNode("ttyACM0", 0);
  makeNode("hidraw3", 0400);
  const AsNobody nobody(folder.path());
  const std::vector<Found> found = findArms(where, {});
  ASSERT_EQ(found.size(), 2U);
  for (const Found& one : found) {
    ASSERT_EQ(one.missing.size(), 1U);
    EXPECT_TRUE(contains(one.missing.front().sentence, "You do not have permission to use"));
    EXPECT_TRUE(contains(one.missing.front().command, "ATTRS{idVendor}==\"2988\", TAG+=\"uaccess\""));
    EXPECT_TRUE(contains(one.missing.front().command, "udevadm control --reload"));
  }
}

TEST_F(LookForTouch, ANodeThatIsNotThereIsSaid) {
  plug("1-1", "2988", "0302", "ttyACM7");
  const Found one = theOne();
  ASSERT_EQ(one.missing.size(), 1U);
  EXPECT_TRUE(contains(one.missing.front().sentence, "has not created")) << one.missing.front().sentence;
}

TEST_F(LookForTouch, WithoutAnArmTheDriverIsToldOfWithWhatItMisses) {
  const Found one = theOne({{"No library.", "get it"}});
  EXPECT_EQ(one.title, "Touch, Omni (vendor's driver)");
  ASSERT_EQ(one.missing.size(), 2U);
  EXPECT_EQ(one.missing[0].command, "get it");
  EXPECT_EQ(one.missing[1].command, "lsusb -d 2988:");
}

TEST_F(LookForTouch, SettingsAreInTheHomeOrSharedOrNamed) {
  plug("1-1", "2988", "0302", "ttyACM0");
  makeNode("ttyACM0", 0600);
  fs::remove_all(folder.file("home/config"));
  const Found without = theOne();
  ASSERT_EQ(without.missing.size(), 1U);
  EXPECT_EQ(without.missing[0].command, "export GTDD_HOME=" + folder.file("home"));
  fs::create_directories(folder.file("shared/config"));
  EXPECT_TRUE(theOne().missing.empty());
  fs::remove_all(folder.file("shared/config"));
  where.settings_are_named = true;
  EXPECT_TRUE(theOne().missing.empty());
}

TEST_F(LookForTouch, AMachineWithoutUsbIsLookedAtAllTheSame) {
  where.usb = folder.file("nowhere");
  EXPECT_EQ(theOne().missing.size(), 1U);
}

}  // namespace underact::device::openhaptics
