#pragma once
#include <cstddef>
#include <cstdint>

// The binary interface of OpenHaptics' HD library, 3.0 to 3.4, declared from published facts: the vendor's headers may
// not be passed on, and the library is bound while the program runs. Names of calls are the vendor's, so that its
// manual is found; everything else is ours.
namespace underact::device::openhaptics {

using Handle = std::uint32_t;  // of an arm
inline constexpr Handle kNoHandle = 0xFFFFFFFF;

struct ErrorInfo {
  std::uint32_t code = 0;
  std::int32_t internal_code = 0;
  Handle device = 0;
};
static_assert(sizeof(ErrorInfo) == 12, "returned by value: its size decides how");

using Callback = std::uint32_t (*)(void*);
inline constexpr std::uint32_t kCallbackDone = 0, kCallbackContinue = 1;
using Scheduled = unsigned long;  // a callback that was scheduled; 8 bytes on 64-bit Linux, 4 on Windows
inline constexpr std::uint16_t kMaxPriority = 65535;

inline constexpr std::size_t kRoom = 16;  // more values than any parameter has, whatever the model

/// What can be asked for: state, facts about the arm, limits, and force.
enum Parameter : std::uint32_t {
  kCurrentButtons = 0x2000,
  kSafetySwitch = 0x2001,
  kInkwellSwitch = 0x2002,
  kEncoderValues = 0x2010,
  kPosition = 0x2050,
  kVelocity = 0x2051,
  kTransform = 0x2052,
  kAngularVelocity = 0x2053,
  kJointAngles = 0x2100,
  kGimbalAngles = 0x2150,
  kLastButtons = 0x2200,
  kVersion = 0x2500,
  kModel = 0x2501,
  kDriverVersion = 0x2502,
  kVendor = 0x2503,
  kSerial = 0x2504,
  kFirmware = 0x2505,
  kMaxWorkspace = 0x2550,
  kUsableWorkspace = 0x2551,
  kTabletopOffset = 0x2552,
  kInputDof = 0x2553,
  kOutputDof = 0x2554,
  kCalibrationStyle = 0x2555,
  kUpdateRate = 0x2600,
  kInstantaneousUpdateRate = 0x2601,
  kMaxStiffness = 0x2602,
  kMaxForce = 0x2603,
  kMaxContinuousForce = 0x2604,
  kMotorTemperature = 0x2605,
  kVelocityLimit = 0x2606,
  kForceImpulseLimit = 0x2607,
  kForceRampingRate = 0x2608,
  kMaxDamping = 0x2609,
  kCurrentForce = 0x2700,
};

/// What can be switched.
enum Capability : std::uint32_t { kForceOutput = 0x4000 };

enum CalibrationStatus : std::uint32_t {
  kCalibrated = 0x5000,
  kCalibrationNeedsUpdate = 0x5001,
  kCalibrationNeedsHand = 0x5002,
};
enum CalibrationStyle : std::uint32_t { kEncoderReset = 1, kAutomatic = 2, kInkwell = 4 };

// clang-format off
// All 36 that the library exports: result, name, arguments. What takes Unused is never called here.
#define UNDERACT_HD_CALLS(CALL)                                     \
  CALL(Handle,        hdInitDevice,               (const char*))    \
  CALL(void,          hdMakeCurrentDevice,        (Handle))         \
  CALL(Handle,        hdGetCurrentDevice,         ())               \
  CALL(void,          hdDisableDevice,            (Handle))         \
  CALL(void,          hdBeginFrame,               (Handle))         \
  CALL(void,          hdEndFrame,                 (Handle))         \
  CALL(ErrorInfo,     hdGetError,                 ())               \
  CALL(const char*,   hdGetErrorString,           (std::uint32_t))  \
  CALL(void,          hdEnable,                   (std::uint32_t))  \
  CALL(void,          hdDisable,                  (std::uint32_t))  \
  CALL(std::uint8_t,  hdIsEnabled,                (std::uint32_t))  \
  CALL(void,          hdGetBooleanv,              (std::uint32_t, std::uint8_t*)) \
  CALL(void,          hdGetIntegerv,              (std::uint32_t, std::int32_t*)) \
  CALL(void,          hdGetFloatv,                (std::uint32_t, float*))        \
  CALL(void,          hdGetDoublev,               (std::uint32_t, double*))       \
  CALL(void,          hdGetLongv,                 (std::uint32_t, long*))         \
  CALL(const char*,   hdGetString,                (std::uint32_t))                \
  CALL(void,          hdSetBooleanv,              (std::uint32_t, const std::uint8_t*)) \
  CALL(void,          hdSetIntegerv,              (std::uint32_t, const std::int32_t*)) \
  CALL(void,          hdSetFloatv,                (std::uint32_t, const float*))        \
  CALL(void,          hdSetDoublev,               (std::uint32_t, const double*))       \
  CALL(void,          hdSetLongv,                 (std::uint32_t, const long*))         \
  CALL(std::uint32_t, hdCheckCalibration,         ())               \
  CALL(std::uint32_t, hdCheckCalibrationStyle,    ())               \
  CALL(void,          hdUpdateCalibration,        (std::uint32_t))  \
  CALL(void,          hdUpdateCalibrationMessage, (Unused))         \
  CALL(void,          hdScaleGimbalAngles,        (Unused))         \
  CALL(void,          hdDeploymentLicense,        (Unused))         \
  CALL(void,          hdStartScheduler,           ())               \
  CALL(void,          hdStopScheduler,            ())               \
  CALL(void,          hdSetSchedulerRate,         (unsigned long))  \
  CALL(void,          hdScheduleSynchronous,      (Callback, void*, std::uint16_t)) \
  CALL(Scheduled,     hdScheduleAsynchronous,     (Callback, void*, std::uint16_t)) \
  CALL(void,          hdUnschedule,               (Scheduled))      \
  CALL(std::uint8_t,  hdWaitForCompletion,        (Scheduled, std::uint32_t)) \
  CALL(double,        hdGetSchedulerTimeStamp,    ())
// clang-format on

struct Unused;  // no value of it can be made, so such a call does not compile

#if defined(_WIN32) && !defined(_WIN64)
#define UNDERACT_HD_CONVENTION __stdcall
#else
#define UNDERACT_HD_CONVENTION
#endif

/// The library's calls, bound.
struct Calls {
#define UNDERACT_HD_MEMBER(Type, name, arguments) Type(UNDERACT_HD_CONVENTION* name) arguments = nullptr;
  UNDERACT_HD_CALLS(UNDERACT_HD_MEMBER)
#undef UNDERACT_HD_MEMBER
};

}  // namespace underact::device::openhaptics
