#pragma once
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QSurfaceFormat>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

class QOpenGLContext;
class QPainter;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace underact::gui {

/// OpenGL 3.2 core without multisampling, which both VTK and software GL require. Pass it to
/// QSurfaceFormat::setDefaultFormat() before QApplication is constructed, so that all contexts of the program are
/// alike.
QSurfaceFormat surfaceFormat();

/// The version of OpenGL that the surfaces made so far found; (0, 0): none.
std::pair<int, int> foundOpenGl();
/// Whether it is the version of surfaceFormat() or a later one. A surface without it shows nothing, and a window with
/// one must not be shown.
bool hasOpenGl();

/// A Qt widget that shows one VTK renderer, with text drawn over it by Qt (the system's font, crisp at any scale).
/// Draws only when update() is called, and with software GL once more, smoothed, when no update() followed for a while.
///
/// With a graphics card, a QOpenGLWidget inside shows the picture; it survives the loss of its context, when it is
/// moved to another window, floated or shown again. Software GL draws into memory, and the picture is painted like any
/// other widget's: a QOpenGLWidget would have the whole window put together by GL as well, which takes software GL
/// longer than the picture itself.
class GlSurface : public QWidget {
  Q_OBJECT
 public:
  /// before: called before each frame with the context current, to change the picture; sizes in device pixels. words:
  /// paints over the picture, in logical pixels.
  using Before = std::function<void(QSize device_pixels)>;
  using Words = std::function<void(QPainter&)>;
  GlSurface(Before before, Words words, QWidget* parent);
  ~GlSurface() override;

  vtkRenderer& renderer() { return *renderer_; }
  void setBackground(const QColor& colour);
  /// Asks for a new picture.
  void update();
  /// The name of the GL renderer; known after the first frame.
  QString rendererName() const { return renderer_name_; }
  /// Whether creases are darkened (screen-space ambient occlusion). By default where a graphics card draws, which has
  /// not been tried: software GL draws a third of the frames with it.
  void setOcclusion(bool on);
  /// Smoothed, as it is shown at rest.
  QImage picture();
  qint64 framesDrawn() const { return frames_; }
  /// GL errors since construction; should be 0.
  int errors() const { return errors_; }

 signals:
  void drawn(double frame_ms);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Composed;
  struct InMemory;

  void begin(QOpenGLContext& context);
  void release();
  void render(QOpenGLContext& context, QSize pixels);
  void drawInMemory(bool fine);
  void countErrors(QOpenGLContext& context);
  void end(QOpenGLContext& context, double frame_ms);
  QSize devicePixels() const;

  Before before_;
  Words words_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  std::unique_ptr<InMemory> in_memory_;  // with software GL
  Composed* composed_ = nullptr;         // with a graphics card
  QString renderer_name_;
  std::optional<bool> occludes_;
  qint64 frames_ = 0;
  int errors_ = 0;
};

}  // namespace underact::gui
