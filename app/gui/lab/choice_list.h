#pragma once
#include <QWidget>
#include <vector>

#include "core/tradeoff/choice_result.h"

class QLabel;
class QVBoxLayout;

namespace underact::gui {

/// The texts of the Lab panel on one choice.
struct ChoiceWords {
  QString key, name, value;  // "rate", "Servo rate", "1000 Hz"
  QString figures;           // its cost, its error and the bound; empty: not measured
  QString mark;              // beyond the bound, or the recommended option; empty: neither
  bool is_beyond = false;
  QString tip;
};

/// For every choice that the scene offers, in the catalogue's order. standings: as measured; empty: not yet.
std::vector<ChoiceWords> choiceWords(const scene::Description& scene, const tradeoff::Settings& now,
                                     const std::vector<tradeoff::ChoiceResult>& choice_results);

/// The choices of a scene, one below the other; labels are called panel.lab.choice.KEY.PART (value, figures, mark).
class ChoiceList : public QWidget {
  Q_OBJECT
 public:
  explicit ChoiceList(QWidget* parent = nullptr);
  void present(const std::vector<ChoiceWords>& words);

 private:
  struct ChoiceRow {
    QString key;
    QWidget* all = nullptr;
    QLabel *value = nullptr, *figures = nullptr, *mark = nullptr;
  };
  ChoiceRow makeRow(const ChoiceWords& words);

  QVBoxLayout* column_;
  std::vector<ChoiceRow> rows_;
};

}  // namespace underact::gui
