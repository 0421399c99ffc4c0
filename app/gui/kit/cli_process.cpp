#include "app/gui/kit/cli_process.h"

#include "app/gui/kit/words.h"
#include "core/system/process.h"
#include "core/system/resource_paths.h"

namespace underact::gui {
namespace {

constexpr int kWaitForEnd_ms = 2000;
constexpr int kBehindTheWindow = 10;  // nice

}  // namespace

CliProcess::CliProcess() {
  process_.setStandardOutputFile(QProcess::nullDevice());
#ifdef Q_OS_UNIX
  // Its own process group: the program starts others, which are to end with it.
  process_.setChildProcessModifier([] { system::leadGroup(kBehindTheWindow); });
#endif
  connect(&process_, &QProcess::readyReadStandardError, this, &CliProcess::read);
  connect(&process_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    unread_ += '\n';
    read();
    emit ended(status == QProcess::NormalExit ? std::optional<int>(code) : std::nullopt);
  });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    last_words_ = tr("The program %1 could not be started. Reinstall Underact.").arg(process_.program());
    emit ended(std::nullopt);
  });
}

CliProcess::~CliProcess() {
  process_.disconnect(this);
  kill();
}

void CliProcess::start(const QStringList& words) {
  const Result<std::string> program = system::findProgram("underact-cli", "UNDERACT_CLI");
  if (program) {
    process_.start(QString::fromStdString(program.value()), words, QIODevice::ReadOnly);
    return;
  }
  last_words_ = sentencesOf(program.problems()) + " " + tr("Reinstall Underact.");
  // Queued: the caller of start() is not ready for the end yet.
  QMetaObject::invokeMethod(
      this, [this] { emit ended(std::nullopt); }, Qt::QueuedConnection);
}

void CliProcess::kill() {
  if (process_.state() == QProcess::NotRunning) return;
#ifdef Q_OS_UNIX
  process_.waitForStarted(kWaitForEnd_ms);  // before that it has no group yet
  if (process_.processId() > 0) system::killGroup(process_.processId());
#endif
  process_.kill();
  process_.waitForFinished(kWaitForEnd_ms);
}

void CliProcess::read() {
  unread_ += process_.readAllStandardError();
  for (qsizetype end = unread_.indexOf('\n'); end >= 0; end = unread_.indexOf('\n')) {
    const QByteArray line = unread_.left(end).trimmed();
    unread_.remove(0, end + 1);
    if (!line.isEmpty() && (!reader_ || !reader_(line))) last_words_ = QString::fromUtf8(line);
  }
}

}  // namespace underact::gui
