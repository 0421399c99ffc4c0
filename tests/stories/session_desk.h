#pragma once
#include <QListWidget>
#include <QTemporaryDir>
#include <QVariantMap>
#include <memory>

#include "tests/stories/story.h"

namespace underact::gui::test {

/// A window with the Sessions panel open, whose recordings go into a folder of the story's own.
struct Desk {
  /// settings: what the user has set besides ("recording/subject").
  explicit Desk(const QVariantMap& settings = {});
  QStringList files() const;  // the sessions that are there
  QString file(const QString& name) const { return folder.filePath(name); }
  QString text(const char* label);
  QListWidget& list() { return *story->find<QListWidget>("panel.sessions.list"); }
  int shown();  // rows of the list
  /// Types over what stands in a field.
  void fill(const char* field, const QString& text);
  /// Begins or ends a recording. false: that did not come about.
  bool record(bool on);
  /// A session of so many ticks; gives its path.
  QString session(int ticks, const QString& name = {});
  // These wait until it is so.
  bool listed(int count);
  bool choose(const QString& path);

  QTemporaryDir folder;
  std::unique_ptr<Story> story;
};

/// A session "killed" of 250 ticks that nobody closed: what the program leaves when it is killed. Gives its path.
QString unclosed(const QString& folder, const QString& name);

}  // namespace underact::gui::test
