#include "app/gui/sessions/rerun_check.h"

#include <QObject>

#include "app/gui/kit/words.h"
#include "app/gui/model/recorded_files.h"
#include "core/record/session.h"

namespace underact::gui {

RerunCheck checkRerun(const std::string& session, WorkState& state) {
  Result<record::Session> read = record::Session::open(session);
  if (!read) return {{}, false, read.problems()};
  if (read.value().info().ticks == 0)
    return {{}, false, {{phrase(QT_TRANSLATE_NOOP("problem", "This session contains no ticks.")), {session}}}};
  device::RerunOptions options;
  options.files_in = recordedFilesFolders();
  options.progress = [&state](double share) {
    state.share = share;
    return !state.cancelled;
  };
  const Result<device::RerunResult> result = device::rerun(read.value(), options);
  if (state.cancelled) return {{}, true, {}};
  if (!result) return {{}, false, result.problems()};
  return {result.value(), false, {}};
}

QString sentenceOf(const RerunCheck& check, bool& alarm) {
  const record::Verified& verified = check.result.verified;
  alarm = !check.cancelled;
  if (check.cancelled) return QObject::tr("Cancelled: the run was not compared to its end.");
  if (!check.problems.empty()) return QObject::tr("Not run again. %1").arg(sentencesOf(check.problems));
  QStringList laws;
  for (const std::string& law : verified.mended) laws << QString::fromStdString(law);
  if (verified.differs && !laws.empty())
    return QObject::tr(
               "Since this session was made, the law of %1 was mended: %2 ticks differ now, the first one is %3.")
        .arg(laws.join(", "))
        .arg(verified.different_ticks)
        .arg(verified.differs->tick);
  if (verified.differs)
    return QObject::tr("Tick %1 differs from the recording: %2.")
        .arg(verified.differs->tick)
        .arg(QString::fromStdString(verified.differs->column));
  if (!verified.unknown.empty()) return sentenceText(verified.unknown);
  alarm = false;
  const QString same = QObject::tr("Run again: all %1 ticks are the same to the last bit.").arg(verified.ticks);
  return check.result.is_from_hand
             ? same
             : QObject::tr("%1 A person or an edit had a part in the run, so the recorded input was used.").arg(same);
}

}  // namespace underact::gui
