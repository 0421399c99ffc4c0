#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <vector>

#include "scenes/meshes/make/meshes.h"
#include "tests/bench/mesh/case.h"
#include "tests/bench/mesh/party.h"
#include "tests/support/mesh_points.h"

// underact-mesh-bench [--python INTERPRETER] [--points N] [--most FACES]: nearest points of meshes, ours beside those
// of others, over the same points. Prints one table, asserts nothing.
namespace underact::bench {
namespace {

struct Options {
  std::string python;  // none: without FCPW and libigl
  int points = 10000;
  int min_faces = 0;
  int max_faces = 1310720;
};

Case caseOf(const mesh::Triangles& triangles, int points) {
  return {triangles, test::pointsNear(triangles, 5.0, points, test::Seed{20070701}),
          test::handPath(triangles, 1.0, points, test::Seed{20070702})};
}

std::vector<std::string> outputOf(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<std::string> lines;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) {
    lines.emplace_back(part.data());
    while (!lines.back().empty() && lines.back().back() == '\n') lines.back().pop_back();
  }
  return lines;
}

struct Told {
  Line line;
  std::vector<double> squared;
};

std::vector<Told> askAll(const Options& options, const std::filesystem::path& folder) {
  std::vector<std::string> programs;
  for (const char* name : {"ours", "cgal", "embree"}) {
    const std::string program = std::string(UNDERACT_BENCH_FOLDER "/underact-mesh-bench-") + name;
    if (std::filesystem::exists(program)) programs.push_back("'" + program + "'");
  }
  if (!options.python.empty()) programs.push_back("'" + options.python + "' '" UNDERACT_BENCH_SCRIPT "'");
  std::vector<Told> all;
  for (const std::string& program : programs) {
    const std::string answers = folder / "answers";
    int count = 0;
    for (const std::string& text : outputOf(program + " '" + (folder / "case").string() + "' '" + answers + "'")) {
      Told one;
      if (!lineOf(text, one.line)) continue;  // what a library says of itself
      one.squared = readAnswers(answers + "." + std::to_string(count++));
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// The largest difference of distance from the first of CGAL, or where it is not installed from our global search.
double offBy(const std::vector<Told>& all, const Told& one) {
  const auto by = [&](const char* name) {
    return std::find_if(all.begin(), all.end(), [&](const Told& told) { return told.line.by == name; });
  };
  const auto found = by("CGAL") != all.end() ? by("CGAL") : by("underact global");
  if (found == all.end() || found->squared.size() != one.squared.size()) return -1.0;
  double off = 0.0;
  for (std::size_t i = 0; i < one.squared.size(); ++i) {
    off = std::max(off, std::abs(std::sqrt(one.squared[i]) - std::sqrt(found->squared[i])));
  }
  return off;
}

void print(const char* mesh, std::size_t faces, const std::vector<Told>& all) {
  const auto cell = [](const char* format, double value) {
    value < 0.0 ? static_cast<void>(std::printf(" %8s", "-")) : static_cast<void>(std::printf(format, value));
  };
  for (const Told& one : all) {
    std::printf("%-7s %8zu  %-16s", mesh, faces, one.line.by.c_str());
    cell(" %8.0f", one.line.build_ms);
    cell(" %8.1f", one.line.grown_MB);
    cell(" %8.1f", one.line.own_MB);
    for (const double us : {one.line.random.p50_us, one.line.random.p99_us, one.line.path.p50_us, one.line.path.p99_us})
      cell(" %8.2f", us);
    cell(" %8.0e", offBy(all, one));
    std::printf("  %s\n", one.line.note.c_str());
    std::fflush(stdout);
  }
}

void compareAll(const Options& options) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("underact_mesh_bench_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::printf("Each query timed by itself; to read the clock costs %.3f us, which is taken off.\n", clockCost_us());
  std::printf("%-7s %8s  %-16s %8s %8s %8s %17s %17s %8s\n", "", "", "", "", "grown", "own", "random, us",
              "hand's path, us", "off");
  std::printf("%-7s %8s  %-16s %8s %8s %8s %8s %8s %8s %8s %8s\n", "mesh", "faces", "by", "build ms", "MB", "MB", "p50",
              "p99", "p50", "p99", "mm");
  const struct {
    const char* name;
    mesh::Triangles (*make)(int faces);
  } bodies[] = {{"sphere", mesh_maker::bumpySphere}, {"knot", mesh_maker::torusKnot}};
  for (const auto& body : bodies) {
    for (const int faces : {1000, 20480, 81920, 327680, 1310720}) {
      if (faces < options.min_faces || faces > options.max_faces) continue;
      const Case one = caseOf(body.make(faces), options.points);
      if (write(one, folder / "case")) print(body.name, one.triangles.faces.size(), askAll(options, folder));
    }
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace underact::bench

int main(int count, char** words) {
  underact::bench::Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    if (std::strcmp(words[i], "--python") == 0) options.python = words[i + 1];
    if (std::strcmp(words[i], "--points") == 0) options.points = std::max(100, std::atoi(words[i + 1]));
    if (std::strcmp(words[i], "--least") == 0) options.min_faces = std::atoi(words[i + 1]);
    if (std::strcmp(words[i], "--most") == 0) options.max_faces = std::atoi(words[i + 1]);
  }
  underact::bench::compareAll(options);
  return 0;
}
