#pragma once
#include <QDialog>

#include "core/record/session_writer.h"

class QLabel;

namespace underact::gui {

class MetadataForm;

/// Edits the metadata of a finished session. Not modal.
class MetadataDialog : public QDialog {
  Q_OBJECT
 public:
  MetadataDialog(const QString& path, const record::SessionMetadata& words, QWidget* parent);

 signals:
  void written();

 private:
  void write();
  QString path_;
  MetadataForm* form_;
  QLabel* told_;
};

}  // namespace underact::gui
