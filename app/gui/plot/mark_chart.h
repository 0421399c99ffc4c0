#pragma once
#include <QPainter>
#include <optional>
#include <vector>

#include "app/gui/kit/painted.h"

namespace underact::gui {

/// The content of a MarkChart, as data.
struct MarkSheet {
  /// That share of a colour of the theme, mixed with the background.
  struct Colour {
    QColor Theme::*of = &Theme::ink;
    double share = 1.0;
  };
  struct Mark {
    QPointF at;   // in the coordinates of the axes
    double half;  // half of its height, logical pixels
    Colour line;
    double line_width;
    std::optional<Colour> fill = {};  // none: a ring
    bool is_square = false;
  };
  struct Axis {
    double from = 0.0, to = 1.0;
    bool is_logarithmic = false;
    QString (*text)(double) = nullptr;  // of its ticks, at 1, 2 and 5 times powers of ten; null: no ticks
    double lines_a_tick = 0.0;          // with less room per tick, only powers of ten have one
  };
  struct Word {
    int line;  // below the axes, from 0
    Qt::AlignmentFlag side;
    QString text;
  };
  struct Band {
    double low, middle, high;
  };
  QString spoken;  // for a screen reader
  QString y_title, key;
  int word_lines = 1, key_lines = 1;  // below the axes; the tick labels of x are in the first
  QString widest;                     // widest label of a tick
  Axis x, y;
  std::vector<Word> words;
  std::vector<Mark> marks;  // the last on top
  std::vector<QPointF> path;
  Colour path_line;
  double path_width = 1.0;
  std::optional<Band> band = {};  // of y
  bool marks_grow = false;        // with the text

  /// Logarithmic, beyond the outermost values by that factor; values must not be empty.
  static Axis around(const std::vector<double>& values, double room);
};

/// Marks on axes and the path from one to the next; empty until it has a sheet. Chart is for curves that move.
class MarkChart : public Painted {
  Q_OBJECT
 public:
  /// least: minimum size, in characters and lines.
  MarkChart(const QString& name, const QString& spoken, const QString& tip, const QSize& min, QWidget* parent);
  void present(MarkSheet sheet);
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double lineHeight() const { return fontMetrics().lineSpacing(); }
  QRectF axes() const;
  QPointF placeOf(const QPointF& at) const;
  QColor colourOf(const MarkSheet::Colour& colour) const {
    return mixed(palette().color(QPalette::Window), theme_.*colour.of, colour.share);
  }
  void drawAxes(QPainter& painter) const;
  void drawBand(QPainter& painter) const;
  void drawMarks(QPainter& painter) const;

  const QSize min_;
  MarkSheet sheet_;
};

}  // namespace underact::gui
