// File, Export probes: what the window shows, written beside the window's own work.
#include "app/gui/window/probe_exporter.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

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

TEST_F(ProbeExporterTest, TheMenuHasIt) {
  bool found = false;
  for (const QAction* menu : window_->menuBar()->actions()) {
    for (const QAction* action : menu->menu()->actions()) found |= action->text() == "Export &probes...";
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace boxprobe
