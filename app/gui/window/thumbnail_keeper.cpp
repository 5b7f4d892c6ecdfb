// See thumbnail_keeper.h.
#include "app/gui/window/thumbnail_keeper.h"

#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/thumbnails.h"
#include "app/session/opened_glb.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

ThumbnailKeeper::ThumbnailKeeper(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  constexpr int kMilliseconds = 700;
  later_.setInterval(kMilliseconds);
  connect(&later_, &QTimer::timeout, this, &ThumbnailKeeper::look);
  connect(&workspace, &Workspace::filed, this, &ThumbnailKeeper::opened);
}

QString ThumbnailKeeper::path() const {
  const Document& document = workspace_.document();
  return workspace_.lesson() != nullptr ? QString()
                                        : QString::fromStdString(ownPathOf(document.path(), document.scene()));
}

bool ThumbnailKeeper::rests() const {
  const SceneRenderer& renderer = workspace_.renderer();
  const bool plain = renderer.view().view == 0 && !workspace_.state().anyHidden() && !workspace_.state().isolated();
  return plain && workspace_.viewport().readyToDraw() && !renderer.workPending() && !workspace_.document().previewing();
}

void ThumbnailKeeper::opened() {
  due_ = path();
  looks_ = 0;
  if (!due_.isEmpty()) later_.start();
}

void ThumbnailKeeper::look() {
  const QString path = this->path();
  if (path.isEmpty()) return;     // a lesson's: until the own scene is back
  constexpr int kMostLooks = 90;  // about a minute
  const bool rests = this->rests();
  if (path == due_ && !rests && ++looks_ < kMostLooks) return;
  later_.stop();
  if (path == due_ && rests) keepThumbnail(path, workspace_.viewport().grabFramebuffer());
}

}  // namespace boxprobe
