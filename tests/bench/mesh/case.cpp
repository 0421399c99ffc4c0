#include "tests/bench/mesh/case.h"

#include <malloc.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace underact::bench {
namespace {

template <class T>
void put(std::ofstream& file, const T* first, std::size_t count) {
  file.write(reinterpret_cast<const char*>(first), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T>
void get(std::ifstream& file, T* first, std::size_t count) {
  file.read(reinterpret_cast<char*>(first), static_cast<std::streamsize>(count * sizeof(T)));
}

}  // namespace

bool write(const Case& one, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  const std::array<std::uint32_t, 3> counts{static_cast<std::uint32_t>(one.triangles.p_MV.size()),
                                            static_cast<std::uint32_t>(one.triangles.faces.size()),
                                            static_cast<std::uint32_t>(one.random_M.size())};
  put(file, counts.data(), counts.size());
  for (const Eigen::Vector3f& p_MV : one.triangles.p_MV) put(file, p_MV.data(), 3);
  for (const mesh::Face& face : one.triangles.faces) put(file, face.data(), 3);
  for (const Vec3& q_M : one.random_M) put(file, q_M.data(), 3);
  for (const Vec3& q_M : one.path_M) put(file, q_M.data(), 3);
  return file.good();
}

Case read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<std::uint32_t, 3> counts{};
  get(file, counts.data(), counts.size());
  Case one;
  one.triangles.p_MV.resize(counts[0]);
  one.triangles.faces.resize(counts[1]);
  one.random_M.resize(counts[2]);
  one.path_M.resize(counts[2]);
  for (Eigen::Vector3f& p_MV : one.triangles.p_MV) get(file, p_MV.data(), 3);
  for (mesh::Face& face : one.triangles.faces) get(file, face.data(), 3);
  for (Vec3& q_M : one.random_M) get(file, q_M.data(), 3);
  for (Vec3& q_M : one.path_M) get(file, q_M.data(), 3);
  return one;
}

std::string textOf(const Line& line) {
  std::ostringstream text;
  text << line.by << '|' << line.build_ms << '|' << line.grown_MB << '|' << line.own_MB << '|' << line.random.p50_us
       << '|' << line.random.p99_us << '|' << line.path.p50_us << '|' << line.path.p99_us << '|' << line.note;
  return text.str();
}

bool lineOf(const std::string& text, Line& line) {
  std::istringstream fields(text);
  if (!std::getline(fields, line.by, '|')) return false;
  char bar = 0;
  fields >> line.build_ms >> bar >> line.grown_MB >> bar >> line.own_MB >> bar >> line.random.p50_us >> bar >>
      line.random.p99_us >> bar >> line.path.p50_us >> bar >> line.path.p99_us >> bar;
  std::getline(fields, line.note);
  return bar == '|';
}

bool writeAnswers(const std::vector<double>& squared, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  put(file, squared.data(), squared.size());
  return file.good();
}

std::vector<double> readAnswers(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  std::vector<double> squared(file ? static_cast<std::size_t>(file.tellg()) / sizeof(double) : 0U);
  file.seekg(0);
  get(file, squared.data(), squared.size());
  return squared;
}

double memory_MB() {
  malloc_trim(0);  // what was given back to malloc is not in use
  std::ifstream file("/proc/self/statm");
  double pages = 0.0, resident = 0.0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace underact::bench
