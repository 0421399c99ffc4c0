#pragma once
#include <QDialog>

#include "core/record/session_writer.h"

class QLabel;

namespace underact::gui {

class WordsForm;

/// Edits the metadata of a finished session. Not modal.
class WordsDialog : public QDialog {
  Q_OBJECT
 public:
  WordsDialog(const QString& path, const record::SessionWords& words, QWidget* parent);

 signals:
  void written();

 private:
  void write();
  QString path_;
  WordsForm* form_;
  QLabel* told_;
};

}  // namespace underact::gui
