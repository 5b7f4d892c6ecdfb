// See key_list.h.
#include "app/gui/window/key_list.h"

#include <QCoreApplication>
#include <initializer_list>
#include <utility>

namespace boxprobe {

QString keyTable() {
  const auto translated = [](const char* text) { return QCoreApplication::translate("Keys", text); };
  static constexpr std::pair<const char*, const char*> kRows[] = {
      {QT_TRANSLATE_NOOP("Keys", "Drag a ball, cube or arrow"),
       QT_TRANSLATE_NOOP("Keys", "moves a face, a blend distance, the probe; rings turn it")},
      {QT_TRANSLATE_NOOP("Keys", "Drag the diamond"),
       QT_TRANSLATE_NOOP("Keys", "moves the capture origin; X, Y, Z held: along that axis")},
      {QT_TRANSLATE_NOOP("Keys", "Shift, Ctrl, Alt while dragging"),
       QT_TRANSLATE_NOOP("Keys", "finely; onto walls or the grid; both sides")},
      {QT_TRANSLATE_NOOP("Keys", "1, 2, 3, 4"),
       QT_TRANSLATE_NOOP("Keys", "handles of box, influence, origin; move and turn")},
      {QT_TRANSLATE_NOOP("Keys", "Arrows, Page up, Page down"),
       QT_TRANSLATE_NOOP("Keys", "nudge by 10 cm, with Shift by 1 cm; in a lesson: turn its pages")},
      {QT_TRANSLATE_NOOP("Keys", "Click; with Ctrl"),
       QT_TRANSLATE_NOOP("Keys", "selects a probe, an object and its material; several probes, Ctrl+A all")},
      {QT_TRANSLATE_NOOP("Keys", "Double click; Shift+P"),
       QT_TRANSLATE_NOOP("Keys", "selects the probe that lights this place; where the camera stands")},
      {QT_TRANSLATE_NOOP("Keys", "[ and ]"), QT_TRANSLATE_NOOP("Keys", "exposure: darker, brighter")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+Shift and drag; Alt+Left, Right"),
       QT_TRANSLATE_NOOP("Keys", "turns the sky's picture; by 5 degrees")},
      {QT_TRANSLATE_NOOP("Keys", "Right click"), QT_TRANSLATE_NOOP("Keys", "what can be done here")},
      {QT_TRANSLATE_NOOP("Keys", "Drag elsewhere"),
       QT_TRANSLATE_NOOP("Keys", "turns about the point under the pointer")},
      {QT_TRANSLATE_NOOP("Keys", "Middle button, or Shift"), QT_TRANSLATE_NOOP("Keys", "moves the view")},
      {QT_TRANSLATE_NOOP("Keys", "Wheel; Ctrl and drag"), QT_TRANSLATE_NOOP("Keys", "zooms to the pointer; zooms")},
      {QT_TRANSLATE_NOOP("Keys", "Right button held"),
       QT_TRANSLATE_NOOP("Keys", "looks around; with W A S D, E, Q flies, the wheel sets the pace")},
      {QT_TRANSLATE_NOOP("Keys", "W A S D, G"),
       QT_TRANSLATE_NOOP("Keys", "fly, Shift faster; walk at eye height on and off")},
      {QT_TRANSLATE_NOOP("Keys", "F, P, Home"),
       QT_TRANSLATE_NOOP("Keys", "frame the selection; look from the probe; first camera")},
      {QT_TRANSLATE_NOOP("Keys", "H, Alt+H, /, Alt+B"),
       QT_TRANSLATE_NOOP("Keys", "hide the selection; show all; the selection alone; cut away what stands before it")},
      {QT_TRANSLATE_NOOP("Keys", "Alt+X, Y, Z; with Shift"),
       QT_TRANSLATE_NOOP("Keys", "look along an axis; from its other side")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+1 ... 9, Ctrl+K"),
       QT_TRANSLATE_NOOP("Keys", "the scene's cameras; store this view")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+Z; Ctrl+Shift+Z, Ctrl+Y"), QT_TRANSLATE_NOOP("Keys", "undo; redo")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+C, Ctrl+V, Ctrl+D, Delete"),
       QT_TRANSLATE_NOOP("Keys", "copy, paste, duplicate, delete the selected probes")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+F, Ctrl+Shift+F"),
       QT_TRANSLATE_NOOP("Keys", "fit the box; place probes in all rooms")},
      {QT_TRANSLATE_NOOP("Keys", "F5, Shift+F5"), QT_TRANSLATE_NOOP("Keys", "bake the selected probes, all probes")},
      {QT_TRANSLATE_NOOP("Keys", "Ctrl+B, Ctrl+R"),
       QT_TRANSLATE_NOOP("Keys", "boxes and handles, reflections on and off")},
      {QT_TRANSLATE_NOOP("Keys", "C, Shift+C, V"),
       QT_TRANSLATE_NOOP("Keys", "compare with this picture, with all light ray traced; flip")},
      {QT_TRANSLATE_NOOP("Keys", "Alt+C"),
       QT_TRANSLATE_NOOP("Keys",
                         "four views side by side: techniques, ray traced, before, baked, live; with their errors")},
      {QT_TRANSLATE_NOOP("Keys", "Shift+V, Ctrl+Shift+D"),
       QT_TRANSLATE_NOOP("Keys", "the error against all light ray traced; the difference in false colours")},
      {QT_TRANSLATE_NOOP("Keys", "E"),
       QT_TRANSLATE_NOOP("Keys", "explain the pixel under the pointer; a click pins it")},
      {QT_TRANSLATE_NOOP("Keys", "Esc"),
       QT_TRANSLATE_NOOP("Keys", "cancels the drag, ends the comparison or stops capturing")},
      {QT_TRANSLATE_NOOP("Keys", "?, F1, F11"), QT_TRANSLATE_NOOP("Keys", "these keys; the lessons; projector mode")},
  };
  QString table = "<table>";
  for (const auto& [what, does] : kRows) {
    table += QString("<tr><td style='padding-right:14px'><b>%1</b></td><td>%2</td></tr>")
                 .arg(translated(what), translated(does));
  }
  return table + "</table>";
}

}  // namespace boxprobe
