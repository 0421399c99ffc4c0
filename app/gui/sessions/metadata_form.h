#pragma once
#include <QWidget>

#include "core/record/session_writer.h"

class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace underact::gui {

/// The metadata that a person enters for a session: name, notes, tags, subject, consent.
class MetadataForm : public QWidget {
  Q_OBJECT
 public:
  /// prefix: of the object names of the fields, "panel.sessions."
  explicit MetadataForm(const QString& prefix, QWidget* parent = nullptr);
  record::SessionMetadata words() const;
  void setWords(const record::SessionMetadata& words);  // emits no signal
  void clearConsent();                                  // emits no signal

 signals:
  void edited();

 private:
  void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& name, const QString& tip);

  QLineEdit* name_;
  QPlainTextEdit* notes_;
  QLineEdit *tags_, *subject_, *consent_;
};

}  // namespace underact::gui
