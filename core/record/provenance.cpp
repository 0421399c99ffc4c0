#include "core/record/provenance.h"

#include <H5public.h>
#include <underact/version.h>
#include <zlib.h>

#include <Eigen/Core>
#include <array>
#include <boost/version.hpp>
#include <ctime>
#include <filesystem>
#include <random>
#include <variant>
#include <vector>

#include "core/arm/model.h"
#include "core/record/hdf5_id.h"
#include "core/record/laws.h"
#include "core/scene/fields.h"
#include "core/scene/load_meshes.h"
#include "core/scene/scene_arm.h"
#include "core/system/library.h"
#include "core/system/machine.h"
#include "core/system/this_process.h"

namespace underact::record {
namespace {

using json::ObjectText;

std::string hex(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    text += kDigits[static_cast<unsigned char>(byte) >> 4U];
    text += kDigits[static_cast<unsigned char>(byte) & 15U];
  }
  return text;
}

std::string lastPart(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

ObjectText library(const std::string& name, const std::string& version, const std::string& build_id) {
  ObjectText object;
  object.addText("name", name);
  if (!version.empty()) object.addText("version", version);
  if (!build_id.empty()) object.addText("build_id", build_id);
  return object;
}

std::string dotted(std::initializer_list<int> numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ".") + std::to_string(number);
  return text;
}

/// What was compiled in by its version, then what is loaded, by its build id.
std::vector<ObjectText> libraries(const std::vector<system::Loaded>& loaded) {
  quiet();
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  std::vector<ObjectText> list{
      library("Eigen", dotted({EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION}), ""),
      library("Boost", dotted({BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100}), ""),
      library("HDF5", dotted({static_cast<int>(major), static_cast<int>(minor), static_cast<int>(release)}), ""),
      library("zlib", zlibVersion(), "")};
  for (std::size_t index = 1; index < loaded.size(); ++index) {  // the first one is the program
    if (!loaded[index].path.empty())
      list.push_back(library(lastPart(loaded[index].path), "", hex(loaded[index].build_id)));
  }
  return list;
}

const char* compiler() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#elif defined(__GNUC__)
  return "GCC " __VERSION__;
#else
  return "unknown";
#endif
}

const char* optimised() {
#ifdef __OPTIMIZE__
  return "yes";
#else
  return "no";
#endif
}

ObjectText programProvenance() {
  const std::vector<system::Loaded> loaded = system::loadedHere();
  ObjectText object;
  object.addText("name", lastPart(system::ownProgram()));
  object.addText("version", kVersion);
  object.addText("build_id", loaded.empty() ? std::string() : hex(loaded.front().build_id));
  object.addText("compiler", compiler());
  object.addText("optimised", optimised());
  object.addList("libraries", libraries(loaded));
  return object;
}

ObjectText machineProvenance() {
  const system::Machine machine = system::thisMachine();
  ObjectText object;
  object.addText("processor", machine.processor);
  object.addInteger("cores", machine.cores);
  object.addText("kernel", machine.kernel);
  object.addText("architecture", machine.architecture);
  object.addText("c_library", machine.c_library);
  return object;
}

ObjectText armProvenance(const servo::Host& host) {
  const std::string file(scene::armTextOf(host.scene()));
  ObjectText object;
  object.addText("name", scene::withoutFolders(host.scene()).arm);
  if (!file.empty()) object.addText("file", file);
  return object;
}

ObjectText deviceProvenance(const servo::DeviceInfo& device) {
  ObjectText object;
  object.addText("title", device.title);
  object.addText("serial", device.serial);
  object.addBool("simulated", device.simulated);
  object.addBool("untested", device.untested);
  return object;
}

const char* schedulingWord(system::SchedulingMethod method) {
  switch (method) {
    case system::SchedulingMethod::Auto:
      return "auto";
    case system::SchedulingMethod::Fifo:
      return "fifo";
    case system::SchedulingMethod::Rtkit:
      return "rtkit";
    case system::SchedulingMethod::Normal:
      return "normal";
  }
  return "";
}

ObjectText schedulingProvenance(const servo::Host& host) {
  const system::SchedulingRequest& wanted = host.schedulingWanted();
  const system::Scheduling granted = host.scheduling();
  ObjectText object;
  object.addText("wanted", schedulingWord(wanted.method));
  object.addInteger("wanted_core", wanted.core);
  object.addBool("wanted_memory_locked", wanted.lock_memory);
  object.addText("granted", granted.name);
  object.addTexts("also", {granted.also.begin(), granted.also.end()});
  return object;
}

/// The filter of the error's rate with its settings.
ObjectText velocityProvenance(const scene::Velocity& velocity) {
  ObjectText object;
  object.addText("filter", json::wordOf(scene::kFilterWords, velocity.index()));
  if (const auto* const kalman = std::get_if<scene::KalmanFilter>(&velocity)) {
    object.addNumber("noise_mm", kalman->noise_mm);
    object.addNumber("acceleration_mm_per_s2", kalman->acceleration_mm_per_s2);
  } else if (const auto* const low_pass = std::get_if<scene::LowPassFilter>(&velocity)) {
    object.addNumber("time_constant_ms", low_pass->time_constant_ms);
  } else if (const auto* const window = std::get_if<scene::AdaptiveWindowFilter>(&velocity)) {
    object.addNumber("window", window->window);
    object.addNumber("noise_mm", window->noise_mm);
  }
  return object;
}

/// The gains as they act: one that the law does not use is 0.
ObjectText gainsOf(const scene::Constraint& constraint, const scene::Control& control) {
  ObjectText object;
  object.addText("constraint", constraint.name);
  object.addText("law", json::wordOf(scene::kLawWords, control.law));
  object.addText("space", json::wordOf(scene::kSpaceWords, control.space));
  object.addVector("kp_N_per_mm", control.gains.kp_N_per_mm);
  object.addVector("kd_N_s_per_mm",
                   control.law == scene::LawType::P ? Vec3(Vec3::Zero()) : control.gains.kd_N_s_per_mm);
  object.addVector("ki_N_per_mm_s",
                   control.law == scene::LawType::PID ? control.gains.ki_N_per_mm_s : Vec3(Vec3::Zero()));
  object.addText("anisotropy", json::wordOf(scene::kAnisotropyWords, control.anisotropy));
  object.addText("passivity", json::wordOf(scene::kPassivityWords, control.passivity));
  object.addObject("velocity", velocityProvenance(control.velocity));
  return object;
}

}  // namespace

ObjectText servoProvenance(const servo::Host& host) {
  ObjectText servo;
  servo.addInteger("rate_hz", host.rateHz());
  servo.addObject("scheduling", schedulingProvenance(host));
  servo.addInteger("max_late", host.maxLate());
  servo.addNumber("frozen_s", host.device().frozen_s);
  servo.addNumber("force_share", host.forceShare());
  servo.addBool("hold_to_run", host.holdToRun());
  ObjectText object;
  object.addObject("servo", servo);
  return object;
}

ObjectText provenanceOf(const std::string& session_id, const std::string& continues, const ObjectText& common) {
  ObjectText object;
  object.addInteger("underact_provenance", 1);
  object.addText("session", session_id);
  if (!continues.empty()) object.addText("continues", continues);
  object.addAll(lawVersions());
  object.addAll(common);
  return object;
}

ObjectText provenanceOf(const servo::Host& host, const ObjectText& run) {
  ObjectText object;
  object.addObject("program", programProvenance());
  object.addObject("machine", machineProvenance());
  object.addObject("arm", armProvenance(host));
  object.addObject("device", deviceProvenance(host.device()));
  object.addAll(servoProvenance(host));
  object.addAll(run);
  return object;
}

ObjectText sceneProvenance(const scene::Description& whole) {
  const scene::Description scene = scene::withoutFolders(whole);
  std::vector<ObjectText> gains, files;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const scene::Constraint& constraint = scene.constraints[index];
    gains.push_back(gainsOf(constraint, scene::controlOf(scene, index)));
    const auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape);
    const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
    if (mesh == nullptr && curve == nullptr) continue;
    ObjectText& file = files.emplace_back();
    file.addText("constraint", constraint.name);
    file.addText("file", mesh != nullptr ? mesh->file : curve->file);
    file.addText("xxh3_128", mesh != nullptr ? mesh->checksum : curve->checksum);
  }
  ObjectText object;
  object.addList("gains", gains);
  object.addList("files", files);
  return object;
}

std::string newSessionId() {
  std::random_device dice;
  std::array<char, 16> bytes{};
  for (std::size_t index = 0; index < bytes.size(); ++index)
    bytes[index] = static_cast<char>(static_cast<unsigned char>(dice() & 255U));
  return hex({bytes.data(), bytes.size()});
}

std::int64_t unixNow_ns() {
  timespec now{};
  timespec_get(&now, TIME_UTC);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

}  // namespace underact::record
