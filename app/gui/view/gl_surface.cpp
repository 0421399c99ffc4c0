#include "app/gui/view/gl_surface.h"

#include <vtkAutoInit.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLPaintDevice>
#include <QPainter>

// What vtk_module_autoinit() of CMake would do for every program that links this room.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace underact::gui {
namespace {

// Creases darken within this distance: of the size of a gap between two links. 128 samples show no grain.
constexpr double kCrease_mm = 25.0, kLeastDepth_mm = 1.0;
constexpr int kSamplesOfCreases = 128;

}  // namespace

QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setOption(QSurfaceFormat::DeprecatedFunctions);  // no forward-compatible context, which refuses wide lines
  format.setSamples(0);                                   // 4 samples cut the frame rate of software GL to 40 %
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  return format;
}

GlSurface::GlSurface(Before before, Words words, QWidget* parent)
    : QOpenGLWidget(parent), before_(std::move(before)), words_(std::move(words)) {
  setFormat(surfaceFormat());
  setAttribute(Qt::WA_TransparentForMouseEvents);  // its parent handles the mouse
  renderer_->SetBackgroundAlpha(1.0);              // otherwise the widget blends with the window behind it
  renderer_->SetClippingRangeExpansion(0.0);
  renderer_->SetSSAORadius(kCrease_mm);
  renderer_->SetSSAOBias(kLeastDepth_mm);
  renderer_->SetSSAOKernelSize(kSamplesOfCreases);
  renderer_->SSAOBlurOn();
}

GlSurface::~GlSurface() {
  release();
}

void GlSurface::setBackground(const QColor& colour) {
  renderer_->SetBackground(colour.redF(), colour.greenF(), colour.blueF());
}

QSize GlSurface::devicePixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void GlSurface::initializeGL() {
  release();
  window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetOwnContext(false);
  window_->SetFrameBlitModeToBlitToCurrent();
  window_->InitializeFromCurrentContext();
  QOpenGLFunctions* gl = context()->functions();
  renderer_name_ = QString::fromLatin1(reinterpret_cast<const char*>(gl->glGetString(GL_RENDERER)));
  bool software = false;
  for (const char* word : {"llvmpipe", "softpipe", "SwiftShader", "swrast", "GDI Generic", "Basic Render"}) {
    software = software || renderer_name_.contains(QLatin1String(word), Qt::CaseInsensitive);
  }
  window_->SetMultiSamples(0);  // edges are lines, which are smoothed: see paintGL()
  renderer_->SetUseSSAO(occludes_.value_or(!software));
  window_->AddRenderer(renderer_);
  context_ends_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlSurface::release);
}

// The context goes while the picture stays: VTK's resources on the graphics card are released, and created again in the
// next context.
void GlSurface::release() {
  if (window_ == nullptr) return;
  disconnect(context_ends_);
  makeCurrent();
  window_->SetIsCurrent(true);
  window_->RemoveRenderer(renderer_);  // releases what its actors hold
  window_->Finalize();
  window_->SetReadyForRendering(false);
  window_ = nullptr;
}

void GlSurface::resizeGL(int, int) {}  // paintGL asks: a move to another screen may change only the scale

void GlSurface::paintGL() {
  QElapsedTimer clock;
  clock.start();
  const QSize pixels = devicePixels();
  if (QSize(window_->GetSize()[0], window_->GetSize()[1]) != pixels) window_->SetSize(pixels.width(), pixels.height());
  QOpenGLFunctions* gl = context()->functions();
  window_->SetIsCurrent(true);
  window_->GetState()->Reset();  // Qt has drawn meanwhile
  window_->GetState()->Push();
  before_(pixels);
  // Antialiased lines at a fraction of the cost of multisampling; VTK leaves the switch alone.
  gl->glEnable(GL_LINE_SMOOTH);
  window_->Render();
  window_->GetState()->Pop();
  gl->glDisable(GL_LINE_SMOOTH);
  if (words_) {
    for (const GLenum switched : {GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
      gl->glDisable(switched);  // QPainter assumes that they are off
    }
    // Not QPainter(this): while a window is grabbed it would paint elsewhere.
    QOpenGLPaintDevice paper(pixels);
    paper.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&paper);
    words_(painter);
  }
  for (GLenum error = gl->glGetError(); error != GL_NO_ERROR && errors_ < 1000; error = gl->glGetError()) ++errors_;
  ++frames_;
  emit drawn(1e-6 * static_cast<double>(clock.nsecsElapsed()));
}

void GlSurface::setOcclusion(bool on) {
  occludes_ = on;
  renderer_->SetUseSSAO(on);
  update();
}

QImage GlSurface::picture() {
  return grabFramebuffer();
}

}  // namespace underact::gui
