// Boxes fitted and probes placed in a plain VTK program's renderer, whichever axis is up and whatever its unit.
#include <vtkCallbackCommand.h>
#include <vtkTransform.h>

#include <cstdio>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "filters/vtk/placement/vtkReflectionProbeFit.h"
#include "tests/image/vtk_room.h"

namespace {

using namespace boxprobe::test;

struct FittedRoom : Room {
  explicit FittedRoom(double size = 1.0) : Room(size) {
    probes->SetRenderer(renderer);
    fit->SetProbes(probes);
    fit->SetMetresPerUnit(1.0 / size);
  }
  vtkNew<vtkReflectionProbes> probes;
  vtkNew<vtkReflectionProbeFit> fit;
};

void expectBounds(vtkReflectionProbe* probe, const std::array<double, 6>& wanted, double off) {
  const double* found = probe->GetBounds();
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], wanted[i], off) << "bound " << i;
}

TEST(ReflectionProbeFit, ABoxIsFittedToTheWalls) {
  for (const double size : {1.0, 100.0}) {
    const FittedRoom room(size);
    vtkNew<vtkReflectionProbe> probe;
    probe->SetName("hall");
    probe->SetBounds(-size, size, -0.5 * size, 0.5 * size, -size, size);
    room.probes->AddProbe(probe);
    ASSERT_TRUE(room.fit->Fit(probe)) << room.fit->GetReport();
    expectBounds(probe, {-2 * size, 2 * size, -size, size, -2 * size, 2 * size}, 0.02 * size);
    EXPECT_STREQ(probe->GetName(), "hall");
    expectNear(at(room.picture(), kMirroredX, kMirroredY), {128, 128, 128}, 2);
  }
}

TEST(ReflectionProbeFit, AnyAxisMayPointUp) {
  const FittedRoom room;
  for (vtkActor* actor : {room.floor.Get(), room.others[0].Get(), room.others[1].Get(), room.others[2].Get(),
                          room.others[3].Get(), room.others[4].Get()}) {
    vtkNew<vtkTransform> turn;
    turn->RotateZ(20.0);
    turn->RotateX(90.0);  // y becomes z, z becomes -y
    actor->SetUserTransform(turn);
  }
  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-1, 1, -1, 1, -0.5, 0.5);
  room.probes->AddProbe(probe);
  room.fit->SetUpAxis(2);
  ASSERT_TRUE(room.fit->Fit(probe)) << room.fit->GetReport();
  expectBounds(probe, {-2, 2, -2, 2, -1, 1}, 0.05);
  EXPECT_NEAR(std::remainder(probe->GetOrientation()[2] - 20.0, 90.0), 0.0, 1.0);
}

TEST(ReflectionProbeFit, ProbesArePlacedInRooms) {
  const FittedRoom room;
  const int placed = room.fit->Place();
  std::printf("%d placed: %s\n", placed, room.fit->GetReport());
  ASSERT_GE(placed, 1) << room.fit->GetReport();
  EXPECT_EQ(room.probes->GetNumberOfProbes(), placed);
  expectBounds(room.probes->GetProbe(0), {-2, 2, -1, 1, -2, 2}, 0.05);
  EXPECT_EQ(room.fit->Place(), 0);  // the room has its probe
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {128, 128, 128}, 3);
}

TEST(ReflectionProbeFit, WhatCannotBeFittedIsSaid) {
  vtkNew<vtkReflectionProbeFit> fit;
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  fit->AddObserver(vtkCommand::ErrorEvent, count);
  vtkNew<vtkReflectionProbe> probe;
  EXPECT_FALSE(fit->Fit(probe));
  EXPECT_FALSE(fit->Fit(nullptr));
  EXPECT_EQ(fit->Place(), -1);
  EXPECT_EQ(errors, 3);
  vtkNew<vtkReflectionProbes> probes;
  vtkNew<vtkRenderer> empty;
  probes->SetRenderer(empty);
  fit->SetProbes(probes);
  EXPECT_FALSE(fit->Fit(probe));
  EXPECT_STRNE(fit->GetReport(), "");
  EXPECT_EQ(fit->Place(), 0);
  EXPECT_EQ(errors, 3);
}

TEST(ReflectionProbeFit, CanBeStopped) {
  const FittedRoom room;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(room.fit.GetPointer());
  stop->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
    static_cast<vtkReflectionProbeFit*>(client)->SetAbortFlag(true);
  });
  room.fit->AddObserver(vtkCommand::ProgressEvent, stop);
  vtkNew<vtkReflectionProbe> probe;
  EXPECT_FALSE(room.fit->Fit(probe));
  expectBounds(probe, {-1, 1, -1, 1, -1, 1}, 0.0);
  EXPECT_EQ(room.fit->Place(), 0);
}

}  // namespace
