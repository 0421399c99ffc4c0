#pragma once
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <functional>

class QPainter;
class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace underact::gui {

/// OpenGL 3.2 core without samples, which VTK and software GL both want. Give it to QSurfaceFormat::setDefaultFormat()
/// before QApplication is made, so that all of the program's contexts are alike.
QSurfaceFormat surfaceFormat();

/// A Qt widget that shows one VTK renderer, and words over it that Qt writes (the system's font, crisp at any scale).
/// Lives on when its context does not: moved to another window, floated, shown again. Draws when update() is called,
/// and only then.
class GlSurface : public QOpenGLWidget {
  Q_OBJECT
 public:
  /// before: what changes the picture, called before each one with the context current; its sizes are device pixels.
  /// words: paints over the picture, in logical pixels.
  using Before = std::function<void(QSize device_pixels)>;
  using Words = std::function<void(QPainter&)>;
  GlSurface(Before before, Words words, QWidget* parent);
  ~GlSurface() override;

  vtkRenderer& renderer() { return *renderer_; }
  void setBackground(const QColor& colour);
  /// Whether the processor draws; known after the first picture.
  QString rendererName() const { return renderer_name_; }
  QImage picture();
  qint64 framesDrawn() const { return frames_; }
  /// GL errors since the widget was made: none, or something is wrong.
  int errors() const { return errors_; }

 signals:
  void drawn(double frame_ms);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;

 private:
  void release();
  QSize devicePixels() const;

  Before before_;
  Words words_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  QMetaObject::Connection context_ends_;
  QString renderer_name_;
  bool software_ = false;
  qint64 frames_ = 0;
  int errors_ = 0;
};

}  // namespace underact::gui
