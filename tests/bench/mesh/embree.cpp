#include <embree3/rtcore.h>

#include <cmath>
#include <cstring>

#include "tests/bench/mesh/party.h"

// Usage: underact-mesh-bench-embree CASE ANSWERS. Embree's tree, by a point query whose callback looks at one triangle,
// in floats, as its users do.
namespace underact::bench {
namespace {

using Point = Eigen::Vector3f;

/// The triangle's point nearest to q, by the region that q is in (Ericson 2005, 5.1.5).
Point nearestOf(const Point& a, const Point& b, const Point& c, const Point& q) {
  const Point ab = b - a, ac = c - a, aq = q - a, bq = q - b, cq = q - c;
  const float d1 = ab.dot(aq), d2 = ac.dot(aq), d3 = ab.dot(bq), d4 = ac.dot(bq), d5 = ab.dot(cq), d6 = ac.dot(cq);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const float vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float whole = 1.0F / (va + vb + vc);
  return a + vb * whole * ab + vc * whole * ac;
}

struct Best {
  const mesh::Triangles* triangles;
  Point q_M;
  float squared;
  unsigned face;
};

float squaredTo(const mesh::Triangles& triangles, unsigned face, const Point& q_M) {
  const mesh::Face& corners = triangles.faces[face];
  const auto at = [&](std::size_t i) -> const Point& { return triangles.p_MV[static_cast<std::size_t>(corners[i])]; };
  return (nearestOf(at(0), at(1), at(2), q_M) - q_M).squaredNorm();
}

bool lookAt(RTCPointQueryFunctionArguments* asked) {
  Best& best = *static_cast<Best*>(asked->userPtr);
  const float squared = squaredTo(*best.triangles, asked->primID, best.q_M);
  if (!(squared < best.squared)) return false;
  best.squared = squared;
  best.face = asked->primID;
  asked->query->radius = std::sqrt(squared);
  return true;
}

RTCScene sceneOf(RTCDevice device, const mesh::Triangles& triangles) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t corners = triangles.p_MV.size(), faces = triangles.faces.size();
  void* const places = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, corners);
  std::memcpy(places, triangles.p_MV.front().data(), 12 * corners);
  void* const numbers = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, faces);
  std::memcpy(numbers, triangles.faces.front().data(), 12 * faces);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcCommitGeometry(geometry);
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

struct AskScene {
  RTCScene scene;
  const mesh::Triangles* triangles;
  bool from_last;  // the last query's face bounds how far to look
  bool knows = false;
  unsigned last = 0;

  double operator()(const Vec3& q_M) {
    Best best{triangles, q_M.cast<float>(), INFINITY, last};
    if (from_last && knows) best.squared = squaredTo(*triangles, last, best.q_M);
    RTCPointQuery query{best.q_M.x(), best.q_M.y(), best.q_M.z(), 0.0F, std::sqrt(best.squared)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene, &query, &context, lookAt, &best);
    last = best.face;
    knows = true;
    return static_cast<double>(best.squared);
  }
};

}  // namespace
}  // namespace underact::bench

int main(int count, char** words) {
  using namespace underact::bench;
  if (count != 3) return 2;
  const Case one = read(words[1]);
  const RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;
  Line line = built("Embree", [&] { scene = sceneOf(device, one.triangles); });
  line.note = "floats";
  Teller teller(one, words[2]);
  teller.tell(line, AskScene{scene, &one.triangles, false});
  line.by = "Embree, warm";
  line.note = "floats; the last face bounds the search";
  teller.tell(line, AskScene{scene, &one.triangles, true});
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return 0;
}
