#include "core/record/laws.h"

#include <algorithm>
#include <array>
#include <variant>

namespace underact::record {
namespace {

struct Law {
  const char* name;
  int version;
  bool (*acts)(const scene::Constraint&);
};

constexpr std::array<Law, 2> kLaws{{
    // 2: after a slip the target slides on by the dynamic share. 1: it stuck again at once.
    {"friction", 2, [](const scene::Constraint& one) { return one.friction.has_value(); }},
    // 2: a contact ends only where no face lies between the proxy and the tip. 1: narrow gaps let the tip through.
    {"mesh_wall", 2,
     [](const scene::Constraint& one) {
       return std::holds_alternative<scene::Mesh>(one.shape) && one.side != target::Side::Both;
     }},
}};

int versionIn(const json::Value& provenance, const char* law) {
  const json::Value* const laws = provenance.find("laws");
  const json::Value* const version = laws != nullptr ? laws->find(law) : nullptr;
  return version != nullptr && version->kind == json::Kind::Number ? static_cast<int>(version->number) : 1;
}

}  // namespace

json::ObjectText lawVersions() {
  json::ObjectText versions;
  for (const Law& law : kLaws) versions.addInteger(law.name, law.version);
  json::ObjectText object;
  object.addObject("laws", versions);
  return object;
}

std::vector<std::string> mendedLaws(Session& session) {
  json::Value provenance;
  if (!session.provenance().empty()) {
    if (Result<json::Value> read = session.provenanceOf(session.provenance().front()))
      provenance = std::move(read).value();
  }
  std::vector<std::string> mended;
  for (const Law& law : kLaws) {
    if (versionIn(provenance, law.name) >= law.version) continue;
    const bool is_used = std::any_of(session.changes().begin(), session.changes().end(), [&](const ChangeRow& change) {
      const Result<scene::Description> scene = session.scene(change);
      return scene && std::any_of(scene.value().constraints.begin(), scene.value().constraints.end(), law.acts);
    });
    if (is_used) mended.emplace_back(law.name);
  }
  return mended;
}

}  // namespace underact::record
