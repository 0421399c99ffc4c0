<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Beside</name>
    <message>
        <source>The two scenes are for different arms and cannot be compared.</source>
        <translation>Die beiden Szenen sind für verschiedene Arme und lassen sich nicht vergleichen.</translation>
    </message>
    <message>
        <source>The comparison has ended: each tick of the other scene takes too long. Choose a simpler scene or a lower servo rate.</source>
        <translation>Der Vergleich wurde beendet: Jeder Takt der anderen Szene dauert zu lange. Wählen Sie eine einfachere Szene oder eine niedrigere Servo-Taktrate.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>old sample</source>
        <translation>alter Messwert</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>jump</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>too late</source>
        <translation>zu spät</translation>
    </message>
    <message>
        <source>stood still</source>
        <translation>stand still</translation>
    </message>
    <message>
        <source>clock error</source>
        <translation>Uhrfehler</translation>
    </message>
    <message>
        <source>asleep</source>
        <translation>im Ruhezustand</translation>
    </message>
    <message>
        <source>window busy</source>
        <translation>Fenster beschäftigt</translation>
    </message>
    <message>
        <source>Some meshes of the arm are not drawn. The panel Arm says why.</source>
        <translation>Einige Netze des Arms werden nicht gezeichnet. Warum, sagt der Bereich Arm.</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Revolute: rotates about its axis. Prismatic: slides along its axis.</source>
        <translation>Drehgelenk: dreht sich um seine Achse. Schubgelenk: gleitet entlang seiner Achse.</translation>
    </message>
    <message>
        <source>axis
x</source>
        <translation>Achse
x</translation>
    </message>
    <message>
        <source>Direction of the axis in the home pose, in W, of any length: S = (axis, point x axis).</source>
        <translation>Richtung der Achse in Grundstellung, in W, beliebig lang: S = (Achse, Punkt x Achse).</translation>
    </message>
    <message>
        <source>
y</source>
        <translation>
y</translation>
    </message>
    <message>
        <source>Direction of the axis in the home pose.</source>
        <translation>Richtung der Achse in Grundstellung.</translation>
    </message>
    <message>
        <source>
z</source>
        <translation>
z</translation>
    </message>
    <message>
        <source>point
x [mm]</source>
        <translation>Punkt
x [mm]</translation>
    </message>
    <message>
        <source>A point on the axis in the home pose, in W; a prismatic joint needs none.</source>
        <translation>Ein Punkt auf der Achse in Grundstellung, in W; ein Schubgelenk braucht keinen.</translation>
    </message>
    <message>
        <source>
y [mm]</source>
        <translation>
y [mm]</translation>
    </message>
    <message>
        <source>A point on the axis in the home pose.</source>
        <translation>Ein Punkt auf der Achse in Grundstellung.</translation>
    </message>
    <message>
        <source>
z [mm]</source>
        <translation>
z [mm]</translation>
    </message>
    <message>
        <source>min
[° mm]</source>
        <translation>min.
[° mm]</translation>
    </message>
    <message>
        <source>Lower limit, degrees or mm; empty: no limit.</source>
        <translation>Untere Grenze, Grad oder mm; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>max
[° mm]</source>
        <translation>max.
[° mm]</translation>
    </message>
    <message>
        <source>Upper limit, degrees or mm; empty: no limit.</source>
        <translation>Obere Grenze, Grad oder mm; leer: keine Grenze.</translation>
    </message>
    <message>
        <source>spring k
[N mm/rad, N/mm]</source>
        <translation>Feder k
[N mm/rad, N/mm]</translation>
    </message>
    <message>
        <source>The joint's own spring adds k (q - rest)^2 / 2 to the energy; 0: the joint moves freely.</source>
        <translation>Die eigene Feder des Gelenks trägt k (q - Ruhe)^2 / 2 zur Energie bei; 0: Das Gelenk bewegt sich frei.</translation>
    </message>
    <message>
        <source>rest
[° mm]</source>
        <translation>Ruhe
[° mm]</translation>
    </message>
    <message>
        <source>Where the spring exerts no force, degrees or mm.</source>
        <translation>Wo die Feder keine Kraft ausübt, Grad oder mm.</translation>
    </message>
    <message>
        <source>revolute</source>
        <translation>Drehgelenk</translation>
    </message>
    <message>
        <source>prismatic</source>
        <translation>Schubgelenk</translation>
    </message>
    <message>
        <source>"%1" is not a number. Enter one such as −12.5.</source>
        <translation>„%1“ ist keine Zahl. Geben Sie eine ein, etwa −12,5.</translation>
    </message>
    <message>
        <source>A joint is revolute or prismatic.</source>
        <translation>Ein Gelenk ist ein Drehgelenk oder ein Schubgelenk.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Hold the button</source>
        <translation>Taste halten</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Stoppt</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Drop to open the scene</source>
        <translation>Loslassen, um die Szene zu öffnen</translation>
    </message>
    <message>
        <source>Drop to replay the session</source>
        <translation>Loslassen, um die Sitzung abzuspielen</translation>
    </message>
    <message>
        <source>Drop to give the scene this arm</source>
        <translation>Loslassen, um der Szene diesen Arm zu geben</translation>
    </message>
    <message>
        <source>Drop to hold the stylus to this mesh</source>
        <translation>Loslassen, um den Stift an diesem Netz zu halten</translation>
    </message>
    <message>
        <source>Drop to hold the stylus to this curve</source>
        <translation>Loslassen, um den Stift an dieser Kurve zu halten</translation>
    </message>
    <message>
        <source>Drop to begin the lesson</source>
        <translation>Loslassen, um die Lektion zu beginnen</translation>
    </message>
    <message>
        <source>Drop to look at these figures</source>
        <translation>Loslassen, um diese Abbildungen anzusehen</translation>
    </message>
    <message>
        <source>Drop to open the notebook in another program</source>
        <translation>Loslassen, um das Notebook in einem anderen Programm zu öffnen</translation>
    </message>
    <message>
        <source>All that Underact opens (%1);;All files (*)</source>
        <translation>Alles, was Underact öffnet (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Drop one file at a time.</source>
        <translation>Ziehen Sie immer nur eine Datei auf das Fenster.</translation>
    </message>
    <message>
        <source>This is not on this computer. Download it, and drop the file.</source>
        <translation>Das liegt nicht auf diesem Computer. Laden Sie es herunter und ziehen Sie dann die Datei auf das Fenster.</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>nicht erstellt</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>picture of the view</source>
        <translation>Bild der Ansicht</translation>
    </message>
    <message>
        <source>all %1 numbers pass</source>
        <translation>alle %1 Zahlen stimmen</translation>
    </message>
    <message>
        <source>%1 of %2 numbers fail</source>
        <translation>%1 von %2 Zahlen weichen ab</translation>
    </message>
    <message>
        <source>%1 figures, %2 numbers checked, %3.</source>
        <translation>%1 Abbildungen, %2 Zahlen geprüft, %3.</translation>
    </message>
    <message>
        <source>all pass</source>
        <translation>alle stimmen</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 abweichend</translation>
    </message>
    <message>
        <source>Figures left out: %1.</source>
        <translation>Ausgelassene Abbildungen: %1.</translation>
    </message>
    <message>
        <source>Figure %1 has no picture.</source>
        <translation>Abbildung %1 hat kein Bild.</translation>
    </message>
    <message>
        <source>Figure %1: %2</source>
        <translation>Abbildung %1: %2</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder.</source>
        <translation>%1 konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>This program does not know the session's arm “%1”.</source>
        <translation>Dieses Programm kennt den Arm „%1“ der Sitzung nicht.</translation>
    </message>
    <message>
        <source>This session has only one tick: there is nothing to follow.</source>
        <translation>Diese Sitzung hat nur einen Takt: Es gibt nichts, dem man folgen könnte.</translation>
    </message>
    <message>
        <source>It cannot be copied to %1.</source>
        <translation>Es kann nicht nach %1 kopiert werden.</translation>
    </message>
    <message>
        <source>This computer has no program for notebooks. Open %1 with Jupyter or VS Code.</source>
        <translation>Dieser Rechner hat kein Programm für Notebooks. Öffnen Sie %1 mit Jupyter oder VS Code.</translation>
    </message>
    <message>
        <source>Notebook</source>
        <translation>Notebook</translation>
    </message>
    <message>
        <source>The notebook cannot be opened.</source>
        <translation>Das Notebook kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Another program opens this notebook, for example Jupyter or VS Code.</source>
        <translation>Dieses Notebook öffnet ein anderes Programm, zum Beispiel Jupyter oder VS Code.</translation>
    </message>
    <message>
        <source>It opens a copy of your own, which keeps your changes:
%1</source>
        <translation>Es öffnet eine eigene Kopie, in der Ihre Änderungen bleiben:
%1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open my copy</source>
        <translation>Meine Kopie öffnen</translation>
    </message>
    <message>
        <source>Drag the stylus</source>
        <translation>Stift ziehen</translation>
    </message>
    <message>
        <source>moves the simulated hand in the plane of the view; when you release it, the hand lets go, unless Keep holding (F6) is on</source>
        <translation>bewegt die simulierte Hand in der Ebene der Ansicht; beim Loslassen lässt auch die Hand los, außer Festhalten (F6) ist an</translation>
    </message>
    <message>
        <source>Wheel while dragging</source>
        <translation>Rad beim Ziehen</translation>
    </message>
    <message>
        <source>moves the hand nearer or further away</source>
        <translation>bewegt die Hand näher oder weiter weg</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>move the hand 2 mm, with Shift 10 mm (press F2 first, or click the view); it holds the stylus until you let go (Shift+F6)</source>
        <translation>bewegen die Hand um 2 mm, mit Umschalt um 10 mm (vorher F2 drücken oder in die Ansicht klicken); sie hält den Stift, bis Sie loslassen (Umschalt+F6)</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>move the hand in depth</source>
        <translation>bewegen die Hand in die Tiefe</translation>
    </message>
    <message>
        <source>Ctrl and arrow keys</source>
        <translation>Strg und Pfeiltasten</translation>
    </message>
    <message>
        <source>turn the stylus; its position then follows the scene</source>
        <translation>drehen den Stift; seine Position folgt dabei der Szene</translation>
    </message>
    <message>
        <source>Game controller, 3D mouse</source>
        <translation>Gamepad, 3D-Maus</translation>
    </message>
    <message>
        <source>move and rotate the simulated hand; the panel Input devices shows and edits their mappings</source>
        <translation>bewegen und drehen die simulierte Hand; der Bereich Eingabegeräte zeigt und ändert ihre Belegung</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>holds the stylus button down (press F2 first, or click the view)</source>
        <translation>hält die Stifttaste gedrückt (zuerst F2 drücken oder die Ansicht anklicken)</translation>
    </message>
    <message>
        <source>Rings o and p</source>
        <translation>Ringe o und p</translation>
    </message>
    <message>
        <source>in a scene with an influence factor: the point that the stylus points at, and the point nearest to the tip</source>
        <translation>in einer Szene mit Einflussfaktor: der Punkt, auf den der Stift zeigt, und der Punkt, der der Spitze am nächsten ist</translation>
    </message>
    <message>
        <source>Drag beside the stylus</source>
        <translation>Neben dem Stift ziehen</translation>
    </message>
    <message>
        <source>rotates the view; with the middle button, pans it</source>
        <translation>dreht die Ansicht; mit der mittleren Taste wird sie verschoben</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>zooms the view</source>
        <translation>zoomt die Ansicht</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>Schieberegler</translation>
    </message>
    <message>
        <source>respond to the mouse, the arrow keys and, once clicked, the wheel; a double click restores the scene's value</source>
        <translation>reagieren auf Maus, Pfeiltasten und, einmal angeklickt, das Rad; ein Doppelklick stellt den Wert der Szene wieder her</translation>
    </message>
    <message>
        <source>Table of joints</source>
        <translation>Tabelle der Gelenke</translation>
    </message>
    <message>
        <source>F2, a double click or typing edits a number; Enter applies it</source>
        <translation>F2, ein Doppelklick oder Tippen ändert eine Zahl; die Eingabetaste übernimmt sie</translation>
    </message>
    <message>
        <source>Stops the servo wherever you are, also in an open menu or dialog.</source>
        <translation>Stoppt den Servo, wo Sie auch sind, auch in einem offenen Menü oder Dialog.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>one of many: %1</source>
        <translation>eine von vielen: %1</translation>
    </message>
    <message>
        <source>one of many: only %1 is defined</source>
        <translation>eine von vielen: nur %1 ist bestimmt</translation>
    </message>
    <message>
        <source>✓ within</source>
        <translation>✓ innerhalb</translation>
    </message>
    <message>
        <source>✗ outside</source>
        <translation>✗ außerhalb</translation>
    </message>
    <message>
        <source>, q1 free</source>
        <translation>, q1 frei</translation>
    </message>
    <message>
        <source>, now</source>
        <translation>, jetzt</translation>
    </message>
    <message>
        <source>A search from %1 starts found no solution for this pose.</source>
        <translation>Eine Suche von %1 Startpunkten aus fand keine Lösung für diese Lage.</translation>
    </message>
    <message>
        <source>The arm cannot reach this pose: there is no solution.</source>
        <translation>Der Arm kann diese Lage nicht erreichen: Es gibt keine Lösung.</translation>
    </message>
    <message>
        <source>More joints than the pose takes: infinitely many solutions. These %1 are from a search from %2 starts; %3 are within the joint limits.</source>
        <translation>Mehr Gelenke, als die Lage braucht: unendlich viele Lösungen. Diese %1 fand eine Suche von %2 Startpunkten aus; %3 liegen innerhalb der Gelenkgrenzen.</translation>
    </message>
    <message>
        <source>No closed form: a search from %2 starts found %1 solutions, %3 within the joint limits.</source>
        <translation>Keine geschlossene Form: Eine Suche von %2 Startpunkten aus fand %1 Lösungen, %3 innerhalb der Gelenkgrenzen.</translation>
    </message>
    <message>
        <source>%1 solutions, %2 within the joint limits.</source>
        <translation>%1 Lösungen, %2 innerhalb der Gelenkgrenzen.</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source> Singular at the %1.</source>
        <translation> Singulär: %1.</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1, %2, %3 mm</translation>
    </message>
    <message>
        <source>%1
Timed: %2. Error: %3; root mean square.
Bound: %4 (%5).</source>
        <translation>%1
Gemessene Zeit: %2. Fehler: %3; quadratisches Mittel.
Grenze: %4 (%5).</translation>
    </message>
    <message>
        <source>%1 for %2, %3 per second; error %4, bound %5</source>
        <translation>%1 für %2, %3 je Sekunde; Fehler %4, Grenze %5</translation>
    </message>
    <message>
        <source>▲ The error exceeds the bound.</source>
        <translation>▲ Der Fehler überschreitet die Grenze.</translation>
    </message>
    <message>
        <source>The default; no other setting keeps the error within the bound here.</source>
        <translation>Die Voreinstellung; auch keine andere Einstellung hält den Fehler hier innerhalb der Schranke.</translation>
    </message>
    <message>
        <source>→ Recommended: %1 (%2 per second, error %3)</source>
        <translation>→ Empfohlen: %1 (%2 je Sekunde, Fehler %3)</translation>
    </message>
    <message>
        <source>not measured with this setting</source>
        <translation>mit dieser Einstellung nicht gemessen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ns</source>
        <translation>%1 ns</translation>
    </message>
    <message>
        <source>0 mm</source>
        <translation>0 mm</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>below 0.001 nm</source>
        <translation>unter 0,001 nm</translation>
    </message>
    <message>
        <source>%1 nm</source>
        <translation>%1 nm</translation>
    </message>
    <message>
        <source>a second</source>
        <translation>eine Sekunde</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>closed form where there is one, else %1</source>
        <translation>geschlossene Form, wo es eine gibt, sonst %1</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>STL (binary)</source>
        <translation>STL (binär)</translation>
    </message>
    <message>
        <source>STL (text)</source>
        <translation>STL (Text)</translation>
    </message>
    <message>
        <source>This file cannot be read. Open it to see why.</source>
        <translation>Diese Datei lässt sich nicht lesen. Öffnen Sie sie, um den Grund zu sehen.</translation>
    </message>
    <message>
        <source>real time: not granted</source>
        <translation>Echtzeit: nicht gewährt</translation>
    </message>
    <message>
        <source>real time: %1</source>
        <translation>Echtzeit: %1</translation>
    </message>
    <message>
        <source>%1 is a file, not a folder. Choose another folder for the recordings.</source>
        <translation>%1 ist eine Datei, kein Ordner. Wählen Sie einen anderen Ordner für die Aufzeichnungen.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created. Choose another folder for the recordings.</source>
        <translation>Der Ordner %1 lässt sich nicht anlegen. Wählen Sie einen anderen Ordner für die Aufzeichnungen.</translation>
    </message>
    <message>
        <source>The folder %1 is not writable. Choose another folder for the recordings.</source>
        <translation>Der Ordner %1 ist nicht beschreibbar. Wählen Sie einen anderen Ordner für die Aufzeichnungen.</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>1 day</source>
        <translation>1 Tag</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 Tage</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 kB</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1, enough for %2</source>
        <translation>%1, reicht für %2</translation>
    </message>
    <message>
        <source>q%1: above %2 N/mm at %3 Hz the stylus may buzz somewhere in the workspace.</source>
        <translation>q%1: Über %2 N/mm kann der Stift bei %3 Hz irgendwo im Arbeitsraum brummen.</translation>
    </message>
    <message>
        <source>%1: above %2 N/mm at %3 Hz the stylus may buzz in a hand with %4 N s/m of damping.</source>
        <translation>%1: Über %2 N/mm kann der Stift bei %3 Hz in einer Hand mit %4 N s/m Dämpfung brummen.</translation>
    </message>
    <message>
        <source>at minimum, %1</source>
        <translation>am Minimum, %1</translation>
    </message>
    <message>
        <source>at maximum, %1</source>
        <translation>am Maximum, %1</translation>
    </message>
    <message>
        <source>There is no such joint.</source>
        <translation>Dieses Gelenk gibt es nicht.</translation>
    </message>
    <message>
        <source>Nothing was measured.</source>
        <translation>Es wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>Its latency is %1 times that of a bare loop at p99, and %2 times at p99.9.</source>
        <translation>Seine Latenz ist bei p99 das %1-Fache der einer leeren Schleife, bei p99.9 das %2-Fache.</translation>
    </message>
    <message>
        <source>The servo is as punctual as this machine allows. </source>
        <translation>Der Servo ist so pünktlich, wie dieser Rechner es erlaubt. </translation>
    </message>
    <message>
        <source>The servo is less punctual than this machine allows. </source>
        <translation>Der Servo ist weniger pünktlich, als dieser Rechner es erlaubt. </translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>gerade eben</translation>
    </message>
    <message>
        <source>last %1 s ago</source>
        <translation>zuletzt vor %1 s</translation>
    </message>
    <message>
        <source>last %1 min ago</source>
        <translation>zuletzt vor %1 min</translation>
    </message>
    <message>
        <source>The stylus button nearer the tip. On the simulated arm it is the Space key, while the view has the focus (F2).</source>
        <translation>Die Stifttaste näher an der Spitze. Beim simulierten Arm ist es die Leertaste, solange die Ansicht den Fokus hat (F2).</translation>
    </message>
    <message>
        <source>The stylus button farther from the tip. The simulated arm has none.</source>
        <translation>Die Stifttaste weiter von der Spitze entfernt. Der simulierte Arm hat keine.</translation>
    </message>
    <message>
        <source>Cancelled: no file was written.</source>
        <translation>Abgebrochen: Es wurde keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Not exported. %1</source>
        <translation>Nicht exportiert. %1</translation>
    </message>
    <message>
        <source>%1 ticks saved in %2</source>
        <translation>%1 Takte in %2 gespeichert</translation>
    </message>
    <message>
        <source>%1. %2 damaged ticks of the session were left out.</source>
        <translation>%1. %2 beschädigte Takte der Sitzung wurden ausgelassen.</translation>
    </message>
    <message>
        <source>The recording was split into %1 files, because a session's length is limited. The last one is %2.</source>
        <translation>Die Aufzeichnung hat %1 Dateien, weil eine Sitzung nicht länger sein darf. Die letzte ist %2.</translation>
    </message>
    <message>
        <source>%1 ticks are missing: the computer was too busy to write them. The servo kept running.</source>
        <translation>%1 Takte fehlen: Der Rechner war zu stark ausgelastet, um sie zu schreiben. Der Servo lief weiter.</translation>
    </message>
    <message>
        <source>The disk is nearly full: there is room for another %1. Free some space; otherwise the recording stops and is saved.</source>
        <translation>Der Datenträger ist fast voll: Der Platz reicht noch für %1. Geben Sie Platz frei; sonst wird die Aufzeichnung gestoppt und gespeichert.</translation>
    </message>
    <message>
        <source>The disk is nearly full: %1 left. Free some space; otherwise the recording stops and is saved.</source>
        <translation>Der Datenträger ist fast voll: %1 sind frei. Geben Sie Platz frei; sonst wird die Aufzeichnung gestoppt und gespeichert.</translation>
    </message>
    <message>
        <source>Cancelled: the run was not compared to its end.</source>
        <translation>Abgebrochen: Der Lauf wurde nicht bis zum Ende verglichen.</translation>
    </message>
    <message>
        <source>Not run again. %1</source>
        <translation>Nicht wiederholt. %1</translation>
    </message>
    <message>
        <source>Since this session was made, the law of %1 was mended: %2 ticks differ now, the first one is %3.</source>
        <translation>Seit diese Sitzung entstand, wurde das Gesetz von %1 berichtigt: %2 Takte weichen nun ab, der erste ist %3.</translation>
    </message>
    <message>
        <source>Tick %1 differs from the recording: %2.</source>
        <translation>Takt %1 weicht von der Aufzeichnung ab: %2.</translation>
    </message>
    <message>
        <source>Run again: all %1 ticks are the same to the last bit.</source>
        <translation>Wiederholt: Alle %1 Takte sind bis auf das letzte Bit gleich.</translation>
    </message>
    <message>
        <source>%1 A person or an edit had a part in the run, so the recorded input was used.</source>
        <translation>%1 An dem Lauf war eine Person oder eine Änderung beteiligt, deshalb wurde die aufgezeichnete Eingabe verwendet.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>Not closed: it is still being recorded, or the program ended without closing it. Recover repairs it.</source>
        <translation>Nicht geschlossen: Sie wird noch aufgezeichnet, oder das Programm endete, ohne sie zu schließen. „Retten“ repariert sie.</translation>
    </message>
    <message>
        <source>Recovered after the program ended without closing it.</source>
        <translation>Gerettet, nachdem das Programm geendet hatte, ohne sie zu schließen.</translation>
    </message>
    <message>
        <source>Stopped because the disk was nearly full.</source>
        <translation>Gestoppt, weil der Datenträger fast voll war.</translation>
    </message>
    <message>
        <source>%1 ticks are missing.</source>
        <translation>%1 Takte fehlen.</translation>
    </message>
    <message>
        <source>1 fault.</source>
        <translation>1 Störung.</translation>
    </message>
    <message>
        <source>%1 faults.</source>
        <translation>%1 Störungen.</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>not closed: Recover</source>
        <translation>nicht geschlossen: Retten</translation>
    </message>
    <message>
        <source>%1 ticks</source>
        <translation>%1 Takte</translation>
    </message>
    <message>
        <source>Scene %1</source>
        <translation>Szene %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Subject %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>Consent %1</source>
        <translation>Einwilligung %1</translation>
    </message>
    <message>
        <source>Tags %1</source>
        <translation>Tags %1</translation>
    </message>
    <message>
        <source>Markers %1</source>
        <translation>Marken %1</translation>
    </message>
    <message>
        <source>%1 away</source>
        <translation>%1 entfernt</translation>
    </message>
    <message>
        <source>equidistant</source>
        <translation>ringsum gleich weit</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>position only</source>
        <translation>nur der Position</translation>
    </message>
    <message>
        <source>position and direction</source>
        <translation>Position und Richtung</translation>
    </message>
    <message>
        <source>position and angle</source>
        <translation>Position und Winkel</translation>
    </message>
    <message>
        <source>position and orientation</source>
        <translation>Position und Orientierung</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Home position</source>
        <translation>Grundstellung</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>Kθ</source>
        <translation>Kθ</translation>
    </message>
    <message>
        <source>%1 N mm/rad</source>
        <translation>%1 N mm/rad</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Placed at</source>
        <translation>Platziert bei</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>straight lines</source>
        <translation>Strecken</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>none, closed</source>
        <translation>keine, geschlossen</translation>
    </message>
    <message>
        <source>two</source>
        <translation>zwei</translation>
    </message>
    <message>
        <source>held to it</source>
        <translation>daran gehalten</translation>
    </message>
    <message>
        <source>felt from outside</source>
        <translation>von außen gefühlt</translation>
    </message>
    <message>
        <source>felt from inside</source>
        <translation>von innen gefühlt</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>%1 static, %2 dynamic</source>
        <translation>%1 statisch, %2 dynamisch</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
</context>
<context>
    <name>QToolBar</name>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
</context>
<context>
    <name>SceneView</name>
    <message>
        <source>desk</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>no. </source>
        <translation>Nr. </translation>
    </message>
    <message>
        <source>moment, sent</source>
        <translation>Moment, gesendet</translation>
    </message>
    <message>
        <source>moment, not sent</source>
        <translation>Moment, nicht gesendet</translation>
    </message>
    <message>
        <source>second arm</source>
        <translation>zweiter Arm</translation>
    </message>
    <message>
        <source>where the stylus points</source>
        <translation>wohin der Stift zeigt</translation>
    </message>
    <message>
        <source>nearest to the tip</source>
        <translation>der Spitze am nächsten</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
</context>
<context>
    <name>cause</name>
    <message>
        <source>previous tick too long</source>
        <translation>voriger Takt zu lang</translation>
    </message>
    <message>
        <source>The previous tick took longer than a period.</source>
        <translation>Der vorige Takt dauerte länger als eine Periode.</translation>
    </message>
    <message>
        <source>waiting for the arm</source>
        <translation>Warten auf den Arm</translation>
    </message>
    <message>
        <source>Most of the delay was spent waiting for the arm.</source>
        <translation>Der größte Teil der Verzögerung verging mit dem Warten auf den Arm.</translation>
    </message>
    <message>
        <source>page fault</source>
        <translation>Seitenfehler</translation>
    </message>
    <message>
        <source>The servo thread accessed memory that the system had to load first.</source>
        <translation>Der Servo-Thread griff auf Speicher zu, den das System erst laden musste.</translation>
    </message>
    <message>
        <source>preempted</source>
        <translation>verdrängt</translation>
    </message>
    <message>
        <source>Another thread ran on the servo's core.</source>
        <translation>Ein anderer Thread lief auf dem Kern des Servos.</translation>
    </message>
    <message>
        <source>woken late</source>
        <translation>verspätet geweckt</translation>
    </message>
    <message>
        <source>None of these: the system, or the host of a virtual machine, woke the thread late.</source>
        <translation>Nichts davon: Das System oder der Wirt einer virtuellen Maschine weckte den Thread verspätet.</translation>
    </message>
</context>
<context>
    <name>choice</name>
    <message>
        <source>Servo rate</source>
        <translation>Servo-Taktrate</translation>
    </message>
    <message>
        <source>Simulated arm</source>
        <translation>Simulierter Arm</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Solver steps</source>
        <translation>Schritte des Lösers</translation>
    </message>
    <message>
        <source>Velocity filter</source>
        <translation>Geschw.-Filter</translation>
    </message>
    <message>
        <source>Inverse kinematics</source>
        <translation>Rückwärtskinematik</translation>
    </message>
    <message>
        <source>Recording blocks</source>
        <translation>Blöcke der Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>columns</name>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Columns [%1]</source>
        <translation>Spalten [%1]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
</context>
<context>
    <name>difference</name>
    <message>
        <source>centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>point on it</source>
        <translation>Punkt darauf</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>constraints</source>
        <translation>Bindungen</translation>
    </message>
    <message>
        <source>control law and gains</source>
        <translation>Regelgesetz und Verstärkungen</translation>
    </message>
    <message>
        <source>influence</source>
        <translation>Einfluss</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>Geschwindigkeitsfilter</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>home pose</source>
        <translation>Grundstellung</translation>
    </message>
</context>
<context>
    <name>explore</name>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>R, revolute: q adds to θ. P, prismatic: q adds to d.</source>
        <translation>R, Drehgelenk: q kommt zu θ hinzu. P, Schubgelenk: q kommt zu d hinzu.</translation>
    </message>
    <message>
        <source>α
[°]</source>
        <translation>α
[°]</translation>
    </message>
    <message>
        <source>Twist: the angle from the previous z axis to that of this row, about the previous x axis.</source>
        <translation>Verwindung: der Winkel von der vorigen z-Achse zu der dieser Zeile, um die vorige x-Achse.</translation>
    </message>
    <message>
        <source>a
[mm]</source>
        <translation>a
[mm]</translation>
    </message>
    <message>
        <source>Length: the distance from the previous z axis to that of this row, along the previous x axis.</source>
        <translation>Länge: der Abstand von der vorigen z-Achse zu der dieser Zeile, entlang der vorigen x-Achse.</translation>
    </message>
    <message>
        <source>θ
[°]</source>
        <translation>θ
[°]</translation>
    </message>
    <message>
        <source>Angle: from the previous x axis to that of this row, about z, with the joint at 0.</source>
        <translation>Winkel: von der vorigen x-Achse zu der dieser Zeile, um z, mit dem Gelenk bei 0.</translation>
    </message>
    <message>
        <source>d
[mm]</source>
        <translation>d
[mm]</translation>
    </message>
    <message>
        <source>Offset: the distance from the previous x axis to that of this row, along z, with the joint at 0.</source>
        <translation>Versatz: der Abstand von der vorigen x-Achse zu der dieser Zeile, entlang z, mit dem Gelenk bei 0.</translation>
    </message>
    <message>
        <source>q
[° mm]</source>
        <translation>q
[° mm]</translation>
    </message>
    <message>
        <source>The value of the joint: from the arm if the joints follow it, otherwise as typed.</source>
        <translation>Der Wert des Gelenks: vom Arm, wenn die Gelenke ihm folgen, sonst wie eingegeben.</translation>
    </message>
    <message>
        <source>Two links in a plane</source>
        <translation>Zwei Glieder in der Ebene</translation>
    </message>
    <message>
        <source>SCARA</source>
        <translation>SCARA</translation>
    </message>
    <message>
        <source>Two revolute, one prismatic</source>
        <translation>Zwei Dreh-, ein Schubgelenk</translation>
    </message>
</context>
<context>
    <name>gain</name>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Integral</source>
        <translation>Integral</translation>
    </message>
</context>
<context>
    <name>layer</name>
    <message>
        <source>&amp;Workspace box</source>
        <translation>&amp;Arbeitsraum</translation>
    </message>
    <message>
        <source>The box the arm can reach, with ticks every 20 mm.</source>
        <translation>Der Quader, den der Arm erreicht, mit einem Strich alle 20 mm.</translation>
    </message>
    <message>
        <source>&amp;Axes of W and B</source>
        <translation>Achsen von &amp;W und B</translation>
    </message>
    <message>
        <source>The axes of the workspace and of the arm's base.</source>
        <translation>Die Achsen des Arbeitsraums und der Basis des Arms.</translation>
    </message>
    <message>
        <source>A&amp;rm</source>
        <translation>A&amp;rm</translation>
    </message>
    <message>
        <source>The arm's links.</source>
        <translation>Die Glieder des Arms.</translation>
    </message>
    <message>
        <source>&amp;Target and error</source>
        <translation>&amp;Ziel und Fehler</translation>
    </message>
    <message>
        <source>The point to which the tip is pulled, and the line to it.</source>
        <translation>Der Punkt, zu dem die Spitze gezogen wird, und die Linie dorthin.</translation>
    </message>
    <message>
        <source>&amp;Force</source>
        <translation>&amp;Kraft</translation>
    </message>
    <message>
        <source>The force that is sent, as an arrow.</source>
        <translation>Die gesendete Kraft als Pfeil.</translation>
    </message>
    <message>
        <source>&amp;Influence</source>
        <translation>&amp;Einfluss</translation>
    </message>
    <message>
        <source>The point that the stylus points at (o), the point nearest to the tip (p), and the arc of the target between them.</source>
        <translation>Der Punkt, auf den der Stift zeigt (o), der Punkt, der der Spitze am nächsten liegt (p), und der Bogen des Ziels dazwischen.</translation>
    </message>
    <message>
        <source>&amp;Virtual robot</source>
        <translation>&amp;Virtueller Roboter</translation>
    </message>
    <message>
        <source>The virtual robots with their joints, and the directions in which their end effectors can move.</source>
        <translation>Die virtuellen Roboter mit ihren Gelenken und den Richtungen, in die sich ihre Endeffektoren bewegen können.</translation>
    </message>
    <message>
        <source>Recorded &amp;path</source>
        <translation>Aufgezeichneter &amp;Pfad</translation>
    </message>
    <message>
        <source>The path of the tip in the replayed session; the more force, the more vermillion.</source>
        <translation>Der Weg der Spitze in der wiedergegebenen Sitzung; je mehr Kraft, desto zinnoberroter.</translation>
    </message>
    <message>
        <source>&amp;Desk</source>
        <translation>&amp;Tisch</translation>
    </message>
    <message>
        <source>The reference points on the desk with which the arm was registered.</source>
        <translation>Die Messpunkte auf dem Tisch, mit denen der Arm registriert wurde.</translation>
    </message>
    <message>
        <source>As se&amp;en from the desk</source>
        <translation>Vom Tisch aus &amp;gesehen</translation>
    </message>
    <message>
        <source>Left, right and up are those of the desk, however a registered arm is turned. Off: those of the arm.</source>
        <translation>Links, rechts und oben sind die des Tischs, wie auch ein registrierter Arm gedreht ist. Aus: die des Arms.</translation>
    </message>
    <message>
        <source>&amp;Link frames</source>
        <translation>Glie&amp;dkoordinaten</translation>
    </message>
    <message>
        <source>The frames 1 to 6 of the DH table along the arm; each number is at the end of the z axis of its joint.</source>
        <translation>Die Koordinatensysteme 1 bis 6 der DH-Tabelle entlang des Arms; jede Zahl steht am Ende der z-Achse ihres Gelenks.</translation>
    </message>
    <message>
        <source>Inver&amp;se solutions</source>
        <translation>&amp;Inverse Lösungen</translation>
    </message>
    <message>
        <source>All configurations in which the arm reaches the pose of the stylus, as ghosts; dashed: outside the joint limits.</source>
        <translation>Alle Stellungen, in denen der Arm die Lage des Stifts erreicht, als Geisterbilder; gestrichelt: außerhalb der Gelenkgrenzen.</translation>
    </message>
    <message>
        <source>&amp;Motion ellipsoid (v)</source>
        <translation>&amp;Bewegungsellipsoid (v)</translation>
    </message>
    <message>
        <source>The motions of the tip for joint rotations of magnitude 0.25 rad (manipulability ellipsoid).</source>
        <translation>Die Bewegungen der Spitze bei Gelenkdrehungen vom Betrag 0,25 rad (Manipulierbarkeitsellipsoid).</translation>
    </message>
    <message>
        <source>F&amp;orce ellipsoid (f)</source>
        <translation>Kra&amp;ftellipsoid (f)</translation>
    </message>
    <message>
        <source>The forces for joint torques of one magnitude, which the panel Kinematics names, to the scale of the force arrow.</source>
        <translation>Die Kräfte bei Gelenkdrehmomenten von einem Betrag, den das Panel Kinematik nennt, im Maßstab des Kraftpfeils.</translation>
    </message>
    <message>
        <source>Mes&amp;h: triangles</source>
        <translation>&amp;Netz: Dreiecke</translation>
    </message>
    <message>
        <source>The edges of all triangles of a mesh as drawn.</source>
        <translation>Die Kanten aller gezeichneten Dreiecke eines Dreiecksnetzes.</translation>
    </message>
    <message>
        <source>Mesh: &amp;cut open</source>
        <translation>Netz: auf&amp;schneiden</translation>
    </message>
    <message>
        <source>Cuts meshes open perpendicular to an axis and hides the side nearer to you. What you feel is not cut.</source>
        <translation>Schneidet Dreiecksnetze senkrecht zu einer Achse auf und verbirgt die Seite, die Ihnen näher ist. Was Sie fühlen, bleibt ganz.</translation>
    </message>
    <message>
        <source>C&amp;ut follows the stylus</source>
        <translation>S&amp;chnitt folgt dem Stift</translation>
    </message>
    <message>
        <source>The cut passes through the tip. Off: it stays where it is.</source>
        <translation>Der Schnitt geht durch die Spitze. Aus: Er bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
</context>
<context>
    <name>lesson text</name>
    <message>
        <source>Frames and transforms</source>
        <translation>Koordinatensysteme und Transformationen</translation>
    </message>
    <message>
        <source>Kinematics</source>
        <translation>Kinematik</translation>
    </message>
    <message>
        <source>One position of the tip, seen from two frames.</source>
        <translation>Eine Position der Spitze, aus zwei Koordinatensystemen gesehen.</translation>
    </message>
    <message>
        <source>The frame W</source>
        <translation>Koordinatensystem W</translation>
    </message>
    <message>
        <source>A **frame** is three axes at right angles and the point in which they meet, its origin. The origin of the
workspace frame **W** is in the middle of the box; $x$ points to the right, $y$ up, $z$ towards you.

Move the tip to each of these positions: $(40, 0, 50)$, $(0, 40, 50)$ and $(0, 0, 10)$ mm. Drag the stylus with
the mouse, or press F2 and use the arrow keys (Page Up moves it away from you, Page Down towards you).</source>
        <translation>Ein **Koordinatensystem** besteht aus drei Achsen im rechten Winkel und dem Punkt, in dem sie sich treffen, seinem Ursprung. Der Ursprung des Koordinatensystems **W** des Arbeitsraums liegt in der
Mitte des Quaders; $x$ zeigt nach rechts, $y$ nach oben, $z$ auf Sie zu.

Führen Sie die Spitze nacheinander an diese Orte: $(40, 0, 50)$, $(0, 40, 50)$ und $(0, 0, 10)$ mm.
Ziehen Sie den Stift mit der Maus, oder drücken Sie F2 und benutzen Sie die Pfeiltasten (Bild auf führt ihn von Ihnen weg, Bild ab zu Ihnen hin).</translation>
    </message>
    <message>
        <source>The panel *Arm* shows the position of the tip. With Shift, an arrow key moves it by 10 mm.</source>
        <translation>Der Bereich *Arm* zeigt die Position der Spitze. Mit Umschalt bewegt eine Pfeiltaste sie um 10 mm.</translation>
    </message>
    <message>
        <source>The same position in B</source>
        <translation>Dieselbe Position in B</translation>
    </message>
    <message>
        <source>The arm has its own base frame **B**, frame 0 of its DH table. It is rotated and translated with respect to W. A
point with the coordinates $(x_W, y_W, z_W)$ in W has these coordinates in B (thesis eq. 3.1, in mm):

$$x_B = z_W + 176$$

$$y_B = x_W$$

$$z_B = y_W - 30$$

Hold the stylus anywhere and calculate the position of the tip in B.</source>
        <translation>Der Arm hat ein eigenes Koordinatensystem an seiner Basis: **B**, das Koordinatensystem 0 seiner DH-Tabelle. Es ist gegenüber W gedreht und verschoben. Ein Punkt mit den
Koordinaten $(x_W, y_W, z_W)$ in W hat in B diese Koordinaten (Thesis, Gl. 3.1, in mm):

$$x_B = z_W + 176$$

$$y_B = x_W$$

$$z_B = y_W - 30$$

Halten Sie den Stift an einem beliebigen Ort und berechnen Sie den Ort der Spitze in B.</translation>
    </message>
    <message>
        <source>Read $x_W$, $y_W$ and $z_W$ in the panel *Arm* and insert them into the three equations.</source>
        <translation>Lesen Sie $x_W$, $y_W$ und $z_W$ im Bereich *Arm* ab und setzen Sie sie in die drei Gleichungen ein.</translation>
    </message>
    <message>
        <source>What is x in B, in mm?</source>
        <translation>Wie groß ist x in B, in mm?</translation>
    </message>
    <message>
        <source>What is y in B, in mm?</source>
        <translation>Wie groß ist y in B, in mm?</translation>
    </message>
    <message>
        <source>What is z in B, in mm?</source>
        <translation>Wie groß ist z in B, in mm?</translation>
    </message>
    <message>
        <source>Back to W</source>
        <translation>Zurück zu W</translation>
    </message>
    <message>
        <source>A transform can be inverted. From B to W it is

$$x_W = y_B$$

$$y_W = z_B + 30$$

$$z_W = x_B - 176$$

Move the tip to the point with the coordinates $(216, 0, 10)$ mm **in B**, and hold it there for one second.</source>
        <translation>Eine Transformation lässt sich invertieren. Von B nach W lautet sie

$$x_W = y_B$$

$$y_W = z_B + 30$$

$$z_W = x_B - 176$$

Führen Sie die Spitze an den Ort, der **in B** die Koordinaten $(216, 0, 10)$ mm hat, und halten Sie sie dort eine Sekunde lang.</translation>
    </message>
    <message>
        <source>In W that point is $(0, 40, 40)$ mm.</source>
        <translation>In W ist diese Position $(0, 40, 40)$ mm.</translation>
    </message>
    <message>
        <source>A rotated frame</source>
        <translation>Gedrehtes Koordinatensystem</translation>
    </message>
    <message>
        <source>The columns of a **rotation matrix** are the axes of one frame, expressed in the other. The third column of the
matrix of the stylus is the direction in which the stylus points.

Turn the stylus until it points up, along $y$ of W; its third column is then $(0, 1, 0)$. Press F2, then turn it
with Ctrl and the arrow keys.</source>
        <translation>Die Spalten einer **Rotationsmatrix** sind die Achsen des einen Koordinatensystems, im anderen ausgedrückt. Die dritte Spalte der Matrix des Stifts ist die Richtung, in die der Stift zeigt.

Drehen Sie den Stift, bis er nach oben zeigt, entlang $y$ von W; seine dritte Spalte ist dann $(0, 1, 0)$. Drücken Sie F2 und drehen Sie ihn mit Strg und den Pfeiltasten.</translation>
    </message>
    <message>
        <source>In the view from the front, hold Ctrl and press the up arrow key.</source>
        <translation>In der Ansicht von vorn: Halten Sie Strg und drücken Sie die Pfeiltaste nach oben.</translation>
    </message>
    <message>
        <source>Order matters</source>
        <translation>Reihenfolge zählt</translation>
    </message>
    <message>
        <source>Two rotations, one after the other, are a product of matrices, and matrices do not commute. A rotation about a
**fixed** axis of W multiplies from the left: first about $x$, then about $y$ is $R = R_y R_x$.

Try it with a book: rotate it by 90° about $x$, then by 90° about $y$. Then reverse the order. The panel
*Transforms* does the same: choose fixed axes, $R_x$ 90 and $R_y$ 90; it draws both orders.</source>
        <translation>Zwei Drehungen nacheinander sind ein Produkt von Matrizen, und Matrizen sind nicht vertauschbar. Eine Drehung um eine **feste** Achse von W multipliziert von links: zuerst um $x$, dann um $y$ ist $R = R_y R_x$.

Versuchen Sie es mit einem Buch: Drehen Sie es um 90° um $x$, dann um 90° um $y$. Danach in umgekehrter Reihenfolge. Der Bereich
*Transformationen* macht dasselbe: Wählen Sie feste Achsen, $R_x$ 90 und $R_y$ 90; er zeichnet beide Reihenfolgen.</translation>
    </message>
    <message>
        <source>First about $x$: $z$ becomes $-y$; the rotation about $y$ does not change that. First about $y$: $z$ becomes $x$; the rotation about $x$ does not change that.</source>
        <translation>Zuerst um $x$: $z$ wird zu $-y$; die Drehung um $y$ ändert daran nichts. Zuerst um $y$: $z$ wird zu $x$; die Drehung um $x$ ändert daran nichts.</translation>
    </message>
    <message>
        <source>First 90° about x, then 90° about y: where does z end up?</source>
        <translation>Zuerst 90° um x, dann 90° um y: Wohin kommt z?</translation>
    </message>
    <message>
        <source>+x</source>
        <translation>+x</translation>
    </message>
    <message>
        <source>+y</source>
        <translation>+y</translation>
    </message>
    <message>
        <source>−y</source>
        <translation>−y</translation>
    </message>
    <message>
        <source>−z</source>
        <translation>−z</translation>
    </message>
    <message>
        <source>Order of the rotations reversed</source>
        <translation>Reihenfolge der Drehungen vertauscht</translation>
    </message>
    <message>
        <source>First 90° about y, then 90° about x: where does z end up?</source>
        <translation>Zuerst 90° um y, dann 90° um x: Wohin kommt z?</translation>
    </message>
    <message>
        <source>Denavit-Hartenberg parameters</source>
        <translation>Denavit-Hartenberg-Parameter</translation>
    </message>
    <message>
        <source>Four numbers per joint describe an arm.</source>
        <translation>Vier Zahlen je Gelenk beschreiben einen Arm.</translation>
    </message>
    <message>
        <source>Four numbers per joint</source>
        <translation>Vier Zahlen je Gelenk</translation>
    </message>
    <message>
        <source>Four numbers lead from the frame of one joint to the next (Craig's modified convention): a rotation $\alpha$ about
$x$, a translation $a$ along $x$, a rotation $\theta$ about $z$ and a translation $d$ along $z$:

$$T = R_x(\alpha) \cdot D_x(a) \cdot R_z(\theta) \cdot D_z(d)$$

The panel *Kinematics* shows the table of the arm, the view the frames 1 to 6. Each $z$ is the axis of its joint.</source>
        <translation>Vom Koordinatensystem eines Gelenks zum nächsten führen vier Zahlen (modifizierte Konvention nach Craig): eine Drehung $\alpha$ um
$x$, eine Verschiebung $a$ entlang $x$, eine Drehung $\theta$ um $z$ und eine Verschiebung $d$ entlang $z$:

$$T = R_x(\alpha) \cdot D_x(a) \cdot R_z(\theta) \cdot D_z(d)$$

Der Bereich *Kinematik* zeigt die Tabelle des Arms, die Ansicht die Koordinatensysteme 1 bis 6. Jedes $z$ ist die Achse seines Gelenks.</translation>
    </message>
    <message>
        <source>Open *DH table* in the panel *Kinematics*. The upper arm is $a$ of row 3, the forearm $d$ of row 4.</source>
        <translation>Öffnen Sie *DH-Tabelle* im Bereich *Kinematik*. Der Oberarm ist $a$ in Zeile 3, der Unterarm $d$ in Zeile 4.</translation>
    </message>
    <message>
        <source>How long is the upper arm, a of row 3, in mm?</source>
        <translation>Wie lang ist der Oberarm, a in Zeile 3, in mm?</translation>
    </message>
    <message>
        <source>Wrong row of the DH table</source>
        <translation>Falsche Zeile der DH-Tabelle</translation>
    </message>
    <message>
        <source>How long is the forearm, d of row 4, in mm?</source>
        <translation>Wie lang ist der Unterarm, d in Zeile 4, in mm?</translation>
    </message>
    <message>
        <source>One of them changes</source>
        <translation>Eine davon ändert sich</translation>
    </message>
    <message>
        <source>Three of the four numbers are fixed by the design of the arm. Only $\theta$ changes when a joint turns.

Turn joint 1, the turret, from one side to the other, through 40° in total, and leave the other joints nearly as
they are. While the servo is stopped (Esc), move the joints with the sliders of the panel *Kinematics*, or drag
the stylus in the view.</source>
        <translation>Drei der vier Zahlen sind durch die Konstruktion des Arms festgelegt. Nur $\theta$ ändert sich, wenn sich ein Gelenk dreht.

Drehen Sie Gelenk 1, den Drehturm, von einer Seite zur anderen, über einen Bereich von insgesamt 40°, und lassen Sie die übrigen fast so, wie sie sind.
Bewegen Sie die Gelenke bei gestopptem Servo (Esc) mit den Schiebereglern im Bereich *Kinematik*, oder ziehen Sie den Stift in der Ansicht.</translation>
    </message>
    <message>
        <source>Use the slider of joint 1. In the view from the top, the tip moves on a circle about axis 1.</source>
        <translation>Benutzen Sie den Schieberegler von Gelenk 1. In der Ansicht von oben läuft die Spitze auf einem Kreis um Achse 1.</translation>
    </message>
    <message>
        <source>What the twist means</source>
        <translation>Was die Verwindung bedeutet</translation>
    </message>
    <message>
        <source>The twist $\alpha$ is the angle from the axis of one joint to that of the next, about $x$. At 0° the two axes are
parallel, at 90° perpendicular.

Look at the column $\alpha$ in the panel *DH table*, and at the frames in the view. The view also draws the arm
that the table describes: type 90 for $\alpha$ in row 3, and see where the forearm would be. *Undo* restores the
value.</source>
        <translation>Die Verwindung $\alpha$ ist der Winkel von der Achse eines Gelenks zur Achse des nächsten, um $x$. Bei 0° sind die beiden Achsen parallel, bei 90° stehen sie senkrecht aufeinander.

Betrachten Sie die Spalte $\alpha$ im Bereich *DH-Tabelle* und die Koordinatensysteme in der Ansicht. Die Ansicht zeichnet auch den Arm, den die Tabelle beschreibt: Geben Sie bei $\alpha$ in Zeile 3 den Wert 90 ein und sehen Sie, wo der Unterarm wäre. *Rückgängig* stellt den alten Wert wieder her.</translation>
    </message>
    <message>
        <source>Row 3 has $\alpha = 0$; it leads from axis 2 to axis 3.</source>
        <translation>Zeile 3 hat $\alpha = 0$; sie führt von Achse 2 zu Achse 3.</translation>
    </message>
    <message>
        <source>Which two axes are parallel?</source>
        <translation>Welche zwei Achsen sind parallel?</translation>
    </message>
    <message>
        <source>1 and 2</source>
        <translation>1 und 2</translation>
    </message>
    <message>
        <source>2 and 3</source>
        <translation>2 und 3</translation>
    </message>
    <message>
        <source>3 and 4</source>
        <translation>3 und 4</translation>
    </message>
    <message>
        <source>5 and 6</source>
        <translation>5 und 6</translation>
    </message>
    <message>
        <source>Twist of 90° taken for parallel axes</source>
        <translation>Verwindung von 90° für parallele Achsen gehalten</translation>
    </message>
    <message>
        <source>Set the joints</source>
        <translation>Gelenke einstellen</translation>
    </message>
    <message>
        <source>Now the other way round: set $\theta_1 = 0°$, $\theta_2 = 45°$ and $\theta_3 = 15°$ with the sliders of joints 1
to 3, and hold them for one second. Stop the servo first (Esc).

Watch frame 3 at the elbow: $\theta_3$ is measured from the upper arm, not from the desk.</source>
        <translation>Nun umgekehrt: Stellen Sie $\theta_1 = 0°$, $\theta_2 = 45°$ und $\theta_3 = 15°$ mit den Schiebereglern der
Gelenke 1 bis 3 ein, und halten Sie sie eine Sekunde lang. Stoppen Sie zuerst den Servo (Esc).

Beobachten Sie Koordinatensystem 3 am Ellbogen: $\theta_3$ wird vom Oberarm aus gemessen, nicht vom Tisch aus.</translation>
    </message>
    <message>
        <source>You can also type a number in the field beside the slider. Friction stops the arm a few tenths of a degree short; that is close enough.</source>
        <translation>Sie können auch im Feld neben dem Schieberegler eine Zahl eingeben. Durch Reibung bleibt der Arm einige Zehntelgrad vorher stehen; das ist nahe genug.</translation>
    </message>
    <message>
        <source>The device's own angles</source>
        <translation>Die eigenen Winkel des Geräts</translation>
    </message>
    <message>
        <source>The device measures the angle of the shin with respect to its base, where both motors are (thesis figure 3.5):

$$\theta_1 = -\theta_{1p}$$

$$\theta_2 = \theta_{2p}$$

$$\theta_3 = \theta_{3p} - \theta_{2p}$$

Hold the arm in any configuration. From $\theta_2$ and $\theta_3$ of the table, calculate $\theta_{3p}$, the
device's own angle of the shin.</source>
        <translation>Das Gerät misst den Winkel des Unterschenkels gegenüber seiner Basis, in der beide Motoren sitzen (Thesis, Abbildung 3.5):

$$\theta_1 = -\theta_{1p}$$

$$\theta_2 = \theta_{2p}$$

$$\theta_3 = \theta_{3p} - \theta_{2p}$$

Halten Sie den Arm in einer beliebigen Stellung. Berechnen Sie aus $\theta_2$ und $\theta_3$ der Tabelle den Winkel $\theta_{3p}$, den das Gerät für den Unterschenkel misst.</translation>
    </message>
    <message>
        <source>$\theta_{3p} = \theta_2 + \theta_3$. *Angle conventions* in the panel *Kinematics* shows whether you are right.</source>
        <translation>$\theta_{3p} = \theta_2 + \theta_3$. *Winkelkonventionen* im Bereich *Kinematik* zeigt, ob Ihr Ergebnis stimmt.</translation>
    </message>
    <message>
        <source>What is the device's angle of the shin, in degrees?</source>
        <translation>Welchen Winkel misst das Gerät für den Unterschenkel, in Grad?</translation>
    </message>
    <message>
        <source>Forward kinematics</source>
        <translation>Vorwärtskinematik</translation>
    </message>
    <message>
        <source>From joint angles to the position of the tip.</source>
        <translation>Von den Gelenkwinkeln zur Position der Spitze.</translation>
    </message>
    <message>
        <source>The arm in its plane</source>
        <translation>Der Arm in seiner Ebene</translation>
    </message>
    <message>
        <source>When the turret points straight ahead ($\theta_1 = 0$), the arm lies in a plane. The distance and the height of
the tip with respect to the shoulder are

$$r = L_1 \cos\theta_2 + L_2 \sin(\theta_2 + \theta_3)$$

$$z_B = L_1 \sin\theta_2 - L_2 \cos(\theta_2 + \theta_3)$$

with $L_1 = 127.508$ and $L_2 = 149.352$ mm (thesis eq. 3.5).

Stop the servo (Esc) and set $\theta_1 = 0°$, $\theta_2 = 30°$, $\theta_3 = 30°$.</source>
        <translation>Steht der Drehturm geradeaus ($\theta_1 = 0$), liegt der Arm in einer Ebene. Abstand und Höhe der Spitze gegenüber der Schulter sind

$$r = L_1 \cos\theta_2 + L_2 \sin(\theta_2 + \theta_3)$$

$$z_B = L_1 \sin\theta_2 - L_2 \cos(\theta_2 + \theta_3)$$

mit $L_1 = 127.508$ und $L_2 = 149.352$ mm (Thesis, Gl. 3.5).

Stoppen Sie den Servo (Esc) und stellen Sie $\theta_1 = 0°$, $\theta_2 = 30°$, $\theta_3 = 30°$ ein.</translation>
    </message>
    <message>
        <source>Use the sliders of the panel *Kinematics*, or type the angles beside them.</source>
        <translation>Benutzen Sie die Schieberegler im Bereich *Kinematik*, oder geben Sie die Winkel daneben ein.</translation>
    </message>
    <message>
        <source>Predict it</source>
        <translation>Vorhersagen</translation>
    </message>
    <message>
        <source>With $\theta_2 = 30°$ and $\theta_3 = 30°$: $\cos 30° = 0.866$ and $\sin 60° = 0.866$, so $r = 0.866 \cdot (127.5 + 149.4)$ mm.

In W that is $z_W = r - 176$ mm. Work it out before you look at the panel *Arm*.</source>
        <translation>Mit $\theta_2 = 30°$ und $\theta_3 = 30°$ gilt: $\cos 30° = 0.866$ und $\sin 60° = 0.866$, also $r = 0.866 \cdot (127.5 + 149.4)$ mm.

In W ist das $z_W = r - 176$ mm. Rechnen Sie es aus, bevor Sie in den Bereich *Arm* sehen.</translation>
    </message>
    <message>
        <source>$r = 239.8$ mm.</source>
        <translation>$r = 239.8$ mm.</translation>
    </message>
    <message>
        <source>What is z of the tip in W, in mm?</source>
        <translation>Wie groß ist z der Spitze in W, in mm?</translation>
    </message>
    <message>
        <source>Offset between W and B forgotten</source>
        <translation>Versatz zwischen W und B vergessen</translation>
    </message>
    <message>
        <source>Out of the plane</source>
        <translation>Aus der Ebene heraus</translation>
    </message>
    <message>
        <source>The turret turns the whole plane about the vertical axis:

$$x_B = \cos\theta_1 \cdot r$$

$$y_B = \sin\theta_1 \cdot r$$

Work out where the tip is for $\theta_1 = 20°$, $\theta_2 = 40°$, $\theta_3 = 10°$. Then set the angles and compare.</source>
        <translation>Der Drehturm dreht die ganze Ebene um die senkrechte Achse:

$$x_B = \cos\theta_1 \cdot r$$

$$y_B = \sin\theta_1 \cdot r$$

Rechnen Sie aus, wo die Spitze für $\theta_1 = 20°$, $\theta_2 = 40°$, $\theta_3 = 10°$ ist. Stellen Sie dann die Winkel ein und vergleichen Sie.</translation>
    </message>
    <message>
        <source>$r = 127.5 \cdot 0.766 + 149.4 \cdot 0.766 = 212.1$ mm, and $y_B = x_W$.</source>
        <translation>$r = 127.5 \cdot 0.766 + 149.4 \cdot 0.766 = 212.1$ mm, und $y_B = x_W$.</translation>
    </message>
    <message>
        <source>What is x in W (that is y in B), in mm?</source>
        <translation>Wie groß ist x in W (also y in B), in mm?</translation>
    </message>
    <message>
        <source>Sine and cosine confused</source>
        <translation>Sinus und Kosinus verwechselt</translation>
    </message>
    <message>
        <source>The wrist does not move the tip</source>
        <translation>Das Handgelenk bewegt die Spitze nicht</translation>
    </message>
    <message>
        <source>The axes of joints 4, 5 and 6 intersect at the tip. These joints turn the stylus and leave the tip where it is:
position and orientation can be calculated one after the other.

Turn joint 4 through 40° and keep the tip within 6 mm of $(0, 0, 50)$.</source>
        <translation>Die Achsen der Gelenke 4, 5 und 6 schneiden sich in der Spitze. Diese Gelenke drehen den Stift und lassen die Spitze, wo sie ist: Ort und
Orientierung lassen sich nacheinander berechnen.

Drehen Sie Gelenk 4 über einen Bereich von 40° und halten Sie die Spitze höchstens 6 mm von $(0, 0, 50)$ entfernt.</translation>
    </message>
    <message>
        <source>Stop the servo and use the slider of joint 4, or turn the stylus with Ctrl and the arrow keys.</source>
        <translation>Stoppen Sie den Servo und benutzen Sie den Schieberegler von Gelenk 4, oder drehen Sie den Stift mit Strg und den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Eight inverse solutions</source>
        <translation>Acht inverse Lösungen</translation>
    </message>
    <message>
        <source>One pose of the stylus, eight configurations of the arm.</source>
        <translation>Eine Lage des Stifts, acht Stellungen des Arms.</translation>
    </message>
    <message>
        <source>How many?</source>
        <translation>Wie viele?</translation>
    </message>
    <message>
        <source>Forward kinematics gives one pose for a set of joint angles. Inverse kinematics gives several sets of joint angles
for one pose: the turret can face the stylus or turn its back on it, the elbow can be up or down, the wrist can be
bent to one side or the other.

The view draws all of them as ghosts: those with solid lines are within the joint limits, those with dashed lines
are not. Move the stylus and count the rows of *Inverse solutions* in the panel *Kinematics*.</source>
        <translation>Die Vorwärtskinematik ergibt aus Gelenkwinkeln eine einzige Lage. Die Rückwärtskinematik hat für eine Lage mehrere Lösungen: Der Drehturm kann dem Stift zugewandt oder von ihm
abgewandt sein, der Ellbogen oben oder unten, das Handgelenk zur einen oder zur anderen Seite gebeugt.

Die Ansicht zeichnet sie alle als Geisterbilder: Die durchgezogenen halten die Gelenkgrenzen ein, die gestrichelten nicht. Bewegen Sie den Stift und zählen Sie
die Zeilen von *Inverse Lösungen* im Bereich *Kinematik*.</translation>
    </message>
    <message>
        <source>Select a row: a ghost of the arm moves to that solution.</source>
        <translation>Wählen Sie eine Zeile: Ein Geisterbild des Arms geht zu dieser Lösung.</translation>
    </message>
    <message>
        <source>How many solutions does this pose have?</source>
        <translation>Wie viele Lösungen hat diese Lage?</translation>
    </message>
    <message>
        <source>Only some are possible</source>
        <translation>Nur einige sind möglich</translation>
    </message>
    <message>
        <source>A real arm has limits: its turret turns by 56° to either side, its elbow bends from $\theta_3 = -46°$ to 78°, its
wrist from $\theta_5 = 36°$ to 149°. In the workspace the arm is therefore always in solution 1, the row that says
*now*: a stop is in the way of every other solution. The turret cannot face backwards, the elbow stops before it
is straight (90°), the wrist stops before axes 4 and 6 are aligned (0°).

The last column of the table says which of the eight keep every joint within its limits.</source>
        <translation>Ein echter Arm hat Grenzen: Sein Drehturm dreht sich um 56° nach jeder Seite, sein Ellbogen beugt sich von $\theta_3 = -46°$ bis 78°, sein Handgelenk
von $\theta_5 = 36°$ bis 149°. Im Arbeitsraum ist der Arm deshalb immer in Lösung 1, der Zeile, in der *jetzt* steht:
Vor jeder anderen Lösung ist ein Anschlag. Der Drehturm kann sich nicht nach hinten drehen, der Ellbogen hält an, bevor er gestreckt ist (90°), das Handgelenk,
bevor die Achsen 4 und 6 auf einer Geraden liegen (0°).

Die letzte Spalte der Tabelle sagt, welche der acht jedes Gelenk innerhalb seiner Grenzen lassen.</translation>
    </message>
    <message>
        <source>Count the rows whose last column does not say *outside*.</source>
        <translation>Zählen Sie die Zeilen, in deren letzter Spalte nicht *außerhalb* steht.</translation>
    </message>
    <message>
        <source>How many of them are within the limits here?</source>
        <translation>Wie viele davon halten hier die Grenzen ein?</translation>
    </message>
    <message>
        <source>A second one within the limits</source>
        <translation>Eine zweite innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>In the other wrist solution $\theta_4$ and $\theta_6$ are half a turn further and $\theta_5$ has the opposite
sign. The program compares the size of $\theta_5$ with the limits, so that this solution can pass; the joint of a
real arm bends one way only. With joint 4 near the middle of its range, another half turn is beyond its limits; with
joint 4 turned to one side it is not.

Turn the stylus until two of the eight are within the limits, and hold it for half a second.</source>
        <translation>In der anderen Lösung des Handgelenks sind $\theta_4$ und $\theta_6$ eine halbe Drehung weiter, und $\theta_5$ hat das andere Vorzeichen. Das Programm
vergleicht den Betrag von $\theta_5$ mit den Grenzen, sodass diese Lösung sie einhalten kann; das Gelenk eines wirklichen Arms biegt sich nur zu
einer Seite. Steht Gelenk 4 nahe seiner Mitte, so führt eine halbe Drehung über seine Grenzen hinaus; ist es zu
einer Seite gedreht, so nicht.

Drehen Sie den Stift, bis zwei der acht die Grenzen einhalten, und halten Sie ihn eine halbe Sekunde lang.</translation>
    </message>
    <message>
        <source>Stop the servo (Esc) and move joint 4 to more than 35° with its slider in the panel *Kinematics*, or turn the stylus with Ctrl and the arrow keys.</source>
        <translation>Stoppen Sie den Servo (Esc) und stellen Sie Gelenk 4 mit seinem Schieberegler im Bereich *Kinematik* auf mehr als 35°, oder drehen Sie den Stift mit Strg und den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Can your hand move the arm from one of the two to the other?</source>
        <translation>Kann Ihre Hand den Arm von der einen der beiden zur anderen führen?</translation>
    </message>
    <message>
        <source>yes, directly</source>
        <translation>ja, direkt</translation>
    </message>
    <message>
        <source>yes, through another pose</source>
        <translation>ja, über eine andere Lage</translation>
    </message>
    <message>
        <source>no, joint 5 would have to go through 0°</source>
        <translation>nein, Gelenk 5 müsste durch 0° gehen</translation>
    </message>
    <message>
        <source>Solutions thought to be connected</source>
        <translation>Lösungen für verbunden gehalten</translation>
    </message>
    <message>
        <source>Two elbows</source>
        <translation>Zwei Ellbogen</translation>
    </message>
    <message>
        <source>The distance of the tip from the shoulder determines the angle of the elbow: with $x$, $y$ and $z$ of the tip in
B,

$$S = \sin\theta_3 = \frac{x^2 + y^2 + z^2 - L_1^2 - L_2^2}{2 L_1 L_2}$$

$$\theta_3 = \mathrm{atan2}(S, \pm\sqrt{1 - S^2})$$

Two angles have the same sine: $\theta_3$ and $180° - \theta_3$. These are the two elbow solutions.

Move the stylus to where $S = 0.5$, so that the elbow is at $\theta_3 = 30°$, and hold it for half a second. The
ghosts with the other elbow show the second angle.</source>
        <translation>Der Abstand der Spitze von der Schulter bestimmt den Winkel des Ellbogens: Mit $x$, $y$ und $z$ der Spitze in B gilt

$$S = \sin\theta_3 = \frac{x^2 + y^2 + z^2 - L_1^2 - L_2^2}{2 L_1 L_2}$$

$$\theta_3 = \mathrm{atan2}(S, \pm\sqrt{1 - S^2})$$

Zu einem Sinus gehören zwei Winkel: $\theta_3$ und $180° - \theta_3$. Das sind die beiden Lösungen des Ellbogens.

Führen Sie den Stift dorthin, wo $S = 0.5$ ist, sodass der Ellbogen bei $\theta_3 = 30°$ steht, und halten Sie ihn eine halbe Sekunde lang. Die Geisterbilder mit
dem anderen Ellbogen zeigen den zweiten Winkel.</translation>
    </message>
    <message>
        <source>Move to about $(0, 0, 62)$ mm. The other elbow is at $180° - 30°$.</source>
        <translation>Gehen Sie etwa nach $(0, 0, 62)$ mm. Der andere Ellbogen steht bei $180° - 30°$.</translation>
    </message>
    <message>
        <source>What is the angle of the other elbow, in degrees?</source>
        <translation>Welchen Winkel hat der andere Ellbogen, in Grad?</translation>
    </message>
    <message>
        <source>One angle for a sine, where there are two</source>
        <translation>Ein Winkel je Sinus, wo es zwei gibt</translation>
    </message>
    <message>
        <source>−θ₃ in place of 180° − θ₃</source>
        <translation>−θ₃ statt 180° − θ₃</translation>
    </message>
    <message>
        <source>Where two become one</source>
        <translation>Wo zwei zu einem werden</translation>
    </message>
    <message>
        <source>The farther out the tip, the closer the two elbows are. At $S = 1$ the arm is stretched and they coincide; at
$S &gt; 1$ the tip is out of reach.

Pull the stylus towards you until the elbow is less than 20° from straight, and hold it for half a second. Watch
the elbows of the two ghosts meet.</source>
        <translation>Je weiter außen die Spitze ist, desto näher rücken die beiden Ellbogen zusammen. Bei $S = 1$ ist der Arm gestreckt, und sie fallen zusammen; bei $S &gt; 1$ ist die Spitze außer Reichweite.

Ziehen Sie den Stift zu sich, bis am Ellbogen weniger als 20° bis zur Streckung fehlen, und halten Sie ihn eine halbe Sekunde lang. Beobachten Sie, wie die Ellbogen der beiden Geisterbilder zusammenkommen.</translation>
    </message>
    <message>
        <source>In the view from the front, Page Down moves the stylus towards you. Move to about $z = 98$ mm, 25 mm above the middle.</source>
        <translation>Bild ab bringt den Stift in der Ansicht von vorn näher. Gehen Sie bis etwa $z = 98$ mm, 25 mm über der Mitte.</translation>
    </message>
    <message>
        <source>Two wrists</source>
        <translation>Zwei Handgelenke</translation>
    </message>
    <message>
        <source>Two sets of wrist angles give the stylus the same orientation:

$$(\theta_4, \theta_5, \theta_6)$$

$$(\theta_4 + 180°, -\theta_5, \theta_6 + 180°)$$

In between, at $\theta_5 = 0$, axes 4 and 6 are aligned and only the sum of their angles counts.

Move joint 5 to 60° and hold it for half a second; select the row of the other wrist and watch its ghost turn.</source>
        <translation>Zwei Stellungen des Handgelenks geben dem Stift dieselbe Orientierung:

$$(\theta_4, \theta_5, \theta_6)$$

$$(\theta_4 + 180°, -\theta_5, \theta_6 + 180°)$$

Dazwischen, bei $\theta_5 = 0$, liegen die Achsen 4 und 6 auf einer Geraden, und nur die Summe ihrer Winkel zählt.

Bringen Sie Gelenk 5 auf 60° und halten Sie es eine halbe Sekunde lang; wählen Sie die Zeile des anderen Handgelenks und sehen Sie zu, wie sich dessen Geisterbild dreht.</translation>
    </message>
    <message>
        <source>Joint 5 has a slider in the panel *Kinematics* (stop the servo first). The signs ± in a row stand for turret, elbow and wrist.</source>
        <translation>Gelenk 5 hat einen Schieberegler im Bereich *Kinematik* (stoppen Sie zuerst den Servo). Die Vorzeichen ± einer Zeile stehen für Drehturm, Ellbogen und Handgelenk.</translation>
    </message>
    <message>
        <source>What is θ₅ of the other wrist, in degrees?</source>
        <translation>Wie groß ist θ₅ beim anderen Handgelenk, in Grad?</translation>
    </message>
    <message>
        <source>180° − θ₅ in place of −θ₅</source>
        <translation>180° − θ₅ statt −θ₅</translation>
    </message>
    <message>
        <source>θ₅ thought to be the same in both wrists</source>
        <translation>θ₅ in beiden Handgelenken für gleich gehalten</translation>
    </message>
    <message>
        <source>At θ₅ = 0, how many combinations of θ₄ and θ₆ give the same orientation?</source>
        <translation>Wie viele Kombinationen von θ₄ und θ₆ ergeben bei θ₅ = 0 dieselbe Orientierung?</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
    <message>
        <source>two</source>
        <translation>zwei</translation>
    </message>
    <message>
        <source>eight</source>
        <translation>acht</translation>
    </message>
    <message>
        <source>infinitely many</source>
        <translation>unendlich viele</translation>
    </message>
    <message>
        <source>Singular pose counted as any other</source>
        <translation>Singuläre Lage wie jede andere gezählt</translation>
    </message>
    <message>
        <source>Jacobian and singularities</source>
        <translation>Jacobi-Matrix und Singularitäten</translation>
    </message>
    <message>
        <source>From joint rates to the velocity of the tip, and where the arm loses a direction.</source>
        <translation>Von den Drehgeschwindigkeiten der Gelenke zur Geschwindigkeit der Spitze, und wo dem Arm eine Richtung fehlt.</translation>
    </message>
    <message>
        <source>A matrix for velocities</source>
        <translation>Matrix der Geschwindigkeiten</translation>
    </message>
    <message>
        <source>The **Jacobian** $J_p$ maps the rates of joints 1 to 3 to the velocity of the tip: $v = J_p \cdot \omega$. All
joint rates of magnitude 1 together give an ellipsoid of velocities of the tip, drawn in blue. Where it is long, a
small rotation of the joints moves the tip far.

Drag the stylus around at 60 mm/s or more for half a second, and watch the ellipsoid change.</source>
        <translation>Die **Jacobi-Matrix** $J_p$ bildet die Drehgeschwindigkeiten der Gelenke 1 bis 3 auf die Geschwindigkeit der Spitze ab: $v = J_p \cdot \omega$. Alle Drehgeschwindigkeiten
vom Betrag 1 zusammen ergeben ein Ellipsoid der Geschwindigkeiten der Spitze, blau gezeichnet. Wo es lang ist, bewegt eine kleine Drehung der Gelenke die Spitze weit.

Ziehen Sie den Stift eine halbe Sekunde lang mit 60 mm/s oder mehr umher und beobachten Sie, wie sich das Ellipsoid ändert.</translation>
    </message>
    <message>
        <source>Drag with the mouse from side to side.</source>
        <translation>Ziehen Sie mit der Maus von einer Seite zur anderen.</translation>
    </message>
    <message>
        <source>Read the ellipsoid</source>
        <translation>Das Ellipsoid lesen</translation>
    </message>
    <message>
        <source>The semi-axes are the singular values of $J_p$: how far the tip moves per radian, from the best direction to the
worst.

Hold still and read the *Singular values* under *Jacobian* in the panel *Kinematics*.</source>
        <translation>Die Halbachsen sind die Singulärwerte von $J_p$: wie weit sich die Spitze je Radiant bewegt, von der besten Richtung bis zur schlechtesten.

Halten Sie still und lesen Sie die *Singulärwerte* unter *Jacobi-Matrix* im Bereich *Kinematik* ab.</translation>
    </message>
    <message>
        <source>It is the first of the three, the largest. The panel shows metres: 0.25 m is 250 mm.</source>
        <translation>Es ist der erste der drei, der größte. Der Bereich zeigt Meter: 0,25 m sind 250 mm.</translation>
    </message>
    <message>
        <source>How far does the tip move per radian in the best direction, in mm?</source>
        <translation>Wie weit bewegt sich die Spitze je Radiant in der besten Richtung, in mm?</translation>
    </message>
    <message>
        <source>Its volume</source>
        <translation>Sein Volumen</translation>
    </message>
    <message>
        <source>The determinant is the volume of the ellipsoid up to a constant factor. Its absolute value is Yoshikawa's
manipulability:

$$\det J_p = L_1 L_2 \cos\theta_3 \cdot (L_1 \cos\theta_2 + L_2 \sin(\theta_2 + \theta_3))$$

Find a pose where it is above 4000 cm³ (0.004 m³), and one where it is below 2500 cm³.</source>
        <translation>Die Determinante ist bis auf einen konstanten Faktor das Volumen des Ellipsoids. Ihr Betrag ist die Manipulierbarkeit nach Yoshikawa:

$$\det J_p = L_1 L_2 \cos\theta_3 \cdot (L_1 \cos\theta_2 + L_2 \sin(\theta_2 + \theta_3))$$

Finden Sie eine Lage, in der sie über 4000 cm³ (0,004 m³) liegt, und eine, in der sie unter 2500 cm³ liegt.</translation>
    </message>
    <message>
        <source>The cosine is largest at $\theta_3 = 0$, the bracket far from axis 1. Manipulability is high at about $(0, 30, 45)$ mm and low where the arm is nearly stretched.</source>
        <translation>Der Kosinus ist bei $\theta_3 = 0$ am größten, die Klammer weit weg von Achse 1. Etwa bei $(0, 30, 45)$ mm ist die Manipulierbarkeit groß, am fast gestreckten Arm klein.</translation>
    </message>
    <message>
        <source>The elbow</source>
        <translation>Der Ellbogen</translation>
    </message>
    <message>
        <source>At $\theta_3 = ±90°$ the arm is stretched or folded. Then $\cos\theta_3 = 0$: the joints can no longer move the
tip outwards. Seen from the side, the ellipsoid is flat.

Stretch the arm until the tip moves less than 35 mm per radian in the worst direction, and hold it for half a
second.</source>
        <translation>Bei $\theta_3 = ±90°$ ist der Arm gestreckt oder gefaltet. Dann ist $\cos\theta_3 = 0$: Die Gelenke können die Spitze nicht mehr nach außen bewegen.
Von der Seite gesehen ist das Ellipsoid flach.

Strecken Sie den Arm, bis sich die Spitze in der schlechtesten Richtung weniger als 35 mm je Radiant bewegt, und halten Sie ihn eine halbe Sekunde lang.</translation>
    </message>
    <message>
        <source>Pull the stylus towards you, to $z = 98$ mm, 25 mm above the middle.</source>
        <translation>Ziehen Sie den Stift zu sich, bis $z = 98$ mm, 25 mm über der Mitte.</translation>
    </message>
    <message>
        <source>The shoulder</source>
        <translation>Die Schulter</translation>
    </message>
    <message>
        <source>The bracket in the determinant is $r$, the distance of the tip from axis 1. At $r = 0$ the tip is on that axis,
and turning the turret does not move it.

Push the stylus away from you until $r$ is below 100 mm. The ellipsoid becomes narrow from side to side.</source>
        <translation>Die Klammer der Determinante ist $r$, der Abstand der Spitze von Achse 1. Bei $r = 0$ liegt die Spitze auf dieser Achse, und eine Drehung des Drehturms bewegt sie nicht.

Schieben Sie den Stift von sich weg, bis $r$ unter 100 mm liegt. Das Ellipsoid wird von Seite zu Seite schmal.</translation>
    </message>
    <message>
        <source>Move it away from you and down, to about $(0, -60, -90)$ mm. In the view from the top, away is up on the screen, and Page Up moves the stylus down.</source>
        <translation>Führen Sie ihn von sich weg und nach unten, etwa nach $(0, -60, -90)$ mm. In der Ansicht von oben geht es auf dem Bildschirm aufwärts von Ihnen weg, und Bild auf führt nach unten.</translation>
    </message>
    <message>
        <source>All six joints</source>
        <translation>Alle sechs Gelenke</translation>
    </message>
    <message>
        <source>With the wrist the Jacobian is a 6x6 matrix, and its determinant has one more factor:

$$\det J = \pm \det J_p \cdot \sin\theta_5$$</source>
        <translation>Mit dem Handgelenk ist die Jacobi-Matrix eine 6x6-Matrix, und ihre Determinante hat einen Faktor mehr:

$$\det J = \pm \det J_p \cdot \sin\theta_5$$</translation>
    </message>
    <message>
        <source>Each factor can be zero: $\cos\theta_3$, the bracket, $\sin\theta_5$.</source>
        <translation>Jeder Faktor kann null sein: $\cos\theta_3$, die Klammer, $\sin\theta_5$.</translation>
    </message>
    <message>
        <source>How many kinds of singularities does this arm have?</source>
        <translation>Wie viele Arten von Singularitäten hat dieser Arm?</translation>
    </message>
    <message>
        <source>Singularity of the wrist forgotten</source>
        <translation>Singularität des Handgelenks vergessen</translation>
    </message>
    <message>
        <source>At θ₅ = 0, what can the stylus not do?</source>
        <translation>Was kann der Stift bei θ₅ = 0 nicht?</translation>
    </message>
    <message>
        <source>move its tip outwards</source>
        <translation>die Spitze nach außen bewegen</translation>
    </message>
    <message>
        <source>rotate about one of the axes</source>
        <translation>sich um eine der Achsen drehen</translation>
    </message>
    <message>
        <source>move at all</source>
        <translation>sich überhaupt bewegen</translation>
    </message>
    <message>
        <source>Singularity of the wrist taken for that of the elbow</source>
        <translation>Singularität des Handgelenks für die des Ellbogens gehalten</translation>
    </message>
    <message>
        <source>Statics and force ellipsoids</source>
        <translation>Statik und Kraftellipsoide</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Which joint torques produce a force, and where the arm is strong.</source>
        <translation>Welche Drehmomente eine Kraft erzeugen und wo der Arm stark ist.</translation>
    </message>
    <message>
        <source>A force at the tip</source>
        <translation>Eine Kraft an der Spitze</translation>
    </message>
    <message>
        <source>Press Start (F5): a spring pulls the stylus to the middle. From there, pull it to the right until the arm pulls
back with 0.4 N, and hold it for one second. The orange arrow is the force; the gauge shows its magnitude.</source>
        <translation>Drücken Sie Start (F5): Eine Feder zieht den Stift nun zur Mitte. Beginnen Sie dort und ziehen Sie ihn nach rechts, bis der Arm eine Sekunde lang mit 0,4 N zurückzieht.
Der orange Pfeil ist die Kraft; die Kraftanzeige zeigt ihren Betrag.</translation>
    </message>
    <message>
        <source>Let go of the stylus: the spring brings it to the middle. Then pull it 2 mm to the right and hold it there.</source>
        <translation>Lassen Sie den Stift los: Die Feder bringt ihn in die Mitte. Ziehen Sie ihn dann 2 mm nach rechts und halten Sie ihn dort.</translation>
    </message>
    <message>
        <source>Which motor carries it?</source>
        <translation>Welcher Motor trägt sie?</translation>
    </message>
    <message>
        <source>The torques follow from the force through the same Jacobian, transposed:

$$\tau = J_p^T f$$

A sideways force is carried by the turret alone. A force up or down requires no torque from the turret. Pull the
stylus **up** until the force is above 0.4 N, while the torque of the turret stays within 15 N mm of zero. Hold it
for one second.</source>
        <translation>Die Drehmomente folgen aus der Kraft durch dieselbe Jacobi-Matrix, transponiert:

$$\tau = J_p^T f$$

Eine Kraft zur Seite trägt allein der Drehturm. Eine Kraft nach oben oder unten braucht kein Drehmoment des Drehturms.
Ziehen Sie den Stift **nach oben**, bis die Kraft über 0,4 N liegt, während das Drehmoment des Drehturms höchstens 15 N mm von null abweicht. Halten Sie ihn eine Sekunde lang.</translation>
    </message>
    <message>
        <source>From the middle, move 2 mm straight up.</source>
        <translation>Gehen Sie von der Mitte 2 mm gerade nach oben.</translation>
    </message>
    <message>
        <source>Lever arm times force</source>
        <translation>Hebelarm mal Kraft</translation>
    </message>
    <message>
        <source>For a sideways force $f_x$ the torque of the turret is the lever arm times the force:

$$\tau_1 = r \cdot f_x$$

where $r$ is the distance of the tip from axis 1. In the middle of the workspace, $r = 176$ mm.

Calculate the torque for $f_x = 0.5$ N there. Then pull to the right until the torque of the turret is 70 N mm or
more, and hold it for one second.</source>
        <translation>Bei einer Kraft $f_x$ zur Seite ist das Drehmoment des Drehturms Hebelarm mal Kraft:

$$\tau_1 = r \cdot f_x$$

mit $r$ als Abstand der Spitze von Achse 1. In der Mitte des Arbeitsraums ist $r = 176$ mm.

Berechnen Sie das Drehmoment für $f_x = 0.5$ N dort. Ziehen Sie dann nach rechts, bis das Drehmoment des Drehturms 70 N mm oder mehr beträgt, und halten Sie es eine Sekunde lang.</translation>
    </message>
    <message>
        <source>$176 \cdot 0.5$.</source>
        <translation>$176 \cdot 0.5$.</translation>
    </message>
    <message>
        <source>What is the torque, in N mm?</source>
        <translation>Wie groß ist das Drehmoment, in N mm?</translation>
    </message>
    <message>
        <source>Metres in place of millimetres</source>
        <translation>Meter statt Millimeter</translation>
    </message>
    <message>
        <source>Pull to the right: the spring pulls to the left, so its torque is negative.</source>
        <translation>Ziehen Sie nach rechts: Die Feder zieht nach links, daher ist ihr Drehmoment negativ.</translation>
    </message>
    <message>
        <source>Two ellipsoids</source>
        <translation>Zwei Ellipsoide</translation>
    </message>
    <message>
        <source>All joint torques of magnitude 1 together give an ellipsoid of forces (orange), as all joint rates of magnitude 1
give one of velocities (blue). Both have the same axes; the semi-axes of one are the reciprocals of those of the
other. Power in equals power out: $\tau^T \omega = f^T v$.

Stretch the arm to less than 20° from straight, and look at both.</source>
        <translation>Alle Drehmomente vom Betrag 1 zusammen ergeben ein Ellipsoid der Kräfte (orange), wie alle Drehgeschwindigkeiten vom Betrag 1 eines der Geschwindigkeiten (blau). Beide haben dieselben Achsen;
die Halbachsen des einen sind die Kehrwerte derer des anderen. Die hineingesteckte Leistung ist gleich der abgegebenen: $\tau^T \omega = f^T v$.

Strecken Sie den Arm, bis weniger als 20° bis zur Streckung fehlen, und sehen Sie sich beide an.</translation>
    </message>
    <message>
        <source>Where the motion ellipsoid is thin, the force ellipsoid is …</source>
        <translation>Wo das Bewegungsellipsoid dünn ist, ist das Kraftellipsoid …</translation>
    </message>
    <message>
        <source>thin as well</source>
        <translation>auch dünn</translation>
    </message>
    <message>
        <source>long</source>
        <translation>lang</translation>
    </message>
    <message>
        <source>round</source>
        <translation>rund</translation>
    </message>
    <message>
        <source>Force ellipsoid thought to have the shape of that of motion</source>
        <translation>Kraftellipsoid für so geformt gehalten wie das der Bewegung</translation>
    </message>
    <message>
        <source>Stiffness and damping</source>
        <translation>Steifigkeit und Dämpfung</translation>
    </message>
    <message>
        <source>Appendix B of the thesis: a spring, a damper and a mass in the hand.</source>
        <translation>Anhang B der Thesis: eine Feder, ein Dämpfer und eine Masse in der Hand.</translation>
    </message>
    <message>
        <source>Hooke's law</source>
        <translation>Hookesches Gesetz</translation>
    </message>
    <message>
        <source>The control law P is a spring: $F = k_p \cdot e$, where $e$ is the displacement from the tip to its target. Here
$k_p = 0.05$ N/mm.

Press Start (F5), move to the middle, and pull away from it until the force is between 0.35 and 0.45 N. Hold it
for a second.</source>
        <translation>Das Regelgesetz P ist eine Feder: $F = k_p \cdot e$, wobei $e$ der Weg von der Spitze zu ihrem Ziel ist. Hier ist $k_p = 0.05$ N/mm.

Drücken Sie Start (F5), gehen Sie zur Mitte und ziehen Sie weg, bis die Kraft zwischen 0,35 und 0,45 N liegt. Halten Sie sie eine Sekunde lang.</translation>
    </message>
    <message>
        <source>0.4 N at 0.05 N/mm is 8 mm.</source>
        <translation>0,4 N bei 0,05 N/mm sind 8 mm.</translation>
    </message>
    <message>
        <source>How far is that?</source>
        <translation>Wie weit ist das?</translation>
    </message>
    <message>
        <source>Turn on **Keep holding** (F6), so that the hand stays where you release the mouse, and pull the stylus away from
the middle. Read the force from the gauge, and calculate from it how far the tip is from its target.</source>
        <translation>Schalten Sie **Festhalten** (F6) ein, damit die Hand bleibt, wo Sie die Maus loslassen, und ziehen Sie den Stift von der
Mitte weg. Lesen Sie die Kraft an der Anzeige ab, und berechnen Sie daraus, wie weit die Spitze von ihrem Ziel entfernt ist.</translation>
    </message>
    <message>
        <source>$e = F / k_p$: 0.5 N is 10 mm.</source>
        <translation>$e = F / k_p$: 0,5 N sind 10 mm.</translation>
    </message>
    <message>
        <source>How far is the tip from the target now, in mm?</source>
        <translation>Wie weit ist die Spitze jetzt vom Ziel entfernt, in mm?</translation>
    </message>
    <message>
        <source>Make it stiffer</source>
        <translation>Steifer machen</translation>
    </message>
    <message>
        <source>Set the stiffness to 0.1 N/mm in the panel *Feel* (type it, or use the slider), and pull again until the force is above 0.5 N. The same displacement now gives twice the force.</source>
        <translation>Stellen Sie im Bereich *Fühlen* die Steifigkeit auf 0,1 N/mm (durch Eingabe oder mit dem Schieberegler) und ziehen Sie noch einmal, bis die Kraft über 0,5 N liegt. Derselbe Weg ergibt nun die doppelte Kraft.</translation>
    </message>
    <message>
        <source>*Link x, y and z* moves all three sliders at once.</source>
        <translation>*x, y, z koppeln* bewegt alle drei Schieberegler zugleich.</translation>
    </message>
    <message>
        <source>Mass on a spring</source>
        <translation>Masse an einer Feder</translation>
    </message>
    <message>
        <source>On this spring, a mass $m$ with the damping $b$ has the natural frequency $\omega_n$, and the damping ratio
$\zeta$ determines how fast an oscillation decays (thesis appendix B; $k_d$ is the damping of the control law):

$$\omega_n = \sqrt{\frac{k_p}{m}}$$

$$\zeta = \frac{b + k_d}{2 \sqrt{k_p m}}$$

Take $m = 0.1$ kg, $b = 4$ N s/m, $k_d = 0$ and $k_p = 0.1$ N/mm, that is 100 N/m. The panel *Step response* shows
the response.</source>
        <translation>An dieser Feder hat eine Masse $m$ mit der Dämpfung $b$ die Eigenfrequenz $\omega_n$, und der Dämpfungsgrad $\zeta$ bestimmt, wie schnell eine Schwingung abklingt (Thesis, Anhang B; $k_d$ ist die Dämpfung des Regelgesetzes):

$$\omega_n = \sqrt{\frac{k_p}{m}}$$

$$\zeta = \frac{b + k_d}{2 \sqrt{k_p m}}$$

Nehmen Sie $m = 0.1$ kg, $b = 4$ N s/m, $k_d = 0$ und $k_p = 0.1$ N/mm, das sind 100 N/m. Der Bereich *Sprungantwort* zeigt die Antwort.</translation>
    </message>
    <message>
        <source>$\sqrt{100 / 0.1} = 31.6$, and $4 / (2 \cdot \sqrt{10}) = 0.63$.</source>
        <translation>$\sqrt{100 / 0.1} = 31.6$, und $4 / (2 \cdot \sqrt{10}) = 0.63$.</translation>
    </message>
    <message>
        <source>What is ωₙ, in rad/s?</source>
        <translation>Wie groß ist ωₙ, in rad/s?</translation>
    </message>
    <message>
        <source>Square root forgotten</source>
        <translation>Wurzel vergessen</translation>
    </message>
    <message>
        <source>N/mm not converted to N/m</source>
        <translation>N/mm nicht in N/m umgerechnet</translation>
    </message>
    <message>
        <source>What is ζ?</source>
        <translation>Wie groß ist ζ?</translation>
    </message>
    <message>
        <source>Factor 2 forgotten</source>
        <translation>Faktor 2 vergessen</translation>
    </message>
    <message>
        <source>Critically damped</source>
        <translation>Kritisch gedämpft</translation>
    </message>
    <message>
        <source>At $\zeta = 1$ the mass returns as fast as it can without oscillating. Solve $\zeta = 1$ for $k_d$, with the
numbers of the previous step, and set $k_p = 0.1$ N/mm and your $k_d$ in N s/mm (1 N s/m is 0.001 N s/mm). The
control law must be PD.</source>
        <translation>Bei $\zeta = 1$ kehrt die Masse so schnell zurück, wie es ohne Schwingung möglich ist. Lösen Sie $\zeta = 1$ nach $k_d$ auf, mit den Zahlen des vorigen Schritts,
und stellen Sie ein: $k_p = 0.1$ N/mm und Ihr $k_d$ in N s/mm (1 N s/m ist 0,001 N s/mm). Das Regelgesetz muss PD sein.</translation>
    </message>
    <message>
        <source>$k_d = 2 \sqrt{k_p m} - b = 6.32 - 4 = 2.32$ N s/m.</source>
        <translation>$k_d = 2 \sqrt{k_p m} - b = 6.32 - 4 = 2.32$ N s/m.</translation>
    </message>
    <message>
        <source>Read it from a figure</source>
        <translation>Aus einer Abbildung ablesen</translation>
    </message>
    <message>
        <source>Below $\zeta = 1$ the step response overshoots, by the fraction

$$\exp\left(\frac{-\pi \zeta}{\sqrt{1 - \zeta^2}}\right)$$

Figure B.5 of the thesis shows an overshoot of 38 %. Find its $\zeta$: try values, or move the sliders of the
panel *Step response*.</source>
        <translation>Unter $\zeta = 1$ schwingt die Sprungantwort über, und zwar um den Anteil

$$\exp\left(\frac{-\pi \zeta}{\sqrt{1 - \zeta^2}}\right)$$

Abbildung B.5 der Thesis zeigt 38 % Überschwingen. Finden Sie das zugehörige $\zeta$: Probieren Sie Werte aus, oder bewegen Sie die Schieberegler im Bereich *Sprungantwort*.</translation>
    </message>
    <message>
        <source>With $\zeta = 0.3$ it is 37 %.</source>
        <translation>Mit $\zeta = 0.3$ sind es 37 %.</translation>
    </message>
    <message>
        <source>At which ζ is the overshoot 38 %?</source>
        <translation>Bei welchem ζ beträgt das Überschwingen 38 %?</translation>
    </message>
    <message>
        <source>Sampled walls, and why they buzz</source>
        <translation>Abgetastete Wände und warum sie brummen</translation>
    </message>
    <message>
        <source>A spring that a computer renders gives back a little more energy than it received.</source>
        <translation>Eine Feder, die ein Rechner fühlbar macht, gibt etwas mehr Energie zurück, als sie bekommen hat.</translation>
    </message>
    <message>
        <source>A spring gives back</source>
        <translation>Eine Feder gibt zurück</translation>
    </message>
    <message>
        <source>Press Start (F5). Push the stylus into the ball, more than 6 mm deep, and let it come out again. The spring stores
the energy that you put in and gives it back: the energy rises, and falls to about 0. Let it rise and fall twice.</source>
        <translation>Drücken Sie Start (F5). Schieben Sie den Stift mehr als 6 mm tief in die Kugel und lassen Sie ihn wieder herauskommen. Die Feder speichert die Energie, die Sie hineinstecken, und gibt sie zurück: Die Energie
steigt und fällt auf etwa 0. Lassen Sie sie zweimal steigen und fallen.</translation>
    </message>
    <message>
        <source>The ball's surface is 50 mm from the middle. Move in to about 40 mm and back out to the surface, twice. The plot *Energy* shows the balance.</source>
        <translation>Die Oberfläche der Kugel ist 50 mm von der Mitte entfernt. Gehen Sie zweimal hinein bis etwa 40 mm und heraus bis zur Oberfläche. Das Diagramm *Energie* zeigt die Bilanz.</translation>
    </message>
    <message>
        <source>The energy leak of a tick</source>
        <translation>Das Energieleck eines Takts</translation>
    </message>
    <message>
        <source>Between two ticks the force is held constant while the hand moves on: on the way in it is too small, on the way
out too large. In each tick in which the hand moves by $dx$, the wall generates the energy $K \cdot dx^2 / 2$, as
a damper with the wrong sign would:

$$b_{leak} = \frac{K T}{2}$$

A hand and an arm with more damping than that dissipate it. A wall that leaks more is **active**: it buzzes.</source>
        <translation>Zwischen zwei Takten bleibt die Kraft gleich, während sich die Hand weiterbewegt: Auf dem Weg hinein ist sie zu klein, auf dem Weg heraus zu groß. In jedem Takt, in dem sich die Hand um $dx$ bewegt, erzeugt die Wand die Energie $K \cdot dx^2 / 2$,
wie es ein Dämpfer mit falschem Vorzeichen täte:

$$b_{leak} = \frac{K T}{2}$$

Eine Hand und ein Arm mit mehr Dämpfung nehmen sie auf. Eine Wand, die mehr abgibt, ist **aktiv**: Sie brummt.</translation>
    </message>
    <message>
        <source>12 N/mm are 12000 N/m, and a tick is 0.001 s.</source>
        <translation>12 N/mm sind 12000 N/m, und ein Takt dauert 0,001 s.</translation>
    </message>
    <message>
        <source>How large is the leak of a wall of 12 N/mm at 1000 ticks per second, in N s/m?</source>
        <translation>Wie groß ist das Leck einer Wand mit 12 N/mm bei 1000 Takten je Sekunde, in N s/m?</translation>
    </message>
    <message>
        <source>And at 2000 ticks per second?</source>
        <translation>Und bei 2000 Takten je Sekunde?</translation>
    </message>
    <message>
        <source>Leak thought not to depend on the tick</source>
        <translation>Leck für unabhängig vom Tick gehalten</translation>
    </message>
    <message>
        <source>An active wall</source>
        <translation>Eine aktive Wand</translation>
    </message>
    <message>
        <source>This ball has a stiffness of 12 N/mm. Press Start and move through its surface, in and out, and along it. Watch the energy: below 0, the ball has given out more than it received. Your hand has received the difference.</source>
        <translation>Diese Kugel hat eine Steifigkeit von 12 N/mm. Drücken Sie Start und bewegen Sie sich durch ihre Oberfläche, hinein und heraus, und an ihr entlang. Beobachten Sie die Energie: Unter 0 hat die Kugel mehr abgegeben, als sie bekommen hat. Die Differenz hat Ihre Hand bekommen.</translation>
    </message>
    <message>
        <source>The surface is 40 mm from the middle. Move through it quickly, back and forth.</source>
        <translation>Die Oberfläche ist 40 mm von der Mitte entfernt. Gehen Sie schnell hindurch, hin und her.</translation>
    </message>
    <message>
        <source>Make it passive</source>
        <translation>Passiv machen</translation>
    </message>
    <message>
        <source>A **passivity controller** monitors this energy and adds damping as soon as the wall would give out more than it
received. Set *Passivity* to *Control* (*Velocity and energy* in the panel *Feel*), press Start, and move through the
surface as before, until the controller adds more than 0.05 N.</source>
        <translation>Ein **Passivitätsregler** überwacht diese Energie und fügt Dämpfung hinzu, sobald die Wand mehr abgeben würde, als sie bekommen hat. Stellen Sie *Passivität* auf *Regeln* (*Geschwindigkeit und Energie* im Bereich *Fühlen*),
drücken Sie Start und gehen Sie wie zuvor durch die Oberfläche, bis der Regler mehr als 0,05 N hinzufügt.</translation>
    </message>
    <message>
        <source>The setting is in the section *Velocity and energy* of the panel *Feel*.</source>
        <translation>Die Einstellung steht im Abschnitt *Geschwindigkeit und Energie* des Bereichs *Fühlen*.</translation>
    </message>
    <message>
        <source>How stiff may a wall be?</source>
        <translation>Wie steif darf eine Wand sein?</translation>
    </message>
    <message>
        <source>Solve $b_{leak} = K T / 2$ for the stiffness: with a total damping of $b$, the wall leaks less than the damping
dissipates as long as

$$K &lt; \frac{2 b}{T}$$</source>
        <translation>Lösen Sie $b_{leak} = K T / 2$ nach der Steifigkeit auf: Mit einer Dämpfung von insgesamt $b$ gibt die Wand weniger ab, als die Dämpfung aufnimmt, solange

$$K &lt; \frac{2 b}{T}$$</translation>
    </message>
    <message>
        <source>$2 \cdot 4 / 0.001$ N/m.</source>
        <translation>$2 \cdot 4 / 0.001$ N/m.</translation>
    </message>
    <message>
        <source>The damping is 4 N s/m and a tick takes 1 ms. How stiff may the wall be, in N/mm?</source>
        <translation>Die Dämpfung beträgt 4 N s/m, ein Takt dauert 1 ms. Wie steif darf die Wand sein, in N/mm?</translation>
    </message>
    <message>
        <source>N/m not converted to N/mm</source>
        <translation>N/m nicht in N/mm umgerechnet</translation>
    </message>
    <message>
        <source>Your wall buzzes. What does NOT help?</source>
        <translation>Ihre Wand brummt. Was hilft NICHT?</translation>
    </message>
    <message>
        <source>a faster servo</source>
        <translation>ein schnellerer Servo</translation>
    </message>
    <message>
        <source>a softer wall</source>
        <translation>eine weichere Wand</translation>
    </message>
    <message>
        <source>more damping</source>
        <translation>mehr Dämpfung</translation>
    </message>
    <message>
        <source>a stronger motor</source>
        <translation>ein stärkerer Motor</translation>
    </message>
    <message>
        <source>Constraints as robots</source>
        <translation>Bindungen als Roboter</translation>
    </message>
    <message>
        <source>Virtual robots</source>
        <translation>Virtuelle Roboter</translation>
    </message>
    <message>
        <source>A line is a robot with one joint, a plane a robot with two: which motions they leave free, and which they constrain.</source>
        <translation>Eine Gerade ist ein Roboter mit einem Gelenk, eine Ebene einer mit zweien: welche Bewegungen sie frei lassen und welche sie festhalten.</translation>
    </message>
    <message>
        <source>A line: one prismatic joint</source>
        <translation>Eine Gerade: ein Schubgelenk</translation>
    </message>
    <message>
        <source>Think of the wire as the path of the end effector of a robot with one prismatic joint. Along it you are free;
across it you are held by $F = k_p (Q - P)$, where $Q$ is the point of the wire nearest to your tip, $P$.

Press Start (F5) and slide along the wire until your height has changed by 50 mm, while you stay within 3 mm of it.</source>
        <translation>Denken Sie sich den Draht als Bahn des Endeffektors eines Roboters mit einem Schubgelenk. Entlang des Drahts sind Sie frei, quer dazu werden Sie gehalten, durch $F = k_p (Q - P)$, wobei $Q$ der Punkt des Drahts ist, der Ihrer Spitze $P$ am nächsten liegt.

Drücken Sie Start (F5) und gleiten Sie am Draht entlang, bis sich Ihre Höhe um 50 mm geändert hat, und bleiben Sie dabei höchstens 3 mm von ihm entfernt.</translation>
    </message>
    <message>
        <source>The wire runs along $(-1, -2, 1)$. Move in the direction in which it does not resist.</source>
        <translation>Der Draht verläuft entlang $(-1, -2, 1)$. Bewegen Sie sich in der Richtung, in der er keinen Widerstand leistet.</translation>
    </message>
    <message>
        <source>A plane: two prismatic joints</source>
        <translation>Eine Ebene: zwei Schubgelenke</translation>
    </message>
    <message>
        <source>Two prismatic joints make a plane: two directions are free, and one is held, along the normal $(1, 1, 1)$.

Press Start and slide on the plane: over 40 mm in $x$ and over 40 mm in $y$, within 3 mm of it.</source>
        <translation>Zwei Schubgelenke bilden eine Ebene. Zwei Richtungen sind frei, und eine wird gehalten, entlang der Normalen $(1, 1, 1)$.

Drücken Sie Start und gleiten Sie auf der Ebene: über 40 mm in $x$ und über 40 mm in $y$, höchstens 3 mm von ihr entfernt.</translation>
    </message>
    <message>
        <source>From the middle, move along $(1, -1, 0)$: to the right and down.</source>
        <translation>Gehen Sie von der Mitte entlang $(1, -1, 0)$: nach rechts und nach unten.</translation>
    </message>
    <message>
        <source>A circle: one revolute joint</source>
        <translation>Ein Kreis: ein Drehgelenk</translation>
    </message>
    <message>
        <source>One revolute joint makes a circle. Follow its rim and visit the four points that the check below names, to within 8 mm.</source>
        <translation>Ein Drehgelenk ergibt einen Kreis. Folgen Sie seinem Rand und besuchen Sie die vier Punkte, die unten genannt werden, auf 8 mm genau.</translation>
    </message>
    <message>
        <source>The points lie on the rim, 40 mm from $(10, 20, 30)$, in its tilted plane. Let the rim lead you.</source>
        <translation>Die Punkte liegen auf dem Rand, 40 mm von $(10, 20, 30)$ entfernt, in seiner geneigten Ebene. Lassen Sie sich vom Rand führen.</translation>
    </message>
    <message>
        <source>A sphere: two revolute joints</source>
        <translation>Eine Kugel: zwei Drehgelenke</translation>
    </message>
    <message>
        <source>Two revolute joints make a sphere where their axes intersect at right angles and the link to the tip stands square to axis 2; a slanting link leaves out a cap at each end of axis 1. Press Start and slide from the front of the ball, $(0, 0, 50)$, over to its top, $(0, 50, 0)$ mm, and stay within 4 mm of the surface.</source>
        <translation>Zwei Drehgelenke ergeben eine Kugel, wenn sich ihre Achsen im rechten Winkel schneiden und das Glied zur Spitze senkrecht auf Achse 2 steht; steht es schräg, so fehlt an jedem Ende von Achse 1 eine Kappe. Drücken Sie Start und gleiten Sie von der Vorderseite der Kugel, $(0, 0, 50)$, hinüber zu ihrem obersten Punkt, $(0, 50, 0)$ mm, und bleiben Sie höchstens 4 mm von der Oberfläche entfernt.</translation>
    </message>
    <message>
        <source>Move up and away from you at the same time: the surface leads you.</source>
        <translation>Gehen Sie zugleich nach oben und von sich weg: Die Oberfläche führt Sie.</translation>
    </message>
    <message>
        <source>Count the degrees of freedom</source>
        <translation>Freiheitsgrade zählen</translation>
    </message>
    <message>
        <source>The tip has three degrees of freedom. A robot with $n$ independent joints leaves it $n$ of them; the other $3 - n$ are constrained. In a singular configuration, joints that move the tip in the same direction count once.</source>
        <translation>Die Spitze hat drei Freiheitsgrade. Ein Roboter mit $n$ unabhängigen Gelenken lässt ihr $n$ davon; die übrigen $3 - n$ sind gebunden. In einer singulären Stellung zählen Gelenke, die die Spitze in derselben Richtung bewegen, nur einmal.</translation>
    </message>
    <message>
        <source>A cylinder is a prismatic joint along an axis and a revolute joint about it.</source>
        <translation>Ein Zylinder ist ein Schubgelenk entlang einer Achse und ein Drehgelenk um sie.</translation>
    </message>
    <message>
        <source>How many joints does a robot need for the surface of a cylinder?</source>
        <translation>Wie viele Gelenke braucht ein Roboter für die Oberfläche eines Zylinders?</translation>
    </message>
    <message>
        <source>A robot with three perpendicular prismatic joints holds the tip …</source>
        <translation>Ein Roboter mit drei zueinander senkrechten Schubgelenken hält die Spitze …</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>gar nicht</translation>
    </message>
    <message>
        <source>to a plane</source>
        <translation>auf einer Ebene</translation>
    </message>
    <message>
        <source>to a point</source>
        <translation>in einem Punkt</translation>
    </message>
    <message>
        <source>Joints taken for constraints</source>
        <translation>Gelenke für Bindungen gehalten</translation>
    </message>
    <message>
        <source>A robot without joints is …</source>
        <translation>Ein Roboter ohne Gelenke ist …</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>a line</source>
        <translation>eine Gerade</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>freier Raum</translation>
    </message>
    <message>
        <source>Robots that exist only in software pull the stylus to their end effector.</source>
        <translation>Roboter, die es nur in Software gibt, ziehen den Stift zu ihrem Endeffektor.</translation>
    </message>
    <message>
        <source>One joint</source>
        <translation>Ein Gelenk</translation>
    </message>
    <message>
        <source>The purple robot has one joint, in the middle, and a link of 50 mm. Its end effector pulls your stylus; the joint
turns towards your stylus.

Press Start (F5) and lead the robot round until its joint is between 60° and 80°, and hold it there for one
second.</source>
        <translation>Der violette Roboter hat ein Gelenk in der Mitte und ein Glied von 50 mm. Sein Endeffektor zieht Ihren Stift an; das Gelenk dreht sich zu Ihrem Stift hin.

Drücken Sie Start (F5) und führen Sie den Roboter herum, bis sein Gelenk eine Sekunde lang zwischen 60° und 80° steht.</translation>
    </message>
    <message>
        <source>At 0° its end effector is on the right, at 70° nearly at the top: about $(17, 47, 0)$ mm. The panel *Robot* shows the angle.</source>
        <translation>Bei 0° ist sein Endeffektor rechts, bei 70° fast oben: etwa $(17, 47, 0)$ mm. Der Bereich *Roboter* zeigt den Winkel.</translation>
    </message>
    <message>
        <source>It also follows the orientation</source>
        <translation>Er folgt auch der Orientierung</translation>
    </message>
    <message>
        <source>The joint minimises the energy of two springs, one for position and one for orientation:

$$V = \frac{1}{2} k_p |e_p|^2 + \frac{1}{2} K_\theta e_\theta^2$$

Turn the stylus, and the robot turns with it. The moment $K_\theta e_\theta$ of the second spring is shown but
never sent: the arm has no motors in its wrist.

Move to $(50, 0, 0)$: the stylus still points up, and the two springs pull the robot in different directions. Turn
the stylus to the right until the moment is below 40 N mm, and hold it for half a second.</source>
        <translation>Das Gelenk macht die Energie zweier Federn möglichst klein, einer für die Position und einer für die Orientierung:

$$V = \frac{1}{2} k_p |e_p|^2 + \frac{1}{2} K_\theta e_\theta^2$$

Drehen Sie den Stift, und der Roboter dreht sich mit. Das Moment $K_\theta e_\theta$ der zweiten Feder wird angezeigt, aber nie gesendet: Der Arm hat keine Motoren im Handgelenk.

Gehen Sie nach $(50, 0, 0)$: Der Stift zeigt noch nach oben, und die beiden Federn ziehen den Roboter in verschiedene Richtungen. Drehen Sie den Stift nach rechts, bis das Moment eine halbe Sekunde lang unter 40 N mm liegt.</translation>
    </message>
    <message>
        <source>Ctrl with the arrow keys turns the stylus. It should point along the robot's link.</source>
        <translation>Strg mit den Pfeiltasten dreht den Stift. Er soll entlang dem Glied des Roboters zeigen.</translation>
    </message>
    <message>
        <source>What is left to feel</source>
        <translation>Was zu fühlen bleibt</translation>
    </message>
    <message>
        <source>Once the joints have settled, no joint can reduce the energy any further: $J_v^T K e = 0$. The force $F = K e$ is
therefore perpendicular to every direction in which the end effector can move.

Press Start and pull away from the sphere, 40 mm in radius, until the commanded force is above 1 N, and hold it
for half a second.</source>
        <translation>Sind die Gelenke zur Ruhe gekommen, so kann kein Gelenk die Energie weiter verringern: $J_v^T K e = 0$. Die Kraft $F = K e$ steht deshalb senkrecht auf jeder Richtung, in die sich der Endeffektor bewegen kann.

Drücken Sie Start und ziehen Sie von der Kugel mit 40 mm Radius weg, bis die verlangte Kraft eine halbe Sekunde lang über 1 N liegt.</translation>
    </message>
    <message>
        <source>Pull straight away from the middle, by 3 mm or more.</source>
        <translation>Ziehen Sie gerade von der Mitte weg, um 3 mm oder mehr.</translation>
    </message>
    <message>
        <source>How much of the force do the robot's joints carry?</source>
        <translation>Wie viel von der Kraft tragen die Gelenke des Roboters?</translation>
    </message>
    <message>
        <source>all of it</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>half of it</source>
        <translation>die Hälfte</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Force thought to be carried by the joints</source>
        <translation>Kraft den Gelenken zugeschrieben</translation>
    </message>
    <message>
        <source>A joint at its limit</source>
        <translation>Ein Gelenk an seiner Grenze</translation>
    </message>
    <message>
        <source>This robot is a SCARA. Within its reach nothing holds you, because its joints follow you. Its prismatic joint moves 25 mm up and down. Press Start, lead it up to that limit, and keep pushing until you feel 0.3 N for half a second.</source>
        <translation>Dieser Roboter ist ein SCARA. In seiner Reichweite hält Sie nichts, denn seine Gelenke folgen Ihnen. Sein Schubgelenk fährt 25 mm nach oben und nach unten. Drücken Sie Start, führen Sie es nach oben bis zu dieser Grenze und drücken Sie weiter, bis Sie eine halbe Sekunde lang 0,3 N fühlen.</translation>
    </message>
    <message>
        <source>In the view from the top, Page Down moves up. The prismatic joint is joint 3.</source>
        <translation>In der Ansicht von oben geht es mit Bild ab nach oben. Das Schubgelenk ist Gelenk 3.</translation>
    </message>
    <message>
        <source>Six joints</source>
        <translation>Sechs Gelenke</translation>
    </message>
    <message>
        <source>Six independent joints follow every pose: nothing is constrained. Beyond its reach the robot is stretched, in a
singular configuration, and pulls you along the one direction in which it cannot move.

The ball, the wire, the wall: each was a robot, and each force the part of $K e$ that its joints could not
relieve.</source>
        <translation>Sechs unabhängige Gelenke folgen jeder Lage: Nichts ist gebunden. Außerhalb seiner Reichweite ist der Roboter gestreckt, in einer singulären Stellung, und zieht Sie in der einen Richtung, in die er sich nicht bewegen kann.

Die Kugel, der Draht, die Wand: Jedes war ein Roboter, und jede Kraft war der Teil von $K e$, den seine Gelenke nicht abbauen konnten.</translation>
    </message>
    <message>
        <source>Try it: press Start, and pull away from the robot.</source>
        <translation>Probieren Sie es aus: Drücken Sie Start und ziehen Sie vom Roboter weg.</translation>
    </message>
    <message>
        <source>Within its reach, what force does a robot with six joints exert on you?</source>
        <translation>Welche Kraft übt ein Roboter mit sechs Gelenken in seiner Reichweite auf Sie aus?</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>that of a spring to its base</source>
        <translation>die einer Feder zu seiner Basis</translation>
    </message>
    <message>
        <source>its weight</source>
        <translation>sein Gewicht</translation>
    </message>
    <message>
        <source>When it is stretched, in which direction does it hold you?</source>
        <translation>In welcher Richtung hält er Sie, wenn er gestreckt ist?</translation>
    </message>
    <message>
        <source>along the arm</source>
        <translation>entlang dem Arm</translation>
    </message>
    <message>
        <source>across the arm</source>
        <translation>quer zum Arm</translation>
    </message>
    <message>
        <source>in all directions</source>
        <translation>in allen Richtungen</translation>
    </message>
    <message>
        <source>Singular direction taken for one of motion</source>
        <translation>Singuläre Richtung für eine der Bewegung gehalten</translation>
    </message>
    <message>
        <source>Two arms, two workspaces</source>
        <translation>Zwei Arme, zwei Arbeitsräume</translation>
    </message>
    <message>
        <source>Comparing arms</source>
        <translation>Arme im Vergleich</translation>
    </message>
    <message>
        <source>Where a UR5e and a SCARA reach, and where they lose a direction.</source>
        <translation>Wie weit ein UR5e und ein SCARA reichen, und wo sie eine Richtung verlieren.</translation>
    </message>
    <message>
        <source>Stretch the UR5e</source>
        <translation>Den UR5e strecken</translation>
    </message>
    <message>
        <source>The **UR5e** has three parallel axes: shoulder, elbow and first wrist joint. With six joints for six numbers of a
pose, it loses a direction only in a singularity. The elbow's is the limit of its reach: both links in line.

Pull the tool away from the base until the smallest singular value of $J_v$ is below 150 mm per radian.</source>
        <translation>Der **UR5e** hat drei parallele Achsen: Schulter, Ellbogen und erstes Handgelenk. Mit sechs Gelenken für die sechs Zahlen
einer Lage verliert er eine Richtung nur in einer Singularität. Die des Ellbogens ist die Grenze seiner Reichweite: beide Glieder in einer Linie.

Ziehen Sie das Werkzeug von der Basis weg, bis der kleinste Singulärwert von $J_v$ unter 150 mm je Radiant liegt.</translation>
    </message>
    <message>
        <source>Drag the tool outwards, away from the base, as far as it goes. The links of the arm weigh 17.7 kg and follow slowly.</source>
        <translation>Ziehen Sie das Werkzeug nach außen, von der Basis weg, so weit es geht. Die Glieder des Arms wiegen 17,7 kg und folgen langsam.</translation>
    </message>
    <message>
        <source>Stretch the SCARA</source>
        <translation>Den SCARA strecken</translation>
    </message>
    <message>
        <source>The **SCARA** moves in the plane with two joints and along $z$ with a slide. It has one singularity within its
limits: both links in line, $q_2 = 0$. Its workspace is a part of a ring, as thick as the slide is long.

Stretch it until $q_2$ is below 20°.</source>
        <translation>Der **SCARA** bewegt sich mit zwei Gelenken in der Ebene und mit einem Schubgelenk entlang $z$. Innerhalb seiner Grenzen hat er eine
Singularität: beide Glieder in einer Linie, $q_2 = 0$. Sein Arbeitsraum ist ein Teil eines Rings, so dick wie das Schubgelenk lang ist.

Strecken Sie ihn, bis $q_2$ unter 20° liegt.</translation>
    </message>
    <message>
        <source>Pull the tip away from the base. $q_2$ is in the panel *Kinematics*, under *Joints*.</source>
        <translation>Ziehen Sie die Spitze von der Basis weg. $q_2$ steht im Bereich *Kinematik* unter *Gelenke*.</translation>
    </message>
    <message>
        <source>What the SCARA cannot do</source>
        <translation>Was der SCARA nicht kann</translation>
    </message>
    <message>
        <source>Four joints cannot give all six numbers of a pose. Three of them set the position of the tip, and the fourth one
turns the tool.

Look at the *Jacobian* in the panel *Kinematics*: which rows are zero in every column?</source>
        <translation>Vier Gelenke können nicht alle sechs Zahlen einer Lage ergeben. Drei von ihnen bestimmen die Position der Spitze, und das vierte
dreht das Werkzeug.

Sehen Sie sich im Bereich *Kinematik* die *Jacobi-Matrix* an: Welche Zeilen sind in jeder Spalte null?</translation>
    </message>
    <message>
        <source>The rows of angular velocity about x and y, $\omega_x$ and $\omega_y$: the tool always points down.</source>
        <translation>Die Zeilen der Winkelgeschwindigkeit um x und y, $\omega_x$ und $\omega_y$: Das Werkzeug zeigt immer nach unten.</translation>
    </message>
    <message>
        <source>Which motion of the tool is missing?</source>
        <translation>Welche Bewegung des Werkzeugs fehlt?</translation>
    </message>
    <message>
        <source>moving along z</source>
        <translation>die entlang z</translation>
    </message>
    <message>
        <source>turning about z</source>
        <translation>das Drehen um z</translation>
    </message>
    <message>
        <source>tilting about x and y</source>
        <translation>das Kippen um x und y</translation>
    </message>
    <message>
        <source>Slide forgotten</source>
        <translation>Schubgelenk vergessen</translation>
    </message>
    <message>
        <source>Joint that turns the tool forgotten</source>
        <translation>Gelenk vergessen, das das Werkzeug dreht</translation>
    </message>
    <message>
        <source>Eight solutions, two, or none</source>
        <translation>Acht Lösungen, zwei oder keine</translation>
    </message>
    <message>
        <source>How many sets of joint values give the same pose depends on the geometry of the arm.</source>
        <translation>Wie viele Sätze von Gelenkwerten dieselbe Lage ergeben, hängt von der Geometrie des Arms ab.</translation>
    </message>
    <message>
        <source>The UR5e</source>
        <translation>Der UR5e</translation>
    </message>
    <message>
        <source>The **UR5e** can turn its shoulder in two ways, bend its wrist in two and its elbow in two, each whatever the others
do. The panel *Kinematics* lists the solutions for a pose under *Inverse solutions*.</source>
        <translation>Der **UR5e** kann seine Schulter auf zwei Arten drehen, sein Handgelenk auf zwei beugen und seinen Ellbogen auf zwei, jeweils unabhängig von den anderen. Der Bereich *Kinematik* führt die Lösungen für eine Lage unter *Inverse Lösungen* auf.</translation>
    </message>
    <message>
        <source>Count the rows. Near the edge of the workspace some of them have no real angle, and are missing.</source>
        <translation>Zählen Sie die Zeilen. Nahe am Rand des Arbeitsraums haben einige keinen reellen Winkel und fehlen.</translation>
    </message>
    <message>
        <source>The SCARA</source>
        <translation>Der SCARA</translation>
    </message>
    <message>
        <source>Slide and last joint of the **SCARA** follow from the pose without a choice. What is left are two links in a plane.</source>
        <translation>Schubgelenk und letztes Gelenk des **SCARA** folgen eindeutig aus der Lage. Übrig bleiben zwei Glieder in einer Ebene.</translation>
    </message>
    <message>
        <source>The elbow is to the left or to the right of the line from the base to the tip.</source>
        <translation>Der Ellbogen liegt links oder rechts der Linie von der Basis zur Spitze.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Most arms of six joints have no formula for their solutions: the equations lead to a polynomial of degree 16
(Raghavan and Roth 1990). A maker who wants a formula chooses the geometry for it: three axes that meet in a point,
or three that are parallel (Pieper 1968). Without it a program searches, as `underact-cli ik` does.</source>
        <translation>Die meisten Arme mit sechs Gelenken haben keine Formel für ihre Lösungen: Die Gleichungen führen auf ein Polynom vom Grad 16
(Raghavan und Roth 1990). Wer eine Formel will, wählt die Geometrie danach: drei Achsen, die sich in einem Punkt schneiden,
oder drei parallele (Pieper 1968). Ohne sie sucht ein Programm, wie `underact-cli ik` es tut.</translation>
    </message>
    <message>
        <source>The UR5e has three parallel axes; a KR 5 has a wrist whose three axes meet in a point.</source>
        <translation>Der UR5e hat drei parallele Achsen; ein KR 5 hat ein Handgelenk, dessen drei Achsen sich in einem Punkt schneiden.</translation>
    </message>
    <message>
        <source>Which change leaves the UR5e without its eight formulas?</source>
        <translation>Welche Änderung nimmt dem UR5e seine acht Formeln?</translation>
    </message>
    <message>
        <source>longer links</source>
        <translation>längere Glieder</translation>
    </message>
    <message>
        <source>tilting axis 3 by a degree</source>
        <translation>Achse 3 um ein Grad neigen</translation>
    </message>
    <message>
        <source>another tool</source>
        <translation>ein anderes Werkzeug</translation>
    </message>
    <message>
        <source>Lengths thought to decide about the formula</source>
        <translation>Längen für entscheidend für die Formel gehalten</translation>
    </message>
    <message>
        <source>Joints to spare</source>
        <translation>Gelenke übrig</translation>
    </message>
    <message>
        <source>With more joints than coordinates, the arm can move while its tip rests.</source>
        <translation>Mit mehr Gelenken als Koordinaten kann sich der Arm bewegen, während seine Spitze ruht.</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Zählen</translation>
    </message>
    <message>
        <source>Three links in a plane have three joints; the place of the tip in that plane has two coordinates. The difference is
the dimension of the **null space**: of the joint rates that do not move the tip, $J_v\,\dot q = 0$.</source>
        <translation>Drei Glieder in einer Ebene haben drei Gelenke; der Ort der Spitze in dieser Ebene hat zwei Koordinaten. Der Unterschied ist
die Dimension des **Nullraums**: der Gelenkgeschwindigkeiten, die die Spitze nicht bewegen, $J_v\,\dot q = 0$.</translation>
    </message>
    <message>
        <source>$3 - 2$, as long as the arm is not stretched.</source>
        <translation>$3 - 2$, solange der Arm nicht gestreckt ist.</translation>
    </message>
    <message>
        <source>What is the dimension of the null space?</source>
        <translation>Welche Dimension hat der Nullraum?</translation>
    </message>
    <message>
        <source>Coordinates counted in place of the difference</source>
        <translation>Koordinaten statt der Differenz gezählt</translation>
    </message>
    <message>
        <source>Joints counted in place of the difference</source>
        <translation>Gelenke statt der Differenz gezählt</translation>
    </message>
    <message>
        <source>Move the links, not the tip</source>
        <translation>Die Glieder bewegen, nicht die Spitze</translation>
    </message>
    <message>
        <source>The tip is held to a point. Turn the last link with the hand, so that joint 3 changes by 30°, and watch the others
follow: the tip stays within 10 mm of the point.</source>
        <translation>Die Spitze wird an einem Punkt gehalten. Drehen Sie das letzte Glied mit der Hand, sodass sich Gelenk 3 um 30° ändert, und sehen Sie zu, wie die
anderen folgen: Die Spitze bleibt innerhalb von 10 mm um den Punkt.</translation>
    </message>
    <message>
        <source>With the servo running, turn the stylus with Ctrl and the arrow keys.</source>
        <translation>Drehen Sie bei laufendem Servo den Stift mit Strg und den Pfeiltasten.</translation>
    </message>
    <message>
        <source>What it is good for</source>
        <translation>Wozu das gut ist</translation>
    </message>
    <message>
        <source>Arms of seven joints, as the Panda and the iiwa, use the null space to keep the elbow away from a wall, a joint
away from its limit, or the arm away from a singularity, while the tool does its work.</source>
        <translation>Arme mit sieben Gelenken wie der Panda und der iiwa nutzen den Nullraum, um den Ellbogen von einer Wand, ein Gelenk von
seiner Grenze oder den Arm von einer Singularität fernzuhalten, während das Werkzeug arbeitet.</translation>
    </message>
    <message>
        <source>The tool's pose has six numbers, the arm seven joints.</source>
        <translation>Die Lage des Werkzeugs hat sechs Zahlen, der Arm sieben Gelenke.</translation>
    </message>
    <message>
        <source>An iiwa holds its flange still. What can move?</source>
        <translation>Ein iiwa hält seinen Flansch still. Was kann sich bewegen?</translation>
    </message>
    <message>
        <source>its elbow, on a circle</source>
        <translation>sein Ellbogen, auf einem Kreis</translation>
    </message>
    <message>
        <source>its flange, along a line</source>
        <translation>sein Flansch, entlang einer Linie</translation>
    </message>
    <message>
        <source>Seventh joint forgotten</source>
        <translation>Siebtes Gelenk vergessen</translation>
    </message>
</context>
<context>
    <name>limit</name>
    <message>
        <source>Maximum force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>größte Kraft</translation>
    </message>
    <message>
        <source>Limits the force to the arm's continuous force; its direction is kept.</source>
        <translation>Begrenzt die Kraft auf die Dauerkraft des Arms; ihre Richtung bleibt erhalten.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Above 1 m/s, force in the direction of motion is reduced; from 2 m/s it is zero. Force against the motion is not limited.</source>
        <translation>Über 1 m/s wird Kraft in Bewegungsrichtung verringert; ab 2 m/s ist sie null. Kraft gegen die Bewegung wird nicht begrenzt.</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>motors</source>
        <translation>Motoren</translation>
    </message>
    <message>
        <source>Removes what no motor can render: a joint without a motor passes no torque on, and no joint moves the tip in some directions. Zero for haptic arms such as the Omni.</source>
        <translation>Nimmt weg, was kein Motor erzeugen kann: Ein Gelenk ohne Motor gibt kein Moment weiter, und in manche Richtungen bewegt kein Gelenk die Spitze. Null bei haptischen Armen wie dem Omni.</translation>
    </message>
    <message>
        <source>Workspace edge</source>
        <translation>Arbeitsraumrand</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Within 3° of a joint's stop, a force that presses towards it fades out.</source>
        <translation>Auf den letzten 3° vor dem Anschlag eines Gelenks klingt eine Kraft ab, die dorthin drückt.</translation>
    </message>
    <message>
        <source>Motor heat</source>
        <translation>Motorwärme</translation>
    </message>
    <message>
        <source>heat</source>
        <translation>Wärme</translation>
    </message>
    <message>
        <source>Between 90 % and 100 % of a motor's permissible heat, the force is reduced to its continuous force.</source>
        <translation>Zwischen 90 % und 100 % der zulässigen Wärme eines Motors wird die Kraft auf seine Dauerkraft verringert.</translation>
    </message>
    <message>
        <source>Slew rate</source>
        <translation>Änderungsrate</translation>
    </message>
    <message>
        <source>slew rate</source>
        <translation>Änderungsrate</translation>
    </message>
    <message>
        <source>The force changes by at most 1 N per millisecond.</source>
        <translation>Die Kraft ändert sich um höchstens 1 N je Millisekunde.</translation>
    </message>
    <message>
        <source>Frozen sample</source>
        <translation>Starrer Messwert</translation>
    </message>
    <message>
        <source>frozen sample</source>
        <translation>starrer Messwert</translation>
    </message>
    <message>
        <source>If the joint angles stay identical to the last bit for some time, the arm no longer measures the hand: the force fades out until they change.</source>
        <translation>Bleiben die Gelenkwinkel eine Zeit lang bis aufs letzte Bit gleich, misst der Arm die Hand nicht mehr: Die Kraft klingt ab, bis sie sich ändern.</translation>
    </message>
</context>
<context>
    <name>panel</name>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>The scene's arm: its joint angles, tip position and faults.</source>
        <translation>Der Arm der Szene: Gelenkwinkel, Lage der Spitze und Fehler.</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Measures the smallest difference of stiffness that a hand can feel, with two beams.</source>
        <translation>Misst den kleinsten Unterschied der Steifigkeit, den eine Hand fühlen kann, mit zwei Balken.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Which arms are plugged in, what each lacks, and which is in use.</source>
        <translation>Welche Arme angeschlossen sind, was jedem fehlt und welcher in Gebrauch ist.</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>How hard the constraint pulls, axis by axis.</source>
        <translation>Wie stark die Bindung zieht, Achse für Achse.</translation>
    </message>
    <message>
        <source>DH table</source>
        <translation>DH-Tabelle</translation>
    </message>
    <message>
        <source>A DH table to edit, drawn beside the arm with the same joint angles.</source>
        <translation>Eine DH-Tabelle zum Ändern, neben dem Arm mit denselben Gelenkwinkeln gezeichnet.</translation>
    </message>
    <message>
        <source>Transforms</source>
        <translation>Transformationen</translation>
    </message>
    <message>
        <source>Rotations and translations composed in both orders, side by side.</source>
        <translation>Drehungen und Verschiebungen, in beiden Reihenfolgen nebeneinander verkettet.</translation>
    </message>
    <message>
        <source>Input devices</source>
        <translation>Eingabegeräte</translation>
    </message>
    <message>
        <source>Mouse, game controllers and 3D mice: which are plugged in, and how they move the stylus.</source>
        <translation>Maus, Gamepads und 3D-Mäuse: welche angeschlossen sind und wie sie den Stift bewegen.</translation>
    </message>
    <message>
        <source>Kinematics</source>
        <translation>Kinematik</translation>
    </message>
    <message>
        <source>Joints, DH table, inverse solutions, Jacobian and singularities.</source>
        <translation>Gelenke, DH-Tabelle, inverse Lösungen, Jacobi-Matrix und Singularitäten.</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>Labor</translation>
    </message>
    <message>
        <source>Measures what each choice between speed and accuracy costs, with a slider along the best trade-offs.</source>
        <translation>Misst, was jede Wahl zwischen Tempo und Genauigkeit kostet, mit einem Schieberegler entlang der besten Kombinationen.</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Exercises in robot kinematics and forces that check what your hand does.</source>
        <translation>Übungen zu Roboterkinematik und Kräften, die prüfen, was Ihre Hand tut.</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Error and force over the last 10 s, and force against displacement along one axis.</source>
        <translation>Fehler und Kraft der letzten 10 s, und Kraft gegen Auslenkung entlang einer Achse.</translation>
    </message>
    <message>
        <source>Session plots</source>
        <translation>Sitzungsdiagramme</translation>
    </message>
    <message>
        <source>Plots of the whole session that is replayed: force, angles, energy, spectrum.</source>
        <translation>Diagramme der ganzen wiedergegebenen Sitzung: Kraft, Winkel, Energie, Spektrum.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>The virtual robot: joints, springs, rotational stiffness, solver.</source>
        <translation>Der virtuelle Roboter: Gelenke, Federn, Drehsteifigkeit, Löser.</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>The scenes that come with the program, and your own.</source>
        <translation>Die Szenen, die mit dem Programm kommen, und Ihre eigenen.</translation>
    </message>
    <message>
        <source>Second arm</source>
        <translation>Zweiter Arm</translation>
    </message>
    <message>
        <source>Another arm beside the first, with a scene of its own.</source>
        <translation>Ein weiterer Arm neben dem ersten, mit einer eigenen Szene.</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>How evenly the servo loop runs, which limits reduce the force, and which scheduling is in effect.</source>
        <translation>Wie gleichmäßig die Servoschleife läuft, welche Grenzen die Kraft verringern und welche Zeitplanung gilt.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Record, set markers, and find recorded sessions.</source>
        <translation>Aufzeichnen, Marken setzen und aufgezeichnete Sitzungen finden.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>The geometry of the constraint in numbers, and the distance to it.</source>
        <translation>Die Geometrie der Bindung in Zahlen und der Abstand zu ihr.</translation>
    </message>
    <message>
        <source>Step response</source>
        <translation>Sprungantwort</translation>
    </message>
    <message>
        <source>How the tip follows a target that jumps: rise time, settling time, overshoot, poles, and the measured arm beside the model.</source>
        <translation>Wie die Spitze einem springenden Ziel folgt: Anstiegszeit, Einschwingzeit, Überschwingen, Pole und der gemessene Arm neben dem Modell.</translation>
    </message>
</context>
<context>
    <name>problem</name>
    <message>
        <source>Open a scene first; then it can be given another arm.</source>
        <translation>Öffnen Sie zuerst eine Szene; dann kann sie einen anderen Arm bekommen.</translation>
    </message>
    <message>
        <source>This arm is already in use as the first arm. Choose another one here or there.</source>
        <translation>Dieser Arm wird schon als erster Arm verwendet. Wählen Sie hier oder dort einen anderen.</translation>
    </message>
    <message>
        <source>Another measurement is running. End it first.</source>
        <translation>Eine andere Messung läuft. Beenden Sie diese zuerst.</translation>
    </message>
    <message>
        <source>An internal error occurred in the window: %1.</source>
        <translation>Im Fenster ist ein interner Fehler aufgetreten: %1.</translation>
    </message>
    <message>
        <source>Save the scene under another name, then press Start. If the error occurs again, quit the program and send the fault file to its developers.</source>
        <translation>Speichern Sie die Szene unter einem anderen Namen und drücken Sie dann Start. Tritt der Fehler wieder auf, beenden Sie das Programm und senden Sie die Störungsdatei an die Entwickler.</translation>
    </message>
    <message>
        <source>There is no such row.</source>
        <translation>Diese Zeile gibt es nicht.</translation>
    </message>
    <message>
        <source>A joint is revolute or prismatic.</source>
        <translation>Ein Gelenk ist ein Drehgelenk oder ein Schubgelenk.</translation>
    </message>
    <message>
        <source>The figures have not been made yet.</source>
        <translation>Die Abbildungen wurden noch nicht erstellt.</translation>
    </message>
    <message>
        <source>The list of figures cannot be read. Make the figures again.</source>
        <translation>Die Liste der Abbildungen kann nicht gelesen werden. Erstellen Sie die Abbildungen neu.</translation>
    </message>
    <message>
        <source>Open a scene first. It is restored after the measurement.</source>
        <translation>Öffnen Sie zuerst eine Szene. Sie wird nach der Messung wiederhergestellt.</translation>
    </message>
    <message>
        <source>Only arms with the geometry of table 3.1 of the thesis can be measured. Open a scene for one of them.</source>
        <translation>Nur Arme mit der Geometrie aus Tabelle 3.1 der Thesis lassen sich vermessen. Öffnen Sie eine Szene für einen von ihnen.</translation>
    </message>
    <message>
        <source>A recording is being replayed. Close it first.</source>
        <translation>Eine Aufzeichnung wird wiedergegeben. Schließen Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Hold to run is on, but this measurement needs your hand off the stylus. Switch it off first.</source>
        <translation>„Nur mit Taste“ ist an, aber für diese Messung muss die Hand den Stift loslassen. Schalten Sie es zuerst aus.</translation>
    </message>
    <message>
        <source>The mapping could not be saved in %1: %2. It stays in effect until you close the window.</source>
        <translation>Die Belegung konnte nicht in %1 gespeichert werden: %2. Sie gilt, bis Sie das Fenster schließen.</translation>
    </message>
    <message>
        <source>A page without a folder has no pictures.</source>
        <translation>Eine Seite ohne Ordner hat keine Bilder.</translation>
    </message>
    <message>
        <source>A picture must be in the folder of the file that shows it.</source>
        <translation>Ein Bild muss im Ordner der Datei liegen, die es zeigt.</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>ein Bild</translation>
    </message>
    <message>
        <source>The picture has %1 x %2 pixels; make it smaller than 16 megapixels.</source>
        <translation>Das Bild hat %1 x %2 Pixel; verkleinern Sie es auf unter 16 Megapixel.</translation>
    </message>
    <message>
        <source>The picture is damaged, or neither PNG nor JPEG.</source>
        <translation>Das Bild ist beschädigt oder weder PNG noch JPEG.</translation>
    </message>
    <message>
        <source>The file cannot be written: %1. Choose another folder.</source>
        <translation>Die Datei kann nicht geschrieben werden: %1. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>A page shows at most %1 pictures.</source>
        <translation>Eine Seite zeigt höchstens %1 Bilder.</translation>
    </message>
    <message>
        <source>This window was opened for one arm only.</source>
        <translation>Dieses Fenster wurde nur für einen Arm geöffnet.</translation>
    </message>
    <message>
        <source>A session is being recorded, and a session contains only one arm. Stop the recording, then choose the arm.</source>
        <translation>Eine Sitzung wird aufgezeichnet, und eine Sitzung enthält nur einen Arm. Stoppen Sie die Aufzeichnung und wählen Sie dann den Arm.</translation>
    </message>
    <message>
        <source>A session is being replayed. Close it, then choose the arm.</source>
        <translation>Eine Sitzung wird wiedergegeben. Schließen Sie sie und wählen Sie dann den Arm.</translation>
    </message>
    <message>
        <source>A measurement is running on this arm. End it, then choose the arm.</source>
        <translation>Auf diesem Arm läuft eine Messung. Beenden Sie sie und wählen Sie dann den Arm.</translation>
    </message>
    <message>
        <source>This is a file of Underact with the key %1. The window does not open it; the guide says what it is for.</source>
        <translation>Das ist eine Datei von Underact mit dem Schlüssel %1. Das Fenster öffnet sie nicht; wozu sie dient, steht im Handbuch.</translation>
    </message>
    <message>
        <source>This JSON is none of Underact's: a scene has the key %1, an arm file %2 and a lesson %3.</source>
        <translation>Dieses JSON ist nicht von Underact: Eine Szene hat den Schlüssel %1, eine Armdatei %2 und eine Lektion %3.</translation>
    </message>
    <message>
        <source>This XML begins with the element %1. Underact opens only URDF, which begins with %2.</source>
        <translation>Dieses XML beginnt mit dem Element %1. Underact öffnet nur URDF, das mit %2 beginnt.</translation>
    </message>
    <message>
        <source>This is a xacro file, from which URDF is made. Run "xacro FILE &gt; robot.urdf", and open robot.urdf.</source>
        <translation>Das ist eine Xacro-Datei, aus der URDF erst gemacht wird. Rufen Sie „xacro DATEI &gt; robot.urdf“ auf und öffnen Sie robot.urdf.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>binary data of an unknown format</source>
        <translation>eine Binärdatei von unbekanntem Format</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>This is a text without the points of a curve: no line begins with a number.</source>
        <translation>Das ist ein Text ohne Punkte einer Kurve: Keine Zeile beginnt mit einer Zahl.</translation>
    </message>
    <message>
        <source>This is a folder. Open one of the files in it.</source>
        <translation>Das ist ein Ordner. Öffnen Sie eine der Dateien darin.</translation>
    </message>
    <message>
        <source>a file for Underact</source>
        <translation>eine Datei für Underact</translation>
    </message>
    <message>
        <source>Text typed during the recording is not in the file. Edit the details of the session below.</source>
        <translation>Was während der Aufzeichnung eingegeben wurde, steht nicht in der Datei. Ändern Sie die Angaben zur Sitzung unten.</translation>
    </message>
    <message>
        <source>No scene is open in the window.</source>
        <translation>Im Fenster ist keine Szene geöffnet.</translation>
    </message>
    <message>
        <source>The window plays a recording. Close the replay there first.</source>
        <translation>Das Fenster spielt eine Aufzeichnung ab. Schließen Sie dort zuerst die Wiedergabe.</translation>
    </message>
    <message>
        <source>The window is in visitor mode. End it there first.</source>
        <translation>Das Fenster ist im Besuchermodus. Beenden Sie ihn dort zuerst.</translation>
    </message>
    <message>
        <source>The window measures with a scene of its own. End that there first.</source>
        <translation>Das Fenster misst mit einer eigenen Szene. Beenden Sie das dort zuerst.</translation>
    </message>
    <message>
        <source>The scene in the window has changes that are not saved. Save or undo them there first.</source>
        <translation>Die Szene im Fenster hat ungesicherte Änderungen. Sichern Sie sie dort zuerst, oder machen Sie sie rückgängig.</translation>
    </message>
    <message>
        <source>No reference point has been touched.</source>
        <translation>Es wurde kein Messpunkt berührt.</translation>
    </message>
    <message>
        <source>A sheet holds only reference points of equal height: at least one is higher or lower than point 1.</source>
        <translation>Auf ein Blatt passen nur Messpunkte gleicher Höhe: Mindestens einer liegt höher oder tiefer als Messpunkt 1.</translation>
    </message>
    <message>
        <source>The reference points do not fit on this paper. Move them closer together, or draw them on the desk by hand.</source>
        <translation>Die Messpunkte passen nicht auf dieses Papier. Rücken Sie sie näher zusammen, oder zeichnen Sie sie von Hand auf den Tisch.</translation>
    </message>
    <message>
        <source>The sheet cannot be written: %1.</source>
        <translation>Das Blatt kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>The file cannot be created there. Choose another folder.</source>
        <translation>Die Datei kann dort nicht angelegt werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The existing file cannot be replaced. Choose another name.</source>
        <translation>Die vorhandene Datei kann nicht ersetzt werden. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>This session contains no ticks.</source>
        <translation>Diese Sitzung enthält keine Takte.</translation>
    </message>
    <message>
        <source>The file is larger than 64 MiB.</source>
        <translation>Die Datei ist größer als 64 MiB.</translation>
    </message>
    <message>
        <source>The file contains nothing to draw.</source>
        <translation>Die Datei enthält nichts, was gezeichnet werden könnte.</translation>
    </message>
    <message>
        <source>The mesh %1 is not drawn: %2</source>
        <translation>Das Netz %1 wird nicht gezeichnet: %2</translation>
    </message>
    <message>
        <source>The text is cut here: it is nested more than %1 deep.</source>
        <translation>Der Text ist hier abgeschnitten: Er ist mehr als %1-fach verschachtelt.</translation>
    </message>
    <message>
        <source>The text is cut here: it has more than %1 parts.</source>
        <translation>Der Text ist hier abgeschnitten: Er hat mehr als %1 Teile.</translation>
    </message>
    <message>
        <source>The text is cut here: it is longer than %1 KiB.</source>
        <translation>Der Text ist hier abgeschnitten: Er ist länger als %1 KiB.</translation>
    </message>
    <message>
        <source>The file is damaged: reading stopped after %1 vertices and %2 faces.</source>
        <translation>Die Datei ist beschädigt: Nach %1 Ecken und %2 Flächen ging es beim Lesen nicht weiter.</translation>
    </message>
    <message>
        <source>The file is damaged, or its faces take more memory than a file of its size should.</source>
        <translation>Die Datei ist beschädigt, oder ihre Flächen brauchen mehr Speicher als bei einer Datei ihrer Größe zu erwarten.</translation>
    </message>
    <message>
        <source>The file is damaged: OpenMesh could not read it.</source>
        <translation>Die Datei ist beschädigt: OpenMesh konnte sie nicht lesen.</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 is not the normal of a face.</source>
        <translation>Die Datei ist beschädigt: Zeile %1 ist keine Normale einer Fläche.</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 does not begin the vertices of a face (outer loop).</source>
        <translation>Die Datei ist beschädigt: Zeile %1 beginnt nicht die Ecken einer Fläche (outer loop).</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 is not a vertex of a face (vertex x y z).</source>
        <translation>Die Datei ist beschädigt: Zeile %1 ist keine Ecke einer Fläche (vertex x y z).</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 does not end the three vertices of a face (endloop).</source>
        <translation>Die Datei ist beschädigt: Zeile %1 beendet nicht die drei Ecken einer Fläche (endloop).</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 does not end a face (endfacet).</source>
        <translation>Die Datei ist beschädigt: In Zeile %1 endet keine Fläche (endfacet).</translation>
    </message>
    <message>
        <source>The file is damaged: its length does not fit its faces.</source>
        <translation>Die Datei ist beschädigt: Ihre Länge passt nicht zu ihren Flächen.</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 does not begin a face (facet).</source>
        <translation>Die Datei ist beschädigt: In Zeile %1 beginnt keine Fläche (facet).</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 is not a vertex (v x y z).</source>
        <translation>Die Datei ist beschädigt: Zeile %1 ist keine Ecke (v x y z).</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 is not a face.</source>
        <translation>Die Datei ist beschädigt: Zeile %1 ist keine Fläche.</translation>
    </message>
    <message>
        <source>The file is damaged: it ends at line %1, and vertices or faces are missing.</source>
        <translation>Die Datei ist beschädigt: Sie endet mit Zeile %1, und Ecken oder Flächen fehlen.</translation>
    </message>
    <message>
        <source>The file is damaged: line %1 is not a vertex (x y z).</source>
        <translation>Die Datei ist beschädigt: Zeile %1 ist keine Ecke (x y z).</translation>
    </message>
    <message>
        <source>The file is damaged: vertex %1 of %2 cannot be read.</source>
        <translation>Die Datei ist beschädigt: Ecke %1 von %2 ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The file is damaged: face %1 of %2 cannot be read.</source>
        <translation>Die Datei ist beschädigt: Fläche %1 von %2 ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The file is damaged: row %1 of %2 cannot be read.</source>
        <translation>Die Datei ist beschädigt: Zeile %1 von %2 ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The file is damaged, or takes more memory than a file of its size should.</source>
        <translation>Die Datei ist beschädigt oder braucht mehr Speicher als bei einer Datei ihrer Größe zu erwarten.</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>ein Objekt in { }</translation>
    </message>
    <message>
        <source>a device description</source>
        <translation>eine Gerätebeschreibung</translation>
    </message>
    <message>
        <source>This must be above 0.</source>
        <translation>Dies muss über 0 liegen.</translation>
    </message>
    <message>
        <source>This must be 0 or above.</source>
        <translation>Dieser Wert muss 0 oder größer sein.</translation>
    </message>
    <message>
        <source>a list of numbers, one for each joint</source>
        <translation>eine Liste von Zahlen, eine je Gelenk</translation>
    </message>
    <message>
        <source>This must be a list of %1 numbers, one for each joint.</source>
        <translation>Dies muss eine Liste von %1 Zahlen sein, eine je Gelenk.</translation>
    </message>
    <message>
        <source>This must be a number of at least 1.</source>
        <translation>Dies muss eine Zahl von mindestens 1 sein.</translation>
    </message>
    <message>
        <source>an arm file</source>
        <translation>eine Armdatei</translation>
    </message>
    <message>
        <source>This program reads version 1 of arm files.</source>
        <translation>Dieses Programm liest Version 1 von Armdateien.</translation>
    </message>
    <message>
        <source>an object, as in %1</source>
        <translation>ein Objekt wie %1</translation>
    </message>
    <message>
        <source>--base and --tip are for URDF files: other files have one arm.</source>
        <translation>--base und --tip sind für URDF-Dateien: andere Dateien haben nur einen Arm.</translation>
    </message>
    <message>
        <source>an arm</source>
        <translation>eine Armdatei</translation>
    </message>
    <message>
        <source>Two of the axes are nearly parallel: a DH table would lose digits. Write the arm as a product of exponentials (poe).</source>
        <translation>Zwei der Achsen sind fast parallel: Eine DH-Tabelle würde Stellen verlieren. Schreiben Sie den Arm als Produkt von Exponentialen (poe).</translation>
    </message>
    <message>
        <source>A haptic device must stay a DH table, because its lengths are read from that.</source>
        <translation>Ein haptisches Gerät muss eine DH-Tabelle bleiben, weil seine Längen daraus gelesen werden.</translation>
    </message>
    <message>
        <source>Joint %1 slides without limits, which URDF cannot express.</source>
        <translation>Gelenk %1 verschiebt sich ohne Grenzen; das lässt sich in URDF nicht angeben.</translation>
    </message>
    <message>
        <source>Joint %1 has one limit only, which URDF cannot express.</source>
        <translation>Gelenk %1 hat nur eine Grenze; das lässt sich in URDF nicht angeben.</translation>
    </message>
    <message>
        <source>Joint %1 has limits on the magnitude of its angle, which URDF cannot express.</source>
        <translation>Gelenk %1 hat Grenzen für den Betrag seines Winkels; das lässt sich in URDF nicht angeben.</translation>
    </message>
    <message>
        <source>A capsule is none of the forms of URDF.</source>
        <translation>URDF kennt keine Kapsel.</translation>
    </message>
    <message>
        <source>A length must lie within 1e6 mm (1 km).</source>
        <translation>Eine Länge darf höchstens 1e6 mm (1 km) betragen.</translation>
    </message>
    <message>
        <source>This is not a finite number.</source>
        <translation>Dies ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>This must be a list of 4 rows.</source>
        <translation>Dies muss eine Liste von 4 Zeilen sein.</translation>
    </message>
    <message>
        <source>Each row must have 4 numbers.</source>
        <translation>Jede Zeile muss 4 Zahlen haben.</translation>
    </message>
    <message>
        <source>Each entry must be a number.</source>
        <translation>Jeder Eintrag muss eine Zahl sein.</translation>
    </message>
    <message>
        <source>The last row must be 0, 0, 0, 1.</source>
        <translation>Die letzte Zeile muss 0, 0, 0, 1 sein.</translation>
    </message>
    <message>
        <source>A prismatic joint has its limits in mm: "%1".</source>
        <translation>Ein Schubgelenk hat seine Grenzen in mm: „%1“.</translation>
    </message>
    <message>
        <source>A revolute joint has its limits in degrees or radians: "%1".</source>
        <translation>Ein Drehgelenk hat seine Grenzen in Grad oder rad: „%1“.</translation>
    </message>
    <message>
        <source>This limit is already given by "%1".</source>
        <translation>Diese Grenze ist schon durch „%1“ angegeben.</translation>
    </message>
    <message>
        <source>A revolute joint rests at an angle: "%1".</source>
        <translation>Ein Drehgelenk ruht bei einem Winkel: „%1“.</translation>
    </message>
    <message>
        <source>A prismatic joint rests at a length: "%1".</source>
        <translation>Ein Schubgelenk ruht bei einer Länge: „%1“.</translation>
    </message>
    <message>
        <source>The rest is already given by "%1".</source>
        <translation>Die Ruhelage steht schon in „%1“.</translation>
    </message>
    <message>
        <source>A revolute joint has a torque: "%1".</source>
        <translation>Ein Drehgelenk hat ein Drehmoment: "%1".</translation>
    </message>
    <message>
        <source>A prismatic joint has a force: "%1".</source>
        <translation>Ein Schubgelenk hat eine Kraft: "%1".</translation>
    </message>
    <message>
        <source>the mass of a link</source>
        <translation>die Masse eines Glieds</translation>
    </message>
    <message>
        <source>This must be six numbers: xx, yy, zz, xy, xz and yz.</source>
        <translation>Hier müssen sechs Zahlen stehen: xx, yy, zz, xy, xz und yz.</translation>
    </message>
    <message>
        <source>The joint's lower limit must be below its upper limit.</source>
        <translation>Die untere Grenze des Gelenks muss unter der oberen liegen.</translation>
    </message>
    <message>
        <source>The joint's rest must be within its limits.</source>
        <translation>Die Ruhelage des Gelenks muss innerhalb seiner Grenzen liegen.</translation>
    </message>
    <message>
        <source>A joint that is not sensed cannot be driven.</source>
        <translation>Ein Gelenk, das nicht gemessen wird, kann nicht angetrieben werden.</translation>
    </message>
    <message>
        <source>Only joint 5 can have limits on the magnitude of its angle.</source>
        <translation>Nur bei Gelenk 5 lässt sich der Betrag des Winkels begrenzen.</translation>
    </message>
    <message>
        <source>The axis has no direction.</source>
        <translation>Die Achse hat keine Richtung.</translation>
    </message>
    <message>
        <source>A prismatic joint has a direction, but no point.</source>
        <translation>Ein Schubgelenk hat eine Richtung, aber keinen Punkt.</translation>
    </message>
    <message>
        <source>a list of joints, in { } each</source>
        <translation>eine Liste von Gelenken, jedes in { }</translation>
    </message>
    <message>
        <source>An arm has from one to eight joints; this one has %1.</source>
        <translation>Ein Arm hat ein bis acht Gelenke; dieser hat %1.</translation>
    </message>
    <message>
        <source>a row, as in {"alpha_deg": 90, "a_mm": 0, ...}</source>
        <translation>eine Zeile wie {"alpha_deg": 90, "a_mm": 0, ...}</translation>
    </message>
    <message>
        <source>The tool is already given by "X_6T".</source>
        <translation>Das Werkzeug ist schon durch „X_6T“ angegeben.</translation>
    </message>
    <message>
        <source>Only an arm of six joints can have "X_6T"; its general name is "X_NT".</source>
        <translation>Nur ein Arm mit sechs Gelenken kann „X_6T“ haben; der allgemeine Name ist „X_NT“.</translation>
    </message>
    <message>
        <source>a row of the DH table</source>
        <translation>eine Zeile der DH-Tabelle</translation>
    </message>
    <message>
        <source>a joint</source>
        <translation>ein Gelenk</translation>
    </message>
    <message>
        <source>The joints are already given by the table "dh".</source>
        <translation>Die Gelenke sind schon durch die Tabelle „dh“ angegeben.</translation>
    </message>
    <message>
        <source>The arm of a scene with the geometry of table 3.1 of the thesis is a haptic device, which needs %1 and %2 here: %3.</source>
        <translation>Der Arm einer Szene mit der Geometrie aus Tabelle 3.1 der Thesis ist ein haptisches Gerät und braucht hier %1 und %2: %3.</translation>
    </message>
    <message>
        <source>Joint %1 is not sensed, so that the position of the tip would be unknown: the arm of a scene needs each of its joints sensed.</source>
        <translation>Gelenk %1 wird nicht gemessen, die Lage der Spitze wäre also unbekannt: Beim Arm einer Szene muss jedes Gelenk gemessen werden.</translation>
    </message>
    <message>
        <source>This must be the name of a mesh file.</source>
        <translation>Das muss der Name einer Netzdatei sein.</translation>
    </message>
    <message>
        <source>The name of the mesh is longer than 1024 bytes.</source>
        <translation>Der Name des Netzes ist länger als 1024 Bytes.</translation>
    </message>
    <message>
        <source>Each factor must be from 1e-6 to 1e6, or the same below 0.</source>
        <translation>Jeder Faktor muss zwischen 1e-6 und 1e6 liegen, oder ebenso unter 0.</translation>
    </message>
    <message>
        <source>Each length must be above 0.</source>
        <translation>Jede Länge muss über 0 liegen.</translation>
    </message>
    <message>
        <source>This must be a whole number from 0, the base, to %1, the last link.</source>
        <translation>Das muss eine ganze Zahl von 0, der Basis, bis %1, dem letzten Glied, sein.</translation>
    </message>
    <message>
        <source>a list of solids, in { } each</source>
        <translation>eine Liste von Körpern, jeder in { }</translation>
    </message>
    <message>
        <source>An arm has at most %1 solids; this one has %2.</source>
        <translation>Ein Arm hat höchstens %1 Körper; dieser hat %2.</translation>
    </message>
    <message>
        <source>a solid</source>
        <translation>ein Körper</translation>
    </message>
    <message>
        <source>The mesh %1 is not drawn: its name leads out of the folder of the arm's file, or of the package that this folder is in.</source>
        <translation>Das Netz %1 wird nicht gezeichnet: Sein Name führt aus dem Ordner der Armdatei hinaus oder aus dem Paket, in dem dieser Ordner liegt.</translation>
    </message>
    <message>
        <source>The mesh %1 is not drawn: a recording contains the file of the arm, not the meshes beside it.</source>
        <translation>Das Netz %1 wird nicht gezeichnet: Eine Aufzeichnung enthält die Datei des Arms, nicht die Netze daneben.</translation>
    </message>
    <message>
        <source>The mesh %1 is not drawn: there is no such package in the folder of the arm's file, and none with a package.xml in the folders above.</source>
        <translation>Das Netz %1 wird nicht gezeichnet: Ein solches Paket gibt es im Ordner der Armdatei nicht, und auch keines mit einer package.xml in den Ordnern darüber.</translation>
    </message>
    <message>
        <source>The mesh %1 is not drawn: there is no such file.</source>
        <translation>Das Netz %1 wird nicht gezeichnet: Eine solche Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>The joint %1 is %2; a joint of an arm turns about an axis or slides along it. Leave it out (%3).</source>
        <translation>Das Gelenk %1 ist %2; ein Gelenk eines Arms dreht sich um eine Achse oder gleitet an ihr entlang. Lassen Sie es weg (%3).</translation>
    </message>
    <message>
        <source>The joint %1 follows another one; each joint of an arm moves by itself. Leave it out (%2).</source>
        <translation>Das Gelenk %1 folgt einem anderen; jedes Gelenk eines Arms bewegt sich für sich. Lassen Sie es weg (%2).</translation>
    </message>
    <message>
        <source>The joint %1 has no range here, and is taken as one without limits.</source>
        <translation>Das Gelenk %1 hat hier keinen Bereich und gilt als eines ohne Grenzen.</translation>
    </message>
    <message>
        <source>An arm has from one to eight joints; this is the ninth. End it before (%1).</source>
        <translation>Ein Arm hat ein bis acht Gelenke; dies ist das neunte. Lassen Sie ihn davor enden (%1).</translation>
    </message>
    <message>
        <source>%1 kg on joints beside the arm, from link %2 on, are in none of its masses.</source>
        <translation>%1 kg an Gelenken neben dem Arm, ab Glied %2, sind in keiner seiner Massen.</translation>
    </message>
    <message>
        <source>No joint between link %1 and link %2 moves.</source>
        <translation>Zwischen Glied %1 und Glied %2 bewegt sich kein Gelenk.</translation>
    </message>
    <message>
        <source>The link %1 has two parents.</source>
        <translation>Das Glied %1 hat zwei übergeordnete Glieder.</translation>
    </message>
    <message>
        <source>The robot has no link that could be its %1.</source>
        <translation>Der Roboter hat kein Glied, das „%1“ sein könnte.</translation>
    </message>
    <message>
        <source>Say which link is the %1 (arm convert --%1 LINK): %2, for example.</source>
        <translation>Geben Sie an, welches Glied „%1“ ist (arm convert --%1 GLIED), zum Beispiel %2.</translation>
    </message>
    <message>
        <source>The joint %1 is %2, so link %3 is taken as the base.</source>
        <translation>Das Gelenk %1 ist %2, darum gilt das Glied %3 als Basis.</translation>
    </message>
    <message>
        <source>Link %1 is taken as the tip. --tip LINK takes another one: %2, for example.</source>
        <translation>Das Glied %1 gilt als Spitze. --tip GLIED nimmt ein anderes: %2 zum Beispiel.</translation>
    </message>
    <message>
        <source>No joints lead from link %1 to link %2.</source>
        <translation>Von Glied %1 zu Glied %2 führen keine Gelenke.</translation>
    </message>
    <message>
        <source>There is no link %1.</source>
        <translation>Es gibt kein Glied %1.</translation>
    </message>
    <message>
        <source>There is no link %1. Did you mean "%2"?</source>
        <translation>Es gibt kein Glied %1. Ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>This file is a macro (xacro). Expand it into a URDF file first.</source>
        <translation>Diese Datei ist ein Makro (xacro). Erzeugen Sie daraus zuerst eine URDF-Datei.</translation>
    </message>
    <message>
        <source>A robot can have at most 4096 links and joints.</source>
        <translation>Ein Roboter kann höchstens 4096 Glieder und Gelenke haben.</translation>
    </message>
    <message>
        <source>This program reads URDF of the versions 1.0, 1.1 and 1.2; here it is %1.</source>
        <translation>Dieses Programm liest URDF der Versionen 1.0, 1.1 und 1.2; hier steht %1.</translation>
    </message>
    <message>
        <source>The name %1 appears twice.</source>
        <translation>Der Name %1 kommt zweimal vor.</translation>
    </message>
    <message>
        <source>A length must lie within 1000 m.</source>
        <translation>Eine Länge darf höchstens 1000 m betragen.</translation>
    </message>
    <message>
        <source>An &lt;origin&gt; has either "rpy" or "quat_xyzw", not both.</source>
        <translation>Ein &lt;origin&gt; hat entweder "rpy" oder "quat_xyzw", nicht beides.</translation>
    </message>
    <message>
        <source>A quaternion must have the length 1; here it is %1.</source>
        <translation>Ein Quaternion muss die Länge 1 haben; hier ist sie %1.</translation>
    </message>
    <message>
        <source>A length must be above 0 and at most 1000 m.</source>
        <translation>Eine Länge muss über 0 liegen und darf höchstens 1000 m sein.</translation>
    </message>
    <message>
        <source>Each factor must be from 1e-9 to 1000, or the same below 0.</source>
        <translation>Jeder Faktor muss zwischen 1e-9 und 1000 liegen, oder ebenso unter 0.</translation>
    </message>
    <message>
        <source>The form %1 is not known here.</source>
        <translation>Die Form %1 ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>A picture of link %1 is not drawn: %2</source>
        <translation>Ein Bild des Glieds %1 wird nicht gezeichnet: %2</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; is missing; &lt;joint&gt; needs it.</source>
        <translation>Das Element &lt;%1&gt; fehlt; &lt;joint&gt; braucht es.</translation>
    </message>
    <message>
        <source>A joint's type must be %1; here it is %2.</source>
        <translation>Der Typ eines Gelenks muss %1 sein; hier ist er %2.</translation>
    </message>
    <message>
        <source>The type %1 is not known. Did you mean "%2"?</source>
        <translation>Der Typ %1 ist nicht bekannt. Ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>An element is not closed, or closed by another name, here or above.</source>
        <translation>Ein Element ist nicht geschlossen oder mit einem anderen Namen geschlossen, hier oder weiter oben.</translation>
    </message>
    <message>
        <source>An attribute of this element is not written as name="value".</source>
        <translation>Ein Attribut dieses Elements ist nicht in der Form Name="Wert" geschrieben.</translation>
    </message>
    <message>
        <source>The elements are nested more than 100 levels deep.</source>
        <translation>Die Elemente sind mehr als 100 Ebenen tief geschachtelt.</translation>
    </message>
    <message>
        <source>Here the text stops being XML.</source>
        <translation>Ab hier ist der Text kein XML mehr.</translation>
    </message>
    <message>
        <source>This is no text: it contains zero bytes.</source>
        <translation>Das ist kein Text: Er enthält Nullbytes.</translation>
    </message>
    <message>
        <source>A document type is not allowed here. Remove it.</source>
        <translation>Ein Dokumenttyp ist hier nicht erlaubt. Entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>A URDF file is one element &lt;robot&gt;.</source>
        <translation>Eine URDF-Datei besteht aus einem Element &lt;robot&gt;.</translation>
    </message>
    <message>
        <source>The attribute %1 is not known in &lt;%2&gt;, and may move the link.</source>
        <translation>Das Attribut %1 ist in &lt;%2&gt; nicht bekannt und könnte das Glied bewegen.</translation>
    </message>
    <message>
        <source>The element %1 is not known in &lt;%2&gt;, and may move the link.</source>
        <translation>Das Element %1 ist in &lt;%2&gt; nicht bekannt und könnte das Glied bewegen.</translation>
    </message>
    <message>
        <source>The element &lt;%1&gt; appears twice in &lt;%2&gt;.</source>
        <translation>Das Element &lt;%1&gt; steht zweimal in &lt;%2&gt;.</translation>
    </message>
    <message>
        <source>The element %1 is not known here. Did you mean "%2"?</source>
        <translation>Das Element %1 ist hier nicht bekannt. Ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>The attribute %1 is not known in &lt;%2&gt;. Did you mean "%3"?</source>
        <translation>Das Attribut %1 ist in &lt;%2&gt; nicht bekannt. Ist „%3“ gemeint?</translation>
    </message>
    <message>
        <source>The attribute "%1" is missing; %2 needs it.</source>
        <translation>Das Attribut „%1“ fehlt; %2 braucht es.</translation>
    </message>
    <message>
        <source>This must be a finite number; here it is %1.</source>
        <translation>Hier muss eine endliche Zahl stehen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be %1 finite numbers; here it is %2.</source>
        <translation>Hier müssen %1 endliche Zahlen stehen; hier steht %2.</translation>
    </message>
    <message>
        <source>A reference such as &amp;#65; ends with a semicolon.</source>
        <translation>Ein Verweis wie &amp;#65; endet mit einem Strichpunkt.</translation>
    </message>
    <message>
        <source>An element can have at most 64 attributes.</source>
        <translation>Ein Element kann höchstens 64 Attribute haben.</translation>
    </message>
    <message>
        <source>The arm stopped answering.</source>
        <translation>Der Arm antwortet nicht mehr.</translation>
    </message>
    <message>
        <source>The arm sent the same sample twice.</source>
        <translation>Der Arm hat denselben Messwert zweimal gesendet.</translation>
    </message>
    <message>
        <source>The arm sent a position that is not a number.</source>
        <translation>Der Arm hat eine Position gesendet, die keine Zahl ist.</translation>
    </message>
    <message>
        <source>The arm's position jumped at %1 m/s; a hand reaches at most %2 m/s.</source>
        <translation>Die Lage des Arms sprang mit %1 m/s; eine Hand erreicht höchstens %2 m/s.</translation>
    </message>
    <message>
        <source>%1 ticks in a row were late by a whole period.</source>
        <translation>%1 Takte nacheinander waren um eine ganze Periode zu spät.</translation>
    </message>
    <message>
        <source>The servo stalled for %1 s.</source>
        <translation>Der Servo stand %1 s lang still.</translation>
    </message>
    <message>
        <source>The arm's clock advanced by %1 s while %2 s passed.</source>
        <translation>Die Uhr des Arms ging um %1 s weiter, während %2 s vergingen.</translation>
    </message>
    <message>
        <source>The computer was asleep for %1 s.</source>
        <translation>Der Rechner war %1 s lang im Ruhezustand.</translation>
    </message>
    <message>
        <source>The window was too busy to hear Stop for %1 s.</source>
        <translation>Das Fenster war %1 s lang zu beschäftigt, um Stopp zu hören.</translation>
    </message>
    <message>
        <source>Check the cable, then press Start.</source>
        <translation>Prüfen Sie das Kabel und drücken Sie dann Start.</translation>
    </message>
    <message>
        <source>Press Start to try again.</source>
        <translation>Drücken Sie Start, um es erneut zu versuchen.</translation>
    </message>
    <message>
        <source>Close programs that keep the computer busy or choose a lower rate, then press Start.</source>
        <translation>Programme schließen, die den Rechner auslasten, oder eine kleinere Taktrate wählen, dann Start drücken.</translation>
    </message>
    <message>
        <source>Press Start to continue.</source>
        <translation>Start drücken, um weiterzumachen.</translation>
    </message>
    <message>
        <source>Restart the servo to reopen the arm, then press Start.</source>
        <translation>Den Servo neu starten, um den Arm neu zu öffnen, dann Start drücken.</translation>
    </message>
    <message>
        <source>Force is off.</source>
        <translation>Die Kraft ist aus.</translation>
    </message>
    <message>
        <source>This is a %1 archive. Unpack it, and open a file that is in it.</source>
        <translation>Das ist ein %1-Archiv. Entpacken Sie es und öffnen Sie eine Datei daraus.</translation>
    </message>
    <message>
        <source>This is a %1 model. Save it as STL or OBJ with the program that it comes from, and open that file.</source>
        <translation>Das ist ein %1-Modell. Speichern Sie es mit dem Programm, aus dem es stammt, als STL oder OBJ und öffnen Sie diese Datei.</translation>
    </message>
    <message>
        <source>a %1 document</source>
        <translation>ein Dokument (%1)</translation>
    </message>
    <message>
        <source>a picture (%1)</source>
        <translation>ein Bild (%1)</translation>
    </message>
    <message>
        <source>a film (%1)</source>
        <translation>ein Film (%1)</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>ein Programm</translation>
    </message>
    <message>
        <source>This text is in UTF-16. Save it as UTF-8.</source>
        <translation>Dieser Text ist in UTF-16. Speichern Sie ihn als UTF-8.</translation>
    </message>
    <message>
        <source>This is a web page, not the file itself. Download the file again.</source>
        <translation>Dies ist eine Webseite, nicht die Datei selbst. Laden Sie die Datei noch einmal herunter.</translation>
    </message>
    <message>
        <source>This is a pointer of Git LFS, not the file itself. Get it with "git lfs pull".</source>
        <translation>Dies ist ein Zeiger von Git LFS, nicht die Datei selbst. Holen Sie sie mit "git lfs pull".</translation>
    </message>
    <message>
        <source>This is %1. Underact opens scenes, sessions, arm files, meshes, points of curves, lessons, lists of figures and notebooks.</source>
        <translation>Das ist %1. Underact öffnet Szenen, Sitzungen, Armdateien, Netze, Punkte von Kurven, Lektionen, Listen von Abbildungen und Notebooks.</translation>
    </message>
    <message>
        <source>This is not a rotation matrix: its rows must have length 1, be at right angles, and form a right-handed frame.</source>
        <translation>Dies ist keine Rotationsmatrix: Ihre Zeilen müssen die Länge 1 haben, rechtwinklig zueinander stehen und ein rechtshändiges Koordinatensystem bilden.</translation>
    </message>
    <message>
        <source>This is not a rotation matrix: a number in it is %1 off the nearest one, and 0.001 is allowed. Give at least four decimals, better six.</source>
        <translation>Dies ist keine Drehmatrix: eine Zahl darin weicht um %1 von der nächsten ab, und 0.001 ist erlaubt. Geben Sie mindestens vier Dezimalen an, besser sechs.</translation>
    </message>
    <message>
        <source>This matrix is %1 off a rotation, and the nearest one is taken. With six decimals it is exact enough.</source>
        <translation>Diese Matrix weicht um %1 von einer Drehung ab; die nächste wird genommen. Mit sechs Dezimalen ist sie genau genug.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>A threshold measurement needs a scene with two beams: two virtual robots, each with one revolute joint and a spring. Open the scene "Two beams, one softer".</source>
        <translation>Eine Schwellenmessung braucht eine Szene mit zwei Balken: zwei virtuelle Roboter, jeder mit einem Drehgelenk und einer Feder. Öffnen Sie die Szene „Zwei Balken, einer weicher“.</translation>
    </message>
    <message>
        <source>Joint %1: the axis has no direction.</source>
        <translation>Gelenk %1: Die Achse hat keine Richtung.</translation>
    </message>
    <message>
        <source>Joint %1: the point on the axis is not a finite point.</source>
        <translation>Gelenk %1: Der Punkt auf der Achse ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>Joint %1: the lower limit must not be above the upper one.</source>
        <translation>Gelenk %1: Die untere Grenze darf nicht über der oberen liegen.</translation>
    </message>
    <message>
        <source>A chain needs at least one joint.</source>
        <translation>Eine Kette braucht mindestens ein Gelenk.</translation>
    </message>
    <message>
        <source>A chain has at most %1 joints, not %2.</source>
        <translation>Eine Kette hat höchstens %1 Gelenke, nicht %2.</translation>
    </message>
    <message>
        <source>The upper left 3 x 3 numbers of the home pose are not a rotation matrix.</source>
        <translation>Die 3 x 3 Zahlen oben links in der Lage der Grundstellung sind keine Rotationsmatrix.</translation>
    </message>
    <message>
        <source>The position of the home pose is not a finite point.</source>
        <translation>Die Position in der Lage der Grundstellung ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>A table needs at least one row: a chain without joints cannot move.</source>
        <translation>Eine Tabelle braucht mindestens eine Zeile: Eine Kette ohne Gelenke kann sich nicht bewegen.</translation>
    </message>
    <message>
        <source>A table has at most %1 rows.</source>
        <translation>Eine Tabelle hat höchstens %1 Zeilen.</translation>
    </message>
    <message>
        <source>%1 of row %2 must be from -360 to 360 degrees.</source>
        <translation>%1 in Zeile %2 muss zwischen -360 und 360 Grad liegen.</translation>
    </message>
    <message>
        <source>%1 of row %2 must be from -1000 to 1000 mm: a longer one does not fit into the picture.</source>
        <translation>%1 in Zeile %2 muss zwischen -1000 und 1000 mm liegen: Eine größere Länge passt nicht ins Bild.</translation>
    </message>
    <message>
        <source>The twist alpha</source>
        <translation>Die Verwindung alpha</translation>
    </message>
    <message>
        <source>The length a</source>
        <translation>Die Länge a</translation>
    </message>
    <message>
        <source>The angle theta</source>
        <translation>Der Winkel theta</translation>
    </message>
    <message>
        <source>The offset d</source>
        <translation>Der Versatz d</translation>
    </message>
    <message>
        <source>In row %1 the lower limit is above the upper limit.</source>
        <translation>In Zeile %1 liegt die untere Grenze über der oberen.</translation>
    </message>
    <message>
        <source>a of row %1 is below 0, but it is a distance along x. Reverse x to describe the same arm: add 180 degrees to theta in this row and in the row before it, and change the signs of a and alpha.</source>
        <translation>a in Zeile %1 liegt unter 0, ist aber ein Abstand entlang x. Kehren Sie x um, um denselben Arm zu beschreiben: Addieren Sie 180 Grad zu theta in dieser und in der vorigen Zeile, und wechseln Sie die Vorzeichen von a und alpha.</translation>
    </message>
    <message>
        <source>Joints %1 and %2 slide in the same direction: one of them is redundant.</source>
        <translation>Die Gelenke %1 und %2 gleiten in derselben Richtung: Eines davon ist überflüssig.</translation>
    </message>
    <message>
        <source>Joints %1 and %2 turn about the same axis: one of them is redundant. Add a twist or a length between them.</source>
        <translation>Die Gelenke %1 und %2 drehen sich um dieselbe Achse: Eines davon ist überflüssig. Geben Sie zwischen ihnen eine Verwindung oder eine Länge an.</translation>
    </message>
    <message>
        <source>No joint moves the tip: it lies on every axis. Add a length a, or an offset d after a twist.</source>
        <translation>Kein Gelenk bewegt die Spitze: Sie liegt auf jeder Achse. Geben Sie eine Länge a an, oder einen Versatz d nach einer Verwindung.</translation>
    </message>
    <message>
        <source>A curve has at most 1000000 points.</source>
        <translation>Eine Kurve hat höchstens 1000000 Punkte.</translation>
    </message>
    <message>
        <source>Point %1 of the curve is not a finite point.</source>
        <translation>Punkt %1 der Kurve ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>Point %1 of the curve is farther than 1e6 mm from the origin; check the scale.</source>
        <translation>Punkt %1 der Kurve ist weiter als 1e6 mm vom Ursprung entfernt; prüfen Sie den Maßstab.</translation>
    </message>
    <message>
        <source>A closed curve needs at least 3 different points.</source>
        <translation>Eine geschlossene Kurve braucht mindestens 3 verschiedene Punkte.</translation>
    </message>
    <message>
        <source>A curve needs at least 2 different points.</source>
        <translation>Eine Kurve braucht mindestens 2 verschiedene Punkte.</translation>
    </message>
    <message>
        <source>The file has more than 1000000 points; remove every second one.</source>
        <translation>Die Datei hat mehr als 1000000 Punkte; entfernen Sie jeden zweiten.</translation>
    </message>
    <message>
        <source>Colours behind the points, or their number before them, were left out.</source>
        <translation>Farben hinter den Punkten oder ihre Anzahl davor wurden weggelassen.</translation>
    </message>
    <message>
        <source>The file has no points.</source>
        <translation>Die Datei hat keine Punkte.</translation>
    </message>
    <message>
        <source>There is nothing between two separators; a point is three numbers.</source>
        <translation>Zwischen zwei Trennzeichen steht nichts; ein Punkt besteht aus drei Zahlen.</translation>
    </message>
    <message>
        <source>A point is three numbers, not %1; use a point for decimals.</source>
        <translation>Ein Punkt besteht aus drei Zahlen, nicht %1; schreiben Sie Dezimalzahlen mit einem Punkt.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is not a finite number.</source>
        <translation>%1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>a curve</source>
        <translation>eine Kurve</translation>
    </message>
    <message>
        <source>Reading the file took longer than %1, although there was little to compute: the disk or the network may be slow. Copy the file to this computer, and open the copy.</source>
        <translation>Das Lesen der Datei dauerte länger als %1, obwohl dabei wenig zu rechnen war: Der Datenträger oder das Netz ist vielleicht langsam. Kopieren Sie die Datei auf diesen Rechner und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2.</source>
        <translation>%1 kann nicht gestartet werden: %2.</translation>
    </message>
    <message>
        <source>The file was not opened: %1 could not be isolated from the rest of this computer, which protects you from damaged or malicious files. Run the program on a system that lets it filter system calls (seccomp).</source>
        <translation>Die Datei wurde nicht geöffnet: %1 ließ sich nicht vom Rest dieses Rechners abschotten, was vor beschädigten oder bösartigen Dateien schützt. Starten Sie das Programm auf einem System, auf dem es Systemaufrufe filtern darf (seccomp).</translation>
    </message>
    <message>
        <source>The tip hardly moved, so nothing can be measured. Check that the hand has let go, that nothing is in the way, and that the arm has mass.</source>
        <translation>Die Spitze hat sich kaum bewegt, sodass sich nichts messen lässt. Prüfen Sie, dass die Hand losgelassen hat, dass nichts im Weg steht und dass der Arm Masse hat.</translation>
    </message>
    <message>
        <source>The fit was cancelled.</source>
        <translation>Die Anpassung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>No mass with friction and damping moves as the tip did. Check that the hand has let go, and measure again.</source>
        <translation>Keine Masse mit Reibung und Dämpfung bewegt sich so wie die Spitze. Prüfen Sie, dass die Hand losgelassen hat, und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The evaluation was cancelled.</source>
        <translation>Die Auswertung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Along %1 at position %2: %3</source>
        <translation>Entlang %1 an der Position %2: %3</translation>
    </message>
    <message>
        <source>Hold the stylus. Press it down slowly by 3 mm and let it come back just as slowly, four times, two seconds each.</source>
        <translation>Halten Sie den Stift. Drücken Sie ihn langsam 3 mm nach unten und lassen Sie ihn ebenso langsam zurückkommen, viermal, je zwei Sekunden.</translation>
    </message>
    <message>
        <source>Slowly turn the stylus about its own axis in your fingers, and tilt it both ways.</source>
        <translation>Drehen Sie den Stift langsam in den Fingern um seine eigene Achse, und neigen Sie ihn nach beiden Seiten.</translation>
    </message>
    <message>
        <source>Let go of the stylus and keep your hand away. The arm moves by itself, 20 mm to each side.</source>
        <translation>Lassen Sie den Stift los und halten Sie die Hand fern. Der Arm bewegt sich von selbst, 20 mm nach jeder Seite.</translation>
    </message>
    <message>
        <source>The tip moves to its position</source>
        <translation>Die Spitze fährt an ihre Position</translation>
    </message>
    <message>
        <source>The hand grips the stylus</source>
        <translation>Die Hand greift den Stift</translation>
    </message>
    <message>
        <source>Swings along %1</source>
        <translation>Schwingungen entlang %1</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>Slow press</source>
        <translation>Langsames Drücken</translation>
    </message>
    <message>
        <source>Rotations of the stylus</source>
        <translation>Drehungen des Stifts</translation>
    </message>
    <message>
        <source>There is no arm %1.</source>
        <translation>Einen Arm %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>State one to three positions.</source>
        <translation>Geben Sie ein bis drei Positionen an.</translation>
    </message>
    <message>
        <source>Around (%1, %2, %3) mm the arm cannot move 20 mm in every direction. Choose a position nearer to the middle of the workspace.</source>
        <translation>Um (%1, %2, %3) mm herum kann sich der Arm nicht in jede Richtung 20 mm weit bewegen. Wählen Sie eine Position näher an der Mitte des Arbeitsraums.</translation>
    </message>
    <message>
        <source>The stylus was not pressed down and let back slowly. Press it down by about 3 mm in two seconds, and let it come back just as slowly.</source>
        <translation>Der Stift wurde nicht langsam nach unten gedrückt und zurückgelassen. Drücken Sie ihn in zwei Sekunden etwa 3 mm weit, und lassen Sie ihn ebenso langsam zurückkommen.</translation>
    </message>
    <message>
        <source>turret</source>
        <translation>Drehturm</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Oberschenkel</translation>
    </message>
    <message>
        <source>shin</source>
        <translation>Unterschenkel</translation>
    </message>
    <message>
        <source>gimbal 1</source>
        <translation>Kardan 1</translation>
    </message>
    <message>
        <source>gimbal 2</source>
        <translation>Kardan 2</translation>
    </message>
    <message>
        <source>gimbal 3</source>
        <translation>Kardan 3</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 entlang %2</translation>
    </message>
    <message>
        <source>Stiffness in a slow press</source>
        <translation>Steifigkeit beim langsamen Drücken</translation>
    </message>
    <message>
        <source>Hysteresis of the press</source>
        <translation>Hysterese beim Drücken</translation>
    </message>
    <message>
        <source>Linear up to the clamp, at</source>
        <translation>Linear bis zur Begrenzung, bei</translation>
    </message>
    <message>
        <source>Linear at least up to</source>
        <translation>Linear mindestens bis</translation>
    </message>
    <message>
        <source>Stiffness of a free swing along %1</source>
        <translation>Steifigkeit einer freien Schwingung entlang %1</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Counts per turn, %1</source>
        <translation>Schritte je Umdrehung, %1</translation>
    </message>
    <message>
        <source>Noise of the tip at rest</source>
        <translation>Rauschen der Spitze in Ruhe</translation>
    </message>
    <message>
        <source>Noise of the tip in slow motion</source>
        <translation>Rauschen der Spitze in langsamer Bewegung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>The text ends too early: a value was expected.</source>
        <translation>Der Text endet zu früh: Hier wurde ein Wert erwartet.</translation>
    </message>
    <message>
        <source>There is a comma before this bracket; remove it, or write another value after it.</source>
        <translation>Vor dieser Klammer steht ein Komma; entfernen Sie es, oder schreiben Sie noch einen Wert dahinter.</translation>
    </message>
    <message>
        <source>Text must be in double quotes, not in single ones.</source>
        <translation>Text muss in doppelten Anführungszeichen stehen, nicht in einfachen.</translation>
    </message>
    <message>
        <source>JSON has no comments; remove this.</source>
        <translation>In JSON gibt es keine Kommentare; entfernen Sie dies.</translation>
    </message>
    <message>
        <source>A value was expected; %1 is not one. Numbers look like 0.5, -3 or 1e-3; text is in double quotes.</source>
        <translation>Hier wurde ein Wert erwartet; %1 ist keiner. Zahlen sehen aus wie 0.5, -3 oder 1e-3; Text steht in doppelten Anführungszeichen.</translation>
    </message>
    <message>
        <source>A value was expected: a number, text in double quotes, a list in [ ] or an object in { }.</source>
        <translation>Hier wurde ein Wert erwartet: eine Zahl, Text in doppelten Anführungszeichen, eine Liste in [ ] oder ein Objekt in { }.</translation>
    </message>
    <message>
        <source>The text ends too early: a key in double quotes or a } was expected.</source>
        <translation>Der Text endet zu früh: Hier wurde ein Schlüssel in doppelten Anführungszeichen oder eine } erwartet.</translation>
    </message>
    <message>
        <source>There is a comma before this }; remove it, or write another key after it.</source>
        <translation>Vor dieser } steht ein Komma; entfernen Sie es, oder schreiben Sie noch einen Schlüssel dahinter.</translation>
    </message>
    <message>
        <source>A key in double quotes was expected.</source>
        <translation>Hier wurde ein Schlüssel in doppelten Anführungszeichen erwartet.</translation>
    </message>
    <message>
        <source>The text ends too early: a %1 is missing.</source>
        <translation>Der Text endet zu früh: Es fehlt eine %1.</translation>
    </message>
    <message>
        <source>A comma or a %1 was expected here.</source>
        <translation>Hier wurde ein Komma oder eine %1 erwartet.</translation>
    </message>
    <message>
        <source>This text is not closed: its second double quote is missing.</source>
        <translation>Dieser Text ist nicht abgeschlossen: Sein zweites Anführungszeichen fehlt.</translation>
    </message>
    <message>
        <source>This text does not end on its line: its second double quote is missing.</source>
        <translation>Dieser Text endet nicht in seiner Zeile: Sein zweites Anführungszeichen fehlt.</translation>
    </message>
    <message>
        <source>JSON does not know this escape; a backslash itself is written \\, a new line \n.</source>
        <translation>Diese Escape-Folge kennt JSON nicht; ein Backslash selbst wird als \\ geschrieben, eine neue Zeile als \n.</translation>
    </message>
    <message>
        <source>There is a control character in this text; a tab is written \t.</source>
        <translation>In diesem Text steht ein Steuerzeichen; ein Tabulator wird als \t geschrieben.</translation>
    </message>
    <message>
        <source>The file is empty; an object in { } was expected.</source>
        <translation>Die Datei ist leer; erwartet wurde ein Objekt in { }.</translation>
    </message>
    <message>
        <source>The text should end before this: all its brackets are closed.</source>
        <translation>Der Text sollte vor dieser Stelle enden: Alle Klammern sind geschlossen.</translation>
    </message>
    <message>
        <source>A colon was expected after the key.</source>
        <translation>Nach dem Schlüssel wurde ein Doppelpunkt erwartet.</translation>
    </message>
    <message>
        <source>Four digits of 0-9 and a-f are expected after \u.</source>
        <translation>Nach \u werden vier Zeichen aus 0-9 und a-f erwartet.</translation>
    </message>
    <message>
        <source>This \u escape is half of a pair; its other half is missing.</source>
        <translation>Diese Escape-Folge mit \u ist die Hälfte eines Paars; die andere Hälfte fehlt.</translation>
    </message>
    <message>
        <source>This is not text in UTF-8; save the file as UTF-8.</source>
        <translation>Dies ist kein Text in UTF-8; speichern Sie die Datei als UTF-8.</translation>
    </message>
    <message>
        <source>The file contains more than a million values; a scene is far smaller.</source>
        <translation>Die Datei enthält mehr als eine Million Werte; eine Szene ist weit kleiner.</translation>
    </message>
    <message>
        <source>Lists and objects are nested more than 64 levels deep here.</source>
        <translation>Listen und Objekte sind hier mehr als 64-fach verschachtelt.</translation>
    </message>
    <message>
        <source>A \u escape in this text is half of a pair; its other half is missing.</source>
        <translation>Eine Escape-Folge mit \u in diesem Text ist die Hälfte eines Paars; die andere Hälfte fehlt.</translation>
    </message>
    <message>
        <source>This must be %1; here it is %2.</source>
        <translation>Dies muss %1 sein; hier steht %2.</translation>
    </message>
    <message>
        <source>The file has %1 more problems.</source>
        <translation>Weitere Probleme in der Datei: %1.</translation>
    </message>
    <message>
        <source>The key "%1" is missing; %2 needs it.</source>
        <translation>Der Schlüssel „%1“ fehlt; er ist hier nötig (%2).</translation>
    </message>
    <message>
        <source>The key %1 appears a second time; the first is on line %2. Remove one of them.</source>
        <translation>Der Schlüssel %1 kommt hier zum zweiten Mal vor; der erste steht in Zeile %2. Entfernen Sie einen davon.</translation>
    </message>
    <message>
        <source>The key %1 is not known in %2. Known keys: %3.</source>
        <translation>Der Schlüssel %1 ist hier nicht bekannt (%2). Bekannte Schlüssel: %3.</translation>
    </message>
    <message>
        <source>The key %1 is not known in %2. Did you mean "%3"?</source>
        <translation>Der Schlüssel %1 ist hier nicht bekannt (%2). Meinten Sie „%3“?</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>%1 is not in this version of Underact.</source>
        <translation>%1 gibt es in dieser Version von Underact nicht.</translation>
    </message>
    <message>
        <source>This must be %1; here it has %2.</source>
        <translation>Dies muss %1 sein; hier sind es %2.</translation>
    </message>
    <message>
        <source>a list of 3 numbers, as in [0, 30, 0]</source>
        <translation>eine Liste von 3 Zahlen wie [0, 30, 0]</translation>
    </message>
    <message>
        <source>a list of 3 rows, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]</source>
        <translation>eine Liste von 3 Zeilen wie [[1, 0, 0], [0, 1, 0], [0, 0, 1]]</translation>
    </message>
    <message>
        <source>a row of 3 numbers</source>
        <translation>eine Zeile von 3 Zahlen</translation>
    </message>
    <message>
        <source>text in double quotes</source>
        <translation>Text in doppelten Anführungszeichen</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Mass, damping and gains must be 0 or above.</source>
        <translation>Masse, Dämpfung und Verstärkungen müssen 0 oder größer sein.</translation>
    </message>
    <message>
        <source>What is held has neither mass nor damping, so it would reach the target at once. Give it mass or damping.</source>
        <translation>Was gehalten wird, hat weder Masse noch Dämpfung, also wäre es sofort am Ziel. Geben Sie ihm Masse oder Dämpfung.</translation>
    </message>
    <message>
        <source>From there no single target is nearest. Start from another position.</source>
        <translation>Von dort aus ist kein einzelnes Ziel das nächste. Beginnen Sie an einer anderen Position.</translation>
    </message>
    <message>
        <source>The arm does not reach the target there. Start from another position.</source>
        <translation>Dort erreicht der Arm das Ziel nicht. Beginnen Sie an einer anderen Position.</translation>
    </message>
    <message>
        <source>The target moves while the tip approaches it. Start from another position.</source>
        <translation>Das Ziel bewegt sich, während sich die Spitze ihm nähert. Beginnen Sie an einer anderen Position.</translation>
    </message>
    <message>
        <source>The scene has no constraint "%1"; choose one of its names.</source>
        <translation>Die Szene hat keine Bindung „%1“; wählen Sie einen ihrer Namen.</translation>
    </message>
    <message>
        <source>The scene has %1 constraints; name the one to measure, such as "%2".</source>
        <translation>Die Szene hat %1 Bindungen; nennen Sie die zu messende, etwa „%2“.</translation>
    </message>
    <message>
        <source>"%1" is a wall: it pushes but never pulls, so it does not hold the tip at a target. Measure one whose side is "both".</source>
        <translation>„%1“ ist eine Wand: Sie drückt, zieht aber nie, hält die Spitze also nicht an einem Ziel. Messen Sie eine, deren Seite „both“ ist.</translation>
    </message>
    <message>
        <source>The arm does not reach the target after this step (%1). Make the step smaller, or step in the other direction.</source>
        <translation>Nach diesem Sprung erreicht der Arm das Ziel nicht (%1). Machen Sie den Sprung kleiner, oder springen Sie in die andere Richtung.</translation>
    </message>
    <message>
        <source>The constraint does not hold the tip along a straight step there%1: its target does not follow the whole step. Choose another axis, or start from another position.</source>
        <translation>Die Bindung hält die Spitze dort nicht entlang eines geraden Sprungs%1: Ihr Ziel folgt nicht dem ganzen Sprung. Wählen Sie eine andere Achse, oder beginnen Sie an einem anderen Ort.</translation>
    </message>
    <message>
        <source>The numerator has no coefficients; for the number 1, write 1.</source>
        <translation>Der Zähler hat keine Koeffizienten; für die Zahl 1 schreiben Sie 1.</translation>
    </message>
    <message>
        <source>A coefficient of the numerator is not a finite number.</source>
        <translation>Ein Koeffizient des Zählers ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>A coefficient of the denominator is not a finite number.</source>
        <translation>Ein Koeffizient des Nenners ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The denominator has no s; give at least two coefficients, such as 1,1 for s + 1.</source>
        <translation>Der Nenner enthält kein s; geben Sie mindestens zwei Koeffizienten an, etwa 1,1 für s + 1.</translation>
    </message>
    <message>
        <source>The denominator is of order %1; at most %2 is possible.</source>
        <translation>Der Nenner hat die Ordnung %1; möglich ist höchstens %2.</translation>
    </message>
    <message>
        <source>The numerator is of a higher order than the denominator (%1 against %2), so a step would give an impulse. Lower its order.</source>
        <translation>Der Zähler hat eine höhere Ordnung als der Nenner (%1 gegen %2), sodass ein Sprung einen Impuls ergäbe. Verringern Sie seine Ordnung.</translation>
    </message>
    <message>
        <source>%1; it should be %2</source>
        <translation>%1; Soll: %2</translation>
    </message>
    <message>
        <source>Held for %1 of %2 s.</source>
        <translation>%1 von %2 s gehalten.</translation>
    </message>
    <message>
        <source>%1 of %2 reached.</source>
        <translation>%1 von %2 erreicht.</translation>
    </message>
    <message>
        <source>Still to reach: %1, to within %2. %3.</source>
        <translation>Noch offen: %1, auf %2 genau. %3.</translation>
    </message>
    <message>
        <source>%1 moved through %2; required: %3.</source>
        <translation>%1: %2 zurückgelegt, %3 nötig.</translation>
    </message>
    <message>
        <source>%1 crossed %2 %3 of %4 times within %5 s.</source>
        <translation>%1 ging innerhalb von %5 s %3 von %4 Mal durch %2.</translation>
    </message>
    <message>
        <source>Type your answer.</source>
        <translation>Geben Sie Ihre Antwort ein.</translation>
    </message>
    <message>
        <source>Choose an answer.</source>
        <translation>Wählen Sie eine Antwort.</translation>
    </message>
    <message>
        <source>Required at the same time: %1 %2; now %3.</source>
        <translation>Zugleich verlangt: %1 %2; jetzt %3.</translation>
    </message>
    <message>
        <source>%1 is correct.</source>
        <translation>%1 ist richtig.</translation>
    </message>
    <message>
        <source>%1 is not correct. Try again.</source>
        <translation>%1 ist nicht richtig. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 is not measured yet</source>
        <translation>%1 ist noch nicht gemessen</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>within %1 of %2</source>
        <translation>höchstens %1 neben %2</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>The tip</source>
        <translation>Die Spitze</translation>
    </message>
    <message>
        <source>The tip in B</source>
        <translation>Die Spitze in B</translation>
    </message>
    <message>
        <source>The velocity</source>
        <translation>Die Geschwindigkeit</translation>
    </message>
    <message>
        <source>The speed</source>
        <translation>Das Tempo</translation>
    </message>
    <message>
        <source>The direction of the stylus</source>
        <translation>Die Richtung des Stifts</translation>
    </message>
    <message>
        <source>Joint angle</source>
        <translation>Gelenkwinkel</translation>
    </message>
    <message>
        <source>Device angle</source>
        <translation>Gerätewinkel</translation>
    </message>
    <message>
        <source>The solution</source>
        <translation>Die Lösung</translation>
    </message>
    <message>
        <source>The number of inverse solutions</source>
        <translation>Die Anzahl der inversen Lösungen</translation>
    </message>
    <message>
        <source>The number of solutions within the limits</source>
        <translation>Die Anzahl der Lösungen innerhalb der Grenzen</translation>
    </message>
    <message>
        <source>The determinant of J_p</source>
        <translation>Die Determinante von J_p</translation>
    </message>
    <message>
        <source>The manipulability</source>
        <translation>Die Manipulierbarkeit</translation>
    </message>
    <message>
        <source>The singular value of J_p</source>
        <translation>Der Singulärwert von J_p</translation>
    </message>
    <message>
        <source>The distance from axis 1</source>
        <translation>Der Abstand von Achse 1</translation>
    </message>
    <message>
        <source>The distance from a stretched or folded elbow</source>
        <translation>Der Abstand vom gestreckten oder gefalteten Ellbogen</translation>
    </message>
    <message>
        <source>The distance from aligned axes 4 and 6</source>
        <translation>Der Abstand von der Flucht der Achsen 4 und 6</translation>
    </message>
    <message>
        <source>The distance to the nearest joint limit</source>
        <translation>Der Abstand zur nächsten Gelenkgrenze</translation>
    </message>
    <message>
        <source>The force</source>
        <translation>Die Kraft</translation>
    </message>
    <message>
        <source>The commanded force</source>
        <translation>Die verlangte Kraft</translation>
    </message>
    <message>
        <source>Joint torque</source>
        <translation>Gelenkmoment</translation>
    </message>
    <message>
        <source>The error</source>
        <translation>Der Fehler</translation>
    </message>
    <message>
        <source>The displacement from target to tip</source>
        <translation>Der Weg vom Ziel zur Spitze</translation>
    </message>
    <message>
        <source>The stiffness felt</source>
        <translation>Die gefühlte Steifigkeit</translation>
    </message>
    <message>
        <source>The angle between the force and the direction to the target</source>
        <translation>Der Winkel zwischen der Kraft und der Richtung zum Ziel</translation>
    </message>
    <message>
        <source>The force that the limits take off</source>
        <translation>Die Kraft, die die Grenzen wegnehmen</translation>
    </message>
    <message>
        <source>The energy</source>
        <translation>Die Energie</translation>
    </message>
    <message>
        <source>The damping force of the passivity controller</source>
        <translation>Die Dämpfungskraft des Passivitätsreglers</translation>
    </message>
    <message>
        <source>The stiffness kp</source>
        <translation>Die Steifigkeit kp</translation>
    </message>
    <message>
        <source>The damping kd</source>
        <translation>Die Dämpfung kd</translation>
    </message>
    <message>
        <source>The influence factor t</source>
        <translation>Der Einflussfaktor t</translation>
    </message>
    <message>
        <source>The angle about the shape's axis</source>
        <translation>Der Winkel um die Achse der Form</translation>
    </message>
    <message>
        <source>The virtual robot's joint</source>
        <translation>Das Gelenk des virtuellen Roboters</translation>
    </message>
    <message>
        <source>The robot's energy</source>
        <translation>Die Energie des Roboters</translation>
    </message>
    <message>
        <source>The moment that is not sent</source>
        <translation>Das Moment, das nicht gesendet wird</translation>
    </message>
    <message>
        <source>The stylus button</source>
        <translation>Die Stifttaste</translation>
    </message>
    <message>
        <source>The scene "%1" has no %2: none of its constraints has an influence.</source>
        <translation>In der Szene „%1“ gibt es %2 nicht: Keine ihrer Bindungen hat einen Einfluss.</translation>
    </message>
    <message>
        <source>The scene "%1" has no %2: none of its constraints is a virtual robot.</source>
        <translation>In der Szene „%1“ gibt es %2 nicht: Keine ihrer Bindungen ist ein virtueller Roboter.</translation>
    </message>
    <message>
        <source>The scene "%1" has no %2: its passivity is "off", so its energy is not observed.</source>
        <translation>In der Szene „%1“ gibt es %2 nicht: Ihre Passivität ist „off“, daher wird ihre Energie nicht beobachtet.</translation>
    </message>
    <message>
        <source>This must be the number 1, the version of lesson files.</source>
        <translation>Dies muss die Zahl 1 sein, die Version von Lektionsdateien.</translation>
    </message>
    <message>
        <source>a list of names</source>
        <translation>eine Liste von Namen</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>a list of checks</source>
        <translation>eine Liste von Prüfungen</translation>
    </message>
    <message>
        <source>A step has at most %1 checks.</source>
        <translation>Ein Schritt hat höchstens %1 Prüfungen.</translation>
    </message>
    <message>
        <source>The first step has none before it.</source>
        <translation>Vor dem ersten Schritt ist keiner.</translation>
    </message>
    <message>
        <source>a list of numbers</source>
        <translation>eine Liste von Zahlen</translation>
    </message>
    <message>
        <source>A pose has 1 to %1 joints.</source>
        <translation>Eine Lage hat 1 bis %1 Gelenke.</translation>
    </message>
    <message>
        <source>a step in { }</source>
        <translation>ein Schritt in { }</translation>
    </message>
    <message>
        <source>a step</source>
        <translation>ein Schritt</translation>
    </message>
    <message>
        <source>Name a scene, as in "02_sphere" or "my_scene.json".</source>
        <translation>Nennen Sie eine Szene, etwa „02_sphere“ oder „meine_szene.json“.</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>a list of steps</source>
        <translation>eine Liste von Schritten</translation>
    </message>
    <message>
        <source>A lesson has 1 to %1 steps.</source>
        <translation>Eine Lektion hat 1 bis %1 Schritte.</translation>
    </message>
    <message>
        <source>a lesson</source>
        <translation>eine Lektion</translation>
    </message>
    <message>
        <source>This must be at least %1.</source>
        <translation>Dies muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>The quantity %1 has the parts 1 to %2.</source>
        <translation>Die Messgröße %1 hat die Teile 1 bis %2.</translation>
    </message>
    <message>
        <source>a list of %1 numbers</source>
        <translation>eine Liste von %1 Zahlen</translation>
    </message>
    <message>
        <source>a number, or null for any value</source>
        <translation>eine Zahl, oder null für einen beliebigen Wert</translation>
    </message>
    <message>
        <source>Give a range ("above", "below" or both), or a value ("near" with "within").</source>
        <translation>Geben Sie einen Bereich an ("above", "below" oder beide) oder einen Wert ("near" mit "within").</translation>
    </message>
    <message>
        <source>"above" must be less than "below".</source>
        <translation>„above“ muss kleiner sein als „below“.</translation>
    </message>
    <message>
        <source>a list of conditions</source>
        <translation>eine Liste von Bedingungen</translation>
    </message>
    <message>
        <source>a condition in { }</source>
        <translation>eine Bedingung in { }</translation>
    </message>
    <message>
        <source>a condition</source>
        <translation>eine Bedingung</translation>
    </message>
    <message>
        <source>a list of values</source>
        <translation>eine Liste von Werten</translation>
    </message>
    <message>
        <source>Give 1 to %1 values.</source>
        <translation>Geben Sie 1 bis %1 Werte an.</translation>
    </message>
    <message>
        <source>The quantity %1 has %2 values here; choose one with "part".</source>
        <translation>Die Messgröße %1 hat hier %2 Werte; wählen Sie einen mit "part".</translation>
    </message>
    <message>
        <source>The answer is either measured or given: remove "measure" or "answer".</source>
        <translation>Die Antwort wird entweder gemessen oder angegeben: Entfernen Sie "measure" oder "answer".</translation>
    </message>
    <message>
        <source>a list of answers</source>
        <translation>eine Liste von Antworten</translation>
    </message>
    <message>
        <source>Give 2 to 9 answers to choose from.</source>
        <translation>Geben Sie 2 bis 9 Antworten zur Wahl.</translation>
    </message>
    <message>
        <source>This must be the number of the right answer, 1 to %1.</source>
        <translation>Dies muss die Nummer der richtigen Antwort sein, 1 bis %1.</translation>
    </message>
    <message>
        <source>a list of misconceptions</source>
        <translation>eine Liste von Fehlvorstellungen</translation>
    </message>
    <message>
        <source>a misconception</source>
        <translation>eine Fehlvorstellung</translation>
    </message>
    <message>
        <source>This must be a wrong answer to the question.</source>
        <translation>Dies muss eine falsche Antwort auf die Frage sein.</translation>
    </message>
    <message>
        <source>a check in { }</source>
        <translation>eine Prüfung in { }</translation>
    </message>
    <message>
        <source>a check</source>
        <translation>eine Prüfung</translation>
    </message>
    <message>
        <source>the name of a %1</source>
        <translation>ein bekannter Name (%1)</translation>
    </message>
    <message>
        <source>There is no %1 %2. There are %3.</source>
        <translation>Nicht bekannt: %1 %2. Bekannt sind: %3.</translation>
    </message>
    <message>
        <source>There is no %1 %2. Did you mean "%3"?</source>
        <translation>Nicht bekannt: %1 %2. Meinten Sie „%3“?</translation>
    </message>
    <message>
        <source>This must be one line of text, not empty.</source>
        <translation>Dies muss eine nicht leere Zeile Text sein.</translation>
    </message>
    <message>
        <source>text in double quotes, or a list of its lines</source>
        <translation>Text in doppelten Anführungszeichen, oder eine Liste seiner Zeilen</translation>
    </message>
    <message>
        <source>The text is empty.</source>
        <translation>Der Text ist leer.</translation>
    </message>
    <message>
        <source>This is longer than %1 bytes.</source>
        <translation>Dies ist länger als %1 Bytes.</translation>
    </message>
    <message>
        <source>This must be from 0 to %1.</source>
        <translation>Dies muss zwischen 0 und %1 liegen.</translation>
    </message>
    <message>
        <source>a report</source>
        <translation>ein Bericht</translation>
    </message>
    <message>
        <source>This must be the number 1, the version of reports.</source>
        <translation>Dies muss die Zahl 1 sein, die Version der Berichte.</translation>
    </message>
    <message>
        <source>This page is no report of a lesson, or one of an earlier version, which has no data for a table.</source>
        <translation>Diese Seite ist kein Bericht einer Lektion, oder einer aus einer früheren Version, der keine Daten für eine Tabelle enthält.</translation>
    </message>
    <message>
        <source>This folder holds more than %1 pages. Put the reports of one class into a folder of their own.</source>
        <translation>Dieser Ordner enthält mehr als %1 Seiten. Legen Sie die Berichte einer Klasse in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>The folder cannot be read: %1.</source>
        <translation>Der Ordner kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>%1 has a later report of this lesson, %2, which counts.</source>
        <translation>%1 hat einen späteren Bericht dieser Lektion, %2; dieser zählt.</translation>
    </message>
    <message>
        <source>The scene has an error: %1</source>
        <translation>Die Szene hat einen Fehler: %1</translation>
    </message>
    <message>
        <source>A virtual robot has at most %1 joints, not %2.</source>
        <translation>Ein virtueller Roboter hat höchstens %1 Gelenke, nicht %2.</translation>
    </message>
    <message>
        <source>A stiffness must be 0 or above.</source>
        <translation>Eine Steifigkeit muss 0 oder größer sein.</translation>
    </message>
    <message>
        <source>The rest position of a joint's spring is not a finite number.</source>
        <translation>Die Ruhelage der Feder eines Gelenks ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The solver takes 1 to 100 steps.</source>
        <translation>Der Löser macht 1 bis 100 Schritte.</translation>
    </message>
    <message>
        <source>The solver's tolerance must be above 0 and at most 0.01.</source>
        <translation>Die Toleranz des Lösers muss über 0 liegen und darf höchstens 0,01 sein.</translation>
    </message>
    <message>
        <source>The thesis's force law needs a chain with just one joint, a revolute one.</source>
        <translation>Das Kraftgesetz der Thesis braucht eine Kette mit nur einem Gelenk, einem Drehgelenk.</translation>
    </message>
    <message>
        <source>The orientation "angle" needs a chain with just one revolute joint.</source>
        <translation>Die Orientierung „angle“ braucht eine Kette mit genau einem Drehgelenk.</translation>
    </message>
    <message>
        <source>In the home pose the tip's z axis lies along the joint's axis, so it has no angle about that axis.</source>
        <translation>In der Grundstellung liegt die z-Achse der Spitze entlang der Achse des Gelenks und hat daher keinen Winkel um sie.</translation>
    </message>
    <message>
        <source>There is no closed form for this chain with these gains and this orientation; use the method "auto" or "iterative".</source>
        <translation>Für diese Kette gibt es mit diesen Verstärkungen und dieser Orientierung keine geschlossene Form; benutzen Sie die Methode „auto“ oder „iterative“.</translation>
    </message>
    <message>
        <source>The mesh has no triangles.</source>
        <translation>Das Dreiecksnetz hat keine Dreiecke.</translation>
    </message>
    <message>
        <source>The mesh has more than 134 million triangles.</source>
        <translation>Das Dreiecksnetz hat mehr als 134 Millionen Dreiecke.</translation>
    </message>
    <message>
        <source>A vertex of the mesh is not a finite point.</source>
        <translation>Eine Ecke des Dreiecksnetzes ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>A triangle refers to a vertex that does not exist.</source>
        <translation>Ein Dreieck verweist auf eine Ecke, die es nicht gibt.</translation>
    </message>
    <message>
        <source>A triangle has the same vertex twice.</source>
        <translation>Ein Dreieck hat dieselbe Ecke zweimal.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The file is truncated or damaged: it declares %1, but is too short for that.</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt: Sie gibt %1 an und ist dafür zu kurz.</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>This is not a PLY file: it does not begin with "ply".</source>
        <translation>Dies ist keine PLY-Datei: Sie beginnt nicht mit „ply“.</translation>
    </message>
    <message>
        <source>This is not an OFF file: it does not begin with "OFF".</source>
        <translation>Dies ist keine OFF-Datei: Sie beginnt nicht mit „OFF“.</translation>
    </message>
    <message>
        <source>This is not a mesh that can be read. Use an STL, OBJ, PLY or OFF file.</source>
        <translation>Dies ist kein lesbares Dreiecksnetz. Verwenden Sie eine STL-, OBJ-, PLY- oder OFF-Datei.</translation>
    </message>
    <message>
        <source>a binary STL mesh</source>
        <translation>ein binäres STL-Dreiecksnetz</translation>
    </message>
    <message>
        <source>The file contains no faces.</source>
        <translation>Die Datei enthält keine Flächen.</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>ein Dreiecksnetz</translation>
    </message>
    <message>
        <source>The file is larger than 4 GiB. Make the mesh coarser, or save it in parts.</source>
        <translation>Die Datei ist größer als 4 GiB. Machen Sie das Dreiecksnetz gröber, oder speichern Sie es in Teilen.</translation>
    </message>
    <message>
        <source>The file contains nothing to feel.</source>
        <translation>In der Datei gibt es nichts zu fühlen.</translation>
    </message>
    <message>
        <source>The OFF header is damaged: it does not begin with "OFF".</source>
        <translation>Der OFF-Kopf ist beschädigt: Er beginnt nicht mit „OFF“.</translation>
    </message>
    <message>
        <source>The mesh in the OFF file is not three-dimensional.</source>
        <translation>Das Dreiecksnetz in der OFF-Datei ist nicht dreidimensional.</translation>
    </message>
    <message>
        <source>This is a binary OFF file, which cannot be read. Save it as text, or as STL or PLY.</source>
        <translation>Dies ist eine binäre OFF-Datei, die nicht gelesen werden kann. Speichern Sie sie als Text, oder als STL oder PLY.</translation>
    </message>
    <message>
        <source>The OFF file contains points but no faces. A surface needs faces.</source>
        <translation>Die OFF-Datei enthält Punkte, aber keine Flächen. Eine Oberfläche braucht Flächen.</translation>
    </message>
    <message>
        <source>The OFF header is damaged: the numbers of vertices and faces cannot be read.</source>
        <translation>Der OFF-Kopf ist beschädigt: Die Anzahlen der Ecken und Flächen sind nicht lesbar.</translation>
    </message>
    <message>
        <source>The PLY file contains no vertices (element vertex).</source>
        <translation>Die PLY-Datei enthält keine Ecken (vertex).</translation>
    </message>
    <message>
        <source>The PLY file contains triangle strips, which cannot be read. Save it with single faces.</source>
        <translation>Die PLY-Datei enthält Dreiecksstreifen, die nicht gelesen werden können. Speichern Sie sie mit einzelnen Flächen.</translation>
    </message>
    <message>
        <source>The PLY file contains points but no faces. A surface needs faces: create them in the program that made the points.</source>
        <translation>Die PLY-Datei enthält Punkte, aber keine Flächen. Eine Oberfläche braucht Flächen: Erzeugen Sie sie in dem Programm, aus dem die Punkte kommen.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: it declares vertices or faces twice.</source>
        <translation>Der PLY-Kopf ist beschädigt: Er nennt Ecken oder Flächen zweimal.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: the vertices do not have exactly one %1.</source>
        <translation>Der PLY-Kopf ist beschädigt: Die Ecken haben nicht genau ein %1.</translation>
    </message>
    <message>
        <source>The PLY file contains %1 of its vertices as integers. Save it with float or double coordinates.</source>
        <translation>Die PLY-Datei enthält %1 ihrer Ecken als ganze Zahlen. Speichern Sie sie mit Koordinaten in float oder double.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: the faces do not have exactly one list of vertices (vertex_indices).</source>
        <translation>Der PLY-Kopf ist beschädigt: Die Flächen haben nicht genau eine Liste von Ecken (vertex_indices).</translation>
    </message>
    <message>
        <source>The PLY header is damaged: it does not begin with "ply".</source>
        <translation>Der PLY-Kopf ist beschädigt: Er beginnt nicht mit „ply“.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: it has no line "format".</source>
        <translation>Der PLY-Kopf ist beschädigt: Er hat keine Zeile „format“.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: line %1 is not valid.</source>
        <translation>Der PLY-Kopf ist beschädigt: Zeile %1 ist ungültig.</translation>
    </message>
    <message>
        <source>The PLY header is damaged: it has no end.</source>
        <translation>Der PLY-Kopf ist beschädigt: Er hat kein Ende.</translation>
    </message>
    <message>
        <source>The file cannot be read: the reader program exited with %1.</source>
        <translation>Die Datei kann nicht gelesen werden: Das Leseprogramm endete mit %1.</translation>
    </message>
    <message>
        <source>The file is damaged: the reader program crashed (signal %1).</source>
        <translation>Die Datei ist beschädigt: Das Leseprogramm ist abgestürzt (Signal %1).</translation>
    </message>
    <message>
        <source>The file is damaged, or has very large faces: reading it took longer than %1, which is enough for a file of its size.</source>
        <translation>Die Datei ist beschädigt oder hat sehr große Flächen: Das Lesen dauerte länger als %1, was für eine Datei ihrer Größe genügt.</translation>
    </message>
    <message>
        <source>The file is damaged: it declares more faces than a file of its size can hold.</source>
        <translation>Die Datei ist beschädigt: Sie gibt mehr Flächen an, als eine Datei ihrer Größe fassen kann.</translation>
    </message>
    <message>
        <source>It reads meshes: reinstall Underact.</source>
        <translation>Es liest Netze: Installieren Sie Underact neu.</translation>
    </message>
    <message>
        <source>The file is damaged: the reader program could not make a mesh of it.</source>
        <translation>Die Datei ist beschädigt: Das Leseprogramm konnte kein Dreiecksnetz daraus machen.</translation>
    </message>
    <message>
        <source>The file changed while it was being read. Open it again.</source>
        <translation>Die Datei wurde geändert, während sie gelesen wurde. Öffnen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The file declares %1 faces, but has the length of %2: these were read.</source>
        <translation>Die Datei gibt %1 Flächen an, hat aber die Länge von %2: Diese wurden gelesen.</translation>
    </message>
    <message>
        <source>What belongs to no face was skipped: %1 B.</source>
        <translation>Was zu keiner Fläche gehört, wurde übersprungen: %1 B.</translation>
    </message>
    <message>
        <source>%1 face was left out: one of its vertices is not a finite point.</source>
        <translation>%1 Fläche wurde weggelassen: Eine ihrer Ecken ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>%1 faces were left out: they have vertices that are not finite points.</source>
        <translation>%1 Flächen wurden weggelassen: Sie haben Ecken, die keine endlichen Punkte sind.</translation>
    </message>
    <message>
        <source>%1 face was left out: it refers to a vertex that is not in the file.</source>
        <translation>%1 Fläche wurde weggelassen: Sie verweist auf eine Ecke, die nicht in der Datei steht.</translation>
    </message>
    <message>
        <source>%1 faces were left out: they refer to vertices that are not in the file.</source>
        <translation>%1 Flächen wurden weggelassen: Sie verweisen auf Ecken, die nicht in der Datei stehen.</translation>
    </message>
    <message>
        <source>%1 face was left out: it has no extent.</source>
        <translation>%1 Fläche wurde weggelassen: Sie hat keine Ausdehnung.</translation>
    </message>
    <message>
        <source>%1 faces were left out: they have no extent.</source>
        <translation>%1 Flächen wurden weggelassen: Sie haben keine Ausdehnung.</translation>
    </message>
    <message>
        <source>%1 face was left out: it is a duplicate.</source>
        <translation>%1 Fläche wurde weggelassen: Sie kommt doppelt vor.</translation>
    </message>
    <message>
        <source>%1 faces were left out: they are duplicates.</source>
        <translation>%1 Flächen wurden weggelassen: Sie kommen mehrfach vor.</translation>
    </message>
    <message>
        <source>%1 vertex was merged with others at the same position, or nearer than %2.</source>
        <translation>%1 Ecke wurde mit anderen am selben Ort oder näher als %2 vereinigt.</translation>
    </message>
    <message>
        <source>%1 vertices were merged with others at the same position, or nearer than %2.</source>
        <translation>%1 Ecken wurden mit anderen am selben Ort oder näher als %2 vereinigt.</translation>
    </message>
    <message>
        <source>%1 vertex lies on an edge of another face. This face was divided there: the seam is no hole.</source>
        <translation>%1 Ecke liegt auf einer Kante einer anderen Fläche. Diese Fläche wurde dort geteilt: Die Naht ist kein Loch.</translation>
    </message>
    <message>
        <source>%1 vertices lie on edges of other faces. These faces were divided there: seams are no holes.</source>
        <translation>%1 Ecken liegen auf Kanten anderer Flächen. Diese Flächen wurden dort geteilt: Nähte sind keine Löcher.</translation>
    </message>
    <message>
        <source>%1 face was turned over so that neighbours agree on which side is outside.</source>
        <translation>%1 Fläche wurde umgedreht, damit Nachbarn sich einig sind, welche Seite außen ist.</translation>
    </message>
    <message>
        <source>%1 faces were turned over so that neighbours agree on which side is outside.</source>
        <translation>%1 Flächen wurden umgedreht, damit Nachbarn sich einig sind, welche Seite außen ist.</translation>
    </message>
    <message>
        <source>Most normals in the file point against the order of the vertices. Only the order counts here: if outside and inside feel swapped, save the mesh with its faces turned over.</source>
        <translation>Die meisten Normalen in der Datei zeigen gegen die Reihenfolge der Ecken. Hier gilt nur die Reihenfolge: Fühlen sich außen und innen vertauscht an, so speichern Sie das Dreiecksnetz mit umgedrehten Flächen.</translation>
    </message>
    <message>
        <source>The surface is open: %1 border, %2 long. The stylus can pass through the hole.</source>
        <translation>Die Oberfläche ist offen: %1 Rand, %2 lang. Der Stift kann durch das Loch gehen.</translation>
    </message>
    <message>
        <source>The surface is open: %1 borders, the longest %2 long. The stylus can pass through a hole.</source>
        <translation>Die Oberfläche ist offen: %1 Ränder, der längste %2 lang. Der Stift kann durch ein Loch gehen.</translation>
    </message>
    <message>
        <source>%1 edge has more than two faces.</source>
        <translation>%1 Kante hat mehr als zwei Flächen.</translation>
    </message>
    <message>
        <source>%1 edges have more than two faces.</source>
        <translation>%1 Kanten haben mehr als zwei Flächen.</translation>
    </message>
    <message>
        <source>The surface has no outside: at %1 edge its faces cannot agree, as on a Möbius strip.</source>
        <translation>Die Oberfläche hat kein Außen: An %1 Kante können sich ihre Flächen nicht einigen, wie auf einem Möbiusband.</translation>
    </message>
    <message>
        <source>The surface has no outside: at %1 edges its faces cannot agree, as on a Möbius strip.</source>
        <translation>Die Oberfläche hat kein Außen: An %1 Kanten können sich ihre Flächen nicht einigen, wie auf einem Möbiusband.</translation>
    </message>
    <message>
        <source>The check for self-intersection was left out or not completed: there are too many faces, or too many near each other.</source>
        <translation>Ob die Oberfläche sich selbst durchdringt, wurde nicht oder nicht vollständig geprüft: Sie hat zu viele Flächen, oder zu viele nahe beieinander.</translation>
    </message>
    <message>
        <source>%1 face is as narrow as a line. It is kept because such faces close seams.</source>
        <translation>%1 Fläche ist so schmal wie eine Linie. Sie bleibt erhalten, weil solche Flächen Nähte schließen.</translation>
    </message>
    <message>
        <source>%1 faces are as narrow as a line. They are kept because such faces close seams.</source>
        <translation>%1 Flächen sind so schmal wie eine Linie. Sie bleiben erhalten, weil solche Flächen Nähte schließen.</translation>
    </message>
    <message>
        <source>Part of it is thin, %1 on average: felt from both sides, it may let the stylus through; a wall does not.</source>
        <translation>Ein Teil davon ist dünn, im Mittel %1: Von beiden Seiten gefühlt, lässt er den Stift vielleicht hindurch; eine Wand nicht.</translation>
    </message>
    <message>
        <source>The mesh is closed: it can be felt from both sides, or as a wall from outside or inside.</source>
        <translation>Das Dreiecksnetz ist geschlossen: Es lässt sich von beiden Seiten fühlen, oder als Wand von außen oder innen.</translation>
    </message>
    <message>
        <source>The mesh can be felt from both sides only: %1.</source>
        <translation>Das Dreiecksnetz lässt sich nur von beiden Seiten fühlen: %1.</translation>
    </message>
    <message>
        <source>The mesh consists of %1 separate parts.</source>
        <translation>Das Dreiecksnetz besteht aus %1 Teilen, die nicht zusammenhängen.</translation>
    </message>
    <message>
        <source>The mesh consists of %1 separate parts, %2 inside others.</source>
        <translation>Das Dreiecksnetz besteht aus %1 Teilen, die nicht zusammenhängen, %2 davon in anderen.</translation>
    </message>
    <message>
        <source>%1 of these is a hollow, which is felt from within.</source>
        <translation>%1 davon ist ein Hohlraum, der von innen gefühlt wird.</translation>
    </message>
    <message>
        <source>%1 of these are hollows, which are felt from within.</source>
        <translation>%1 davon sind Hohlräume, die von innen gefühlt werden.</translation>
    </message>
    <message>
        <source>%1 hole with a border of %2 was closed, so that the mesh has an inside.</source>
        <translation>%1 Loch mit einem Rand von %2 wurde geschlossen, damit das Dreiecksnetz ein Inneres hat.</translation>
    </message>
    <message>
        <source>%1 holes, the longest border %2, were closed, so that the mesh has an inside.</source>
        <translation>%1 Löcher, der längste Rand %2, wurden geschlossen, damit das Dreiecksnetz ein Inneres hat.</translation>
    </message>
    <message>
        <source>The mesh is so far from its origin that the single-precision numbers of the file have steps of %1: smaller details are lost. Save it nearer to its origin.</source>
        <translation>Das Dreiecksnetz ist so weit von seinem Ursprung entfernt, dass die Zahlen einfacher Genauigkeit in der Datei Stufen von %1 haben: Kleinere Einzelheiten sind verloren. Speichern Sie es näher an seinem Ursprung.</translation>
    </message>
    <message>
        <source>it has no faces</source>
        <translation>Es hat keine Flächen</translation>
    </message>
    <message>
        <source>it is open, so it has no inside</source>
        <translation>Es ist offen, hat also kein Inneres</translation>
    </message>
    <message>
        <source>its faces cannot agree on an outside</source>
        <translation>Die Außenseiten seiner Flächen passen nicht zusammen</translation>
    </message>
    <message>
        <source>edges with more than two faces leave the inside undefined</source>
        <translation>Kanten mit mehr als zwei Flächen lassen offen, was innen ist</translation>
    </message>
    <message>
        <source>it intersects itself too often to tell inside from outside</source>
        <translation>es durchdringt sich zu oft, um innen von außen zu unterscheiden</translation>
    </message>
    <message>
        <source>No face is left, so there is nothing to feel.</source>
        <translation>Es bleibt keine Fläche übrig: Es gibt nichts zu fühlen.</translation>
    </message>
    <message>
        <source>Read as millimetres, the mesh is %1 mm long.</source>
        <translation>Als Millimeter gelesen ist das Dreiecksnetz %1 mm lang.</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Metern</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimetern</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>Mikrometern</translation>
    </message>
    <message>
        <source>In %1 it would be %2 mm.</source>
        <translation>In %1 wären es %2 mm.</translation>
    </message>
    <message>
        <source>That is too small to feel: state a larger scale.</source>
        <translation>Das ist zu klein, um es zu fühlen: Geben Sie einen größeren Maßstab an.</translation>
    </message>
    <message>
        <source>That is far beyond the arm's reach: state a smaller scale.</source>
        <translation>Das ist weit jenseits der Reichweite des Arms: Geben Sie einen kleineren Maßstab an.</translation>
    </message>
    <message>
        <source>The surface intersects itself, at %1 pair of faces.</source>
        <translation>Die Oberfläche durchdringt sich selbst, bei %1 Flächenpaar.</translation>
    </message>
    <message>
        <source>The surface intersects itself, at %1 pairs of faces.</source>
        <translation>Die Oberfläche durchdringt sich selbst, bei %1 Flächenpaaren.</translation>
    </message>
    <message>
        <source>The surface intersects itself, at %1 pair of faces or more.</source>
        <translation>Die Oberfläche durchdringt sich selbst, bei mindestens %1 Flächenpaar.</translation>
    </message>
    <message>
        <source>The surface intersects itself, at %1 pairs of faces or more.</source>
        <translation>Die Oberfläche durchdringt sich selbst, bei mindestens %1 Flächenpaaren.</translation>
    </message>
    <message>
        <source>You feel the surface of the whole body, without walls inside it.</source>
        <translation>Sie fühlen die Oberfläche des ganzen Körpers, ohne Wände in seinem Inneren.</translation>
    </message>
    <message>
        <source>You feel the surface of the whole body, without walls inside it: %1 face there was left out.</source>
        <translation>Sie fühlen die Oberfläche des ganzen Körpers, ohne Wände in seinem Inneren: %1 Fläche dort wurde weggelassen.</translation>
    </message>
    <message>
        <source>You feel the surface of the whole body, without walls inside it: %1 faces there were left out.</source>
        <translation>Sie fühlen die Oberfläche des ganzen Körpers, ohne Wände in seinem Inneren: %1 Flächen dort wurden weggelassen.</translation>
    </message>
    <message>
        <source>Parts touch or contain each other.</source>
        <translation>Teile berühren oder enthalten einander.</translation>
    </message>
    <message>
        <source>Inside and outside cannot be distinguished.</source>
        <translation>Innen und außen lassen sich nicht unterscheiden.</translation>
    </message>
    <message>
        <source>The recording cannot be started: %1.</source>
        <translation>Die Aufzeichnung kann nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>The recording is incomplete: %1.</source>
        <translation>Die Aufzeichnung ist unvollständig: %1.</translation>
    </message>
    <message>
        <source>This is the session itself, which is not replaced. Give another name.</source>
        <translation>Das ist die Sitzung selbst, die nicht ersetzt wird. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>The fault cannot be written to a file: %1.</source>
        <translation>Die Störung kann nicht in eine Datei geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>the HDF5 library gives no reason</source>
        <translation>Die HDF5-Bibliothek nennt keinen Grund</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>a session</source>
        <translation>eine Sitzung</translation>
    </message>
    <message>
        <source>This session is incomplete: it has no table "%1".</source>
        <translation>Diese Sitzung ist unvollständig: Ihr fehlt die Tabelle „%1“.</translation>
    </message>
    <message>
        <source>This session is incomplete: the table "%1" is damaged.</source>
        <translation>Diese Sitzung ist unvollständig: Die Tabelle „%1“ ist beschädigt.</translation>
    </message>
    <message>
        <source>This file is truncated: it has %1 of %2 bytes. Copy it again from where it came.</source>
        <translation>Diese Datei ist abgeschnitten: Sie hat %1 von %2 Bytes. Kopieren Sie sie noch einmal von dort, wo sie herkam.</translation>
    </message>
    <message>
        <source>This is not a session, or its beginning is damaged.</source>
        <translation>Dies ist keine Sitzung, oder ihr Anfang ist beschädigt.</translation>
    </message>
    <message>
        <source>Another program is recording into this file. Give another name.</source>
        <translation>Ein anderes Programm zeichnet in diese Datei auf. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>Another program has this file open. Close it there first.</source>
        <translation>Ein anderes Programm hat diese Datei offen. Schließen Sie sie zuerst dort.</translation>
    </message>
    <message>
        <source>The file cannot be opened for writing: %1.</source>
        <translation>Die Datei kann nicht zum Schreiben geöffnet werden: %1.</translation>
    </message>
    <message>
        <source>Another file has taken this one's place in the meantime, so nothing was changed. Try again.</source>
        <translation>Inzwischen ist eine andere Datei an die Stelle dieser getreten; deshalb wurde nichts geändert. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The disk is full: the recording was stopped, and everything up to then was saved. Free some space, or record into another folder.</source>
        <translation>Der Datenträger ist voll: Die Aufzeichnung wurde gestoppt, und alles bis dahin wurde gespeichert. Schaffen Sie Platz, oder zeichnen Sie in einen anderen Ordner auf.</translation>
    </message>
    <message>
        <source>The recording stopped: %1.</source>
        <translation>Die Aufzeichnung wurde gestoppt: %1.</translation>
    </message>
    <message>
        <source>The file could not be trimmed to its intact part: %1.</source>
        <translation>Die Datei konnte nicht auf ihren unversehrten Teil gekürzt werden: %1.</translation>
    </message>
    <message>
        <source>The file cannot be changed: %1.</source>
        <translation>Die Datei lässt sich nicht ändern: %1.</translation>
    </message>
    <message>
        <source>The file is damaged, and the rest cannot be read.</source>
        <translation>Die Datei ist beschädigt, und der Rest ist nicht lesbar.</translation>
    </message>
    <message>
        <source>This file could not be deleted: %1.</source>
        <translation>Diese Datei konnte nicht gelöscht werden: %1.</translation>
    </message>
    <message>
        <source>The recording stopped: its file was moved or deleted.</source>
        <translation>Die Aufzeichnung wurde gestoppt: Ihre Datei wurde verschoben oder gelöscht.</translation>
    </message>
    <message>
        <source>The disk is nearly full: the recording was stopped, and everything up to then was saved. Free some space, or record into another folder.</source>
        <translation>Der Datenträger ist fast voll: Die Aufzeichnung wurde gestoppt, und alles bis dahin wurde gespeichert. Schaffen Sie Platz, oder zeichnen Sie in einen anderen Ordner auf.</translation>
    </message>
    <message>
        <source>The servo did not tick, so the recording is empty.</source>
        <translation>Der Servo machte keinen Takt; deshalb ist die Aufzeichnung leer.</translation>
    </message>
    <message>
        <source>Everything up to then was saved.</source>
        <translation>Alles bis dahin wurde gespeichert.</translation>
    </message>
    <message>
        <source>%1 ticks or events are missing in the recording: the computer was too busy to write them.</source>
        <translation>In der Aufzeichnung fehlen %1 Ticks oder Ereignisse: Der Computer war zu beschäftigt, um sie zu schreiben.</translation>
    </message>
    <message>
        <source>%1 markers are missing: the recording has as many as a session may have.</source>
        <translation>%1 Marken fehlen: Die Aufzeichnung hat so viele, wie eine Sitzung haben darf.</translation>
    </message>
    <message>
        <source>The session is as long as one may be: the recording goes on in %1.</source>
        <translation>Die Sitzung ist so lang, wie eine sein darf: Die Aufzeichnung geht in %1 weiter.</translation>
    </message>
    <message>
        <source>Ticks are missing in the recording: the computer is too busy to write them. The servo goes on.</source>
        <translation>In der Aufzeichnung fehlen Ticks: Der Computer ist zu beschäftigt, um sie zu schreiben. Der Servo läuft weiter.</translation>
    </message>
    <message>
        <source>Recovering takes a copy of the file in its folder, and there is none: %1. Nothing was changed.</source>
        <translation>Zum Wiederherstellen wird in ihrem Ordner eine Kopie der Datei angelegt, und das gelang nicht: %1. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>It cannot be recovered; nothing was changed.</source>
        <translation>Sie kann nicht wiederhergestellt werden; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The file is damaged from row %1 on, for %2 ticks; what follows cannot be replayed.</source>
        <translation>Die Datei ist ab Zeile %1 beschädigt, %2 Takte lang; was danach kommt, lässt sich nicht wiedergeben.</translation>
    </message>
    <message>
        <source>%1 ticks are missing after tick %2; what follows cannot be replayed.</source>
        <translation>%1 Takte fehlen nach Takt %2; was danach kommt, lässt sich nicht wiedergeben.</translation>
    </message>
    <message>
        <source>This session does not say which scene it began with.</source>
        <translation>Diese Sitzung sagt nicht, mit welcher Szene sie begann.</translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>This is an HDF5 file, but not a session of Underact.</source>
        <translation>Dies ist eine HDF5-Datei, aber keine Sitzung von Underact.</translation>
    </message>
    <message>
        <source>This session was recorded by a newer version of Underact. This version reads layout 1.</source>
        <translation>Diese Sitzung wurde mit einer neueren Version von Underact aufgezeichnet. Diese hier liest Aufbau 1.</translation>
    </message>
    <message>
        <source>This session does not state the rate of the servo: the file is damaged.</source>
        <translation>Diese Sitzung nennt die Taktrate des Servos nicht: Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The table "%1" of this session cannot be read: the file is damaged there.</source>
        <translation>Die Tabelle „%1“ dieser Sitzung kann nicht gelesen werden: Die Datei ist dort beschädigt.</translation>
    </message>
    <message>
        <source>The texts of this session cannot be read: the file is damaged there.</source>
        <translation>Die Texte dieser Sitzung können nicht gelesen werden: Die Datei ist dort beschädigt.</translation>
    </message>
    <message>
        <source>The servo's state at the beginning was recorded by a version with a different layout.</source>
        <translation>Der Zustand des Servos am Anfang wurde von einer Version mit einem anderen Aufbau aufgezeichnet.</translation>
    </message>
    <message>
        <source>The servo's state at the beginning of this session cannot be read: the file is damaged there.</source>
        <translation>Der Zustand des Servos am Anfang dieser Sitzung kann nicht gelesen werden: Die Datei ist dort beschädigt.</translation>
    </message>
    <message>
        <source>The recording was stopped: its table "%1" is as long as that of a session may be. Everything up to then was saved.</source>
        <translation>Die Aufzeichnung wurde beendet: Ihre Tabelle „%1“ ist so lang, wie die einer Sitzung sein darf. Alles bis dahin wurde gespeichert.</translation>
    </message>
    <message>
        <source>The servo's state at the beginning was not recorded completely.</source>
        <translation>Der Zustand des Servos am Anfang wurde nicht vollständig aufgezeichnet.</translation>
    </message>
    <message>
        <source>The servo's state at the beginning of this session is not valid: the file is damaged, or was changed.</source>
        <translation>Der Zustand des Servos am Anfang dieser Sitzung ist ungültig: Die Datei ist beschädigt oder wurde verändert.</translation>
    </message>
    <message>
        <source>The file is damaged: reading a part of it took longer than %1, which is enough for any session.</source>
        <translation>Die Datei ist beschädigt: Einen Teil davon zu lesen dauerte länger als %1, was für jede Sitzung genügt.</translation>
    </message>
    <message>
        <source>It reads sessions: reinstall Underact.</source>
        <translation>Es liest Sitzungen: Installieren Sie Underact neu.</translation>
    </message>
    <message>
        <source>This is a link to another file, which would be changed instead. Give the name of that file.</source>
        <translation>Dies ist eine Verknüpfung mit einer anderen Datei, die stattdessen geändert würde. Geben Sie den Namen jener Datei an.</translation>
    </message>
    <message>
        <source>The file cannot be opened: %1.</source>
        <translation>Die Datei lässt sich nicht öffnen: %1.</translation>
    </message>
    <message>
        <source>This is a folder, not a session.</source>
        <translation>Dies ist ein Ordner, keine Sitzung.</translation>
    </message>
    <message>
        <source>This is not a session file.</source>
        <translation>Dies ist keine Sitzungsdatei.</translation>
    </message>
    <message>
        <source>The reference points lie nearly on one line, at most %1 beside it: small errors turn the arm about it. Choose a reference point farther from the line.</source>
        <translation>Die Messpunkte liegen fast auf einer Geraden, höchstens %1 daneben: Kleine Fehler drehen den Arm um sie. Wählen Sie einen Messpunkt, der weiter neben der Geraden liegt.</translation>
    </message>
    <message>
        <source>The reference points %1 are only %2 apart: small errors there turn everything. Choose reference points that are farther apart.</source>
        <translation>Die Messpunkte %1 sind nur %2 voneinander entfernt: Kleine Fehler dort drehen alles. Wählen Sie Messpunkte, die weiter auseinanderliegen.</translation>
    </message>
    <message>
        <source>The reference points %1 were probably swapped. Touch them again in the order of their numbers.</source>
        <translation>Die Messpunkte %1 wurden wahrscheinlich beim Berühren vertauscht. Berühren Sie sie noch einmal in der Reihenfolge ihrer Nummern.</translation>
    </message>
    <message>
        <source>The reference points were probably touched in another order: %1. Touch them again in the order of their numbers.</source>
        <translation>Die Messpunkte wurden wahrscheinlich in einer anderen Reihenfolge berührt: %1. Berühren Sie sie noch einmal in der Reihenfolge ihrer Nummern.</translation>
    </message>
    <message>
        <source>According to these reference points the arm hangs upside down below the desk. If it does not, they were touched in mirrored order: touch them again in the order of their numbers.</source>
        <translation>Nach diesen Messpunkten hängt der Arm kopfüber unter dem Tisch. Tut er das nicht, so wurden sie in gespiegelter Reihenfolge berührt: Berühren Sie sie noch einmal in der Reihenfolge ihrer Nummern.</translation>
    </message>
    <message>
        <source>The touched points miss the reference points by %1, which is a lot. Reference point %2 fits worst: touch it again, and check that the sheet was printed at 100 % and that the arm is calibrated.</source>
        <translation>Die berührten Punkte verfehlen die Messpunkte um %1, und das ist viel. Messpunkt %2 passt am schlechtesten: Berühren Sie ihn noch einmal, und prüfen Sie, ob das Blatt mit 100 % gedruckt wurde und der Arm kalibriert ist.</translation>
    </message>
    <message>
        <source>At reference point %1 the tip moved by %2 while it was held. Touch it again, with your hand resting on the desk.</source>
        <translation>Bei Messpunkt %1 bewegte sich die Spitze um %2, während sie gehalten wurde. Berühren Sie ihn noch einmal, mit aufgelegter Hand.</translation>
    </message>
    <message>
        <source>Not all of the reference points are finite points within 1 km.</source>
        <translation>Nicht alle Messpunkte sind endliche Punkte innerhalb von 1 km.</translation>
    </message>
    <message>
        <source>The reference points %1 and %2 are at the same position. Touch them again, or choose reference points that are apart.</source>
        <translation>Die Messpunkte %1 und %2 liegen am selben Ort. Berühren Sie sie noch einmal, oder wählen Sie Messpunkte, die auseinanderliegen.</translation>
    </message>
    <message>
        <source>The reference points lie on one line, so how the arm is turned about it is unknown. Choose a reference point beside the line.</source>
        <translation>Die Messpunkte liegen auf einer Geraden; wie der Arm um sie gedreht ist, bleibt daher unbekannt. Wählen Sie einen Messpunkt neben der Geraden.</translation>
    </message>
    <message>
        <source>Not all of the touched points are finite points within 1 km.</source>
        <translation>Nicht alle berührten Punkte sind endliche Punkte innerhalb von 1 km.</translation>
    </message>
    <message>
        <source>The touched points %1 and %2 are at the same position. Touch them again, or choose reference points that are apart.</source>
        <translation>Die berührten Punkte %1 und %2 liegen am selben Ort. Berühren Sie sie noch einmal, oder wählen Sie Messpunkte, die auseinanderliegen.</translation>
    </message>
    <message>
        <source>The touched points lie on one line, so how the arm is turned about it is unknown. Choose a reference point beside the line.</source>
        <translation>Die berührten Punkte liegen auf einer Geraden; wie der Arm um sie gedreht ist, bleibt daher unbekannt. Wählen Sie einen Messpunkt neben der Geraden.</translation>
    </message>
    <message>
        <source>A registration needs 3 to 8 reference points; this one has %1.</source>
        <translation>Eine Registrierung braucht 3 bis 8 Messpunkte; hier sind es %1.</translation>
    </message>
    <message>
        <source>a reference point</source>
        <translation>ein Messpunkt</translation>
    </message>
    <message>
        <source>This must be from 0 to 1000 mm.</source>
        <translation>Dies muss zwischen 0 und 1000 mm liegen.</translation>
    </message>
    <message>
        <source>a list of 3 to 8 reference points</source>
        <translation>eine Liste von 3 bis 8 Messpunkten</translation>
    </message>
    <message>
        <source>This must be a list of 3 to 8 reference points; this one has %1.</source>
        <translation>Dies muss eine Liste von 3 bis 8 Messpunkten sein; hier sind es %1.</translation>
    </message>
    <message>
        <source>This must be four rows of four numbers, the last one 0, 0, 0, 1.</source>
        <translation>Dies müssen vier Zeilen mit je vier Zahlen sein, die letzte 0, 0, 0, 1.</translation>
    </message>
    <message>
        <source>a list of four rows</source>
        <translation>eine Liste von vier Zeilen</translation>
    </message>
    <message>
        <source>This is not what the reference points give, %1. Leave X_DW out: it is computed from them.</source>
        <translation>Dies ist nicht, was die Messpunkte ergeben, nämlich %1. Lassen Sie X_DW weg: Es wird aus ihnen berechnet.</translation>
    </message>
    <message>
        <source>a registration</source>
        <translation>eine Registrierung</translation>
    </message>
    <message>
        <source>This program reads version 1 of registrations.</source>
        <translation>Dieses Programm liest Version 1 von Registrierungen.</translation>
    </message>
    <message>
        <source>The registration cannot be saved. Check that the folder exists and is yours, and that the disk is not full.</source>
        <translation>Die Registrierung lässt sich nicht speichern. Prüfen Sie, ob der Ordner da ist und Ihnen gehört und ob der Datenträger nicht voll ist.</translation>
    </message>
    <message>
        <source>The registration cannot be saved: %1. Check that the folder exists and is yours, and that the disk is not full.</source>
        <translation>Die Registrierung lässt sich nicht speichern: %1. Prüfen Sie, ob der Ordner da ist und Ihnen gehört und ob der Datenträger nicht voll ist.</translation>
    </message>
    <message>
        <source>This is the registration of another arm, "%1". Register this arm again.</source>
        <translation>Dies ist die Registrierung eines anderen Arms, „%1“. Registrieren Sie diesen Arm noch einmal.</translation>
    </message>
    <message>
        <source>The registration cannot be deleted: %1. Check that the folder exists and is yours, and that the disk is not full.</source>
        <translation>Die Registrierung lässt sich nicht löschen: %1. Prüfen Sie, ob der Ordner da ist und Ihnen gehört und ob der Datenträger nicht voll ist.</translation>
    </message>
    <message>
        <source>The control law %1 does not use this gain; %2 does. Change the control law, or remove the gain.</source>
        <translation>Das Regelgesetz %1 benutzt diese Verstärkung nicht, wohl aber %2. Ändern Sie das Regelgesetz, oder entfernen Sie die Verstärkung.</translation>
    </message>
    <message>
        <source>PD (or PID)</source>
        <translation>PD (oder PID)</translation>
    </message>
    <message>
        <source>The control of joints follows the closed form of the Omni's geometry, which the arm %1 has not; "cartesian" works with every arm.</source>
        <translation>Die Gelenkregelung folgt der geschlossenen Form der Omni-Geometrie, die der Arm %1 nicht hat; „cartesian“ geht mit jedem Arm.</translation>
    </message>
    <message>
        <source>The gain along %1 is %2 while the others are larger, so no point of the %3 is nearest in the gains' own metric. Set "anisotropy" to "euclidean" in the control, or give every axis a gain.</source>
        <translation>Die Verstärkung entlang %1 ist %2, während die anderen größer sind, also ist bei dieser Bindung (Typ „%3“) kein Punkt der nächste in der eigenen Metrik der Verstärkungen. Setzen Sie „anisotropy“ in der Regelung auf „euclidean“, oder geben Sie jeder Achse eine Verstärkung.</translation>
    </message>
    <message>
        <source>%1, almost nothing,</source>
        <translation>%1, also fast nichts,</translation>
    </message>
    <message>
        <source>The constraint has no name.</source>
        <translation>Die Bindung hat keinen Namen.</translation>
    </message>
    <message>
        <source>The name %1 is taken by %2; names must differ.</source>
        <translation>Den Namen %1 hat schon %2; Namen müssen sich unterscheiden.</translation>
    </message>
    <message>
        <source>A %1 has no influence.</source>
        <translation>Eine Bindung vom Typ „%1“ hat keinen Einfluss.</translation>
    </message>
    <message>
        <source>A wall has no influence: where the stylus is free, nothing pulls it. Remove "side" or "influence".</source>
        <translation>Eine Wand hat keinen Einfluss: Wo der Stift frei ist, zieht ihn nichts. Entfernen Sie „side“ oder „influence“.</translation>
    </message>
    <message>
        <source>With influence, the target is not the nearest point in the gains' own metric. Set "anisotropy" to "euclidean" in the control, or give every axis the same kp.</source>
        <translation>Mit Einfluss ist das Ziel nicht der nächste Punkt in der eigenen Metrik der Verstärkungen. Setzen Sie „anisotropy“ in der Regelung auf „euclidean“, oder geben Sie jeder Achse dasselbe kp.</translation>
    </message>
    <message>
        <source>A %1 has no inside and no outside.</source>
        <translation>Eine Bindung vom Typ „%1“ hat kein Innen und kein Außen.</translation>
    </message>
    <message>
        <source>There is nothing to slide along.</source>
        <translation>Hier gibt es nichts, woran man entlanggleiten kann.</translation>
    </message>
    <message>
        <source>The arm file %1 was not read.</source>
        <translation>Die Armdatei %1 wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The arm %1: %2</source>
        <translation>Der Arm %1: %2</translation>
    </message>
    <message>
        <source>The arm %1 is not known. Known arms: %2; or the name of an arm file, such as "my_arm.json".</source>
        <translation>Der Arm %1 ist nicht bekannt. Bekannte Arme: %2; oder der Name einer Armdatei, etwa „my_arm.json“.</translation>
    </message>
    <message>
        <source>The arm %1 is not known. Did you mean "%2"? Known arms: %3; or the name of an arm file, such as "my_arm.json".</source>
        <translation>Der Arm %1 ist nicht bekannt. Ist „%2“ gemeint? Bekannte Arme: %3; oder der Name einer Armdatei, etwa „my_arm.json“.</translation>
    </message>
    <message>
        <source>The title is empty; say in a few words what the scene lets you feel.</source>
        <translation>Der Titel ist leer; sagen Sie in ein paar Worten, was in der Szene zu fühlen ist.</translation>
    </message>
    <message>
        <source>a guide</source>
        <translation>eine Führung</translation>
    </message>
    <message>
        <source>The curve %1 is not loaded.</source>
        <translation>Die Kurve %1 ist nicht geladen.</translation>
    </message>
    <message>
        <source>The mesh %1 is not the one that the scene was made with: its checksum differs. Restore that file, or remove "checksum" to use this one.</source>
        <translation>Das Dreiecksnetz %1 ist nicht das, mit dem die Szene gemacht wurde: Seine Prüfsumme ist eine andere. Stellen Sie jene Datei wieder her, oder entfernen Sie „checksum“, um diese zu verwenden.</translation>
    </message>
    <message>
        <source>The mesh %1: %2</source>
        <translation>Das Dreiecksnetz %1: %2</translation>
    </message>
    <message>
        <source>The curve %1 is not the one that the scene was made with: its checksum differs. Restore that file, or remove "checksum" to use this one.</source>
        <translation>Die Kurve %1 ist nicht die, mit der die Szene erstellt wurde: Ihre Prüfsumme weicht ab. Stellen Sie die Datei wieder her, oder entfernen Sie "checksum", um diese zu verwenden.</translation>
    </message>
    <message>
        <source>The file %1 was not found in %2. A recording stores the names of its meshes and curves, not their folders. Put the file beside the session, or choose its folder: in the window with Replay, Folder with meshes and curves; on the command line with --files FOLDER.</source>
        <translation>Die Datei %1 wurde in %2 nicht gefunden. Eine Aufzeichnung speichert die Namen ihrer Dreiecksnetze und Kurven, nicht deren Ordner. Legen Sie die Datei neben die Sitzung, oder wählen Sie ihren Ordner: im Fenster mit Wiedergabe, Ordner mit Dreiecksnetzen und Kurven; auf der Befehlszeile mit --files ORDNER.</translation>
    </message>
    <message>
        <source>This is not a finite direction; the largest number is about 1.8e308.</source>
        <translation>Dies ist keine endliche Richtung; die größte Zahl ist etwa 1.8e308.</translation>
    </message>
    <message>
        <source>The lower limit %1 is above the upper limit %2.</source>
        <translation>Die untere Grenze %1 liegt über der oberen Grenze %2.</translation>
    </message>
    <message>
        <source>Without a spring the joint has no rest position; give it "%1", or remove this.</source>
        <translation>Ohne Feder hat das Gelenk keine Ruhelage; geben Sie ihm „%1“, oder entfernen Sie dies.</translation>
    </message>
    <message>
        <source>The orientation "none" does not use this; set "orientation" to "axis", "angle" or "full", or remove this.</source>
        <translation>Die Orientierung „none“ benutzt dies nicht; setzen Sie „orientation“ auf „axis“, „angle“ oder „full“, oder entfernen Sie dies.</translation>
    </message>
    <message>
        <source>A virtual robot pulls the tip, which control in joint space cannot do. Set "space" to "cartesian".</source>
        <translation>Ein virtueller Roboter zieht die Spitze, was eine Regelung im Gelenkraum nicht kann. Setzen Sie „space“ auf „cartesian“.</translation>
    </message>
    <message>
        <source>A virtual robot is held in the gains' own metric. Remove "anisotropy", or give every axis the same kp.</source>
        <translation>Ein virtueller Roboter wird in der eigenen Metrik der Verstärkungen gehalten. Entfernen Sie „anisotropy“, oder geben Sie jeder Achse dasselbe kp.</translation>
    </message>
    <message>
        <source>The nearest name is %1.</source>
        <translation>Der ähnlichste Name ist %1.</translation>
    </message>
    <message>
        <source>It is %1 mm long, too small to be felt: state a larger scale_mm_per_unit.</source>
        <translation>Es ist %1 mm lang, zu klein zum Fühlen: Geben Sie ein größeres scale_mm_per_unit an.</translation>
    </message>
    <message>
        <source>It is %1 mm long, far beyond the arm's reach: state a smaller scale_mm_per_unit.</source>
        <translation>Es ist %1 mm lang, weit über die Reichweite des Arms hinaus: Geben Sie ein kleineres scale_mm_per_unit an.</translation>
    </message>
    <message>
        <source>There is no file %1, so %2 was read.</source>
        <translation>Es gibt keine Datei %1, deshalb wurde %2 gelesen.</translation>
    </message>
    <message>
        <source>A %1 needs the name of its file.</source>
        <translation>Eine Bindung vom Typ „%1“ braucht den Namen ihrer Datei.</translation>
    </message>
    <message>
        <source>This must be from 1e-9 to 1e9 mm (1: the file is in mm; 1000: in m; 25.4: in inches), or negative to mirror at the file's origin; here it is %1.</source>
        <translation>Dies muss zwischen 1e-9 und 1e9 mm liegen (1: Die Datei ist in mm; 1000: in m; 25.4: in Zoll), oder negativ sein, um am Ursprung der Datei zu spiegeln; hier steht %1.</translation>
    </message>
    <message>
        <source>The nearest point of a %1 is not searched in the gains' own metric. Set "anisotropy" to "euclidean" in the control, or give every axis the same kp.</source>
        <translation>Bei einer Bindung vom Typ „%1“ wird der nächste Punkt nicht in der eigenen Metrik der Verstärkungen gesucht. Setzen Sie „anisotropy“ in der Regelung auf „euclidean“, oder geben Sie jeder Achse dasselbe kp.</translation>
    </message>
    <message>
        <source>A wall's proxy follows the surface and needs no search. Remove "search".</source>
        <translation>Der Proxy einer Wand folgt der Oberfläche und braucht keine Suche. Entfernen Sie „search“.</translation>
    </message>
    <message>
        <source>The mesh %1 is not loaded.</source>
        <translation>Das Dreiecksnetz %1 ist nicht geladen.</translation>
    </message>
    <message>
        <source>The mesh %1 has holes or edges that do not fit together, so it has no inside and no outside. Remove "side": the stylus is then held to its surface.</source>
        <translation>Das Dreiecksnetz %1 hat Löcher oder Kanten, die nicht zusammenpassen, und damit kein Innen und kein Außen. Entfernen Sie „side“: Der Stift wird dann auf seiner Oberfläche gehalten.</translation>
    </message>
    <message>
        <source>the number 1</source>
        <translation>die Zahl 1</translation>
    </message>
    <message>
        <source>The scene has version %1, but this program only reads version 1. Use a newer version of Underact.</source>
        <translation>Die Szene hat Version %1, aber dieses Programm liest nur Version 1. Benutzen Sie eine neuere Version von Underact.</translation>
    </message>
    <message>
        <source>This must be the number 1, the version of scene files.</source>
        <translation>Dies muss die Zahl 1 sein, die Version von Szenendateien.</translation>
    </message>
    <message>
        <source>a list of constraints</source>
        <translation>eine Liste von Bindungen</translation>
    </message>
    <message>
        <source>a scene</source>
        <translation>eine Szene</translation>
    </message>
    <message>
        <source>a simulation</source>
        <translation>eine Simulation</translation>
    </message>
    <message>
        <source>The type %1 is not known. Known types: %2.</source>
        <translation>Der Typ %1 ist nicht bekannt. Bekannte Typen: %2.</translation>
    </message>
    <message>
        <source>The type %1 is not known. Did you mean "%2"? Known types: %3.</source>
        <translation>Der Typ %1 ist nicht bekannt. Meinten Sie „%2“? Bekannte Typen: %3.</translation>
    </message>
    <message>
        <source>The name is empty; write one, or remove the key to get a default name.</source>
        <translation>Der Name ist leer; schreiben Sie einen, oder entfernen Sie den Schlüssel, dann wird ein Name vergeben.</translation>
    </message>
    <message>
        <source>A %1 has no inside and no outside; remove "side".</source>
        <translation>Eine Bindung vom Typ „%1“ hat kein Innen und kein Außen; entfernen Sie „side“.</translation>
    </message>
    <message>
        <source>A %1 has no influence; only a circle, a cylinder and a sphere have. Remove it.</source>
        <translation>Eine Bindung vom Typ „%1“ hat keinen Einfluss; nur Kreis, Zylinder und Kugel haben einen. Entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>an influence</source>
        <translation>ein Einfluss</translation>
    </message>
    <message>
        <source>Nothing can slide along a %1, so it has no friction. Remove it.</source>
        <translation>An einer Bindung vom Typ „%1“ kann nichts entlanggleiten, also hat sie keine Reibung. Entfernen Sie sie.</translation>
    </message>
    <message>
        <source>a friction</source>
        <translation>eine Reibung</translation>
    </message>
    <message>
        <source>This belongs in a constraint, as in %1.</source>
        <translation>Dies gehört in eine Bindung, wie in %1.</translation>
    </message>
    <message>
        <source>a constraint</source>
        <translation>eine Bindung</translation>
    </message>
    <message>
        <source>a %1</source>
        <translation>eine Bindung vom Typ „%1“</translation>
    </message>
    <message>
        <source>The nearest point of a %1 is computed by a formula; only a mesh and a curve have a search. Remove it.</source>
        <translation>Der nächste Punkt einer Bindung vom Typ „%1“ wird mit einer Formel berechnet; nur Dreiecksnetz und Kurve haben eine Suche. Entfernen Sie sie.</translation>
    </message>
    <message>
        <source>This belongs in the control, as in %1.</source>
        <translation>Dies gehört in die Regelung, wie in %1.</translation>
    </message>
    <message>
        <source>a control</source>
        <translation>eine Regelung</translation>
    </message>
    <message>
        <source>A prismatic joint has a direction but no point; remove the point.</source>
        <translation>Ein Schubgelenk hat eine Richtung, aber keinen Punkt; entfernen Sie den Punkt.</translation>
    </message>
    <message>
        <source>The spring of a %1 joint is called "%2".</source>
        <translation>Die Feder eines Gelenks vom Typ „%1“ heißt „%2“.</translation>
    </message>
    <message>
        <source>4 rows of 4 numbers</source>
        <translation>eine Liste von 4 Zeilen mit je 4 Zahlen</translation>
    </message>
    <message>
        <source>A pose has 4 rows of 4 numbers; this one has %1.</source>
        <translation>Eine Lage hat 4 Zeilen mit je 4 Zahlen; hier sind es %1.</translation>
    </message>
    <message>
        <source>4 numbers</source>
        <translation>eine Zeile von 4 Zahlen</translation>
    </message>
    <message>
        <source>A row has 4 numbers; this one has %1.</source>
        <translation>Eine Zeile hat 4 Zahlen; hier sind es %1.</translation>
    </message>
    <message>
        <source>a list of joints</source>
        <translation>eine Liste von Gelenken</translation>
    </message>
    <message>
        <source>a solver</source>
        <translation>ein Löser</translation>
    </message>
    <message>
        <source>This is for %2, not for the filter "%1". Change the filter, or remove this.</source>
        <translation>Der Filter „%1“ benutzt dies nicht, wohl aber %2. Ändern Sie den Filter, oder entfernen Sie dies.</translation>
    </message>
    <message>
        <source>a velocity filter</source>
        <translation>ein Geschwindigkeitsfilter</translation>
    </message>
    <message>
        <source>A scene has 1 to %1 constraints; this one has %2.</source>
        <translation>Eine Szene hat 1 bis %1 Bindungen; hier sind es %2.</translation>
    </message>
    <message>
        <source>A virtual robot has 1 to %1 joints; this one has %2.</source>
        <translation>Ein virtueller Roboter hat 1 bis %1 Gelenke; hier sind es %2.</translation>
    </message>
    <message>
        <source>This is not a finite number; the largest is about 1.8e308.</source>
        <translation>Dies ist keine endliche Zahl; die größte ist etwa 1.8e308.</translation>
    </message>
    <message>
        <source>A direction must not be [0, 0, 0]; any other length will do.</source>
        <translation>Eine Richtung darf nicht [0, 0, 0] sein; jede andere Länge ist recht.</translation>
    </message>
    <message>
        <source>This must be above 0 mm; here it is %1.</source>
        <translation>Dies muss über 0 mm liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This is too close to 0 mm; the smallest value is 1e-100 mm.</source>
        <translation>Dies ist zu nahe an 0 mm; der kleinste Wert ist 1e-100 mm.</translation>
    </message>
    <message>
        <source>This must lie within 1e6 mm (1 km); here it is %1.</source>
        <translation>Dies darf höchstens 1e6 mm (1 km) betragen; hier steht %1.</translation>
    </message>
    <message>
        <source>A gain must be 0 or above, otherwise the arm pushes away; here it is %1.</source>
        <translation>Eine Verstärkung muss 0 oder größer sein, sonst drückt der Arm weg; hier steht %1.</translation>
    </message>
    <message>
        <source>A gain must be at most 1e12; here it is %1.</source>
        <translation>Eine Verstärkung darf höchstens 1e12 betragen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must lie within %1; here it is %2.</source>
        <translation>Dies darf höchstens %1 betragen; hier steht %2.</translation>
    </message>
    <message>
        <source>This is not a finite pose; the largest number is about 1.8e308.</source>
        <translation>Dies ist keine endliche Lage; die größte Zahl ist etwa 1.8e308.</translation>
    </message>
    <message>
        <source>The last row of a pose must be [0, 0, 0, 1].</source>
        <translation>Die letzte Zeile einer Lage muss [0, 0, 0, 1] sein.</translation>
    </message>
    <message>
        <source>The position must lie within 1e6 mm (1 km).</source>
        <translation>Die Position muss innerhalb von 1e6 mm (1 km) liegen.</translation>
    </message>
    <message>
        <source>The arm %1 is from a file, and the recording does not say what that file contained.</source>
        <translation>Der Arm %1 ist aus einer Datei, und die Aufzeichnung sagt nicht, was sie enthielt.</translation>
    </message>
    <message>
        <source>"arm_text" is the content of an arm file, but "arm" names none.</source>
        <translation>„arm_text“ ist der Inhalt einer Armdatei, aber „arm“ nennt keine.</translation>
    </message>
    <message>
        <source>This is a folder; a scene needs a file name.</source>
        <translation>Dies ist ein Ordner; eine Szene braucht einen Dateinamen.</translation>
    </message>
    <message>
        <source>The scene cannot be saved: %1.</source>
        <translation>Die Szene lässt sich nicht speichern: %1.</translation>
    </message>
    <message>
        <source>The scene cannot be saved: %1. The existing file is unchanged.</source>
        <translation>Die Szene lässt sich nicht speichern: %1. Die vorhandene Datei ist unverändert.</translation>
    </message>
    <message>
        <source>There is no setting %1.</source>
        <translation>Eine Einstellung %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no setting %1. Did you mean "%2"?</source>
        <translation>Eine Einstellung %1 gibt es nicht. Meinten Sie „%2“?</translation>
    </message>
    <message>
        <source>The scene has %1 constraints, counted from 0.</source>
        <translation>Die Szene hat %1 Bindungen, gezählt ab 0.</translation>
    </message>
    <message>
        <source>The scene has nothing there with a setting "%1".</source>
        <translation>Die Szene hat dort nichts mit einer Einstellung „%1“.</translation>
    </message>
    <message>
        <source>This must be from %1 to %2; here it is %3.</source>
        <translation>Dies muss zwischen %1 und %2 liegen; hier steht %3.</translation>
    </message>
    <message>
        <source>This must be a whole number from %1 to %2; here it is %3.</source>
        <translation>Dies muss eine ganze Zahl von %1 bis %2 sein; hier steht %3.</translation>
    </message>
    <message>
        <source>a number, or a list of 3 numbers for x, y and z</source>
        <translation>eine Zahl oder eine Liste von 3 Zahlen für x, y und z</translation>
    </message>
    <message>
        <source>This must be from 0 to the static friction, %1; here it is %2.</source>
        <translation>Dies muss zwischen 0 und der Haftreibung, %1, liegen; hier steht %2.</translation>
    </message>
    <message>
        <source>This must be from %1 to %2 µs; here it is %3.</source>
        <translation>Dies muss zwischen %1 und %2 µs liegen; hier ist es %3.</translation>
    </message>
    <message>
        <source>This must be from 0 (orientation only) to 1 (position only); here it is %1.</source>
        <translation>Dies muss zwischen 0 (nur die Orientierung) und 1 (nur die Position) liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be from 0 to 30 degrees; here it is %1.</source>
        <translation>Dies muss zwischen 0 und 30 Grad liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be from 0 (smooth) to %1; here it is %2.</source>
        <translation>Dies muss zwischen 0 (glatt) und %1 liegen; hier steht %2.</translation>
    </message>
    <message>
        <source>This must be from 0 (faces as they are) to %1 degrees; here it is %2.</source>
        <translation>Dies muss zwischen 0 (Flächen, wie sie sind) und %1 Grad liegen; hier steht %2.</translation>
    </message>
    <message>
        <source>This must be from -2000 to 2000 mm/s; here it is %1.</source>
        <translation>Dies muss zwischen -2000 und 2000 mm/s liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be from 0 (guide only) to 1 (nearest point only); here it is %1.</source>
        <translation>Dies muss zwischen 0 (nur zur Führung) und 1 (nur zum nächsten Punkt) liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be above 0 and at most 1000 mm; here it is %1.</source>
        <translation>Dies muss über 0 liegen und höchstens 1000 mm sein; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be above 0 and at most 0.01 (rad, or a fraction of the reach); here it is %1.</source>
        <translation>Dies muss über 0 liegen und höchstens 0.01 sein (rad, oder Anteil der Reichweite); hier steht %1.</translation>
    </message>
    <message>
        <source>what a scene teaches</source>
        <translation>was eine Szene lehrt</translation>
    </message>
    <message>
        <source>This arm keeps the rate that it was opened with.</source>
        <translation>Dieser Arm behält die Taktrate, mit der er geöffnet wurde.</translation>
    </message>
    <message>
        <source>no guard: %1</source>
        <translation>kein Wächter: %1</translation>
    </message>
    <message>
        <source>guarded by a separate process</source>
        <translation>von einem eigenen Prozess bewacht</translation>
    </message>
    <message>
        <source>guarded by a separate process (replaced so far: %1)</source>
        <translation>von einem eigenen Prozess bewacht (bisher ersetzt: %1)</translation>
    </message>
    <message>
        <source>Nothing guards the arm: %1. If this program crashed now, the arm could hold its last force. Until the guard is back, keep a hand on the arm's plug or switch, or switch the force off.</source>
        <translation>Nichts bewacht den Arm: %1. Stürzte dieses Programm jetzt ab, könnte der Arm seine letzte Kraft behalten. Halten Sie eine Hand an seinem Stecker oder Schalter, bis der Wächter wieder da ist, oder schalten Sie die Kraft ab.</translation>
    </message>
    <message>
        <source>this arm cannot be reached from outside the program</source>
        <translation>Dieser Arm ist von außerhalb des Programms nicht zu erreichen</translation>
    </message>
    <message>
        <source>the guard has ended and is being restarted</source>
        <translation>der Wächter ist beendet und wird neu gestartet</translation>
    </message>
    <message>
        <source>the guard has ended and does not restart (%1)</source>
        <translation>der Wächter ist beendet und startet nicht wieder (%1)</translation>
    </message>
    <message>
        <source>the watchdog is switched off</source>
        <translation>Die Überwachung der Takte ist abgeschaltet</translation>
    </message>
    <message>
        <source>The servo rate must be from 100 to 10000 Hz, not %1.</source>
        <translation>Die Taktrate des Servos muss zwischen 100 und 10000 Hz liegen, nicht %1.</translation>
    </message>
    <message>
        <source>A session is recorded at a single rate. Stop the recording, then change the rate.</source>
        <translation>Eine Sitzung wird mit einer einzigen Taktrate aufgezeichnet. Stoppen Sie die Aufzeichnung, dann ändern Sie die Taktrate.</translation>
    </message>
    <message>
        <source>The share of the force must be from 0 to 1.</source>
        <translation>Der Anteil der Kraft muss zwischen 0 und 1 liegen.</translation>
    </message>
    <message>
        <source>A session is recorded with a single force limit. Stop the recording first.</source>
        <translation>Eine Sitzung wird mit einer einzigen Kraftgrenze aufgezeichnet. Stoppen Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>manual</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>by the arm's own clock</source>
        <translation>nach der Uhr des Arms</translation>
    </message>
    <message>
        <source>denormals flushed</source>
        <translation>denormale Zahlen zu null gemacht</translation>
    </message>
    <message>
        <source>denormals kept</source>
        <translation>denormale Zahlen behalten</translation>
    </message>
    <message>
        <source>The centre is not a finite point.</source>
        <translation>Der Mittelpunkt ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>Every size must be above 0.</source>
        <translation>Jede Größe muss über 0 liegen.</translation>
    </message>
    <message>
        <source>The radius must be above 0.</source>
        <translation>Der Radius muss über 0 liegen.</translation>
    </message>
    <message>
        <source>The point on the axis is not a finite point.</source>
        <translation>Der Punkt auf der Achse ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>The point is not a finite point.</source>
        <translation>Der Punkt ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>The line has no direction.</source>
        <translation>Die Gerade hat keine Richtung.</translation>
    </message>
    <message>
        <source>The normal has no direction.</source>
        <translation>Die Normale hat keine Richtung.</translation>
    </message>
    <message>
        <source>The position is not a finite point.</source>
        <translation>Die Position ist kein endlicher Punkt.</translation>
    </message>
    <message>
        <source>This must lie within 0 and %1; here it is %2.</source>
        <translation>Dies muss zwischen 0 und %1 liegen; hier steht %2.</translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation>keine endliche Zahl</translation>
    </message>
    <message>
        <source>a list of six numbers</source>
        <translation>eine Liste von sechs Zahlen</translation>
    </message>
    <message>
        <source>This must be a list of six numbers, one for each joint.</source>
        <translation>Dies muss eine Liste von sechs Zahlen sein, eine für jedes Gelenk.</translation>
    </message>
    <message>
        <source>This must be a number of at least 1, or null where it was not measured.</source>
        <translation>Dies muss eine Zahl von mindestens 1 sein, oder null, wo nicht gemessen wurde.</translation>
    </message>
    <message>
        <source>a list of positions</source>
        <translation>eine Liste von Positionen</translation>
    </message>
    <message>
        <source>Each coordinate must lie within 1e6 mm (1 km).</source>
        <translation>Jede Koordinate darf höchstens 1e6 mm (1 km) betragen.</translation>
    </message>
    <message>
        <source>the origin of a model</source>
        <translation>die Herkunft eines Modells</translation>
    </message>
    <message>
        <source>This must be a whole number of ticks per second, at least 1.</source>
        <translation>Dies muss eine ganze Zahl von Takten je Sekunde sein, mindestens 1.</translation>
    </message>
    <message>
        <source>an uncertainty</source>
        <translation>eine Unsicherheit</translation>
    </message>
    <message>
        <source>This program reads version 1 of arm models.</source>
        <translation>Dieses Programm liest Version 1 von Armmodellen.</translation>
    </message>
    <message>
        <source>an arm model</source>
        <translation>ein Armmodell</translation>
    </message>
    <message>
        <source>There is no arm model %1; use %2, or a file (a name with a dot or a slash).</source>
        <translation>Ein Armmodell %1 gibt es nicht; verwenden Sie %2, oder eine Datei (ein Name mit einem Punkt oder Schrägstrich).</translation>
    </message>
    <message>
        <source>There is no hand "%1". Hands: %2.</source>
        <translation>Eine Hand „%1“ gibt es nicht. Hände: %2.</translation>
    </message>
    <message>
        <source>This must not be below 0; here it is %1.</source>
        <translation>Dies darf nicht unter 0 liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>This must be above 0; here it is %1.</source>
        <translation>Dies muss über 0 liegen; hier steht %1.</translation>
    </message>
    <message>
        <source>a hand</source>
        <translation>eine Hand</translation>
    </message>
    <message>
        <source>Each time must be later than those before it.</source>
        <translation>Jeder Zeitpunkt muss später sein als die davor.</translation>
    </message>
    <message>
        <source>a point of a hand's path</source>
        <translation>ein Punkt auf dem Weg einer Hand</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>eine Liste von Punkten</translation>
    </message>
    <message>
        <source>A path needs at least one point.</source>
        <translation>Ein Weg braucht mindestens einen Punkt.</translation>
    </message>
    <message>
        <source>a hand file</source>
        <translation>eine Handdatei</translation>
    </message>
    <message>
        <source>This program reads version 1 only.</source>
        <translation>Dieses Programm liest nur Version 1.</translation>
    </message>
    <message>
        <source>The trial pushes a mass at the tip, as haptic arms have one; the arm "%1" has links instead.</source>
        <translation>Der Versuch stößt eine Masse an der Spitze an, wie haptische Arme sie haben; der Arm „%1“ hat stattdessen Glieder.</translation>
    </message>
    <message>
        <source>Nothing holds the tip there: the target follows the tip everywhere, so no stiffness is felt.</source>
        <translation>Dort hält nichts die Spitze: Das Ziel folgt der Spitze überallhin, also ist keine Steifigkeit zu fühlen.</translation>
    </message>
    <message>
        <source>This is a folder, not %1 file.</source>
        <translation>Dies ist ein Ordner; hier wird eine Datei erwartet (%1).</translation>
    </message>
    <message>
        <source>This is a pipe, a device or a socket, not a regular file, so %1 is not read from it. Save its output to a file, and give that file.</source>
        <translation>Dies ist eine Pipe, ein Gerät oder ein Socket und keine gewöhnliche Datei; %1 wird daraus nicht gelesen. Speichern Sie die Ausgabe in einer Datei, und geben Sie diese an.</translation>
    </message>
    <message>
        <source>The file cannot be read: %1.</source>
        <translation>Die Datei lässt sich nicht lesen: %1.</translation>
    </message>
    <message>
        <source>The file is larger than %1 MiB; %2 is far smaller.</source>
        <translation>Die Datei ist größer als %1 MiB; so groß wird keine Datei dieser Art (%2).</translation>
    </message>
    <message>
        <source>Another program wrote to the file while it was being read. Open it again once that program has saved it.</source>
        <translation>Ein anderes Programm hat in die Datei geschrieben, während sie gelesen wurde. Öffnen Sie sie noch einmal, sobald jenes Programm sie gespeichert hat.</translation>
    </message>
    <message>
        <source>A folder, a pipe or a device has this name and is not replaced. Give another name.</source>
        <translation>Ein Ordner, eine Pipe oder ein Gerät heißt schon so und wird nicht ersetzt. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>A file or a link of this name already exists; it was left unchanged. Give another name.</source>
        <translation>Eine Datei oder eine Verknüpfung dieses Namens gibt es schon; sie wurde nicht geändert. Geben Sie einen anderen Namen an.</translation>
    </message>
    <message>
        <source>all cores</source>
        <translation>alle Kerne</translation>
    </message>
    <message>
        <source>core %1 refused</source>
        <translation>Kern %1 verweigert</translation>
    </message>
    <message>
        <source>core %1</source>
        <translation>Kern %1</translation>
    </message>
    <message>
        <source>isolated core %1</source>
        <translation>isolierter Kern %1</translation>
    </message>
    <message>
        <source>rtkit: %1</source>
        <translation>rtkit: %1</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>The requested core does not exist, or is not available to this program.</source>
        <translation>Den verlangten Kern gibt es nicht, oder er steht diesem Programm nicht zur Verfügung.</translation>
    </message>
    <message>
        <source>Real time was not requested, so ticks can be late when the computer is busy.</source>
        <translation>Echtzeit wurde nicht verlangt, also können Takte spät kommen, wenn der Rechner beschäftigt ist.</translation>
    </message>
    <message>
        <source>The system did not grant real-time scheduling, so ticks can be late when the computer is busy. Put "@users - rtprio 90" and "@users - memlock unlimited" into a file in /etc/security/limits.d and log in again, or install rtkit; the guide's page real_time.md explains how.</source>
        <translation>Das System gewährte keine Echtzeit, also können Takte spät kommen, wenn der Rechner beschäftigt ist. Schreiben Sie "@users - rtprio 90" und "@users - memlock unlimited" in eine Datei in /etc/security/limits.d und melden Sie sich neu an, oder installieren Sie rtkit; die Seite real_time.md des Handbuchs erklärt, wie.</translation>
    </message>
    <message>
        <source>A higher priority would be better still. Put "@users - rtprio 90" and "@users - memlock unlimited" into a file in /etc/security/limits.d and log in again; the guide's page real_time.md explains how.</source>
        <translation>Eine höhere Priorität wäre noch besser. Schreiben Sie "@users - rtprio 90" und "@users - memlock unlimited" in eine Datei in /etc/security/limits.d und melden Sie sich neu an; die Seite real_time.md des Handbuchs erklärt, wie.</translation>
    </message>
    <message>
        <source>Parts of the program may be swapped out, and a tick then waits for them. Put "@users - memlock unlimited" into a file in /etc/security/limits.d and log in again; the guide's page real_time.md explains how.</source>
        <translation>Teile des Programms können aus dem Speicher ausgelagert werden, und ein Takt wartet dann auf sie. Schreiben Sie "@users - memlock unlimited" in eine Datei in /etc/security/limits.d und melden Sie sich neu an; die Seite real_time.md des Handbuchs erklärt, wie.</translation>
    </message>
    <message>
        <source>On a computer that is always busy, a core for the servo alone (isolcpus) is better still; the guide's page real_time.md explains how.</source>
        <translation>Auf einem Rechner, der immer beschäftigt ist, ist ein Kern allein für den Servo (isolcpus) noch besser; die Seite real_time.md des Handbuchs erklärt, wie.</translation>
    </message>
    <message>
        <source>memory locked</source>
        <translation>Speicher gesperrt</translation>
    </message>
    <message>
        <source>memory not locked</source>
        <translation>Speicher nicht gesperrt</translation>
    </message>
    <message>
        <source>timer slack 1 ns</source>
        <translation>Spielraum des Zeitgebers 1 ns</translation>
    </message>
    <message>
        <source>timer slack unchanged</source>
        <translation>Spielraum des Zeitgebers unverändert</translation>
    </message>
    <message>
        <source>stack in memory</source>
        <translation>Stapel im Speicher</translation>
    </message>
    <message>
        <source>The scenes that come with Underact were not found in %1. Reinstall Underact, or set UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.</source>
        <translation>Die Szenen, die zu Underact gehören, wurden in %1 nicht gefunden. Installieren Sie Underact neu, oder setzen Sie UNDERACT_DATA_DIR auf seinen Datenordner (share/underact) oder seinen Quellordner.</translation>
    </message>
    <message>
        <source>The lessons that come with Underact were not found in %1. Reinstall Underact, or set UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.</source>
        <translation>Die Lektionen, die zu Underact gehören, wurden in %1 nicht gefunden. Installieren Sie Underact neu, oder setzen Sie UNDERACT_DATA_DIR auf seinen Datenordner (share/underact) oder seinen Quellordner.</translation>
    </message>
    <message>
        <source>The guide's pages were not found in %1. Reinstall Underact, or set UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.</source>
        <translation>Die Seiten des Handbuchs wurden in %1 nicht gefunden. Installieren Sie Underact neu, oder setzen Sie UNDERACT_DATA_DIR auf seinen Datenordner (share/underact) oder seinen Quellordner.</translation>
    </message>
    <message>
        <source>The Python package that comes with Underact was not found in %1. Reinstall Underact, or set UNDERACT_DATA_DIR to its data folder (share/underact) or its source folder.</source>
        <translation>Das Python-Paket, das zu Underact gehört, wurde in %1 nicht gefunden. Installieren Sie Underact neu, oder setzen Sie UNDERACT_DATA_DIR auf seinen Datenordner (share/underact) oder seinen Quellordner.</translation>
    </message>
    <message>
        <source>%1 was not found. Searched: %2.</source>
        <translation>%1 wurde nicht gefunden. Gesucht wurde: %2.</translation>
    </message>
    <message>
        <source>no D-Bus: %1</source>
        <translation>kein D-Bus: %1</translation>
    </message>
    <message>
        <source>it does not answer: %1</source>
        <translation>Es antwortet nicht: %1</translation>
    </message>
    <message>
        <source>it grants no priority</source>
        <translation>Es gewährt keine Priorität</translation>
    </message>
    <message>
        <source>RLIMIT_RTTIME cannot be set</source>
        <translation>RLIMIT_RTTIME lässt sich nicht setzen</translation>
    </message>
    <message>
        <source>it agreed, but nothing changed</source>
        <translation>Es stimmte zu, aber nichts änderte sich</translation>
    </message>
    <message>
        <source>The servo has never been tested on macOS: the latency that it reports is all that is known.</source>
        <translation>Unter macOS wurde der Servo nie erprobt: Die Latenz, die er meldet, ist alles, was bekannt ist.</translation>
    </message>
    <message>
        <source>time constraint</source>
        <translation>Zeitvorgabe</translation>
    </message>
    <message>
        <source>untested</source>
        <translation>nicht erprobt</translation>
    </message>
    <message>
        <source>The servo has never been tested on Windows: the latency that it reports is all that is known.</source>
        <translation>Unter Windows wurde der Servo nie erprobt: Die Latenz, die er meldet, ist alles, was bekannt ist.</translation>
    </message>
    <message>
        <source>time critical</source>
        <translation>zeitkritisch</translation>
    </message>
    <message>
        <source>The hand never touches the constraint.</source>
        <translation>Die Hand berührt die Bindung nie.</translation>
    </message>
    <message>
        <source>The run ended in a fault, so what it measured means nothing.</source>
        <translation>Der Lauf endete in einer Störung, also besagt nichts, was er maß.</translation>
    </message>
    <message>
        <source>Simulated arm</source>
        <translation>Simulierter Arm</translation>
    </message>
    <message>
        <source>Touch, Omni (vendor's driver)</source>
        <translation>Touch, Omni (Treiber des Herstellers)</translation>
    </message>
    <message>
        <source>WoodenHaptics (HID)</source>
        <translation>WoodenHaptics (HID)</translation>
    </message>
    <message>
        <source>Inverse3 (Haply's service)</source>
        <translation>Inverse3 (Haplys Dienst)</translation>
    </message>
    <message>
        <source>Arm over the network</source>
        <translation>Arm über das Netz</translation>
    </message>
    <message>
        <source>There is no arm of the kind "%1". Known kinds: %2.</source>
        <translation>Arme der Art „%1“ gibt es nicht. Bekannte Arten: %2.</translation>
    </message>
    <message>
        <source>The scene is for the arm "%1", which exists as a simulated arm only. Choose the simulated arm, or open another scene first.</source>
        <translation>Die Szene ist für den Arm „%1“, den es nur simuliert gibt. Wählen Sie den simulierten Arm, oder öffnen Sie zuerst eine andere Szene.</translation>
    </message>
    <message>
        <source>"%1" is not an address of Haply's service. Give HOST:PORT or HOST, and /ID for one of several arms, as in 127.0.0.1:10001 or 127.0.0.1:10001/04C3.</source>
        <translation>„%1“ ist keine Adresse von Haplys Dienst. Geben Sie HOST:PORT oder HOST an, und /ID für einen von mehreren Armen, etwa 127.0.0.1:10001 oder 127.0.0.1:10001/04C3.</translation>
    </message>
    <message>
        <source>Inverse3 %1 at %2</source>
        <translation>Inverse3 %1 unter %2</translation>
    </message>
    <message>
        <source>Haply's service at %1 has no Inverse3. Plug it in, switch it on, and open it again.</source>
        <translation>Haplys Dienst unter %1 hat keinen Inverse3. Schließen Sie ihn an, schalten Sie ihn ein und öffnen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>Haply's service at %1 has no Inverse3 "%2". It has: %3.</source>
        <translation>Haplys Dienst unter %1 hat keinen Inverse3 „%2“. Er hat: %3.</translation>
    </message>
    <message>
        <source>What answers at %1 does not say where an Inverse3 is. Is it Haply's service?</source>
        <translation>Was unter %1 antwortet, sagt nicht, wo ein Inverse3 ist. Ist es Haplys Dienst?</translation>
    </message>
    <message>
        <source>Haply's service at %1 tells places in the axes %2. Set the basis of the Inverse3 to XYZ there.</source>
        <translation>Haplys Dienst unter %1 gibt Positionen in den Achsen %2 an. Stellen Sie dort die Basis des Inverse3 auf XYZ.</translation>
    </message>
    <message>
        <source>The connection to Haply's service at %1 was lost. Start the service and press Restart.</source>
        <translation>Die Verbindung zu Haplys Dienst unter %1 ist abgebrochen. Starten Sie den Dienst und drücken Sie Neustart.</translation>
    </message>
    <message>
        <source>Haply's service at %1 no longer has the Inverse3. Plug it in, switch it on, and press Restart.</source>
        <translation>Haplys Dienst unter %1 hat den Inverse3 nicht mehr. Schließen Sie ihn an, schalten Sie ihn ein und drücken Sie Neustart.</translation>
    </message>
    <message>
        <source>Haply's service at %1 sends messages that are not understood. Restart the service and press Restart.</source>
        <translation>Haplys Dienst unter %1 sendet Nachrichten, die nicht verstanden werden. Starten Sie den Dienst neu und drücken Sie Neustart.</translation>
    </message>
    <message>
        <source>Haply's service at %1 no longer says where the Inverse3 is. Check the service and press Restart.</source>
        <translation>Haplys Dienst unter %1 sagt nicht mehr, wo der Inverse3 ist. Prüfen Sie den Dienst und drücken Sie Neustart.</translation>
    </message>
    <message>
        <source>The Inverse3 has no power supply, so it gives no force. Connect it.</source>
        <translation>Der Inverse3 hat keine Stromversorgung und gibt deshalb keine Kraft. Schließen Sie sie an.</translation>
    </message>
    <message>
        <source>The Inverse3 is not calibrated, so it gives no force. Calibrate it as its manual says.</source>
        <translation>Der Inverse3 ist nicht kalibriert und gibt deshalb keine Kraft. Kalibrieren Sie ihn, wie sein Handbuch es beschreibt.</translation>
    </message>
    <message>
        <source>Haply's service says that the Inverse3 is not ready, so it gives no force.</source>
        <translation>Haplys Dienst meldet, dass der Inverse3 nicht bereit ist; deshalb gibt er keine Kraft.</translation>
    </message>
    <message>
        <source>No service of Haply answers at %1. Is it running there? Another address is given as haply:HOST:PORT.</source>
        <translation>Unter %1 antwortet kein Dienst von Haply. Läuft er dort? Eine andere Adresse wird als haply:HOST:PORT angegeben.</translation>
    </message>
    <message>
        <source>What answers at %1 is not Haply's service. Another address is given as haply:HOST:PORT.</source>
        <translation>Was unter %1 antwortet, ist nicht Haplys Dienst. Eine andere Adresse wird als haply:HOST:PORT angegeben.</translation>
    </message>
    <message>
        <source>Game controllers cannot be read here (%1). Mouse, keyboard and 3D mice still work. Controllers need an X11 display, or a Wayland desktop with Xwayland.</source>
        <translation>Gamepads können hier nicht gelesen werden (%1). Maus, Tastatur und 3D-Mäuse funktionieren trotzdem. Gamepads brauchen einen Bildschirm mit X11 oder eine Wayland-Umgebung mit Xwayland.</translation>
    </message>
    <message>
        <source>no reason given</source>
        <translation>ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>left stick, right</source>
        <translation>linker Stick, rechts</translation>
    </message>
    <message>
        <source>left stick, down</source>
        <translation>linker Stick, unten</translation>
    </message>
    <message>
        <source>right stick, right</source>
        <translation>rechter Stick, rechts</translation>
    </message>
    <message>
        <source>right stick, down</source>
        <translation>rechter Stick, unten</translation>
    </message>
    <message>
        <source>left trigger</source>
        <translation>linker Trigger</translation>
    </message>
    <message>
        <source>right trigger</source>
        <translation>rechter Trigger</translation>
    </message>
    <message>
        <source>left bumper</source>
        <translation>linke Schultertaste</translation>
    </message>
    <message>
        <source>right bumper</source>
        <translation>rechte Schultertaste</translation>
    </message>
    <message>
        <source>left stick</source>
        <translation>linker Stick</translation>
    </message>
    <message>
        <source>right stick</source>
        <translation>rechter Stick</translation>
    </message>
    <message>
        <source>D-pad up</source>
        <translation>Steuerkreuz oben</translation>
    </message>
    <message>
        <source>D-pad right</source>
        <translation>Steuerkreuz rechts</translation>
    </message>
    <message>
        <source>D-pad down</source>
        <translation>Steuerkreuz unten</translation>
    </message>
    <message>
        <source>D-pad left</source>
        <translation>Steuerkreuz links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>zu Ihnen</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>tilt back</source>
        <translation>nach hinten neigen</translation>
    </message>
    <message>
        <source>tilt right</source>
        <translation>nach rechts neigen</translation>
    </message>
    <message>
        <source>twist right</source>
        <translation>nach rechts drehen</translation>
    </message>
    <message>
        <source>a mapping</source>
        <translation>eine Belegung</translation>
    </message>
    <message>
        <source>This must lie between %1 and %2.</source>
        <translation>Dies muss zwischen %1 und %2 liegen.</translation>
    </message>
    <message>
        <source>a number, as in 0</source>
        <translation>eine Zahl wie 0</translation>
    </message>
    <message>
        <source>This must be a whole number from 0 to %1.</source>
        <translation>Dies muss eine ganze Zahl von 0 bis %1 sein.</translation>
    </message>
    <message>
        <source>a list of two, as in [4, 5]</source>
        <translation>eine Liste von zweien wie [4, 5]</translation>
    </message>
    <message>
        <source>This must be a list of two: one for the positive direction, one for the negative.</source>
        <translation>Dies muss eine Liste von zweien sein: eines für die positive, eines für die negative Richtung.</translation>
    </message>
    <message>
        <source>Give only one of "axis", "buttons" and "triggers".</source>
        <translation>Geben Sie nur eines von „axis“, „buttons“ und „triggers“ an.</translation>
    </message>
    <message>
        <source>a direction</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>the buttons of a mapping</source>
        <translation>die Tasten einer Belegung</translation>
    </message>
    <message>
        <source>You do not have permission to read %1.</source>
        <translation>Sie haben keine Berechtigung, %1 zu lesen.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>SpaceMouse Wireless (cable)</source>
        <translation>SpaceMouse Wireless (Kabel)</translation>
    </message>
    <message>
        <source>SpaceMouse Wireless (receiver)</source>
        <translation>SpaceMouse Wireless (Empfänger)</translation>
    </message>
    <message>
        <source>SpaceMouse Pro Wireless (cable)</source>
        <translation>SpaceMouse Pro Wireless (Kabel)</translation>
    </message>
    <message>
        <source>SpaceMouse Pro Wireless (receiver)</source>
        <translation>SpaceMouse Pro Wireless (Empfänger)</translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The stylus is in the inkwell, so the arm gives no force. Take it out.</source>
        <translation>Der Stift steckt im Tintenfass; deshalb gibt der Arm keine Kraft. Nehmen Sie ihn heraus.</translation>
    </message>
    <message>
        <source>The arm reports its tip %1 mm from where the scene's arm "%2" has it, so it gets no force: the force would point elsewhere. Choose the arm that is connected.</source>
        <translation>Der Arm meldet seine Spitze %1 mm neben dem Ort, an dem der Arm „%2“ der Szene sie hat; deshalb bekommt er keine Kraft: Sie würde woandershin zeigen. Wählen Sie den Arm, der angeschlossen ist.</translation>
    </message>
    <message>
        <source>%1 times so far.</source>
        <translation>Bisher %1-mal.</translation>
    </message>
    <message>
        <source>The arm reports its tip %1 mm from where the scene's arm "%2" has it. Choose the arm that is connected, otherwise shapes are felt elsewhere than they are shown.</source>
        <translation>Der Arm meldet seine Spitze %1 mm neben dem Ort, an dem der Arm „%2“ der Szene sie hat. Wählen Sie den Arm, der angeschlossen ist; sonst fühlt man Formen woanders, als sie gezeigt werden.</translation>
    </message>
    <message>
        <source>The arm is not calibrated, so it gives no force. Put the stylus into the inkwell.</source>
        <translation>Der Arm ist nicht kalibriert und gibt deshalb keine Kraft. Stecken Sie den Stift in das Tintenfass.</translation>
    </message>
    <message>
        <source>The arm is not calibrated, so it gives no force. Hold it in its reset position, as the vendor's manual shows, and press the stylus button nearer to the tip.</source>
        <translation>Der Arm ist nicht kalibriert und gibt deshalb keine Kraft. Halten Sie ihn in seiner Nullstellung, wie es das Handbuch des Herstellers zeigt, und drücken Sie die Stifttaste, die näher an der Spitze ist.</translation>
    </message>
    <message>
        <source>The arm is not calibrated, so it gives no force. Move the stylus around slowly until it is.</source>
        <translation>Der Arm ist nicht kalibriert und gibt deshalb keine Kraft. Bewegen Sie den Stift langsam umher, bis er es ist.</translation>
    </message>
    <message>
        <source>The arm does not say whether it is calibrated, so it gives no force. Run the vendor's setup.</source>
        <translation>Der Arm sagt nicht, ob er kalibriert ist, und gibt deshalb keine Kraft. Führen Sie das Einrichtungsprogramm des Herstellers aus.</translation>
    </message>
    <message>
        <source>The arm's driver refused a query that it should support. Report the arm's model.</source>
        <translation>Der Treiber des Arms hat eine Anfrage abgelehnt, die er unterstützen sollte. Melden Sie das Modell des Arms.</translation>
    </message>
    <message>
        <source>The arm's driver got out of step within a frame. Restart the servo.</source>
        <translation>Der Treiber des Arms ist in einem Frame aus dem Tritt gekommen. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver no longer knows the arm. Restart the servo.</source>
        <translation>Der Treiber des Arms kennt den Arm nicht mehr. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's motors are too warm, so its driver cuts the force. Let the arm cool down.</source>
        <translation>Die Motoren des Arms sind zu warm; deshalb nimmt sein Treiber die Kraft weg. Lassen Sie den Arm abkühlen.</translation>
    </message>
    <message>
        <source>The force exceeded what the arm can give, so its driver cut it. Make the scene softer.</source>
        <translation>Die Kraft war größer, als der Arm sie geben kann; deshalb hat sein Treiber sie weggenommen. Machen Sie die Szene weicher.</translation>
    </message>
    <message>
        <source>The force rose faster than the arm allows, so its driver cut it. Make the scene softer.</source>
        <translation>Die Kraft stieg schneller an, als der Arm es zulässt; deshalb hat sein Treiber sie weggenommen. Machen Sie die Szene weicher.</translation>
    </message>
    <message>
        <source>The stylus moved faster than the arm allows, so its driver cut the force.</source>
        <translation>Der Stift bewegte sich schneller, als der Arm es zulässt; deshalb hat sein Treiber die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The arm's driver cut the force. Start again; if that does not help, restart the servo.</source>
        <translation>Der Treiber des Arms hat die Kraft weggenommen. Drücken Sie noch einmal Start; hilft das nicht, starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm reports a fault of its own. Switch it off and on, then restart the servo.</source>
        <translation>Der Arm meldet eine eigene Störung. Schalten Sie ihn aus und wieder ein und starten Sie dann den Servo neu.</translation>
    </message>
    <message>
        <source>The arm is already open, here or in another program. Close that first.</source>
        <translation>Der Arm ist schon geöffnet, hier oder in einem anderen Programm. Schließen Sie ihn dort zuerst.</translation>
    </message>
    <message>
        <source>The arm does not answer. Check its cable and its power, then restart the servo.</source>
        <translation>Der Arm antwortet nicht. Prüfen Sie Kabel und Stromversorgung und starten Sie dann den Servo neu.</translation>
    </message>
    <message>
        <source>The arm cannot be reached with its driver's present settings. Run the vendor's setup, then restart the servo.</source>
        <translation>Mit den jetzigen Einstellungen seines Treibers ist der Arm nicht zu erreichen. Führen Sie das Einrichtungsprogramm des Herstellers aus und starten Sie dann den Servo neu.</translation>
    </message>
    <message>
        <source>The scheduler of the arm's driver failed. Restart the servo.</source>
        <translation>Der Taktgeber des Treibers ist ausgefallen. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver could not finish a frame. Restart the servo.</source>
        <translation>Der Treiber des Arms konnte einen Takt nicht beenden. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver refused access to its scheduler. Restart the servo.</source>
        <translation>Der Treiber des Arms hat den Zugriff auf seinen Taktgeber verweigert. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The scheduler of the arm's driver is full. Close other programs that use it, then restart the servo.</source>
        <translation>Der Taktgeber des Treibers ist voll belegt. Schließen Sie andere Programme, die ihn nutzen, und starten Sie dann den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver has no valid licence. Run the vendor's setup.</source>
        <translation>Der Treiber des Arms hat keine gültige Lizenz. Führen Sie das Einrichtungsprogramm des Herstellers aus.</translation>
    </message>
    <message>
        <source>The arm's driver keeps reporting errors. Quit the program and start it again.</source>
        <translation>Der Treiber des Arms meldet fortwährend Fehler. Beenden Sie das Programm und starten Sie es neu.</translation>
    </message>
    <message>
        <source>The arm sends angles that are not numbers. Restart the servo.</source>
        <translation>Der Arm sendet Winkel, die keine Zahlen sind. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver reports the unknown error %1. Restart the servo.</source>
        <translation>Der Treiber des Arms meldet den unbekannten Fehler %1. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The system has not created %1 for the arm. Plug it in again.</source>
        <translation>Das System hat %1 für den Arm nicht angelegt. Stecken Sie ihn neu an.</translation>
    </message>
    <message>
        <source>You do not have permission to use %1 of the arm. This rule gives it to whoever is logged in at the computer; plug the arm in again afterwards.</source>
        <translation>Sie haben keine Berechtigung, %1 des Arms zu benutzen. Diese Regel erteilt sie dem, der am Rechner angemeldet ist; stecken Sie den Arm danach neu an.</translation>
    </message>
    <message>
        <source>The vendor's driver has no settings: there is no folder config in %1 or %2, and GTDD_HOME names no other. Run the vendor's Touch_Setup, or set GTDD_HOME to the folder.</source>
        <translation>Der Treiber des Herstellers hat keine Einstellungen: Weder in %1 noch in %2 gibt es einen Ordner config, und GTDD_HOME nennt keinen anderen. Führen Sie Touch_Setup des Herstellers aus, oder setzen Sie GTDD_HOME auf den Ordner.</translation>
    </message>
    <message>
        <source>Touch or Omni on USB</source>
        <translation>Touch oder Omni an USB</translation>
    </message>
    <message>
        <source>Touch or Omni on USB, serial %1</source>
        <translation>Touch oder Omni an USB, Seriennummer %1</translation>
    </message>
    <message>
        <source>No Touch or Omni was found on USB. Plug it in and switch it on. An arm on FireWire or Ethernet is not detected here, but may still open.</source>
        <translation>An USB wurde kein Touch oder Omni gefunden. Stecken Sie ihn an und schalten Sie ihn ein. Ein Arm an FireWire oder Ethernet wird hier nicht erkannt, lässt sich aber vielleicht trotzdem öffnen.</translation>
    </message>
    <message>
        <source>In a terminal: "%1".</source>
        <translation>In einem Terminal: „%1“.</translation>
    </message>
    <message>
        <source>The library that was found is not OpenHaptics 3.0 to 3.4: it lacks %1.</source>
        <translation>Die gefundene Bibliothek ist nicht OpenHaptics 3.0 bis 3.4: Ihr fehlt %1.</translation>
    </message>
    <message>
        <source>The arm's driver cannot be loaded: %1.</source>
        <translation>Der Treiber des Arms kann nicht geladen werden: %1.</translation>
    </message>
    <message>
        <source>The vendor's driver, OpenHaptics, is not installed (%1 was not found). Get it for Linux from the maker of the arm, unpack it, and run its installer in its folder; then do the same with the arm's device driver.</source>
        <translation>Der Treiber des Herstellers, OpenHaptics, ist nicht installiert (%1 wurde nicht gefunden). Beziehen Sie ihn für Linux vom Hersteller des Arms, entpacken Sie ihn und führen Sie in seinem Ordner das Installationsprogramm aus; verfahren Sie dann ebenso mit dem Gerätetreiber des Arms.</translation>
    </message>
    <message>
        <source>The vendor's driver needs %1 from the old packages libncurses5 and libtinfo5, which are not installed.</source>
        <translation>Der Treiber des Herstellers braucht %1 aus den alten Paketen libncurses5 und libtinfo5, die nicht installiert sind.</translation>
    </message>
    <message>
        <source>The vendor's driver needs libusb, which is not installed.</source>
        <translation>Der Treiber des Herstellers braucht libusb, das nicht installiert ist.</translation>
    </message>
    <message>
        <source>OpenHaptics is installed, but %1 of the arm's device driver is not, or the system has not registered it yet. Install the device driver.</source>
        <translation>OpenHaptics ist installiert, aber %1 vom Gerätetreiber des Arms fehlt, oder das System hat es noch nicht registriert. Installieren Sie den Gerätetreiber.</translation>
    </message>
    <message>
        <source>The vendor's driver needs %1, which is missing.</source>
        <translation>Der Treiber des Herstellers braucht %1, das fehlt.</translation>
    </message>
    <message>
        <source>The scheduler of the arm's driver has stopped: it has made no call for half a second. Restart the servo; if that does not help, quit the program.</source>
        <translation>Der Taktgeber des Treibers steht still: Er hat sich seit einer halben Sekunde nicht gemeldet. Starten Sie den Servo neu; hilft das nicht, beenden Sie das Programm.</translation>
    </message>
    <message>
        <source>A call to the arm's driver has not returned, and the force may still be on. Switch the arm off, quit the program and start it again.</source>
        <translation>Ein Aufruf des Treibers ist nicht zurückgekehrt, und die Kraft kann noch an sein. Schalten Sie den Arm aus, beenden Sie das Programm und starten Sie es neu.</translation>
    </message>
    <message>
        <source>No arm could be opened.</source>
        <translation>Es konnte kein Arm geöffnet werden.</translation>
    </message>
    <message>
        <source>No arm could be opened under the name "%1".</source>
        <translation>Unter dem Namen „%1“ konnte kein Arm geöffnet werden.</translation>
    </message>
    <message>
        <source>Its driver gives no reason.</source>
        <translation>Sein Treiber nennt keinen Grund.</translation>
    </message>
    <message>
        <source>Its driver says: %1.</source>
        <translation>Sein Treiber sagt: %1.</translation>
    </message>
    <message>
        <source>The arm's force cannot be switched on.</source>
        <translation>Die Kraft des Arms lässt sich nicht einschalten.</translation>
    </message>
    <message>
        <source>The arm's driver supports only one rate, %1 Hz.</source>
        <translation>Der Treiber des Arms unterstützt nur eine Taktrate, %1 Hz.</translation>
    </message>
    <message>
        <source>%1 (vendor's driver)</source>
        <translation>%1 (Treiber des Herstellers)</translation>
    </message>
    <message>
        <source>The arm's driver did not accept the rate %1 Hz.</source>
        <translation>Der Treiber des Arms hat die Taktrate %1 Hz nicht angenommen.</translation>
    </message>
    <message>
        <source>The arm's driver accepts no rate at all. Restart the servo.</source>
        <translation>Der Treiber des Arms nimmt gar keine Taktrate an. Starten Sie den Servo neu.</translation>
    </message>
    <message>
        <source>The arm's driver supports %1 Hz, not %2. Choose one of these rates.</source>
        <translation>Der Treiber des Arms unterstützt %1 Hz, nicht %2. Wählen Sie eine dieser Taktraten.</translation>
    </message>
    <message>
        <source>Another arm uses the same driver at %1 Hz, and both share one scheduler. Close one of them first.</source>
        <translation>Ein anderer Arm nutzt denselben Treiber mit %1 Hz, und beide haben einen gemeinsamen Taktgeber. Schließen Sie zuerst einen von ihnen.</translation>
    </message>
    <message>
        <source>Ticks %1 to %2 of this session are damaged; the arm stands still there.</source>
        <translation>Die Takte %1 bis %2 dieser Sitzung sind beschädigt; dort steht der Arm still.</translation>
    </message>
    <message>
        <source>Opening was cancelled before the whole session was read.</source>
        <translation>Das Öffnen wurde abgebrochen, bevor die ganze Sitzung gelesen war.</translation>
    </message>
    <message>
        <source>This session contains no ticks, so there is nothing to replay.</source>
        <translation>Diese Sitzung enthält keine Takte: Es gibt nichts wiederzugeben.</translation>
    </message>
    <message>
        <source>"%1" is not an address of a shared arm. Give HOST:PORT or HOST, as in 192.168.1.20:7878, arm-pc or [fe80::1]:7878.</source>
        <translation>„%1“ ist keine Adresse eines freigegebenen Arms. Geben Sie HOST:PORT oder HOST an, wie 192.168.1.20:7878, arm-pc oder [fe80::1]:7878.</translation>
    </message>
    <message>
        <source>The arm at %1 is not shared with you: your key is not known there. Here, "underact-cli share-arm --show-key" prints the line to run there.</source>
        <translation>Der Arm bei %1 ist nicht für Sie freigegeben: Ihr Schlüssel ist dort nicht bekannt. „underact-cli share-arm --show-key“ gibt hier die Zeile aus, die dort auszuführen ist.</translation>
    </message>
    <message>
        <source>What answers at %1 is not the arm whose key is known here. If it was given a new key, run the line that "underact-cli share-arm" prints there; if not, somebody else is answering in its place.</source>
        <translation>Was bei %1 antwortet, ist nicht der Arm, dessen Schlüssel hier bekannt ist. Hat er einen neuen Schlüssel bekommen, führen Sie die Zeile aus, die „underact-cli share-arm“ dort ausgibt; wenn nicht, antwortet jemand anders an seiner Stelle.</translation>
    </message>
    <message>
        <source>No arm is shared at %1. Is that computer on, does "underact-cli share-arm" run there, and is it listening for others (--listen)?</source>
        <translation>Bei %1 ist kein Arm freigegeben. Ist jener Rechner an, läuft „underact-cli share-arm“ dort, und nimmt es Verbindungen anderer an (--listen)?</translation>
    </message>
    <message>
        <source>It is shared with version %1 of the protocol, and this program speaks %2. Install the same release of Underact at both ends.</source>
        <translation>Er ist mit Version %1 des Protokolls freigegeben, und dieses Programm spricht Version %2. Installieren Sie an beiden Enden dieselbe Version von Underact.</translation>
    </message>
    <message>
        <source>The arm at %1: %2</source>
        <translation>Der Arm bei %1: %2</translation>
    </message>
    <message>
        <source>The arm at %1 does not answer, although its computer does. Restart "underact-cli share-arm" there.</source>
        <translation>Der Arm bei %1 antwortet nicht, obwohl sein Rechner antwortet. Starten Sie „underact-cli share-arm“ dort neu.</translation>
    </message>
    <message>
        <source>The key of the arm at %1 is not known here. "underact-cli share-arm" prints, at the arm's computer, the line to run here once.</source>
        <translation>Der Schlüssel des Arms bei %1 ist hier nicht bekannt. „underact-cli share-arm“ gibt am Rechner des Arms die Zeile aus, die hier einmal auszuführen ist.</translation>
    </message>
    <message>
        <source>This key file belongs to another user of this computer, so it is not used. Delete it, and find out who put it there.</source>
        <translation>Diese Schlüsseldatei gehört einem anderen Benutzer dieses Rechners und wird deshalb nicht benutzt. Löschen Sie sie, und stellen Sie fest, wer sie dort abgelegt hat.</translation>
    </message>
    <message>
        <source>%1 Run chmod 600 '%2' and, if somebody may have done so, %3.</source>
        <translation>%1 Führen Sie chmod 600 '%2' aus und, falls es jemand getan haben könnte: %3.</translation>
    </message>
    <message>
        <source>Others may read your secret key.</source>
        <translation>Andere können Ihren geheimen Schlüssel lesen.</translation>
    </message>
    <message>
        <source>underact-cli share-arm --new-key</source>
        <translation>underact-cli share-arm --new-key</translation>
    </message>
    <message>
        <source>Others may read or change who may use your arm.</source>
        <translation>Andere können lesen oder ändern, wer Ihren Arm benutzen darf.</translation>
    </message>
    <message>
        <source>delete each line in it that you do not know</source>
        <translation>löschen Sie darin jede Zeile, die Sie nicht kennen</translation>
    </message>
    <message>
        <source>Others may read or change which arms you trust.</source>
        <translation>Andere können lesen oder ändern, welchen Armen Sie vertrauen.</translation>
    </message>
    <message>
        <source>a key</source>
        <translation>ein Schlüssel</translation>
    </message>
    <message>
        <source>The key file cannot be read.</source>
        <translation>Die Schlüsseldatei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The key file cannot be written: %1.</source>
        <translation>Die Schlüsseldatei kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>"%1" is not a key. A key has 40 characters; "underact-cli share-arm --show-key" prints it. Put it in single quotes, since some of its characters have a meaning in a shell.</source>
        <translation>„%1“ ist kein Schlüssel. Ein Schlüssel hat 40 Zeichen; „underact-cli share-arm --show-key“ gibt ihn aus. Setzen Sie ihn in einfache Anführungszeichen, denn manche der Zeichen haben für eine Shell eine Bedeutung.</translation>
    </message>
    <message>
        <source>The ZeroMQ library of this computer was built without CURVE, so no arm can be shared.</source>
        <translation>Die ZeroMQ-Bibliothek dieses Rechners wurde ohne CURVE gebaut; deshalb kann kein Arm freigegeben werden.</translation>
    </message>
    <message>
        <source>This is not a key pair. "underact-cli share-arm --new-key" makes a new one in its place.</source>
        <translation>Dies ist kein Schlüsselpaar. „underact-cli share-arm --new-key“ erzeugt ein neues an seiner Stelle.</translation>
    </message>
    <message>
        <source>A line must begin with a key of 40 characters.</source>
        <translation>Eine Zeile muss mit einem Schlüssel aus 40 Zeichen beginnen.</translation>
    </message>
    <message>
        <source>The key of %1 in this file is not valid.</source>
        <translation>Der Schlüssel von %1 in dieser Datei ist ungültig.</translation>
    </message>
    <message>
        <source>%1, shared on this computer</source>
        <translation>%1, an diesem Rechner freigegeben</translation>
    </message>
    <message>
        <source>%1, shared on this computer, without force</source>
        <translation>%1, an diesem Rechner freigegeben, ohne Kraft</translation>
    </message>
    <message>
        <source>The arm at %1 ticks at %2 Hz, not at %3 Hz.</source>
        <translation>Der Arm bei %1 taktet mit %2 Hz und nicht mit %3 Hz.</translation>
    </message>
    <message>
        <source>The connection to the arm at %1 was lost. Check the network and the sharing program on its computer, then press Restart.</source>
        <translation>Die Verbindung zum Arm bei %1 ist abgebrochen. Prüfen Sie das Netz und das Programm, das ihn an seinem Rechner freigibt, und drücken Sie dann „Servo neu starten“.</translation>
    </message>
    <message>
        <source>The arm at %1 no longer sends anything. Check the network and the sharing program on its computer, then press Restart.</source>
        <translation>Vom Arm bei %1 kommt nichts mehr. Prüfen Sie das Netz und das Programm, das ihn an seinem Rechner freigibt, und drücken Sie dann „Servo neu starten“.</translation>
    </message>
    <message>
        <source>The arm at %1 keeps the rate that it was opened with. Choose the simulated arm, then the rate, and open it again.</source>
        <translation>Der Arm bei %1 behält die Taktrate, mit der er geöffnet wurde. Wählen Sie den simulierten Arm, dann die Taktrate, und öffnen Sie ihn wieder.</translation>
    </message>
    <message>
        <source>The arm at %1 no longer sends anything. Check the network and the sharing program on its computer.</source>
        <translation>Vom Arm bei %1 kommt nichts mehr. Prüfen Sie das Netz und das Programm, das ihn an seinem Rechner freigibt.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1 at %2, without force</source>
        <translation>%1 bei %2, ohne Kraft</translation>
    </message>
    <message>
        <source>No connection to %1: %2.</source>
        <translation>Keine Verbindung zu %1: %2.</translation>
    </message>
    <message>
        <source>Connections cannot be accepted at %1: %2. Is an arm already shared there? Choose another port with --listen HOST:PORT.</source>
        <translation>An %1 können keine Verbindungen angenommen werden: %2. Ist dort schon ein Arm freigegeben? Wählen Sie mit --listen HOST:PORT einen anderen Port.</translation>
    </message>
    <message>
        <source>Recorded arm: %1</source>
        <translation>Aufgezeichneter Arm: %1</translation>
    </message>
    <message>
        <source>A recording is being replayed. Close it, then change the rate.</source>
        <translation>Eine Aufzeichnung wird wiedergegeben. Schließen Sie sie und ändern Sie dann die Taktrate.</translation>
    </message>
    <message>
        <source>The arm "%1" of this session is another one in this version of the program. Run it with the version that recorded it.</source>
        <translation>Der Arm „%1“ dieser Sitzung ist in dieser Version des Programms ein anderer. Wiederholen Sie den Lauf mit der Version, die ihn aufgezeichnet hat.</translation>
    </message>
    <message>
        <source>This session's arm or rate is none that this version has.</source>
        <translation>Den Arm oder die Rate dieser Sitzung gibt es in dieser Version nicht.</translation>
    </message>
    <message>
        <source>This session does not say completely by which hand and on which arm model it was made: the file is damaged, or of a newer version.</source>
        <translation>Diese Sitzung gibt nicht vollständig an, mit welcher Hand und mit welchem Armmodell sie entstanden ist: Die Datei ist beschädigt oder stammt von einer neueren Version.</translation>
    </message>
    <message>
        <source>The simulated hand could not press the beam.</source>
        <translation>Die simulierte Hand konnte den Balken nicht drücken.</translation>
    </message>
    <message>
        <source>No WoodenHaptics arm is plugged in.</source>
        <translation>Es ist kein WoodenHaptics-Arm angeschlossen.</translation>
    </message>
    <message>
        <source>No WoodenHaptics arm with the serial number or path "%1" is plugged in.</source>
        <translation>Es ist kein WoodenHaptics-Arm mit der Seriennummer oder dem Pfad „%1“ angeschlossen.</translation>
    </message>
    <message>
        <source>Devices that may be one, and can be chosen by name: %1.</source>
        <translation>Geräte, die einer sein können und sich über ihren Namen wählen lassen: %1.</translation>
    </message>
    <message>
        <source>The WoodenHaptics arm was unplugged while it was being opened. Plug it in again.</source>
        <translation>Der WoodenHaptics-Arm wurde abgezogen, während er geöffnet wurde. Stecken Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>%1 sends reports of %2 bytes; those of a WoodenHaptics arm have 8, 14 or 64.</source>
        <translation>%1 sendet Berichte von %2 Bytes; die eines WoodenHaptics-Arms haben 8, 14 oder 64.</translation>
    </message>
    <message>
        <source>The WoodenHaptics arm at %1 sends nothing. Press the reset button on its board, or plug it in again.</source>
        <translation>Der WoodenHaptics-Arm an %1 sendet nichts. Drücken Sie die Reset-Taste seiner Platine, oder stecken Sie ihn neu an.</translation>
    </message>
    <message>
        <source>The kinematics of the arm "%1" are not published, so it cannot be used. WoodenHaptics arms can.</source>
        <translation>Die Kinematik des Arms „%1“ ist nicht veröffentlicht; deshalb kann er nicht verwendet werden. WoodenHaptics-Arme können es.</translation>
    </message>
    <message>
        <source>%1 is already in use, here or by another program of this kind.</source>
        <translation>%1 ist schon in Gebrauch, hier oder durch ein anderes Programm dieser Art.</translation>
    </message>
    <message>
        <source>You do not have permission to open %1. This command, in a terminal, grants it: %2</source>
        <translation>Sie haben keine Berechtigung, %1 zu öffnen. Dieser Befehl, in einem Terminal, erteilt sie: %2</translation>
    </message>
    <message>
        <source>%1 cannot be opened. Unplug it and plug it in again.</source>
        <translation>%1 kann nicht geöffnet werden. Ziehen Sie das Gerät ab und stecken Sie es neu an.</translation>
    </message>
    <message>
        <source>%1, serial %2</source>
        <translation>%1, Seriennummer %2</translation>
    </message>
    <message>
        <source>%1: perhaps a WoodenHaptics arm</source>
        <translation>%1: vielleicht ein WoodenHaptics-Arm</translation>
    </message>
    <message>
        <source>You do not have permission to open %1: the system's rules give it to nobody.</source>
        <translation>Sie haben keine Berechtigung, %1 zu öffnen: Die Regeln des Systems erteilen sie niemandem.</translation>
    </message>
    <message>
        <source>Unplug it, put it in its home posture (upper arm upright, forearm level, straight ahead), plug it in and press Restart.</source>
        <translation>Ziehen Sie ihn ab, bringen Sie ihn in seine Grundstellung (Oberarm senkrecht, Unterarm waagerecht, geradeaus), stecken Sie ihn an und drücken Sie „Servo neu starten“.</translation>
    </message>
    <message>
        <source>Put it in its home posture (upper arm upright, forearm level, straight ahead) and press the calibration button on its board.</source>
        <translation>Bringen Sie ihn in seine Grundstellung (Oberarm senkrecht, Unterarm waagerecht, geradeaus) und drücken Sie die Kalibriertaste seiner Platine.</translation>
    </message>
    <message>
        <source>The WoodenHaptics arm was unplugged, or its connection was lost. Plug it in and press Restart.</source>
        <translation>Der WoodenHaptics-Arm wurde abgezogen, oder seine Verbindung ist abgebrochen. Stecken Sie ihn an und drücken Sie „Servo neu starten“.</translation>
    </message>
    <message>
        <source>The WoodenHaptics arm is plugged in, but sends nothing. Press the reset button on its board, or plug it in again, and press Restart.</source>
        <translation>Der WoodenHaptics-Arm ist angeschlossen, sendet aber nichts. Drücken Sie die Reset-Taste seiner Platine, oder stecken Sie ihn neu an, und drücken Sie „Servo neu starten“.</translation>
    </message>
    <message>
        <source>The WoodenHaptics arm does not know its posture, so it gives no force.</source>
        <translation>Der WoodenHaptics-Arm kennt seine Stellung nicht und gibt deshalb keine Kraft.</translation>
    </message>
</context>
<context>
    <name>purpose</name>
    <message>
        <source>Demonstrate</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Let visitors feel scenes.</source>
        <translation>Besucher Szenen fühlen lassen.</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Unterrichten</translation>
    </message>
    <message>
        <source>Explain kinematics and haptics to a class, with lessons.</source>
        <translation>Einer Klasse Kinematik und Haptik erklären, mit Lektionen.</translation>
    </message>
    <message>
        <source>Research</source>
        <translation>Forschen</translation>
    </message>
    <message>
        <source>Record, measure and compare.</source>
        <translation>Aufzeichnen, messen und vergleichen.</translation>
    </message>
</context>
<context>
    <name>scene text</name>
    <message>
        <source>Free space</source>
        <translation>Freier Raum</translation>
    </message>
    <message>
        <source>Nothing holds the stylus here; there is only a floor far below. For lessons about the motion of the arm, not about forces.</source>
        <translation>Hier hält nichts den Stift; es gibt nur einen Boden weit unten. Für Lektionen über die Bewegung des Arms, nicht über Kräfte.</translation>
    </message>
    <message>
        <source>SCARA in free space</source>
        <translation>SCARA im freien Raum</translation>
    </message>
    <message>
        <source>Nothing holds the tip here; there is only a floor below the arm. For lessons about the motion of the arm, not about forces.</source>
        <translation>Nichts hält hier die Spitze; es gibt nur einen Boden unter dem Arm. Für Lektionen über die Bewegung des Arms, nicht über Kräfte.</translation>
    </message>
    <message>
        <source>UR5e in free space</source>
        <translation>UR5e im freien Raum</translation>
    </message>
    <message>
        <source>Three links held at a point</source>
        <translation>Drei Glieder, an einem Punkt gehalten</translation>
    </message>
    <message>
        <source>The tip of three links in a plane is held to a point. The links can still move.</source>
        <translation>Die Spitze von drei Gliedern in einer Ebene wird an einem Punkt gehalten. Die Glieder können sich noch bewegen.</translation>
    </message>
    <message>
        <source>Soft spring</source>
        <translation>Weiche Feder</translation>
    </message>
    <message>
        <source>A soft spring ties the stylus to the middle of the workspace. It is soft enough for you to see how the force grows with the displacement before the arm reaches its limit of 0.88 N.</source>
        <translation>Eine weiche Feder verbindet den Stift mit der Mitte des Arbeitsraums. Sie ist so weich, dass Sie sehen, wie die Kraft mit dem Weg wächst, bevor der Arm seine Grenze von 0,88 N erreicht.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>A spring in space that pulls the stylus to one point. Thesis figures 4.2 and 4.3.</source>
        <translation>Eine Feder im Raum, die den Stift zu einem Punkt zieht. Thesis, Abbildungen 4.2 und 4.3.</translation>
    </message>
    <message>
        <source>The same spring in every direction: the farther you pull, the harder it pulls back.</source>
        <translation>Dieselbe Feder in jeder Richtung: Je weiter Sie ziehen, desto stärker zieht sie zurück.</translation>
    </message>
    <message>
        <source>Pull the stylus 1 mm away, then 2 mm: the force doubles. Beyond 1.76 mm it grows no more, because the arm's limit of 0.88 N is reached.</source>
        <translation>Ziehen Sie den Stift 1 mm weg, dann 2 mm: Die Kraft verdoppelt sich. Ab 1,76 mm wächst sie nicht mehr, weil die Grenze des Arms von 0,88 N erreicht ist.</translation>
    </message>
    <message>
        <source>$f = k_p (q - p)$, where $p$ is the tip and $q$ the point</source>
        <translation>$f = k_p (q - p)$, dabei ist $p$ die Spitze und $q$ der Punkt</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>The stylus is held to the surface of a ball of 50 mm radius. Thesis figures 4.5 and 4.6.</source>
        <translation>Der Stift wird auf der Oberfläche einer Kugel mit 50 mm Radius gehalten. Thesis, Abbildungen 4.5 und 4.6.</translation>
    </message>
    <message>
        <source>A ball that holds you to its surface, from inside and from outside, and lets you slide along it.</source>
        <translation>Eine Kugel, die Sie von innen und von außen auf ihrer Oberfläche hält und Sie daran entlanggleiten lässt.</translation>
    </message>
    <message>
        <source>Slide all the way round. Then move to the centre: every point of the surface is equally near, and the pull is gone.</source>
        <translation>Gleiten Sie einmal ganz herum. Gehen Sie dann in die Mitte: Alle Punkte der Oberfläche sind gleich nah, und der Zug ist weg.</translation>
    </message>
    <message>
        <source>$q = c + r \frac{p - c}{|p - c|}$, $f = k_p (q - p)$</source>
        <translation>$q = c + r \frac{p - c}{|p - c|}$, $f = k_p (q - p)$</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>A straight wire that holds the stylus. Thesis figure 4.8.</source>
        <translation>Ein gerader Draht, der den Stift hält. Thesis, Abbildung 4.8.</translation>
    </message>
    <message>
        <source>You slide freely along the wire and are held across it.</source>
        <translation>Sie gleiten frei am Draht entlang und werden quer dazu gehalten.</translation>
    </message>
    <message>
        <source>Close your eyes and find out which way the wire runs. Then check in the view.</source>
        <translation>Schließen Sie die Augen und finden Sie heraus, wie der Draht verläuft. Prüfen Sie es dann in der Ansicht.</translation>
    </message>
    <message>
        <source>$q = p_0 + \frac{v \cdot (p - p_0)}{v \cdot v} v$, $f = k_p (q - p)$</source>
        <translation>$q = p_0 + \frac{v \cdot (p - p_0)}{v \cdot v} v$, $f = k_p (q - p)$</translation>
    </message>
    <message>
        <source>Tilted plane</source>
        <translation>Geneigte Ebene</translation>
    </message>
    <message>
        <source>A sheet tilted equally to all three axes. Thesis figure 4.10.</source>
        <translation>Ein Blatt, zu allen drei Achsen gleich geneigt. Thesis, Abbildung 4.10.</translation>
    </message>
    <message>
        <source>You slide freely over the sheet and are held to it from both sides.</source>
        <translation>Sie gleiten frei über das Blatt und werden von beiden Seiten daran gehalten.</translation>
    </message>
    <message>
        <source>Draw a circle on the sheet without looking. The green point is the point of the sheet nearest to your tip.</source>
        <translation>Zeichnen Sie ohne hinzusehen einen Kreis auf die Platte. Der grüne Punkt ist der Punkt der Platte, der Ihrer Spitze am nächsten liegt.</translation>
    </message>
    <message>
        <source>$q = p - \frac{n \cdot (p - p_0)}{n \cdot n} n$, $f = k_p (q - p)$</source>
        <translation>$q = p - \frac{n \cdot (p - p_0)}{n \cdot n} n$, $f = k_p (q - p)$</translation>
    </message>
    <message>
        <source>Circle in a tilted plane</source>
        <translation>Kreis in geneigter Ebene</translation>
    </message>
    <message>
        <source>A ring of 40 mm radius in a tilted plane. Thesis figure 4.12.</source>
        <translation>Ein Ring mit 40 mm Radius in einer geneigten Ebene. Thesis, Abbildung 4.12.</translation>
    </message>
    <message>
        <source>You slide freely around the ring; in the other two directions you are held.</source>
        <translation>Sie gleiten frei um den Ring; in den beiden anderen Richtungen werden Sie gehalten.</translation>
    </message>
    <message>
        <source>Follow the ring all the way round. Then move to its axis: every point of the ring is equally near, and the pull is gone.</source>
        <translation>Folgen Sie dem Ring einmal ganz herum. Gehen Sie dann zu seiner Achse: Alle Punkte des Rings sind gleich nah, und der Zug ist weg.</translation>
    </message>
    <message>
        <source>$d = p - c$, $e = d - (d \cdot a) a$, $q = c + r \frac{e}{|e|}$</source>
        <translation>$d = p - c$, $e = d - (d \cdot a) a$, $q = c + r \frac{e}{|e|}$</translation>
    </message>
    <message>
        <source>Tilted cylinder</source>
        <translation>Geneigter Zylinder</translation>
    </message>
    <message>
        <source>A tube of 30 mm radius without ends. Thesis figure 4.14.</source>
        <translation>Ein Rohr ohne Enden mit 30 mm Radius. Thesis, Abbildung 4.14.</translation>
    </message>
    <message>
        <source>You slide freely along the tube and around it.</source>
        <translation>Sie gleiten frei am Rohr entlang und darum herum.</translation>
    </message>
    <message>
        <source>Draw a helix: slide along the tube and around it at the same time. The ring of scene 05 allows only one of the two.</source>
        <translation>Zeichnen Sie eine Schraubenlinie: Gleiten Sie zugleich am Rohr entlang und darum herum. Der Ring der Szene 05 lässt nur eines von beiden zu.</translation>
    </message>
    <message>
        <source>$d = p - c$, $e = d - (d \cdot a) a$, $q = c + (d \cdot a) a + r \frac{e}{|e|}$</source>
        <translation>$d = p - c$, $e = d - (d \cdot a) a$, $q = c + (d \cdot a) a + r \frac{e}{|e|}$</translation>
    </message>
    <message>
        <source>Box from outside</source>
        <translation>Quader von außen</translation>
    </message>
    <message>
        <source>A solid box in mid-air.</source>
        <translation>Ein fester Kasten in der Luft.</translation>
    </message>
    <message>
        <source>Free in the air; firm faces, edges and corners where you push in.</source>
        <translation>Frei in der Luft; feste Flächen, Kanten und Ecken, wo Sie hineindrücken.</translation>
    </message>
    <message>
        <source>Stroke a face until you slip over the edge. Then push in past the middle: the opposite face is nearer there, and you come out on that side.</source>
        <translation>Streichen Sie über eine Fläche, bis Sie über die Kante gleiten. Drücken Sie dann über die Mitte hinaus: Dort ist die Fläche gegenüber näher, und Sie kommen dort heraus.</translation>
    </message>
    <message>
        <source>inside $f = k_p (q - p)$ with $q$ on the nearest face, outside $f = 0$</source>
        <translation>innen $f = k_p (q - p)$ mit $q$ auf der nächsten Fläche, außen $f = 0$</translation>
    </message>
    <message>
        <source>Room of six walls</source>
        <translation>Raum aus sechs Wänden</translation>
    </message>
    <message>
        <source>The classic haptic cube. At the start the stylus is outside and is pulled in.</source>
        <translation>Der klassische haptische Würfel. Am Anfang ist der Stift draußen und wird hineingezogen.</translation>
    </message>
    <message>
        <source>Free in the room, stopped by six walls.</source>
        <translation>Frei im Raum, aufgehalten von sechs Wänden.</translation>
    </message>
    <message>
        <source>Run along a wall into a corner and feel one, two, then three walls push at once.</source>
        <translation>Fahren Sie an einer Wand entlang in eine Ecke und fühlen Sie eine, zwei, dann drei Wände zugleich drücken.</translation>
    </message>
    <message>
        <source>$q_i = \min(\max(p_i, -30), 30)$ in mm for each axis, $f = k_p (q - p)$</source>
        <translation>$q_i = \min(\max(p_i, -30), 30)$ in mm für jede Achse, $f = k_p (q - p)$</translation>
    </message>
    <message>
        <source>Wall with damping</source>
        <translation>Wand mit Dämpfung</translation>
    </message>
    <message>
        <source>A floor 20 mm below the middle. You feel it only when you push into it; the damping takes the bounce out of the contact.</source>
        <translation>Ein Boden 20 mm unter der Mitte. Sie fühlen ihn nur, wenn Sie hineindrücken; die Dämpfung nimmt dem Kontakt das Federn.</translation>
    </message>
    <message>
        <source>A floor that does not bounce.</source>
        <translation>Ein Boden, der nicht prellt.</translation>
    </message>
    <message>
        <source>Tap the floor. Set the damping kd to 0 in the Feel panel, and tap again.</source>
        <translation>Tippen Sie auf den Boden. Stellen Sie im Bereich Fühlen die Dämpfung kd auf 0. Tippen Sie noch einmal.</translation>
    </message>
    <message>
        <source>below the floor $f = k_p e + k_d \frac{de}{dt}$ with $e = q - p$, above it $f = 0$</source>
        <translation>unter dem Boden $f = k_p e + k_d \frac{de}{dt}$ mit $e = q - p$, darüber $f = 0$</translation>
    </message>
    <message>
        <source>Two balls, the nearest one counts</source>
        <translation>Zwei Kugeln, die nähere zählt</translation>
    </message>
    <message>
        <source>The stylus is held to the nearer of two balls. With "combine" at "sum" both would pull at once.</source>
        <translation>Der Stift wird auf der näheren von zwei Kugeln gehalten. Mit „combine“ auf „sum“ würden beide zugleich ziehen.</translation>
    </message>
    <message>
        <source>Two balls; only the nearer one holds you.</source>
        <translation>Zwei Kugeln; nur die nähere hält Sie.</translation>
    </message>
    <message>
        <source>Pull slowly from one ball to the other. Halfway, one lets you go and the other catches you.</source>
        <translation>Ziehen Sie langsam von einer Kugel zur anderen. Auf halbem Weg lässt die eine Sie los, und die andere fängt Sie.</translation>
    </message>
    <message>
        <source>$f = k_p (q_j - p)$, where $j$ is the ball with the smallest $|q_j - p|$</source>
        <translation>$f = k_p (q_j - p)$, dabei ist $j$ die Kugel mit dem kleinsten $|q_j - p|$</translation>
    </message>
    <message>
        <source>Soft and stiff axes</source>
        <translation>Weiche und steife Achsen</translation>
    </message>
    <message>
        <source>One point with a spring for each axis. Thesis section 4.1, with the gain as a vector.</source>
        <translation>Ein Punkt mit einer Feder je Achse. Thesis, Abschnitt 4.1, mit der Verstärkung als Vektor.</translation>
    </message>
    <message>
        <source>Stiff to the sides, soft up and down, softer still back and forth.</source>
        <translation>Steif zu den Seiten, weich auf und ab, noch weicher vor und zurück.</translation>
    </message>
    <message>
        <source>Pull diagonally and watch the arrow: the force does not point along your pull.</source>
        <translation>Ziehen Sie schräg und beobachten Sie den Pfeil: Die Kraft zeigt nicht entlang Ihrem Zug.</translation>
    </message>
    <message>
        <source>$f_i = k_i (q_i - p_i)$ for $i = x, y, z$</source>
        <translation>$f_i = k_i (q_i - p_i)$ für $i = x, y, z$</translation>
    </message>
    <message>
        <source>Line with PID</source>
        <translation>Gerade mit PID</translation>
    </message>
    <message>
        <source>The wire of scene 03 with a PID control law. The integral accumulates the error, up to the limit of the arm.</source>
        <translation>Der Draht der Szene 03 mit PID-Regelgesetz. Das Integral summiert den Fehler auf, bis zur Grenze des Arms.</translation>
    </message>
    <message>
        <source>A force that keeps growing while you stay beside the wire, and overshoots when you let go.</source>
        <translation>Eine Kraft, die weiter wächst, solange Sie neben dem Draht bleiben, und überschwingt, wenn Sie loslassen.</translation>
    </message>
    <message>
        <source>Hold the stylus 1 mm off the wire for a few seconds and watch the force. Then set ki to 0 and repeat.</source>
        <translation>Halten Sie den Stift einige Sekunden lang 1 mm neben dem Draht und beobachten Sie die Kraft. Stellen Sie dann ki auf 0 und wiederholen Sie es.</translation>
    </message>
    <message>
        <source>$f = k_p e + k_d \frac{de}{dt} + k_i \int e \, dt$ with $e = q - p$</source>
        <translation>$f = k_p e + k_d \frac{de}{dt} + k_i \int e \, dt$ mit $e = q - p$</translation>
    </message>
    <message>
        <source>Sphere held by the joints</source>
        <translation>Kugel, gehalten von den Gelenken</translation>
    </message>
    <message>
        <source>The ball of scene 02, but the control law acts on the joint angles: it pulls each joint towards its angle at the target. Thesis section 4.1 calls this scheme more difficult; this is why.</source>
        <translation>Die Kugel der Szene 02, aber das Regelgesetz wirkt auf die Gelenkwinkel: Es zieht jedes Gelenk zu seinem Winkel am Ziel. Die Thesis, Abschnitt 4.1, nennt dieses Verfahren schwieriger; hier fühlt man, warum.</translation>
    </message>
    <message>
        <source>Soft in one direction, stiff in another, and never quite straight.</source>
        <translation>Weich in einer Richtung, steif in einer anderen, und nie ganz gerade.</translation>
    </message>
    <message>
        <source>Slide around the ball and compare with scene 02. The pull is oblique and carries you along.</source>
        <translation>Gleiten Sie um die Kugel und vergleichen Sie mit Szene 02. Der Zug ist schräg und trägt Sie mit.</translation>
    </message>
    <message>
        <source>$\tau = K (\theta_q - \theta)$, $f = J_p^{-T} \tau$</source>
        <translation>$\tau = K (\theta_q - \theta)$, $f = J_p^{-T} \tau$</translation>
    </message>
    <message>
        <source>Circle with influence</source>
        <translation>Kreis mit Einfluss</translation>
    </message>
    <message>
        <source>The target depends half on the position of the tip, half on where the stylus points. Point it along the axis of the circle, and only the position counts. Thesis section 5.1, figures 5.6 and 5.7.</source>
        <translation>Das Ziel hängt halb von der Position der Spitze ab und halb davon, wohin der Stift zeigt. Zeigt er entlang der Achse des Kreises, zählt nur die Position. Thesis, Abschnitt 5.1, Abbildungen 5.6 und 5.7.</translation>
    </message>
    <message>
        <source>Turn the stylus without moving it, and it is pulled around the ring.</source>
        <translation>Drehen Sie den Stift, ohne ihn zu bewegen, und er wird um den Ring gezogen.</translation>
    </message>
    <message>
        <source>Keep your hand still and turn the stylus with Ctrl and the mouse. Then set t to 0, then to 1, in the Feel panel.</source>
        <translation>Halten Sie die Hand still und drehen Sie den Stift mit Strg und der Maus. Stellen Sie dann im Bereich Fühlen t auf 0 und dann auf 1.</translation>
    </message>
    <message>
        <source>$\theta = \alpha + t (\beta - \alpha)$, $q = c + r (\cos\theta \, u + \sin\theta \, v)$; $\alpha$: the stylus, $\beta$: the tip, $\beta - \alpha$ by the shorter way</source>
        <translation>$\theta = \alpha + t (\beta - \alpha)$, $q = c + r (\cos\theta \, u + \sin\theta \, v)$; $\alpha$: der Stift, $\beta$: die Spitze, $\beta - \alpha$ auf dem kürzeren Weg</translation>
    </message>
    <message>
        <source>Cylinder with influence</source>
        <translation>Zylinder mit Einfluss</translation>
    </message>
    <message>
        <source>The influence of scene 14 on a tilted cylinder. Thesis section 5.1.</source>
        <translation>Der Einfluss der Szene 14 auf einem geneigten Zylinder. Thesis, Abschnitt 5.1.</translation>
    </message>
    <message>
        <source>You slide freely along the tube; around it you are pulled to where the stylus points.</source>
        <translation>Sie gleiten frei am Rohr entlang; um das Rohr werden Sie dorthin gezogen, wohin der Stift zeigt.</translation>
    </message>
    <message>
        <source>Slide along the tube without turning the stylus. Then turn it: it pulls you round.</source>
        <translation>Gleiten Sie das Rohr entlang, ohne den Stift zu drehen, und drehen Sie ihn dann: Es zieht Sie herum.</translation>
    </message>
    <message>
        <source>$\theta = \alpha + t (\beta - \alpha)$, $q = c + k a + r (\cos\theta \, u + \sin\theta \, v)$ with $k = (p - c) \cdot a$</source>
        <translation>$\theta = \alpha + t (\beta - \alpha)$, $q = c + k a + r (\cos\theta \, u + \sin\theta \, v)$ mit $k = (p - c) \cdot a$</translation>
    </message>
    <message>
        <source>A robot of one joint</source>
        <translation>Ein Roboter mit einem Gelenk</translation>
    </message>
    <message>
        <source>The end effector of a virtual robot with one joint and a link of 50 mm. It follows the position and the orientation of the stylus, each with its own stiffness: 0.5 N/mm and 250 N mm/rad, as in thesis section 5.2.</source>
        <translation>Der Endeffektor eines virtuellen Roboters mit einem Gelenk und einem Glied von 50 mm. Er folgt der Position und der Orientierung des Stifts, jeder mit eigener Steifigkeit: 0,5 N/mm und 250 N mm/rad wie in der Thesis, Abschnitt 5.2.</translation>
    </message>
    <message>
        <source>A robot with one joint that turns to where you are and to where you point.</source>
        <translation>Ein Roboter mit einem Gelenk, der sich dorthin dreht, wo Sie sind und wohin Sie zeigen.</translation>
    </message>
    <message>
        <source>Turn the stylus and let yourself be pulled around the rim. The corresponding moment is shown in the Robot panel but never sent.</source>
        <translation>Drehen Sie den Stift und lassen Sie sich am Rand herumziehen. Das zugehörige Moment wird im Bereich Roboter angezeigt, aber nie gesendet.</translation>
    </message>
    <message>
        <source>$V = \min_\theta (\frac{1}{2} k_p |e_p|^2 + \frac{1}{2} k_o e_o^2)$, $f = k_p (p_V - p)$</source>
        <translation>$V = \min_\theta (\frac{1}{2} k_p |e_p|^2 + \frac{1}{2} k_o e_o^2)$, $f = k_p (p_V - p)$</translation>
    </message>
    <message>
        <source>The same robot, the thesis's force law</source>
        <translation>Derselbe Roboter, das Kraftgesetz der Thesis</translation>
    </message>
    <message>
        <source>The robot of scene 16 with the thesis's own force law (code 5.2, misprints corrected): the joint follows the position of the stylus alone, and the orientation error pulls along the rim.</source>
        <translation>Der Roboter der Szene 16 mit dem Kraftgesetz der Thesis (Code 5.2, Druckfehler berichtigt): Das Gelenk folgt nur der Position des Stifts, und der Orientierungsfehler zieht am Rand entlang.</translation>
    </message>
    <message>
        <source>Almost the same as scene 16, but this law can give out more energy than it received.</source>
        <translation>Fast dasselbe wie Szene 16, aber dieses Gesetz kann mehr Energie abgeben, als es bekommen hat.</translation>
    </message>
    <message>
        <source>In both scenes, move around a small loop inside the circle without turning the stylus, and watch the energy in the plots.</source>
        <translation>Fahren Sie in beiden Szenen innerhalb des Kreises eine kleine Schleife, ohne den Stift zu drehen, und beobachten Sie die Energie in den Diagrammen.</translation>
    </message>
    <message>
        <source>$f = k_p (q - p) - \frac{k_o e_o}{L} t$, where $t$ is the tangent at the nearest point $q$ and $e_o = \theta_V - \theta_T$</source>
        <translation>$f = k_p (q - p) - \frac{k_o e_o}{L} t$, dabei ist $t$ die Tangente im nächsten Punkt $q$ und $e_o = \theta_V - \theta_T$</translation>
    </message>
    <message>
        <source>A sphere made of two joints</source>
        <translation>Eine Kugel aus zwei Gelenken</translation>
    </message>
    <message>
        <source>Two joints whose axes intersect at right angles: their end effector moves on a sphere of 40 mm radius. The orientation acts with 250 N mm/rad, the position with 0.5 N/mm.</source>
        <translation>Zwei Gelenke, deren Achsen sich rechtwinklig schneiden: Ihr Endeffektor bewegt sich auf einer Kugel mit 40 mm Radius. Die Orientierung wirkt mit 250 N mm/rad, die Position mit 0,5 N/mm.</translation>
    </message>
    <message>
        <source>A sphere made of two joints; where you point pulls you across it.</source>
        <translation>Eine Kugel aus zwei Gelenken; wohin Sie zeigen, zieht Sie auf ihr entlang.</translation>
    </message>
    <message>
        <source>Switch the solver from closed form to iterative in the Robot panel: it feels the same.</source>
        <translation>Stellen Sie im Bereich Roboter den Löser von der geschlossenen Form auf Iteration um: Es fühlt sich gleich an.</translation>
    </message>
    <message>
        <source>$n$ is the unit vector along $k_p R (p - c) + k_o z$, $q = c + R n$, $f = k_p (q - p)$</source>
        <translation>$n$ ist der Einheitsvektor entlang $k_p R (p - c) + k_o z$, $q = c + R n$, $f = k_p (q - p)$</translation>
    </message>
    <message>
        <source>Four bars, closed by the hand</source>
        <translation>Viergelenk, von der Hand geschlossen</translation>
    </message>
    <message>
        <source>Two robots whose end effectors meet at your stylus, the fourth joint of the linkage: a crank of 30 mm with a coupler of 70 mm, and a rocker of 50 mm, pivots 60 mm apart.</source>
        <translation>Zwei Roboter, deren Endeffektoren sich an Ihrem Stift treffen, dem vierten Gelenk des Getriebes: eine Kurbel von 30 mm mit einer Koppel von 70 mm und eine Schwinge von 50 mm, Drehpunkte 60 mm voneinander entfernt.</translation>
    </message>
    <message>
        <source>You swing on the rocker's circle, as far as crank and coupler reach.</source>
        <translation>Sie schwingen auf dem Kreis der Schwinge, so weit Kurbel und Koppel reichen.</translation>
    </message>
    <message>
        <source>Swing to both ends. There crank and coupler are aligned, and you feel the dead centre.</source>
        <translation>Schwingen Sie zu beiden Enden. Dort liegen Kurbel und Koppel auf einer Geraden, und Sie fühlen den Totpunkt.</translation>
    </message>
    <message>
        <source>$f = k_p (q_1 - p) + k_p (q_2 - p)$, one part from each chain</source>
        <translation>$f = k_p (q_1 - p) + k_p (q_2 - p)$, ein Teil von jeder Kette</translation>
    </message>
    <message>
        <source>SCARA</source>
        <translation>SCARA</translation>
    </message>
    <message>
        <source>An assembly robot: two revolute joints with vertical axes, a vertical prismatic joint and a rotating gripper.</source>
        <translation>Ein Montageroboter: zwei Drehgelenke mit senkrechten Achsen, ein senkrechtes Schubgelenk und ein drehbarer Greifer.</translation>
    </message>
    <message>
        <source>Free within the robot&apos;s reach; joint limits where it ends.</source>
        <translation>Frei innerhalb der Reichweite; Gelenkanschläge, wo sie endet.</translation>
    </message>
    <message>
        <source>Find the limits of the elbow and of the prismatic joint, 25 mm up and down, and the rim where the arm is stretched.</source>
        <translation>Suchen Sie die Grenzen des Ellbogens und des Schubgelenks, 25 mm nach oben und unten, und den Rand, an dem der Arm gestreckt ist.</translation>
    </message>
    <message>
        <source>$J^T K e = 0$: the robot's joints carry no load; where one is at its limit, the hand does</source>
        <translation>$J^T K e = 0$: Die Gelenke des Roboters tragen keine Last; wo eines an seiner Grenze ist, trägt sie die Hand</translation>
    </message>
    <message>
        <source>PUMA 560, a quarter of its size</source>
        <translation>PUMA 560, ein Viertel so groß</translation>
    </message>
    <message>
        <source>The classic robot of robotics courses, at a scale of 1:4 (lengths after Armstrong, Khatib and Burdick 1986).</source>
        <translation>Der klassische Roboter der Robotikvorlesungen im Maßstab 1:4 (Längen nach Armstrong, Khatib und Burdick 1986).</translation>
    </message>
    <message>
        <source>Six joints follow six coordinates: free within the reach, held at its edge.</source>
        <translation>Sechs Gelenke folgen sechs Koordinaten: innen frei, am Rand der Reichweite gehalten.</translation>
    </message>
    <message>
        <source>Stretch the elbow, then turn the stylus as far as the wrist allows.</source>
        <translation>Strecken Sie den Ellbogen und drehen Sie dann den Stift, so weit das Handgelenk geht.</translation>
    </message>
    <message>
        <source>$J^T K e = 0$ with a regular $J$ of six columns means $e = 0$, so $f = 0$</source>
        <translation>$J^T K e = 0$ mit regulärem $J$ aus sechs Spalten heißt $e = 0$, also $f = 0$</translation>
    </message>
    <message>
        <source>Six joints, out of reach</source>
        <translation>Sechs Gelenke, außer Reichweite</translation>
    </message>
    <message>
        <source>The arm's own kinematic chain at a third of its size, placed on the left: it reaches 92 mm. In most of the workspace your stylus is out of its reach.</source>
        <translation>Die kinematische Kette des Arms selbst auf ein Drittel verkleinert, links aufgestellt: Sie reicht 92 mm weit. Im größten Teil des Arbeitsraums ist Ihr Stift außer Reichweite.</translation>
    </message>
    <message>
        <source>A small arm that cannot reach you: stretched out, it points at you and pulls.</source>
        <translation>Ein kleiner Arm, der Sie nicht erreicht: Gestreckt zeigt er auf Sie und zieht.</translation>
    </message>
    <message>
        <source>Move left into its reach: it lets you go. Outside it, turn the stylus: the arm still follows the orientation.</source>
        <translation>Gehen Sie nach links in seine Reichweite: Er lässt Sie los. Drehen Sie außerhalb davon den Stift: Er folgt weiter der Orientierung.</translation>
    </message>
    <message>
        <source>$f = k_p (\ell - |p - s|) \frac{p - s}{|p - s|}$ where $|p - s| &gt; \ell$; $s$: its shoulder, $\ell$: its length</source>
        <translation>$f = k_p (\ell - |p - s|) \frac{p - s}{|p - s|}$ bei $|p - s| &gt; \ell$; $s$: seine Schulter, $\ell$: seine Länge</translation>
    </message>
    <message>
        <source>Two beams, one softer</source>
        <translation>Zwei Balken, einer weicher</translation>
    </message>
    <message>
        <source>Two cantilever beams, 70 mm long, clamped at the back. To bend by 1 mm, the left one takes 0.03 N at its tip, the right one 0.045 N (EI = k L^3 / 3: 3430 and 5145 N mm^2). Each beam is a robot with one elastic joint and a link of 0.85 L (Howell's pseudo-rigid-body model, 2001), within half a percent of the beam's deflection curve. The panel Threshold measures how small a difference you can feel.</source>
        <translation>Zwei Kragbalken, 70 mm lang, hinten eingespannt. Um 1 mm biegen sich der linke bei 0,03 N an der Spitze und der rechte bei 0,045 N (EI = k L^3 / 3: 3430 und 5145 N mm^2). Jeder Balken ist ein Roboter mit einem elastischen Gelenk und einem Glied von 0,85 L (Howells Pseudo-Starrkörper-Modell, 2001), auf ein halbes Prozent genau auf der Biegelinie. Der Bereich Schwelle misst, wie kleine Unterschiede Sie fühlen.</translation>
    </message>
    <message>
        <source>Two beams that bend, one softer than the other.</source>
        <translation>Zwei Balken, die sich biegen, einer weicher als der andere.</translation>
    </message>
    <message>
        <source>Press both down equally far. Which one is stiffer? The left one, at 0.03 N/mm, is the softer.</source>
        <translation>Drücken Sie beide gleich weit nach unten. Welcher ist steifer? Der linke mit 0,03 N/mm ist der weichere.</translation>
    </message>
    <message>
        <source>$k = \frac{3 E I}{L^3}$</source>
        <translation>$k = \frac{3 E I}{L^3}$</translation>
    </message>
    <message>
        <source>Too stiff for its servo</source>
        <translation>Zu steif für seinen Servo</translation>
    </message>
    <message>
        <source>A ball whose surface is too stiff to be stable with ticks of a millisecond.</source>
        <translation>Eine Kugel, deren Oberfläche für Takte von einer Millisekunde zu steif ist, um stabil zu sein.</translation>
    </message>
    <message>
        <source>A surface too stiff for the servo loop: it buzzes, and gives out more energy than it received.</source>
        <translation>Eine Oberfläche, die für die Servoschleife zu steif ist: Sie brummt und gibt mehr Energie ab, als sie bekommen hat.</translation>
    </message>
    <message>
        <source>Move through the surface and along it, and watch the energy fall below 0. Then set Passivity to Control in the Feel panel.</source>
        <translation>Bewegen Sie sich durch die Oberfläche und daran entlang, und sehen Sie, wie die Energie unter 0 fällt. Stellen Sie dann im Bereich Fühlen die Passivität auf Regeln.</translation>
    </message>
    <message>
        <source>a wall is passive for any hand while $b &gt; \frac{K T}{2} + |B|$; $b$: the arm's damping, $T$: the duration of a tick</source>
        <translation>eine Wand ist für jede Hand passiv, solange $b &gt; \frac{K T}{2} + |B|$; $b$: die Dämpfung des Arms, $T$: die Dauer eines Takts</translation>
    </message>
    <message>
        <source>Torus knot</source>
        <translation>Torusknoten</translation>
    </message>
    <message>
        <source>A body from an STL file, felt from outside. meshes/ contains the same knot with 1000 and with 300 000 triangles: choose another file, and feel how little changes.</source>
        <translation>Ein Körper aus einer STL-Datei, von außen gefühlt. meshes/ enthält denselben Knoten mit 1000 und mit 300 000 Dreiecken: Wählen Sie eine andere Datei, und fühlen Sie, wie wenig sich ändert.</translation>
    </message>
    <message>
        <source>A tube that goes through its own hole three times.</source>
        <translation>Ein Rohr, das dreimal durch sein eigenes Loch geht.</translation>
    </message>
    <message>
        <source>Follow the tube round and round. However hard you press, you stay on the side you came from.</source>
        <translation>Folgen Sie dem Rohr immer weiter. Wie fest Sie auch drücken, Sie bleiben auf der Seite, von der Sie kamen.</translation>
    </message>
    <message>
        <source>$f = k_p (q - p)$, where $q$ stays on the surface and follows the tip; it sticks while $|f_t| \le \mu_s |f_n|$</source>
        <translation>$f = k_p (q - p)$, dabei bleibt $q$ auf der Oberfläche und folgt der Spitze; es haftet, solange $|f_t| \le \mu_s |f_n|$</translation>
    </message>
    <message>
        <source>Bumpy sphere</source>
        <translation>Kugel mit Höckern</translation>
    </message>
    <message>
        <source>A ball of flat triangles with bumps 1.5 mm high. Its faces are smoothed, so that the force turns with the surface and has no edges.</source>
        <translation>Eine Kugel aus ebenen Dreiecken mit 1,5 mm hohen Buckeln. Die Flächen sind geglättet, sodass die Kraft sich mit der Oberfläche dreht und keine Kanten hat.</translation>
    </message>
    <message>
        <source>Bumps on a ball that feels round, although it is made of flat triangles.</source>
        <translation>Buckel auf einer Kugel, die sich rund anfühlt, obwohl sie aus ebenen Dreiecken besteht.</translation>
    </message>
    <message>
        <source>Stroke the ball slowly and count the bumps across the width of a finger.</source>
        <translation>Streichen Sie langsam über die Kugel und zählen Sie die Höcker auf einer Fingerbreite.</translation>
    </message>
    <message>
        <source>$f = k_p e + k_d \frac{de}{dt}$ with $e = q - p$, where $q$ follows the tip on the surface</source>
        <translation>$f = k_p e + k_d \frac{de}{dt}$ mit $e = q - p$, dabei folgt $q$ der Spitze auf der Oberfläche</translation>
    </message>
    <message>
        <source>Bracket with holes</source>
        <translation>Winkel mit Löchern</translation>
    </message>
    <message>
        <source>A part with two screw holes and a rib. Static friction is greater than dynamic friction.</source>
        <translation>Ein Teil mit zwei Schraubenlöchern und einer Rippe. Die Haftreibung ist größer als die Gleitreibung.</translation>
    </message>
    <message>
        <source>Sharp edges, two holes, a rib, and friction that sticks and slips.</source>
        <translation>Scharfe Kanten, zwei Löcher, eine Rippe und Reibung, die haftet und gleitet.</translation>
    </message>
    <message>
        <source>Find the holes by touch, and slide along an edge until you slip off it. Then press and pull slowly: the target sticks and slips.</source>
        <translation>Ertasten Sie die Löcher, und gleiten Sie an einer Kante entlang, bis Sie abrutschen. Drücken Sie dann und ziehen Sie langsam: Das Ziel haftet und gleitet.</translation>
    </message>
    <message>
        <source>it sticks while $|f_t| \le \mu_s |f_n|$, then slides with $|f_t| = \mu_d |f_n|$; $\mu_s = 0.5$, $\mu_d = 0.3$</source>
        <translation>es haftet, solange $|f_t| \le \mu_s |f_n|$, und gleitet dann mit $|f_t| = \mu_d |f_n|$; $\mu_s = 0.5$, $\mu_d = 0.3$</translation>
    </message>
    <message>
        <source>Led along a trefoil</source>
        <translation>Am Kleeblatt geführt</translation>
    </message>
    <message>
        <source>A closed curve through the points of a file. A guide moves along it at 40 mm/s and waits for you 8 mm ahead.</source>
        <translation>Eine geschlossene Kurve durch die Punkte einer Datei. Eine Führung bewegt sich mit 40 mm/s auf ihr und wartet 8 mm vor Ihnen.</translation>
    </message>
    <message>
        <source>A guide that leads your hand along a closed curve and waits for you.</source>
        <translation>Eine Führung, die Ihre Hand eine geschlossene Kurve entlangführt und auf Sie wartet.</translation>
    </message>
    <message>
        <source>Let yourself be led. Hold your hand still: the guide stops 8 mm ahead. Then set t to 1 in the Feel panel: you are held to the curve, but no longer led.</source>
        <translation>Lassen Sie sich führen. Halten Sie die Hand still: Die Führung hält 8 mm vor Ihnen an. Stellen Sie dann im Bereich Fühlen t auf 1: Sie werden auf der Kurve gehalten, aber nicht mehr geführt.</translation>
    </message>
    <message>
        <source>$q = C(s)$; $\frac{ds}{dt} = 40$ mm/s as long as $s$ is less than 8 mm ahead of you</source>
        <translation>$q = C(s)$; $\frac{ds}{dt} = 40$ mm/s, solange $s$ weniger als 8 mm vor Ihnen liegt</translation>
    </message>
    <message>
        <source>A signature to follow</source>
        <translation>Eine Unterschrift zum Folgen</translation>
    </message>
    <message>
        <source>An open curve through the points of a file. The search is local, so that you do not switch branches where the stroke crosses itself.</source>
        <translation>Eine offene Kurve durch die Punkte einer Datei. Die Suche ist örtlich, sodass Sie dort, wo der Zug sich kreuzt, nicht den Ast wechseln.</translation>
    </message>
    <message>
        <source>A stroke to follow, with a little friction.</source>
        <translation>Ein Strich zum Folgen, mit ein wenig Reibung.</translation>
    </message>
    <message>
        <source>Follow the stroke over its own crossing: you stay on your branch.</source>
        <translation>Folgen Sie dem Strich über seine eigene Kreuzung: Sie bleiben auf Ihrem Zweig.</translation>
    </message>
    <message>
        <source>$q = C(s)$, where $s$ is the nearest point of the curve close to the previous one</source>
        <translation>$q = C(s)$, dabei ist $s$ die nächste Stelle der Kurve nahe der vorigen</translation>
    </message>
    <message>
        <source>UR5e above a table</source>
        <translation>UR5e über einem Tisch</translation>
    </message>
    <message>
        <source>Six joints, all driven, without a spherical wrist: a collaborative robot moved by hand. Its links weigh 17.7 kg, and its tool is pushed off a table. Simulated only.</source>
        <translation>Sechs Gelenke, alle angetrieben, ohne Kugelhandgelenk: ein kollaborativer Roboter, von Hand bewegt. Seine Glieder wiegen 17,7 kg, und sein Werkzeug wird von einem Tisch weggedrückt. Nur simuliert.</translation>
    </message>
    <message>
        <source>Much inertia and little spring: the arm follows the hand late, and the table stops it.</source>
        <translation>Viel Trägheit, wenig Feder: Der Arm folgt der Hand spät, und der Tisch hält ihn auf.</translation>
    </message>
    <message>
        <source>Push down onto the table, 10 mm below the tool, then slide along it. Open Kinematics: the same pose has up to eight sets of joint angles.</source>
        <translation>Drücken Sie nach unten auf den Tisch, 10 mm unter dem Werkzeug, und gleiten Sie dann an ihm entlang. Öffnen Sie Kinematik: Dieselbe Lage hat bis zu acht Sätze von Gelenkwinkeln.</translation>
    </message>
    <message>
        <source>$\tau = J_v^T f$: six torques for three numbers of force</source>
        <translation>$\tau = J_v^T f$: sechs Momente für drei Zahlen einer Kraft</translation>
    </message>
    <message>
        <source>UR10e in front of a wall</source>
        <translation>UR10e vor einer Wand</translation>
    </message>
    <message>
        <source>The larger sister of the UR5e, with the same axes and longer links. A vertical wall stands 19 mm in front of its tool. Simulated only.</source>
        <translation>Der größere Bruder des UR5e, mit denselben Achsen und längeren Gliedern. Eine senkrechte Wand steht 19 mm vor seinem Werkzeug. Nur simuliert.</translation>
    </message>
    <message>
        <source>A wall, and the inertia of an arm twice as heavy as a UR5e.</source>
        <translation>Eine Wand, und die Trägheit eines doppelt so schweren Arms wie ein UR5e.</translation>
    </message>
    <message>
        <source>Push forward, away from the base, into the wall. Compare how it moves with how the UR5e moves under the same pull.</source>
        <translation>Drücken Sie nach vorn, von der Basis weg, gegen die Wand. Vergleichen Sie die Bewegung mit der des UR5e bei gleichem Zug.</translation>
    </message>
    <message>
        <source>$M(q)\,\ddot q = \tau + J_v^T f_h$, where $f_h$ is the force of the hand</source>
        <translation>$M(q)\,\ddot q = \tau + J_v^T f_h$, wobei $f_h$ die Kraft der Hand ist</translation>
    </message>
    <message>
        <source>SCARA above a hole</source>
        <translation>SCARA über einem Loch</translation>
    </message>
    <message>
        <source>Two parallel joints, a vertical slide and a turn: four joints for assembly from above. The tip is kept inside a vertical hole. Simulated only.</source>
        <translation>Zwei parallele Gelenke, ein senkrechtes Schubgelenk und eine Drehung: vier Gelenke für die Montage von oben. Die Spitze bleibt in einem senkrechten Loch. Nur simuliert.</translation>
    </message>
    <message>
        <source>Free along the hole, with a wall all around.</source>
        <translation>Frei entlang dem Loch, ringsum eine Wand.</translation>
    </message>
    <message>
        <source>Move up and down: only the slide moves, along $z$. Then push sideways against the wall of the hole: only joints 1 and 2 feel it.</source>
        <translation>Bewegen Sie sich auf und ab: Nur das Schubgelenk bewegt sich, entlang $z$. Drücken Sie dann seitlich gegen die Wand des Lochs: Das wirkt nur auf Gelenk 1 und 2.</translation>
    </message>
    <message>
        <source>$\dot z = -\dot q_3$: only the slide moves the tip along $z$, and it moves it no other way</source>
        <translation>$\dot z = -\dot q_3$: Nur das Schubgelenk bewegt die Spitze entlang $z$, und nur dorthin</translation>
    </message>
    <message>
        <source>Three links in a plane</source>
        <translation>Drei Glieder in einer Ebene</translation>
    </message>
    <message>
        <source>Three parallel joints: the arm of the textbooks, easily drawn on paper. The tip is held to a circle in the plane of the arm. Simulated only.</source>
        <translation>Drei parallele Gelenke: der Arm der Lehrbücher, leicht aufs Papier gezeichnet. Die Spitze wird auf einem Kreis in der Ebene des Arms gehalten. Nur simuliert.</translation>
    </message>
    <message>
        <source>A groove around a circle, and no force out of the plane: no joint moves the tip there, so no motor pushes there.</source>
        <translation>Eine Rille im Kreis, und keine Kraft aus der Ebene heraus: Kein Gelenk bewegt die Spitze dorthin, also drückt auch kein Motor.</translation>
    </message>
    <message>
        <source>Pull the tip along the circle, then try to pull it out of the plane. With three joints for two coordinates, many postures have the same tip.</source>
        <translation>Ziehen Sie die Spitze den Kreis entlang, dann versuchen Sie, sie aus der Ebene zu ziehen. Mit drei Gelenken für zwei Koordinaten haben viele Haltungen dieselbe Spitze.</translation>
    </message>
    <message>
        <source>$f = J_v^{-T}\tau$ in the plane; $\tau$ cannot make a force along $z$</source>
        <translation>$f = J_v^{-T}\tau$ in der Ebene; $\tau$ kann keine Kraft entlang $z$ erzeugen</translation>
    </message>
    <message>
        <source>Stanford arm on a ball</source>
        <translation>Stanford-Arm auf einer Kugel</translation>
    </message>
    <message>
        <source>The arm of Scheinman, 1969: two turns, a slide of almost a metre, and a spherical wrist. The tip is pushed out of a ball. Simulated only.</source>
        <translation>Der Arm von Scheinman, 1969: zwei Drehungen, ein Schubgelenk von fast einem Meter und ein sphärisches Handgelenk. Eine Kugel stößt die Spitze ab. Nur simuliert.</translation>
    </message>
    <message>
        <source>A ball as on the Omni, with an arm that reaches by sliding.</source>
        <translation>Eine Kugel wie beim Omni, mit einem Arm, der durch Schieben reicht.</translation>
    </message>
    <message>
        <source>Push down into the ball, 10 mm below the tip. Pull the tip away from the base: joint 3 slides.</source>
        <translation>Drücken Sie nach unten in die Kugel, 10 mm unter der Spitze. Ziehen Sie die Spitze von der Basis weg: Gelenk 3 schiebt.</translation>
    </message>
    <message>
        <source>$J_v\,e_3 = a_3$: for a slide the column of the Jacobian is its axis</source>
        <translation>$J_v\,e_3 = a_3$: Bei einem Schubgelenk ist die Spalte der Jacobi-Matrix seine Achse</translation>
    </message>
    <message>
        <source>PUMA 560 along a line</source>
        <translation>PUMA 560 an einer Linie</translation>
    </message>
    <message>
        <source>The robot of the textbooks, with an offset shoulder and a spherical wrist. Its wrist centre is held to a line. Simulated only.</source>
        <translation>Der Roboter der Lehrbücher, mit versetzter Schulter und sphärischem Handgelenk. Sein Handwurzelpunkt wird an einer Linie gehalten. Nur simuliert.</translation>
    </message>
    <message>
        <source>You slide freely along the line; a spring pulls you back across it.</source>
        <translation>Sie gleiten frei an der Geraden entlang; quer dazu zieht eine Feder Sie zurück.</translation>
    </message>
    <message>
        <source>Pull along the line, then across it. Joints 4 to 6 have no part in it: their axes meet in the wrist centre, which is the tip here.</source>
        <translation>Ziehen Sie entlang der Linie, dann quer. Gelenk 4 bis 6 sind nicht beteiligt: Ihre Achsen schneiden sich im Handwurzelpunkt, der hier die Spitze ist.</translation>
    </message>
    <message>
        <source>$\dot p = J_p\,(\dot q_1, \dot q_2, \dot q_3)$</source>
        <translation>$\dot p = J_p\,(\dot q_1, \dot q_2, \dot q_3)$</translation>
    </message>
    <message>
        <source>IRB 120 around a circle</source>
        <translation>IRB 120 um einen Kreis</translation>
    </message>
    <message>
        <source>A small industrial robot with a spherical wrist 72 mm behind its flange. The flange is held to a vertical circle. Simulated only.</source>
        <translation>Ein kleiner Industrieroboter mit einem sphärischen Handgelenk 72 mm hinter seinem Flansch. Der Flansch wird an einem senkrechten Kreis gehalten. Nur simuliert.</translation>
    </message>
    <message>
        <source>A groove around a vertical circle.</source>
        <translation>Eine Rille in einem senkrechten Kreis.</translation>
    </message>
    <message>
        <source>Pull the flange around the circle. The wrist turns as well: it is not held, since the tip is 72 mm in front of it.</source>
        <translation>Ziehen Sie den Flansch um den Kreis. Das Handgelenk dreht sich mit: Es wird nicht gehalten, da die Spitze 72 mm davor liegt.</translation>
    </message>
    <message>
        <source>$\dot p = J_v\,\dot q$, six columns, none of them 0</source>
        <translation>$\dot p = J_v\,\dot q$, sechs Spalten, keine davon 0</translation>
    </message>
    <message>
        <source>KR 5 inside a box</source>
        <translation>KR 5 in einem Quader</translation>
    </message>
    <message>
        <source>A large industrial robot of 1.4 m reach. Its flange stays inside a box of 160 mm. Simulated only.</source>
        <translation>Ein großer Industrieroboter mit 1,4 m Reichweite. Sein Flansch bleibt in einem Würfel von 160 mm. Nur simuliert.</translation>
    </message>
    <message>
        <source>Free inside the box; each face pushes back like a spring.</source>
        <translation>Frei im Kasten; jede Fläche drückt zurück wie eine Feder.</translation>
    </message>
    <message>
        <source>Push against two faces at once, into an edge, then into a corner.</source>
        <translation>Drücken Sie gegen zwei Flächen zugleich, in eine Kante, dann in eine Ecke.</translation>
    </message>
    <message>
        <source>$f = k_p (q - p)$, $q$ on the nearest face</source>
        <translation>$f = k_p (q - p)$, $q$ auf der nächsten Fläche</translation>
    </message>
    <message>
        <source>Panda at a wall</source>
        <translation>Panda an einer Wand</translation>
    </message>
    <message>
        <source>Seven joints for six numbers. A wall stands 20 mm in front of the flange, like a cupboard to be wiped. Simulated only.</source>
        <translation>Sieben Gelenke für sechs Zahlen. 20 mm vor dem Flansch steht eine Wand, wie ein Schrank, den man abwischt. Nur simuliert.</translation>
    </message>
    <message>
        <source>Free, then a wall to slide along. The arm follows with seven joints, one more than it needs.</source>
        <translation>Frei, dann eine Wand zum Entlanggleiten. Der Arm folgt mit sieben Gelenken, einem mehr, als er braucht.</translation>
    </message>
    <message>
        <source>Slide up and down the wall, and watch the elbow. Open Kinematics: without a closed form, underact-cli ik searches, and finds a whole family of solutions.</source>
        <translation>Gleiten Sie an der Wand auf und ab, und achten Sie auf den Ellbogen. Öffnen Sie Kinematik: Ohne geschlossene Form sucht underact-cli ik und findet eine ganze Schar von Lösungen.</translation>
    </message>
    <message>
        <source>$\tau = J_v^T f$: seven torques for three numbers of force</source>
        <translation>$\tau = J_v^T f$: sieben Drehmomente für drei Zahlen der Kraft</translation>
    </message>
    <message>
        <source>An iiwa holds its pose</source>
        <translation>Ein iiwa hält seine Pose</translation>
    </message>
    <message>
        <source>The flange is held to a pose: its position by a force, its orientation by a moment, which this arm can render because all its joints are driven. The elbow stays free. Simulated only.</source>
        <translation>Der Flansch wird in einer Pose gehalten: sein Ort durch eine Kraft, seine Orientierung durch ein Moment, das dieser Arm ausüben kann, weil alle seine Gelenke angetrieben sind. Der Ellbogen bleibt frei. Nur simuliert.</translation>
    </message>
    <message>
        <source>A spring against every displacement and every rotation. The moment is limited to 500 N mm.</source>
        <translation>Eine Feder gegen jede Verschiebung und jede Drehung. Das Moment ist auf 500 N mm begrenzt.</translation>
    </message>
    <message>
        <source>Turn the tool with Ctrl and the arrow keys: the moment turns it back. Stop the servo and move joint 3 with its slider in the panel Kinematics: the elbow goes round, and the flange stays near its pose.</source>
        <translation>Drehen Sie das Werkzeug mit Strg und den Pfeiltasten: Das Moment dreht es zurück. Halten Sie den Servo an, und bewegen Sie Gelenk 3 mit seinem Regler im Bereich Kinematik: Der Ellbogen wandert herum, und der Flansch bleibt nahe seiner Pose.</translation>
    </message>
    <message>
        <source>$\tau = J_v^T f + J_\omega^T m$: seven torques for six numbers</source>
        <translation>$\tau = J_v^T f + J_\omega^T m$: sieben Drehmomente für sechs Zahlen</translation>
    </message>
</context>
<context>
    <name>scenes</name>
    <message>
        <source>Shapes</source>
        <translation>Formen</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>Virtual robots</source>
        <translation>Virtuelle Roboter</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Dreiecksnetze</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Other arms</source>
        <translation>Andere Arme</translation>
    </message>
</context>
<context>
    <name>setting</name>
    <message>
        <source>P, proportional</source>
        <translation>P, proportional</translation>
    </message>
    <message>
        <source>PD, with damping</source>
        <translation>PD, mit Dämpfung</translation>
    </message>
    <message>
        <source>PID, with integral</source>
        <translation>PID, mit Integral</translation>
    </message>
    <message>
        <source>least effort (weighted)</source>
        <translation>kleinster Aufwand (gewichtet)</translation>
    </message>
    <message>
        <source>least distance (euclidean)</source>
        <translation>kleinster Abstand (euklidisch)</translation>
    </message>
    <message>
        <source>observe</source>
        <translation>beobachten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>control</source>
        <translation>regeln</translation>
    </message>
    <message>
        <source>Cartesian (tip)</source>
        <translation>kartesisch (Spitze)</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Kalman</source>
        <translation>Kalman</translation>
    </message>
    <message>
        <source>low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>adaptive window</source>
        <translation>adaptives Fenster</translation>
    </message>
    <message>
        <source>raw difference</source>
        <translation>rohe Differenz</translation>
    </message>
    <message>
        <source>+z, from the tip to the hand</source>
        <translation>+z, von der Spitze zur Hand</translation>
    </message>
    <message>
        <source>−z, from the hand to the tip</source>
        <translation>−z, von der Hand zur Spitze</translation>
    </message>
    <message>
        <source>nearest overall</source>
        <translation>allernächster Punkt</translation>
    </message>
    <message>
        <source>nearest overall, by tree</source>
        <translation>allernächster Punkt, im Baum</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>entlang der Oberfläche</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>direction of z (axis)</source>
        <translation>Richtung von z (Achse)</translation>
    </message>
    <message>
        <source>angle about the joint</source>
        <translation>Winkel um das Gelenk</translation>
    </message>
    <message>
        <source>full orientation</source>
        <translation>volle Orientierung</translation>
    </message>
    <message>
        <source>energy, F = K e</source>
        <translation>Energie, F = K e</translation>
    </message>
    <message>
        <source>thesis 5.2</source>
        <translation>Thesis 5.2</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>iterative</source>
        <translation>iterativ</translation>
    </message>
    <message>
        <source>combination of forces</source>
        <translation>Zusammenwirken der Kräfte</translation>
    </message>
    <message>
        <source>The forces of all constraints are added, or only the constraint nearest to the stylus acts.</source>
        <translation>Die Kräfte aller Bindungen werden addiert, oder nur die dem Stift nächste Bindung wirkt.</translation>
    </message>
    <message>
        <source>integrator</source>
        <translation>Integrator</translation>
    </message>
    <message>
        <source>The integration method for a substep of the simulated arm.</source>
        <translation>Das Integrationsverfahren für einen Teilschritt des simulierten Arms.</translation>
    </message>
    <message>
        <source>substep</source>
        <translation>Teilschritt</translation>
    </message>
    <message>
        <source>The longest substep of the simulated arm, in microseconds.</source>
        <translation>Der längste Teilschritt des simulierten Arms, in Mikrosekunden.</translation>
    </message>
    <message>
        <source>us</source>
        <translation>µs</translation>
    </message>
    <message>
        <source>control law</source>
        <translation>Regelgesetz</translation>
    </message>
    <message>
        <source>P: f = kp e.  PD: f = kp e + kd de/dt.  PID: f = kp e + kd de/dt + integral of ki e.</source>
        <translation>P: f = kp e.  PD: f = kp e + kd de/dt.  PID: f = kp e + kd de/dt + Integral von ki e.</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Pulls the stylus back with this force for each millimetre of error: f = kp e (proportional gain).</source>
        <translation>Zieht den Stift je Millimeter Fehler mit dieser Kraft zurück: f = kp e (Proportionalverstärkung).</translation>
    </message>
    <message>
        <source>N/mm</source>
        <translation>N/mm</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Resists a change of the error: f = kd de/dt (derivative gain, for PD and PID).</source>
        <translation>Widersteht einer Änderung des Fehlers: f = kd de/dt (Differentialverstärkung, für PD und PID).</translation>
    </message>
    <message>
        <source>N s/mm</source>
        <translation>N s/mm</translation>
    </message>
    <message>
        <source>integral gain</source>
        <translation>Integralverstärkung</translation>
    </message>
    <message>
        <source>Removes an error that stays, over time: df/dt = ki e (integral gain, for PID).</source>
        <translation>Baut einen bleibenden Fehler mit der Zeit ab: df/dt = ki e (Integralverstärkung, für PID).</translation>
    </message>
    <message>
        <source>N/(mm s)</source>
        <translation>N/(mm s)</translation>
    </message>
    <message>
        <source>nearest point</source>
        <translation>nächster Punkt</translation>
    </message>
    <message>
        <source>With unequal gains the point of least effort is not the point of least distance. With least effort the stylus stays where it is put; with least distance, as in the thesis, it may creep.</source>
        <translation>Bei ungleichen Verstärkungen ist der Punkt des kleinsten Aufwands nicht der Punkt des kleinsten Abstands. Bei kleinstem Aufwand bleibt der Stift, wo er hingesetzt wird; bei kleinstem Abstand, wie in der Thesis, kann er kriechen.</translation>
    </message>
    <message>
        <source>passivity</source>
        <translation>Passivität</translation>
    </message>
    <message>
        <source>Observe: adds up the energy that the stylus puts into the constraint and gets back, E = sum of f dx; below 0 the wall is active. Control: also adds the missing damping.</source>
        <translation>Beobachten: summiert die Energie, die der Stift in die Bindung steckt und zurückbekommt, E = Summe von f dx; unter 0 ist die Wand aktiv. Regeln: fügt zudem die fehlende Dämpfung hinzu.</translation>
    </message>
    <message>
        <source>control space</source>
        <translation>Raum der Regelung</translation>
    </message>
    <message>
        <source>Cartesian: f = kp e at the tip, axis by axis. Joints: torques pull joints 1 to 3 to those of the target, tau = K (q* - q), f = J^-T tau; the gains are as felt in the middle of the workspace.</source>
        <translation>Kartesisch: f = kp e an der Spitze, Achse für Achse. Gelenke: Drehmomente ziehen die Gelenke 1 bis 3 zu denen des Ziels, tau = K (q* - q), f = J^-T tau; die Verstärkungen gelten, wie sie in der Mitte des Arbeitsraums zu fühlen sind.</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>Geschwindigkeitsfilter</translation>
    </message>
    <message>
        <source>How the rate de/dt is estimated from positions in encoder steps: each filter trades delay for noise in another way.</source>
        <translation>Wie die Rate de/dt aus Positionen in Encoderschritten geschätzt wird: Jeder Filter wägt Verzögerung und Rauschen anders ab.</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>The standard deviation of a sample.</source>
        <translation>Die Standardabweichung eines Messwerts.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>The acceleration expected of the hand: with more, the filter follows faster and is noisier.</source>
        <translation>Die von der Hand erwartete Beschleunigung: Bei mehr folgt der Filter schneller und rauscht stärker.</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>mm/s²</translation>
    </message>
    <message>
        <source>time constant</source>
        <translation>Zeitkonstante</translation>
    </message>
    <message>
        <source>Time constant tau of the low-pass, r' = (de/dt - r) / tau: its delay.</source>
        <translation>Zeitkonstante tau des Tiefpasses, r' = (de/dt - r) / tau: seine Verzögerung.</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>longest window</source>
        <translation>längstes Fenster</translation>
    </message>
    <message>
        <source>The longest window, in ticks: a longer one is smoother but adds delay.</source>
        <translation>Das längste Fenster, in Takten: Ein längeres glättet stärker, verzögert aber mehr.</translation>
    </message>
    <message>
        <source>ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>How far a sample may lie off the line through the ends of the window.</source>
        <translation>Wie weit ein Messwert neben der Geraden durch die Enden des Fensters liegen darf.</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Both: the stylus is held to the surface. Outside, inside: the stylus is free on that side, and a wall pushes it back from the other.</source>
        <translation>Beide: Der Stift wird an der Oberfläche gehalten. Außen, innen: Der Stift ist auf dieser Seite frei, und eine Wand drückt ihn von der anderen zurück.</translation>
    </message>
    <message>
        <source>influence t</source>
        <translation>Einfluss t</translation>
    </message>
    <message>
        <source>0: the point that the stylus points at; 1: the point nearest to the tip; between them along the shorter arc: theta = alpha + t wrap(beta - alpha).</source>
        <translation>0: der Punkt, auf den der Stift zeigt; 1: der Punkt, der der Spitze am nächsten ist; dazwischen entlang des kürzeren Bogens: theta = alpha + t wrap(beta - alpha).</translation>
    </message>
    <message>
        <source>stylus axis</source>
        <translation>Stiftachse</translation>
    </message>
    <message>
        <source>Which end of the stylus points at the shape: z of frame 6 points from the tip into the hand.</source>
        <translation>Mit welchem Ende der Stift auf die Form zeigt: z von Koordinatensystem 6 zeigt von der Spitze in die Hand.</translation>
    </message>
    <message>
        <source>blend width</source>
        <translation>Übergangsbreite</translation>
    </message>
    <message>
        <source>Within this angle of the shape's axis the stylus's direction counts less and less, and the target changes smoothly to position only.</source>
        <translation>Innerhalb dieses Winkels zur Achse der Form zählt die Richtung des Stifts immer weniger, und das Ziel geht glatt dazu über, nur der Position zu folgen.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>How firmly the target sticks: coefficient of static friction. It moves when the force along the surface exceeds this share of the force across it.</source>
        <translation>Wie fest das Ziel haftet: Haftreibungszahl. Es bewegt sich, wenn die Kraft entlang der Oberfläche diesen Anteil der Kraft senkrecht zu ihr übersteigt.</translation>
    </message>
    <message>
        <source>dynamic friction</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>How strongly the target drags while it slides: coefficient of dynamic friction, at most the static one.</source>
        <translation>Wie stark das Ziel beim Gleiten gebremst wird: Gleitreibungszahl, höchstens die Haftreibungszahl.</translation>
    </message>
    <message>
        <source>Nearest overall: the target may change to another part of the mesh or curve. Along the surface: it stays on the part it is on.</source>
        <translation>Allernächster Punkt: Das Ziel kann auf einen anderen Teil des Dreiecksnetzes oder der Kurve wechseln. Entlang der Oberfläche: Es bleibt auf dem Teil, auf dem es ist.</translation>
    </message>
    <message>
        <source>search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Bends between faces feel round: the force tilts by up to this angle from the face's own normal. Edges that bend by more stay sharp. 0: faces as they are.</source>
        <translation>Knicke zwischen Flächen fühlen sich rund an: Die Kraft neigt sich um bis zu diesen Winkel gegen die eigene Normale der Fläche. Kanten, die stärker knicken, bleiben scharf. 0: Flächen, wie sie sind.</translation>
    </message>
    <message>
        <source>kind of curve</source>
        <translation>Art der Kurve</translation>
    </message>
    <message>
        <source>How the points are joined: smoothly, or by straight lines.</source>
        <translation>Wie die Punkte verbunden sind: glatt oder durch gerade Strecken.</translation>
    </message>
    <message>
        <source>closed curve</source>
        <translation>geschlossene Kurve</translation>
    </message>
    <message>
        <source>The curve returns to its first point.</source>
        <translation>Die Kurve kehrt zu ihrem ersten Punkt zurück.</translation>
    </message>
    <message>
        <source>speed of the guide</source>
        <translation>Tempo der Führung</translation>
    </message>
    <message>
        <source>How fast the guide moves along the curve; in a scene file, a negative speed moves it backwards.</source>
        <translation>Wie schnell sich die Führung entlang der Kurve bewegt; in einer Szenendatei bewegt ein negatives Tempo sie rückwärts.</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>guide t</source>
        <translation>Führung t</translation>
    </message>
    <message>
        <source>0: to the guide; 1: to the point nearest to the tip; between them along the curve: s = s_guide + t (s_hand - s_guide).</source>
        <translation>0: zur Führung; 1: zum Punkt, der der Spitze am nächsten ist; dazwischen entlang der Kurve: s = s_guide + t (s_hand - s_guide).</translation>
    </message>
    <message>
        <source>lead of the guide</source>
        <translation>Vorlauf der Führung</translation>
    </message>
    <message>
        <source>How far ahead of the hand the guide may go before it waits.</source>
        <translation>Wie weit die Führung der Hand vorausgehen darf, bevor sie wartet.</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>None: e = (p, 0). Direction of z: e_o = z_V − z_T. Angle about the one revolute joint, as in the thesis. Full orientation: e_o is the rotation vector.</source>
        <translation>Keine: e = (p, 0). Richtung von z: e_o = z_V − z_T. Winkel um das eine Drehgelenk, wie in der Thesis. Volle Orientierung: e_o ist der Rotationsvektor.</translation>
    </message>
    <message>
        <source>rotational stiffness</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>How firmly the end effector's orientation follows the stylus's: it adds Kθ e_o² / 2 to the energy, so that the joints, and with them the end effector, go where the stylus points.</source>
        <translation>Wie fest die Orientierung des Endeffektors der des Stifts folgt: addiert Kθ e_o² / 2 zur Energie, sodass die Gelenke und mit ihnen der Endeffektor dorthin gehen, wohin der Stift zeigt.</translation>
    </message>
    <message>
        <source>N mm/rad</source>
        <translation>N mm/rad</translation>
    </message>
    <message>
        <source>force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>Energy: F = K e at the joints of least energy; no work is done around a closed path. Thesis 5.2, for one joint: F = kp e − (ko e_θ / L) t; it does work around a closed path.</source>
        <translation>Energie: F = K e bei den Gelenken kleinster Energie; auf einem geschlossenen Weg wird keine Arbeit verrichtet. Thesis 5.2, für ein Gelenk: F = kp e − (ko e_θ / L) t; auf einem geschlossenen Weg verrichtet es Arbeit.</translation>
    </message>
    <message>
        <source>solver method</source>
        <translation>Methode des Lösers</translation>
    </message>
    <message>
        <source>Automatic: a closed form where the chain has one (a circle, sphere, cylinder, line or plane), otherwise iteration (Levenberg and Marquardt, from the last tick's joints).</source>
        <translation>Automatisch: eine geschlossene Form, wo die Kette eine hat (Kreis, Kugel, Zylinder, Gerade oder Ebene), sonst Iteration (Levenberg und Marquardt, ab den Gelenken des letzten Takts).</translation>
    </message>
    <message>
        <source>solver steps</source>
        <translation>Schritte des Lösers</translation>
    </message>
    <message>
        <source>The most iterations in one tick, 1 to 100; the next tick goes on from there.</source>
        <translation>Die größte Zahl der Iterationen in einem Takt, 1 bis 100; der nächste Takt macht dort weiter.</translation>
    </message>
    <message>
        <source>solver tolerance</source>
        <translation>Toleranz des Lösers</translation>
    </message>
    <message>
        <source>The iteration ends when no joint would move by more than this: in rad, or as a fraction of the reach.</source>
        <translation>Die Iteration endet, wenn sich kein Gelenk um mehr als dies bewegen würde: in rad, oder als Anteil der Reichweite.</translation>
    </message>
    <message>
        <source>spring of the joint</source>
        <translation>Feder des Gelenks</translation>
    </message>
    <message>
        <source>The joint's own spring adds k (q - rest)^2 / 2 to the energy; 0: the joint moves freely.</source>
        <translation>Die eigene Feder des Gelenks trägt k (q - Ruhe)^2 / 2 zur Energie bei; 0: Das Gelenk bewegt sich frei.</translation>
    </message>
    <message>
        <source>lower limit of the joint</source>
        <translation>untere Grenze des Gelenks</translation>
    </message>
    <message>
        <source>The smallest value; none: no limit.</source>
        <translation>Der kleinste Wert; keiner: keine Grenze.</translation>
    </message>
    <message>
        <source>upper limit of the joint</source>
        <translation>obere Grenze des Gelenks</translation>
    </message>
    <message>
        <source>The largest value; none: no limit.</source>
        <translation>Der größte Wert; keiner: keine Grenze.</translation>
    </message>
    <message>
        <source>rest position of the joint</source>
        <translation>Ruhelage des Gelenks</translation>
    </message>
    <message>
        <source>Where the joint's spring exerts no force.</source>
        <translation>Wo die Feder des Gelenks keine Kraft ausübt.</translation>
    </message>
</context>
<context>
    <name>shape</name>
    <message>
        <source>Virtual robot</source>
        <translation>Virtueller Roboter</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Dreiecksnetz</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>Through</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>x axis</source>
        <translation>x-Achse</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Ellipsoid</source>
        <translation>Ellipsoid</translation>
    </message>
    <message>
        <source>Semi-axes</source>
        <translation>Halbachsen</translation>
    </message>
</context>
<context>
    <name>step</name>
    <message>
        <source>First order system response</source>
        <translation>Antwort eines Systems erster Ordnung</translation>
    </message>
    <message>
        <source>a/(s + a) ends at 1, 1/(s + a) at 1/a, 3a/(s + a) at 3; here a = 2.</source>
        <translation>a/(s + a) endet bei 1, 1/(s + a) bei 1/a, 3a/(s + a) bei 3; hier a = 2.</translation>
    </message>
    <message>
        <source>Generic second order responses</source>
        <translation>Antworten zweiter Ordnung</translation>
    </message>
    <message>
        <source>Damping ratios from 0 to 2 (twice critical), natural frequency 1 rad/s.</source>
        <translation>Dämpfungsgrade von 0 bis 2 (doppelt kritisch), Eigenfrequenz 1 rad/s.</translation>
    </message>
    <message>
        <source>Comparing third and second order responses</source>
        <translation>Dritte und zweite Ordnung im Vergleich</translation>
    </message>
    <message>
        <source>5/((s + 1)(s + 2)(s + 30)), the same without the fast part, and a second-order system with the same gain: at most 0.0014 apart.</source>
        <translation>5/((s + 1)(s + 2)(s + 30)), dasselbe ohne den schnellen Teil, und ein System zweiter Ordnung mit gleicher Verstärkung: höchstens 0.0014 auseinander.</translation>
    </message>
    <message>
        <source>third order</source>
        <translation>dritte Ordnung</translation>
    </message>
    <message>
        <source>without the fast part</source>
        <translation>ohne schnellen Teil</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>zweite Ordnung</translation>
    </message>
    <message>
        <source>First order system step response</source>
        <translation>Sprungantwort erster Ordnung</translation>
    </message>
    <message>
        <source>a/(s + a): rise ln 9 / a, settling ln 50 / a; here a = 1.</source>
        <translation>a/(s + a): Anstieg ln 9 / a, Einschwingen ln 50 / a; hier a = 1.</translation>
    </message>
    <message>
        <source>Second order system step response</source>
        <translation>Sprungantwort zweiter Ordnung</translation>
    </message>
    <message>
        <source>Rise, peak, overshoot of 38 % and settling; damping ratio 0.2943, natural frequency 1 rad/s.</source>
        <translation>Anstieg, Maximum, Überschwingen von 38 % und Einschwingen; Dämpfungsgrad 0,2943, Eigenfrequenz 1 rad/s.</translation>
    </message>
</context>
<context>
    <name>step of work</name>
    <message>
        <source>Preparing the picture</source>
        <translation>bereitet das Bild vor</translation>
    </message>
    <message>
        <source>Joining the points</source>
        <translation>verbindet die Punkte</translation>
    </message>
    <message>
        <source>reading points</source>
        <translation>liest Punkte</translation>
    </message>
    <message>
        <source>Building the tree</source>
        <translation>baut den Suchbaum</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>liest die Datei</translation>
    </message>
    <message>
        <source>Storing</source>
        <translation>legt ab</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>liest das Dreiecksnetz</translation>
    </message>
    <message>
        <source>Uniting parts that intersect</source>
        <translation>Teile, die sich durchdringen, werden vereinigt</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>The view</source>
        <translation>Die Ansicht</translation>
    </message>
    <message>
        <source>What you see here is what you feel, in the arm's own frame. Drag beside the stylus to rotate the view; use the wheel to zoom.</source>
        <translation>Was Sie hier sehen, ist das, was Sie fühlen, im eigenen Koordinatensystem des Arms. Ziehen Sie neben dem Stift, um die Ansicht zu drehen; zoomen Sie mit dem Rad.</translation>
    </message>
    <message>
        <source>The stylus</source>
        <translation>Der Stift</translation>
    </message>
    <message>
        <source>Drag it with the mouse to move the hand on the simulated arm; hold Ctrl to turn the stylus. The arrow is the force sent to the arm.</source>
        <translation>Ziehen Sie ihn mit der Maus, um die Hand am simulierten Arm zu bewegen; halten Sie Strg, um den Stift zu drehen. Der Pfeil ist die an den Arm gesendete Kraft.</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>The constraints to feel, in teaching order. Below the list you read what to feel, what to try, and the equation.</source>
        <translation>Die Bindungen zum Fühlen, in Lehrreihenfolge. Unter der Liste lesen Sie, was zu fühlen ist, was Sie probieren können, und die Gleichung.</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Fühlen</translation>
    </message>
    <message>
        <source>Stiffness, damping and more. You feel each change while you drag a slider; a double click restores the scene's own value.</source>
        <translation>Steifigkeit, Dämpfung und mehr. Sie fühlen jede Änderung, während Sie einen Schieberegler ziehen; ein Doppelklick stellt den eigenen Wert der Szene wieder her.</translation>
    </message>
    <message>
        <source>The status line</source>
        <translation>Die Statuszeile</translation>
    </message>
    <message>
        <source>Always up to date: the state of the servo and its rate, with latency and scheduling in the tip, the arm, and the force with its limit, as on the gauge in the view.</source>
        <translation>Immer aktuell: der Zustand des Servos und seine Rate, mit Latenz und Scheduling im Tipp, der Arm und die Kraft mit ihrer Grenze, wie auf der Anzeige in der Ansicht.</translation>
    </message>
    <message>
        <source>What you do</source>
        <translation>Was Sie tun</translation>
    </message>
    <message>
        <source>Demonstrate, Teach or Research: each shows the panels, menus and buttons that it takes. All panels, at the end of the rail, and Ctrl+Shift+P find the rest.</source>
        <translation>Vorführen, Unterrichten oder Forschen: jedes zeigt die Bereiche, Menüs und Knöpfe, die es braucht. „Alle Bereiche“ am Ende der Leiste und Strg+Umschalt+P finden den Rest.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Which arms are plugged in, what is missing to use one, and which one is in use. A real arm exerts no force until you press Start.</source>
        <translation>Welche Arme angeschlossen sind, was für ihre Nutzung fehlt und welcher in Gebrauch ist. Ein echter Arm übt keine Kraft aus, bis Sie Start drücken.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Opens the guide; F1 does so at the page for whatever has the focus. The Help menu also has the list of keys and this tour. Esc stops the force; Shift+Esc does so from anywhere.</source>
        <translation>Öffnet die Anleitung; F1 öffnet sie auf der Seite zu dem, was den Fokus hat. Das Hilfemenü enthält auch die Liste der Tasten und diesen Rundgang. Esc stoppt die Kraft; Umschalt+Esc tut es von überall.</translation>
    </message>
</context>
<context>
    <name>underact::gui</name>
    <message>
        <source>Difference of stiffness against trial</source>
        <translation>Steifigkeitsunterschied gegen Versuch</translation>
    </message>
    <message>
        <source>The difference of each trial. Filled: right; hollow: wrong; ringed: reversal.</source>
        <translation>Der Unterschied jedes Versuchs. Gefüllt: richtig; leer: falsch; mit Ring: Umkehrung.</translation>
    </message>
    <message>
        <source>%1 trials; the threshold is %2</source>
        <translation>%1 Versuche; die Schwelle ist %2</translation>
    </message>
    <message>
        <source>%1 trials; no threshold</source>
        <translation>%1 Versuche; keine Schwelle</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>● right  ○ wrong  ◎ reversal</source>
        <translation>● richtig  ○ falsch  ◎ Umkehr</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>%1 of “%2”</source>
        <translation>%1 von „%2“</translation>
    </message>
    <message>
        <source>Add a curve</source>
        <translation>Kurve hinzufügen</translation>
    </message>
    <message>
        <source>Points (%1);;All files (*)</source>
        <translation>Punkte (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Curve not loaded</source>
        <translation>Kurve nicht geladen</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>Kurve %1</translation>
    </message>
    <message>
        <source>The curve %1.</source>
        <translation>Die Kurve %1.</translation>
    </message>
    <message>
        <source>Add &amp;curve…</source>
        <translation>&amp;Kurve hinzufügen …</translation>
    </message>
    <message>
        <source>Loads a file of points and adds their curve to the scene, or makes a new scene of it.</source>
        <translation>Lädt eine Datei mit Punkten und fügt deren Kurve der Szene hinzu oder macht eine neue Szene daraus.</translation>
    </message>
    <message>
        <source>&amp;Figures of the thesis</source>
        <translation>&amp;Abbildungen der Thesis</translation>
    </message>
    <message>
        <source>Shows the figures of the thesis as this program makes them, with their numbers checked.</source>
        <translation>Zeigt die Abbildungen der Thesis, wie dieses Programm sie erstellt, mit geprüften Zahlen.</translation>
    </message>
    <message>
        <source>Follow a recorded hand</source>
        <translation>Einer aufgezeichneten Hand folgen</translation>
    </message>
    <message>
        <source>Recorded sessions (*.h5 *.hdf5);;All files (*)</source>
        <translation>Aufgezeichnete Sitzungen (*.h5 *.hdf5);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Follow a &amp;recorded hand…</source>
        <translation>Einer aufgezeichneten Hand f&amp;olgen …</translation>
    </message>
    <message>
        <source>Shows a recorded stylus as a ghost beside yours, and your distance to it.</source>
        <translation>Zeigt einen aufgezeichneten Stift als Geisterbild neben Ihrem und den Abstand dazu.</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>A&amp;bspielen oder pausieren</translation>
    </message>
    <message>
        <source>Plays or pauses the ghost.</source>
        <translation>Spielt das Geisterbild ab oder pausiert es.</translation>
    </message>
    <message>
        <source>From the &amp;beginning</source>
        <translation>Von &amp;vorn</translation>
    </message>
    <message>
        <source>Starts the ghost from the beginning and resets the count.</source>
        <translation>Startet das Geisterbild von vorn und setzt die Zählung zurück.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Removes the ghost.</source>
        <translation>Entfernt das Geisterbild.</translation>
    </message>
    <message>
        <source>Recorded session</source>
        <translation>Aufgezeichnete Sitzung</translation>
    </message>
    <message>
        <source>“%1” is damaged. You follow the part that could be read.</source>
        <translation>„%1“ ist beschädigt. Sie folgen dem Teil, der lesbar war.</translation>
    </message>
    <message>
        <source>“%1” cannot be followed. Nothing has changed.</source>
        <translation>„%1“ kann man nicht folgen. Alles bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Followed for %1 s: %2 mm away on average, %3 mm at most, %4 % of the time within %5 mm.</source>
        <translation>%1 s lang gefolgt: im Mittel %2 mm entfernt, höchstens %3 mm, %4 % der Zeit innerhalb von %5 mm.</translation>
    </message>
    <message>
        <source>The ghost waited for %1 s.</source>
        <translation>Das Geisterbild hat %1 s gewartet.</translation>
    </message>
    <message>
        <source>The ghost is paused. Press Play to continue.</source>
        <translation>Das Geisterbild ist pausiert. Mit „Abspielen“ geht es weiter.</translation>
    </message>
    <message>
        <source>The ghost waits until you are within %1 mm.</source>
        <translation>Das Geisterbild wartet, bis die Spitze auf %1 mm heran ist.</translation>
    </message>
    <message>
        <source>Move to the ghost: it starts when you are within %1 mm.</source>
        <translation>Bewegen Sie die Spitze zum Geisterbild: Es beginnt, wenn sie auf %1 mm heran ist.</translation>
    </message>
    <message>
        <source>Average %1 mm, largest %2 mm, %3 % within %4 mm</source>
        <translation>Mittel %1 mm, größter Abstand %2 mm, %3 % innerhalb von %4 mm</translation>
    </message>
    <message>
        <source>Last round: %1</source>
        <translation>Letzte Runde: %1</translation>
    </message>
    <message>
        <source>The scene has changed since the recording.</source>
        <translation>Die Szene hat sich seit der Aufzeichnung geändert.</translation>
    </message>
    <message>
        <source>It was recorded in the scene “%1”.</source>
        <translation>Aufgezeichnet wurde in der Szene „%1“.</translation>
    </message>
    <message>
        <source>The recording has a gap: the ghost jumps there.</source>
        <translation>Die Aufzeichnung hat eine Lücke: Dort springt das Geisterbild.</translation>
    </message>
    <message>
        <source>The recording has %1 gaps: the ghost jumps there.</source>
        <translation>Die Aufzeichnung hat %1 Lücken: Dort springt das Geisterbild.</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>&amp;Maus und Tasten</translation>
    </message>
    <message>
        <source>Shows what the mouse and the keys do.</source>
        <translation>Zeigt, was Maus und Tasten tun.</translation>
    </message>
    <message>
        <source>&amp;About Underact</source>
        <translation>Ü&amp;ber Underact</translation>
    </message>
    <message>
        <source>Shows the version, the licence, and what has not been tested.</source>
        <translation>Zeigt Version, Lizenz und was nicht erprobt ist.</translation>
    </message>
    <message>
        <source>Right, left</source>
        <translation>Rechts, links</translation>
    </message>
    <message>
        <source>Up, down</source>
        <translation>Auf, ab</translation>
    </message>
    <message>
        <source>Nearer, farther</source>
        <translation>Her, weg</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>moves the stylus to the right</source>
        <translation>bewegt den Stift nach rechts</translation>
    </message>
    <message>
        <source>moves the stylus up</source>
        <translation>bewegt den Stift nach oben</translation>
    </message>
    <message>
        <source>moves the stylus towards you</source>
        <translation>bewegt den Stift zu Ihnen</translation>
    </message>
    <message>
        <source>tilts the top of the stylus towards you</source>
        <translation>neigt den Stift oben zu Ihnen</translation>
    </message>
    <message>
        <source>turns the front of the stylus to the right</source>
        <translation>dreht den Stift vorn nach rechts</translation>
    </message>
    <message>
        <source>tilts the top of the stylus to the left</source>
        <translation>neigt den Stift oben nach links</translation>
    </message>
    <message>
        <source>Stylus button 1</source>
        <translation>Stifttaste 1</translation>
    </message>
    <message>
        <source>Stylus button 2</source>
        <translation>Stifttaste 2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>game controller</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>joystick</source>
        <translation>Joystick</translation>
    </message>
    <message>
        <source>3D mouse</source>
        <translation>3D-Maus</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Als PDF speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The page was not saved.</source>
        <translation>Die Seite wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>Nothing has been measured.</source>
        <translation>Es ist nichts gemessen.</translation>
    </message>
    <message>
        <source>%1 combinations, %2 best trade-offs; %3</source>
        <translation>%1 Kombinationen, davon %2 bestmögliche; %3</translation>
    </message>
    <message>
        <source>chosen: %1 per second, error %2</source>
        <translation>gewählt: %1 je Sekunde, Fehler %2</translation>
    </message>
    <message>
        <source>none of them is in use</source>
        <translation>keine davon wird verwendet</translation>
    </message>
    <message>
        <source>Error of the tip's path against processor time</source>
        <translation>Bahnfehler der Spitze gegen Prozessorzeit</translation>
    </message>
    <message>
        <source>Every combination of choices for this scene: the processor time per second of tick and simulated arm, and the deviation of the tip from its path at 16 kHz, root mean square over all hands. A best trade-off is one that no other combination beats in both (Pareto front).</source>
        <translation>Jede Kombination der Wahlmöglichkeiten für diese Szene: die Rechenzeit je Sekunde von Takt und simuliertem Arm und die Abweichung der Spitze von ihrem Weg bei 16 kHz, quadratisches Mittel über alle Hände. Bestmöglich ist, was keine andere Kombination in beidem übertrifft (Pareto-Front).</translation>
    </message>
    <message>
        <source>error of the tip's path</source>
        <translation>Bahnfehler der Spitze</translation>
    </message>
    <message>
        <source>processor time per second</source>
        <translation>Prozessorzeit je Sekunde</translation>
    </message>
    <message>
        <source>○ combination  ● best trade-off  ■ as measured  ◎ chosen</source>
        <translation>○ Kombination  ● bestmöglich  ■ wie gemessen  ◎ gewählt</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language changes when you next start Underact.</source>
        <translation>Die Sprache wechselt, wenn Sie Underact das nächste Mal starten.</translation>
    </message>
    <message>
        <source>&amp;Restart now</source>
        <translation>Jetzt &amp;neu starten</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Später</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Follow the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Uses the system's language from the next start.</source>
        <translation>Verwendet ab dem nächsten Start die Sprache des Systems.</translation>
    </message>
    <message>
        <source>Uses English from the next start.</source>
        <translation>Verwendet ab dem nächsten Start Englisch.</translation>
    </message>
    <message>
        <source>Uses German from the next start.</source>
        <translation>Verwendet ab dem nächsten Start Deutsch.</translation>
    </message>
    <message>
        <source>✓ Solved</source>
        <translation>✓ Gelöst</translation>
    </message>
    <message>
        <source>○ Not solved</source>
        <translation>○ Nicht gelöst</translation>
    </message>
    <message>
        <source>Solved earlier; no details were kept.</source>
        <translation>Früher gelöst; Einzelheiten wurden nicht gespeichert.</translation>
    </message>
    <message>
        <source>✓ Solved: %1</source>
        <translation>✓ Gelöst: %1</translation>
    </message>
    <message>
        <source>○ Not yet: %1</source>
        <translation>○ Noch nicht: %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1 von %2 Schritten</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>New student</source>
        <translation>Nächste Person</translation>
    </message>
    <message>
        <source>Begin with a new student?</source>
        <translation>Mit der nächsten Person beginnen?</translation>
    </message>
    <message>
        <source>The name, the progress and the ticks of all lessons are cleared.</source>
        <translation>Der Name sowie Fortschritt und Häkchen aller Lektionen werden gelöscht.</translation>
    </message>
    <message>
        <source>Before that, the report of this lesson is saved as %1.</source>
        <translation>Zuvor wird der Bericht dieser Lektion gespeichert als %1.</translation>
    </message>
    <message>
        <source>&amp;New student</source>
        <translation>&amp;Nächste Person</translation>
    </message>
    <message>
        <source>Add a mesh</source>
        <translation>Dreiecksnetz hinzufügen</translation>
    </message>
    <message>
        <source>Meshes (%1);;All files (*)</source>
        <translation>Dreiecksnetze (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mesh not loaded</source>
        <translation>Dreiecksnetz nicht geladen</translation>
    </message>
    <message>
        <source>mesh %1</source>
        <translation>Dreiecksnetz %1</translation>
    </message>
    <message>
        <source>The mesh %1.</source>
        <translation>Das Dreiecksnetz %1.</translation>
    </message>
    <message>
        <source>Add &amp;mesh…</source>
        <translation>Dreiecks&amp;netz hinzufügen …</translation>
    </message>
    <message>
        <source>Loads an STL, OBJ, PLY or OFF file and adds it to the scene, or makes a new scene of it.</source>
        <translation>Lädt eine STL-, OBJ-, PLY- oder OFF-Datei und fügt sie der Szene hinzu oder macht eine neue Szene daraus.</translation>
    </message>
    <message>
        <source>Mesh &amp;report</source>
        <translation>Be&amp;richt zum Dreiecksnetz</translation>
    </message>
    <message>
        <source>What the file of the scene's mesh contains, what was repaired, and how the mesh can be felt.</source>
        <translation>Was die Datei des Dreiecksnetzes der Szene enthält, was repariert wurde und wie es sich fühlen lässt.</translation>
    </message>
    <message>
        <source>&amp;Left-handed</source>
        <translation>&amp;Linkshändig</translation>
    </message>
    <message>
        <source>Mirrors every scene for the left hand; lessons and recordings are not mirrored.</source>
        <translation>Spiegelt jede Szene für die linke Hand; Lektionen und Aufzeichnungen werden nicht gespiegelt.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Find a &amp;command…</source>
        <translation>Befehl &amp;suchen …</translation>
    </message>
    <message>
        <source>Finds commands, scenes, lessons, pages and settings by name.</source>
        <translation>Findet Befehle, Szenen, Lektionen, Seiten und Einstellungen nach ihrem Namen.</translation>
    </message>
    <message>
        <source>Underact: reference points for registering an arm. Print at 100 % and tape to the desk, the arm behind or beside it. This edge faces away from you.</source>
        <translation>Underact: Messpunkte zum Registrieren eines Arms. Mit 100 % drucken, auf den Tisch kleben, der Arm dahinter oder daneben. Diese Kante zeigt von Ihnen weg.</translation>
    </message>
    <message>
        <source>100 mm if printed at 100 %</source>
        <translation>100 mm, falls mit 100 % gedruckt</translation>
    </message>
    <message>
        <source>Reference points for registering an arm</source>
        <translation>Messpunkte zum Registrieren eines Arms</translation>
    </message>
    <message>
        <source>Replay a session</source>
        <translation>Sitzung wiedergeben</translation>
    </message>
    <message>
        <source>Plays the recording or pauses it.</source>
        <translation>Spielt die Aufzeichnung ab oder pausiert sie.</translation>
    </message>
    <message>
        <source>One tick &amp;back</source>
        <translation>Einen Takt &amp;zurück</translation>
    </message>
    <message>
        <source>Pauses and shows the previous tick.</source>
        <translation>Pausiert und zeigt den vorigen Takt.</translation>
    </message>
    <message>
        <source>One tick &amp;forward</source>
        <translation>Einen Takt &amp;weiter</translation>
    </message>
    <message>
        <source>Pauses and shows the next tick.</source>
        <translation>Pausiert und zeigt den nächsten Takt.</translation>
    </message>
    <message>
        <source>Start loop &amp;here</source>
        <translation>Schleifenanfang &amp;hier</translation>
    </message>
    <message>
        <source>Sets the start of the loop to this tick.</source>
        <translation>Setzt den Anfang der Schleife auf diesen Takt.</translation>
    </message>
    <message>
        <source>&amp;End loop here</source>
        <translation>Schleifen&amp;ende hier</translation>
    </message>
    <message>
        <source>Sets the end of the loop to this tick.</source>
        <translation>Setzt das Ende der Schleife auf diesen Takt.</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Schleife</translation>
    </message>
    <message>
        <source>Repeats the part between the start and the end of the loop.</source>
        <translation>Wiederholt den Teil zwischen Anfang und Ende der Schleife.</translation>
    </message>
    <message>
        <source>Folder with the meshes and curves of sessions</source>
        <translation>Ordner mit den Dreiecksnetzen und Kurven von Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Open session…</source>
        <translation>Sitzung ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Opens a recorded session and replays it.</source>
        <translation>Öffnet eine aufgezeichnete Sitzung und gibt sie wieder.</translation>
    </message>
    <message>
        <source>Folder w&amp;ith meshes and curves…</source>
        <translation>Or&amp;dner mit Dreiecksnetzen und Kurven …</translation>
    </message>
    <message>
        <source>Sets a folder in which replays look for meshes and curves: sessions store only their file names.</source>
        <translation>Legt einen Ordner fest, in dem Wiedergaben nach Dreiecksnetzen und Kurven suchen: Sitzungen speichern nur deren Dateinamen.</translation>
    </message>
    <message>
        <source>&amp;What if</source>
        <translation>Was wäre, we&amp;nn</translation>
    </message>
    <message>
        <source>Replays the recorded hand with the scene and gains of the window instead of the recorded ones.</source>
        <translation>Gibt die aufgezeichnete Hand mit Szene und Verstärkungen des Fensters statt mit den aufgezeichneten wieder.</translation>
    </message>
    <message>
        <source>&amp;Close session</source>
        <translation>Sitzung s&amp;chließen</translation>
    </message>
    <message>
        <source>Ends the replay and restores the previous arm and scene.</source>
        <translation>Beendet die Wiedergabe und stellt den vorigen Arm und die vorige Szene wieder her.</translation>
    </message>
    <message>
        <source>“%1” is damaged. The readable part is replayed.</source>
        <translation>„%1“ ist beschädigt. Der lesbare Teil wird wiedergegeben.</translation>
    </message>
    <message>
        <source>A scene of “%1” cannot be run. Your previous scene stays open.</source>
        <translation>Eine Szene von „%1“ kann nicht ausgeführt werden. Die vorige Szene gilt weiter.</translation>
    </message>
    <message>
        <source>“%1” was not opened. The scene and the arm are unchanged.</source>
        <translation>„%1“ wurde nicht geöffnet. Szene und Arm sind unverändert.</translation>
    </message>
    <message>
        <source>Interrupted: no film was written.</source>
        <translation>Unterbrochen: Es wurde kein Film geschrieben.</translation>
    </message>
    <message>
        <source>A film is a file.webm, file.mp4 or file.gif.</source>
        <translation>Ein Film ist eine Datei.webm, Datei.mp4 oder Datei.gif.</translation>
    </message>
    <message>
        <source>%1 exists. --overwrite replaces it.</source>
        <translation>%1 gibt es schon. --overwrite ersetzt es.</translation>
    </message>
    <message>
        <source>The program ffmpeg, which encodes films, was not found. Install it (Debian: apt install ffmpeg).</source>
        <translation>Das Programm ffmpeg, das Filme kodiert, wurde nicht gefunden. Installieren Sie es (Debian: apt install ffmpeg).</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 kann nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>ffmpeg ended before the film was complete.</source>
        <translation>ffmpeg hat vor dem Film geendet.</translation>
    </message>
    <message>
        <source>ffmpeg says: %1</source>
        <translation>ffmpeg sagt: %1</translation>
    </message>
    <message>
        <source>&amp;Keep holding</source>
        <translation>Fest&amp;halten</translation>
    </message>
    <message>
        <source>The simulated hand keeps holding the stylus when you release the mouse; otherwise it lets go.</source>
        <translation>Die simulierte Hand hält den Stift fest, wenn Sie die Maus loslassen; sonst lässt sie los.</translation>
    </message>
    <message>
        <source>Keep holding</source>
        <translation>Festhalten</translation>
    </message>
    <message>
        <source>Let go of the st&amp;ylus</source>
        <translation>St&amp;ift loslassen</translation>
    </message>
    <message>
        <source>The simulated hand lets go: the stylus goes where the scene sends it.</source>
        <translation>Die simulierte Hand lässt los: Der Stift geht dorthin, wohin ihn die Szene schickt.</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>Shows the whole scene from the current direction.</source>
        <translation>Zeigt die ganze Szene aus der jetzigen Richtung.</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Vorn</translation>
    </message>
    <message>
        <source>Looks from the front, where the hand is, along −z.</source>
        <translation>Blick von vorn, wo die Hand ist, entlang −z.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Looks down, along −y.</source>
        <translation>Blick nach unten, entlang −y.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>&amp;Side</source>
        <translation>&amp;Seite</translation>
    </message>
    <message>
        <source>Looks from the right, along −x.</source>
        <translation>Blick von rechts, entlang −x.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>Looks from the front right and above.</source>
        <translation>Blick von vorn rechts oben.</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>Looks from the left, along x.</source>
        <translation>Blick von links, entlang x.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Hinten</translation>
    </message>
    <message>
        <source>Looks from behind the arm, along z.</source>
        <translation>Blick von hinter dem Arm, entlang z.</translation>
    </message>
    <message>
        <source>Home (defa&amp;ult view)</source>
        <translation>Standardblic&amp;k</translation>
    </message>
    <message>
        <source>Looks as at the start: from the front, a little from the right and above.</source>
        <translation>Blickt wie am Anfang: von vorn, etwas von rechts und von oben.</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Looks up, along y.</source>
        <translation>Blick nach oben, entlang y.</translation>
    </message>
    <message>
        <source>&amp;Zoom to selection</source>
        <translation>Aus&amp;wahl zeigen</translation>
    </message>
    <message>
        <source>Shows the chosen inverse solution, or else the constraints and the tip, from the current direction.</source>
        <translation>Zeigt die gewählte inverse Lösung, sonst die Bindungen und die Spitze, aus der jetzigen Richtung.</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>Parallelpro&amp;jektion</translation>
    </message>
    <message>
        <source>Draws without perspective (orthographic), so that lengths can be compared.</source>
        <translation>Zeichnet ohne Perspektive (orthografisch), sodass sich Längen vergleichen lassen.</translation>
    </message>
    <message>
        <source>&amp;Move the hand with the keys</source>
        <translation>Hand mit den &amp;Tasten bewegen</translation>
    </message>
    <message>
        <source>Gives the view the keyboard focus, so that the arrow keys move the hand.</source>
        <translation>Gibt der Ansicht den Tastaturfokus, sodass die Pfeiltasten die Hand bewegen.</translation>
    </message>
    <message>
        <source>Cut across x</source>
        <translation>Schnitt quer zu x</translation>
    </message>
    <message>
        <source>Cuts meshes at right angles to x; best seen from the side.</source>
        <translation>Schneidet Dreiecksnetze im rechten Winkel zu x; am besten von der Seite zu sehen.</translation>
    </message>
    <message>
        <source>Cut across y</source>
        <translation>Schnitt quer zu y</translation>
    </message>
    <message>
        <source>Cuts meshes at right angles to y; best seen from the top.</source>
        <translation>Schneidet Dreiecksnetze im rechten Winkel zu y; am besten von oben zu sehen.</translation>
    </message>
    <message>
        <source>Cut across z</source>
        <translation>Schnitt quer zu z</translation>
    </message>
    <message>
        <source>Cuts meshes at right angles to z; best seen from the front.</source>
        <translation>Schneidet Dreiecksnetze im rechten Winkel zu z; am besten von vorn zu sehen.</translation>
    </message>
    <message>
        <source>Follows the light or dark theme of the desktop, also while the program runs.</source>
        <translation>Folgt dem hellen oder dunklen Thema der Arbeitsumgebung, auch während das Programm läuft.</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Always light.</source>
        <translation>Immer hell.</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Always dark.</source>
        <translation>Immer dunkel.</translation>
    </message>
    <message>
        <source>What you do</source>
        <translation>Was Sie tun</translation>
    </message>
    <message>
        <source>Which panels, menus and buttons are shown.</source>
        <translation>Welche Bereiche, Menüs und Knöpfe gezeigt werden.</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open rece&amp;nt</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Servo</source>
        <translation>&amp;Servo</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>&amp;Geisterbild</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>L&amp;ayers</source>
        <translation>Ebe&amp;nen</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Sp&amp;rache</translation>
    </message>
    <message>
        <source>Sessio&amp;ns</source>
        <translation>Sitzu&amp;ngen</translation>
    </message>
    <message>
        <source>Less&amp;ons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Symbolleiste</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>Starts the servo, also after a fault.</source>
        <translation>Startet den Servo, auch nach einer Störung.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>S&amp;topp</translation>
    </message>
    <message>
        <source>Stops the servo: the force goes to zero. Shift+Esc does so in an open menu or dialog, too.</source>
        <translation>Stoppt den Servo: Die Kraft geht auf null. Umschalt+Esc tut das auch in einem offenen Menü oder Dialog.</translation>
    </message>
    <message>
        <source>File not opened</source>
        <translation>Datei nicht geöffnet</translation>
    </message>
    <message>
        <source>“%1” was not opened.</source>
        <translation>„%1“ wurde nicht geöffnet.</translation>
    </message>
    <message>
        <source>Scene saved as %1.</source>
        <translation>Szene gespeichert als %1.</translation>
    </message>
    <message>
        <source>Opened with your last settings. Undo (Ctrl+Z) restores the original.</source>
        <translation>Mit Ihren letzten Einstellungen geöffnet. Rückgängig (Strg+Z) stellt das Original wieder her.</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Datei öffnen …</translation>
    </message>
    <message>
        <source>Opens a scene, session, arm file, mesh, curve, lesson, list of figures or notebook.</source>
        <translation>Öffnet eine Szene, Sitzung, Armdatei, Kurve, Lektion, ein Netz, eine Liste von Abbildungen oder ein Notebook.</translation>
    </message>
    <message>
        <source>&amp;Save tuned scene as…</source>
        <translation>Abgestimmte Szene &amp;speichern unter …</translation>
    </message>
    <message>
        <source>Saves the scene with its current settings.</source>
        <translation>Speichert die Szene mit ihren aktuellen Einstellungen.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Stops the servo and closes the window.</source>
        <translation>Stoppt den Servo und schließt das Fenster.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change to the scene.</source>
        <translation>Macht die letzte Änderung der Szene rückgängig.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Redoes the change that was undone.</source>
        <translation>Führt die rückgängig gemachte Änderung wieder aus.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>La&amp;yers</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>Shows or hides parts of the view.</source>
        <translation>Blendet Teile der Ansicht ein oder aus.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>All panels</source>
        <translation>Alle Bereiche</translation>
    </message>
    <message>
        <source>Shows or hides any panel.</source>
        <translation>Zeigt oder verbirgt jeden Bereich.</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>Anordnung zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Restores the default layout of the panels.</source>
        <translation>Stellt die anfängliche Anordnung der Bereiche wieder her.</translation>
    </message>
</context>
<context>
    <name>underact::gui::AboutDialog</name>
    <message>
        <source>About Underact</source>
        <translation>Über Underact</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Underact %1&lt;/h3&gt;&lt;p&gt;Feel geometry through a small haptic arm, and see what you feel.&lt;/p&gt;&lt;p&gt;Licence: BSD-3-Clause. Uses Qt %2 (LGPL) and VTK (BSD).&lt;/p&gt;&lt;p&gt;Tested in simulation only; no part of it has been tested on a real arm yet.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Underact %1&lt;/h3&gt;&lt;p&gt;Mit einem kleinen haptischen Arm Geometrie fühlen und sehen, was man fühlt.&lt;/p&gt;&lt;p&gt;Lizenz: BSD-3-Clause. Verwendet Qt %2 (LGPL) und VTK (BSD).&lt;/p&gt;&lt;p&gt;Nur in der Simulation erprobt, noch in keinem Teil an einem echten Arm.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>underact::gui::Actions</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>underact::gui::AddDialog</name>
    <message>
        <source>Why it was not added</source>
        <translation>Warum nichts hinzugefügt wurde</translation>
    </message>
    <message>
        <source>&amp;Add to the scene</source>
        <translation>Zur Szene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Open as a new scene</source>
        <translation>Als neue Szene ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Closes this dialog. The scene is not changed.</source>
        <translation>Schließt diesen Dialog. Die Szene wird nicht verändert.</translation>
    </message>
</context>
<context>
    <name>underact::gui::AddressDialog</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error message</source>
        <translation>Fehlermeldung</translation>
    </message>
    <message>
        <source>Send live data to</source>
        <translation>Live-Daten senden an</translation>
    </message>
    <message>
        <source>Each tick is sent as one JSON object over UDP. To receive it in PlotJuggler, start its source “UDP Server”, whose default port is %1.</source>
        <translation>Jeder Takt wird als ein JSON-Objekt über UDP gesendet. Um die Daten in PlotJuggler zu empfangen, starten Sie dessen Quelle „UDP Server“ mit dem Standardport %1.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>A port, an IP address, or both: 9870, 192.168.1.20, 192.168.1.20:9870.</source>
        <translation>Ein Port, eine IP-Adresse oder beides: 9870, 192.168.1.20, 192.168.1.20:9870.</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>%1 is not this computer. What the hand does and feels is sent unencrypted: anyone on the network between can read it.</source>
        <translation>%1 ist nicht dieser Rechner. Was die Hand tut und fühlt, wird unverschlüsselt gesendet: Wer im Netz dazwischen ist, kann es mitlesen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::AnglesSection</name>
    <message>
        <source>Angle conventions</source>
        <translation>Winkelkonventionen</translation>
    </message>
    <message>
        <source>The same configuration in the joint angles of the DH table and in those of the device. The device measures the shin from the base, not from the thigh. Thesis figure 3.5; the signs have not been verified on hardware.</source>
        <translation>Dieselbe Stellung in den Gelenkwinkeln der DH-Tabelle und in denen des Geräts. Das Gerät misst den Unterschenkel von der Basis aus, nicht vom Oberschenkel. Thesis, Abbildung 3.5; die Vorzeichen sind nicht am Gerät geprüft.</translation>
    </message>
    <message>
        <source>DH [°]</source>
        <translation>DH [°]</translation>
    </message>
    <message>
        <source>device [°]</source>
        <translation>Gerät [°]</translation>
    </message>
    <message>
        <source>q3 = shin − thigh</source>
        <translation>q3 = Unters. − Obers.</translation>
    </message>
    <message>
        <source>turret</source>
        <translation>Turm</translation>
    </message>
    <message>
        <source>q1 = −turret</source>
        <translation>q1 = −Turm</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Obers.</translation>
    </message>
    <message>
        <source>q2 = thigh</source>
        <translation>q2 = Obers.</translation>
    </message>
    <message>
        <source>shin</source>
        <translation>Unters.</translation>
    </message>
    <message>
        <source>gimbal 1</source>
        <translation>Kardan 1</translation>
    </message>
    <message>
        <source>q4 = −g1</source>
        <translation>q4 = −g1</translation>
    </message>
    <message>
        <source>gimbal 2</source>
        <translation>Kardan 2</translation>
    </message>
    <message>
        <source>q5 = g2 + 90°</source>
        <translation>q5 = g2 + 90°</translation>
    </message>
    <message>
        <source>gimbal 3</source>
        <translation>Kardan 3</translation>
    </message>
    <message>
        <source>q6 = −g3 − 90°</source>
        <translation>q6 = −g3 − 90°</translation>
    </message>
    <message>
        <source>%1 (thesis figure 3.5).</source>
        <translation>%1 (Thesis, Abbildung 3.5).</translation>
    </message>
</context>
<context>
    <name>underact::gui::ArmPanel</name>
    <message>
        <source>Meshes of the arm that are not drawn</source>
        <translation>Netze des Arms, die nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Position of the stylus tip in the workspace frame W: p_WT (x, y, z).</source>
        <translation>Position der Stiftspitze im Koordinatensystem W des Arbeitsraums: p_WT (x, y, z).</translation>
    </message>
    <message>
        <source>Joints 1–3</source>
        <translation>Gelenke 1–3</translation>
    </message>
    <message>
        <source>q1, q2 and q3 as in the DH table; of the Omni turret, thigh and shin, which are driven.</source>
        <translation>q1, q2 und q3 wie in der DH-Tabelle; beim Omni Drehturm, Oberschenkel und Unterschenkel, die angetrieben sind.</translation>
    </message>
    <message>
        <source>Further joints</source>
        <translation>Weitere Gelenke</translation>
    </message>
    <message>
        <source>q4 and the joints after it, as in the DH table; of the Omni the gimbal, which is measured, not driven.</source>
        <translation>q4 und die folgenden Gelenke wie in der DH-Tabelle; beim Omni der Kardan, der gemessen, aber nicht angetrieben wird.</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>The share of the force that soft start and soft release pass on to the arm.</source>
        <translation>Der Anteil der Kraft, den sanfter Start und sanftes Loslassen an den Arm weitergeben.</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Why the servo stopped by itself. The line above the view says what to do.</source>
        <translation>Warum der Servo von selbst gestoppt hat. Die Zeile über der Ansicht sagt, was zu tun ist.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation><numerusform>Und %n weiteres.</numerusform><numerusform>Und %n weitere.</numerusform></translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>underact::gui::ArmSearch</name>
    <message>
        <source>%1: none is plugged in</source>
        <translation>%1: keiner ist angeschlossen</translation>
    </message>
</context>
<context>
    <name>underact::gui::AxisBar</name>
    <message>
        <source>Line: deflection. Bar: output. Grey: dead zone.</source>
        <translation>Strich: Auslenkung. Balken: Ausgabe. Grau: Totzone.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ButtonsSection</name>
    <message>
        <source>Stylus buttons</source>
        <translation>Stifttasten</translation>
    </message>
    <message>
        <source>What each stylus button does.</source>
        <translation>Was jede Stifttaste bewirkt.</translation>
    </message>
    <message>
        <source>At the ti&amp;p</source>
        <translation>An der S&amp;pitze</translation>
    </message>
    <message>
        <source>Se&amp;cond</source>
        <translation>&amp;Zweite</translation>
    </message>
    <message>
        <source>No action</source>
        <translation>Keine Aktion</translation>
    </message>
    <message>
        <source>Start or stop recording</source>
        <translation>Aufzeichnung starten oder stoppen</translation>
    </message>
    <message>
        <source>Set a marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Hold to run is on: this button enables the force and does nothing else.</source>
        <translation>„Nur mit Taste“ ist an: Diese Taste gibt die Kraft frei und tut sonst nichts.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CalibrationPanel</name>
    <message>
        <source>Sho&amp;w feedback</source>
        <translation>Rückmeldung zei&amp;gen</translation>
    </message>
    <message>
        <source> N/mm</source>
        <translation> N/mm</translation>
    </message>
    <message>
        <source>a person</source>
        <translation>eine Person</translation>
    </message>
    <message>
        <source>simulated hand</source>
        <translation>simulierte Hand</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>&amp;Referenz</translation>
    </message>
    <message>
        <source>Stiffness of the softer beam of every trial, at its tip: k = K / L². The other one is stiffer.</source>
        <translation>Die Steifigkeit des weicheren Balkens jedes Versuchs, an seiner Spitze: k = K / L². Der andere ist steifer.</translation>
    </message>
    <message>
        <source>&amp;Answered by</source>
        <translation>&amp;Antworten von</translation>
    </message>
    <message>
        <source>Who presses the beams and answers which one is stiffer: a person, or a simulated hand.</source>
        <translation>Wer die Balken drückt und antwortet, welcher steifer ist: eine Person oder eine simulierte Hand.</translation>
    </message>
    <message>
        <source>&amp;Weber fraction</source>
        <translation>&amp;Weber-Bruch</translation>
    </message>
    <message>
        <source>Scatter of what the simulated hand feels, as a fraction of the stiffness (Weber's law).</source>
        <translation>Streuung dessen, was die simulierte Hand fühlt, als Bruchteil der Steifigkeit (Webersches Gesetz).</translation>
    </message>
    <message>
        <source>See&amp;d</source>
        <translation>Startwer&amp;t</translation>
    </message>
    <message>
        <source>Determines the stiffer side of each trial and the scatter of the simulated hand. The same seed gives the same sequence.</source>
        <translation>Bestimmt die steifere Seite jedes Versuchs und die Streuung der simulierten Hand. Derselbe Startwert ergibt dieselbe Folge.</translation>
    </message>
    <message>
        <source>Show feedback: whether each answer was right</source>
        <translation>Rückmeldung zeigen: ob jede Antwort richtig war</translation>
    </message>
    <message>
        <source>Tells you after each answer whether it was right. For practice only: feedback lets you learn.</source>
        <translation>Sagt Ihnen nach jeder Antwort, ob sie richtig war. Nur zum Üben: Durch Rückmeldung lernen Sie dazu.</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Starts the trials. Two right answers in a row make them harder, a wrong one easier (Levitt 1971).</source>
        <translation>Startet die Versuche. Zwei richtige Antworten nacheinander machen sie schwerer, eine falsche leichter (Levitt 1971).</translation>
    </message>
    <message>
        <source>Begin the measurement</source>
        <translation>Messung beginnen</translation>
    </message>
    <message>
        <source>How small a difference of stiffness can be felt (just-noticeable difference, JND)? Press two beams and answer which one is stiffer, again and again.</source>
        <translation>Wie klein darf ein Unterschied der Steifigkeit sein, um noch fühlbar zu sein (eben merklicher Unterschied, JND)? Drücken Sie zwei Balken und antworten Sie, welcher steifer ist, immer wieder.</translation>
    </message>
    <message>
        <source>&amp;Open the two beams</source>
        <translation>Die zwei Balken ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Opens the scene “Two beams, one softer”.</source>
        <translation>Öffnet die Szene „Zwei Balken, einer weicher“.</translation>
    </message>
    <message>
        <source>A threshold measurement needs a scene with two beams whose stiffness can be set. This scene has no such beams.</source>
        <translation>Eine Schwellenmessung braucht eine Szene mit zwei Balken, deren Steifigkeit sich einstellen lässt. Diese Szene hat keine solchen Balken.</translation>
    </message>
    <message>
        <source>Answers that the %1 beam is stiffer; possible once you have pressed both.</source>
        <translation>Antwortet, dass der Balken %1 steifer ist; möglich, sobald Sie beide gedrückt haben.</translation>
    </message>
    <message>
        <source>Left &amp;beam is stiffer</source>
        <translation>&amp;Linker Balken ist steifer</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>R&amp;ight beam is stiffer</source>
        <translation>&amp;Rechter Balken ist steifer</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>No threshold: there were fewer than four reversals, because every difference was felt, or none was.</source>
        <translation>Keine Schwelle: Es gab weniger als vier Umkehrungen, weil jeder Unterschied gefühlt wurde oder keiner.</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Just-noticeable difference: the difference at which 70.7 % of answers are right (Levitt 1971). Geometric mean of the reversals after the first two.</source>
        <translation>Eben merklicher Unterschied (JND): der Unterschied, bei dem 70,7 % der Antworten richtig sind (Levitt 1971). Geometrisches Mittel der Umkehrungen nach den ersten zwei.</translation>
    </message>
    <message>
        <source>± 1 s.d.</source>
        <translation>± 1 Std.-Abw.</translation>
    </message>
    <message>
        <source>One standard deviation of the reversals' logarithms, either way.</source>
        <translation>Eine Standardabweichung der Logarithmen der Umkehrungen, nach beiden Seiten.</translation>
    </message>
    <message>
        <source>in stiffness</source>
        <translation>in Steifigkeit</translation>
    </message>
    <message>
        <source>The just-noticeable difference times the reference.</source>
        <translation>Der eben merkliche Unterschied mal die Referenz.</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>The stiffness of the softer beam of every trial, at its tip.</source>
        <translation>Die Steifigkeit des weicheren Balkens jedes Versuchs, an seiner Spitze.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Number of answers given.</source>
        <translation>Zahl der gegebenen Antworten.</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>Scatter w of a single press that gives this JND when two are compared: ln(1 + JND) = 0.771 w.</source>
        <translation>Streuung w eines einzelnen Drückens, die beim Vergleich von zweien diesen JND ergibt: ln(1 + JND) = 0.771 w.</translation>
    </message>
    <message>
        <source>Answered by</source>
        <translation>Antworten von</translation>
    </message>
    <message>
        <source>A person, or the simulated hand with the Weber fraction that was set.</source>
        <translation>Eine Person oder die simulierte Hand mit dem eingestellten Weber-Bruch.</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern …</translation>
    </message>
    <message>
        <source>Writes every trial and the result as a CSV file.</source>
        <translation>Schreibt jeden Versuch und das Ergebnis als CSV-Datei.</translation>
    </message>
    <message>
        <source>Save the trials</source>
        <translation>Versuche speichern</translation>
    </message>
    <message>
        <source>A&amp;gain</source>
        <translation>&amp;Erneut</translation>
    </message>
    <message>
        <source>Returns to the start. A result that was not saved is lost.</source>
        <translation>Geht zum Anfang zurück. Ein nicht gespeichertes Ergebnis geht verloren.</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Erneut messen</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>hand, w = %1</source>
        <translation>Hand, w = %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Not saved: %1. Choose another folder.</source>
        <translation>Nicht gespeichert: %1. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Umkehrungen</translation>
    </message>
    <message>
        <source>A reversal is a change between harder and easier. The first two only find the rough range; the just-noticeable difference is the geometric mean of the others (Levitt 1971).</source>
        <translation>Eine Umkehrung ist ein Wechsel zwischen schwerer und leichter. Die ersten zwei finden nur den groben Bereich; der eben merkliche Unterschied ist das geometrische Mittel der anderen (Levitt 1971).</translation>
    </message>
    <message>
        <source>Left beam</source>
        <translation>Linker Balken</translation>
    </message>
    <message>
        <source>Right beam</source>
        <translation>Rechter Balken</translation>
    </message>
    <message>
        <source>%1, pressed or not</source>
        <translation>%1, gedrückt oder nicht</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Restores the stiffness that the scene gives the beams; nothing is kept.</source>
        <translation>Stellt die Steifigkeit wieder her, die die Szene den Balken gibt; nichts wird behalten.</translation>
    </message>
    <message>
        <source>Cancel the measurement</source>
        <translation>Messung abbrechen</translation>
    </message>
    <message>
        <source>%1 is stiffer</source>
        <translation>%1 ist steifer</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>Trial %1: which beam is stiffer?</source>
        <translation>Versuch %1: Welcher Balken ist steifer?</translation>
    </message>
    <message>
        <source>The simulated hand is at trial %1.</source>
        <translation>Die simulierte Hand ist bei Versuch %1.</translation>
    </message>
    <message>
        <source>reversals %v of %m</source>
        <translation>Umkehrungen %v von %m</translation>
    </message>
    <message>
        <source>It presses the beams on a simulated arm of its own; the arm in the window does not move.</source>
        <translation>Sie drückt die Balken an einem eigenen simulierten Arm; der Arm im Fenster bewegt sich nicht.</translation>
    </message>
    <message>
        <source>Press each beam down with the stylus, as often as you like. Release it before you answer.</source>
        <translation>Drücken Sie jeden Balken mit dem Stift herunter, so oft Sie mögen. Lassen Sie ihn los, bevor Sie antworten.</translation>
    </message>
    <message>
        <source>The servo is stopped. Press Start to feel the beams.</source>
        <translation>Der Servo ist gestoppt. Drücken Sie Start, um die Balken zu fühlen.</translation>
    </message>
    <message>
        <source>✓ pressed</source>
        <translation>✓ gedrückt</translation>
    </message>
    <message>
        <source>press it</source>
        <translation>drücken</translation>
    </message>
    <message>
        <source>✓ That was right.</source>
        <translation>✓ Das war richtig.</translation>
    </message>
    <message>
        <source>✗ It was the other one.</source>
        <translation>✗ Es war der andere.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CalibrationRun</name>
    <message>
        <source>Another scene was opened, so the measurement was cancelled.</source>
        <translation>Eine andere Szene wurde geöffnet, daher wurde die Messung abgebrochen.</translation>
    </message>
    <message>
        <source>The scene was changed, so the measurement was cancelled.</source>
        <translation>Die Szene wurde geändert, daher wurde die Messung abgebrochen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ChainSection</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>From the base to the end effector, in the home pose, in W: X = e^[S1] q1 … e^[Sn] qn X_home. Each edited cell is one undo step.</source>
        <translation>Von der Basis zum Endeffektor, in Grundstellung, in W: X = e^[S1] q1 … e^[Sn] qn X_home. Jede Eingabe lässt sich einzeln rückgängig machen.</translation>
    </message>
    <message>
        <source>Joints of the robot</source>
        <translation>Gelenke des Roboters</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Add a joint after the selected one</source>
        <translation>Ein Gelenk nach dem gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Adds a joint after the selected one; 8 at most.</source>
        <translation>Fügt nach dem gewählten ein Gelenk hinzu; höchstens 8.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected joint</source>
        <translation>Gewähltes Gelenk entfernen</translation>
    </message>
    <message>
        <source>Removes the selected joint; a robot has at least one.</source>
        <translation>Entfernt das gewählte Gelenk; ein Roboter hat mindestens eines.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move the selected joint towards the base</source>
        <translation>Gewähltes Gelenk zur Basis hin verschieben</translation>
    </message>
    <message>
        <source>Moves the selected joint towards the base.</source>
        <translation>Verschiebt das gewählte Gelenk zur Basis hin.</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move the selected joint towards the end effector</source>
        <translation>Gewähltes Gelenk zum Endeffektor hin verschieben</translation>
    </message>
    <message>
        <source>Moves the selected joint towards the end effector.</source>
        <translation>Verschiebt das gewählte Gelenk zum Endeffektor hin.</translation>
    </message>
    <message>
        <source>joint %1, %2</source>
        <translation>Gelenk %1, %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::ChartWidget</name>
    <message>
        <source>&amp;Show all</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>Copy &amp;picture</source>
        <translation>&amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Copy &amp;data</source>
        <translation>&amp;Daten kopieren</translation>
    </message>
    <message>
        <source>Save data &amp;as…</source>
        <translation>Daten &amp;speichern unter …</translation>
    </message>
    <message>
        <source>Save the data of the plots</source>
        <translation>Daten der Diagramme speichern</translation>
    </message>
    <message>
        <source>CSV files (*.csv);;All files (*)</source>
        <translation>CSV-Dateien (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Wheel: enlarge in time; Ctrl and wheel: in value. Shift and drag: a rectangle. Double click: show all. Right click: copy or save.</source>
        <translation>Rad: in der Zeit vergrößern; Strg und Rad: im Wert. Umschalt und ziehen: ein Rechteck. Doppelklick: alles zeigen. Rechtsklick: kopieren oder speichern.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CheckDialog</name>
    <message>
        <source>&amp;Keep all cores busy</source>
        <translation>Alle &amp;Kerne auslasten</translation>
    </message>
    <message>
        <source>Servo check</source>
        <translation>Servoprüfung</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Measures the latency of the servo at %1 Hz and, in turn, that of a bare loop, which is the best this machine can do. The check uses a simulated arm of its own; your arm and the window keep running.</source>
        <translation>Misst die Latenz des Servos bei %1 Hz und im Wechsel die einer leeren Schleife, also das Beste, was dieser Rechner leisten kann. Die Prüfung nutzt einen eigenen simulierten Arm; Ihr Arm und das Fenster laufen weiter.</translation>
    </message>
    <message>
        <source>Duration in seconds</source>
        <translation>Dauer in Sekunden</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Latency and tick time</source>
        <translation>Latenz und Taktdauer</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>p99</source>
        <translation>p99</translation>
    </message>
    <message>
        <source>p99.9</source>
        <translation>p99.9</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>bare loop, latency [µs]</source>
        <translation>leere Schleife, Latenz [µs]</translation>
    </message>
    <message>
        <source>servo, latency [µs]</source>
        <translation>Servo, Latenz [µs]</translation>
    </message>
    <message>
        <source>servo, tick time [µs]</source>
        <translation>Servo, Taktdauer [µs]</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Dauer</translation>
    </message>
    <message>
        <source>Measuring the servo and a bare loop in turn, one second each.</source>
        <translation>Der Servo und eine leere Schleife werden im Wechsel gemessen, je eine Sekunde lang.</translation>
    </message>
    <message>
        <source>E&amp;nd now</source>
        <translation>Jetzt be&amp;enden</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>Erneut &amp;messen</translation>
    </message>
    <message>
        <source>%1 ticks in %2 s at %3 Hz, real time: %4. Late by a period or more: %5.</source>
        <translation>%1 Takte in %2 s bei %3 Hz, Echtzeit: %4. Um eine Periode oder mehr verspätet: %5.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CheckRow</name>
    <message>
        <source>Check %1</source>
        <translation>Aufgabe %1</translation>
    </message>
    <message>
        <source>Question %1</source>
        <translation>Frage %1</translation>
    </message>
    <message>
        <source>Answer to: %1</source>
        <translation>Antwort auf: %1</translation>
    </message>
    <message>
        <source>Type a number and press Enter.</source>
        <translation>Geben Sie eine Zahl ein und drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Checks the answer.</source>
        <translation>Prüft die Antwort.</translation>
    </message>
    <message>
        <source>An answer to: %1</source>
        <translation>Eine Antwort auf: %1</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ChoiceList</name>
    <message>
        <source>%1: cost and error</source>
        <translation>%1: Kosten und Fehler</translation>
    </message>
    <message>
        <source>%1: recommendation</source>
        <translation>%1: Empfehlung</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::ClassResults</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>– all solved</source>
        <translation>– alles gelöst</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Files that are not in the table</source>
        <translation>Dateien, die nicht in der Tabelle sind</translation>
    </message>
    <message>
        <source>Class results</source>
        <translation>Ergebnisse der Klasse</translation>
    </message>
    <message>
        <source>Student</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Solved</source>
        <translation>Gelöst</translation>
    </message>
    <message>
        <source>Stopped at</source>
        <translation>Stehen geblieben bei</translation>
    </message>
    <message>
        <source>Wrong answers</source>
        <translation>Falsche Antworten</translation>
    </message>
    <message>
        <source>Misconception</source>
        <translation>Fehlvorstellung</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Sort by</source>
        <translation>Sortieren nach</translation>
    </message>
    <message>
        <source>The column that the table is sorted by.</source>
        <translation>Die Spalte, nach der die Tabelle sortiert ist.</translation>
    </message>
    <message>
        <source>&amp;Open folder…</source>
        <translation>&amp;Ordner öffnen …</translation>
    </message>
    <message>
        <source>Reads the reports in a folder and in its folders.</source>
        <translation>Liest die Berichte in einem Ordner und in dessen Ordnern.</translation>
    </message>
    <message>
        <source>&amp;Save as CSV…</source>
        <translation>Als &amp;CSV speichern …</translation>
    </message>
    <message>
        <source>Saves the table for a spreadsheet.</source>
        <translation>Speichert die Tabelle für ein Tabellenprogramm.</translation>
    </message>
    <message>
        <source>Save for &amp;Moodle…</source>
        <translation>Für &amp;Moodle speichern …</translation>
    </message>
    <message>
        <source>Saves the steps solved, in percent, as the CSV that Moodle imports as grades.</source>
        <translation>Speichert die gelösten Schritte in Prozent als CSV, das Moodle als Bewertungen importiert.</translation>
    </message>
    <message>
        <source>Sor&amp;t by</source>
        <translation>Sor&amp;tieren nach</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this window.</source>
        <translation>Schließt dieses Fenster.</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>(ohne Name)</translation>
    </message>
    <message>
        <source>Choose the folder with the reports that your students saved (Lessons, Save report). Each student and lesson becomes a row.</source>
        <translation>Wählen Sie den Ordner mit den Berichten, die Ihre Klasse gespeichert hat (Lektionen, Bericht speichern). Jede Person und Lektion wird eine Zeile.</translation>
    </message>
    <message>
        <source>Reports in %1: %2</source>
        <translation>Berichte in %1: %2</translation>
    </message>
    <message>
        <source>There are no reports in %1. Students save one with Lessons, Save report.</source>
        <translation>In %1 sind keine Berichte. Man speichert einen mit Lektionen, Bericht speichern.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation><numerusform>Und %n weitere.</numerusform><numerusform>Und %n weitere.</numerusform></translation>
    </message>
    <message>
        <source>Open a folder of reports</source>
        <translation>Ordner mit Berichten öffnen</translation>
    </message>
    <message>
        <source>Save for Moodle</source>
        <translation>Für Moodle speichern</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>Als CSV speichern</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Not saved: %1. Choose another folder.</source>
        <translation>Nicht gespeichert: %1. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Left out, as they have no name: %1.</source>
        <translation>Weggelassen, da ohne Name: %1.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CliProcess</name>
    <message>
        <source>The program %1 could not be started. Reinstall Underact.</source>
        <translation>Das Programm %1 ließ sich nicht starten. Installieren Sie Underact neu.</translation>
    </message>
    <message>
        <source>Reinstall Underact.</source>
        <translation>Installieren Sie Underact neu.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ColumnButton</name>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Plots any columns of a session against time, up to six at once.</source>
        <translation>Zeichnet beliebige Spalten einer Sitzung gegen die Zeit, bis zu sechs zugleich.</translation>
    </message>
    <message>
        <source>Columns (%1)</source>
        <translation>Spalten (%1)</translation>
    </message>
</context>
<context>
    <name>underact::gui::CompareStrip</name>
    <message>
        <source>mean %1 N, maximum %2 N, RMS error %3 mm</source>
        <translation>im Mittel %1 N, höchstens %2 N, RMS-Fehler %3 mm</translation>
    </message>
    <message>
        <source>Two scenes compared</source>
        <translation>Zwei Szenen im Vergleich</translation>
    </message>
    <message>
        <source>Message about the comparison</source>
        <translation>Meldung zum Vergleich</translation>
    </message>
    <message>
        <source>Differences between the two scenes</source>
        <translation>Unterschiede zwischen den beiden Szenen</translation>
    </message>
    <message>
        <source>Force and error of both scenes</source>
        <translation>Kraft und Fehler beider Szenen</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>Tauschen</translation>
    </message>
    <message>
        <source>Same as felt</source>
        <translation>Wie gefühlt</translation>
    </message>
    <message>
        <source>Another scene…</source>
        <translation>Andere Szene …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Start the servo to compare the forces.</source>
        <translation>Starten Sie den Servo, um die Kräfte zu vergleichen.</translation>
    </message>
    <message>
        <source>Since the last change. Felt scene: %1. Other scene: %2.</source>
        <translation>Seit der letzten Änderung. Gefühlte Szene: %1. Andere Szene: %2.</translation>
    </message>
</context>
<context>
    <name>underact::gui::CompareTool</name>
    <message>
        <source>%1: felt %2, other %3</source>
        <translation>%1: gefühlt %2, andere %3</translation>
    </message>
    <message>
        <source>&amp;Compare two scenes</source>
        <translation>&amp;Zwei Szenen vergleichen</translation>
    </message>
    <message>
        <source>Opens a second view with the scene as it is now. Change gains, and compare the forces before and after the change on the same motion.</source>
        <translation>Öffnet eine zweite Ansicht mit der Szene, wie sie jetzt ist. Ändern Sie Verstärkungen, und vergleichen Sie die Kräfte vor und nach der Änderung an derselben Bewegung.</translation>
    </message>
    <message>
        <source>S&amp;wap compared scenes</source>
        <translation>Vergli&amp;chene Szenen tauschen</translation>
    </message>
    <message>
        <source>Makes the other scene the one that is felt; the felt scene moves to the second view.</source>
        <translation>Macht die andere Szene zur gefühlten; die bisher gefühlte kommt in die zweite Ansicht.</translation>
    </message>
    <message>
        <source>Compare with the scene as it is &amp;now</source>
        <translation>Mit der jetzi&amp;gen Szene vergleichen</translation>
    </message>
    <message>
        <source>Copies the felt scene, as it is now, to the second view.</source>
        <translation>Übernimmt die gefühlte Szene, wie sie jetzt ist, in die zweite Ansicht.</translation>
    </message>
    <message>
        <source>Compar&amp;e with another scene…</source>
        <translation>Mit &amp;anderer Szene vergleichen …</translation>
    </message>
    <message>
        <source>Opens a scene file in the second view.</source>
        <translation>Öffnet eine Szenendatei in der zweiten Ansicht.</translation>
    </message>
    <message>
        <source>swap of compared scenes</source>
        <translation>Tausch der verglichenen Szenen</translation>
    </message>
    <message>
        <source>Scene to compare with</source>
        <translation>Szene zum Vergleich</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>You feel: %1</source>
        <translation>Sie fühlen: %1</translation>
    </message>
    <message>
        <source>For comparison: %1</source>
        <translation>Zum Vergleich: %1</translation>
    </message>
    <message>
        <source>The two scenes are the same. Change gains, shape or method of the one you feel.</source>
        <translation>Beide Szenen sind gleich. Ändern Sie an der gefühlten Verstärkungen, Form oder Verfahren.</translation>
    </message>
    <message>
        <source>%1
and %2 more</source>
        <translation>%1
und %2 weitere</translation>
    </message>
</context>
<context>
    <name>underact::gui::ComparisonTable</name>
    <message>
        <source>Recorded and now</source>
        <translation>Aufgezeichnet und jetzt</translation>
    </message>
    <message>
        <source>Over the ticks since the last jump or edit in which both runs sent the whole force.</source>
        <translation>Über die Takte seit dem letzten Sprung oder der letzten Änderung, in denen beide Läufe die ganze Kraft sendeten.</translation>
    </message>
    <message>
        <source>RMS error [mm]</source>
        <translation>RMS-Fehler [mm]</translation>
    </message>
    <message>
        <source>maximum force [N]</source>
        <translation>größte Kraft [N]</translation>
    </message>
    <message>
        <source>mean force [N]</source>
        <translation>mittlere Kraft [N]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>RMS error, recorded</source>
        <translation>RMS-Fehler, aufgezeichnet</translation>
    </message>
    <message>
        <source>Maximum force, recorded</source>
        <translation>Größte Kraft, aufgezeichnet</translation>
    </message>
    <message>
        <source>Mean force, recorded</source>
        <translation>Mittlere Kraft, aufgezeichnet</translation>
    </message>
    <message>
        <source>RMS error, now</source>
        <translation>RMS-Fehler, jetzt</translation>
    </message>
    <message>
        <source>Maximum force, now</source>
        <translation>Größte Kraft, jetzt</translation>
    </message>
    <message>
        <source>Mean force, now</source>
        <translation>Mittlere Kraft, jetzt</translation>
    </message>
    <message>
        <source>Compared over</source>
        <translation>Verglichen über</translation>
    </message>
    <message>
        <source>over %1 s</source>
        <translation>über %1 s</translation>
    </message>
</context>
<context>
    <name>underact::gui::ConstraintFiles</name>
    <message>
        <source>Loading %1</source>
        <translation>%1 wird geladen</translation>
    </message>
    <message>
        <source>“%1” was not loaded. The scene is unchanged.</source>
        <translation>„%1“ wurde nicht geladen. Die Szene ist unverändert.</translation>
    </message>
    <message>
        <source>Adding %1</source>
        <translation>%1 wird hinzugefügt</translation>
    </message>
</context>
<context>
    <name>underact::gui::CurveDialog</name>
    <message>
        <source>Curve %1</source>
        <translation>Kurve %1</translation>
    </message>
    <message>
        <source>Size of the curve</source>
        <translation>Größe der Kurve</translation>
    </message>
    <message>
        <source>Adds the curve to the current scene.</source>
        <translation>Fügt die Kurve der aktuellen Szene hinzu.</translation>
    </message>
    <message>
        <source>Opens a new scene with only this curve.</source>
        <translation>Öffnet eine neue Szene, die nur diese Kurve enthält.</translation>
    </message>
    <message>
        <source>Interpolation between the points</source>
        <translation>Interpolation zwischen den Punkten</translation>
    </message>
    <message>
        <source>smooth (spline)</source>
        <translation>glatt (Spline)</translation>
    </message>
    <message>
        <source>straight lines (polyline)</source>
        <translation>Strecken (Polylinie)</translation>
    </message>
    <message>
        <source>C&amp;losed: from the last point back to the first</source>
        <translation>&amp;Geschlossen: vom letzten Punkt zum ersten</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Millimetres per file unit</source>
        <translation>Millimeter je Einheit der Datei</translation>
    </message>
    <message>
        <source>Length of one file unit: 1 for mm, 1000 for m, 25.4 for inches.</source>
        <translation>Länge einer Einheit der Datei: 1 für mm, 1000 für m, 25,4 für Zoll.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Interpolation</source>
        <translation>&amp;Interpolation</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>File &amp;unit</source>
        <translation>&amp;Einheit der Datei</translation>
    </message>
    <message>
        <source>Which unit</source>
        <translation>Welche Einheit</translation>
    </message>
    <message>
        <source>In millimetres the curve would be %1 long.</source>
        <translation>In Millimetern wäre die Kurve %1 lang.</translation>
    </message>
    <message>
        <source>%1 Which unit is the file in?</source>
        <translation>%1 Welche Einheit hat die Datei?</translation>
    </message>
    <message>
        <source>%1 It is assumed to be in %2.</source>
        <translation>%1 Angenommen ist eine Kurve in %2.</translation>
    </message>
    <message>
        <source>%1 points, %2, length %3.</source>
        <translation>%1 Punkte, %2, Länge %3.</translation>
    </message>
</context>
<context>
    <name>underact::gui::DeleteQuestion</name>
    <message>
        <source>Delete a session</source>
        <translation>Sitzung löschen</translation>
    </message>
    <message>
        <source>Move “%1” to the bin?</source>
        <translation>„%1“ in den Papierkorb verschieben?</translation>
    </message>
    <message>
        <source>The file is %1. It stays in the bin until the bin is emptied: until then, anyone with access to the bin can read and restore it. If a person asks for their data to be erased, delete it permanently.</source>
        <translation>Die Datei heißt %1. Sie bleibt im Papierkorb, bis er geleert wird: Bis dahin kann sie lesen und wiederherstellen, wer Zugriff auf den Papierkorb hat. Verlangt eine Person, dass ihre Daten gelöscht werden, so entfernen Sie die Datei endgültig.</translation>
    </message>
    <message>
        <source>&amp;Move to the bin</source>
        <translation>In den &amp;Papierkorb</translation>
    </message>
    <message>
        <source>Move to the bin</source>
        <translation>In den Papierkorb</translation>
    </message>
    <message>
        <source>&amp;Delete permanently…</source>
        <translation>&amp;Endgültig entfernen…</translation>
    </message>
    <message>
        <source>Delete permanently, after confirmation</source>
        <translation>Endgültig entfernen, nach Rückfrage</translation>
    </message>
    <message>
        <source>Delete a session permanently</source>
        <translation>Sitzung endgültig entfernen</translation>
    </message>
    <message>
        <source>Delete “%1” permanently?</source>
        <translation>„%1“ endgültig entfernen?</translation>
    </message>
    <message>
        <source>This cannot be undone: the file %1 does not go to the bin. Exports, plots and backups of it are not removed.</source>
        <translation>Das lässt sich nicht rückgängig machen: Die Datei %1 kommt nicht in den Papierkorb. Exporte, Diagramme und Sicherungskopien davon werden nicht entfernt.</translation>
    </message>
    <message>
        <source>&amp;Delete permanently</source>
        <translation>&amp;Endgültig entfernen</translation>
    </message>
    <message>
        <source>Delete permanently</source>
        <translation>Endgültig entfernen</translation>
    </message>
</context>
<context>
    <name>underact::gui::DemonstratorPanel</name>
    <message>
        <source>Seconds per scene</source>
        <translation>Sekunden je Szene</translation>
    </message>
    <message>
        <source>Maximum force, percent of the arm's continuous force</source>
        <translation>Größte Kraft, in Prozent der Dauerkraft des Arms</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Demonstrator</source>
        <translation>Vorführende</translation>
    </message>
    <message>
        <source>Scenes for visitors</source>
        <translation>Szenen für Besucher</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Each scene for</source>
        <translation>Jede Szene für</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stops the servo: the force goes to zero.</source>
        <translation>Stoppt den Servo: Die Kraft geht auf null.</translation>
    </message>
    <message>
        <source>Leave visitor mode</source>
        <translation>Besuchermodus verlassen</translation>
    </message>
    <message>
        <source>Restores the window as it was before.</source>
        <translation>Stellt das Fenster wieder her, wie es zuvor war.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this panel; visitor mode continues.</source>
        <translation>Schließt diesen Bereich; der Besuchermodus läuft weiter.</translation>
    </message>
</context>
<context>
    <name>underact::gui::DevicesPanel</name>
    <message>
        <source>in use</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>nicht bereit</translation>
    </message>
    <message>
        <source>The arm in use</source>
        <translation>Der verwendete Arm</translation>
    </message>
    <message>
        <source>Result of the choice</source>
        <translation>Ergebnis der Wahl</translation>
    </message>
    <message>
        <source>“%1” could not be opened. %2</source>
        <translation>„%1“ ließ sich nicht öffnen. %2</translation>
    </message>
    <message>
        <source>Use the si&amp;mulated arm</source>
        <translation>Si&amp;mulierten Arm verwenden</translation>
    </message>
    <message>
        <source>Closes the arm in use. The mouse moves the simulated arm again.</source>
        <translation>Schließt den verwendeten Arm. Die Maus bewegt wieder den simulierten Arm.</translation>
    </message>
    <message>
        <source>&amp;Look for arms</source>
        <translation>Arme s&amp;uchen</translation>
    </message>
    <message>
        <source>Looks again for arms that are plugged in.</source>
        <translation>Sucht erneut nach angeschlossenen Armen.</translation>
    </message>
    <message>
        <source>Plugged in</source>
        <translation>Angeschlossen</translation>
    </message>
    <message>
        <source>Arms</source>
        <translation>Arme</translation>
    </message>
    <message>
        <source>About the selected arm</source>
        <translation>Über den gewählten Arm</translation>
    </message>
    <message>
        <source>Use this arm</source>
        <translation>Arm verwenden</translation>
    </message>
    <message>
        <source>Opens this arm with the servo stopped. Press Start to turn the force on.</source>
        <translation>Öffnet diesen Arm mit gestopptem Servo. Drücken Sie Start, um die Kraft einzuschalten.</translation>
    </message>
    <message>
        <source>How to fix it…</source>
        <translation>Abhilfe …</translation>
    </message>
    <message>
        <source>Shows the command that fixes the problem.</source>
        <translation>Zeigt den Befehl, der das Problem behebt.</translation>
    </message>
    <message>
        <source>Test and report…</source>
        <translation>Testen und melden …</translation>
    </message>
    <message>
        <source>Shows the command that tests the arm and writes a report for the developers.</source>
        <translation>Zeigt den Befehl, der den Arm testet und einen Bericht für die Entwickler schreibt.</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Another arm</source>
        <translation>Ein anderer Arm</translation>
    </message>
    <message>
        <source>Name of the arm</source>
        <translation>Name des Arms</translation>
    </message>
    <message>
        <source>KIND:ADDRESS</source>
        <translation>ART:ADRESSE</translation>
    </message>
    <message>
        <source>The name as listed by “underact-cli devices”, with a serial number, a path or an address after the colon: wooden:/dev/hidraw3.</source>
        <translation>Der Name, wie „underact-cli devices“ ihn auflistet, mit einer Seriennummer, einem Pfad oder einer Adresse nach dem Doppelpunkt: wooden:/dev/hidraw3.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opens the arm with this name.</source>
        <translation>Öffnet den Arm dieses Namens.</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Pose of the arm on the desk</source>
        <translation>Lage des Arms auf dem Tisch</translation>
    </message>
    <message>
        <source>Register the arm…</source>
        <translation>Arm registrieren …</translation>
    </message>
    <message>
        <source>Arm being opened</source>
        <translation>Arm, der geöffnet wird</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops opening this arm. The simulated arm stays in use.</source>
        <translation>Bricht das Öffnen ab. Der simulierte Arm bleibt in Gebrauch.</translation>
    </message>
    <message>
        <source>The arm was not changed. %1</source>
        <translation>Der Arm wurde nicht gewechselt. %1</translation>
    </message>
    <message>
        <source>The arm must not be in use: switch to the simulated arm first. The command reads from the arm for two seconds, without any force, and writes a report. Add what you felt, and send the file to the developers.</source>
        <translation>Der Arm darf nicht in Gebrauch sein: Wechseln Sie zuerst zum simulierten Arm. Der Befehl liest zwei Sekunden lang vom Arm, ohne Kraft, und schreibt einen Bericht. Fügen Sie hinzu, was Sie gefühlt haben, und senden Sie die Datei an die Entwickler.</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>In use: %1. Untested on hardware: start with a soft scene and keep a hand on Stop.</source>
        <translation>In Gebrauch: %1. Nicht am Gerät erprobt: Beginnen Sie mit einer weichen Szene und lassen Sie eine Hand an Stopp.</translation>
    </message>
    <message>
        <source>In use: %1.</source>
        <translation>In Gebrauch: %1.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
</context>
<context>
    <name>underact::gui::DhPanel</name>
    <message>
        <source>Table to start from</source>
        <translation>Ausgangstabelle</translation>
    </message>
    <message>
        <source>Replaces this table with that of an arm.</source>
        <translation>Ersetzt diese Tabelle durch die eines Arms.</translation>
    </message>
    <message>
        <source>The scene's arm</source>
        <translation>Arm der Szene</translation>
    </message>
    <message>
        <source>DH table</source>
        <translation>DH-Tabelle</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>&amp;Joints follow the arm</source>
        <translation>&amp;Gelenke folgen dem Arm</translation>
    </message>
    <message>
        <source>Joints follow the arm</source>
        <translation>Gelenke folgen dem Arm</translation>
    </message>
    <message>
        <source>Revolute joints 1 to 6 take the angles of the arm's joints: move the stylus, and the table follows.</source>
        <translation>Die Drehgelenke 1 bis 6 übernehmen die Gelenkwinkel des Arms: Bewegen Sie den Stift, und die Tabelle folgt.</translation>
    </message>
    <message>
        <source>x [mm]</source>
        <translation>x [mm]</translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation>y [mm]</translation>
    </message>
    <message>
        <source>z [mm]</source>
        <translation>z [mm]</translation>
    </message>
    <message>
        <source>Tip of the table</source>
        <translation>Spitze (Tabelle)</translation>
    </message>
    <message>
        <source>The position of the tip computed from the table, ⁰T₁ ¹T₂ …, in the workspace frame.</source>
        <translation>Die Position der Spitze nach der Tabelle, ⁰T₁ ¹T₂ …, im Koordinatensystem des Arbeitsraums.</translation>
    </message>
    <message>
        <source>Offset from arm</source>
        <translation>Abstand vom Arm</translation>
    </message>
    <message>
        <source>The vector from the tip of the arm to the tip of the table; 0 if the table is that of the arm.</source>
        <translation>Der Vektor von der Spitze des Arms zu der der Tabelle; 0, wenn die Tabelle die des Arms ist.</translation>
    </message>
    <message>
        <source>Notes on the table</source>
        <translation>Hinweise zur Tabelle</translation>
    </message>
    <message>
        <source>Why the input was refused</source>
        <translation>Warum die Eingabe abgelehnt wurde</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Adds a row after the selected one; 8 at most.</source>
        <translation>Fügt nach der gewählten eine Zeile hinzu; höchstens 8.</translation>
    </message>
    <message>
        <source>Add a row</source>
        <translation>Zeile hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected row; a table has at least one.</source>
        <translation>Entfernt die gewählte Zeile; eine Tabelle hat mindestens eine.</translation>
    </message>
    <message>
        <source>Remove the selected row</source>
        <translation>Gewählte Zeile entfernen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change to the table.</source>
        <translation>Macht die letzte Änderung der Tabelle rückgängig.</translation>
    </message>
    <message>
        <source>Undo the last change to the table</source>
        <translation>Letzte Änderung der Tabelle rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redoes the change that was undone.</source>
        <translation>Führt die rückgängig gemachte Änderung wieder aus.</translation>
    </message>
    <message>
        <source>Redo the change to the table</source>
        <translation>Änderung der Tabelle wiederholen</translation>
    </message>
    <message>
        <source>row %1, %2</source>
        <translation>Zeile %1, %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::DhSection</name>
    <message>
        <source>DH table</source>
        <translation>DH-Tabelle</translation>
    </message>
    <message>
        <source>Modified (Craig) convention: from frame i−1 to i by Rx(α) Dx(a) Rz(θ) Dz(d); θ includes the current joint angle. Thesis table 3.1; Craig, eq. 3.6.</source>
        <translation>Modifizierte Konvention (Craig): von Koordinatensystem i−1 zu i durch Rx(α) Dx(a) Rz(θ) Dz(d); θ enthält den jetzigen Gelenkwinkel. Thesis, Tabelle 3.1; Craig, Gl. 3.6.</translation>
    </message>
    <message>
        <source>α [°]</source>
        <translation>α [°]</translation>
    </message>
    <message>
        <source>a [mm]</source>
        <translation>a [mm]</translation>
    </message>
    <message>
        <source>θ [°]</source>
        <translation>θ [°]</translation>
    </message>
    <message>
        <source>d [mm]</source>
        <translation>d [mm]</translation>
    </message>
    <message>
        <source>Twist α and length a of link %1, angle θ and offset d of joint %2.</source>
        <translation>Verwindung α und Länge a von Glied %1, Winkel θ und Versatz d von Gelenk %2.</translation>
    </message>
</context>
<context>
    <name>underact::gui::DistanceBar</name>
    <message>
        <source>%1, warning when near</source>
        <translation>%1, Warnung bei Nähe</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
</context>
<context>
    <name>underact::gui::Document</name>
    <message>
        <source>tuning of last time</source>
        <translation>Einstellung vom letzten Mal</translation>
    </message>
    <message>
        <source>edits</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>left-handed</source>
        <translation>linkshändig</translation>
    </message>
    <message>
        <source>right-handed</source>
        <translation>rechtshändig</translation>
    </message>
</context>
<context>
    <name>underact::gui::DragHint</name>
    <message>
        <source>How to begin</source>
        <translation>Wie man beginnt</translation>
    </message>
    <message>
        <source>Drag the stylus with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus.</translation>
    </message>
</context>
<context>
    <name>underact::gui::DropOverlay</name>
    <message>
        <source>A file over the window</source>
        <translation>Eine Datei über dem Fenster</translation>
    </message>
    <message>
        <source>What dropping the file does</source>
        <translation>Was das Loslassen der Datei bewirkt</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
</context>
<context>
    <name>underact::gui::FaultDialog</name>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>Was es bedeutet</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Fault file</source>
        <translation>Störungsdatei</translation>
    </message>
    <message>
        <source>The servo has stopped</source>
        <translation>Der Servo hat gestoppt</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Störungen</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>Wieder &amp;starten</translation>
    </message>
    <message>
        <source>Turns the force on again, with a soft start.</source>
        <translation>Schaltet die Kraft mit sanftem Start wieder ein.</translation>
    </message>
    <message>
        <source>&amp;Restart the servo</source>
        <translation>Servo &amp;neu starten</translation>
    </message>
    <message>
        <source>Reopens the arm and restarts the servo. Then press Start.</source>
        <translation>Öffnet den Arm erneut und startet den Servo neu. Drücken Sie danach Start.</translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation>&amp;Ordner zeigen</translation>
    </message>
    <message>
        <source>Opens the folder that holds the file.</source>
        <translation>Öffnet den Ordner, in dem die Datei liegt.</translation>
    </message>
    <message>
        <source>Copy &amp;path</source>
        <translation>&amp;Pfad kopieren</translation>
    </message>
    <message>
        <source>Copies the path of the file.</source>
        <translation>Kopiert den Pfad der Datei.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this message. The servo stays stopped until you press Start.</source>
        <translation>Schließt diese Meldung. Der Servo bleibt gestoppt, bis Sie Start drücken.</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>Force is off and stays off until you press Start.</source>
        <translation>Die Kraft ist aus und bleibt aus, bis Sie Start drücken.</translation>
    </message>
    <message>
        <source>The last second before the fault is saved in %1</source>
        <translation>Die letzte Sekunde vor der Störung ist gespeichert in %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::FaultPlot</name>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>Latency [µs]</source>
        <translation>Latenz [µs]</translation>
    </message>
    <message>
        <source>The second before the fault</source>
        <translation>Die Sekunde vor der Störung</translation>
    </message>
    <message>
        <source>Force and latency of the ticks before the fault, which is at the right edge.</source>
        <translation>Kraft und Latenz der Takte vor der Störung; sie selbst liegt am rechten Rand.</translation>
    </message>
</context>
<context>
    <name>underact::gui::FaultWatch</name>
    <message>
        <source>Show the last &amp;fault</source>
        <translation>L&amp;etzte Störung zeigen</translation>
    </message>
    <message>
        <source>Shows what last stopped the servo, and where the fault file is.</source>
        <translation>Zeigt, was den Servo zuletzt gestoppt hat und wo die Störungsdatei liegt.</translation>
    </message>
</context>
<context>
    <name>underact::gui::FeelFoot</name>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Why the change was refused</source>
        <translation>Warum die Änderung abgelehnt wurde</translation>
    </message>
    <message>
        <source>A sampled wall with one tick of delay is stable for K &lt; (b + B) / (1.5 T); b: damping of the hand, B: kd, T: period of the servo. Lower the stiffness or hold the stylus more firmly.</source>
        <translation>Eine abgetastete Wand mit einem Takt Verzögerung ist stabil für K &lt; (b + B) / (1.5 T); b: Dämpfung der Hand, B: kd, T: Periode des Servos. Verringern Sie die Steifigkeit oder halten Sie den Stift fester.</translation>
    </message>
</context>
<context>
    <name>underact::gui::FeelPanel</name>
    <message>
        <source>Constraint whose gains are shown</source>
        <translation>Bindung, deren Verstärkungen angezeigt werden</translation>
    </message>
    <message>
        <source>Selects the constraint whose gains are shown below.</source>
        <translation>Wählt die Bindung, deren Verstärkungen unten angezeigt werden.</translation>
    </message>
    <message>
        <source>&amp;Constraint</source>
        <translation>&amp;Bindung</translation>
    </message>
    <message>
        <source>&amp;Law</source>
        <translation>Re&amp;gelgesetz</translation>
    </message>
    <message>
        <source>Control law</source>
        <translation>Regelgesetz</translation>
    </message>
    <message>
        <source>&amp;Works on</source>
        <translation>&amp;Wirkt auf</translation>
    </message>
    <message>
        <source>What the control law works on</source>
        <translation>Worauf das Regelgesetz wirkt</translation>
    </message>
    <message>
        <source>&amp;Nearest</source>
        <translation>&amp;Nächster</translation>
    </message>
    <message>
        <source>Nearest point with unequal gains</source>
        <translation>Nächster Punkt bei ungleichen Verstärkungen</translation>
    </message>
    <message>
        <source>direction of the guide</source>
        <translation>Richtung der Führung</translation>
    </message>
    <message>
        <source>Reset to &amp;scene</source>
        <translation>Auf Szene &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Restores control law, gains, influence, friction and guidance to the values in the scene file.</source>
        <translation>Setzt Regelgesetz, Verstärkungen, Einfluss, Reibung und Führung auf die Werte der Szenendatei zurück.</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>reset to scene</source>
        <translation>auf Szene zurücksetzen</translation>
    </message>
    <message>
        <source>Influence t</source>
        <translation>Einfluss t</translation>
    </message>
    <message>
        <source>Where the target lies on the circle, cylinder or sphere, between the point that the stylus points at and the point nearest to the tip: theta = alpha + t wrap(beta - alpha) (thesis equation 5.3).</source>
        <translation>Wo das Ziel auf Kreis, Zylinder oder Kugel liegt, zwischen dem Punkt, auf den der Stift zeigt, und dem, der der Spitze am nächsten ist: theta = alpha + t wrap(beta - alpha) (Thesis, Gl. 5.3).</translation>
    </message>
    <message>
        <source>&amp;Use stylus orientation</source>
        <translation>Stift&amp;orientierung nutzen</translation>
    </message>
    <message>
        <source>Use stylus orientation</source>
        <translation>Stiftorientierung nutzen</translation>
    </message>
    <message>
        <source>Off: the target is the point nearest to the tip. On: rotating the stylus moves the target, too.</source>
        <translation>Aus: Das Ziel ist der Punkt, der der Spitze am nächsten ist. An: Auch das Drehen des Stifts bewegt das Ziel.</translation>
    </message>
    <message>
        <source>influence on</source>
        <translation>Einfluss an</translation>
    </message>
    <message>
        <source>influence off</source>
        <translation>Einfluss aus</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>&amp;Stylus axis</source>
        <translation>&amp;Stiftachse</translation>
    </message>
    <message>
        <source>Stylus axis that points at the target</source>
        <translation>Stiftachse, die auf das Ziel zeigt</translation>
    </message>
    <message>
        <source>Blend width</source>
        <translation>Übergangsbreite</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>F&amp;riction</source>
        <translation>&amp;Reibung</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Off: the stylus slides freely along the surface. On: it sticks until the force along the surface exceeds the static coefficient times the normal force; then it slides against the dynamic coefficient times the normal force (Coulomb).</source>
        <translation>Aus: Der Stift gleitet frei die Oberfläche entlang. An: Er haftet, bis die Kraft entlang der Oberfläche die Haftreibungszahl mal Normalkraft übersteigt; dann gleitet er gegen die Gleitreibungszahl mal Normalkraft (Coulomb).</translation>
    </message>
    <message>
        <source>friction on</source>
        <translation>Reibung an</translation>
    </message>
    <message>
        <source>friction off</source>
        <translation>Reibung aus</translation>
    </message>
    <message>
        <source>Dynamic</source>
        <translation>Gleiten</translation>
    </message>
    <message>
        <source>Static</source>
        <translation>Haften</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>Dynamic friction</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooth bends</source>
        <translation>Knicke glätten</translation>
    </message>
    <message>
        <source>Se&amp;arch</source>
        <translation>S&amp;uche</translation>
    </message>
    <message>
        <source>Search for the nearest point of the mesh</source>
        <translation>Suche nach dem nächsten Punkt des Dreiecksnetzes</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>&amp;Guide the hand</source>
        <translation>&amp;Hand führen</translation>
    </message>
    <message>
        <source>Guide the hand along the curve</source>
        <translation>Hand entlang der Kurve führen</translation>
    </message>
    <message>
        <source>Off: the target is the nearest point of the curve. On: a guide point runs ahead of the hand along the curve, pulls it along and waits for it.</source>
        <translation>Aus: Das Ziel ist der nächste Punkt der Kurve. An: Ein Führungspunkt läuft der Hand auf der Kurve voraus, zieht sie mit und wartet auf sie.</translation>
    </message>
    <message>
        <source>guidance on</source>
        <translation>Führung an</translation>
    </message>
    <message>
        <source>guidance off</source>
        <translation>Führung aus</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of the guide</source>
        <translation>Tempo der Führung</translation>
    </message>
    <message>
        <source>Bac&amp;kwards</source>
        <translation>Rü&amp;ckwärts</translation>
    </message>
    <message>
        <source>The guide runs backwards</source>
        <translation>Die Führung läuft rückwärts</translation>
    </message>
    <message>
        <source>Influence of the hand's position on the curve</source>
        <translation>Einfluss der Position der Hand auf der Kurve</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Vorlauf</translation>
    </message>
    <message>
        <source>Lead of the guide</source>
        <translation>Vorlauf der Führung</translation>
    </message>
    <message>
        <source>Velocity and energy</source>
        <translation>Geschwindigkeit und Energie</translation>
    </message>
    <message>
        <source>How the velocity for damping is estimated, and whether the energy of the constraint is observed.</source>
        <translation>Wie die Geschwindigkeit für die Dämpfung geschätzt wird und ob die Energie der Bindung beobachtet wird.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>&amp;Velocity</source>
        <translation>&amp;Filter</translation>
    </message>
    <message>
        <source>Velocity filter</source>
        <translation>Geschwindigkeitsfilter</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>Zeitkonstante</translation>
    </message>
    <message>
        <source>Longest window</source>
        <translation>Längstes Fenster</translation>
    </message>
    <message>
        <source>&amp;Passivity</source>
        <translation>&amp;Passivität</translation>
    </message>
    <message>
        <source>Passivity</source>
        <translation>Passivität</translation>
    </message>
</context>
<context>
    <name>underact::gui::FigureChooser</name>
    <message>
        <source>Figures</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>%1  %2
%3</source>
        <translation>%1  %2
%3</translation>
    </message>
</context>
<context>
    <name>underact::gui::FigureSheet</name>
    <message>
        <source>Figure</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>Bildtext</translation>
    </message>
    <message>
        <source>Numbers checked in the figure</source>
        <translation>Geprüfte Zahlen der Abbildung</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Figure %1: %2</source>
        <translation>Abbildung %1: %2</translation>
    </message>
    <message>
        <source>There is no picture.</source>
        <translation>Es gibt kein Bild.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>✓ pass</source>
        <translation>✓ stimmt</translation>
    </message>
    <message>
        <source>✗ fail</source>
        <translation>✗ weicht ab</translation>
    </message>
</context>
<context>
    <name>underact::gui::FiguresRun</name>
    <message>
        <source>Another window is making the figures. Wait until it has finished, then open this window again.</source>
        <translation>Ein anderes Fenster erstellt gerade die Abbildungen. Warten Sie, bis es fertig ist, und öffnen Sie dieses Fenster dann erneut.</translation>
    </message>
    <message>
        <source>The folder %1 is not writable. Change its permissions.</source>
        <translation>Der Ordner %1 ist nicht beschreibbar. Ändern Sie seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Cancelled. The earlier figures were kept.</source>
        <translation>Abgebrochen. Die früheren Abbildungen blieben erhalten.</translation>
    </message>
    <message>
        <source>The figures could not be saved in %1. Free some space there or change its permissions.</source>
        <translation>Die Abbildungen konnten nicht in %1 gespeichert werden. Schaffen Sie dort Platz oder ändern Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>The figures were not made, and underact-cli gave no reason.</source>
        <translation>Die Abbildungen wurden nicht erstellt, und underact-cli nannte keinen Grund.</translation>
    </message>
    <message>
        <source>The figures were not made. %1</source>
        <translation>Die Abbildungen wurden nicht erstellt. %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::FilmTool</name>
    <message>
        <source>Film…</source>
        <translation>Film …</translation>
    </message>
    <message>
        <source>Saves a film of the scene, moved by a scripted hand, or of the open session.</source>
        <translation>Speichert einen Film der Szene in einer vorgegebenen Hand oder der offenen Sitzung.</translation>
    </message>
    <message>
        <source>A film is being made.</source>
        <translation>Ein Film entsteht gerade.</translation>
    </message>
    <message>
        <source>Save the film</source>
        <translation>Film speichern</translation>
    </message>
    <message>
        <source>Films (*.webm *.mp4 *.gif)</source>
        <translation>Filme (*.webm *.mp4 *.gif)</translation>
    </message>
    <message>
        <source>Save the scene first: a film shows the scene's file.</source>
        <translation>Speichern Sie zuerst die Szene: Ein Film zeigt die Datei der Szene.</translation>
    </message>
    <message>
        <source>Filming %1</source>
        <translation>%1 wird gefilmt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Fortschritt des Films</translation>
    </message>
    <message>
        <source>Film saved as %1.</source>
        <translation>Film als %1 gespeichert.</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>The film was not made.</source>
        <translation>Der Film ist nicht entstanden.</translation>
    </message>
</context>
<context>
    <name>underact::gui::FixDialog</name>
    <message>
        <source>Command for a terminal</source>
        <translation>Befehl für ein Terminal</translation>
    </message>
    <message>
        <source>How to use this arm</source>
        <translation>Diesen Arm verwenden</translation>
    </message>
    <message>
        <source>What is missing</source>
        <translation>Was fehlt</translation>
    </message>
    <message>
        <source>Copy the command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Copies the command; paste it into a terminal.</source>
        <translation>Kopiert den Befehl; fügen Sie ihn in ein Terminal ein.</translation>
    </message>
</context>
<context>
    <name>underact::gui::GainSection</name>
    <message>
        <source>L&amp;ink x, y and z</source>
        <translation>x, y, z k&amp;oppeln</translation>
    </message>
    <message>
        <source>Link x, y and z</source>
        <translation>x, y, z koppeln</translation>
    </message>
    <message>
        <source>Changing one axis changes all three.</source>
        <translation>Die Änderung einer Achse ändert alle drei.</translation>
    </message>
    <message>
        <source>L&amp;ink q1, q2 and q3</source>
        <translation>q1, q2, q3 k&amp;oppeln</translation>
    </message>
</context>
<context>
    <name>underact::gui::GalleryDialog</name>
    <message>
        <source>State of the figures</source>
        <translation>Stand der Abbildungen</translation>
    </message>
    <message>
        <source>Figures of the thesis</source>
        <translation>Abbildungen der Thesis</translation>
    </message>
    <message>
        <source>&amp;Open the scene</source>
        <translation>S&amp;zene öffnen</translation>
    </message>
    <message>
        <source>Opens the figure's scene in the main window so that you can feel it.</source>
        <translation>Öffnet die Szene der Abbildung im Hauptfenster, sodass Sie sie fühlen können.</translation>
    </message>
    <message>
        <source>Open the s&amp;ession</source>
        <translation>S&amp;itzung öffnen</translation>
    </message>
    <message>
        <source>Replays the run that the figure was drawn from.</source>
        <translation>Gibt den Lauf wieder, aus dem die Abbildung gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Save as &amp;PDF…</source>
        <translation>Als &amp;PDF speichern …</translation>
    </message>
    <message>
        <source>Saves the figure in print quality.</source>
        <translation>Speichert die Abbildung in Druckqualität.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>&amp;Make the figures</source>
        <translation>Abbildu&amp;ngen erstellen</translation>
    </message>
    <message>
        <source>Runs every scene of the thesis again, draws the figures and checks their numbers.</source>
        <translation>Führt jede Szene der Thesis erneut aus, zeichnet die Abbildungen und prüft ihre Zahlen.</translation>
    </message>
    <message>
        <source>Show the pa&amp;ge</source>
        <translation>Sei&amp;te zeigen</translation>
    </message>
    <message>
        <source>Opens a page with all figures in the browser.</source>
        <translation>Öffnet eine Seite mit allen Abbildungen im Browser.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Closes this window and cancels any figures still being made.</source>
        <translation>Schließt dieses Fenster und bricht ein laufendes Erstellen ab.</translation>
    </message>
    <message>
        <source>The page could not be opened. Open it in a browser: %1</source>
        <translation>Die Seite ließ sich nicht öffnen. Öffnen Sie sie in einem Browser: %1</translation>
    </message>
    <message>
        <source>figure %1 (%2 of %3)</source>
        <translation>Abbildung %1 (%2 von %3)</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The figures are being made in the background, which takes about a minute. You can keep using the arm and the window.</source>
        <translation>Die Abbildungen werden im Hintergrund erstellt; das dauert etwa eine Minute. Sie können Arm und Fenster weiter benutzen.</translation>
    </message>
    <message>
        <source>&amp;Make the figures again</source>
        <translation>Abbildungen &amp;neu erstellen</translation>
    </message>
    <message>
        <source>Underact runs each scene of the thesis with a scripted hand, draws the figures and checks their numbers. Press “Make the figures”; this takes about a minute.</source>
        <translation>Underact führt jede Szene der Thesis mit einer skriptgesteuerten Hand aus, zeichnet die Abbildungen und prüft ihre Zahlen. Drücken Sie „Abbildungen erstellen“; das dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>Made by Underact %1 on %2.</source>
        <translation>Erstellt von Underact %1 am %2.</translation>
    </message>
    <message>
        <source>This is Underact %1; make the figures again to see its results.</source>
        <translation>Dies ist Underact %1; erstellen Sie die Abbildungen neu, um seine Ergebnisse zu sehen.</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Figure %1 was saved as %2</source>
        <translation>Abbildung %1 wurde gespeichert als %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::GhostHand</name>
    <message>
        <source>A session is being replayed. Close the replay first.</source>
        <translation>Eine Sitzung wird wiedergegeben. Schließen Sie zuerst die Wiedergabe.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>underact::gui::GhostStrip</name>
    <message>
        <source>Following a recorded hand</source>
        <translation>Einer aufgezeichneten Hand folgen</translation>
    </message>
    <message>
        <source>Play the ghost</source>
        <translation>Geisterbild abspielen</translation>
    </message>
    <message>
        <source>From the beginning</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Time of the ghost</source>
        <translation>Zeit des Geisterbilds</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of the ghost, as a multiple of the recorded speed.</source>
        <translation>Tempo des Geisterbilds, als Vielfaches des aufgezeichneten Tempos.</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Mirrors the ghost like the scenes for the left hand. Off: the hand as it was recorded.</source>
        <translation>Spiegelt das Geisterbild wie die Szenen für die linke Hand. Aus: die Hand, wie sie aufgezeichnet wurde.</translation>
    </message>
    <message>
        <source>Distance to the ghost</source>
        <translation>Abstand zum Geisterbild</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Remove the ghost</source>
        <translation>Geisterbild entfernen</translation>
    </message>
    <message>
        <source>Wait for me beyond</source>
        <translation>Auf mich warten ab</translation>
    </message>
    <message>
        <source>The ghost waits while you are farther away than this, and continues when you are within half the distance.</source>
        <translation>Das Geisterbild wartet, solange die Spitze weiter entfernt ist, und läuft weiter, sobald sie auf den halben Abstand heran ist.</translation>
    </message>
    <message>
        <source>Distance beyond which the ghost waits</source>
        <translation>Abstand, ab dem das Geisterbild wartet</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Wait at the start</source>
        <translation>Anfangs warten</translation>
    </message>
    <message>
        <source>The ghost waits at its beginning until you are there.</source>
        <translation>Das Geisterbild wartet an seinem Anfang, bis die Spitze dort ist.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>The ghost starts again at the end; each round is counted separately.</source>
        <translation>Am Ende beginnt das Geisterbild von vorn; jede Runde wird für sich gezählt.</translation>
    </message>
    <message>
        <source>What to do, and your result</source>
        <translation>Was zu tun ist, und Ihr Ergebnis</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the result of the last round to the clipboard.</source>
        <translation>Kopiert das Ergebnis der letzten Runde in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Copy the result</source>
        <translation>Ergebnis kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Previous round</source>
        <translation>Vorige Runde</translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation>Zur Aufzeichnung</translation>
    </message>
    <message>
        <source>Open that scene</source>
        <translation>Diese Szene öffnen</translation>
    </message>
    <message>
        <source>Opens the scene of the recording in place of the current one.</source>
        <translation>Öffnet die Szene der Aufzeichnung anstelle der jetzigen.</translation>
    </message>
    <message>
        <source>Pause the ghost</source>
        <translation>Geisterbild pausieren</translation>
    </message>
</context>
<context>
    <name>underact::gui::GuideList</name>
    <message>
        <source>Contents of the guide</source>
        <translation>Inhalt des Handbuchs</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>Suchergebnisse</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Nichts wurde gefunden.</translation>
    </message>
</context>
<context>
    <name>underact::gui::GuideTool</name>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Opens the guide at the page for whatever has the focus.</source>
        <translation>Öffnet das Handbuch auf der Seite zu dem, was den Fokus hat.</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>The guide cannot be opened.</source>
        <translation>Das Handbuch lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
</context>
<context>
    <name>underact::gui::GuideWindow</name>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Previous page (Alt+Left)</source>
        <translation>Vorige Seite (Alt+Links)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Next page (Alt+Right)</source>
        <translation>Nächste Seite (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Handbuch durchsuchen</translation>
    </message>
    <message>
        <source>Search the guide (Ctrl+F)</source>
        <translation>Handbuch durchsuchen (Strg+F)</translation>
    </message>
    <message>
        <source>Enter opens the selected result; F3 goes to the next match on the page.</source>
        <translation>Die Eingabetaste öffnet das gewählte Ergebnis; F3 geht zum nächsten Treffer auf der Seite.</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Kleiner</translation>
    </message>
    <message>
        <source>Smaller text (Ctrl+minus)</source>
        <translation>Kleinerer Text (Strg+Minus)</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Größer</translation>
    </message>
    <message>
        <source>Larger text (Ctrl+plus)</source>
        <translation>Größerer Text (Strg+Plus)</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>Prints the page (Ctrl+P)</source>
        <translation>Druckt die Seite (Strg+P)</translation>
    </message>
    <message>
        <source>PDF…</source>
        <translation>PDF …</translation>
    </message>
    <message>
        <source>Saves the page as PDF</source>
        <translation>Speichert die Seite als PDF</translation>
    </message>
    <message>
        <source>%1 – Guide</source>
        <translation>%1 – Handbuch</translation>
    </message>
</context>
<context>
    <name>underact::gui::Hand</name>
    <message>
        <source>Replay: no force is sent to the arm.</source>
        <translation>Wiedergabe: Es wird keine Kraft an den Arm gesendet.</translation>
    </message>
</context>
<context>
    <name>underact::gui::HelpDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>Maus und Tasten</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Was die Maus und die Tasten tun</translation>
    </message>
    <message>
        <source>The view shows what the hand feels: the constraint in blue, the stylus, the target in green and the force in orange. Start turns the force on; Stop and Esc turn it off.</source>
        <translation>Die Ansicht zeigt, was die Hand fühlt: die Bindung in Blau, den Stift, das Ziel in Grün und die Kraft in Orange. Start schaltet die Kraft ein; Stopp und Esc schalten sie aus.</translation>
    </message>
    <message>
        <source>The hand and the view</source>
        <translation>Die Hand und die Ansicht</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>underact::gui::HomeSection</name>
    <message>
        <source>Home pose</source>
        <translation>Grundstellung</translation>
    </message>
    <message>
        <source>Pose of the end effector V with all joints at 0: its position, and its orientation as rotations about x, then y, then z of W, R = Rz Ry Rx. The tip of the stylus is pulled towards V; the z axis of V can follow that of the stylus.</source>
        <translation>Lage des Endeffektors V, wenn alle Gelenke auf 0 stehen: seine Position und seine Orientierung als Drehungen um x, dann y, dann z von W, R = Rz Ry Rx. Die Spitze des Stifts wird zu V gezogen; die z-Achse von V kann der des Stifts folgen.</translation>
    </message>
    <message>
        <source>Home pose of the end effector</source>
        <translation>Grundstellung des Endeffektors</translation>
    </message>
    <message>
        <source>Along and about %1 of W.</source>
        <translation>Entlang und um %1 von W.</translation>
    </message>
    <message>
        <source>position [mm]</source>
        <translation>Position [mm]</translation>
    </message>
    <message>
        <source>orientation [°]</source>
        <translation>Orientierung [°]</translation>
    </message>
    <message>
        <source>home position, %1, mm</source>
        <translation>Position in Grundstellung, %1, mm</translation>
    </message>
    <message>
        <source>Position of the end effector with all joints at 0, in W.</source>
        <translation>Position des Endeffektors in W, wenn alle Gelenke auf 0 stehen.</translation>
    </message>
    <message>
        <source>home orientation, rotation about %1, degrees</source>
        <translation>Orientierung in Grundstellung, Drehung um %1, Grad</translation>
    </message>
    <message>
        <source>Orientation of the end effector with all joints at 0: R = Rz Ry Rx.</source>
        <translation>Orientierung des Endeffektors, wenn alle Gelenke auf 0 stehen: R = Rz Ry Rx.</translation>
    </message>
</context>
<context>
    <name>underact::gui::IdentifyRun</name>
    <message>
        <source>Another scene was opened, so the measurement was ended.</source>
        <translation>Eine andere Szene wurde geöffnet, daher wurde die Messung beendet.</translation>
    </message>
    <message>
        <source>A recording was opened, so the measurement was ended.</source>
        <translation>Eine Aufzeichnung wurde geöffnet, daher wurde die Messung beendet.</translation>
    </message>
    <message>
        <source>Another arm is simulated now, so the measurement was ended.</source>
        <translation>Jetzt wird ein anderer Arm simuliert, daher wurde die Messung beendet.</translation>
    </message>
    <message>
        <source>%1 Force is off. Fix the cause, then press “Repeat this part”.</source>
        <translation>%1 Die Kraft ist aus. Beheben Sie die Ursache und drücken Sie dann „Diesen Teil wiederholen“.</translation>
    </message>
    <message>
        <source>The servo was stopped.</source>
        <translation>Der Servo wurde gestoppt.</translation>
    </message>
    <message>
        <source>The servo rate was changed during the measurement. Set it back to %1 Hz, or go back and begin again.</source>
        <translation>Die Servo-Taktrate wurde während der Messung geändert. Stellen Sie sie auf %1 Hz zurück, oder gehen Sie zurück und beginnen Sie neu.</translation>
    </message>
    <message>
        <source>The scene is for another arm now, so the measurement was ended.</source>
        <translation>Die Szene ist jetzt für einen anderen Arm, daher wurde die Messung beendet.</translation>
    </message>
    <message>
        <source>The scene was changed during the measurement.</source>
        <translation>Die Szene wurde während der Messung geändert.</translation>
    </message>
    <message>
        <source>Evaluating</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>A simulated hand does this for you: %1</source>
        <translation>Eine simulierte Hand macht das für Sie: %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::IdentifyTool</name>
    <message>
        <source>Me&amp;asure the arm…</source>
        <translation>Arm &amp;vermessen …</translation>
    </message>
    <message>
        <source>Measures mass, friction, damping, encoder resolution and rendered stiffness of this arm, step by step.</source>
        <translation>Misst Masse, Reibung, Dämpfung, Encoderauflösung und dargestellte Steifigkeit dieses Arms, Schritt für Schritt.</translation>
    </message>
    <message>
        <source>&amp;Open a measured arm…</source>
        <translation>Vermessenen Arm ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Gives the simulated arm the values of a measured arm, from its file.</source>
        <translation>Gibt dem simulierten Arm die Werte eines vermessenen Arms, aus dessen Datei.</translation>
    </message>
    <message>
        <source>Open a measured arm</source>
        <translation>Vermessenen Arm öffnen</translation>
    </message>
    <message>
        <source>Arm models (*.json)</source>
        <translation>Armmodelle (*.json)</translation>
    </message>
    <message>
        <source>&amp;Vendor's arm</source>
        <translation>&amp;Herstellerarm</translation>
    </message>
    <message>
        <source>Gives the simulated arm the vendor's values again.</source>
        <translation>Gibt dem simulierten Arm wieder die Werte des Herstellers.</translation>
    </message>
    <message>
        <source>Measured arm</source>
        <translation>Vermessener Arm</translation>
    </message>
    <message>
        <source>This file does not describe an arm that can be simulated. The arm is unchanged.</source>
        <translation>Diese Datei beschreibt keinen Arm, der sich simulieren lässt. Der Arm bleibt unverändert.</translation>
    </message>
</context>
<context>
    <name>underact::gui::IdentifyWizard</name>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>uncertainty</source>
        <translation>Unsicherheit</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>given</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>Swings shown</source>
        <translation>Gezeigte Schwingungen</translation>
    </message>
    <message>
        <source>Uncertainty: one standard deviation. “below”: not distinguishable from zero.</source>
        <translation>Unsicherheit: eine Standardabweichung. „unter“: nicht von null zu unterscheiden.</translation>
    </message>
    <message>
        <source> Given: the value of the simulated arm, or the stiffness that was commanded.</source>
        <translation> Vorgabe: der Wert des simulierten Arms oder die verlangte Steifigkeit.</translation>
    </message>
    <message>
        <source>Swings along %1 at position %2, residual of the fit %3 µm</source>
        <translation>Schwingungen entlang %1 an Position %2, Residuum der Anpassung %3 µm</translation>
    </message>
    <message>
        <source>Save the results</source>
        <translation>Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>A short name, shown in the status line.</source>
        <translation>Ein kurzer Name, der in der Statuszeile steht.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Titel</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>Herkunft</translation>
    </message>
    <message>
        <source>&amp;Save the arm…</source>
        <translation>Arm &amp;speichern …</translation>
    </message>
    <message>
        <source>Saves an arm file, for “Open a measured arm” and for the option --arm-model.</source>
        <translation>Speichert eine Armdatei, für „Vermessenen Arm öffnen“ und für die Option --arm-model.</translation>
    </message>
    <message>
        <source>Save the &amp;report…</source>
        <translation>&amp;Bericht speichern …</translation>
    </message>
    <message>
        <source>Saves the results as a Markdown file.</source>
        <translation>Speichert die Ergebnisse als Markdown-Datei.</translation>
    </message>
    <message>
        <source>&amp;Use this arm</source>
        <translation>Arm &amp;verwenden</translation>
    </message>
    <message>
        <source>Gives the simulated arm these values, until you choose another arm.</source>
        <translation>Gibt dem simulierten Arm diese Werte, bis Sie einen anderen Arm wählen.</translation>
    </message>
    <message>
        <source>Result of the last action</source>
        <translation>Ergebnis der letzten Aktion</translation>
    </message>
    <message>
        <source>Save the arm</source>
        <translation>Arm speichern</translation>
    </message>
    <message>
        <source>Arm models (*.json)</source>
        <translation>Armmodelle (*.json)</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation>Markdown (*.md)</translation>
    </message>
    <message>
        <source>The simulated arm is now “%1”.</source>
        <translation>Der simulierte Arm ist jetzt „%1“.</translation>
    </message>
    <message>
        <source>measured-%1</source>
        <translation>measured-%1</translation>
    </message>
    <message>
        <source>%1, measured on %2</source>
        <translation>%1, vermessen am %2</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation>%1 konnte nicht geschrieben werden: %2.</translation>
    </message>
    <message>
        <source>Measure the arm</source>
        <translation>Arm vermessen</translation>
    </message>
    <message>
        <source>This wizard measures the arm: the mass, friction and damping at its tip along x, y and z, the resolution of its encoders, and the stiffness that it actually renders. At the end you can save an arm file and a report.</source>
        <translation>Dieser Assistent vermisst den Arm: Masse, Reibung und Dämpfung an der Spitze entlang x, y und z, die Auflösung der Encoder und die Steifigkeit, die der Arm tatsächlich darstellt. Am Ende können Sie eine Armdatei und einen Bericht speichern.</translation>
    </message>
    <message>
        <source>The arm is simulated, and a simulated hand follows the instructions. This takes half a minute.</source>
        <translation>Der Arm ist simuliert, und eine simulierte Hand folgt den Anweisungen. Das dauert eine halbe Minute.</translation>
    </message>
    <message>
        <source>First let go of the stylus: for about 20 seconds the arm moves it by itself, 20 mm to each side, with no more force than any scene may use. Then take the stylus, press it down slowly, and rotate it. This takes about a minute.</source>
        <translation>Lassen Sie zuerst den Stift los: Etwa 20 Sekunden lang bewegt der Arm ihn selbst, 20 mm nach jeder Seite, mit höchstens der Kraft, die jede Szene verwenden darf. Nehmen Sie danach den Stift, drücken Sie ihn langsam nach unten und drehen Sie ihn. Das dauert etwa eine Minute.</translation>
    </message>
    <message>
        <source>Esc stops the force at any time. The open scene is restored afterwards.</source>
        <translation>Esc stoppt die Kraft jederzeit. Die geöffnete Szene wird danach wiederhergestellt.</translation>
    </message>
    <message>
        <source>Position and arm</source>
        <translation>Position und Arm</translation>
    </message>
    <message>
        <source>Position &amp;x</source>
        <translation>Position &amp;x</translation>
    </message>
    <message>
        <source>Position &amp;y</source>
        <translation>Position &amp;y</translation>
    </message>
    <message>
        <source>Position &amp;z</source>
        <translation>Position &amp;z</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The tip swings about this position, in the workspace frame W.</source>
        <translation>Die Spitze schwingt um diese Position, im Koordinatensystem W des Arbeitsraums.</translation>
    </message>
    <message>
        <source>Also at &amp;two more positions, to the left and to the right</source>
        <translation>Auch an zwei &amp;weiteren Positionen, links und rechts</translation>
    </message>
    <message>
        <source>Also at two more positions</source>
        <translation>Auch an zwei weiteren Positionen</translation>
    </message>
    <message>
        <source>Shows whether the results depend on the position; takes three times as long.</source>
        <translation>Zeigt, ob die Ergebnisse von der Position abhängen; dauert dreimal so lange.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Which arm this is; saved in the file.</source>
        <translation>Welcher Arm es ist; wird in der Datei gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>&amp;Arm</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>As printed on the arm; optional.</source>
        <translation>Wie auf dem Arm angegeben; darf leer bleiben.</translation>
    </message>
    <message>
        <source>&amp;Serial number</source>
        <translation>&amp;Seriennummer</translation>
    </message>
    <message>
        <source>The servo runs at %1 Hz.</source>
        <translation>Der Servo läuft mit %1 Hz.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Current part of the measurement</source>
        <translation>Aktueller Teil der Messung</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Why the measurement has stopped</source>
        <translation>Warum die Messung unterbrochen ist</translation>
    </message>
    <message>
        <source>Con&amp;tinue</source>
        <translation>&amp;Fortfahren</translation>
    </message>
    <message>
        <source>Starts this part. First take the stylus or let go of it, as the instruction says.</source>
        <translation>Startet diesen Teil. Nehmen Sie vorher den Stift, oder lassen Sie ihn los, wie es die Anweisung sagt.</translation>
    </message>
    <message>
        <source>&amp;Repeat this part</source>
        <translation>Diesen Teil &amp;wiederholen</translation>
    </message>
    <message>
        <source>Starts the servo again and repeats the interrupted part from its beginning.</source>
        <translation>Startet den Servo wieder und wiederholt den unterbrochenen Teil von vorn.</translation>
    </message>
    <message>
        <source>&amp;Begin again</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
</context>
<context>
    <name>underact::gui::InputDevices</name>
    <message>
        <source>The input devices have no effect now: they move the simulated arm, which is not in use.</source>
        <translation>Die Eingabegeräte sind jetzt ohne Wirkung: Sie bewegen den simulierten Arm, und der ist nicht in Gebrauch.</translation>
    </message>
    <message>
        <source>The mapping of %1 cannot be read; the default mapping is used. %2</source>
        <translation>Die Belegung von %1 kann nicht gelesen werden; die Standardbelegung wird verwendet. %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::InputDevicesPanel</name>
    <message>
        <source>not ready</source>
        <translation>nicht bereit</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>moves the stylus</source>
        <translation>bewegt den Stift</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>State of the input devices</source>
        <translation>Zustand der Eingabegeräte</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Input devices</source>
        <translation>Eingabegeräte</translation>
    </message>
    <message>
        <source>The input devices that are plugged in. An unticked device is ignored.</source>
        <translation>Die angeschlossenen Eingabegeräte. Ein Gerät ohne Häkchen wird ignoriert.</translation>
    </message>
    <message>
        <source>About the selected device</source>
        <translation>Über das gewählte Gerät</translation>
    </message>
    <message>
        <source>How to fix it…</source>
        <translation>Abhilfe …</translation>
    </message>
    <message>
        <source>Shows the command that fixes the problem.</source>
        <translation>Zeigt den Befehl, der das Problem behebt.</translation>
    </message>
    <message>
        <source>Mouse and keyboard – always on</source>
        <translation>Maus und Tastatur – immer aktiv</translation>
    </message>
    <message>
        <source>Drag the stylus in the view, or click the view and press the arrow keys. Shift+F1 lists all keys. A game controller or 3D mouse appears in this list when you plug it in.</source>
        <translation>Ziehen Sie den Stift in der Ansicht, oder klicken Sie in die Ansicht und drücken Sie die Pfeiltasten. Umschalt+F1 listet alle Tasten auf. Ein Gamepad oder eine 3D-Maus erscheint in dieser Liste, wenn Sie das Gerät anschließen.</translation>
    </message>
    <message>
        <source>A %1, untested. Its mapping is saved.</source>
        <translation>%1, nicht erprobt. Die Belegung wird gespeichert.</translation>
    </message>
    <message>
        <source>Every device in use moves the simulated hand.</source>
        <translation>Jedes verwendete Gerät bewegt die simulierte Hand.</translation>
    </message>
</context>
<context>
    <name>underact::gui::JacobianSection</name>
    <message>
        <source>Jacobian</source>
        <translation>Jacobi-Matrix</translation>
    </message>
    <message>
        <source>Velocity v of the tip (m/rad) and angular velocity ω of the stylus (rad/rad) per joint rate, in the workspace frame: (v, ω) = J dq/dt; joint torques are τ = Jᵀ F. Derived from eq. 3.5.</source>
        <translation>Geschwindigkeit v der Spitze (m/rad) und Winkelgeschwindigkeit ω des Stifts (rad/rad) je Gelenkgeschwindigkeit, im Koordinatensystem des Arbeitsraums: (v, ω) = J dq/dt; die Gelenkdrehmomente sind τ = Jᵀ F. Hergeleitet aus Gl. 3.5.</translation>
    </message>
    <message>
        <source>&amp;Position only, J_p (3 × 3)</source>
        <translation>Nur &amp;Position, J_p (3 × 3)</translation>
    </message>
    <message>
        <source>Velocity of the tip along %1 of W per joint rate, m/rad.</source>
        <translation>Geschwindigkeit der Spitze entlang %1 von W je Gelenkgeschwindigkeit, m/rad.</translation>
    </message>
    <message>
        <source>Angular velocity of the stylus about %1 of W per joint rate, rad/rad.</source>
        <translation>Winkelgeschwindigkeit des Stifts um %1 von W je Gelenkgeschwindigkeit, rad/rad.</translation>
    </message>
    <message>
        <source>Only the position part of the Jacobian</source>
        <translation>Nur der Positionsteil der Jacobi-Matrix</translation>
    </message>
    <message>
        <source>Joints 4 to 6 rotate the stylus about its tip without moving it: v = J_p (q1, q2, q3)'.</source>
        <translation>Die Gelenke 4 bis 6 drehen den Stift um seine Spitze, ohne sie zu bewegen: v = J_p (q1, q2, q3)'.</translation>
    </message>
    <message>
        <source>det J_p</source>
        <translation>det J_p</translation>
    </message>
    <message>
        <source>L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)), per rad³; 0 at a singularity.</source>
        <translation>L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)), je rad³; 0 an einer Singularität.</translation>
    </message>
    <message>
        <source>Manipulability</source>
        <translation>Manipulierbarkeit</translation>
    </message>
    <message>
        <source>Yoshikawa's measure of manipulability, |det J_p|.</source>
        <translation>Das Maß der Manipulierbarkeit nach Yoshikawa, |det J_p|.</translation>
    </message>
    <message>
        <source>Condition number</source>
        <translation>Konditionszahl</translation>
    </message>
    <message>
        <source>Ratio of the largest to the smallest singular value of J_p; 1: the same in all directions.</source>
        <translation>Verhältnis des größten zum kleinsten Singulärwert von J_p; 1: in allen Richtungen gleich.</translation>
    </message>
    <message>
        <source>Singular values</source>
        <translation>Singulärwerte</translation>
    </message>
    <message>
        <source>Of J_p: displacement of the tip along each axis of the motion ellipsoid per radian of joint rotation. The force along the same axis per N m of joint torque is the reciprocal.</source>
        <translation>Von J_p: Weg der Spitze entlang jeder Achse des Bewegungsellipsoids je rad Gelenkdrehung. Die Kraft entlang derselben Achse je N m Gelenkdrehmoment ist der Kehrwert.</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>%1, %2, %3 m/rad</source>
        <translation>%1, %2, %3 m/rad</translation>
    </message>
</context>
<context>
    <name>underact::gui::JobStrip</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel the job</source>
        <translation>Den Vorgang abbrechen</translation>
    </message>
    <message>
        <source>Stops the job.</source>
        <translation>Beendet den Vorgang.</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>Running %1 again</source>
        <translation>%1 wird wiederholt</translation>
    </message>
    <message>
        <source>Drawing the plots of %1</source>
        <translation>Diagramme von %1 werden gezeichnet</translation>
    </message>
</context>
<context>
    <name>underact::gui::JointRow</name>
    <message>
        <source>Joint %1, limits</source>
        <translation>Gelenk %1, Grenzen</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>Joint %1, %2, slider</source>
        <translation>Gelenk %1, %2, Schieberegler</translation>
    </message>
    <message>
        <source>Joint %1, %2, millimetres</source>
        <translation>Gelenk %1, %2, Millimeter</translation>
    </message>
    <message>
        <source>Joint %1, %2, degrees</source>
        <translation>Gelenk %1, %2, Grad</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Limits %1 to %2 mm</source>
        <translation>Grenzen %1 bis %2 mm</translation>
    </message>
    <message>
        <source>Limits %1° to %2°</source>
        <translation>Grenzen %1° bis %2°</translation>
    </message>
    <message>
        <source>, marked below the slider.</source>
        <translation>, unter dem Schieberegler markiert.</translation>
    </message>
    <message>
        <source>at limit</source>
        <translation>an Grenze</translation>
    </message>
</context>
<context>
    <name>underact::gui::JointsSection</name>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>The joint angles q of the DH table, as measured by the encoders.</source>
        <translation>Die Gelenkwinkel q der DH-Tabelle, gemessen von den Encodern.</translation>
    </message>
    <message>
        <source>turret</source>
        <translation>Turm</translation>
    </message>
    <message>
        <source>thigh</source>
        <translation>Obers.</translation>
    </message>
    <message>
        <source>shin</source>
        <translation>Unters.</translation>
    </message>
    <message>
        <source>gimbal 1</source>
        <translation>Kardan 1</translation>
    </message>
    <message>
        <source>gimbal 2</source>
        <translation>Kardan 2</translation>
    </message>
    <message>
        <source>gimbal 3</source>
        <translation>Kardan 3</translation>
    </message>
    <message>
        <source>Angle q%1 of thesis table 3.1: measured and driven.</source>
        <translation>Winkel q%1 der Thesis, Tabelle 3.1: gemessen und angetrieben.</translation>
    </message>
    <message>
        <source>Angle q%1 of thesis table 3.1: measured, not driven.</source>
        <translation>Winkel q%1 der Thesis, Tabelle 3.1: gemessen, nicht angetrieben.</translation>
    </message>
    <message>
        <source>slide</source>
        <translation>schiebt</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>dreht</translation>
    </message>
    <message>
        <source>Joint %1 of the arm's file: measured and driven.</source>
        <translation>Gelenk %1 aus der Datei des Arms: gemessen und angetrieben.</translation>
    </message>
    <message>
        <source>Joint %1 of the arm's file: measured, not driven.</source>
        <translation>Gelenk %1 aus der Datei des Arms: gemessen, nicht angetrieben.</translation>
    </message>
    <message>
        <source>Each slider moves the simulated hand, which moves the arm.</source>
        <translation>Jeder Schieberegler bewegt die simulierte Hand, und diese den Arm.</translation>
    </message>
</context>
<context>
    <name>underact::gui::KinematicsPanel</name>
    <message>
        <source>&amp;Kinematics with all layers</source>
        <translation>Kinematik k&amp;omplett</translation>
    </message>
    <message>
        <source>Opens the Kinematics panel and shows link frames, inverse solutions and both ellipsoids. Choose it again to hide them.</source>
        <translation>Öffnet den Bereich Kinematik und zeigt Gliedkoordinaten, inverse Lösungen und beide Ellipsoide. Nochmals gewählt, blendet es sie aus.</translation>
    </message>
    <message>
        <source>%1, in the view</source>
        <translation>%1, in der Ansicht</translation>
    </message>
    <message>
        <source>v: displacement of the tip for 0.25 rad of joint rotation. f: force for %1 N m.</source>
        <translation>v: Weg der Spitze bei 0,25 rad Gelenkdrehung. f: Kraft bei %1 N m.</translation>
    </message>
    <message>
        <source>The replay moves the arm. Close the session to use the sliders.</source>
        <translation>Die Wiedergabe bewegt den Arm. Schließen Sie die Sitzung, um die Schieberegler zu benutzen.</translation>
    </message>
    <message>
        <source>A real arm is moved by hand: the sliders only show its joint angles.</source>
        <translation>Ein echter Arm wird von Hand bewegt: Die Schieberegler zeigen nur seine Gelenkwinkel.</translation>
    </message>
    <message>
        <source>The servo is running. Press Stop (Esc) to move the arm with the sliders.</source>
        <translation>Der Servo läuft. Drücken Sie Stopp (Esc), um den Arm mit den Schiebereglern zu bewegen.</translation>
    </message>
    <message>
        <source>The encoder of joint %1 has steps of %2°: this is the nearest one.</source>
        <translation>Der Encoder von Gelenk %1 hat Schritte von %2°: Näher kommt es nicht.</translation>
    </message>
    <message>
        <source>The replay moves the arm. Close the session to move it here.</source>
        <translation>Die Wiedergabe bewegt den Arm. Schließen Sie die Sitzung, um ihn hier zu bewegen.</translation>
    </message>
    <message>
        <source>A real arm is moved by hand.</source>
        <translation>Einen echten Arm bewegt die Hand.</translation>
    </message>
    <message>
        <source>The servo is running. Press Stop (Esc) to move the arm.</source>
        <translation>Der Servo läuft. Drücken Sie Stopp (Esc), um den Arm zu bewegen.</translation>
    </message>
    <message>
        <source>Solution %1 does not exist here.</source>
        <translation>Lösung %1 gibt es hier nicht.</translation>
    </message>
    <message>
        <source>Solution %1 is outside the joint limits.</source>
        <translation>Lösung %1 liegt außerhalb der Gelenkgrenzen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LabPanel</name>
    <message>
        <source>Choices of this scene</source>
        <translation>Wahlmöglichkeiten dieser Szene</translation>
    </message>
    <message>
        <source>Predicted time of a tick</source>
        <translation>Vorhergesagte Dauer eines Takts</translation>
    </message>
    <message>
        <source>Measuring. Window and servo keep running; do not change the scene.</source>
        <translation>Messung läuft. Fenster und Servo laufen weiter; ändern Sie die Szene nicht.</translation>
    </message>
    <message>
        <source>Cancelling: the current run ends first.</source>
        <translation>Abbruch: Der begonnene Lauf endet zuerst.</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was kept, since partial results would be misleading.</source>
        <translation>Abgebrochen. Nichts wurde behalten, da Teilergebnisse irreführend wären.</translation>
    </message>
    <message>
        <source>The scene was changed during the measurement, so the results do not apply to it. Measure again.</source>
        <translation>Die Szene wurde während der Messung geändert, daher gelten die Ergebnisse nicht für sie. Messen Sie erneut.</translation>
    </message>
    <message>
        <source>The finest run of this scene, or every other one, ended in a fault, so nothing can be compared. What could be measured is shown below. Lower gains may help.</source>
        <translation>Der feinste Lauf dieser Szene oder jeder andere endete mit einem Fehler, deshalb ist nichts zu vergleichen. Was gemessen werden konnte, steht unten. Kleinere Verstärkungen können helfen.</translation>
    </message>
    <message>
        <source> The rate stays at %1 Hz. </source>
        <translation> Die Taktrate bleibt bei %1 Hz. </translation>
    </message>
    <message>
        <source> The servo stays at %1 Hz.</source>
        <translation> Der Servo bleibt bei %1 Hz.</translation>
    </message>
    <message>
        <source>The scene was changed, so the results no longer apply and have been discarded. Measure again.</source>
        <translation>Die Szene wurde geändert, daher gelten die Ergebnisse nicht mehr und wurden verworfen. Messen Sie erneut.</translation>
    </message>
    <message>
        <source>speed or accuracy</source>
        <translation>Tempo oder Genauigkeit</translation>
    </message>
    <message>
        <source>The scene is unchanged. %1</source>
        <translation>Die Szene bleibt unverändert. %1</translation>
    </message>
    <message>
        <source>The rate stays at %1 Hz. %2</source>
        <translation>Die Taktrate bleibt bei %1 Hz. %2</translation>
    </message>
    <message>
        <source>Time of a tick: %1 predicted, %2 % of the period of %3 at %4 Hz.</source>
        <translation>Dauer eines Takts: %1 vorhergesagt, %2 % der Periode von %3 bei %4 Hz.</translation>
    </message>
    <message>
        <source>The current settings are none of the combinations that were measured.</source>
        <translation>Die jetzigen Einstellungen sind keine der gemessenen Kombinationen.</translation>
    </message>
    <message>
        <source>Processor time per second: %1. Error of the tip's path: %2, of the force: %3 N.</source>
        <translation>Prozessorzeit je Sekunde: %1. Bahnfehler der Spitze: %2, Kraftfehler: %3 N.</translation>
    </message>
    <message>
        <source>The rate changes to %1 Hz when you let go of the slider; the force is off for a moment then.</source>
        <translation>Die Taktrate wechselt auf %1 Hz, wenn Sie den Schieberegler loslassen; die Kraft setzt dann kurz aus.</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>Nothing differs from the scene that was measured.</source>
        <translation>Nichts weicht von der gemessenen Szene ab.</translation>
    </message>
    <message>
        <source>Measured %1 combinations; %2 are best trade-offs.</source>
        <translation>%1 Kombinationen gemessen; %2 sind bestmöglich.</translation>
    </message>
    <message>
        <source>Open a scene to measure it.</source>
        <translation>Öffnen Sie eine Szene, um sie zu messen.</translation>
    </message>
    <message>
        <source>Nothing has been measured yet. Measure runs this scene on a simulated arm of its own with every combination of choices, and compares cost and error. This takes about %1; window and servo keep running.</source>
        <translation>Noch ist nichts gemessen. „Messen“ führt diese Szene an einem eigenen simulierten Arm mit jeder Kombination der Wahlmöglichkeiten aus und vergleicht Kosten und Fehler. Das dauert etwa %1; Fenster und Servo laufen weiter.</translation>
    </message>
    <message>
        <source> The arm simulated here has the vendor's values, not those of “%1”.</source>
        <translation> Der hier simulierte Arm hat die Werte des Herstellers, nicht die von „%1“.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LatenessChart</name>
    <message>
        <source>Latency histogram</source>
        <translation>Histogramm der Latenz</translation>
    </message>
    <message>
        <source>Number of ticks by latency, both scales logarithmic. The line marks one period: ticks to the right of it were late.</source>
        <translation>Anzahl der Takte nach Latenz, beide Skalen logarithmisch. Die Linie markiert eine Periode: Takte rechts davon waren verspätet.</translation>
    </message>
    <message>
        <source>99 of 100 ticks have a latency of %1 µs or less</source>
        <translation>99 von 100 Takten haben höchstens %1 µs Latenz</translation>
    </message>
    <message>
        <source>1 µs</source>
        <translation>1 µs</translation>
    </message>
    <message>
        <source>1 ms</source>
        <translation>1 ms</translation>
    </message>
    <message>
        <source>100 ms</source>
        <translation>100 ms</translation>
    </message>
</context>
<context>
    <name>underact::gui::Learning</name>
    <message>
        <source>Press the button for “%1”.</source>
        <translation>Drücken Sie die Taste für „%1“.</translation>
    </message>
    <message>
        <source>Now press the button for the opposite direction.</source>
        <translation>Drücken Sie jetzt die Taste für die Gegenrichtung.</translation>
    </message>
    <message>
        <source>Push the stick fully, or press the button, that %1.</source>
        <translation>Bewegen Sie den Stick bis zum Anschlag oder drücken Sie die Taste für: %1.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonCard</name>
    <message>
        <source>%1 min, all steps solved</source>
        <translation>%1 min, alle Schritte gelöst</translation>
    </message>
    <message>
        <source>%1 min, %2 steps</source>
        <translation>%1 min, %2 Schritte</translation>
    </message>
    <message>
        <source>%1 min, %2 of %3 steps solved</source>
        <translation>%1 min, %2 von %3 Schritten gelöst</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonComplete</name>
    <message>
        <source>Lesson complete</source>
        <translation>Lektion abgeschlossen</translation>
    </message>
    <message>
        <source>What comes next</source>
        <translation>Was als Nächstes kommt</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>Nächste Lektion</translation>
    </message>
    <message>
        <source>Begins the next lesson.</source>
        <translation>Beginnt die nächste Lektion.</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Goes to the next step.</source>
        <translation>Geht zum nächsten Schritt.</translation>
    </message>
    <message>
        <source>✓ Lesson complete</source>
        <translation>✓ Lektion abgeschlossen</translation>
    </message>
    <message>
        <source>The last step is solved</source>
        <translation>Der letzte Schritt ist gelöst</translation>
    </message>
    <message>
        <source>This was the last lesson. Your own comes next: see Writing lessons in the guide.</source>
        <translation>Das war die letzte Lektion. Als Nächstes kommt Ihre eigene: siehe „Lektionen schreiben“ im Handbuch.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Als Nächstes: %1</translation>
    </message>
    <message>
        <source>Still open: step %1.</source>
        <translation>Noch offen: Schritt %1.</translation>
    </message>
    <message>
        <source>This step is solved.</source>
        <translation>Dieser Schritt ist gelöst.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonList</name>
    <message>
        <source>Lesson %1: %2</source>
        <translation>Lektion %1: %2</translation>
    </message>
    <message>
        <source>About the selected lesson</source>
        <translation>Über die gewählte Lektion</translation>
    </message>
    <message>
        <source>Why the lesson did not start</source>
        <translation>Warum die Lektion nicht begonnen wurde</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Enter or a click starts a lesson. Your scene and panels come back when you leave it.</source>
        <translation>Die Eingabetaste oder ein Klick beginnt eine Lektion. Ihre Szene und Bereiche kommen zurück, wenn Sie sie verlassen.</translation>
    </message>
    <message>
        <source>Open a lesson file</source>
        <translation>Eine Lektionsdatei öffnen</translation>
    </message>
    <message>
        <source>Why there are no lessons</source>
        <translation>Warum es keine Lektionen gibt</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Recently opened</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonPage</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Text des Schritts</translation>
    </message>
    <message>
        <source>Name in the report</source>
        <translation>Name im Bericht</translation>
    </message>
    <message>
        <source>Name in the report (optional)</source>
        <translation>Name im Bericht (optional)</translation>
    </message>
    <message>
        <source>Written to the report only and saved nowhere else.</source>
        <translation>Wird nur in den Bericht geschrieben und nirgends sonst gespeichert.</translation>
    </message>
    <message>
        <source>**Hint:**</source>
        <translation>**Hinweis:**</translation>
    </message>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – Schritt %2 von %3</translation>
    </message>
    <message>
        <source>✓ %1 (solved)</source>
        <translation>✓ %1 (gelöst)</translation>
    </message>
    <message>
        <source>The servo is stopped. Press Start (F5) to feel the force.</source>
        <translation>Der Servo ist gestoppt. Drücken Sie Start (F5), um die Kraft zu fühlen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonRun</name>
    <message>
        <source>“%1” contains errors; see the list.</source>
        <translation>„%1“ enthält Fehler; siehe die Liste.</translation>
    </message>
    <message>
        <source>A session is being replayed. Close it, then start the lesson.</source>
        <translation>Eine Sitzung wird wiedergegeben. Schließen Sie sie und beginnen Sie dann die Lektion.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LessonsPanel</name>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>Le&amp;ktion öffnen …</translation>
    </message>
    <message>
        <source>Opens a lesson from a file.</source>
        <translation>Öffnet eine Lektion aus einer Datei.</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>Lektion &amp;verlassen</translation>
    </message>
    <message>
        <source>Restores the scene and the panels from before the lesson.</source>
        <translation>Stellt Szene und Bereiche von vor der Lektion wieder her.</translation>
    </message>
    <message>
        <source>Save &amp;report…</source>
        <translation>&amp;Bericht speichern …</translation>
    </message>
    <message>
        <source>Saves what you did and measured in the lesson as a web page.</source>
        <translation>Speichert als Webseite, was Sie in der Lektion getan und gemessen haben.</translation>
    </message>
    <message>
        <source>&amp;All lessons</source>
        <translation>&amp;Alle Lektionen</translation>
    </message>
    <message>
        <source>Begins one of the lessons that ship.</source>
        <translation>Beginnt eine der mitgelieferten Lektionen.</translation>
    </message>
    <message>
        <source>Ne&amp;xt lesson</source>
        <translation>&amp;Nächste Lektion</translation>
    </message>
    <message>
        <source>Begins the lesson that comes after this one.</source>
        <translation>Beginnt die Lektion, die auf diese folgt.</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Goes to the next step of the lesson.</source>
        <translation>Geht zum nächsten Schritt der Lektion.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Goes to the previous step of the lesson.</source>
        <translation>Geht zum vorigen Schritt der Lektion.</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>&amp;Hinweis</translation>
    </message>
    <message>
        <source>Shows a hint for this step, below its text.</source>
        <translation>Zeigt einen Hinweis zu diesem Schritt unter seinem Text.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken …</translation>
    </message>
    <message>
        <source>Prints all steps of the lesson with their questions.</source>
        <translation>Druckt alle Schritte der Lektion mit ihren Fragen.</translation>
    </message>
    <message>
        <source>Save as P&amp;DF…</source>
        <translation>Als &amp;PDF speichern …</translation>
    </message>
    <message>
        <source>Saves all steps of the lesson with their questions as PDF.</source>
        <translation>Speichert alle Schritte der Lektion mit ihren Fragen als PDF.</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>New st&amp;udent…</source>
        <translation>Nächste Per&amp;son …</translation>
    </message>
    <message>
        <source>Clears name, progress and ticks for the next student; the report is kept.</source>
        <translation>Löscht Name, Fortschritt und Häkchen für die nächste Person; der Bericht bleibt.</translation>
    </message>
    <message>
        <source>&amp;Class results…</source>
        <translation>&amp;Ergebnisse der Klasse …</translation>
    </message>
    <message>
        <source>Makes one table of the reports in a folder, also for Moodle.</source>
        <translation>Macht aus den Berichten eines Ordners eine Tabelle, auch für Moodle.</translation>
    </message>
    <message>
        <source>Lesson not opened</source>
        <translation>Lektion nicht geöffnet</translation>
    </message>
    <message>
        <source>Open another lesson file</source>
        <translation>Eine andere Lektionsdatei öffnen</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>Not saved: %1. Choose another folder.</source>
        <translation>Nicht gespeichert: %1. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Report saved as %1.</source>
        <translation>Bericht gespeichert als %1.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html);;All files (*)</source>
        <translation>Webseiten (*.html);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json);;All files (*)</source>
        <translation>Lektionen (*.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>underact::gui::LimitsSection</name>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>How much each limit of the safety gate reduces the force.</source>
        <translation>Um wie viel jede Grenze der Kraftschleuse die Kraft verringert.</translation>
    </message>
    <message>
        <source>−0.00 N</source>
        <translation>−0,00 N</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>After Start the force ramps up within 0.3 s, after Stop it ramps down within 0.05 s. The bar shows the share that is held back.</source>
        <translation>Nach Start steigt die Kraft innerhalb von 0,3 s an, nach Stopp fällt sie innerhalb von 0,05 s ab. Der Balken zeigt den Anteil, der zurückgehalten wird.</translation>
    </message>
    <message>
        <source>Estimated heat of motor %1, relative to that at its continuous force. Computed, not measured: heating is proportional to the torque squared, with a time constant of 60 s.</source>
        <translation>Geschätzte Wärme von Motor %1, bezogen auf die bei Dauerkraft. Berechnet, nicht gemessen: Die Erwärmung ist proportional zum Quadrat des Drehmoments, mit einer Zeitkonstante von 60 s.</translation>
    </message>
    <message>
        <source>Motor heat (estimated)</source>
        <translation>Wärme der Motoren (geschätzt)</translation>
    </message>
    <message>
        <source>1, 2 or 3</source>
        <translation>1, 2 oder 3</translation>
    </message>
    <message>
        <source>1 turret</source>
        <translation>1 Drehturm</translation>
    </message>
    <message>
        <source>2 thigh</source>
        <translation>2 Oberschenkel</translation>
    </message>
    <message>
        <source>3 shin</source>
        <translation>3 Unterschenkel</translation>
    </message>
    <message>
        <source>released</source>
        <translation>losgelassen</translation>
    </message>
    <message>
        <source>not active yet</source>
        <translation>bisher nicht aktiv</translation>
    </message>
    <message>
        <source>%1, at most %2</source>
        <translation>%1, höchstens %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>underact::gui::LiveData</name>
    <message>
        <source>Send &amp;live data to PlotJuggler</source>
        <translation>&amp;Live-Daten an PlotJuggler senden</translation>
    </message>
    <message>
        <source>Sends every tick as JSON over UDP: to this computer, unless you give another address.</source>
        <translation>Sendet jeden Takt als JSON über UDP: an diesen Rechner, sofern Sie keine andere Adresse angeben.</translation>
    </message>
    <message>
        <source>Send live &amp;data to…</source>
        <translation>Live-Daten s&amp;enden an …</translation>
    </message>
    <message>
        <source>Sends every tick to an address that you give.</source>
        <translation>Sendet jeden Takt an eine Adresse, die Sie angeben.</translation>
    </message>
    <message>
        <source>live data to %1</source>
        <translation>Live-Daten an %1</translation>
    </message>
    <message>
        <source>%1 ticks sent, %2 could not be sent.</source>
        <translation>%1 Takte gesendet, %2 konnten nicht gesendet werden.</translation>
    </message>
    <message>
        <source>What the hand does is sent to another computer.</source>
        <translation>Was die Hand tut, wird an einen anderen Rechner gesendet.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LivePlot</name>
    <message>
        <source>Force along %1 [N]</source>
        <translation>Kraft entlang %1 [N]</translation>
    </message>
    <message>
        <source>Error [mm]</source>
        <translation>Fehler [mm]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>aufgezeichnet</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>passive</source>
        <translation>passiv</translation>
    </message>
    <message>
        <source>displacement [mm]</source>
        <translation>Auslenkung [mm]</translation>
    </message>
    <message>
        <source>Angle [°]</source>
        <translation>Winkel [°]</translation>
    </message>
    <message>
        <source>α stylus</source>
        <translation>α Stift</translation>
    </message>
    <message>
        <source>β tip</source>
        <translation>β Spitze</translation>
    </message>
    <message>
        <source>θ target</source>
        <translation>θ Ziel</translation>
    </message>
    <message>
        <source>Energy [mJ]</source>
        <translation>Energie [mJ]</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>Live plots</source>
        <translation>Live-Diagramme</translation>
    </message>
    <message>
        <source>Error and force over the last 10 seconds, and force against displacement along one axis.</source>
        <translation>Fehler und Kraft der letzten 10 Sekunden, und Kraft gegen Auslenkung entlang einer Achse.</translation>
    </message>
</context>
<context>
    <name>underact::gui::LiveService</name>
    <message>
        <source>Let pro&amp;grams steer</source>
        <translation>Pro&amp;gramme steuern lassen</translation>
    </message>
    <message>
        <source>Lets other programs on this computer read and steer the scene. They need a token.</source>
        <translation>Lässt andere Programme dieses Computers die Szene beobachten und steuern. Sie brauchen ein Token.</translation>
    </message>
    <message>
        <source>Programs can steer the scene now, at %1.</source>
        <translation>Programme können die Szene jetzt steuern, unter %1.</translation>
    </message>
    <message>
        <source>&amp;Block programs</source>
        <translation>Programme sperre&amp;n</translation>
    </message>
    <message>
        <source>Ends what programs do to the scene. None can steer it until you turn this off.</source>
        <translation>Beendet, was Programme mit der Szene tun. Keines kann sie steuern, bis Sie dies ausschalten.</translation>
    </message>
    <message>
        <source>Stopped. Programs cannot steer until “Block programs” is turned off.</source>
        <translation>Angehalten. Programme können erst wieder steuern, wenn „Programme sperren“ ausgeschaltet ist.</translation>
    </message>
    <message>
        <source>Live service</source>
        <translation>Live-Dienst</translation>
    </message>
    <message>
        <source>The programs that listen to the scene or steer it.</source>
        <translation>Die Programme, die die Szene beobachten oder steuern.</translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation>Kopiert: %1</translation>
    </message>
    <message>
        <source>Copy the &amp;address, %1</source>
        <translation>&amp;Adresse kopieren, %1</translation>
    </message>
    <message>
        <source>Copy the path of the &amp;token file</source>
        <translation>Pfad der &amp;Token-Datei kopieren</translation>
    </message>
    <message>
        <source>%1 steers</source>
        <translation>%1 steuert</translation>
    </message>
    <message>
        <source>%1 listens</source>
        <translation>%1 beobachtet</translation>
    </message>
    <message>
        <source>You steer</source>
        <translation>Sie steuern</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>1 program listens</source>
        <translation>1 Programm beobachtet</translation>
    </message>
    <message>
        <source>%1 programs listen</source>
        <translation>%1 Programme beobachten</translation>
    </message>
    <message>
        <source>Live service: %1</source>
        <translation>Live-Dienst: %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::LoadStrip</name>
    <message>
        <source>File that is being loaded</source>
        <translation>Datei, die geladen wird</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel loading</source>
        <translation>Laden abbrechen</translation>
    </message>
    <message>
        <source>Cancels loading. The scene is not changed.</source>
        <translation>Bricht das Laden ab. Die Szene wird nicht verändert.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::MainWindow</name>
    <message>
        <source>%1 (mirrored)[*] – Underact</source>
        <translation>%1 (gespiegelt)[*] – Underact</translation>
    </message>
    <message>
        <source>%1[*] – Underact</source>
        <translation>%1[*] – Underact</translation>
    </message>
    <message>
        <source>Underact</source>
        <translation>Underact</translation>
    </message>
    <message>
        <source>Panel tabs</source>
        <translation>Reiter der Bereiche</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>The settings on this computer were written by a newer version of Underact. This version starts with its defaults and leaves the saved settings unchanged.</source>
        <translation>Die Einstellungen auf diesem Rechner stammen von einer neueren Version von Underact. Diese Version startet mit ihren Vorgaben und lässt die gespeicherten Einstellungen unverändert.</translation>
    </message>
</context>
<context>
    <name>underact::gui::MapEditor</name>
    <message>
        <source>The mark shows the default value. Double-click to restore it.</source>
        <translation>Die Marke zeigt den Standardwert. Ein Doppelklick stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Belegung</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Was jetzt zu tun ist</translation>
    </message>
    <message>
        <source>Shows what %1.</source>
        <translation>Zeigt die Belegung für: %1.</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>Bewegt durch</translation>
    </message>
    <message>
        <source>The stick, buttons or triggers for this motion.</source>
        <translation>Der Stick, die Tasten oder Trigger für diese Bewegung.</translation>
    </message>
    <message>
        <source>Learn…</source>
        <translation>Lernen …</translation>
    </message>
    <message>
        <source>Assigns the stick or button that you use next.</source>
        <translation>Übernimmt den Stick oder die Taste, die Sie als Nächstes betätigen.</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Umgekehrt</translation>
    </message>
    <message>
        <source>Right becomes left, up becomes down.</source>
        <translation>Rechts wird zu links, oben zu unten.</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <translation>Totzone</translation>
    </message>
    <message>
        <source>Share of the stick's travel that has no effect.</source>
        <translation>Anteil des Stickwegs, der nichts bewirkt.</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>Fein</translation>
    </message>
    <message>
        <source>How fine the motion is near the centre: the speed grows with the deflection to the power of 1 + this value. 0: linear.</source>
        <translation>Wie fein die Bewegung nahe der Mitte ist: Das Tempo wächst mit der Auslenkung hoch 1 + diesem Wert. 0: linear.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of the tip at full deflection.</source>
        <translation>Tempo der Spitze bei voller Auslenkung.</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>Rotational speed at full deflection.</source>
        <translation>Drehgeschwindigkeit bei voller Auslenkung.</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change to a mapping.</source>
        <translation>Macht die letzte Änderung einer Belegung rückgängig.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redoes the change that was undone.</source>
        <translation>Führt die rückgängig gemachte Änderung wieder aus.</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Resets this device to its default mapping.</source>
        <translation>Setzt dieses Gerät auf die Standardbelegung zurück.</translation>
    </message>
    <message>
        <source>Mapping of %1</source>
        <translation>Belegung: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>underact::gui::MeasuringPart</name>
    <message>
        <source>Hands that move the stylus</source>
        <translation>Hände, die den Stift bewegen</translation>
    </message>
    <message>
        <source>Which simulated hands move the stylus during the measurement.</source>
        <translation>Welche simulierten Hände den Stift während der Messung bewegen.</translation>
    </message>
    <message>
        <source>All hands</source>
        <translation>Alle Hände</translation>
    </message>
    <message>
        <source>Length of each run, s</source>
        <translation>Länge jedes Laufs, s</translation>
    </message>
    <message>
        <source>How long each run is, in simulated time.</source>
        <translation>Wie lang jeder Lauf ist, in simulierter Zeit.</translation>
    </message>
    <message>
        <source> s each</source>
        <translation> s je Lauf</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measures cost and error of every choice for this scene, and finds the best trade-offs.</source>
        <translation>Misst Aufwand und Fehler jeder Wahl für diese Szene und findet die bestmöglichen Kombinationen.</translation>
    </message>
    <message>
        <source>Measure speed and accuracy of this scene</source>
        <translation>Tempo und Genauigkeit dieser Szene messen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ends the measurement; nothing is kept.</source>
        <translation>Beendet die Messung; nichts wird behalten.</translation>
    </message>
    <message>
        <source>Cancel the measurement</source>
        <translation>Messung abbrechen</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
    </message>
    <message>
        <source>Status of the measurement</source>
        <translation>Stand der Messung</translation>
    </message>
    <message>
        <source>&amp;Hands</source>
        <translation>&amp;Hände</translation>
    </message>
    <message>
        <source>R&amp;uns</source>
        <translation>Lä&amp;ufe</translation>
    </message>
</context>
<context>
    <name>underact::gui::MeshDialog</name>
    <message>
        <source>Mesh %1</source>
        <translation>Dreiecksnetz %1</translation>
    </message>
    <message>
        <source>Size of the mesh</source>
        <translation>Größe des Dreiecksnetzes</translation>
    </message>
    <message>
        <source>Report on the mesh</source>
        <translation>Bericht über das Dreiecksnetz</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Which unit</source>
        <translation>Welche Einheit</translation>
    </message>
    <message>
        <source>%1 Which unit is the file in?</source>
        <translation>%1 Welche Einheit hat die Datei?</translation>
    </message>
    <message>
        <source>In %1: %2 long</source>
        <translation>In %1: %2 lang</translation>
    </message>
    <message>
        <source>In millimetres, unchanged</source>
        <translation>In Millimetern, unverändert</translation>
    </message>
    <message>
        <source>How the mesh is felt</source>
        <translation>Wie das Dreiecksnetz gefühlt wird</translation>
    </message>
    <message>
        <source>wall, from outside</source>
        <translation>Wand, von außen</translation>
    </message>
    <message>
        <source>wall, from inside</source>
        <translation>Wand, von innen</translation>
    </message>
    <message>
        <source>surface that holds the tip</source>
        <translation>Oberfläche, die die Spitze hält</translation>
    </message>
    <message>
        <source>&amp;Felt as</source>
        <translation>Ge&amp;fühlt als</translation>
    </message>
    <message>
        <source>F&amp;riction</source>
        <translation>&amp;Reibung</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>Dynamic friction</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>static</source>
        <translation>Haften</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>Gleiten</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>C&amp;opy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copies the report.</source>
        <translation>Kopiert den Bericht.</translation>
    </message>
    <message>
        <source>Adds the mesh to the current scene.</source>
        <translation>Fügt das Dreiecksnetz der aktuellen Szene hinzu.</translation>
    </message>
    <message>
        <source>Opens a new scene with only this mesh.</source>
        <translation>Öffnet eine neue Szene, die nur dieses Dreiecksnetz enthält.</translation>
    </message>
    <message>
        <source>%1: %2 triangles, %3 vertices, %4.</source>
        <translation>%1: %2 Dreiecke, %3 Ecken, %4.</translation>
    </message>
</context>
<context>
    <name>underact::gui::MetadataDialog</name>
    <message>
        <source>Error message</source>
        <translation>Fehlermeldung</translation>
    </message>
    <message>
        <source>Metadata of %1</source>
        <translation>Angaben zu %1</translation>
    </message>
    <message>
        <source>Save the metadata</source>
        <translation>Angaben speichern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>underact::gui::MetadataForm</name>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Name of the session in the list.</source>
        <translation>Name der Sitzung in der Liste.</translation>
    </message>
    <message>
        <source>No&amp;tes</source>
        <translation>No&amp;tizen</translation>
    </message>
    <message>
        <source>Notes for whoever opens the session later.</source>
        <translation>Hinweise für alle, die die Sitzung später öffnen.</translation>
    </message>
    <message>
        <source>Ta&amp;gs</source>
        <translation>Ta&amp;gs</translation>
    </message>
    <message>
        <source>Keywords for the search, separated by commas.</source>
        <translation>Stichwörter für die Suche, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>Su&amp;bject</source>
        <translation>&amp;Person</translation>
    </message>
    <message>
        <source>The person whose hand it is, as a code. Keep the list of codes and names somewhere else.</source>
        <translation>Die Person, deren Hand es ist, als Code. Bewahren Sie die Liste der Codes und Namen woanders auf.</translation>
    </message>
    <message>
        <source>A code, not a name: whoever reads the file can see it.</source>
        <translation>Ein Code, kein Name: Wer die Datei liest, kann ihn sehen.</translation>
    </message>
    <message>
        <source>&amp;Consent</source>
        <translation>&amp;Einwilligung</translation>
    </message>
    <message>
        <source>What the subject agreed to, and how: version and date of the consent form. Empty: not recorded.</source>
        <translation>Worin die Person eingewilligt hat und wie: Fassung und Datum der Einwilligungserklärung. Leer: nicht festgehalten.</translation>
    </message>
    <message>
        <source>pilot, left hand</source>
        <translation>Vorversuch, linke Hand</translation>
    </message>
    <message>
        <source>form 2.1, in writing, 2026-11-20</source>
        <translation>Formular 2.1, schriftlich, 2026-11-20</translation>
    </message>
</context>
<context>
    <name>underact::gui::Notice</name>
    <message>
        <source>What was done</source>
        <translation>Was getan wurde</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Shows it: a session in its list, another file in its folder.</source>
        <translation>Zeigt es: eine Sitzung in ihrer Liste, eine andere Datei in ihrem Ordner.</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the notice.</source>
        <translation>Schließt den Hinweis.</translation>
    </message>
</context>
<context>
    <name>underact::gui::PageView</name>
    <message>
        <source>Web page</source>
        <translation>Webseite</translation>
    </message>
    <message>
        <source>This link opens a web page outside the program:</source>
        <translation>Dieser Link öffnet eine Webseite außerhalb des Programms:</translation>
    </message>
    <message>
        <source>Open in browser</source>
        <translation>Im Browser öffnen</translation>
    </message>
</context>
<context>
    <name>underact::gui::Palette</name>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>What to find</source>
        <translation>Was gesucht wird</translation>
    </message>
    <message>
        <source>Command, scene, lesson, page or setting</source>
        <translation>Befehl, Szene, Lektion, Seite oder Einstellung</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation>%1  (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nothing found. Try another word, or fewer letters.</source>
        <translation>Nichts gefunden. Versuchen Sie ein anderes Wort oder weniger Buchstaben.</translation>
    </message>
    <message>
        <source>Type more letters to narrow the list.</source>
        <translation>Tippen Sie weiter, um die Liste zu verkürzen.</translation>
    </message>
    <message>
        <source>Press Enter to choose.</source>
        <translation>Die Eingabetaste wählt aus.</translation>
    </message>
    <message>
        <source>“%1” is not possible now.</source>
        <translation>„%1“ ist jetzt nicht möglich.</translation>
    </message>
</context>
<context>
    <name>underact::gui::Player</name>
    <message>
        <source>what if</source>
        <translation>was wäre, wenn</translation>
    </message>
</context>
<context>
    <name>underact::gui::PlotsPanel</name>
    <message>
        <source>Ener&amp;gy</source>
        <translation>Ener&amp;gie</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Freeze the plots</source>
        <translation>Diagramme einfrieren</translation>
    </message>
    <message>
        <source>Freezes the plots so that you can read and enlarge them. The servo keeps running.</source>
        <translation>Friert die Diagramme ein, damit Sie sie lesen und vergrößern können. Der Servo läuft weiter.</translation>
    </message>
    <message>
        <source>Error and force over the last 10 s, and force against displacement</source>
        <translation>Fehler und Kraft der letzten 10 s, und Kraft gegen Auslenkung</translation>
    </message>
    <message>
        <source>Axis of force against displacement</source>
        <translation>Achse der Kraft gegen Auslenkung</translation>
    </message>
    <message>
        <source>Axis of the workspace frame W along which force is plotted against displacement (thesis figure 4.3).</source>
        <translation>Achse des Koordinatensystems W des Arbeitsraums, entlang der Kraft gegen Auslenkung aufgetragen wird (Thesis, Abbildung 4.3).</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Energy plot</source>
        <translation>Energiediagramm</translation>
    </message>
    <message>
        <source>The energy that the stylus has put into the constraints and not received back, E = Σ −f·Δp. Below zero they have given out more than they received: they are active.</source>
        <translation>Die Energie, die der Stift in die Bindungen gesteckt und nicht zurückbekommen hat, E = Σ −f·Δp. Unter null haben sie mehr abgegeben, als sie bekamen: Sie sind aktiv.</translation>
    </message>
    <message>
        <source>Force against &amp;displacement, axis</source>
        <translation>Kraft gegen &amp;Auslenkung, Achse</translation>
    </message>
    <message>
        <source>There is not enough room for this plot: switch Energy off, or make the window wider.</source>
        <translation>Für dieses Diagramm ist zu wenig Platz: Schalten Sie Energie aus, oder machen Sie das Fenster breiter.</translation>
    </message>
</context>
<context>
    <name>underact::gui::PlotsRun</name>
    <message>
        <source>Cancelled: not all plots were drawn.</source>
        <translation>Abgebrochen: Nicht alle Diagramme wurden gezeichnet.</translation>
    </message>
    <message>
        <source>%1 plots saved: %2</source>
        <translation>%1 Diagramme gespeichert: %2</translation>
    </message>
    <message>
        <source>The plots were not drawn; underact-cli gave no reason.</source>
        <translation>Die Diagramme wurden nicht gezeichnet; underact-cli nannte keinen Grund.</translation>
    </message>
    <message>
        <source>The plots were not drawn. %1</source>
        <translation>Die Diagramme wurden nicht gezeichnet. %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::PressRows</name>
    <message>
        <source>Buttons</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>The button of the device with this function.</source>
        <translation>Die Taste des Geräts mit dieser Funktion.</translation>
    </message>
    <message>
        <source>Learn…</source>
        <translation>Lernen …</translation>
    </message>
    <message>
        <source>Assigns the button that you press next.</source>
        <translation>Übernimmt die Taste, die Sie als Nächstes drücken.</translation>
    </message>
    <message>
        <source>Learn %1</source>
        <translation>%1 lernen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>underact::gui::ProblemsDialog</name>
    <message>
        <source>Scene not opened</source>
        <translation>Szene nicht geöffnet</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>Problems in the file</source>
        <translation>Probleme in der Datei</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the problems</source>
        <translation>Die Probleme kopieren</translation>
    </message>
    <message>
        <source>&amp;Open another…</source>
        <translation>&amp;Andere öffnen …</translation>
    </message>
    <message>
        <source>Open another scene file</source>
        <translation>Eine andere Szenendatei öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>One problem</source>
        <translation>Ein Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>%1 was not opened; your previous scene stays open. %2 to fix:</source>
        <translation>%1 wurde nicht geöffnet; Ihre bisherige Szene bleibt offen. %2:</translation>
    </message>
</context>
<context>
    <name>underact::gui::Projector</name>
    <message>
        <source>&amp;Projector layout</source>
        <translation>&amp;Projektor-Layout</translation>
    </message>
    <message>
        <source>For teaching: hides the panels and shows the view in high contrast with a large force gauge and large text.</source>
        <translation>Für den Unterricht: blendet die Bereiche aus und zeigt die Ansicht in hohem Kontrast, mit großer Kraftanzeige und großer Schrift.</translation>
    </message>
</context>
<context>
    <name>underact::gui::RateChooser</name>
    <message>
        <source>Servo rate</source>
        <translation>Servo-Taktrate</translation>
    </message>
    <message>
        <source>Ticks per second. Changing the rate releases the force for a moment; a running servo restarts with its soft start.</source>
        <translation>Takte je Sekunde. Eine Änderung der Taktrate schaltet die Kraft kurz ab; ein laufender Servo startet danach sanft wieder.</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Taktrate</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
</context>
<context>
    <name>underact::gui::RecordSection</name>
    <message>
        <source>&amp;Mark</source>
        <translation>&amp;Marke</translation>
    </message>
    <message>
        <source>Recording status</source>
        <translation>Status der Aufzeichnung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>From the first tick of the recording to the last.</source>
        <translation>Vom ersten Takt der Aufzeichnung bis zum letzten.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of the file.</source>
        <translation>Größe der Datei.</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Takte</translation>
    </message>
    <message>
        <source>Ticks in the file, and ticks that could not be written, if any.</source>
        <translation>Takte in der Datei und, falls vorhanden, Takte, die nicht geschrieben werden konnten.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Markers set with the M key, the button or the stylus.</source>
        <translation>Marken, gesetzt mit der Taste M, der Schaltfläche oder dem Stift.</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Freier Platz</translation>
    </message>
    <message>
        <source>Free space on the disk. The recording stops and is saved before the disk is full.</source>
        <translation>Freier Platz auf dem Datenträger. Bevor er voll ist, wird die Aufzeichnung gestoppt und gespeichert.</translation>
    </message>
    <message>
        <source>Enough for</source>
        <translation>Reicht für</translation>
    </message>
    <message>
        <source>How long the free space lasts for this recording.</source>
        <translation>Wie lange der freie Platz für diese Aufzeichnung reicht.</translation>
    </message>
    <message>
        <source>%1, %2 missing</source>
        <translation>%1, %2 fehlen</translation>
    </message>
    <message>
        <source>Metadata</source>
        <translation>Angaben</translation>
    </message>
    <message>
        <source>Information about the session, saved in its file. You can edit it later.</source>
        <translation>Informationen zur Sitzung, in ihrer Datei gespeichert. Sie lassen sich später ändern.</translation>
    </message>
    <message>
        <source>Set a marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Label of the next marker</source>
        <translation>Text der nächsten Marke</translation>
    </message>
    <message>
        <source>Label of the next marker. Press Enter to set it.</source>
        <translation>Text der nächsten Marke. Die Eingabetaste setzt sie.</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>&amp;Aufzeichnung stoppen</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufzeichnen</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung stoppen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Recording to %1</source>
        <translation>Wird aufgezeichnet in %1</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>Gespeichert als %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::Recording</name>
    <message>
        <source>%1 Choose another folder for the recordings.</source>
        <translation>%1 Wählen Sie einen anderen Ordner für die Aufzeichnungen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ReferencePointsPicture</name>
    <message>
        <source>The reference points on the desk, from above</source>
        <translation>Die Messpunkte auf dem Tisch, von oben</translation>
    </message>
    <message>
        <source>Next: reference point %1 of %2.</source>
        <translation>Als Nächstes: Messpunkt %1 von %2.</translation>
    </message>
    <message>
        <source>%1 reference points.</source>
        <translation>%1 Messpunkte.</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>von Ihnen weg</translation>
    </message>
</context>
<context>
    <name>underact::gui::RegistrationRun</name>
    <message>
        <source>Hold the tip still.</source>
        <translation>Halten Sie die Spitze still.</translation>
    </message>
    <message>
        <source>The tip moved by more than 1 mm while you held it. Rest it on reference point %1 and press again.</source>
        <translation>Die Spitze hat sich um mehr als 1 mm bewegt, während Sie sie hielten. Setzen Sie sie auf Messpunkt %1 und drücken Sie erneut.</translation>
    </message>
    <message>
        <source>Reference point %1 has been touched; the spread of the tip was %2 mm.</source>
        <translation>Messpunkt %1 ist berührt; die Streuung der Spitze war %2 mm.</translation>
    </message>
</context>
<context>
    <name>underact::gui::RegistrationTool</name>
    <message>
        <source>Re&amp;gister the arm…</source>
        <translation>Arm re&amp;gistrieren …</translation>
    </message>
    <message>
        <source>Finds the pose of the arm on the desk from reference points that its tip touches, step by step.</source>
        <translation>Ermittelt Schritt für Schritt die Lage des Arms auf dem Tisch, anhand von Messpunkten, die seine Spitze berührt.</translation>
    </message>
    <message>
        <source>Second arm: %1</source>
        <translation>Zweiter Arm: %1</translation>
    </message>
    <message>
        <source>A recording is being replayed. Close it, then register the arm.</source>
        <translation>Eine Aufzeichnung wird wiedergegeben. Schließen Sie sie und registrieren Sie dann den Arm.</translation>
    </message>
    <message>
        <source>A measurement is running on this arm. End it, then register the arm.</source>
        <translation>An diesem Arm läuft eine Messung. Beenden Sie sie und registrieren Sie dann den Arm.</translation>
    </message>
    <message>
        <source>No scene is open. Open one, so that the position of the tip is known.</source>
        <translation>Es ist keine Szene geöffnet. Öffnen Sie eine, damit die Position der Spitze bekannt ist.</translation>
    </message>
    <message>
        <source>Not registered: %1</source>
        <translation>Nicht registriert: %1</translation>
    </message>
    <message>
        <source>Not registered: the view shows the arm as if it stood straight.</source>
        <translation>Nicht registriert: Die Ansicht zeigt den Arm, als stünde er gerade.</translation>
    </message>
    <message>
        <source>Registered on %1 with %2 reference points, residual %3 mm. Expected error at the centre of the workspace: %4 mm.</source>
        <translation>Registriert am %1 mit %2 Messpunkten, Residuum %3 mm. Erwarteter Fehler in der Mitte des Arbeitsraums: %4 mm.</translation>
    </message>
</context>
<context>
    <name>underact::gui::RegistrationWizard</name>
    <message>
        <source>Check the result</source>
        <translation>Ergebnis prüfen</translation>
    </message>
    <message>
        <source>How well the points fit</source>
        <translation>Wie gut die Punkte passen</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>Erwarteter Fehler</translation>
    </message>
    <message>
        <source>e&lt;sup&gt;2&lt;/sup&gt;/N · (1 + (d₁²/f₁² + d₂²/f₂² + d₃²/f₃²)/3): Fitzpatrick, West and Maurer, 1998.</source>
        <translation>e&lt;sup&gt;2&lt;/sup&gt;/N · (1 + (d₁²/f₁² + d₂²/f₂² + d₃²/f₃²)/3): Fitzpatrick, West und Maurer, 1998.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Residual of each reference point</source>
        <translation>Residuum jedes Messpunkts</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>residual, mm</source>
        <translation>Residuum, mm</translation>
    </message>
    <message>
        <source>spread, mm</source>
        <translation>Streuung, mm</translation>
    </message>
    <message>
        <source>Whether the registration was saved</source>
        <translation>Ob die Registrierung gespeichert wurde</translation>
    </message>
    <message>
        <source>The touched points lie %1 mm from their reference points (root mean square).</source>
        <translation>Die berührten Punkte liegen %1 mm neben ihren Messpunkten (quadratisches Mittel).</translation>
    </message>
    <message>
        <source>Expected error at the centre of the workspace: %1 mm; at most %2 mm in 19 of 20 registrations like this one. More reference points, and points farther apart, make it smaller.</source>
        <translation>Erwarteter Fehler in der Mitte des Arbeitsraums: %1 mm; in 19 von 20 Registrierungen wie dieser höchstens %2 mm. Mehr Messpunkte, die weiter auseinanderliegen, machen ihn kleiner.</translation>
    </message>
    <message>
        <source>The registration is in use, but only until the window closes. %1 Press Accept again to close the wizard.</source>
        <translation>Die Registrierung gilt jetzt, aber nur, bis das Fenster geschlossen wird. %1 Drücken Sie noch einmal „Annehmen“, um den Assistenten zu schließen.</translation>
    </message>
    <message>
        <source>Where does the arm stand?</source>
        <translation>Wo steht der Arm?</translation>
    </message>
    <message>
        <source>What this is for</source>
        <translation>Wozu das dient</translation>
    </message>
    <message>
        <source>You touch reference points on the desk, whose positions are known, with the tip of the stylus. From these the program finds the pose of the arm: the view is turned so that left on the desk is left in the picture, and two arms are drawn where they stand. Tape the sheet to the desk, and then move neither the sheet nor the arm. The scene and its forces stay where they are in the arm's own frame.</source>
        <translation>Sie berühren mit der Spitze des Stifts Messpunkte auf dem Tisch, deren Positionen bekannt sind. Daraus ermittelt das Programm die Lage des Arms: Die Ansicht wird so gedreht, dass links auf dem Tisch auch im Bild links ist, und zwei Arme werden dort gezeichnet, wo sie stehen. Kleben Sie das Blatt auf den Tisch, und bewegen Sie danach weder Blatt noch Arm. Die Szene und ihre Kräfte bleiben, wo sie im eigenen Koordinatensystem des Arms sind.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Which arm to register.</source>
        <translation>Welcher Arm registriert werden soll.</translation>
    </message>
    <message>
        <source>Whether the arm is registered</source>
        <translation>Ob der Arm registriert ist</translation>
    </message>
    <message>
        <source>Whether the arm is calibrated</source>
        <translation>Ob der Arm kalibriert ist</translation>
    </message>
    <message>
        <source>&amp;Forget this registration</source>
        <translation>Diese Registrierung &amp;löschen</translation>
    </message>
    <message>
        <source>Deletes the registration of this arm. The view then shows the arm as if it stood straight.</source>
        <translation>Löscht die Registrierung dieses Arms. Die Ansicht zeigt den Arm dann, als stünde er gerade.</translation>
    </message>
    <message>
        <source>Number of reference points</source>
        <translation>Anzahl der Messpunkte</translation>
    </message>
    <message>
        <source>More reference points make the error smaller, and better known. Restores the positions of the printed sheet.</source>
        <translation>Mehr Messpunkte machen den Fehler kleiner und besser bekannt. Setzt die Positionen des gedruckten Blatts wieder ein.</translation>
    </message>
    <message>
        <source> points</source>
        <translation> Messpunkte</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>The paper to print the sheet on.</source>
        <translation>Das Papier, auf das das Blatt gedruckt wird.</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>Save the &amp;sheet as PDF…</source>
        <translation>&amp;Blatt als PDF speichern …</translation>
    </message>
    <message>
        <source>Saves the sheet of reference points. Print it at 100 %, and check its ruler.</source>
        <translation>Speichert das Blatt mit den Messpunkten. Drucken Sie es mit 100 %, und prüfen Sie sein Lineal.</translation>
    </message>
    <message>
        <source>Positions of the reference points, mm from point 1</source>
        <translation>Positionen der Messpunkte, mm ab Messpunkt 1</translation>
    </message>
    <message>
        <source>right, mm</source>
        <translation>rechts, mm</translation>
    </message>
    <message>
        <source>away, mm</source>
        <translation>weg, mm</translation>
    </message>
    <message>
        <source>up, mm</source>
        <translation>oben, mm</translation>
    </message>
    <message>
        <source>Positions of the reference points, from point 1: to the right, away from you, up. You can type in points of your own.</source>
        <translation>Positionen der Messpunkte, von Messpunkt 1 aus: nach rechts, von Ihnen weg, nach oben. Sie können eigene Messpunkte eintippen.</translation>
    </message>
    <message>
        <source>Layout of the reference points</source>
        <translation>Anordnung der Messpunkte</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>Blatt speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Each coordinate must be a number from -1000 to 1000 mm.</source>
        <translation>Jede Koordinate muss eine Zahl von -1000 bis 1000 mm sein.</translation>
    </message>
    <message>
        <source>The arm reports: %1</source>
        <translation>Der Arm meldet: %1</translation>
    </message>
    <message>
        <source>A simulated arm needs no calibration. Move its hand in the view.</source>
        <translation>Ein simulierter Arm braucht keine Kalibrierung. Bewegen Sie seine Hand in der Ansicht.</translation>
    </message>
    <message>
        <source>The arm reports that it is calibrated and that nothing is missing.</source>
        <translation>Der Arm meldet, dass er kalibriert ist und nichts fehlt.</translation>
    </message>
    <message>
        <source>The sheet was saved as %1. Print it at 100 %, and check its ruler.</source>
        <translation>Das Blatt wurde als %1 gespeichert. Drucken Sie es mit 100 %, und prüfen Sie sein Lineal.</translation>
    </message>
    <message>
        <source>Register the arm</source>
        <translation>Arm registrieren</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>&amp;Annehmen</translation>
    </message>
    <message>
        <source>Touch the reference points</source>
        <translation>Messpunkte berühren</translation>
    </message>
    <message>
        <source>What to do now</source>
        <translation>Was jetzt zu tun ist</translation>
    </message>
    <message>
        <source>Result of the last press</source>
        <translation>Ergebnis des letzten Tastendrucks</translation>
    </message>
    <message>
        <source>Position of the tip</source>
        <translation>Position der Spitze</translation>
    </message>
    <message>
        <source>Progress of the hold</source>
        <translation>Fortschritt des Haltens</translation>
    </message>
    <message>
        <source>&amp;Hold (Space)</source>
        <translation>&amp;Halten (Leertaste)</translation>
    </message>
    <message>
        <source>Records the position of the tip for half a second.</source>
        <translation>Erfasst eine halbe Sekunde lang die Position der Spitze.</translation>
    </message>
    <message>
        <source>&amp;Touch this point again</source>
        <translation>Messpunkt erneut &amp;berühren</translation>
    </message>
    <message>
        <source>The reference point selected in the table is touched next.</source>
        <translation>Der in der Tabelle gewählte Messpunkt ist als Nächstes an der Reihe.</translation>
    </message>
    <message>
        <source>Reference points and positions of the tip</source>
        <translation>Messpunkte und Positionen der Spitze</translation>
    </message>
    <message>
        <source>x, y, z in W, mm</source>
        <translation>x, y, z in W, mm</translation>
    </message>
    <message>
        <source>Tip: %1</source>
        <translation>Spitze: %1</translation>
    </message>
    <message>
        <source>The arm has not sent a sample yet.</source>
        <translation>Vom Arm kam noch kein Messwert.</translation>
    </message>
    <message>
        <source>All reference points have been touched.</source>
        <translation>Alle Messpunkte sind berührt.</translation>
    </message>
    <message>
        <source>Rest the tip on reference point %1 and press the stylus button, or Space. The force is off.</source>
        <translation>Setzen Sie die Spitze auf Messpunkt %1 und drücken Sie die Stifttaste oder die Leertaste. Die Kraft ist aus.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ReplayBar</name>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Reading the session</source>
        <translation>Die Sitzung wird gelesen</translation>
    </message>
    <message>
        <source>Reading progress</source>
        <translation>Lesefortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel opening the session</source>
        <translation>Öffnen der Sitzung abbrechen</translation>
    </message>
    <message>
        <source>One tick back</source>
        <translation>Einen Takt zurück</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>One tick forward</source>
        <translation>Einen Takt weiter</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Stelle in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Click or drag to jump. Strokes above the line are markers, crosses are faults.</source>
        <translation>Klicken oder ziehen Sie, um zu springen. Striche über der Linie sind Marken, Kreuze sind Störungen.</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>Zeit in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed of the hand relative to the recording. At 1 × the samples are exactly the recorded ones.</source>
        <translation>Tempo der Hand im Verhältnis zur Aufzeichnung. Bei 1 × sind die Abtastwerte genau die aufgezeichneten.</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre, wenn</translation>
    </message>
    <message>
        <source>Recorded force and error</source>
        <translation>Aufgezeichnete Kraft und aufgezeichneter Fehler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close session</source>
        <translation>Sitzung schließen</translation>
    </message>
    <message>
        <source>%1: recorded force %2 N, error %3 mm</source>
        <translation>%1: aufgezeichnete Kraft %2 N, Fehler %3 mm</translation>
    </message>
    <message>
        <source>A session is being replayed. Close the replay first.</source>
        <translation>Eine Sitzung wird wiedergegeben. Schließen Sie zuerst die Wiedergabe.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>underact::gui::RobotEdits</name>
    <message>
        <source>joint %1, %2</source>
        <translation>Gelenk %1, %2</translation>
    </message>
    <message>
        <source>This robot follows the angle about its one joint. At “Follows”, choose “%1” first; then add the joint.</source>
        <translation>Dieser Roboter folgt dem Winkel um sein einziges Gelenk. Wählen Sie bei „Folgt“ zuerst „%1“ und fügen Sie dann das Gelenk hinzu.</translation>
    </message>
    <message>
        <source>add a joint</source>
        <translation>Gelenk hinzufügen</translation>
    </message>
    <message>
        <source>remove a joint</source>
        <translation>Gelenk entfernen</translation>
    </message>
    <message>
        <source>move a joint</source>
        <translation>Gelenk verschieben</translation>
    </message>
    <message>
        <source>home position</source>
        <translation>Position in Grundstellung</translation>
    </message>
    <message>
        <source>home orientation</source>
        <translation>Orientierung in Grundstellung</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>new robot</source>
        <translation>neuer Roboter</translation>
    </message>
    <message>
        <source>remove the robot</source>
        <translation>Roboter entfernen</translation>
    </message>
</context>
<context>
    <name>underact::gui::RobotNowSection</name>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>What the solver found in the tick shown.</source>
        <translation>Was der Löser im gezeigten Takt gefunden hat.</translation>
    </message>
    <message>
        <source>Solved by</source>
        <translation>Gelöst durch</translation>
    </message>
    <message>
        <source>A closed form, or the iteration with its number of steps in this tick.</source>
        <translation>Eine geschlossene Form oder die Iteration mit der Zahl ihrer Schritte in diesem Takt.</translation>
    </message>
    <message>
        <source>Remaining step</source>
        <translation>Restschritt</translation>
    </message>
    <message>
        <source>The largest step that any joint would still take by itself, in rad or fractions of the reach.</source>
        <translation>Der größte Schritt, den ein Gelenk von sich aus noch machen würde, in rad oder Anteilen der Reichweite.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>V = e·K e / 2 plus the energy of the joint springs, in this tick.</source>
        <translation>V = e·K e / 2 und die Energie der Gelenkfedern, in diesem Takt.</translation>
    </message>
    <message>
        <source>Moment, sent</source>
        <translation>Moment, gesendet</translation>
    </message>
    <message>
        <source>m = Kθ e_o about the tip of the stylus. All joints of this arm are driven, so that it is rendered beside the force.</source>
        <translation>m = Kθ e_o um die Spitze des Stifts. Alle Gelenke dieses Arms sind angetrieben, daher wird es neben der Kraft ausgeübt.</translation>
    </message>
    <message>
        <source>Moment, not sent</source>
        <translation>Moment, nicht gesendet</translation>
    </message>
    <message>
        <source>m = Kθ e_o about the tip of the stylus. The arm has no motors for it: it is shown, but never sent.</source>
        <translation>m = Kθ e_o um die Spitze des Stifts. Der Arm hat dafür keine Motoren: Es wird gezeigt, aber nie gesendet.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>At the end effector, or moving there at no more than 2 m/s after a minimum has vanished or a better one was adopted. Not unique: every position is equally good.</source>
        <translation>Am Endeffektor oder auf dem Weg dorthin, mit höchstens 2 m/s, nachdem ein Minimum verschwunden ist oder ein besseres übernommen wurde. Nicht eindeutig: Jede Position ist gleich gut.</translation>
    </message>
    <message>
        <source>Better pose</source>
        <translation>Bessere Lage</translation>
    </message>
    <message>
        <source>A lower minimum found by a second search; it is adopted once it has saved a tenth of the energy for 50 ms.</source>
        <translation>Ein tieferes Minimum, das eine zweite Suche gefunden hat; es wird übernommen, sobald es 50 ms lang ein Zehntel der Energie gespart hat.</translation>
    </message>
    <message>
        <source>Joint q%1</source>
        <translation>Gelenk q%1</translation>
    </message>
    <message>
        <source>The value of the joint; 0 is the home pose.</source>
        <translation>Der Wert des Gelenks; 0 ist die Grundstellung.</translation>
    </message>
    <message>
        <source>nearest point, thesis 5.2</source>
        <translation>nächster Punkt, Thesis 5.2</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>geschlossene Form</translation>
    </message>
    <message>
        <source>iteration, %1 of %2 steps</source>
        <translation>Iteration, %1 von %2 Schritten</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>%1 N mm</source>
        <translation>%1 N mm</translation>
    </message>
    <message>
        <source>not unique</source>
        <translation>nicht eindeutig</translation>
    </message>
    <message>
        <source>moving to the end effector</source>
        <translation>auf dem Weg zum Endeffektor</translation>
    </message>
    <message>
        <source>at the end effector</source>
        <translation>am Endeffektor</translation>
    </message>
    <message>
        <source>known: saves %1 mJ</source>
        <translation>bekannt: spart %1 mJ</translation>
    </message>
    <message>
        <source>none known</source>
        <translation>keine bekannt</translation>
    </message>
</context>
<context>
    <name>underact::gui::RobotPanel</name>
    <message>
        <source>This scene has no virtual robot. “New robot” adds one with a single joint; the stylus is pulled towards its end effector.</source>
        <translation>Diese Szene hat keinen virtuellen Roboter. „Neuer Roboter“ fügt einen mit einem einzigen Gelenk hinzu; der Stift wird zu seinem Endeffektor gezogen.</translation>
    </message>
    <message>
        <source>Moment, not sent</source>
        <translation>Moment, nicht gesendet</translation>
    </message>
    <message>
        <source>iteration, 100 of 100 steps</source>
        <translation>Iteration, 100 von 100 Schritten</translation>
    </message>
    <message>
        <source>Why the change was refused</source>
        <translation>Warum die Änderung abgelehnt wurde</translation>
    </message>
    <message>
        <source>New robot</source>
        <translation>Neuer Roboter</translation>
    </message>
    <message>
        <source>Adds a robot with one joint to the scene.</source>
        <translation>Fügt der Szene einen Roboter mit einem Gelenk hinzu.</translation>
    </message>
    <message>
        <source>Add a robot to the scene</source>
        <translation>Der Szene einen Roboter hinzufügen</translation>
    </message>
    <message>
        <source>Remove robot</source>
        <translation>Roboter entfernen</translation>
    </message>
    <message>
        <source>Removes the robot shown from the scene; a scene needs at least one constraint.</source>
        <translation>Entfernt den gezeigten Roboter aus der Szene; eine Szene braucht mindestens eine Bindung.</translation>
    </message>
    <message>
        <source>Remove the robot shown from the scene</source>
        <translation>Den gezeigten Roboter aus der Szene entfernen</translation>
    </message>
    <message>
        <source>Robot shown</source>
        <translation>Gezeigter Roboter</translation>
    </message>
    <message>
        <source>The robot of the scene that this panel shows.</source>
        <translation>Der Roboter der Szene, den dieser Bereich zeigt.</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>The joints move to the minimum of the energy V = e·K e / 2, and the stylus is pulled towards the end effector: F = K e.</source>
        <translation>Die Gelenke gehen in das Minimum der Energie V = e·K e / 2, und der Stift wird zum Endeffektor gezogen: F = K e.</translation>
    </message>
    <message>
        <source>Kθ</source>
        <translation>Kθ</translation>
    </message>
    <message>
        <source>Rotational stiffness</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Folgt</translation>
    </message>
    <message>
        <source>The part of the stylus's orientation that the end effector follows</source>
        <translation>Der Teil der Orientierung des Stifts, dem der Endeffektor folgt</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>How the joint angles of minimum energy are found in every tick. The method does not change what you feel.</source>
        <translation>Wie in jedem Takt die Gelenkwinkel kleinster Energie gefunden werden. Die Methode ändert nicht, was Sie fühlen.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Method of the solver</source>
        <translation>Methode des Lösers</translation>
    </message>
    <message>
        <source>Max. steps</source>
        <translation>Max. Schritte</translation>
    </message>
    <message>
        <source>Maximum number of steps per tick</source>
        <translation>Größte Zahl der Schritte je Takt</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tolerance, rad and fractions of the reach</source>
        <translation>Toleranz, rad und Anteile der Reichweite</translation>
    </message>
</context>
<context>
    <name>underact::gui::SceneArmBox</name>
    <message>
        <source>Scene &amp;for</source>
        <translation>Szene &amp;für</translation>
    </message>
    <message>
        <source>&amp;File…</source>
        <translation>&amp;Datei…</translation>
    </message>
    <message>
        <source>The arm that the scene is for</source>
        <translation>Der Arm, für den die Szene ist</translation>
    </message>
    <message>
        <source>Haptic arms, and arms that are only simulated. The scene keeps the choice when it is saved.</source>
        <translation>Haptische Arme, und Arme, die nur simuliert werden. Die Szene behält die Wahl, wenn sie gespeichert wird.</translation>
    </message>
    <message>
        <source>An arm from a file</source>
        <translation>Ein Arm aus einer Datei</translation>
    </message>
    <message>
        <source>An arm file of your own: a DH table, axes (both JSON) or URDF.</source>
        <translation>Eine eigene Armdatei: DH-Tabelle, Achsen (beide JSON) oder URDF.</translation>
    </message>
    <message>
        <source>File %1</source>
        <translation>Datei %1</translation>
    </message>
    <message>
        <source>Arm not taken</source>
        <translation>Arm nicht übernommen</translation>
    </message>
    <message>
        <source>The scene keeps its arm. %1:</source>
        <translation>Die Szene behält ihren Arm. %1:</translation>
    </message>
    <message>
        <source>arm %1</source>
        <translation>Arm %1</translation>
    </message>
    <message>
        <source>Choose an arm file</source>
        <translation>Eine Armdatei wählen</translation>
    </message>
    <message>
        <source>Arm files (*.json *.urdf *.xml);;All files (*)</source>
        <translation>Armdateien (*.json *.urdf *.xml);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>underact::gui::SceneFiles</name>
    <message>
        <source>Loading the files of %1</source>
        <translation>Dateien von %1 werden geladen</translation>
    </message>
    <message>
        <source>Open a file</source>
        <translation>Eine Datei öffnen</translation>
    </message>
    <message>
        <source>Scene not saved</source>
        <translation>Szene nicht gespeichert</translation>
    </message>
    <message>
        <source>Save the tuned scene</source>
        <translation>Abgestimmte Szene speichern</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Neue Szene</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The scene “%1” has not been saved.</source>
        <translation>Die Szene „%1“ ist noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>The scene “%1” has unsaved changes.</source>
        <translation>Die Szene „%1“ hat nicht gespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save it as a scene file, or discard it?</source>
        <translation>Als Szenendatei speichern oder verwerfen?</translation>
    </message>
    <message>
        <source>Save them as a scene file, or discard them?</source>
        <translation>Als Szenendatei speichern oder verwerfen?</translation>
    </message>
</context>
<context>
    <name>underact::gui::SceneView</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>The constraint, the stylus and the force on it. The arrow keys move the hand.</source>
        <translation>Die Bindung, der Stift und die Kraft auf ihn. Die Pfeiltasten bewegen die Hand.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ScenesPanel</name>
    <message>
        <source>Feel:</source>
        <translation>Fühlen:</translation>
    </message>
    <message>
        <source>Try:</source>
        <translation>Probieren:</translation>
    </message>
    <message>
        <source>Equation:</source>
        <translation>Gleichung:</translation>
    </message>
    <message>
        <source>Filter the scenes</source>
        <translation>Szenen filtern</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>About the selected scene</source>
        <translation>Über die gewählte Szene</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Szenendatei öffnen</translation>
    </message>
    <message>
        <source>Why there are no scenes</source>
        <translation>Warum es keine Szenen gibt</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Recent file</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Find a scene</source>
        <translation>Szene s&amp;uchen</translation>
    </message>
    <message>
        <source>Moves the cursor to the filter.</source>
        <translation>Setzt den Cursor in den Filter.</translation>
    </message>
    <message>
        <source>Recently opened</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
</context>
<context>
    <name>underact::gui::SchedulingSection</name>
    <message>
        <source>Scheduling</source>
        <translation>Zeitplanung</translation>
    </message>
    <message>
        <source>The scheduling that the system granted to the servo thread.</source>
        <translation>Die Zeitplanung, die das System dem Servo-Thread gewährt hat.</translation>
    </message>
    <message>
        <source>Scheduling in effect</source>
        <translation>Geltende Zeitplanung</translation>
    </message>
    <message>
        <source>Also granted</source>
        <translation>Außerdem gewährt</translation>
    </message>
    <message>
        <source>How to improve it</source>
        <translation>Wie sie besser wird</translation>
    </message>
    <message>
        <source>There is nothing to improve.</source>
        <translation>Es gibt nichts zu verbessern.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SecondArm</name>
    <message>
        <source>“%1” was not opened. %2</source>
        <translation>„%1“ wurde nicht geöffnet. %2</translation>
    </message>
    <message>
        <source>The scene is unchanged. %1</source>
        <translation>Die Szene bleibt unverändert. %1</translation>
    </message>
    <message>
        <source>The rate of the second arm is unchanged. %1</source>
        <translation>Die Taktrate des zweiten Arms bleibt unverändert. %1</translation>
    </message>
    <message>
        <source>The second arm: %1 %2</source>
        <translation>Der zweite Arm: %1 %2</translation>
    </message>
    <message>
        <source> The report is in %1.</source>
        <translation> Der Bericht liegt in %1.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SecondArmPanel</name>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>stoppt</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>A second arm</source>
        <translation>Ein zweiter Arm</translation>
    </message>
    <message>
        <source>Message from the second arm</source>
        <translation>Meldung des zweiten Arms</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>The arm in use.</source>
        <translation>Der verwendete Arm.</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>State of its servo. Start and Stop apply to both arms.</source>
        <translation>Zustand seines Servos. Start und Stopp gelten für beide Arme.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>The force sent to the second arm.</source>
        <translation>Die an den zweiten Arm gesendete Kraft.</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Position of its tip in its own frame W.</source>
        <translation>Position seiner Spitze in seinem eigenen Koordinatensystem W.</translation>
    </message>
    <message>
        <source>A s&amp;econd arm</source>
        <translation>Ein &amp;zweiter Arm</translation>
    </message>
    <message>
        <source>Adds an arm beside the first, with its own servo and scene. Start and Stop apply to both arms.</source>
        <translation>Fügt neben dem ersten einen Arm mit eigenem Servo und eigener Szene hinzu. Start und Stopp gelten für beide Arme.</translation>
    </message>
    <message>
        <source>The second arm is unchanged. %1</source>
        <translation>Der zweite Arm bleibt unverändert. %1</translation>
    </message>
    <message>
        <source>Second arm</source>
        <translation>Zweiter Arm</translation>
    </message>
    <message>
        <source>The arm to use; the Devices panel lists more.</source>
        <translation>Der Arm, der verwendet wird; weitere stehen im Bereich Geräte.</translation>
    </message>
    <message>
        <source>Scene of the second arm</source>
        <translation>Szene des zweiten Arms</translation>
    </message>
    <message>
        <source>What the second arm is constrained to.</source>
        <translation>Woran der zweite Arm gebunden ist.</translation>
    </message>
    <message>
        <source>Side of the second arm</source>
        <translation>Seite des zweiten Arms</translation>
    </message>
    <message>
        <source>The side of the first arm on which it stands.</source>
        <translation>Die Seite des ersten Arms, auf der er steht.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Another scene file…</source>
        <translation>Andere Szenendatei …</translation>
    </message>
    <message>
        <source>Opens a scene file for the second arm.</source>
        <translation>Öffnet eine Szenendatei für den zweiten Arm.</translation>
    </message>
    <message>
        <source>Mirrors my hand</source>
        <translation>Spiegelt meine Hand</translation>
    </message>
    <message>
        <source>Moves a simulated second arm as the mirror image of the first hand.</source>
        <translation>Bewegt einen simulierten zweiten Arm als Spiegelbild der ersten Hand.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>A scene for the second arm</source>
        <translation>Szene für den zweiten Arm</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Set by the registrations of both arms.</source>
        <translation>Durch die Registrierungen beider Arme festgelegt.</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet …</translation>
    </message>
    <message>
        <source>Loading the scene…</source>
        <translation>Szene wird geladen …</translation>
    </message>
    <message>
        <source>The second arm is on. Switch it off first.</source>
        <translation>Der zweite Arm ist eingeschaltet. Schalten Sie ihn zuerst aus.</translation>
    </message>
    <message>
        <source> (untested)</source>
        <translation> (nicht erprobt)</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>underact::gui::Section</name>
    <message>
        <source>%1, show or hide</source>
        <translation>%1, ein- oder ausblenden</translation>
    </message>
</context>
<context>
    <name>underact::gui::SectionStrip</name>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Schnitt quer zu</translation>
    </message>
    <message>
        <source>Cut across x</source>
        <translation>Schnitt quer zu x</translation>
    </message>
    <message>
        <source>Cut across y</source>
        <translation>Schnitt quer zu y</translation>
    </message>
    <message>
        <source>Cut across z</source>
        <translation>Schnitt quer zu z</translation>
    </message>
    <message>
        <source>Position of the cut</source>
        <translation>Position des Schnitts</translation>
    </message>
    <message>
        <source>Position of the cut along its axis. Double-click to let it follow the stylus again.</source>
        <translation>Position des Schnitts entlang seiner Achse. Nach einem Doppelklick folgt er wieder dem Stift.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The cut follows the stylus</source>
        <translation>Der Schnitt folgt dem Stift</translation>
    </message>
    <message>
        <source>Move the cut with the ke&amp;ys</source>
        <translation>Schnitt &amp;mit Tasten verschieben</translation>
    </message>
    <message>
        <source>Moves the focus to the slider of the cut: the arrow keys then move the cut by 1 mm, Page Up and Page Down by 10 mm.</source>
        <translation>Setzt den Fokus auf den Schieberegler des Schnitts: Die Pfeiltasten verschieben den Schnitt dann um 1 mm, Bild auf und Bild ab um 10 mm.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ServoPanel</name>
    <message>
        <source>&amp;Hold to run</source>
        <translation>&amp;Nur mit Taste</translation>
    </message>
    <message>
        <source>There is force only while the stylus button is held.</source>
        <translation>Kraft gibt es nur, solange die Stifttaste gehalten wird.</translation>
    </message>
    <message>
        <source>&amp;Restart the servo</source>
        <translation>Servo neu st&amp;arten</translation>
    </message>
    <message>
        <source>Ends the servo thread, reopens the arm and starts from the beginning with the same scene.</source>
        <translation>Beendet den Servo-Thread, öffnet den Arm erneut und beginnt mit derselben Szene von vorn.</translation>
    </message>
    <message>
        <source>&amp;Check the servo…</source>
        <translation>Servo &amp;prüfen …</translation>
    </message>
    <message>
        <source>Measures the latency of the servo and compares it with the best this machine can do.</source>
        <translation>Misst die Latenz des Servos und vergleicht sie mit dem Besten, was dieser Rechner leisten kann.</translation>
    </message>
    <message>
        <source>Hold to run</source>
        <translation>Nur mit Taste</translation>
    </message>
    <message>
        <source>There is force only while the stylus button is held. On the simulated arm, that button is the Space key while the view has the focus (F2).</source>
        <translation>Kraft gibt es nur, solange die Stifttaste gehalten wird. Beim simulierten Arm ist das die Leertaste, solange die Ansicht den Fokus hat (F2).</translation>
    </message>
    <message>
        <source>Result of the restart or the rate change</source>
        <translation>Ergebnis des Neustarts oder der geänderten Taktrate</translation>
    </message>
    <message>
        <source>Restart the servo</source>
        <translation>Servo neu starten</translation>
    </message>
    <message>
        <source>Check the servo…</source>
        <translation>Servo prüfen …</translation>
    </message>
    <message>
        <source>The servo was restarted. Press Start to turn the force on.</source>
        <translation>Der Servo wurde neu gestartet. Drücken Sie Start, um die Kraft einzuschalten.</translation>
    </message>
    <message>
        <source>The arm could not be reopened. %1</source>
        <translation>Der Arm ließ sich nicht wieder öffnen. %1</translation>
    </message>
    <message>
        <source>The rate was not changed. %1</source>
        <translation>Die Taktrate wurde nicht geändert. %1</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionIndex</name>
    <message>
        <source>There is not enough free memory to read the file. Close other programs, choose another folder, then choose this one again.</source>
        <translation>Der freie Speicher reicht nicht, um die Datei zu lesen. Schließen Sie andere Programme, wählen Sie einen anderen Ordner und dann wieder diesen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionList</name>
    <message>
        <source>Search sessions</source>
        <translation>Sitzungen durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Words from the name, notes, tags, subject, consent, scene, arm, markers or date. Each word must occur.</source>
        <translation>Wörter aus Name, Notizen, Tags, Person, Einwilligung, Szene, Arm, Marken oder Datum. Jedes Wort muss vorkommen.</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Details of the selected session</source>
        <translation>Einzelheiten zur gewählten Sitzung</translation>
    </message>
    <message>
        <source>Reading the folder</source>
        <translation>Der Ordner wird gelesen</translation>
    </message>
    <message>
        <source>No sessions yet. Press Record to make one.</source>
        <translation>Noch keine Sitzungen. „Aufzeichnen“ legt eine an.</translation>
    </message>
    <message>
        <source>%1 of %2 sessions</source>
        <translation>%1 von %2 Sitzungen</translation>
    </message>
    <message>
        <source>1 session</source>
        <translation>1 Sitzung</translation>
    </message>
    <message>
        <source>%1 sessions</source>
        <translation>%1 Sitzungen</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionPanel</name>
    <message>
        <source>Plot of the session</source>
        <translation>Diagramm der Sitzung</translation>
    </message>
    <message>
        <source>Selects a plot of the whole session. Click a plot against time to jump to that time.</source>
        <translation>Wählt ein Diagramm der ganzen Sitzung. Ein Klick in ein Diagramm gegen die Zeit springt zu dieser Zeit.</translation>
    </message>
    <message>
        <source>Error and force</source>
        <translation>Fehler und Kraft</translation>
    </message>
    <message>
        <source>Force against displacement</source>
        <translation>Kraft gegen Auslenkung</translation>
    </message>
    <message>
        <source>Influence angles</source>
        <translation>Einflusswinkel</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Open a recorded session to see its plots here (Ctrl+Shift+O).</source>
        <translation>Öffnen Sie eine aufgezeichnete Sitzung, um hier ihre Diagramme zu sehen (Strg+Umschalt+O).</translation>
    </message>
    <message>
        <source>Plot of the &amp;session</source>
        <translation>Diagramm der &amp;Sitzung</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionPlot</name>
    <message>
        <source>Error [mm]</source>
        <translation>Fehler [mm]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>verlangt</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>Force along x [N]</source>
        <translation>Kraft entlang x [N]</translation>
    </message>
    <message>
        <source>displacement [mm]</source>
        <translation>Auslenkung [mm]</translation>
    </message>
    <message>
        <source>Force along y [N]</source>
        <translation>Kraft entlang y [N]</translation>
    </message>
    <message>
        <source>Force along z [N]</source>
        <translation>Kraft entlang z [N]</translation>
    </message>
    <message>
        <source>Angle [°]</source>
        <translation>Winkel [°]</translation>
    </message>
    <message>
        <source>α stylus</source>
        <translation>α Stift</translation>
    </message>
    <message>
        <source>β tip</source>
        <translation>β Spitze</translation>
    </message>
    <message>
        <source>θ target</source>
        <translation>θ Ziel</translation>
    </message>
    <message>
        <source>Energy [mJ]</source>
        <translation>Energie [mJ]</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>Force [dB re 1 mN]</source>
        <translation>Kraft [dB re 1 mN]</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>Frequenz [Hz]</translation>
    </message>
    <message>
        <source>Error [dB re 1 µm]</source>
        <translation>Fehler [dB re 1 µm]</translation>
    </message>
    <message>
        <source>Plots of the whole session</source>
        <translation>Diagramme der ganzen Sitzung</translation>
    </message>
    <message>
        <source>Error and force, force against displacement, angles, energy or spectrum, as selected above.</source>
        <translation>Fehler und Kraft, Kraft gegen Auslenkung, Winkel, Energie oder Spektrum, wie oben gewählt.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionTools</name>
    <message>
        <source>Export as &amp;CSV…</source>
        <translation>Als &amp;CSV exportieren …</translation>
    </message>
    <message>
        <source>Saves the ticks of the selected session as a table.</source>
        <translation>Speichert die Takte der gewählten Sitzung als Tabelle.</translation>
    </message>
    <message>
        <source>Export the session as CSV</source>
        <translation>Sitzung als CSV exportieren</translation>
    </message>
    <message>
        <source>&amp;Plots as PDF…</source>
        <translation>&amp;Diagramme als PDF …</translation>
    </message>
    <message>
        <source>Saves all plots of the selected session, one file each.</source>
        <translation>Speichert alle Diagramme der gewählten Sitzung, jedes als eigene Datei.</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Diagramme speichern</translation>
    </message>
    <message>
        <source>Run a&amp;gain</source>
        <translation>Lauf w&amp;iederholen</translation>
    </message>
    <message>
        <source>Repeats the run of the selected session from its file, and compares every tick to the last bit.</source>
        <translation>Wiederholt den Lauf der gewählten Sitzung aus ihrer Datei und vergleicht jeden Takt bis auf das letzte Bit.</translation>
    </message>
    <message>
        <source>Fo&amp;llow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Shows the recorded stylus of the selected session as a ghost for a hand to follow.</source>
        <translation>Zeigt den aufgezeichneten Stift der gewählten Sitzung als Geisterbild, dem eine Hand folgt.</translation>
    </message>
    <message>
        <source>&amp;Show in folder</source>
        <translation>Im &amp;Ordner zeigen</translation>
    </message>
    <message>
        <source>Opens the folder of the selected session.</source>
        <translation>Öffnet den Ordner der gewählten Sitzung.</translation>
    </message>
    <message>
        <source>&amp;Edit metadata…</source>
        <translation>Anga&amp;ben ändern …</translation>
    </message>
    <message>
        <source>Edits the name, notes, tags, subject and consent of the selected session.</source>
        <translation>Ändert Name, Notizen, Tags, Person und Einwilligung der gewählten Sitzung.</translation>
    </message>
    <message>
        <source>Rec&amp;over</source>
        <translation>&amp;Retten</translation>
    </message>
    <message>
        <source>Repairs a session that was not closed, so that every program can open it.</source>
        <translation>Repariert eine Sitzung, die nicht geschlossen wurde, sodass jedes Programm sie öffnen kann.</translation>
    </message>
    <message>
        <source>&amp;Delete…</source>
        <translation>&amp;Löschen …</translation>
    </message>
    <message>
        <source>Moves the selected session to the bin, or deletes it permanently.</source>
        <translation>Verschiebt die gewählte Sitzung in den Papierkorb oder entfernt sie endgültig.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Replays the selected session.</source>
        <translation>Gibt die gewählte Sitzung wieder.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Retten</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>More commands for the selected session and the folder.</source>
        <translation>Weitere Befehle für die gewählte Sitzung und den Ordner.</translation>
    </message>
    <message>
        <source>The session was recovered up to its last tenth of a second: %1 ticks.</source>
        <translation>Die Sitzung wurde bis auf ihre letzte Zehntelsekunde gerettet: %1 Takte.</translation>
    </message>
    <message>
        <source>%1 was moved to the bin and stays there until the bin is emptied.</source>
        <translation>%1 wurde in den Papierkorb verschoben und bleibt dort, bis er geleert wird.</translation>
    </message>
    <message>
        <source>The session cannot be moved to the bin: its folder has no bin or is write-protected. Delete the session permanently, or choose Show in folder and delete it there.</source>
        <translation>Die Sitzung lässt sich nicht in den Papierkorb verschieben: Ihr Ordner hat keinen oder ist schreibgeschützt. Entfernen Sie die Sitzung endgültig, oder wählen Sie „Im Ordner zeigen“ und löschen Sie sie dort.</translation>
    </message>
    <message>
        <source>%1 was deleted permanently.</source>
        <translation>%1 wurde endgültig entfernt.</translation>
    </message>
    <message>
        <source>The session cannot be removed: its folder is write-protected. Choose Show in folder, and ask the owner of the folder.</source>
        <translation>Die Sitzung lässt sich nicht entfernen: Ihr Ordner ist schreibgeschützt. Wählen Sie „Im Ordner zeigen“, und fragen Sie, wem der Ordner gehört.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SessionsPanel</name>
    <message>
        <source>Recent sessions</source>
        <translation>Letzte Sitzungen</translation>
    </message>
    <message>
        <source>Recording saved: %1 (%2)</source>
        <translation>Aufzeichnung gespeichert: %1 (%2)</translation>
    </message>
    <message>
        <source>The recording %1 was cut off. Press Show to recover it.</source>
        <translation>Die Aufzeichnung %1 brach ab. Mit „Zeigen“ können Sie sie retten.</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufzeichnen</translation>
    </message>
    <message>
        <source>Starts recording immediately, or stops it.</source>
        <translation>Startet die Aufzeichnung sofort oder stoppt sie.</translation>
    </message>
    <message>
        <source>Stop recording %1</source>
        <translation>Aufzeichnung beenden %1</translation>
    </message>
    <message>
        <source>Set a &amp;marker</source>
        <translation>&amp;Marke setzen</translation>
    </message>
    <message>
        <source>Marks this moment in the recording.</source>
        <translation>Markiert diesen Moment in der Aufzeichnung.</translation>
    </message>
    <message>
        <source>&amp;Find a session</source>
        <translation>Sitzung &amp;suchen</translation>
    </message>
    <message>
        <source>Puts the cursor in the search field.</source>
        <translation>Setzt den Cursor in das Suchfeld.</translation>
    </message>
    <message>
        <source>C&amp;hoose folder…</source>
        <translation>Ordner &amp;wählen …</translation>
    </message>
    <message>
        <source>Sets the folder in which sessions are saved and listed.</source>
        <translation>Legt den Ordner fest, in dem Sitzungen gespeichert und aufgelistet werden.</translation>
    </message>
    <message>
        <source>Folder for sessions</source>
        <translation>Ordner für Sitzungen</translation>
    </message>
    <message>
        <source>A session is being recorded. Stop the recording first.</source>
        <translation>Eine Sitzung wird aufgezeichnet. Stoppen Sie zuerst die Aufzeichnung.</translation>
    </message>
    <message>
        <source>Stop &amp;recording</source>
        <translation>&amp;Aufzeichnung stoppen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
    <message>
        <source>recording, disk nearly full</source>
        <translation>Aufzeichnung, Datenträger fast voll</translation>
    </message>
    <message>
        <source>%1 left.</source>
        <translation>%1 übrig.</translation>
    </message>
    <message>
        <source>recording, ticks missing</source>
        <translation>Aufzeichnung, Takte fehlen</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>underact::gui::ShapePanel</name>
    <message>
        <source>Edit joints</source>
        <translation>Gelenke bearbeiten</translation>
    </message>
    <message>
        <source>Opens the Robot panel: joints, springs, rotational stiffness and solver.</source>
        <translation>Öffnet den Bereich Roboter: Gelenke, Federn, Drehsteifigkeit und Löser.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht …</translation>
    </message>
    <message>
        <source>What the mesh file contains, what was repaired, and how the mesh can be felt.</source>
        <translation>Was die Datei des Dreiecksnetzes enthält, was repariert wurde und wie es sich fühlen lässt.</translation>
    </message>
    <message>
        <source>Stylus</source>
        <translation>Stift</translation>
    </message>
    <message>
        <source>Distance e from the tip to the nearest point of the shape, or to the end effector of a robot. Free: the tip does not touch the wall.</source>
        <translation>Abstand e von der Spitze zum nächsten Punkt der Form oder zum Endeffektor eines Roboters. Frei: Die Spitze berührt die Wand nicht.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ShareBar</name>
    <message>
        <source>%1, last active</source>
        <translation>%1, zuletzt aktiv</translation>
    </message>
</context>
<context>
    <name>underact::gui::SingularitiesSection</name>
    <message>
        <source>Distance to singularities</source>
        <translation>Abstand zu Singularitäten</translation>
    </message>
    <message>
        <source>At a singularity the arm loses a degree of freedom. Below its mark, a bar turns amber and says "near".</source>
        <translation>An einer Singularität verliert der Arm einen Freiheitsgrad. Unterhalb seiner Marke wird ein Balken bernsteinfarben und meldet „nah“.</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>Distance of the wrist centre from axis 1: |L1 cos q2 + L2 sin(q2 + q3)|. At 0, joint 1 no longer moves the tip. Near: below %1 mm.</source>
        <translation>Abstand des Handgelenkmittelpunkts von Achse 1: |L1 cos q2 + L2 sin(q2 + q3)|. Bei 0 bewegt Gelenk 1 die Spitze nicht mehr. Nah: unter %1 mm.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>Distance of q3 from ±90°, where the arm is stretched or folded: det J_p = L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)). Near: below %1°.</source>
        <translation>Abstand von q3 zu ±90°, wo der Arm gestreckt oder gefaltet ist: det J_p = L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)). Nah: unter %1°.</translation>
    </message>
    <message>
        <source>Wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>Distance of q5 from 0° or 180°, where axes 4 and 6 coincide and only q4 + q6 (or q6 − q4) is defined. Near: below %1°.</source>
        <translation>Abstand von q5 zu 0° oder 180°, wo die Achsen 4 und 6 zusammenfallen und nur q4 + q6 (oder q6 − q4) bestimmt ist. Nah: unter %1°.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SolutionsSection</name>
    <message>
        <source>Inverse solutions</source>
        <translation>Inverse Lösungen</translation>
    </message>
    <message>
        <source>All sets of joint values that give the current pose of the stylus; of an arm without a closed form those that a search finds. Of a haptic arm: thesis eq. 3.11 to 3.20 and figure 3.4, with their errata.</source>
        <translation>Alle Sätze von Gelenkwerten, die die jetzige Lage des Stifts ergeben; für einen Arm ohne geschlossene Form die, die eine Suche findet. Für einen haptischen Arm: Thesis, Gl. 3.11 bis 3.20 und Abbildung 3.4, mit ihren Errata.</translation>
    </message>
    <message>
        <source>Show the &amp;path</source>
        <translation>&amp;Weg zeigen</translation>
    </message>
    <message>
        <source>Show none</source>
        <translation>Keine zeigen</translation>
    </message>
    <message>
        <source>Move the &amp;arm there</source>
        <translation>&amp;Arm dorthin bewegen</translation>
    </message>
    <message>
        <source>Move the ghost to the selected solution</source>
        <translation>Geisterbild zur gewählten Lösung bewegen</translation>
    </message>
    <message>
        <source>Moves a ghost of the arm at constant speed from the current joint angles to the selected solution.</source>
        <translation>Bewegt ein Geisterbild des Arms mit konstantem Tempo von den jetzigen Gelenkwinkeln zur gewählten Lösung.</translation>
    </message>
    <message>
        <source>Show none of the solutions</source>
        <translation>Keine der Lösungen zeigen</translation>
    </message>
    <message>
        <source>Removes the ghost of the selected solution.</source>
        <translation>Entfernt das Geisterbild der gewählten Lösung.</translation>
    </message>
    <message>
        <source>Move the arm to the selected solution</source>
        <translation>Den Arm zur gewählten Lösung bewegen</translation>
    </message>
    <message>
        <source>Moves the simulated arm from the current joint angles to the selected solution.</source>
        <translation>Bewegt den simulierten Arm von den jetzigen Gelenkwinkeln zur gewählten Lösung.</translation>
    </message>
    <message>
        <source>no.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>Schulter</translation>
    </message>
    <message>
        <source>elbow</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>wrist</source>
        <translation>Handgelenk</translation>
    </message>
    <message>
        <source>joint values</source>
        <translation>Gelenkwerte</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>The number of the solution, as in the view.</source>
        <translation>Die Nummer der Lösung, wie in der Ansicht.</translation>
    </message>
    <message>
        <source>+: the turret faces the wrist centre; −: it faces away. In the view: the short line at the shoulder.</source>
        <translation>+: Der Drehturm ist dem Handgelenkmittelpunkt zugewandt; −: abgewandt. In der Ansicht: die kurze Linie an der Schulter.</translation>
    </message>
    <message>
        <source>+: cos q3 ≥ 0, as for a real arm; −: the other elbow.</source>
        <translation>+: cos q3 ≥ 0, wie bei einem echten Arm; −: der andere Ellbogen.</translation>
    </message>
    <message>
        <source>+: sin q5 ≥ 0; −: the wrist is bent the other way. In the view: the short line at the tip, axis 5.</source>
        <translation>+: sin q5 ≥ 0; −: Das Handgelenk ist andersherum gebeugt. In der Ansicht: die kurze Linie an der Spitze, Achse 5.</translation>
    </message>
    <message>
        <source>Degrees, or mm of a joint that slides.</source>
        <translation>Grad, oder mm bei einem Schubgelenk.</translation>
    </message>
    <message>
        <source>Whether all joints are within their limits. Now: the current configuration of the arm.</source>
        <translation>Ob alle Gelenke innerhalb ihrer Grenzen liegen. Jetzt: die jetzige Stellung des Arms.</translation>
    </message>
    <message>
        <source>Solution %1 does not exist here: at a singularity, two solutions coincide.</source>
        <translation>Lösung %1 gibt es hier nicht: An einer Singularität fallen zwei Lösungen zusammen.</translation>
    </message>
    <message>
        <source>Solution %1 does not exist here.</source>
        <translation>Lösung %1 gibt es hier nicht.</translation>
    </message>
    <message>
        <source>null space (%1)</source>
        <translation>Nullraum (%1)</translation>
    </message>
</context>
<context>
    <name>underact::gui::StatusLine</name>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>4000 Hz</source>
        <translation>4000 Hz</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Servo-Taktrate</translation>
    </message>
    <message>
        <source>Ticks per second.</source>
        <translation>Takte je Sekunde.</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>99 % of the ticks in the last 10 s began no later than this after their deadline.</source>
        <translation>99 % der Takte der letzten 10 s begannen höchstens so lange nach ihrem Termin.</translation>
    </message>
    <message>
        <source>latency p99 9999 µs</source>
        <translation>Latenz p99 9999 µs</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Zeitplanung</translation>
    </message>
    <message>
        <source>Guard</source>
        <translation>Wächter</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>The force sent to the arm, and its limit.</source>
        <translation>Die an den Arm gesendete Kraft und ihre Grenze.</translation>
    </message>
    <message>
        <source>force 0.00 / 0.00 N</source>
        <translation>Kraft 0,00 / 0,00 N</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Live data</source>
        <translation>Live-Daten</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source> (simulated)</source>
        <translation> (simuliert)</translation>
    </message>
    <message>
        <source> (untested)</source>
        <translation> (nicht erprobt)</translation>
    </message>
    <message>
        <source>: %1</source>
        <translation>: %1</translation>
    </message>
    <message>
        <source>A recording moves the stylus; no force is sent to an arm.</source>
        <translation>Eine Aufzeichnung bewegt den Stift; an keinen Arm wird Kraft gesendet.</translation>
    </message>
    <message>
        <source>Simulated; no real arm moves. %1</source>
        <translation>Simuliert; kein echter Arm bewegt sich. %1</translation>
    </message>
    <message>
        <source>force %1 / %2 N%3</source>
        <translation>Kraft %1 / %2 N%3</translation>
    </message>
    <message>
        <source>, limited: %1</source>
        <translation>, begrenzt: %1</translation>
    </message>
    <message>
        <source>The state of the servo, and its ticks per second.</source>
        <translation>Der Zustand des Servos und seine Takte je Sekunde.</translation>
    </message>
    <message>
        <source>not guarded</source>
        <translation>nicht bewacht</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 Hz of %2</source>
        <translation>%1 Hz von %2</translation>
    </message>
    <message>
        <source>latency p99 %1 µs</source>
        <translation>Latenz p99 %1 µs</translation>
    </message>
</context>
<context>
    <name>underact::gui::StepFigures</name>
    <message>
        <source> ± %1i</source>
        <translation> ± %1i</translation>
    </message>
    <message>
        <source>Poles [rad/s]: %1</source>
        <translation>Pole [rad/s]: %1</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Final value</source>
        <translation>Endwert</translation>
    </message>
    <message>
        <source>Where the response ends, as a fraction of the step; without damping, the value about which it oscillates.</source>
        <translation>Wo die Antwort endet, als Anteil des Sprungs; ohne Dämpfung der Wert, um den sie schwingt.</translation>
    </message>
    <message>
        <source>Rise [s]</source>
        <translation>Anstieg [s]</translation>
    </message>
    <message>
        <source>Rise time: from 10 % to 90 % of the final value, each when first reached.</source>
        <translation>Anstiegszeit: von 10 % bis 90 % des Endwerts, jeweils beim ersten Erreichen.</translation>
    </message>
    <message>
        <source>Settling [s]</source>
        <translation>Einschwingen [s]</translation>
    </message>
    <message>
        <source>Settling time: from then on the response stays within 2 % of the final value.</source>
        <translation>Einschwingzeit: Von da an bleibt die Antwort innerhalb von 2 % um den Endwert.</translation>
    </message>
    <message>
        <source>Peak [s]</source>
        <translation>Maximum [s]</translation>
    </message>
    <message>
        <source>Peak time: when the response is highest, if it exceeds the final value.</source>
        <translation>Zeit des Maximums, falls die Antwort über den Endwert hinausgeht.</translation>
    </message>
    <message>
        <source>Overshoot [%]</source>
        <translation>Überschwingen [%]</translation>
    </message>
    <message>
        <source>How far the response exceeds the final value; for a second-order system, exp(−π ζ / √(1 − ζ²)).</source>
        <translation>Wie weit die Antwort über den Endwert hinausgeht; bei einem System zweiter Ordnung exp(−π ζ / √(1 − ζ²)).</translation>
    </message>
    <message>
        <source>ωₙ [rad/s]</source>
        <translation>ωₙ [rad/s]</translation>
    </message>
    <message>
        <source>Natural frequency: √(kp / m).</source>
        <translation>Eigenfrequenz: √(kp / m).</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>Damping ratio: (b + kd) / (2 √(kp m)); 1 is critical.</source>
        <translation>Dämpfungsgrad: (b + kd) / (2 √(kp m)); 1 ist kritisch.</translation>
    </message>
    <message>
        <source>Error [mm]</source>
        <translation>Fehler [mm]</translation>
    </message>
    <message>
        <source>Steady-state error: distance from the tip to the target at the end. Friction can hold the tip up to friction / kp away.</source>
        <translation>Bleibender Fehler: Abstand der Spitze vom Ziel am Ende. Reibung kann die Spitze bis zu Reibung / kp entfernt halten.</translation>
    </message>
    <message>
        <source>Residual [mm]</source>
        <translation>Residuum [mm]</translation>
    </message>
    <message>
        <source>Root mean square difference between the fit and the measured curve.</source>
        <translation>Quadratisches Mittel der Differenz zwischen Anpassung und gemessener Kurve.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
</context>
<context>
    <name>underact::gui::StepFoot</name>
    <message>
        <source>&amp;Limits of the safety gate</source>
        <translation>Grenzen der Kraf&amp;tschleuse</translation>
    </message>
    <message>
        <source>Ge&amp;t gains</source>
        <translation>Verst. h&amp;olen</translation>
    </message>
    <message>
        <source>Copies the control law and the gains along x from the scene to this panel.</source>
        <translation>Kopiert das Regelgesetz und die Verstärkungen entlang x aus der Szene in diesen Bereich.</translation>
    </message>
    <message>
        <source>Get gains from the scene</source>
        <translation>Verstärkungen aus der Szene holen</translation>
    </message>
    <message>
        <source>Apply &amp;gains</source>
        <translation>Verst. &amp;geben</translation>
    </message>
    <message>
        <source>Copies the control law and the gains of this panel to the scene, for x, y and z; one undo step.</source>
        <translation>Kopiert das Regelgesetz und die Verstärkungen dieses Bereichs in die Szene, für x, y und z; ein Schritt beim Rückgängigmachen.</translation>
    </message>
    <message>
        <source>Apply gains to the scene</source>
        <translation>Verstärkungen an die Szene geben</translation>
    </message>
    <message>
        <source>&amp;Measure the arm</source>
        <translation>Arm &amp;messen</translation>
    </message>
    <message>
        <source>Moves the target of the constraint by a step, on a simulated arm of its own with these gains and no hand, and plots the path of the tip over the model's response.</source>
        <translation>Verschiebt das Ziel der Bindung um einen Sprung, an einem eigenen simulierten Arm mit diesen Verstärkungen und ohne Hand, und zeichnet den Weg der Spitze über die Antwort des Modells.</translation>
    </message>
    <message>
        <source>Measure the simulated arm</source>
        <translation>Simulierten Arm messen</translation>
    </message>
    <message>
        <source>Size of the step, mm</source>
        <translation>Höhe des Sprungs, mm</translation>
    </message>
    <message>
        <source>How far the target jumps in the measurement.</source>
        <translation>Wie weit das Ziel bei der Messung springt.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Limits of the safety gate</source>
        <translation>Grenzen der Kraftschleuse</translation>
    </message>
    <message>
        <source>Measures with the limits of the safety gate on force and speed. Off: the control law alone, as in the model.</source>
        <translation>Misst mit den Grenzen der Kraftschleuse für Kraft und Tempo. Aus: das Regelgesetz allein, wie im Modell.</translation>
    </message>
</context>
<context>
    <name>underact::gui::StepPanel</name>
    <message>
        <source>The response grows without bound: a pole lies to the right of the imaginary axis, or a double pole on it.</source>
        <translation>Die Antwort wächst unbegrenzt: Ein Pol liegt rechts der imaginären Achse oder ein doppelter auf ihr.</translation>
    </message>
    <message>
        <source>The response drifts for ever: a pole lies at 0.</source>
        <translation>Die Antwort driftet ohne Ende: Ein Pol liegt bei 0.</translation>
    </message>
    <message>
        <source>The response oscillates for ever: there is no damping.</source>
        <translation>Die Antwort schwingt ohne Ende: Es gibt keine Dämpfung.</translation>
    </message>
    <message>
        <source>Response shown</source>
        <translation>Gezeigte Antwort</translation>
    </message>
    <message>
        <source>The arm under a control law, or one of the figures in appendix B of the thesis.</source>
        <translation>Der Arm unter einem Regelgesetz oder eine der Abbildungen aus Anhang B der Thesis.</translation>
    </message>
    <message>
        <source>The arm under a control law</source>
        <translation>Der Arm unter einem Regelgesetz</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Notes on this response</source>
        <translation>Hinweise zu dieser Antwort</translation>
    </message>
    <message>
        <source>gains of the step response</source>
        <translation>Verstärkungen der Sprungantwort</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>The tip did not move: %1 N does not overcome the arm's friction of %2 N. Make the step larger.</source>
        <translation>Die Spitze hat sich nicht bewegt: %1 N überwinden die Reibung des Arms von %2 N nicht. Machen Sie den Sprung größer.</translation>
    </message>
    <message>
        <source>The safety gate reduced the force in %1 ticks, so the response is not linear. Make the step smaller, or measure without the limits.</source>
        <translation>Die Kraftschleuse hat die Kraft in %1 Takten begrenzt, die Antwort ist daher nicht linear. Machen Sie den Sprung kleiner oder messen Sie ohne die Grenzen.</translation>
    </message>
    <message>
        <source>Measured along %1%3. The model has no friction; the arm has %2 N.</source>
        <translation>Gemessen entlang %1%3. Das Modell hat keine Reibung; der Arm hat %2 N.</translation>
    </message>
    <message>
        <source>the direction in which the constraint pulls</source>
        <translation>der Richtung, in der die Bindung zieht</translation>
    </message>
    <message>
        <source> on “%1”</source>
        <translation> an „%1“</translation>
    </message>
</context>
<context>
    <name>underact::gui::StepPlot</name>
    <message>
        <source>2 % band, peak, settling</source>
        <translation>2-%-Band, Maximum, Einschwingen</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Response to a unit step</source>
        <translation>Antwort auf einen Einheitssprung</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Imaginary part [rad/s]</source>
        <translation>Imaginärteil [rad/s]</translation>
    </message>
    <message>
        <source>real part [rad/s]</source>
        <translation>Realteil [rad/s]</translation>
    </message>
    <message>
        <source>× pole</source>
        <translation>× Pol</translation>
    </message>
    <message>
        <source>○ zero</source>
        <translation>○ Nullstelle</translation>
    </message>
    <message>
        <source>Step response and poles</source>
        <translation>Sprungantwort und Pole</translation>
    </message>
    <message>
        <source>Above: the response to a unit step. Below: poles and zeros in the s-plane; poles to the left of the imaginary axis decay, the faster the farther away.</source>
        <translation>Oben: die Antwort auf einen Einheitssprung. Unten: Pole und Nullstellen in der s-Ebene; Pole links der imaginären Achse klingen ab, je weiter entfernt, desto schneller.</translation>
    </message>
    <message>
        <source>Overshoot %1 %</source>
        <translation>Überschwingen %1 %</translation>
    </message>
    <message>
        <source>No final value</source>
        <translation>Kein Endwert</translation>
    </message>
</context>
<context>
    <name>underact::gui::StepRows</name>
    <message>
        <source>Mass at the tip: the apparent mass of the arm, plus that of a hand: m x'' + b x' + kp x = kp r.</source>
        <translation>Masse an der Spitze: die scheinbare Masse des Arms und die einer Hand: m x'' + b x' + kp x = kp r.</translation>
    </message>
    <message>
        <source>Damping at the tip besides that of the control law: the arm's own, plus that of a hand: m x'' + b x' + kp x = kp r.</source>
        <translation>Dämpfung an der Spitze außer der des Regelgesetzes: die des Arms und die einer Hand: m x'' + b x' + kp x = kp r.</translation>
    </message>
    <message>
        <source>Measured constraint</source>
        <translation>Gemessene Bindung</translation>
    </message>
    <message>
        <source>The constraint of the scene that is measured and whose gains are copied.</source>
        <translation>Die Bindung der Szene, die gemessen wird und deren Verstärkungen kopiert werden.</translation>
    </message>
    <message>
        <source>Control law of the response</source>
        <translation>Regelgesetz der Antwort</translation>
    </message>
    <message>
        <source>P: kp e (B.13).  PD: plus kd de/dt (B.14).  PID: plus the integral of ki e (B.15).</source>
        <translation>P: kp e (B.13).  PD: dazu kd de/dt (B.14).  PID: dazu das Integral von ki e (B.15).</translation>
    </message>
    <message>
        <source>C&amp;onstraint</source>
        <translation>B&amp;indung</translation>
    </message>
    <message>
        <source>La&amp;w</source>
        <translation>&amp;Regelgesetz</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Stiffness kp</source>
        <translation>Steifigkeit kp</translation>
    </message>
    <message>
        <source>Damping kd</source>
        <translation>Dämpfung kd</translation>
    </message>
    <message>
        <source>Integral ki</source>
        <translation>Integral ki</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Damping b</source>
        <translation>Dämpfung b</translation>
    </message>
</context>
<context>
    <name>underact::gui::StopBanner</name>
    <message>
        <source>Force is off. Start (F5)</source>
        <translation>Kraft ist aus. Start (F5)</translation>
    </message>
    <message>
        <source>The servo is stopped: nothing pushes. Press here or F5 to start it.</source>
        <translation>Der Servo ist gestoppt: Nichts drückt. Hier oder F5 drücken, um ihn zu starten.</translation>
    </message>
</context>
<context>
    <name>underact::gui::SwingPlot</name>
    <message>
        <source>Tip along %1 [mm]</source>
        <translation>Spitze entlang %1 [mm]</translation>
    </message>
    <message>
        <source>Tip along x [mm]</source>
        <translation>Spitze entlang x [mm]</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>fitted model</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Swings of the tip</source>
        <translation>Schwingungen der Spitze</translation>
    </message>
    <message>
        <source>The tip is pulled towards the target and swings. The dashed line is the fitted model: a mass with friction and damping under the force that was sent.</source>
        <translation>Die Spitze wird zum Ziel gezogen und schwingt. Die gestrichelte Linie ist die Anpassung: eine Masse mit Reibung und Dämpfung unter der gesendeten Kraft.</translation>
    </message>
    <message>
        <source>%1 points along %2</source>
        <translation>%1 Punkte entlang %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::TimeSection</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>How evenly the servo loop runs.</source>
        <translation>Wie gleichmäßig die Servoschleife läuft.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Nominal rate</source>
        <translation>Soll-Taktrate</translation>
    </message>
    <message>
        <source>Ticks per second, as set above or on the command line (--rate).</source>
        <translation>Takte je Sekunde, wie oben oder auf der Befehlszeile eingestellt (--rate).</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Ticks per second, measured by the computer's clock.</source>
        <translation>Takte je Sekunde, gemessen mit der Uhr des Rechners.</translation>
    </message>
    <message>
        <source>latency</source>
        <translation>Latenz</translation>
    </message>
    <message>
        <source>Latency of the ticks since the servo was started at this rate, in µs. p99: 99 of 100 ticks start no later than this.</source>
        <translation>Latenz der Takte, seit der Servo mit dieser Taktrate läuft, in µs. p99: 99 von 100 Takten beginnen nicht später als dies.</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>letzte 10 s</translation>
    </message>
    <message>
        <source>Latency of the ticks of the last 10 s, in µs.</source>
        <translation>Latenz der Takte der letzten 10 s, in µs.</translation>
    </message>
    <message>
        <source>tick time</source>
        <translation>Taktdauer</translation>
    </message>
    <message>
        <source>How long a tick takes from the sample to the force, in µs.</source>
        <translation>Wie lange ein Takt vom Messwert bis zur Kraft dauert, in µs.</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätet</translation>
    </message>
    <message>
        <source>Ticks that started late by a period or more. The lost time is not made up for.</source>
        <translation>Takte, die um eine Periode oder mehr verspätet begannen. Die verlorene Zeit wird nicht aufgeholt.</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Deadlines that had passed when a late tick started. They are skipped, not made up for in a burst.</source>
        <translation>Termine, die schon vorbei waren, als ein verspäteter Takt begann. Sie werden ausgelassen, nicht in einem Schub nachgeholt.</translation>
    </message>
    <message>
        <source>Lost rows</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>Ticks missing from plots and recordings because the window was busy. The servo was not affected.</source>
        <translation>Takte, die in Diagrammen und Aufzeichnungen fehlen, weil das Fenster beschäftigt war. Der Servo war nicht betroffen.</translation>
    </message>
    <message>
        <source>Microseconds:</source>
        <translation>Mikrosekunden:</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
</context>
<context>
    <name>underact::gui::TitleCard</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>What to feel</source>
        <translation>Was zu fühlen ist</translation>
    </message>
    <message>
        <source>What to try</source>
        <translation>Zum Probieren</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>How to leave</source>
        <translation>Wie man den Modus verlässt</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Shows the next scene.</source>
        <translation>Zeigt die nächste Szene.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Turns the force on. Esc turns it off.</source>
        <translation>Schaltet die Kraft ein. Esc schaltet sie aus.</translation>
    </message>
    <message>
        <source>About the scene</source>
        <translation>Über die Szene</translation>
    </message>
    <message>
        <source>For demonstrators: Ctrl+Alt+Shift+U opens a panel with Stop and Leave visitor mode.</source>
        <translation>Für Vorführende: Strg+Alt+Umschalt+U öffnet einen Bereich mit Stopp und Besuchermodus verlassen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::Tour</name>
    <message>
        <source>Tour of the window</source>
        <translation>Rundgang durchs Fenster</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rundgang durchs Fenster</translation>
    </message>
    <message>
        <source>A tour of the window in eight stops. Esc leaves it at any time.</source>
        <translation>Ein Rundgang durchs Fenster mit acht Stationen. Esc beendet ihn jederzeit.</translation>
    </message>
    <message>
        <source>What it is for</source>
        <translation>Wozu es dient</translation>
    </message>
    <message>
        <source>Stop of the tour</source>
        <translation>Station des Rundgangs</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Goes to the previous stop.</source>
        <translation>Geht eine Station zurück.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Goes to the next stop, as does Enter.</source>
        <translation>Geht zur nächsten Station; auch mit der Eingabetaste.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Leaves the tour, as does Esc.</source>
        <translation>Verlässt den Rundgang, wie auch Esc.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>underact::gui::TransformPanel</name>
    <message>
        <source>p [mm]</source>
        <translation>p [mm]</translation>
    </message>
    <message>
        <source>Components along %1 of W of the frame's axes and of its position.</source>
        <translation>Komponenten der Achsen des Koordinatensystems und seiner Position entlang %1 von W.</translation>
    </message>
    <message>
        <source>Axes that the steps refer to</source>
        <translation>Bezugsachsen der Schritte</translation>
    </message>
    <message>
        <source>Moving: each step refers to the frame that results from the steps before it, X = S1 S2 S3. Fixed: to the axes of W, X = S3 S2 S1. Craig, section 2.8.</source>
        <translation>Bewegt: Jeder Schritt bezieht sich auf das Koordinatensystem, das die Schritte davor ergeben, X = S1 S2 S3. Fest: auf die Achsen von W, X = S3 S2 S1. Craig, Abschnitt 2.8.</translation>
    </message>
    <message>
        <source>About moving axes: X = S1 S2 …</source>
        <translation>Um bewegte Achsen: X = S1 S2 …</translation>
    </message>
    <message>
        <source>About fixed axes: X = … S2 S1</source>
        <translation>Um feste Achsen: X = … S2 S1</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>R: rotation about an axis. D: translation along an axis.</source>
        <translation>R: Drehung um eine Achse. D: Verschiebung entlang einer Achse.</translation>
    </message>
    <message>
        <source>value [° mm]</source>
        <translation>Wert [° mm]</translation>
    </message>
    <message>
        <source>Angle in degrees, or distance in mm.</source>
        <translation>Winkel in Grad oder Strecke in mm.</translation>
    </message>
    <message>
        <source>Why the input was refused</source>
        <translation>Warum die Eingabe abgelehnt wurde</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie gelistet</translation>
    </message>
    <message>
        <source>In reverse order</source>
        <translation>Umgekehrte Reihenfolge</translation>
    </message>
    <message>
        <source>Distance between the two results</source>
        <translation>Abstand der beiden Ergebnisse</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Adds a step after the selected one; 6 at most.</source>
        <translation>Fügt nach dem gewählten einen Schritt hinzu; höchstens 6.</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the selected step; at least one remains.</source>
        <translation>Entfernt den gewählten Schritt; mindestens einer bleibt.</translation>
    </message>
    <message>
        <source>Remove the selected step</source>
        <translation>Gewählten Schritt entfernen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undoes the last change to the steps.</source>
        <translation>Macht die letzte Änderung der Schritte rückgängig.</translation>
    </message>
    <message>
        <source>Undo the last change to the steps</source>
        <translation>Letzte Änderung der Schritte rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redoes the change that was undone.</source>
        <translation>Führt die rückgängig gemachte Änderung wieder aus.</translation>
    </message>
    <message>
        <source>Redo the change to the steps</source>
        <translation>Änderung der Schritte wiederholen</translation>
    </message>
    <message>
        <source>A rotation must be from −360 to 360 degrees.</source>
        <translation>Eine Drehung muss von −360 bis 360 Grad gehen.</translation>
    </message>
    <message>
        <source>A translation must be from −200 to 200 mm, the range of the view.</source>
        <translation>Eine Verschiebung muss von −200 bis 200 mm gehen, so weit reicht die Ansicht.</translation>
    </message>
    <message>
        <source>step %1, kind</source>
        <translation>Schritt %1, Art</translation>
    </message>
    <message>
        <source>step %1, value</source>
        <translation>Schritt %1, Wert</translation>
    </message>
    <message>
        <source>Degrees.</source>
        <translation>Grad.</translation>
    </message>
    <message>
        <source>Millimetres.</source>
        <translation>Millimeter.</translation>
    </message>
    <message>
        <source>Both orders end in the same pose: here, the order does not matter.</source>
        <translation>Beide Reihenfolgen enden in derselben Lage: Hier kommt es auf die Reihenfolge nicht an.</translation>
    </message>
    <message>
        <source>The results are %1 and %2° apart: the order matters.</source>
        <translation>Die Ergebnisse liegen %1 und %2° auseinander: Es kommt auf die Reihenfolge an.</translation>
    </message>
</context>
<context>
    <name>underact::gui::TwoViews</name>
    <message>
        <source>Felt scene</source>
        <translation>Gefühlte Szene</translation>
    </message>
    <message>
        <source>Other scene</source>
        <translation>Andere Szene</translation>
    </message>
    <message>
        <source>3D view of the other scene</source>
        <translation>3D-Ansicht der anderen Szene</translation>
    </message>
    <message>
        <source>The scene that is not felt, with the same motion of the hand. The arrow keys rotate both views.</source>
        <translation>Die Szene, die nicht gefühlt wird, mit derselben Bewegung der Hand. Die Pfeiltasten drehen beide Ansichten.</translation>
    </message>
</context>
<context>
    <name>underact::gui::ValueRow</name>
    <message>
        <source>The mark shows the scene's own value; a double click restores it.</source>
        <translation>Die Marke zeigt den eigenen Wert der Szene; ein Doppelklick stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieberegler</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>underact::gui::VisitorMode</name>
    <message>
        <source>&amp;Visitor mode</source>
        <translation>&amp;Besuchermodus</translation>
    </message>
    <message>
        <source>Full screen for visitors: shows scenes in turn with reduced force and locks everything else.</source>
        <translation>Vollbild für Besucher: zeigt Szenen im Wechsel mit verringerter Kraft und sperrt alles andere.</translation>
    </message>
    <message>
        <source>&amp;Demonstrator's panel</source>
        <translation>Bereich für Vorführen&amp;de</translation>
    </message>
    <message>
        <source>In visitor mode: choose the scenes, their duration and the force, or leave the mode.</source>
        <translation>Im Besuchermodus: Szenen, ihre Dauer und die Kraft wählen oder den Modus verlassen.</translation>
    </message>
    <message>
        <source>A measurement is using a scene of its own. End it first.</source>
        <translation>Eine Messung verwendet gerade eine eigene Szene. Beenden Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Visitor mode</source>
        <translation>Besuchermodus</translation>
    </message>
    <message>
        <source>Visitor mode was not started.</source>
        <translation>Der Besuchermodus wurde nicht gestartet.</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Lädt</translation>
    </message>
    <message>
        <source>None of these scenes can be shown; the previous ones stay.</source>
        <translation>Keine dieser Szenen kann gezeigt werden; die vorherigen bleiben.</translation>
    </message>
    <message>
        <source>Cannot be shown: %1</source>
        <translation>Nicht darstellbar: %1</translation>
    </message>
    <message>
        <source>No scene can be shown</source>
        <translation>Keine Szene darstellbar</translation>
    </message>
    <message>
        <source>The arm could not be reopened. %1</source>
        <translation>Der Arm ließ sich nicht wieder öffnen. %1</translation>
    </message>
    <message>
        <source>No scene is selected; the previous ones stay.</source>
        <translation>Keine Szene ist gewählt; die vorherigen bleiben.</translation>
    </message>
</context>
<context>
    <name>underact::gui::WalkPart</name>
    <message>
        <source>From speed to accuracy</source>
        <translation>Von Tempo zu Genauigkeit</translation>
    </message>
    <message>
        <source>Moves along the best trade-offs, from the fastest to the most accurate. The mark shows the scene as measured; a double click returns to it.</source>
        <translation>Geht die bestmöglichen Kombinationen durch, von der schnellsten zur genauesten. Die Marke zeigt die gemessene Szene; ein Doppelklick kehrt zu ihr zurück.</translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation>Tem&amp;po</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Chosen combination</source>
        <translation>Gewählte Kombination</translation>
    </message>
    <message>
        <source>Differences from the scene as it was</source>
        <translation>Unterschiede zur vorigen Szene</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Restores the scene and the servo rate that were measured.</source>
        <translation>Stellt die Szene und die Taktrate der Messung wieder her.</translation>
    </message>
    <message>
        <source>Restore what was measured</source>
        <translation>Gemessenen Stand wiederherstellen</translation>
    </message>
    <message>
        <source>There is nothing to choose from yet.</source>
        <translation>Es gibt noch nichts zur Auswahl.</translation>
    </message>
</context>
<context>
    <name>underact::gui::Welcome</name>
    <message>
        <source>What you just did</source>
        <translation>Was Sie gerade getan haben</translation>
    </message>
    <message>
        <source>Force now</source>
        <translation>Kraft jetzt</translation>
    </message>
    <message>
        <source>Welcome: three things to try</source>
        <translation>Willkommen: drei Dinge zum Probieren</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>&amp;Willkommen</translation>
    </message>
    <message>
        <source>Three things to try first: push, move a slider, turn the stylus.</source>
        <translation>Drei Dinge zum Einstieg: drücken, einen Schieberegler bewegen, den Stift drehen.</translation>
    </message>
    <message>
        <source>To try</source>
        <translation>Zum Probieren</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>What do you want to do? You can change it at the top right.</source>
        <translation>Was möchten Sie tun? Oben rechts lässt es sich ändern.</translation>
    </message>
    <message>
        <source>Tour of the window</source>
        <translation>Rundgang durchs Fenster</translation>
    </message>
    <message>
        <source>A tour of the window in eight stops.</source>
        <translation>Ein Rundgang durchs Fenster mit acht Stationen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this card. You find it again in the Help menu.</source>
        <translation>Schließt diese Karte. Sie finden sie im Menü Hilfe wieder.</translation>
    </message>
    <message>
        <source>Move a slider, here the stiffness. To feel it, turn on Keep holding (F6) and push a little first.</source>
        <translation>Bewegen Sie einen Regler, hier die Steifigkeit. Um ihn zu fühlen, schalten Sie Festhalten (F6) ein und drücken vorher ein wenig.</translation>
    </message>
    <message>
        <source>Turn the stylus: hold Ctrl and drag it.</source>
        <translation>Drehen Sie den Stift: Halten Sie Strg und ziehen Sie ihn.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Not done yet</source>
        <translation>Noch offen</translation>
    </message>
    <message>
        <source>Three things to try: %1 of 3 done</source>
        <translation>Drei Dinge: %1 von 3 getan</translation>
    </message>
    <message>
        <source>You find this card again in the Help menu.</source>
        <translation>Sie finden diese Karte im Menü Hilfe wieder.</translation>
    </message>
    <message>
        <source>The arm pushes back.</source>
        <translation>Der Arm drückt zurück.</translation>
    </message>
    <message>
        <source>You feel the change at once.</source>
        <translation>Sie fühlen die Änderung sofort.</translation>
    </message>
    <message>
        <source>The stylus has turned; in some scenes this moves the target.</source>
        <translation>Der Stift hat sich gedreht; in manchen Szenen bewegt das das Ziel.</translation>
    </message>
    <message>
        <source>Force now: %1 of %2 N.</source>
        <translation>Kraft jetzt: %1 von %2 N.</translation>
    </message>
    <message>
        <source>That is the limit: push less deeply to feel a slider.</source>
        <translation>Das ist die Grenze: Drücken Sie weniger tief, um einen Regler zu fühlen.</translation>
    </message>
</context>
<context>
    <name>underact::gui::WindowScene</name>
    <message>
        <source>changes by %1</source>
        <translation>Änderungen von %1</translation>
    </message>
</context>
<context>
    <name>welcome</name>
    <message>
        <source>Push into the surface: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in die Fläche.</translation>
    </message>
    <message>
        <source>Pull the stylus away from the point: drag it with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus vom Punkt weg.</translation>
    </message>
    <message>
        <source>Push into the sphere: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in die Kugel.</translation>
    </message>
    <message>
        <source>Pull the stylus away from the line: drag it with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus von der Geraden weg.</translation>
    </message>
    <message>
        <source>Push into the plane: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in die Ebene.</translation>
    </message>
    <message>
        <source>Pull the stylus away from the circle: drag it with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus vom Kreis weg.</translation>
    </message>
    <message>
        <source>Push into the cylinder: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in den Zylinder.</translation>
    </message>
    <message>
        <source>Push into the box: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in den Quader.</translation>
    </message>
    <message>
        <source>Push into the mesh: drag the stylus with the mouse.</source>
        <translation>Drücken Sie den Stift mit der Maus in das Dreiecksnetz.</translation>
    </message>
    <message>
        <source>Pull the stylus away from the curve: drag it with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus von der Kurve weg.</translation>
    </message>
    <message>
        <source>Pull the stylus away from the end effector of the virtual robot: drag it with the mouse.</source>
        <translation>Ziehen Sie den Stift mit der Maus vom Endeffektor des virtuellen Roboters weg.</translation>
    </message>
</context>
</TS>
