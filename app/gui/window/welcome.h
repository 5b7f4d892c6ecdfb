// In the place of the picture while no scene is open: what was open lately, the scenes that come with the program, the
// lessons. Thumbnails are read one at a time while nothing else is to do. Called by the main window; opens nothing
// itself.
#pragma once

#include <QList>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace boxprobe {

class FlowLayout;
class SceneCard;

class Welcome : public QWidget {
  Q_OBJECT

 public:
  /// Covers `picture`. `scenes`: folder of the scenes that come with the program.
  Welcome(QWidget* picture, const QString& scenes);

  /// Newest first.
  void setRecent(const QStringList& paths);

 signals:
  void openRequested();
  void modelRequested();
  void lessonsRequested();
  void chosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buttons();
  void addExamples(const QString& folder);
  void add(FlowLayout* to, const QString& title, const QString& words, const QString& path, const QString& thumbnail);
  void readNext();

  QLabel *recentTitle_ = nullptr, *examplesTitle_ = nullptr;
  FlowLayout *recent_ = nullptr, *examples_ = nullptr;
  struct Waiting {
    QPointer<SceneCard> card;
    QString thumbnail;
  };
  QList<Waiting> waiting_;
  QTimer reading_;
};

}  // namespace boxprobe
