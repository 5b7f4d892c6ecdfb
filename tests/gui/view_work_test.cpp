// When pictures are drawn and work is done, without a picture: who is asked what, in which order.
#include <gtest/gtest.h>

#include "app/gui/edit/background_work.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/rest_refinement.h"
#include "app/gui/widgets/preferences.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class RenderSchedulerTest : public ::testing::Test {
 protected:
  RenderSchedulerTest()
      : scheduler_({[this] { return ready_; },
                    [this] {
                      log_ += "picture ";
                      work_ += std::exchange(foundByPicture_, 0);
                    },
                    [this] { return work_ > 0; },
                    [this] {
                      --work_;
                      log_ += "step ";
                    },
                    [this] { return 1.0 / (1 + work_); }, [this] { return better_-- > 0; }}) {
    QObject::connect(&scheduler_, &RenderScheduler::rendered, [this] { log_ += "drawn "; });
    QObject::connect(&scheduler_, &RenderScheduler::workEnded, [this] { log_ += "ended "; });
    QObject::connect(&scheduler_, &RenderScheduler::workProgressed,
                     [this](double done) { log_ += QString::number(done, 'f', 2).toStdString() + " "; });
  }
  /// What was done until nothing is left. Pictures of the progress come by the clock, and are left out.
  std::string done() {
    EXPECT_TRUE(waitFor([this] { return scheduler_.idle(); }));
    std::string log = std::exchange(log_, {});
    const std::string between = "picture drawn step ";
    for (std::size_t at = log.find(between); at != std::string::npos; at = log.find(between)) log.erase(at, 14);
    return log;
  }

  bool ready_ = true;
  int work_ = 0, foundByPicture_ = 0, better_ = 0;
  std::string log_;
  RenderScheduler scheduler_;
};

TEST_F(RenderSchedulerTest, OnePictureForAnyNumberOfRequests) {
  EXPECT_TRUE(scheduler_.idle());
  scheduler_.requestRender();
  scheduler_.requestRender();
  scheduler_.sceneChanged();
  EXPECT_FALSE(scheduler_.idle());
  EXPECT_EQ(done(), "picture drawn ");
  EXPECT_EQ(scheduler_.renders(), 1u);
  EXPECT_EQ(scheduler_.turns(), 1u);
  scheduler_.wake();
  EXPECT_EQ(done(), "");
  EXPECT_EQ(scheduler_.turns(), 2u);
  better_ = 2;
  scheduler_.requestRender();
  EXPECT_EQ(done(), "picture drawn picture drawn picture drawn ");
}

TEST_F(RenderSchedulerTest, NothingWithoutAContext) {
  ready_ = false;
  work_ = 1;
  scheduler_.requestRender();
  EXPECT_TRUE(waitFor([calls = 0]() mutable { return ++calls > 20; }));
  EXPECT_EQ(log_, "");
  EXPECT_EQ(scheduler_.turns(), 0u);
  EXPECT_FALSE(scheduler_.idle()) << "the request waits";
  ready_ = true;
  scheduler_.wake();
  EXPECT_EQ(done(), "step 1.00 picture drawn ended ");
}

TEST_F(RenderSchedulerTest, AStepATurnAndAPictureAtTheEnd) {
  work_ = 3;
  scheduler_.wake();
  EXPECT_EQ(done(), "step 0.33 step 0.50 step 1.00 picture drawn ended ");
  work_ = 2;
  scheduler_.requestRender();
  EXPECT_TRUE(waitFor([this] { return scheduler_.idle(); }));
  EXPECT_EQ(log_.substr(0, 24), "step 0.50 picture drawn ") << "what was asked for does not wait for the end";
  log_.clear();
  // Captures come first, what is better later.
  better_ = 1;
  work_ = 1;
  scheduler_.requestRender();
  EXPECT_EQ(done(), "step 1.00 picture drawn ended picture drawn ");
  foundByPicture_ = 1;
  const auto before = scheduler_.renders();
  scheduler_.requestRender();
  EXPECT_EQ(done(), "step 1.00 picture drawn ended ");
  EXPECT_EQ(scheduler_.renders(), before + 2);
}

TEST_F(RenderSchedulerTest, WorkIsStoppedUntilTheSceneChanges) {
  scheduler_.stopWork();
  EXPECT_FALSE(scheduler_.workStopped()) << "there is none";
  work_ = 5;
  scheduler_.wake();
  EXPECT_TRUE(waitFor([this] { return work_ < 5; }));
  const int left = work_;
  scheduler_.stopWork();
  EXPECT_TRUE(scheduler_.workStopped());
  log_.clear();
  EXPECT_EQ(done(), "picture drawn ended ");
  EXPECT_EQ(work_, left);
  scheduler_.requestRender();
  EXPECT_EQ(done(), "picture drawn ");
  EXPECT_EQ(work_, left);
  scheduler_.stopWork();
  scheduler_.resumeWork();
  EXPECT_FALSE(scheduler_.workStopped());
  done();
  EXPECT_EQ(work_, 0);
  work_ = 5;
  scheduler_.wake();
  EXPECT_TRUE(waitFor([this] { return work_ < 5; }));
  scheduler_.stopWork();
  done();
  foundByPicture_ = 1;
  scheduler_.requestRender();
  EXPECT_EQ(done(), "picture drawn ");
  scheduler_.sceneChanged();
  EXPECT_FALSE(scheduler_.workStopped());
  done();
  EXPECT_EQ(work_, 0);
}

class MotionPreviewTest : public ::testing::Test {
 protected:
  static MotionPreview::Hooks hooks(std::string& log, bool& any) {
    return {[&log](bool allowed) { log += allowed ? "allowed " : "refused "; },
            [&log, &any](bool moving) {
              log += moving ? "moving " : "still ";
              return any && moving;
            }};
  }
  void watch(MotionPreview& preview) {
    QObject::connect(&preview, &MotionPreview::enabledChanged, [this](bool on) { log_ += on ? "on " : "off "; });
    QObject::connect(&preview, &MotionPreview::cameToRest, [this] { log_ += "rest "; });
  }
  std::string told() { return std::exchange(log_, {}); }
  std::string log_;
  bool any_ = true;
};

TEST_F(MotionPreviewTest, ACheaperPictureUntilItRests) {
  preferences()->clear();
  MotionPreview preview(hooks(log_, any_));
  watch(preview);
  EXPECT_FALSE(preview.enabled());
  preview.moved();
  EXPECT_FALSE(preview.active());
  EXPECT_EQ(told(), "");
  preview.setDefault(false);
  EXPECT_EQ(told(), "");
  preview.setDefault(true);
  EXPECT_TRUE(preview.enabled());
  EXPECT_EQ(told(), "allowed on ");
  EXPECT_FALSE(cheaperWhileMoving().has_value()) << "nobody chose it";
  preview.setRest(kNeverMilliseconds);
  preview.moved();
  EXPECT_TRUE(preview.active());
  EXPECT_EQ(told(), "moving ");
  preview.rest();
  preview.rest();
  EXPECT_FALSE(preview.active());
  EXPECT_EQ(told(), "still rest ");
  preview.moved();
  told();
  preview.setRest(1);
  EXPECT_TRUE(waitFor([&] { return !preview.active(); }));
  EXPECT_EQ(told(), "still rest ");
  preview.setRest(kNeverMilliseconds);
  any_ = false;
  preview.moved();
  EXPECT_FALSE(preview.active()) << "nothing stands in for anything";
  EXPECT_EQ(told(), "moving ");
  any_ = true;
  preview.moved();
  told();
  preview.setEnabled(false);
  EXPECT_FALSE(preview.active());
  EXPECT_EQ(told(), "refused still rest off ");
  EXPECT_EQ(cheaperWhileMoving(), std::optional<bool>(false));
  preview.setEnabled(false);
  preview.setDefault(true);
  EXPECT_EQ(told(), "") << "the user has chosen";
  EXPECT_FALSE(MotionPreview(hooks(log_, any_)).enabled());
  MotionPreview next(hooks(log_, any_));
  next.setDefault(true);
  EXPECT_FALSE(next.enabled());
  next.setEnabled(true);
  EXPECT_EQ(cheaperWhileMoving(), std::optional<bool>(true));
  preferences()->clear();
}

TEST(RestRefinementWork, PicturesAreRefinedWhereEverythingRests) {
  preferences()->clear();
  std::string log;
  bool ever = true, resting = false;
  int asked = 0;
  RestRefinement refinement({[&] { return ever; },
                             [&] {
                               ++asked;
                               return resting;
                             },
                             [&](bool on) { log += on ? "refined " : "plain "; }});
  QObject::connect(&refinement, &RestRefinement::switched, [&] { log += "picture "; });
  QObject::connect(&refinement, &RestRefinement::enabledChanged, [&](bool on) { log += on ? "on " : "off "; });
  const auto told = [&] { return std::exchange(log, {}); };
  EXPECT_TRUE(refinement.enabled());
  refinement.setRest(1);
  refinement.moved();
  EXPECT_TRUE(waitFor([&] { return asked > 2; })) << "it asks again";
  EXPECT_FALSE(refinement.active());
  EXPECT_EQ(told(), "");
  resting = true;
  EXPECT_TRUE(waitFor([&] { return refinement.active(); }));
  EXPECT_EQ(told(), "refined picture ");
  refinement.setRest(kNeverMilliseconds);
  refinement.moved();
  EXPECT_FALSE(refinement.active());
  EXPECT_EQ(told(), "plain ");
  refinement.moved();
  EXPECT_EQ(told(), "");
  refinement.setRest(1);
  EXPECT_TRUE(waitFor([&] { return refinement.active(); }));
  told();
  refinement.setRest(kNeverMilliseconds);
  refinement.setEnabled(false);
  EXPECT_EQ(told(), "plain picture off ");
  EXPECT_FALSE(refinesAtRest());
  refinement.setEnabled(false);
  EXPECT_EQ(told(), "");
  refinement.setRest(1);
  refinement.moved();
  EXPECT_TRUE(waitFor([calls = 0]() mutable { return ++calls > 20; }));
  EXPECT_FALSE(refinement.active());
  refinement.setEnabled(true);
  EXPECT_TRUE(refinesAtRest());
  EXPECT_TRUE(waitFor([&] { return refinement.active(); }));
  EXPECT_EQ(told(), "on refined picture ");
  ever = false;
  asked = 0;
  refinement.moved();
  EXPECT_TRUE(waitFor([calls = 0]() mutable { return ++calls > 20; }));
  EXPECT_EQ(asked, 0);
  EXPECT_FALSE(refinement.active());
  preferences()->clear();
}

TEST(BackgroundWorkOrder, WhatItFoundIsTakenHereAndStoppedWorkTakesNothing) {
  BackgroundWork work;
  std::vector<std::string> told;
  std::vector<double> percents;
  QObject::connect(&work, &BackgroundWork::progressed, [&] { percents.push_back(work.percent()); });
  QObject::connect(&work, &BackgroundWork::ended, [&](bool stopped, const QString& error) {
    told.push_back((stopped ? "stopped" : "ended") + (error.isEmpty() ? std::string() : " " + error.toStdString()) +
                   (work.running() ? ", and runs" : ""));
  });
  const auto ended = [&] {
    EXPECT_TRUE(waitFor([&] { return !told.empty(); }));
    return std::exchange(told, {});
  };
  using Told = std::vector<std::string>;
  work.start([&](const BackgroundWork::Progress& progress) -> BackgroundWork::Finish {
    EXPECT_TRUE(progress(0.237));
    EXPECT_TRUE(progress(0.2379));
    return [&] { told.push_back("taken"); };
  });
  EXPECT_TRUE(work.running());
  work.start([&](const BackgroundWork::Progress&) -> BackgroundWork::Finish {
    return [&] { told.push_back("a second one"); };
  });
  EXPECT_TRUE(waitFor([&] { return told.size() == 2; }));
  EXPECT_EQ(std::exchange(told, {}), (Told{"taken", "ended"}));
  EXPECT_EQ(percents, std::vector<double>{23.0});
  work.start([](const BackgroundWork::Progress&) -> BackgroundWork::Finish { throw std::runtime_error("no room"); });
  EXPECT_EQ(ended(), Told{"ended no room"});
  work.start([](const BackgroundWork::Progress& progress) -> BackgroundWork::Finish {
    while (progress(0.5)) {
    }
    return {};
  });
  work.stop();
  EXPECT_EQ(ended(), Told{"stopped"});
  work.start([](const BackgroundWork::Progress& progress) -> BackgroundWork::Finish {
    EXPECT_TRUE(progress(0.0)) << "the stop was the last one's";
    return [] {};
  });
  EXPECT_EQ(ended(), Told{"ended"});
}

}  // namespace
}  // namespace boxprobe
