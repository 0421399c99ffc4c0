#include "app/gui/kit/procedure.h"

#include <QAbstractButton>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/stop_key.h"

namespace underact::gui {

ProcedurePage::ProcedurePage(const QString& name, const QString& title, int spacing) : column_(new QVBoxLayout(this)) {
  setObjectName(name);
  setTitle(title);
  column_->setSpacing(spacing);
}

QLabel* ProcedurePage::addText(const char* name, const QString& text) {
  auto* label = new QLabel(text, this);
  label->setObjectName(name);
  label->setWordWrap(true);
  column_->addWidget(label);
  return label;
}

QPushButton* ProcedurePage::button(const char* name, const QString& text, const QString& tip, const QString& spoken) {
  auto* made = new QPushButton(text, this);
  nameWidget(made, name, spoken.isEmpty() ? QString(text).remove('&') : spoken, tip);
  return made;
}

QTableWidget* ProcedurePage::table(const char* name, const QString& spoken, const QStringList& columns) {
  auto* table = new QTableWidget(0, static_cast<int>(columns.size()), this);
  nameWidget(table, name, spoken);
  table->setHorizontalHeaderLabels(columns);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->verticalHeader()->hide();
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setTabKeyNavigation(false);
  return table;
}

void ProcedurePage::initializePage() {
  if (enter) enter();
}

void ProcedurePage::cleanupPage() {
  if (leave) leave();
}

void setRow(QTableWidget* table, int row, const QStringList& texts) {
  for (int column = 0; column < texts.size(); ++column)
    table->setItem(row, column, new QTableWidgetItem(texts[column]));
}

Procedure::Procedure(QString key, const QString& title, QWidget* parent) : QWizard(parent), key_(std::move(key)) {
  setObjectName(key_ + ".wizard");
  setWindowTitle(title);
  setModal(false);
  setWizardStyle(QWizard::ModernStyle);
  setOption(QWizard::NoBackButtonOnStartPage);
  setAttribute(Qt::WA_DeleteOnClose);
  setProperty(StopKey::kEscStops, true);
  connect(this, &QDialog::finished, this, &QWidget::close);
}

void Procedure::setPages(const std::vector<ProcedurePage*>& pages, const QString& finish, int wide_lines) {
  for (ProcedurePage* page : pages) addPage(page);
  for (const auto& [which, word] : {std::pair<WizardButton, QString>{BackButton, "back"},
                                    {NextButton, "next"},
                                    {FinishButton, finish},
                                    {CancelButton, "cancel"}}) {
    nameWidget(button(which), key_ + '.' + word, buttonText(which).remove('&').remove('<').remove('>').trimmed());
    button(which)->setIcon({});
  }
  constexpr int kHighLines = 46;
  const int line = fontMetrics().lineSpacing();
  const QWidget* const behind = parentWidget();
  const QSize max = behind != nullptr ? behind->size() : QSize(1280, 800);  // large text on a small screen
  resize(QSize(wide_lines * line, kHighLines * line).boundedTo(max));
}

void Procedure::bringForward() {
  show();
  raise();
  activateWindow();
}

}  // namespace underact::gui
