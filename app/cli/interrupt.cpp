#include "app/cli/interrupt.h"

#include <csignal>

namespace underact::cli {
namespace {

volatile std::sig_atomic_t signal_came = 0;

void onSignal(int /*number*/) {
  signal_came = 1;
}

}  // namespace

Interrupt::Interrupt() {
  signal_came = 0;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interrupt::came() const {
  return signal_came != 0;
}

}  // namespace underact::cli
