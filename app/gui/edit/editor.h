// The way of the window's edits into the Document: previews of one control are committed before another control edits,
// so that nothing half done is lost or ends up under a wrong label; errors become one line for the status bar. Every
// view edits through here; it knows no view.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "app/gui/edit/edit_token.h"
#include "filters/core/scene/document.h"

namespace boxprobe {

class Editor : public QObject {
  Q_OBJECT

 public:
  using ProbeEdit = std::function<void(Probe&)>;

  explicit Editor(Document& document, QObject* parent = nullptr);

  const Document& document() const { return document_; }
  const Scene& scene() const { return document_.scene(); }
  /// The selected probe as shown now, or null.
  const Probe* probe() const;

  /// Shows `edit` without an undo step. The same token goes on with the preview under way; another one commits that
  /// first. `label` is what the undo step is called.
  void preview(const EditToken& token, const QString& label, const Document::Edit& edit);
  /// Ends the gesture of `token`, its previews included, as one step.
  void commit(const EditToken& token, const QString& label, const Document::Edit& edit);
  /// An edit that was not previewed.
  void commit(const QString& label, const Document::Edit& edit) { commit(EditToken(), label, edit); }
  /// The same for the selected probe, whose name becomes the token's target; nothing without one.
  void previewProbe(EditToken token, const QString& label, const ProbeEdit& edit);
  void commitProbe(EditToken token, const QString& label, const ProbeEdit& edit);
  void commitProbe(const QString& label, const ProbeEdit& edit) { commitProbe(EditToken(), label, edit); }
  /// Commits the preview under way, if any.
  void finish();
  void cancel();

  /// A probe that comes back is selected; where the selected one goes, its neighbour.
  void undo();
  void redo();
  /// Undoes or redoes until `position` steps stand.
  void goTo(std::size_t position);
  void selectProbe(std::optional<std::size_t> index);

 signals:
  /// An edit was committed, cancelled, undone or redone. The document does not tell its observers when what a preview
  /// shows becomes a step, for the scene stays as it is shown; the undo stack and the end of the preview are told here.
  void settled();
  void failed(const QString& line);

 private:
  template <typename Work>
  void guarded(const Work& work);
  template <typename Move>
  void step(const Move& move);
  bool goesOn(const EditToken& token) const;
  void forgetPending();

  Document& document_;
  EditToken pending_;     ///< of the preview under way
  QString pendingLabel_;  ///< what it was called last
};

}  // namespace boxprobe
