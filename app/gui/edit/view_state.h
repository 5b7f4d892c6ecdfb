// What the window knows of the scene beside the document: which objects are selected, what is hidden, isolated or
// locked, and whether the view is cut away. It belongs to the window, not to the scene's file, and no capture sees it.
// Everything goes by name. Called by the outliner, the menus and the picture; knows none of them.
#pragma once

#include <QObject>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

class ViewState : public QObject {
  Q_OBJECT

 public:
  using Names = std::set<std::string>;
  /// Probes by their name, objects by their node's.
  enum class Part { Probe, Object };

  explicit ViewState(QObject* parent = nullptr);

  /// The selected objects, in place of probes as what is hidden, isolated and framed. Empty: the probes are.
  const Names& objects() const { return objects_; }
  void selectObjects(const Names& nodes);

  /// By the eye, whatever is isolated.
  bool hidden(Part part, const std::string& name) const;
  /// Neither hidden nor left out by what is isolated.
  bool shown(Part part, const std::string& name) const;
  bool locked(Part part, const std::string& name) const;
  void setHidden(Part part, const Names& names, bool hidden);
  void setLocked(Part part, const Names& names, bool locked);
  /// Nothing else is shown, hidden or not, until endIsolation().
  void isolate(const Names& probes, const Names& objects);
  void endIsolation();
  bool isolated() const { return isolated_.has_value(); }
  /// Ends isolation and hides nothing; locks stay.
  void showAll();
  bool anyHidden() const;
  bool anyLocked() const { return !(locked_ == Marks{}); }

  /// What stands between the eye and the selected probe's box is cut away.
  bool cutaway() const { return cutaway_; }
  void setCutaway(bool on);

  /// Probes that were renamed keep what they are; names that are gone are forgotten. `nodes`: all objects'.
  void follow(const std::vector<Probe>& probes, const Names& nodes);
  /// Another scene: all but the cutaway.
  void forget();

 signals:
  void changed();

 private:
  struct Marks {
    Names probes, objects;
    Names& of(Part part) { return part == Part::Probe ? probes : objects; }
    const Names& of(Part part) const { return part == Part::Probe ? probes : objects; }
    bool operator==(const Marks& o) const { return probes == o.probes && objects == o.objects; }
  };
  void set(Names& names, const Names& which, bool on);
  std::vector<Names*> everything(Part part);

  Names objects_;
  Marks hidden_, locked_;
  std::optional<Marks> isolated_;
  bool cutaway_ = false;
  std::vector<std::string> probeNames_;  ///< at the last follow()
};

}  // namespace boxprobe
