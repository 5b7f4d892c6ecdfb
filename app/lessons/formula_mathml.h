// A lesson's formulas as MathML, which browsers and the window's text engine typeset. Called by the page, the sheets
// and the lesson panel; knows neither.
#pragma once

#include <string>

namespace boxprobe {

/// One formula, without the enclosing <math> element. The markup is the part of TeX that the lessons need: letters are
/// variables, words in \text{..} upright, _ and ^ take a letter, a number, a command or a group in braces,
/// \frac{a}{b}, \sqrt{a}, \min_{..} with what is under it, \cdot, \times, \le, \ge, \approx, \ne and Greek letters.
/// Total: what it does not know is shown as it stands.
std::string formulaMathml(const std::string& markup);

}  // namespace boxprobe
