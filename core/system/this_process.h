#pragma once
#include <cstdint>
#include <string>

namespace underact::system {

/// The path of the running program; empty: the system does not say.
std::string ownProgram();
/// The number of this process, as the system has it.
std::int64_t processId();
/// A word that no other program at work has, and this one once.
std::string unusedWord();
/// The name of this computer; "this-computer" where the system does not say.
std::string computerName();
/// In the environment of this process and what it starts. Empty: taken out of it. No other thread may look.
void setVariable(const char* name, const std::string& value);
/// It is somebody at a terminal who reads or types there.
bool isTerminal(int descriptor);
/// At once: nothing is put in order.
[[noreturn]] void end(int status);
/// Others have more need of the processor; more: of more of them.
void stepBack(int more);
/// Blocks as large as a picture's go back to the system when they are freed. The C library would keep them once it has
/// seen one, and where memory is locked it cannot give them back later: 13 MB after the start on Debian 13.
void giveLargeBlocksBack();

}  // namespace underact::system
