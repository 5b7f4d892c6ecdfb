// See contact_sheet.h.
#include "app/cli/report/contact_sheet.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

constexpr int kColumns = 5, kGap = 10, kTextHeight = 24, kFontSize = 15, kTitleHeight = 40;

using Rgb = std::array<std::uint8_t, 3>;

class Sheet {
 public:
  Sheet(int width, int height) {
    image_.width = width;
    image_.height = height;
    image_.pixels.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  }
  void set(int x, int y, const Rgb& color, double cover = 1.0) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    std::uint8_t* at = &image_.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                                           static_cast<std::size_t>(x))];
    for (std::size_t c = 0; c < 3; ++c)
      at[c] = static_cast<std::uint8_t>(std::lround(at[c] + cover * (color[c] - at[c])));
  }
  /// Its lower edge at `bottom`.
  void write(const std::string& text, int left, int bottom, int size, bool bold) {
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (renderer == nullptr) throw WorkError("this VTK cannot draw text: build it with the RenderingFreeType module");
    vtkNew<vtkTextProperty> font;
    font->SetFontFamilyToArial();
    font->SetFontSize(size);
    font->SetBold(bold ? 1 : 0);
    font->SetColor(0.1, 0.1, 0.12);
    vtkNew<vtkImageData> letters;
    int dimensions[2] = {0, 0};
    if (!renderer->RenderString(font, text, letters, dimensions, 72)) return;
    for (int y = 0; y < dimensions[1]; ++y) {
      for (int x = 0; x < dimensions[0]; ++x) {
        const auto* p = static_cast<const unsigned char*>(letters->GetScalarPointer(x, y, 0));
        if (p != nullptr) set(left + x, bottom - y, {p[0], p[1], p[2]}, p[3] / 255.0);
      }
    }
  }
  ImageRgba8 take() { return std::move(image_); }

 private:
  ImageRgba8 image_;
};

Rgb displayed(const float* linear, double exposure) {
  return displayBytes({linear[0], linear[1], linear[2]}, exposure);
}

/// Lightness rises all the way, as in the debug view.
Rgb mapped(vtkColorTransferFunction* colors, double fraction) {
  double rgb[3];
  colors->GetColor(std::clamp(fraction, 0.0, 1.0), rgb);
  Rgb result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<std::uint8_t>(std::lround(255.0 * rgb[c]));
  return result;
}

}  // namespace

ImageRgba8 contactSheet(const std::string& title, const ImageRgbaF& truth, const std::vector<ContactPicture>& pictures,
                        double exposure, double range) {
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLab();
  colors->AddRGBPoint(0.0, 0.03, 0.02, 0.10);
  colors->AddRGBPoint(0.3, 0.36, 0.09, 0.43);
  colors->AddRGBPoint(0.6, 0.85, 0.28, 0.33);
  colors->AddRGBPoint(0.85, 0.99, 0.67, 0.27);
  colors->AddRGBPoint(1.0, 0.99, 0.98, 0.75);
  // Labels want room: small pictures are shown in whole multiples of their pixels.
  constexpr int kLeastWidth = 300;
  const int zoom = (kLeastWidth + truth.width - 1) / truth.width;
  const int w = zoom * truth.width, h = zoom * truth.height;
  const auto pixelOf = [&](int x, int y) { return static_cast<std::size_t>(y / zoom * truth.width + x / zoom); };
  const int cellWidth = w + kGap, cellHeight = kTextHeight + 2 * h + 2 + kGap;
  const int cells = static_cast<int>(pictures.size()) + 1, rows = (cells + kColumns - 1) / kColumns;
  Sheet sheet(kColumns * cellWidth + kGap, kTitleHeight + rows * cellHeight + kGap);
  sheet.write(title, kGap, kTitleHeight - 12, kFontSize + 4, true);
  const auto drawPicture = [&](const ImageRgbaF& picture, int left, int top) {
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        sheet.set(left + x, top + y, displayed(&picture.pixels[4 * pixelOf(x, y)], exposure));
      }
    }
  };
  for (int cell = 0; cell < cells; ++cell) {
    const int left = kGap + cell % kColumns * cellWidth, top = kTitleHeight + cell / kColumns * cellHeight;
    const int under = top + kTextHeight + h + 2;
    if (cell == 0) {
      sheet.write("reference: integral over the box", left, top + kTextHeight - 6, kFontSize, true);
      drawPicture(truth, left, top + kTextHeight);
      const int bar = std::min(w - 20, 260);
      for (int x = 0; x < bar; ++x) {
        const Rgb color = mapped(colors, x / (bar - 1.0));
        for (int y = 0; y < 16; ++y) sheet.set(left + x, under + 30 + y, color);
      }
      sheet.write("0", left, under + 66, kFontSize, false);
      sheet.write(numberText(range) + " and more", left + bar - 70, under + 66, kFontSize, false);
      sheet.write("error, tone-mapped; grey: not measured", left, under + 22, kFontSize, false);
      continue;
    }
    const ContactPicture& picture = pictures[static_cast<std::size_t>(cell) - 1];
    sheet.write(picture.label, left, top + kTextHeight - 6, kFontSize, false);
    drawPicture(picture.picture, left, top + kTextHeight);
    for (int y = 0; y < h; ++y) {
      for (int x = 0; x < w; ++x) {
        const float error = picture.error[pixelOf(x, y)];
        sheet.set(left + x, under + y, error < 0.0f ? Rgb{205, 205, 208} : mapped(colors, error / range));
      }
    }
  }
  return sheet.take();
}

}  // namespace boxprobe
