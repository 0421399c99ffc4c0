// The sessions that clients record, and their markers.
#include "app/serve/service_impl.h"

namespace underact::serve {
namespace {

constexpr std::size_t kLongestMark = 1000;
constexpr std::size_t kLongestFileName = 200;

}  // namespace

void Service::Impl::mark(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> text = keys.text("text", kLongestMark);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const std::int64_t tick = host.snapshot().ticks;
  steered.mark(*text);
  json::ObjectText told = event("mark", tick);
  told.addText("text", *text);
  told.addText("by", client.name);
  tell(told);
  json::ObjectText answer = okAnswer(request.id);
  answer.addInteger("tick", tick);
  client.send(answer.text());
}

void Service::Impl::record(Client& client, const Request& request) {
  Keys keys(request);
  const bool stops = request.root().find("stop") != nullptr;
  const std::optional<bool> stop = keys.flag("stop", false);
  const std::optional<std::string> file = keys.text("file", kLongestFileName, !stops);
  if (stops && file) keys.add(request.root(), "file", "Give either \"file\" or \"stop\", not both.");
  if (stop && !*stop) keys.add(request.root(), "stop", "This must be true, or be omitted.");
  const bool is_plain = file && !file->empty() && file->front() != '.' &&
                        file->find_first_of(std::string("/\\\0", 3)) == std::string::npos && file->ends_with(".h5");
  if (file && !is_plain)
    keys.add(request.root(), "file",
             "This must be the name of a new file in the sessions folder, as in \"trial_7.h5\".");
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const std::optional<RecordingNow> now = steered.recording();
  json::ObjectText answer = okAnswer(request.id);
  if (stops) {
    if (!now) return refuse(client, request, problemAt("/stop", "Nothing is being recorded."));
    if (!now->is_clients)
      return refuse(client, request, problemAt("/stop", "No client has begun this recording, so none may end it."));
    const Result<RecordingNow> ended = steered.endRecording();
    if (!ended) return refuse(client, request, problemAt("/stop", ended.problems().front().sentence));
    answer.addText("file", ended.value().path);
    answer.addInteger("ticks", ended.value().ticks);
  } else {
    if (now) return refuse(client, request, problemAt("/do", "A session is being recorded already: " + now->path));
    const Problems problems = steered.startRecording(*file);
    if (!problems.empty()) return refuse(client, request, problemAt("/file", problems.front().sentence));
    const std::optional<RecordingNow> begun = steered.recording();
    answer.addText("file", begun ? begun->path : *file);
    answer.addInteger("ticks", 0);
  }
  client.send(answer.text());
}

}  // namespace underact::serve
