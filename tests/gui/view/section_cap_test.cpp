#include "app/gui/view/section_cap.h"

#include <gtest/gtest.h>
#include <vtkCell.h>

#include <cmath>
#include <map>

#include "app/gui/view/mesh_picture.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"
#include "core/mesh/surface.h"

namespace underact::gui {
namespace {

const Eigen::Matrix4d kThere = Eigen::Matrix4d::Identity();

/// A ball of squares halved, closed; inwards: as a hollow has it.
mesh::Triangles ball(double radius, const Vec3& middle, int sectors, int rings, bool inwards = false) {
  mesh::Triangles made;
  const auto at = [&](int ring, int sector) {
    if (ring == 0) return 0;
    return ring == rings ? 1 : 2 + (ring - 1) * sectors + sector % sectors;
  };
  const auto add = [&](double up_rad, double around_rad) {
    const Vec3 out(std::cos(up_rad) * std::cos(around_rad), std::cos(up_rad) * std::sin(around_rad), std::sin(up_rad));
    made.p_MV.push_back((middle + radius * out).cast<float>());
  };
  add(-kPi / 2, 0.0);
  add(kPi / 2, 0.0);
  for (int ring = 1; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector)
      add(kPi * (static_cast<double>(ring) / rings - 0.5), 2.0 * kPi * sector / sectors);
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const int a = at(ring, sector), b = at(ring, sector + 1), c = at(ring + 1, sector + 1), d = at(ring + 1, sector);
      if (ring > 0) made.faces.push_back({a, b, c});
      if (ring + 1 < rings) made.faces.push_back({a, c, d});
    }
  }
  if (inwards) {
    for (mesh::Face& face : made.faces) std::swap(face[1], face[2]);
  }
  return made;
}

mesh::Triangles together(mesh::Triangles one, const mesh::Triangles& other) {
  const auto first = static_cast<std::int32_t>(one.p_MV.size());
  one.p_MV.insert(one.p_MV.end(), other.p_MV.begin(), other.p_MV.end());
  for (const mesh::Face& face : other.faces) one.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  return one;
}

Vec3 pointOf(vtkPolyData* data, vtkIdType cell, int corner) {
  return Eigen::Map<const Vec3>(data->GetPoint(data->GetCell(cell)->GetPointId(corner)));
}

/// Of the face, without what its rows go over each other.
double area_mm2(const SectionCap& cap, int axis, double height_mm) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double area = 0.0;
  for (vtkIdType cell = 0; cell < cap.face()->GetNumberOfCells(); ++cell) {
    const Vec3 a = pointOf(cap.face(), cell, 0), b = pointOf(cap.face(), cell, 1), c = pointOf(cap.face(), cell, 2),
               d = pointOf(cap.face(), cell, 3);
    const double over_mm = 0.5 * SectionCap::kRow * height_mm;
    area += 0.5 * (b[u] - a[u] + c[u] - d[u]) * (c[v] - b[v] - over_mm);
  }
  return area;
}

/// What the outline goes round, by Green: a hollow's counts below zero.
double roundArea_mm2(const SectionCap& cap, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double area = 0.0;
  for (vtkIdType cell = 0; cell < cap.outline()->GetNumberOfCells(); ++cell) {
    const Vec3 a = pointOf(cap.outline(), cell, 0), b = pointOf(cap.outline(), cell, 1);
    area += 0.5 * (a[u] * b[v] - a[v] * b[u]);
  }
  return std::abs(area);
}

/// Half a row at each end of each of its parts, as wide as the whole.
double tolerance_mm2(double width_mm, double height_mm, std::size_t rounds) {
  return 2.0 * static_cast<double>(rounds) * SectionCap::kRow * height_mm * width_mm;
}

SectionCap capOf(const mesh::Triangles& triangles, const Eigen::Matrix4d& X, int axis, double at_mm) {
  SectionCap cap;
  cap.add(triangles, X, axis, at_mm, true);
  cap.done();
  return cap;
}

}  // namespace

TEST(SectionCap, ABallsFaceIsTheDiscThatItsOutlineGoesRound) {
  const mesh::Triangles triangles = ball(30.0, {1.0, -2.0, 3.0}, 96, 48);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at_mm : {-20.0, 0.0, 3.0, 17.0}) {
      const SectionCap cap = capOf(triangles, kThere, axis, at_mm);
      const double off_mm = at_mm - Vec3(1.0, -2.0, 3.0)[axis], radius_mm = std::sqrt(900.0 - off_mm * off_mm);
      const double round_mm2 = roundArea_mm2(cap, axis);
      // Flat faces between points of the ball lie at most r (1 - cos(pi / 96)) and as much again for the rings within.
      EXPECT_NEAR(round_mm2, kPi * radius_mm * radius_mm, 2 * kPi * 30.0 * 30.0 * 4 * (1 - std::cos(kPi / 96)));
      EXPECT_NEAR(area_mm2(cap, axis, 2 * radius_mm), round_mm2, tolerance_mm2(2 * radius_mm, 2 * radius_mm, 1))
          << axis << ' ' << at_mm;
    }
  }
}

TEST(SectionCap, AHollowStaysOpenAndBodiesThatOverlapAreOne) {
  const mesh::Triangles outer = ball(30.0, Vec3::Zero(), 64, 32), inner = ball(20.0, Vec3::Zero(), 64, 32, true);
  const SectionCap shell = capOf(together(outer, inner), kThere, 2, 0.5);
  EXPECT_NEAR(area_mm2(shell, 2, 60.0), roundArea_mm2(shell, 2), tolerance_mm2(60.0, 60.0, 2));
  const SectionCap twice = capOf(together(outer, ball(20.0, Vec3::Zero(), 64, 32)), kThere, 2, 0.5);
  EXPECT_NEAR(area_mm2(twice, 2, 60.0), area_mm2(capOf(outer, kThere, 2, 0.5), 2, 60.0), tolerance_mm2(60.0, 60.0, 2));
}

TEST(SectionCap, ScaleTurnAndPlaceOfTheMeshAreTheFaces) {
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 3>(0, 0) = 1000.0 * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  X.block<3, 1>(0, 3) = Vec3(40.0, 0.0, -5.0);
  const SectionCap cap = capOf(ball(0.010, Vec3::Zero(), 64, 32), X, 0, 41.0);
  const double radius_mm = std::sqrt(99.0);
  EXPECT_NEAR(area_mm2(cap, 0, 2 * radius_mm), kPi * radius_mm * radius_mm, 0.01 * kPi * 99.0);  // 64 sectors: 0.3 %
  double bounds[6];
  cap.face()->ComputeBounds();
  cap.face()->GetBounds(bounds);
  EXPECT_EQ(bounds[0], 41.0F);
  EXPECT_NEAR(0.5 * (bounds[2] + bounds[3]), 0.0, 0.1);
  EXPECT_NEAR(0.5 * (bounds[4] + bounds[5]), -5.0, 0.1);
}

TEST(SectionCap, PastTheMeshThereIsNothingAndAnOpenOneHasAnOutlineAlone) {
  const mesh::Triangles triangles = ball(30.0, Vec3::Zero(), 24, 12);
  EXPECT_EQ(capOf(triangles, kThere, 1, 31.0).outline()->GetNumberOfCells(), 0);
  SectionCap open;
  open.add(triangles, kThere, 1, 3.0, false);
  EXPECT_EQ(open.face()->GetNumberOfCells(), 0);
  EXPECT_GT(open.outline()->GetNumberOfCells(), 20);
}

TEST(SectionCap, WhatIsDrawnCoarserIsStillClosed) {
  const mesh::Triangles thin = together(ball(30.0, Vec3::Zero(), 300, 200), ball(29.95, Vec3::Zero(), 300, 200, true));
  const auto surface = mesh::makeSurface(thin).value();
  const auto drawn = drawnMesh(surface);
  ASSERT_TRUE(drawn->is_coarser);
  ASSERT_LT(drawn->coarser.faces.size(), thin.faces.size());
  std::map<std::pair<int, int>, int> along;  // how often an edge is gone along, less how often the other way
  for (const mesh::Face& face : drawn->coarser.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      along[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  for (const auto& [edge, deltas] : along) ASSERT_EQ(deltas, 0) << edge.first << ' ' << edge.second;
}

TEST(MeshPicture, CutsOnceAFrameAndOnlyWhereSomethingMoved) {
  scene::Description scene;
  scene.constraints.resize(1);
  scene::Mesh mesh;
  mesh.surface = mesh::makeSurface(ball(30.0, Vec3::Zero(), 48, 24)).value();
  scene.constraints[0].shape = mesh;
  MeshPicture picture;
  picture.setScene(scene);
  const Vec3 eye_mm(0, 0, 500);
  picture.update(eye_mm);
  EXPECT_EQ(picture.cuts(), 0U);  // nobody asked for it
  Layers layers;
  layers.section = true;
  picture.show(layers);
  tick::TickReport report;
  for (int tick = 0; tick < 30; ++tick) {
    report.p_WT = Vec3(0.0, 0.0, 1e-3 * tick);
    picture.present(report);
  }
  picture.update(eye_mm);
  EXPECT_EQ(picture.cuts(), 1U);
  for (int frame = 0; frame < 5; ++frame) {
    report.p_WT.x() += 1e-3;  // along the cut
    picture.present(report);
    picture.update(Vec3(frame, 100.0, 400.0));
  }
  EXPECT_EQ(picture.cuts(), 1U);
  report.p_WT.z() = 0.010;
  picture.present(report);
  picture.update(eye_mm);
  EXPECT_EQ(picture.cuts(), 2U);
}

}  // namespace underact::gui
