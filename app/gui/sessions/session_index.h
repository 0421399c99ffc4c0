#pragma once
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QHash>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <thread>
#include <vector>

#include "core/record/session.h"

namespace underact::gui {

/// A session of the folder, as read from its file.
struct SessionEntry {
  QString path;
  qint64 modified_ms = 0;  // since 1970; with the size it shows whether the file has changed
  qint64 size_bytes = 0;
  record::SessionInfo info;
  std::vector<record::Marker> markers;
  std::int64_t first_tick = 0;  // of its rows: the times of markers count from it
  int faults = 0;
  QString wrong;  // why it cannot be read; empty: readable
  bool isReadable() const { return wrong.isEmpty(); }
  /// It was closed properly, or recovered since.
  bool isClosed() const { return isReadable() && info.isComplete(); }
  /// When it was recorded; if it cannot be read, when it was last written.
  qint64 began_ms() const;
};

/// Reads one file. Any thread.
SessionEntry readSessionEntry(const QString& path);

/// Its title in a list: its name, else its scene, else its file.
QString titleOf(const SessionEntry& entry);

/// Every word of text occurs in the metadata of the session or in its date; case is ignored.
bool fitsSearch(const SessionEntry& entry, const QString& text);

/// The sessions of a folder, newest first. They are read in a separate thread, each once, and again when its file
/// changes.
class SessionIndex : public QObject {
  Q_OBJECT
 public:
  explicit SessionIndex(QObject* parent);
  ~SessionIndex() override;
  /// Reads the folder, and again whenever it changes. busy: a file that this program is writing; it is left out.
  void setFolder(const QString& folder);
  void setBusy(const QString& path) { busy_ = path; }
  /// Reads what has changed.
  void refresh();
  const std::vector<SessionEntry>& entries() const { return entries_; }
  const SessionEntry* find(const QString& path) const;
  bool isReading() const { return reader_.joinable(); }

 signals:
  void changed();

 private:
  void read(const QString& folder, const QHash<QString, SessionEntry>& known, const QString& busy);
  void take(std::vector<SessionEntry> entries, bool last);

  QString folder_, busy_;
  QFileSystemWatcher watcher_;
  QTimer soon_;  // combines many changes in a row
  std::vector<SessionEntry> entries_;
  std::thread reader_;
  std::atomic<bool> cancelled_{false};
  bool again_ = false;
};

}  // namespace underact::gui
