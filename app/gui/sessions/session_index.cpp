#include "app/gui/sessions/session_index.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <algorithm>
#include <deque>
#include <future>
#include <new>
#include <system_error>

#include "app/gui/kit/words.h"
#include "core/record/untrusted_file.h"

namespace underact::gui {
namespace {

constexpr int kWait_ms = 300;
constexpr qint64 kTellEvery_ms = 250;  // while a folder with many files is read
constexpr qint64 kMillisecond_ns = 1'000'000;
// Each file is read by a process of its own, which is waited for: several at once take a third of the time.
constexpr std::size_t kFilesAtOnce = 4;

QString textOf(const std::string& text) {
  return QString::fromStdString(text);
}

/// Reads the file at the entry's path into it.
void readInto(SessionEntry& entry) {
  Result<record::Session> session = record::Session::open(entry.path.toStdString());
  if (!session) {
    entry.wrong = sentencesOf(session.problems());
    return;
  }
  entry.info = session.value().info();
  entry.markers = session.value().markers();
  entry.faults = static_cast<int>(session.value().faults().size());
  if (!session.value().changes().empty()) entry.first_tick = session.value().changes().front().tick;
}

/// In another thread; if the system cannot start one, when the result is needed.
std::future<SessionEntry> startReading(const QString& path) {
  try {
    return std::async(std::launch::async, readSessionEntry, path);
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, readSessionEntry, path);
  }
}

}  // namespace

qint64 SessionEntry::began_ms() const {
  return isReadable() ? info.header.started_unix_ns / kMillisecond_ns : modified_ms;
}

SessionEntry readSessionEntry(const QString& path) {
  SessionEntry entry;
  const QFileInfo file(path);
  entry.path = path;
  entry.modified_ms = file.lastModified().toMSecsSinceEpoch();
  entry.size_bytes = file.size();
  try {
    readInto(entry);
  } catch (const std::bad_alloc&) {  // no file, whatever it contains, may end the list or the window
    entry.wrong = SessionIndex::tr(
        "There is not enough free memory to read the file. Close other programs, choose another folder, then choose "
        "this one again.");
  }
  return entry;
}

QString titleOf(const SessionEntry& entry) {
  const record::SessionHeader& header = entry.info.header;
  if (!header.words.name.empty()) return textOf(header.words.name);
  return header.scene_title.empty() ? QFileInfo(entry.path).fileName() : textOf(header.scene_title);
}

bool fitsSearch(const SessionEntry& entry, const QString& text) {
  const record::SessionHeader& header = entry.info.header;
  QStringList given{QFileInfo(entry.path).fileName(),
                    QDateTime::fromMSecsSinceEpoch(entry.began_ms()).toString("d MMM yyyy yyyy-MM-dd hh:mm")};
  for (const std::string& one : {header.words.name, header.words.notes, header.words.tags, header.words.subject,
                                 header.words.consent, header.scene_title, header.arm, header.device})
    given << textOf(one);
  for (const record::Marker& marker : entry.markers) given << textOf(marker.label);
  const QString all = given.join('\n');
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(),
                     [&all](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}

SessionIndex::SessionIndex(QObject* parent) : QObject(parent) {
  soon_.setSingleShot(true);
  soon_.setInterval(kWait_ms);
  connect(&soon_, &QTimer::timeout, this, &SessionIndex::refresh);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, [this] { soon_.start(); });
}

SessionIndex::~SessionIndex() {
  cancelled_ = true;
  if (reader_.joinable()) reader_.join();
}

void SessionIndex::setFolder(const QString& folder) {
  if (folder != folder_) entries_.clear();
  folder_ = folder;
  refresh();
}

void SessionIndex::refresh() {
  if (folder_.isEmpty()) return;  // not set yet
  if (isReading()) {
    again_ = true;
    return;
  }
  if (!watcher_.directories().isEmpty() && watcher_.directories() != QStringList{folder_})
    watcher_.removePaths(watcher_.directories());
  if (watcher_.directories().isEmpty() && QFileInfo(folder_).isDir()) watcher_.addPath(folder_);
  QHash<QString, SessionEntry> known;
  for (const SessionEntry& entry : entries_) known.insert(entry.path, entry);
  reader_ = std::thread([this, folder = folder_, known, busy = busy_] { read(folder, known, busy); });
}

/// In the reader thread.
void SessionIndex::read(const QString& folder, const QHash<QString, SessionEntry>& known, const QString& busy) {
  std::vector<SessionEntry> entries;
  const auto tell = [&](bool last) {
    std::sort(entries.begin(), entries.end(),
              [](const SessionEntry& a, const SessionEntry& b) { return a.began_ms() > b.began_ms(); });
    QMetaObject::invokeMethod(
        this, [this, entries, last] { take(entries, last); }, Qt::QueuedConnection);
  };
  std::deque<std::future<SessionEntry>> coming;
  const auto takeFirst = [&] {
    entries.push_back(coming.front().get());
    coming.pop_front();
  };
  QElapsedTimer told;
  told.start();
  for (const QFileInfo& file : QDir(folder).entryInfoList({"*.h5"}, QDir::Files, QDir::Time)) {
    if (cancelled_) break;
    const QString path = file.absoluteFilePath();
    if (path == busy) continue;
    const auto before = known.constFind(path);
    const bool same = before != known.constEnd() && before->size_bytes == file.size() &&
                      before->modified_ms == file.lastModified().toMSecsSinceEpoch();
    if (same) {
      entries.push_back(*before);
    } else {
      coming.push_back(startReading(path));
    }
    if (coming.size() == kFilesAtOnce) takeFirst();
    if (told.elapsed() < kTellEvery_ms) continue;
    tell(false);
    told.restart();
  }
  while (!coming.empty()) takeFirst();
  tell(true);
}

void SessionIndex::take(std::vector<SessionEntry> entries, bool last) {
  if (last) reader_.join();
  // Until the folder is read to its end, the entries known before are kept.
  if (last || entries.size() > entries_.size()) entries_ = std::move(entries);
  emit changed();
  if (last && std::exchange(again_, false)) refresh();
}

const SessionEntry* SessionIndex::find(const QString& path) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&path](const SessionEntry& one) { return one.path == path; });
  return found == entries_.end() ? nullptr : &*found;
}

}  // namespace underact::gui
