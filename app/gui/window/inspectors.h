// Three inspectors as tabs: of the selected probe, of an object with its material, and of the scene. Each is headed by
// the name of what its fields are of. Nothing turns to another page or scrolls but what a user asks for. Called by the
// docks of panels, which say what stands in each.
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <array>

class QLabel;
class QScrollArea;
class QTabWidget;

namespace boxprobe {

class Inspectors : public QWidget {
  Q_OBJECT

 public:
  enum class Page { Probe, Object, Scene };

  explicit Inspectors(QWidget* parent = nullptr);

  /// Called once for each page, panels from top to bottom.
  void setPanels(Page page, const QList<QWidget*>& panels);
  /// `about`: a line below the name.
  void setHeading(Page page, const QString& name, const QString& about);
  /// There is nothing to inspect: headings alone.
  void setEmpty(bool empty);

  void turnTo(Page page);
  /// Its page is turned to and scrolled to it.
  void reveal(QWidget* panel);
  /// After a search: to the first page that has a section left, unless this one does.
  void turnToFound();

 private:
  struct Sheet {
    QLabel *name = nullptr, *about = nullptr;
    QScrollArea* scroll = nullptr;
  };
  bool anythingLeft(const Sheet& sheet) const;

  QTabWidget* tabs_;
  std::array<Sheet, 3> sheets_;  ///< by Page
};

}  // namespace boxprobe
