#include "core/sweep/row.h"

#include <cmath>

#include "core/json/json.h"

namespace underact::sweep {
namespace {

std::string inQuotes(std::string_view text) {
  std::string field = "\"";
  for (const char message : text) field += message == '"' ? std::string("\"\"") : std::string(1, message);
  return field + "\"";
}

}  // namespace

void SweepRow::addRaw(std::string_view field) {
  if (fields_++ > 0) text_ += ',';
  text_ += field;
}

void SweepRow::add(double value) {
  if (std::isfinite(value)) return addRaw(json::numberText(value));
  addRaw(std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
}

void SweepRow::add(std::string_view text) {
  std::string line(text);
  for (char& message : line) {
    if (static_cast<unsigned char>(message) < 0x20U) message = ' ';
  }
  const bool plain =
      line.find_first_of(",\"") == std::string::npos && (line.empty() || (line.front() != ' ' && line.back() != ' '));
  addRaw(plain ? line : inQuotes(line));
}

}  // namespace underact::sweep
