// Probes through the clipboard, as the text of a scene file that holds nothing else: they can be pasted into another
// scene or a text editor, and back.
#pragma once

#include <QObject>
#include <QString>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class Editor;
class Workspace;

/// The probes of a scene file's text, of a list of probes or of one probe, as scene files hold them. Throws InputError
/// (one line, with line and column) for what is none.
std::vector<Probe> probesFromText(const std::string& text);

class ProbeClipboard : public QObject {
  Q_OBJECT

 public:
  ProbeClipboard(Workspace& workspace, QObject* parent);

 private:
  /// The selected probes.
  void copy();
  /// As one undo step; names that are taken get a number. What was pasted is selected.
  void paste();

  Workspace& workspace_;
  Editor& editor_;
};

}  // namespace boxprobe
