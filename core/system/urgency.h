#pragma once
#include <optional>
#include <string>

namespace underact::system {

/// A scheduling of the system's; by itself that of any program.
struct Urgency {
  int policy = 0, priority = 0;
};

/// One less than the servo's, where the system grants it to this program's threads.
std::optional<Urgency> urgencyGranted();

/// The calling thread's.
Urgency ownUrgency();
/// false: the system does not grant it.
bool setOwnUrgency(const Urgency& wanted);

/// Gives this program's threads of that name (at most 15 characters) the urgency that is granted, or (on: false) that
/// of any program. Where nothing is granted, or there is no such thread, nothing happens.
void setUrgency(const std::string& thread_name, bool on);

}  // namespace underact::system
