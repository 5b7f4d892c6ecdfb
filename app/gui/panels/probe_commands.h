// What is done with whole probes: add, duplicate, delete, rename, each as one undo step.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>

namespace boxprobe {

class Editor;
class Workspace;

class ProbeCommands : public QObject {
  Q_OBJECT

 public:
  ProbeCommands(Workspace& workspace, QObject* parent);

  void addProbe();
  void duplicateProbe();
  void deleteProbe();
  /// A name that is empty or taken is refused in one line.
  void rename(std::size_t index, const QString& name);

 signals:
  /// By addProbe; it is selected.
  void added();

 private:
  Workspace& workspace_;
  Editor& editor_;
};

}  // namespace boxprobe
