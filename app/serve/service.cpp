#include "app/serve/service.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/serve/service_impl.h"
#include "core/json/text.h"
#include "core/scene/scene_arm.h"

namespace underact::serve {
namespace {

constexpr double kAnswerWithin_s = 2.0;  // a servo that ticks answers in some milliseconds; a load waits for zero force
constexpr const char* kPerson = "window";

}  // namespace

const char* modeWord(servo::Mode mode) {
  switch (mode) {
    case servo::Mode::Running:
      return "running";
    case servo::Mode::Faulted:
      return "fault";
    case servo::Mode::Idle:
    case servo::Mode::Stopping:
      return "stopped";
  }
  return "stopped";
}

const std::array<Service::Impl::Command, 19> Service::Impl::kCommands{{
    {"hello", false, &Impl::hello},
    {"challenge", false, &Impl::challenge},
    {"scene", false, &Impl::tellScene},
    {"load", true, &Impl::load},
    {"settings", false, &Impl::tellSettings},
    {"get", false, &Impl::get},
    {"set", true, &Impl::set},
    {"start", true, &Impl::start},
    {"stop", false, &Impl::stop},
    {"force", true, &Impl::force},
    {"mark", false, &Impl::mark},
    {"record", true, &Impl::record},
    {"subscribe", false, &Impl::subscribe},
    {"unsubscribe", false, &Impl::unsubscribe},
    {"status", false, &Impl::tellStatus},
    {"lease", false, &Impl::lease},
    {"constraint.add", true, &Impl::add},
    {"constraint.remove", true, &Impl::remove},
    {"constraint.move", true, &Impl::move},
}};

void Service::Impl::perform(Client& client, const Request& request) {
  if (const Problems problems = request.general ? *request.general : generalProblems(request); !problems.empty()) {
    refuse(client, request, problems);
    client.closes = client.closes || !client.is_known;
    return;
  }
  if (!client.is_known && request.what != "hello" && request.what != "challenge") {
    refuse(client, request, problemAt("/do", "The first request must be \"hello\", with the token."));
    client.closes = true;
    return;
  }
  const auto command =
      std::find_if(kCommands.begin(), kCommands.end(), [&](const Command& one) { return request.what == one.name; });
  if (command == kCommands.end()) {
    std::vector<std::string> known;
    for (const Command& one : kCommands) known.emplace_back(one.name);
    const std::string nearest = json::nearestWord(request.what, known);
    const std::string what = request.root().find("do")->kind == json::JsonKind::String
                                 ? "There is no request " + json::shown(request.what) + "."
                                 : "\"do\" must be the name of a request, as text.";
    refuse(client, request, problemAt("/do", what + (nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?")));
    return;
  }
  if (command->steers) {
    if (const std::string why = whyNotSteer(client); !why.empty())
      return refuse(client, request, problemAt("/do", why + " \"stop\" is always allowed."));
    take(client);
  }
  (this->*command->perform)(client, request);
}

void Service::Impl::take(const Client& client) {
  if (holder == client.number) return;
  endForce();
  holder = client.number;
  json::ObjectText text = event("lease", last.tick);
  text.addBool("held", true);
  text.addText("by", client.name);
  tell(text);
}

void Service::Impl::giveBack() {
  endForce();
  holder.reset();
  json::ObjectText text = event("lease", last.tick);
  text.addBool("held", is_taken_back);
  if (is_taken_back) text.addText("by", kPerson);
  tell(text);
}

std::string Service::Impl::holderName() const {
  if (is_taken_back) return kPerson;
  return holder && clients.count(*holder) > 0 ? clients.at(*holder).name : "";
}

std::string Service::Impl::whyNotSteer(const Client& client) const {
  if (is_taken_back) return "The person at the window steers, and has to let programs steer again.";
  if (holder && *holder != client.number && !options.anyone_steers)
    return holderName() + " steers, and has to give the lease first.";
  return steered.refusal();
}

void Service::Impl::answerWaiting(const servo::TickRecord& record) {
  for (auto one = waiting.begin(); one != waiting.end();) {
    const bool still_runs = one->stops && record.mode == servo::Mode::Running && record.orders == one->orders;
    if (record.orders < one->orders || record.revision < one->revision || still_runs) {
      ++one;
      continue;
    }
    if (Client* const client = find(one->client)) {
      json::ObjectText answer = okAnswer(one->id);
      answer.addInteger("tick", record.tick);
      if (one->has_mode) answer.addText("mode", modeWord(record.mode));
      client->send(answer.text());
    }
    one = waiting.erase(one);
  }
}

void Service::Impl::tellEdit(std::int64_t tick, std::uint64_t revision, const Edit& edit) {
  json::ObjectText text = event("edit", tick);
  text.addInteger("revision", revision);
  text.addText("do", edit.what);
  text.addText("by", edit.by);
  tell(text);
}

void Service::Impl::tick(const servo::TickRecord& record) {
  const std::int64_t missing = last.tick > 0 ? record.tick - last.tick - 1 : 0;
  if (std::string_view(modeWord(record.mode)) != modeWord(last.mode)) {
    json::ObjectText text = event("mode", record.tick);
    text.addText("mode", modeWord(record.mode));
    tell(text);
  }
  std::uint64_t of_others = last.tick > 0 ? record.revision - last.revision : 0;
  while (!edits.empty() && edits.begin()->first <= record.revision) {
    tellEdit(record.tick, edits.begin()->first, edits.begin()->second);
    edits.erase(edits.begin());
    of_others -= of_others > 0 ? 1 : 0;
  }
  if (of_others > 0) tellEdit(record.tick, record.revision, {kPerson, "edit"});  // what no client did
  last = record;
  answerWaiting(record);
  std::vector<double> all;
  for (auto& [number, client] : clients) {
    if (!client.subscription || client.closes) continue;
    if (missing > 0) client.subscription->addMissing(missing);
    if (all.empty()) all = record::numbersOf(record, scene::armOf(host.scene()).geometry);
    client.subscription->add(record.tick, all);
  }
}

Service::Service(Steered& scene, ServiceOptions options) : impl_(std::make_unique<Impl>(scene, std::move(options))) {}

Service::~Service() = default;

void Service::add(const servo::TickRecord& record) {
  impl_->tick(record);
}

void Service::add(const Fault& fault, std::int64_t tick) {
  json::ObjectText text = impl_->event("fault", tick);
  text.addText("fault", underact::name(fault.kind));
  text.addText("sentence", describe(fault));
  impl_->tell(text);
}

int Service::connect() {
  const int number = impl_->next_number++;
  impl_->clients[number].number = number;
  return number;
}

int Service::join(const std::string& name) {
  const int number = connect();
  Client& client = impl_->clients[number];
  client.name = name;
  client.is_known = client.is_silent = true;
  return number;
}

bool Service::push(int connection, const Vec3& f_T_W, double for_s) {
  const Client& client = impl_->clients.at(connection);
  if (!impl_->maySteer(client)) return false;
  impl_->take(client);
  impl_->push(f_T_W, for_s);
  return true;
}

const servo::TickRecord& Service::lastTick() const {
  return impl_->last;
}

const scene::Description& Service::scene() const {
  return impl_->host.scene();
}

void Service::disconnect(int connection) {
  if (impl_->clients.erase(connection) == 0) return;
  impl_->reading.drop(connection);
  impl_->reckoning.drop(connection);
  if (impl_->holder == connection) impl_->giveBack();
}

void Service::receive(int connection, Frame frame, double now_s) {
  Client* const client = impl_->find(connection);
  if (client == nullptr || client->closes) return;
  impl_->now_s = now_s;
  impl_->receive(*client, std::move(frame));
}

bool Service::isKnown(int connection) const {
  const Client* const client = impl_->find(connection);
  return client != nullptr && client->is_known;
}

void Service::heed(Frame& frame, bool is_known) {
  frame.has_stopped = is_known && frame.is_text && glanceAt(frame.text).what == "stop";
  if (frame.has_stopped) ++impl_->host.stops();
  frame.stops = impl_->host.stops();
}

std::optional<std::string> Service::tooSoon(std::string_view text) const {
  return problemAnswer(
      glanceAt(text).id,
      problemAt("",
                "This is one request too many: at most 2000 requests and 4 MiB a second are taken, and "
                "as many may wait."));
}

bool Service::hasMessage(int connection) const {
  const Client* const client = impl_->find(connection);
  if (client == nullptr) return false;
  if (!client->messages.empty()) return true;
  if (client->closes) return false;
  const auto& subscription = client->subscription;
  return client->dropped_events > 0 || (subscription && (subscription->hasRows() || subscription->hasDropped()));
}

Message Service::takeMessage(int connection) {
  Client& client = impl_->clients.at(connection);
  if (!client.messages.empty()) {
    Message message = std::move(client.messages.front());
    client.messages.pop_front();
    client.message_bytes -= message.bytes.size();
    return message;
  }
  const std::int64_t rows = client.subscription ? client.subscription->takeDropped() : 0;
  if (rows == 0 && client.dropped_events == 0) return client.subscription->take();
  json::ObjectText text = impl_->event("lag", impl_->last.tick);
  text.addInteger("rows", rows);
  text.addInteger("events", std::exchange(client.dropped_events, 0));
  return {text.text(), false};
}

bool Service::mayBeRead(int connection) const {
  const Client* const client = impl_->find(connection);
  return client != nullptr && !client->closes && client->messages.size() < kMaxMessages &&
         client->message_bytes < kMaxMessageBytes;
}

bool Service::closes(int connection) const {
  const Client* const client = impl_->find(connection);
  return client == nullptr || client->closes;
}

void Service::poll(double now_s) {
  impl_->now_s = now_s;
  impl_->takeWork();
  impl_->host.snapshot();  // sends commands that are waiting
  impl_->steered.drain(*this);
  while (!impl_->waiting.empty() && now_s - impl_->waiting.front().since_s > kAnswerWithin_s) {
    const Waiting late = impl_->waiting.front();
    impl_->waiting.pop_front();
    if (Client* const client = impl_->find(late.client))
      client->send(problemAnswer(
          late.id, problemAt("",
                             "The servo has not taken this up within 2 s: it does not tick, or the force does not "
                             "come down.")));
  }
}

bool Service::isBusy() const {
  const auto subscribed = [](const auto& one) { return one.second.subscription.has_value(); };
  return !impl_->waiting.empty() || !impl_->reading.isEmpty() || !impl_->reckoning.isEmpty() ||
         std::any_of(impl_->clients.begin(), impl_->clients.end(), subscribed);
}

bool Service::hasClients() const {
  return std::any_of(impl_->clients.begin(), impl_->clients.end(),
                     [](const auto& one) { return one.second.is_known && !one.second.closes; });
}

std::vector<std::string> Service::clientNames() const {
  std::vector<std::string> names;
  for (const auto& [number, client] : impl_->clients) {
    if (client.is_known && !client.closes) names.push_back(client.name);
  }
  return names;
}

std::string Service::steeringClient() const {
  return impl_->is_taken_back ? "" : impl_->holderName();
}

void Service::takeBack(bool on) {
  if (std::exchange(impl_->is_taken_back, on) != on) impl_->giveBack();
}

bool Service::isTakenBack() const {
  return impl_->is_taken_back;
}

void Service::letGo() {
  impl_->endForce();
  impl_->host.stop();
}

bool Service::pushes() const {
  const servo::Mode mode = impl_->host.snapshot().mode;
  return mode == servo::Mode::Running || mode == servo::Mode::Stopping;
}

}  // namespace underact::serve
