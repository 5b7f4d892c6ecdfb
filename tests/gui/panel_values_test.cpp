// What each control of the panels shows and does to the scene, control by control, against panel_values.txt.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/gui/widgets/value_field.h"
#include "filters/io/scene/scene_file.h"
#include "tests/gui/window_test.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

class PanelValuesTest : public WindowTest {
 protected:
  // Every field of a light, a probe and a material is another number, none is a default.
  LoadedScene scene() const override {
    return smallBuilding(
        {"probes.room.origin=[0.1,1.7,-0.4]", "probes.room.rotationDegrees=[3,17,-5]",
         "probes.room.blendDistance={\"min\":[0.11,0.22,0.33],\"max\":[0.44,0.55,0.66]}", "probes.room.bevel=0.23",
         "probes.room.lattice={\"spacing\":0.72}",
         "probes.room.occlusion={\"multiplier\":0.6,\"power\":0.7,\"strength\":0.8}", "probes.room.importance=1.5",
         "probes.room.intensity=0.9", "probes.room.near=0.02", "probes.room.far=77",
         "probes.room.technique=\"impostor+hdrp\"", "sky.rotationDegrees=12",
         "lights.0={\"type\":\"spot\",\"position\":[1.1,4.2,2.3],\"direction\":[-0.3,-0.8,-0.2],\"intensity\":7,"
         "\"innerConeDegrees\":11,\"outerConeDegrees\":34,\"range\":19,\"radius\":0.07,\"shadows\":\"coverage\","
         "\"shadowLevel\":\"distance\",\"levelsPerUnit\":0.4}",
         "materials.mirror={\"roughness\":0.13,\"coat\":0.4,\"metallic\":0.83,\"transmission\":0.6,\"ior\":1.37,"
         "\"thickness\":0.21,\"attenuationDistance\":0.9}",
         "objects.mirror.translation=[0.01,0.02,0.03]", "objects.mirror.rotationDegrees=[1,2,3]"});
  }

  /// "path: before -> after" of every value of the scene that differs.
  static std::string differing(const Json& before, const Json& after) {
    const Json a = before.flatten(), b = after.flatten();
    std::string text;
    for (const auto& [path, value] : b.items()) {
      if (!a.contains(path)) {
        text += " " + path + "=" + value.dump();
      } else if (a[path] != value) {
        text += " " + path + "=" + a[path].dump() + "->" + value.dump();
      }
    }
    for (const auto& [path, value] : a.items()) {
      if (!b.contains(path)) text += " " + path + "=" + value.dump() + "->";
    }
    return text.empty() ? " nothing" : text;
  }

  Json sceneNow() { return Json::parse(sceneText(document().scene(), std::string(BOXPROBE_DATA_DIR) + "/scenes")); }

  /// Its name, or that of what it is part of and its place there.
  static std::string nameOf(const QWidget* widget) {
    for (const QWidget* each = widget; each != nullptr; each = each->parentWidget()) {
      const QString name = each->objectName();
      if (name.isEmpty() || name.startsWith("qt_")) continue;
      const auto fields = each->findChildren<ValueField*>();
      const auto at = std::find(fields.begin(), fields.end(), widget);
      const bool part = each != widget && at != fields.end();
      return name.toStdString() + (part ? " " + std::to_string(at - fields.begin()) : "");
    }
    return "?";
  }

  void undoAll() {
    while (document().canUndo()) document().undo();
  }

  /// What is said of the probe, once its error has been measured.
  void readLabels(std::vector<std::string>& lines) {
    const auto* mean = window_->findChild<QLabel*>("gaugeMean");
    EXPECT_TRUE(waitFor([&] { return mean->text().contains(QChar(0xb0)); }));
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      const std::string name = label->objectName().toStdString();
      const bool named = name.rfind("gauge", 0) == 0 || name == "bakeState" || name == "blackMirrors";
      if (named || label->text().contains(QChar(0xd7))) {
        lines.push_back("label " + nameOf(label) + " '" + label->text().toStdString() + "'");
      }
    }
  }

  void tryFields(std::vector<std::string>& lines) {
    int number = 0;
    for (ValueField* field : window_->findChildren<ValueField*>()) {
      const std::string name = nameOf(field), shown = field->text().toStdString();
      const Json before = sceneNow();
      const double was = field->value();
      const double wish = field->value() + 0.17 + 0.01 * ++number;
      const double value = field->maximum() - field->minimum() > 3.0 && wish <= field->maximum()
                               ? wish
                               : field->minimum() + 0.37 * (std::min(field->maximum(), 50.0) - field->minimum());
      field->scrubTo(value);
      field->endScrub();
      lines.push_back("field " + name + " '" + shown + "' to '" + field->text().toStdString() +
                      "':" + differing(before, sceneNow()));
      if (document().canUndo()) {
        lines.back() += " (" + document().undoLabel() + ")";
      } else {
        field->scrubTo(was);  // it stands for something else than the scene, and the window goes on
        field->endScrub();
      }
      undoAll();
      lines.back() += field->text().toStdString() == shown ? "" : " and back to '" + field->text().toStdString() + "'";
    }
  }

  void tryChoices(std::vector<std::string>& lines) {
    for (const char* name : {"techniqueProjection", "techniqueEvaluation", "mode", "faceSize", "samplesPerPixel",
                             "bounces", "filter", "filterSamples", "lattice", "clear", "imageLayout", "facesSeenFrom",
                             "encoding", "lightShadows", "glassForm", "curve", "fresnel"}) {
      auto* combo = window_->findChild<QComboBox*>(name);
      if (combo == nullptr) {
        lines.push_back("choice " + std::string(name) + " is not there");
        continue;
      }
      for (int i = 0; i < combo->count(); ++i) {
        if (combo->objectName() == "mode" && i == 2) continue;  // asks for a file
        const Json before = sceneNow();
        combo->setCurrentIndex(i);
        emit combo->activated(i);
        lines.push_back("choice " + std::string(name) + " '" + combo->itemText(i).toStdString() +
                        "':" + differing(before, sceneNow()));
        if (document().canUndo()) lines.back() += " (" + document().undoLabel() + ")";
        undoAll();
      }
    }
    for (const char* name : {"projection", "influence", "occlusion", "dynamic", "planarMirror", "thin"}) {
      auto* box = window_->findChild<QAbstractButton*>(name);
      if (box == nullptr) {
        lines.push_back("switch " + std::string(name) + " is not there");
        continue;
      }
      const Json before = sceneNow();
      const bool checked = box->isChecked();
      box->click();
      lines.push_back("switch " + std::string(name) + (checked ? " off:" : " on:") + differing(before, sceneNow()));
      if (document().canUndo()) lines.back() += " (" + document().undoLabel() + ")";
      undoAll();
      if (box->isChecked() != checked) lines.back() += " and does not go back";
    }
  }
};

TEST_F(PanelValuesTest, EachControlShowsAndSetsWhatItStandsFor) {
  std::vector<std::string> lines;
  readLabels(lines);
  tryFields(lines);
  tryChoices(lines);
  test::expectKeptValues("gui/values/panel_values.txt", lines, test::kExactly);
}

}  // namespace
}  // namespace boxprobe
