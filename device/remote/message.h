#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/arm/preset.h"
#include "core/arm/sample.h"
#include "core/base/sentence.h"

namespace underact::device::remote {

// The messages between a shared arm and the remote program that drives it. Each message: "UARM", the version (uint16),
// its kind (uint8), zero (uint8); then its fields in the order below, little-endian, numbers as IEEE 754, texts as a
// uint16 length in bytes and the bytes. The guide's page "Arms over the network" has the layout.

inline constexpr int kVersion = 1;
inline constexpr std::size_t kHeaderBytes = 8, kSampleBytes = 84, kForceBytes = 52;
inline constexpr std::size_t kLongestText = 600, kLongestMessage = 2048;

/// The state of the arm, once per period.
struct SampleMessage {
  std::uint64_t sequence = 0;  // counts its periods
  arm::Sample sample;          // time on the arm's own clock
  bool has_sample = false;     // false: the arm gave none; then the rest is of the last one
};

/// The force that answers a sample.
struct ForceMessage {
  std::uint64_t number = 0;    // counts forces
  std::uint64_t answered = 0;  // sequence of the sample
  Vec3 f_T_W = Vec3::Zero();
  bool pushes = false;  // of a tick; false: zero, sent by the network thread because no tick came
};

/// Whose joints the samples are.
struct Kinematics {
  std::string preset;
  arm::Geometry geometry;
};

/// "I want the arm", the first message of a program.
struct Hello {
  std::uint64_t token = 0;  // of the program: it may take its own place again
  int rate_hz = 0;          // its tick rate
  bool only_looks = false;  // wants only the answer
  Kinematics arm;
};

/// "It is yours", and its properties.
struct Welcome {
  int rate_hz = 0;
  bool allows_force = false, is_passive = false, untested = true;
  double max_force_N = 0.0;
  double frozen_s = 0.0;  // see servo::DeviceInfo
  Kinematics arm;
  std::string title;
};

enum class About : std::uint8_t {
  Refusal = 0,   // why the arm is refused
  InUse = 1,     // that another program has it
  OtherArm = 2,  // that its joints are another arm's
  Trouble = 3,   // what is wrong at the arm; empty: nothing any more
  Ended = 4      // that it is no longer shared
};
struct Words {
  About about = About::Refusal;
  Sentence text;
};

/// "I go."
struct Bye {};

using Message = std::variant<SampleMessage, ForceMessage, Hello, Welcome, Words, Bye>;

/// Texts longer than kLongestText are cut.
std::vector<std::uint8_t> bytesOf(const Message& message);

/// None if it is not exactly such a message: another version or length, a number that is not finite, an undefined flag,
/// a text with control characters.
std::optional<Message> readMessage(std::span<const std::uint8_t> bytes);

/// The version stated by a message of this kind; none: it is not one. Tells which of the two ends is older.
std::optional<int> versionOf(std::span<const std::uint8_t> bytes);

}  // namespace underact::device::remote
