#pragma once
#include <optional>
#include <string>

namespace underact::system {

/// A scheduling policy and priority; by default those of any program.
struct ThreadPriority {
  int policy = 0, priority = 0;
};

/// Just below the servo's, where the system grants it to this program's threads.
std::optional<ThreadPriority> grantedPriority();

/// That of the calling thread.
ThreadPriority ownPriority();
/// Sets that of the calling thread. false: the system does not grant it.
bool setOwnPriority(const ThreadPriority& wanted);

/// Gives this program's threads of that name (at most 15 characters) the urgency that is granted, or (on: false) the
/// default one. Without effect where nothing is granted, or there is no such thread.
void setThreadPriority(const std::string& thread_name, bool on);

}  // namespace underact::system
