// Unsaved changes, kept on disk while they are made, for a process that ends without a word: a crash, a power cut, kill
// -9. Each process has a folder of its own under the user's data, with a lock that dies with it; a folder whose lock is
// free was left behind. Nothing stays once the changes are saved, taken back or given up.
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/document.h"

namespace boxprobe {

class Workspace;

class Autosave : public QObject {
  Q_OBJECT

 public:
  /// What a process that ended left behind.
  struct Kept {
    QString folder;              ///< of its files
    QString scene;               ///< a scene file, with paths relative to `folder`
    QString original;            ///< absolute: the file it was opened from or last saved to; empty: never saved
    std::string originalDigest;  ///< fileDigest() of that file as it was opened or saved; empty: not known
    QString name;                ///< as the window called it
    QString folderShown;         ///< of the original, or of the model of a scene never saved; may be empty
    QDateTime time;              ///< of the last change kept
  };

  Autosave(Workspace& workspace, QObject* parent);
  ~Autosave() override { end(); }
  /// The process ends as it should: what was kept goes, unless keep() was called; what stays is free for the next one.
  void end();

  /// The files follow the document at once. False: they could not be written.
  bool write();
  /// Saving failed while the process ends: the files stay.
  void keep() { stays_ = true; }

  /// Newest first. Folders of processes that live are left alone.
  static std::vector<Kept> leftBehind();
  static void discard(const Kept& kept);

 signals:
  /// Once, when the files cannot be written.
  void failed(const QString& line);

 private:
  /// An edit was made, taken back or saved: a moment later the files follow.
  void settled();
  void remove();

  const Workspace& workspace_;
  const Document& document_;
  QTimer soon_;
  QString folder_;                   ///< made with the first change
  std::unique_ptr<QLockFile> lock_;  ///< held while `folder_` is there
  Scene written_;                    ///< as it is in the folder
  bool stays_ = false;
  bool told_ = false;
};

}  // namespace boxprobe
