#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/json/json.h"
#include "core/record/session_tables.h"
#include "core/record/session_writer.h"
#include "core/record/untrusted_file.h"
#include "core/scene/description.h"

namespace underact::record {

/// The properties of a session.
struct SessionInfo {
  std::string path;
  std::string program_version;
  SessionHeader header;
  std::int64_t ticks = 0;     // rows that can be read
  double duration_s = 0.0;    // from the first sample to the last
  std::int64_t dropped = 0;   // ticks that the recorder missed; known if the session ended in order
  std::optional<EndRow> end;  // none: it is being recorded, or was when the program died
  std::int64_t bytes = 0;     // of the file
  Problems damage;            // parts of the small tables that cannot be read
  /// Whether the recording was ended in order, or made whole by recover().
  bool isComplete() const { return end.has_value(); }
};

/// A named moment in a session.
struct Marker {
  std::int64_t tick = 0;
  std::string label;
};

/// Ticks that cannot be read.
struct Gap {
  std::int64_t first_row = 0;
  std::int64_t rows = 0;
};

/// A recorded session, for reading; also one that is still growing, and one whose writer was killed. The file may come
/// from anybody: see UntrustedFile; numbers that no recording can have are refused.
class Session {
 public:
  /// Problems: no such file; not a session; another version of the layout; damaged at its beginning; as
  /// UntrustedFile::open().
  static Result<Session> open(const std::string& path);
  /// Opens a session of an open file. at_least: see accessThrough().
  static Result<Session> open(std::shared_ptr<const UntrustedInput> input, std::int64_t at_least = 0);

  // As they were read by open() or the last refresh(); valid until the next one.
  const SessionInfo& info() const { return info_; }
  const std::vector<ChangeRow>& changes() const { return changes_; }
  const std::vector<Marker>& markers() const { return markers_; }
  const std::vector<servo::FaultMark>& faults() const { return faults_; }
  /// The forces that a program added, in order. None in a session of a version before 0.2.0.
  const std::vector<servo::Push>& pushes() const { return pushes_; }
  /// What was run: the first row all of it, a later one what changed. None in a session of version 0.1.0.
  const std::vector<ProvenanceRow>& provenance() const { return provenance_; }
  /// The system's clocks at some ticks, in order. None in a session of version 0.1.0.
  const std::vector<ClockRow>& clock() const { return clock_; }

  /// The scene of a change, as JSON; empty: the servo had none. Problems: the text is damaged.
  Result<std::string> sceneText(const ChangeRow& change);
  /// A row of provenance(), as it stands in the file: it may not be JSON. Problems: the text is damaged.
  Result<std::string> provenanceText(const ProvenanceRow& row);
  /// A row of provenance(), read. Problems, too: it is not JSON.
  Result<json::Value> provenanceOf(const ProvenanceRow& row);
  /// The scene, read; an empty scene where the servo had none. Problems, too: those of readScene().
  Result<scene::Description> scene(const ChangeRow& change);
  /// The servo's state at the first row. Problems: damaged, or another layout.
  Result<tick::TickState> start(const tick::TickProgram& program);

  /// Ticks of a block; the last one may have fewer.
  std::int64_t blockRows() const { return file_.blockRows(kTicks); }
  /// Blocks of ticks that can be read, damaged ones included.
  std::int64_t blocks() const { return (info_.ticks + blockRows() - 1) / blockRows(); }
  /// Whole blocks of ticks; a damaged one has no bytes.
  Result<std::vector<Block>> readTicks(std::int64_t first_block, std::int64_t count);
  /// Blocks of any table, as readTicks(); of /truth and /constraints, say, which are asked for.
  Result<std::vector<Block>> readBlocks(TableIndex table, std::int64_t first_block, std::int64_t count) {
    return file_.read(table, first_block, count);
  }
  /// Whether an arm in it has more than six joints.
  bool hasMoreJoints() const { return file_.rows(kJoints) > 0; }
  /// Rows of any table.
  std::int64_t rows(TableIndex table) const { return file_.rows(table); }
  /// Calls visit() for each block in order, and damaged() for each damaged one, until visit() returns false. progress:
  /// 0 to 1; may be empty.
  Problems eachBlock(const std::function<bool(const Block&, std::int64_t first_row)>& visit,
                     const std::function<void(const Gap&)>& damaged, const std::function<void(double)>& progress = {});
  /// Takes in what was written since it was opened or last refreshed.
  void refresh();
  /// Whether its writer had not closed it when it was opened: it is being recorded, or the program was killed.
  bool isOpenElsewhere() const { return file_.isOpenElsewhere(); }

 private:
  explicit Session(UntrustedFile file) : file_(std::move(file)) {}
  Problems readInfo(const std::string& path);
  void readSmallTables();
  Problem unreadable(TableIndex table) const;
  void readSteering();
  void findJoints();
  void addJoints(std::int64_t first_block, std::vector<Block>& ticks);
  Result<std::vector<std::byte>> bytesOf(TableIndex table, std::int64_t begin, std::int64_t end);
  Result<std::string> words(const Words& words);
  template <class Row>
  std::vector<Row> rowsOf(TableIndex table);

  UntrustedFile file_;
  SessionInfo info_;
  std::vector<ChangeRow> changes_;
  std::vector<Marker> markers_;
  std::vector<servo::FaultMark> faults_;
  std::vector<servo::Push> pushes_;
  std::vector<ProvenanceRow> provenance_;
  std::vector<ClockRow> clock_;
  std::int64_t joints_from_ = 0;  // the block of ticks that the first block of /joints belongs to
};

}  // namespace underact::record
