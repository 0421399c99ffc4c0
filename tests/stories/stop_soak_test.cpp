#include <gtest/gtest.h>

#include <QAction>
#include <QDirIterator>
#include <QProcess>
#include <QSettings>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "app/gui/service/live_service.h"
#include "app/gui/window/window_watch.h"
#include "tests/gui/person.h"
#include "tests/stories/story.h"
#include "tests/support/property.h"

// Stop in the window, pressed at random moments while the window's thread is busy with what strangers send and leave
// lying about. A sample looks whether each is heard; a soak (UNDERACT_SOAK=1), which has the machine for itself, how
// soon.
namespace underact::gui::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr double kWithin_ms = 50.0;
constexpr milliseconds kPatience{20'000}, kAgain{500};

enum Means { kShiftEsc, kClick, kEsc, kMeanses };

/// Presses Stop in one of the ways there are, from a thread of its own, when it is told to.
class Presser {
 public:
  Presser(std::atomic<std::uint64_t>& stops, const QPoint& button_px) : stops_(stops), button_px_(button_px) {}
  ~Presser() {
    if (thread_.joinable()) thread_.join();
  }
  Presser(const Presser&) = delete;
  Presser& operator=(const Presser&) = delete;
  /// The window's thread may do what it likes until it is done().
  void press(Means how, microseconds in) {
    is_done_ = false;
    thread_ = std::thread([this, how, in] {
      std::this_thread::sleep_for(in);
      const std::uint64_t before = stops_;
      const Clock::time_point begin = Clock::now();
      for (Clock::time_point next = begin; stops_ == before && Clock::now() < begin + kPatience;) {
        if (Clock::now() >= next) {
          press(how);
          next = how == kEsc ? next + kAgain : begin + kPatience;  // Esc closes what is open first
        }
        std::this_thread::sleep_for(microseconds(200));
      }
      took_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
      is_done_ = true;
    });
  }
  bool isDone() const { return is_done_; }
  double took_ms() {
    thread_.join();
    return took_ms_;
  }

 private:
  void press(Means how) {
    if (how == kShiftEsc) person_.pressWithShift(Person::kEscape);
    if (how == kClick) person_.click(button_px_);
    if (how == kEsc) person_.press(Person::kEscape);
  }

  std::atomic<std::uint64_t>& stops_;
  QPoint button_px_;
  Person person_;
  std::atomic<bool> is_done_{true};
  double took_ms_ = 0.0;
  std::thread thread_;
};

/// Files as strangers leave them, each opened in the window.
QStringList foreignFiles(const QString& folder) {
  const std::vector<std::pair<const char*, QByteArray>> files{
      {"keys.json",
       R"({"underact_scene": 1, "title": "T", )" + QByteArray(R"("a": 1, )").repeated(20'000) + R"("z": 1})"},
      {"about.json", R"({"underact_scene": 1, "title": "<img src='/dev/zero'>", "about": ")" +
                         QByteArray("$x^2$ **a** ").repeated(3'000) +
                         R"(", "constraints": [{"name": "<b>", "type": "point", "position_mm": [0, 0, 0]}]})"},
      {"deep.json", QByteArray("[").repeated(100'000)},
      {"links.urdf", "<robot name='r'>" + QByteArray("<link name='l'/>").repeated(4'000) + "</robot>"},
      {"torn.stl", "solid " + QByteArray("facet normal 0 0 1 ").repeated(10'000)},
      {"session.h5", "\x89HDF\r\n\x1a\n" + QByteArray(50'000, 'x')}};
  QStringList paths{shippedScene("02_sphere"), shippedScene("06_virtual_arm"), "/dev/zero", folder};
  for (const auto& [name, content] : files) {
    QFile file(folder + "/" + name);
    if (file.open(QIODevice::WriteOnly)) file.write(content);
    paths << file.fileName();
  }
  return paths;
}

/// How many sessions are below the folder; each of them must be whole.
int verified(const QString& folder) {
  QStringList sessions, refused;
  for (QDirIterator file(folder, {"*.h5"}, QDir::Files, QDirIterator::Subdirectories); file.hasNext();) {
    sessions << file.next();
    if (QProcess::execute(UNDERACT_CLI, {"log", "verify", sessions.back()}) != 0) refused << sessions.back();
  }
  std::printf("%d sessions, %d refused\n", int(sessions.size()), int(refused.size()));
  EXPECT_EQ(refused, QStringList());
  return int(sessions.size());
}

}  // namespace

TEST(StopSoakStory, StopIsHeardWhateverTheWindowIsBusyWithAndAllThatItRecordsIsWhole) {
  const int trials = underact::test::isSoak() ? 1000 : 12;
  QTemporaryDir folder;
  qputenv("XDG_RUNTIME_DIR", folder.path().toUtf8());
  forgetSettings();
  const QString recordings = folder.filePath("recordings");
  QSettings().setValue("recording/folder", recordings);
  auto story = std::make_unique<Story>("02_sphere", Beginning{.first_start = false,
                                                              .servo = {.watchdog_s = 30.0, .max_late = 1'000'000},
                                                              .busy_limit_s = WindowWatch::kLimit_s});
  story->host().begin();
  auto* const button = story->find("button.session.stop");
  Presser presser(story->host().stops(), button->mapToGlobal(button->rect().center()));
  ASSERT_TRUE(story->perform("service.on", true));
  const auto* const live = story->window().findChild<LiveService*>();
  QProcess strangers;
  strangers.start("/usr/bin/python3", {QString(UNDERACT_SOURCE) + "/tests/python/hostile_clients.py", live->address(),
                                       live->tokenFile(), "3600", "53", "stop"});
  const QStringList files = foreignFiles(folder.path());
  underact::test::Random random(underact::test::Seed{53});
  std::array<double, kMeanses> worst_ms{};
  for (int trial = 0; trial < trials; ++trial) {
    for (QWidget* one : QApplication::topLevelWidgets())
      if (one != &story->window() && one->isVisible()) one->close();
    story->perform("service.take_back", false);
    story->perform("session.start");
    if (trial % 4 == 0) story->perform("session.record", trial % 8 == 0);
    story->bringToFront(&story->window());
    QTest::qWait(60);
    const Means how = static_cast<Means>(trial % kMeanses);
    presser.press(how, microseconds(static_cast<std::int64_t>(random.below(150'000))));
    do {
      switch (random.below(4)) {
        case 0:  // the watchdog of the window ends the force in some
          QThread::msleep(static_cast<unsigned long>(random.below(900)));
          break;
        case 1:
          story->window().document().undoStack().setClean();
          story->perform("scene.open", files[static_cast<int>(random.below(static_cast<std::size_t>(files.size())))]);
          break;
        case 2:
          story->window().grab();
          break;
        default:
          QTest::qWait(static_cast<int>(random.below(50)));
      }
    } while (!presser.isDone());
    const double took_ms = presser.took_ms();
    worst_ms[how] = std::max(worst_ms[how], took_ms);
    ASSERT_LT(took_ms, static_cast<double>(kPatience.count())) << "not heard in trial " << trial;
  }
  strangers.kill();
  strangers.waitForFinished();
  std::printf("%d Stops, heard within %.1f ms; by Esc, which closes what is open first, within %.1f ms\n", trials,
              std::max(worst_ms[kShiftEsc], worst_ms[kClick]), worst_ms[kEsc]);
  if (underact::test::isSoak()) EXPECT_LT(std::max(worst_ms[kShiftEsc], worst_ms[kClick]), kWithin_ms);
  story->window().document().undoStack().setClean();
  story.reset();  // ends what it records
  EXPECT_GE(verified(recordings), trials / 8);
}

}  // namespace underact::gui::test
