#pragma once
#include <cstdint>
#include <string>

namespace underact::system {

/// The path of the running program; empty: the system does not say.
std::string ownProgram();
/// The number of this process, as the system has it.
std::int64_t processId();
/// A word that no other running program has; a new one with each call.
std::string uniqueWord();
/// The name of this computer; "this-computer" where the system does not say.
std::string computerName();
/// Sets a variable in the environment of this process and those it starts; empty: removes it. No other thread may read
/// the environment meanwhile.
void setVariable(const char* name, const std::string& value);
/// Whether the descriptor is a terminal.
bool isTerminal(int descriptor);
/// Ends the process at once, without any cleaning up.
[[noreturn]] void end(int status);
/// Lowers the priority of this process; more: by how much.
void lowerPriority(int more);
/// Makes the C library return large blocks, such as pictures, to the system when they are freed. It would keep them
/// once it has seen one, and with locked memory it cannot return them later: 13 MB after the start on Debian 13.
void returnLargeBlocks();

}  // namespace underact::system
