// The one place where a scene is edited. Holds the scene, the selection and the undo stack; views observe it and never
// call each other. No Qt, no VTK. A drag is preview... then commit (one undo step) or cancel.
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

  const Scene& scene() const;  ///< as shown now, an unfinished preview included; valid until the next change
  std::optional<std::size_t> selectedProbe() const;  ///< always a valid index into scene().probes, or nothing
  void selectProbe(std::optional<std::size_t> index);

  /// A scene with its history: everything here but the observers. Taken, to show another scene for a while, and put
  /// back as it was. Cheap to copy: scenes are shared.
  class State {
   public:
    /// Of a scene as it is right after it was opened. Throws InputError if it is not valid.
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

    std::shared_ptr<const Scene> committed_;  ///< what the undo stack stands at
    std::shared_ptr<const Scene> saved_;      ///< as last opened or saved; null: never as it is
    std::vector<Step> steps_;                 ///< undo stack; steps_[position_ - 1] is what undo takes back
    std::size_t position_ = 0;
    /// Kept while its probe is gone, so that undo of a delete selects it again.
    std::optional<std::string> selectedName_;
    std::string path_;
  };
  /// Without a preview under way.
  const State& state() const { return state_; }
  /// Observers are told what differs, and `also`.
  void restore(State state, const Changes& also = {});

  /// Replaces everything (a file was opened); the undo stack starts again and the document counts as saved, unless it
  /// is `unsaved`: what was recovered is not what `path` holds. Throws InputError, and leaves everything as it was, if
  /// the scene is not valid.
  void open(Scene scene, std::string path, bool unsaved = false);

  /// Shows the scene as it would be: `edit` is applied to the last committed scene, so that previews do not pile up.
  /// Where the result is not valid (a half-typed value) what is shown stays, and false is returned: never throws for
  /// it.
  bool preview(const Edit& edit);
  /// Applies `edit` to the last committed scene and records one undo step, unless nothing changed. Ends a preview.
  /// Throws InputError, and leaves the last committed scene shown, if the result is not valid.
  void commit(const std::string& label, const Edit& edit);
  /// Commits what the last preview shows. Does nothing without a preview.
  void commitPreview(const std::string& label);
  void cancel();  ///< back to the last committed scene
  bool previewing() const;

  bool canUndo() const;
  bool canRedo() const;
  std::string undoLabel() const;
  std::string redoLabel() const;
  void undo();  ///< also ends a preview
  void redo();
  /// What was done, oldest first; the first position() of them stand, undo takes those back, redo the others forward.
  std::vector<std::string> stepLabels() const;
  std::size_t position() const;
  /// Undoes or redoes until that many steps stand; at most all.
  void goTo(std::size_t position);

  const std::string& path() const;  ///< empty: never saved
  bool modified() const;            ///< differs from what was last opened or saved
  void markSaved(std::string path);

  /// Observers are called in the order added, after the state is consistent; they may edit, add and remove. If one
  /// throws the others are called all the same, then the first exception goes on to the caller. Returns an id for
  /// removeObserver.
  std::size_t addObserver(Observer observer);
  void removeObserver(std::size_t id);

 private:
  using Snapshot = std::shared_ptr<const Scene>;
  void record(const std::string& label, const Snapshot& scene);
  void move(Snapshot committed, Snapshot shown, std::size_t position, Changes changes);
  void notify(const Changes& changes);

  State state_;
  Snapshot shown_;  ///< state_.committed_, or a preview of what may come next
  std::vector<std::pair<std::size_t, Observer>> observers_;
  std::size_t nextObserver_ = 1;
};

}  // namespace boxprobe
