// File, Export probes: what the window's probes show, written for an engine. They are filtered and read back a level
// and a probe per turn of the event loop, and written by another thread, so that the window stays usable.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "filters/io/engines/probe_export.h"

class QWidget;

namespace boxprobe {

class Document;
class SceneRenderer;
class Workspace;

class ProbeExporter : public QObject {
  Q_OBJECT

 public:
  ProbeExporter(Workspace& workspace, QWidget* window);
  /// Stops after the probe at work.
  ~ProbeExporter() override;

  /// Asks for the engine and a folder, then exports.
  void ask();
  /// Probes without a finished capture are left out and named.
  void start(const ExportSettings& settings, const QString& folder);
  bool running() const { return running_; }

 signals:
  void message(const QString& text);
  void failed(const QString& text);

 private:
  /// One turn of the event loop: filters a level that a file holds and nothing has sampled, or reads a probe back.
  void readOne();
  void readNext();
  void write();
  void end(const QString& text, bool good);

  Workspace& workspace_;
  const Document& document_;
  SceneRenderer& renderer_;
  QWidget* window_;
  QTimer turn_;
  ExportSettings settings_;
  QString folder_;
  std::vector<std::string> waiting_;                      ///< probes' names; the last is next
  std::pair<std::string, std::vector<ModelFile>> scene_;  ///< whose probes they are: its file and its models
  std::vector<ProbeCapture> captures_;
  QStringList unfinished_;
  std::thread thread_;
  std::atomic<bool> stop_{false};
  bool running_ = false;
};

}  // namespace boxprobe
