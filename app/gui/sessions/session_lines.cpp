#include "app/gui/sessions/session_lines.h"

#include <QFileInfo>

#include "app/gui/model/session_words.h"

namespace underact::gui {
namespace {

constexpr int kMaxMarkers = 5;
const QString kBetween = QString(" %1 ").arg(QChar(0x00B7));

QString shownText(const std::string& text) {
  return QString::fromStdString(text);
}

QString dateOf(const SessionEntry& entry, const char* format) {
  return QDateTime::fromMSecsSinceEpoch(entry.began_ms()).toString(format);
}

QString shortDateOf(const SessionEntry& entry) {
  const bool this_year = dateOf(entry, "yyyy") == QDateTime::currentDateTime().toString("yyyy");
  return dateOf(entry, this_year ? "d MMM hh:mm" : "d MMM yyyy");
}

QString markersOf(const SessionEntry& entry) {
  QStringList marks;
  for (const record::Marker& marker : entry.markers) {
    if (marks.size() == kMaxMarkers) {
      marks << QObject::tr("and %1 more").arg(entry.markers.size() - kMaxMarkers);
      break;
    }
    const auto rate_hz = static_cast<double>(entry.info.header.rate_hz);
    const QString when = clockText(static_cast<double>(marker.tick - entry.first_tick) / rate_hz);
    marks << (marker.label.empty() ? when : QString("%1 %2").arg(when, shownText(marker.label)));
  }
  return marks.join(", ");
}

QString lossesOf(const SessionEntry& entry) {
  QStringList losses;
  if (!entry.info.isComplete())
    losses << QObject::tr(
        "Not closed: it is still being recorded, or the program ended without closing it. Recover repairs it.");
  else if (entry.info.end->reason == record::EndReason::Recovered)
    losses << QObject::tr("Recovered after the program ended without closing it.");
  else if (entry.info.end->reason == record::EndReason::DiskFull)
    losses << QObject::tr("Stopped because the disk was nearly full.");
  if (entry.info.dropped > 0) losses << QObject::tr("%1 ticks are missing.").arg(entry.info.dropped);
  if (entry.faults > 0)
    losses << (entry.faults == 1 ? QObject::tr("1 fault.") : QObject::tr("%1 faults.").arg(entry.faults));
  for (const Problem& problem : entry.info.damage) losses << shownText(problem.sentence);
  return losses.join(' ');
}

}  // namespace

QString linesOf(const SessionEntry& entry) {
  if (!entry.isReadable())
    return titleOf(entry) + '\n' + QStringList{shortDateOf(entry), QObject::tr("cannot be read")}.join(kBetween);
  QStringList facts;
  if (!entry.isClosed()) facts << QObject::tr("not closed: Recover");
  facts << shortDateOf(entry) << clockText(entry.info.duration_s) << bytesText(entry.size_bytes);
  const record::SessionHeader& header = entry.info.header;
  for (const std::string& one :
       {header.words.subject, header.words.name.empty() ? std::string() : header.scene_title, header.words.tags}) {
    if (!one.empty()) facts << shownText(one);
  }
  return titleOf(entry) + '\n' + facts.join(kBetween);
}

QString detailsOf(const SessionEntry& entry) {
  QStringList lines;
  const QString size = bytesText(entry.size_bytes);
  if (!entry.isReadable()) {
    lines << entry.wrong << QStringList{dateOf(entry, "d MMM yyyy hh:mm:ss"), size}.join(kBetween);
    return lines.join('\n');
  }
  const record::SessionHeader& header = entry.info.header;
  const QString losses = lossesOf(entry);
  if (!losses.isEmpty()) lines << losses;
  lines << QStringList{dateOf(entry, "d MMM yyyy hh:mm:ss"), spanText(entry.info.duration_s),
                       QObject::tr("%1 ticks").arg(entry.info.ticks), size}
               .join(kBetween);
  lines
      << QObject::tr("Scene %1").arg(header.scene_title.empty() ? QObject::tr("none") : shownText(header.scene_title)) +
             kBetween + shownText(header.device) + kBetween + QObject::tr("%1 Hz").arg(header.rate_hz);
  if (!header.words.subject.empty()) lines << QObject::tr("Subject %1").arg(shownText(header.words.subject));
  if (!header.words.consent.empty()) lines << QObject::tr("Consent %1").arg(shownText(header.words.consent));
  if (!header.words.tags.empty()) lines << QObject::tr("Tags %1").arg(shownText(header.words.tags));
  if (!entry.markers.empty()) lines << QObject::tr("Markers %1").arg(markersOf(entry));
  if (!header.words.notes.empty()) lines << shownText(header.words.notes);
  return lines.join('\n');
}

}  // namespace underact::gui
