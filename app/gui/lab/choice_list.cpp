#include "app/gui/lab/choice_list.h"

#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/lab/lab_words.h"

namespace underact::gui {
namespace {

QString tipOf(const tradeoff::Choice& choice) {
  return QObject::tr("%1\nTimed: %2. Error: %3; root mean square.\nBound: %4 (%5).")
      .arg(QString(choice.question), QString(choice.cost), QString(choice.error), errorText(choice.bound, choice.unit),
           QString(choice.reason));
}

QString figuresOf(const tradeoff::Choice& choice, const tradeoff::Summary& now) {
  return QObject::tr("%1 for %2, %3 per second; error %4, bound %5")
      .arg(timeText(1e-3 * now.p50_ns), QString(choice.cost), timeText(now.cost_us_per_s),
           errorText(now.error, choice.unit), errorText(choice.bound, choice.unit));
}

/// Marks a choice by words and a sign; the colour only adds to them.
void mark(const tradeoff::ChoiceResult& choice_result, const tradeoff::Summary* now, bool is_default,
          ChoiceWords& words) {
  const tradeoff::Choice& choice = *choice_result.choice;
  const tradeoff::Summary* best = recommendedOf(choice_result);
  const bool exceeds = now != nullptr && now->error > choice.bound;
  // Where nothing is better, the program's own default is what it recommends: no warning.
  words.is_beyond = exceeds && (best != nullptr || !is_default);
  if (words.is_beyond) words.mark = QObject::tr("▲ The error exceeds the bound.");
  if (exceeds && !words.is_beyond)
    words.mark = QObject::tr("The default; no other setting keeps the error within the bound here.");
  if (best == nullptr || (now != nullptr && now->option == best->option)) return;
  const QString better =
      QObject::tr("→ Recommended: %1 (%2 per second, error %3)")
          .arg(optionText(best->option), timeText(best->cost_us_per_s), errorText(best->error, choice.unit));
  words.mark = words.is_beyond ? words.mark + ' ' + better : better;
}

}  // namespace

std::vector<ChoiceWords> choiceWords(const scene::Description& scene, const tradeoff::Settings& now,
                                     const std::vector<tradeoff::ChoiceResult>& choice_results) {
  std::vector<ChoiceWords> all;
  for (const tradeoff::Choice& choice : tradeoff::choices()) {
    if (!choice.applies(scene)) continue;
    ChoiceWords words;
    words.key = choice.key;
    words.name = choiceName(choice);
    words.value = optionText(valueText(choice, scene, now));
    words.tip = tipOf(choice);
    const auto choice_result = std::find_if(choice_results.begin(), choice_results.end(),
                                            [&](const tradeoff::ChoiceResult& one) { return one.choice == &choice; });
    if (choice_result != choice_results.end()) {
      const tradeoff::Summary* measured = measuredOf(*choice_result, now);
      words.figures =
          measured != nullptr ? figuresOf(choice, *measured) : QObject::tr("not measured with this setting");
      mark(*choice_result, measured, choice.same(now, tradeoff::Settings{}), words);
    }
    all.push_back(std::move(words));
  }
  return all;
}

ChoiceList::ChoiceList(QWidget* parent) : QWidget(parent), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(8);
}

ChoiceList::ChoiceRow ChoiceList::makeRow(const ChoiceWords& words) {
  const QByteArray name = QString("panel.lab.choice.%1").arg(words.key).toUtf8();
  ChoiceRow row;
  row.key = words.key;
  row.all = new QWidget(this);
  row.all->setObjectName(name);
  row.all->setToolTip(words.tip);
  row.all->setAccessibleName(words.name);
  row.all->setAccessibleDescription(words.tip);
  auto* column = tight<QVBoxLayout>(row.all, 0);
  row.value = messageLabel((name + ".value").constData(), words.name, "section", row.all);
  row.figures =
      messageLabel((name + ".figures").constData(), tr("%1: cost and error").arg(words.name), "quiet", row.all);
  row.mark = messageLabel((name + ".mark").constData(), tr("%1: recommendation").arg(words.name), "", row.all);
  for (QLabel* label : {row.value, row.figures, row.mark}) column->addWidget(label);
  column_->addWidget(row.all);
  return row;
}

void ChoiceList::present(const std::vector<ChoiceWords>& words) {
  const bool is_same = std::equal(rows_.begin(), rows_.end(), words.begin(), words.end(),
                                  [](const ChoiceRow& row, const ChoiceWords& one) { return row.key == one.key; });
  if (!is_same) {
    for (const ChoiceRow& row : rows_) delete row.all;
    rows_.clear();
    for (const ChoiceWords& one : words) rows_.push_back(makeRow(one));
  }
  for (std::size_t index = 0; index < words.size(); ++index) {
    const ChoiceRow& row = rows_[index];
    showMessage(row.value, tr("%1: %2").arg(words[index].name, words[index].value));
    showMessage(row.figures, words[index].figures);
    showMessage(row.mark, words[index].mark);
    const QString role = words[index].is_beyond ? "amber-text" : "";
    if (row.mark->property("role").toString() == role) continue;
    row.mark->setProperty("role", role);
    row.mark->style()->polish(row.mark);
  }
}

}  // namespace underact::gui
