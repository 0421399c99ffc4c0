#include "core/record/laws.h"

#include <algorithm>
#include <array>
#include <variant>

#include "core/scene/scene_arm.h"

namespace underact::record {
namespace {

constexpr const char* kIntegratorLaw = "integrator";

struct Law {
  const char* name;
  int version;
  bool (*acts)(const scene::Constraint&);
};

constexpr std::array<Law, 3> kLaws{{
    // 2: after a slip the target slides on by the dynamic share. 1: it stuck again at once.
    {"friction", 2, [](const scene::Constraint& one) { return one.friction.has_value(); }},
    // 2: a contact ends only where no face lies between the proxy and the tip. 1: narrow gaps let the tip through.
    {"mesh_wall", 2,
     [](const scene::Constraint& one) {
       return std::holds_alternative<scene::Mesh>(one.shape) && one.side != target::Side::Both;
     }},
    // 2: every simulated arm takes the integrator of its scene. 1: other arms than the Omni's family took the velocity
    // at
    // the end. Nothing differs: a rerun does as its session's version did, see asIntegrated().
    {kIntegratorLaw, 2, [](const scene::Constraint&) { return false; }},
}};

int versionIn(const json::Value& provenance, const char* law) {
  const json::Value* const laws = provenance.find("laws");
  const json::Value* const version = laws != nullptr ? laws->find(law) : nullptr;
  return version != nullptr && version->kind == json::JsonKind::Number ? static_cast<int>(version->number) : 1;
}

/// What the first provenance of a session says; null where there is none.
json::Value firstProvenance(Session& session) {
  if (session.provenance().empty()) return {};
  Result<json::Value> read = session.provenanceOf(session.provenance().front());
  return read ? std::move(read).value() : json::Value{};
}

}  // namespace

json::ObjectText lawVersions() {
  json::ObjectText versions;
  for (const Law& law : kLaws) versions.addInteger(law.name, law.version);
  json::ObjectText object;
  object.addObject("laws", versions);
  return object;
}

scene::Description asIntegrated(Session& session, scene::Description scene) {
  const bool is_old = versionIn(firstProvenance(session), kIntegratorLaw) < 2;
  if (is_old && !arm::solvesInTick(scene::armOf(scene).geometry)) scene.simulation.integrator = Integrator::EndVelocity;
  return scene;
}

std::vector<std::string> mendedLaws(Session& session) {
  const json::Value provenance = firstProvenance(session);
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
