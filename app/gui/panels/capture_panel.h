// How the selected probe is captured and filtered: mode, image, size, samples, bounces, depth range, background, hidden
// objects. Every field of the scene file that makes a capture.
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/edit/editor.h"
#include "filters/core/scene/model.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace boxprobe {

class HidesList;
class ImageFields;
class ValueField;
class VectorRow;
class Workspace;

class CapturePanel : public QWidget {
  Q_OBJECT

 public:
  explicit CapturePanel(Workspace& workspace);

 private:
  void update();
  void buildMode(QFormLayout* form);
  void buildSampling(QFormLayout* form);
  void buildView(QFormLayout* form);
  void chooseMode(int mode);
  void markDifferences();
  void showRow(QWidget* field, bool shown);

  Editor& editor_;
  bool empty_ = false;  ///< no probe is selected
  QFormLayout* form_ = nullptr;
  QLabel* black_ = nullptr;  ///< why mirrors are black with one bounce
  QComboBox *mode_ = nullptr, *faceSize_ = nullptr, *samples_ = nullptr, *bounces_ = nullptr, *filter_ = nullptr,
            *filterSamples_ = nullptr, *clear_ = nullptr;
  ImageFields* image_ = nullptr;
  ValueField *near_ = nullptr, *far_ = nullptr;
  VectorRow* clearColor_ = nullptr;
  HidesList* hides_ = nullptr;
};

}  // namespace boxprobe
