#include "core/registration/registration_store.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/translate.h"

namespace underact::registration {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

Problems cannotKeep(const std::string& path, const std::error_code& error) {
  if (!error)
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "The registration cannot be saved. Check that the folder exists and is yours, and "
                                   "that the disk is not full.")),
             {path}}};
  return {{phrase(TRANSLATE_NOOP("problem",
                                 "The registration cannot be saved: %1. Check that the folder exists and is yours, and "
                                 "that the disk is not full."),
                  {error.message()}),
           {path}}};
}

}  // namespace

std::string registrationFolder() {
  if (const std::string own = variable("UNDERACT_REGISTRATION_DIR"); !own.empty()) return own;
  fs::path data = variable("XDG_DATA_HOME");
  if (data.empty()) data = variable("APPDATA");
  if (data.empty()) data = fs::path(variable("HOME")) / ".local" / "share";
  return (data / "underact" / "registrations").string();
}

std::string registrationPath(const std::string& arm, const std::string& folder) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string name;
  for (const char one : arm) {
    const auto code = static_cast<unsigned char>(one);
    const bool plain = (one >= '0' && one <= '9') || (one >= 'a' && one <= 'z') || (one >= 'A' && one <= 'Z') ||
                       one == '-' || one == '_';
    name += plain ? std::string(1, one) : std::string{'%', kHex[code >> 4U], kHex[code & 15U]};
  }
  return (fs::path(folder) / (name + ".json")).string();
}

Problems saveRegistration(const Registration& registration, const std::string& folder) {
  const std::string path = registrationPath(registration.arm, folder), fresh = path + ".new";
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannotKeep(folder, error);
  std::ofstream file(fresh, std::ios::binary);
  file << registrationText(registration);
  file.close();
  if (!file) return cannotKeep(fresh, {});
  fs::rename(fresh, path, error);  // atomic
  if (error) return cannotKeep(path, error);
  return {};
}

Result<std::optional<Registration>> loadRegistration(const std::string& arm, const std::string& folder) {
  const std::string path = registrationPath(arm, folder);
  std::error_code error;
  if (!fs::exists(path, error)) return std::optional<Registration>();
  Result<Registration> read = readRegistrationFile(path);
  if (!read) return read.problems();
  if (read.value().arm != arm)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "This is the registration of another arm, \"%1\". Register this arm again."),
                {read.value().arm}),
         {path}}};
  return std::optional<Registration>(std::move(read).value());
}

Problems removeRegistration(const std::string& arm, const std::string& folder) {
  const std::string path = registrationPath(arm, folder);
  std::error_code error;
  fs::remove(path, error);
  if (!error) return {};
  return {
      {phrase(TRANSLATE_NOOP("problem",
                             "The registration cannot be deleted: %1. Check that the folder exists and is yours, and "
                             "that the disk is not full."),
              {error.message()}),
       {path}}};
}

}  // namespace underact::registration
