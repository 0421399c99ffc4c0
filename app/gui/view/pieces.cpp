#include "app/gui/view/pieces.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/gui/view/lights.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

/// Writes no depth, and, as a mark, asks for none either.
class SeeThroughMapper : public vtkOpenGLPolyDataMapper {
 public:
  static SeeThroughMapper* New();
  vtkTypeMacro(SeeThroughMapper, vtkOpenGLPolyDataMapper);
  bool is_mark = false;

 protected:
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override {
    vtkOpenGLPolyDataMapper::RenderPieceStart(renderer, actor);
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
    state->vtkglDepthMask(kNo);
    if (is_mark) state->vtkglDisable(kDepthTest);
  }
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override {
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
    state->vtkglDepthMask(kYes);
    if (is_mark) state->vtkglEnable(kDepthTest);
    vtkOpenGLPolyDataMapper::RenderPieceFinish(renderer, actor);
  }
  static constexpr unsigned int kDepthTest = 0x0B71;
  static constexpr unsigned char kNo = 0, kYes = 1;
};
vtkStandardNewMacro(SeeThroughMapper);

/// Where it is seen through, first the depth alone, then the colour of what is nearest, so that no layer shows through
/// another, also where parts of it have the same place. Offset away from the eye, by
/// more than the rounding of depths, so that what has the same place and is not seen through stays in front, as lines
/// do.
class BodyMapper : public vtkOpenGLPolyDataMapper {
 public:
  static BodyMapper* New();
  vtkTypeMacro(BodyMapper, vtkOpenGLPolyDataMapper);
  double behind_mm = 0.0;

 protected:
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override {
    vtkOpenGLState* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
    QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
    gl->glEnable(GL_POLYGON_OFFSET_FILL);
    gl->glPolygonOffset(1.0F, 2.0F);
    if (behind_mm > 0.0) gl->glDepthRangef(nearestDepth(behind_mm, *renderer), 1.0F);
    GLint compare = GL_LEQUAL;
    gl->glGetIntegerv(GL_DEPTH_FUNC, &compare);
    gl->glDepthFunc(GL_LEQUAL);  // Qt may have left it at a function that rejects equal depths
    if (actor->GetProperty()->GetOpacity() < 1.0) {
      // The alpha of the picture says how much of the colour a pixel still takes: what lies in one place, once.
      const vtkOpenGLState::ScopedglEnableDisable blends(state, GL_BLEND);
      const vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
      state->vtkglColorMask(kNo, kNo, kNo, kYes);
      state->vtkglDisable(GL_BLEND);
      vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
      state->vtkglColorMask(kYes, kYes, kYes, kYes);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ZERO, GL_ZERO);
      vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
      state->vtkglColorMask(kNo, kNo, kNo, kYes);
      state->vtkglClearColor(0.0F, 0.0F, 0.0F, 1.0F);
      state->vtkglClear(GL_COLOR_BUFFER_BIT);
      state->vtkglColorMask(kYes, kYes, kYes, kYes);
    } else {
      vtkOpenGLPolyDataMapper::RenderPieceDraw(renderer, actor);
    }
    gl->glDepthFunc(static_cast<GLenum>(compare));
    gl->glDepthRangef(0.0F, 1.0F);
    gl->glPolygonOffset(0.0F, 0.0F);
    gl->glDisable(GL_POLYGON_OFFSET_FILL);
  }
  /// Where depths begin if what is there lies that much farther from the eye, at the distance at which it looks: in
  /// perspective a share of each distance. The steps of a polygon offset are as small as the driver likes.
  static float nearestDepth(double along_mm, vtkRenderer& renderer) {
    vtkCamera& eye = *renderer.GetActiveCamera();
    const double near_mm = eye.GetClippingRange()[0], far_mm = eye.GetClippingRange()[1];
    if (eye.GetParallelProjection() != 0) return static_cast<float>(along_mm / (far_mm - eye.GetDistance()));
    return static_cast<float>(along_mm * far_mm / (eye.GetDistance() * (far_mm - near_mm)));
  }
  static constexpr unsigned char kNo = 0, kYes = 1;
};
vtkStandardNewMacro(BodyMapper);

/// What a surface reflects of the lights, computed at its corners: for each pixel it takes software GL as long as all
/// the rest. Directions in the camera's frame; the words are VTK's, which it puts into its own shaders.
void lightCorners(vtkActor& actor, bool from_both_sides) {
  std::string lit = "  vec3 n = normalize(normalVCVSOutput);\n";
  if (from_both_sides) lit += "  n = n.z < 0.0 ? -n : n;\n";
  lit += "  litVSOutput = vec2(0.0);\n  vec3 l;\n  float d;\n";
  for (std::size_t light = 0; light < kLights.size(); ++light) {
    const Vec3 offset = kLights[light].normalized();
    const auto word = [](double value) { return QByteArray::number(value, 'f', 6).toStdString(); };
    const std::string strength = word(kLightStrengths[light]);
    lit +=
        "  l = vec3(" + word(offset.x()) + ", " + word(offset.y()) + ", " + word(offset.z()) + ");\n  d = dot(n, l);\n";
    lit += "  litVSOutput += " + strength +
           " * vec2(max(d, 0.0), d > 0.0 ? pow(max(1e-5, reflect(-l, n).z), 28.0) : 0.0);\n";
  }
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  shader.AddVertexShaderReplacement("//VTK::CustomUniforms::Dec", true,
                                    "//VTK::CustomUniforms::Dec\nout vec2 litVSOutput;\n", false);
  shader.AddVertexShaderReplacement("//VTK::CustomEnd::Impl", true, lit, false);
  shader.AddFragmentShaderReplacement("//VTK::CustomUniforms::Dec", true,
                                      "//VTK::CustomUniforms::Dec\nin vec2 litVSOutput;\n", false);
  shader.AddFragmentShaderReplacement("//VTK::Normal::Impl", true, "", false);
  shader.AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                      "  gl_FragData[0] = vec4(ambientColor + litVSOutput.x * diffuseColor + "
                                      "litVSOutput.y * specularColor, opacity);\n  //VTK::SSAO::Impl\n",
                                      false);
}

vtkSmartPointer<vtkPolyData> surface(vtkPoints* points, vtkFloatArray* normals, vtkCellArray* cells) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  return data;
}

vtkSmartPointer<vtkFloatArray> makeNormals() {
  auto normals = vtkSmartPointer<vtkFloatArray>::New();
  normals->SetNumberOfComponents(3);
  normals->SetName("normal");
  return normals;
}

}  // namespace

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data, PieceKind kind) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkSmartPointer<vtkPolyDataMapper> mapper;
  if (kind == PieceKind::Solid) {
    mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  } else if (kind == PieceKind::Body) {
    mapper = vtkSmartPointer<BodyMapper>::New();
    mapper->ScalarVisibilityOff();
  } else {
    auto see_through = vtkSmartPointer<SeeThroughMapper>::New();
    see_through->is_mark = kind == PieceKind::Mark;
    mapper = see_through;
  }
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
  // Drawn with the opaque actors, in the order of addition: VTK's own handling of translucency uses a second
  // floating-point buffer and halves the frame rate of software GL.
  actor->ForceOpaqueOn();
  // VTK's shaders ask for each pixel whether it is seen at all, which keeps GL from leaving out hidden ones early.
  actor->GetShaderProperty()->AddFragmentShaderReplacement("  if (gl_FragData[0].a <= 0.0)\n    {\n    discard;\n    }",
                                                           true, "", false);
  vtkProperty& property = *actor->GetProperty();
  property.SetInterpolationToGouraud();
  const bool has_normals = data->GetPointData()->GetNormals() != nullptr;
  if (kind == PieceKind::Solid) {
    if (has_normals) lightCorners(*actor, false);
    property.SetAmbient(0.55);
    property.SetDiffuse(0.5);
    property.BackfaceCullingOn();
  } else if (kind == PieceKind::Body) {
    property.SetAmbient(0.45);
    property.SetDiffuse(0.65);
  } else if (kind == PieceKind::Tint) {
    if (has_normals) lightCorners(*actor, true);
    property.SetAmbient(0.7);
    property.SetDiffuse(0.35);
    property.SetOpacity(0.25);
  } else {
    property.LightingOff();
  }
  return actor;
}

void setBehind(vtkActor& body, double behind_mm) {
  BodyMapper::SafeDownCast(body.GetMapper())->behind_mm = behind_mm;
}

void setColour(vtkActor& actor, const QColor& colour) {
  actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void place(vtkActor& actor, const Eigen::Matrix4d& X) {
  vtkMatrix4x4* matrix = actor.GetUserMatrix();
  if (matrix == nullptr) {
    const vtkNew<vtkMatrix4x4> fresh;
    actor.SetUserMatrix(fresh);
    matrix = fresh;
  }
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, X(row, column));
  }
  matrix->Modified();
}

Eigen::Matrix4d along(const Vec3& a_mm, const Vec3& b_mm, double radius_mm) {
  const Vec3 travel_mm = b_mm - a_mm;
  const double length_mm = std::max(travel_mm.norm(), 1e-9);
  const Vec3 axis = travel_mm.norm() > 1e-9 ? Vec3(travel_mm / length_mm) : Vec3::UnitZ();
  const Vec3 u = axis.unitOrthogonal();
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 1>(0, 0) = radius_mm * u;
  X.block<3, 1>(0, 1) = radius_mm * axis.cross(u);
  X.block<3, 1>(0, 2) = length_mm * axis;
  X.block<3, 1>(0, 3) = a_mm;
  return X;
}

Eigen::Matrix4d at(const Vec3& p_mm, double scale) {
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  X.block<3, 3>(0, 0) *= scale;
  X.block<3, 1>(0, 3) = p_mm;
  return X;
}

vtkSmartPointer<vtkPolyData> turned(std::span<const Ring> profile, int sectors) {
  const vtkNew<vtkPoints> points;
  const vtkSmartPointer<vtkFloatArray> normals = makeNormals();
  const vtkNew<vtkCellArray> cells;
  for (std::size_t strip = 0; strip + 1 < profile.size(); ++strip) {
    const Ring lower = profile[strip], upper = profile[strip + 1];
    // A small change of slope means a rounded part: there both strips share the mean normal.
    const auto slopeOf = [&](std::size_t index) {
      const Eigen::Vector2d offset(profile[index + 1].radius - profile[index].radius,
                                   profile[index + 1].z - profile[index].z);
      return Eigen::Vector2d(offset.y(), -offset.x()).normalized();
    };
    const auto meanOf = [&](std::size_t one, std::size_t other) {
      const Eigen::Vector2d a = slopeOf(one), b = slopeOf(other);
      return a.dot(b) > 0.7 ? Eigen::Vector2d((a + b).normalized()) : slopeOf(strip);
    };
    const Eigen::Vector2d below = strip > 0 ? meanOf(strip, strip - 1) : slopeOf(strip);
    const Eigen::Vector2d above = strip + 2 < profile.size() ? meanOf(strip, strip + 1) : slopeOf(strip);
    const vtkIdType first = points->GetNumberOfPoints();
    for (int sector = 0; sector <= sectors; ++sector) {
      const double angle = 2.0 * kPi * sector / sectors;
      const double c = std::cos(angle), s = std::sin(angle);
      points->InsertNextPoint(lower.radius * c, lower.radius * s, lower.z);
      normals->InsertNextTuple3(below.x() * c, below.x() * s, below.y());
      points->InsertNextPoint(upper.radius * c, upper.radius * s, upper.z);
      normals->InsertNextTuple3(above.x() * c, above.x() * s, above.y());
    }
    for (int sector = 0; sector < sectors; ++sector) {
      const vtkIdType corner = first + 2 * sector;
      const std::array<vtkIdType, 4> quad{corner, corner + 2, corner + 3, corner + 1};
      cells->InsertNextCell(4, quad.data());
    }
  }
  return surface(points, normals, cells);
}

vtkSmartPointer<vtkPolyData> unitSphere(int sectors, int rings) {
  std::vector<Ring> profile;
  for (int ring = 0; ring <= rings; ++ring) {
    const double angle = kPi * (static_cast<double>(ring) / rings - 0.5);
    profile.push_back({ring == 0 || ring == rings ? 0.0 : std::cos(angle), std::sin(angle)});
  }
  return turned(profile, sectors);
}

vtkSmartPointer<vtkPolyData> unitTube(int sectors, bool closed) {
  const std::array<Ring, 4> profile{Ring{0, 0}, Ring{1, 0}, Ring{1, 1}, Ring{0, 1}};
  return turned(closed ? std::span<const Ring>(profile) : std::span<const Ring>(profile).subspan(1, 2), sectors);
}

vtkSmartPointer<vtkPolyData> unitCube() {
  const vtkNew<vtkPoints> points;
  const vtkSmartPointer<vtkFloatArray> normals = makeNormals();
  const vtkNew<vtkCellArray> cells;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 normal = side * Vec3::Unit(axis);
      const Vec3 u = Vec3::Unit((axis + 1) % 3), v = normal.cross(u);
      cells->InsertNextCell(4);
      for (const auto& [a, b] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        const Vec3 corner = 0.5 * normal + a * u + b * v;
        cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
        normals->InsertNextTuple(normal.data());
      }
    }
  }
  return surface(points, normals, cells);
}

vtkSmartPointer<vtkPolyData> polygon(std::span<const Vec3> points_mm, const Vec3& normal) {
  const vtkNew<vtkPoints> points;
  const vtkSmartPointer<vtkFloatArray> normals = makeNormals();
  const vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(points_mm.size()));
  for (const Vec3& p_mm : points_mm) {
    cells->InsertCellPoint(points->InsertNextPoint(p_mm.data()));
    normals->InsertNextTuple(normal.data());
  }
  return surface(points, normals, cells);
}

}  // namespace underact::gui
