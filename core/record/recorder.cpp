#include "core/record/recorder.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/translate.h"
#include "core/record/provenance.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/system/clock.h"

namespace underact::record {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPause{20};
constexpr milliseconds kLookAtDisk{500};
constexpr milliseconds kWaitForEnd{1000};

SessionHeader headerOf(const servo::Host& host, const SessionMetadata& words, const RecorderOptions& options) {
  SessionHeader header;
  header.words = words;
  header.scene_title = host.scene().title;
  header.arm = scene::withoutFolders(host.scene()).arm;
  header.arm_file = scene::armTextOf(host.scene());
  header.device = host.device().title;
  header.scheduling = host.scheduling().name;
  header.started_unix_ns = unixNow_ns();
  header.rate_hz = host.rateHz();
  header.frozen_s = host.device().frozen_s;
  header.max_late = host.maxLate();
  header.block_s = options.block_s;
  header.force_share = host.forceShare();
  header.session_id = options.session_id.empty() ? newSessionId() : options.session_id;
  header.details = options.details;
  header.provenance = provenanceOf(host, header.session_id, options.run);
  return header;
}

struct Mark {
  std::int64_t tick = 0;
  std::string label;
};

/// Room for the constraints of a tick where they are asked for; an edited scene may have more than the first.
std::size_t detailsOf(const servo::Host& host, const RecorderOptions& options) {
  constexpr std::size_t kAtLeast = 8;
  return options.details ? std::max(kAtLeast, host.scene().constraints.size()) : 0;
}

}  // namespace

struct Recorder::Impl {
  Impl(servo::Host& servo, std::string file, SessionWriter made, const RecorderOptions& wanted, std::string id)
      : host(servo),
        session_id(std::move(id)),
        servo_words(servoProvenance(servo).text()),
        path(std::move(file)),
        options(wanted),
        writer(std::move(made)),
        tap(std::make_shared<servo::Tap>(1'000'000'000 / servo.rateHz(), wanted.most_ticks, detailsOf(servo, wanted))) {
  }

  void run() {
    while (!failed() && !tap->ended() && !ends.load()) {
      const bool busy = room() < 0.5;  // a run at full speed must not wait
      takeAll();
      if (!failed()) checkDisk();
      if (!busy) std::this_thread::sleep_for(kPause);
    }
    tap->giveUp();
    takeAll();
    finish();
  }
  double room() const { return static_cast<double>(tap->room()) / static_cast<double>(capacity); }
  bool failed() const { return !problems.empty(); }

  /// What belongs to a tick is written before it, so that a truncated file can be replayed up to its end.
  void takeAll() {
    if (!tap->begun()) return;
    if (!begun) {
      begun = true;
      note(writer.begin(tap->firstTick(), tap->firstRevision(), tap->start(), tap->takeScene(tap->firstRevision())));
    }
    batch.clear();
    for (servo::TickRecord record; tap->take(record);) batch.push_back(record);
    for (servo::Change change; tap->take(change);) note(writer.add(change, tap->takeScene(change.revision)));
    for (servo::FaultMark fault; tap->take(fault);) note(writer.add(fault));
    for (servo::Push push; tap->take(push);) note(writer.add(push));
    for (const Mark& mark : takeMarks()) note(writer.mark(mark.tick, mark.label));
    for (const json::ObjectText& changed : takeNotes())
      note(writer.addProvenance(batch.empty() ? tap->firstTick() : batch.back().tick, changed));
    for (servo::TruthRow row; tap->take(row);) note(writer.add(row));
    for (servo::ConstraintRow row; tap->take(row);) note(writer.add(row));
    for (const servo::TickRecord& record : batch) note(writer.add(record));
    if (!batch.empty()) last = batch.back();
    readClocks(false);
    note(writer.flush());
    const std::scoped_lock lock(mutex);
    shown.ticks = writer.ticks();
    shown.dropped = tap->dropped();
    if (batch.empty()) return;
    if (first_ns == 0) first_ns = batch.front().time_ns;
    shown.duration_s = 1e-9 * static_cast<double>(std::max<std::int64_t>(batch.back().time_ns - first_ns, 0));
  }
  /// Writes a row of /clock when it is time, and at the end.
  void readClocks(bool is_last) {
    if (last.tick == 0 || (is_last && last.tick == clock_tick)) return;
    const std::int64_t now_ns = system::monotonicNow_ns();
    const auto every_ns = static_cast<std::int64_t>(1e9 * options.clock_every_s);
    if (!is_last && clock_tick != 0 && now_ns - clock_ns < every_ns) return;
    const std::int64_t unix_ns = unixNow_ns(), between_ns = system::monotonicNow_ns() - now_ns;
    note(writer.add(ClockRow{last.tick, last.time_ns, now_ns + between_ns / 2, unix_ns, between_ns}));
    clock_tick = last.tick;
    clock_ns = now_ns;
  }
  std::deque<json::ObjectText> takeNotes() {
    const std::scoped_lock lock(mutex);
    return std::exchange(notes, {});
  }
  std::deque<Mark> takeMarks() {
    const std::scoped_lock lock(mutex);
    return std::exchange(marks, {});
  }
  void note(Problems found) {
    if (problems.empty()) problems = std::move(found);
    disk_full = disk_full || writer.isFull();
  }

  void checkDisk() {
    if (steady_clock::now() < next_look) return;
    next_look = steady_clock::now() + kLookAtDisk;
    std::error_code error;
    const auto size = static_cast<double>(std::filesystem::file_size(path, error));
    if (error)
      return note({{said(TRANSLATE_NOOP("problem", "The recording stopped: its file was moved or deleted.")), {path}}});
    const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
    const std::filesystem::space_info space = std::filesystem::space(folder, error);
    if (error) return;
    const auto left = static_cast<double>(space.available) - static_cast<double>(options.reserve_bytes);
    {
      const std::scoped_lock lock(mutex);
      shown.bytes = static_cast<std::int64_t>(size);
      shown.disk_left_bytes = static_cast<std::int64_t>(space.available);
      shown.disk_left_s = size > 0.0 ? std::max(0.0, left) * shown.duration_s / size : 0.0;
    }
    if (left > 0.0) return;
    disk_full = true;
    note({{said(TRANSLATE_NOOP("problem",
                               "The disk is nearly full: the recording was stopped, and everything up to then was "
                               "saved. Free some space, or record into another folder.")),
           {path}}});
  }

  void finish() {
    bool in_order = problems.empty() || disk_full;
    const EndReason reason = disk_full ? EndReason::DiskFull : wished_reason.load();
    if (in_order && !begun)
      note({{said(TRANSLATE_NOOP("problem", "The servo did not tick, so the recording is empty.")), {path}}});
    if (in_order && !disk_full) readClocks(true);
    if (in_order) {
      const Problems at_end = writer.end({0, tap->dropped(), unixNow_ns(), reason});
      if (!at_end.empty()) problems = at_end;  // whatever was reported before, the end is missing
      in_order = at_end.empty();
    }
    if (!in_order) {
      writer.abandon();
      const Result<std::int64_t> whole = completeFile(path);
      Sentence& sentence = problems.front().sentence;
      if (whole)
        sentence = oneAfterAnother({sentence, said(TRANSLATE_NOOP("problem", "Everything up to then was saved."))});
    }
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    const std::scoped_lock lock(mutex);
    if (!error) shown.bytes = static_cast<std::int64_t>(size);
    shown.problems = problems;
    shown.recording = false;
  }

  servo::Host& host;
  std::string session_id;
  std::string servo_words;  // as noted last
  std::string path;
  RecorderOptions options;
  SessionWriter writer;
  std::shared_ptr<servo::Tap> tap;
  std::size_t capacity = tap->room();
  std::vector<servo::TickRecord> batch;
  Problems problems;  // of the recorder's thread; others read shown
  bool disk_full = false;
  std::atomic<EndReason> wished_reason{EndReason::Stopped};
  bool begun = false;
  std::int64_t first_ns = 0;
  servo::TickRecord last;                     // that was taken
  std::int64_t clock_tick = 0, clock_ns = 0;  // of the last row of /clock
  steady_clock::time_point next_look{};
  std::atomic<bool> ends{false};
  mutable std::mutex mutex;  // of what follows
  std::deque<Mark> marks;
  std::deque<json::ObjectText> notes;  // of the provenance
  RecorderStatus shown;
  bool stopped = false;  // the host's thread
  std::thread thread;
};

Recorder::Recorder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Recorder::~Recorder() {
  stop(EndReason::ProgramEnded);
}

Result<std::unique_ptr<Recorder>> Recorder::start(servo::Host& host, const std::string& path,
                                                  const SessionMetadata& words, const RecorderOptions& options) {
  const SessionHeader header = headerOf(host, words, options);
  Result<SessionWriter> writer = SessionWriter::create(path, header, options.existing);
  if (!writer) return writer.problems();
  auto impl = std::make_unique<Impl>(host, path, std::move(writer).value(), options, header.session_id);
  Impl* const running = impl.get();
  std::unique_ptr<Recorder> recorder(new Recorder(std::move(impl)));
  running->thread = std::thread([running] { running->run(); });
  host.record(running->tap);
  return recorder;
}

void Recorder::mark(const std::string& label) {
  const std::int64_t tick = impl_->host.snapshot().ticks;
  const std::scoped_lock lock(impl_->mutex);
  impl_->marks.push_back({tick, label});
}

void Recorder::noteServo() {
  const json::ObjectText now = servoProvenance(impl_->host);
  if (std::exchange(impl_->servo_words, now.text()) == now.text()) return;
  const std::scoped_lock lock(impl_->mutex);
  impl_->notes.push_back(now);
}

Problems Recorder::stop(EndReason reason) {
  if (!std::exchange(impl_->stopped, true)) {
    noteServo();
    impl_->wished_reason = reason;
    impl_->host.endRecord();
    const auto limit = steady_clock::now() + kWaitForEnd;
    while (!impl_->tap->ended() && steady_clock::now() < limit) {
      impl_->host.snapshot();  // sends commands that are waiting
      std::this_thread::sleep_for(milliseconds(1));
    }
    impl_->ends = true;
    impl_->thread.join();
  }
  return status().problems;
}

RecorderStatus Recorder::status() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->shown;
}

const std::string& Recorder::sessionId() const {
  return impl_->session_id;
}

const std::string& Recorder::path() const {
  return impl_->path;
}

}  // namespace underact::record
