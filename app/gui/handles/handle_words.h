// What the window says of a handle: what it does, what its drag is called, the numbers beside the pointer. Called by
// the probe widget.
#pragma once

#include <QString>

#include "app/gui/handles/drag_snap.h"
#include "app/gui/handles/handle.h"

namespace boxprobe {

/// For the status bar; `selected`: it belongs to the selected probe.
QString handleHint(const Handle& handle, const Probe& probe, bool selected);
/// "Move face +X of room": the undo step; `name` is the probe's, or "3 probes".
QString handleEditLabel(const Handle& handle, const QString& name);
/// Of a drag that has made `now` of `before`.
QString handleReadout(const Handle& handle, const Probe& before, const Probe& now);
/// "on the wall", "grid 0.1 m"
QString snapWords(const DragSnap& snap, const Handle& handle);

}  // namespace boxprobe
