// File, Live link: the scene as it is edited, saved or not, in a .glb that scripts in other programs follow
// (data/engines). Written in a thread of its own a moment after each edit: boxes and lamps at once, maps as soon as
// they are captured.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"

class QWidget;

namespace boxprobe {

class SceneRenderer;
class Workspace;

class LiveLink : public QObject {
  Q_OBJECT

 public:
  LiveLink(Workspace& workspace, QWidget* window);

  /// True: asks for the file and starts. False: stops.
  void ask(bool on);
  /// Writes the file now and from then on; FILE.revision counts.
  void start(const QString& path);
  void stop();
  bool running() const { return !path_.isEmpty(); }
  /// How often the file has been written.
  int revision() const { return revision_; }

 signals:
  void message(const QString& text);
  void failed(const QString& text);

 private:
  using Maps = std::map<std::string, std::shared_ptr<const BakedMaps>>;
  /// An edit was made, taken back, or another scene opened: the file follows.
  void changed();
  /// Whether it runs, in the menu.
  void show(bool on);
  void write();
  void written(bool stopped, const QString& error);
  /// One turn of the event loop: a level filtered or a map read back, once captures are done.
  void readOne();

  Workspace& workspace_;
  const Document& document_;
  SceneRenderer& renderer_;
  QWidget* window_;
  QString path_;
  QTimer soon_, turn_;
  Maps maps_;             ///< by probe, as they are in the file or will be
  bool mapsNew_ = false;  ///< some are not written yet
  bool again_ = false;    ///< something changed while it was written
  int revision_ = 0;      ///< goes on from one link to the next: a script that follows must not see a number again
  int writtenHere_ = 0;   ///< since this link began
  QString writing_;       ///< the file that is being written, or was last: perhaps another link's
  QString told_;          ///< the last error
  BackgroundWork work_;
};

}  // namespace boxprobe
