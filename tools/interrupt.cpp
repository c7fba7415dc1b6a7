// SPDX-License-Identifier: MIT
#include "tools/interrupt.h"

#include <array>
#include <atomic>
#include <csignal>

namespace tress {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM};

std::atomic<int> caught = 0;  // lock-free, so that a handler may set it
static_assert(std::atomic<int>::is_always_lock_free);
std::array<struct sigaction, kSignals.size()> before;

void note(int signal) { caught = signal; }

}  // namespace

Interrupt::Interrupt() {
    caught = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART | int(SA_RESETHAND);  // no write is cut short; the default is back after the first
    for (size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN)
            sigaction(kSignals[i], &action, nullptr);  // who ignores it (nohup) wants that
    }
}

Interrupt::~Interrupt() {
    for (size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before[i], nullptr);
}

int Interrupt::signal() const { return caught; }

}  // namespace tress
