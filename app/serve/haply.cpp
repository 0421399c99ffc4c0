#include "app/serve/haply.h"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "app/serve/haply_state.h"
#include "core/scene/scene_arm.h"

namespace underact::serve {
namespace {

constexpr double kForceFor_s = 0.05;
constexpr double kSmooth_s = 0.01;        // velocities of joints: one step of an encoder in a tick is 23 deg/s
constexpr std::size_t kMaxWaiting = 100;  // messages for a client

HttpAnswer okAnswered(const json::ObjectText& data) {
  json::ObjectText text;
  text.addBool("ok", true);
  text.addObject("data", data);
  return {200, text.text()};
}

HttpAnswer refused(int status, const std::string& why) {
  json::ObjectText text;
  text.addBool("ok", false);
  text.addText("error", why);
  return {status, text.text()};
}

}  // namespace

struct HaplyService::Impl {
  explicit Impl(Service& served) : service(served) {}

  json::ObjectText state(bool is_full) const {
    return haply::stateText(service.lastTick(), turning, scene::armOf(service.scene()).geometry, session, is_full);
  }

  Service& service;
  haply::SessionWords session;
  int next_number = 1;
  std::optional<int> client;  // its connection, and
  int steers_as = 0;          // its number as a client of the service
  bool wants_state = false, wants_all = false;
  std::int64_t asked_at = 0;  // the newest tick then
  servo::TickRecord before;   // of the poll before
  Vec3 turning = Vec3::Zero();
  std::deque<Message> messages;
};

HaplyService::HaplyService(Service& service) : impl_(std::make_unique<Impl>(service)) {}

HaplyService::~HaplyService() {
  if (impl_->client) disconnect(*impl_->client);
}

int HaplyService::connect() {
  const int number = impl_->next_number++;
  if (impl_->client) return number;
  impl_->client = number;
  impl_->steers_as = impl_->service.join("haply");
  impl_->wants_state = impl_->wants_all = true;
  impl_->asked_at = 0;
  return number;
}

void HaplyService::disconnect(int connection) {
  if (impl_->client != connection) return;
  impl_->service.disconnect(impl_->steers_as);
  impl_->client.reset();
  impl_->messages.clear();
  impl_->wants_state = impl_->wants_all = false;
  impl_->session = {impl_->session.number + 1, "default"};
}

void HaplyService::receive(int connection, Frame frame, double) {
  if (impl_->client != connection) return;
  const Result<haply::Frame> read =
      frame.is_text && frame.text.size() <= kLongestAtOnce
          ? haply::readFrame(frame.text, impl_->session)
          : Result<haply::Frame>(Problems{{"A frame must be JSON text, of at most 16384 bytes."}});
  if (!read) {
    json::ObjectText answer;
    answer.addText("error", read.problems().front().sentence);
    if (impl_->messages.size() < kMaxWaiting) impl_->messages.push_back({answer.text(), false});
    return;
  }
  const haply::Frame& wish = read.value();
  impl_->session = wish.session;
  // Where another client steers, the force is not taken; the state is told all the same.
  if (wish.f_A) impl_->service.push(impl_->steers_as, haply::forceOf(wish.session.arm, *wish.f_A), kForceFor_s);
  impl_->wants_all = impl_->wants_all || wish.wants_all;
  impl_->wants_state = true;
  impl_->asked_at = impl_->service.lastTick().tick;
}

bool HaplyService::hasMessage(int connection) const {
  return impl_->client == connection && !impl_->messages.empty();
}

Message HaplyService::takeMessage(int) {
  Message message = std::move(impl_->messages.front());
  impl_->messages.pop_front();
  return message;
}

bool HaplyService::mayBeRead(int connection) const {
  return impl_->client == connection && impl_->messages.size() < kMaxWaiting;
}

bool HaplyService::closes(int connection) const {
  return impl_->client != connection;
}

void HaplyService::poll(double) {
  const servo::TickRecord& now = impl_->service.lastTick();
  if (const double passed_s = 1e-9 * static_cast<double>(now.time_ns - impl_->before.time_ns); passed_s > 0.0) {
    const Vec3 turned = haply::anglesOf(now) - haply::anglesOf(impl_->before);
    if (impl_->before.tick > 0)
      impl_->turning += std::min(1.0, passed_s / kSmooth_s) * (turned / passed_s - impl_->turning);
    impl_->before = now;
  }
  if (impl_->wants_state && now.tick > impl_->asked_at) {
    impl_->messages.push_back({impl_->state(impl_->wants_all).text(), false});
    impl_->wants_state = impl_->wants_all = false;
  }
}

bool HaplyService::isKnown(int connection) const {
  return impl_->client == connection;
}

bool HaplyService::isBusy() const {
  return impl_->client.has_value();
}

HttpAnswer HaplyService::answer(const HttpRequest& request) {
  const std::string path = request.target.substr(0, request.target.find('?'));
  const std::string session = "/sessions/" + std::to_string(impl_->session.number);
  if (path == "/version") return {200, haply::versionText().text()};
  if (path == "/devices") return {200, impl_->state(true).text()};
  if (path == "/sessions") {
    json::ObjectText list;
    list.addInteger("session_count", impl_->client ? 1 : 0);
    list.addList("sessions",
                 impl_->client ? std::vector{haply::sessionText(impl_->session)} : std::vector<json::ObjectText>{});
    return okAnswered(list);
  }
  if (path == session && request.method == "GET") return okAnswered(haply::sessionText(impl_->session));
  if (path == session + "/profile") {
    if (request.method == "POST") {
      const Result<haply::Frame> read =
          haply::readFrame("{\"session\": {\"configure\": {\"profile\": " + request.body + "}}}", impl_->session);
      if (!read || !read.value().names_profile) return refused(400, "A profile needs a name.");
      impl_->session.profile = read.value().session.profile;
    } else if (request.method == "DELETE") {
      impl_->session.profile = "default";
    }
    json::ObjectText profile;
    profile.addText("name", impl_->session.profile);
    return okAnswered(profile);
  }
  return refused(404, "There is no " + path + " here.");
}

}  // namespace underact::serve
