// What is put to the test: every technique of the table, the terms that techniques are made of, and the forms published
// elsewhere. Called by the command line and the tests.
#pragma once

#include <vector>

#include "filters/stress/stress_trial.h"

namespace boxprobe::stress {

/// The promise. Boxes below the smallest normal float and input that is NaN are held to no error bound.
constexpr double kSlabUlp = 2.0;         ///< slab factors, in units of the last place of the exact value
constexpr double kHitBoxSizes = 6.0e-7;  ///< of the hit, longest sides of the box
constexpr double kRoundedBoxSizes =
    1.0e-3;  ///< of the hit on a box with rounded edges, where no ray slides along a face
constexpr double kRoundedMostBoxSizes = 2.0e-4;  ///< the same for 99.99 % of the inputs of a class
constexpr double kSphereBoxSizes = 1.0e-6;       ///< the same of the sphere, times the cosine at which the ray meets it
constexpr double kTermRelative = 1.0e-6;         ///< solid-angle scale, GGX terms, weights
constexpr double kLampShare = 1.0e-2;            ///< of a lamp in the cosine hemisphere, shares of 1
constexpr double kLampSideRounding = 1.0e-2;  ///< of the least height over a lamp that is seen: nearer, either is right
constexpr double kLatticeLight = 1.0e-5;      ///< of nodes whose coefficients are up to 1
constexpr double kLevelError = 1.0e-3;        ///< levels of the chain: a hundredth of what can be seen

/// Every projection with every evaluation.
const std::vector<StressSubject>& techniqueSubjects();
/// The terms: level, weight, solid-angle scale, GGX, frames.
const std::vector<StressSubject>& termSubjects();
/// The published forms, measured as their robust counterparts are.
const std::vector<StressSubject>& publishedSubjects();

/// Null if there is none of that id, among all three.
const StressSubject* findSubject(std::string_view id);

/// Parts that more than one kind of subject is measured by.
bool finite(const glm::vec3& v);
/// Two numbers in [0, 1) to draw a half vector with.
glm::vec2 lobeNumbers(const StressInput& in);
/// 1 / blend distance as the host makes it.
float blendRate(const StressInput& in);
/// By the program's own box projection, without a bevel.
shading::ProbeHit boxHit(const LocalInput& in);
/// Length that errors count in: the box, or where no float position is known to a fraction of it, the way to it.
double lengthScale(const LocalInput& in, const StressClass& c);
double ulpsFrom(float value, long double exact);
/// Slab factors, exit and hit of a box, whichever way they were found.
void measureBox(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, Trial& trial, TrialLog* log);
/// Of a box with rounded edges, found at the distance `t`; the sharp box's exit is taken as exact.
void measureRoundedBox(const LocalInput& in, const StressClass& c, float t, float exit, Trial& trial, TrialLog* log);
void measureSphere(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, Trial& trial,
                   TrialLog* log);
/// Of the solid-angle scale at a box's hit, the hit taken as exact.
void measureFootprintScale(const LocalInput& in, const StressClass& c, const shading::ProbeHit& hit, float scale,
                           Trial& trial, TrialLog* log);
/// R against 2 max(N.V, 0) N - V.
void measureReflection(const LocalInput& in, const StressClass& c, const glm::vec3& r, Trial& trial, TrialLog* log);
void measureTerm(const StressClass& c, const char* name, float value, long double exact, Trial& trial, TrialLog* log);

}  // namespace boxprobe::stress
