// The user's choices that outlive the window and belong to no scene.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <memory>
#include <optional>

namespace boxprobe {

/// All of them; see settings_file.h.
std::unique_ptr<QSettings> preferences();

/// Cheaper techniques while the camera or a handle moves; nothing until the user has chosen.
std::optional<bool> cheaperWhileMoving();
void keepCheaperWhileMoving(bool on);

/// Pictures that rest go on to the truth; on until the user has chosen.
bool refinesAtRest();
void keepRefinesAtRest(bool on);

/// What stands before the selected probe's box is cut away; off until the user has chosen.
bool cutsAway();
void keepCutaway(bool on);

/// The look of the window, as Theme counts; nothing until the user has chosen.
std::optional<int> chosenTheme();
void keepTheme(int theme);

/// Sections of the panels that the user has folded, by their titles.
bool sectionIsFolded(const QString& title);
void keepSectionFolded(const QString& title, bool folded);

/// Where the window stood and how its docks lay, as Qt saves them; empty until it was closed once.
struct WindowLayout {
  QByteArray geometry, docks;
};
WindowLayout windowLayout();
void keepWindowLayout(const QByteArray& geometry, const QByteArray& docks);

}  // namespace boxprobe
