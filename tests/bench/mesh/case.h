#pragma once
#include <string>
#include <vector>

#include "core/base/types.h"
#include "core/mesh/triangles.h"

namespace underact::bench {

/// What every party is asked: a mesh, and two lists of points.
struct Case {
  mesh::Triangles triangles;
  std::vector<Vec3> random_M;  // each anywhere near the surface
  std::vector<Vec3> path_M;    // a hand's, tick by tick
};

/// As a file for other programs: three counts (corners, faces, points of each list; 32 bits), corners (floats), faces,
/// points (doubles). In this machine's byte order.
bool write(const Case& one, const std::string& path);
Case read(const std::string& path);

/// How long a list took, query by query, us.
struct Times {
  double p50_us = 0.0;
  double p99_us = 0.0;
};

/// What a party says of one of its ways to search; below 0: does not apply.
struct Line {
  std::string by;
  double build_ms = -1.0;
  double grown_MB = -1.0;  // memory of the process, before and after building
  double own_MB = -1.0;    // as the party itself counts
  Times random = {}, path = {};
  std::string note = {};
};

/// Asked and answered by lines of text, fields between bars.
std::string textOf(const Line& line);
bool lineOf(const std::string& text, Line& line);

/// Squared distances of both lists, one after the other, as doubles.
bool writeAnswers(const std::vector<double>& squared, const std::string& path);
std::vector<double> readAnswers(const std::string& path);

/// Memory of this process that is in use now, MB.
double memory_MB();

}  // namespace underact::bench
