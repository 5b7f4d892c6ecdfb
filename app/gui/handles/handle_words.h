// What the window says of a handle: what it does, and what its drag is called.
#pragma once

#include <QString>

#include "filters/core/scene/scene.h"
#include "filters/vtk/widgets/handle.h"

namespace boxprobe {

/// In the user's language.
QString handleWords(const char* text);
/// For the status bar; `selected`: it belongs to the selected probe.
QString handleHint(const Handle& handle, const Probe& probe, bool selected);
/// "Move face +X of room": the undo step; `name` is the probe's, or "3 probes".
QString handleEditLabel(const Handle& handle, const QString& name);

}  // namespace boxprobe
