#pragma once
#include <QPointer>
#include <QWizard>
#include <functional>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace underact::gui {

/// A page of a procedure, of a wizard or of a panel, filled from top to bottom. A function that is not set does
/// nothing, or allows it.
class ProcedurePage : public QWizardPage {
 public:
  ProcedurePage(const QString& name, const QString& title, int spacing);
  QVBoxLayout* column() const { return column_; }
  /// A wrapped text.
  QLabel* addText(const char* name, const QString& text = {});
  /// Not yet in the column. spoken: its name for screen readers; empty: its text.
  QPushButton* button(const char* name, const QString& text, const QString& tip, const QString& spoken = {});
  /// A table whose texts nobody edits, with columns of equal width; not yet in the column.
  QTableWidget* table(const char* name, const QString& spoken, const QStringList& columns);

  std::function<void()> enter, leave;         // from the page before, and back to it
  std::function<bool()> is_ready, may_leave;  // for the next page; after it was asked for

  void initializePage() override;
  void cleanupPage() override;
  bool isComplete() const override { return !is_ready || is_ready(); }
  bool validatePage() override { return !may_leave || may_leave(); }

 private:
  QVBoxLayout* column_;
};

/// Sets the texts of a table's row.
void setRow(QTableWidget* table, int row, const QStringList& texts);

/// A procedure in which a person does one step after the other: what is to be prepared, the steps, the result to keep
/// or discard. Not modal, so that the hand of a simulated arm can be moved in the view. Closing it discards the result.
class Procedure : public QWizard {
  Q_OBJECT
 public:
  void bringForward();

 protected:
  /// key: of the names of its parts, for stories: "identify" makes identify.wizard, identify.next.
  Procedure(QString key, const QString& title, QWidget* parent);
  /// finish: the last word of the name of the button that keeps the result. It is as large as its text needs and the
  /// window behind it allows. To be called once.
  void setPages(const std::vector<ProcedurePage*>& pages, const QString& finish, int wide_lines);

 private:
  QString key_;
};

/// Brings forward the one that is open, or opens one.
template <class One, class... Given>
void openProcedure(QPointer<One>& open, Given&&... given) {
  if (!open) open = new One(std::forward<Given>(given)...);
  open->bringForward();
}

}  // namespace underact::gui
