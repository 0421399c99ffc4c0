#include "tests/stories/story.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <optional>

#include "tests/stories/held_paints.h"
#include "tests/stories/picture_difference.h"

namespace underact::gui::test {
namespace {

constexpr int kTicksAFrame = 250, kTicksAPaint = 1000;
constexpr QSize kPictureSize(640, 480);  // of the view: the same whatever the fonts make of the docks

QTemporaryDir& folder() {
  static QTemporaryDir kFolder;
  return kFolder;
}

}  // namespace

QString shippedScene(const QString& name) {
  return QString(UNDERACT_SOURCE) + "/scenes/" + name + ".json";
}

QString temporaryFile(const QString& name, const QByteArray& content) {
  const QString path = folder().filePath(name);
  QFile file(path);
  if (!content.isEmpty() && file.open(QIODevice::WriteOnly)) file.write(content);
  return path;
}

void forgetSettings() {
  QSettings().clear();
}

Story::Story(const QString& scene, const Beginning& beginning) : simulated_(makeSimulatedHost(beginning.servo)) {
  {
    const HeldPaints held;
    open(scene, beginning);
  }
  settle();
}

void Story::open(const QString& scene, const Beginning& beginning) {
  if (beginning.first_start) {
    forgetSettings();
    QSettings().setValue("hints/has_pushed", true);  // the welcome has stories of its own
  }
  theme_ = std::make_unique<ThemeWatcher>();
  window_ = std::make_unique<MainWindow>(WindowParts{*simulated_.host, simulated_.arm, *theme_, simulated_.replay,
                                                     simulated_.chosen, beginning.hands, beginning.busy_limit_s},
                                         beginning.features);
  if (beginning.first_start) window_->resize(beginning.size);
  if (beginning.shown) {
    window_->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    window_->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  }
  EXPECT_TRUE(perform("hand.keep", beginning.keeps_holding));
  if (!scene.isEmpty()) {
    EXPECT_TRUE(perform("scene.open", scene.contains('/') ? scene : shippedScene(scene)));
  }
  if (beginning.servo.clock == servo::Clock::Manual) run(1);  // a servo always ticks: it knows where the stylus is
}

Story::~Story() {
  window_->document().undoStack().setClean();  // nobody is there to answer what becomes of the edits
  window_->close();
}

void Story::run(int ticks) {
  if (simulated_.host->scheduling().name != "manual") {  // it runs by itself: that many ticks take that long
    QTest::qWait(1000 * ticks / simulated_.host->rateHz());
    return;
  }
  for (int done = 0; done < ticks; done += kTicksAFrame) {
    simulated_.host->run(std::min(kTicksAFrame, ticks - done));
    window_->frame();
  }
  unpainted_ticks_ += ticks;
  std::optional<HeldPaints> held;
  if (unpainted_ticks_ < kTicksAPaint) {
    held.emplace();
  } else {
    unpainted_ticks_ = 0;
  }
  QCoreApplication::processEvents();
}

QWidget* Story::findWidget(const QString& name) {
  for (QWidget* widget : QApplication::allWidgets()) {
    if (widget->objectName() == name) return widget;
  }
  ADD_FAILURE() << "no widget " << name.toStdString();
  return nullptr;
}

void Story::press(QWidget* at, const QPoint& where) {
  const HeldPaints held;
  QTest::mousePress(at->window()->windowHandle(), Qt::LeftButton, {}, at->mapTo(at->window(), where));
}

void Story::moveTo(QWidget* at, const QPoint& where) {
  const HeldPaints held;
  QTest::mouseMove(at->window()->windowHandle(), at->mapTo(at->window(), where));
}

void Story::release(QWidget* at, const QPoint& where) {
  const HeldPaints held;
  QTest::mouseRelease(at->window()->windowHandle(), Qt::LeftButton, {}, at->mapTo(at->window(), where));
}

void Story::click(QWidget* at, const QPoint& where) {
  // The pointer comes before the click, as it does by hand; and no two clicks make a double click.
  moveTo(at, where);
  {
    const HeldPaints held;
    QTest::mouseClick(at->window()->windowHandle(), Qt::LeftButton, {}, at->mapTo(at->window(), where));
  }
  QTest::qWait(QApplication::doubleClickInterval() / 8);
}

void Story::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QWindow* window = QGuiApplication::focusWindow();
  ASSERT_NE(window, nullptr);
  const HeldPaints held;
  QTest::keyClick(window, key, modifiers);
}

void Story::byPalette(const QString& words) {
  perform("help.find");
  auto* const line = find<QLineEdit>("palette.words");
  ASSERT_NE(line, nullptr);
  line->setText(words);
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Return);
  settle();
}

void Story::bringToFront(QWidget* window) {
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window));
  window->activateWindow();
  // Not qWaitForWindowActive(): a dialog counts as active as long as its parent is.
  ASSERT_TRUE(QTest::qWaitFor([window] { return QGuiApplication::focusWindow() == window->windowHandle(); }));
}

void Story::type(QWidget* number, const QString& text) {
  const HeldPaints held;
  number->setFocus(Qt::TabFocusReason);
  key(Qt::Key_A, Qt::ControlModifier);
  for (const QChar letter : text) QTest::keyClick(number->window()->windowHandle(), letter.toLatin1());
  key(Qt::Key_Return);
}

void Story::dragHandTo(const Vec3& p_W, bool hold) {
  constexpr int kSteps = 20;
  const HeldPaints held;
  const QPointF from = view().screenOf(snapshot().report.p_WT);
  const bool holds = arm().setpoint().holds;
  const QPointF offset = view().screenOf(p_W) - (holds ? view().screenOf(arm().setpoint().p_WT) : from);
  press(&view(), from.toPoint());
  for (int step = 1; step <= kSteps; ++step) {
    moveTo(&view(), (from + offset * step / kSteps).toPoint());
    run(50);
  }
  if (!hold) release(&view(), (from + offset).toPoint());
}

void Story::settle(int ms) {
  QTest::qWait(ms);
  EXPECT_TRUE(QTest::qWaitFor([this] { return !view().moving(); }, kLong_ms));  // the camera moves in real time
  window_->frame();
  QTest::qWait(20);
}

QImage Story::picture() {
  settle();
  return window_->grab().toImage();
}

void Story::savePicture(const QString& name) {
  const QString made = QString(UNDERACT_BINARY) + "/pictures";
  QDir().mkpath(made);
  view().clearFocus();
  const QImage image = picture();
  EXPECT_TRUE(image.save(made + "/" + name + ".png"));
  if (qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")) {
    QDir().mkpath(QString(UNDERACT_SOURCE) + "/resources/pictures");
    EXPECT_TRUE(image.save(QString(UNDERACT_SOURCE) + "/resources/pictures/" + name + ".png"));
  }
}

double Story::imageDifference(const QString& name) {
  view().setHint({});
  view().clearFocus();
  QFont no_text = view().font();  // every system has another font
  no_text.setPixelSize(1);
  view().setFont(no_text);
  view().setFixedSize(kPictureSize);
  settle(300);  // a camera on its way arrives in 0.2 s
  const QImage now = view().picture();
  view().setMinimumSize(320, 240);
  view().setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
  return differenceFromReference(now, name);
}

}  // namespace underact::gui::test
