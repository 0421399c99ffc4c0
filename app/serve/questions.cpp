// What a client asks and hears.
#include <underact/version.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/serve/scene_parts.h"
#include "app/serve/service_impl.h"
#include "app/serve/token.h"
#include "core/json/text.h"
#include "core/scene/scene_arm.h"
#include "core/scene/settings.h"
#include "core/scene/write.h"

namespace underact::serve {
namespace {

constexpr std::size_t kLongestName = 100;
constexpr std::size_t kShortestNonce = 32, kLongestNonce = 128;

/// In a time that does not depend on where they differ.
bool isSameToken(std::string_view given, std::string_view token) {
  unsigned difference = given.size() == token.size() ? 0U : 1U;
  for (std::size_t index = 0; index < token.size(); ++index) {
    const char one = index < given.size() ? given[index] : '\0';
    difference |= static_cast<unsigned char>(one) ^ static_cast<unsigned char>(token[index]);
  }
  return difference == 0U;
}

}  // namespace

void Service::Impl::hello(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> token = keys.text("token", kLongestWords);
  const std::optional<std::string> name = keys.text("name", kLongestName);
  if (!keys.areGood()) {
    refuse(client, request, keys.problems());
    client.closes = client.closes || !client.is_known;
    return;
  }
  if (client.is_known) return refuse(client, request, problemAt("/do", "You have said hello already."));
  const auto known = std::count_if(clients.begin(), clients.end(),
                                   [](const auto& one) { return one.second.is_known && !one.second.closes; });
  if (!isSameToken(*token, options.token)) {
    refuse(client, request,
           problemAt("/token", "This is not the token. It is in the file that the service named when it started."));
    client.closes = true;
    return;
  }
  if (static_cast<std::size_t>(known) >= kMaxClients) {
    refuse(client, request, problemAt("", "There are 8 clients already, and there cannot be more."));
    client.closes = true;
    return;
  }
  client.is_known = true;
  client.name = name->empty() ? "unnamed" : *name;
  json::ObjectText answer = okAnswer(request.id);
  answer.addInteger("version", kProtocolVersion);
  answer.addText("program", std::string("underact ") + kVersion);
  answer.addText("arm", host.scene().arm);
  answer.addInteger("rate_hz", host.rateHz());
  answer.addNumber("force_limit_N", scene::armOf(host.scene()).continuous_force_N * host.forceShare());
  answer.addText("mode", modeWord(last.mode));
  answer.addInteger("tick", last.tick);
  answer.addBool("may_steer", maySteer(client));
  client.send(answer.text());
}

void Service::Impl::challenge(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> nonce = keys.text("nonce", kLongestNonce);
  if (nonce && (nonce->size() < kShortestNonce ||
                !std::all_of(nonce->begin(), nonce->end(), [](unsigned char one) { return std::isxdigit(one) != 0; })))
    keys.add(request.root(), "nonce", "This must be 32 to 128 hexadecimal digits.");
  Problems problems = keys.areGood() ? Problems() : keys.problems();
  if (client.is_known || std::exchange(client.is_challenged, true))
    problems = problemAt("/do", "A challenge comes once, before \"hello\".");
  if (!problems.empty()) {
    refuse(client, request, problems);
    client.closes = client.closes || !client.is_known;
    return;
  }
  json::ObjectText answer = okAnswer(request.id);
  answer.addText("proof", proofOf(options.token, *nonce));
  client.send(answer.text());
}

void Service::Impl::tellScene(Client& client, const Request& request) {
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  reckon(client, [answer = okAnswer(request.id)](const scene::Description& scene) mutable {
    answer.addJson("scene", scene::writeScene(scene));
    return answer.text();
  });
}

void Service::Impl::tellSettings(Client& client, const Request& request) {
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  reckon(client, [answer = okAnswer(request.id)](const scene::Description& scene) mutable {
    answer.addJson("settings", settingsText(scene));
    return answer.text();
  });
}

void Service::Impl::get(Client& client, const Request& request) {
  const bool is_ready = request.values && request.revision == host.revision();
  const Result<std::string> values = is_ready ? *request.values : valuesFor(request, host.scene());
  if (!values) return refuse(client, request, values.problems());
  json::ObjectText answer = okAnswer(request.id);
  answer.addJson("values", values.value());
  client.send(answer.text());
}

void Service::Impl::tellStatus(Client& client, const Request& request) {
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  std::vector<std::string> names;
  for (const auto& [number, one] : clients) {
    if (one.is_known) names.push_back(one.name);
  }
  json::ObjectText answer = okAnswer(request.id);
  answer.addInteger("tick", last.tick);
  answer.addText("mode", modeWord(last.mode));
  answer.addInteger("revision", last.revision);
  answer.addInteger("rate_hz", host.rateHz());
  answer.addTexts("clients", names);
  if (holder || is_taken_back) answer.addText("steered_by", holderName());
  answer.addBool("may_steer", maySteer(client));
  if (const std::optional<RecordingNow> now = steered.recording()) {
    json::ObjectText recording;
    recording.addText("file", now->path);
    recording.addInteger("ticks", now->ticks);
    answer.addObject("recording", recording);
  }
  client.send(answer.text());
}

void Service::Impl::lease(Client& client, const Request& request) {
  Keys keys(request);
  const std::optional<std::string> what = keys.text("lease", 100);
  if (what && *what != "take" && *what != "give")
    keys.add(request.root(), "lease", "This must be \"take\" or \"give\".");
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  if (*what == "take") {
    if (const std::string why = whyNotSteer(client); !why.empty())
      return refuse(client, request, problemAt("/lease", why));
    take(client);
  } else if (holder == client.number) {
    giveBack();
  }
  json::ObjectText answer = okAnswer(request.id);
  answer.addBool("may_steer", maySteer(client));
  client.send(answer.text());
}

void Service::Impl::subscribe(Client& client, const Request& request) {
  Keys keys(request);
  const json::Value* const columns = keys.list("columns");
  const std::optional<double> hz = keys.number("hz", 1.0, host.rateHz());
  const bool has_format = request.root().find("format") != nullptr;
  const std::optional<std::string> format = keys.text("format", 100, false);
  if (format && *format != "json" && *format != "binary")
    keys.add(request.root(), "format", "This must be \"json\" or \"binary\".");
  std::vector<std::string> names;
  for (std::size_t at = 0; columns != nullptr && at < columns->items.size(); ++at) {
    if (columns->items[at].kind != json::JsonKind::String)
      keys.add(columns->items[at], "columns[" + std::to_string(at) + "]",
               "This must be the name of a column, as text.");
    else
      names.push_back(columns->items[at].text);
  }
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  const Result<std::vector<std::size_t>> found = findColumns(names);
  if (!found) return refuse(client, request, found.problems());
  const auto stride = std::max<std::int64_t>(1, std::llround(host.rateHz() / *hz));
  client.subscription.emplace(found.value(), stride,
                              has_format && *format == "binary" ? RowFormat::Binary : RowFormat::Json);
  json::ObjectText answer = okAnswer(request.id);
  answer.addList("columns", client.subscription->columnTexts());
  answer.addInteger("stride", stride);
  client.send(answer.text());
}

void Service::Impl::unsubscribe(Client& client, const Request& request) {
  Keys keys(request);
  if (!keys.areGood()) return refuse(client, request, keys.problems());
  client.subscription.reset();
  client.send(okAnswer(request.id).text());
}

}  // namespace underact::serve
