// What is done with whole probes: add, duplicate, delete, rename, each as one undo step. Called by the menus and the
// outliner.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>

#include "app/gui/edit/editor.h"

namespace boxprobe {

class ProbeCommands : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<glm::dvec3()> cameraTargetWorld;  ///< where a new probe is captured
    std::function<Box()> sceneBounds;               ///< what its box is fitted to
  };

  ProbeCommands(Editor& editor, Hooks hooks, QObject* parent = nullptr);

  void addProbe();
  void duplicateProbe();
  void deleteProbe();
  /// A name that is empty or taken is refused in one line.
  void rename(std::size_t index, const QString& name);

 signals:
  /// By addProbe; it is selected.
  void added();

 private:
  Editor& editor_;
  Hooks hooks_;
};

}  // namespace boxprobe
