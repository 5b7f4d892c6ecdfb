// The anisotropic part of VisibleNormalLobe: anisotropic GGX (Burley 2012; Heitz 2018 for sampling).
#include <algorithm>
#include <cmath>

#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846, kLeastAlpha = 1.0e-4, kLeastFacing = 1.0e-5;

}  // namespace

VisibleNormalLobe::VisibleNormalLobe(const glm::dvec3& normal, const glm::dvec3& across, const glm::dvec3& view,
                                     double alphaAlong, double alphaAcross)
    : VisibleNormalLobe(normal, view, std::max(alphaAcross, kLeastAlpha)) {
  alphaAlong_ = std::max(alphaAlong, kLeastAlpha);
  tangent_ = glm::cross(across, normal);
  bitangent_ = across;
  view_ = glm::normalize(
      glm::dvec3(glm::dot(tangent_, view), glm::dot(across, view), std::max(glm::dot(normal, view), kLeastFacing)));
  viewRoot_ = brushedRoot(view_);
}

double VisibleNormalLobe::brushedRoot(const glm::dvec3& d) const {
  return glm::length(glm::dvec3(alphaAlong_ * d.x, alpha_ * d.y, d.z));
}

VisibleNormalLobe::Sample VisibleNormalLobe::sampleBrushed(const glm::dvec2& u) const {
  const glm::dvec3 stretched = glm::normalize(glm::dvec3(alphaAlong_ * view_.x, alpha_ * view_.y, view_.z));
  const double flat = std::hypot(stretched.x, stretched.y);
  const glm::dvec3 first =
      flat > 1.0e-12 ? glm::dvec3(-stretched.y, stretched.x, 0.0) / flat : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 second = glm::cross(stretched, first);
  const double radius = std::sqrt(u.x), phi = 2.0 * kPi * u.y, t1 = radius * std::cos(phi);
  const double s = 0.5 * (1.0 + stretched.z);
  const double t2 = (1.0 - s) * std::sqrt(std::max(1.0 - t1 * t1, 0.0)) + s * radius * std::sin(phi);
  const glm::dvec3 n = t1 * first + t2 * second + std::sqrt(std::max(1.0 - t1 * t1 - t2 * t2, 0.0)) * stretched;
  const glm::dvec3 h = glm::normalize(glm::dvec3(alphaAlong_ * n.x, alpha_ * n.y, std::max(n.z, 0.0)));
  const double hDotV = std::clamp(glm::dot(h, view_), 0.0, 1.0);
  const glm::dvec3 l = 2.0 * hDotV * h - view_;
  if (!(l.z > 0.0)) return {normal_, 0.0, 0.0};
  const double weight = l.z * (view_.z + viewRoot_) / (l.z * viewRoot_ + view_.z * brushedRoot(l));
  return {l.x * tangent_ + l.y * bitangent_ + l.z * normal_, weight, hDotV};
}

VisibleNormalLobe::Density VisibleNormalLobe::brushedAt(const glm::dvec3& direction) const {
  const glm::dvec3 l(glm::dot(tangent_, direction), glm::dot(bitangent_, direction), glm::dot(normal_, direction));
  const glm::dvec3 sum = l + view_;
  const double length = glm::length(sum);
  if (!(l.z > 0.0) || length < 1.0e-12) return {};
  const glm::dvec3 h = sum / length;
  const double hDotV = std::min(glm::dot(h, view_), 1.0);
  if (!(hDotV > 0.0) || !(h.z > 0.0)) return {};
  const double x = h.x / alphaAlong_, y = h.y / alpha_, spread = x * x + y * y + h.z * h.z;
  const double distribution = 1.0 / (kPi * alphaAlong_ * alpha_ * spread * spread);
  const double masking = 2.0 * view_.z / (view_.z + viewRoot_);
  const double weight = l.z * (view_.z + viewRoot_) / (l.z * viewRoot_ + view_.z * brushedRoot(l));
  return {masking * distribution / (4.0 * view_.z), weight, hDotV};
}

}  // namespace boxprobe
