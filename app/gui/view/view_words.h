#pragma once
#include <QFont>
#include <QImage>
#include <QString>
#include <functional>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/workspace_picture.h"

class QPainter;

namespace underact::gui {

/// A small picture painted once and kept until its key changes: sharp at any scale, and cheap to draw over the view.
class Stamp {
 public:
  using Paint = std::function<void(QPainter&, const QSizeF&)>;
  const QImage& image(const QString& key, const QSizeF& size, double scale, const Paint& paint);

 private:
  QString key_;
  QImage image_;
};

/// The contents of the text over the view.
struct WordsState {
  Theme theme;
  QFont font;
  QSizeF size;         // logical pixels
  double scale = 1.0;  // device pixels per logical one
  OrbitCamera camera;
  QString hint;
  QString fault;  // a sentence; takes the hint's place
  double force_N = 0.0;
  double force_limit_N = 0.0;
  double gauge_scale = 1.0;  // size of its text relative to the font
  bool limited = false;
  bool focus = false;
  bool has_influence = false;  // the letters o and p are shown
};

/// Labels, force gauge, hint, small triad and focus frame, by the system's font.
class ViewWords {
 public:
  void paint(QPainter& painter, const WordsState& state, const std::vector<Label>& labels);

 private:
  void paintLabels(QPainter& painter, const WordsState& state, const std::vector<Label>& labels);
  void paintLegend(QPainter& painter, const WordsState& state);
  void paintGauge(QPainter& painter, const WordsState& state);
  void paintHint(QPainter& painter, const WordsState& state);
  void paintTriad(QPainter& painter, const WordsState& state);

  Stamp gauge_, hint_, triad_;
};

}  // namespace underact::gui
