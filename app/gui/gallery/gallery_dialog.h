#pragma once
#include <QDialog>
#include <functional>
#include <memory>

#include "app/gui/gallery/figure_list.h"
#include "app/gui/gallery/figures_run.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace underact::gui {

class FigureChooser;
class FigureSheet;

/// What the gallery asks of the window.
struct GalleryWays {
  std::function<void(const QString& path)> open_scene;
  std::function<void(const QString& path)> open_session;  // empty: there is no way to
};

/// The figures of the thesis, remade by the program: made on demand, kept between two starts, each with the numbers
/// that it should show. Not modal; closing it ends the making.
class GalleryDialog : public QDialog {
  Q_OBJECT
 public:
  /// only: numbers of figures with commas between; empty: all.
  GalleryDialog(GalleryWays ways, const QString& only, QWidget* parent);
  ~GalleryDialog() override;
  bool isMaking() const { return run_ != nullptr; }
  /// What came of it, or what there is: what a screen reader says.
  QString message() const;
  /// Writes the figure that is shown as a PDF, and says where.
  void savePdf(const QString& path);

 private:
  QWidget* buildActions();
  QWidget* buildMaking();
  void make();
  void ended(FiguresRun::End end, const QString& why_not);
  void readFolder();
  void say(const QString& sentence, const char* role = "");
  void showFigure();
  void choosePdf();
  const FigureRow* shown() const;

  GalleryWays ways_;
  QString folder_, only_;
  FigureList list_;
  std::unique_ptr<FiguresRun> run_;
  FigureChooser* figures_;
  FigureSheet* sheet_;
  QLabel* message_;
  QProgressBar* progress_;
  QPushButton *make_ = nullptr, *page_ = nullptr, *scene_ = nullptr, *session_ = nullptr, *pdf_ = nullptr;
};

}  // namespace underact::gui
