// What a client says that the stylus is held to.
#include <algorithm>
#include <cmath>

#include "app/serve/scene_parts.h"
#include "app/serve/service_impl.h"
#include "core/json/text.h"
#include "core/json/value_text.h"
#include "core/scene/all_settings.h"
#include "core/scene/scene_arm.h"

namespace underact::serve {
namespace {

constexpr double kLongestForce_ms = 1000.0, kDefaultForce_ms = 50.0;
constexpr double kLongestWay_ms = 60'000.0;
constexpr double kMaxForce_N = 1e6;  // what the gate lets through is far less

}  // namespace

void Service::Impl::open(const Client& client, const Request& request, const std::string& root,
                         std::function<Result<Opened>()> read) {
  reading.add(client.number,
              [this, short_one = Request{request.id, request.what}, root, read = std::move(read)]() -> Worker::Then {
                return [this, short_one, root, opened = read()](Client& its) { finish(its, short_one, root, opened); };
              });
}

void Service::Impl::load(Client& client, const Request& request) {
  Keys keys(request);
  const json::Value* const scene = keys.object("scene", false);
  const std::optional<std::string> file = keys.text("file", kLongestWords, false);
  const bool has_file = request.root().find("file") != nullptr;
  if (scene != nullptr && has_file) keys.add(*scene, "scene", "Give either \"scene\" or \"file\", not both.");
  if (request.root().find("scene") == nullptr && !has_file)
    keys.add(request.root(), "scene", "Give the scene, as \"scene\" or as the name of a \"file\".");
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  open(client, request, scene != nullptr ? "/scene" : "/file",
       [whole = request.read, scene, name = file.value_or(""), beside = host.scene().file]() -> Result<Opened> {
         Result<scene::Description> opened = scene == nullptr ? openScene(name) : sceneOf(json::textOf(*scene), beside);
         if (!opened) return opened.problems();
         return Opened{std::move(opened).value()};
       });
}

void Service::Impl::add(Client& client, const Request& request) {
  Keys keys(request);
  const json::Value* const constraint = keys.object("constraint");
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  open(client, request, "/constraint", [whole = request.read, constraint, scene = host.scene()]() -> Result<Opened> {
    Result<scene::Constraint> opened = readConstraint(scene, *constraint);
    if (!opened) return opened.problems();
    return Opened{{}, std::move(opened).value(), constraint->find("name") != nullptr};
  });
}

void Service::Impl::finish(Client& client, const Request& request, const std::string& root,
                           const Result<Opened>& opened) {
  // The path of a scene file's problem leads into that file, not into the request.
  const std::string within = root == "/file" ? "" : root;
  if (!opened) {
    Problems problems = below(within, opened.problems());
    if (within.empty())
      for (Problem& problem : problems) {
        if (problem.place.key.empty()) problem.place.key = "/file";
      }
    return refuse(client, request, problems);
  }
  if (const std::string why = whyNotSteer(client); !why.empty()) return refuse(client, request, problemAt("/do", why));
  take(client);
  if (opened.value().scene) {
    const scene::Description& scene = *opened.value().scene;
    if (!scene::haveSameArm(scene, host.scene()))
      return refuse(client, request,
                    problemAt(within + "/arm", "This service runs the arm " + json::shown(host.scene().arm) +
                                                   ". For a scene of another arm, start another service."));
    const Problems problems = steered.load(scene, client.name);
    if (!problems.empty()) return refuse(client, request, below(within, problems));
    edits[host.revision()] = {client.name, "load"};
    waitForTick(client, request.id);
    waiting.back().revision = host.revision();
    return;
  }
  const Result<scene::Description> edited =
      withConstraint(host.scene(), *opened.value().constraint, opened.value().is_named);
  if (!edited) return refuse(client, request, below(within, edited.problems()));
  edit(client, request, edited.value());
}

void Service::Impl::edit(Client& client, const Request& request, const scene::Description& edited,
                         std::int64_t over_ticks) {
  const Problems problems = steered.edit(edited, over_ticks, client.name);
  if (!problems.empty()) return refuse(client, request, problems);
  edits[host.revision()] = {client.name, request.what};
  waitForTick(client, request.id);
  waiting.back().revision = host.revision();
}

void Service::Impl::set(Client& client, const Request& request) {
  const bool is_ready = request.edited && request.revision == host.revision();
  const Result<scene::Description> edited = is_ready ? *request.edited : editedBy(request, host.scene());
  if (!edited) return refuse(client, request, edited.problems());
  edit(client, request, edited.value());
}

void Service::Impl::start(Client& client, const Request& request) {
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  if (request.stops != host.stops())
    return refuse(client, request,
                  problemAt("/do", "The servo was stopped after this request had come. Send it again."));
  host.start();
  waitForTick(client, request.id, true);
}

void Service::Impl::stop(Client& client, const Request& request) {
  if (!request.has_stopped) host.stop();  // whatever else the request says
  endForce();
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  waitForTick(client, request.id, true);
  waiting.back().stops = true;
}

void Service::Impl::force(Client& client, const Request& request) {
  Keys keys(request);
  const json::Value* const list = keys.list("f_N");
  Vec3 f_T_W = Vec3::Zero();
  bool are_three = list != nullptr && list->items.size() == 3;
  for (std::size_t axis = 0; are_three && axis < 3; ++axis) {
    are_three = list->items[axis].kind == json::JsonKind::Number;
    f_T_W[static_cast<Eigen::Index>(axis)] = list->items[axis].number;
  }
  if (list != nullptr && !are_three) keys.add(*list, "f_N", "This must be a list of 3 numbers, N, for x, y and z.");
  if (are_three && f_T_W.cwiseAbs().maxCoeff() > kMaxForce_N)
    keys.add(*list, "f_N", "Each number must be from -1e6 to 1e6 N; the gate clamps to the arm's limit.");
  const bool has_time = request.root().find("for_ms") != nullptr;
  const std::optional<double> for_ms = keys.number("for_ms", 1.0, kLongestForce_ms, false);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const double wanted_ms = has_time ? *for_ms : kDefaultForce_ms;
  push(f_T_W, 1e-3 * wanted_ms);
  waitForTick(client, request.id);
}

void Service::Impl::remove(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> name = keys.text("name", kLongestWords);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const Result<scene::Description> edited = withoutConstraint(host.scene(), *name);
  if (!edited) return refuse(client, request, edited.problems());
  edit(client, request, edited.value());
}

void Service::Impl::move(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> name = keys.text("name", kLongestWords);
  const json::Value* const values = keys.object("values");
  const std::optional<double> over_ms = keys.number("over_ms", 0.0, kLongestWay_ms, false);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const std::int64_t ticks = std::llround(1e-3 * over_ms.value_or(0.0) * host.rateHz());
  const Result<scene::Description> edited = withMoved(host.scene(), *name, *values, ticks > 0);
  if (!edited) return refuse(client, request, edited.problems());
  edit(client, request, edited.value(), ticks);
}

}  // namespace underact::serve
