// File, Export probes: what the window shows, written beside the window's own work.
#include "app/gui/window/probe_exporter.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/window/scene_reporter.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class ProbeExporterTest : public WindowTest {};

TEST_F(ProbeExporterTest, WhatIsShownIsWrittenWhileTheWindowGoesOn) {
  waitUntilIdle();
  const QTemporaryDir folder;
  ProbeExporter& exporter = window_->exporter();
  QSignalSpy done(&exporter, &ProbeExporter::message), failed(&exporter, &ProbeExporter::failed);
  ExportSettings settings;
  settings.ladder = "three";
  settings.faceSize = 16;
  exporter.start(settings, folder.path());
  EXPECT_TRUE(exporter.running());  // another thread's
  EXPECT_TRUE(QTest::qWaitFor([&] { return !exporter.running(); }, 60000));
  const std::size_t probes = document().scene().probes.size();
  EXPECT_EQ(QDir(folder.path()).entryList({"*.ktx2"}).size() + (failed.isEmpty() ? 0 : 1), static_cast<int>(probes));
  EXPECT_TRUE(QDir(folder.path()).exists("boxprobe_three.js"));
  settings.format = "png";
  failed.clear();
  exporter.start(settings, folder.path());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !exporter.running(); }, 60000));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed.at(0).at(0).toString().contains("no such format"));
}

TEST_F(ProbeExporterTest, AReportOfTheSceneOnShowIsOneFile) {
  waitUntilIdle();
  const QTemporaryDir folder;
  SceneReporter& reporter = window_->reporter();
  QSignalSpy done(&reporter, &SceneReporter::message), failed(&reporter, &SceneReporter::failed);
  ReviewSettings settings;
  settings.width = 32;
  settings.height = 18;
  settings.paths = 4;
  reporter.setSettings(settings);
  window_->editor().commitProbe("Rename", [](Probe& probe) { probe.name = "not in the file"; });
  const QString path = folder.filePath("report.html");
  EXPECT_TRUE(reporter.write(path)) << (failed.isEmpty() ? "" : failed.at(0).at(0).toString().toStdString());
  document().undo();
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray page = file.readAll();
  EXPECT_TRUE(page.contains("not in the file")) << "the scene as it is edited";
  EXPECT_EQ(page.count("data:image/png;base64,"), 3 * static_cast<int>(document().scene().cameras.size()));
  EXPECT_TRUE(done.last().at(0).toString().startsWith("Wrote "));
  EXPECT_FALSE(reporter.write(folder.filePath("missing/report.html")));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed.at(0).at(0).toString().contains("missing"));
}

TEST_F(ProbeExporterTest, TheMenuHasIt) {
  bool found = false;
  for (const QAction* menu : window_->menuBar()->actions()) {
    for (const QAction* action : menu->menu()->actions()) found |= action->text() == "Export &probes...";
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace boxprobe
