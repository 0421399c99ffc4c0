#pragma once

namespace underact {

inline constexpr double kPi = 3.14159265358979323846;

// Scene files, the screen and device borders use mm, N/mm and degrees; core uses SI. All factors are defined here.
inline constexpr double kMetrePerMillimetre = 1e-3;
inline constexpr double kMillimetrePerMetre = 1e3;
inline constexpr double kNewtonPerMetre = 1e3;  // 1 N/mm; also 1 N s/mm in N s/m, and 1 N/(mm s) in N/(m s)
inline constexpr double kRadPerDegree = kPi / 180.0;
inline constexpr double kSecondPerMillisecond = 1e-3;
inline constexpr double kSecondPerNanosecond = 1e-9;

}  // namespace underact
