/// A thread beside a process's first one, which alone takes signals.
#pragma once

#include <functional>
#include <thread>

namespace tetfarm {

/// Runs `work` in a thread that all signals are kept from.
std::thread thread_without_signals(std::function<void()> work);

}  // namespace tetfarm
