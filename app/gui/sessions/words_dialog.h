#pragma once
#include <QDialog>

#include "core/record/session_writer.h"

class QLabel;

namespace underact::gui {

class WordsForm;

/// The words of a session that is finished, to be changed. Not modal.
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
