// An outline about one object, over the window's picture, in a layer of its own. Not in captures or linear pictures.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <vector>

class vtkActor;
class vtkDataObject;
class vtkRenderWindow;
class vtkRenderer;

namespace boxprobe {

class ObjectOutline {
 public:
  ObjectOutline(vtkRenderWindow* window, vtkRenderer* scene) : window_(window), scene_(scene) {}
  ~ObjectOutline();
  ObjectOutline(const ObjectOutline&) = delete;
  ObjectOutline& operator=(const ObjectOutline&) = delete;

  /// About all of these together, as they stand now; empty: none. Not while the window draws.
  void show(const std::vector<vtkActor*>& pieces);
  /// Needs the window's context.
  void release();

 private:
  struct Piece {
    vtkWeakPointer<vtkActor> actor;
    vtkWeakPointer<vtkDataObject> data;
  };
  void build();
  static void place(vtkActor* piece, vtkActor* twin);

  vtkWeakPointer<vtkRenderWindow> window_;
  vtkWeakPointer<vtkRenderer> scene_;
  vtkSmartPointer<vtkRenderer> layer_;  ///< null until first used
  std::vector<vtkSmartPointer<vtkActor>> twins_;
  std::vector<Piece> pieces_;  ///< what the twins are of
};

}  // namespace boxprobe
