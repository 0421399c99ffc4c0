#pragma once
#include <QObject>
#include <QProcess>
#include <QString>
#include <functional>
#include <optional>
#include <utility>

namespace underact::gui {

/// Runs underact-cli (beside this program, or $UNDERACT_CLI if set) on a long task at low priority, since the servo and
/// the view come first. Processes that it starts (Python) end with it.
class CliProcess : public QObject {
  Q_OBJECT
 public:
  CliProcess();
  ~CliProcess() override;  // kills it, without a signal
  void start(const QStringList& words);
  /// Kills it; emits ended() before returning.
  void kill();
  /// The last line of its output; the lines above are for developers. Empty: no output.
  const QString& lastLine() const { return last_words_; }
  /// Handles lines that are not for the user, such as progress; returns whether a line was one.
  void setReader(std::function<bool(const QByteArray& line)> reader) { reader_ = std::move(reader); }

 signals:
  /// code: its exit code; none where it was killed or could not be started.
  void ended(std::optional<int> code);

 private:
  void read();

  QProcess process_;
  QByteArray unread_;  // an incomplete line
  QString last_words_;
  std::function<bool(const QByteArray&)> reader_;
};

}  // namespace underact::gui
