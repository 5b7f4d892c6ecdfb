/**
 * @class   vtkCulledRenderer
 * @brief   renderer that draws, of many props, those that can be seen
 *
 * Given a list of props with their bounds, it draws those in the view that nothing drawn before them hides: nearest
 * first, and for the rest occlusion queries of the branches of a tree of their bounds. The picture is the same as
 * without; what it costs follows from what is seen. While camera and props stay as they are nothing is asked again.
 * Props added to the renderer in the usual way are drawn after those, always.
 */
#pragma once

#include <vtkOpenGLRenderer.h>

#include <array>
#include <cstdint>
#include <vector>

#include "filters/core/geometry/box_tree.h"
#include "filters/vtk/gl/occlusion_query.h"
#include "filters/vtk/scene/still_view.h"

class vtkCulledRenderer : public vtkOpenGLRenderer {
 public:
  static vtkCulledRenderer* New();
  vtkTypeMacro(vtkCulledRenderer, vtkOpenGLRenderer) void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Replaces the props that are culled; `bounds` are theirs in the world, none of an empty list. */
  void SetCulledProps(std::vector<vtkProp*> props, const std::vector<boxprobe::Box>& bounds);
  /** Indices of those the last frame drew, ascending; more than can be seen, never less. */
  const std::vector<std::size_t>& GetDrawn() const { return this->Drawn; }
  /** Counts changes of GetDrawn(). */
  std::uint64_t GetDrawnGeneration() const { return this->DrawnGeneration; }
  /** Indices of those that are in the view, hidden ones included. */
  std::vector<std::size_t> InView();
  /** Was GetDrawn() found out for the view as it is? */
  bool DrawnIsCurrent() { return this->DrawnHolds && this->CurrentView() == this->DrawnView; }
  /** false: all of them are drawn, hidden or not, in the view or not. */
  void SetCulling(bool culling);
  /** Opaque actors up to the first prop of another kind are drawn nearest first, so that what is hidden is not worked
   * out: the default. false: in the order they were added in. */
  void SetNearestFirst(bool nearestFirst) { this->NearestFirst = nearestFirst; }
  std::uint64_t GetBoxesAsked() const { return this->BoxesAsked; }
  /** The prop that fills what no other covers: the sky; null: there is none. */
  void SetBackdrop(vtkProp* backdrop);
  /** While the view rests, what nothing shows of is not drawn again, of the surfaces and the backdrop: the default. */
  void SetLeavingOut(bool leavingOut);
  /** What was found hidden may show from now on, for a reason that no prop's redraw time tells of. */
  void ForgetHidden() { this->Still.forget(); }
  /** How many props the last frame left out because nothing of them shows; and was the backdrop one of them? */
  std::size_t GetLeftOut() const { return this->LeftOut; }
  bool GetBackdropLeftOut() const { return this->BackdropLeftOut; }
  /** Pixels around all places where the backdrop shows, which it is drawn within, if what the view hides is known. */
  boxprobe::OcclusionQuery::Rectangle GetBackdropShows() const { return this->BackdropShows; }

  int UpdateGeometry(vtkFrameBufferObjectBase* fbo = nullptr) override;
  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  vtkCulledRenderer();
  ~vtkCulledRenderer() override;

 private:
  vtkCulledRenderer(const vtkCulledRenderer&) = delete;
  void operator=(const vtkCulledRenderer&) = delete;

  using View = std::array<double, 14>;
  View CurrentView();
  std::vector<vtkProp*> PropsOf(const std::vector<std::size_t>& items) const;
  std::vector<vtkProp*> Ordered(const std::vector<vtkProp*>& given);
  void Draw(std::vector<vtkProp*> props, vtkFrameBufferObjectBase* fbo = nullptr);
  void DrawSurfaces(const std::vector<vtkProp*>& props, vtkFrameBufferObjectBase* fbo = nullptr);
  void DrawStill(const std::vector<vtkProp*>& surfaces, const std::vector<vtkProp*>& others,
                 vtkFrameBufferObjectBase* fbo);
  void DrawOthers(const std::vector<vtkProp*>& props, vtkFrameBufferObjectBase* fbo);
  std::vector<vtkProp*> Showing(const std::vector<vtkProp*>& props);
  void FindHidden(const std::vector<vtkProp*>& surfaces, bool backdrop);
  void SetDrawn(std::vector<std::size_t> items);

  std::vector<vtkProp*> Culled;
  boxprobe::BoxTree Tree;
  boxprobe::OcclusionQuery Test;
  std::vector<std::size_t> Drawn;
  std::uint64_t DrawnGeneration = 0;
  std::uint64_t BoxesAsked = 0;
  View DrawnView{};
  bool DrawnHolds = false;  // for that view
  bool Culling = true;
  bool NearestFirst = true;
  bool LeavingOut = true;
  boxprobe::StillView Still;
  vtkProp* Backdrop = nullptr;
  boxprobe::OcclusionQuery::Rectangle BackdropShows;  // if the hidden props of the view are known
  std::size_t LeftOut = 0;
  bool BackdropLeftOut = false;
  std::vector<vtkProp*> Others, Array;
};
