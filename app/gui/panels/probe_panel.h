// Place, influence and look of the selected probe in numbers: shows the document's values and turns entries into edits
// through the editor. How it is captured stands in capture_panel.h.
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/widgets/value_field.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;

namespace boxprobe {

class BlendRow;
class TechniqueChooser;
class TechniqueParametersPanel;
class VectorRow;
class Workspace;

class ProbePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ProbePanel(Workspace& workspace);

 private:
  using VectorEdit = std::function<void(Probe&, int axis, double value)>;

  void update();
  void buildPlace();
  void buildInfluence();
  void buildLook();
  void buildEdges(QFormLayout* form);
  void buildDiffuse();
  void connectVector(VectorRow* row, const QString& what, const VectorEdit& edit);
  void updateBoxBounds(VectorRow* min, VectorRow* max, const Box& box);
  void markDifferences();
  QString label(const QString& what) const;

  Editor& editor_;
  bool empty_ = false;  ///< no probe is selected
  VectorRow *origin_ = nullptr, *boxMin_ = nullptr, *boxMax_ = nullptr, *rotation_ = nullptr;
  QLabel *size_ = nullptr, *several_ = nullptr;
  QCheckBox* ownInfluence_ = nullptr;
  QWidget* influenceFields_ = nullptr;
  VectorRow *influenceMin_ = nullptr, *influenceMax_ = nullptr;
  BlendRow* blend_ = nullptr;
  ValueField *importance_ = nullptr, *intensity_ = nullptr;
  TechniqueChooser* technique_ = nullptr;
  QLabel* techniqueHelp_ = nullptr;
  TechniqueParametersPanel* parameters_ = nullptr;
  QCheckBox* projection_ = nullptr;
  ValueField *bevelRadius_ = nullptr, *bevelFromRoughness_ = nullptr;
  QCheckBox* occluded_ = nullptr;
  QWidget* occlusionFields_ = nullptr;
  ValueField *occlusionMultiplier_ = nullptr, *occlusionPower_ = nullptr, *occlusionStrength_ = nullptr;
  QComboBox* lattice_ = nullptr;
  QFormLayout* diffuse_ = nullptr;
  ValueField* latticeSpacing_ = nullptr;
};

}  // namespace boxprobe
