#include "filters/reference/trace/visible_normal_lobe.h"

#include <algorithm>
#include <cmath>

namespace boxprobe {

namespace {

constexpr double kTwoPi = 6.283185307179586;
// Smaller cosines count as grazing, because their tangents would be rounding errors.
constexpr double kLeastCosine = 1.0e-5;

double fraction(double x) {
  return x - std::floor(x);
}

// 53 bits, the precision of a double in [0, 1).
double unitNumber(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

// Any unit vector perpendicular to `n`, from the axis most perpendicular to it.
glm::dvec3 across(const glm::dvec3& n) {
  const glm::dvec3 a = glm::abs(n);
  const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                          : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                   : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

}  // namespace

std::uint64_t hashBits(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

ShiftedPoints::ShiftedPoints(std::uint64_t seed)
    : shift_(unitNumber(hashBits(seed)), unitNumber(hashBits(hashBits(seed) + 1))) {}

glm::dvec2 ShiftedPoints::operator[](int index) const {
  constexpr double kPlastic = 1.32471795724474602596;
  return {fraction(shift_.x + index / kPlastic), fraction(shift_.y + index / (kPlastic * kPlastic))};
}

VisibleNormalLobe::VisibleNormalLobe(const glm::dvec3& normal, const glm::dvec3& view, double alpha)
    : normal_(normal), mirrored_(2.0 * std::max(glm::dot(normal, view), 0.0) * normal - view), alpha_(alpha) {
  const double facing = glm::dot(normal, view);
  cosine_ = std::clamp(facing, kLeastCosine, 1.0);
  sine_ = std::sqrt(1.0 - cosine_ * cosine_);
  const glm::dvec3 along = view - facing * normal;
  const double length = glm::length(along);
  tangent_ = length > 1.0e-12 ? along / length : across(normal);
  bitangent_ = glm::cross(normal_, tangent_);
  const double x = alpha_ * sine_, scale = 1.0 / std::sqrt(x * x + cosine_ * cosine_);
  stretchedX_ = x * scale;
  stretchedZ_ = cosine_ * scale;
  viewRoot_ = std::sqrt(alpha_ * alpha_ + (1.0 - alpha_ * alpha_) * cosine_ * cosine_);
}

VisibleNormalLobe::Sample VisibleNormalLobe::sample(const glm::dvec2& u) const {
  if (alphaAlong_ > 0.0) return sampleBrushed(u);
  if (mirror()) return {mirrored_, 1.0, cosine_};
  // A point of the projected hemisphere of visible microfacets. Axes: y, (-z, 0, x) of the stretched view, the view.
  const double radius = std::sqrt(u.x), phi = kTwoPi * u.y;
  const double t1 = radius * std::cos(phi);
  const double s = 0.5 * (1.0 + stretchedZ_);
  const double t2 = (1.0 - s) * std::sqrt(std::max(1.0 - t1 * t1, 0.0)) + s * radius * std::sin(phi);
  const double t3 = std::sqrt(std::max(1.0 - t1 * t1 - t2 * t2, 0.0));
  const glm::dvec3 h = glm::normalize(glm::dvec3(alpha_ * (stretchedX_ * t3 - stretchedZ_ * t2), alpha_ * t1,
                                                 std::max(stretchedX_ * t2 + stretchedZ_ * t3, 0.0)));
  const double hDotV = std::min(h.x * sine_ + h.z * cosine_, 1.0);
  const glm::dvec3 l = 2.0 * hDotV * h - glm::dvec3(sine_, 0.0, cosine_);
  if (!(l.z > 0.0)) return {normal_, 0.0, 0.0};
  const double lightRoot = std::sqrt(alpha_ * alpha_ + (1.0 - alpha_ * alpha_) * l.z * l.z);
  const double weight = l.z * (cosine_ + viewRoot_) / (cosine_ * lightRoot + l.z * viewRoot_);
  return {l.x * tangent_ + l.y * bitangent_ + l.z * normal_, weight, hDotV};
}

VisibleNormalLobe VisibleNormalLobe::widened(double alpha) const {
  if (alphaAlong_ > 0.0) {
    const glm::dvec3 view = view_.x * tangent_ + view_.y * bitangent_ + view_.z * normal_;
    return {normal_, bitangent_, view, std::max(alphaAlong_, alpha), std::max(alpha_, alpha)};
  }
  return {normal_, sine_ * tangent_ + cosine_ * normal_, std::max(alpha_, alpha)};
}

VisibleNormalLobe::Density VisibleNormalLobe::at(const glm::dvec3& direction) const {
  if (alphaAlong_ > 0.0) return brushedAt(direction);
  const glm::dvec3 l(glm::dot(direction, tangent_), glm::dot(direction, bitangent_), glm::dot(direction, normal_));
  const glm::dvec3 v(sine_, 0.0, cosine_), sum = l + v;
  const double length = glm::length(sum);
  if (!(l.z > 0.0) || length < 1.0e-12 || mirror()) return {};
  const glm::dvec3 h = sum / length;
  const double hDotV = std::min(glm::dot(h, v), 1.0);
  if (!(hDotV > 0.0) || !(h.z > 0.0)) return {};
  // D_v(h) / (4 h.v) = G1(v) D(h) / (4 n.v); Smith's G1, Trowbridge and Reitz's D.
  const double a2 = alpha_ * alpha_, d = h.z * h.z * (a2 - 1.0) + 1.0;
  const double distribution = a2 / (0.5 * kTwoPi * d * d);
  const double masking = 2.0 * cosine_ / (cosine_ + viewRoot_);
  const double lightRoot = std::sqrt(a2 + (1.0 - a2) * l.z * l.z);
  const double weight = l.z * (cosine_ + viewRoot_) / (cosine_ * lightRoot + l.z * viewRoot_);
  return {masking * distribution / (4.0 * cosine_), weight, hDotV};
}

}  // namespace boxprobe
