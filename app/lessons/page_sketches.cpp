// See page_sketches.h.
#include "app/lessons/page_sketches.h"

#include <algorithm>

namespace boxprobe {

const std::vector<PageSketch>& pageSketches() {
  static const std::vector<PageSketch> sketches = {
      {PageSketch::Cone, "cone", "From cone to texels",
       "The ray from P is reflected to the wall, and a rough floor spreads it into a cone. The cone meets a patch of "
       "the wall (orange). C sees the patch under another angle (pink), and so another mip level is right. Which one, "
       "when P is near the wall and when it is far? Draw it into the chart before you look.",
       true},
      {PageSketch::Surface, "fresnel", "How much is reflected",
       "Drag the eye down to the surface. The arrows are as long as the shares of light they carry: orange is "
       "reflected, pink is let in. How far down must the eye be until half is reflected?",
       false},
      {PageSketch::Surface, "lobe", "Where a rough surface sends its light",
       "Drag the eye and change the roughness. The lobe is GGX with Smith's term, in the plane of the eye. Is it "
       "brightest in the mirrored direction?",
       false},
      {PageSketch::Surface, "glass", "Reflected and let in",
       "Drag the eye, and change the index of refraction. From within the glass there is an angle beyond which nothing "
       "gets out. Find it for n = 1.5.",
       false},
      {PageSketch::Plan, "ball", "Painted, or a mirror?",
       "Choose how the ball samples the cubemap that was captured at C, then drag the eye, the ball and C. The upper "
       "half of the strip is what the eye sees on the ball, the lower half what it should see. Which of the three "
       "follow the eye, and which one stays right wherever the ball is?",
       false},
      {PageSketch::Plan, "impostor", "What did C see?",
       "The box knows walls, and the captured distances know what C saw. Drag C, the table top and P. Find a place for "
       "C from which as little as possible of what the floor mirrors is hidden. What becomes of the box's error there?",
       false},
      {PageSketch::Plan, "mirrors", "How often must it be captured?",
       "Two mirrors face each other. Each capture adds one reflection, so a ray that needs more ends in black. Move "
       "the eye from one mirror to the other, then change the share. What decides how many bounces are needed?",
       false},
      {PageSketch::Plan, "harmonics", "How much do nine numbers know?",
       "One lamp, all else is dark. Drag the lamp, its edge and the surface's normal. Make the lamp small: which light "
       "do nine numbers invent? Make it half of all directions: are four numbers enough?",
       false},
      {PageSketch::Plan, "seam", "Across the edge",
       "Drag the texels up and down, and choose how they are looked up. If each face is looked up by itself, when does "
       "the edge show? What does the fix-up's smooth edge cost?",
       false},
      {PageSketch::Plan, "sky", "How far away is it?",
       "What is outside can hang at the window or be infinitely far. Move it away and compare the lookup through the "
       "box with R alone. From what distance on is R alone the better one? What does C change?",
       true},
      {PageSketch::Plan, "screen", "What the screen knows",
       "Rays that end on what the picture shows are found in the picture. Drag the eye, where it looks, and the table "
       "top. Where do the screen and the box help each other, and what is left that neither has?",
       false},
      {PageSketch::Plan, "round", "A corner without a kink",
       "Drag the end of the ray through a corner and watch the distance. Then change the radius, by the handle on the "
       "box's edge. Where else does the distance change?",
       false},
      {PageSketch::Plan, "corner", "Why the corner glows",
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
