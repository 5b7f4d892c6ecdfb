// See technique_combo.h.
#include "app/gui/technique_combo.h"

#include <QSignalBlocker>

#include "filters/math/technique_table.h"

namespace boxprobe {

namespace {

QString text(std::string_view view) {
  return QString::fromUtf8(view.data(), static_cast<int>(view.size()));
}

constexpr int kHelpRole = Qt::UserRole + 1;

}  // namespace

TechniqueCombo::TechniqueCombo(QWidget* parent) : QuietCombo(parent) {
  const auto& projections = projectionRows();
  const auto& evaluations = evaluationRows();
  const auto standard = parseTechnique(projections.front().id).value_or(Technique{}).evaluation;
  for (std::size_t p = 0; p < projections.size(); ++p) {
    if (p > 0 && evaluations.size() > 1) insertSeparator(count());
    for (std::size_t e = 0; e < evaluations.size(); ++e) {
      const bool plain = static_cast<int>(e) == standard;
      QString label = text(projections[p].label);
      QString help = text(projections[p].help);
      if (!plain) {
        label += " + " + text(evaluations[e].label);
        help += " " + text(evaluations[e].help);
      }
      addItem(label, QString::fromStdString(shortTechniqueId({static_cast<int>(p), static_cast<int>(e)})));
      setItemData(count() - 1, help, kHelpRole);
      setItemData(count() - 1, help, Qt::ToolTipRole);
    }
  }
  setMaxVisibleItems(24);
  connect(this, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { emit chosen(itemData(index).toString().toStdString()); });
}

void TechniqueCombo::show(const std::string& techniqueId) {
  const auto technique = parseTechnique(techniqueId);
  const QSignalBlocker quiet(this);
  setCurrentIndex(technique ? findData(QString::fromStdString(shortTechniqueId(*technique))) : -1);
}

QString TechniqueCombo::help() const {
  return currentData(kHelpRole).toString();
}

}  // namespace boxprobe
