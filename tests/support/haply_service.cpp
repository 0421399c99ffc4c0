#include "tests/support/haply_service.h"

#include <deque>
#include <future>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "core/json/json.h"
#include "core/web_socket/connection.h"

namespace underact::test {
namespace {

std::string xyz(double x, double y, double z) {
  return "{\"x\": " + json::numberText(x) + ", \"y\": " + json::numberText(y) + ", \"z\": " + json::numberText(z) + "}";
}

std::string flag(bool on) {
  return on ? "true" : "false";
}

}  // namespace

struct HaplyService::Impl {
  struct Connection;

  explicit Impl(const Options& chosen) : options(chosen) {}
  void listen();
  void accept();
  std::string state(bool is_full);
  void take(const std::string& frame);

  const Options options;
  web_socket::EventLoop loop;
  web_socket::Listener listener{loop};
  std::set<std::shared_ptr<Connection>> connections;
  std::thread thread;
  int port = 0;
  mutable std::mutex mutex;  // of all below
  Vec3 p_WT{0.0, 0.0, 0.06};
  Mat3 R_WT = Mat3::Identity();
  Vec3 f_W = Vec3::Zero();
  bool button = false, is_frozen = false, is_unplugged = false, is_held = false;
  bool is_calibrated = true, has_power = true, is_ready = true;
  std::optional<std::string> instead;
  std::int64_t forces = 0, pushes = 0, frames = 0;
  int clients = 0, states = 0;
  std::string greeting;
};

struct HaplyService::Impl::Connection : std::enable_shared_from_this<Connection> {
  Connection(web_socket::Connection its_line, Impl& whose) : line(std::move(its_line)), service(whose) {}
  void begin() {
    line.readHeader([self = shared_from_this()](bool is_read) {
      if (!is_read) return self->end();
      if (self->line.request().is_upgrade) return self->greet();
      self->line.readBody([self](bool is_whole) { is_whole ? self->answerHttp() : self->end(); });
    });
  }
  void greet() {
    line.accept([self = shared_from_this()](bool is_accepted) {
      if (!is_accepted) return self->end();
      self->is_client = true;
      {
        const std::scoped_lock lock(self->service.mutex);
        ++self->service.clients;
        self->service.greeting.clear();
      }
      self->say(self->service.state(true));
      self->read();
    });
  }
  void answerHttp() {
    const std::string target = line.request().target;
    std::string body;
    if (target == "/version" && service.options.has_version)
      body = R"({"build_time": "", "git_branch": "", "git_describe": "", "git_hash": "", "git_tag": "",
                 "project_name": "stand-in", "project_version": ")" +
             service.options.version + "\"}";
    if (target == "/devices") body = service.state(true);
    line.respond(body.empty() ? 404 : 200, "", body, [self = shared_from_this()](bool) { self->end(); });
  }
  void read() {
    line.read([self = shared_from_this()](bool is_read, std::string_view frame, bool) {
      if (!is_read || self->is_over) return self->end();  // a frame that had come when it was ended
      self->service.take(std::string(frame));
      self->say(self->service.state(false));
      self->read();
    });
  }
  void say(std::string text) {
    if (text.empty()) return;
    waiting.push_back(std::move(text));
    if (waiting.size() == 1) write();
  }
  void write() {
    line.write(waiting.front(), false, [self = shared_from_this()](bool is_written) {
      if (!is_written) return self->end();
      self->waiting.pop_front();
      if (!self->waiting.empty()) self->write();
    });
  }
  void end() {
    is_over = true;
    line.end();
    if (service.connections.erase(shared_from_this()) == 0 || !is_client) return;
    const std::scoped_lock lock(service.mutex);
    if (--service.clients == 0) service.f_W.setZero();
  }

  web_socket::Connection line;
  Impl& service;
  std::deque<std::string> waiting;
  bool is_client = false, is_over = false;
};

void HaplyService::Impl::listen() {
  const std::string why = listener.open(port);
  if (!why.empty()) throw std::runtime_error(why);
  port = listener.port();
  accept();
}

void HaplyService::Impl::accept() {
  listener.accept([this](std::optional<web_socket::Connection> line) {
    if (!line) return;
    const auto connection = std::make_shared<Connection>(std::move(*line), *this);
    connections.insert(connection);
    connection->begin();
    accept();
  });
}

/// Theirs: x to the right, y away from the person, z up; (0, -0.12, 0.15) is the middle of W.
std::string HaplyService::Impl::state(bool is_full) {
  const std::scoped_lock lock(mutex);
  if (is_held) return {};
  if (instead) return *instead;
  if (is_unplugged) return R"({"inverse3": [], "verse_grip": [], "wireless_verse_grip": [], "session_id": 1})";
  const double tremor_m = is_frozen || states++ % 2 == 0 ? 0.0 : 1e-5;
  const Vec3 from_m = options.is_middle_origin ? Vec3::Zero() : Vec3(0.0, -0.12, 0.15);
  const std::string config =
      R"("config": {"type": "inverse3x", "device_info": {"id": ")" + options.id +
      R"(", "major_version": 7, "minor_version": 1, "device_type": 4, "uuid": "U"}, "port": "COM15",
         "extended_device_id": "9AB1", "extended_firmware_version": "8C20",
         "gravity_compensation": {"enabled": true, "scaling_factor": 0.75}, "handedness": "right",
         "torque_scaling": {"enabled": true}, "coordinate_origin": ")" +
      (options.is_middle_origin ? "workspace_center" : "device_base") + R"(", "basis": {"permutation": ")" +
      options.axes + "\"}}, ";
  std::string text = R"({"session_id": 1, "inverse3": [{"device_id": ")" + options.id + "\", ";
  if (is_full) text += config;
  text += R"("state": {"angular_position": {"a0": -89.5, "a1": 122.25, "a2": -22.75}, "cursor_position": )" +
          xyz(from_m.x() + p_WT.x() + tremor_m, from_m.y() - p_WT.z(), from_m.z() + p_WT.y()) +
          R"(, "cursor_velocity": {"x": 0, "y": 0, "z": 0}, "mode": "idle", "control_domain": "undefined",
              "control_mode": "idle"}, "status": {"calibrated": )" +
          flag(is_calibrated) + R"(, "in_use": false, "power_supply": )" + flag(has_power) + R"(, "ready": )" +
          flag(is_ready) + R"(, "started": true}}], "verse_grip": [], "wireless_verse_grip": [)";
  if (options.has_grip) {
    Mat3 R_HW;
    R_HW << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    const Eigen::Quaterniond q(R_HW * R_WT);
    if (is_full)
      text += R"({"device_id": "61576", "config": {"port": "COM5", "type": "wireless_verse_grip", "major_version": 1,
                 "minor_version": 0, "hardware_version": 3}, "state": )";
    else
      text += R"({"device_id": "61576", "state": )";
    text += R"({"battery_level": 0.83, "buttons": {"a": )" + flag(button) +
            R"(, "b": false, "c": false}, "hall": 0, "orientation": {"w": )" + json::numberText(q.w()) +
            ", \"x\": " + json::numberText(q.x()) + ", \"y\": " + json::numberText(q.y()) +
            ", \"z\": " + json::numberText(q.z()) +
            R"(}}, "status": {"ready": true, "connected": true, "awake": true}})";
  }
  return text + "]}";
}

void HaplyService::Impl::take(const std::string& frame) {
  const Result<json::Value> root = json::parse(frame, "");
  const std::scoped_lock lock(mutex);
  ++frames;
  if (greeting.empty()) greeting = frame;
  const json::Value* const arms = root ? root.value().find("inverse3") : nullptr;
  if (arms == nullptr || is_unplugged) return;
  for (const json::Value& arm : arms->items) {
    const json::Value* const id = arm.find("device_id");
    const json::Value* const commands = arm.find("commands");
    const json::Value* const force = commands != nullptr ? commands->find("set_cursor_force") : nullptr;
    const json::Value* const three =
        force != nullptr ? force->find(options.version < "3.5" ? "values" : "vector") : nullptr;
    if (id == nullptr || id->text != options.id || three == nullptr) continue;
    const Vec3 f_H(three->find("x")->number, three->find("y")->number, three->find("z")->number);
    f_W = Vec3(f_H.x(), f_H.z(), -f_H.y());
    ++forces;
    if (f_W != Vec3::Zero()) ++pushes;
  }
}

HaplyService::HaplyService() : HaplyService(Options{}) {}

HaplyService::HaplyService(const Options& options) : impl_(std::make_unique<Impl>(options)) {
  impl_->listen();
  impl_->thread = std::thread([this] { impl_->loop.run(); });
}

HaplyService::~HaplyService() {
  stop();
  impl_->loop.stop();
  impl_->thread.join();
}

int HaplyService::port() const {
  return impl_->port;
}

void HaplyService::stop() {
  std::promise<void> done;
  impl_->loop.post([&] {
    impl_->listener.close();
    const auto all = impl_->connections;
    for (const auto& connection : all) connection->end();
    done.set_value();
  });
  done.get_future().wait();
}

void HaplyService::start() {
  std::promise<void> done;
  impl_->loop.post([&] {
    impl_->listen();
    done.set_value();
  });
  done.get_future().wait();
}

void HaplyService::placeTip(const Vec3& p_WT) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->p_WT = p_WT;
}

void HaplyService::turnTip(const Mat3& R_WT) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->R_WT = R_WT;
}

void HaplyService::holdButton(bool held) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->button = held;
}

void HaplyService::freeze(bool on) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->is_frozen = on;
}

void HaplyService::unplugArm(bool on) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->is_unplugged = on;
  impl_->f_W.setZero();
}

void HaplyService::setStatus(bool calibrated, bool has_power, bool ready) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->is_calibrated = calibrated;
  impl_->has_power = has_power;
  impl_->is_ready = ready;
}

void HaplyService::hold(bool on) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->is_held = on;
}

void HaplyService::sayInstead(std::optional<std::string> text) {
  const std::scoped_lock lock(impl_->mutex);
  impl_->instead = std::move(text);
}

Vec3 HaplyService::force_N() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->f_W;
}

std::int64_t HaplyService::forces() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->forces;
}

std::int64_t HaplyService::pushes() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->pushes;
}

std::int64_t HaplyService::frames() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->frames;
}

std::string HaplyService::greeting() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->greeting;
}

std::string HaplyService::stateText(bool is_full) const {
  return impl_->state(is_full);
}

}  // namespace underact::test
