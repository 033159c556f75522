<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>(length - distance) / distance, with the straight way from terminal to terminal over the supports; 0.1 is 10 %</source>
      <translation>(Länge - Abstand) / Abstand, mit dem geraden Weg von Anschluss zu Anschluss über die Halterungen; 0.1 sind 10 %</translation>
    </message>
    <message>
      <source>Acceleration of gravity in m/s^2, in the coordinates of the container of the cable</source>
      <translation>Fallbeschleunigung in m/s^2, in den Koordinaten des Behälters des Kabels</translation>
    </message>
    <message>
      <source>Angle by which the cable is twisted from its start to its end; between clamped ends their rolls make it</source>
      <translation>Winkel, um den das Kabel vom Anfang bis zum Ende verdrillt ist; zwischen eingespannten Enden folgt er aus deren Drehung</translation>
    </message>
    <message>
      <source>Axial stiffness EA; 0: does not stretch</source>
      <translation>Dehnsteifigkeit EA; 0: dehnt sich nicht</translation>
    </message>
    <message>
      <source>Bending stiffness EI</source>
      <translation>Biegesteifigkeit EI</translation>
    </message>
    <message>
      <source>Bending stiffness EI about the second axis of the section, of a flat cable; 0: the same</source>
      <translation>Biegesteifigkeit EI um die zweite Achse des Querschnitts, bei einem Flachkabel; 0: dieselbe</translation>
    </message>
    <message>
      <source>Between what that is for all cables, with 95 % confidence</source>
      <translation>Zwischen welchen Werten das für alle Kabel liegt, mit 95 % Vertrauen</translation>
    </message>
    <message>
      <source>By what factor the cable may be stiffer or softer; 1: its stiffness is known</source>
      <translation>Um welchen Faktor das Kabel steifer oder weicher sein kann; 1: seine Steifigkeit ist bekannt</translation>
    </message>
    <message>
      <source>Centre of mass, in the coordinates of the container</source>
      <translation>Schwerpunkt, in den Koordinaten des Behälters</translation>
    </message>
    <message>
      <source>Check: warn where the cable bends more sharply than its type allows. Enforce: form it so that it does not</source>
      <translation>Check (prüfen): warnt, wo das Kabel stärker gebogen ist, als sein Typ erlaubt. Enforce (erzwingen): formt es so, dass es das nicht ist</translation>
    </message>
    <message>
      <source>Circular edge, flat or cylindrical face, vertex or object where the cable is held; a second one, a local coordinate system, gives the axes at a vertex</source>
      <translation>Kreiskante, ebene oder zylindrische Fläche, Punkt oder Objekt, wo das Kabel gehalten wird; ein zweites, ein lokales Koordinatensystem, gibt an einem Punkt die Achsen</translation>
    </message>
    <message>
      <source>Closed sketch swept instead of a circle: its x and y turn with the axes of the section</source>
      <translation>Geschlossene Skizze, die statt eines Kreises entlanggeführt wird: ihre x- und y-Achse drehen sich mit den Achsen des Querschnitts</translation>
    </message>
    <message>
      <source>Colour the cable by how far its bend radius is above the limit: red below it, orange up to 10 % above, yellow at 50 %, green from 100 %</source>
      <translation>Färbt das Kabel danach, wie weit sein Biegeradius über der Grenze liegt: rot darunter, orange bis 10 % darüber, gelb bei 50 %, grün ab 100 %</translation>
    </message>
    <message>
      <source>Columns of the spreadsheet, as Smallest bend radius, by their heads without units; empty: all</source>
      <translation>Spalten der Tabelle, etwa Smallest bend radius, mit ihren Überschriften ohne Einheiten; leer: alle</translation>
    </message>
    <message>
      <source>Compute shear also where the cable does not seem to need it</source>
      <translation>Schub auch berechnen, wo das Kabel ihn nicht zu brauchen scheint</translation>
    </message>
    <message>
      <source>Compute stretch also where the cable does not seem to need it</source>
      <translation>Dehnung auch berechnen, wo das Kabel sie nicht zu brauchen scheint</translation>
    </message>
    <message>
      <source>Compute torsion also where the cable does not seem to need it</source>
      <translation>Torsion auch berechnen, wo das Kabel sie nicht zu brauchen scheint</translation>
    </message>
    <message>
      <source>Curvature about the two axes of the section and twist of the unloaded cable, in 1/m</source>
      <translation>Krümmung um die beiden Achsen des Querschnitts und Verdrehung des unbelasteten Kabels, in 1/m</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>Dichte</translation>
    </message>
    <message>
      <source>Displacement from the reference, in its axes</source>
      <translation>Verschiebung gegenüber der Referenz, in deren Achsen</translation>
    </message>
    <message>
      <source>Distance of the tightest place from the start, along the cable</source>
      <translation>Abstand der am stärksten gebogenen Stelle vom Anfang, entlang des Kabels</translation>
    </message>
    <message>
      <source>Distance of the tightest place from the start, along the route</source>
      <translation>Abstand der am stärksten gebogenen Stelle vom Anfang, entlang des Weges</translation>
    </message>
    <message>
      <source>Energy of bending, torsion and stretch, in J</source>
      <translation>Energie von Biegung, Torsion und Dehnung, in J</translation>
    </message>
    <message>
      <source>Energy of the weight, measured from the start against gravity, in J</source>
      <translation>Energie des Gewichts, vom Anfang aus gegen die Schwerkraft gemessen, in J</translation>
    </message>
    <message>
      <source>Error of position asked for, relative to the length</source>
      <translation>Verlangter Fehler der Lage, relativ zur Länge</translation>
    </message>
    <message>
      <source>Estimate of the largest error of position</source>
      <translation>Schätzung des größten Fehlers der Lage</translation>
    </message>
    <message>
      <source>First value, as FreeCAD computes: mm, degrees</source>
      <translation>Erster Wert, wie FreeCAD rechnet: mm, Grad</translation>
    </message>
    <message>
      <source>Fixed: the length is given. Slack: it follows from the distance of the terminals, measured over the supports. Shortest: the least that keeps bend radius and clearance</source>
      <translation>Fixed: die Länge ist gegeben. Slack: sie folgt aus dem Abstand der Anschlüsse, über die Halterungen gemessen. Shortest: die kürzeste, die Biegeradius und Freiraum einhält</translation>
    </message>
    <message>
      <source>Force of the connector at the end on the cable, in N</source>
      <translation>Kraft des Steckers am Ende auf das Kabel, in N</translation>
    </message>
    <message>
      <source>Force of the connector at the start on the cable, in N</source>
      <translation>Kraft des Steckers am Anfang auf das Kabel, in N</translation>
    </message>
    <message>
      <source>Forces of the obstacles on the cable, in N</source>
      <translation>Kräfte der Hindernisse auf das Kabel, in N</translation>
    </message>
    <message>
      <source>Forces of the supports on the cable, in their order, in N</source>
      <translation>Kräfte der Halterungen auf das Kabel, in ihrer Reihenfolge, in N</translation>
    </message>
    <message>
      <source>Greatest bending stiffness, where no strand slips; 0: not known</source>
      <translation>Größte Biegesteifigkeit, bei der keine Litze gleitet; 0: nicht bekannt</translation>
    </message>
    <message>
      <source>How far each terminal may be from its place, along each axis</source>
      <translation>Wie weit jeder Anschluss von seinem Platz entfernt sein kann, entlang jeder Achse</translation>
    </message>
    <message>
      <source>How far each terminal may be turned, about each axis it holds</source>
      <translation>Wie weit jeder Anschluss verdreht sein kann, um jede Achse, die er hält</translation>
    </message>
    <message>
      <source>How the solve ended, and what to look at</source>
      <translation>Wie die Lösung ausging, und worauf zu achten ist</translation>
    </message>
    <message>
      <source>Its centreline, drawn as a wire of its own</source>
      <translation>Seine Mittellinie, als eigener Draht gezeichnet</translation>
    </message>
    <message>
      <source>Largest force of a connector on the cable, in N</source>
      <translation>Größte Kraft eines Steckers auf das Kabel, in N</translation>
    </message>
    <message>
      <source>Largest residual of force and moment balance, recomputed from the nodes, relative to the loads</source>
      <translation>Größter Rest im Gleichgewicht der Kräfte und Momente, aus den Knoten nachgerechnet, relativ zu den Lasten</translation>
    </message>
    <message>
      <source>Last value</source>
      <translation>Letzter Wert</translation>
    </message>
    <message>
      <source>Least bending stiffness, where all strands slip; 0: not known</source>
      <translation>Kleinste Biegesteifigkeit, bei der alle Litzen gleiten; 0: nicht bekannt</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and an obstacle, where no terminal or support holds it; infinite if none is in reach</source>
      <translation>Kleinster Abstand zwischen der Oberfläche des Kabels und einem Hindernis, wo kein Anschluss und keine Halterung es hält; unendlich, wenn keines in Reichweite ist</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and the edge of the hole</source>
      <translation>Kleinster Abstand zwischen der Oberfläche des Kabels und dem Rand des Lochs</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and the obstacles</source>
      <translation>Kleinster Abstand zwischen der Oberfläche des Kabels und den Hindernissen</translation>
    </message>
    <message>
      <source>Length added at the start, inside the connector and to strip</source>
      <translation>Zugabe zur Länge am Anfang, im Stecker und zum Abisolieren</translation>
    </message>
    <message>
      <source>Length of the curve</source>
      <translation>Länge der Kurve</translation>
    </message>
    <message>
      <source>Length of the route</source>
      <translation>Länge des Weges</translation>
    </message>
    <message>
      <source>Length of the route less that of the cable</source>
      <translation>Länge des Weges weniger der des Kabels</translation>
    </message>
    <message>
      <source>Length of the unloaded cable</source>
      <translation>Länge des unbelasteten Kabels</translation>
    </message>
    <message>
      <source>Length of the unloaded cable from its start to here</source>
      <translation>Länge des unbelasteten Kabels von seinem Anfang bis hierher</translation>
    </message>
    <message>
      <source>Length that all values allow</source>
      <translation>Länge, die alle Werte erlauben</translation>
    </message>
    <message>
      <source>Length that the worst value needs</source>
      <translation>Länge, die der schlimmste Wert braucht</translation>
    </message>
    <message>
      <source>Length to cut: the solved length and both allowances, rounded up</source>
      <translation>Schnittlänge: die gelöste Länge und beide Zugaben, aufgerundet</translation>
    </message>
    <message>
      <source>Let the cable pass the other way. By itself it passes along the axis the way that is nearer to the straight line from the support or terminal before to the one after</source>
      <translation>Lässt das Kabel andersherum durch. Von selbst läuft es entlang der Achse in der Richtung, die der Geraden von der Halterung oder dem Anschluss davor zu der danach näher ist</translation>
    </message>
    <message>
      <source>Let the cable slide through without friction. Else it is held at Position</source>
      <translation>Lässt das Kabel ohne Reibung gleiten. Sonst wird es bei Position gehalten</translation>
    </message>
    <message>
      <source>Longest length that keeps bend radius and clearance</source>
      <translation>Größte Länge, die Biegeradius und Freiraum einhält</translation>
    </message>
    <message>
      <source>Mark the place with the smallest bend radius</source>
      <translation>Markiert die Stelle mit dem kleinsten Biegeradius</translation>
    </message>
    <message>
      <source>Mark the places where obstacles push the cable</source>
      <translation>Markiert die Stellen, an denen Hindernisse das Kabel drücken</translation>
    </message>
    <message>
      <source>Mass of the cable, in kg</source>
      <translation>Masse des Kabels, in kg</translation>
    </message>
    <message>
      <source>Mass per length</source>
      <translation>Masse pro Länge</translation>
    </message>
    <message>
      <source>Moment of the connector at the end on the cable, in N m</source>
      <translation>Moment des Steckers am Ende auf das Kabel, in N m</translation>
    </message>
    <message>
      <source>Moment of the connector at the start on the cable, in N m</source>
      <translation>Moment des Steckers am Anfang auf das Kabel, in N m</translation>
    </message>
    <message>
      <source>Moments of the supports on the cable, in their order, in N m</source>
      <translation>Momente der Halterungen auf das Kabel, in ihrer Reihenfolge, in N m</translation>
    </message>
    <message>
      <source>Number of random cases</source>
      <translation>Anzahl zufälliger Fälle</translation>
    </message>
    <message>
      <source>Number of values from first to last</source>
      <translation>Anzahl der Werte vom ersten bis zum letzten</translation>
    </message>
    <message>
      <source>Number that the random cases follow from</source>
      <translation>Zahl, aus der die zufälligen Fälle folgen</translation>
    </message>
    <message>
      <source>Outer diameter</source>
      <translation>Außendurchmesser</translation>
    </message>
    <message>
      <source>Parts, assemblies, links to them and other cables that the cable must not enter</source>
      <translation>Teile, Baugruppen, Verknüpfungen mit ihnen und andere Kabel, in die das Kabel nicht eindringen darf</translation>
    </message>
    <message>
      <source>Radius of the hole; that of the reference if it is a circle or a cylinder</source>
      <translation>Radius des Lochs; der der Referenz, wenn sie ein Kreis oder Zylinder ist</translation>
    </message>
    <message>
      <source>Row of the worst case; its shape is drawn with the nominal one</source>
      <translation>Zeile des schlimmsten Falles; seine Form ist mit der nominellen gezeichnet</translation>
    </message>
    <message>
      <source>Search for the length that the worst value needs; takes longer</source>
      <translation>Sucht die Länge, die der schlimmste Wert braucht; dauert länger</translation>
    </message>
    <message>
      <source>Share of the cases that hold</source>
      <translation>Anteil der Fälle, die genügen</translation>
    </message>
    <message>
      <source>Shear modulus</source>
      <translation>Schubmodul</translation>
    </message>
    <message>
      <source>Shear stiffness GA; 0: does not shear</source>
      <translation>Schubsteifigkeit GA; 0: keine Schubverformung</translation>
    </message>
    <message>
      <source>Shortest length that keeps bend radius and clearance</source>
      <translation>Kürzeste Länge, die Biegeradius und Freiraum einhält</translation>
    </message>
    <message>
      <source>Show what terminals and supports exert on the cable as arrows</source>
      <translation>Zeigt als Pfeile, was Anschlüsse und Halterungen auf das Kabel ausüben</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>Kleinster Biegeradius</translation>
    </message>
    <message>
      <source>Smallest bend radius less the smallest one that the cable type allows; negative if it is violated</source>
      <translation>Kleinster Biegeradius weniger dem kleinsten, den der Kabeltyp erlaubt; negativ, wenn er verletzt ist</translation>
    </message>
    <message>
      <source>Smallest bend radius of all shapes</source>
      <translation>Kleinster Biegeradius aller Formen</translation>
    </message>
    <message>
      <source>Smallest bend radius of the centreline</source>
      <translation>Kleinster Biegeradius der Mittellinie</translation>
    </message>
    <message>
      <source>Smallest bend radius the cable may have where it is laid; 0: no limit</source>
      <translation>Kleinster Biegeradius, den das Kabel haben darf, wo es fest verlegt ist; 0: keine Grenze</translation>
    </message>
    <message>
      <source>Smallest bend radius the cable may have where it moves; 0: not known</source>
      <translation>Kleinster Biegeradius, den das Kabel haben darf, wo es sich bewegt; 0: nicht bekannt</translation>
    </message>
    <message>
      <source>Smallest clearance of all shapes; infinite without any</source>
      <translation>Kleinster Freiraum aller Formen; unendlich ohne Hindernis</translation>
    </message>
    <message>
      <source>Solids, centrelines, or the envelope: solids so close to each other that the gaps are less than the cable</source>
      <translation>Körper, Mittellinien oder die Hülle: Körper so dicht beieinander, dass die Lücken kleiner als das Kabel sind</translation>
    </message>
    <message>
      <source>Spline: as CAD routes a cable, with the directions of the terminals. Catenary: a thread of the cable's length without stiffness. Chord: straight</source>
      <translation>Spline: wie CAD ein Kabel führt, mit den Richtungen der Anschlüsse. Catenary (Kettenlinie): ein Faden von der Länge des Kabels ohne Steifigkeit. Chord (Sehne): gerade</translation>
    </message>
    <message>
      <source>Spreadsheet with a row for each value</source>
      <translation>Tabelle mit einer Zeile für jeden Wert</translation>
    </message>
    <message>
      <source>Terminal where the cable ends</source>
      <translation>Anschluss, an dem das Kabel endet</translation>
    </message>
    <message>
      <source>Terminal where the cable starts</source>
      <translation>Anschluss, an dem das Kabel beginnt</translation>
    </message>
    <message>
      <source>The cable it belongs to</source>
      <translation>Das Kabel, zu dem es gehört</translation>
    </message>
    <message>
      <source>The cable may be as much too long as IPC/WHMA-A-620 allows: 50 mm up to 1.5 m</source>
      <translation>Das Kabel darf um so viel zu lang sein, wie IPC/WHMA-A-620 erlaubt: 50 mm bis 1.5 m</translation>
    </message>
    <message>
      <source>The cut length is rounded up to a multiple of this; 0: not rounded</source>
      <translation>Die Schnittlänge wird auf ein Vielfaches davon aufgerundet; 0: nicht gerundet</translation>
    </message>
    <message>
      <source>The difference, relative to the length of the cable</source>
      <translation>Der Unterschied, relativ zur Länge des Kabels</translation>
    </message>
    <message>
      <source>The number: Length, Placement.Base.x, Constraints.width, or a cell of a spreadsheet; of the cable also StiffnessScale, a factor of its stiffness, and GravityTurn.x, y or z, degrees</source>
      <translation>Die Zahl: Length, Placement.Base.x, Constraints.width oder eine Zelle einer Tabelle; vom Kabel auch StiffnessScale, ein Faktor seiner Steifigkeit, und GravityTurn.x, y oder z, Grad</translation>
    </message>
    <message>
      <source>The object that has the number, a joint or a sheet as well; empty: the cable</source>
      <translation>Das Objekt, das die Zahl hat, auch eine Verbindung oder Tabelle; leer: das Kabel</translation>
    </message>
    <message>
      <source>The same at the end</source>
      <translation>Dasselbe am Ende</translation>
    </message>
    <message>
      <source>The section in words, and what looks wrong</source>
      <translation>Der Querschnitt in Worten, und was falsch aussieht</translation>
    </message>
    <message>
      <source>Time of the last solve, in s</source>
      <translation>Zeit der letzten Lösung, in s</translation>
    </message>
    <message>
      <source>Torsional stiffness GJ</source>
      <translation>Torsionssteifigkeit GJ</translation>
    </message>
    <message>
      <source>Turn about the axis of the reference</source>
      <translation>Drehung um die Achse der Referenz</translation>
    </message>
    <message>
      <source>Turn about the cable's axis; whole turns do not count</source>
      <translation>Drehung um die Achse des Kabels; ganze Umdrehungen zählen nicht</translation>
    </message>
    <message>
      <source>Turn the cable into the part instead of out of it</source>
      <translation>Das Kabel in das Teil hinein führen statt aus ihm heraus</translation>
    </message>
    <message>
      <source>Value at which it is</source>
      <translation>Wert, bei dem er auftritt</translation>
    </message>
    <message>
      <source>Value at which it is needed</source>
      <translation>Wert, bei dem sie gebraucht wird</translation>
    </message>
    <message>
      <source>Value of each shape that is drawn</source>
      <translation>Wert jeder Form, die gezeichnet ist</translation>
    </message>
    <message>
      <source>Values at which the cable jumps to another shape, or buckles</source>
      <translation>Werte, bei denen das Kabel in eine andere Form springt oder ausknickt</translation>
    </message>
    <message>
      <source>Values in their order, instead of first, last and number</source>
      <translation>Werte in ihrer Reihenfolge, statt erstem, letztem und Anzahl</translation>
    </message>
    <message>
      <source>Values: one number of the document over a range. Random: cases within the tolerances. Corners: all combinations of their bounds</source>
      <translation>Values: eine Zahl des Dokuments über einen Bereich. Random: Fälle innerhalb der Toleranzen. Corners: alle Kombinationen ihrer Grenzen</translation>
    </message>
    <message>
      <source>Values: stiffness and mass as given. Material: those of a solid round section; a stranded cable is softer, often ten times</source>
      <translation>Values: Steifigkeit und Masse wie angegeben. Material: die eines vollen runden Querschnitts; ein Kabel aus Litzen ist weicher, oft zehnmal</translation>
    </message>
    <message>
      <source>What exerts them</source>
      <translation>Was sie ausübt</translation>
    </message>
    <message>
      <source>What forbids shorter and longer lengths, and where</source>
      <translation>Was kürzere und größere Längen verbietet, und wo</translation>
    </message>
    <message>
      <source>What happened, value by value</source>
      <translation>Was geschah, Wert für Wert</translation>
    </message>
    <message>
      <source>What holds the cable on its way, in order along it</source>
      <translation>Was das Kabel auf seinem Weg hält, in der Reihenfolge entlang des Kabels</translation>
    </message>
    <message>
      <source>What is held. Clamped: position and all directions; Swivel: position and tangent, the cable may twist; Pinned: position; Free: nothing</source>
      <translation>Was gehalten wird. Clamped: Position und alle Richtungen; Swivel: Position und Tangente, das Kabel kann sich verdrehen; Pinned: Position; Free: nichts</translation>
    </message>
    <message>
      <source>What is wrong, if anything</source>
      <translation>Was falsch ist, falls etwas falsch ist</translation>
    </message>
    <message>
      <source>What is wrong, or to be done</source>
      <translation>Was falsch oder zu tun ist</translation>
    </message>
    <message>
      <source>What the cable is made of</source>
      <translation>Woraus das Kabel besteht</translation>
    </message>
    <message>
      <source>What the model has and what was left out of it, and why</source>
      <translation>Was das Modell enthält, was weggelassen wurde, und warum</translation>
    </message>
    <message>
      <source>When it is solved. Manual: when asked to. On recompute: with the document. Live: also by itself, when what holds it moves in the window</source>
      <translation>Wann es gelöst wird. Manual: auf Verlangen. On recompute: mit dem Dokument. Live: auch von selbst, wenn sich im Fenster bewegt, was es hält</translation>
    </message>
    <message>
      <source>Where each number comes from: measured, datasheet, standard, derived, user or placeholder, and the source</source>
      <translation>Woher jede Zahl kommt: measured (gemessen), datasheet (Datenblatt), standard (Norm), derived (abgeleitet), user (Benutzer) oder placeholder (Platzhalter), und die Quelle</translation>
    </message>
    <message>
      <source>Where the cable is held: along z, in the coordinates of the container</source>
      <translation>Wo das Kabel gehalten wird: entlang z, in den Koordinaten des Behälters</translation>
    </message>
    <message>
      <source>Where the cable must be formed to keep the enforced bend radius, and with what moment</source>
      <translation>Wo das Kabel geformt werden muss, damit es den erzwungenen Biegeradius einhält, und mit welchem Moment</translation>
    </message>
    <message>
      <source>Where the smallest bend radius is measured: at the inside of the bend or at the centreline</source>
      <translation>Wo der kleinste Biegeradius gemessen wird: innen an der Biegung (Inside) oder an der Mittellinie (Centreline)</translation>
    </message>
    <message>
      <source>Where they act: distances from the start, along the cable, in mm</source>
      <translation>Wo sie wirken: Abstände vom Anfang, entlang des Kabels, in mm</translation>
    </message>
    <message>
      <source>Whether shape and numbers are those from before the last change, because it is not solved yet</source>
      <translation>Ob Form und Zahlen die von vor der letzten Änderung sind, weil es noch nicht gelöst ist</translation>
    </message>
    <message>
      <source>Whether something has changed since the study was run</source>
      <translation>Ob sich etwas geändert hat, seit die Studie lief</translation>
    </message>
    <message>
      <source>Whether the cable moves, so that MinBendRadiusMoving counts</source>
      <translation>Ob sich das Kabel bewegt, so dass MinBendRadiusMoving gilt</translation>
    </message>
    <message>
      <source>Whether the cable stays in this shape</source>
      <translation>Ob das Kabel in dieser Form bleibt</translation>
    </message>
    <message>
      <source>Young's modulus</source>
      <translation>Elastizitätsmodul</translation>
    </message>
  </context>
  <context>
    <name>Cable</name>
    <message>
      <source>Add the Selection</source>
      <translation>Auswahl hinzufügen</translation>
    </message>
    <message>
      <source>Always, while parts move</source>
      <translation>Immer, während sich Teile bewegen</translation>
    </message>
    <message>
      <source>Bend radius</source>
      <translation>Biegeradius</translation>
    </message>
    <message>
      <source>Bend radius margin</source>
      <translation>Abstand vom erlaubten Biegeradius</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>Kabeltyp</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>Prüfen</translation>
    </message>
    <message>
      <source>Clearance</source>
      <translation>Freiraum</translation>
    </message>
    <message>
      <source>Colour by bend radius</source>
      <translation>Nach Biegeradius färben</translation>
    </message>
    <message>
      <source>Edit {label}</source>
      <translation>{label} bearbeiten</translation>
    </message>
    <message>
      <source>Error estimate</source>
      <translation>Fehlerschätzung</translation>
    </message>
    <message>
      <source>Folder for the report</source>
      <translation>Ordner für den Bericht</translation>
    </message>
    <message>
      <source>Force and moment at the end</source>
      <translation>Kraft und Moment am Ende</translation>
    </message>
    <message>
      <source>Force and moment at the start</source>
      <translation>Kraft und Moment am Anfang</translation>
    </message>
    <message>
      <source>Force on the cable</source>
      <translation>Kraft auf das Kabel</translation>
    </message>
    <message>
      <source>Form the cable so that it is kept</source>
      <translation>Das Kabel so formen, dass er eingehalten wird</translation>
    </message>
    <message>
      <source>From the slack</source>
      <translation>Aus der Überlänge</translation>
    </message>
    <message>
      <source>Given</source>
      <translation>Gegeben</translation>
    </message>
    <message>
      <source>Holds</source>
      <translation>Hält</translation>
    </message>
    <message>
      <source>Lead the cable through the supports selected now</source>
      <translation>Das Kabel durch die gerade ausgewählten Halterungen führen</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>Let the cable pass the other way</source>
      <translation>Kabel andersherum durchlassen</translation>
    </message>
    <message>
      <source>Mark contacts</source>
      <translation>Kontakte markieren</translation>
    </message>
    <message>
      <source>Mark the tightest place</source>
      <translation>Die engste Stelle markieren</translation>
    </message>
    <message>
      <source>Moment on the cable</source>
      <translation>Moment auf das Kabel</translation>
    </message>
    <message>
      <source>Nearer to the end of the cable</source>
      <translation>Näher an das Ende des Kabels</translation>
    </message>
    <message>
      <source>Nearer to the start of the cable</source>
      <translation>Näher an den Anfang des Kabels</translation>
    </message>
    <message>
      <source>Nothing</source>
      <translation>Nichts</translation>
    </message>
    <message>
      <source>Offset</source>
      <translation>Versatz</translation>
    </message>
    <message>
      <source>Position</source>
      <translation>Position</translation>
    </message>
    <message>
      <source>Position along the cable</source>
      <translation>Position entlang des Kabels</translation>
    </message>
    <message>
      <source>Position and all directions</source>
      <translation>Position und alle Richtungen</translation>
    </message>
    <message>
      <source>Position and direction; it may twist</source>
      <translation>Position und Richtung; es kann sich verdrehen</translation>
    </message>
    <message>
      <source>Preview; the solid follows when it rests.</source>
      <translation>Vorschau; der Körper folgt, wenn Ruhe ist.</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>Radius</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <source>Roll</source>
      <translation>Rollwinkel</translation>
    </message>
    <message>
      <source>Shortest that will do</source>
      <translation>Kürzeste, die genügt</translation>
    </message>
    <message>
      <source>Show forces</source>
      <translation>Kräfte zeigen</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>Kleinster Biegeradius</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>Lösen</translation>
    </message>
    <message>
      <source>Solve Now</source>
      <translation>Jetzt lösen</translation>
    </message>
    <message>
      <source>Solving: {seconds}, {what}</source>
      <translation>Löst: {seconds}, {what}</translation>
    </message>
    <message>
      <source>Stability</source>
      <translation>Stabilität</translation>
    </message>
    <message>
      <source>Stand at the edge, face or vertex selected now</source>
      <translation>An die jetzt gewählte Kante, Fläche oder Ecke setzen</translation>
    </message>
    <message>
      <source>Stands at</source>
      <translation>Sitzt an</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Stops the solve; the last good shape stays</source>
      <translation>Hält die Lösung an; die letzte gute Form bleibt</translation>
    </message>
    <message>
      <source>Stops the solves of all cables; their last good shapes stay</source>
      <translation>Hält die Lösung aller Kabel an; ihre letzten guten Formen bleiben</translation>
    </message>
    <message>
      <source>Supports</source>
      <translation>Halterungen</translation>
    </message>
    <message>
      <source>Take the Selection</source>
      <translation>Auswahl übernehmen</translation>
    </message>
    <message>
      <source>The cable passes it by; it stays in the document</source>
      <translation>Das Kabel geht an ihr vorbei; sie bleibt im Dokument</translation>
    </message>
    <message>
      <source>The cable slides through</source>
      <translation>Das Kabel gleitet hindurch</translation>
    </message>
    <message>
      <source>Turn the cable into the part</source>
      <translation>Das Kabel in das Teil hinein führen</translation>
    </message>
    <message>
      <source>Waiting to be solved: {seconds}</source>
      <translation>Wartet auf die Lösung: {seconds}</translation>
    </message>
    <message>
      <source>When asked to</source>
      <translation>Auf Verlangen</translation>
    </message>
    <message>
      <source>With the document</source>
      <translation>Mit dem Dokument</translation>
    </message>
    <message>
      <source>its type has no limit</source>
      <translation>sein Typ hat keine Grenze</translation>
    </message>
    <message>
      <source>no obstacle in reach</source>
      <translation>kein Hindernis in Reichweite</translation>
    </message>
    <message>
      <source>not stable</source>
      <translation>nicht stabil</translation>
    </message>
    <message>
      <source>nowhere</source>
      <translation>nirgends</translation>
    </message>
    <message>
      <source>stable</source>
      <translation>stabil</translation>
    </message>
    <message>
      <source>straight</source>
      <translation>gerade</translation>
    </message>
    <message>
      <source>{margin} above {limit}</source>
      <translation>{margin} über {limit}</translation>
    </message>
    <message>
      <source>{margin} below {limit}</source>
      <translation>{margin} unter {limit}</translation>
    </message>
    <message>
      <source>{radius} at {place} from the start</source>
      <translation>{radius} bei {place} vom Anfang</translation>
    </message>
    <message>
      <source>{said}; {count} more</source>
      <translation>{said}; {count} weitere</translation>
    </message>
  </context>
  <context>
    <name>CablePreferences</name>
    <message>
      <source>Always, while parts move</source>
      <translation>Immer, während sich Teile bewegen</translation>
    </message>
    <message>
      <source>By how much a new cable is longer than the straight way between its terminals</source>
      <translation>Um wie viel ein neues Kabel länger ist als der gerade Weg zwischen seinen Anschlüssen</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>Kabeltyp</translation>
    </message>
    <message>
      <source>Colour</source>
      <translation>Farbe</translation>
    </message>
    <message>
      <source>Colour of new cables</source>
      <translation>Farbe neuer Kabel</translation>
    </message>
    <message>
      <source>Error of position</source>
      <translation>Fehler der Lage</translation>
    </message>
    <message>
      <source>Name of a type in the library that new cables have; empty: the first type of the document, or of the library</source>
      <translation>Name eines Typs der Bibliothek, den neue Kabel haben; leer: der erste Typ des Dokuments oder der Bibliothek</translation>
    </message>
    <message>
      <source>New cables</source>
      <translation>Neue Kabel</translation>
    </message>
    <message>
      <source>Nothing</source>
      <translation>Nichts</translation>
    </message>
    <message>
      <source>Position</source>
      <translation>Position</translation>
    </message>
    <message>
      <source>Position and all directions</source>
      <translation>Position und alle Richtungen</translation>
    </message>
    <message>
      <source>Position and tangent; the cable may twist</source>
      <translation>Position und Tangente; das Kabel kann sich verdrehen</translation>
    </message>
    <message>
      <source>Slack</source>
      <translation>Überlänge</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>Lösen</translation>
    </message>
    <message>
      <source>Terminals hold</source>
      <translation>Anschlüsse halten</translation>
    </message>
    <message>
      <source>What a new terminal holds of its cable</source>
      <translation>Was ein neuer Anschluss von seinem Kabel hält</translation>
    </message>
    <message>
      <source>What is asked for of new cables, relative to the length</source>
      <translation>Was von neuen Kabeln verlangt wird, relativ zur Länge</translation>
    </message>
    <message>
      <source>When asked to</source>
      <translation>Auf Verlangen</translation>
    </message>
    <message>
      <source>When new cables are solved</source>
      <translation>Wann neue Kabel gelöst werden</translation>
    </message>
    <message>
      <source>With the document</source>
      <translation>Mit dem Dokument</translation>
    </message>
    <message>
      <source>the first of the document</source>
      <translation>der erste des Dokuments</translation>
    </message>
  </context>
  <context>
    <name>CableReport</name>
    <message>
      <source>All cables</source>
      <translation>Alle Kabel</translation>
    </message>
    <message>
      <source>Allowance at start and end</source>
      <translation>Zugabe am Anfang und am Ende</translation>
    </message>
    <message>
      <source>Allowed</source>
      <translation>Erlaubt</translation>
    </message>
    <message>
      <source>Allowed [mm]</source>
      <translation>Erlaubt [mm]</translation>
    </message>
    <message>
      <source>Allowed&lt;br&gt;[mm]</source>
      <translation>Erlaubt&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>As the window shows it</source>
      <translation>Wie das Fenster es zeigt</translation>
    </message>
    <message>
      <source>Balance of forces and moments</source>
      <translation>Gleichgewicht der Kräfte und Momente</translation>
    </message>
    <message>
      <source>Bend and clearance</source>
      <translation>Biegung und Freiraum</translation>
    </message>
    <message>
      <source>Cable</source>
      <translation>Kabel</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>Kabeltyp</translation>
    </message>
    <message>
      <source>Cable types</source>
      <translation>Kabeltypen</translation>
    </message>
    <message>
      <source>Cables</source>
      <translation>Kabel</translation>
    </message>
    <message>
      <source>Cables of {document}</source>
      <translation>Kabel von {document}</translation>
    </message>
    <message>
      <source>Centre of mass</source>
      <translation>Schwerpunkt</translation>
    </message>
    <message>
      <source>Centre x [mm]</source>
      <translation>Schwerpunkt x [mm]</translation>
    </message>
    <message>
      <source>Centre y [mm]</source>
      <translation>Schwerpunkt y [mm]</translation>
    </message>
    <message>
      <source>Centre z [mm]</source>
      <translation>Schwerpunkt z [mm]</translation>
    </message>
    <message>
      <source>Clearance [mm]</source>
      <translation>Freiraum [mm]</translation>
    </message>
    <message>
      <source>Clearance asked for</source>
      <translation>Verlangter Freiraum</translation>
    </message>
    <message>
      <source>Clearance is the least distance of the cable's surface to any visible solid and any other cable, where one is within 20 mm of it, except where the cable is held. Coordinates, forces and moments are in the coordinates of the document; forces and moments are those of the connectors and supports on the cable.</source>
      <translation>Der Freiraum ist der kleinste Abstand der Oberfläche des Kabels von sichtbaren Körpern und von anderen Kabeln, wo eines davon näher als 20 mm ist, außer dort, wo das Kabel gehalten wird. Koordinaten, Kräfte und Momente stehen in den Koordinaten des Dokuments; Kräfte und Momente sind die der Stecker und Halterungen auf das Kabel.</translation>
    </message>
    <message>
      <source>Clearance&lt;br&gt;[mm]</source>
      <translation>Freiraum&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Curvature [1/m] over the distance from the start [mm]; dashed: the spline route</source>
      <translation>Krümmung [1/m] über dem Abstand vom Anfang [mm]; gestrichelt: der Spline</translation>
    </message>
    <message>
      <source>Cut length</source>
      <translation>Schnittlänge</translation>
    </message>
    <message>
      <source>Cut length [mm]</source>
      <translation>Schnittlänge [mm]</translation>
    </message>
    <message>
      <source>Cut length&lt;br&gt;[mm]</source>
      <translation>Schnittlänge&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Error estimate</source>
      <translation>Geschätzter Fehler</translation>
    </message>
    <message>
      <source>Error estimate [mm]</source>
      <translation>Geschätzter Fehler [mm]</translation>
    </message>
    <message>
      <source>Error&lt;br&gt;[mm]</source>
      <translation>Fehler&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Fails</source>
      <translation>Hält nicht</translation>
    </message>
    <message>
      <source>Force [N]</source>
      <translation>Kraft [N]</translation>
    </message>
    <message>
      <source>Force at end [N]</source>
      <translation>Kraft am Ende [N]</translation>
    </message>
    <message>
      <source>Force at start [N]</source>
      <translation>Kraft am Anfang [N]</translation>
    </message>
    <message>
      <source>Forces and moments on the cable</source>
      <translation>Kräfte und Momente auf das Kabel</translation>
    </message>
    <message>
      <source>Holds</source>
      <translation>Hält</translation>
    </message>
    <message>
      <source>If the strands slip</source>
      <translation>Wenn die Litzen gleiten</translation>
    </message>
    <message>
      <source>If the strands stick</source>
      <translation>Wenn die Litzen haften</translation>
    </message>
    <message>
      <source>It bends to {radius} mm; {allowed} mm is allowed.</source>
      <translation>Es biegt sich auf {radius} mm; erlaubt sind {allowed} mm.</translation>
    </message>
    <message>
      <source>It does not stay in this shape.</source>
      <translation>Es bleibt nicht in dieser Form.</translation>
    </message>
    <message>
      <source>It enters {other} by {depth} mm.</source>
      <translation>Es dringt {depth} mm in {other} ein.</translation>
    </message>
    <message>
      <source>It holds, but with {stiffness} it bends to {radius} mm.</source>
      <translation>Es hält, aber mit {stiffness} biegt es sich auf {radius} mm.</translation>
    </message>
    <message>
      <source>It is out of date; recompute the document.</source>
      <translation>Es ist veraltet; das Dokument neu berechnen.</translation>
    </message>
    <message>
      <source>It is {distance} mm from {other}; its clearance is {clearance} mm.</source>
      <translation>Es ist {distance} mm von {other} entfernt; sein Freiraum ist {clearance} mm.</translation>
    </message>
    <message>
      <source>Its bend radius [mm]</source>
      <translation>Dessen Biegeradius [mm]</translation>
    </message>
    <message>
      <source>Its bend&lt;br&gt;radius [mm]</source>
      <translation>Dessen Biege-&lt;br&gt;radius [mm]</translation>
    </message>
    <message>
      <source>Its distance to {other} is not known: {reason}</source>
      <translation>Sein Abstand von {other} ist nicht bekannt: {reason}</translation>
    </message>
    <message>
      <source>Its shape at the bounds of its stiffness is not known: {error}</source>
      <translation>Seine Form an den Grenzen seiner Steifigkeit ist nicht bekannt: {error}</translation>
    </message>
    <message>
      <source>Largest end&lt;br&gt;force [N]</source>
      <translation>Größte Kraft am&lt;br&gt;Ende [N]</translation>
    </message>
    <message>
      <source>Largest end&lt;br&gt;moment [N m]</source>
      <translation>Größtes Moment am&lt;br&gt;Ende [N m]</translation>
    </message>
    <message>
      <source>Least clearance</source>
      <translation>Kleinster Freiraum</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>Length [mm]</source>
      <translation>Länge [mm]</translation>
    </message>
    <message>
      <source>Length between the terminals</source>
      <translation>Länge zwischen den Anschlüssen</translation>
    </message>
    <message>
      <source>Length&lt;br&gt;[mm]</source>
      <translation>Länge&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Margin</source>
      <translation>Reserve</translation>
    </message>
    <message>
      <source>Margin [%]</source>
      <translation>Reserve [%]</translation>
    </message>
    <message>
      <source>Margin [mm]</source>
      <translation>Reserve [mm]</translation>
    </message>
    <message>
      <source>Mass</source>
      <translation>Masse</translation>
    </message>
    <message>
      <source>Mass [g]</source>
      <translation>Masse [g]</translation>
    </message>
    <message>
      <source>Mass, and how it was solved</source>
      <translation>Masse, und wie gelöst wurde</translation>
    </message>
    <message>
      <source>Mass&lt;br&gt;[g]</source>
      <translation>Masse&lt;br&gt;[g]</translation>
    </message>
    <message>
      <source>Mode</source>
      <translation>Vorgabe</translation>
    </message>
    <message>
      <source>Model</source>
      <translation>Modell</translation>
    </message>
    <message>
      <source>Moment [N m]</source>
      <translation>Moment [N m]</translation>
    </message>
    <message>
      <source>Moment at end [N m]</source>
      <translation>Moment am Ende [N m]</translation>
    </message>
    <message>
      <source>Moment at start [N m]</source>
      <translation>Moment am Anfang [N m]</translation>
    </message>
    <message>
      <source>Not solved</source>
      <translation>Nicht gelöst</translation>
    </message>
    <message>
      <source>Of the spline route</source>
      <translation>Des Splines</translation>
    </message>
    <message>
      <source>Rounded up by</source>
      <translation>Aufgerundet um</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Querschnitt</translation>
    </message>
    <message>
      <source>Shortest and longest that will do</source>
      <translation>Kürzeste und längste, die genügen</translation>
    </message>
    <message>
      <source>Slack</source>
      <translation>Überlänge</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>Kleinster Biegeradius</translation>
    </message>
    <message>
      <source>Smallest bend radius [mm]</source>
      <translation>Kleinster Biegeradius [mm]</translation>
    </message>
    <message>
      <source>Smallest bend&lt;br&gt;radius [mm]</source>
      <translation>Kleinster Biege-&lt;br&gt;radius [mm]</translation>
    </message>
    <message>
      <source>Solve time [s]</source>
      <translation>Rechenzeit [s]</translation>
    </message>
    <message>
      <source>Solved in&lt;br&gt;[ms]</source>
      <translation>Gelöst in&lt;br&gt;[ms]</translation>
    </message>
    <message>
      <source>Spline route</source>
      <translation>Spline</translation>
    </message>
    <message>
      <source>Spline route [mm]</source>
      <translation>Spline [mm]</translation>
    </message>
    <message>
      <source>Spline route&lt;br&gt;[mm]</source>
      <translation>Spline&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Stays in this shape</source>
      <translation>Bleibt in dieser Form</translation>
    </message>
    <message>
      <source>Straight way [mm]</source>
      <translation>Gerader Weg [mm]</translation>
    </message>
    <message>
      <source>Straight way over the supports</source>
      <translation>Gerader Weg über die Halterungen</translation>
    </message>
    <message>
      <source>The document has no cables.</source>
      <translation>Das Dokument hat keine Kabel.</translation>
    </message>
    <message>
      <source>The spline route is the curve through the same terminals and supports that a drawing would show, without stiffness, weight and given length. Tolerances of the cut length are those of IPC/WHMA-A-620, Table 11-1, as an industry review draft has them.</source>
      <translation>Der Spline ist die Kurve durch dieselben Anschlüsse und Halterungen, die eine Zeichnung zeigen würde, ohne Steifigkeit, Gewicht und gegebene Länge. Toleranzen der Schnittlänge sind die der Tabelle 11-1 von IPC/WHMA-A-620, wie ein Entwurf zur Durchsicht in der Industrie sie hat.</translation>
    </message>
    <message>
      <source>The worst cable comes first: those without an answer, those that fail, those of which something is not known; among equals the smallest margin. The margin is by how much the smallest bend radius is above the allowed one, relative to that. Bend radii are those of the centreline.</source>
      <translation>Das schlechteste Kabel kommt zuerst: die ohne Lösung, die nicht halten, die, von denen etwas nicht bekannt ist; unter gleichen das mit der kleinsten Reserve. Die Reserve ist, um wie viel der kleinste Biegeradius über dem erlaubten liegt, bezogen auf diesen. Biegeradien sind die der Mittellinie.</translation>
    </message>
    <message>
      <source>Time of the solve</source>
      <translation>Rechenzeit</translation>
    </message>
    <message>
      <source>To be checked</source>
      <translation>Zu prüfen</translation>
    </message>
    <message>
      <source>Together: length {length} mm, cut length {cut} mm, mass {mass} g, centre of mass {centre} mm.</source>
      <translation>Zusammen: Länge {length} mm, Schnittlänge {cut} mm, Masse {mass} g, Schwerpunkt {centre} mm.</translation>
    </message>
    <message>
      <source>Type</source>
      <translation>Typ</translation>
    </message>
    <message>
      <source>Verdict</source>
      <translation>Urteil</translation>
    </message>
    <message>
      <source>What it says</source>
      <translation>Was dazu zu sagen ist</translation>
    </message>
    <message>
      <source>Where its numbers are from</source>
      <translation>Woher seine Zahlen sind</translation>
    </message>
    <message>
      <source>allowed</source>
      <translation>erlaubt</translation>
    </message>
    <message>
      <source>at [mm]</source>
      <translation>bei [mm]</translation>
    </message>
    <message>
      <source>checked</source>
      <translation>wird geprüft</translation>
    </message>
    <message>
      <source>en</source>
      <translation>de</translation>
    </message>
    <message>
      <source>enforced</source>
      <translation>wird eingehalten</translation>
    </message>
    <message>
      <source>no</source>
      <translation>nein</translation>
    </message>
    <message>
      <source>not known</source>
      <translation>nicht bekannt</translation>
    </message>
    <message>
      <source>nothing within 20 mm</source>
      <translation>nichts näher als 20 mm</translation>
    </message>
    <message>
      <source>of it x, y, z</source>
      <translation>davon x, y, z</translation>
    </message>
    <message>
      <source>straight</source>
      <translation>gerade</translation>
    </message>
    <message>
      <source>to</source>
      <translation>zu</translation>
    </message>
    <message>
      <source>to {residual}, relative</source>
      <translation>auf {residual}, relativ</translation>
    </message>
    <message>
      <source>yes</source>
      <translation>ja</translation>
    </message>
    <message>
      <source>{distance} to {nearest}</source>
      <translation>{distance} zu {nearest}</translation>
    </message>
    <message>
      <source>{obstacle}, at {place}</source>
      <translation>{obstacle}, bei {place}</translation>
    </message>
    <message>
      <source>{radius} at the centreline</source>
      <translation>{radius} an der Mittellinie</translation>
    </message>
    <message>
      <source>{radius} at the inside of the bend</source>
      <translation>{radius} an der Innenseite der Biegung</translation>
    </message>
    <message>
      <source>{radius} at {place}</source>
      <translation>{radius} bei {place}</translation>
    </message>
    <message>
      <source>{radius}, up to {distance} beside this shape</source>
      <translation>{radius}, bis zu {distance} neben dieser Form</translation>
    </message>
    <message>
      <source>{type} has no smallest bend radius to compare with.</source>
      <translation>{type} hat keinen kleinsten Biegeradius zum Vergleichen.</translation>
    </message>
    <message>
      <source>{what}, from a corner</source>
      <translation>{what}, von schräg oben</translation>
    </message>
    <message>
      <source>{what}, from above</source>
      <translation>{what}, von oben</translation>
    </message>
    <message>
      <source>{what}, from the front</source>
      <translation>{what}, von vorn</translation>
    </message>
    <message>
      <source>{what}, from the right</source>
      <translation>{what}, von rechts</translation>
    </message>
    <message>
      <source>… to {place}</source>
      <translation>… bis {place}</translation>
    </message>
  </context>
  <context>
    <name>Cable_Cable</name>
    <message>
      <source>Cable</source>
      <translation>Kabel</translation>
    </message>
    <message>
      <source>Runs a cable between two selected terminals, edges or faces</source>
      <translation>Führt ein Kabel zwischen zwei gewählten Anschlüssen, Kanten oder Flächen</translation>
    </message>
  </context>
  <context>
    <name>Cable_Check</name>
    <message>
      <source>Check All</source>
      <translation>Alles prüfen</translation>
    </message>
    <message>
      <source>Lists what the cables come near to: solids and each other, with distances and places</source>
      <translation>Listet auf, welchen Körpern und welchen anderen Kabeln die Kabel nahe kommen, mit Abständen und Stellen</translation>
    </message>
  </context>
  <context>
    <name>Cable_Clamp</name>
    <message>
      <source>Clamp</source>
      <translation>Klemme</translation>
    </message>
    <message>
      <source>Holds a cable and keeps it from twisting at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>Hält ein Kabel an der gewählten Kante oder Fläche und hindert es am Verdrehen, auf dem Weg des mit ausgewählten Kabels</translation>
    </message>
  </context>
  <context>
    <name>Cable_Clip</name>
    <message>
      <source>Clip</source>
      <translation>Clip</translation>
    </message>
    <message>
      <source>Grips a cable and lets it twist at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>Greift ein Kabel an der gewählten Kante oder Fläche und lässt es sich verdrehen, auf dem Weg des mit ausgewählten Kabels</translation>
    </message>
  </context>
  <context>
    <name>Cable_Example</name>
    <message>
      <source>Example</source>
      <translation>Beispiel</translation>
    </message>
    <message>
      <source>Opens an equipment panel with ten cables in a new document</source>
      <translation>Öffnet eine Gerätetafel mit zehn Kabeln in einem neuen Dokument</translation>
    </message>
  </context>
  <context>
    <name>Cable_Report</name>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Writes a page and a spreadsheet about all cables, the worst first</source>
      <translation>Schreibt eine Seite und eine Tabelle über alle Kabel, das schlimmste zuerst</translation>
    </message>
  </context>
  <context>
    <name>Cable_Ring</name>
    <message>
      <source>Leads a cable through a round hole at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>Führt ein Kabel an der gewählten Kante oder Fläche durch ein rundes Loch, auf dem Weg des mit ausgewählten Kabels</translation>
    </message>
    <message>
      <source>Ring</source>
      <translation>Ring</translation>
    </message>
  </context>
  <context>
    <name>Cable_Route</name>
    <message>
      <source>Comparison Route</source>
      <translation>Vergleichsweg</translation>
    </message>
    <message>
      <source>Draws a curve without mechanics beside the selected cable, to compare with</source>
      <translation>Zeichnet neben das gewählte Kabel zum Vergleich eine Kurve ohne Mechanik</translation>
    </message>
  </context>
  <context>
    <name>Cable_Shortest</name>
    <message>
      <source>Gives the selected cable the least length that keeps its bend radius and clearance</source>
      <translation>Gibt dem gewählten Kabel die kürzeste Länge, die Biegeradius und Freiraum einhält</translation>
    </message>
    <message>
      <source>Shortest Length</source>
      <translation>Kürzeste Länge</translation>
    </message>
  </context>
  <context>
    <name>Cable_Sleeve</name>
    <message>
      <source>Guides a cable in a direction and lets it twist at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>Führt ein Kabel an der gewählten Kante oder Fläche in einer Richtung und lässt es sich verdrehen, auf dem Weg des mit ausgewählten Kabels</translation>
    </message>
    <message>
      <source>Sleeve</source>
      <translation>Hülse</translation>
    </message>
  </context>
  <context>
    <name>Cable_Study</name>
    <message>
      <source>Makes a study of the selected cable, or runs the one that is selected</source>
      <translation>Macht eine Studie des gewählten Kabels oder lässt die gewählte laufen</translation>
    </message>
    <message>
      <source>Study</source>
      <translation>Studie</translation>
    </message>
  </context>
  <context>
    <name>Cable_Terminal</name>
    <message>
      <source>Cable Terminal</source>
      <translation>Kabelanschluss</translation>
    </message>
    <message>
      <source>Holds the end of a cable at the selected edge or face</source>
      <translation>Hält das Ende eines Kabels an der gewählten Kante oder Fläche</translation>
    </message>
  </context>
  <context>
    <name>Sentence</name>
    <message>
      <source>, and neither mesh nor time allowed more</source>
      <translation>, und weder Netz noch Zeit ließen mehr zu</translation>
    </message>
    <message>
      <source>, line 1: {1}; the columns are {2}</source>
      <translation>, Zeile 1: {1}; die Spalten sind {2}</translation>
    </message>
    <message>
      <source>, line {1}</source>
      <translation>, Zeile {1}</translation>
    </message>
    <message>
      <source>, or empty</source>
      <translation>, oder leer</translation>
    </message>
    <message>
      <source>, with elements fixed</source>
      <translation>, bei vorgegebenen Elementen</translation>
    </message>
    <message>
      <source>.</source>
      <translation>.</translation>
    </message>
    <message>
      <source>. </source>
      <translation>. </translation>
    </message>
    <message>
      <source>: </source>
      <translation>: </translation>
    </message>
    <message>
      <source>An equilibrium was found, but not to the tolerance asked for</source>
      <translation>Ein Gleichgewicht wurde gefunden, aber nicht mit der verlangten Genauigkeit</translation>
    </message>
    <message>
      <source>At {1} the cable is {2} nearer to {3} than {4} allows</source>
      <translation>Bei {1} ist das Kabel um {2} näher an {3}, als {4} erlaubt</translation>
    </message>
    <message>
      <source>Begins to buckle {1}</source>
      <translation>Beginnt auszuknicken, {1}</translation>
    </message>
    <message>
      <source>BendingStiffness lies outside of SlipBendingStiffness and StickBendingStiffness</source>
      <translation>BendingStiffness liegt nicht zwischen SlipBendingStiffness und StickBendingStiffness</translation>
    </message>
    <message>
      <source>CasADi is not installed, so no cable can be solved; what was solved before can still be seen. Install it with: {1} casadi</source>
      <translation>CasADi ist nicht installiert, daher kann kein Kabel gelöst werden; was schon gelöst ist, bleibt zu sehen. Installieren mit: {1} casadi</translation>
    </message>
    <message>
      <source>Check lengths, stiffness and mass for a wrong unit</source>
      <translation>Längen, Steifigkeit und Masse auf eine falsche Einheit prüfen</translation>
    </message>
    <message>
      <source>Check lengths, stiffness and mass for a wrong unit; a different length may be easier</source>
      <translation>Längen, Steifigkeit und Masse auf eine falsche Einheit prüfen; eine andere Länge mag leichter sein</translation>
    </message>
    <message>
      <source>Diameter {1} mm, {2} g/m, {3}, GJ {4} N m²</source>
      <translation>Durchmesser {1} mm, {2} g/m, {3}, GJ {4} N m²</translation>
    </message>
    <message>
      <source>EI {1} and {2} N m²</source>
      <translation>EI {1} und {2} N m²</translation>
    </message>
    <message>
      <source>Edge{1} of {2}</source>
      <translation>Edge{1} von {2}</translation>
    </message>
    <message>
      <source>Face{1} of {2}</source>
      <translation>Face{1} von {2}</translation>
    </message>
    <message>
      <source>Found anew: no equilibrium was found that the last shape becomes</source>
      <translation>Neu gefunden: es wurde kein Gleichgewicht gefunden, in das die letzte Form übergeht</translation>
    </message>
    <message>
      <source>From {1} mm to {2} mm it keeps its bend radius only if it is formed there, with a moment of {3} N m</source>
      <translation>Von {1} mm bis {2} mm hält es seinen Biegeradius nur ein, wenn es dort geformt wird, mit einem Moment von {3} N m</translation>
    </message>
    <message>
      <source>From {1} to {2} no length was found at which it is in equilibrium. At {3}: {4}</source>
      <translation>Von {1} bis {2} wurde keine Länge gefunden, bei der es im Gleichgewicht ist. Bei {3}: {4}</translation>
    </message>
    <message>
      <source>If {1} than {2}, {3}</source>
      <translation>Wenn {1} als {2}: {3}</translation>
    </message>
    <message>
      <source>It bends to {1} at {2}; the limit is {3}</source>
      <translation>Es biegt sich auf {1} bei {2}; die Grenze ist {3}</translation>
    </message>
    <message>
      <source>It is {1} s</source>
      <translation>Sie beträgt {1} s</translation>
    </message>
    <message>
      <source>It may be too short to get past the obstacles, or have no way between them: try it longer, or with some of them left out</source>
      <translation>Es ist vielleicht zu kurz, um an den Hindernissen vorbeizukommen, oder findet keinen Weg zwischen ihnen: länger versuchen, oder ohne einige von ihnen</translation>
    </message>
    <message>
      <source>It must be pushed from {1} at {2} to keep {3} clear</source>
      <translation>Es muss bei {2} von {1} weggedrückt werden, um {3} Freiraum zu halten</translation>
    </message>
    <message>
      <source>Its length is only {1} % above the chord; give it more slack</source>
      <translation>Seine Länge ist nur {1} % größer als der gerade Abstand; ihm mehr Überlänge geben</translation>
    </message>
    <message>
      <source>Its spreadsheet is not there; Run Study writes it anew</source>
      <translation>Ihre Tabelle ist nicht da; der Befehl „Studie“ schreibt sie neu</translation>
    </message>
    <message>
      <source>Jumps to another equilibrium {1}; its shape changes by {2} of the length</source>
      <translation>Springt in ein anderes Gleichgewicht, {1}; seine Form ändert sich um {2} der Länge</translation>
    </message>
    <message>
      <source>Kept: {1}</source>
      <translation>Berücksichtigt: {1}</translation>
    </message>
    <message>
      <source>Left out: {1}</source>
      <translation>Weggelassen: {1}</translation>
    </message>
    <message>
      <source>No length up to {1} will do. The best is {2}, but {3}; a limit that this length keeps, other ends or supports, or a softer cable would help</source>
      <translation>Keine Länge bis {1} genügt. Am besten ist {2}, aber {3}; eine Grenze, die diese Länge einhält, andere Enden oder Halterungen oder ein weicheres Kabel würden helfen</translation>
    </message>
    <message>
      <source>No length will do everywhere. {1}</source>
      <translation>Keine Länge genügt überall. {1}</translation>
    </message>
    <message>
      <source>No length will do everywhere: {1} needs {2}, and {3} allows {4}</source>
      <translation>Keine Länge genügt überall: {1} braucht {2}, und {3} erlaubt {4}</translation>
    </message>
    <message>
      <source>No results yet; Run Study makes them</source>
      <translation>Noch keine Ergebnisse; der Befehl „Studie“ macht sie</translation>
    </message>
    <message>
      <source>No shape of this cable satisfies all requirements</source>
      <translation>Keine Form dieses Kabels erfüllt alle Anforderungen</translation>
    </message>
    <message>
      <source>No shape yet</source>
      <translation>Noch keine Form</translation>
    </message>
    <message>
      <source>No shape yet: {1} cannot be computed ({2})</source>
      <translation>Noch keine Form: {1} kann nicht berechnet werden ({2})</translation>
    </message>
    <message>
      <source>Out of date</source>
      <translation>Veraltet</translation>
    </message>
    <message>
      <source>Out of date: {1} cannot be computed ({2}). Shape and numbers are from before; mend it</source>
      <translation>Veraltet: {1} kann nicht berechnet werden ({2}). Form und Zahlen sind von vorher; es in Ordnung bringen</translation>
    </message>
    <message>
      <source>Out of date; Run Study brings it up to date</source>
      <translation>Veraltet; der Befehl „Studie“ bringt sie auf den neuesten Stand</translation>
    </message>
    <message>
      <source>Recomputed from its nodes, its moments are out of balance by {1}</source>
      <translation>Aus den Knoten nachgerechnet, sind seine Momente um {1} nicht im Gleichgewicht</translation>
    </message>
    <message>
      <source>Row {1} is the worst: {2}</source>
      <translation>Zeile {1} ist die schlimmste: {2}</translation>
    </message>
    <message>
      <source>Solved by {1}, scheme {2}, {3} elements</source>
      <translation>Gelöst mit {1}, Schema {2}, {3} Elemente</translation>
    </message>
    <message>
      <source>The arc length of node {1} is less than that of node {2}</source>
      <translation>Die Bogenlänge von Knoten {1} ist kleiner als die von Knoten {2}</translation>
    </message>
    <message>
      <source>The cable bends to a radius of {1} mm at {2} mm from its start, and its section reaches farther than that to the inside of the bend: its surface would fold</source>
      <translation>Das Kabel biegt sich {2} mm nach seinem Anfang auf einen Radius von {1} mm, und sein Querschnitt reicht weiter nach innen: seine Oberfläche würde sich falten</translation>
    </message>
    <message>
      <source>The cable has {1} node(s); a shape needs at least 2</source>
      <translation>Das Kabel hat {1} Knoten; eine Form braucht mindestens 2</translation>
    </message>
    <message>
      <source>The cable is in equilibrium</source>
      <translation>Das Kabel ist im Gleichgewicht</translation>
    </message>
    <message>
      <source>The cable is {1} mm long; a shape needs at least {2} mm</source>
      <translation>Das Kabel ist {1} mm lang; eine Form braucht mindestens {2} mm</translation>
    </message>
    <message>
      <source>The cable passes through itself: its points at {1} mm and {2} mm from its start are {3} mm apart</source>
      <translation>Das Kabel geht durch sich selbst: seine Punkte {1} mm und {2} mm nach seinem Anfang liegen {3} mm auseinander</translation>
    </message>
    <message>
      <source>The cable runs through itself at {1} and {2}, {3} deep, and no equilibrium was found in which it does not; change its length or what holds it</source>
      <translation>Das Kabel geht bei {1} und {2} durch sich selbst, {3} tief, und es wurde kein Gleichgewicht gefunden, in dem es das nicht tut; seine Länge ändern oder was es hält</translation>
    </message>
    <message>
      <source>The cable slides through {1} until nothing is left on one side of it; give that support an arc length, or hold the cable elsewhere</source>
      <translation>Das Kabel gleitet durch {1}, bis auf einer Seite nichts mehr übrig ist; dieser Halterung eine Position geben oder das Kabel anderswo halten</translation>
    </message>
    <message>
      <source>The cable turns by {1} rad between its nodes {2} and {3}; a shape needs less than {4} rad. Solve with more elements</source>
      <translation>Das Kabel dreht sich um {1} rad zwischen seinen Knoten {2} und {3}; eine Form braucht weniger als {4} rad. Mit mehr Elementen lösen</translation>
    </message>
    <message>
      <source>The cable's shape would have {1} times the volume of its length. Solve with more elements</source>
      <translation>Die Form des Kabels hätte das {1}-Fache des Volumens seiner Länge. Mit mehr Elementen lösen</translation>
    </message>
    <message>
      <source>The envelope is open between {1} and {2}: there shapes next to each other are up to {3} mm apart</source>
      <translation>Die Hülle ist zwischen {1} und {2} offen: dort liegen benachbarte Formen bis zu {3} mm auseinander</translation>
    </message>
    <message>
      <source>The position error is estimated at {1} of the length; {2} was asked for</source>
      <translation>Der Fehler der Lage wird auf {1} der Länge geschätzt; verlangt war {2}</translation>
    </message>
    <message>
      <source>The positions, tangents and arc lengths of the nodes do not belong together: two nodes are {1} mm apart and should be {2} mm apart</source>
      <translation>Positionen, Tangenten und Bogenlängen der Knoten gehören nicht zusammen: zwei Knoten sind {1} mm auseinander und sollten {2} mm auseinander sein</translation>
    </message>
    <message>
      <source>The profile crosses or touches itself, so it bounds no section</source>
      <translation>Das Profil kreuzt oder berührt sich selbst und begrenzt daher keinen Querschnitt</translation>
    </message>
    <message>
      <source>The profile does not lie in its own xy-plane: z runs from {1} mm to {2} mm and must be 0</source>
      <translation>Das Profil liegt nicht in seiner eigenen xy-Ebene: z reicht von {1} mm bis {2} mm und muss 0 sein</translation>
    </message>
    <message>
      <source>The profile has {1} faces; it must have one</source>
      <translation>Das Profil hat {1} Flächen; es muss eine haben</translation>
    </message>
    <message>
      <source>The profile has {1} separate parts; it must have one (holes are allowed)</source>
      <translation>Das Profil hat {1} getrennte Teile; es muss eines haben (Löcher sind erlaubt)</translation>
    </message>
    <message>
      <source>The profile is empty; it must be a closed planar outline</source>
      <translation>Das Profil ist leer; es muss ein geschlossener ebener Umriss sein</translation>
    </message>
    <message>
      <source>The profile is not closed; its edges must form closed outlines</source>
      <translation>Das Profil ist nicht geschlossen; seine Kanten müssen geschlossene Umrisse bilden</translation>
    </message>
    <message>
      <source>The profile is {1} mm across; it must be at least {2} mm</source>
      <translation>Das Profil ist {1} mm groß; es müssen mindestens {2} mm sein</translation>
    </message>
    <message>
      <source>The quaternion of node {1} has the length {2}; it must be 1</source>
      <translation>Die Quaternion von Knoten {1} hat die Länge {2}; sie muss 1 sein</translation>
    </message>
    <message>
      <source>The radius is {1} mm; it must be at least {2} mm</source>
      <translation>Der Radius ist {1} mm; er muss mindestens {2} mm sein</translation>
    </message>
    <message>
      <source>The reference is {1}; it must be an object, or a pair of an object and the name of its edge or face, as in (connector, 'Edge7')</source>
      <translation>Die Referenz ist {1}; sie muss ein Objekt sein oder ein Paar aus einem Objekt und dem Namen seiner Kante oder Fläche, wie in (connector, 'Edge7')</translation>
    </message>
    <message>
      <source>The report cannot be written: {1}: {2}; choose another folder</source>
      <translation>Der Bericht kann nicht geschrieben werden: {1}: {2}; einen anderen Ordner wählen</translation>
    </message>
    <message>
      <source>The shape found is an equilibrium but not a stable one: the cable would leave it</source>
      <translation>Die gefundene Form ist ein Gleichgewicht, aber kein stabiles: das Kabel würde sie verlassen</translation>
    </message>
    <message>
      <source>The shape it ended with is not held as its ends and supports say</source>
      <translation>Die Form, mit der er endete, ist nicht so gehalten, wie Enden und Halterungen es verlangen</translation>
    </message>
    <message>
      <source>The solid of the cable could not be built: {1}</source>
      <translation>Der Körper des Kabels konnte nicht gebildet werden: {1}</translation>
    </message>
    <message>
      <source>The solid of the cable is not valid and closed</source>
      <translation>Der Körper des Kabels ist nicht gültig und geschlossen</translation>
    </message>
    <message>
      <source>The solver found no equilibrium</source>
      <translation>Der Löser hat kein Gleichgewicht gefunden</translation>
    </message>
    <message>
      <source>The stretch {1}: {2}</source>
      <translation>Das Stück {1}: {2}</translation>
    </message>
    <message>
      <source>The time limit was reached before an equilibrium was found</source>
      <translation>Die Zeitgrenze war erreicht, bevor ein Gleichgewicht gefunden wurde</translation>
    </message>
    <message>
      <source>The {1} of node {2} are not finite numbers</source>
      <translation>Die {1} von Knoten {2} sind keine endlichen Zahlen</translation>
    </message>
    <message>
      <source>The {1} of the nodes have the shape {2}; it must be {3}</source>
      <translation>Die {1} der Knoten haben die Form {2}; es muss {3} sein</translation>
    </message>
    <message>
      <source>There is no solved shape to draw. Solve the cable first</source>
      <translation>Es gibt keine gelöste Form zu zeichnen. Zuerst das Kabel lösen</translation>
    </message>
    <message>
      <source>This CasADi has no plug-in {1}; install the casadi wheel from PyPI</source>
      <translation>Dieses CasADi hat keine Erweiterung {1}; das Paket casadi von PyPI installieren</translation>
    </message>
    <message>
      <source>Update is {1}; Solve Now brings it up to date</source>
      <translation>Update ist {1}; „Jetzt lösen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>Vertex{1} of {2}</source>
      <translation>Vertex{1} von {2}</translation>
    </message>
    <message>
      <source>Warning</source>
      <translation>Warnung</translation>
    </message>
    <message>
      <source>a cable, which is taken as rigid: pushed with up to {1} N at a place, and that does not move it</source>
      <translation>ein Kabel, das als starr gilt: es wird mit bis zu {1} N an einer Stelle gedrückt und bewegt sich dadurch nicht</translation>
    </message>
    <message>
      <source>a list of lists of 3 whole numbers</source>
      <translation>eine Liste von Listen mit 3 ganzen Zahlen</translation>
    </message>
    <message>
      <source>a number with the unit {1}</source>
      <translation>eine Zahl mit der Einheit {1}</translation>
    </message>
    <message>
      <source>a plain number</source>
      <translation>eine Zahl ohne Einheit</translation>
    </message>
    <message>
      <source>a spline needs two points or more, each apart from the one before</source>
      <translation>ein Spline braucht zwei oder mehr Punkte, jeden getrennt vom vorigen</translation>
    </message>
    <message>
      <source>all that holds the cable, but for one clamp at most, lets it twist</source>
      <translation>alles, was das Kabel hält, bis auf höchstens eine Klemme, lässt es sich verdrehen</translation>
    </message>
    <message>
      <source>an end is free</source>
      <translation>ein Ende ist frei</translation>
    </message>
    <message>
      <source>arc lengths</source>
      <translation>Bogenlängen</translation>
    </message>
    <message>
      <source>are all {1}; at least two must differ</source>
      <translation>sind alle {1}; mindestens zwei müssen sich unterscheiden</translation>
    </message>
    <message>
      <source>are empty; name what varies</source>
      <translation>sind leer; angeben, was sich ändert</translation>
    </message>
    <message>
      <source>are {1}, but none has an area: all corners of each are on one line or at one point</source>
      <translation>sind {1}, aber keines hat eine Fläche: alle Ecken liegen jeweils auf einer Geraden oder in einem Punkt</translation>
    </message>
    <message>
      <source>are {1}, which have {2} corners; at most {3} can be tried; draw cases at random instead</source>
      <translation>sind {1} mit {2} Ecken; höchstens {3} können versucht werden; stattdessen zufällige Fälle ziehen</translation>
    </message>
    <message>
      <source>are {1}; at most {2} can be solved; divide the cable at a clamp</source>
      <translation>sind {1}; höchstens {2} können gelöst werden; das Kabel an einer Klemme teilen</translation>
    </message>
    <message>
      <source>asks for a length, but {1}, so that any will do; give one</source>
      <translation>fragt nach einer Länge, aber {1}, sodass jede genügt; eine angeben</translation>
    </message>
    <message>
      <source>at least {1} lists of 3 numbers</source>
      <translation>mindestens {1} Listen mit 3 Zahlen</translation>
    </message>
    <message>
      <source>at the centreline</source>
      <translation>an der Mittellinie</translation>
    </message>
    <message>
      <source>at the inside of the bend</source>
      <translation>innen an der Biegung</translation>
    </message>
    <message>
      <source>at {1} it is held {2} mm inside {3}; two cables do not fit there, so hold one of them beside the other</source>
      <translation>an der Stelle „{1}“ wird es {2} mm im Inneren von {3} gehalten; zwei Kabel passen dort nicht hin, daher eines neben dem anderen halten</translation>
    </message>
    <message>
      <source>bend radius</source>
      <translation>Biegeradius</translation>
    </message>
    <message>
      <source>bending</source>
      <translation>Biegung</translation>
    </message>
    <message>
      <source>bending in two directions</source>
      <translation>Biegung in zwei Richtungen</translation>
    </message>
    <message>
      <source>between {1} and {2}</source>
      <translation>zwischen {1} und {2}</translation>
    </message>
    <message>
      <source>both ends are free and every support lets the cable slide, so it would slide out; hold an end or give a support an arc length</source>
      <translation>beide Enden sind frei, und jede Halterung lässt das Kabel gleiten, so dass es herausrutschen würde; ein Ende halten oder einer Halterung eine Position geben</translation>
    </message>
    <message>
      <source>both ends are free, so nothing holds the cable; hold one of them</source>
      <translation>beide Enden sind frei, also hält nichts das Kabel; eines davon halten</translation>
    </message>
    <message>
      <source>do not part inside from outside at the edge from {1} to {2}: the triangles there do not all have the same side out, or one is missing; turn or add triangles</source>
      <translation>trennen an der Kante von {1} nach {2} nicht innen von außen: die Dreiecke dort haben nicht alle dieselbe Seite außen, oder eines fehlt; Dreiecke umdrehen oder ergänzen</translation>
    </message>
    <message>
      <source>enclose {1} m³, which must be positive: they are clockwise seen from outside, or a sheet that is there twice; reverse each of them, or leave one layer out</source>
      <translation>umschließen {1} m³, was positiv sein muss: sie laufen von außen gesehen im Uhrzeigersinn, oder es ist ein doppeltes Blatt; jedes umdrehen oder eine Lage weglassen</translation>
    </message>
    <message>
      <source>end</source>
      <translation>Ende</translation>
    </message>
    <message>
      <source>fatrop or ipopt</source>
      <translation>fatrop oder ipopt</translation>
    </message>
    <message>
      <source>gravity</source>
      <translation>Schwerkraft</translation>
    </message>
    <message>
      <source>gravity: there is none, or the cable has no mass (exact)</source>
      <translation>Schwerkraft: es gibt keine, oder das Kabel hat keine Masse (exakt)</translation>
    </message>
    <message>
      <source>has a column {1}</source>
      <translation>hat eine Spalte {1}</translation>
    </message>
    <message>
      <source>has more or fewer values than columns; put text with commas in quotes</source>
      <translation>hat mehr oder weniger Werte als Spalten; Text mit Kommas in Anführungszeichen setzen</translation>
    </message>
    <message>
      <source>has no column {1}</source>
      <translation>hat keine Spalte {1}</translation>
    </message>
    <message>
      <source>has no one set of equilibria; give a length, and ask for each stretch alone</source>
      <translation>hat nicht nur eine Menge von Gleichgewichten; eine Länge angeben und nach jedem Stück einzeln fragen</translation>
    </message>
    <message>
      <source>has no value at which the cable can be solved</source>
      <translation>hat keinen Wert, bei dem das Kabel gelöst werden kann</translation>
    </message>
    <message>
      <source>has {1}</source>
      <translation>enthält {1}</translation>
    </message>
    <message>
      <source>has {1} entries; it takes one, or a vertex and a local coordinate system</source>
      <translation>hat {1} Einträge; es braucht einen, oder einen Punkt und ein lokales Koordinatensystem</translation>
    </message>
    <message>
      <source>has {1} of {2}, which was deleted or moved</source>
      <translation>enthält {1} von {2}, das gelöscht oder verschoben wurde</translation>
    </message>
    <message>
      <source>has {1} rows; it must have at least {2}</source>
      <translation>hat {1} Zeilen; es müssen mindestens {2} sein</translation>
    </message>
    <message>
      <source>has {1} twice; a cable passes a support once</source>
      <translation>enthält {1} zweimal; ein Kabel läuft nur einmal durch eine Halterung</translation>
    </message>
    <message>
      <source>has {1}, which follows from the cable itself, so neither can be first; of two cables, only one can have the other as an obstacle</source>
      <translation>enthält {1}, das aus dem Kabel selbst folgt, so dass keines das erste sein kann; von zwei Kabeln kann nur eines das andere als Hindernis haben</translation>
    </message>
    <message>
      <source>has {1}, which has no solid; choose parts with solids</source>
      <translation>enthält {1}, das keinen Körper hat; Teile mit Körpern wählen</translation>
    </message>
    <message>
      <source>has {1}, which is in another part or assembly than the cable; put both into the same</source>
      <translation>enthält {1}, das in einem anderen Teil oder einer anderen Baugruppe als das Kabel ist; beide in dieselbe legen</translation>
    </message>
    <message>
      <source>has {1}, which is no column; known are {2}</source>
      <translation>hat {1}, was keine Spalte ist; bekannt sind {2}</translation>
    </message>
    <message>
      <source>has {1}, which is no support; choose clamps, sleeves, rings or clips</source>
      <translation>enthält {1}, das keine Halterung ist; Klemmen, Hülsen, Ringe oder Clips wählen</translation>
    </message>
    <message>
      <source>has {1}; it may have {2}</source>
      <translation>enthält {1}; erlaubt sind {2}</translation>
    </message>
    <message>
      <source>has {1}; they must be finite numbers</source>
      <translation>hat {1}; es müssen endliche Zahlen sein</translation>
    </message>
    <message>
      <source>is Enforce, but {1} has no limit; set its MinBendRadius, or use Check</source>
      <translation>ist Enforce, aber {1} hat keine Grenze; dessen MinBendRadius setzen oder Check verwenden</translation>
    </message>
    <message>
      <source>is Shortest. {1}</source>
      <translation>ist Shortest. {1}</translation>
    </message>
    <message>
      <source>is an array {1} of {2}; it must be {3}</source>
      <translation>ist ein Feld {1} aus {2}; es muss {3} sein</translation>
    </message>
    <message>
      <source>is empty</source>
      <translation>ist leer</translation>
    </message>
    <message>
      <source>is empty: its object was deleted or never chosen. Choose an edge, a face or an object</source>
      <translation>ist leer: das Objekt wurde gelöscht oder nie gewählt. Eine Kante, eine Fläche oder ein Objekt wählen</translation>
    </message>
    <message>
      <source>is empty: the cable was deleted; delete this too or choose another</source>
      <translation>ist leer: das Kabel wurde gelöscht; dies auch löschen oder ein anderes wählen</translation>
    </message>
    <message>
      <source>is empty; choose a terminal. One that is Free lets the end hang</source>
      <translation>ist leer; einen Anschluss wählen. Einer mit Free lässt das Ende hängen</translation>
    </message>
    <message>
      <source>is empty; every type needs one</source>
      <translation>ist leer; jeder Typ braucht einen</translation>
    </message>
    <message>
      <source>is empty; it must have at least 1 row</source>
      <translation>ist leer; es muss mindestens 1 Zeile haben</translation>
    </message>
    <message>
      <source>is empty; name a number, as Length</source>
      <translation>ist leer; eine Zahl nennen, etwa Length</translation>
    </message>
    <message>
      <source>is free; a route needs both ends held</source>
      <translation>ist frei; ein Weg braucht zwei gehaltene Enden</translation>
    </message>
    <message>
      <source>is missing</source>
      <translation>fehlt</translation>
    </message>
    <message>
      <source>is not given, so it cannot be enforced; give it</source>
      <translation>ist nicht angegeben und kann daher nicht erzwungen werden; es angeben</translation>
    </message>
    <message>
      <source>is not known here; known are {1}</source>
      <translation>ist hier nicht bekannt; bekannt sind {1}</translation>
    </message>
    <message>
      <source>is off, and there is no other tolerance; give one</source>
      <translation>ist aus, und es gibt keine andere Toleranz; eine angeben</translation>
    </message>
    <message>
      <source>is on, but an end is free, so that any length would do; turn it off, or hold both ends</source>
      <translation>ist an, aber ein Ende ist frei, sodass jede Länge recht wäre; ausschalten oder beide Enden halten</translation>
    </message>
    <message>
      <source>is that of the start; a chord needs two points</source>
      <translation>ist die des Anfangs; eine Sehne braucht zwei Punkte</translation>
    </message>
    <message>
      <source>is zero; a catenary needs a direction to hang in</source>
      <translation>ist null; eine Kettenlinie braucht eine Richtung, in die sie hängt</translation>
    </message>
    <message>
      <source>is {1} and so is From; give a range, or Values</source>
      <translation>ist {1}, und From ebenso; einen Bereich angeben oder Values</translation>
    </message>
    <message>
      <source>is {1} and so is Start; choose two different terminals</source>
      <translation>ist {1}, und Start ebenso; zwei verschiedene Anschlüsse wählen</translation>
    </message>
    <message>
      <source>is {1} and the ends are {2} apart, which leaves no slack; an inextensible cable needs at least {3}, or give it an axial stiffness</source>
      <translation>ist {1}, und die Enden sind {2} auseinander, was keine Überlänge lässt; ein undehnbares Kabel braucht mindestens {3}, oder ihm eine Dehnsteifigkeit geben</translation>
    </message>
    <message>
      <source>is {1} away from {2}, but the cable has only {3} on this side of it, so it does not reach; the cable must be longer or the support nearer</source>
      <translation>ist {1} von {2} entfernt, aber das Kabel hat auf dieser Seite nur {3} und reicht daher nicht; das Kabel muss länger oder die Halterung näher sein</translation>
    </message>
    <message>
      <source>is {1} mm; it must be greater than 0 mm, or let the cable slide (Slides)</source>
      <translation>ist {1} mm; es muss größer als 0 mm sein, oder das Kabel gleiten lassen (Slides)</translation>
    </message>
    <message>
      <source>is {1} mm; it must be less than the radius of {2} mm</source>
      <translation>ist {1} mm; es muss kleiner als der Radius von {2} mm sein</translation>
    </message>
    <message>
      <source>is {1} s; it must be greater than 0</source>
      <translation>ist {1} s; es muss größer als 0 sein</translation>
    </message>
    <message>
      <source>is {1}, but the cable's radius is {2}, so it does not pass; take a wider ring or a thinner cable</source>
      <translation>ist {1}, aber der Radius des Kabels ist {2}, so dass es nicht hindurchpasst; einen weiteren Ring oder ein dünneres Kabel nehmen</translation>
    </message>
    <message>
      <source>is {1}, but the points are {2} apart; make it at least that</source>
      <translation>ist {1}, aber die Punkte sind {2} auseinander; sie mindestens so groß machen</translation>
    </message>
    <message>
      <source>is {1}, but the terminals are {2} apart; the shortest possible length is {3}. Make the cable longer or bring the terminals closer</source>
      <translation>ist {1}, aber die Anschlüsse sind {2} auseinander; die kürzeste mögliche Länge ist {3}. Das Kabel länger machen oder die Anschlüsse näher zusammenbringen</translation>
    </message>
    <message>
      <source>is {1}, but {2} before it is at {3}; supports must be in order along the cable</source>
      <translation>ist {1}, aber {2} davor ist bei {3}; Halterungen müssen in ihrer Reihenfolge entlang des Kabels stehen</translation>
    </message>
    <message>
      <source>is {1}, but {2}, so there is no straight distance; use Fixed</source>
      <translation>ist {1}, aber {2}, daher gibt es keinen geraden Abstand; Fixed verwenden</translation>
    </message>
    <message>
      <source>is {1}, but {2}; the shortest possible length is {3}</source>
      <translation>ist {1}, aber {2}; die kürzeste mögliche Länge ist {3}</translation>
    </message>
    <message>
      <source>is {1}, which does not change the cable; choose a number that it depends on</source>
      <translation>ist {1}, was das Kabel nicht verändert; eine Zahl wählen, von der es abhängt</translation>
    </message>
    <message>
      <source>is {1}, which is in another part or assembly than the cable; put both into the same</source>
      <translation>ist {1}, das in einem anderen Teil oder einer anderen Baugruppe als das Kabel ist; beide in dieselbe legen</translation>
    </message>
    <message>
      <source>is {1}, which is no cable terminal; choose a terminal</source>
      <translation>ist {1}, das kein Kabelanschluss ist; einen Anschluss wählen</translation>
    </message>
    <message>
      <source>is {1}, which is no cable type</source>
      <translation>ist {1}, das kein Kabeltyp ist</translation>
    </message>
    <message>
      <source>is {1}, which is no cable; choose a cable</source>
      <translation>ist {1}, das kein Kabel ist; ein Kabel wählen</translation>
    </message>
    <message>
      <source>is {1}, which is not on the cable; its length is {2}</source>
      <translation>ist {1} und damit nicht auf dem Kabel; dessen Länge ist {2}</translation>
    </message>
    <message>
      <source>is {1}; it must be a finite number, at most {2} in size</source>
      <translation>ist {1}; es muss eine endliche Zahl vom Betrag höchstens {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a list of 3 numbers</source>
      <translation>ist {1}; es muss eine Liste von 3 Zahlen sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a list of {2} numbers</source>
      <translation>ist {1}; es muss eine Liste von {2} Zahlen sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a number greater than 0 and at most {2}</source>
      <translation>ist {1}; es muss eine Zahl größer als 0 und höchstens {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a number{2}</source>
      <translation>ist {1}; es muss eine Zahl{2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a whole number</source>
      <translation>ist {1}; es muss eine ganze Zahl sein</translation>
    </message>
    <message>
      <source>is {1}; it must be a whole number from {2}</source>
      <translation>ist {1}; es muss eine ganze Zahl ab {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be an object</source>
      <translation>ist {1}; es muss ein Objekt sein</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 0</source>
      <translation>ist {1}; es muss mindestens 0 sein</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 1</source>
      <translation>ist {1}; es muss mindestens 1 sein</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 2</source>
      <translation>ist {1}; es muss mindestens 2 sein</translation>
    </message>
    <message>
      <source>is {1}; it must be at least {2}</source>
      <translation>ist {1}; es muss mindestens {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be between 1e-10 and 0.1</source>
      <translation>ist {1}; es muss zwischen 1e-10 und 0.1 liegen</translation>
    </message>
    <message>
      <source>is {1}; it must be between 2 and 10000</source>
      <translation>ist {1}; es muss zwischen 2 und 10000 liegen</translation>
    </message>
    <message>
      <source>is {1}; it must be from 0 to {2}, as there are {3} {4}</source>
      <translation>ist {1}; es muss von 0 bis {2} sein, denn es gibt {3} {4}</translation>
    </message>
    <message>
      <source>is {1}; it must be greater than 0</source>
      <translation>ist {1}; es muss größer als 0 sein</translation>
    </message>
    <message>
      <source>is {1}; it must be greater than {2}</source>
      <translation>ist {1}; es muss größer als {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be inside or centreline</source>
      <translation>ist {1}; es muss inside oder centreline sein</translation>
    </message>
    <message>
      <source>is {1}; it must be one of {2}</source>
      <translation>ist {1}; es muss eines von {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must be {2}</source>
      <translation>ist {1}; es muss {2} sein</translation>
    </message>
    <message>
      <source>is {1}; it must begin with one of {2}, a comma, and the source</source>
      <translation>ist {1}; es muss mit einem von {2}, einem Komma und der Quelle beginnen</translation>
    </message>
    <message>
      <source>is {1}; it must lie between the bounds {2} (strands slip) and {3} (they stick)</source>
      <translation>ist {1}; es muss zwischen den Grenzen {2} (Litzen gleiten) und {3} (sie haften) liegen</translation>
    </message>
    <message>
      <source>is {1}; its length is zero, so it gives no direction</source>
      <translation>ist {1}; die Länge ist null, daher gibt es keine Richtung an</translation>
    </message>
    <message>
      <source>it bends to {1} at {2}, and {3} is the limit</source>
      <translation>es biegt sich auf {1} bei {2}, und {3} ist die Grenze</translation>
    </message>
    <message>
      <source>it does not act, the cable would be the same without it (exact)</source>
      <translation>wirkt nicht, das Kabel wäre ohne sie dasselbe (exakt)</translation>
    </message>
    <message>
      <source>it does not lie as before: no equilibrium was found that its last shape becomes, and it may be too short to stay where it was. This one may be on another side of an obstacle, or have a turn more; look at it, or undo the change</source>
      <translation>es liegt nicht wie zuvor: Es wurde kein Gleichgewicht gefunden, in das seine letzte Form übergeht, und es ist vielleicht zu kurz, um zu bleiben, wo es war. Dieses liegt vielleicht auf einer anderen Seite eines Hindernisses oder hat eine Umdrehung mehr; sehen Sie es an oder machen Sie die Änderung rückgängig</translation>
    </message>
    <message>
      <source>it holds with the least margin</source>
      <translation>sie genügt mit dem geringsten Spielraum</translation>
    </message>
    <message>
      <source>it is Moving, but has no MinBendRadiusMoving; MinBendRadius counts</source>
      <translation>er ist Moving, hat aber kein MinBendRadiusMoving; es gilt MinBendRadius</translation>
    </message>
    <message>
      <source>it is being solved</source>
      <translation>es wird gerade gelöst</translation>
    </message>
    <message>
      <source>it is twisted by {1}° because {2} and {3} are Clamped, turned as the geometry of their parts happens to be; choose Swivel if the cable may turn while it is mounted, or set Roll</source>
      <translation>es ist um {1}° verdrillt, weil {2} und {3} Clamped sind, so gedreht, wie die Geometrie ihrer Teile gerade liegt; Swivel wählen, wenn sich das Kabel beim Einbau drehen kann, oder Roll setzen</translation>
    </message>
    <message>
      <source>it keeps clear of {1} at {2} mm from the start only because it is pushed away with {3} N, and nothing there does that: it would come nearer. Hold it there, or change its length</source>
      <translation>es bleibt bei {2} mm vom Anfang nur deshalb frei von {1}, weil es mit {3} N weggedrückt wird, und nichts dort tut das: Es käme näher. Halten Sie es dort oder ändern Sie seine Länge</translation>
    </message>
    <message>
      <source>it must be pushed from {1} at {2} to keep {3} clear</source>
      <translation>es muss bei {2} von {1} weggedrückt werden, um {3} Freiraum zu halten</translation>
    </message>
    <message>
      <source>it passes a ring at an angle and is {1} mm inside the rim of the hole; no shape was found that keeps clear of it, so widen the hole, or change the length or the ring</source>
      <translation>es läuft schräg durch einen Ring und ist {1} mm im Rand des Lochs; es wurde keine Form gefunden, die ihn frei lässt, daher das Loch weiten oder die Länge oder den Ring ändern</translation>
    </message>
    <message>
      <source>its ends are at one place</source>
      <translation>seine Enden sind am selben Ort</translation>
    </message>
    <message>
      <source>its length</source>
      <translation>seine Länge</translation>
    </message>
    <message>
      <source>its length is not found yet</source>
      <translation>seine Länge ist noch nicht gefunden</translation>
    </message>
    <message>
      <source>its radius</source>
      <translation>sein Radius</translation>
    </message>
    <message>
      <source>its radius plus the clearance of {1}</source>
      <translation>sein Radius zuzüglich des Freiraums von {1}</translation>
    </message>
    <message>
      <source>its smallest clearance is {1} mm where {2} mm is asked for: what holds the cable there leaves it no more room</source>
      <translation>sein kleinster Freiraum beträgt {1} mm, verlangt sind {2} mm: was das Kabel dort hält, lässt ihm nicht mehr Platz</translation>
    </message>
    <message>
      <source>its solve was stopped; a recompute starts it again</source>
      <translation>seine Lösung wurde angehalten; ein Neuberechnen startet sie wieder</translation>
    </message>
    <message>
      <source>leads out of its container; choose {1} anew</source>
      <translation>führt aus dem Behälter heraus; {1} neu wählen</translation>
    </message>
    <message>
      <source>leads to an edge or a face of no size; choose another</source>
      <translation>führt zu einer Kante oder Fläche ohne Größe; eine andere wählen</translation>
    </message>
    <message>
      <source>leaves {1} of cable between {2} and {3}, but {4}; the shortest possible is {5}</source>
      <translation>lässt {1} Kabel zwischen {2} und {3}, aber {4}; das kürzeste mögliche ist {5}</translation>
    </message>
    <message>
      <source>length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>longer</source>
      <translation>länger</translation>
    </message>
    <message>
      <source>longest</source>
      <translation>größte</translation>
    </message>
    <message>
      <source>moves by ({1}) mm and turns by the quaternion ({2}); give finite numbers, and the rotation an axis and an angle</source>
      <translation>verschiebt um ({1}) mm und dreht um das Quaternion ({2}); endliche Zahlen angeben und der Drehung eine Achse und einen Winkel geben</translation>
    </message>
    <message>
      <source>no length will do: {1}</source>
      <translation>keine Länge genügt: {1}</translation>
    </message>
    <message>
      <source>no stiffness is given, so the cable is taken as rigid in {1}</source>
      <translation>keine Steifigkeit angegeben, daher gilt das Kabel als starr gegen {1}</translation>
    </message>
    <message>
      <source>obstacle {1}</source>
      <translation>Hindernis {1}</translation>
    </message>
    <message>
      <source>obstacles</source>
      <translation>Hindernisse</translation>
    </message>
    <message>
      <source>obstacles in reach: the cable keeps clear of them by itself (exact)</source>
      <translation>Hindernisse in Reichweite: das Kabel bleibt von selbst frei von ihnen (exakt)</translation>
    </message>
    <message>
      <source>obstacles: all {1} are out of reach of a cable of this length (exact)</source>
      <translation>Hindernisse: alle {1} sind außer Reichweite eines Kabels dieser Länge (exakt)</translation>
    </message>
    <message>
      <source>obstacles: {1} of {2} are out of reach of a cable of this length (exact)</source>
      <translation>Hindernisse: {1} von {2} sind außer Reichweite eines Kabels dieser Länge (exakt)</translation>
    </message>
    <message>
      <source>of {1} became {2} where {3} was set; give values that it can take</source>
      <translation>von {1} wurde {2}, wo {3} gesetzt war; Werte angeben, die es annehmen kann</translation>
    </message>
    <message>
      <source>of {1} does not take {2}: {3}</source>
      <translation>von {1} nimmt {2} nicht an: {3}</translation>
    </message>
    <message>
      <source>of {1} is {2}, which is no number; choose a numeric one</source>
      <translation>von {1} ist {2}, was keine Zahl ist; eine Zahl wählen</translation>
    </message>
    <message>
      <source>pinned, the other end free and no weight: the cable can turn freely; clamp this end or hold the other</source>
      <translation>nur an einem Punkt gehalten, das andere Ende frei und kein Gewicht: das Kabel kann sich frei drehen; dieses Ende einspannen oder das andere halten</translation>
    </message>
    <message>
      <source>positions</source>
      <translation>Positionen</translation>
    </message>
    <message>
      <source>quaternions</source>
      <translation>Quaternionen</translation>
    </message>
    <message>
      <source>rims of rings: no equilibrium was found that keeps clear of them; the cable passes one at an angle and is {1} nearer to it than its radius allows</source>
      <translation>Ränder von Ringen: es wurde kein Gleichgewicht gefunden, das sie frei lässt; das Kabel läuft schräg durch einen und ist um {1} näher an ihm, als sein Radius erlaubt</translation>
    </message>
    <message>
      <source>shear</source>
      <translation>Schub</translation>
    </message>
    <message>
      <source>shear and stretch</source>
      <translation>Schub und Dehnung</translation>
    </message>
    <message>
      <source>shorter</source>
      <translation>kürzer</translation>
    </message>
    <message>
      <source>shortest</source>
      <translation>kürzeste</translation>
    </message>
    <message>
      <source>start</source>
      <translation>Anfang</translation>
    </message>
    <message>
      <source>stretch</source>
      <translation>Dehnung</translation>
    </message>
    <message>
      <source>summed along the cable they are {1} of its length, below the tolerance</source>
      <translation>über das Kabel summiert {1} seiner Länge, unter der Toleranz</translation>
    </message>
    <message>
      <source>support {1}</source>
      <translation>Halterung {1}</translation>
    </message>
    <message>
      <source>supports: the way through them leaves no slack between two of them; an inextensible cable needs some, or give it an axial stiffness</source>
      <translation>Halterungen: der Weg durch sie lässt zwischen zweien keine Überlänge; ein undehnbares Kabel braucht welche, oder ihm eine Dehnsteifigkeit geben</translation>
    </message>
    <message>
      <source>the cable itself</source>
      <translation>das Kabel selbst</translation>
    </message>
    <message>
      <source>the end is free to twist</source>
      <translation>das Ende kann sich frei verdrehen</translation>
    </message>
    <message>
      <source>the ends are {1} apart</source>
      <translation>die Enden sind {1} auseinander</translation>
    </message>
    <message>
      <source>the solver broke off: {1}</source>
      <translation>der Löser brach ab: {1}</translation>
    </message>
    <message>
      <source>the start is free to twist</source>
      <translation>der Anfang kann sich frei verdrehen</translation>
    </message>
    <message>
      <source>the start of the cable</source>
      <translation>der Anfang des Kabels</translation>
    </message>
    <message>
      <source>the terminals are at the same point</source>
      <translation>die Anschlüsse liegen im selben Punkt</translation>
    </message>
    <message>
      <source>the tightest bend, {1} mm at {2} mm from the start, is tighter than the {3} mm that {4} allows ({5})</source>
      <translation>die engste Biegung, {1} mm, {2} mm nach dem Anfang, ist enger als die {3} mm, die {4} erlaubt ({5})</translation>
    </message>
    <message>
      <source>the way through its supports is {1}</source>
      <translation>der Weg durch seine Halterungen ist {1}</translation>
    </message>
    <message>
      <source>the way through the supports between them is {1}</source>
      <translation>der Weg durch die Halterungen dazwischen ist {1}</translation>
    </message>
    <message>
      <source>there is no requirement</source>
      <translation>es gibt keine Anforderung</translation>
    </message>
    <message>
      <source>they are {1} apart</source>
      <translation>sie sind {1} auseinander</translation>
    </message>
    <message>
      <source>torsion</source>
      <translation>Torsion</translation>
    </message>
    <message>
      <source>torsion: {1}</source>
      <translation>Torsion: {1}</translation>
    </message>
    <message>
      <source>torsional</source>
      <translation>Torsion</translation>
    </message>
    <message>
      <source>what it needs was deleted while it ran; all else is as it was</source>
      <translation>was sie braucht, wurde gelöscht, während sie lief; alles andere ist, wie es war</translation>
    </message>
    <message>
      <source>what the {1} stretches between clamps have to do with each other: each is solved alone (exact)</source>
      <translation>was die {1} Stücke zwischen Klemmen miteinander zu tun haben: jedes wird einzeln gelöst (exakt)</translation>
    </message>
    <message>
      <source>with this diameter, the mass means a density of {1} kg/m³, outside {2} to {3} kg/m³; check its unit and the diameter</source>
      <translation>bei diesem Durchmesser bedeutet die Masse eine Dichte von {1} kg/m³, außerhalb von {2} bis {3} kg/m³; ihre Einheit und den Durchmesser prüfen</translation>
    </message>
    <message>
      <source>with this diameter, the {1} stiffness means a modulus of {2} Pa, outside {3} to {4} Pa; check its unit and the diameter</source>
      <translation>bei diesem Durchmesser bedeutet die Steifigkeit gegen {1} einen Modul von {2} Pa, außerhalb von {3} bis {4} Pa; ihre Einheit und den Durchmesser prüfen</translation>
    </message>
    <message>
      <source>{1} and the cable bends alike in all directions, so it carries no torque (exact)</source>
      <translation>{1}, und das Kabel ist in allen Richtungen gleich biegsam, trägt also kein Drehmoment (exakt)</translation>
    </message>
    <message>
      <source>{1} cannot be computed</source>
      <translation>{1} kann nicht berechnet werden</translation>
    </message>
    <message>
      <source>{1} cannot be drawn: {2}</source>
      <translation>{1} kann nicht gezeichnet werden: {2}</translation>
    </message>
    <message>
      <source>{1} cannot be read as a table in UTF-8: {2}</source>
      <translation>{1} kann nicht als Tabelle in UTF-8 gelesen werden: {2}</translation>
    </message>
    <message>
      <source>{1} cannot be run while the document is recomputed</source>
      <translation>{1} kann nicht laufen, während das Dokument neu berechnet wird</translation>
    </message>
    <message>
      <source>{1} cannot be written: {2}</source>
      <translation>{1} kann nicht geschrieben werden: {2}</translation>
    </message>
    <message>
      <source>{1} contains {2}; refer to an edge, a face or an object inside it</source>
      <translation>{1} enthält {2}; auf eine Kante, eine Fläche oder ein Objekt darin verweisen</translation>
    </message>
    <message>
      <source>{1} gives no direction for a cable; choose a circular edge, a flat or cylindrical face, a vertex, or an object with a placement such as a local coordinate system</source>
      <translation>{1} gibt keine Richtung für ein Kabel; eine Kreiskante, eine ebene oder zylindrische Fläche, einen Punkt oder ein Objekt mit einer Platzierung wie ein lokales Koordinatensystem wählen</translation>
    </message>
    <message>
      <source>{1} has axes of its own; only a vertex takes a second entry</source>
      <translation>{1} hat eigene Achsen; nur ein Punkt nimmt einen zweiten Eintrag</translation>
    </message>
    <message>
      <source>{1} holds the cable {2} inside {3}: hold it outside, or leave that obstacle out</source>
      <translation>{1} hält das Kabel {2} tief in {3}: es außerhalb halten oder dieses Hindernis weglassen</translation>
    </message>
    <message>
      <source>{1} in {2} elements</source>
      <translation>{1} in {2} Elementen</translation>
    </message>
    <message>
      <source>{1} is an open mesh, so all that is behind its front is inside: close it if it is a solid, or leave it out</source>
      <translation>{1} ist ein offenes Netz, so dass alles hinter seiner Vorderseite innen ist: es schließen, wenn es ein Körper ist, oder weglassen</translation>
    </message>
    <message>
      <source>{1} is missing: the part has changed. Choose another</source>
      <translation>{1} fehlt: das Teil hat sich geändert. Etwas anderes wählen</translation>
    </message>
    <message>
      <source>{1} is not inside {2}, where {3} is, so the one cannot follow the other. Put both into the same part or assembly</source>
      <translation>{1} ist nicht in {2}, wo {3} ist, daher kann das eine dem anderen nicht folgen. Beide in dasselbe Teil oder dieselbe Baugruppe legen</translation>
    </message>
    <message>
      <source>{1} is not inside {2}: it was deleted or moved. Choose another</source>
      <translation>{1} ist nicht in {2}: es wurde gelöscht oder verschoben. Etwas anderes wählen</translation>
    </message>
    <message>
      <source>{1} is not solved; recompute it</source>
      <translation>{1} ist nicht gelöst; es neu berechnen</translation>
    </message>
    <message>
      <source>{1} is stretched or mirrored by the scale of a link; let the link have one scale for all axes, greater than 0</source>
      <translation>{1} wird durch den Maßstab eines Links gestreckt oder gespiegelt; dem Link einen einzigen Maßstab für alle Achsen geben, größer als 0</translation>
    </message>
    <message>
      <source>{1} is the {2} at which an equilibrium was found. At {3}: {4}</source>
      <translation>{1} ist die {2} Länge, bei der ein Gleichgewicht gefunden wurde. Bei {3}: {4}</translation>
    </message>
    <message>
      <source>{1} is the {2} that was tried</source>
      <translation>{1} ist die {2} Länge, die versucht wurde</translation>
    </message>
    <message>
      <source>{1} is {2}, and {3} is {4}; give one</source>
      <translation>{1} ist {2}, und {3} ist {4}; eine solche angeben</translation>
    </message>
    <message>
      <source>{1} is {2}; it must be a number with its unit</source>
      <translation>{1} ist {2}; es muss eine Zahl mit ihrer Einheit sein</translation>
    </message>
    <message>
      <source>{1} of {2} cases hold</source>
      <translation>{1} von {2} Fällen genügen</translation>
    </message>
    <message>
      <source>{1} of {2} stretches: unchanged since the last solution (exact)</source>
      <translation>{1} von {2} Stücken: unverändert seit der letzten Lösung (exakt)</translation>
    </message>
    <message>
      <source>{1} was stopped; the document is as it was</source>
      <translation>{1} wurde angehalten; das Dokument ist, wie es war</translation>
    </message>
    <message>
      <source>{1} was stored by a later version of the Cable workbench; what this one does not know it leaves alone. Update the workbench</source>
      <translation>{1} wurde von einer neueren Version des Arbeitsbereichs Cable gespeichert; was diese nicht kennt, lässt sie in Ruhe. Den Arbeitsbereich aktualisieren</translation>
    </message>
    <message>
      <source>{1}: only a placeholder; set what you know of this cable</source>
      <translation>{1}: nur ein Platzhalter; eintragen, was über dieses Kabel bekannt ist</translation>
    </message>
    <message>
      <source>{1}; choose a cable type</source>
      <translation>{1}; einen Kabeltyp wählen</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>Cable</source>
      <translation>Kabel</translation>
    </message>
  </context>
</TS>
