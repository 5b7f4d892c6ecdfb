// The one place where a scene is edited: the scene, the selection and the undo stack. Views observe it and never call
// each other. A drag is preview..., then commit (one undo step) or cancel.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/changes.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

class Document {
 public:
  using Edit = std::function<void(Scene&)>;
  using Observer = std::function<void(const Changes&)>;

  Document();

  const Scene& scene() const;  ///< as shown now, with an unfinished preview; valid until the next change
  std::optional<std::size_t> selectedProbe() const;  ///< always a valid index into scene().probes, or nothing
  void selectProbe(std::optional<std::size_t> index);

  /// A scene with its history: everything here except the observers. To show another scene for a while, keep a copy and
  /// restore it afterwards. Cheap to copy, because scenes are shared.
  class State {
   public:
    /// The state of a scene that was just opened. Throws InputError if the scene is not valid.
    static State opened(Scene scene, std::string path, std::optional<std::string> selectedProbe = {});
    const Scene& scene() const { return *committed_; }
    const std::string& path() const { return path_; }

   private:
    friend class Document;
    struct Step {
      std::string label;
      std::shared_ptr<const Scene> before, after;
    };
    State();

    std::shared_ptr<const Scene> committed_;  ///< the scene at the current position of the undo stack
    std::shared_ptr<const Scene> saved_;      ///< as last opened or saved; null: never saved in this form
    std::vector<Step> steps_;                 ///< undo stack; undo reverts steps_[position_ - 1]
    std::size_t position_ = 0;
    /// Kept while its probe is deleted, so that undo selects it again.
    std::optional<std::string> selectedName_;
    std::string path_;
  };
  /// Without a preview in progress.
  const State& state() const { return state_; }
  /// Observers are notified of what differs, and of `also`.
  void restore(State state, const Changes& also = {});

  /// Replaces everything (a file was opened). The undo stack is cleared, and the document counts as saved unless it is
  /// `unsaved`, as a recovered scene is. Throws InputError, and leaves everything as it was, if the scene is not valid.
  void open(Scene scene, std::string path, bool unsaved = false);

  /// Shows the scene with `edit` applied to the last committed scene, so that previews do not accumulate. If the result
  /// is not valid (a half-typed value) the shown scene stays and false is returned; never throws for that.
  bool preview(const Edit& edit);
  /// Applies `edit` to the last committed scene and records one undo step, unless nothing changed. Ends a preview.
  /// Throws InputError, and shows the last committed scene, if the result is not valid.
  void commit(const std::string& label, const Edit& edit);
  /// Commits what the last preview shows; does nothing without a preview.
  void commitPreview(const std::string& label);
  void cancel();  ///< back to the last committed scene
  bool previewing() const;

  bool canUndo() const;
  bool canRedo() const;
  std::string undoLabel() const;
  std::string redoLabel() const;
  void undo();  ///< also ends a preview
  void redo();
  /// Labels of all steps, oldest first. The first position() of them are applied.
  std::vector<std::string> stepLabels() const;
  std::size_t position() const;
  /// Undoes or redoes until that many steps are applied; at most all.
  void goTo(std::size_t position);

  const std::string& path() const;  ///< empty: never saved
  bool modified() const;            ///< differs from what was last opened or saved
  void markSaved(std::string path);

  /// Observers are called in the order added, when the state is consistent; they may edit, add and remove. If one
  /// throws, the others are still called, then the first exception is rethrown. Returns an id for removeObserver.
  std::size_t addObserver(Observer observer);
  void removeObserver(std::size_t id);

 private:
  using Snapshot = std::shared_ptr<const Scene>;
  void record(const std::string& label, const Snapshot& scene);
  void move(Snapshot committed, Snapshot shown, std::size_t position, Changes changes);
  void notify(const Changes& changes);

  State state_;
  Snapshot shown_;  ///< state_.committed_, or a preview
  std::vector<std::pair<std::size_t, Observer>> observers_;
  std::size_t nextObserver_ = 1;
};

}  // namespace boxprobe
