// What a user can do, one row per action: its text, keys and tool tip. Menus and tool bars arrange actions; the part
// that carries one out connects itself to it.
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QObject>
#include <QStringList>
#include <vector>

class QMenuBar;
class QWidget;

namespace boxprobe {

class Actions : public QObject {
  Q_OBJECT

  enum Start { Off, On };

 public:
  explicit Actions(QMenuBar* bar);

  QAction* const open = add(tr("&Open..."), "Ctrl+O");
  QAction* const reload = add(tr("&Reload"), "Ctrl+Shift+O");
  QAction* const sky = add(tr("S&ky from a picture..."));
  QAction* const save = add(tr("&Save"), "Ctrl+S");
  QAction* const saveAs = add(tr("Save &as..."), "Ctrl+Shift+S");
  QAction* const exportImage = add(tr("&Export image..."), "Ctrl+E");
  QAction* const exportProbes = add(tr("Export &probes..."));
  QAction* const liveLink = addSwitch(Off, tr("&Live link..."));
  QAction* const saveBaked = add(tr("Save &baked probes..."));
  QAction* const report =
      add(tr("Repor&t..."), "",
          tr("One HTML file: every camera drawn and path traced, the probes with their fit and cost"));
  QAction* const quit = add(tr("&Quit"), "Ctrl+Q");

  QAction* const undo = add(tr("&Undo"), "Ctrl+Z");
  QAction* const redo = add(tr("&Redo"), "Ctrl+Shift+Z; Ctrl+Y");
  QAction* const addProbe = add(tr("&Add probe"), "Ctrl+Shift+A");
  QAction* const duplicate = add(tr("&Duplicate probe"), "Ctrl+D");
  QAction* const remove = add(tr("De&lete probe"), "Del");
  QAction* const copy = add(tr("&Copy probe"), "Ctrl+C");
  QAction* const paste = add(tr("&Paste probes"), "Ctrl+V");
  QAction* const selectAll = add(tr("&Select all probes"), "Ctrl+A");
  QAction* const selectHere =
      add(tr("Select the probe &here"), "Shift+P", tr("The probe that lights the place where the camera stands"));
  QAction* const fit = add(tr("&Fit box"), "Ctrl+F");
  QAction* const place = add(tr("&Place probes"), "Ctrl+Shift+F");
  QAction* const bake = add(tr("&Bake probe"), "F5");
  QAction* const bakeAll = add(tr("Ba&ke all probes"), "Shift+F5");
  QAction* const escape = add(tr("Cancel the drag or stop capturing"), "Esc");

  QAction* const resetView = add(tr("&Reset view"), "Home");
  QAction* const frame = add(tr("&Frame the selection"), "F");
  QAction* const lookFrom = add(tr("&Look from the probe"), "P");
  QAction* const walk = addSwitch(Off, tr("&Walk at eye height"), "G", {}, "walk");
  QAction* const hide = add(tr("&Hide the selection"), "H",
                            tr("In this window alone; the scene's file, captures and exported pictures have it"));
  QAction* const showAll = add(tr("Show &all hidden"), "Alt+H");
  QAction* const isolate =
      add(tr("&Isolate the selection"), "/",
          tr("Of a probe: with the objects that reach into its box. Once more shows the others again"));
  QAction* const cutaway =
      addSwitch(Off, tr("Cu&t away what hides the probe's box"), "Alt+B",
                tr("Looks into a room from outside. Exported pictures, errors and captures are not cut"), "cutaway");
  QAction* const hold = add(tr("&Hold this picture"), "C");
  QAction* const trace = add(tr("With &all light, path traced"), "Shift+C");
  QAction* const traceReflection = add(tr("With the &reflection alone ray traced"));
  QAction* const traceError = add(tr("&Error against all light, path traced"), "Shift+V");
  QAction* const difference = addSwitch(Off, tr("The &difference in false colours"), "Ctrl+Shift+D");
  QAction* const flip = addSwitch(Off, tr("&Flip to the other picture"), "V");
  QAction* const sideBySide = addSwitch(Off, tr("Four &views side by side"), "Alt+C");
  QAction* const stopComparing = add(tr("&Stop comparing"));
  QAction* const brighter = add(tr("&Brighter"), "]");
  QAction* const darker = add(tr("&Darker"), "[");
  QAction* const expose = add(tr("&Expose automatically"));
  QAction* const skyLeft = add(tr("To the &left"), "Alt+Left");
  QAction* const skyRight = add(tr("To the &right"), "Alt+Right");
  QAction* const groundShadow = addSwitch(On, tr("Ground shado&w"));
  QAction* const ambientOcclusion = addSwitch(On, tr("Ambient occl&usion"));
  QAction* const boxes = addSwitch(On, tr("Probe &boxes and handles"), "Ctrl+B", {}, "showBoxes");
  QAction* const reflections = addSwitch(On, tr("Re&flections from probes"), "Ctrl+R", {}, "showReflections");
  QAction* const motionPreview =
      addSwitch(Off, tr("C&heaper techniques while moving"), "",
                tr("Draws expensive techniques by a cheaper one while the camera or a handle moves"));
  QAction* const refinement = addSwitch(
      On, tr("Refi&ne at rest"), "",
      tr("While nothing moves, reflections go on to what rays of the whole lobe show, whatever the technique"));
  QAction* const projector = addSwitch(Off, tr("&Projector: the picture and the lesson alone"), "F11");

  QAction* const explain = addSwitch(Off, tr("&Explain pixels"), "E");
  QAction* const copyText = add(tr("&Copy explanation as text"), "Ctrl+Shift+C");
  QAction* const copyJson = add(tr("Copy explanation as &JSON"), "Ctrl+Shift+J");
  QAction* const saveRays = add(tr("Save &rays..."));
  QAction* const counters = addSwitch(Off, tr("&Work counters in the status bar"), "", {}, "countersShown");

  QAction* const lessons = add(tr("&Lessons..."), "F1");
  // With Shift where the layout has it above another letter.
  QAction* const keys = addSwitch(Off, tr("&Keys over the picture"), "?; Shift+?");
  QAction* const about = add(tr("&Mouse and keys, about"), "Shift+F1");

  // One of several, whose place in its list is its data().
  QActionGroup* const handleModes = addChoices({tr("&Box"), tr("&Influence"), tr("&Origin"), tr("&Move and turn")});
  QActionGroup* const axes = new QActionGroup(this);  ///< to look along, in the order of kBoxFaces
  QActionGroup* const tones =                         ///< in the order of Tone
      addChoices({tr("N&one"), tr("Khronos PBR &Neutral"), tr("&AgX"), tr("A&CES")});
  QActionGroup* const backgrounds =  ///< in the order of Background
      addChoices({tr("&Environment"), tr("&Blurred environment"), tr("&Grey"), tr("&Colour...")});
  QActionGroup* const themes =  ///< in the order of Theme
      addChoices({tr("As the &desktop has it"), tr("D&ark"), tr("&Light")});
  QActionGroup* const surfaceViews = new QActionGroup(this);  ///< of boxprobe::surfaceViews(), the picture itself first

  // Filled by whoever carries out what they offer; docks add themselves to the view.
  QMenu* const view = addMenu(tr("&View"));
  QMenu* const recent = addMenu(tr("Open &recent"));
  QMenu* const history = addMenu(tr("&History"), "history");
  QMenu* const cameras = addMenu(tr("&Camera"), "cameras");
  QMenu* const variants = addMenu(tr("&Material variant"), "variants");

  /// What can be done with the selected probe, for other menus.
  std::vector<QAction*> ofProbe() const { return {frame, lookFrom, fit, bake, duplicate, copy, remove}; }
  /// Those of them that act on the probe even while an object is selected.
  std::vector<QAction*> ofProbeBesideObject() const { return {lookFrom, fit, bake, copy}; }

 private:
  /// `shortcuts`: one or several, apart by "; ".
  QAction* add(const QString& text, const char* shortcuts = "", const QString& tip = {});
  QAction* addSwitch(Start start, const QString& text, const char* shortcuts = "", const QString& tip = {},
                     const char* name = "");
  QActionGroup* addChoices(const QStringList& texts);
  QAction* addChoice(QActionGroup* group, const QString& text, const QString& shortcut = {});
  QMenu* addMenu(const QString& title, const char* name = "");
};

/// Marks the choice at that place, as if it had been chosen already: nobody is told.
void showChoice(const QActionGroup* group, int place);

}  // namespace boxprobe
