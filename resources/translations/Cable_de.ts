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
      <source>The number: Length, Placement.Base.x, Constraints.width, or a cell of a spreadsheet</source>
      <translation>Die Zahl: Length, Placement.Base.x, Constraints.width oder eine Zelle einer Tabelle</translation>
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
    <name>Workbench</name>
    <message>
      <source>Cable</source>
      <translation>Kabel</translation>
    </message>
  </context>
</TS>
