#include "core/record/replay.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/base/translate.h"
#include "core/record/laws.h"
#include "core/record/provenance.h"
#include "core/scene/compile.h"
#include "core/scene/load_meshes.h"
#include "core/servo/rerun.h"

namespace underact::record {
namespace {

Result<tick::TickProgram> programOf(scene::Description scene, const SessionHeader& header,
                                    const std::vector<std::string>& files_in) {
  tick::TickProgram bare;  // of a servo without a scene
  bare.geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  if (scene.constraints.empty()) return bare;
  Problems problems = scene::loadRecordedMeshes(scene, files_in);
  if (!problems.empty()) return problems;
  Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return program;
  program.value().limits.max_force_N *= header.force_share;
  program.value().limits.frozen_s = header.frozen_s;
  program.value().limits.max_late = header.max_late;
  return program;
}

/// The period of the servo; 0: its gate used the arm's clock.
std::int64_t periodOf(const SessionHeader& header) {
  return header.gate_time == GateTime::Servo ? 1'000'000'000 / header.rate_hz : 0;
}

bool isMeasured(const Column& column) {
  return column.name == "lateness_us" || column.name == "tick_us";
}

/// The faults that were reported to ticks, tick by tick.
class ToldFaults {
 public:
  explicit ToldFaults(const std::vector<servo::FaultMark>& faults) {
    std::copy_if(faults.begin(), faults.end(), std::back_inserter(told_),
                 [](const servo::FaultMark& fault) { return fault.from_servo; });
  }
  Fault at(std::int64_t tick) {
    while (next_ < told_.size() && told_[next_].tick < tick) ++next_;
    return next_ < told_.size() && told_[next_].tick == tick ? told_[next_].fault : Fault{};
  }

 private:
  std::vector<servo::FaultMark> told_;
  std::size_t next_ = 0;
};

/// The forces that a program added, tick by tick.
class AddedForces {
 public:
  explicit AddedForces(const std::vector<servo::Push>& pushes) : pushes_(pushes) {}
  Vec3 at(std::int64_t tick) {
    for (; next_ < pushes_.size() && pushes_[next_].tick <= tick; ++next_) now_ = pushes_[next_];
    // A file may hold any two numbers, so the difference is computed without overflow.
    const auto since = static_cast<std::uint64_t>(tick) - static_cast<std::uint64_t>(now_.tick);
    return since < static_cast<std::uint64_t>(now_.ticks) ? now_.f_T_W : Vec3(Vec3::Zero());
  }

 private:
  const std::vector<servo::Push>& pushes_;
  std::size_t next_ = 0;
  servo::Push now_;
};

/// Gets each tick as it is computed, after the scenes and faults that belong to it.
struct Listener {
  std::function<void(const ChangeRow&, const scene::Description&)> change;
  std::function<void(const servo::TickRecord&)> tick;
};

class Verification {
 public:
  Verification(Session& session, servo::Rerun rerun, const std::vector<std::string>& files_in, const Listener& listener)
      : session_(session),
        listener_(listener),
        rerun_(std::move(rerun)),
        faults_(session.faults()),
        forces_(session.pushes()),
        packer_(tickColumns()),
        files_in_(files_in) {
    result_.mended = mendedLaws(session);
  }

  /// Compares a block. false: the result is known.
  bool compare(const Block& recorded) {
    packer_.begin(session_.blockRows());
    std::int64_t rows = 0;
    for (const servo::TickRecord& record : unpackTicks(recorded)) {
      if (!isNext(record) || !applyChanges(record)) break;
      const servo::TickRecord now =
          servo::recordOf(rerun_.tick(record, faults_.at(record.tick), false, forces_.at(record.tick)));
      pack(now, rerun_.geometry(), packer_);
      if (listener_.tick) listener_.tick(now);
      ++rows;
    }
    const std::optional<BlockDifference> difference = differenceOf(recorded, packer_.block());
    if (difference && !result_.differs) {
      result_.ticks += difference->first;
      result_.differs =
          Difference{unpackTicks(recorded)[static_cast<std::size_t>(difference->first)].tick, difference->column};
    }
    if (!result_.differs) result_.ticks += rows;
    if (difference) result_.different_ticks += difference->rows;
    return !isDecided();
  }
  void stopAt(const Gap& gap) {
    if (!result_.unknown.empty()) return;
    result_.unknown = phrase(
        TRANSLATE_NOOP("problem", "The file is damaged from row %1 on, for %2 ticks; what follows cannot be replayed."),
        {std::to_string(gap.first_row + 1), std::to_string(gap.rows)});
  }
  bool isDecided() const {
    return !result_.unknown.empty() || (result_.differs && result_.mended.empty()) || !problems_.empty();
  }
  Verified result() const { return result_; }
  const Problems& problems() const { return problems_; }

 private:
  bool isNext(const servo::TickRecord& record) {
    const bool next = !last_tick_ || (record.tick > *last_tick_ && record.tick - 1 == *last_tick_);
    if (!next) {
      // A file may hold any two numbers, so the difference is computed without overflow.
      const auto missing = static_cast<std::int64_t>(static_cast<std::uint64_t>(record.tick) -
                                                     static_cast<std::uint64_t>(*last_tick_) - 1);
      result_.unknown =
          phrase(TRANSLATE_NOOP("problem", "%1 ticks are missing after tick %2; what follows cannot be replayed."),
                 {std::to_string(missing), std::to_string(*last_tick_)});
    }
    last_tick_ = record.tick;
    return next;
  }
  bool applyChanges(const servo::TickRecord& record) {
    for (; next_change_ < session_.changes().size() && session_.changes()[next_change_].tick <= record.tick;
         ++next_change_) {
      const ChangeRow& change = session_.changes()[next_change_];
      Result<scene::Description> scene = session_.scene(change);
      if (!scene) return fail(scene.problems());
      Result<tick::TickProgram> program = programOf(scene.value(), session_.info().header, files_in_);
      if (!program) return fail(program.problems());
      if (listener_.change) listener_.change(change, scene.value());
      rerun_.replaceBy(std::move(program).value(), change.carry, change.over_ticks);
    }
    return true;
  }
  bool fail(const Problems& problems) {
    problems_ = problems;
    return false;
  }

  Session& session_;
  const Listener& listener_;
  servo::Rerun rerun_;
  ToldFaults faults_;
  AddedForces forces_;
  Packer packer_;
  const std::vector<std::string>& files_in_;
  std::size_t next_change_ = 1;  // the first one is the beginning of the rerun
  std::optional<std::int64_t> last_tick_;
  Verified result_;
  Problems problems_;
};

/// The servo as it was at the first row.
Result<servo::Rerun> rerunFromStart(Session& session, const std::vector<std::string>& files_in) {
  if (session.changes().empty())
    return Problems{{phrase(TRANSLATE_NOOP("problem", "This session does not say which scene it began with.")),
                     {session.info().path}}};
  Result<scene::Description> scene = session.scene(session.changes().front());
  if (!scene) return scene.problems();
  Result<tick::TickProgram> program = programOf(scene.value(), session.info().header, files_in);
  if (!program) return program.problems();
  Result<tick::TickState> state = session.start(program.value());
  if (!state) return state.problems();
  return servo::Rerun(std::move(program).value(), std::move(state).value(), periodOf(session.info().header));
}

}  // namespace

std::optional<BlockDifference> differenceOf(const Block& a, const Block& b) {
  const auto rows = static_cast<std::size_t>(std::min(a.rows, b.rows));
  std::vector<bool> differs(rows);
  std::optional<BlockDifference> difference;
  const std::byte *of_a = a.bytes.data(), *of_b = b.bytes.data();
  for (const Column& column : tickColumns(hasMoreJoints(a) && hasMoreJoints(b))) {
    const std::size_t one = bytesOf(column);
    const bool is_same = rows == 0 || isMeasured(column) || std::memcmp(of_a, of_b, one * rows) == 0;
    for (std::size_t row = 0; row < rows && !is_same; ++row) {
      if (std::memcmp(of_a + row * one, of_b + row * one, one) == 0) continue;
      differs[row] = true;
      const auto index = static_cast<std::int64_t>(row);
      if (!difference || index < difference->first) difference = {index, std::string(column.name), 0};
    }
    of_a += one * static_cast<std::size_t>(a.rows);
    of_b += one * static_cast<std::size_t>(b.rows);
  }
  if (difference) difference->rows = std::count(differs.begin(), differs.end(), true);
  return difference;
}

namespace {

Result<Verified> verify(Session& session, const Listener& listener, const std::function<bool(double)>& progress,
                        const std::vector<std::string>& files_in) {
  if (session.info().ticks == 0) return Verified{};
  Result<servo::Rerun> rerun = rerunFromStart(session, files_in);
  if (!rerun) return rerun.problems();
  Verification verification(session, std::move(rerun).value(), files_in, listener);
  bool goes_on = true;
  const Problems problems = session.eachBlock(
      [&](const Block& block, std::int64_t) {
        return goes_on && !verification.isDecided() && verification.compare(block);
      },
      [&](const Gap& gap) { verification.stopAt(gap); },
      [&](double share) { goes_on = goes_on && (!progress || progress(share)); });
  if (!problems.empty()) return problems;
  if (!verification.problems().empty()) return verification.problems();
  Verified result = verification.result();
  if (!goes_on && result.unknown.empty() && !result.differs)
    result.unknown = phrase(TRANSLATE_NOOP("problem", "It was cancelled."));
  return result;
}

/// Writes a run that is made again.
class RerunWriter {
 public:
  RerunWriter(Session& session, SessionWriter writer) : session_(session), writer_(std::move(writer)) {}
  Problems begin(const std::vector<std::string>& files_in) {
    Result<scene::Description> scene = session_.scene(session_.changes().front());
    if (!scene) return scene.problems();
    Result<tick::TickProgram> program = programOf(scene.value(), session_.info().header, files_in);
    if (!program) return program.problems();
    const Result<tick::TickState> state = session_.start(program.value());
    if (!state) return state.problems();
    const ChangeRow& first = session_.changes().front();
    return writer_.begin(first.tick, first.revision, state.value(), scene.value());
  }
  void add(const ChangeRow& change, const scene::Description& scene) {
    note(writer_.add(servo::Change{change.tick, change.revision, change.carry, change.over_ticks}, scene));
  }
  void add(const servo::TickRecord& record) {
    for (; next_fault_ < session_.faults().size() && session_.faults()[next_fault_].tick <= record.tick; ++next_fault_)
      note(writer_.add(session_.faults()[next_fault_]));
    for (; next_push_ < session_.pushes().size() && session_.pushes()[next_push_].tick <= record.tick; ++next_push_)
      note(writer_.add(session_.pushes()[next_push_]));
    for (; next_mark_ < session_.markers().size() && session_.markers()[next_mark_].tick <= record.tick; ++next_mark_)
      note(writer_.mark(session_.markers()[next_mark_].tick, session_.markers()[next_mark_].label));
    note(writer_.add(record));
  }
  Problems end() {
    EndRow row = session_.info().end.value_or(EndRow{});
    row.unix_ns = unixNow_ns();
    note(writer_.end(row));
    return problems_;
  }

 private:
  void note(const Problems& more) {
    if (problems_.empty()) problems_ = more;
  }
  Session& session_;
  SessionWriter writer_;
  std::size_t next_fault_ = 0, next_mark_ = 0, next_push_ = 0;
  Problems problems_;
};

/// The members of what a session says of its run, and of which session it is a run again.
json::ObjectText provenanceAgain(Session& session, const std::string& session_id) {
  json::ObjectText object;
  object.addInteger("underact_provenance", 1);
  object.addText("session", session_id);
  object.addText("rerun_of", session.info().header.session_id);
  object.addText("rerun_by", "recorded input");
  object.addAll(lawVersions());
  if (session.provenance().empty()) return object;
  const Result<std::string> text = session.provenanceText(session.provenance().front());
  if (text && json::parse(text.value(), "")) object.addJson("original", text.value());
  return object;
}

}  // namespace

Result<Verified> verifyReplay(Session& session, const std::function<bool(double)>& progress,
                              const std::vector<std::string>& files_in) {
  return verify(session, {}, progress, files_in);
}

Result<Verified> rerunFromInput(Session& session, const RerunFile& file,
                                const std::function<void(const servo::TickRecord&)>& tick,
                                const std::function<bool(double)>& progress, const std::vector<std::string>& files_in) {
  if (file.path.empty() || session.changes().empty()) return verify(session, {{}, tick}, progress, files_in);
  SessionHeader header = session.info().header;
  header.session_id = newSessionId();
  header.provenance = provenanceAgain(session, header.session_id);
  header.details = false;
  Result<SessionWriter> writer = SessionWriter::create(file.path, header, file.existing);
  if (!writer) return writer.problems();
  RerunWriter again(session, std::move(writer).value());
  if (Problems problems = again.begin(files_in); !problems.empty()) return problems;
  const Listener listener{[&](const ChangeRow& change, const scene::Description& scene) { again.add(change, scene); },
                          [&](const servo::TickRecord& record) {
                            again.add(record);
                            if (tick) tick(record);
                          }};
  Result<Verified> verified = verify(session, listener, progress, files_in);
  if (Problems problems = again.end(); verified && !problems.empty()) return problems;
  return verified;
}

Problems replayWith(Session& session, const scene::Description& scene,
                    const std::function<void(const servo::TickRecord&, const servo::TickRecord&)>& tick,
                    const std::function<bool(double)>& progress) {
  Result<tick::TickProgram> program = programOf(scene, session.info().header, {});
  if (!program) return program.problems();
  servo::Rerun rerun(std::move(program).value(), periodOf(session.info().header));
  ToldFaults faults(session.faults());
  AddedForces forces(session.pushes());
  bool begins = true, goes_on = true;
  return session.eachBlock(
      [&](const Block& block, std::int64_t) {
        for (const servo::TickRecord& recorded : unpackTicks(block)) {
          tick(recorded,
               servo::recordOf(rerun.tick(recorded, faults.at(recorded.tick), begins, forces.at(recorded.tick))));
          begins = false;
        }
        return goes_on;
      },
      [&](const Gap&) { begins = true; }, [&](double share) { goes_on = goes_on && (!progress || progress(share)); });
}

}  // namespace underact::record
