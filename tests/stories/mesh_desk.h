#pragma once
#include <QByteArray>
#include <QString>

#include "core/base/types.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

// What stories about meshes share: files to be loaded, and how long to wait for them.

/// A ball as binary STL: rings of triangles around z, in the unit of radius.
QByteArray ballStl(double radius, const Vec3& middle, int sectors, int rings);
QByteArray withFirstFaceTwice(QByteArray stl);
/// A box with sharp edges, from -half to half, as binary STL. open: without the face at +z.
QByteArray boxStl(const Vec3& half, bool open);

/// On the window.
void drop(Story& story, const QString& path);
/// Until nothing is loaded any more; false: it takes longer than half a minute.
bool waitForMeshes(Story& story);
/// Drops the file, and makes a new scene of it as the dialog offers it.
void openMesh(Story& story, const QString& path);
/// What the dialog, or another widget, looks like, into the build's pictures.
void keepPicture(Story& story, const QString& widget, const QString& name);
/// The hand goes there, with time to arrive.
void handTo(Story& story, const Vec3& p_WT);
const scene::Mesh& meshOf(Story& story, std::size_t index = 0);

}  // namespace underact::gui::test
