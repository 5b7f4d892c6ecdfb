// Which view is told of which kinds of change of the document, so that none is updated for what it does not show.
// Called by whoever puts views together; knows no view.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/document.h"

namespace boxprobe {

/// A mask: some of the kinds that Changes has.
class ChangeKinds {
 public:
  using Kind = bool Changes::*;
  ChangeKinds(std::initializer_list<Kind> kinds) : kinds_(kinds) {}
  static ChangeKinds all();
  bool anyIn(const Changes& changes) const;

 private:
  std::vector<Kind> kinds_;
  bool all_ = false;
};

/// The kinds that a view of the selected probe shows: its fields, its name, and which one it is.
ChangeKinds selectedProbeKinds();

class ChangeViews {
 public:
  using Update = std::function<void(const Changes&)>;

  explicit ChangeViews(Document& document) : document_(document) {}
  ~ChangeViews();
  ChangeViews(const ChangeViews&) = delete;
  ChangeViews& operator=(const ChangeViews&) = delete;

  /// `update` is called whenever one of `kinds` has changed; views are called in the order added. If one throws, the
  /// others are called all the same (see Document::addObserver).
  void add(std::string name, ChangeKinds kinds, Update update);
  /// Everything is new to the views: called once when all are there.
  void updateAll();
  /// How often the view of that name was updated. 0 for a name that is not there.
  std::size_t updates(const std::string& name) const;

 private:
  struct View {
    std::string name;
    ChangeKinds kinds;
    Update update;
    std::size_t updates = 0;
    std::size_t observer = 0;
    void tell(const Changes& changes);
  };

  Document& document_;
  std::vector<std::unique_ptr<View>> views_;  ///< their places are known to the document's observers
};

}  // namespace boxprobe
