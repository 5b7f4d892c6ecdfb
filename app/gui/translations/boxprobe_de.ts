<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccessibleNames</name>
    <message>
        <source>More menus</source>
        <translation>Weitere Menüs</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>Weitere Werkzeuge</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>Abkoppeln</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
</context>
<context>
    <name>BakeState</name>
    <message>
        <source>Follows the scene</source>
        <translation>Folgt der Szene</translation>
    </message>
    <message>
        <source>Custom image %1</source>
        <translation>Eigenes Bild %1</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Not used: its influence box reaches no visible object</source>
        <translation>Nicht verwendet: ihre Einflussbox erreicht kein sichtbares Objekt</translation>
    </message>
    <message>
        <source>Out of date: capturing was stopped</source>
        <translation>Veraltet: Aufnahme wurde gestoppt</translation>
    </message>
    <message>
        <source>Waiting for an image</source>
        <translation>Wartet auf ein Bild</translation>
    </message>
    <message>
        <source>Out of date: waiting for capture</source>
        <translation>Veraltet: wartet auf Aufnahme</translation>
    </message>
    <message>
        <source>Filtering the image</source>
        <translation>Bild wird gefiltert</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translation>Wird aufgenommen</translation>
    </message>
    <message>
        <source>Loaded from disk, up to date</source>
        <translation>Von der Platte geladen, aktuell</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <source>As this probe is filtered</source>
        <translation>Wie diese Sonde gefiltert ist</translation>
    </message>
    <message>
        <source>The right one: rough surfaces get the blur that belongs to them</source>
        <translation>Die richtige: raue Oberflächen bekommen die Unschärfe, die zu ihnen gehört</translation>
    </message>
    <message>
        <source>As Unity</source>
        <translation>Wie Unity</translation>
    </message>
    <message>
        <source>To see the difference: the curve that Unity samples its probes by</source>
        <translation>Zum Vergleich: die Kurve, nach der Unity seine Sonden abtastet</translation>
    </message>
    <message>
        <source>In proportion</source>
        <translation>Proportional</translation>
    </message>
    <message>
        <source>To see the difference: the level in proportion to the roughness</source>
        <translation>Zum Vergleich: die Stufe proportional zur Rauheit</translation>
    </message>
    <message>
        <source>Unity&apos;s, exactly</source>
        <translation>Genau wie Unity</translation>
    </message>
    <message>
        <source>To see the difference: what Unity&apos;s curve approximates</source>
        <translation>Zum Vergleich: was die Kurve von Unity annähert</translation>
    </message>
    <message>
        <source>As Marmoset</source>
        <translation>Wie Marmoset</translation>
    </message>
    <message>
        <source>To see the difference: Marmoset&apos;s curve, blurred sooner</source>
        <translation>Zum Vergleich: die Kurve von Marmoset, früher unscharf</translation>
    </message>
    <message>
        <source>Three steps of blur</source>
        <translation>Drei Stufen der Unschärfe</translation>
    </message>
    <message>
        <source>To see the difference: sharp, half and wholly blurred maps, mixed</source>
        <translation>Zum Vergleich: scharfe, halb und ganz unscharfe Maps, gemischt</translation>
    </message>
    <message>
        <source>By the power above</source>
        <translation>Mit der Potenz oben</translation>
    </message>
    <message>
        <source>The surface&apos;s own</source>
        <translation>Die der Oberfläche</translation>
    </message>
    <message>
        <source>Along the surface&apos;s lobe</source>
        <translation>Entlang der Keule der Oberfläche</translation>
    </message>
    <message>
        <source>Half of them towards what is bright</source>
        <translation>Zur Hälfte auf das Helle gerichtet</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>ExplanationHtml</name>
    <message>
        <source>smallest</source>
        <translation>kleinster</translation>
    </message>
    <message>
        <source>Lengths in scene units, directions without, colours linear; swatches as the picture shows them.</source>
        <translation>Längen in Szeneneinheiten, Richtungen ohne Einheit, Farben linear; Farbfelder, wie das Bild sie zeigt.</translation>
    </message>
</context>
<context>
    <name>FieldForm</name>
    <message>
        <source>%1 Default: %2</source>
        <translation>%1 Standard: %2</translation>
    </message>
</context>
<context>
    <name>Handles</name>
    <message>
        <source>size %1 × %2 × %3 %4</source>
        <translation>Größe %1 × %2 × %3 %4</translation>
    </message>
    <message>
        <source>influence %1  %2 %3</source>
        <translation>Einfluss %1  %2 %3</translation>
    </message>
    <message>
        <source>blend %1  %2 %3</source>
        <translation>Überblendung %1  %2 %3</translation>
    </message>
    <message>
        <source>moved by %1 %2</source>
        <translation>bewegt um %1 %2</translation>
    </message>
    <message>
        <source>rotation
%1°  %2°  %3°</source>
        <translation>Drehung
%1°  %2°  %3°</translation>
    </message>
    <message>
        <source>origin
%1  %2  %3 %4</source>
        <translation>Ursprung
%1  %2  %3 %4</translation>
    </message>
    <message>
        <source>steps of %1°</source>
        <translation>Schritte von %1°</translation>
    </message>
    <message>
        <source>on the wall under the pointer</source>
        <translation>auf der Wand unter dem Zeiger</translation>
    </message>
    <message>
        <source>on the wall ahead</source>
        <translation>auf der Wand voraus</translation>
    </message>
    <message>
        <source>grid %1 %2</source>
        <translation>Raster %1 %2</translation>
    </message>
    <message>
        <source> Shift: finely. Ctrl: onto the wall under the pointer, or the grid. Alt: both sides.</source>
        <translation> Umschalt: fein. Strg: an die Wand unter dem Zeiger oder das Raster. Alt: beide Seiten.</translation>
    </message>
    <message>
        <source>Drag to move face %1 of %2.</source>
        <translation>Ziehen bewegt Fläche %1 von %2.</translation>
    </message>
    <message>
        <source>Drag to move face %1 of the influence box of %2.</source>
        <translation>Ziehen bewegt Fläche %1 der Einflussbox von %2.</translation>
    </message>
    <message>
        <source>Drag to set over what distance %2 fades towards %1.</source>
        <translation>Ziehen bestimmt, über welche Strecke %2 zu %1 hin ausblendet.</translation>
    </message>
    <message>
        <source>Drag to move the capture origin of %2 along %1. Shift: finely. Ctrl: grid.</source>
        <translation>Ziehen bewegt den Aufnahmeursprung von %2 entlang %1. Umschalt: fein. Strg: Raster.</translation>
    </message>
    <message>
        <source>Drag to move all of %2 along its %1. Shift: finely. Ctrl: grid.</source>
        <translation>Ziehen bewegt ganz %2 entlang der eigenen Achse %1. Umschalt: fein. Strg: Raster.</translation>
    </message>
    <message>
        <source>Drag to turn all of %2 about its %1. Shift: finely. Ctrl: by 15 degrees.</source>
        <translation>Ziehen dreht ganz %2 um die eigene Achse %1. Umschalt: fein. Strg: um 15 Grad.</translation>
    </message>
    <message>
        <source>Click to select probe %1. Ctrl: beside those that are selected.</source>
        <translation>Klick wählt Sonde %1. Strg: zusätzlich zu den ausgewählten.</translation>
    </message>
    <message>
        <source>Drag to move the capture origin of %1. X, Y, Z: along that axis. Shift: finely. Ctrl: grid.</source>
        <translation>Ziehen bewegt den Aufnahmeursprung von %1. X, Y, Z: entlang dieser Achse. Umschalt: fein. Strg: Raster.</translation>
    </message>
    <message>
        <source>Move face %1 of %2</source>
        <translation>Fläche %1 von %2 bewegen</translation>
    </message>
    <message>
        <source>Move influence face %1 of %2</source>
        <translation>Einflussfläche %1 von %2 bewegen</translation>
    </message>
    <message>
        <source>Set blend distance %1 of %2</source>
        <translation>Überblendstrecke %1 von %2 setzen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Move origin of %1</source>
        <translation>Ursprung von %1 bewegen</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Drag a ball, cube or arrow</source>
        <translation>Kugel, Würfel oder Pfeil ziehen</translation>
    </message>
    <message>
        <source>moves a face, a blend distance, the probe; rings turn it</source>
        <translation>verschiebt eine Fläche, eine Überblendstrecke, die Sonde; Ringe drehen sie</translation>
    </message>
    <message>
        <source>Drag the diamond</source>
        <translation>Die Raute ziehen</translation>
    </message>
    <message>
        <source>moves the capture origin; X, Y, Z held: along that axis</source>
        <translation>verschiebt den Aufnahmeursprung; X, Y, Z gehalten: entlang dieser Achse</translation>
    </message>
    <message>
        <source>Shift, Ctrl, Alt while dragging</source>
        <translation>Umschalt, Strg, Alt beim Ziehen</translation>
    </message>
    <message>
        <source>finely; onto walls or the grid; both sides</source>
        <translation>fein; an Wände oder Raster; beide Seiten</translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation>1, 2, 3, 4</translation>
    </message>
    <message>
        <source>handles of box, influence, origin; move and turn</source>
        <translation>Griffe für Box, Einfluss, Ursprung; bewegen und drehen</translation>
    </message>
    <message>
        <source>Arrows, Page up, Page down</source>
        <translation>Pfeiltasten, Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>nudge by 10 cm, with Shift by 1 cm; in a lesson: turn its pages</source>
        <translation>um 10 cm verschieben, mit Umschalt um 1 cm; in einer Lektion: blättern</translation>
    </message>
    <message>
        <source>Click; with Ctrl</source>
        <translation>Klick; mit Strg</translation>
    </message>
    <message>
        <source>selects a probe, an object and its material; several probes, Ctrl+A all</source>
        <translation>wählt eine Sonde, ein Objekt und sein Material; mehrere Sonden, Strg+A alle</translation>
    </message>
    <message>
        <source>Double click; Shift+P</source>
        <translation>Doppelklick; Umschalt+P</translation>
    </message>
    <message>
        <source>selects the probe that lights this place; where the camera stands</source>
        <translation>wählt die Sonde, die diese Stelle beleuchtet; wo die Kamera steht</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ und ]</translation>
    </message>
    <message>
        <source>exposure: darker, brighter</source>
        <translation>Belichtung: dunkler, heller</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>what can be done here</source>
        <translation>was hier getan werden kann</translation>
    </message>
    <message>
        <source>Drag elsewhere</source>
        <translation>An anderer Stelle ziehen</translation>
    </message>
    <message>
        <source>turns about the point under the pointer</source>
        <translation>dreht um den Punkt unter dem Zeiger</translation>
    </message>
    <message>
        <source>Middle button, or Shift</source>
        <translation>Mittlere Taste oder Umschalt</translation>
    </message>
    <message>
        <source>moves the view</source>
        <translation>verschiebt die Ansicht</translation>
    </message>
    <message>
        <source>Wheel; Ctrl and drag</source>
        <translation>Mausrad; Strg und ziehen</translation>
    </message>
    <message>
        <source>zooms to the pointer; zooms</source>
        <translation>zoomt zum Zeiger; zoomt</translation>
    </message>
    <message>
        <source>Right button held</source>
        <translation>Rechte Taste gehalten</translation>
    </message>
    <message>
        <source>looks around; with W A S D, E, Q flies, the wheel sets the pace</source>
        <translation>blickt umher; mit W A S D, E, Q fliegen, das Mausrad bestimmt das Tempo</translation>
    </message>
    <message>
        <source>W A S D, G</source>
        <translation>W A S D, G</translation>
    </message>
    <message>
        <source>fly, Shift faster; walk at eye height on and off</source>
        <translation>fliegen, Umschalt schneller; Gehen auf Augenhöhe ein und aus</translation>
    </message>
    <message>
        <source>F, P, Home</source>
        <translation>F, P, Pos1</translation>
    </message>
    <message>
        <source>frame the selection; look from the probe; first camera</source>
        <translation>Auswahl einpassen; von der Sonde aus blicken; erste Kamera</translation>
    </message>
    <message>
        <source>H, Alt+H, /, Alt+B</source>
        <translation>H, Alt+H, /, Alt+B</translation>
    </message>
    <message>
        <source>hide the selection; show all; the selection alone; cut away what stands before it</source>
        <translation>Auswahl ausblenden; alles zeigen; nur die Auswahl; wegschneiden, was sie verdeckt</translation>
    </message>
    <message>
        <source>Alt+X, Y, Z; with Shift</source>
        <translation>Alt+X, Y, Z; mit Umschalt</translation>
    </message>
    <message>
        <source>look along an axis; from its other side</source>
        <translation>entlang einer Achse blicken; von ihrer anderen Seite</translation>
    </message>
    <message>
        <source>Ctrl+1 ... 9, Ctrl+K</source>
        <translation>Strg+1 ... 9, Strg+K</translation>
    </message>
    <message>
        <source>the scene&apos;s cameras; store this view</source>
        <translation>Kameras der Szene; diese Ansicht speichern</translation>
    </message>
    <message>
        <source>Ctrl+Z; Ctrl+Shift+Z, Ctrl+Y</source>
        <translation>Strg+Z; Strg+Umschalt+Z, Strg+Y</translation>
    </message>
    <message>
        <source>undo; redo</source>
        <translation>rückgängig; wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+D, Delete</source>
        <translation>Strg+C, Strg+V, Strg+D, Entf</translation>
    </message>
    <message>
        <source>copy, paste, duplicate, delete the selected probes</source>
        <translation>ausgewählte Sonden kopieren, einfügen, duplizieren, löschen</translation>
    </message>
    <message>
        <source>Ctrl+F, Ctrl+Shift+F</source>
        <translation>Strg+F, Strg+Umschalt+F</translation>
    </message>
    <message>
        <source>fit the box; place probes in all rooms</source>
        <translation>Box anpassen; Sonden in allen Räumen platzieren</translation>
    </message>
    <message>
        <source>F5, Shift+F5</source>
        <translation>F5, Umschalt+F5</translation>
    </message>
    <message>
        <source>bake the selected probes, all probes</source>
        <translation>ausgewählte Sonden backen, alle Sonden</translation>
    </message>
    <message>
        <source>Ctrl+B, Ctrl+R</source>
        <translation>Strg+B, Strg+R</translation>
    </message>
    <message>
        <source>boxes and handles, reflections on and off</source>
        <translation>Boxen und Griffe, Reflexionen ein und aus</translation>
    </message>
    <message>
        <source>C, Shift+C, V</source>
        <translation>C, Umschalt+C, V</translation>
    </message>
    <message>
        <source>compare with this picture, with all light ray traced; flip</source>
        <translation>mit diesem Bild vergleichen, mit allem Licht per Raytracing; wechseln</translation>
    </message>
    <message>
        <source>Alt+C</source>
        <translation>Alt+C</translation>
    </message>
    <message>
        <source>four views side by side: techniques, ray traced, before, baked, live; with their errors</source>
        <translation>vier Ansichten nebeneinander: Techniken, Raytracing, vorher, gebacken, live; mit ihren Fehlern</translation>
    </message>
    <message>
        <source>Shift+V, Ctrl+Shift+D</source>
        <translation>Umschalt+V, Strg+Umschalt+D</translation>
    </message>
    <message>
        <source>the error against all light ray traced; the difference in false colours</source>
        <translation>der Fehler gegen alles Licht per Raytracing; die Differenz in Falschfarben</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>explain the pixel under the pointer; a click pins it</source>
        <translation>den Pixel unter dem Zeiger erklären; ein Klick hält ihn fest</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>cancels the drag, ends the comparison or stops capturing</source>
        <translation>bricht das Ziehen ab, beendet den Vergleich oder stoppt die Aufnahme</translation>
    </message>
    <message>
        <source>?, F1, F11</source>
        <translation>?, F1, F11</translation>
    </message>
    <message>
        <source>these keys; the lessons; projector mode</source>
        <translation>diese Tasten; die Lektionen; Projektormodus</translation>
    </message>
    <message>
        <source>Ctrl+Shift and drag; Alt+Left, Right</source>
        <translation>Strg+Umschalt und ziehen; Alt+Links, Rechts</translation>
    </message>
    <message>
        <source>turns the sky&apos;s picture; by 5 degrees</source>
        <translation>dreht das Bild des Himmels; um 5 Grad</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>Languag&amp;e</source>
        <translation>Spr&amp;ache (Language)</translation>
    </message>
    <message>
        <source>Language: %1, when the window is opened the next time</source>
        <translation>Sprache: %1, wenn das Fenster das nächste Mal geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>The language of the system, if there is a translation</source>
        <translation>Die Sprache des Systems, wenn es eine Übersetzung gibt</translation>
    </message>
    <message>
        <source>Not yet reviewed by a native speaker; corrections are welcome</source>
        <translation>Noch nicht von einem Muttersprachler geprüft; Verbesserungen sind willkommen</translation>
    </message>
</context>
<context>
    <name>PictureDifference</name>
    <message>
        <source>light %1, RMSE %2</source>
        <translation>Licht %1, RMSE %2</translation>
    </message>
    <message>
        <source>, noise %1</source>
        <translation>, Rauschen %1</translation>
    </message>
</context>
<context>
    <name>PictureInset</name>
    <message>
        <source>from the side</source>
        <translation>von der Seite</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
</context>
<context>
    <name>QMainWindow</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1 of HDRP&apos;s</source>
        <translation>%1 von HDRP</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source> ms, </source>
        <translation> ms, </translation>
    </message>
    <message>
        <source>%1. Quartiles: %2 to %3 ms</source>
        <translation>%1. Quartile: %2 bis %3 ms</translation>
    </message>
    <message>
        <source>This translation has not been reviewed by a native speaker yet.</source>
        <translation>Diese Übersetzung wurde noch nicht von einem Muttersprachler geprüft.</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Boxprobe %1&lt;/h3&gt;&lt;p&gt;Reflection probes with box projection (parallax correction): move the box and the capture origin and watch the reflections follow.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Boxprobe %1&lt;/h3&gt;&lt;p&gt;Reflexionssonden mit Box-Projektion (Parallaxenkorrektur): Box und Aufnahmeursprung verschieben und sehen, wie die Reflexionen folgen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Orange: the projection box. Dashed: the probe has its full weight inside. Built on VTK, Qt, OpenEXR and GLM.</source>
        <translation>Orange: die Projektionsbox. Gestrichelt: darin hat die Sonde ihr volles Gewicht. Erstellt mit VTK, Qt, OpenEXR und GLM.</translation>
    </message>
    <message>
        <source>About Boxprobe</source>
        <translation>Über Boxprobe</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelling</source>
        <translation>Wird abgebrochen</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
</context>
<context>
    <name>RayRig</name>
    <message>
        <source>Move the pointer over a surface with the Explain tool on (E).</source>
        <translation>Mit eingeschaltetem Werkzeug Erklären (E) den Zeiger über eine Oberfläche bewegen.</translation>
    </message>
    <message>
        <source>Click surfaces with the Explain tool on (E).</source>
        <translation>Mit eingeschaltetem Werkzeug Erklären (E) Oberflächen anklicken.</translation>
    </message>
    <message>
        <source>Choose an object, or click one with the Explain tool on (E).</source>
        <translation>Ein Objekt wählen oder mit eingeschaltetem Werkzeug Erklären (E) eines anklicken.</translation>
    </message>
    <message>
        <source>Click the two ends with the Explain tool on (E).</source>
        <translation>Mit eingeschaltetem Werkzeug Erklären (E) die beiden Enden anklicken.</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>show rays in the debug dock first</source>
        <translation>erst die Strahlen im Reiter Debug einblenden</translation>
    </message>
    <message>
        <source>no rays are shown that could be saved to %1; %2</source>
        <translation>es werden keine Strahlen gezeigt, die in %1 gespeichert werden könnten; %2</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Boxprobe ended without saving %1. Its changes up to %2 can be recovered.</source>
        <translation>Boxprobe wurde beendet, ohne %1 zu speichern. Die Änderungen bis %2 lassen sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Nothing is written to the file itself until you save.</source>
        <translation>Die Datei selbst bleibt unverändert, bis Sie speichern.</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Discard them</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>&amp;Später fragen</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>The graphics driver was reset. Start Boxprobe again to see the scene.</source>
        <translation>Der Grafiktreiber wurde zurückgesetzt. Starten Sie Boxprobe neu, um die Szene zu sehen.</translation>
    </message>
    <message>
        <source>Unsaved changes are kept and offered after the start.</source>
        <translation>Ungespeicherte Änderungen sind gesichert und werden nach dem Start angeboten.</translation>
    </message>
    <message>
        <source>Unsaved changes could not be kept. Save the scene first.</source>
        <translation>Ungespeicherte Änderungen konnten nicht gesichert werden. Speichern Sie zuerst die Szene.</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>&amp;Neu starten</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Jetzt nicht</translation>
    </message>
</context>
<context>
    <name>SchematicPainter</name>
    <message>
        <source>from the eye</source>
        <translation>vom Auge</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>%1: cannot be read as settings; it is kept as %2, and settings start anew</source>
        <translation>%1: als Einstellungen nicht lesbar; bleibt als %2 erhalten, und die Einstellungen beginnen neu</translation>
    </message>
    <message>
        <source>%1: cannot be read as settings, nor renamed to %2; settings last until the window closes</source>
        <translation>%1: als Einstellungen nicht lesbar und nicht in %2 umbenennbar; Einstellungen gelten, bis das Fenster geschlossen wird</translation>
    </message>
</context>
<context>
    <name>Tables</name>
    <message>
        <source>Name of the probe; each has its own.</source>
        <translation>Name der Sonde; jede hat ihren eigenen.</translation>
    </message>
    <message>
        <source>Where the cubemap is captured.</source>
        <translation>Wo die Cubemap aufgenommen wird.</translation>
    </message>
    <message>
        <source>Projection box: its faces belong on the walls of the room.</source>
        <translation>Projektionsbox: ihre Flächen gehören auf die Wände des Raums.</translation>
    </message>
    <message>
        <source>Turns the box about its centre: X, then Y, then Z.</source>
        <translation>Dreht die Box um ihre Mitte: X, dann Y, dann Z.</translation>
    </message>
    <message>
        <source>Box that the probe lights, in the frame of the projection box.</source>
        <translation>Box, die die Sonde beleuchtet, im Bezugssystem der Projektionsbox.</translation>
    </message>
    <message>
        <source>the projection box</source>
        <translation>die Projektionsbox</translation>
    </message>
    <message>
        <source>Nothing nearer to the origin is captured.</source>
        <translation>Nichts, was dem Ursprung näher ist, wird aufgenommen.</translation>
    </message>
    <message>
        <source>Nothing farther from the origin is captured; more than `near`.</source>
        <translation>Nichts, was weiter vom Ursprung entfernt ist, wird aufgenommen; mehr als `near`.</translation>
    </message>
    <message>
        <source>What the probe holds where it sees no object.</source>
        <translation>Was die Sonde enthält, wo sie kein Objekt sieht.</translation>
    </message>
    <message>
        <source>the scene&apos;s sky, as the camera sees it</source>
        <translation>der Himmel der Szene, wie die Kamera ihn sieht</translation>
    </message>
    <message>
        <source>nothing: other probes, or the sky, fill in</source>
        <translation>nichts: andere Sonden oder der Himmel füllen auf</translation>
    </message>
    <message>
        <source>the current sky shows through, not box-projected; it may change without a recapture</source>
        <translation>der jetzige Himmel scheint durch, nicht auf die Box projiziert; er darf sich ohne neue Aufnahme ändern</translation>
    </message>
    <message>
        <source>Distance inside the influence box over which the probe&apos;s weight rises from 0 to 1.</source>
        <translation>Strecke innerhalb der Einflussbox, auf der das Gewicht der Sonde von 0 auf 1 steigt.</translation>
    </message>
    <message>
        <source>Where probes overlap, the more important one takes its share first.</source>
        <translation>Wo Sonden sich überlappen, nimmt die wichtigere ihren Anteil zuerst.</translation>
    </message>
    <message>
        <source>Factor on the probe&apos;s light; 1 is as captured.</source>
        <translation>Faktor auf das Licht der Sonde; 1 ist wie aufgenommen.</translation>
    </message>
    <message>
        <source>Off: looked up with the bare reflection vector, as if infinitely far away.</source>
        <translation>Aus: mit dem bloßen Reflexionsvektor abgefragt, wie unendlich fern.</translation>
    </message>
    <message>
        <source>Edge length of a cubemap face: larger is sharper and takes more memory.</source>
        <translation>Kantenlänge einer Cubemap-Fläche: größer ist schärfer und braucht mehr Speicher.</translation>
    </message>
    <message>
        <source>Captures in turn, each with the last one&apos;s light; with 1, mirrors are black in their own probe.</source>
        <translation>Aufnahmen nacheinander, jede mit dem Licht der vorigen; bei 1 sind Spiegel in ihrer eigenen Sonde schwarz.</translation>
    </message>
    <message>
        <source>until another changes the light they bring by less than 1 %, 16 at most</source>
        <translation>bis eine weitere ihr Licht um weniger als 1 % ändert, höchstens 16</translation>
    </message>
    <message>
        <source>Where the probe&apos;s light comes from.</source>
        <translation>Woher das Licht der Sonde kommt.</translation>
    </message>
    <message>
        <source>captured when an input changes, and kept</source>
        <translation>bei Änderung einer Eingabe aufgenommen und behalten</translation>
    </message>
    <message>
        <source>recaptured continuously, one face per frame; sees objects that move</source>
        <translation>laufend neu aufgenommen, eine Fläche je Frame; sieht bewegte Objekte</translation>
    </message>
    <message>
        <source>not captured: `image` takes the capture&apos;s place</source>
        <translation>nicht aufgenommen: `image` tritt an die Stelle der Aufnahme</translation>
    </message>
    <message>
        <source>How the surroundings lie in the image.</source>
        <translation>Wie die Umgebung im Bild liegt.</translation>
    </message>
    <message>
        <source>by the file&apos;s attributes, shape or name</source>
        <translation>nach den Attributen, der Form oder dem Namen der Datei</translation>
    </message>
    <message>
        <source>latitude-longitude, 2:1</source>
        <translation>Länge-Breite, 2:1</translation>
    </message>
    <message>
        <source>six faces in a row or column</source>
        <translation>sechs Flächen in einer Zeile oder Spalte</translation>
    </message>
    <message>
        <source>one file per face</source>
        <translation>eine Datei je Fläche</translation>
    </message>
    <message>
        <source>From where the faces of a cube in the image are seen.</source>
        <translation>Von wo die Flächen eines Würfels im Bild gesehen sind.</translation>
    </message>
    <message>
        <source>as OpenGL and engines lay a cubemap out: right of +Z is +X</source>
        <translation>wie OpenGL und Engines eine Cubemap anordnen: rechts von +Z liegt +X</translation>
    </message>
    <message>
        <source>as in a photograph: right of +Z is -X, what a viewer in the middle has there</source>
        <translation>wie auf einem Foto: rechts von +Z liegt -X, was ein Betrachter in der Mitte dort hat</translation>
    </message>
    <message>
        <source>Turns the image about the vertical, as `rotationDegrees` of the sky does: 90 takes +Z to +X.</source>
        <translation>Dreht das Bild um die Senkrechte, wie `rotationDegrees` des Himmels: 90 bringt +Z nach +X.</translation>
    </message>
    <message>
        <source>How the image&apos;s texels hold radiance.</source>
        <translation>Wie die Texel des Bildes Strahldichte enthalten.</translation>
    </message>
    <message>
        <source>radiance as it is: .exr, .hdr</source>
        <translation>Strahldichte, wie sie ist: .exr, .hdr</translation>
    </message>
    <message>
        <source>multiplier * M^exponent * colour, M in alpha, colour bytes sRGB: Unity&apos;s RGBM</source>
        <translation>Faktor * M^Exponent * Farbe, M im Alphakanal, Farbbytes sRGB: RGBM von Unity</translation>
    </message>
    <message>
        <source>multiplier * colour, colour bytes sRGB: Unity&apos;s double LDR</source>
        <translation>Faktor * Farbe, Farbbytes sRGB: Double LDR von Unity</translation>
    </message>
    <message>
        <source>as `rgbm`, the colour bytes linear</source>
        <translation>wie `rgbm`, die Farbbytes linear</translation>
    </message>
    <message>
        <source>Decode instruction of the encoding: multiplier and exponent.</source>
        <translation>Dekodierung der Kodierung: Faktor und Exponent.</translation>
    </message>
    <message>
        <source>How mip levels for rough surfaces are made from the capture.</source>
        <translation>Wie Mip-Stufen für raue Oberflächen aus der Aufnahme entstehen.</translation>
    </message>
    <message>
        <source>as the renderer&apos;s rough surfaces reflect</source>
        <translation>wie die rauen Oberflächen des Renderers reflektieren</translation>
    </message>
    <message>
        <source>an angular Gaussian of CubeMapGen&apos;s widths: a soft, frosted look</source>
        <translation>eine Gaußglocke über den Winkel mit den Breiten von CubeMapGen: weich, wie mattiert</translation>
    </message>
    <message>
        <source>Samples per captured texel: smoother edges, longer capture.</source>
        <translation>Samples je aufgenommenem Texel: glattere Kanten, längere Aufnahme.</translation>
    </message>
    <message>
        <source>Filter samples per texel at mip level 1, doubled with each level: smoother around lamps, longer filtering.</source>
        <translation>Filtersamples je Texel der Mip-Stufe 1, mit jeder Stufe doppelt so viele: glatter um Lampen, längeres Filtern.</translation>
    </message>
    <message>
        <source>Nodes this probe does not see, such as an object at its origin.</source>
        <translation>Knoten, die diese Sonde nicht sieht, etwa ein Objekt an ihrem Ursprung.</translation>
    </message>
    <message>
        <source>Rounds the edges of the projection box, so that reflections turn a corner instead of breaking at it.</source>
        <translation>Rundet die Kanten der Projektionsbox, sodass Reflexionen um die Ecke biegen, statt an ihr zu brechen.</translation>
    </message>
    <message>
        <source>sharp edges</source>
        <translation>scharfe Kanten</translation>
    </message>
    <message>
        <source>Darkens near reflections by mix(1, clamp(multiplier * d^power, 0, 1), strength), d metres along the reflected ray. A look; it makes no picture truer.</source>
        <translation>Dunkelt nahe Reflexionen mit mix(1, clamp(Faktor * d^Potenz, 0, 1), Stärke) ab, d Meter entlang des reflektierten Strahls. Ein Stilmittel; es macht kein Bild richtiger.</translation>
    </message>
    <message>
        <source>Least corner.</source>
        <translation>Kleinste Ecke.</translation>
    </message>
    <message>
        <source>Greatest corner; no component less than that of `min`.</source>
        <translation>Größte Ecke; keine Komponente kleiner als die von `min`.</translation>
    </message>
    <message>
        <source>Distances inside the -x, -y and -z faces.</source>
        <translation>Strecken innerhalb der Flächen -x, -y und -z.</translation>
    </message>
    <message>
        <source>Distances inside the +x, +y and +z faces.</source>
        <translation>Strecken innerhalb der Flächen +x, +y und +z.</translation>
    </message>
    <message>
        <source>Radius of the box&apos;s edges: reflections turn a corner instead of breaking at it; 0 is sharp.</source>
        <translation>Radius der Boxkanten: Reflexionen biegen um die Ecke, statt an ihr zu brechen; 0 ist scharf.</translation>
    </message>
    <message>
        <source>Radius added at roughness 1, in proportion to the roughness: rough surfaces show no edge.</source>
        <translation>Zusätzlicher Radius bei Rauheit 1, proportional zur Rauheit: raue Oberflächen zeigen keine Kante.</translation>
    </message>
    <message>
        <source>Openness at a distance of 1 m: 1 is fully open, 0.2 a fifth.</source>
        <translation>Offenheit in 1 m Abstand: 1 ist ganz offen, 0.2 ein Fünftel.</translation>
    </message>
    <message>
        <source>How fast it opens with distance: 1 in proportion, 0 not at all.</source>
        <translation>Wie schnell es sich mit dem Abstand öffnet: 1 proportional, 0 gar nicht.</translation>
    </message>
    <message>
        <source>Share of the darkening that is applied.</source>
        <translation>Anteil der Abdunklung, der angewendet wird.</translation>
    </message>
    <message>
        <source>Kind of light.</source>
        <translation>Art des Lichts.</translation>
    </message>
    <message>
        <source>parallel light, such as the sun&apos;s</source>
        <translation>paralleles Licht, wie das der Sonne</translation>
    </message>
    <message>
        <source>shines in every direction</source>
        <translation>scheint in alle Richtungen</translation>
    </message>
    <message>
        <source>shines in a cone</source>
        <translation>scheint in einem Kegel</translation>
    </message>
    <message>
        <source>Direction the light travels in; any length.</source>
        <translation>Richtung, in die das Licht scheint; beliebige Länge.</translation>
    </message>
    <message>
        <source>Where the light stands.</source>
        <translation>Wo das Licht steht.</translation>
    </message>
    <message>
        <source>Colour of the light, multiplied by its intensity.</source>
        <translation>Farbe des Lichts, multipliziert mit seiner Intensität.</translation>
    </message>
    <message>
        <source>Directional: irradiance at normal incidence. Others: radiant intensity; irradiance falls with the square of the distance.</source>
        <translation>Richtungslicht: Bestrahlungsstärke bei senkrechtem Einfall. Andere: Strahlstärke; die Bestrahlungsstärke fällt mit dem Quadrat des Abstands.</translation>
    </message>
    <message>
        <source>Half angle of the cone within which the light is at full strength; less than `outerConeDegrees`.</source>
        <translation>Halber Winkel des Kegels, in dem das Licht volle Stärke hat; kleiner als `outerConeDegrees`.</translation>
    </message>
    <message>
        <source>Half angle of the cone beyond which it is dark.</source>
        <translation>Halber Winkel des Kegels, außerhalb dessen es dunkel ist.</translation>
    </message>
    <message>
        <source>Distance at which the light has faded to nothing; 0 is no limit.</source>
        <translation>Abstand, in dem das Licht auf nichts abgeklungen ist; 0 heißt ohne Grenze.</translation>
    </message>
    <message>
        <source>What blocks the light where it stands outside of a probe&apos;s box. Ray-traced reflections trace it, but for `none`.</source>
        <translation>Was das Licht abhält, wenn es außerhalb der Box einer Sonde steht. Reflexionen mit Raytracing verfolgen es, außer bei `none`.</translation>
    </message>
    <message>
        <source>no shadow that it asks for: where lamps are shapes, what stands still shadows it all the same; with lamps in the map it shines through walls</source>
        <translation>kein eigener Schatten: wo Lampen Formen sind, wirft das Unbewegte trotzdem Schatten; mit Lampen in der Map scheint es durch Wände</translation>
    </message>
    <message>
        <source>what the probe saw in the light&apos;s direction</source>
        <translation>was die Sonde in Richtung des Lichts sah</translation>
    </message>
    <message>
        <source>the same, and a shadow map of the objects that move</source>
        <translation>dasselbe und eine Shadow Map der bewegten Objekte</translation>
    </message>
    <message>
        <source>Whole angle its disc is seen under, which softens shadows; the sun&apos;s is 0.53.</source>
        <translation>Ganzer Winkel, unter dem die Scheibe erscheint, was Schatten weich macht; bei der Sonne 0.53.</translation>
    </message>
    <message>
        <source>Radius of the light&apos;s sphere, which softens shadows.</source>
        <translation>Radius der Lichtkugel, was Schatten weich macht.</translation>
    </message>
    <message>
        <source>What chooses the mip level of the coverage: the softness.</source>
        <translation>Was die Mip-Stufe der Abdeckung bestimmt: die Weichheit.</translation>
    </message>
    <message>
        <source>the light&apos;s size as seen from the surface</source>
        <translation>die Größe des Lichts von der Oberfläche aus gesehen</translation>
    </message>
    <message>
        <source>in proportion to the distance to the wall, as published</source>
        <translation>proportional zum Abstand der Wand, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Mip levels per metre for `distance`; 0 spreads all levels over the longest distance in the probe&apos;s box.</source>
        <translation>Mip-Stufen je Meter für `distance`; 0 verteilt alle Stufen auf die längste Strecke in der Box der Sonde.</translation>
    </message>
    <message>
        <source>Base colour, multiplied by the texture.</source>
        <translation>Grundfarbe, multipliziert mit der Textur.</translation>
    </message>
    <message>
        <source>Perceptual roughness as in glTF: 0 is a mirror, 1 is fully rough.</source>
        <translation>Wahrgenommene Rauheit wie in glTF: 0 ist ein Spiegel, 1 ganz rau.</translation>
    </message>
    <message>
        <source>Radiance the surface emits.</source>
        <translation>Strahldichte, die die Oberfläche abgibt.</translation>
    </message>
    <message>
        <source>Strength of the normal texture.</source>
        <translation>Stärke der Normalentextur.</translation>
    </message>
    <message>
        <source>Strength of a clear coat.</source>
        <translation>Stärke eines Klarlacks.</translation>
    </message>
    <message>
        <source>Index of refraction: 1 bends nothing, water 1.33, glass 1.5, diamond 2.42. Below 1 the surroundings are denser.</source>
        <translation>Brechzahl: 1 bricht nichts, Wasser 1.33, Glas 1.5, Diamant 2.42. Unter 1 ist die Umgebung dichter.</translation>
    </message>
    <message>
        <source>Share of light that passes through the surface instead of being scattered: 1 is glass.</source>
        <translation>Anteil des Lichts, der durch die Oberfläche geht, statt gestreut zu werden: 1 ist Glas.</translation>
    </message>
    <message>
        <source>Length of the path inside, for the forms that do not find it; 0 makes a thin sheet.</source>
        <translation>Länge des Wegs im Inneren, für die Formen, die ihn nicht finden; 0 ergibt eine dünne Scheibe.</translation>
    </message>
    <message>
        <source>Distance after which white light has `attenuationColor`; 0 absorbs nothing.</source>
        <translation>Strecke, nach der weißes Licht `attenuationColor` hat; 0 absorbiert nichts.</translation>
    </message>
    <message>
        <source>What is left of white light after `attenuationDistance` (Beer&apos;s law).</source>
        <translation>Was von weißem Licht nach `attenuationDistance` bleibt (Lambert-Beer).</translation>
    </message>
    <message>
        <source>A thin sheet: reflects on both sides, bends and absorbs nothing.</source>
        <translation>Eine dünne Scheibe: reflektiert auf beiden Seiten, bricht und absorbiert nichts.</translation>
    </message>
    <message>
        <source>How the light&apos;s path through a transmissive material is found.</source>
        <translation>Wie der Weg des Lichts durch ein durchlässiges Material gefunden wird.</translation>
    </message>
    <message>
        <source>`two-interface` where a shell describes the object, thin walls where it is hollow, else `two-pass`</source>
        <translation>`two-interface`, wo eine Hülle das Objekt beschreibt, dünne Wände, wo es hohl ist, sonst `two-pass`</translation>
    </message>
    <message>
        <source>bent once, at the front, then looked up, as published</source>
        <translation>einmal gebrochen, vorn, dann abgefragt, wie veröffentlicht</translation>
    </message>
    <message>
        <source>the same for the back faces, and the front faces blended over them, as published</source>
        <translation>dasselbe für die Rückseiten, die Vorderseiten darüber geblendet, wie veröffentlicht</translation>
    </message>
    <message>
        <source>followed through the object&apos;s shell, bent where it enters and leaves</source>
        <translation>durch die Hülle des Objekts verfolgt, beim Ein- und Austritt gebrochen</translation>
    </message>
    <message>
        <source>Drawn in the picture.</source>
        <translation>Wird im Bild gezeichnet.</translation>
    </message>
    <message>
        <source>Captured by probes. With `visible` false: a stand-in that only reflections show.</source>
        <translation>Wird von Sonden aufgenommen. Mit `visible` false: ein Stellvertreter, den nur Reflexionen zeigen.</translation>
    </message>
    <message>
        <source>It moves: baked probes leave it out, so moving it needs no recapture; planar mirrors show it.</source>
        <translation>Es bewegt sich: gebackene Sonden lassen es weg, sodass Bewegen keine neue Aufnahme braucht; ebene Spiegel zeigen es.</translation>
    </message>
    <message>
        <source>Which probes light this object. Ray-traced reflections take all for `blend+sky`.</source>
        <translation>Welche Sonden dieses Objekt beleuchten. Reflexionen mit Raytracing nehmen alle für `blend+sky`.</translation>
    </message>
    <message>
        <source>none: the sky alone</source>
        <translation>keine: nur der Himmel</translation>
    </message>
    <message>
        <source>one probe, no blending</source>
        <translation>eine Sonde, kein Überblenden</translation>
    </message>
    <message>
        <source>a blend of probes</source>
        <translation>eine Mischung von Sonden</translation>
    </message>
    <message>
        <source>a blend of probes, and of the sky where they fade out</source>
        <translation>eine Mischung von Sonden, und vom Himmel, wo sie ausblenden</translation>
    </message>
    <message>
        <source>Where the weights of probes are computed.</source>
        <translation>Wo die Gewichte der Sonden berechnet werden.</translation>
    </message>
    <message>
        <source>at each pixel</source>
        <translation>an jedem Pixel</translation>
    </message>
    <message>
        <source>once, from the share of its bounds inside a probe&apos;s influence box: cheaper, and wrong for large objects</source>
        <translation>einmal, aus dem Anteil seiner Ausdehnung in der Einflussbox einer Sonde: günstiger, bei großen Objekten falsch</translation>
    </message>
    <message>
        <source>Moves the object from where its model puts it.</source>
        <translation>Verschiebt das Objekt vom Platz, den sein Modell ihm gibt.</translation>
    </message>
    <message>
        <source>Turns the object about its node&apos;s origin: X, then Y, then Z of the world.</source>
        <translation>Dreht das Objekt um den Ursprung seines Knotens: X, dann Y, dann Z der Welt.</translation>
    </message>
    <message>
        <source>Off: the entry is kept and does nothing.</source>
        <translation>Aus: der Eintrag bleibt und tut nichts.</translation>
    </message>
    <message>
        <source>A surface rougher than this has no mirrored picture and costs nothing.</source>
        <translation>Eine rauere Oberfläche hat kein Spiegelbild und kostet nichts.</translation>
    </message>
    <message>
        <source>Texels of the mirrored picture per pixel of the screen, each way.</source>
        <translation>Texel des Spiegelbilds je Bildschirmpixel, in jeder Richtung.</translation>
    </message>
    <message>
        <source>Factor on linear light before tone mapping and the curve of sRGB.</source>
        <translation>Faktor auf lineares Licht vor dem Tone-Mapping und der sRGB-Kurve.</translation>
    </message>
    <message>
        <source>How light beyond a display&apos;s white is shown. Linear pictures, errors and explanations are before it.</source>
        <translation>Wie Licht über dem Weiß der Anzeige gezeigt wird. Lineare Bilder, Fehler und Erklärungen liegen davor.</translation>
    </message>
    <message>
        <source>Khronos PBR Neutral: base colours stay, highlights are compressed towards white</source>
        <translation>Khronos PBR Neutral: Grundfarben bleiben, Lichter werden zum Weiß hin gestaucht</translation>
    </message>
    <message>
        <source>AgX: a long shoulder, bright colours become white</source>
        <translation>AgX: eine lange Schulter, helle Farben werden weiß</translation>
    </message>
    <message>
        <source>the Academy&apos;s contrast, by Hill&apos;s fit</source>
        <translation>der Kontrast der Academy, nach Hills Näherung</translation>
    </message>
    <message>
        <source>What a picture shows where nothing stands; probes see the sky.</source>
        <translation>Was ein Bild zeigt, wo nichts steht; Sonden sehen den Himmel.</translation>
    </message>
    <message>
        <source>the sky</source>
        <translation>der Himmel</translation>
    </message>
    <message>
        <source>the sky as a rough surface reflects it</source>
        <translation>der Himmel, wie eine raue Oberfläche ihn reflektiert</translation>
    </message>
    <message>
        <source>a grey backdrop</source>
        <translation>ein grauer Hintergrund</translation>
    </message>
    <message>
        <source>one colour, `backgroundColor`</source>
        <translation>eine Farbe, `backgroundColor`</translation>
    </message>
    <message>
        <source>What `color` shows, linear: the display&apos;s own colour, whatever exposure and tone.</source>
        <translation>Was `color` zeigt, linear: die Farbe der Anzeige selbst, gleich welche Belichtung und Tonwerte.</translation>
    </message>
    <message>
        <source>Everything together casts a soft shadow of the sky&apos;s light on a plane below it, in display colours only: no probe, mirror or linear picture shows it.</source>
        <translation>Alles zusammen wirft einen weichen Schatten des Himmelslichts auf eine Ebene darunter, nur in Anzeigefarben: keine Sonde, kein Spiegel und kein lineares Bild zeigt ihn.</translation>
    </message>
    <message>
        <source>What stands in the scene hides the sky from its own hollows and contacts, where the sky alone lights it; probes show it without.</source>
        <translation>Was in der Szene steht, verdeckt den Himmel vor eigenen Vertiefungen und Berührungen, wo allein der Himmel beleuchtet; Sonden zeigen es ohne.</translation>
    </message>
    <message>
        <source>What becomes of light that meets more than one microfacet of a rough surface.</source>
        <translation>Was aus Licht wird, das mehr als eine Mikrofacette einer rauen Oberfläche trifft.</translation>
    </message>
    <message>
        <source>it is lost: rough metals darken</source>
        <translation>es geht verloren: raue Metalle werden dunkler</translation>
    </message>
    <message>
        <source>it is added back, of lamps and probes alike (Turquin 2019)</source>
        <translation>es wird wieder hinzugefügt, bei Lampen wie Sonden (Turquin 2019)</translation>
    </message>
    <message>
        <source>How shining objects light diffuse surfaces.</source>
        <translation>Wie leuchtende Objekte diffuse Oberflächen beleuchten.</translation>
    </message>
    <message>
        <source>from the probe&apos;s map, alike all over its box</source>
        <translation>aus der Map der Sonde, überall in ihrer Box gleich</translation>
    </message>
    <message>
        <source>flat lamps by their shapes, everything else by a lattice in the box</source>
        <translation>flache Lampen nach ihren Formen, alles andere über ein Gitter in der Box</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>Picture of linear radiance, .exr or .hdr: latitude-longitude, or a cube as a strip or a cross.</source>
        <translation>Bild linearer Strahldichte, .exr oder .hdr: Länge-Breite oder ein Würfel als Streifen oder Kreuz.</translation>
    </message>
    <message>
        <source>The same radiance in every direction.</source>
        <translation>Dieselbe Strahldichte in jeder Richtung.</translation>
    </message>
    <message>
        <source>Radiance straight up.</source>
        <translation>Strahldichte senkrecht nach oben.</translation>
    </message>
    <message>
        <source>Radiance at the horizon.</source>
        <translation>Strahldichte am Horizont.</translation>
    </message>
    <message>
        <source>Radiance straight down.</source>
        <translation>Strahldichte senkrecht nach unten.</translation>
    </message>
    <message>
        <source>Turns the sky about the vertical: 90 takes +Z to +X. Probes that clear to `open` follow without a capture.</source>
        <translation>Dreht den Himmel um die Senkrechte: 90 bringt +Z nach +X. Sonden, die mit `open` leeren, folgen ohne Aufnahme.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The surfaces as drawn.</source>
        <translation>Die Oberflächen, wie sie gezeichnet sind.</translation>
    </message>
    <message>
        <source>Hit distance</source>
        <translation>Trefferabstand</translation>
    </message>
    <message>
        <source>scene units</source>
        <translation>Szeneneinheiten</translation>
    </message>
    <message>
        <source>From the surface along the reflected ray to where it leaves the probe&apos;s proxy: the d of the projection.</source>
        <translation>Von der Oberfläche entlang des reflektierten Strahls bis zum Austritt aus dem Proxy der Sonde: das d der Projektion.</translation>
    </message>
    <message>
        <source>True distance</source>
        <translation>Wahrer Abstand</translation>
    </message>
    <message>
        <source>From the surface along the reflected ray to the captured surface, by the probe&apos;s distance cubemap.</source>
        <translation>Von der Oberfläche entlang des reflektierten Strahls zur aufgenommenen Oberfläche, nach der Abstands-Cubemap der Sonde.</translation>
    </message>
    <message>
        <source>Hit error</source>
        <translation>Trefferfehler</translation>
    </message>
    <message>
        <source>Distance between the proxy&apos;s hit and the true hit: 0 where the scene is the box.</source>
        <translation>Abstand zwischen dem Treffer auf dem Proxy und dem wahren Treffer: 0, wo die Szene die Box ist.</translation>
    </message>
    <message>
        <source>Lookup error</source>
        <translation>Abfragefehler</translation>
    </message>
    <message>
        <source>Angle at the capture origin between the sampled direction and the direction of the true hit.</source>
        <translation>Winkel am Aufnahmeursprung zwischen der abgetasteten Richtung und der Richtung des wahren Treffers.</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>The sampled mip level; the mean if there are several lookups.</source>
        <translation>Die abgetastete Mip-Stufe; der Mittelwert bei mehreren Abfragen.</translation>
    </message>
    <message>
        <source>Effective roughness</source>
        <translation>Wirksame Rauheit</translation>
    </message>
    <message>
        <source>The roughness that the sampled mip level was filtered for.</source>
        <translation>Die Rauheit, für die die abgetastete Mip-Stufe gefiltert wurde.</translation>
    </message>
    <message>
        <source>Lookup direction</source>
        <translation>Abfragerichtung</translation>
    </message>
    <message>
        <source>The sampled direction, x y z from -1 to 1 as red, green and blue.</source>
        <translation>Die abgetastete Richtung, x y z von -1 bis 1 als Rot, Grün und Blau.</translation>
    </message>
    <message>
        <source>Probe weights</source>
        <translation>Sondengewichte</translation>
    </message>
    <message>
        <source>Each probe&apos;s colour by its share of the pixel; dark grey is the sky&apos;s share.</source>
        <translation>Die Farbe jeder Sonde nach ihrem Anteil am Pixel; Dunkelgrau ist der Anteil des Himmels.</translation>
    </message>
    <message>
        <source>Face hit</source>
        <translation>Getroffene Fläche</translation>
    </message>
    <message>
        <source>The face of the box that the reflected ray hits: -x +x -y +y -z +z.</source>
        <translation>Die Fläche der Box, die der reflektierte Strahl trifft: -x +x -y +y -z +z.</translation>
    </message>
    <message>
        <source>Lookups</source>
        <translation>Abfragen</translation>
    </message>
    <message>
        <source>Cubemap lookups at this pixel.</source>
        <translation>Cubemap-Abfragen an diesem Pixel.</translation>
    </message>
    <message>
        <source>Diffuse light</source>
        <translation>Diffuses Licht</translation>
    </message>
    <message>
        <source>Irradiance over pi of probes, lamps as shapes and sky: what a white matte surface would show.</source>
        <translation>Bestrahlungsstärke durch Pi von Sonden, Lampen als Formen und Himmel: was eine weiße matte Oberfläche zeigen würde.</translation>
    </message>
    <message>
        <source>Node validity</source>
        <translation>Gültigkeit der Knoten</translation>
    </message>
    <message>
        <source>Weight of lattice nodes with light of their own: 0 where all nodes around lie within things and are filled.</source>
        <translation>Gewicht der Gitterknoten mit eigenem Licht: 0, wo alle Knoten ringsum in Dingen liegen und aufgefüllt sind.</translation>
    </message>
    <message>
        <source>Diffuse error</source>
        <translation>Diffuser Fehler</translation>
    </message>
    <message>
        <source>Distance between the diffuse light and a path tracer&apos;s, over the latter; hatched until it is traced.</source>
        <translation>Abstand zwischen dem diffusen Licht und dem eines Pathtracers, im Verhältnis zu letzterem; schraffiert, bis es berechnet ist.</translation>
    </message>
    <message>
        <source>Normal (painted on)</source>
        <translation>Normale (aufgemalt)</translation>
    </message>
    <message>
        <source>Samples along the surface normal: the picture sticks to the object.</source>
        <translation>Tastet entlang der Oberflächennormale ab: das Bild klebt am Objekt.</translation>
    </message>
    <message>
        <source>Infinite (no correction)</source>
        <translation>Unendlich (keine Korrektur)</translation>
    </message>
    <message>
        <source>Samples along the bare reflection vector: correct only for distant surroundings.</source>
        <translation>Tastet entlang des bloßen Reflexionsvektors ab: nur für ferne Umgebung richtig.</translation>
    </message>
    <message>
        <source>Sphere proxy</source>
        <translation>Kugel-Proxy</translation>
    </message>
    <message>
        <source>Intersects the ray with the sphere around the box: straight walls bend.</source>
        <translation>Schneidet den Strahl mit der Kugel um die Box: gerade Wände biegen sich.</translation>
    </message>
    <message>
        <source>Box projection</source>
        <translation>Box-Projektion</translation>
    </message>
    <message>
        <source>Box projection (parallax correction): intersects the ray with the probe&apos;s box; exact where the room is the box.</source>
        <translation>Box-Projektion (Parallaxenkorrektur): schneidet den Strahl mit der Box der Sonde; exakt, wo der Raum die Box ist.</translation>
    </message>
    <message>
        <source>Impostor (box refined)</source>
        <translation>Impostor (verfeinerte Box)</translation>
    </message>
    <message>
        <source>Refines the box&apos;s hit by the captured distances, or follows the ray through them: for rooms that are not boxes.</source>
        <translation>Verfeinert den Treffer auf der Box mit den aufgenommenen Abständen oder verfolgt den Strahl durch sie: für Räume, die keine Boxen sind.</translation>
    </message>
    <message>
        <source>No contact hardening</source>
        <translation>Keine Kontaktschärfung</translation>
    </message>
    <message>
        <source>One lookup at the surface&apos;s own roughness, whatever the distance.</source>
        <translation>Eine Abfrage mit der Rauheit der Oberfläche selbst, gleich welcher Abstand.</translation>
    </message>
    <message>
        <source>Approximate hardening</source>
        <translation>Genäherte Schärfung</translation>
    </message>
    <message>
        <source>Sharper where the reflected surface is nearer than the hardening length.</source>
        <translation>Schärfer, wo die reflektierte Oberfläche näher ist als die Schärfungslänge.</translation>
    </message>
    <message>
        <source>HDRP / Frostbite hardening</source>
        <translation>HDRP-/Frostbite-Schärfung</translation>
    </message>
    <message>
        <source>Sharper by the angle under which the capture origin sees the lobe&apos;s patch of wall.</source>
        <translation>Schärfer nach dem Winkel, unter dem der Aufnahmeursprung den Wandfleck der Keule sieht.</translation>
    </message>
    <message>
        <source>Godot hardening</source>
        <translation>Schärfung nach Godot</translation>
    </message>
    <message>
        <source>Sharper by distance and, by a Fresnel-like factor, at grazing angles.</source>
        <translation>Schärfer nach Abstand und, mit einem fresnelartigen Faktor, bei streifenden Winkeln.</translation>
    </message>
    <message>
        <source>One footprint</source>
        <translation>Ein Footprint</translation>
    </message>
    <message>
        <source>One lookup at the mip level that matches the patch of wall under the lobe.</source>
        <translation>Eine Abfrage mit der Mip-Stufe, die zum Wandfleck unter der Keule passt.</translation>
    </message>
    <message>
        <source>Two footprints</source>
        <translation>Zwei Footprints</translation>
    </message>
    <message>
        <source>Divides the lobe into 2 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>Teilt die Keule in 2 Stücke, jedes mit der Mip-Stufe seines Flecks abgetastet: Reflexionen strecken sich bei streifenden Winkeln.</translation>
    </message>
    <message>
        <source>Four footprints</source>
        <translation>Vier Footprints</translation>
    </message>
    <message>
        <source>Divides the lobe into 4 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>Teilt die Keule in 4 Stücke, jedes mit der Mip-Stufe seines Flecks abgetastet: Reflexionen strecken sich bei streifenden Winkeln.</translation>
    </message>
    <message>
        <source>Eight footprints</source>
        <translation>Acht Footprints</translation>
    </message>
    <message>
        <source>Divides the lobe into 8 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>Teilt die Keule in 8 Stücke, jedes mit der Mip-Stufe seines Flecks abgetastet: Reflexionen strecken sich bei streifenden Winkeln.</translation>
    </message>
    <message>
        <source>Sixteen footprints</source>
        <translation>Sechzehn Footprints</translation>
    </message>
    <message>
        <source>Divides the lobe into 16 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>Teilt die Keule in 16 Stücke, jedes mit der Mip-Stufe seines Flecks abgetastet: Reflexionen strecken sich bei streifenden Winkeln.</translation>
    </message>
    <message>
        <source>Ray-traced</source>
        <translation>Raytracing</translation>
    </message>
    <message>
        <source>Follows random rays of the surface&apos;s lobe to the proxy: the others approximate this; noisy with few rays.</source>
        <translation>Verfolgt zufällige Strahlen der Keule der Oberfläche zum Proxy: die anderen nähern dies an; mit wenigen Strahlen verrauscht.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Chooses for each object the cheapest evaluation whose measured error stays within the budget at its roughness.</source>
        <translation>Wählt für jedes Objekt die günstigste Auswertung, deren gemessener Fehler bei seiner Rauheit im Budget bleibt.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Samples</translation>
    </message>
    <message>
        <source>Reflected rays per pixel, each one lookup.</source>
        <translation>Reflektierte Strahlen je Pixel, jeder eine Abfrage.</translation>
    </message>
    <message>
        <source>Rays in all</source>
        <translation>Strahlen insgesamt</translation>
    </message>
    <message>
        <source>Of an animated picture: rays per pixel of all frames that are averaged, which each ray&apos;s blur is made for. 0: of one frame, whose blur stays however many frames there are.</source>
        <translation>Bei einem animierten Bild: Strahlen je Pixel aller gemittelten Frames, wofür die Unschärfe jedes Strahls gemacht ist. 0: eines Frames, dessen Unschärfe bleibt, gleich wie viele Frames es sind.</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>How rays are spread: at random (white), evenly with fine-grained noise (blue), evenly with a shift per pixel (r2), or equally in every pixel (deterministic), which shows ghosts instead of noise.</source>
        <translation>Wie Strahlen verteilt sind: zufällig (white), gleichmäßig mit feinkörnigem Rauschen (blue), gleichmäßig mit Versatz je Pixel (r2) oder in jedem Pixel gleich (deterministic), was Geisterbilder statt Rauschen zeigt.</translation>
    </message>
    <message>
        <source>Animated</source>
        <translation>Animiert</translation>
    </message>
    <message>
        <source>Draws a new pattern every frame and averages the frames.</source>
        <translation>Zeichnet in jedem Frame ein neues Muster und mittelt die Frames.</translation>
    </message>
    <message>
        <source>Level offset</source>
        <translation>Stufenversatz</translation>
    </message>
    <message>
        <source>Blurs each ray&apos;s lookup by its share of the lobe and the distance to what it hits.</source>
        <translation>Macht die Abfrage jedes Strahls unscharf nach seinem Anteil an der Keule und dem Abstand zum Getroffenen.</translation>
    </message>
    <message>
        <source>Filtered</source>
        <translation>Gefiltert</translation>
    </message>
    <message>
        <source>Blurs each ray&apos;s lookup by the patch of wall it stands for: far less noise and error.</source>
        <translation>Macht die Abfrage jedes Strahls unscharf nach dem Wandfleck, für den er steht: weit weniger Rauschen und Fehler.</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Distribution of the rays: the surface&apos;s lobe, or half of them from the probe&apos;s brightness, for small lights. Blurred rays find lights by themselves and come from the lobe alone.</source>
        <translation>Verteilung der Strahlen: die Keule der Oberfläche, oder zur Hälfte nach der Helligkeit der Sonde, für kleine Lichter. Unscharfe Strahlen finden Lichter von selbst und kommen nur aus der Keule.</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>Unschärfe</translation>
    </message>
    <message>
        <source>Smooths the sampled picture, but not across different normals.</source>
        <translation>Glättet das abgetastete Bild, aber nicht über verschiedene Normalen hinweg.</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Potenz</translation>
    </message>
    <message>
        <source>Exponent of the Fresnel-like factor (1 - N.V)^power: the higher, the closer to grazing it sets in. Published: 4; 2 and 3 are cheaper forms.</source>
        <translation>Exponent des fresnelartigen Faktors (1 - N.V)^Potenz: je höher, desto streifender setzt er ein. Veröffentlicht: 4; 2 und 3 sind günstigere Formen.</translation>
    </message>
    <message>
        <source>Hardening length</source>
        <translation>Schärfungslänge</translation>
    </message>
    <message>
        <source>Distance from the surface to the reflected surface at which the reflection has its full roughness. Published: 6.</source>
        <translation>Abstand von der Oberfläche zur reflektierten, bei dem die Reflexion ihre volle Rauheit hat. Veröffentlicht: 6.</translation>
    </message>
    <message>
        <source>Fresnel</source>
        <translation>Fresnel</translation>
    </message>
    <message>
        <source>Factor towards grazing angles: the one above, or the surface&apos;s own Fresnel reflectance.</source>
        <translation>Faktor zu streifenden Winkeln hin: der obige oder die Fresnel-Reflexion der Oberfläche selbst.</translation>
    </message>
    <message>
        <source>Blur by roughness</source>
        <translation>Unschärfe je Rauheit</translation>
    </message>
    <message>
        <source>How blurred the reflection is at each roughness: the curve to the mip level. Own is what the levels were filtered for; the others show a mismatch.</source>
        <translation>Wie unscharf die Reflexion bei jeder Rauheit ist: die Kurve zur Mip-Stufe. „Own“ ist, wofür die Stufen gefiltert wurden; die anderen zeigen eine Abweichung.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Lookups of the captured distances that refine the box&apos;s hit: 1 at the hit, 2 also on the way to it, 3 also behind it; from 4 on the most that following the ray through them may take: 24 are enough.</source>
        <translation>Abfragen der aufgenommenen Abstände, die den Treffer auf der Box verfeinern: 1 am Treffer, 2 auch auf dem Weg dorthin, 3 auch dahinter; ab 4 die Höchstzahl für das Verfolgen des Strahls: 24 genügen.</translation>
    </message>
    <message>
        <source>Error budget</source>
        <translation>Fehlerbudget</translation>
    </message>
    <message>
        <source>Largest accepted error, RMSE of (x/(1+x))^(1/2.2) as `boxprobe bench` measures it.</source>
        <translation>Größter zulässiger Fehler, RMSE von (x/(1+x))^(1/2.2), wie `boxprobe bench` ihn misst.</translation>
    </message>
    <message>
        <source>0 is a dielectric, 1 a metal.</source>
        <translation>0 ist ein Nichtleiter, 1 ein Metall.</translation>
    </message>
    <message>
        <source>4:3 or 3:4</source>
        <translation>4:3 oder 3:4</translation>
    </message>
    <message>
        <source>reflection</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>light of probes and sky: projection, lookups, harmonics, weights</source>
        <translation>Licht von Sonden und Himmel: Projektion, Abfragen, Kugelfunktionen, Gewichte</translation>
    </message>
    <message>
        <source>light loop</source>
        <translation>Lichtschleife</translation>
    </message>
    <message>
        <source>lamps, their shadows by coverage included</source>
        <translation>Lampen, mit ihren Schatten nach Abdeckung</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>textures and normal maps</source>
        <translation>Texturen und Normalentexturen</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>conversion to display colours</source>
        <translation>Umrechnung in Anzeigefarben</translation>
    </message>
    <message>
        <source>other shading</source>
        <translation>übriges Shading</translation>
    </message>
    <message>
        <source>what is left of the pixels&apos; programs: normals, the view vector, the split sum</source>
        <translation>was von den Programmen der Pixel bleibt: Normalen, Blickvektor, Split-Sum</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>pixels found, tested for depth and written, of one colour</source>
        <translation>Pixel gefunden, auf Tiefe geprüft und geschrieben, einfarbig</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Vertices</translation>
    </message>
    <message>
        <source>vertices and VTK&apos;s calls for each object</source>
        <translation>Vertices und die Aufrufe von VTK für jedes Objekt</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>the sky behind everything</source>
        <translation>der Himmel hinter allem</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>what the scene hides of its own sky, if it is asked to</source>
        <translation>was die Szene von ihrem eigenen Himmel verdeckt, falls verlangt</translation>
    </message>
    <message>
        <source>ground shadow</source>
        <translation>Bodenschatten</translation>
    </message>
    <message>
        <source>the soft shadow below everything, if the scene has it</source>
        <translation>der weiche Schatten unter allem, falls die Szene ihn hat</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>a frame of nothing: cleared, samples resolved, VTK&apos;s own work</source>
        <translation>ein leerer Frame: gelöscht, Samples aufgelöst, eigene Arbeit von VTK</translation>
    </message>
    <message>
        <source>What becomes of a sun in the image, a small bright disc.</source>
        <translation>Was aus einer Sonne im Bild wird, einer kleinen hellen Scheibe.</translation>
    </message>
    <message>
        <source>it is drawn as a directional light, with its shadow, and taken out of the image</source>
        <translation>sie wird als gerichtetes Licht mit Schatten gezeichnet und aus dem Bild genommen</translation>
    </message>
    <message>
        <source>it stays in the image</source>
        <translation>sie bleibt im Bild</translation>
    </message>
    <message>
        <source>eye ray</source>
        <translation>Augstrahl</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>reflected ray</source>
        <translation>reflektierter Strahl</translation>
    </message>
    <message>
        <source>lookup</source>
        <translation>Abfrage</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>Sample</translation>
    </message>
    <message>
        <source>true hit</source>
        <translation>wahrer Treffer</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>within glass</source>
        <translation>im Glas</translation>
    </message>
    <message>
        <source>refracted ray</source>
        <translation>gebrochener Strahl</translation>
    </message>
    <message>
        <source>shadow ray</source>
        <translation>Schattenstrahl</translation>
    </message>
    <message>
        <source>nodes about 1 m apart, closer where light falls steeply</source>
        <translation>Knoten im Abstand von etwa 1 m, enger, wo das Licht steil abfällt</translation>
    </message>
    <message>
        <source>Distance between the nodes, about: at least 2 and at most 16 of them stand along each axis.</source>
        <translation>Ungefährer Abstand der Knoten: Entlang jeder Achse stehen mindestens 2 und höchstens 16.</translation>
    </message>
    <message>
        <source>The nodes at which diffuse light is known; with `false` there are none, and the whole map lights every place alike.</source>
        <translation>Die Knoten, an denen diffuses Licht bekannt ist; mit `false` gibt es keine, und die ganze Map beleuchtet jeden Ort gleich.</translation>
    </message>
</context>
<context>
    <name>TypedNumber</name>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than one separator: type one decimal mark and no separator of thousands</source>
        <translation>„%1“ hat mehr als ein Trennzeichen: ein Dezimalzeichen eingeben und kein Tausendertrennzeichen</translation>
    </message>
    <message>
        <source>&quot;%1&quot; mixes digits of two scripts</source>
        <translation>„%1“ mischt Ziffern zweier Schriften</translation>
    </message>
    <message>
        <source>A number is missing</source>
        <translation>Es fehlt eine Zahl</translation>
    </message>
</context>
<context>
    <name>WindowWords</name>
    <message>
        <source>Choose it under Model &gt; Unit and up axis</source>
        <translation>Wählen Sie es unter Modell &gt; Einheit und Hochachse</translation>
    </message>
    <message>
        <source>choose it under Model &gt; Unit and up axis</source>
        <translation>wählen Sie es unter Modell &gt; Einheit und Hochachse</translation>
    </message>
    <message>
        <source>or choose Model &gt; Treat as &gt; Interior</source>
        <translation>oder wählen Sie Modell &gt; Behandeln als &gt; Innenraum</translation>
    </message>
</context>
<context>
    <name>boxprobe</name>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 existiert bereits. Ersetzen?</translation>
    </message>
</context>
<context>
    <name>boxprobe::Actions</name>
    <message>
        <source>Handles on the faces of the projection box: a filled ball at the maximum, a hollow one at the minimum</source>
        <translation>Griffe an den Flächen der Projektionsbox: gefüllte Kugel am Maximum, hohle am Minimum</translation>
    </message>
    <message>
        <source>Balls on the influence box, cubes on the box inside which the probe has its full weight</source>
        <translation>Kugeln an der Einflussbox, Würfel an der Box, in der die Sonde ihr volles Gewicht hat</translation>
    </message>
    <message>
        <source>Arrows at the capture origin</source>
        <translation>Pfeile am Aufnahmeursprung</translation>
    </message>
    <message>
        <source>Moves and turns the whole probe</source>
        <translation>Bewegt und dreht die ganze Sonde</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>&amp;Öffnen...</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Neu laden</translation>
    </message>
    <message>
        <source>S&amp;ky from a picture...</source>
        <translation>&amp;Himmel aus einem Bild...</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>Speichern &amp;unter...</translation>
    </message>
    <message>
        <source>&amp;Export image...</source>
        <translation>Bild &amp;exportieren...</translation>
    </message>
    <message>
        <source>Export &amp;probes...</source>
        <translation>Sonden e&amp;xportieren...</translation>
    </message>
    <message>
        <source>&amp;Live link...</source>
        <translation>&amp;Live-Verbindung...</translation>
    </message>
    <message>
        <source>Save &amp;baked probes...</source>
        <translation>Ge&amp;backene Sonden speichern...</translation>
    </message>
    <message>
        <source>Repor&amp;t...</source>
        <translation>Berich&amp;t...</translation>
    </message>
    <message>
        <source>One HTML file: every camera drawn and path traced, the probes with their fit and cost</source>
        <translation>Eine HTML-Datei: jede Kamera gezeichnet und per Pathtracing berechnet, die Sonden mit Passung und Kosten</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Been&amp;den</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Add probe</source>
        <translation>Sonde &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate probe</source>
        <translation>Sonde &amp;duplizieren</translation>
    </message>
    <message>
        <source>De&amp;lete probe</source>
        <translation>Sonde &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Copy probe</source>
        <translation>Sonde &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste probes</source>
        <translation>Sonden &amp;einfügen</translation>
    </message>
    <message>
        <source>&amp;Select all probes</source>
        <translation>&amp;Alle Sonden auswählen</translation>
    </message>
    <message>
        <source>Select the probe &amp;here</source>
        <translation>&amp;Sonde hier auswählen</translation>
    </message>
    <message>
        <source>The probe that lights the place where the camera stands</source>
        <translation>Die Sonde, die den Ort der Kamera beleuchtet</translation>
    </message>
    <message>
        <source>&amp;Fit box</source>
        <translation>Box an&amp;passen</translation>
    </message>
    <message>
        <source>&amp;Place probes</source>
        <translation>Sonden pla&amp;tzieren</translation>
    </message>
    <message>
        <source>&amp;Bake probe</source>
        <translation>Sonde &amp;backen</translation>
    </message>
    <message>
        <source>Ba&amp;ke all probes</source>
        <translation>Alle Sonden ba&amp;cken</translation>
    </message>
    <message>
        <source>Cancel the drag or stop capturing</source>
        <translation>Ziehen abbrechen oder Aufnahme stoppen</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Frame the selection</source>
        <translation>Auswahl &amp;einpassen</translation>
    </message>
    <message>
        <source>&amp;Look from the probe</source>
        <translation>Von der S&amp;onde aus blicken</translation>
    </message>
    <message>
        <source>&amp;Walk at eye height</source>
        <translation>Auf Augen&amp;höhe gehen</translation>
    </message>
    <message>
        <source>&amp;Hide the selection</source>
        <translation>Auswahl a&amp;usblenden</translation>
    </message>
    <message>
        <source>In this window alone; the scene&apos;s file, captures and exported pictures have it</source>
        <translation>Nur in diesem Fenster; Szenendatei, Aufnahmen und exportierte Bilder enthalten sie</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>Alles Aus&amp;geblendete zeigen</translation>
    </message>
    <message>
        <source>&amp;Isolate the selection</source>
        <translation>Auswahl &amp;isolieren</translation>
    </message>
    <message>
        <source>Of a probe: with the objects that reach into its box. Once more shows the others again</source>
        <translation>Bei einer Sonde: mit den Objekten, die in ihre Box reichen. Nochmals zeigt die anderen wieder</translation>
    </message>
    <message>
        <source>Cu&amp;t away what hides the probe&apos;s box</source>
        <translation>Was die Box verdeckt, &amp;wegschneiden</translation>
    </message>
    <message>
        <source>Looks into a room from outside. Exported pictures, errors and captures are not cut</source>
        <translation>Blickt von außen in einen Raum. Exportierte Bilder, Fehler und Aufnahmen sind nicht beschnitten</translation>
    </message>
    <message>
        <source>&amp;Hold this picture</source>
        <translation>Dieses Bild fest&amp;halten</translation>
    </message>
    <message>
        <source>With &amp;all light, path traced</source>
        <translation>Mit &amp;allem Licht, Pathtracing</translation>
    </message>
    <message>
        <source>With the &amp;reflection alone ray traced</source>
        <translation>Nur die &amp;Reflexion per Raytracing</translation>
    </message>
    <message>
        <source>&amp;Error against all light, path traced</source>
        <translation>&amp;Fehler gegen alles Licht, Pathtracing</translation>
    </message>
    <message>
        <source>The &amp;difference in false colours</source>
        <translation>&amp;Differenz in Falschfarben</translation>
    </message>
    <message>
        <source>&amp;Flip to the other picture</source>
        <translation>&amp;Zum anderen Bild wechseln</translation>
    </message>
    <message>
        <source>Four &amp;views side by side</source>
        <translation>&amp;Vier Ansichten nebeneinander</translation>
    </message>
    <message>
        <source>&amp;Stop comparing</source>
        <translation>Vergleich &amp;beenden</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>&amp;Heller</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>&amp;Dunkler</translation>
    </message>
    <message>
        <source>&amp;Expose automatically</source>
        <translation>&amp;Automatisch belichten</translation>
    </message>
    <message>
        <source>To the &amp;left</source>
        <translation>Nach &amp;links</translation>
    </message>
    <message>
        <source>To the &amp;right</source>
        <translation>Nach &amp;rechts</translation>
    </message>
    <message>
        <source>Ground shado&amp;w</source>
        <translation>Boden&amp;schatten</translation>
    </message>
    <message>
        <source>Ambient occl&amp;usion</source>
        <translation>Umgebungsver&amp;deckung</translation>
    </message>
    <message>
        <source>Probe &amp;boxes and handles</source>
        <translation>Sondenbo&amp;xen und Griffe</translation>
    </message>
    <message>
        <source>Re&amp;flections from probes</source>
        <translation>Re&amp;flexionen von Sonden</translation>
    </message>
    <message>
        <source>C&amp;heaper techniques while moving</source>
        <translation>Gü&amp;nstigere Techniken bei Bewegung</translation>
    </message>
    <message>
        <source>Draws expensive techniques by a cheaper one while the camera or a handle moves</source>
        <translation>Zeichnet teure Techniken durch eine günstigere, solange sich Kamera oder Griff bewegen</translation>
    </message>
    <message>
        <source>Refi&amp;ne at rest</source>
        <translation>In &amp;Ruhe verfeinern</translation>
    </message>
    <message>
        <source>While nothing moves, reflections go on to what rays of the whole lobe show, whatever the technique</source>
        <translation>Wenn sich nichts bewegt, nähern sich die Reflexionen dem, was Strahlen der ganzen Keule zeigen, gleich mit welcher Technik</translation>
    </message>
    <message>
        <source>&amp;Projector: the picture and the lesson alone</source>
        <translation>Pro&amp;jektor: nur Bild und Lektion</translation>
    </message>
    <message>
        <source>&amp;Explain pixels</source>
        <translation>Pixel &amp;erklären</translation>
    </message>
    <message>
        <source>&amp;Copy explanation as text</source>
        <translation>Erklärung als &amp;Text kopieren</translation>
    </message>
    <message>
        <source>Copy explanation as &amp;JSON</source>
        <translation>Erklärung als &amp;JSON kopieren</translation>
    </message>
    <message>
        <source>Save &amp;rays...</source>
        <translation>&amp;Strahlen speichern...</translation>
    </message>
    <message>
        <source>&amp;Work counters in the status bar</source>
        <translation>&amp;Arbeitszähler in der Statusleiste</translation>
    </message>
    <message>
        <source>&amp;Lessons...</source>
        <translation>&amp;Lektionen...</translation>
    </message>
    <message>
        <source>&amp;Keys over the picture</source>
        <translation>&amp;Tasten über dem Bild</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys, about</source>
        <translation>&amp;Maus und Tasten, Über</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>&amp;Box</translation>
    </message>
    <message>
        <source>&amp;Influence</source>
        <translation>&amp;Einfluss</translation>
    </message>
    <message>
        <source>&amp;Origin</source>
        <translation>&amp;Ursprung</translation>
    </message>
    <message>
        <source>&amp;Move and turn</source>
        <translation>Be&amp;wegen und drehen</translation>
    </message>
    <message>
        <source>N&amp;one</source>
        <translation>K&amp;eins</translation>
    </message>
    <message>
        <source>Khronos PBR &amp;Neutral</source>
        <translation>Khronos PBR &amp;Neutral</translation>
    </message>
    <message>
        <source>&amp;AgX</source>
        <translation>&amp;AgX</translation>
    </message>
    <message>
        <source>A&amp;CES</source>
        <translation>A&amp;CES</translation>
    </message>
    <message>
        <source>&amp;Environment</source>
        <translation>&amp;Umgebung</translation>
    </message>
    <message>
        <source>&amp;Blurred environment</source>
        <translation>&amp;Weichgezeichnete Umgebung</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>&amp;Colour...</source>
        <translation>&amp;Farbe...</translation>
    </message>
    <message>
        <source>As the &amp;desktop has it</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Zuletzt &amp;geöffnet</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>&amp;Material variant</source>
        <translation>&amp;Materialvariante</translation>
    </message>
</context>
<context>
    <name>boxprobe::AnimationTools</name>
    <message>
        <source>Animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>Time at which the model&apos;s animations are shown</source>
        <translation>Zeitpunkt, zu dem die Animationen des Modells gezeigt werden</translation>
    </message>
    <message>
        <source>Animation time</source>
        <translation>Animationszeit</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Shows the model as it stands without its animations</source>
        <translation>Zeigt das Modell ohne seine Animationen</translation>
    </message>
    <message>
        <source>%1 s / %2 s</source>
        <translation>%1 s / %2 s</translation>
    </message>
    <message>
        <source>at rest / %1 s</source>
        <translation>in Ruhe / %1 s</translation>
    </message>
</context>
<context>
    <name>boxprobe::Autosave</name>
    <message>
        <source>Unsaved changes would not survive a crash: %1</source>
        <translation>Nicht gespeicherte Änderungen würden einen Absturz nicht überstehen: %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::AxisGizmo</name>
    <message>
        <source>Click an axis to look along it</source>
        <translation>Eine Achse anklicken, um an ihr entlang zu blicken</translation>
    </message>
</context>
<context>
    <name>boxprobe::BakePanel</name>
    <message>
        <source>Bake</source>
        <translation>Backen</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Progress of the selected probe&apos;s cubemap</source>
        <translation>Fortschritt der Cubemap der ausgewählten Sonde</translation>
    </message>
    <message>
        <source>Recaptures and filters the selected probes (F5)</source>
        <translation>Nimmt die ausgewählten Sonden neu auf und filtert sie (F5)</translation>
    </message>
    <message>
        <source>Bake all</source>
        <translation>Alle backen</translation>
    </message>
    <message>
        <source>Recaptures and filters every probe (Shift+F5)</source>
        <translation>Nimmt alle Sonden neu auf und filtert sie (Umschalt+F5)</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stops the work until the scene changes again (Esc)</source>
        <translation>Hält die Arbeit an, bis sich die Szene wieder ändert (Esc)</translation>
    </message>
    <message>
        <source>Save files...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Writes every baked probe to an OpenEXR file in a folder. In the folder beside the scene they are loaded instead of captured</source>
        <translation>Schreibt jede gebackene Sonde als OpenEXR-Datei in einen Ordner. Aus dem Ordner neben der Szene werden sie geladen, statt neu aufgenommen zu werden</translation>
    </message>
    <message>
        <source>No probe selected</source>
        <translation>Keine Sonde ausgewählt</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <translation>%1 backen</translation>
    </message>
    <message>
        <source>%1 of %2 baked files are missing or out of date: those probes were captured again. Save baked probes to renew the files</source>
        <translation>%1 von %2 gebackenen Dateien fehlen oder sind veraltet: diese Sonden wurden neu aufgenommen. Gebackene Sonden speichern, um die Dateien zu erneuern</translation>
    </message>
    <message>
        <source>Save baked probes</source>
        <translation>Gebackene Sonden speichern</translation>
    </message>
    <message>
        <source>Save the baked probes to %1, where the scene finds them?</source>
        <translation>Die gebackenen Sonden in %1 speichern, wo die Szene sie findet?</translation>
    </message>
    <message>
        <source>Another folder...</source>
        <translation>Anderer Ordner...</translation>
    </message>
    <message>
        <source>Save baked probes to a folder</source>
        <translation>Gebackene Sonden in einem Ordner speichern</translation>
    </message>
    <message>
        <source>Saving baked probes: %1 left</source>
        <translation>Gebackene Sonden werden gespeichert: noch %1</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1</source>
        <translation>1 Datei nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2</source>
        <translation>%1 Dateien nach %2 geschrieben</translation>
    </message>
    <message>
        <source>%1; not written because not finished: %2</source>
        <translation>%1; nicht geschrieben, weil nicht fertig: %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::BlendRow</name>
    <message>
        <source>- faces</source>
        <translation>Flächen -</translation>
    </message>
    <message>
        <source>+ faces</source>
        <translation>Flächen +</translation>
    </message>
    <message>
        <source>%1 The weight is 1 inside the dashed box. Sets all six faces.</source>
        <translation>%1 In der gestrichelten Box ist das Gewicht 1. Setzt alle sechs Flächen.</translation>
    </message>
    <message>
        <source>One distance for each of the six faces</source>
        <translation>Eine Strecke für jede der sechs Flächen</translation>
    </message>
    <message>
        <source>up to </source>
        <translation>bis zu </translation>
    </message>
</context>
<context>
    <name>boxprobe::CameraMenu</name>
    <message>
        <source>&amp;Store this view...</source>
        <translation>Diese Ansicht &amp;speichern...</translation>
    </message>
    <message>
        <source>&amp;Move here</source>
        <translation>&amp;Hierher bewegen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Store this view</source>
        <translation>Diese Ansicht speichern</translation>
    </message>
    <message>
        <source>Name of the camera</source>
        <translation>Name der Kamera</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>Kamera umbenennen</translation>
    </message>
</context>
<context>
    <name>boxprobe::CapturePanel</name>
    <message>
        <source>Capture</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Baked</source>
        <translation>Gebacken</translation>
    </message>
    <message>
        <source>Realtime</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Custom image</source>
        <translation>Eigenes Bild</translation>
    </message>
    <message>
        <source>Face size</source>
        <translation>Flächengröße</translation>
    </message>
    <message>
        <source>%1 × %1 texels</source>
        <translation>%1 × %1 Texel</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Samples</translation>
    </message>
    <message>
        <source>%1 per texel</source>
        <translation>%1 je Texel</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Abpraller</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Mirrors and metals are black where this probe sees them. With 2 bounces they reflect, too.</source>
        <translation>Spiegel und Metalle sind schwarz, wo diese Sonde sie sieht. Mit 2 Abprallern spiegeln auch sie.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>GGX</source>
        <translation>GGX</translation>
    </message>
    <message>
        <source>Gaussian (frosty)</source>
        <translation>Gauß (mattiert)</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter quality</source>
        <translation>Filterqualität</translation>
    </message>
    <message>
        <source>%1 directions</source>
        <translation>%1 Richtungen</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>Fern</translation>
    </message>
    <message>
        <source>Clear to</source>
        <translation>Leeren mit</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>The same light from all directions</source>
        <translation>Dasselbe Licht aus allen Richtungen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>linear radiance, scene units</source>
        <translation>lineare Strahldichte, Einheiten der Szene</translation>
    </message>
    <message>
        <source>Linear radiance where the probe sees nothing</source>
        <translation>Lineare Strahldichte, wo die Sonde nichts sieht</translation>
    </message>
    <message>
        <source>clear colour</source>
        <translation>Hintergrundfarbe</translation>
    </message>
    <message>
        <source>Hides</source>
        <translation>Verbirgt</translation>
    </message>
    <message>
        <source>hidden objects</source>
        <translation>verborgene Objekte</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Modus</translation>
    </message>
</context>
<context>
    <name>boxprobe::CompareViews</name>
    <message>
        <source>This view shows what you choose here. The error beside it tells how far its display colours are from those of the ray-traced view, or of the scene as it is: the mean in percent of white, and the PSNR. Once the traced view is as fine: its mean light over the traced one&apos;s, and the relative RMSE, as the benchmark of whole pictures measures them</source>
        <translation>Diese Ansicht zeigt, was hier gewählt wird. Der Fehler daneben sagt, wie weit ihre Anzeigefarben von denen der Raytracing-Ansicht oder der Szene, wie sie ist, entfernt sind: der Mittelwert in Prozent von Weiß und die PSNR. Sobald die Raytracing-Ansicht ebenso fein ist: das Verhältnis des mittleren Lichts zu dem der Raytracing-Ansicht und die relative RMSE, wie der Benchmark ganzer Bilder sie misst</translation>
    </message>
</context>
<context>
    <name>boxprobe::CompareWipe</name>
    <message>
        <source>Drag: how much of each picture is shown</source>
        <translation>Ziehen: wie viel von jedem Bild gezeigt wird</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Wie es jetzt ist</translation>
    </message>
</context>
<context>
    <name>boxprobe::CostPanel</name>
    <message>
        <source>Measure quickly</source>
        <translation>Schnell messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>CPU time of a frame relative to plain box projection</source>
        <translation>CPU-Zeit eines Frames im Verhältnis zur einfachen Box-Projektion</translation>
    </message>
    <message>
        <source>RMSE of (x/(1+x))^(1/2.2) relative to the integral over the box</source>
        <translation>RMSE von (x/(1+x))^(1/2.2) im Verhältnis zum Integral über die Box</translation>
    </message>
    <message>
        <source>Double-click to use this technique for the selected probe</source>
        <translation>Doppelklick verwendet diese Technik für die ausgewählte Sonde</translation>
    </message>
    <message>
        <source>One camera and three roughnesses; takes about a minute</source>
        <translation>Eine Kamera und drei Rauheiten; dauert etwa eine Minute</translation>
    </message>
    <message>
        <source>Every camera and roughness; takes some minutes</source>
        <translation>Jede Kamera und jede Rauheit; dauert einige Minuten</translation>
    </message>
    <message>
        <source>the benchmark could not be started</source>
        <translation>Der Benchmark konnte nicht gestartet werden</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Measuring the scene as it is shown now; you can go on working</source>
        <translation>Die Szene wird so gemessen, wie sie jetzt ist; Sie können weiterarbeiten</translation>
    </message>
    <message>
        <source>%1 techniques measured</source>
        <translation>%1 Techniken gemessen</translation>
    </message>
    <message>
        <source>Not measured yet in this scene. A measurement gives every technique&apos;s frame time and its error against the integral over the box.</source>
        <translation>In dieser Szene noch nicht gemessen. Eine Messung liefert für jede Technik die Zeit je Frame und den Fehler gegenüber dem Integral über die Box.</translation>
    </message>
    <message>
        <source>%1 is on the Pareto front: no measured technique is both cheaper and more accurate.</source>
        <translation>%1 liegt auf der Pareto-Front: keine gemessene Technik ist zugleich günstiger und genauer.</translation>
    </message>
    <message>
        <source>%1 is not on the Pareto front: another technique costs no more and has a lower error.</source>
        <translation>%1 liegt nicht auf der Pareto-Front: eine andere Technik kostet nicht mehr und hat einen kleineren Fehler.</translation>
    </message>
    <message>
        <source>The probe&apos;s technique is not among those measured.</source>
        <translation>Die Technik der Sonde ist nicht unter den gemessenen.</translation>
    </message>
    <message>
        <source>Measured in the example scene gallery, not in this one. Measure measures the scene on show. </source>
        <translation>Gemessen in der Beispielszene gallery, nicht in dieser. „Messen“ misst die gezeigte Szene. </translation>
    </message>
    <message>
        <source>Frame time relative to plain box projection</source>
        <translation>Zeit je Frame im Verhältnis zur einfachen Box-Projektion</translation>
    </message>
</context>
<context>
    <name>boxprobe::DebugView</name>
    <message>
        <source>Explain pixels</source>
        <translation>Pixel erklären</translation>
    </message>
    <message>
        <source>Plan and elevation in the picture</source>
        <translation>Grund- und Aufriss im Bild</translation>
    </message>
    <message>
        <source>View of planar mirrors</source>
        <translation>Ansicht der ebenen Spiegel</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Explains how the pixel under the pointer gets its colour; a click pins it (E)</source>
        <translation>Erklärt, wie der Pixel unter dem Zeiger zu seiner Farbe kommt; ein Klick hält ihn fest (E)</translation>
    </message>
    <message>
        <source>The same drawing stands under the explanation</source>
        <translation>Dieselbe Zeichnung steht unter der Erklärung</translation>
    </message>
    <message>
        <source>Shows each mirror&apos;s mirrored camera and its view through the mirror; for an explained pixel, the reflected ray up to the moving object</source>
        <translation>Zeigt die gespiegelte Kamera jedes Spiegels und ihren Blick durch den Spiegel; für einen erklärten Pixel den reflektierten Strahl bis zum bewegten Objekt</translation>
    </message>
    <message>
        <source>Move the pointer over the picture. A click pins what it explains.</source>
        <translation>Den Zeiger über das Bild bewegen. Ein Klick hält fest, was erklärt wird.</translation>
    </message>
    <message>
        <source>Switch the Explain tool on (E), then move the pointer over the picture.</source>
        <translation>Das Werkzeug Erklären einschalten (E), dann den Zeiger über das Bild bewegen.</translation>
    </message>
    <message>
        <source>Save rays</source>
        <translation>Strahlen speichern</translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation>VTK-Polydaten (*.vtp)</translation>
    </message>
    <message>
        <source>Saved %1 lines to %2</source>
        <translation>%1 Linien in %2 gespeichert</translation>
    </message>
    <message>
        <source>No pixel is explained yet. Press E and point at a surface</source>
        <translation>Noch kein Pixel erklärt. E drücken und auf eine Oberfläche zeigen</translation>
    </message>
    <message>
        <source>Copied the explanation as text</source>
        <translation>Erklärung als Text kopiert</translation>
    </message>
    <message>
        <source>Copied the explanation as JSON</source>
        <translation>Erklärung als JSON kopiert</translation>
    </message>
</context>
<context>
    <name>boxprobe::Editor</name>
    <message>
        <source>%1 probes</source>
        <translation>%1 Sonden</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExplainCard</name>
    <message>
        <source>Follow the pointer</source>
        <translation>Dem Zeiger folgen</translation>
    </message>
    <message>
        <source>Unpins the card (Esc)</source>
        <translation>Löst die Karte (Esc)</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Text kopieren</translation>
    </message>
    <message>
        <source>Copies the whole calculation as text</source>
        <translation>Kopiert die ganze Rechnung als Text</translation>
    </message>
    <message>
        <source>Copy JSON</source>
        <translation>JSON kopieren</translation>
    </message>
    <message>
        <source>Copies the explanation as the command `boxprobe explain` prints it as JSON</source>
        <translation>Kopiert die Erklärung als JSON, wie der Befehl `boxprobe explain` sie ausgibt</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>Beheben</translation>
    </message>
    <message>
        <source>Changes the probe; undo takes it back. It mends this pixel: the lookup error in the debug view shows what it does to the others.</source>
        <translation>Ändert die Sonde; Rückgängig nimmt es zurück. Es behebt diesen Pixel: der Abfragefehler in der Debug-Ansicht zeigt die Wirkung auf die anderen.</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>Festgehalten</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExposureControl</name>
    <message>
        <source>%1 The slider spans %2 stops either way. Keys: [ darker, ] brighter.</source>
        <translation>%1 Der Regler umfasst %2 Blendenstufen in jede Richtung. Tasten: [ dunkler, ] heller.</translation>
    </message>
    <message>
        <source>Set exposure</source>
        <translation>Belichtung setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExposureTools</name>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Sets the exposure that suits the picture as it is now; Undo takes it back</source>
        <translation>Setzt die Belichtung, die zum jetzigen Bild passt; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Set tone mapping</source>
        <translation>Tone-Mapping setzen</translation>
    </message>
    <message>
        <source>Switch ground shadow</source>
        <translation>Bodenschatten umschalten</translation>
    </message>
    <message>
        <source>Switch ambient occlusion</source>
        <translation>Umgebungsverdeckung umschalten</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Set background</source>
        <translation>Hintergrund setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::FaceTags</name>
    <message>
        <source>worst spot: %1 off</source>
        <translation>schlechteste Stelle: %1 daneben</translation>
    </message>
</context>
<context>
    <name>boxprobe::FileCommands</name>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>Änderungen speichern?</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>Die Änderungen in %1 speichern?</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Scenes and models (*.boxprobe.json *.json %1);;Scenes (*.boxprobe.json *.json);;Models (%1)</source>
        <translation>Szenen und Modelle (*.boxprobe.json *.json %1);;Szenen (*.boxprobe.json *.json);;Modelle (%1)</translation>
    </message>
    <message>
        <source>New from a model</source>
        <translation>Neu aus einem Modell</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>Modelle (%1)</translation>
    </message>
    <message>
        <source>Wait until what is being read or fitted is done</source>
        <translation>Bitte warten, bis Lesen oder Anpassen fertig ist</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>%1 (and 1 more warning)</source>
        <translation>%1 (und 1 weitere Warnung)</translation>
    </message>
    <message>
        <source>%1 (and %2 more warnings)</source>
        <translation>%1 (und %2 weitere Warnungen)</translation>
    </message>
    <message>
        <source>Loading cancelled; the scene is unchanged.</source>
        <translation>Laden abgebrochen; die Szene ist unverändert.</translation>
    </message>
    <message>
        <source>Cannot open</source>
        <translation>Öffnen nicht möglich</translation>
    </message>
    <message>
        <source>No sky</source>
        <translation>Kein Himmel</translation>
    </message>
    <message>
        <source>Sky from %1</source>
        <translation>Himmel aus %1</translation>
    </message>
    <message>
        <source>%1 is the sky; turn it under Sky and lights</source>
        <translation>%1 ist der Himmel; drehen unter „Himmel und Lichter“</translation>
    </message>
    <message>
        <source>Sky from a picture</source>
        <translation>Himmel aus einem Bild</translation>
    </message>
    <message>
        <source>Pictures of a sky (*.hdr *.exr)</source>
        <translation>Bilder eines Himmels (*.hdr *.exr)</translation>
    </message>
    <message>
        <source>%1 changed on disk. Your changes stay; File &gt; Reload takes the file instead</source>
        <translation>%1 hat sich auf der Platte geändert. Ihre Änderungen bleiben; Datei &gt; Neu laden nimmt stattdessen die Datei</translation>
    </message>
    <message>
        <source>A lesson is on show; leave it to read the file again</source>
        <translation>Eine Lektion wird gezeigt; verlassen Sie sie, um die Datei neu zu lesen</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Discard your changes and read %1 again?</source>
        <translation>Ihre Änderungen verwerfen und %1 neu lesen?</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>%1 neu gelesen</translation>
    </message>
    <message>
        <source>Not read again: %1</source>
        <translation>Nicht neu gelesen: %1</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Scenes (*%1)</source>
        <translation>Szenen (*%1)</translation>
    </message>
    <message>
        <source>%1 already exists, and is not the file that these changes were made to. Replace it?</source>
        <translation>%1 existiert bereits und ist nicht die Datei, zu der diese Änderungen gehören. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 changed on disk. Replace it by yours?</source>
        <translation>%1 hat sich auf der Platte geändert. Durch Ihre Fassung ersetzen?</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>Recovered %1; save it to keep it</source>
        <translation>%1 wiederhergestellt; zum Behalten speichern</translation>
    </message>
    <message>
        <source>Cannot recover</source>
        <translation>Wiederherstellen nicht möglich</translation>
    </message>
    <message>
        <source>Export image</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Display colours (*.png);;Linear light (*.exr)</source>
        <translation>Anzeigefarben (*.png);;Lineares Licht (*.exr)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>Exportieren nicht möglich</translation>
    </message>
    <message>
        <source>The file&apos;s own</source>
        <translation>Wie in der Datei</translation>
    </message>
</context>
<context>
    <name>boxprobe::FitPanel</name>
    <message>
        <source>Mean error %1, 95 %: %2</source>
        <translation>Mittlerer Fehler %1, 95 %: %2</translation>
    </message>
    <message>
        <source>; light error %1%2%3 %</source>
        <translation>; Lichtfehler %1%2%3 %</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Fits the box of the selected probe to the walls that its origin sees (Ctrl+F)</source>
        <translation>Passt die Box der ausgewählten Sonde an die Wände an, die ihr Ursprung sieht (Strg+F)</translation>
    </message>
    <message>
        <source>Before and after: the angle between the sampled and the true direction, and the error of the sampled light</source>
        <translation>Vorher und nachher: der Winkel zwischen abgetasteter und wahrer Richtung und der Fehler des abgetasteten Lichts</translation>
    </message>
    <message>
        <source>The fit was stopped</source>
        <translation>Das Anpassen wurde gestoppt</translation>
    </message>
    <message>
        <source>The probe changed meanwhile: fit it again</source>
        <translation>Die Sonde hat sich inzwischen geändert: neu anpassen</translation>
    </message>
    <message>
        <source>hardly matters</source>
        <translation>kaum von Belang</translation>
    </message>
    <message>
        <source>gains %1</source>
        <translation>gewinnt %1</translation>
    </message>
    <message>
        <source>, light error %1</source>
        <translation>, Lichtfehler %1</translation>
    </message>
    <message>
        <source>What this face alone changes: the mean angle, and the error of the sampled light (negative is better). Leave out a face that improves the angle but worsens the light.</source>
        <translation>Was diese Fläche allein ändert: der mittlere Winkel und der Fehler des abgetasteten Lichts (negativ ist besser). Eine Fläche weglassen, die den Winkel verbessert, aber das Licht verschlechtert.</translation>
    </message>
    <message>
        <source>Set fit of %1</source>
        <translation>Anpassung von %1 setzen</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>Stopp (%1 %)</translation>
    </message>
    <message>
        <source>Fit box</source>
        <translation>Box anpassen</translation>
    </message>
    <message>
        <source>The box fits already: mean error %1</source>
        <translation>Die Box passt schon: mittlerer Fehler %1</translation>
    </message>
    <message>
        <source>Open: nothing to fit to; the box stays</source>
        <translation>Offen: nichts zum Anpassen; die Box bleibt</translation>
    </message>
    <message>
        <source>The origin is inside of a wall: move it first</source>
        <translation>Der Ursprung liegt in einer Wand: erst verschieben</translation>
    </message>
</context>
<context>
    <name>boxprobe::FootprintView</name>
    <message>
        <source>The probe&apos;s cubemap, unfolded and seen from inside: +Z in the middle, +X to its left. Outlined: the texels that this pixel samples, magnified at the right with their shares in percent.</source>
        <translation>Die Cubemap der Sonde, aufgeklappt und von innen gesehen: +Z in der Mitte, +X links davon. Umrandet: die Texel, die dieser Pixel abtastet, rechts vergrößert mit ihren Anteilen in Prozent.</translation>
    </message>
    <message>
        <source>%1 has no cubemap yet</source>
        <translation>%1 hat noch keine Cubemap</translation>
    </message>
    <message>
        <source>%1
mip level %2 of %3: %4² texels per face</source>
        <translation>%1
Mip-Stufe %2 von %3: %4² Texel je Fläche</translation>
    </message>
    <message>
        <source>
no lookups here</source>
        <translation>
hier keine Abfragen</translation>
    </message>
    <message>
        <source>
one lookup, on face %1</source>
        <translation>
eine Abfrage, auf Fläche %1</translation>
    </message>
    <message>
        <source>
%1 lookups, most on face %2</source>
        <translation>
%1 Abfragen, die meisten auf Fläche %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::FramePanel</name>
    <message>
        <source>Count lookups</source>
        <translation>Abfragen zählen</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>Heatmap</translation>
    </message>
    <message>
        <source>Measure costs</source>
        <translation>Kosten messen</translation>
    </message>
    <message>
        <source>Draws the picture again and counts the cubemap lookups of each pixel</source>
        <translation>Zeichnet das Bild neu und zählt die Cubemap-Abfragen jedes Pixels</translation>
    </message>
    <message>
        <source>Colours the surfaces by their number of lookups, like the view &quot;Lookups&quot; of the Debug tab</source>
        <translation>Färbt die Oberflächen nach der Zahl ihrer Abfragen, wie die Ansicht „Abfragen“ des Reiters Debug</translation>
    </message>
    <message>
        <source>Draws the picture many times with parts of it left out, and tells how much time each part takes</source>
        <translation>Zeichnet das Bild viele Male, wobei Teile weggelassen werden, und nennt die Zeit jedes Teils</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Off: the sky alone</source>
        <translation>Aus: nur der Himmel</translation>
    </message>
    <message>
        <source>Simple: one probe, no blending</source>
        <translation>Einfach: eine Sonde</translation>
    </message>
    <message>
        <source>Blend probes</source>
        <translation>Sonden überblenden</translation>
    </message>
    <message>
        <source>Blend probes and sky</source>
        <translation>Sonden und Himmel</translation>
    </message>
    <message>
        <source>At each pixel</source>
        <translation>An jedem Pixel</translation>
    </message>
    <message>
        <source>One for the object</source>
        <translation>Eine für das Objekt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sonden</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Set probes of %1</source>
        <translation>Sonden von %1 setzen</translation>
    </message>
    <message>
        <source>Set weights of %1</source>
        <translation>Gewichte von %1 setzen</translation>
    </message>
    <message>
        <source>Lookups per pixel: mean %1, at most %2.</source>
        <translation>Abfragen je Pixel: im Mittel %1, höchstens %2.</translation>
    </message>
    <message>
        <source>A frame takes %1 ms of CPU time (all threads).</source>
        <translation>Ein Frame braucht %1 ms CPU-Zeit (alle Threads).</translation>
    </message>
    <message>
        <source>A frame takes %1 ms.</source>
        <translation>Ein Frame braucht %1 ms.</translation>
    </message>
    <message>
        <source>Costs of the frame</source>
        <translation>Kosten des Frames</translation>
    </message>
    <message>
        <source>of these, drawn over</source>
        <translation>davon überzeichnet</translation>
    </message>
    <message>
        <source>Pixels that are worked out and then covered</source>
        <translation>Pixel, die berechnet und dann verdeckt werden</translation>
    </message>
    <message>
        <source>Costs of objects&apos; pixels</source>
        <translation>Kosten der Pixel von Objekten</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>Zeichenaufrufe</translation>
    </message>
    <message>
        <source>with 1 probe</source>
        <translation>mit 1 Sonde</translation>
    </message>
    <message>
        <source>with %1 probes</source>
        <translation>mit %1 Sonden</translation>
    </message>
    <message>
        <source>shader variants</source>
        <translation>Shader-Varianten</translation>
    </message>
    <message>
        <source>Objects that share a shader variant, whatever their textures</source>
        <translation>Objekte, die eine Shader-Variante teilen, gleich welche Texturen sie haben</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>Planar mirrors</source>
        <translation>Ebene Spiegel</translation>
    </message>
    <message>
        <source>Objects and their probes</source>
        <translation>Objekte und ihre Sonden</translation>
    </message>
    <message>
        <source>unlit</source>
        <translation>unbeleuchtet</translation>
    </message>
    <message>
        <source>Material %1. Shares are for the object&apos;s whole bounds; they vary per pixel.</source>
        <translation>Material %1. Die Anteile gelten für die ganze Ausdehnung des Objekts; je Pixel sind sie verschieden.</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Memory by probe</source>
        <translation>Speicher je Sonde</translation>
    </message>
    <message>
        <source>all maps, including those kept for undo</source>
        <translation>alle Maps, auch die für Rückgängig behaltenen</translation>
    </message>
    <message>
        <source>lights %1 object, %2 of them in this frame</source>
        <translation>beleuchtet %1 Objekt, davon %2 in diesem Frame</translation>
    </message>
    <message>
        <source>lights %1 objects, %2 of them in this frame</source>
        <translation>beleuchtet %1 Objekte, davon %2 in diesem Frame</translation>
    </message>
    <message>
        <source>Measuring where the time of a frame goes ...</source>
        <translation>Es wird gemessen, wohin die Zeit eines Frames geht ...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
</context>
<context>
    <name>boxprobe::GaugeRows</name>
    <message>
        <source>Moves face %1 alone to where the box is least wrong: the mean error falls by %2</source>
        <translation>Bewegt nur die Fläche %1 dorthin, wo die Box am wenigsten falsch ist: der mittlere Fehler sinkt um %2</translation>
    </message>
    <message>
        <source>Live error</source>
        <translation>Live-Fehler</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Angle between what reflected rays look up and what they should, while the box is edited</source>
        <translation>Winkel zwischen dem, was reflektierte Strahlen abfragen, und dem, was sie sollten, während die Box bearbeitet wird</translation>
    </message>
    <message>
        <source>The view from before</source>
        <translation>Die Ansicht von vorher</translation>
    </message>
    <message>
        <source>Look at the worst spot (%1)</source>
        <translation>Schlechteste Stelle ansehen (%1)</translation>
    </message>
    <message>
        <source>Look at the worst spot</source>
        <translation>Schlechteste Stelle ansehen</translation>
    </message>
    <message>
        <source>Moves the camera to where reflections are most wrong. The error there is at least every face&apos;s mean.</source>
        <translation>Bewegt die Kamera dorthin, wo Reflexionen am falschesten sind. Der Fehler dort ist mindestens der Mittelwert jeder Fläche.</translation>
    </message>
    <message>
        <source>Mean error %1, 95 % below %2</source>
        <translation>Mittlerer Fehler %1, 95 % unter %2</translation>
    </message>
    <message>
        <source>Face %1 alone can take %2 off the mean: click its button</source>
        <translation>Fläche %1 senkt das Mittel um %2: Knopf klicken</translation>
    </message>
    <message>
        <source>No face alone can take %1 off the mean</source>
        <translation>Keine Fläche allein senkt das Mittel um %1</translation>
    </message>
    <message>
        <source>Mean error of what leaves the box through this face: %1 % of the reflections</source>
        <translation>Mittlerer Fehler dessen, was die Box durch diese Fläche verlässt: %1 % der Reflexionen</translation>
    </message>
</context>
<context>
    <name>boxprobe::GlassFields</name>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>Transmission</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>Brechzahl</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>One-pass</source>
        <translation>Ein Durchgang</translation>
    </message>
    <message>
        <source>Two-pass</source>
        <translation>Zwei Durchgänge</translation>
    </message>
    <message>
        <source>Two-interface</source>
        <translation>Zwei Grenzflächen</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Thin sheet</source>
        <translation>Dünne Scheibe</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Absorption</source>
        <translation>Absorption</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Glass as in the model</source>
        <translation>Glas wie im Modell</translation>
    </message>
    <message>
        <source>Removes the scene&apos;s values above; those in the model file apply again</source>
        <translation>Entfernt die Werte der Szene oben; es gelten wieder die der Modelldatei</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>thinness</source>
        <translation>Dünne</translation>
    </message>
    <message>
        <source>absorption color</source>
        <translation>Absorptionsfarbe</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::HeldPicture</name>
    <message>
        <source>Preparing the picture...</source>
        <translation>Das Bild wird vorbereitet...</translation>
    </message>
</context>
<context>
    <name>boxprobe::HidesList</name>
    <message>
        <source>No object</source>
        <translation>Kein Objekt</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Objects this probe does not see, such as one at its origin. Default: none</source>
        <translation>Objekte, die diese Sonde nicht sieht, etwa eines an ihrem Ursprung. Standard: keine</translation>
    </message>
    <message>
        <source>Not seen by this probe: %1</source>
        <translation>Von dieser Sonde nicht gesehen: %1</translation>
    </message>
    <message>
        <source>The model&apos;s objects have no names</source>
        <translation>Die Objekte des Modells haben keine Namen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ImageFields</name>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>OpenEXR or Radiance HDR, or PNG or JPEG with an encoding: a latitude-longitude map, a cross, a strip, or one of six face files</source>
        <translation>OpenEXR oder Radiance HDR, oder PNG oder JPEG mit einer Kodierung: eine Länge-Breite-Karte, ein Kreuz, ein Streifen oder eine von sechs Flächendateien</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Detected</source>
        <translation>Erkannt</translation>
    </message>
    <message>
        <source>Latitude-longitude</source>
        <translation>Länge-Breite</translation>
    </message>
    <message>
        <source>Strip of faces</source>
        <translation>Flächenstreifen</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>Six files</source>
        <translation>Sechs Dateien</translation>
    </message>
    <message>
        <source>image layout</source>
        <translation>Bildanordnung</translation>
    </message>
    <message>
        <source>Faces seen from</source>
        <translation>Flächensicht</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>view of faces</source>
        <translation>Blick auf Flächen</translation>
    </message>
    <message>
        <source>Image turned by</source>
        <translation>Bilddrehung</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>Kodierung</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>RGBM</source>
        <translation>RGBM</translation>
    </message>
    <message>
        <source>dLDR</source>
        <translation>dLDR</translation>
    </message>
    <message>
        <source>RGBM, linear bytes</source>
        <translation>RGBM, lineare Bytes</translation>
    </message>
    <message>
        <source>encoding</source>
        <translation>Kodierung</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>The brightest radiance that the encoding holds. Default: 34.4932 for RGBM, 4.5948 for dLDR, 5 for RGBM of linear bytes</source>
        <translation>Die hellste Strahldichte, die die Kodierung fasst. Standard: 34.4932 für RGBM, 4.5948 für dLDR, 5 für RGBM aus linearen Bytes</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>The power of M. Default: 2.2 for RGBM, 1 for RGBM of linear bytes</source>
        <translation>Die Potenz von M. Standard: 2.2 für RGBM, 1 für RGBM aus linearen Bytes</translation>
    </message>
    <message>
        <source>Environment image</source>
        <translation>Umgebungsbild</translation>
    </message>
    <message>
        <source>Environment images (*.exr *.hdr *.png *.jpg *.jpeg)</source>
        <translation>Umgebungsbilder (*.exr *.hdr *.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Cannot use this image</source>
        <translation>Dieses Bild ist nicht verwendbar</translation>
    </message>
</context>
<context>
    <name>boxprobe::ImportBar</name>
    <message>
        <source>metres</source>
        <translation>Metern</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimetern</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimetern</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>X up</source>
        <translation>X nach oben</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y nach oben</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z nach oben</translation>
    </message>
    <message>
        <source>Length of one unit in the model file</source>
        <translation>Länge einer Einheit der Modelldatei</translation>
    </message>
    <message>
        <source>Axis that points up in the model file</source>
        <translation>Achse der Modelldatei, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Reads the model that way, and finds probe, camera and light for it again. Undo takes all of it back</source>
        <translation>Liest das Modell so und bestimmt Sonde, Kamera und Licht dafür neu. Rückgängig nimmt alles zurück</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Model &gt; Unit and up axis asks again</source>
        <translation>Modell &gt; Einheit und Hochachse fragt erneut</translation>
    </message>
    <message>
        <source>The file is in</source>
        <translation>Die Datei ist in</translation>
    </message>
    <message>
        <source>with</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>How is the model file meant?</source>
        <translation>Wie ist die Modelldatei gemeint?</translation>
    </message>
    <message>
        <source>%1. Is the file in %2, %3?</source>
        <translation>%1. Ist die Datei in %2, %3?</translation>
    </message>
</context>
<context>
    <name>boxprobe::Inspectors</name>
    <message>
        <source>Inspectors</source>
        <translation>Inspektoren</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonExerciseBox</name>
    <message>
        <source>Exercise %1. %2</source>
        <translation>Übung %1. %2</translation>
    </message>
    <message>
        <source>Show the solution</source>
        <translation>Lösung zeigen</translation>
    </message>
    <message>
        <source>Hide the solution</source>
        <translation>Lösung verbergen</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonListPage</name>
    <message>
        <source>Leave lessons</source>
        <translation>Lektionen verlassen</translation>
    </message>
    <message>
        <source>Forget progress</source>
        <translation>Fortschritt vergessen</translation>
    </message>
    <message>
        <source>&lt;b&gt;Lessons&lt;/b&gt;</source>
        <translation>&lt;b&gt;Lektionen&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Closes the lessons and shows your own scene as you left it</source>
        <translation>Schließt die Lektionen und zeigt Ihre Szene, wie Sie sie verlassen haben</translation>
    </message>
    <message>
        <source>Choose a lesson. Your own scene is kept unchanged and comes back when you leave. You can move everything in a lesson: your changes are your own attempt and never change the lesson.</source>
        <translation>Wählen Sie eine Lektion. Ihre eigene Szene bleibt unverändert und kommt beim Verlassen zurück. In einer Lektion können Sie alles bewegen: Ihre Änderungen sind Ihr eigener Versuch und ändern die Lektion nie.</translation>
    </message>
    <message>
        <source>Marks all lessons as not started</source>
        <translation>Markiert alle Lektionen als nicht begonnen</translation>
    </message>
    <message>
        <source>These lessons cannot be read</source>
        <translation>Diese Lektionen sind nicht lesbar</translation>
    </message>
    <message>
        <source>Faults in the lessons&apos; texts</source>
        <translation>Fehler in den Texten der Lektionen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>go on, %1/%2</source>
        <translation>weiter, %1/%2</translation>
    </message>
    <message>
        <source>%1/%2</source>
        <translation>%1/%2</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonQuestionBox</name>
    <message>
        <source>You have answered this question.</source>
        <translation>Sie haben diese Frage beantwortet.</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>Right. %1</source>
        <translation>Richtig. %1</translation>
    </message>
    <message>
        <source>Not this one. %1</source>
        <translation>Diese nicht. %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonStepPage</name>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>Shows the list of lessons; this one stays open</source>
        <translation>Zeigt die Liste der Lektionen; diese bleibt offen</translation>
    </message>
    <message>
        <source>Leave lessons</source>
        <translation>Lektionen verlassen</translation>
    </message>
    <message>
        <source>Closes the lessons and shows your own scene as you left it</source>
        <translation>Schließt die Lektionen und zeigt Ihre Szene, wie Sie sie verlassen haben</translation>
    </message>
    <message>
        <source>Lesson&apos;s scene</source>
        <translation>Szene der Lektion</translation>
    </message>
    <message>
        <source>Shows the step as the lesson has it; your attempt is kept</source>
        <translation>Zeigt den Schritt, wie die Lektion ihn hat; Ihr Versuch bleibt erhalten</translation>
    </message>
    <message>
        <source>Your try</source>
        <translation>Ihr Versuch</translation>
    </message>
    <message>
        <source>Shows your attempt at this step</source>
        <translation>Zeigt Ihren Versuch zu diesem Schritt</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Discards your attempt. Undo restores it.</source>
        <translation>Verwirft Ihren Versuch. Rückgängig holt ihn zurück.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Previous step (Left, Page Up)</source>
        <translation>Voriger Schritt (Links, Bild auf)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next step (Right, Page Down)</source>
        <translation>Nächster Schritt (Rechts, Bild ab)</translation>
    </message>
    <message>
        <source>Try: %1</source>
        <translation>Versuchen Sie: %1</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>boxprobe lessons %1 -o sheet.png draws the %2.</source>
        <translation>boxprobe lessons %1 -o sheet.png zeichnet die %2.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Schritt %1 von %2</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>This is the lesson&apos;s scene. Your attempt is kept.</source>
        <translation>Dies ist die Szene der Lektion. Ihr Versuch bleibt erhalten.</translation>
    </message>
    <message>
        <source>This is your attempt. The lesson&apos;s scene is kept.</source>
        <translation>Dies ist Ihr Versuch. Die Szene der Lektion bleibt erhalten.</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonTaskBox</name>
    <message>
        <source>Show the answer</source>
        <translation>Antwort zeigen</translation>
    </message>
    <message>
        <source>Solves the task for you, as an edit that you can undo</source>
        <translation>Löst die Aufgabe für Sie, als Bearbeitung, die sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>Measuring...</source>
        <translation>Wird gemessen...</translation>
    </message>
    <message>
        <source>You have solved this task.</source>
        <translation>Sie haben diese Aufgabe gelöst.</translation>
    </message>
    <message>
        <source>undefined here</source>
        <translation>hier nicht definiert</translation>
    </message>
    <message>
        <source>what it is compared with is undefined here</source>
        <translation>womit verglichen wird, ist hier nicht definiert</translation>
    </message>
    <message>
        <source>done above %1</source>
        <translation>gelöst über %1</translation>
    </message>
    <message>
        <source>done below %1</source>
        <translation>gelöst unter %1</translation>
    </message>
    <message>
        <source>solved at %1 ± %2</source>
        <translation>gelöst bei %1 ± %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>Done. %1</source>
        <translation>Gelöst. %1</translation>
    </message>
    <message>
        <source>Let go to measure; with Shift handles move finely</source>
        <translation>Zum Messen loslassen; mit Umschalt bewegen sich Griffe fein</translation>
    </message>
    <message>
        <source>Error of the picture</source>
        <translation>Fehler des Bildes</translation>
    </message>
    <message>
        <source>Difference between the pictures</source>
        <translation>Unterschied der Bilder</translation>
    </message>
    <message>
        <source>Mean light</source>
        <translation>Mittleres Licht</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>Largest jump between two pixels</source>
        <translation>Größter Sprung zwischen zwei Pixeln</translation>
    </message>
    <message>
        <source>Share of lookups that are not a number</source>
        <translation>Anteil der Abfragen, die keine Zahl sind</translation>
    </message>
    <message>
        <source>Angle off the right lookup, degrees</source>
        <translation>Winkel zur richtigen Abfrage, Grad</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonView</name>
    <message>
        <source>Forget progress</source>
        <translation>Fortschritt vergessen</translation>
    </message>
    <message>
        <source>Mark all lessons as not started? This cannot be undone.</source>
        <translation>Alle Lektionen als nicht begonnen markieren? Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Loading cancelled; the scene is unchanged.</source>
        <translation>Laden abgebrochen; die Szene ist unverändert.</translation>
    </message>
    <message>
        <source>This lesson is done</source>
        <translation>Diese Lektion ist fertig</translation>
    </message>
    <message>
        <source>This lesson still has a question or a task</source>
        <translation>Diese Lektion hat noch eine Frage oder Aufgabe</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonVisit</name>
    <message>
        <source>Show the lesson&apos;s scene</source>
        <translation>Szene der Lektion zeigen</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Neu beginnen</translation>
    </message>
</context>
<context>
    <name>boxprobe::LightPanel</name>
    <message>
        <source>directional</source>
        <translation>Richtungslicht</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punktlicht</translation>
    </message>
    <message>
        <source>spot</source>
        <translation>Spotlicht</translation>
    </message>
    <message>
        <source>Sky and lights</source>
        <translation>Himmel und Lichter</translation>
    </message>
    <message>
        <source>Sky turned by</source>
        <translation>Himmelsdrehung</translation>
    </message>
    <message>
        <source>Turn the sky</source>
        <translation>Himmel drehen</translation>
    </message>
    <message>
        <source>Faces seen from</source>
        <translation>Flächensicht</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>Außen</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Set view of the sky&apos;s faces</source>
        <translation>Blick auf die Flächen des Himmels setzen</translation>
    </message>
    <message>
        <source>Lamps</source>
        <translation>Lampen</translation>
    </message>
    <message>
        <source>As shapes</source>
        <translation>Als Formen</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>In der Map</translation>
    </message>
    <message>
        <source>Set lamps</source>
        <translation>Lampen setzen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Lights in the order of the scene file</source>
        <translation>Lichter in der Reihenfolge der Szenendatei</translation>
    </message>
    <message>
        <source>Directional: %1 Others: %2</source>
        <translation>Richtungslicht: %1 Andere: %2</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds a light where the camera is, shining the way it looks</source>
        <translation>Fügt ein Licht am Ort der Kamera hinzu, das in ihre Blickrichtung scheint</translation>
    </message>
    <message>
        <source>As the view</source>
        <translation>Wie die Ansicht</translation>
    </message>
    <message>
        <source>Puts the light where the camera is and aims it the way the camera looks</source>
        <translation>Setzt das Licht an den Ort der Kamera und richtet es in ihre Blickrichtung</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes this light</source>
        <translation>Entfernt dieses Licht</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Color of the light</source>
        <translation>Farbe des Lichts</translation>
    </message>
    <message>
        <source>Add %1 light</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Delete light %1</source>
        <translation>Licht %1 löschen</translation>
    </message>
    <message>
        <source>color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>By coverage</source>
        <translation>Nach Abdeckung</translation>
    </message>
    <message>
        <source>By coverage, and for moving objects</source>
        <translation>Abdeckung und bewegte Objekte</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>By size</source>
        <translation>Nach Größe</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>Nach Entfernung</translation>
    </message>
    <message>
        <source>softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Levels per metre</source>
        <translation>Stufen je Meter</translation>
    </message>
    <message>
        <source>Set %1 of light %2</source>
        <translation>%1 von Licht %2 setzen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Its sun</source>
        <translation>Seine Sonne</translation>
    </message>
    <message>
        <source>As a light</source>
        <translation>Als Lichtquelle</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Set the sky&apos;s sun</source>
        <translation>Sonne des Himmels setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::LiveLink</name>
    <message>
        <source>Live link to a file</source>
        <translation>Live-Verbindung in eine Datei</translation>
    </message>
    <message>
        <source>glTF (*.glb)</source>
        <translation>glTF (*.glb)</translation>
    </message>
    <message>
        <source>%1 is the scene&apos;s model; the live link needs a file of its own</source>
        <translation>%1 ist das Modell der Szene; die Live-Verbindung braucht eine eigene Datei</translation>
    </message>
    <message>
        <source>The live link to %1 ended after 1 revision</source>
        <translation>Die Live-Verbindung zu %1 endete nach 1 Fassung</translation>
    </message>
    <message>
        <source>The live link to %1 ended after %2 revisions</source>
        <translation>Die Live-Verbindung zu %1 endete nach %2 Fassungen</translation>
    </message>
    <message>
        <source>Live link: %1</source>
        <translation>Live-Verbindung: %1</translation>
    </message>
    <message>
        <source>%1 follows the scene</source>
        <translation>%1 folgt der Szene</translation>
    </message>
</context>
<context>
    <name>boxprobe::MaterialPanel</name>
    <message>
        <source>Reset to the model&apos;s own</source>
        <translation>Auf Modellwert zurücksetzen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Material of the model, by its name in the file</source>
        <translation>Material des Modells, nach seinem Namen in der Datei</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Removes the scene&apos;s value; the value in the model file applies again</source>
        <translation>Entfernt den Wert der Szene; es gilt wieder der der Modelldatei</translation>
    </message>
    <message>
        <source>Reset roughness of %1</source>
        <translation>Rauheit von %1 zurücksetzen</translation>
    </message>
    <message>
        <source>Set roughness of %1</source>
        <translation>Rauheit von %1 setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::MenuBar</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Debug</source>
        <translation>Deb&amp;ug</translation>
    </message>
    <message>
        <source>&amp;Surfaces coloured by</source>
        <translation>&amp;Oberflächen einfärben nach</translation>
    </message>
    <message>
        <source>Hel&amp;p</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Look &amp;along an axis</source>
        <translation>Entlang einer A&amp;chse blicken</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>E&amp;xposure</source>
        <translation>&amp;Belichtung</translation>
    </message>
    <message>
        <source>To&amp;ne mapping</source>
        <translation>Tone-Ma&amp;pping</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>Hin&amp;tergrund</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>Farbschema (&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Griffe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>%1 probes</source>
        <translation>%1 Sonden</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>&amp;Duplicate %1</source>
        <translation>%1 &amp;duplizieren</translation>
    </message>
    <message>
        <source>De&amp;lete %1</source>
        <translation>%1 &amp;löschen</translation>
    </message>
    <message>
        <source>&amp;Copy %1</source>
        <translation>%1 &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Bake %1</source>
        <translation>%1 &amp;backen</translation>
    </message>
    <message>
        <source>Turn the s&amp;ky</source>
        <translation>Himmel drehen (&amp;Q)</translation>
    </message>
</context>
<context>
    <name>boxprobe::ModelFitter</name>
    <message>
        <source>Interior</source>
        <translation>Innenraum</translation>
    </message>
    <message>
        <source>Open place</source>
        <translation>Offener Ort</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Lights of the file</source>
        <translation>Lichter der Datei</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Lamps under the ceiling</source>
        <translation>Lampen unter der Decke</translation>
    </message>
    <message>
        <source>Sky through the openings</source>
        <translation>Himmel durch die Öffnungen</translation>
    </message>
    <message>
        <source>Sky and sun</source>
        <translation>Himmel und Sonne</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modell</translation>
    </message>
    <message>
        <source>&amp;Treat as</source>
        <translation>&amp;Behandeln als</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Licht</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>Wie gefunden</translation>
    </message>
    <message>
        <source>By the kind of model</source>
        <translation>Nach der Art des Modells</translation>
    </message>
    <message>
        <source>&amp;Unit and up axis...</source>
        <translation>&amp;Einheit und Hochachse...</translation>
    </message>
    <message>
        <source>Kind of model</source>
        <translation>Art des Modells</translation>
    </message>
    <message>
        <source>Kind of model: %1</source>
        <translation>Art des Modells: %1</translation>
    </message>
    <message>
        <source>Treat as %1</source>
        <translation>Als %1 behandeln</translation>
    </message>
    <message>
        <source>Treat as found</source>
        <translation>Wie gefunden behandeln</translation>
    </message>
    <message>
        <source>Replace light</source>
        <translation>Licht ersetzen</translation>
    </message>
    <message>
        <source>Read in %1, %2</source>
        <translation>In %1 gelesen, %2</translation>
    </message>
    <message>
        <source>Fitting the model</source>
        <translation>Das Modell wird angepasst</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Automatische Belichtung</translation>
    </message>
    <message>
        <source>As the picture asks</source>
        <translation>Wie das Bild es verlangt</translation>
    </message>
    <message>
        <source>%1; exposure %2</source>
        <translation>%1; Belichtung %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::ObjectPanel</name>
    <message>
        <source>Moving object: baked probes do not capture it</source>
        <translation>Bewegtes Objekt: nicht in gebackenen Sonden</translation>
    </message>
    <message>
        <source>Reflects objects that move</source>
        <translation>Spiegelt bewegte Objekte</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Object of the model, by its node&apos;s name in the file</source>
        <translation>Objekt des Modells, nach dem Namen seines Knotens in der Datei</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Bewegt um</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Planar mirror</source>
        <translation>Ebener Spiegel</translation>
    </message>
    <message>
        <source>A second, mirrored camera draws moving objects over what the probes reflect. One flat surface only</source>
        <translation>Eine zweite, gespiegelte Kamera zeichnet bewegte Objekte über das, was die Sonden spiegeln. Nur für eine flache Oberfläche</translation>
    </message>
    <message>
        <source>Roughness limit</source>
        <translation>Rauheitsgrenze</translation>
    </message>
    <message>
        <source>Texels per pixel</source>
        <translation>Texel je Pixel</translation>
    </message>
    <message>
        <source>Set whether %1 moves</source>
        <translation>Setzen, ob sich %1 bewegt</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Set roughness limit of mirror %1</source>
        <translation>Rauheitsgrenze des Spiegels %1 setzen</translation>
    </message>
    <message>
        <source>Set resolution of mirror %1</source>
        <translation>Auflösung des Spiegels %1 setzen</translation>
    </message>
    <message>
        <source>Make %1 a mirror</source>
        <translation>%1 zum Spiegel machen</translation>
    </message>
    <message>
        <source>Switch mirror %1 off</source>
        <translation>Spiegel %1 ausschalten</translation>
    </message>
    <message>
        <source>It is not one flat surface, so it cannot be a planar mirror.</source>
        <translation>Es ist keine einzelne ebene Fläche und kann daher kein ebener Spiegel sein.</translation>
    </message>
</context>
<context>
    <name>boxprobe::Outliner</name>
    <message>
        <source>Find a name</source>
        <translation>Namen suchen</translation>
    </message>
    <message>
        <source>Lists only what has this in its name</source>
        <translation>Listet nur, was dies im Namen hat</translation>
    </message>
    <message>
        <source>Outliner</source>
        <translation>Gliederung</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Adds a probe captured at the centre of the view, with its box fitted to the scene</source>
        <translation>Fügt eine in der Mitte der Ansicht aufgenommene Sonde hinzu, deren Box an die Szene angepasst ist</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the selected probes, a little aside (Ctrl+D)</source>
        <translation>Kopiert die ausgewählten Sonden, etwas daneben (Strg+D)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes the selected probes (Delete)</source>
        <translation>Entfernt die ausgewählten Sonden (Entf)</translation>
    </message>
    <message>
        <source>Only probes can be duplicated; select one</source>
        <translation>Nur Sonden lassen sich duplizieren; eine auswählen</translation>
    </message>
    <message>
        <source>%1 is part of the model and cannot be deleted; H hides it in this window</source>
        <translation>%1 gehört zum Modell und lässt sich nicht löschen; H blendet es in diesem Fenster aus</translation>
    </message>
    <message>
        <source>Objects are part of the model and cannot be deleted; H hides them in this window</source>
        <translation>Objekte gehören zum Modell und lassen sich nicht löschen; H blendet sie in diesem Fenster aus</translation>
    </message>
    <message>
        <source>A light is deleted in the panel Sky and lights</source>
        <translation>Ein Licht wird im Bereich „Himmel und Lichter“ gelöscht</translation>
    </message>
    <message>
        <source>A camera is deleted in its menu (right click)</source>
        <translation>Eine Kamera wird in ihrem Menü gelöscht (Rechtsklick)</translation>
    </message>
    <message>
        <source>Select a probe to delete</source>
        <translation>Zum Löschen eine Sonde auswählen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>&amp;Einblenden</translation>
    </message>
    <message>
        <source>Show the &amp;others again</source>
        <translation>Die a&amp;nderen wieder zeigen</translation>
    </message>
    <message>
        <source>Show it a&amp;lone</source>
        <translation>Nur dies &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Unlock</source>
        <translation>Ent&amp;sperren</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>Spe&amp;rren</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>Alles Aus&amp;geblendete zeigen</translation>
    </message>
    <message>
        <source>&amp;Look through it</source>
        <translation>&amp;Hindurchblicken</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>Ein&amp;passen</translation>
    </message>
</context>
<context>
    <name>boxprobe::OutlinerModel</name>
    <message>
        <source>directional %1</source>
        <translation>Richtungslicht %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punktlicht %1</translation>
    </message>
    <message>
        <source>spot %1</source>
        <translation>Spotlicht %1</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>Sonden</translation>
    </message>
    <message>
        <source>Objects (%1)</source>
        <translation>Objekte (%1)</translation>
    </message>
    <message>
        <source>Lamps (%1)</source>
        <translation>Lampen (%1)</translation>
    </message>
    <message>
        <source>Lights (%1)</source>
        <translation>Lichter (%1)</translation>
    </message>
    <message>
        <source>Cameras (%1)</source>
        <translation>Kameras (%1)</translation>
    </message>
    <message>
        <source>An object whose material shines</source>
        <translation>Ein Objekt mit leuchtendem Material</translation>
    </message>
    <message>
        <source>%1 is hidden</source>
        <translation>%1 ist ausgeblendet</translation>
    </message>
    <message>
        <source>%1 is shown</source>
        <translation>%1 ist eingeblendet</translation>
    </message>
    <message>
        <source>Shows or hides it in this window (H). Ctrl+click isolates it (/). The scene file, captures, exported pictures and errors still include it.</source>
        <translation>Blendet es in diesem Fenster ein oder aus (H). Strg+Klick isoliert es (/). Szenendatei, Aufnahmen, exportierte Bilder und Fehler enthalten es weiterhin.</translation>
    </message>
    <message>
        <source>%1 is locked</source>
        <translation>%1 ist gesperrt</translation>
    </message>
    <message>
        <source>%1 is free</source>
        <translation>%1 ist frei</translation>
    </message>
    <message>
        <source>Clicks in the view pass through it and its handles do not move. In this window only; not saved in the scene file.</source>
        <translation>Klicks in der Ansicht gehen hindurch, und seine Griffe bewegen sich nicht. Nur in diesem Fenster; nicht in der Szenendatei gespeichert.</translation>
    </message>
</context>
<context>
    <name>boxprobe::PanelDocks</name>
    <message>
        <source>Outliner</source>
        <translation>Gliederung</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>Einstellung suchen</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>No scene</source>
        <translation>Keine Szene</translation>
    </message>
    <message>
        <source>Open a scene or a model (Ctrl+O).</source>
        <translation>Eine Szene oder ein Modell öffnen (Strg+O).</translation>
    </message>
    <message>
        <source>No probe</source>
        <translation>Keine Sonde</translation>
    </message>
    <message>
        <source>Add one (Ctrl+Shift+A), or place one in every room (Ctrl+Shift+F).</source>
        <translation>Eine hinzufügen (Strg+Umschalt+A) oder in jedem Raum eine platzieren (Strg+Umschalt+F).</translation>
    </message>
    <message>
        <source>Select one in the outliner or in the picture.</source>
        <translation>Eine in der Gliederung oder im Bild auswählen.</translation>
    </message>
    <message>
        <source>The fields show %1; edits go to all of them.</source>
        <translation>Die Felder zeigen %1; Änderungen gelten für alle.</translation>
    </message>
    <message>
        <source>Probe %1 of %2</source>
        <translation>Sonde %1 von %2</translation>
    </message>
    <message>
        <source>No object selected</source>
        <translation>Kein Objekt ausgewählt</translation>
    </message>
    <message>
        <source>The lists below choose an object and a material, too.</source>
        <translation>Auch die Listen unten wählen ein Objekt und ein Material.</translation>
    </message>
    <message>
        <source>Its material: %1</source>
        <translation>Sein Material: %1</translation>
    </message>
    <message>
        <source>Below: the material %1</source>
        <translation>Unten: das Material %1</translation>
    </message>
    <message>
        <source>One of %1 selected. %2</source>
        <translation>Eine von %1 ausgewählten. %2</translation>
    </message>
    <message>
        <source>Sky, lights and picture. Cameras: %1, lights: %2</source>
        <translation>Himmel, Lichter und Bild. Kameras: %1, Lichter: %2</translation>
    </message>
    <message>
        <source>Cubemap</source>
        <translation>Cubemap</translation>
    </message>
    <message>
        <source>Debug</source>
        <translation>Debug</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>Erklären</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kosten</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
</context>
<context>
    <name>boxprobe::Phrase</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The material is unlit: it shows its colour, no light and no probe.</source>
        <translation>Das Material ist unbeleuchtet: es zeigt seine Farbe, kein Licht und keine Sonde.</translation>
    </message>
    <message>
        <source>The surface has no normal here, so there is no reflected ray to project.</source>
        <translation>Die Oberfläche hat hier keine Normale, also gibt es keinen reflektierten Strahl zu projizieren.</translation>
    </message>
    <message>
        <source>The shading normal points away from the eye. A ray reflected about it would start below the surface, so it goes straight on.</source>
        <translation>Die Shading-Normale zeigt vom Auge weg. Ein an ihr reflektierter Strahl begänne unter der Oberfläche, also geht er geradeaus weiter.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: its weight is 0 here, so it is not sampled.</source>
        <translation>Sonde „%1“: ihr Gewicht ist hier 0, also wird sie nicht abgetastet.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot; has not been captured yet: it reflects nothing.</source>
        <translation>Sonde „%1“ ist noch nicht aufgenommen: sie reflektiert nichts.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: technique %2 has no box to hit, so hit point and distance are undefined; the surroundings are taken to be infinitely far away.</source>
        <translation>Sonde „%1“: die Technik %2 hat keine Box, die getroffen wird, also sind Trefferpunkt und Abstand nicht definiert; die Umgebung gilt als unendlich fern.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: the capture origin lies outside the projection box, so a part of the sampled surfaces was never captured from inside the box.</source>
        <translation>Sonde „%1“: der Aufnahmeursprung liegt außerhalb der Projektionsbox, also wurde ein Teil der abgetasteten Oberflächen nie von innerhalb der Box aufgenommen.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: the point lies outside the projection box; distances to planes behind it count as 0 and the hit is pulled on to the box.</source>
        <translation>Sonde „%1“: der Punkt liegt außerhalb der Projektionsbox; Abstände zu Ebenen hinter ihm zählen als 0, und der Treffer wird auf die Box gezogen.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: its distances do not give the true hit here (open sky, or hidden from the capture origin).</source>
        <translation>Sonde „%1“: ihre Abstände ergeben hier keinen wahren Treffer (offener Himmel oder vom Aufnahmeursprung aus verdeckt).</translation>
    </message>
    <message>
        <source>The surface is translucent. What lies behind it shows through and is not explained here.</source>
        <translation>Die Oberfläche ist durchscheinend. Was hinter ihr liegt, scheint durch und wird hier nicht erklärt.</translation>
    </message>
    <message>
        <source>Light passes the glass nearly straight: %1 % of what the picture shows here is what is drawn behind, in place of the lookup, and is not part of this.</source>
        <translation>Licht geht fast gerade durch das Glas: %1 % dessen, was das Bild hier zeigt, ist das dahinter Gezeichnete statt der Abfrage und gehört nicht hierzu.</translation>
    </message>
    <message>
        <source>Where something opaque is drawn along the refracted ray, the picture shows that in place of this lookup.</source>
        <translation>Wo entlang des gebrochenen Strahls etwas Undurchsichtiges gezeichnet ist, zeigt das Bild dieses statt dieser Abfrage.</translation>
    </message>
    <message>
        <source>No probe lights this object, because none reaches it or its probeMode is off. The current sky shows through, not box-projected.</source>
        <translation>Keine Sonde beleuchtet dieses Objekt, weil keine es erreicht oder sein probeMode off ist. Der jetzige Himmel scheint durch, nicht auf die Box projiziert.</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: auto chose %2 for this object&apos;s roughness.</source>
        <translation>Sonde „%1“: auto hat für die Rauheit dieses Objekts %2 gewählt.</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>unendlich</translation>
    </message>
    <message>
        <source>-infinite</source>
        <translation>-unendlich</translation>
    </message>
    <message>
        <source>Surface: object &quot;%1&quot;, material &quot;%2&quot;</source>
        <translation>Oberfläche: Objekt „%1“, Material „%2“</translation>
    </message>
    <message>
        <source>shading point</source>
        <translation>betrachteter Punkt</translation>
    </message>
    <message>
        <source>shading normal, unit</source>
        <translation>Shading-Normale, Einheitsvektor</translation>
    </message>
    <message>
        <source>the surface has no normal here</source>
        <translation>die Oberfläche hat hier keine Normale</translation>
    </message>
    <message>
        <source>towards the eye, unit</source>
        <translation>zum Auge, Einheitsvektor</translation>
    </message>
    <message>
        <source>N bent towards the eye across the brushing; R is about it</source>
        <translation>N, quer zur Bürstrichtung zum Auge gebogen; R ist daran gespiegelt</translation>
    </message>
    <message>
        <source>reflected direction, 2 max(N.V, 0) N - V</source>
        <translation>reflektierte Richtung, 2 max(N.V, 0) N - V</translation>
    </message>
    <message>
        <source>cosine of the view angle</source>
        <translation>Kosinus des Blickwinkels</translation>
    </message>
    <message>
        <source>perceptual roughness; alpha = p^2 = %1</source>
        <translation>wahrgenommene Rauheit; alpha = p^2 = %1</translation>
    </message>
    <message>
        <source>albedo</source>
        <translation>Albedo</translation>
    </message>
    <message>
        <source>base colour; metallic %1</source>
        <translation>Grundfarbe; Metallanteil %1</translation>
    </message>
    <message>
        <source>reflectance at normal incidence: mix(%1, base colour, metallic)</source>
        <translation>Reflexionsgrad bei senkrechtem Einfall: mix(%1, Grundfarbe, Metallanteil)</translation>
    </message>
    <message>
        <source>the material&apos;s occlusion, a factor of all light but emission</source>
        <translation>Verdeckung des Materials, ein Faktor auf alles Licht außer der Emission</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>of the surface</source>
        <translation>der Oberfläche</translation>
    </message>
    <message>
        <source>Sky: %1 of the pixel</source>
        <translation>Himmel: %1 des Pixels</translation>
    </message>
    <message>
        <source>the share that no probe takes, sampled along R at mip level %1</source>
        <translation>der Anteil, den keine Sonde nimmt, entlang R auf Mip-Stufe %1 abgetastet</translation>
    </message>
    <message>
        <source>Glass: %1, seen from within</source>
        <translation>Glas: %1, von innen gesehen</translation>
    </message>
    <message>
        <source>Glass: %1</source>
        <translation>Glas: %1</translation>
    </message>
    <message>
        <source>index on the eye&apos;s side over that beyond; the glass has %1</source>
        <translation>Brechungsindex auf der Seite des Auges durch den dahinter; das Glas hat %1</translation>
    </message>
    <message>
        <source>totally reflected: the view is flatter than the critical angle</source>
        <translation>Totalreflexion: der Blick ist flacher als der Grenzwinkel</translation>
    </message>
    <message>
        <source>exact Fresnel reflectance of a dielectric at N.V</source>
        <translation>exakter Fresnel-Reflexionsgrad eines Dielektrikums bei N.V</translation>
    </message>
    <message>
        <source>refracted view direction, in which the probes are sampled</source>
        <translation>gebrochene Blickrichtung, in der die Sonden abgetastet werden</translation>
    </message>
    <message>
        <source>%1, bent at the front and where it leaves</source>
        <translation>%1, gebrochen vorn und beim Austritt</translation>
    </message>
    <message>
        <source>%1; mirrored within %2 times on the way</source>
        <translation>%1; unterwegs innen %2-mal gespiegelt</translation>
    </message>
    <message>
        <source>from where it is followed to the box</source>
        <translation>von dort wird sie bis zur Box verfolgt</translation>
    </message>
    <message>
        <source>the way within</source>
        <translation>der Weg darin</translation>
    </message>
    <message>
        <source>roughness of a mirror that would scatter as far; gives the mip level</source>
        <translation>Rauheit eines Spiegels, der gleich weit streuen würde; ergibt die Mip-Stufe</translation>
    </message>
    <message>
        <source>left of white light after x</source>
        <translation>was von weißem Licht nach x bleibt</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>factor: transmission (1 - reflected) base colour Beer</source>
        <translation>Faktor: Transmission (1 - reflektiert) Grundfarbe Beer</translation>
    </message>
    <message>
        <source>found along T: %1</source>
        <translation>entlang T gefunden: %1</translation>
    </message>
    <message>
        <source>Planar mirror: objects that move take %1 of the reflection</source>
        <translation>Ebener Spiegel: bewegte Objekte nehmen %1 der Reflexion ein</translation>
    </message>
    <message>
        <source>coverage of the mirror&apos;s picture over the lobe; the probes keep 1 - a</source>
        <translation>Abdeckung des Spiegelbilds über die Keule; den Sonden bleibt 1 - a</translation>
    </message>
    <message>
        <source>along R to what moves, by its height over the mirror</source>
        <translation>entlang R bis zum Bewegten, nach seiner Höhe über dem Spiegel</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>whose texels are as large as the lobe at that distance; %1 fetches</source>
        <translation>deren Texel in diesem Abstand so groß wie die Keule sind; %1 Zugriffe</translation>
    </message>
    <message>
        <source>its light, times a</source>
        <translation>sein Licht, mal a</translation>
    </message>
    <message>
        <source>factor of L_dyn: share and intensity of the probes</source>
        <translation>Faktor von L_dyn: Anteil und Intensität der Sonden</translation>
    </message>
    <message>
        <source>Light %1: what lets it through</source>
        <translation>Licht %1: was davon durchkommt</translation>
    </message>
    <message>
        <source>towards the light</source>
        <translation>zum Licht</translation>
    </message>
    <message>
        <source>along L to where it leaves the box of probe &quot;%1&quot;</source>
        <translation>entlang L bis zum Austritt aus der Box der Sonde „%1“</translation>
    </message>
    <message>
        <source>there; what the probe&apos;s coverage is looked up for</source>
        <translation>dort; dafür wird die Abdeckung der Sonde abgefragt</translation>
    </message>
    <message>
        <source>1 - coverage, coloured by glass, at level %1</source>
        <translation>1 - Abdeckung, von Glas gefärbt, auf Stufe %1</translation>
    </message>
    <message>
        <source>factor of the shadow map of what moves</source>
        <translation>Faktor der Shadow Map der bewegten Objekte</translation>
    </message>
    <message>
        <source>through</source>
        <translation>durchgelassen</translation>
    </message>
    <message>
        <source>none: the surface faces away from it</source>
        <translation>nichts: die Oberfläche ist ihm abgewandt</translation>
    </message>
    <message>
        <source>factor of the light in `direct`</source>
        <translation>Faktor des Lichts in „direkt“</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>direct</source>
        <translation>direkt</translation>
    </message>
    <message>
        <source>light sources</source>
        <translation>Lichtquellen</translation>
    </message>
    <message>
        <source>emissive</source>
        <translation>emittiert</translation>
    </message>
    <message>
        <source>the surface&apos;s own light</source>
        <translation>eigenes Licht der Oberfläche</translation>
    </message>
    <message>
        <source>light from all directions around N, times the base colour; %1 of the pixel</source>
        <translation>Licht aus allen Richtungen um N, mal Grundfarbe; %1 des Pixels</translation>
    </message>
    <message>
        <source>light from all directions around N, times the base colour</source>
        <translation>Licht aus allen Richtungen um N, mal Grundfarbe</translation>
    </message>
    <message>
        <source>diffuse</source>
        <translation>diffus</translation>
    </message>
    <message>
        <source>reflected light times F (A + B); A = %1, B = %2 of the split sum</source>
        <translation>reflektiertes Licht mal F (A + B); A = %1, B = %2 aus Split-Sum</translation>
    </message>
    <message>
        <source>reflected light times F_0 A + F_90 B; A = %1, B = %2 of the split sum</source>
        <translation>reflektiertes Licht mal F_0 A + F_90 B; A = %1, B = %2 aus Split-Sum</translation>
    </message>
    <message>
        <source>specular</source>
        <translation>spiegelnd</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>what is looked through: passes times L_T</source>
        <translation>die Durchsicht: Durchgang mal L_T</translation>
    </message>
    <message>
        <source>sheen</source>
        <translation>Stoffglanz</translation>
    </message>
    <message>
        <source>the same light, sent back by cloth&apos;s fibres</source>
        <translation>dasselbe Licht, von den Fasern des Stoffs zurückgeworfen</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>Klarlack</translation>
    </message>
    <message>
        <source>what the clear coat changes</source>
        <translation>was der Klarlack ändert</translation>
    </message>
    <message>
        <source>color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>computed: linear light before exposure</source>
        <translation>berechnet: lineares Licht vor der Belichtung</translation>
    </message>
    <message>
        <source>the pixel as drawn; differs by %1 of the brightest texel</source>
        <translation>das Pixel wie gezeichnet; weicht um %1 des hellsten Texels ab</translation>
    </message>
    <message>
        <source>the pixel as drawn; differs by %1 of the colour</source>
        <translation>das Pixel wie gezeichnet; weicht um %1 der Farbe ab</translation>
    </message>
    <message>
        <source>rendered</source>
        <translation>gezeichnet</translation>
    </message>
    <message>
        <source>Pixel %1, %2</source>
        <translation>Pixel %1, %2</translation>
    </message>
    <message>
        <source>Pixel %1, %2: the background</source>
        <translation>Pixel %1, %2: der Hintergrund</translation>
    </message>
    <message>
        <source>linear light before exposure</source>
        <translation>lineares Licht vor der Belichtung</translation>
    </message>
    <message>
        <source>what the sky shows there, linear</source>
        <translation>was der Himmel dort zeigt, linear</translation>
    </message>
    <message>
        <source>probe &quot;%1&quot; %2 %</source>
        <translation>Sonde „%1“ %2 %</translation>
    </message>
    <message>
        <source>sky %1 %</source>
        <translation>Himmel %1 %</translation>
    </message>
    <message>
        <source>R has no part along %1: that pair of planes is never met</source>
        <translation>R hat keinen Anteil entlang %1: dieses Ebenenpaar wird nie getroffen</translation>
    </message>
    <message>
        <source>counts as 0: P lies beyond that plane</source>
        <translation>zählt als 0: P liegt jenseits dieser Ebene</translation>
    </message>
    <message>
        <source>where the probe was captured</source>
        <translation>wo die Sonde aufgenommen wurde</translation>
    </message>
    <message>
        <source>from the capture origin, along the box&apos;s own axes</source>
        <translation>vom Aufnahmeursprung, entlang der eigenen Achsen der Box</translation>
    </message>
    <message>
        <source>from the capture origin</source>
        <translation>vom Aufnahmeursprung</translation>
    </message>
    <message>
        <source>reflected direction along the box&apos;s own axes</source>
        <translation>reflektierte Richtung entlang der eigenen Achsen der Box</translation>
    </message>
    <message>
        <source>box relative to C, along the box&apos;s own axes</source>
        <translation>Box relativ zu C, entlang ihrer eigenen Achsen</translation>
    </message>
    <message>
        <source>box relative to C</source>
        <translation>Box relativ zu C</translation>
    </message>
    <message>
        <source>along R to the proxy</source>
        <translation>entlang R bis zum Proxy</translation>
    </message>
    <message>
        <source>%1: the ray leaves through the face %2</source>
        <translation>%1: der Strahl tritt durch die Fläche %2 aus</translation>
    </message>
    <message>
        <source>radius of the box&apos;s rounded edges at this roughness</source>
        <translation>Radius der gerundeten Boxkanten bei dieser Rauheit</translation>
    </message>
    <message>
        <source>along R to the hit as the technique refines it, by %1 lookups of the captured distances</source>
        <translation>entlang R bis zum Treffer, wie ihn die Technik verfeinert, mit %1 Abfragen der aufgenommenen Abstände</translation>
    </message>
    <message>
        <source>along R to the rounded edge</source>
        <translation>entlang R bis zur gerundeten Kante</translation>
    </message>
    <message>
        <source>hit point, P + d R</source>
        <translation>Trefferpunkt, P + d R</translation>
    </message>
    <message>
        <source>direction in which the cubemap is sampled</source>
        <translation>Richtung, in der die Cubemap abgetastet wird</translation>
    </message>
    <message>
        <source>what the cubemap is looked up with; nothing is hit</source>
        <translation>damit wird die Cubemap abgefragt; nichts wird getroffen</translation>
    </message>
    <message>
        <source>along R to the captured surface; the proxy is off by %1</source>
        <translation>entlang R bis zur aufgenommenen Oberfläche; der Proxy liegt um %1 daneben</translation>
    </message>
    <message>
        <source>along R to the captured surface</source>
        <translation>entlang R bis zur aufgenommenen Oberfläche</translation>
    </message>
    <message>
        <source>texel %1, %2 of face %3, level %4</source>
        <translation>Texel %1, %2 der Fläche %3, Stufe %4</translation>
    </message>
    <message>
        <source>%1 more texels</source>
        <translation>%1 weitere Texel</translation>
    </message>
    <message>
        <source>level %1 of 0 to %2, baked for roughness %3</source>
        <translation>Stufe %1 von 0 bis %2, gebacken für Rauheit %3</translation>
    </message>
    <message>
        <source>%1 more lookups, which bring less light: %2 together, their mean; levels %3 to %4</source>
        <translation>%1 weitere Abfragen, die weniger Licht bringen: zusammen %2, ihr Mittelwert; Stufen %3 bis %4</translation>
    </message>
    <message>
        <source>lamp &quot;%1&quot; as a shape: it fills %2 of the cosine hemisphere around N</source>
        <translation>Lampe „%1“ als Form: sie füllt %2 der Kosinus-Halbkugel um N</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>%1 by %2 (within something: filled from its neighbours)</source>
        <translation>%1 zu %2 (in einem Ding: aus seinen Nachbarn aufgefüllt)</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>everything else, from a lattice of %1 x %2 x %3 nodes (%5 ways between them cut): %4</source>
        <translation>alles andere, aus einem Gitter von %1 x %2 x %3 Knoten (%5 Wege zwischen ihnen getrennt): %4</translation>
    </message>
    <message>
        <source>everything else, from a lattice of %1 x %2 x %3 nodes: %4</source>
        <translation>alles andere, aus einem Gitter von %1 x %2 x %3 Knoten: %4</translation>
    </message>
    <message>
        <source>%1 (sharper than the surface&apos;s %2)</source>
        <translation>%1 (schärfer als %2 der Oberfläche)</translation>
    </message>
    <message>
        <source>%1 (softer than the surface&apos;s %2)</source>
        <translation>%1 (weicher als %2 der Oberfläche)</translation>
    </message>
    <message>
        <source>fetch</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>fetch %1</source>
        <translation>Zugriff %1</translation>
    </message>
    <message>
        <source>the probe&apos;s reflected light: its lookups by their shares</source>
        <translation>reflektiertes Licht der Sonde: ihre Abfragen nach ihren Anteilen</translation>
    </message>
    <message>
        <source>how much of that the probe covers; the sky shows for 1 - a</source>
        <translation>wie viel davon die Sonde abdeckt; für 1 - a zeigt sich der Himmel</translation>
    </message>
    <message>
        <source>mean of the sky that each lookup sees</source>
        <translation>Mittel des Himmels, den jede Abfrage sieht</translation>
    </message>
    <message>
        <source>the sky along R, not box-projected, at mip level %1</source>
        <translation>der Himmel entlang R, nicht auf die Box projiziert, auf Mip-Stufe %1</translation>
    </message>
    <message>
        <source>factor of L_spec: box occlusion by the distance d</source>
        <translation>Faktor von L_spec: Boxverdeckung nach dem Abstand d</translation>
    </message>
    <message>
        <source>its light from all directions around N, for the diffuse part</source>
        <translation>ihr Licht aus allen Richtungen um N, für den diffusen Teil</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: %2 of the pixel, technique %3</source>
        <translation>Sonde „%1“: %2 des Pixels, Technik %3</translation>
    </message>
    <message>
        <source>weight of its influence box at P; intensity %1</source>
        <translation>Gewicht ihrer Einflussbox bei P; Intensität %1</translation>
    </message>
    <message>
        <source>weight of its influence box at P</source>
        <translation>Gewicht ihrer Einflussbox bei P</translation>
    </message>
    <message>
        <source>none: its share is too small to show</source>
        <translation>keiner: ihr Anteil ist zu klein, um sichtbar zu sein</translation>
    </message>
    <message>
        <source>none: not captured yet, it gives no light</source>
        <translation>keiner: noch nicht aufgenommen, sie gibt kein Licht</translation>
    </message>
    <message>
        <source>true</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>Auge</translation>
    </message>
    <message>
        <source>no box to hit: d and H are undefined</source>
        <translation>keine Box zu treffen: d und H sind nicht definiert</translation>
    </message>
    <message>
        <source>d = min(t_x, t_y, t_z) = min(%1, %2, %3) = %4</source>
        <translation>d = min(t_x, t_y, t_z) = min(%1, %2, %3) = %4</translation>
    </message>
    <message>
        <source>Plan (from above)</source>
        <translation>Grundriss (von oben)</translation>
    </message>
    <message>
        <source>Elevation (from the front)</source>
        <translation>Aufriss (von vorn)</translation>
    </message>
    <message>
        <source>Elevation (from the side)</source>
        <translation>Aufriss (von der Seite)</translation>
    </message>
    <message>
        <source>less than 0.1 degrees</source>
        <translation>weniger als 0.1 Grad</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 Grad</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>Widen the influence box of &quot;%1&quot;: %2</source>
        <translation>Die Einflussbox von „%1“ erweitern: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>The sky</source>
        <translation>Der Himmel</translation>
    </message>
    <message>
        <source>The sky, at %1</source>
        <translation>Der Himmel, zu %1</translation>
    </message>
    <message>
        <source>%1: the scene has no probe.</source>
        <translation>%1: die Szene hat keine Sonde.</translation>
    </message>
    <message>
        <source>%1, because the probeMode of &quot;%2&quot; is off.</source>
        <translation>%1, weil der probeMode von „%2“ off ist.</translation>
    </message>
    <message>
        <source>%1, because every influence box ends short of this point; the nearest, of &quot;%2&quot;, by %3 at %4.</source>
        <translation>%1, weil jede Einflussbox vor diesem Punkt endet; die nächste, von „%2“, um %3 bei %4.</translation>
    </message>
    <message>
        <source>%1, because the influence box of &quot;%2&quot; ends %3 short of this point at %4.</source>
        <translation>%1, weil die Einflussbox von „%2“ bei %4 um %3 vor diesem Punkt endet.</translation>
    </message>
    <message>
        <source>%1: no probe lights this object.</source>
        <translation>%1: keine Sonde beleuchtet dieses Objekt.</translation>
    </message>
    <message>
        <source>%1, because this point lies in the blend distance of &quot;%2&quot; at %3.</source>
        <translation>%1, weil dieser Punkt in der Überblendstrecke von „%2“ bei %3 liegt.</translation>
    </message>
    <message>
        <source>Move the %1 face of &quot;%2&quot; out by %3</source>
        <translation>Fläche %1 von „%2“ um %3 nach außen verschieben</translation>
    </message>
    <message>
        <source>Move the %1 face of &quot;%2&quot; in by %3</source>
        <translation>Fläche %1 von „%2“ um %3 nach innen verschieben</translation>
    </message>
    <message>
        <source>Project the lookups of &quot;%1&quot; on its box</source>
        <translation>Die Abfragen von „%1“ auf ihre Box projizieren</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;</source>
        <translation>Sonde „%1“</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;, at %2</source>
        <translation>Sonde „%1“, zu %2</translation>
    </message>
    <message>
        <source>%1: not captured yet, so it reflects nothing.</source>
        <translation>%1: noch nicht aufgenommen, reflektiert also nichts.</translation>
    </message>
    <message>
        <source>%1: it captured nothing in this direction, so the sky shows through it.</source>
        <translation>%1: sie hat in dieser Richtung nichts aufgenommen, also scheint der Himmel durch.</translation>
    </message>
    <message>
        <source>%1: its capture origin does not see where this ray ends, so its error is unknown.</source>
        <translation>%1: ihr Aufnahmeursprung sieht nicht, wo dieser Strahl endet, also ist ihr Fehler unbekannt.</translation>
    </message>
    <message>
        <source>%1, right to %2.</source>
        <translation>%1, auf %2 genau.</translation>
    </message>
    <message>
        <source>%1, %2 off: it is sampled by the reflection vector alone, without a hit point.</source>
        <translation>%1, um %2 daneben: allein mit dem Reflexionsvektor abgetastet, ohne Trefferpunkt.</translation>
    </message>
    <message>
        <source>the %1 face of its box</source>
        <translation>die Fläche %1 ihrer Box</translation>
    </message>
    <message>
        <source>its proxy</source>
        <translation>ihren Proxy</translation>
    </message>
    <message>
        <source>%1, %2 off: the ray meets %3 %4 before the surface that is there.</source>
        <translation>%1, um %2 daneben: der Strahl trifft %3 %4 vor der Oberfläche, die dort ist.</translation>
    </message>
    <message>
        <source>%1, %2 off: the ray meets %3 %4 behind the surface that is there.</source>
        <translation>%1, um %2 daneben: der Strahl trifft %3 %4 hinter der Oberfläche, die dort ist.</translation>
    </message>
    <message>
        <source>the light sources</source>
        <translation>den Lichtquellen</translation>
    </message>
    <message>
        <source>the surface itself</source>
        <translation>der Oberfläche selbst</translation>
    </message>
    <message>
        <source>light from all around, scattered</source>
        <translation>ringsum einfallendem, gestreutem Licht</translation>
    </message>
    <message>
        <source>Hardly a reflection: %1 of this light is from %2, %3 is reflected.</source>
        <translation>Kaum eine Reflexion: %1 dieses Lichts stammen von %2, %3 sind reflektiert.</translation>
    </message>
    <message>
        <source>The background: no surface is drawn here.</source>
        <translation>Der Hintergrund: hier ist keine Oberfläche gezeichnet.</translation>
    </message>
    <message>
        <source>Glass: %1 of this light came through it.</source>
        <translation>Glas: %1 dieses Lichts kamen hindurch.</translation>
    </message>
    <message>
        <source>The planar mirror&apos;s own picture: something that moves takes %1 of the reflection.</source>
        <translation>Das eigene Bild des ebenen Spiegels: etwas Bewegtes nimmt %1 der Reflexion ein.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 impostor is drawn by box</source>
        <translation>%1 Impostor wird mit der Box gezeichnet</translation>
    </message>
    <message>
        <source>%1 impostors are drawn by box</source>
        <translation>%1 Impostoren werden mit der Box gezeichnet</translation>
    </message>
    <message>
        <source>rays are chosen without tables of light</source>
        <translation>Strahlen werden ohne Lichttabellen gewählt</translation>
    </message>
    <message>
        <source>the sky is not occluded</source>
        <translation>der Himmel wird nicht verdeckt</translation>
    </message>
    <message>
        <source>%1 probe is left out</source>
        <translation>%1 Sonde wird weggelassen</translation>
    </message>
    <message>
        <source>%1 probes are left out</source>
        <translation>%1 Sonden werden weggelassen</translation>
    </message>
    <message>
        <source>moving objects throw no shadow</source>
        <translation>bewegte Objekte werfen keinen Schatten</translation>
    </message>
    <message>
        <source>%1 texture of its material is left out</source>
        <translation>%1 Textur seines Materials wird weggelassen</translation>
    </message>
    <message>
        <source>%1 textures of its material are left out</source>
        <translation>%1 Texturen seines Materials werden weggelassen</translation>
    </message>
    <message>
        <source>%1 object is out of view or hidden: not drawn</source>
        <translation>%1 Objekt ist außer Sicht oder verdeckt: nicht gezeichnet</translation>
    </message>
    <message>
        <source>%1 objects are out of view or hidden: not drawn</source>
        <translation>%1 Objekte sind außer Sicht oder verdeckt: nicht gezeichnet</translation>
    </message>
    <message>
        <source>the sky behind everything shows nowhere: not drawn</source>
        <translation>der Himmel hinter allem ist nirgends zu sehen: nicht gezeichnet</translation>
    </message>
    <message>
        <source>%1 probe lights no visible object: nothing is captured for it</source>
        <translation>%1 Sonde beleuchtet kein sichtbares Objekt: für sie wird nichts aufgenommen</translation>
    </message>
    <message>
        <source>%1 probes light no visible object: nothing is captured for it</source>
        <translation>%1 Sonden beleuchten kein sichtbares Objekt: für sie wird nichts aufgenommen</translation>
    </message>
    <message>
        <source>%1 probe lights only what this frame does not show</source>
        <translation>%1 Sonde beleuchtet nur, was dieses Bild nicht zeigt</translation>
    </message>
    <message>
        <source>%1 probes light only what this frame does not show</source>
        <translation>%1 Sonden beleuchten nur, was dieses Bild nicht zeigt</translation>
    </message>
    <message>
        <source>%1 probe holds no texture</source>
        <translation>%1 Sonde enthält keine Textur</translation>
    </message>
    <message>
        <source>%1 probes hold no texture</source>
        <translation>%1 Sonden enthalten keine Textur</translation>
    </message>
    <message>
        <source>%1 mip level of %2 not filtered: no material samples it</source>
        <translation>%1 Mip-Stufe von %2 nicht gefiltert: kein Material tastet sie ab</translation>
    </message>
    <message>
        <source>%1 mip levels of %2 not filtered: no material samples them</source>
        <translation>%1 Mip-Stufen von %2 nicht gefiltert: kein Material tastet sie ab</translation>
    </message>
    <message>
        <source>%1 draw is unlit: no light, no probe</source>
        <translation>%1 Zeichenaufruf ist unbeleuchtet: kein Licht, keine Sonde</translation>
    </message>
    <message>
        <source>%1 draws are unlit: no light, no probe</source>
        <translation>%1 Zeichenaufrufe sind unbeleuchtet: kein Licht, keine Sonde</translation>
    </message>
    <message>
        <source>%1 draw has no probe: only the sky, no projection</source>
        <translation>%1 Zeichenaufruf ohne Sonde: nur Himmel, keine Projektion</translation>
    </message>
    <message>
        <source>%1 draws have no probe: only the sky, no projection</source>
        <translation>%1 Zeichenaufrufe ohne Sonde: nur Himmel, keine Projektion</translation>
    </message>
    <message>
        <source>%1 draw has one probe at full weight: no weights computed, no second lookup</source>
        <translation>%1 Zeichenaufruf hat eine Sonde mit vollem Gewicht: keine Gewichte berechnet, keine zweite Abfrage</translation>
    </message>
    <message>
        <source>%1 draws have one probe at full weight: no weights computed, no second lookup</source>
        <translation>%1 Zeichenaufrufe haben eine Sonde mit vollem Gewicht: keine Gewichte berechnet, keine zweite Abfrage</translation>
    </message>
    <message>
        <source>%1 draw leaves nothing to the sky: the sky is not sampled</source>
        <translation>%1 Zeichenaufruf lässt dem Himmel nichts übrig: der Himmel wird nicht abgetastet</translation>
    </message>
    <message>
        <source>%1 draws leave nothing to the sky: the sky is not sampled</source>
        <translation>%1 Zeichenaufrufe lassen dem Himmel nichts übrig: der Himmel wird nicht abgetastet</translation>
    </message>
    <message>
        <source>mirror &quot;%1&quot; has no picture: %2</source>
        <translation>Spiegel „%1“ hat kein Bild: %2</translation>
    </message>
    <message>
        <source>%1 object that moves</source>
        <translation>%1 bewegtes Objekt</translation>
    </message>
    <message>
        <source>%1 objects that move</source>
        <translation>%1 bewegte Objekte</translation>
    </message>
    <message>
        <source>%1 object that may hide them in depth alone</source>
        <translation>%1 Objekt, das sie verdecken kann, nur als Tiefe</translation>
    </message>
    <message>
        <source>%1 objects that may hide them in depth alone</source>
        <translation>%1 Objekte, die sie verdecken können, nur als Tiefe</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 x %3 texels, %4, %5</source>
        <translation>„%1“: %2 x %3 Texel, %4, %5</translation>
    </message>
    <message>
        <source>objects.%1: %2 probe beyond the %3 most important ones reach it and are left out; divide the object, or raise importance where it counts</source>
        <translation>Objekt „%1“: außer den %3 wichtigsten Sonden erreicht es noch %2 und wird weggelassen; das Objekt teilen oder die Wichtigkeit erhöhen, wo es darauf ankommt</translation>
    </message>
    <message>
        <source>objects.%1: %2 probes beyond the %3 most important ones reach it and are left out; divide the object, or raise importance where it counts</source>
        <translation>Objekt „%1“: außer den %3 wichtigsten Sonden erreichen es noch %2 und werden weggelassen; das Objekt teilen oder die Wichtigkeit erhöhen, wo es darauf ankommt</translation>
    </message>
    <message>
        <source>objects.%1: this OpenGL driver has too few texture units for its probes and textures; %2</source>
        <translation>Objekt „%1“: dieser OpenGL-Treiber hat zu wenige Textureinheiten für seine Sonden und Texturen; %2</translation>
    </message>
    <message>
        <source>it is switched off, hidden, or not lit by probes</source>
        <translation>er ist ausgeschaltet, ausgeblendet oder nicht von Sonden beleuchtet</translation>
    </message>
    <message>
        <source>it is rougher than its maxRoughness</source>
        <translation>er ist rauer als seine maxRoughness</translation>
    </message>
    <message>
        <source>it faces away</source>
        <translation>er ist abgewandt</translation>
    </message>
    <message>
        <source>it is out of view</source>
        <translation>er ist außer Sicht</translation>
    </message>
    <message>
        <source>no dynamic object is in its view</source>
        <translation>kein bewegtes Objekt ist in seiner Sicht</translation>
    </message>
    <message>
        <source>larger mirrors used up the mirrorBudget</source>
        <translation>größere Spiegel haben das mirrorBudget verbraucht</translation>
    </message>
    <message>
        <source>No surface at this pixel: it shows the sky, so there is no point, normal or reflected ray.</source>
        <translation>Keine Oberfläche an diesem Pixel: es zeigt den Himmel, also gibt es weder Punkt noch Normale noch reflektierten Strahl.</translation>
    </message>
    <message>
        <source>pictures were not compared: nobody can stand in these rooms</source>
        <translation>Bilder wurden nicht verglichen: in diesen Räumen kann niemand stehen</translation>
    </message>
    <message>
        <source>pictures were not compared: only lamps and unlit surfaces are seen</source>
        <translation>Bilder wurden nicht verglichen: zu sehen sind nur Lampen und unbeleuchtete Oberflächen</translation>
    </message>
    <message>
        <source>pictures were not compared: the light that reaches the rooms is too little to tell it from noise</source>
        <translation>Bilder wurden nicht verglichen: in die Räume fällt zu wenig Licht, um es vom Rauschen zu unterscheiden</translation>
    </message>
    <message>
        <source>pictures were not compared: the scene has no light</source>
        <translation>Bilder wurden nicht verglichen: die Szene hat kein Licht</translation>
    </message>
    <message>
        <source>one box around all rooms: error %1</source>
        <translation>eine Box um alle Räume: Fehler %1</translation>
    </message>
    <message>
        <source>one box around all of the model: error %1</source>
        <translation>eine Box um das ganze Modell: Fehler %1</translation>
    </message>
    <message>
        <source>the scene&apos;s own probes, bounces of light: %1; error %2</source>
        <translation>die Sonden der Szene, Abpraller des Lichts: %1; Fehler %2</translation>
    </message>
    <message>
        <source>one box around all rooms measured better than one for each</source>
        <translation>eine Box um alle Räume war messbar besser als eine für jeden</translation>
    </message>
    <message>
        <source>one box around all of the model measured better than those of rooms</source>
        <translation>eine Box um das ganze Modell war messbar besser als die der Räume</translation>
    </message>
    <message>
        <source>fitted to all of the model, which measured better than its rooms</source>
        <translation>dem ganzen Modell angepasst, was messbar besser war als seine Räume</translation>
    </message>
    <message>
        <source>no probe surely made the pictures better: none is proposed</source>
        <translation>keine Sonde hat die Bilder sicher verbessert: keine wird vorgeschlagen</translation>
    </message>
    <message>
        <source>nothing measured surely better than the scene&apos;s own probes, which stay</source>
        <translation>nichts war messbar und sicher besser als die Sonden der Szene, die bleiben</translation>
    </message>
    <message>
        <source>the scene&apos;s own probes stay, bounces of light: %1</source>
        <translation>die Sonden der Szene bleiben, Abpraller des Lichts: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; captured at (%2, %3, %4): error %5 -&gt; %6</source>
        <translation>„%1“ bei (%2, %3, %4) aufgenommen: Fehler %5 -&gt; %6</translation>
    </message>
    <message>
        <source>&quot;%1&quot; captured at (%2, %3, %4): error %5 -&gt; %6, left out</source>
        <translation>„%1“ bei (%2, %3, %4) aufgenommen: Fehler %5 -&gt; %6, weggelassen</translation>
    </message>
    <message>
        <source>pictures of more than %1 probes were compared with at most %2 bounces of light</source>
        <translation>Bilder von mehr als %1 Sonden wurden mit höchstens %2 Abprallern des Lichts verglichen</translation>
    </message>
    <message>
        <source>%1 probes captured from elsewhere: error %2 -&gt; %3</source>
        <translation>%1 Sonden von anderswo aufgenommen: Fehler %2 -&gt; %3</translation>
    </message>
    <message>
        <source>%1 probes captured from elsewhere: error %2 -&gt; %3, left out</source>
        <translation>%1 Sonden von anderswo aufgenommen: Fehler %2 -&gt; %3, weggelassen</translation>
    </message>
    <message>
        <source>bounces of light in the captures: %1; error %2 -&gt; %3</source>
        <translation>Abpraller des Lichts in den Aufnahmen: %1; Fehler %2 -&gt; %3</translation>
    </message>
    <message>
        <source>bounces of light in the captures: %1; error %2 -&gt; %3, left out</source>
        <translation>Abpraller des Lichts in den Aufnahmen: %1; Fehler %2 -&gt; %3, weggelassen</translation>
    </message>
    <message>
        <source>without &quot;%1&quot;: error %2 -&gt; %3, it stays</source>
        <translation>ohne „%1“: Fehler %2 -&gt; %3, sie bleibt</translation>
    </message>
    <message>
        <source>without &quot;%1&quot;: error %2 -&gt; %3, left out</source>
        <translation>ohne „%1“: Fehler %2 -&gt; %3, weggelassen</translation>
    </message>
    <message>
        <source>%1; without it the error grows by %2</source>
        <translation>%1; ohne sie wächst der Fehler um %2</translation>
    </message>
    <message>
        <source>%1; without it the error is the same</source>
        <translation>%1; ohne sie ist der Fehler gleich</translation>
    </message>
    <message>
        <source>the origin is inside of a wall: nothing is fitted; move the origin into the room</source>
        <translation>der Ursprung liegt in einer Wand: nichts wird angepasst; den Ursprung in den Raum verschieben</translation>
    </message>
    <message>
        <source>open: nothing to fit to; the box stays</source>
        <translation>offen: nichts zum Anpassen; die Box bleibt</translation>
    </message>
    <message>
        <source>no better box was found: it stays</source>
        <translation>keine bessere Box gefunden: sie bleibt</translation>
    </message>
    <message>
        <source>the place is not rectangular</source>
        <translation>der Ort ist nicht rechteckig</translation>
    </message>
    <message>
        <source>a quarter of the reflections and more stay off by over 5 degrees: use the technique impostor, or more probes</source>
        <translation>ein Viertel der Reflexionen und mehr bleiben um über 5 Grad daneben: die Technik Impostor oder mehr Sonden verwenden</translation>
    </message>
    <message>
        <source>no better origin was found: it stays</source>
        <translation>kein besserer Ursprung gefunden: er bleibt</translation>
    </message>
    <message>
        <source>no room was found: back sides of surfaces close in the space within; if it is a room, its faces are inverted: turn them over, or use --as interior</source>
        <translation>kein Raum gefunden: Rückseiten von Oberflächen umschließen den Innenraum; ist es ein Raum, sind seine Flächen umgekehrt: umdrehen, oder Modell &gt; Behandeln als &gt; Innenraum wählen</translation>
    </message>
    <message>
        <source>open: no room was found; nothing is closed in by a floor and walls</source>
        <translation>offen: kein Raum gefunden; nichts ist von Boden und Wänden umschlossen</translation>
    </message>
    <message>
        <source>the scene&apos;s probes stay</source>
        <translation>die Sonden der Szene bleiben</translation>
    </message>
    <message>
        <source>the walls show their back sides to the rooms: the model&apos;s faces are inverted</source>
        <translation>die Wände zeigen den Räumen ihre Rückseiten: die Flächen des Modells sind umgekehrt</translation>
    </message>
    <message>
        <source>%1 closed spaces are too small for a room and have no probe</source>
        <translation>%1 geschlossene Hohlräume sind zu klein für einen Raum und haben keine Sonde</translation>
    </message>
    <message>
        <source>the model is very large for the height of its rooms: doors may be missed</source>
        <translation>das Modell ist für die Höhe seiner Räume sehr groß: Türen können übersehen werden</translation>
    </message>
    <message>
        <source>it has the probe %1, which is kept</source>
        <translation>er hat die Sonde %1, die bleibt</translation>
    </message>
    <message>
        <source>%1: its origin is in no room, inside of a wall or in the open; it is kept</source>
        <translation>%1: ihr Ursprung liegt in keinem Raum, in einer Wand oder im Freien; sie bleibt</translation>
    </message>
    <message>
        <source>left out: it has no ceiling, and no surface in it is smoother than roughness 0.6</source>
        <translation>weggelassen: er hat keine Decke, und keine Oberfläche darin ist glatter als Rauheit 0.6</translation>
    </message>
    <message>
        <source>left out: no more than %1 probes were asked for</source>
        <translation>weggelassen: mehr als %1 Sonden waren nicht verlangt</translation>
    </message>
    <message>
        <source>its first probe leaves %1 of %2 degrees</source>
        <translation>seine erste Sonde lässt %1 von %2 Grad</translation>
    </message>
    <message>
        <source>of %1 more places the best gains %2 degrees; %3 are needed</source>
        <translation>von %1 weiteren Plätzen gewinnt der beste %2 Grad; nötig sind %3</translation>
    </message>
    <message>
        <source>one more would gain %1 degrees; no more than %2 probes were asked for</source>
        <translation>eine weitere würde %1 Grad gewinnen; mehr als %2 Sonden waren nicht verlangt</translation>
    </message>
    <message>
        <source>one more gains %1 degrees</source>
        <translation>eine weitere gewinnt %1 Grad</translation>
    </message>
    <message>
        <source>the others cover its first probe, which gains only %1 degrees: left out</source>
        <translation>die anderen decken seine erste Sonde ab, die nur %1 Grad gewinnt: weggelassen</translation>
    </message>
    <message>
        <source>for what is seen outside of the rooms: %1 % of all surfaces</source>
        <translation>für das außerhalb der Räume Sichtbare: %1 % aller Oberflächen</translation>
    </message>
    <message>
        <source>the only one of %1</source>
        <translation>die einzige von %1</translation>
    </message>
    <message>
        <source>for all of %1</source>
        <translation>für ganz %1</translation>
    </message>
    <message>
        <source>for a part of %1, where it lowers the lookup error by %2 degrees</source>
        <translation>für einen Teil von %1, wo sie den Abfragefehler um %2 Grad senkt</translation>
    </message>
    <message>
        <source>under 1 s left</source>
        <translation>noch unter 1 s</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>noch %1 min</translation>
    </message>
    <message>
        <source>the file has no light: %1</source>
        <translation>die Datei hat kein Licht: %1</translation>
    </message>
    <message>
        <source>as you chose, %1</source>
        <translation>wie gewählt: %1</translation>
    </message>
    <message>
        <source>there is no room with a ceiling: %1</source>
        <translation>es gibt keinen Raum mit Decke: %1</translation>
    </message>
    <message>
        <source>there are no openings: %1</source>
        <translation>es gibt keine Öffnungen: %1</translation>
    </message>
    <message>
        <source>the file has no light, and you chose the file&apos;s</source>
        <translation>die Datei hat kein Licht, und gewählt ist das der Datei</translation>
    </message>
    <message>
        <source>the light is the file&apos;s</source>
        <translation>das Licht ist das der Datei</translation>
    </message>
    <message>
        <source>the lights are the file&apos;s</source>
        <translation>die Lichter sind die der Datei</translation>
    </message>
    <message>
        <source>a studio lights it</source>
        <translation>ein Studio beleuchtet es</translation>
    </message>
    <message>
        <source>soft lamps hang under the ceiling</source>
        <translation>weiche Lampen hängen unter der Decke</translation>
    </message>
    <message>
        <source>the sky shines in through the openings</source>
        <translation>der Himmel scheint durch die Öffnungen herein</translation>
    </message>
    <message>
        <source>sky and sun light it</source>
        <translation>Himmel und Sonne beleuchten es</translation>
    </message>
    <message>
        <source>an open place</source>
        <translation>offener Ort</translation>
    </message>
    <message>
        <source>an interior</source>
        <translation>Innenraum</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>treated as %1 as you chose</source>
        <translation>als %1 behandelt, wie gewählt</translation>
    </message>
    <message>
        <source>treated as %1 (%2)</source>
        <translation>als %1 behandelt (%2)</translation>
    </message>
    <message>
        <source>one probe within it</source>
        <translation>eine Sonde darin</translation>
    </message>
    <message>
        <source>no probe, the surroundings alone are reflected</source>
        <translation>keine Sonde, nur die Umgebung wird reflektiert</translation>
    </message>
    <message>
        <source>%1; %2; %3</source>
        <translation>%1; %2; %3</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>%1 m hoch</translation>
    </message>
    <message>
        <source>%1 m wide</source>
        <translation>%1 m breit</translation>
    </message>
    <message>
        <source>It seems to lie on its side</source>
        <translation>Es scheint auf der Seite zu liegen</translation>
    </message>
    <message>
        <source>In metres it would be %1, and it seems to lie on its side</source>
        <translation>In Metern wäre es %1, und es scheint auf der Seite zu liegen</translation>
    </message>
    <message>
        <source>In metres it would be %1</source>
        <translation>In Metern wäre es %1</translation>
    </message>
    <message>
        <source>%1 of the points within it are closed in by front sides</source>
        <translation>%1 der Punkte darin sind von Vorderseiten umschlossen</translation>
    </message>
    <message>
        <source>%1 of the points within it have a floor, walls around and sky above</source>
        <translation>%1 der Punkte darin haben einen Boden, Wände ringsum und Himmel darüber</translation>
    </message>
    <message>
        <source>%1 of the points within it stand over a floor, below the sky</source>
        <translation>%1 der Punkte darin stehen über einem Boden unter dem Himmel</translation>
    </message>
    <message>
        <source>%1 of the points within it lie inside of it or see back sides</source>
        <translation>%1 der Punkte darin liegen in seinem Inneren oder sehen Rückseiten</translation>
    </message>
    <message>
        <source>%1 of the rays from points within it leave to the sky</source>
        <translation>%1 der Strahlen von Punkten darin gehen in den Himmel</translation>
    </message>
    <message>
        <source>it has no surface that hides what is behind it</source>
        <translation>es hat keine Oberfläche, die etwas hinter sich verdeckt</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
</context>
<context>
    <name>boxprobe::PictureCompare</name>
    <message>
        <source>Held</source>
        <translation>Festgehalten</translation>
    </message>
    <message>
        <source>The picture is held on the right: change something, drag the divider, V flips</source>
        <translation>Das Bild ist rechts festgehalten: etwas ändern, den Teiler ziehen, V wechselt</translation>
    </message>
    <message>
        <source>Path traced</source>
        <translation>Pathtracing</translation>
    </message>
    <message>
        <source>Reflection traced</source>
        <translation>Reflexion per Raytracing</translation>
    </message>
    <message>
        <source>All light, path traced in the background, with as many bounces as the probes have. V flips, Esc ends it</source>
        <translation>Alles Licht, im Hintergrund per Pathtracing, mit so vielen Abprallern wie die Sonden. V wechselt, Esc beendet</translation>
    </message>
    <message>
        <source>The picture with its reflection ray traced: all other light is the picture&apos;s own. Mirrors in mirrors stay black. V flips, Esc ends it</source>
        <translation>Das Bild mit Reflexion per Raytracing: alles übrige Licht ist das des Bildes. Spiegel in Spiegeln bleiben schwarz. V wechselt, Esc beendet</translation>
    </message>
    <message>
        <source>%1: preparing</source>
        <translation>%1: wird vorbereitet</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>The error against all light gets finer as more paths are traced; V shows all of it, Esc ends it</source>
        <translation>Der Fehler gegen alles Licht wird mit mehr Pfaden feiner; V zeigt ihn ganz, Esc beendet</translation>
    </message>
    <message>
        <source>Difference: preparing</source>
        <translation>Differenz: wird vorbereitet</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>Keine Differenz</translation>
    </message>
    <message>
        <source>Difference: PSNR %1 dB</source>
        <translation>Differenz: PSNR %1 dB</translation>
    </message>
    <message>
        <source>Difference: %1</source>
        <translation>Differenz: %1</translation>
    </message>
    <message>
        <source>Difference: mean %1 %, 95 % of the pixels below %2 %, PSNR %3 dB</source>
        <translation>Differenz: im Mittel %1 %, 95 % der Pixel unter %2 %, PSNR %3 dB</translation>
    </message>
    <message>
        <source>. Against the traced: %1</source>
        <translation>. Gegen Raytracing: %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::PictureMenu</name>
    <message>
        <source>Object %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <source>Object %1, material %2</source>
        <translation>Objekt %1, Material %2</translation>
    </message>
    <message>
        <source>No probe lights this place; the sky does</source>
        <translation>Keine Sonde beleuchtet diese Stelle; es ist der Himmel</translation>
    </message>
    <message>
        <source>Probe %1 lights this place</source>
        <translation>Sonde %1 beleuchtet diese Stelle</translation>
    </message>
    <message>
        <source>No probe lights this place; %1 is the nearest</source>
        <translation>Keine Sonde beleuchtet diese Stelle; %1 ist die nächste</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>Sonde %1</translation>
    </message>
    <message>
        <source>Show in the panels</source>
        <translation>In den Bereichen zeigen</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ausblenden</translation>
    </message>
    <message>
        <source>Show the &amp;others again</source>
        <translation>Die a&amp;nderen wieder zeigen</translation>
    </message>
    <message>
        <source>Show it a&amp;lone</source>
        <translation>Nur dies &amp;zeigen</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>Alles Aus&amp;geblendete zeigen</translation>
    </message>
    <message>
        <source>Leave out of the capture of %1</source>
        <translation>Von der Aufnahme von %1 ausnehmen</translation>
    </message>
    <message>
        <source>Leave %1 out</source>
        <translation>%1 ausnehmen</translation>
    </message>
    <message>
        <source>Capture %1 again</source>
        <translation>%1 wieder aufnehmen</translation>
    </message>
</context>
<context>
    <name>boxprobe::PicturePanel</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
</context>
<context>
    <name>boxprobe::PlacePanel</name>
    <message>
        <source>1 room</source>
        <translation>1 Raum</translation>
    </message>
    <message>
        <source>%1 rooms</source>
        <translation>%1 Räume</translation>
    </message>
    <message>
        <source>%1: %2 x %3 x %4</source>
        <translation>%1: %2 x %3 x %4</translation>
    </message>
    <message>
        <source>error %1, %2 % hidden</source>
        <translation>Fehler %1, %2 % verdeckt</translation>
    </message>
    <message>
        <source> (%1 %)</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Replace the probes there are</source>
        <translation>Vorhandene Sonden ersetzen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platzieren</translation>
    </message>
    <message>
        <source>Finds the rooms of the scene, places fitted probes in them, and proposes what makes pictures better by the path tracer&apos;s measure (Ctrl+Shift+F)</source>
        <translation>Findet die Räume der Szene, platziert angepasste Sonden und schlägt vor, was Bilder nach dem Maß des Pathtracers besser macht (Strg+Umschalt+F)</translation>
    </message>
    <message>
        <source>Relative error of the light in pictures of the rooms, before and after; mirrors count four times. 0 is what the path tracer draws</source>
        <translation>Relativer Fehler des Lichts in Bildern der Räume, vorher und nachher; Spiegel zählen vierfach. 0 ist, was der Pathtracer zeichnet</translation>
    </message>
    <message>
        <source>Placing was stopped</source>
        <translation>Das Platzieren wurde gestoppt</translation>
    </message>
    <message>
        <source>Pictures were not compared: %1</source>
        <translation>Bilder wurden nicht verglichen: %1</translation>
    </message>
    <message>
        <source>The scene changed meanwhile: place again</source>
        <translation>Die Szene hat sich inzwischen geändert: neu platzieren</translation>
    </message>
    <message>
        <source>Error of %1 %2</source>
        <translation>Fehler von %1 %2</translation>
    </message>
    <message>
        <source>As it is, but with 1 bounce of light</source>
        <translation>Wie es ist, aber mit 1 Abpraller des Lichts</translation>
    </message>
    <message>
        <source>As it is, but with %1 bounces of light</source>
        <translation>Wie es ist, aber mit %1 Abprallern des Lichts</translation>
    </message>
    <message>
        <source>%1. Error of pictures against the path tracer&apos;s: %2. Light: %3 of the truth&apos;s, before %4</source>
        <translation>%1. Fehler der Bilder gegenüber dem Pathtracer: %2. Licht: %3 des wahren, vorher %4</translation>
    </message>
    <message>
        <source>%1. Mean error of lookups, pictures not compared: %2 → %3</source>
        <translation>%1. Mittlerer Fehler der Abfragen, Bilder nicht verglichen: %2 → %3</translation>
    </message>
    <message>
        <source>Place 1 probe</source>
        <translation>1 Sonde platzieren</translation>
    </message>
    <message>
        <source>Place %1 probes</source>
        <translation>%1 Sonden platzieren</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>Stopp (%1 %)</translation>
    </message>
    <message>
        <source>Place probes</source>
        <translation>Sonden platzieren</translation>
    </message>
    <message>
        <source>As it is, but with all bounces of light</source>
        <translation>Wie es ist, aber mit allen Abprallern des Lichts</translation>
    </message>
</context>
<context>
    <name>boxprobe::PlacedList</name>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>Drawn with the current probes</source>
        <translation>Mit den jetzigen Sonden gezeichnet</translation>
    </message>
    <message>
        <source>after</source>
        <translation>nachher</translation>
    </message>
    <message>
        <source>Drawn with the proposed probes</source>
        <translation>Mit den vorgeschlagenen Sonden gezeichnet</translation>
    </message>
    <message>
        <source>traced</source>
        <translation>Pathtracing</translation>
    </message>
    <message>
        <source>Path traced: all light, the truth</source>
        <translation>Per Pathtracing: alles Licht, die Wahrheit</translation>
    </message>
    <message>
        <source>error before</source>
        <translation>Fehler vorher</translation>
    </message>
    <message>
        <source>Error before, up to 25 % of white</source>
        <translation>Fehler vorher, bis 25 % von Weiß</translation>
    </message>
    <message>
        <source>error after</source>
        <translation>Fehler nachher</translation>
    </message>
    <message>
        <source>Error after, in the same colours</source>
        <translation>Fehler nachher, in denselben Farben</translation>
    </message>
    <message>
        <source>%1; click to enlarge</source>
        <translation>%1; zum Vergrößern klicken</translation>
    </message>
    <message>
        <source>Untick what shall not be placed</source>
        <translation>Abwählen, was nicht platziert werden soll</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeClipboard</name>
    <message>
        <source>Copied probe %1 as JSON</source>
        <translation>Sonde %1 als JSON kopiert</translation>
    </message>
    <message>
        <source>Copied %1 as JSON</source>
        <translation>%1 als JSON kopiert</translation>
    </message>
    <message>
        <source>No probe to paste: %1</source>
        <translation>Keine Sonde zum Einfügen: %1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Paste %1 probes</source>
        <translation>%1 Sonden einfügen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeCommands</name>
    <message>
        <source>There is nothing to capture yet: open a model or a scene first (Ctrl+O)</source>
        <translation>Noch ist nichts aufzunehmen: erst ein Modell oder eine Szene öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>A probe needs a name; it stays %1</source>
        <translation>Eine Sonde braucht einen Namen; es bleibt %1</translation>
    </message>
    <message>
        <source>A probe named %1 already exists; each needs its own name</source>
        <translation>Es gibt schon eine Sonde namens %1; jede braucht einen eigenen Namen</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeExporter</name>
    <message>
        <source>Export probes</source>
        <translation>Sonden exportieren</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Für</translation>
    </message>
    <message>
        <source>Export probes to a folder</source>
        <translation>Sonden in einen Ordner exportieren</translation>
    </message>
    <message>
        <source>No probe has a finished capture to export; bake first (F5)</source>
        <translation>Keine Sonde hat eine fertige Aufnahme zum Exportieren; erst backen (F5)</translation>
    </message>
    <message>
        <source>Exporting 1 probe</source>
        <translation>1 Sonde wird exportiert</translation>
    </message>
    <message>
        <source>Exporting %1 probes</source>
        <translation>%1 Sonden werden exportiert</translation>
    </message>
    <message>
        <source>Not exported: another scene was opened meanwhile</source>
        <translation>Nicht exportiert: inzwischen wurde eine andere Szene geöffnet</translation>
    </message>
    <message>
        <source>; not finished: %1</source>
        <translation>; nicht fertig: %1</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1</source>
        <translation>1 Datei nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2</source>
        <translation>%1 Dateien nach %2 geschrieben</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeGauge</name>
    <message>
        <source>The error is still being measured</source>
        <translation>Der Fehler wird noch gemessen</translation>
    </message>
    <message>
        <source>Set face %1 of %2</source>
        <translation>Fläche %1 von %2 setzen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbePanel</name>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>%1 It is the diamond in the picture.</source>
        <translation>%1 Er ist die Raute im Bild.</translation>
    </message>
    <message>
        <source>Box min</source>
        <translation>Box min</translation>
    </message>
    <message>
        <source>Box max</source>
        <translation>Box max</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Extent of the box along its own axes</source>
        <translation>Ausdehnung der Box entlang ihrer eigenen Achsen</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>box min</source>
        <translation>Box min</translation>
    </message>
    <message>
        <source>box max</source>
        <translation>Box max</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>Einfluss</translation>
    </message>
    <message>
        <source>Blend distance</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>blend distance</source>
        <translation>Überblendstrecke</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Wichtigkeit</translation>
    </message>
    <message>
        <source>Separate influence box</source>
        <translation>Eigene Einflussbox</translation>
    </message>
    <message>
        <source>Off: the influence box is the projection box</source>
        <translation>Aus: die Einflussbox ist die Projektionsbox</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>influence box</source>
        <translation>Einflussbox</translation>
    </message>
    <message>
        <source>influence min</source>
        <translation>Einfluss min</translation>
    </message>
    <message>
        <source>influence max</source>
        <translation>Einfluss max</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>Reflexion</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Project onto the box</source>
        <translation>Auf die Box projizieren</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Bevel</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Bevel by roughness</source>
        <translation>Fase je Rauheit</translation>
    </message>
    <message>
        <source>Box occlusion</source>
        <translation>Boxverdeckung</translation>
    </message>
    <message>
        <source>box occlusion</source>
        <translation>Boxverdeckung</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Distance power</source>
        <translation>Abstandspotenz</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>%1 probes are selected. What is set here is set for all; %2 stands where they differ.</source>
        <translation>%1 Sonden sind ausgewählt. Was hier gesetzt wird, gilt für alle; wo sie sich unterscheiden, steht %2.</translation>
    </message>
    <message>
        <source>The selected probes have different techniques.</source>
        <translation>Die ausgewählten Sonden haben verschiedene Techniken.</translation>
    </message>
    <message>
        <source>Diffuse light</source>
        <translation>Diffuses Licht</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>About 1 m apart, closer where light falls steeply</source>
        <translation>Etwa 1 m auseinander, enger, wo das Licht steil abfällt</translation>
    </message>
    <message>
        <source>Spaced by hand</source>
        <translation>Abstand von Hand</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>The whole map lights every place alike</source>
        <translation>Die ganze Map beleuchtet jeden Ort gleich</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>Gitter</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbePreview</name>
    <message>
        <source>Cubemap of the selected probe</source>
        <translation>Cubemap der ausgewählten Sonde</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Captured and filtered radiance at the picture&apos;s exposure</source>
        <translation>Aufgenommene und gefilterte Strahldichte in der Belichtung des Bildes</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Distance from the capture origin to the captured surfaces; black where nothing was captured</source>
        <translation>Abstand vom Aufnahmeursprung zu den aufgenommenen Oberflächen; schwarz, wo nichts aufgenommen wurde</translation>
    </message>
    <message>
        <source>Which of the probe&apos;s maps is shown</source>
        <translation>Welche der Maps der Sonde gezeigt wird</translation>
    </message>
    <message>
        <source>As</source>
        <translation>Als</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>Kreuz</translation>
    </message>
    <message>
        <source>The six faces: -Z +X +Z -X around, +Y above</source>
        <translation>Die sechs Flächen: -Z +X +Z -X ringsum, +Y oben</translation>
    </message>
    <message>
        <source>Latitude-longitude</source>
        <translation>Länge-Breite</translation>
    </message>
    <message>
        <source>The whole sphere in one picture</source>
        <translation>Die ganze Kugel in einem Bild</translation>
    </message>
    <message>
        <source>Seen from the origin: +Z in the middle, +X to its left, +Y up</source>
        <translation>Vom Ursprung gesehen: +Z in der Mitte, +X links davon, +Y oben</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Mip level 0 is the capture itself; each further level is filtered for rougher surfaces</source>
        <translation>Mip-Stufe 0 ist die Aufnahme selbst; jede weitere ist für rauere Oberflächen gefiltert</translation>
    </message>
    <message>
        <source> stops</source>
        <translation> Blenden</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Exposure of this preview on top of the picture&apos;s exposure; one stop doubles the light</source>
        <translation>Belichtung dieser Vorschau zusätzlich zu der des Bildes; eine Blendenstufe verdoppelt das Licht</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>Chrom</translation>
    </message>
    <message>
        <source>A mirror: the capture itself</source>
        <translation>Ein Spiegel: die Aufnahme selbst</translation>
    </message>
    <message>
        <source>Roughness of this mip level</source>
        <translation>Rauheit dieser Mip-Stufe</translation>
    </message>
    <message>
        <source>A metal with the roughness above</source>
        <translation>Ein Metall mit der Rauheit oben</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Diffuse white: the probe&apos;s irradiance</source>
        <translation>Diffuses Weiß: die Bestrahlungsstärke der Sonde</translation>
    </message>
    <message>
        <source>Shows a sphere at the capture origin in the 3D view, lit by this probe&apos;s maps alone. Captures do not see it</source>
        <translation>Zeigt am Aufnahmeursprung in der 3D-Ansicht eine Kugel, die nur von den Maps dieser Sonde beleuchtet wird. Aufnahmen sehen sie nicht</translation>
    </message>
    <message>
        <source>No probe selected</source>
        <translation>Keine Sonde ausgewählt</translation>
    </message>
    <message>
        <source>Reading the cubemap</source>
        <translation>Die Cubemap wird gelesen</translation>
    </message>
    <message>
        <source>This probe has no distances: its picture was imported, or it is not captured yet</source>
        <translation>Diese Sonde hat keine Abstände: ihr Bild wurde importiert, oder sie ist noch nicht aufgenommen</translation>
    </message>
    <message>
        <source>Not captured yet</source>
        <translation>Noch nicht aufgenommen</translation>
    </message>
    <message>
        <source>one level, %1 × %1</source>
        <translation>eine Stufe, %1 × %1</translation>
    </message>
    <message>
        <source>%1: roughness %2, %3 × %3</source>
        <translation>%1: Rauheit %2, %3 × %3</translation>
    </message>
    <message>
        <source>Black: nothing was captured. White: %1 m and beyond.</source>
        <translation>Schwarz: nichts aufgenommen. Weiß: %1 m und weiter.</translation>
    </message>
    <message>
        <source>Point at the picture to read a texel.</source>
        <translation>Auf das Bild zeigen, um ein Texel zu lesen.</translation>
    </message>
    <message>
        <source>Face %1, column %2, row %3</source>
        <translation>Fläche %1, Spalte %2, Zeile %3</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>nothing seen</source>
        <translation>nichts gesehen</translation>
    </message>
    <message>
        <source>%1
linear light %2  %3  %4   coverage %5</source>
        <translation>%1
lineares Licht %2  %3  %4   Abdeckung %5</translation>
    </message>
</context>
<context>
    <name>boxprobe::PublishedOverlay</name>
    <message>
        <source>Drawing the picture with the published formula...</source>
        <translation>Das Bild wird mit der veröffentlichten Formel gezeichnet...</translation>
    </message>
    <message>
        <source>The picture with the published formula, drawn on the CPU. It is drawn again when you move the view.</source>
        <translation>Das Bild mit der veröffentlichten Formel, auf der CPU gezeichnet. Es wird neu gezeichnet, wenn Sie die Ansicht bewegen.</translation>
    </message>
</context>
<context>
    <name>boxprobe::RayPanel</name>
    <message>
        <source>Under the pointer</source>
        <translation>Unter dem Zeiger</translation>
    </message>
    <message>
        <source>The point that is explained: under the pointer, or pinned by a click</source>
        <translation>Der Punkt, der erklärt wird: unter dem Zeiger oder durch Klick festgehalten</translation>
    </message>
    <message>
        <source>Clicked points</source>
        <translation>Angeklickte Punkte</translation>
    </message>
    <message>
        <source>Every point clicked with the Explain tool</source>
        <translation>Jeder mit dem Werkzeug Erklären angeklickte Punkt</translation>
    </message>
    <message>
        <source>Over an object</source>
        <translation>Über ein Objekt</translation>
    </message>
    <message>
        <source>Spread evenly over the surface of one object</source>
        <translation>Gleichmäßig über die Oberfläche eines Objekts verteilt</translation>
    </message>
    <message>
        <source>Along a line</source>
        <translation>Entlang einer Linie</translation>
    </message>
    <message>
        <source>Between the last two points clicked, dropped on to what lies below</source>
        <translation>Zwischen den letzten beiden angeklickten Punkten, auf das Darunterliegende gesenkt</translation>
    </message>
    <message>
        <source>Grid over the picture</source>
        <translation>Raster über dem Bild</translation>
    </message>
    <message>
        <source>Under a grid of pixels of the picture as it is</source>
        <translation>Unter einem Raster von Pixeln des jetzigen Bildes</translation>
    </message>
    <message>
        <source>Kind of line</source>
        <translation>Art der Linie</translation>
    </message>
    <message>
        <source>Hit distance</source>
        <translation>Trefferabstand</translation>
    </message>
    <message>
        <source>Error of the hit</source>
        <translation>Fehler des Treffers</translation>
    </message>
    <message>
        <source>Face hit</source>
        <translation>Getroffene Fläche</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Show rays</source>
        <translation>Strahlen zeigen</translation>
    </message>
    <message>
        <source>Clear points</source>
        <translation>Punkte löschen</translation>
    </message>
    <message>
        <source>Projection rays</source>
        <translation>Projektionsstrahlen</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Beginnen bei</translation>
    </message>
    <message>
        <source>Surface points that rays are drawn from</source>
        <translation>Oberflächenpunkte, von denen Strahlen ausgehen</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Object over which the points are spread</source>
        <translation>Objekt, über das die Punkte verteilt werden</translation>
    </message>
    <message>
        <source>Points at most</source>
        <translation>Punkte höchstens</translation>
    </message>
    <message>
        <source>Largest number of points that get rays</source>
        <translation>Größte Zahl von Punkten, die Strahlen bekommen</translation>
    </message>
    <message>
        <source>Longest ray</source>
        <translation>Längster Strahl</translation>
    </message>
    <message>
        <source>Length of a ray that hits nothing, scene units</source>
        <translation>Länge eines Strahls, der nichts trifft, Einheiten der Szene</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Meaning of a line&apos;s colour</source>
        <translation>Bedeutung der Farbe einer Linie</translation>
    </message>
    <message>
        <source>Save rays...</source>
        <translation>Strahlen speichern...</translation>
    </message>
    <message>
        <source>Saves VTK poly data (.vtp) with every number in arrays, for ParaView</source>
        <translation>Speichert VTK-Polydaten (.vtp) mit allen Zahlen in Arrays, für ParaView</translation>
    </message>
    <message>
        <source>Removes the clicked points</source>
        <translation>Entfernt die angeklickten Punkte</translation>
    </message>
    <message>
        <source>From the eye to the surface point P</source>
        <translation>Vom Auge zum Oberflächenpunkt P</translation>
    </message>
    <message>
        <source>N, the geometric normal at P</source>
        <translation>N, die geometrische Normale in P</translation>
    </message>
    <message>
        <source>From P along R to the hit H on the probe&apos;s box</source>
        <translation>Von P entlang R zum Treffer H auf der Box der Sonde</translation>
    </message>
    <message>
        <source>From the capture origin C to what is looked up: H - C</source>
        <translation>Vom Aufnahmeursprung C zum Abgefragten: H - C</translation>
    </message>
    <message>
        <source>From P to what each fetch looks up, of techniques with several</source>
        <translation>Von P zu dem, was jeder Zugriff abfragt, bei Techniken mit mehreren</translation>
    </message>
    <message>
        <source>From P along R to what the scene itself has there</source>
        <translation>Von P entlang R zu dem, was die Szene selbst dort hat</translation>
    </message>
    <message>
        <source>From the hit on the box to the true hit</source>
        <translation>Vom Treffer auf der Box zum wahren Treffer</translation>
    </message>
    <message>
        <source>Of glass: from P through the object to where the light leaves it</source>
        <translation>Bei Glas: von P durch das Objekt bis zum Austritt des Lichts</translation>
    </message>
    <message>
        <source>Of glass: from there along the refracted direction to the hit on the probe&apos;s box</source>
        <translation>Bei Glas: von dort entlang der gebrochenen Richtung zum Treffer auf der Box der Sonde</translation>
    </message>
    <message>
        <source>From P towards each light that throws shadows, to where it leaves the probe&apos;s box</source>
        <translation>Von P zu jedem Licht, das Schatten wirft, bis zum Austritt aus der Box der Sonde</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Linien</translation>
    </message>
    <message>
        <source>the last clicked point</source>
        <translation>der zuletzt angeklickte Punkt</translation>
    </message>
</context>
<context>
    <name>boxprobe::SceneCard</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::SceneReporter</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Seiten (*.html)</translation>
    </message>
    <message>
        <source>Wait until what is being read or fitted is done</source>
        <translation>Bitte warten, bis Lesen oder Anpassen fertig ist</translation>
    </message>
    <message>
        <source>Drawing and path tracing the cameras for the report</source>
        <translation>Kameras werden für den Bericht gezeichnet und per Pathtracing berechnet</translation>
    </message>
    <message>
        <source>The report was cancelled; nothing was written</source>
        <translation>Der Bericht wurde abgebrochen; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1; the largest error of a camera is %2</source>
        <translation>%1 geschrieben; der größte Fehler einer Kamera ist %2</translation>
    </message>
    <message>
        <source>No report: %1</source>
        <translation>Kein Bericht: %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::ShownParts</name>
    <message>
        <source>Select a probe or an object to hide</source>
        <translation>Zum Ausblenden eine Sonde oder ein Objekt auswählen</translation>
    </message>
    <message>
        <source>%1 is hidden in this window; Alt+H shows it</source>
        <translation>%1 ist in diesem Fenster ausgeblendet; Alt+H zeigt es</translation>
    </message>
    <message>
        <source>%1 items are hidden in this window; Alt+H shows them</source>
        <translation>%1 Einträge sind in diesem Fenster ausgeblendet; Alt+H zeigt sie</translation>
    </message>
    <message>
        <source>Select a probe or an object to isolate</source>
        <translation>Zum Isolieren eine Sonde oder ein Objekt auswählen</translation>
    </message>
    <message>
        <source>Only the selection is shown; press / to show the rest</source>
        <translation>Nur die Auswahl wird gezeigt; / zeigt den Rest</translation>
    </message>
</context>
<context>
    <name>boxprobe::SkyTurn</name>
    <message>
        <source>The sky has no picture that could be turned</source>
        <translation>Der Himmel hat kein Bild, das sich drehen ließe</translation>
    </message>
    <message>
        <source>Turn the sky</source>
        <translation>Himmel drehen</translation>
    </message>
</context>
<context>
    <name>boxprobe::StatusLine</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stops the capture until the scene changes again (Esc)</source>
        <translation>Hält die Aufnahme an, bis sich die Szene wieder ändert (Esc)</translation>
    </message>
    <message>
        <source>Continue capturing</source>
        <translation>Aufnahme fortsetzen</translation>
    </message>
    <message>
        <source>Work since the start: cubemap faces captured, mip levels filtered, shader programs compiled, frames drawn; and how many draws of the last frame used no probe, one, two or more.</source>
        <translation>Arbeit seit dem Start: aufgenommene Cubemap-Flächen, gefilterte Mip-Stufen, übersetzte Shader-Programme, gezeichnete Frames; und wie viele Zeichenaufrufe des letzten Frames keine, eine, zwei oder mehr Sonden nutzten.</translation>
    </message>
    <message>
        <source>moving preview</source>
        <translation>Bewegungsvorschau</translation>
    </message>
    <message>
        <source>A cheaper technique is shown while something moves (View menu)</source>
        <translation>Solange sich etwas bewegt, wird eine günstigere Technik gezeigt (Menü Ansicht)</translation>
    </message>
    <message>
        <source>refining: %1 %</source>
        <translation>wird verfeinert: %1 %</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>verfeinert</translation>
    </message>
    <message>
        <source>The picture rests and goes on to what rays of the whole lobe show (View menu)</source>
        <translation>Das Bild ruht und nähert sich dem, was Strahlen der ganzen Keule zeigen (Menü Ansicht)</translation>
    </message>
    <message>
        <source>%1 of %2 frames averaged</source>
        <translation>%1 von %2 Frames gemittelt</translation>
    </message>
    <message>
        <source>Mean since the last visible change</source>
        <translation>Mittel seit der letzten sichtbaren Änderung</translation>
    </message>
    <message>
        <source>faces %1   levels %2   programs %3   renders %4   draws with 0/1/2+ probes: %5/%6/%7</source>
        <translation>Flächen %1   Stufen %2   Programme %3   Bilder %4   Aufrufe mit 0/1/2+ Sonden: %5/%6/%7</translation>
    </message>
    <message>
        <source>Shadows of lamps</source>
        <translation>Schatten der Lampen</translation>
    </message>
    <message>
        <source>%1, coarse</source>
        <translation>%1, grob</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>%1, bounce %2</source>
        <translation>%1, Abpraller %2</translation>
    </message>
    <message>
        <source>%1, bounce %2 of %3</source>
        <translation>%1, Abpraller %2 von %3</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translation>Wird aufgenommen</translation>
    </message>
    <message>
        <source>Preparing shaders</source>
        <translation>Shader werden vorbereitet</translation>
    </message>
    <message>
        <source>%1 of %2 probes do not show their own surroundings yet: the sky or few texels stand in for them</source>
        <translation>%1 von %2 Sonden zeigen noch nicht ihre eigene Umgebung: Himmel oder wenige Texel vertreten sie</translation>
    </message>
</context>
<context>
    <name>boxprobe::SurfaceViewPanel</name>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>Coloured by</source>
        <translation>Eingefärbt nach</translation>
    </message>
    <message>
        <source>What the surfaces show instead of their own look</source>
        <translation>Was die Oberflächen statt ihres eigenen Aussehens zeigen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Keeps this range. Otherwise it follows the size of the scene</source>
        <translation>Behält diesen Bereich. Sonst folgt er der Größe der Szene</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Range of the colours; typing a value locks it</source>
        <translation>Bereich der Farben; ein eingetippter Wert sperrt ihn</translation>
    </message>
    <message>
        <source>undefined here</source>
        <translation>hier nicht definiert</translation>
    </message>
    <message>
        <source>background</source>
        <translation>Hintergrund</translation>
    </message>
</context>
<context>
    <name>boxprobe::TechniqueChooser</name>
    <message>
        <source>How the reflected ray is projected</source>
        <translation>Wie der reflektierte Strahl projiziert wird</translation>
    </message>
    <message>
        <source>How the lobe around the reflected ray is evaluated</source>
        <translation>Wie die Keule um den reflektierten Strahl ausgewertet wird</translation>
    </message>
</context>
<context>
    <name>boxprobe::TechniqueParametersPanel</name>
    <message>
        <source>%1 Default: %2.</source>
        <translation>%1 Standard: %2.</translation>
    </message>
</context>
<context>
    <name>boxprobe::ValueField</name>
    <message>
        <source>%1 is not between %2 and %3</source>
        <translation>%1 liegt nicht zwischen %2 und %3</translation>
    </message>
</context>
<context>
    <name>boxprobe::VectorRow</name>
    <message>
        <source>Drag sideways to change %1; hold Shift for fine steps</source>
        <translation>Seitwärts ziehen ändert %1; Umschalt für feine Schritte</translation>
    </message>
</context>
<context>
    <name>boxprobe::ViewCommands</name>
    <message>
        <source>A wall hides the selection; Alt+B cuts it away</source>
        <translation>Eine Wand verdeckt die Auswahl; Alt+B schneidet sie weg</translation>
    </message>
    <message>
        <source>Store camera %1</source>
        <translation>Kamera %1 speichern</translation>
    </message>
    <message>
        <source>Move camera %1 here</source>
        <translation>Kamera %1 hierher bewegen</translation>
    </message>
    <message>
        <source>A camera needs a name</source>
        <translation>Eine Kamera braucht einen Namen</translation>
    </message>
    <message>
        <source>A camera named %1 already exists; each needs its own name</source>
        <translation>Es gibt schon eine Kamera namens %1; jede braucht einen eigenen Namen</translation>
    </message>
    <message>
        <source>Rename camera to %1</source>
        <translation>Kamera in %1 umbenennen</translation>
    </message>
    <message>
        <source>Delete camera %1</source>
        <translation>Kamera %1 löschen</translation>
    </message>
</context>
<context>
    <name>boxprobe::ViewComparison</name>
    <message>
        <source>No difference</source>
        <translation>Keine Differenz</translation>
    </message>
    <message>
        <source>Error %1 %, %2 dB</source>
        <translation>Fehler %1 %, %2 dB</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>Wie es jetzt ist</translation>
    </message>
    <message>
        <source>The scene as it is edited</source>
        <translation>Die Szene, wie sie bearbeitet wird</translation>
    </message>
    <message>
        <source>Path traced</source>
        <translation>Pathtracing</translation>
    </message>
    <message>
        <source>All light of the scene, path traced in the background, with as many bounces as the probes have. The others are measured by it</source>
        <translation>Alles Licht der Szene, im Hintergrund per Pathtracing, mit so vielen Abprallern wie die Sonden. Die anderen werden daran gemessen</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>The scene as it was when the views were opened</source>
        <translation>Die Szene, wie sie beim Öffnen der Ansichten war</translation>
    </message>
    <message>
        <source>All probes baked</source>
        <translation>Alle Sonden gebacken</translation>
    </message>
    <message>
        <source>Every realtime probe captured and filtered as a baked one</source>
        <translation>Jede Echtzeitsonde wie eine gebackene aufgenommen und gefiltert</translation>
    </message>
    <message>
        <source>All probes live</source>
        <translation>Alle Sonden live</translation>
    </message>
    <message>
        <source>Every baked probe captured as a realtime one</source>
        <translation>Jede gebackene Sonde wie eine Echtzeitsonde aufgenommen</translation>
    </message>
    <message>
        <source>Every probe by this technique: %1</source>
        <translation>Jede Sonde mit dieser Technik: %1</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>Four views: choose below each what it shows. Turn the view or edit as before; Esc ends it</source>
        <translation>Vier Ansichten: unter jeder wählen, was sie zeigt. Ansicht drehen oder bearbeiten wie zuvor; Esc beendet</translation>
    </message>
    <message>
        <source>%1 % traced</source>
        <translation>%1 % berechnet</translation>
    </message>
    <message>
        <source>The measure of the others</source>
        <translation>Der Maßstab der anderen</translation>
    </message>
</context>
<context>
    <name>boxprobe::Welcome</name>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>one box fits exactly</source>
        <translation>eine Box passt genau</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>Gebäude</translation>
    </message>
    <message>
        <source>an open pavilion</source>
        <translation>ein offener Pavillon</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Wohnung</translation>
    </message>
    <message>
        <source>furnished, evening sun</source>
        <translation>möbliert, Abendsonne</translation>
    </message>
    <message>
        <source>Furnished</source>
        <translation>Möbliert</translation>
    </message>
    <message>
        <source>the limits of a box</source>
        <translation>die Grenzen einer Box</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>light through openings</source>
        <translation>Licht durch Öffnungen</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
    <message>
        <source>refraction</source>
        <translation>Lichtbrechung</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>Galerie</translation>
    </message>
    <message>
        <source>for measuring</source>
        <translation>zum Messen</translation>
    </message>
    <message>
        <source>Mirror hall</source>
        <translation>Spiegelsaal</translation>
    </message>
    <message>
        <source>planar mirrors</source>
        <translation>ebene Spiegel</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Open a scene or a model, or drop a file into this window.</source>
        <translation>Eine Szene oder ein Modell öffnen, oder eine Datei in dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>Öffnen...</translation>
    </message>
    <message>
        <source>A scene or a model (Ctrl+O)</source>
        <translation>Eine Szene oder ein Modell (Strg+O)</translation>
    </message>
    <message>
        <source>New from a model...</source>
        <translation>Neu aus einem Modell...</translation>
    </message>
    <message>
        <source>A new scene: probe, camera, light and exposure are fitted to the model</source>
        <translation>Eine neue Szene: Sonde, Kamera, Licht und Belichtung werden dem Modell angepasst</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Reflection probes, step by step (F1)</source>
        <translation>Reflexionssonden, Schritt für Schritt (F1)</translation>
    </message>
</context>
<context>
    <name>boxprobe::Workspace</name>
    <message>
        <source>Lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
    <message>
        <source>no scene</source>
        <translation>keine Szene</translation>
    </message>
    <message>
        <source>%1 (not saved)</source>
        <translation>%1 (nicht gespeichert)</translation>
    </message>
</context>
</TS>
