#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include "core/arm/model.h"
#include "core/base/result.h"
#include "core/json/object_text.h"
#include "core/record/hdf5_file.h"
#include "core/record/session_tables.h"
#include "core/scene/description.h"

namespace underact::record {

/// What a person states about a session. subject: a code; no name, no date of birth.
struct SessionMetadata {
  std::string name = {};
  std::string notes = {};
  std::string tags = {};  // words separated by commas
  std::string subject = {};
  std::string consent = {};  // what the person agreed to, and how: version and date of a form; empty: not recorded
  friend bool operator==(const SessionMetadata& a, const SessionMetadata& b) = default;
};
/// Its texts by their names in a file.
inline constexpr std::array<std::pair<const char*, std::string SessionMetadata::*>, 5> kMetadata{
    {{"name", &SessionMetadata::name},
     {"notes", &SessionMetadata::notes},
     {"tags", &SessionMetadata::tags},
     {"subject", &SessionMetadata::subject},
     {"consent", &SessionMetadata::consent}}};

/// The clock of the gate's ramps, slew, heat and frozen time: the servo's own periods, or, as in version 0.1.0, the
/// arm's clock.
enum class GateTime : std::uint8_t { Servo, Arm };

/// What is known at the start of a session.
struct SessionHeader {
  SessionMetadata words;
  std::string scene_title;
  std::string arm{arm::kDefaultArm};
  std::string arm_file = std::string(arm::fileOf(arm::kDefaultArm));  // its content
  std::string device;
  std::string scheduling;
  std::int64_t started_unix_ns = 0;
  std::int64_t rate_hz = 1000;
  double frozen_s = 0.0;
  int max_late = 20;
  GateTime gate_time = GateTime::Servo;
  double block_s = kBlock_s;
  double force_share = 1.0;          // of the arm's continuous force that the servo was limited to
  std::string session_id = {};       // a word that no other session has; that of a version before 0.2.0: empty
  json::ObjectText provenance = {};  // what was run, without what the scene says: see provenanceOf()
  bool details = false;              // the tables /truth and /constraints
};

/// Writes a session, block by block, and none that a reader refuses: what does not fit into the limits is a problem.
/// One thread at a time. After a failure nothing more is written, and each call reports it again.
class SessionWriter {
 public:
  /// A file that its owner alone may read and write. Problems: one of that name exists, unless it is to be replaced; it
  /// cannot be made.
  static Result<SessionWriter> create(const std::string& path, const SessionHeader& header,
                                      system::Existing existing = system::Existing::Refuse,
                                      const SessionLimits& limits = kSessionLimits);
  /// To be called once, before the first tick. A servo without a scene has the scene without constraints.
  Problems begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state,
                 const scene::Description& scene);
  /// To be called before the tick from which it is in effect.
  Problems add(const servo::Change& change, const scene::Description& scene);
  Problems add(const servo::TickRecord& record);
  Problems add(const servo::FaultMark& fault);
  /// Writes what changes: a force that is asked for again before it ends gets a row that ends only with a later one.
  Problems add(const servo::Push& push);
  // Only where header.details was set.
  Problems add(const servo::TruthRow& row);
  Problems add(const servo::ConstraintRow& row);
  Problems add(const ClockRow& row);
  /// From this tick on these members of the provenance are others.
  Problems addProvenance(std::int64_t tick, const json::ObjectText& changed);
  /// Writes a marker. A label longer than may be is cut between two characters.
  Problems mark(std::int64_t tick, std::string_view label);
  /// Makes full blocks readable by others; they then outlive the program.
  Problems flush();
  /// Writes the remaining rows and the end, and closes the file.
  Problems end(const EndRow& row);
  /// Closes the file as it is.
  void abandon() { file_.close(); }
  std::int64_t ticks() const { return ticks_; }
  /// Of these, the ones in whole blocks of the file; after end() all that there are.
  std::int64_t savedTicks() const { return rows_[kTicks]; }
  /// Whether the disk is full: no more is written, and end() closes the file in order.
  bool isFull() const { return file_.isFull(); }
  /// Whether something did not fit into the limits; end() closes the file in order.
  bool isAtLimit() const { return is_at_limit_; }
  /// How full the fullest table is: 1 is a limit.
  double fill() const;
  /// Whether one more marker, with this label, fits.
  bool hasRoomFor(std::string_view label) const;

 private:
  SessionWriter(Hdf5File file, const SessionHeader& header, const SessionLimits& limits);
  Problems append(TableIndex table, const Block& block);
  Problems limitMet(TableIndex table);
  std::string_view cut(std::string_view label) const;
  Problems addPush(const servo::Push& push);
  Problems endPush(std::int64_t tick);
  Problems addScene(std::int64_t tick, std::uint64_t revision, tick::Carry carry, const scene::Description& scene);
  Words addText(std::string_view text, Problems& problems);
  void addMoreJoints(const servo::TickRecord& record);
  Problems writeTicks();
  Problems writeFull(Packer& packer, TableIndex table);

  Hdf5File file_;
  arm::Geometry geometry_;                                   // of the last tick's arm
  std::deque<std::pair<std::int64_t, arm::Geometry>> arms_;  // that come, with their first ticks: told before these
  std::int64_t block_rows_;
  Packer packer_, truths_, constraints_, joints_;
  json::ObjectText provenance_;  // for the first row
  std::string by_scene_;         // the last row's members that the scene says
  std::int64_t ticks_ = 0, last_tick_ = 0, text_bytes_ = 0;
  bool unflushed_ = false, has_joints_ = false;
  SessionLimits limits_;
  std::array<std::int64_t, kTables> rows_{};  // that were appended
  std::int64_t label_bytes_ = 0;
  bool is_at_limit_ = false;
  servo::Push push_;                                    // the force of the last row of that kind
  std::int64_t push_ends_ = 0, written_push_ends_ = 0;  // its first tick without: in truth, and by that row
};

/// Replaces those attributes of a session. Problems: the file cannot be written (it may be being recorded).
Problems rewriteMetadata(const std::string& path, const SessionMetadata& words);

}  // namespace underact::record
