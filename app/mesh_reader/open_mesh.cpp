#include "app/mesh_reader/open_mesh.h"

// The only file of ours that includes OpenMesh.
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <istream>
#include <new>
#include <stdexcept>

#include "app/mesh_reader/text_stream.h"
#include "core/base/translate.h"
#include "core/base/types.h"

namespace underact::mesh_reader {
namespace {

namespace io = OpenMesh::IO;
using mesh_file::Format;

/// Takes vertices and faces from OpenMesh's readers as they are. OpenMesh's own meshes refuse faces at edges with more
/// than two of them, and a surface to be felt needs those as well.
class Taking : public io::BaseImporter {
 public:
  Taking(OpenMeshResult& result, const std::istream& from) : result_(result), from_(from) {}

  OpenMesh::VertexHandle add_vertex(const OpenMesh::Vec3f& p) override {
    const OpenMesh::VertexHandle handle = add_vertex();
    set_point(handle, p);
    return handle;
  }
  OpenMesh::VertexHandle add_vertex() override {
    result_.polygons.p_MV.emplace_back(0.0F, 0.0F, 0.0F);
    return OpenMesh::VertexHandle(static_cast<int>(result_.polygons.p_MV.size()) - 1);
  }
  void set_point(OpenMesh::VertexHandle handle, const OpenMesh::Vec3f& p) override {
    result_.polygons.p_MV[static_cast<std::size_t>(handle.idx())] = {p[0], p[1], p[2]};
  }
  OpenMesh::FaceHandle add_face(const VHandles& corners) override {
    // A stream that has failed returns the numbers of the face before.
    if (from_.fail()) has_broken_ = true;
    Polygons& polygons = result_.polygons;
    for (const OpenMesh::VertexHandle corner : corners) polygons.corners.push_back(corner.idx());
    polygons.ends.push_back(static_cast<std::int32_t>(polygons.corners.size()));
    return OpenMesh::FaceHandle(static_cast<int>(polygons.ends.size()) - 1);
  }
  /// Of the latest face.
  void set_normal(OpenMesh::FaceHandle /*face*/, const OpenMesh::Vec3f& normal) override {
    const Polygons& polygons = result_.polygons;
    const auto corner = [&](std::size_t k) -> Vec3 {
      const std::int32_t index = polygons.corners[polygons.corners.size() - 3 + k];
      return polygons.p_MV[static_cast<std::size_t>(index)].cast<double>();
    };
    const Vec3 turned = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double along = turned.dot(Vec3(normal[0], normal[1], normal[2]));
    if (along > 0.0 || along < 0.0) ++result_.normals;  // most are; 0 and NaN say nothing
    if (along < 0.0) ++result_.normals_against;
  }
  size_t n_vertices() const override { return result_.polygons.p_MV.size(); }
  size_t n_faces() const override { return result_.polygons.ends.size(); }
  size_t n_edges() const override { return 0; }
  bool hasBroken() const { return has_broken_; }

  // Not used.
  OpenMesh::HalfedgeHandle add_edge(OpenMesh::VertexHandle, OpenMesh::VertexHandle) override {
    return OpenMesh::HalfedgeHandle();
  }
  OpenMesh::FaceHandle add_face(OpenMesh::HalfedgeHandle) override { return OpenMesh::FaceHandle(); }
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle, const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(OpenMesh::FaceHandle, OpenMesh::VertexHandle, const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(OpenMesh::FaceHandle, int) override {}
  void set_halfedge(OpenMesh::VertexHandle, OpenMesh::HalfedgeHandle) override {}
  void set_normal(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_normal(OpenMesh::VertexHandle, const OpenMesh::Vec3d&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::VertexHandle, const OpenMesh::Vec4f&) override {}
  void set_texcoord(OpenMesh::VertexHandle, const OpenMesh::Vec2f&) override {}
  void set_status(OpenMesh::VertexHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_next(OpenMesh::HalfedgeHandle, OpenMesh::HalfedgeHandle) override {}
  void set_face(OpenMesh::HalfedgeHandle, OpenMesh::FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(OpenMesh::HalfedgeHandle, const OpenMesh::Vec2f&) override {}
  void set_texcoord(OpenMesh::VertexHandle, const OpenMesh::Vec3f&) override {}
  void set_texcoord(OpenMesh::HalfedgeHandle, const OpenMesh::Vec3f&) override {}
  void set_status(OpenMesh::HalfedgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::EdgeHandle, const OpenMesh::Vec4f&) override {}
  void set_status(OpenMesh::EdgeHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void set_normal(OpenMesh::FaceHandle, const OpenMesh::Vec3d&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec3uc&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec4uc&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec3f&) override {}
  void set_color(OpenMesh::FaceHandle, const OpenMesh::Vec4f&) override {}
  void set_status(OpenMesh::FaceHandle, const OpenMesh::Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  OpenMeshResult& result_;
  const std::istream& from_;
  bool has_broken_ = false;
};

io::BaseReader& readerOf(Format format) {
  switch (format) {
    case Format::StlBinary:
    case Format::StlText:
      return io::STLReader();
    case Format::Obj:
      return io::OBJReader();
    case Format::Ply:
      return io::PLYReader();
    case Format::Off:
      return io::OFFReader();
  }
  return io::STLReader();
}

io::Options optionsOf(Format format) {
  io::Options options;
  if (format == Format::StlBinary) options += io::Options::Binary;
  if (format == Format::StlBinary || format == Format::StlText) options += io::Options::FaceNormal;
  return options;
}

}  // namespace

OpenMeshResult readWithOpenMesh(Format format, const Prepared& prepared,
                                const std::function<void(double share)>& progress) {
  omerr().disable();
  omlog().disable();
  OpenMeshResult result;
  TextStream text(prepared.bytes, format == Format::Obj ? 2 : 1, progress);
  std::istream stream(&text);
  try {
    Taking taking(result, stream);
    io::Options options = optionsOf(format);
    const bool is_read = readerOf(format).read(stream, taking, options);
    const std::size_t corners = result.polygons.p_MV.size(), faces = result.polygons.ends.size();
    const bool shares = prepared.corners > 0 && corners != prepared.corners;
    if (!is_read || taking.hasBroken() || shares || faces > prepared.faces) {
      result.problem =
          phrase(TRANSLATE_NOOP("problem", "The file is damaged: reading stopped after %1 vertices and %2 faces."),
                 {std::to_string(corners), std::to_string(faces)});
    }
  } catch (const std::bad_alloc&) {
    result = {};
    result.problem = phrase(TRANSLATE_NOOP(
        "problem", "The file is damaged, or its faces take more memory than a file of its size should."));
  } catch (const std::exception&) {
    result.problem = phrase(TRANSLATE_NOOP("problem", "The file is damaged: OpenMesh could not read it."));
  }
  return result;
}

}  // namespace underact::mesh_reader
