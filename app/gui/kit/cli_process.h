#pragma once
#include <QObject>
#include <QProcess>
#include <QString>
#include <functional>
#include <optional>
#include <utility>

namespace underact::gui {

/// underact-cli (beside this program; $UNDERACT_CLI where that is set) at a work that takes long, behind the window:
/// the hand and its picture come first. What it starts itself (Python) ends with it.
class CliProcess : public QObject {
  Q_OBJECT
 public:
  CliProcess();
  ~CliProcess() override;  // ends it early, without a signal
  void start(const QStringList& words);
  /// Ends it early; ended() comes before this returns.
  void kill();
  /// The last line that it said: above it stands where it happened, which is for its makers. Empty: it said nothing.
  const QString& lastWords() const { return last_words_; }
  /// Takes a line that is no word for the reader, such as progress; gives whether it is one.
  void setReader(std::function<bool(const QByteArray& line)> reader) { reader_ = std::move(reader); }

 signals:
  /// code: its exit code; none where it was killed or could not be started.
  void ended(std::optional<int> code);

 private:
  void read();

  QProcess process_;
  QByteArray unread_;  // the beginning of a line
  QString last_words_;
  std::function<bool(const QByteArray&)> reader_;
};

}  // namespace underact::gui
