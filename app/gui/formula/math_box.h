// The boxes formulas are set from, as outlines in units of the base font's em with the baseline at y = 0 and y down, so
// that one layout serves a small screen, a projector and a printed sheet. Proportions follow TeX's (The TeXbook,
// appendix G). Called by mathml_layout; knows no MathML.
#pragma once

#include <QPainterPath>
#include <QString>
#include <optional>
#include <vector>

namespace boxprobe {

/// An outline with what its neighbours need to know of it. All lengths in base em.
struct MathBox {
  QPainterPath path;
  double width = 0.0, ascent = 0.0, descent = 0.0;
  double slant = 0.0;  ///< how far an italic letter leans out at the top: what a superscript must clear
};

enum class MathFont { Upright, Italic, Bold, BoldItalic };

MathBox mathText(const QString& text, MathFont font, double size);
MathBox mathSpace(double width);
/// Side by side on one baseline; `box` goes to the right end of `row`.
void appendBox(MathBox& row, const MathBox& box, double spaceBefore = 0.0);
/// `size` is the em of what surrounds the bar.
MathBox mathFraction(const MathBox& numerator, const MathBox& denominator, double size);
MathBox mathRoot(const MathBox& radicand, const std::optional<MathBox>& degree, double size);
/// At the base's right: either may be missing.
MathBox mathScripts(const MathBox& base, const std::optional<MathBox>& below, const std::optional<MathBox>& above,
                    double size);
/// Under and over the base, centred; as of limits, and of accents, which sit closer.
MathBox mathLimits(const MathBox& base, const std::optional<MathBox>& below, const std::optional<MathBox>& above,
                   double size, bool accent);
/// A fence or bar as tall as what it encloses, centred on the axis of fractions.
MathBox mathFence(const QString& text, double ascent, double descent, double size);
/// Rows of cells, columns aligned on the left, centred on the axis.
MathBox mathTable(const std::vector<std::vector<MathBox>>& rows, double size);

}  // namespace boxprobe
