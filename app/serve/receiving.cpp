// Frames become requests: at once, or by a worker, one after another.
#include <utility>

#include "app/serve/scene_parts.h"
#include "app/serve/service_impl.h"

namespace underact::serve {

void Service::Impl::receive(Client& client, Frame frame) {
  if (!frame.is_text) return take(client, problemAt("", "This frame is binary; a request is JSON text."));
  if (frame.text.size() > kLongestAtOnce) {
    if (!client.is_known) {
      client.send(problemAnswer("null", problemAt("", "The first request must be \"hello\", with the token.")));
      client.closes = true;
    } else if (isAtWork(client.number)) {
      holdBack(client, std::move(frame));
    } else {
      readLong(client, std::move(frame));
    }
    return;
  }
  Result<Request> request = readRequest(frame.text);
  if (!request) return take(client, request);
  if (isAtWork(client.number) && request.value().what != "stop") return holdBack(client, std::move(frame));
  request.value().stops = frame.stops;
  request.value().has_stopped = frame.has_stopped;
  take(client, request);
}

void Service::Impl::holdBack(Client& client, Frame frame) {
  if (client.held_back.size() >= kMaxHeldBack || client.held_back_bytes + frame.text.size() > kMaxHeldBackBytes)
    return client.send(problemAnswer(
        glanceAt(frame.text).id, problemAt("", "Too many requests wait for the answer to an earlier one already.")));
  client.held_back_bytes += frame.text.size();
  client.held_back.push_back(std::move(frame));
}

void Service::Impl::readLong(const Client& client, Frame frame) {
  reckoning.add(
      client.number,
      [this, long_frame = std::move(frame), scene = host.scene(), revision = host.revision()]() -> Worker::Then {
        Result<Request> read = readRequest(long_frame.text);
        if (read) {
          Request& request = read.value();
          request.stops = long_frame.stops;
          request.has_stopped = long_frame.has_stopped;
          request.general = generalProblems(request);
          request.revision = revision;
          if (request.general->empty() && request.what == "set") request.edited = editedBy(request, scene);
          if (request.general->empty() && request.what == "get") request.values = valuesFor(request, scene);
          const bool may_be_long = request.what == "load" || request.what == "set" || request.what == "get" ||
                                   request.what == "constraint.add" || request.what == "stop";
          if (!may_be_long)
            request.general = problemAt("", "Only load, set, get and constraint.add may have more than 16384 bytes.");
        }
        return [this, read = std::move(read)](Client& its) { take(its, read); };
      });
}

void Service::Impl::take(Client& client, const Result<Request>& request) {
  if (request) return perform(client, request.value());
  client.send(problemAnswer("null", request.problems()));
  ++client.bad_frames;
  client.closes = client.closes || client.bad_frames >= kMaxBadFrames;
}

void Service::Impl::takeWork() {
  for (Worker* const worker : {&reading, &reckoning}) {
    while (std::optional<std::pair<int, Worker::Then>> done = worker->take()) {
      Client* const client = find(done->first);
      if (client == nullptr) continue;
      done->second(*client);
      while (!client->held_back.empty() && !isAtWork(client->number)) {
        Frame next = std::move(client->held_back.front());
        client->held_back.pop_front();
        client->held_back_bytes -= next.text.size();
        receive(*client, std::move(next));
      }
    }
  }
}

void Service::Impl::reckon(const Client& client, std::function<std::string(const scene::Description&)> answer) {
  reckoning.add(client.number, [answer = std::move(answer), scene = host.scene()]() -> Worker::Then {
    return [text = answer(scene)](Client& its) { its.send(text); };
  });
}

}  // namespace underact::serve
