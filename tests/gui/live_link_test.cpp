// File, Live link: what is edited stands in the file a moment later, saved or not.
#include "app/gui/window/live_link.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/gui/edit/editor.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/gltf/glb_document.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class LiveLinkTest : public WindowTest {
 protected:
  nlohmann::json extension() const {
    const auto root = nlohmann::json::parse(*glbJsonText(path().toStdString()));
    return root["extensions"][kGlbExtension];
  }
  int countedRevision() const {
    QFile file(path() + ".revision");
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return nlohmann::json::parse(file.readAll().toStdString())["revision"].get<int>();
  }
  QString path() const { return folder_.path() + "/live.glb"; }

  QTemporaryDir folder_;
};

TEST_F(LiveLinkTest, AnEditStandsInTheFileAndMapsFollow) {
  waitUntilIdle();
  LiveLink& link = window_->liveLink();
  QSignalSpy failed(&link, &LiveLink::failed);
  link.start(path());
  ASSERT_TRUE(QTest::qWaitFor([&] { return countedRevision() >= 1; }, 300000));
  const Probe probe = document().scene().probes.at(0);
  const glm::dvec3 moved = probe.box.max + glm::dvec3(0.25, 0.5, 0.125);
  const int before = link.revision();
  document().commit("Move the box", [&](Scene& scene) { scene.probes[0].box.max = moved; });
  emit window_->editor().settled();
  EXPECT_TRUE(document().modified());
  const auto size = [&] {
    const nlohmann::json box = extension()["probes"][0]["box"];
    glm::dvec3 sides;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      sides[i] = box["max"][axis].get<double>() - box["min"][axis].get<double>();
    }
    return sides;
  };
  // What was under way before the edit may be written first.
  EXPECT_TRUE(QTest::qWaitFor([&] { return glm::length(size() - (moved - probe.box.min)) < 1e-5; }, 300000));
  EXPECT_GT(link.revision(), before);
  // With all maps in the end, without another edit.
  ASSERT_TRUE(QTest::qWaitFor([&] { return extension()["probes"][0].contains("map"); }, 300000));
  link.stop();
  QTest::qWait(500);  // what was under way is written to its end
  const int ended = link.revision();
  document().commit("Move it back", [&](Scene& scene) { scene.probes[0].box.max = probe.box.max; });
  emit window_->editor().settled();
  QTest::qWait(500);
  EXPECT_EQ(link.revision(), ended);
  EXPECT_EQ(failed.size(), 0);
}

TEST_F(LiveLinkTest, EachLinkCountsItsOwnRevisions) {
  waitUntilIdle();
  LiveLink& link = window_->liveLink();
  QSignalSpy told(&link, &LiveLink::message);
  const auto any = [&told](const QString& words) {
    return std::any_of(told.begin(), told.end(),
                       [&](const auto& each) { return each.at(0).toString().contains(words); });
  };
  for (const char* name : {"/first.glb", "/second.glb"}) {
    told.clear();
    const int before = link.revision();
    link.start(folder_.path() + name);
    EXPECT_TRUE(QTest::qWaitFor([&] { return any("follows the scene"); }, 300000)) << name;
    document().commit("Move", [](Scene& scene) { scene.probes[0].box.max.x += 0.125; });
    emit window_->editor().settled();
    EXPECT_TRUE(QTest::qWaitFor([&] { return link.revision() >= before + 2; }, 300000));
    link.stop();
    const QString words = QString("after %1 revisions").arg(link.revision() - before);
    EXPECT_TRUE(any(words)) << told.back().at(0).toString().toStdString();
    QTest::qWait(500);  // what was under way is written to its end
  }
}

TEST_F(LiveLinkTest, TheModelItselfIsNotOverwritten) {
  const auto bytesOf = [](const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  };
  const QString copy = folder_.path() + "/model.glb";  // if it were overwritten, then not the checkout's
  ASSERT_TRUE(QFile::copy(QString::fromStdString(document().scene().models.at(0).file), copy));
  const QByteArray before = bytesOf(copy);
  ASSERT_GT(before.size(), 1000);
  LoadedScene copied = scene();
  copied.scene.models.at(0).file = copy.toStdString();
  window_->showScene(std::move(copied));
  waitUntilIdle();
  LiveLink& link = window_->liveLink();
  QSignalSpy failed(&link, &LiveLink::failed);
  link.start(copy);
  EXPECT_FALSE(link.running());
  QTest::qWait(500);
  EXPECT_TRUE(bytesOf(copy) == before);
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed.at(0).at(0).toString().contains("model"));
}

}  // namespace
}  // namespace boxprobe
