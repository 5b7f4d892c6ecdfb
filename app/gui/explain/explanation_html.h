// The lines of an explained pixel, typeset: what the card shows. Rich text as QTextDocument understands it. Called by
// the explain card; the content comes from filters/explain/explanation_sections.h, in the
// window's language; nothing is said here that is not there.
#pragma once

#include <QColor>
#include <QString>
#include <glm/vec3.hpp>

#include "filters/core/base/phrase.h"
#include "filters/explain/explanation_sections.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

/// As the picture shows it: exposure, tone, then sRGB's curve.
QColor displayColor(const glm::vec3& linear, double exposure, Tone tone = Tone::None);

/// "t_x" as an italic letter with its subscript, "N.V" with a centred dot; a word in the window's language.
QString symbolHtml(const Phrase& symbol);
/// A formula within a line: symbols, subscripts, wide minus signs.
QString formulaHtml(const QString& text);

/// Notes first, in a box of their own.
QString explanationHtml(const Explanation& e, const ExplanationDetail& detail, double exposure, Tone tone = Tone::None);

}  // namespace boxprobe
