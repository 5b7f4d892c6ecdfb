// See technique_chooser.h.
#include "app/gui/panels/technique_chooser.h"

#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include "app/gui/edit/probe_fields.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/table_words.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

constexpr int kHelpRole = Qt::UserRole + 1;

template <typename Rows>
QComboBox* comboOf(const Rows& rows, const QString& tip, QWidget* parent) {
  auto* combo = new QuietCombo(parent);
  combo->setToolTip(tip);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const QString help = tableWords(rows[i].help);
    combo->addItem(tableWords(rows[i].label), static_cast<int>(i));
    combo->setItemData(combo->count() - 1, help, kHelpRole);
    combo->setItemData(combo->count() - 1, help, Qt::ToolTipRole);
  }
  combo->setMaxVisibleItems(24);
  return combo;
}

/// Empty if the two do not combine.
std::string idOf(int projection, int evaluation) {
  const auto technique = parseTechnique(std::string(projectionRows()[static_cast<std::size_t>(projection)].id) + "+" +
                                        std::string(evaluationRows()[static_cast<std::size_t>(evaluation)].id));
  return technique ? shortTechniqueId(*technique) : std::string();
}

}  // namespace

std::string withProjection(const std::string& techniqueId, int projection) {
  const std::string id = idOf(projection, parseTechnique(techniqueId).value_or(Technique()).evaluation);
  if (!id.empty()) return id;
  return idOf(projection, parseTechnique(projectionRows().front().id).value_or(Technique()).evaluation);
}

std::string withEvaluation(const std::string& techniqueId, int evaluation) {
  const std::string id = idOf(parseTechnique(techniqueId).value_or(Technique()).projection, evaluation);
  if (!id.empty()) return id;
  const auto alone = parseTechnique(evaluationRows()[static_cast<std::size_t>(evaluation)].id);
  return alone ? shortTechniqueId(*alone) : techniqueId;
}

TechniqueChooser::TechniqueChooser(QWidget* parent) : QWidget(parent) {
  projection_ = comboOf(projectionRows(), tr("How the reflected ray is projected"), this);
  evaluation_ = comboOf(evaluationRows(), tr("How the lobe around the reflected ray is evaluated"), this);
  projection_->setObjectName("techniqueProjection");
  evaluation_->setObjectName("techniqueEvaluation");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(projection_);
  column->addWidget(evaluation_);
  connect(projection_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit projectionChosen(projection_->currentData().toInt()); });
  connect(evaluation_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit evaluationChosen(evaluation_->currentData().toInt()); });
}

void TechniqueChooser::enableWhatCombines() {
  auto* items = qobject_cast<QStandardItemModel*>(evaluation_->model());
  if (items == nullptr) return;
  for (int i = 0; i < evaluation_->count(); ++i) {
    items->item(i)->setEnabled(!idOf(projection_->currentData().toInt(), evaluation_->itemData(i).toInt()).empty());
  }
}

void TechniqueChooser::show(const std::string& techniqueId) {
  const auto technique = parseTechnique(techniqueId);
  const QSignalBlocker quietProjection(projection_), quietEvaluation(evaluation_);
  projection_->setCurrentIndex(technique ? projection_->findData(technique->projection) : -1);
  evaluation_->setCurrentIndex(technique ? evaluation_->findData(technique->evaluation) : -1);
  if (technique) enableWhatCombines();
}

void TechniqueChooser::showDiffers(bool projections, bool evaluations) {
  boxprobe::showDiffers(projection_, projections);
  boxprobe::showDiffers(evaluation_, evaluations);
}

QString TechniqueChooser::help() const {
  return projection_->currentData(kHelpRole).toString() + " " + evaluation_->currentData(kHelpRole).toString();
}

}  // namespace boxprobe
