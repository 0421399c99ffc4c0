#include "device/openhaptics/library.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

#include "core/base/translate.h"
#include "core/system/library.h"

namespace underact::device::openhaptics {
namespace {

#if defined(__APPLE__)
constexpr std::array kNames{"libHD.dylib"};
#else
constexpr std::array kNames{"libHD.so.3.4", "libHD.so.3.0", "libHD.so"};
#endif

struct State {
  std::mutex mutex;
  bool is_bound = false;
  Calls calls;
  std::vector<Missing> missing;  // of the last attempt
};

State& state() {
  static State the_one;
  return the_one;
}

std::vector<std::string> candidates() {
  const char* const path = std::getenv(kPathVariable);
  if (path != nullptr && *path != '\0') return {path};
  return {kNames.begin(), kNames.end()};
}

/// The first that loads. If none does: the system's message about the first that exists but lacks something, or about
/// the first.
void* open(std::string& why) {
  for (const std::string& name : candidates()) {
    std::string words;
    if (void* const library = system::openLibrary(name, words)) return library;
    const bool is_there = words.rfind(name + ":", 0) != 0;
    if (why.empty() || is_there) why = words;
    if (is_there) break;
  }
  return nullptr;
}

void attempt(State& state) {
  state.missing.clear();
  std::string why;
  void* const library = open(why);
  if (library == nullptr) {
    state.missing.push_back(explain(why));
    return;
  }
  const Problems problems = bind([library](const char* name) { return system::addressIn(library, name); }, state.calls);
  for (const Problem& problem : problems) state.missing.push_back({problem.sentence, ""});
  state.is_bound = problems.empty();
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

Result<const Calls*> load() {
  State& the = state();
  const std::scoped_lock lock(the.mutex);
  if (!the.is_bound) attempt(the);
  if (the.is_bound) return &the.calls;
  Problems problems;
  for (const Missing& one : the.missing)
    problems.push_back({one.command.empty()
                            ? one.sentence
                            : oneAfterAnother({one.sentence, phrase(TRANSLATE_NOOP("problem", "In a terminal: \"%1\"."),
                                                                    {one.command})}),
                        {}});
  return problems;
}

std::vector<Missing> missing() {
  (void)load();
  State& the = state();
  const std::scoped_lock lock(the.mutex);
  return the.missing;
}

Problems bind(const std::function<void*(const char*)>& resolve, Calls& calls) {
  std::string absent;
  const auto find = [&](const char* name, auto& call) {
    void* const address = resolve(name);
    if (address == nullptr) absent += (absent.empty() ? "" : ", ") + std::string(name);
    static_assert(sizeof(call) == sizeof(address));
    std::memcpy(&call, &address, sizeof(call));  // POSIX: an address of dlsym() is that of a function
  };
#define UNDERACT_HD_FIND(Type, name, arguments) find(#name, calls.name);
  UNDERACT_HD_CALLS(UNDERACT_HD_FIND)
#undef UNDERACT_HD_FIND
  if (absent.empty()) return {};
  return {{phrase(TRANSLATE_NOOP("problem", "The library that was found is not OpenHaptics 3.0 to 3.4: it lacks %1."),
                  {absent}),
           {}}};
}

Missing explain(std::string_view text) {
  const std::string name(text.substr(0, text.find(':')));
  const bool is_not_there = contains(text, "No such file") || contains(text, "image not found");
  if (!is_not_there)
    return {phrase(TRANSLATE_NOOP("problem", "The arm's driver cannot be loaded: %1."), {std::string(text)}), ""};
  if (contains(name, "libHD")) {
    return {phrase(TRANSLATE_NOOP("problem",
                                  "The vendor's driver, OpenHaptics, is not installed (%1 was not found). Get it for "
                                  "Linux from the maker of the arm, unpack it, and run its installer in its folder; "
                                  "then do the same with the arm's device driver."),
                   {name}),
            "sudo ./install"};
  }
  if (contains(name, "ncurses") || contains(name, "tinfo")) {
    return {phrase(TRANSLATE_NOOP("problem",
                                  "The vendor's driver needs %1 from the old packages libncurses5 and libtinfo5, which "
                                  "are not installed."),
                   {name}),
            "sudo apt-get install libncurses5 libtinfo5"};
  }
  if (contains(name, "libusb-1.0"))
    return {phrase(TRANSLATE_NOOP("problem", "The vendor's driver needs libusb, which is not installed.")),
            "sudo apt-get install libusb-1.0-0"};
  if (contains(name, "hantomIO") || contains(name, "HANToMIO")) {
    return {
        phrase(TRANSLATE_NOOP("problem",
                              "OpenHaptics is installed, but %1 of the arm's device driver is not, or the system has "
                              "not registered it yet. Install the device driver."),
               {name}),
        "sudo ldconfig"};
  }
  return {phrase(TRANSLATE_NOOP("problem", "The vendor's driver needs %1, which is missing."), {name}),
          "apt-cache search " + name.substr(0, name.find('.'))};
}

}  // namespace underact::device::openhaptics
