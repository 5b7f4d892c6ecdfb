#include "filters/vtk/charts/vtkParetoLabels.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>
#include <vtkVector.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkParetoLabels);

namespace {

/// Pixels, y upwards.
struct Rectangle {
  double left, low, width, height;

  double overlapArea(const Rectangle& o) const {
    const double w = std::min(left + width, o.left + o.width) - std::max(left, o.left);
    const double h = std::min(low + height, o.low + o.height) - std::max(low, o.low);
    return w > 0.0 && h > 0.0 ? w * h : 0.0;
  }
};

/// The point of a label's rectangle that its leader line ends at.
vtkVector2d nearestOn(const Rectangle& place, double x, double y) {
  return {std::clamp(x, place.left, place.left + place.width), std::clamp(y, place.low, place.low + place.height)};
}

/// Small squares along a leader line, to keep labels off the lines. Leaves out the ends, where the mark and the label
/// are.
std::vector<Rectangle> alongLine(double x, double y, const vtkVector2d& end) {
  constexpr double kSide = 3.0;
  std::vector<Rectangle> squares;
  const int count = static_cast<int>(std::hypot(end.GetX() - x, end.GetY() - y) / kSide);
  for (int k = 4; k < count; ++k) {
    const double share = static_cast<double>(k) / count;
    squares.push_back(
        {x + share * (end.GetX() - x) - 0.5 * kSide, y + share * (end.GetY() - y) - 0.5 * kSide, kSide, kSide});
  }
  return squares;
}

double along(vtkAxis* axis, int component, double value) {
  const double range = axis->GetMaximum() - axis->GetMinimum();
  const double fraction = range != 0.0 ? (value - axis->GetMinimum()) / range : 0.0;
  return axis->GetPoint1()[component] +
         fraction * static_cast<double>(axis->GetPoint2()[component] - axis->GetPoint1()[component]);
}

}  // namespace

void vtkParetoLabels::SetChart(vtkChartXY* chart) {
  this->Chart = chart;
}

void vtkParetoLabels::SetLabels(std::vector<Label> labels) {
  this->Labels = std::move(labels);
  std::stable_sort(this->Labels.begin(), this->Labels.end(),
                   [](const Label& a, const Label& b) { return a.Important && !b.Important; });
}

bool vtkParetoLabels::Paint(vtkContext2D* painter) {
  if (!this->Chart) return true;
  vtkAxis* bottom = this->Chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = this->Chart->GetAxis(vtkAxis::LEFT);
  const Rectangle area{bottom->GetPoint1()[0], left->GetPoint1()[1],
                       static_cast<double>(bottom->GetPoint2()[0] - bottom->GetPoint1()[0]),
                       static_cast<double>(left->GetPoint2()[1] - left->GetPoint1()[1])};
  constexpr double kMark = 7.0;  // half the width of a point's mark, with a margin
  std::vector<Rectangle> taken;
  for (const Label& label : this->Labels) {
    const double x = along(bottom, 0, label.X), y = along(left, 1, label.Y);
    const double half = label.Text.empty() ? 2.0 : kMark;
    taken.push_back({x - half, y - half, 2.0 * half, 2.0 * half});
  }
  vtkTextProperty* font = painter->GetTextProp();
  font->SetFontFamilyToArial();
  font->SetFontSize(13);
  font->SetColor(0.1, 0.1, 0.12);
  font->SetJustificationToLeft();
  font->SetVerticalJustificationToBottom();
  for (const Label& label : this->Labels) {
    if (label.Text.empty()) continue;
    const double x = along(bottom, 0, label.X), y = along(left, 1, label.Y);
    font->SetBold(label.Important ? 1 : 0);
    float bounds[4];
    painter->ComputeStringBounds(label.Text, bounds);
    const double width = bounds[2] + 4.0, height = std::max(static_cast<double>(bounds[3]), 12.0) + 3.0;
    // Rings of candidate positions, nearer ones first; on each ring the right side first.
    Rectangle best{x + kMark, y - 0.5 * height, width, height};
    double least = 1e300;
    for (int ring = 0; ring < 9 && least > 0.0; ++ring) {
      const double reach = kMark + 1.0 + 13.0 * ring;
      const int places = 8 + 4 * ring;
      for (int k = 0; k < places && least > 0.0; ++k) {
        const double turn = (k % 2 == 0 ? 1.0 : -1.0) * ((k + 1) / 2) * 2.0 * M_PI / places;
        const double c = std::cos(turn), s = std::sin(turn);
        const Rectangle place{x + reach * c + (c >= -0.3 ? (c > 0.3 ? 0.0 : -0.5 * width) : -width),
                              y + reach * s + (s >= -0.3 ? (s > 0.3 ? 0.0 : -0.5 * height) : -height), width, height};
        const bool within = place.left >= area.left && place.low >= area.low &&
                            place.left + width <= area.left + area.width &&
                            place.low + height <= area.low + area.height;
        double covered = within ? 0.0 : 1e6;
        for (const Rectangle& other : taken) covered += place.overlapArea(other);
        if (covered < least) {
          for (const Rectangle& square : alongLine(x, y, nearestOn(place, x, y))) {
            for (const Rectangle& other : taken) covered += 4.0 * square.overlapArea(other);
          }
        }
        if (covered < least) {
          least = covered;
          best = place;
        }
      }
    }
    taken.push_back(best);
    const vtkVector2d near = nearestOn(best, x, y);
    const double nearX = near.GetX(), nearY = near.GetY();
    if (std::hypot(nearX - x, nearY - y) > kMark + 8.0) {
      for (const Rectangle& square : alongLine(x, y, near)) taken.push_back(square);
      painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
      painter->GetPen()->SetColor(150, 150, 155, 255);
      painter->GetPen()->SetWidth(1.0f);
      painter->DrawLine(static_cast<float>(x), static_cast<float>(y), static_cast<float>(nearX),
                        static_cast<float>(nearY));
    }
    painter->DrawString(static_cast<float>(best.left + 2.0), static_cast<float>(best.low + 1.0), label.Text);
  }
  return true;
}
