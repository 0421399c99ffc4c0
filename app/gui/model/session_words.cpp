#include "app/gui/model/session_words.h"

#include <QObject>
#include <cmath>

#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr double kLow_s = 600.0;
constexpr std::int64_t kLow_bytes = 1'000'000'000;
constexpr double kMinute_s = 60.0, kHour_s = 3600.0, kDay_s = 86400.0;

}  // namespace

QString clockText(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::max(0.0, seconds));
  const std::int64_t hours = whole / 3600;
  const QString rest = QString("%1:%2").arg(whole / 60 % 60, 2, 10, QChar('0')).arg(whole % 60, 2, 10, QChar('0'));
  return hours == 0 ? rest : QString("%1:%2").arg(hours).arg(rest);
}

QString spanText(double seconds) {
  const auto whole = [](double value) { return static_cast<std::int64_t>(value); };
  if (!(seconds >= 0.0)) return numberText(seconds, 0);
  if (seconds < kMinute_s) return QObject::tr("%1 s").arg(numberText(seconds, 1));
  if (seconds < 10.0 * kMinute_s) return QObject::tr("%1 min %2 s").arg(whole(seconds) / 60).arg(whole(seconds) % 60);
  if (seconds < kHour_s) return QObject::tr("%1 min").arg(whole(seconds / kMinute_s));
  if (seconds < kDay_s) return QObject::tr("%1 h %2 min").arg(whole(seconds) / 3600).arg(whole(seconds) / 60 % 60);
  const std::int64_t days = whole(seconds / kDay_s);
  return days == 1 ? QObject::tr("1 day") : QObject::tr("%1 days").arg(days);
}

QString bytesText(std::int64_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (size < 1e6) return QObject::tr("%1 kB").arg(numberText(std::ceil(size / 1e3), 0));
  if (size < 1e9) return QObject::tr("%1 MB").arg(numberText(size / 1e6, 1));
  return QObject::tr("%1 GB").arg(numberText(size / 1e9, 1));
}

bool isDiskLow(const record::RecorderStatus& status) {
  if (status.disk_left_bytes <= 0) return false;  // not measured yet
  const bool soon = status.disk_left_s > 0.0 && status.disk_left_s < kLow_s;
  return soon || status.disk_left_bytes < kLow_bytes;
}

QString diskText(const record::RecorderStatus& status) {
  if (status.disk_left_bytes <= 0) return QChar(0x2013);
  const QString bytes = bytesText(status.disk_left_bytes);
  return status.disk_left_s > 0.0 ? QObject::tr("%1, enough for %2").arg(bytes, spanText(status.disk_left_s)) : bytes;
}

}  // namespace underact::gui
