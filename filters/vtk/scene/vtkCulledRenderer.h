/**
 * @class   vtkCulledRenderer
 * @brief   renderer that draws, of many props, those that can be seen
 *
 * Given a list of props with their bounds, it draws those in the view that nothing drawn before them hides: nearest
 * first, with occlusion queries of the branches of a bounding volume hierarchy for the rest. The picture is the same as
 * without culling; the cost depends on what is visible. While camera and props do not change there are no new queries.
 * Props added to the renderer in the usual way are always drawn, after those.
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

  /** Replaces the props that are culled; `bounds`: their world bounds. */
  void SetCulledProps(std::vector<vtkProp*> props, const std::vector<boxprobe::Box>& bounds);
  /** Ascending indices of those drawn in the last frame: all visible ones, and possibly others. */
  const std::vector<std::size_t>& GetDrawn() const { return this->Drawn; }
  /** Counts changes of GetDrawn(). */
  std::uint64_t GetDrawnGeneration() const { return this->DrawnGeneration; }
  /** Indices of those in view, including hidden ones. */
  std::vector<std::size_t> InView();
  /** Is GetDrawn() valid for the current view? */
  bool DrawnIsCurrent() { return this->DrawnHolds && this->CurrentView() == this->DrawnView; }
  /** false: draws all of them, even if hidden or outside the view. */
  void SetCulling(bool culling);
  /** true (default): opaque actors up to the first prop of another kind are drawn nearest first, so that hidden
   * fragments are not shaded. false: in the order of addition. */
  void SetNearestFirst(bool nearestFirst) { this->NearestFirst = nearestFirst; }
  std::uint64_t GetBoxesAsked() const { return this->BoxesAsked; }
  /** The prop that fills uncovered pixels, such as the sky; null: none. */
  void SetBackdrop(vtkProp* backdrop);
  /** true (default): in a view at rest, invisible surfaces and an invisible backdrop are culled. */
  void SetHiddenCulling(bool culling);
  /** Hidden props may be visible from now on, for a reason that no prop's redraw time indicates. */
  void ForgetHidden() { this->Still.forget(); }
  /** The same of the culled ones: those drawn are determined anew. */
  void ForgetDrawn() { this->DrawnHolds = false; }
  /** Number of props culled in the last frame because they are invisible; below: was the backdrop culled? */
  std::size_t GetCulledCount() const { return this->CulledCount; }
  bool GetBackdropCulled() const { return this->BackdropCulled; }
  /** A rectangle around the visible pixels of the backdrop, to which it is clipped if the hidden props are known. */
  boxprobe::OcclusionQuery::Rectangle GetBackdropRectangle() const { return this->BackdropRectangle; }

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
  bool HiddenCulling = true;
  boxprobe::StillView Still;
  vtkProp* Backdrop = nullptr;
  boxprobe::OcclusionQuery::Rectangle BackdropRectangle;  // if the hidden props of the view are known
  std::size_t CulledCount = 0;
  bool BackdropCulled = false;
  std::vector<vtkProp*> Others, Array;
};
