// Comparisons of pictures whose every number can be counted: what is measured, when, what is told, which scenes are
// drawn for the views side by side.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <cmath>

#include "app/gui/view/compare_views.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/picture_compare.h"
#include "app/gui/view/picture_difference.h"
#include "app/gui/view/reference_trace.h"
#include "app/gui/view/view_comparison.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

constexpr int kWidth = 40, kHeight = 8;

QImage evenPicture(const QColor& color = {100, 50, 20}) {
  QImage image(kWidth, kHeight, QImage::Format_RGB32);
  image.fill(color);
  return image;
}

/// Of 320 pixels 24 are brighter, and one by each channel.
QImage changedPicture() {
  QImage image = evenPicture();
  for (int i = 0; i < 21; ++i) image.setPixelColor(i, 2, {151, 40, 20});
  image.setPixelColor(3, 4, {130, 50, 20});
  image.setPixelColor(4, 4, {100, 10, 20});
  image.setPixelColor(5, 4, {100, 50, 222});
  return image;
}

double changedSquares() {
  return 21.0 * (51.0 * 51.0 + 10.0 * 10.0) + 30.0 * 30.0 + 40.0 * 40.0 + 202.0 * 202.0;
}
double changedPsnr() {
  return 10.0 * std::log10(255.0 * 255.0 * 3.0 * kWidth * kHeight / changedSquares());
}
double changedMean() {
  return (21.0 * 51.0 + 30.0 + 40.0 + 202.0) / 255.0 / (kWidth * kHeight);
}

QString inTenths(double value) {
  return QString::number(value, 'f', 1);
}

class CompareValuesTest : public ::testing::Test {
 protected:
  using Told = std::vector<std::string>;

  CompareValuesTest() {
    scene_.sky = SkyColor{glm::vec3(0.62F, 0.35F, 0.17F)};
    Probe probe;
    probe.name = "first";
    probe.mode = ProbeMode::Baked;
    probe.technique = "impostor+hdrp";
    probe.projection = false;
    scene_.probes.push_back(probe);
    probe.name = "second";
    probe.mode = ProbeMode::Realtime;
    scene_.probes.push_back(probe);
    document_.open(scene_, "");
    picture_.resize(kWidth * 20, kHeight * 40);
    camera_.target = {0.3, 0.2, -1.0};
  }

  Scene scene_;
  Document document_;
  QWidget picture_;
  Camera camera_;
};

TEST(PictureDifferenceValues, MeanMostAndPsnrAreCounted) {
  const PictureDifference difference = pictureDifference(evenPicture(), changedPicture());
  EXPECT_NEAR(difference.mean, changedMean(), 1e-12);
  EXPECT_NEAR(difference.mostOf95, 51.0 / 255.0, 1e-12) << "92.5 % of them are alike";
  EXPECT_NEAR(displayPsnr(evenPicture(), changedPicture()), changedPsnr(), 1e-9);
  EXPECT_TRUE(std::isinf(displayPsnr(evenPicture(), evenPicture())));
  const auto at = [&](int x, int y) { return QColor(difference.picture.pixel(x, y)); };
  EXPECT_EQ(at(0, 2), differenceColor(51.0 / 255.0));
  EXPECT_EQ(at(3, 4), differenceColor(30.0 / 255.0));
  EXPECT_EQ(at(4, 4), differenceColor(40.0 / 255.0));
  EXPECT_EQ(at(5, 4), differenceColor(202.0 / 255.0));
  EXPECT_EQ(at(39, 7), differenceColor(0.0));
  EXPECT_EQ(at(39, 0), differenceColor(0.0));
  // Three in ten pixels differ: the 95 % are among them.
  QImage more = evenPicture();
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < kHeight; ++y) more.setPixelColor(x, y, {100 + x, 50, 20});
  }
  EXPECT_NEAR(pictureDifference(evenPicture(), more).mostOf95, 9.0 / 255.0, 1e-12);
}

TEST_F(CompareValuesTest, AHeldPictureIsMeasuredWhereNothingMoves) {
  QImage now = evenPicture();
  bool ready = true;
  int pictures = 0, asked = 0;
  CompareWipe wipe(&picture_);
  PictureCompare compare(document_, wipe,
                         {[&] { return ++asked > 0 && ready; },
                          [&] {
                            ++pictures;
                            return now;
                          },
                          [](const QSize&) { return ImageRgbaF(); }, [&] { return camera_; },
                          [] { return std::vector<std::shared_ptr<const Model>>(); }, [] { return ProbesDiffuse(); }});
  std::vector<std::string> told;
  QObject::connect(&compare, &PictureCompare::activeChanged, [&](bool on) { told.push_back(on ? "on" : "off"); });
  QObject::connect(&compare, &PictureCompare::differenceChanged,
                   [&](bool on) { told.push_back(on ? "difference" : "pictures"); });
  QObject::connect(&compare, &PictureCompare::message,
                   [&](const QString& text) { told.push_back(text.section(':', 0, 0).toStdString()); });
  const auto takeTold = [&] { return std::exchange(told, {}); };
  const auto* numbers = picture_.findChild<QLabel*>("compareNumbers");
  const auto* caption = picture_.findChild<QLabel*>("compareRight");
  const auto says = [&](const QString& text) {
    EXPECT_TRUE(waitFor([&] { return numbers->text() == text; }))
        << numbers->text().toStdString() << ", not " << text.toStdString();
  };

  compare.setFlipped(true);
  compare.setDifference(true);
  compare.stop();
  EXPECT_EQ(takeTold(), Told()) << "nothing is compared yet";
  EXPECT_FALSE(wipe.flipped());
  EXPECT_FALSE(wipe.isVisibleTo(&picture_));

  compare.hold();
  EXPECT_EQ(takeTold(), (Told{"on", "The picture is held on the right"}));
  EXPECT_TRUE(compare.active());
  EXPECT_FALSE(compare.tracing());
  EXPECT_EQ(caption->text(), "Held");
  EXPECT_TRUE(wipe.isVisibleTo(&picture_));
  EXPECT_EQ(numbers->text(), "");
  says("No difference");
  const int before = pictures;
  now = changedPicture();
  ready = false;
  asked = 0;
  compare.pictureDrawn();
  EXPECT_TRUE(waitFor([&] { return asked > 1; }));
  EXPECT_EQ(numbers->text(), "No difference") << "the picture does not rest";
  ready = true;
  says("Difference: PSNR " + inTenths(changedPsnr()) + " dB");
  EXPECT_EQ(pictures, before + 1) << "once a change";

  compare.setDifference(true);
  compare.setDifference(true);
  EXPECT_EQ(takeTold(), Told{"difference"});
  EXPECT_EQ(caption->text(), "Difference: preparing");
  says("Difference: mean " + inTenths(100.0 * changedMean()) + " %, 95 % of the pixels below 20.0 %, PSNR " +
       inTenths(changedPsnr()) + " dB");
  EXPECT_EQ(caption->text(), "Difference: Held");
  now = evenPicture({100, 101, 20});
  compare.documentChanged();
  compare.pictureDrawn();
  says("Difference: mean 20.0 %, 95 % of the pixels below 20.0 %, PSNR " +
       inTenths(10.0 * std::log10(3.0 * 255.0 * 255.0 / (51.0 * 51.0))) + " dB");
  now = evenPicture();
  compare.pictureDrawn();
  says("No difference");

  // From elsewhere nothing is compared.
  const Camera there = camera_;
  camera_.position.x += 0.5;
  compare.pictureDrawn();
  EXPECT_FALSE(wipe.isVisibleTo(&picture_));
  compare.setDifference(false);
  EXPECT_EQ(takeTold(), Told{"pictures"});
  EXPECT_EQ(caption->text(), "Difference: Held") << "it is not on show";
  camera_ = there;
  camera_.name = "another name for it";
  compare.pictureDrawn();
  EXPECT_TRUE(wipe.isVisibleTo(&picture_));
  now = changedPicture();
  compare.pictureDrawn();
  says("Difference: PSNR " + inTenths(changedPsnr()) + " dB");
  now = QImage(kWidth, kHeight + 1, QImage::Format_RGB32);
  compare.pictureDrawn();
  EXPECT_TRUE(waitFor([&] { return !wipe.isVisibleTo(&picture_); })) << "of another size";

  compare.setFlipped(true);
  EXPECT_TRUE(wipe.flipped());
  compare.setDifference(true);
  takeTold();
  compare.stop();
  EXPECT_EQ(takeTold(), (Told{"", "off"}));
  EXPECT_FALSE(wipe.flipped());
  EXPECT_FALSE(compare.active());
  EXPECT_FALSE(compare.difference());
  now = QImage();
  compare.hold();
  EXPECT_EQ(takeTold(), Told()) << "without a picture there is none to hold";
}

TEST_F(CompareValuesTest, ATraceIsBegunAnewByAnEditAndAnotherView) {
  QImage now = evenPicture();
  CompareWipe wipe(&picture_);
  PictureCompare compare(
      document_, wipe,
      {[] { return true; }, [&] { return now; }, [](const QSize&) { return ImageRgbaF(); }, [&] { return camera_; },
       [] { return std::vector<std::shared_ptr<const Model>>(); }, [] { return ProbesDiffuse(); }});
  const auto* caption = picture_.findChild<QLabel*>("compareRight");
  const auto shows = [&](const char* name) {
    EXPECT_TRUE(waitFor([&] { return caption->text() == name; })) << caption->text().toStdString();
  };
  compare.traceReference(TracedLight::All);
  EXPECT_EQ(caption->text(), "Path traced: preparing");
  EXPECT_TRUE(compare.tracing());
  shows("Path traced");
  EXPECT_FALSE(compare.tracing());
  compare.documentChanged();
  shows("Path traced: preparing");
  shows("Path traced");
  camera_.position.x = 0.7;
  compare.pictureDrawn();
  shows("Path traced: preparing");
  shows("Path traced");
  EXPECT_TRUE(wipe.isVisibleTo(&picture_));
  now = QImage(kWidth, kHeight + 1, QImage::Format_RGB32);
  compare.pictureDrawn();
  shows("Path traced: preparing");
  shows("Path traced");
  compare.traceReference(TracedLight::Reflection);
  EXPECT_EQ(caption->text(), "Reflection traced: preparing");
  shows("Reflection traced");
  compare.traceError();
  EXPECT_TRUE(compare.difference());
  shows("Difference: Path traced");
  compare.hold();
  EXPECT_EQ(caption->text(), "Difference: preparing");
  compare.stop();
}

TEST_F(CompareValuesTest, PassesOfATraceGetFiner) {
  const auto passes = [this](TracedLight light) {
    ReferenceTrace trace;
    std::string text;
    bool ended = false;
    QObject::connect(
        &trace, &ReferenceTrace::traced,
        [&](const QImage& image, double share, const std::shared_ptr<const ReferencePicture>& found) {
          text += QString("%1 %: %2x%3").arg(100.0 * share).arg(image.width()).arg(image.height()).toStdString();
          if (found) text += " of " + std::to_string(found->color.width) + "x" + std::to_string(found->color.height);
          text += "; ";
          ended = share >= 1.0;
        });
    trace.start(scene_, {}, camera_, {19, 9}, light);
    EXPECT_TRUE(trace.running());
    EXPECT_TRUE(waitFor([&] { return ended; }));
    EXPECT_FALSE(trace.running());
    return text;
  };
  const std::string fivePasses = "20 %: 19x9; 40 %: 19x9; 60 %: 19x9; 80 %: 19x9 of 19x9; 100 %: 19x9 of 19x9; ";
  EXPECT_EQ(passes(TracedLight::All), fivePasses);
  EXPECT_EQ(passes(TracedLight::Reflection), fivePasses);
  EXPECT_EQ(passes(TracedLight::Diffuse),
            "25 %: 19x9 of 4x2; 50 %: 19x9 of 9x4; 75 %: 19x9 of 19x9; 100 %: 19x9 of 19x9; ");
  ReferenceTrace stopped;
  bool told = false;
  QObject::connect(&stopped, &ReferenceTrace::traced, [&] { told = true; });
  stopped.start(scene_, {}, camera_, {19, 9});
  stopped.end();
  EXPECT_FALSE(stopped.running());
  passes(TracedLight::Diffuse);
  EXPECT_FALSE(told) << "nobody waits for it";
}

TEST_F(CompareValuesTest, AViewsSceneIsTheOneItNames) {
  Scene before = scene_;
  before.exposure = 3.0;
  EXPECT_FALSE(viewScene(scene_, before, "now").has_value());
  EXPECT_FALSE(viewScene(scene_, before, "traced").has_value());
  EXPECT_FALSE(viewScene(scene_, before, "").has_value());
  EXPECT_TRUE(viewScene(scene_, before, "before") == before);
  Scene wanted = scene_;
  wanted.probes[1].mode = ProbeMode::Baked;
  EXPECT_TRUE(viewScene(scene_, before, "baked") == wanted);
  wanted = scene_;
  wanted.probes[0].mode = ProbeMode::Realtime;
  EXPECT_TRUE(viewScene(scene_, before, "live") == wanted);
  wanted = scene_;
  for (Probe& probe : wanted.probes) {
    probe.technique = "infinite";
    probe.projection = true;
  }
  EXPECT_TRUE(viewScene(scene_, before, "technique:infinite") == wanted);
  const auto choices = viewChoices();
  ASSERT_GT(choices.size(), 8u);
  EXPECT_EQ(choices[0].id, "");
  EXPECT_EQ(choices[5].id, "live");
  for (std::size_t i = 6; i < choices.size(); ++i) {
    EXPECT_TRUE(choices[i].id.startsWith("technique:")) << choices[i].id.toStdString();
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(choices[i].id, choices[j].id);
  }
}

TEST_F(CompareValuesTest, ViewsSideBySideAreDrawnOneAfterTheOther) {
  // A picture of its own for each scene that is drawn.
  std::string drawn = "own";
  std::vector<std::string> draws, told;
  bool ready = true;
  ViewComparison comparison(document_, &picture_,
                            {[&] { return ready; },
                             [&] {
                               if (drawn == "infinite baked, live") return changedPicture();
                               return evenPicture(drawn == "own" ? QColor(100, 50, 20) : QColor(100, 101, 20));
                             },
                             [](const QSize&) { return ImageRgbaF(); }, [&] { return camera_; },
                             [] { return std::vector<std::shared_ptr<const Model>>(); },
                             [&](const Scene& scene, const Changes&) {
                               drawn = scene == document_.scene() ? "own" : scene.probes[0].technique;
                               if (drawn != "own") {
                                 for (const Probe& probe : scene.probes) {
                                   drawn += (&probe == &scene.probes[0] ? " " : ", ") +
                                            std::string(probe.mode == ProbeMode::Baked ? "baked" : "live");
                                 }
                               }
                               draws.push_back(drawn);
                             }});
  QObject::connect(&comparison, &ViewComparison::onChanged, [&](bool on) { told.push_back(on ? "on" : "off"); });
  QObject::connect(&comparison, &ViewComparison::ownSceneShown,
                   [&](bool own) { told.push_back(own ? "own" : "another"); });
  CompareViews& views = comparison.views();
  const char* const first[] = {"now", "traced", "technique:infinite", "live"};
  for (int view = 0; view < 4; ++view) EXPECT_EQ(views.chosen(view), first[view]);
  views.choose(1, "");
  const auto made = [&] { EXPECT_TRUE(waitFor([&] { return !comparison.making(); })); };

  comparison.setOn(true);
  EXPECT_TRUE(comparison.making());
  made();
  EXPECT_EQ(draws, (Told{"infinite baked, live", "impostor+hdrp live, live", "own"}));
  EXPECT_EQ(told, (Told{"on", "another", "own"}));
  EXPECT_EQ(views.numbers(0), "The measure of the others");
  EXPECT_EQ(views.numbers(1), "");
  EXPECT_EQ(views.numbers(2), "Error " + inTenths(100.0 * changedMean()) + " %, " + inTenths(changedPsnr()) + " dB");
  EXPECT_EQ(views.numbers(3), "Error 20.0 %, " + inTenths(10.0 * std::log10(3.0 * 25.0)) + " dB");

  // An edit of what is seen begins it anew, one of the selection does not.
  document_.selectProbe(1);
  EXPECT_FALSE(comparison.making());
  comparison.pictureDrawn();
  EXPECT_FALSE(comparison.making());
  draws.clear();
  document_.commit("Set", [](Scene& edited) { edited.exposure = 2.0; });
  EXPECT_TRUE(comparison.making());
  EXPECT_FALSE(views.isVisibleTo(&picture_));
  made();
  EXPECT_TRUE(views.isVisibleTo(&picture_));
  EXPECT_EQ(draws, (Told{"infinite baked, live", "impostor+hdrp live, live", "own"}));
  views.choose(3, "before");
  draws.clear();
  camera_.position.y = 0.3;
  comparison.pictureDrawn();
  EXPECT_FALSE(views.isVisibleTo(&picture_));
  made();
  EXPECT_EQ(draws, (Told{"infinite baked, live", "impostor+hdrp baked, live", "own"}));
  comparison.pictureChanged();
  EXPECT_TRUE(comparison.making());
  made();
  views.choose(2, "");
  views.choose(3, "now");
  draws.clear();
  comparison.pictureChanged();
  made();
  EXPECT_EQ(draws, Told());
  EXPECT_EQ(views.numbers(3), "The measure of the others");
  EXPECT_EQ(views.numbers(0), "The measure of the others");

  told.clear();
  ready = false;
  views.choose(2, "technique:infinite");
  comparison.pictureChanged();
  ready = true;
  EXPECT_TRUE(waitFor([&] { return drawn != "own"; }));
  comparison.forget();
  EXPECT_EQ(told, (Told{"another", "own", "off"}));
  EXPECT_FALSE(comparison.on());
  EXPECT_FALSE(views.isVisibleTo(&picture_));
  told.clear();
  comparison.setOn(false);
  EXPECT_EQ(told, Told());
  comparison.setOn(true);
  comparison.setOn(false);
  EXPECT_EQ(told, (Told{"on", "off"}));
}

TEST_F(CompareValuesTest, ATracedViewIsTheMeasureOfTheOthers) {
  ViewComparison comparison(
      document_, &picture_,
      {[] { return true; }, [] { return evenPicture(); }, [](const QSize&) { return ImageRgbaF(); },
       [&] { return camera_; }, [] { return std::vector<std::shared_ptr<const Model>>(); },
       [](const Scene&, const Changes&) {}});
  CompareViews& views = comparison.views();
  views.choose(2, "");
  views.choose(3, "");
  comparison.setOn(true);
  EXPECT_TRUE(waitFor([&] { return views.numbers(1) == "The measure of the others"; }));
  EXPECT_TRUE(views.numbers(0).startsWith("Error ")) << views.numbers(0).toStdString();
  EXPECT_EQ(views.numbers(2), "");
  comparison.setOn(false);
}

}  // namespace
}  // namespace boxprobe
