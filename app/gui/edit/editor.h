// The way of the window's edits into the Document: previews of one control are committed before another control edits,
// so that nothing half done is lost or ends up under a wrong label; errors become one line for the status bar. Every
// view edits through here; it knows no view.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

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
  /// The selected probe as shown now, or null. Of several: the one whose handles and fields are shown.
  const Probe* probe() const;
  /// The places of all selected probes, ascending; the one above is among them. Empty without one.
  std::vector<std::size_t> selected() const;
  /// "room", or "3 probes".
  QString selectedName() const;

  /// Shows `edit` without an undo step. The same token goes on with the preview under way; another one commits that
  /// first. `label` is what the undo step is called.
  void preview(const EditToken& token, const QString& label, const Document::Edit& edit);
  /// Ends the gesture of `token`, its previews included, as one step.
  void commit(const EditToken& token, const QString& label, const Document::Edit& edit);
  /// An edit that was not previewed.
  void commit(const QString& label, const Document::Edit& edit) { commit(EditToken(), label, edit); }
  /// The same for every selected probe, as one step; the name of probe() becomes the token's target. Nothing without
  /// one.
  void previewProbe(EditToken token, const QString& label, const ProbeEdit& edit);
  void commitProbe(EditToken token, const QString& label, const ProbeEdit& edit);
  void commitProbe(const QString& label, const ProbeEdit& edit) { commitProbe(EditToken(), label, edit); }
  /// Of probe() alone, whatever else is selected.
  void commitOne(const QString& label, const ProbeEdit& edit);
  /// Is the preview under way that of `token`?
  bool previews(const EditToken& token) const { return goesOn(token); }
  /// Commits the preview under way, if any.
  void finish();
  void cancel();

  /// Probes that come back are selected; where the selected one goes, its neighbour.
  void undo();
  void redo();
  /// Undoes or redoes until `position` steps stand.
  void goTo(std::size_t position);
  void selectProbe(std::optional<std::size_t> index);
  /// Several; `shown` is the one whose handles and fields are shown, the last where it is not among them.
  void selectProbes(const std::vector<std::size_t>& indices, std::optional<std::size_t> shown = {});
  /// Only the one that the document has selected: another scene is shown, whose names mean others.
  void selectAlone() { together_.clear(); }
  /// Adds a probe to those selected, or takes it out unless it is the only one.
  void toggleProbe(std::size_t index);

 signals:
  /// Other probes are selected, or others beside the one that the document has selected.
  void selectionChanged();
  /// Probes were asked to be selected, whether or not they were before.
  void probesAsked();
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
  Document::Edit onSelected(const ProbeEdit& edit) const;
  bool followRenames(const std::vector<std::string>& before);
  void selectWhatCameBack(const std::vector<std::string>& names);

  Document& document_;
  std::set<std::string> together_;  ///< names; count only while the document's selected probe is among them
  EditToken pending_;               ///< of the preview under way
  QString pendingLabel_;            ///< what it was called last
};

}  // namespace boxprobe
