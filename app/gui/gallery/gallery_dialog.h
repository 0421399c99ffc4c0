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

/// What the gallery asks the window to do.
struct GalleryCallbacks {
  std::function<void(const QString& path)> open_scene;
  std::function<void(const QString& path)> open_session;  // empty: not possible
};

/// The figures of the thesis as this program makes them: made on demand, kept between runs, each with the numbers
/// checked in it. Not modal; closing it cancels a run.
class GalleryDialog : public QDialog {
  Q_OBJECT
 public:
  /// only: figure numbers separated by commas; empty: all.
  GalleryDialog(GalleryCallbacks callbacks, const QString& only, QWidget* parent);
  ~GalleryDialog() override;
  /// Shows those of that folder; a folder other than figureFolder() is only looked at.
  void setFolder(const QString& folder);
  bool isMaking() const { return run_ != nullptr; }
  /// The state of the figures, or the result of a run; read by screen readers.
  QString message() const;
  /// Saves the figure shown as a PDF and says where.
  void savePdf(const QString& path);

 private:
  QWidget* buildActions();
  QWidget* buildMaking();
  void make();
  void ended(FiguresRun::End end, const QString& refusal);
  void readFolder();
  void say(const QString& sentence, const char* role = "");
  void showFigure();
  void choosePdf();
  const FigureRow* shown() const;

  GalleryCallbacks callbacks_;
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
