#include <algorithm>
#include <memory>

#include "core/record/descriptor_driver.h"
#include "core/record/disk.h"
#include "core/record/recorder.h"
#include "core/record/session.h"

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

Result<std::int64_t> recover(const std::string& path) {
  // The file may come from anybody, so it is checked in the sealed reader first, and then exactly that file is changed.
  Result<UntrustedInput> opened = UntrustedInput::open(path, false);
  if (!opened) return opened.problems();
  const auto input = std::make_shared<const UntrustedInput>(std::move(opened).value());
  const std::int64_t length = lengthToGrowTo(input->bytes(), statedSize(input->fd()));
  {
    const Result<Session> session = Session::open(input, length);
    if (!session) return session.problems();
    if (length == input->bytes() && session.value().info().isComplete() && !session.value().isOpenElsewhere())
      return session.value().info().ticks;
  }  // closed here: it is opened for writing now
  input->unlock();
  return completeFileAt(path, input->fd());
}

}  // namespace underact::record
