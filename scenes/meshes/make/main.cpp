#include <cstdio>
#include <filesystem>
#include <fstream>

#include "scenes/meshes/make/meshes.h"
#include "scenes/meshes/make/write.h"

// underact-make-meshes FOLDER...: writes the meshes of the scenes into each folder; one of each format, so that every
// reader has a scene that uses it.
namespace underact::mesh_maker {
namespace {

struct Kind {
  const char* name;
  Triangles (*make)(int faces);
  const char* ending;
  std::string (*write)(const mesh::Triangles& triangles);
};
constexpr Kind kKinds[] = {{"torus_knot", torusKnot, "stl", asStl},
                           {"bumpy_sphere", bumpySphere, "ply", asPly},
                           {"bracket", bracket, "obj", asObj}};
struct Size {
  const char* name;
  int faces;
};
constexpr Size kSizes[] = {{"1k", 1000}, {"20k", 20000}, {"300k", 300000}};

/// Under another name first: another build of the same sources may be writing the same file.
bool put(const std::filesystem::path& path, const std::string& bytes) {
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream file(part, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code problem;
  if (file) std::filesystem::rename(part, path, problem);
  if (file && !problem) return true;
  std::fprintf(stderr, "underact-make-meshes: %s could not be written.\n", path.string().c_str());
  return false;
}

bool makeAll(int folders, char** folder) {
  for (const Kind& kind : kKinds) {
    for (const Size& size : kSizes) {
      const std::string bytes = kind.write(kind.make(size.faces));
      for (int i = 0; i < folders; ++i) {
        std::error_code there;  // put() says what could not be written
        std::filesystem::create_directories(folder[i], there);
        const std::string name = std::string(kind.name) + "_" + size.name + "." + kind.ending;
        if (!put(std::filesystem::path(folder[i]) / name, bytes)) return false;
      }
    }
  }
  return true;
}

}  // namespace
}  // namespace underact::mesh_maker

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "Usage: underact-make-meshes FOLDER...\n");
    return 2;
  }
  return underact::mesh_maker::makeAll(count - 1, words + 1) ? 0 : 1;
}
