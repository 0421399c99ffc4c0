#include "core/sweep/messages.h"

#include <array>
#include <charconv>
#include <string_view>

namespace underact::sweep {
namespace {

constexpr std::array<std::string_view, 5> kWords{"hello", "done", "trouble", "interrupted", "bye"};
constexpr std::string_view kStop = "stop", kCells = "cells";

/// Removes the part up to the next `at` (all, if there is none), and that character, from the front of text, and gives
/// it.
std::string_view takeUntil(std::string_view& text, char at) {
  const std::size_t found = text.find(at);
  const std::string_view taken = text.substr(0, found);
  text.remove_prefix(found == std::string_view::npos ? text.size() : found + 1);
  return taken;
}

std::optional<std::size_t> count(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

std::string write(const Report& report) {
  std::string message(kWords[static_cast<std::size_t>(report.word)]);
  if (report.word != MessageKind::Done) return message + "\n" + report.text;
  message += "\n" + std::to_string(report.wants) + "\n";
  for (const Report::Line& line : report.rows) message += std::to_string(line.cell) + " " + line.row + "\n";
  return message;
}

std::string write(const Order& order) {
  std::string message(order.stop ? kStop : kCells);
  for (const std::size_t cell : order.cells) message += "\n" + std::to_string(cell);
  return message;
}

std::optional<Report> readReport(const std::string& message) {
  std::string_view text = message;
  const std::string_view word = takeUntil(text, '\n');
  std::size_t index = 0;
  while (index < kWords.size() && kWords[index] != word) ++index;
  if (index == kWords.size()) return {};
  Report report{static_cast<MessageKind>(index)};
  if (report.word != MessageKind::Done) {
    report.text = text;
    return report;
  }
  const std::optional<std::size_t> wants = count(takeUntil(text, '\n'));
  if (!wants) return {};
  report.wants = *wants;
  while (!text.empty()) {
    std::string_view line = takeUntil(text, '\n');
    const std::optional<std::size_t> cell = count(takeUntil(line, ' '));
    if (!cell) return {};
    report.rows.push_back({*cell, std::string(line)});
  }
  return report;
}

std::optional<Order> readOrder(const std::string& message) {
  std::string_view text = message;
  const std::string_view word = takeUntil(text, '\n');
  if (word == kStop) return Order{true};
  if (word != kCells) return {};
  Order order;
  while (!text.empty()) {
    const std::optional<std::size_t> cell = count(takeUntil(text, '\n'));
    if (!cell) return {};
    order.cells.push_back(*cell);
  }
  return order;
}

}  // namespace underact::sweep
