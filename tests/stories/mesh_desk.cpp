#include "tests/stories/mesh_desk.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "app/gui/files/load_strip.h"
#include "core/base/units.h"

namespace underact::gui::test {
namespace {

using Corners = std::array<Vec3, 3>;

QByteArray stlOf(const std::vector<Corners>& triangles) {
  QByteArray file(80, ' ');
  const auto count = static_cast<quint32>(triangles.size());
  file.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Corners& corners : triangles) {
    std::array<float, 12> numbers{};  // the normal first, which may be 0
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        numbers[3 + 3 * corner + axis] = static_cast<float>(corners[corner][static_cast<Eigen::Index>(axis)]);
    }
    file.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    file.append(2, '\0');
  }
  return file;
}

}  // namespace

QByteArray ballStl(double radius, const Vec3& middle, int sectors, int rings) {
  const auto at = [&](int ring, int sector) -> Vec3 {
    const double up_rad = kPi * (static_cast<double>(ring) / rings - 0.5);
    const double around_rad = 2.0 * kPi * (sector % sectors) / sectors;
    const double across = ring == 0 || ring == rings ? 0.0 : std::cos(up_rad);
    return middle + radius * Vec3(across * std::cos(around_rad), across * std::sin(around_rad), std::sin(up_rad));
  };
  std::vector<Corners> triangles;
  for (int ring = 0; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      const Vec3 a = at(ring, sector), b = at(ring, sector + 1), c = at(ring + 1, sector + 1), d = at(ring + 1, sector);
      if (ring > 0) triangles.push_back({a, b, c});  // at the poles one side of the quad is a point
      if (ring + 1 < rings) triangles.push_back({a, c, d});
    }
  }
  return stlOf(triangles);
}

QByteArray withFirstFaceTwice(QByteArray stl) {
  constexpr qsizetype kHead = 80, kFace = 50;
  quint32 count = 0;
  std::memcpy(&count, stl.constData() + kHead, sizeof count);
  ++count;
  std::memcpy(stl.data() + kHead, &count, sizeof count);
  return stl + stl.mid(kHead + static_cast<qsizetype>(sizeof count), kFace);
}

QByteArray boxStl(const Vec3& half, bool open) {
  std::vector<Corners> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      if (open && axis == 2 && side > 0.0) continue;
      const Vec3 out = side * Vec3::Unit(axis), u = Vec3::Unit((axis + 1) % 3), v = out.cross(u);
      const auto at = [&](double a, double b) -> Vec3 { return half.cwiseProduct(out + a * u + b * v); };
      triangles.push_back({at(-1, -1), at(1, -1), at(1, 1)});
      triangles.push_back({at(-1, -1), at(1, 1), at(-1, 1)});
    }
  }
  return stlOf(triangles);
}

void drop(Story& story, const QString& path) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPoint middle = story.window().rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&story.window(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&story.window(), &event);
}

bool waitForMeshes(Story& story) {
  constexpr int kMax_ms = 30'000;
  const auto* loads = story.find<LoadStrip>("load");
  return QTest::qWaitFor([loads] { return !loads->isBusy(); }, kMax_ms);
}

void openMesh(Story& story, const QString& path) {
  drop(story, path);
  ASSERT_TRUE(waitForMeshes(story));
  auto* button = story.find<QPushButton>("dialog.mesh.new");
  ASSERT_NE(button, nullptr);
  button->click();
  story.settle();
}

void keepPicture(Story& story, const QString& widget, const QString& name) {
  story.settle();
  EXPECT_TRUE(story.find(widget)->grab().save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png"));
}

void handTo(Story& story, const Vec3& p_WT) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_WT;
  story.arm().setSetpoint(setpoint);
  story.run(2000);
}

const scene::Mesh& meshOf(Story& story, std::size_t index) {
  return std::get<scene::Mesh>(story.host().scene().constraints.at(index).shape);
}

}  // namespace underact::gui::test
