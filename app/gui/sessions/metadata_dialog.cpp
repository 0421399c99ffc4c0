#include "app/gui/sessions/metadata_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"
#include "app/gui/sessions/metadata_form.h"

namespace underact::gui {

MetadataDialog::MetadataDialog(const QString& path, const record::SessionMetadata& words, QWidget* parent)
    : QDialog(parent),
      path_(path),
      form_(new MetadataForm("dialog.words.", this)),
      told_(messageLabel("dialog.words.told", tr("Error message"), "alarm", this)) {
  setObjectName("dialog.words");
  setWindowTitle(tr("Metadata of %1").arg(QFileInfo(path).fileName()));
  resize(440, 280);
  form_->setWords(words);
  told_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
  const auto nameButton = [buttons](QDialogButtonBox::StandardButton which, const char* name, const QString& spoken) {
    QPushButton* button = buttons->button(which);
    button->setObjectName(QString("dialog.words.") + name);
    button->setAccessibleName(spoken);
    button->setIcon({});
  };
  nameButton(QDialogButtonBox::Save, "save", tr("Save the metadata"));
  nameButton(QDialogButtonBox::Cancel, "cancel", tr("Cancel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(form_);
  column->addWidget(told_);
  column->addStretch(1);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &MetadataDialog::write);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void MetadataDialog::write() {
  const Problems problems = record::rewriteMetadata(path_.toStdString(), form_->words());
  told_->setText(sentencesOf(problems));
  told_->setVisible(!problems.empty());
  if (!problems.empty()) return;
  emit written();
  accept();
}

}  // namespace underact::gui
