#include "core/record/recorder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

#include "core/base/translate.h"
#include "core/record/disk.h"
#include "core/record/provenance.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/system/clock.h"
#include "core/system/private_file.h"

namespace underact::record {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPause{20};
constexpr milliseconds kLookAtDisk{500};
constexpr milliseconds kWaitForEnd{1000};
constexpr std::int64_t kReserve = 64LL << 20;
constexpr std::int64_t kReserveShare = 16;  // of what is free at the beginning, on a small disk
// How full a session is when the next is asked for: what the servo's queues hold still fits.
constexpr double kGoesOn = 0.75;
constexpr int kMaxParts = 10'000;

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
  return header;
}

struct Mark {
  std::int64_t tick = 0;
  std::string label;
};

/// Bytes that are free where the file is; none: not known.
std::optional<std::int64_t> freeBytes(const std::string& path) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error ? std::nullopt : std::optional(static_cast<std::int64_t>(space.available));
}

/// Room for the constraints of a tick where they are asked for; an edited scene may have more than the first.
std::size_t detailsOf(const servo::Host& host, const RecorderOptions& options) {
  constexpr std::size_t kAtLeast = 8;
  return options.details ? std::max(kAtLeast, host.scene().constraints.size()) : 0;
}

}  // namespace

struct Recorder::Impl {
  Impl(servo::Host& servo, const std::string& file, SessionWriter made, const RecorderOptions& wanted,
       SessionHeader first, json::ObjectText of_all)
      : host(servo),
        header(std::move(first)),
        session_id(header.session_id),
        common(std::move(of_all)),
        servo_words(servoProvenance(servo).text()),
        path(file),
        part_path(file),
        options(wanted),
        reserve_bytes(wanted.reserve_bytes.value_or(std::min(kReserve, freeBytes(file).value_or(0) / kReserveShare))),
        writer(std::move(made)),
        tap(std::make_shared<servo::Tap>(1'000'000'000 / servo.rateHz(), wanted.max_ticks, detailsOf(servo, wanted))) {
    shown.files.push_back(file);
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

  void takeAll() {
    const bool starts = awaits_start && tap->begun();  // first: what comes before that start is there then
    if (is_closed || (!begun && !starts)) return;
    takeRows();
    if (starts) {
      if (begun) writeBefore(tap->firstTick());
      begin();
    }
    if (is_closed) return;  // there is no next file
    writeBefore(INT64_MAX);
    readClocks(false);
    note(writer.flush());
    if (!awaits_start && !failed() && writer.fill() > kGoesOn) {
      awaits_start = true;
      tap->wantStart();
    }
    const std::scoped_lock lock(mutex);
    shown.ticks = ticks_before + writer.ticks();
    shown.dropped = tap->dropped();
    if (first_ns != 0)
      shown.duration_s = 1e-9 * static_cast<double>(std::max<std::int64_t>(last.time_ns - first_ns, 0));
  }
  /// A tick comes last of what belongs to it, so it is taken first.
  void takeRows() {
    const auto take = [this]<class Row>(std::deque<Row>& rows) {
      for (Row row; tap->take(row);) rows.push_back(row);
    };
    std::apply([&](auto&... rows) { (take(rows), ...); }, waiting);
    const std::scoped_lock lock(mutex);
    waiting_marks.insert(waiting_marks.end(), marks.begin(), marks.end());
    marks.clear();
    for (json::ObjectText& changed : notes) noted = std::move(changed);
    is_noted = is_noted && notes.empty();
    notes.clear();
  }
  /// Gives the waiting rows of the ticks before one to put().
  template <class Row, class Put>
  void each(std::int64_t before_tick, const Put& put) {
    auto& rows = std::get<std::deque<Row>>(waiting);
    for (; !rows.empty() && rows.front().tick < before_tick; rows.pop_front()) put(rows.front());
  }
  /// What belongs to a tick is written before it, so that a truncated file can be replayed up to its end.
  void writeBefore(std::int64_t tick) {
    const auto add = [this](const auto& row) { note(writer.add(row)); };
    each<servo::Change>(tick, [this](const servo::Change& change) {
      scene = tap->takeScene(change.revision);
      note(writer.add(change, scene));
    });
    each<servo::FaultMark>(tick, add);
    each<servo::Push>(tick, add);
    auto& left = waiting_marks;
    for (; !left.empty() && left.front().tick < tick && writer.hasRoomFor(left.front().label); left.pop_front())
      note(writer.mark(left.front().tick, left.front().label));
    if (!std::exchange(is_noted, true)) note(writer.addProvenance(std::max(part_begins, last.tick), noted));
    each<servo::TruthRow>(tick, add);
    each<servo::ConstraintRow>(tick, add);
    each<servo::TickRecord>(tick, [this](const servo::TickRecord& record) {
      if (first_ns == 0) first_ns = record.time_ns;
      note(writer.add(record));
      last = record;
    });
  }
  /// Begins the session with the tick whose state the tap has: the first one, or the next part.
  void begin() {
    const std::int64_t tick = tap->firstTick();
    if (begun) {
      // Those that came before this tick are in its state already.
      each<servo::Change>(tick + 1, [this](const servo::Change& change) { scene = tap->takeScene(change.revision); });
      goOn();
      if (failed()) return;
      is_noted = noted.text() == json::ObjectText().text();
    } else {
      scene = tap->takeScene(tap->firstRevision());
    }
    begun = true;
    awaits_start = false;
    part_begins = tick;
    note(writer.begin(tick, tap->firstRevision(), tap->start(), scene));
  }
  /// Ends this part and makes the file of the next.
  void goOn() {
    readClocks(true);
    note(writer.end({0, tap->dropped() - dropped_before, unixNow_ns(), EndReason::Stopped}));
    is_closed = !failed();
    if (failed()) return;
    clock_tick = 0;
    dropped_before = tap->dropped();
    ticks_before += writer.ticks();
    bytes_before += sizeOf(part_path);
    const std::string before = std::exchange(header.session_id, newSessionId());
    header.provenance = provenanceOf(header.session_id, before, common);
    header.started_unix_ns = unixNow_ns();
    Result<SessionWriter> next = nextFile();
    if (!next) return note(next.problems());
    writer = std::move(next).value();
    is_closed = false;
    const std::scoped_lock lock(mutex);
    shown.files.push_back(part_path);
  }
  Result<SessionWriter> nextFile() {  // none that exists is touched
    Result<SessionWriter> made = Problems{};
    do {
      part_path = nameOfPart(path, ++part);
      made = SessionWriter::create(part_path, header, system::Existing::Refuse, options.limits);
    } while (!made && part < kMaxParts && !system::checkNew(part_path, system::Existing::Refuse).empty());
    return made;
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
  void note(Problems found) {
    if (problems.empty()) problems = std::move(found);
    disk_full = disk_full || writer.isFull();
  }

  void checkDisk() {
    if (steady_clock::now() < next_look) return;
    next_look = steady_clock::now() + kLookAtDisk;
    std::error_code error;
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(part_path, error));
    if (error)
      return note(
          {{phrase(TRANSLATE_NOOP("problem", "The recording stopped: its file was moved or deleted.")), {part_path}}});
    const std::optional<std::int64_t> available = freeBytes(part_path);
    if (!available) return;
    const auto left = static_cast<double>(*available - reserve_bytes);
    {
      const std::scoped_lock lock(mutex);
      shown.bytes = bytes_before + size;
      shown.disk_left_bytes = *available;
      shown.disk_left_s =
          shown.bytes > 0 ? std::max(0.0, left) * shown.duration_s / static_cast<double>(shown.bytes) : 0.0;
    }
    if (left > 0.0) return;
    disk_full = true;
    note({{phrase(TRANSLATE_NOOP("problem",
                                 "The disk is nearly full: the recording was stopped, and everything up to then was "
                                 "saved. Free some space, or record into another folder.")),
           {part_path}}});
  }

  void finish() {
    std::int64_t saved = 0;  // of this part
    bool in_order = problems.empty() || disk_full || writer.isAtLimit();
    const EndReason reason = disk_full ? EndReason::DiskFull : wished_reason.load();
    if (in_order && !begun)
      note({{phrase(TRANSLATE_NOOP("problem", "The servo did not tick, so the recording is empty.")), {part_path}}});
    if (in_order && !disk_full && !is_closed) readClocks(true);
    if (in_order && !is_closed) {
      const Problems at_end = writer.end({0, tap->dropped() - dropped_before, unixNow_ns(), reason});
      if (!at_end.empty()) problems = at_end;  // whatever was reported before, the end is missing
      in_order = at_end.empty();
      saved = writer.savedTicks();
    }
    if (!in_order && !is_closed) {
      writer.abandon();
      const Result<std::int64_t> whole = completeFile(part_path);
      saved = whole ? whole.value() : 0;
      Sentence& sentence = problems.front().sentence;
      if (whole)
        sentence = oneAfterAnother({sentence, phrase(TRANSLATE_NOOP("problem", "Everything up to then was saved."))});
    }
    sayWhatIsMissing();
    const std::scoped_lock lock(mutex);
    shown.bytes = bytes_before + (is_closed ? 0 : sizeOf(part_path));
    shown.ticks = ticks_before + saved;
    shown.dropped = tap->dropped();
    shown.problems = problems;
    shown.recording = false;
  }
  void sayWhatIsMissing() {
    if (const std::int64_t dropped = tap->dropped(); dropped > 0)
      problems.push_back({phrase(TRANSLATE_NOOP("problem",
                                                "%1 ticks or events are missing in the recording: the computer was too "
                                                "busy to write them."),
                                 {std::to_string(dropped)}),
                          {path}});
    if (!waiting_marks.empty() && begun)
      problems.push_back(
          {phrase(TRANSLATE_NOOP("problem", "%1 markers are missing: the recording has as many as a session may have."),
                  {std::to_string(waiting_marks.size())}),
           {path}});
  }

  servo::Host& host;
  SessionHeader header;  // of the present part
  std::string session_id;
  json::ObjectText common;  // what was run, in each part
  std::string servo_words;  // as noted last
  std::string path, part_path;
  RecorderOptions options;
  std::int64_t reserve_bytes;
  SessionWriter writer;
  std::shared_ptr<servo::Tap> tap;
  std::size_t capacity = tap->room();
  // What was taken and is not written yet.
  std::tuple<std::deque<servo::TickRecord>, std::deque<servo::Change>, std::deque<servo::FaultMark>,
             std::deque<servo::Push>, std::deque<servo::TruthRow>, std::deque<servo::ConstraintRow>>
      waiting;
  std::deque<Mark> waiting_marks;
  json::ObjectText noted;  // what changed last of the provenance
  bool is_noted = true;
  scene::Description scene;  // that is in effect
  Problems problems;         // of the recorder's thread; others read shown
  bool disk_full = false;
  std::atomic<EndReason> wished_reason{EndReason::Stopped};
  bool begun = false, awaits_start = true, is_closed = false;
  int part = 1;
  std::int64_t part_begins = 0, ticks_before = 0, bytes_before = 0, dropped_before = 0;  // before this part
  std::int64_t first_ns = 0;
  servo::TickRecord last;                     // that was written
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
  SessionHeader header = headerOf(host, words, options);
  json::ObjectText common = provenanceOf(host, options.run);
  header.provenance = provenanceOf(header.session_id, "", common);
  Result<SessionWriter> writer = SessionWriter::create(path, header, options.existing, options.limits);
  if (!writer) return writer.problems();
  auto impl = std::make_unique<Impl>(host, path, std::move(writer).value(), options, header, std::move(common));
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
