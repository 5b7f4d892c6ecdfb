// What stands in the place of the picture while no scene is open, and the small pictures of scenes it shows.
#include "app/gui/window/welcome.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "app/gui/view/viewport.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/scene_card.h"
#include "app/gui/widgets/thumbnails.h"
#include "app/gui/window/file_commands.h"
#include "filters/io/scene/scene_file.h"
#include "tests/gui/pictures.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class WelcomeTest : public WindowTest {
 protected:
  Welcome& welcome() const { return *window_->findChild<Welcome*>(); }
  QList<SceneCard*> cards() const {
    QList<SceneCard*> shown;
    const auto all = welcome().findChildren<SceneCard*>();
    std::copy_if(all.begin(), all.end(), std::back_inserter(shown), [](auto* card) { return card->isVisible(); });
    return shown;
  }
  SceneCard* card(const QString& name) const {
    for (SceneCard* each : cards()) {
      if (each->accessibleName().startsWith(name)) return each;
    }
    return nullptr;
  }
  void keep(const char* name) {
    if (const char* folder = std::getenv("BOXPROBE_TEST_OUTPUT")) {
      window_->grab().save(QString("%1/%2.png").arg(folder, name));
    }
  }
  QTemporaryDir folder_;
};

// A window that never had one: the one that the program starts with.
TEST_F(WelcomeTest, ANewWindowHasWhatWasOpenedLately) {
  const QString path = folder_.filePath("seen.boxprobe.json");
  saveSceneFile(scene().scene, path.toStdString());
  ASSERT_TRUE(window_->files().openPath(path));
  MainWindow other;
  const auto all = other.findChild<Welcome*>()->findChildren<SceneCard*>();
  EXPECT_TRUE(
      std::any_of(all.begin(), all.end(), [](auto* card) { return card->accessibleName().startsWith("seen"); }));
}

TEST_F(WelcomeTest, AWindowWithoutASceneOffersTheExamplesAndOpensOne) {
  EXPECT_FALSE(welcome().isVisible());
  window_->viewport().setFocus();
  window_->showScene(LoadedScene());
  ASSERT_TRUE(welcome().isVisible());
  EXPECT_EQ(welcome().size(), window_->viewport().size());
  EXPECT_EQ(QApplication::focusWidget(), &window_->viewport()) << "it takes nothing";
  const QStringList names = {"Room", "Building", "Flat", "Furnished", "Windows", "Glass", "Gallery", "Mirror hall"};
  for (const QString& name : names) {
    SceneCard* each = card(name);
    ASSERT_NE(each, nullptr) << name.toStdString();
    EXPECT_TRUE(QTest::qWaitFor([each] { return each->hasPicture(); }, 10000)) << name.toStdString();
  }
  keep("welcome");
  card("Building")->click();
  ASSERT_TRUE(waitFor([this] { return !document().path().empty(); }));
  EXPECT_EQ(QFileInfo(QString::fromStdString(document().path())).fileName(), "building.boxprobe.json");
  EXPECT_FALSE(welcome().isVisible());
}

TEST_F(WelcomeTest, EverythingFitsIntoANarrowPicture) {
  window_->showScene(LoadedScene());
  Welcome narrow(window_, QString(BOXPROBE_DATA_DIR) + "/scenes");
  for (const int width : {290, 420, 900}) {
    narrow.resize(width, 500);
    narrow.show();
    QTest::qWait(20);
    const auto buttons = narrow.findChildren<QPushButton*>();
    ASSERT_GE(buttons.size(), 11);
    for (const QPushButton* one : buttons) {
      const QRect place(one->mapTo(&narrow, QPoint()), one->size());
      EXPECT_GE(place.left(), 0);
      EXPECT_LT(place.right(), width) << one->accessibleName().toStdString() << one->text().toStdString();
      EXPECT_GE(one->width(), one->minimumSizeHint().width());
      for (const QPushButton* other : buttons) {
        const QRect second(other->mapTo(&narrow, QPoint()), other->size());
        EXPECT_TRUE(one == other || !place.intersects(second)) << width;
      }
    }
  }
}

TEST_F(WelcomeTest, ABrokenThumbnailIsAnIconAndAGoodOneAPicture) {
  QImage halves(400, 100, QImage::Format_RGB32);
  halves.fill(Qt::green);
  for (int y = 0; y < 100; ++y) {
    for (int x = 200; x < 400; ++x) halves.setPixelColor(x, y, Qt::red);
  }
  const QString good = folder_.filePath("good.glb"), broken = folder_.filePath("broken.boxprobe.json"),
                large = folder_.filePath("large.glb"), missing = folder_.filePath("missing.glb");
  keepThumbnail(good, halves);
  const QImage kept(thumbnailPath(good));
  ASSERT_FALSE(kept.isNull());
  EXPECT_GT(qGreen(kept.pixel(kept.width() / 4, kept.height() / 2)), 200);
  EXPECT_GT(qRed(kept.pixel(3 * kept.width() / 4, kept.height() / 2)), 200);
  EXPECT_DOUBLE_EQ(1.6, static_cast<double>(kept.width()) / kept.height()) << "cropped, not stretched";
  QFile file(thumbnailPath(broken));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray("\xff\xd8\xff\xe0 not a picture", 18));
  file.close();
  ASSERT_TRUE(QImage(2000, 10, QImage::Format_RGB32).save(thumbnailPath(large), "JPG"));

  window_->showScene(LoadedScene());
  welcome().setRecent({broken, large, missing, good});
  ASSERT_NE(card("good.glb"), nullptr);
  EXPECT_TRUE(QTest::qWaitFor([this] { return card("good.glb")->hasPicture(); }, 10000));
  // Read in their order: the others were looked at before.
  for (const char* name : {"broken", "large.glb", "missing.glb"}) {
    ASSERT_NE(card(name), nullptr) << name;
    EXPECT_FALSE(card(name)->hasPicture()) << name;
  }
  EXPECT_LT(card("broken")->x(), card("large.glb")->x()) << "the newest first";
  keep("welcome-recent");
  const QPixmap drawn = card("good.glb")->grab();
  EXPECT_GT(drawn.toImage().pixelColor(40, 50).green(), 200);
}

TEST_F(WelcomeTest, AnOpenedSceneLeavesASmallPictureOfWhatWasSeen) {
  const QString path = folder_.filePath("copy.boxprobe.json");
  saveSceneFile(document().scene(), path.toStdString());
  const QString thumbnail = thumbnailPath(path);
  ASSERT_FALSE(QFileInfo::exists(thumbnail));
  ASSERT_TRUE(window_->files().openPath(path));
  waitUntilIdle();
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(thumbnail); }, 20000));
  const QImage kept = readThumbnail(thumbnail), seen = shownPicture(window_->viewport());
  ASSERT_FALSE(kept.isNull());
  // Around the middle, where nothing is cropped.
  const double scale =
      std::min(static_cast<double>(seen.width()) / kept.width(), static_cast<double>(seen.height()) / kept.height());
  double difference = 0.0;
  constexpr int kReach = 60;
  for (int y = -kReach; y <= kReach; y += 10) {
    for (int x = -kReach; x <= kReach; x += 10) {
      const QColor a = kept.pixelColor(kept.width() / 2 + x, kept.height() / 2 + y);
      const QColor b = seen.pixelColor(seen.width() / 2 + qRound(x * scale), seen.height() / 2 + qRound(y * scale));
      difference += std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
    }
  }
  EXPECT_LT(difference / (13.0 * 13.0 * 3.0), 16.0);
  window_->showScene(LoadedScene());
  ASSERT_NE(card("copy"), nullptr) << "it is among the recent ones";
  EXPECT_TRUE(QTest::qWaitFor([this] { return card("copy")->hasPicture(); }, 10000));
}

}  // namespace
}  // namespace boxprobe
