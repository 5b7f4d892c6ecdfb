// See page_sketches.h.
#include "app/lessons/page_sketches.h"

#include <algorithm>

namespace boxprobe {

const std::vector<PageSketch>& pageSketches() {
  static const std::vector<PageSketch> sketches = {
      {"ball", "Painted, or a mirror?",
       "Choose how the ball samples the cubemap that was captured at C, then drag the eye, the ball and C. The upper "
       "half of the strip is what the eye sees on the ball, the lower half what it should see. Which of the three "
       "follows the eye, and which one the ball as well?",
       false},
      {"impostor", "What did C see?",
       "The box knows walls, and the captured distances know what C saw. Drag C, the table top and P. Find a place for "
       "C from which nothing of what the floor mirrors is hidden, and see what becomes of the box's error there.",
       false},
      {"mirrors", "How often must it be captured?",
       "Two mirrors face each other. Each capture adds one reflection, so a ray that needs more ends in black. Bring "
       "the mirrors together: how many bounces are needed until no more than a hundredth of the light is missing?",
       false},
      {"harmonics", "How much do nine numbers know?",
       "One lamp, all else is dark. Drag the lamp, its edge and the surface's normal. Make the lamp small: which light "
       "do nine numbers invent? Make it half of all directions: are four numbers enough?",
       false},
      {"seam", "Across the edge",
       "Drag the texels up and down, and choose how they are looked up. When does an edge show that is looked up face "
       "by face? What does the fix-up pay for its smooth edge?",
       false},
      {"sky", "How far away is it?",
       "What is outside can hang at the window or be infinitely far. Move it away and compare the lookup through the "
       "box with R alone. From what distance on is R alone the better one? What does C change?",
       true},
      {"screen", "What the screen knows",
       "Rays that end on what the picture shows are found in the picture. Drag the eye, where it looks, and the table "
       "top. Where do the screen and the box help each other, and what is left that neither has?",
       false},
      {"round", "A corner without a kink",
       "Drag the end of the ray through a corner and watch the distance. Then change the radius, by the handle on the "
       "box's edge. Where else does the distance change?",
       true},
      {"corner", "Why the corner glows",
       "P sees little but the dark wall, and one level of the cubemap is a mean over far more. Drag P out of the "
       "corner, then change m and u. Is there a pair that is right in the corner and in the middle?",
       false}};
  return sketches;
}

const PageSketch* findPageSketch(const std::string& name) {
  const auto& all = pageSketches();
  const auto found = std::find_if(all.begin(), all.end(), [&](const PageSketch& s) { return s.name == name; });
  return found != all.end() ? &*found : nullptr;
}

}  // namespace boxprobe
