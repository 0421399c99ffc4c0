#ifdef __linux__
#include <csignal>

#include "core/system/signals.h"

namespace underact::system {
namespace {

volatile std::sig_atomic_t signal_came = 0;
int interrupts = 0;  // that exist
std::atomic<std::atomic<std::uint64_t>*> signal_counter = nullptr;
static_assert(decltype(signal_counter)::is_always_lock_free && std::atomic<std::uint64_t>::is_always_lock_free);

void onSignal(int /*number*/) {
  signal_came = 1;
  if (std::atomic<std::uint64_t>* const counter = signal_counter.load(); counter != nullptr) counter->fetch_add(1);
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

Interrupt::Interrupt(Reader reader, std::atomic<std::uint64_t>* counter) {
  if (interrupts++ == 0) signal_came = 0;
  counter_before_ = signal_counter.exchange(counter);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) takeOver(signal, onSignal, before_);
  if (reader == Reader::MayGo) takeOver(SIGPIPE, SIG_IGN, before_);
}

Interrupt::~Interrupt() {
  for (const auto& [signal, handler] : before_) std::signal(signal, handler);
  signal_counter = counter_before_;
  --interrupts;
}

bool Interrupt::came() const {
  return signal_came != 0;
}

void endWithParentOnly() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
}

void reportFullFiles() {
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace underact::system
#endif
