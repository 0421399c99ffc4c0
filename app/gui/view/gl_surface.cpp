#include "app/gui/view/gl_surface.h"

#include <vtkAutoInit.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLPaintDevice>
#include <QOpenGLWidget>
#include <QPaintEvent>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <cstring>

// What vtk_module_autoinit() of CMake would do for every program that links this room.
VTK_MODULE_INIT(vtkRenderingOpenGL2)

namespace underact::gui {
namespace {

// Creases darken within this distance: of the size of a gap between two links. 128 samples show no grain.
constexpr double kCrease_mm = 25.0, kMinDepth_mm = 1.0;
constexpr int kSamplesOfCreases = 128;
// Software GL smooths silhouettes at rest alone: FXAA doubles the time of each frame (10 to 21 ms at 1280 x 800 on two
// cores, below 30 frames a second beside other work), four samples for each pixel cost time once.
constexpr int kRest_ms = 150;
constexpr qint64 kMaxFine_px = 1'500'000;  // more than those would make the window wait

std::pair<int, int> found_opengl = surfaceFormat().version();  // until a context was made, or could not be

bool isSoftware(const QString& renderer_name) {
  const char* const words[] = {"llvmpipe", "softpipe", "SwiftShader", "swrast", "GDI Generic", "Basic Render"};
  return std::any_of(std::begin(words), std::end(words), [&](const char* word) {
    return renderer_name.contains(QLatin1String(word), Qt::CaseInsensitive);
  });
}

/// Each pixel is the mean of four; the rows of `four` go from the lowest to the highest.
void average(const QImage& four, QImage& image) {
  constexpr quint32 kEven = 0x00FF00FF, kHalf = 0x00020002;
  for (int row = 0; row < image.height(); ++row) {
    const auto* const low = reinterpret_cast<const quint32*>(four.constScanLine(four.height() - 2 - 2 * row));
    const auto* const high = reinterpret_cast<const quint32*>(four.constScanLine(four.height() - 1 - 2 * row));
    auto* const mean = reinterpret_cast<quint32*>(image.scanLine(row));
    for (int x = 0; x < image.width(); ++x) {
      quint32 even = kHalf, odd = kHalf;
      for (const quint32 pixel : {low[2 * x], low[2 * x + 1], high[2 * x], high[2 * x + 1]}) {
        even += pixel & kEven;
        odd += (pixel >> 8) & kEven;
      }
      mean[x] = ((even >> 2) & kEven) | (((odd >> 2) & kEven) << 8);
    }
  }
}

QString nameOfRenderer(QOpenGLContext& context) {
  return QString::fromLatin1(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
}

}  // namespace

std::pair<int, int> foundOpenGl() {
  return found_opengl;
}

bool hasOpenGl() {
  return found_opengl >= surfaceFormat().version();
}

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

/// What software GL draws into.
struct GlSurface::InMemory {
  /// Null: there is no context, or a graphics card draws.
  static std::unique_ptr<InMemory> make() {
    auto made = std::make_unique<InMemory>();
    made->context.setFormat(surfaceFormat());
    found_opengl = made->context.create() ? made->context.format().version() : std::pair(0, 0);
    if (!hasOpenGl()) return nullptr;
    made->nowhere.setFormat(made->context.format());
    made->nowhere.create();
    if (!made->context.makeCurrent(&made->nowhere) || !isSoftware(nameOfRenderer(made->context))) return nullptr;
    return made;
  }

  QOffscreenSurface nowhere;
  QOpenGLContext context;
  QImage rows;   // as GL has them, the lowest first
  QImage image;  // with the words
  bool is_stale = true;
  QTimer rest;  // since the last frame
};

/// Where a graphics card draws.
class GlSurface::Composed : public QOpenGLWidget {
 public:
  explicit Composed(GlSurface& surface) : QOpenGLWidget(&surface), surface_(surface) {
    setFormat(surfaceFormat());
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  ~Composed() override { release(); }

 protected:
  void initializeGL() override {
    release();
    surface_.begin(*context());
    context_ends_ = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Composed::release);
  }
  void resizeGL(int, int) override {}  // paintGL() asks: a move to another screen may change only the scale
  void paintGL() override {
    QElapsedTimer clock;
    clock.start();
    const QSize pixels = surface_.devicePixels();
    surface_.render(*context(), pixels);
    if (surface_.words_) {
      for (const GLenum switched :
           std::initializer_list<GLenum>{GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST}) {
        context()->functions()->glDisable(switched);  // QPainter assumes that they are off
      }
      // Not QPainter(this): while a window is grabbed it would paint elsewhere.
      QOpenGLPaintDevice paper(pixels);
      paper.setDevicePixelRatio(devicePixelRatioF());
      QPainter painter(&paper);
      surface_.words_(painter);
    }
    surface_.end(*context(), 1e-6 * static_cast<double>(clock.nsecsElapsed()));
  }

 private:
  // The context goes while the picture stays: VTK's resources on the graphics card are released, and created again in
  // the next context.
  void release() {
    disconnect(context_ends_);
    if (surface_.window_ == nullptr) return;
    makeCurrent();
    surface_.release();
  }

  GlSurface& surface_;
  QMetaObject::Connection context_ends_;
};

GlSurface::GlSurface(Before before, Words words, QWidget* parent)
    : QWidget(parent), before_(std::move(before)), words_(std::move(words)), in_memory_(InMemory::make()) {
  setAttribute(Qt::WA_TransparentForMouseEvents);  // its parent handles the mouse
  renderer_->SetBackgroundAlpha(1.0);              // otherwise the widget blends with the window behind it
  renderer_->SetClippingRangeExpansion(0.0);
  renderer_->SetSSAORadius(kCrease_mm);
  renderer_->SetSSAOBias(kMinDepth_mm);
  renderer_->SetSSAOKernelSize(kSamplesOfCreases);
  renderer_->SSAOBlurOn();
  if (in_memory_) {
    setAttribute(Qt::WA_NoSystemBackground);  // not WA_OpaquePaintEvent: Qt would take the view for hidden
    in_memory_->rest.setSingleShot(true);
    in_memory_->rest.setInterval(kRest_ms);
    connect(&in_memory_->rest, &QTimer::timeout, this, [this] {
      if (in_memory_->is_stale || !isVisible()) return;
      drawInMemory(true);
      QWidget::update();
    });
  } else if (hasOpenGl()) {
    composed_ = new Composed(*this);
  }
}

GlSurface::~GlSurface() {
  delete composed_;
  if (in_memory_ && window_ != nullptr && in_memory_->context.makeCurrent(&in_memory_->nowhere)) release();
}

void GlSurface::setBackground(const QColor& colour) {
  renderer_->SetBackground(colour.redF(), colour.greenF(), colour.blueF());
}

void GlSurface::update() {
  if (composed_ != nullptr) return composed_->update();
  if (!in_memory_) return;
  in_memory_->is_stale = true;
  QWidget::update();
}

QSize GlSurface::devicePixels() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

/// In a context that is current.
void GlSurface::begin(QOpenGLContext& context) {
  window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  window_->SetReadyForRendering(true);
  window_->SetIsCurrent(true);
  window_->SetOwnContext(false);
  if (in_memory_)
    window_->SetFrameBlitModeToNoBlit();  // drawInMemory() reads it from where VTK has it
  else
    window_->SetFrameBlitModeToBlitToCurrent();
  window_->InitializeFromCurrentContext();
  renderer_name_ = nameOfRenderer(context);
  window_->SetMultiSamples(0);
  renderer_->SetUseSSAO(occludes_.value_or(!isSoftware(renderer_name_)));
  renderer_->SetUseFXAA(!isSoftware(renderer_name_));
  window_->AddRenderer(renderer_);
}

void GlSurface::release() {
  window_->SetIsCurrent(true);
  window_->RemoveRenderer(renderer_);  // releases what its actors hold
  window_->Finalize();
  window_->SetReadyForRendering(false);
  window_ = nullptr;
}

void GlSurface::render(QOpenGLContext& context, QSize pixels) {
  if (QSize(window_->GetSize()[0], window_->GetSize()[1]) != pixels) window_->SetSize(pixels.width(), pixels.height());
  window_->SetIsCurrent(true);
  window_->GetState()->Reset();  // Qt may have drawn meanwhile
  window_->GetState()->Push();
  before_(pixels);
  // Antialiased lines at a fraction of the cost of multisampling; VTK leaves the switch alone.
  context.functions()->glEnable(GL_LINE_SMOOTH);
  window_->Render();
  window_->GetState()->Pop();
  context.functions()->glDisable(GL_LINE_SMOOTH);
}

void GlSurface::countErrors(QOpenGLContext& context) {
  QOpenGLFunctions& gl = *context.functions();
  for (GLenum error = gl.glGetError(); error != GL_NO_ERROR && errors_ < 1000; error = gl.glGetError()) ++errors_;
}

void GlSurface::end(QOpenGLContext& context, double frame_ms) {
  countErrors(context);
  ++frames_;
  emit drawn(frame_ms);
}

void GlSurface::drawInMemory(bool fine) {
  InMemory& my = *in_memory_;
  const QSize pixels = devicePixels();
  fine = fine && qint64{pixels.width()} * pixels.height() <= kMaxFine_px;
  const QSize drawn = fine ? 2 * pixels : pixels;
  if (!my.context.makeCurrent(&my.nowhere)) return;
  if (window_ == nullptr) begin(my.context);
  render(my.context, drawn);
  if (my.rows.size() != drawn) my.rows = QImage(drawn, QImage::Format_RGB32);
  if (my.image.size() != pixels) my.image = QImage(pixels, QImage::Format_RGB32);
  my.image.setDevicePixelRatio(devicePixelRatioF());
  QOpenGLFunctions& gl = *my.context.functions();
  window_->GetState()->PushReadFramebufferBinding();
  window_->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window_->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.glReadPixels(0, 0, drawn.width(), drawn.height(), GL_BGRA, GL_UNSIGNED_BYTE, my.rows.bits());
  window_->GetState()->PopReadFramebufferBinding();
  if (fine) average(my.rows, my.image);
  for (int row = 0; !fine && row < pixels.height(); ++row) {
    std::memcpy(my.image.scanLine(row), my.rows.constScanLine(pixels.height() - 1 - row),
                static_cast<std::size_t>(my.image.bytesPerLine()));
  }
  if (words_) {
    QPainter painter(&my.image);
    words_(painter);
  }
  if (fine) my.rows = QImage();  // four times as large as the next frame's
  my.is_stale = false;
  countErrors(my.context);
}

void GlSurface::paintEvent(QPaintEvent* event) {
  if (!in_memory_) return;
  if (in_memory_->is_stale || in_memory_->image.size() != devicePixels()) {
    QElapsedTimer clock;
    clock.start();
    drawInMemory(false);
    end(in_memory_->context, 1e-6 * static_cast<double>(clock.nsecsElapsed()));
    in_memory_->rest.start();
  }
  QPainter painter(this);
  painter.setClipRegion(event->region());
  painter.drawImage(QPointF(), in_memory_->image);
}

void GlSurface::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (composed_ != nullptr) composed_->setGeometry(rect());
}

void GlSurface::setOcclusion(bool on) {
  occludes_ = on;
  renderer_->SetUseSSAO(on);
  update();
}

QImage GlSurface::picture() {
  if (composed_ != nullptr) {
    composed_->setGeometry(rect());  // not yet where it was never shown
    return composed_->grabFramebuffer();
  }
  if (!in_memory_) return {};
  drawInMemory(true);
  return in_memory_->image;
}

}  // namespace underact::gui
