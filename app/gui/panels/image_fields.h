// The picture that a custom probe is filtered from: which file, how the surroundings lie in it, how its texels hold
// radiance. Rows of the capture panel, which says when they are shown; edits through the editor.
#pragma once

#include <QObject>

#include "app/gui/edit/editor.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QWidget;

namespace boxprobe {

class ValueField;

class ImageFields : public QObject {
  Q_OBJECT

 public:
  /// Adds its rows to `form`.
  ImageFields(Editor& editor, QFormLayout* form);

  /// The rows show the probe's; none is shown for a probe of another mode than custom.
  void update(const Probe& probe);
  /// Asks for a file and makes the selected probe a custom one of it. One that cannot be used is refused, with the
  /// reason in a box.
  void choose();

 signals:
  /// The dialog was closed: fields may show what was not taken.
  void answered();

 private:
  void addFile();
  void addLayout();
  void addCubeView();
  void addEncoding();
  void showRow(QWidget* field, bool shown);

  Editor& editor_;
  QFormLayout* form_;
  QWidget* row_ = nullptr;
  QLabel* name_ = nullptr;
  QComboBox *layout_ = nullptr, *view_ = nullptr, *encoding_ = nullptr;
  ValueField *turn_ = nullptr, *multiplier_ = nullptr, *exponent_ = nullptr;
};

}  // namespace boxprobe
