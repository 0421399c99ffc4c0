#include "tests/core/mesh_file/some_meshes.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>

namespace underact::test {

using mesh::Face;
using mesh::Triangles;

Triangles cube(float edge, const Eigen::Vector3f& p_MC) {
  Triangles triangles;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3f corner(static_cast<float>(k & 1), static_cast<float>(k >> 1 & 1),
                                 static_cast<float>(k >> 2 & 1));
    triangles.p_MV.emplace_back(p_MC + edge * corner);
  }
  for (const std::array<int, 4>& quad : std::array<std::array<int, 4>, 6>{
           {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}}) {
    triangles.faces.push_back({quad[0], quad[1], quad[2]});
    triangles.faces.push_back({quad[0], quad[2], quad[3]});
  }
  return triangles;
}

Triangles ball(float radius, int levels) {
  Triangles triangles;
  for (const float sign : {1.0F, -1.0F}) {
    for (int axis = 0; axis < 3; ++axis) triangles.p_MV.emplace_back(sign * Eigen::Vector3f::Unit(axis));
  }
  for (int k = 0; k < 8; ++k) {
    Face face{k & 1 ? 3 : 0, k & 2 ? 4 : 1, k & 4 ? 5 : 2};
    if (((k & 1) ^ (k >> 1 & 1) ^ (k >> 2 & 1)) != 0) std::swap(face[1], face[2]);
    triangles.faces.push_back(face);
  }
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(triangles.p_MV.size()));
      if (is_new) {
        const Eigen::Vector3f sum =
            triangles.p_MV[static_cast<std::size_t>(a)] + triangles.p_MV[static_cast<std::size_t>(b)];
        triangles.p_MV.push_back(sum.normalized());
      }
      return at->second;
    };
    std::vector<Face> finer;
    for (const auto& [a, b, c] : triangles.faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {Face{a, ab, ca}, Face{ab, b, bc}, Face{ca, bc, c}, Face{ab, bc, ca}});
    }
    triangles.faces = std::move(finer);
  }
  for (Eigen::Vector3f& p_MV : triangles.p_MV) p_MV *= radius;
  return triangles;
}

Triangles sheet(int n) {
  Triangles triangles;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) triangles.p_MV.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0F);
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x, b = a + 1, c = a + n + 2, d = a + n + 1;
      triangles.faces.push_back({a, b, c});
      triangles.faces.push_back({a, c, d});
    }
  }
  return triangles;
}

Triangles joined(const Triangles& a, const Triangles& b) {
  Triangles both = a;
  both.p_MV.insert(both.p_MV.end(), b.p_MV.begin(), b.p_MV.end());
  for (Face face : b.faces) {
    for (std::int32_t& corner : face) corner += static_cast<std::int32_t>(a.p_MV.size());
    both.faces.push_back(face);
  }
  return both;
}

Triangles soup(const Triangles& triangles) {
  Triangles loose;
  for (const Face& face : triangles.faces) {
    const auto first = static_cast<std::int32_t>(loose.p_MV.size());
    for (const std::int32_t corner : face) loose.p_MV.push_back(triangles.p_MV[static_cast<std::size_t>(corner)]);
    loose.faces.push_back({first, first + 1, first + 2});
  }
  return loose;
}

Triangles turnedOver(Triangles triangles) {
  for (Face& face : triangles.faces) std::swap(face[1], face[2]);
  return triangles;
}

double volumeOf(const Triangles& triangles) {
  double volume = 0.0;
  for (const Face& face : triangles.faces) {
    const auto at = [&](std::size_t k) -> Vec3 {
      return triangles.p_MV[static_cast<std::size_t>(face[k])].cast<double>();
    };
    volume += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return volume;
}

double areaOf(const Triangles& triangles) {
  double area = 0.0;
  for (const Face& face : triangles.faces) {
    const auto at = [&](std::size_t k) -> Vec3 {
      return triangles.p_MV[static_cast<std::size_t>(face[k])].cast<double>();
    };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
  }
  return area;
}

namespace {

std::string text(float value) {
  std::array<char, 64> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string point(const Eigen::Vector3f& p) {
  return text(p.x()) + " " + text(p.y()) + " " + text(p.z());
}

std::string turned(std::string bytes, bool is_big) {
  if (is_big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string plyHead(const Triangles& triangles, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\nelement vertex " + std::to_string(triangles.p_MV.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(triangles.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

std::string bytesOf(const std::vector<float>& values) {
  std::string bytes(4 * values.size(), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string bytesOf(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string stlBinary(const Triangles& triangles, const std::string& head) {
  std::string file = head;
  file.resize(80, ' ');
  file += bytesOf(static_cast<std::uint32_t>(triangles.faces.size()));
  for (const Face& face : triangles.faces) {
    const auto at = [&](std::size_t k) { return triangles.p_MV[static_cast<std::size_t>(face[k])]; };
    const Eigen::Vector3f normal = (at(1) - at(0)).cross(at(2) - at(0));
    file += bytesOf(std::vector<float>{normal.x(), normal.y(), normal.z()});
    for (std::size_t k = 0; k < 3; ++k) file += bytesOf(std::vector<float>{at(k).x(), at(k).y(), at(k).z()});
    file += std::string(2, '\0');
  }
  return file;
}

std::string stlText(const Triangles& triangles) {
  std::string file = "solid by hand\n";
  for (const Face& face : triangles.faces) {
    file += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::int32_t corner : face) {
      file += "      vertex " + point(triangles.p_MV[static_cast<std::size_t>(corner)]) + "\n";
    }
    file += "    endloop\n  endfacet\n";
  }
  return file + "endsolid by hand\n";
}

std::string obj(const Triangles& triangles) {
  std::string file = "# by hand\no thing\n";
  for (const Eigen::Vector3f& p : triangles.p_MV) file += "v " + point(p) + "\n";
  for (const Face& face : triangles.faces) {
    file += "f";
    for (const std::int32_t corner : face) file += " " + std::to_string(corner + 1) + "//7";
    file += "\n";
  }
  return file;
}

std::string off(const Triangles& triangles) {
  std::string file = "OFF\n# by hand\n" + std::to_string(triangles.p_MV.size()) + " " +
                     std::to_string(triangles.faces.size()) + " 0\n";
  for (const Eigen::Vector3f& p : triangles.p_MV) file += point(p) + "\n";
  for (const auto& [a, b, c] : triangles.faces) {
    file += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return file;
}

std::string plyText(const Triangles& triangles) {
  std::string file = plyHead(triangles, "ascii");
  for (const Eigen::Vector3f& p : triangles.p_MV) file += point(p) + "\n";
  for (const auto& [a, b, c] : triangles.faces) {
    file += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return file;
}

std::string plyBinary(const Triangles& triangles, bool is_big) {
  std::string file = plyHead(triangles, is_big ? "binary_big_endian" : "binary_little_endian");
  for (const Eigen::Vector3f& p : triangles.p_MV) {
    for (const float x : p) file += turned(bytesOf(std::vector<float>{x}), is_big);
  }
  for (const Face& face : triangles.faces) {
    file += '\3';
    for (const std::int32_t corner : face) file += turned(bytesOf(static_cast<std::uint32_t>(corner)), is_big);
  }
  return file;
}

}  // namespace underact::test
