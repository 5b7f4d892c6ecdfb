// The scene's lights, one at a time: where it shines from, how strong, what shadows it throws and how soft they are;
// and the way the sky is turned. Fields preview while they are scrubbed and commit once. Called by the main window.
#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/edit/editor.h"

class QComboBox;
class QFormLayout;

namespace boxprobe {

class ValueField;
class VectorRow;

class LightPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LightPanel(Editor& editor, QWidget* parent = nullptr);

  /// The document changed.
  void update();

 private:
  using LightEdit = std::function<void(Light&)>;
  std::optional<std::size_t> index() const;
  const Light* light() const;
  QString label(const QString& what) const;
  void commit(const QString& what, const LightEdit& change);
  /// Of a control that previews before it commits.
  void edit(const void* control, bool preview, const QString& what, const LightEdit& change);
  ValueField* addNumber(QFormLayout* form, const QString& text, const char* key, double step, int decimals,
                        double Light::*member);
  void showRow(QWidget* field, bool shown);
  void addSky(QFormLayout* form);
  void addPlace(QFormLayout* form);
  void addShadows(QFormLayout* form);

  Editor& editor_;
  QFormLayout* form_ = nullptr;
  ValueField* turn_ = nullptr;
  QComboBox* lights_ = nullptr;
  VectorRow* place_ = nullptr;  ///< a directional light's direction, any other's position
  ValueField* intensity_ = nullptr;
  QComboBox* shadows_ = nullptr;
  ValueField* angle_ = nullptr;
  ValueField* radius_ = nullptr;
  QComboBox* level_ = nullptr;
  ValueField* perUnit_ = nullptr;
};

}  // namespace boxprobe
