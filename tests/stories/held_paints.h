#pragma once
#include <QObject>
#include <QPointer>
#include <vector>

namespace underact::gui::test {

/// As long as it is there, no window paints what has changed; then they do, once each, with the next events. To put a
/// window of 1 Mpixel together takes software GL 25 ms, which stories that nobody looks at would spend with each key
/// and each tick. A picture that is asked for is painted all the same.
class HeldPaints : public QObject {
 public:
  HeldPaints();
  ~HeldPaints() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::vector<QPointer<QObject>> held_;
};

}  // namespace underact::gui::test
