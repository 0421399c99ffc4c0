#include "app/gui/sessions/metadata_form.h"

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>

#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {

constexpr int kLinesOfNotes = 2;

MetadataForm::MetadataForm(const QString& prefix, QWidget* parent)
    : QWidget(parent),
      name_(new QLineEdit(this)),
      notes_(new QPlainTextEdit(this)),
      tags_(new QLineEdit(this)),
      subject_(new QLineEdit(this)),
      consent_(new QLineEdit(this)) {
  auto* form = tight<QFormLayout>(this, 4);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  addRow(form, tr("&Name"), name_, prefix + "name", tr("Name of the session in the list."));
  addRow(form, tr("No&tes"), notes_, prefix + "notes", tr("Notes for whoever opens the session later."));
  addRow(form, tr("Ta&gs"), tags_, prefix + "tags", tr("Keywords for the search, separated by commas."));
  addRow(form, tr("Su&bject"), subject_, prefix + "subject",
         tr("The person whose hand it is, as a code. Keep the list of codes and names somewhere else."));
  form->addRow(quietLabel(prefix + "subject_hint", tr("A code, not a name: whoever reads the file can see it."), this));
  addRow(form, tr("&Consent"), consent_, prefix + "consent",
         tr("What the subject agreed to, and how: version and date of the consent form. Empty: not recorded."));
  tags_->setPlaceholderText(tr("pilot, left hand"));
  consent_->setPlaceholderText(tr("form 2.1, in writing, 2026-11-20"));
  notes_->setTabChangesFocus(true);
  notes_->setAcceptDrops(false);  // a scene is dropped on the window
  notes_->setFixedHeight(kLinesOfNotes * fontMetrics().lineSpacing() + 2 * notes_->frameWidth() +
                         2 * static_cast<int>(notes_->document()->documentMargin()));
  for (QLineEdit* line : {name_, tags_, subject_, consent_})
    connect(line, &QLineEdit::textEdited, this, &MetadataForm::edited);
  connect(notes_, &QPlainTextEdit::textChanged, this, &MetadataForm::edited);
}

void MetadataForm::addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& name,
                          const QString& tip) {
  field->setObjectName(name);
  field->setAccessibleName(QString(label).remove('&'));
  field->setToolTip(tip);
  auto* words = new QLabel(label, this);
  words->setToolTip(tip);
  words->setBuddy(field);
  form->addRow(words, field);
}

record::SessionMetadata MetadataForm::words() const {
  return {name_->text().trimmed().toStdString(), notes_->toPlainText().trimmed().toStdString(),
          tags_->text().trimmed().toStdString(), subject_->text().trimmed().toStdString(),
          consent_->text().trimmed().toStdString()};
}

void MetadataForm::setWords(const record::SessionMetadata& words) {
  const QSignalBlocker silent(this);
  name_->setText(QString::fromStdString(words.name));
  notes_->setPlainText(QString::fromStdString(words.notes));
  tags_->setText(QString::fromStdString(words.tags));
  subject_->setText(QString::fromStdString(words.subject));
  consent_->setText(QString::fromStdString(words.consent));
}

void MetadataForm::clearConsent() {
  if (!consent_->text().trimmed().isEmpty()) consent_->clear();
}

}  // namespace underact::gui
