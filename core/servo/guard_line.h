#pragma once

namespace underact::servo {

// Where the guard finds what it is given, and what it is told: one place for both programs.
inline constexpr int kGuardBeatsFd = 3;      // shared memory: one 64 bit count, up by one each tick
inline constexpr int kGuardLifeFd = 4;       // a socket: it ends when the program does
inline constexpr int kGuardDeviceFd = 5;     // the arm
inline constexpr char kGuardFarewell = 'q';  // through the socket: an orderly end, say nothing

}  // namespace underact::servo
