#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/scene_file.h"
#include "core/base/printed.h"
#include "core/json/json.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/report.h"
#include "core/system/named_file.h"
#include "core/system/signals.h"

namespace underact::cli {
namespace {

struct MeshOptions {
  std::vector<std::string> files;
  bool json = false;
  double scale_mm_per_unit = 0.0;  // 0: not given, so 1, with a question if that is implausible
};

struct Timed {
  mesh_file::Loaded loaded;
  double seconds = 0.0;
};

double scaleOf(const MeshOptions& options) {
  return options.scale_mm_per_unit > 0.0 ? options.scale_mm_per_unit : 1.0;
}

std::optional<mesh_file::Proposal> proposalOf(const MeshOptions& options, const mesh_file::Facts& facts) {
  if (options.scale_mm_per_unit > 0.0) return {};
  return mesh_file::implausible(mesh_file::largestExtent(facts));
}

std::array<double, 3> sizeOf(const mesh_file::Facts& facts, double scale) {
  std::array<double, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis) size[axis] = (facts.high[axis] - facts.low[axis]) * scale;
  return size;
}

std::vector<std::string> sidesOf(const mesh_file::Facts& facts) {
  return mesh_file::allowsWalls(facts) ? std::vector<std::string>{"both", "outside", "inside"}
                                       : std::vector<std::string>{"both"};
}

void printAsJson(const std::string& path, const Timed& timed, const MeshOptions& options, std::ostream& out) {
  const mesh_file::Facts& facts = timed.loaded.facts;
  const double scale = scaleOf(options);
  JsonObject object;
  object.addText("file", path);
  object.addText("format", mesh_file::nameOf(timed.loaded.format));
  object.addText("checksum", timed.loaded.checksum);
  object.addNumber("scale_mm_per_unit", scale);
  object.addList("size_mm", sizeOf(facts, scale));
  object.addInteger("faces", facts.faces);
  object.addInteger("corners", facts.corners);
  object.addInteger("parts", facts.parts);
  object.addBool("closed", mesh_file::isClosed(facts));
  object.addNumber("area_mm2", facts.area * scale * scale);
  object.addNumber("volume_mm3", facts.volume * scale * scale * scale);
  for (const auto& [key, count] :
       std::array<std::pair<const char*, std::int64_t>, 14>{{{"faces_in_file", facts.file_faces},
                                                             {"dropped_not_finite", facts.not_finite},
                                                             {"dropped_out_of_range", facts.out_of_range},
                                                             {"dropped_without_extent", facts.without_extent},
                                                             {"dropped_duplicates", facts.duplicates},
                                                             {"welded_corners", facts.welded},
                                                             {"turned_faces", facts.turned},
                                                             {"added_at_seams", facts.added_at_seams},
                                                             {"hollows", facts.hollows},
                                                             {"borders", facts.borders},
                                                             {"border_edges", facts.border_edges},
                                                             {"crowded_edges", facts.crowded_edges},
                                                             {"clashing_edges", facts.clashing_edges},
                                                             {"flat_faces", facts.flat_faces}}}) {
    object.addInteger(key, count);
  }
  object.addInteger("crossings", facts.crossings);
  object.addBool("crossings_checked", facts.crossings_checked != 0);
  object.addBool("united", facts.inside == mesh_file::Inside::United);
  object.addInteger("felt_faces", facts.felt_faces);
  object.addInteger("felt_corners", facts.felt_corners);
  object.addInteger("faces_within", facts.within);
  object.addInteger("closed_holes", facts.closed_holes);
  object.addTexts("sides", sidesOf(facts));
  const std::vector<Sentence> report = mesh_file::reportOf(facts, scale);
  object.addTexts("report", {report.begin(), report.end()});
  const std::optional<mesh_file::Proposal> proposal = proposalOf(options, facts);
  proposal ? object.addText("unit_question", proposal->sentence) : object.addNull("unit_question");
  std::vector<double> scales;
  for (const mesh_file::Unit& unit : proposal ? proposal->units : std::vector<mesh_file::Unit>{}) {
    scales.push_back(unit.mm_per_unit);
  }
  object.addList("unit_scales_mm", scales);
  object.addBool("from_cache", timed.loaded.from_cache);
  object.addNumber("seconds", timed.seconds);
  out << object.text() << '\n';
}

void printAsTable(const std::string& path, const Timed& timed, const MeshOptions& options, std::ostream& out) {
  const mesh_file::Facts& facts = timed.loaded.facts;
  const auto row = [&out](const std::string& what) -> std::ostream& {
    return out << std::left << std::setw(16) << what;
  };
  const std::array<double, 3> size_mm = sizeOf(facts, scaleOf(options));
  row("file") << printed(path) << '\n';
  row("format") << mesh_file::nameOf(timed.loaded.format) << '\n';
  row("size") << json::numberText(std::round(size_mm[0] * 1e3) / 1e3) << " x "
              << json::numberText(std::round(size_mm[1] * 1e3) / 1e3) << " x "
              << json::numberText(std::round(size_mm[2] * 1e3) / 1e3) << " mm\n";
  row("faces") << facts.faces << " (" << facts.file_faces << " in the file)\n";
  row("corners") << facts.corners << '\n';
  row("parts") << facts.parts << '\n';
  if (facts.inside == mesh_file::Inside::United)
    row("felt") << facts.felt_faces << " faces, " << facts.felt_corners << " corners\n";
  row("sides") << (mesh_file::allowsWalls(facts) ? "both, outside, inside" : "both") << '\n';
  row("loaded") << json::numberText(std::round(timed.seconds * 1e3) / 1e3) << " s"
                << (timed.loaded.from_cache ? ", from the cache" : "") << '\n';
  for (const std::string& sentence : mesh_file::reportOf(facts, scaleOf(options)))
    out << "  " << printed(sentence) << '\n';
  if (const auto proposal = proposalOf(options, facts)) {
    out << "  " << printed(proposal->sentence) << '\n';
    for (const mesh_file::Unit& unit : proposal->units) {
      out << "  For " << unit.name << ": \"scale_mm_per_unit\": " << json::numberText(unit.mm_per_unit) << '\n';
    }
  }
}

/// A file that cannot be opened is a file error; one that is not a mesh is bad input.
Exit exitOfMesh(const std::string& path) {
  return system::NamedFile::open(path, "a mesh") ? Exit::BadInput : Exit::File;
}

Exit showMeshes(const MeshOptions& options, const Streams& streams) {
  Exit exit = Exit::Success;
  const system::Interrupt interrupt;
  std::atomic<bool> cancelled = false;
  for (const std::string& path : options.files) {
    Progress progress(streams);
    TaskMonitor monitor;
    monitor.cancelled = &cancelled;
    monitor.progress = [&](const char* /*step*/, double share) {
      progress.show(share);
      cancelled = cancelled || interrupt.came();
    };
    const auto start = std::chrono::steady_clock::now();
    Result<mesh_file::Loaded> loaded = mesh_file::loadMesh(path, monitor);
    if (!loaded) {
      print(loaded.problems(), streams.err);
      const Exit now = exitOfMesh(path);
      if (exit != Exit::File) exit = now;
      if (interrupt.came()) break;
      continue;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Timed timed{std::move(loaded).value(), seconds};
    options.json ? printAsJson(path, timed, options, streams.out) : printAsTable(path, timed, options, streams.out);
  }
  return exit;
}

}  // namespace

void addMesh(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add("mesh", "Mesh files: their contents, repairs, and how they can be felt");
  command.mustChoose();
  const Command showing = command.add(
      "info", "Load meshes (STL, OBJ, PLY, OFF) as a scene would, and report what was found and what was repaired");
  const auto options = std::make_shared<MeshOptions>();
  showing.option("files", options->files, "Mesh files").required();
  showing.flag("--json", options->json, "One JSON object per file instead of a table");
  showing.option("--scale_mm_per_unit", options->scale_mm_per_unit, "Length of the file's unit, mm").positive();
  showing.whenChosen([options, &streams, &exit] { exit = showMeshes(*options, streams); });
}

}  // namespace underact::cli
