#include "core/servo/guard_process.h"

#include <cerrno>
#include <new>
#include <utility>

namespace underact::servo {
namespace {

constexpr int kLeave_ms = 1000;  // the time for a guard to end when told to

std::string hexOf(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += {kDigits[value >> 4U], kDigits[value & 15U]};
  }
  return text;
}

}  // namespace

GuardProcess::GuardProcess(const ZeroForceMessage& word, std::int64_t limit_ns, std::string program)
    : limit_ns_(limit_ns),
      program_(std::move(program)),
      word_(word.bytes),
      memory_(system::SharedMemory::make("underact-guard", sizeof(GuardLine))),
      device_(system::Descriptor::copyOf(word.fd)),
      life_(system::makePipe()) {
  if (memory_.begin() == nullptr || !device_.isOpen() || !life_.reads.isOpen()) {
    failure_ = errno;
    return;
  }
  line_ = new (memory_.begin()) GuardLine;
}

GuardProcess::~GuardProcess() {
  if (line_ != nullptr) line_->farewell = 1;
  life_.writes.close();
  process_.waitForEnd(kLeave_ms);  // it may be stopped, or blocked by the arm, and must not block the program
}

bool GuardProcess::start() {
  process_ = system::Process({.program = program_,
                              .arguments = {std::to_string(limit_ns_), hexOf(word_)},
                              .given = {-1, -1, -1, memory_.descriptor(), life_.reads.number(), device_.number()},
                              .is_apart = true});
  failure_ = process_.error();
  return process_.runs();
}

}  // namespace underact::servo
