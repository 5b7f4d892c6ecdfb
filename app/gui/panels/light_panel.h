// The scene's lights, one at a time: where it shines from, how strong, what shadows it throws and how soft they are;
// and the way the sky is turned. Fields preview while they are scrubbed and commit once.
#pragma once

#include <QWidget>
#include <optional>

#include "app/gui/edit/editor.h"

class QColor;
class QComboBox;
class QPushButton;
class QFormLayout;

namespace boxprobe {

class ValueField;
class VectorRow;
class Workspace;

class LightPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LightPanel(Workspace& workspace);

  /// Where the camera is, directional ones and spots the way it looks.
  void addLight(LightType type);
  void removeLight();
  /// The light on show goes where the camera is, and the way it looks.
  void aimByView();
  /// Display colours; the light's intensity stays.
  void setColor(const QColor& color);

  /// The fields show the light of that index.
  void choose(std::size_t index);

 private:
  using LightEdit = std::function<void(Light&)>;
  void update();
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
  void addButtons(QFormLayout* form);
  void addShadows(QFormLayout* form);

  Workspace& workspace_;
  Editor& editor_;
  QPushButton *remove_ = nullptr, *aim_ = nullptr, *color_ = nullptr;
  QFormLayout* form_ = nullptr;
  ValueField* turn_ = nullptr;
  QComboBox* skyView_ = nullptr;  ///< of a cube in the sky's picture; only shown for a picture
  QComboBox* skySun_ = nullptr;   ///< of the sky's picture; only shown for a picture
  QComboBox* lamps_ = nullptr;    ///< of the scene: how shining objects light diffuse surfaces
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
