#ifdef __linux__
#include <csignal>

#include "core/system/signals.h"

namespace underact::system {
namespace {

volatile std::sig_atomic_t signal_came = 0;

void onSignal(int /*number*/) {
  signal_came = 1;
}

/// Takes over a signal; but if the process was started to ignore the end of its terminal (nohup), it goes on to ignore
/// it.
void takeOver(int signal, void (*handler)(int), std::vector<std::pair<int, void (*)(int)>>& before) {
  void (*const old)(int) = std::signal(signal, handler);
  if (old == SIG_ERR) return;
  before.emplace_back(signal, old);
  if (signal == SIGHUP && old == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

Interrupt::Interrupt(Reader reader) {
  signal_came = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) takeOver(signal, onSignal, before_);
  if (reader == Reader::MayGo) takeOver(SIGPIPE, SIG_IGN, before_);
}

Interrupt::~Interrupt() {
  for (const auto& [signal, handler] : before_) std::signal(signal, handler);
}

bool Interrupt::came() const {
  return signal_came != 0;
}

void endWithParentOnly() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
}

void reportFullFiles() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace underact::system
#endif
