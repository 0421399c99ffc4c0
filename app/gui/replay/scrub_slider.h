#pragma once
#include <QSlider>
#include <optional>
#include <utility>
#include <vector>

#include "app/gui/kit/theme.h"
#include "device/recorded.h"

namespace underact::gui {

/// The position in a recording, one step per row: markers as strokes above the line, faults as crosses, the loop as a
/// thick line. A click jumps there.
class ScrubSlider : public QSlider {
  Q_OBJECT
 public:
  explicit ScrubSlider(QWidget* parent);
  void setMarks(const std::vector<device::RecordedMark>& marks);
  void setLoop(const std::optional<std::pair<std::int64_t, std::int64_t>>& rows);
  void setTheme(const Theme& theme);
  /// The x of a row, logical pixels from the left.
  int xOf(std::int64_t row) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  int handle() const;
  int rowAt(int x) const;

  std::vector<device::RecordedMark> marks_;
  std::optional<std::pair<std::int64_t, std::int64_t>> loop_;
  Theme theme_ = Theme::light();
};

}  // namespace underact::gui
