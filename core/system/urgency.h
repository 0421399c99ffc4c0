#pragma once
#include <optional>
#include <string>

namespace underact::system {

/// A scheduling policy and priority; by default those of any program.
struct Urgency {
  int policy = 0, priority = 0;
};

/// Just below the servo's, where the system grants it to this program's threads.
std::optional<Urgency> urgencyGranted();

/// That of the calling thread.
Urgency ownUrgency();
/// Sets that of the calling thread. false: the system does not grant it.
bool setOwnUrgency(const Urgency& wanted);

/// Gives this program's threads of that name (at most 15 characters) the urgency that is granted, or (on: false) the
/// default one. Without effect where nothing is granted, or there is no such thread.
void setUrgency(const std::string& thread_name, bool on);

}  // namespace underact::system
