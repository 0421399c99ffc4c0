#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "core/base/translate.h"
#include "core/record/descriptor_driver.h"
#include "core/record/disk.h"
#include "core/record/recorder.h"
#include "core/record/session.h"
#include "core/system/file.h"
#include "core/system/private_file.h"

namespace underact::record {
namespace {

/// The rows up to the last readable block.
Result<std::int64_t> wholeRows(Hdf5File& file, std::size_t table) {
  std::int64_t rows = file.rows(table);
  const std::int64_t block_rows = file.blockRows(table);
  while (rows > 0) {
    const std::int64_t last = (rows - 1) / block_rows;
    const Result<std::vector<Block>> block = file.read(table, last, 1);
    if (!block) return block.problems();
    if (!block.value().empty() && !block.value().back().bytes.empty()) break;
    rows = last * block_rows;
  }
  return rows;
}

/// fd: see Hdf5File::reopen().
Result<std::int64_t> completeFileAt(const std::string& path, int fd) {
  const std::array tables = sessionTables(1000);
  Result<Hdf5File> file = Hdf5File::reopen(path, tables, true, fd);
  if (!file) return file.problems();
  EndRow end;
  end.reason = EndReason::Recovered;
  std::int64_t ticks = 0;
  for (std::size_t table = 0; table < kTables; ++table) {
    const Result<std::int64_t> rows = wholeRows(file.value(), table);
    if (!rows) return rows.problems();
    Problems problems = file.value().cut(table, rows.value());
    if (!problems.empty()) return problems;
    if (table != kTicks || rows.value() == 0) continue;
    ticks = rows.value();
    const std::int64_t block_rows = file.value().blockRows(kTicks);
    const Result<std::vector<Block>> last = file.value().read(kTicks, (ticks - 1) / block_rows, 1);
    if (last && !last.value().empty()) end.tick = unpackTicks(last.value().back()).back().tick;
  }
  Problems problems = file.value().append(kEnd, blockOf(end));
  if (problems.empty()) problems = file.value().close();
  if (!problems.empty()) return problems;
  return ticks;
}

}  // namespace

Result<std::int64_t> completeFile(const std::string& path) {
  return completeFileAt(path, -1);
}

namespace {

/// The copy on which a session is recovered; removed unless it was renamed.
struct Copy {
  ~Copy() {
    if (file.isOpen()) std::remove(part.c_str());
  }
  std::string part;
  system::Descriptor file;
};

Problems copyProblem(int reason, const std::string& path) {
  return {
      {phrase(TRANSLATE_NOOP("problem",
                             "Recovering takes a copy of the file in its folder, and there is none: %1. Nothing was "
                             "changed."),
              {std::generic_category().message(reason)}),
       {path}}};
}

}  // namespace

Result<std::int64_t> recover(const std::string& path) {
  // The file may come from anybody, so it is checked in the sealed reader first, and then exactly that file is copied.
  Result<UntrustedInput> opened = UntrustedInput::open(path, false);
  if (!opened) return opened.problems();
  const auto input = std::make_shared<const UntrustedInput>(std::move(opened).value());
  const std::int64_t length = lengthToGrowTo(input->bytes(), statedSize(input->fd()));
  {
    const Result<Session> session = Session::open(input, length);
    if (!session) return session.problems();
    if (length == input->bytes() && session.value().info().isComplete() && !session.value().isOpenElsewhere())
      return session.value().info().ticks;
  }
  if (!system::lock(input->fd(), system::Lock::Alone))  // until the copy has taken its place
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "Another program has this file open. Close it there first.")), {path}}};
  Copy copy{path + ".part", system::makeNew(path + ".part", system::Existing::Replace)};
  const int fd = copy.file.number();
  int reason = copy.file.isOpen() ? system::copyContent(input->fd(), fd) : errno;
  if (reason == 0) reason = system::setRightsLike(fd, input->fd());
  if (reason != 0) return copyProblem(reason, path);
  Result<std::int64_t> ticks = completeFileAt(path, fd);
  Problems unread;
  if (!ticks) {
    unread = ticks.problems();
  } else if (const Result<Session> whole = Session::open(copy.part); !whole) {
    unread = whole.problems();
  }
  if (!unread.empty())
    return Problems{
        {oneAfterAnother({unread.front().sentence,
                          phrase(TRANSLATE_NOOP("problem", "It cannot be recovered; nothing was changed."))}),
         {path}}};
  if (!system::isSameFile(system::statusOf(path, system::Links::Refuse), system::statusOf(input->fd())))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "Another file has taken this one's place in the meantime, so nothing was changed. Try "
                               "again.")),
         {path}}};
  reason = system::putInPlace(std::move(copy.file), copy.part, path, "", system::Lasting::OnDisk);
  if (reason != 0) return copyProblem(reason, path);
  return ticks;
}

}  // namespace underact::record
