#include "tests/stories/session_desk.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>

#include "core/record/session_writer.h"

namespace underact::gui::test {

Desk::Desk(const QVariantMap& settings) {
  forgetSettings();
  QSettings stored;
  stored.setValue("recording/folder", folder.path());
  for (auto one = settings.begin(); one != settings.end(); ++one) stored.setValue(one.key(), one.value());
  stored.sync();
  story = std::make_unique<Story>("02_sphere", Beginning{.first_start = false});
  story->window().resize(1280, 800);
  story->perform("dock.sessions", true);
  story->settle();
}

QStringList Desk::files() const {
  return QDir(folder.path()).entryList({"*.h5"}, QDir::Files, QDir::Name);
}

QString Desk::text(const char* label) {
  return story->find<QLabel>(label)->text();
}

int Desk::shown() {
  int count = 0;
  for (int row = 0; row < list().count(); ++row) count += list().item(row)->isHidden() ? 0 : 1;
  return count;
}

void Desk::fill(const char* field, const QString& text) {
  auto* line = story->find<QLineEdit>(field);
  line->setFocus(Qt::TabFocusReason);
  line->selectAll();
  QTest::keyClicks(line, text);
}

bool Desk::record(bool on) {
  // A recording ends between two ticks, and in a story time stands: the next tick comes here.
  if (!on) story->host().endRecord();
  if (!on) story->host().run(1);
  story->perform("session.record", on);
  return story->window().actions().find("session.record")->isChecked() == on;
}

QString Desk::session(int ticks, const QString& name) {
  const QStringList before = files();
  if (!name.isEmpty()) fill("panel.sessions.name", name);
  EXPECT_TRUE(record(true));
  story->run(ticks);
  EXPECT_TRUE(record(false));
  for (const QString& one : files()) {
    if (!before.contains(one)) return file(one);
  }
  ADD_FAILURE() << "no file";
  return {};
}

bool Desk::listed(int count) {
  return QTest::qWaitFor([this, count] { return list().count() == count; }, kLong_ms);
}

bool Desk::choose(const QString& path) {
  return QTest::qWaitFor([this, &path] { return story->perform("sessions.choose", path); }, kLong_ms);
}

QString unclosed(const QString& folder, const QString& name) {
  const QString path = QDir(folder).filePath(name);
  record::SessionHeader header;
  header.scene_title = "Sphere";
  header.words.name = "killed";
  header.started_unix_ns = 1'700'000'000'000'000'000;
  Result<record::SessionWriter> writer = record::SessionWriter::create(path.toStdString(), header);
  EXPECT_TRUE(writer);
  EXPECT_TRUE(writer.value().begin(1, 0, {}, {}).empty());
  servo::TickRecord record;
  for (int tick = 1; tick <= 250; ++tick) {
    record.tick = tick;
    record.time_ns = 1'000'000LL * tick;
    EXPECT_TRUE(writer.value().add(record).empty());
  }
  EXPECT_TRUE(writer.value().flush().empty());
  QFile::copy(path, path + ".killed");  // as it stands on the disk before it is closed
  writer.value().abandon();
  QFile::remove(path);
  QFile::rename(path + ".killed", path);
  return path;
}

}  // namespace underact::gui::test
