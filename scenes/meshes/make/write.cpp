#include "scenes/meshes/make/write.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>

#include "core/base/types.h"

namespace underact::mesh_maker {
namespace {

const Eigen::Vector3f& corner(const mesh::Triangles& triangles, std::int32_t number) {
  return triangles.p_MV[static_cast<std::size_t>(number)];
}

void append(std::uint32_t number, std::string& bytes) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((number >> shift) & 0xFFU);
}

void append(const Eigen::Vector3f& p, std::string& bytes) {
  for (const float one : {p.x(), p.y(), p.z()}) append(std::bit_cast<std::uint32_t>(one), bytes);
}

Eigen::Vector3f normalOf(const mesh::Triangles& triangles, const mesh::Face& face) {
  const auto at = [&](std::size_t i) -> Vec3 { return corner(triangles, face[i]).cast<double>(); };
  return (at(1) - at(0)).cross(at(2) - at(0)).normalized().cast<float>();
}

template <class T>
void appendText(T number, std::string& text) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

}  // namespace

std::string asStl(const mesh::Triangles& triangles) {
  std::string bytes = "Made by underact-make-meshes, in millimetres";  // not "solid", which begins the text form
  bytes.resize(80, ' ');
  append(static_cast<std::uint32_t>(triangles.faces.size()), bytes);
  for (const mesh::Face& face : triangles.faces) {
    append(normalOf(triangles, face), bytes);
    for (const std::int32_t number : face) append(corner(triangles, number), bytes);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string asPly(const mesh::Triangles& triangles) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment made by underact-make-meshes, in millimetres\n";
  bytes += "element vertex " + std::to_string(triangles.p_MV.size()) + "\n";
  bytes += "property float x\nproperty float y\nproperty float z\n";
  bytes += "element face " + std::to_string(triangles.faces.size()) + "\n";
  bytes += "property list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) append(p_MV, bytes);
  for (const mesh::Face& face : triangles.faces) {
    bytes += '\3';
    for (const std::int32_t number : face) append(static_cast<std::uint32_t>(number), bytes);
  }
  return bytes;
}

std::string asObj(const mesh::Triangles& triangles) {
  std::string text = "# Made by underact-make-meshes, in millimetres\n";
  for (const Eigen::Vector3f& p_MV : triangles.p_MV) {
    text += 'v';
    for (const float one : {p_MV.x(), p_MV.y(), p_MV.z()}) appendText(one, text += ' ');
    text += '\n';
  }
  for (const mesh::Face& face : triangles.faces) {
    text += 'f';
    for (const std::int32_t number : face) appendText(number + 1, text += ' ');
    text += '\n';
  }
  return text;
}

}  // namespace underact::mesh_maker
