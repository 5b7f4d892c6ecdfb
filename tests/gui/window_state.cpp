// See window_state.h.
#include "tests/gui/window_state.h"

#include <QMenu>

namespace boxprobe {

namespace {

using Entries = std::vector<std::pair<std::string, QAction*>>;

void addEntries(const QList<QAction*>& actions, const std::string& path, Entries& entries) {
  for (QAction* action : actions) {
    if (action->isSeparator()) continue;
    const std::string own = path + action->text().remove('&').toStdString();
    entries.emplace_back(own, action);
    if (action->menu() != nullptr) addEntries(action->menu()->actions(), own + " > ", entries);
  }
}

}  // namespace

std::vector<std::pair<std::string, QAction*>> menuEntries(const QMenuBar& bar) {
  Entries entries;
  addEntries(bar.actions(), "", entries);
  return entries;
}

std::string stateOf(const QAction& action) {
  return std::string(action.isEnabled() ? "" : "grey ") + (action.isVisible() ? "" : "hidden ") +
         (action.isCheckable() ? action.isChecked() ? "on" : "off" : "");
}

std::string differing(const std::map<std::string, std::string>& before,
                      const std::map<std::string, std::string>& after) {
  std::string text;
  for (const auto& [name, value] : after) {
    const auto was = before.find(name);
    if (was == before.end()) {
      text += "; " + name + " is " + value;
    } else if (was->second != value) {
      text += "; " + name + " " + was->second + " -> " + value;
    }
  }
  for (const auto& [name, value] : before) {
    if (after.count(name) == 0) text += "; " + name + " is gone";
  }
  return text.empty() ? " nothing" : text.substr(1);
}

}  // namespace boxprobe
