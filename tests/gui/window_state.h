// What tests of values tell apart in a window: the entries of its menus, and how one state differs from the one before.
#pragma once

#include <QAction>
#include <QMenuBar>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace boxprobe {

/// Each with its path ("View > Camera > low"); no separators.
std::vector<std::pair<std::string, QAction*>> menuEntries(const QMenuBar& bar);

/// "grey hidden on", of which each word may be missing.
std::string stateOf(const QAction& action);

/// What is otherwise after than before, by name: its values, or that it is gone; else " nothing".
std::string differing(const std::map<std::string, std::string>& before,
                      const std::map<std::string, std::string>& after);

}  // namespace boxprobe
