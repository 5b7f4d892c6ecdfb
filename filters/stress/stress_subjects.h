// The subjects of the stress test: every technique of the table, the terms that techniques consist of, and published
// forms.
#pragma once

#include <vector>

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

/// The bounds. They do not apply to boxes below the smallest normal float, or to NaN inputs.
constexpr double kSlabUlp = 2.0;                 ///< slab factors, in ulps of the exact value
constexpr double kHitBoxSizes = 6.0e-7;          ///< of the hit, relative to the box's longest side
constexpr double kRoundedBoxSizes = 1.0e-3;      ///< of the hit on a rounded box, where no ray slides along a face
constexpr double kRoundedMostBoxSizes = 2.0e-4;  ///< the same for 99.99 % of the inputs of a class
constexpr double kSphereBoxSizes = 1.0e-6;       ///< the same for the sphere, times the cosine between ray and normal
constexpr double kTermRelative = 1.0e-6;         ///< solid-angle scale, GGX terms, weights
constexpr double kLampShare = 1.0e-2;            ///< of a lamp in the cosine hemisphere, shares of 1
constexpr double kLampSideRounding = 1.0e-2;     ///< of the least visible height over a lamp; closer, either is right
constexpr double kLatticeLight = 1.0e-5;         ///< of nodes whose coefficients are up to 1
constexpr double kLevelError = 1.0e-3;           ///< levels of the chain: a hundredth of the visible threshold

/// Every projection combined with every evaluation.
const std::vector<StressSubject>& techniqueSubjects();
/// The terms: level, weight, solid-angle scale, GGX, frames.
const std::vector<StressSubject>& termSubjects();
/// The published forms, measured like their robust counterparts.
const std::vector<StressSubject>& publishedSubjects();

/// Null if no subject of the three kinds has that id.
const StressSubject* findSubject(std::string_view id);

/// Shared by several kinds of subjects.
bool finite(const glm::vec3& v);
/// Two numbers in [0, 1) from which a half vector is drawn.
glm::vec2 lobeNumbers(const StressInput& in);
/// 1 / blend distance as the host computes it.
float blendRate(const StressInput& in);
/// The hit of the program's box projection, without a bevel.
shading::ProbeHit boxHit(const LocalInput& in);
/// The unit of errors: the box's size, or the distance to it if float positions are less accurate than that.
double lengthScale(const LocalInput& in, const StressClass& c);
double ulpsFrom(float value, long double exact);
/// Measures slab factors, exit and hit of a box, however they were found.
void measureBox(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, Trial& trial, TrialLog* log);
/// The same for a box with rounded edges, with the exit at distance `t`; the sharp box's exit is taken as exact.
void measureRoundedBox(const LocalInput& in, const StressClass& c, float t, float exit, Trial& trial, TrialLog* log);
void measureSphere(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, Trial& trial,
                   TrialLog* log);
/// Measures the solid-angle scale at a box's hit, taking the hit as exact.
void measureFootprintScale(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, float scale,
                           Trial& trial, TrialLog* log);
/// Measures R against 2 max(N.V, 0) N - V.
void measureReflection(const LocalInput& in, const StressClass& c, const glm::vec3& r, Trial& trial, TrialLog* log);
void measureTerm(const StressClass& c, const char* name, float value, long double exact, Trial& trial, TrialLog* log);

}  // namespace boxprobe::stress
