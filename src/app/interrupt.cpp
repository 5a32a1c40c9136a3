#include "app/interrupt.h"

#include <csignal>

namespace vkpt {
namespace {

volatile std::sig_atomic_t g_requested = 0;

void onSignal(int signal) {
  g_requested = 1;
  std::signal(signal, SIG_DFL);
}

} // namespace

InterruptGuard::InterruptGuard() {
  g_requested = 0;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::requested() { return g_requested != 0; }

} // namespace vkpt
