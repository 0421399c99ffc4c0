#include "device/rerun_session.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/arm/model.h"
#include "core/base/translate.h"
#include "core/record/laws.h"
#include "core/record/recorder.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/servo/host.h"
#include "device/simulated_run.h"

namespace underact::device {
namespace {

using record::Session;

/// The run of a simulated arm that the whole session is; none: it has to be made from its input. Problems: it says that
/// it is one, and cannot be read.
Result<std::optional<SimulatedRun>> wholeRunOf(Session& session) {
  const std::optional<SimulatedRun> none;
  if (session.provenance().empty() || session.changes().size() != 1 || !session.pushes().empty() ||
      session.info().dropped > 0)
    return none;
  const Result<json::Value> provenance = session.provenanceOf(session.provenance().front());
  if (!provenance) return provenance.problems();
  if (session.changes().front().tick != 1 || !hasSimulatedRun(provenance.value())) return none;
  Result<SimulatedRun> run = readSimulatedRun(provenance.value(), session.info().path);
  if (!run) return run.problems();
  const json::Value* const arm = provenance.value().find("arm");
  const json::Value* const file = arm != nullptr ? arm->find("file") : nullptr;
  const Result<scene::Description> scene = session.scene(session.changes().front());
  if (!scene) return scene.problems();
  if (file == nullptr || file->text != scene::armTextOf(scene.value()))
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "The arm \"%1\" of this session is another one in this version of the "
                                           "program. Run it with the version that recorded it."),
                            {session.info().header.arm}),
                     {session.info().path}}};
  return std::optional(std::move(run).value());
}

/// A servo on the simulated arm, as it was.
class Again {
 public:
  Again(Session& session, const RerunOptions& options) : session_(session), options_(options) {
    result_.mended = record::mendedLaws(session);
  }

  Problems begin(const SimulatedRun& run) {
    const record::SessionHeader& header = session_.info().header;
    Result<scene::Description> scene = session_.scene(session_.changes().front());
    if (!scene) return scene.problems();
    scene = record::asIntegrated(session_, std::move(scene).value());
    Problems problems = scene::loadRecordedMeshes(scene.value(), options_.files_in);
    if (!problems.empty()) return problems;
    const arm::Preset* const preset = scene::findArm(scene.value());
    const auto rate_hz = static_cast<int>(header.rate_hz);
    if (preset == nullptr || rate_hz < servo::kSlowest_hz || rate_hz > servo::kFastest_hz)
      return {{phrase(TRANSLATE_NOOP("problem", "This session's arm or rate is none that this version has.")),
               {session_.info().path}}};
    geometry_ = preset->geometry;
    host_ = std::make_unique<servo::Host>(
        makeSimulatedArm(run, *preset, scene.value(), rate_hz),
        servo::HostOptions{.rate_hz = rate_hz, .clock = servo::Clock::Manual, .max_late = header.max_late});
    problems = host_->setForceShare(header.force_share);
    if (problems.empty()) problems = host_->load(scene.value());
    if (!problems.empty()) return problems;
    host_->start();
    return startRecorder(run);
  }

  /// Runs the ticks of a block and compares. false: the result is known.
  bool compare(const record::Block& recorded) {
    constexpr std::size_t kAtOnce = 1000;  // far fewer than the servo keeps for us
    const std::vector<servo::TickRecord> rows = record::unpackTicks(recorded);
    record::Packer packer(record::tickColumns(true));
    packer.begin(recorded.rows);
    for (std::size_t at = 0; at < rows.size(); at += kAtOnce) {
      std::vector<std::int64_t> lateness_ns;
      for (std::size_t row = at; row < std::min(at + kAtOnce, rows.size()); ++row)
        lateness_ns.push_back(rows[row].lateness_ns);
      host_->run(static_cast<std::int64_t>(lateness_ns.size()), lateness_ns);
      host_->drain([&](const servo::TickRecord& now) {
        record::pack(now, geometry_, packer, true);
        if (options_.tick) options_.tick(now);
      });
    }
    if (packer.rows() != recorded.rows) return true;
    auto difference = record::differenceOf(recorded, packer.block());
    if (arm::jointsOf(geometry_) > 6 && !record::hasMoreJoints(recorded))  // no recorder does that
      difference = {0, std::string(record::kMoreJoints.column.name), recorded.rows};
    if (difference) result_.different_ticks += difference->rows;
    if (result_.differs) return true;  // the rest is run, too
    result_.ticks += difference ? difference->first : recorded.rows;
    if (difference)
      result_.differs = record::Difference{rows[static_cast<std::size_t>(difference->first)].tick, difference->column};
    return result_.unknown.empty();
  }
  void stopAt(const record::Gap& gap) {
    if (!result_.unknown.empty()) return;
    result_.unknown = phrase(
        TRANSLATE_NOOP("problem", "The file is damaged from row %1 on, for %2 ticks; what follows cannot be replayed."),
        {std::to_string(gap.first_row + 1), std::to_string(gap.rows)});
  }
  Problems end() { return recorder_ ? recorder_->stop() : Problems{}; }
  record::Verified& result() { return result_; }

 private:
  Problems startRecorder(const SimulatedRun& run) {
    if (options_.out.path.empty()) return {};
    record::RecorderOptions options{.max_ticks = session_.info().ticks, .existing = options_.out.existing};
    options.block_s = static_cast<double>(session_.blockRows()) / static_cast<double>(session_.info().header.rate_hz);
    options.details = session_.info().header.details;
    options.run = provenanceOf(run);
    options.run.addText("rerun_of", session_.info().header.session_id);
    options.run.addText("rerun_by", "hand");
    Result<std::unique_ptr<record::Recorder>> started =
        record::Recorder::start(*host_, options_.out.path, session_.info().header.words, options);
    if (!started) return started.problems();
    recorder_ = std::move(started).value();
    return {};
  }

  Session& session_;
  const RerunOptions& options_;
  arm::Geometry geometry_;
  std::unique_ptr<servo::Host> host_;
  std::unique_ptr<record::Recorder> recorder_;
  record::Verified result_;
};

Result<RerunResult> rerunHand(Session& session, const SimulatedRun& run, const RerunOptions& options) {
  Again again(session, options);
  if (Problems problems = again.begin(run); !problems.empty()) return problems;
  bool goes_on = true;
  Problems problems =
      session.eachBlock([&](const record::Block& block,
                            std::int64_t) { return goes_on && again.result().unknown.empty() && again.compare(block); },
                        [&](const record::Gap& gap) { again.stopAt(gap); },
                        [&](double share) { goes_on = goes_on && (!options.progress || options.progress(share)); });
  if (!goes_on && again.result().unknown.empty() && !again.result().differs)
    again.result().unknown = phrase(TRANSLATE_NOOP("problem", "It was cancelled."));
  const Problems unwritten = again.end();
  problems.insert(problems.end(), unwritten.begin(), unwritten.end());
  if (!problems.empty()) return problems;
  return RerunResult{again.result(), true, run.seed};
}

}  // namespace

Result<RerunResult> rerun(Session& session, const RerunOptions& options) {
  const Result<std::optional<SimulatedRun>> run = wholeRunOf(session);
  if (!run) return run.problems();
  if (run.value()) return rerunHand(session, *run.value(), options);
  Result<record::Verified> verified =
      record::rerunFromInput(session, options.out, options.tick, options.progress, options.files_in);
  if (!verified) return verified.problems();
  return RerunResult{std::move(verified).value(), false, 0};
}

}  // namespace underact::device
