// Icons of the tool bar, drawn by lines: sharp at any scale, readable in light and dark windows. Called by the
// menus.
#pragma once

#include <QIcon>

namespace boxprobe {

enum class ToolIcon { Box, Influence, Origin, Place };

QIcon toolIcon(ToolIcon icon);

}  // namespace boxprobe
