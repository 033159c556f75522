<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
  <context>
    <name>App::Property</name>
    <message>
      <source>(length - distance) / distance, with the straight way from terminal to terminal over the supports; 0.1 is 10 %</source>
      <translation>（长度 - 距离）/ 距离，距离为端子到端子经过各支撑的直线路径；0.1 即 10 %</translation>
    </message>
    <message>
      <source>Acceleration of gravity in m/s^2, in the coordinates of the container of the cable</source>
      <translation>重力加速度，单位 m/s^2，以线缆所在容器的坐标表示</translation>
    </message>
    <message>
      <source>Angle by which the cable is twisted from its start to its end; between clamped ends their rolls make it</source>
      <translation>线缆从起点到终点的扭转角；两端固定时由端子的转角决定</translation>
    </message>
    <message>
      <source>Axial stiffness EA; 0: does not stretch</source>
      <translation>轴向刚度 EA；0：不可伸长</translation>
    </message>
    <message>
      <source>Bending stiffness EI</source>
      <translation>弯曲刚度 EI</translation>
    </message>
    <message>
      <source>Bending stiffness EI about the second axis of the section, of a flat cable; 0: the same</source>
      <translation>绕截面第二轴的弯曲刚度 EI（扁平线缆）；0：与第一轴相同</translation>
    </message>
    <message>
      <source>Between what that is for all cables, with 95 % confidence</source>
      <translation>对所有线缆而言该值所在的区间，置信度 95 %</translation>
    </message>
    <message>
      <source>By what factor the cable may be stiffer or softer; 1: its stiffness is known</source>
      <translation>线缆可能更硬或更软的倍数；1：刚度已知</translation>
    </message>
    <message>
      <source>Centre of mass, in the coordinates of the container</source>
      <translation>质心，以容器的坐标表示</translation>
    </message>
    <message>
      <source>Check: warn where the cable bends more sharply than its type allows. Enforce: form it so that it does not</source>
      <translation>Check（检查）：线缆弯曲超过其类型允许处发出警告。Enforce（强制）：使线缆成形而不超过</translation>
    </message>
    <message>
      <source>Circular edge, flat or cylindrical face, vertex or object where the cable is held; a second one, a local coordinate system, gives the axes at a vertex</source>
      <translation>固定线缆的圆形边、平面或圆柱面、顶点或对象；第二项为局部坐标系，给出顶点处的坐标轴</translation>
    </message>
    <message>
      <source>Closed sketch swept instead of a circle: its x and y turn with the axes of the section</source>
      <translation>代替圆形进行扫掠的封闭草图：其 x 和 y 轴随截面轴转动</translation>
    </message>
    <message>
      <source>Colour the cable by how far its bend radius is above the limit: red below it, orange up to 10 % above, yellow at 50 %, green from 100 %</source>
      <translation>按弯曲半径超出限值的程度为线缆着色：低于限值为红色，超出 10 % 以内为橙色，50 % 为黄色，100 % 起为绿色</translation>
    </message>
    <message>
      <source>Columns of the spreadsheet, as Smallest bend radius, by their heads without units; empty: all</source>
      <translation>电子表格的列，例如 Smallest bend radius，用不带单位的列名；空：全部</translation>
    </message>
    <message>
      <source>Compute shear also where the cable does not seem to need it</source>
      <translation>即使线缆似乎不需要，也计算剪切</translation>
    </message>
    <message>
      <source>Compute stretch also where the cable does not seem to need it</source>
      <translation>即使线缆似乎不需要，也计算伸长</translation>
    </message>
    <message>
      <source>Compute torsion also where the cable does not seem to need it</source>
      <translation>即使线缆似乎不需要，也计算扭转</translation>
    </message>
    <message>
      <source>Curvature about the two axes of the section and twist of the unloaded cable, in 1/m</source>
      <translation>未受载线缆绕截面两轴的曲率及扭率，单位 1/m</translation>
    </message>
    <message>
      <source>Density</source>
      <translation>密度</translation>
    </message>
    <message>
      <source>Displacement from the reference, in its axes</source>
      <translation>相对于参考的位移，以其坐标轴表示</translation>
    </message>
    <message>
      <source>Distance of the tightest place from the start, along the cable</source>
      <translation>弯曲最急处沿线缆到起点的距离</translation>
    </message>
    <message>
      <source>Distance of the tightest place from the start, along the route</source>
      <translation>弯曲最急处沿路径到起点的距离</translation>
    </message>
    <message>
      <source>Energy of bending, torsion and stretch, in J</source>
      <translation>弯曲、扭转和伸长的能量，单位 J</translation>
    </message>
    <message>
      <source>Energy of the weight, measured from the start against gravity, in J</source>
      <translation>重力势能，自起点逆重力方向计量，单位 J</translation>
    </message>
    <message>
      <source>Error of position asked for, relative to the length</source>
      <translation>要求的位置误差，相对于长度</translation>
    </message>
    <message>
      <source>Estimate of the largest error of position</source>
      <translation>最大位置误差的估计</translation>
    </message>
    <message>
      <source>First value, as FreeCAD computes: mm, degrees</source>
      <translation>第一个值，按 FreeCAD 的单位：mm、度</translation>
    </message>
    <message>
      <source>Fixed: the length is given. Slack: it follows from the distance of the terminals, measured over the supports. Shortest: the least that keeps bend radius and clearance</source>
      <translation>Fixed：长度给定。Slack：由端子距离（经过各支撑计量）得出。Shortest：满足弯曲半径和间隙的最短长度</translation>
    </message>
    <message>
      <source>Force of the connector at the end on the cable, in N</source>
      <translation>终点连接器对线缆的力，单位 N</translation>
    </message>
    <message>
      <source>Force of the connector at the start on the cable, in N</source>
      <translation>起点连接器对线缆的力，单位 N</translation>
    </message>
    <message>
      <source>Forces of the obstacles on the cable, in N</source>
      <translation>障碍物对线缆的力，单位 N</translation>
    </message>
    <message>
      <source>Forces of the supports on the cable, in their order, in N</source>
      <translation>各支撑依次对线缆的力，单位 N</translation>
    </message>
    <message>
      <source>Greatest bending stiffness, where no strand slips; 0: not known</source>
      <translation>最大弯曲刚度，股线均不滑移；0：未知</translation>
    </message>
    <message>
      <source>How far each terminal may be from its place, along each axis</source>
      <translation>每个端子沿各轴可能偏离其位置的距离</translation>
    </message>
    <message>
      <source>How far each terminal may be turned, about each axis it holds</source>
      <translation>每个端子绕其固定的各轴可能的转角</translation>
    </message>
    <message>
      <source>How the solve ended, and what to look at</source>
      <translation>求解结果及需要注意之处</translation>
    </message>
    <message>
      <source>Its centreline, drawn as a wire of its own</source>
      <translation>其中心线，绘制为独立的线</translation>
    </message>
    <message>
      <source>Largest force of a connector on the cable, in N</source>
      <translation>连接器对线缆的最大力，单位 N</translation>
    </message>
    <message>
      <source>Largest residual of force and moment balance, recomputed from the nodes, relative to the loads</source>
      <translation>由节点重新计算的力与力矩平衡的最大残差，相对于载荷</translation>
    </message>
    <message>
      <source>Last value</source>
      <translation>最后一个值</translation>
    </message>
    <message>
      <source>Least bending stiffness, where all strands slip; 0: not known</source>
      <translation>最小弯曲刚度，股线全部滑移；0：未知</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and an obstacle, where no terminal or support holds it; infinite if none is in reach</source>
      <translation>线缆表面与障碍物之间的最小距离（端子和支撑固定处除外）；可及范围内没有障碍物时为无穷大</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and the edge of the hole</source>
      <translation>线缆表面与孔边缘之间的最小距离</translation>
    </message>
    <message>
      <source>Least distance between the surface of the cable and the obstacles</source>
      <translation>线缆表面与障碍物之间的最小距离</translation>
    </message>
    <message>
      <source>Length added at the start, inside the connector and to strip</source>
      <translation>起点处增加的长度，用于连接器内部和剥线</translation>
    </message>
    <message>
      <source>Length of the curve</source>
      <translation>曲线的长度</translation>
    </message>
    <message>
      <source>Length of the route</source>
      <translation>路径的长度</translation>
    </message>
    <message>
      <source>Length of the route less that of the cable</source>
      <translation>路径长度减去线缆长度</translation>
    </message>
    <message>
      <source>Length of the unloaded cable</source>
      <translation>未受载线缆的长度</translation>
    </message>
    <message>
      <source>Length of the unloaded cable from its start to here</source>
      <translation>未受载线缆从起点到此处的长度</translation>
    </message>
    <message>
      <source>Length that all values allow</source>
      <translation>所有取值都允许的长度</translation>
    </message>
    <message>
      <source>Length that the worst value needs</source>
      <translation>最不利取值所需的长度</translation>
    </message>
    <message>
      <source>Length to cut: the solved length and both allowances, rounded up</source>
      <translation>下料长度：求解长度加两端余量，向上取整</translation>
    </message>
    <message>
      <source>Let the cable pass the other way. By itself it passes along the axis the way that is nearer to the straight line from the support or terminal before to the one after</source>
      <translation>使线缆反向穿过。默认沿轴线以更接近前后支撑或端子连线的方向穿过</translation>
    </message>
    <message>
      <source>Let the cable slide through without friction. Else it is held at Position</source>
      <translation>允许线缆无摩擦滑动。否则固定在 Position 处</translation>
    </message>
    <message>
      <source>Longest length that keeps bend radius and clearance</source>
      <translation>满足弯曲半径和间隙的最大长度</translation>
    </message>
    <message>
      <source>Mark the place with the smallest bend radius</source>
      <translation>标记弯曲半径最小处</translation>
    </message>
    <message>
      <source>Mark the places where obstacles push the cable</source>
      <translation>标记障碍物推压线缆处</translation>
    </message>
    <message>
      <source>Mass of the cable, in kg</source>
      <translation>线缆的质量，单位 kg</translation>
    </message>
    <message>
      <source>Mass per length</source>
      <translation>单位长度质量</translation>
    </message>
    <message>
      <source>Moment of the connector at the end on the cable, in N m</source>
      <translation>终点连接器对线缆的力矩，单位 N m</translation>
    </message>
    <message>
      <source>Moment of the connector at the start on the cable, in N m</source>
      <translation>起点连接器对线缆的力矩，单位 N m</translation>
    </message>
    <message>
      <source>Moments of the supports on the cable, in their order, in N m</source>
      <translation>各支撑依次对线缆的力矩，单位 N m</translation>
    </message>
    <message>
      <source>Number of random cases</source>
      <translation>随机工况的数量</translation>
    </message>
    <message>
      <source>Number of values from first to last</source>
      <translation>从第一个到最后一个的取值数量</translation>
    </message>
    <message>
      <source>Number that the random cases follow from</source>
      <translation>生成随机工况的种子数</translation>
    </message>
    <message>
      <source>Outer diameter</source>
      <translation>外径</translation>
    </message>
    <message>
      <source>Parts, assemblies, links to them and other cables that the cable must not enter</source>
      <translation>线缆不得进入的零件、装配、它们的链接以及其他线缆</translation>
    </message>
    <message>
      <source>Radius of the hole; that of the reference if it is a circle or a cylinder</source>
      <translation>孔的半径；若参考为圆或圆柱则取其半径</translation>
    </message>
    <message>
      <source>Row of the worst case; its shape is drawn with the nominal one</source>
      <translation>最不利工况所在的行；其形状与名义形状一同绘制</translation>
    </message>
    <message>
      <source>Search for the length that the worst value needs; takes longer</source>
      <translation>搜索最不利取值所需的长度；耗时更长</translation>
    </message>
    <message>
      <source>Share of the cases that hold</source>
      <translation>满足要求的工况所占比例</translation>
    </message>
    <message>
      <source>Shear modulus</source>
      <translation>剪切模量</translation>
    </message>
    <message>
      <source>Shear stiffness GA; 0: does not shear</source>
      <translation>剪切刚度 GA；0：无剪切变形</translation>
    </message>
    <message>
      <source>Shortest length that keeps bend radius and clearance</source>
      <translation>满足弯曲半径和间隙的最短长度</translation>
    </message>
    <message>
      <source>Show what terminals and supports exert on the cable as arrows</source>
      <translation>用箭头显示端子和支撑对线缆的作用</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>最小弯曲半径</translation>
    </message>
    <message>
      <source>Smallest bend radius less the smallest one that the cable type allows; negative if it is violated</source>
      <translation>最小弯曲半径减去线缆类型允许的最小值；违反时为负</translation>
    </message>
    <message>
      <source>Smallest bend radius of all shapes</source>
      <translation>所有形状的最小弯曲半径</translation>
    </message>
    <message>
      <source>Smallest bend radius of the centreline</source>
      <translation>中心线的最小弯曲半径</translation>
    </message>
    <message>
      <source>Smallest bend radius the cable may have where it is laid; 0: no limit</source>
      <translation>固定敷设处允许的最小弯曲半径；0：无限制</translation>
    </message>
    <message>
      <source>Smallest bend radius the cable may have where it moves; 0: not known</source>
      <translation>移动处允许的最小弯曲半径；0：未知</translation>
    </message>
    <message>
      <source>Smallest clearance of all shapes; infinite without any</source>
      <translation>所有形状的最小间隙；没有障碍物时为无穷大</translation>
    </message>
    <message>
      <source>Solids, centrelines, or the envelope: solids so close to each other that the gaps are less than the cable</source>
      <translation>实体、中心线或包络：实体间隔小于线缆直径</translation>
    </message>
    <message>
      <source>Spline: as CAD routes a cable, with the directions of the terminals. Catenary: a thread of the cable's length without stiffness. Chord: straight</source>
      <translation>Spline：如 CAD 布线，采用端子方向的样条。Catenary：与线缆等长、无刚度的悬链线。Chord：直线</translation>
    </message>
    <message>
      <source>Spreadsheet with a row for each value</source>
      <translation>每个取值一行的表格</translation>
    </message>
    <message>
      <source>Terminal where the cable ends</source>
      <translation>线缆终点的端子</translation>
    </message>
    <message>
      <source>Terminal where the cable starts</source>
      <translation>线缆起点的端子</translation>
    </message>
    <message>
      <source>The cable it belongs to</source>
      <translation>所属的线缆</translation>
    </message>
    <message>
      <source>The cable may be as much too long as IPC/WHMA-A-620 allows: 50 mm up to 1.5 m</source>
      <translation>线缆可超长的量按 IPC/WHMA-A-620：1.5 m 以内为 50 mm</translation>
    </message>
    <message>
      <source>The cut length is rounded up to a multiple of this; 0: not rounded</source>
      <translation>下料长度向上取整到该值的倍数；0：不取整</translation>
    </message>
    <message>
      <source>The difference, relative to the length of the cable</source>
      <translation>差值，相对于线缆长度</translation>
    </message>
    <message>
      <source>The number: Length, Placement.Base.x, Constraints.width, or a cell of a spreadsheet; of the cable also StiffnessScale, a factor of its stiffness, and GravityTurn.x, y or z, degrees</source>
      <translation>数值：Length、Placement.Base.x、Constraints.width 或电子表格的单元格；线缆还有 StiffnessScale（刚度的倍数）以及 GravityTurn.x、y 或 z（度）</translation>
    </message>
    <message>
      <source>The object that has the number, a joint or a sheet as well; empty: the cable</source>
      <translation>含有该数值的对象，也可以是关节或表格；留空：线缆本身</translation>
    </message>
    <message>
      <source>The same at the end</source>
      <translation>终点处同样增加的长度</translation>
    </message>
    <message>
      <source>The section in words, and what looks wrong</source>
      <translation>截面的文字说明，以及看起来有误之处</translation>
    </message>
    <message>
      <source>Time of the last solve, in s</source>
      <translation>上次求解的时间，单位 s</translation>
    </message>
    <message>
      <source>Torsional stiffness GJ</source>
      <translation>扭转刚度 GJ</translation>
    </message>
    <message>
      <source>Turn about the axis of the reference</source>
      <translation>绕参考轴的转角</translation>
    </message>
    <message>
      <source>Turn about the cable's axis; whole turns do not count</source>
      <translation>绕线缆轴线的转角；整圈不计</translation>
    </message>
    <message>
      <source>Turn the cable into the part instead of out of it</source>
      <translation>使线缆进入零件而不是从中引出</translation>
    </message>
    <message>
      <source>Value at which it is</source>
      <translation>对应的取值</translation>
    </message>
    <message>
      <source>Value at which it is needed</source>
      <translation>需要该长度时的取值</translation>
    </message>
    <message>
      <source>Value of each shape that is drawn</source>
      <translation>所绘各形状对应的取值</translation>
    </message>
    <message>
      <source>Values at which the cable jumps to another shape, or buckles</source>
      <translation>线缆跳变到另一形状或屈曲时的取值</translation>
    </message>
    <message>
      <source>Values in their order, instead of first, last and number</source>
      <translation>依次给出的取值，代替首值、末值和数量</translation>
    </message>
    <message>
      <source>Values: one number of the document over a range. Random: cases within the tolerances. Corners: all combinations of their bounds</source>
      <translation>Values：文档的一个数值在某范围内变化。Random：公差范围内的工况。Corners：公差极限的所有组合</translation>
    </message>
    <message>
      <source>Values: stiffness and mass as given. Material: those of a solid round section; a stranded cable is softer, often ten times</source>
      <translation>Values：刚度和质量按给定值。Material：按实心圆截面；多股线缆更软，常软十倍</translation>
    </message>
    <message>
      <source>What exerts them</source>
      <translation>施力者</translation>
    </message>
    <message>
      <source>What forbids shorter and longer lengths, and where</source>
      <translation>限制更短和更长长度的因素及其位置</translation>
    </message>
    <message>
      <source>What happened, value by value</source>
      <translation>逐个取值的情况</translation>
    </message>
    <message>
      <source>What holds the cable on its way, in order along it</source>
      <translation>沿途固定线缆的支撑，按沿线缆的顺序</translation>
    </message>
    <message>
      <source>What is held. Clamped: position and all directions; Swivel: position and tangent, the cable may twist; Pinned: position; Free: nothing</source>
      <translation>固定方式。Clamped：位置和所有方向；Swivel：位置和切线，线缆可扭转；Pinned：位置；Free：不固定</translation>
    </message>
    <message>
      <source>What is wrong, if anything</source>
      <translation>如有错误，错误所在</translation>
    </message>
    <message>
      <source>What is wrong, or to be done</source>
      <translation>错误或待办事项</translation>
    </message>
    <message>
      <source>What the cable is made of</source>
      <translation>线缆的构成</translation>
    </message>
    <message>
      <source>What the model has and what was left out of it, and why</source>
      <translation>模型包含什么、省略了什么及其原因</translation>
    </message>
    <message>
      <source>When it is solved. Manual: when asked to. On recompute: with the document. Live: also by itself, when what holds it moves in the window</source>
      <translation>何时求解。Manual：按需。On recompute：随文档重新计算。Live：窗口中固定线缆的零件移动时也自动求解</translation>
    </message>
    <message>
      <source>Where each number comes from: measured, datasheet, standard, derived, user or placeholder, and the source</source>
      <translation>每个数值的来源：measured（实测）、datasheet（数据表）、standard（标准）、derived（推导）、user（用户）或 placeholder（占位），以及出处</translation>
    </message>
    <message>
      <source>Where the cable is held: along z, in the coordinates of the container</source>
      <translation>线缆被固定之处：沿 z 轴，以容器的坐标表示</translation>
    </message>
    <message>
      <source>Where the cable must be formed to keep the enforced bend radius, and with what moment</source>
      <translation>线缆必须成形以满足强制弯曲半径的位置，以及所需力矩</translation>
    </message>
    <message>
      <source>Where the smallest bend radius is measured: at the inside of the bend or at the centreline</source>
      <translation>最小弯曲半径的测量位置：弯曲内侧（Inside）或中心线（Centreline）</translation>
    </message>
    <message>
      <source>Where they act: distances from the start, along the cable, in mm</source>
      <translation>作用位置：沿线缆到起点的距离，单位 mm</translation>
    </message>
    <message>
      <source>Whether shape and numbers are those from before the last change, because it is not solved yet</source>
      <translation>形状和数值是否仍为上次更改之前的结果，因为尚未求解</translation>
    </message>
    <message>
      <source>Whether something has changed since the study was run</source>
      <translation>自研究运行以来是否有变化</translation>
    </message>
    <message>
      <source>Whether the cable moves, so that MinBendRadiusMoving counts</source>
      <translation>线缆是否移动，从而适用 MinBendRadiusMoving</translation>
    </message>
    <message>
      <source>Whether the cable stays in this shape</source>
      <translation>线缆是否保持此形状</translation>
    </message>
    <message>
      <source>Young's modulus</source>
      <translation>杨氏模量</translation>
    </message>
  </context>
  <context>
    <name>Cable</name>
    <message>
      <source>Add the Selection</source>
      <translation>添加所选对象</translation>
    </message>
    <message>
      <source>Always, while parts move</source>
      <translation>始终，零件移动时也求解</translation>
    </message>
    <message>
      <source>Bend radius</source>
      <translation>弯曲半径</translation>
    </message>
    <message>
      <source>Bend radius margin</source>
      <translation>弯曲半径裕量</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>线缆类型</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>检查</translation>
    </message>
    <message>
      <source>Clearance</source>
      <translation>间隙</translation>
    </message>
    <message>
      <source>Colour by bend radius</source>
      <translation>按弯曲半径着色</translation>
    </message>
    <message>
      <source>Edit {label}</source>
      <translation>编辑 {label}</translation>
    </message>
    <message>
      <source>Error estimate</source>
      <translation>误差估计</translation>
    </message>
    <message>
      <source>Folder for the report</source>
      <translation>报告的文件夹</translation>
    </message>
    <message>
      <source>Force and moment at the end</source>
      <translation>终点的力和力矩</translation>
    </message>
    <message>
      <source>Force and moment at the start</source>
      <translation>起点的力和力矩</translation>
    </message>
    <message>
      <source>Force on the cable</source>
      <translation>对线缆的力</translation>
    </message>
    <message>
      <source>Form the cable so that it is kept</source>
      <translation>使线缆成形以满足要求</translation>
    </message>
    <message>
      <source>From the slack</source>
      <translation>由余量得出</translation>
    </message>
    <message>
      <source>Given</source>
      <translation>给定</translation>
    </message>
    <message>
      <source>Holds</source>
      <translation>固定</translation>
    </message>
    <message>
      <source>Lead the cable through the supports selected now</source>
      <translation>让线缆穿过当前选中的支撑</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>长度</translation>
    </message>
    <message>
      <source>Let the cable pass the other way</source>
      <translation>使线缆反向穿过</translation>
    </message>
    <message>
      <source>Mark contacts</source>
      <translation>标记接触</translation>
    </message>
    <message>
      <source>Mark the tightest place</source>
      <translation>标记弯曲最急处</translation>
    </message>
    <message>
      <source>Moment on the cable</source>
      <translation>对线缆的力矩</translation>
    </message>
    <message>
      <source>Nearer to the end of the cable</source>
      <translation>更靠近线缆终点</translation>
    </message>
    <message>
      <source>Nearer to the start of the cable</source>
      <translation>更靠近线缆起点</translation>
    </message>
    <message>
      <source>Nothing</source>
      <translation>不固定</translation>
    </message>
    <message>
      <source>Offset</source>
      <translation>偏移</translation>
    </message>
    <message>
      <source>Position</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>Position along the cable</source>
      <translation>沿线缆的位置</translation>
    </message>
    <message>
      <source>Position and all directions</source>
      <translation>位置和所有方向</translation>
    </message>
    <message>
      <source>Position and direction; it may twist</source>
      <translation>位置和方向；可以扭转</translation>
    </message>
    <message>
      <source>Preview; the solid follows when it rests.</source>
      <translation>预览；停止移动后生成实体。</translation>
    </message>
    <message>
      <source>Radius</source>
      <translation>半径</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>移除</translation>
    </message>
    <message>
      <source>Roll</source>
      <translation>滚转角</translation>
    </message>
    <message>
      <source>Shortest that will do</source>
      <translation>满足要求的最短长度</translation>
    </message>
    <message>
      <source>Show forces</source>
      <translation>显示力</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>最小弯曲半径</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>求解</translation>
    </message>
    <message>
      <source>Solve Now</source>
      <translation>立即求解</translation>
    </message>
    <message>
      <source>Solving: {seconds}, {what}</source>
      <translation>正在求解：{seconds}，{what}</translation>
    </message>
    <message>
      <source>Stability</source>
      <translation>稳定性</translation>
    </message>
    <message>
      <source>Stand at the edge, face or vertex selected now</source>
      <translation>置于当前所选的边、面或顶点</translation>
    </message>
    <message>
      <source>Stands at</source>
      <translation>位于</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>停止</translation>
    </message>
    <message>
      <source>Stops the solve; the last good shape stays</source>
      <translation>停止求解；保留上一个有效形状</translation>
    </message>
    <message>
      <source>Stops the solves of all cables; their last good shapes stay</source>
      <translation>停止所有线缆的求解；保留上一个有效形状</translation>
    </message>
    <message>
      <source>Supports</source>
      <translation>支撑</translation>
    </message>
    <message>
      <source>Take the Selection</source>
      <translation>采用所选对象</translation>
    </message>
    <message>
      <source>The cable passes it by; it stays in the document</source>
      <translation>线缆不再经过它；它仍保留在文档中</translation>
    </message>
    <message>
      <source>The cable slides through</source>
      <translation>线缆可滑动穿过</translation>
    </message>
    <message>
      <source>Turn the cable into the part</source>
      <translation>使线缆进入零件</translation>
    </message>
    <message>
      <source>Waiting to be solved: {seconds}</source>
      <translation>等待求解：{seconds}</translation>
    </message>
    <message>
      <source>When asked to</source>
      <translation>按需求解</translation>
    </message>
    <message>
      <source>With the document</source>
      <translation>随文档</translation>
    </message>
    <message>
      <source>its type has no limit</source>
      <translation>其类型没有限制</translation>
    </message>
    <message>
      <source>no obstacle in reach</source>
      <translation>可及范围内没有障碍物</translation>
    </message>
    <message>
      <source>not stable</source>
      <translation>不稳定</translation>
    </message>
    <message>
      <source>nowhere</source>
      <translation>无</translation>
    </message>
    <message>
      <source>stable</source>
      <translation>稳定</translation>
    </message>
    <message>
      <source>straight</source>
      <translation>直线</translation>
    </message>
    <message>
      <source>{margin} above {limit}</source>
      <translation>比 {limit} 大 {margin}</translation>
    </message>
    <message>
      <source>{margin} below {limit}</source>
      <translation>比 {limit} 小 {margin}</translation>
    </message>
    <message>
      <source>{radius} at {place} from the start</source>
      <translation>{radius}，距起点 {place}</translation>
    </message>
    <message>
      <source>{said}; {count} more</source>
      <translation>{said}；另有 {count} 个</translation>
    </message>
  </context>
  <context>
    <name>CablePreferences</name>
    <message>
      <source>Always, while parts move</source>
      <translation>始终，零件移动时也求解</translation>
    </message>
    <message>
      <source>By how much a new cable is longer than the straight way between its terminals</source>
      <translation>新线缆比端子之间的直线路径长多少</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>线缆类型</translation>
    </message>
    <message>
      <source>Colour</source>
      <translation>颜色</translation>
    </message>
    <message>
      <source>Colour of new cables</source>
      <translation>新线缆的颜色</translation>
    </message>
    <message>
      <source>Error of position</source>
      <translation>位置误差</translation>
    </message>
    <message>
      <source>Name of a type in the library that new cables have; empty: the first type of the document, or of the library</source>
      <translation>新线缆采用的类型库中的类型名称；留空：文档或类型库中的第一个类型</translation>
    </message>
    <message>
      <source>New cables</source>
      <translation>新线缆</translation>
    </message>
    <message>
      <source>Nothing</source>
      <translation>不固定</translation>
    </message>
    <message>
      <source>Position</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>Position and all directions</source>
      <translation>位置和所有方向</translation>
    </message>
    <message>
      <source>Position and tangent; the cable may twist</source>
      <translation>位置和切线；线缆可以扭转</translation>
    </message>
    <message>
      <source>Slack</source>
      <translation>余量</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>求解</translation>
    </message>
    <message>
      <source>Terminals hold</source>
      <translation>端子固定</translation>
    </message>
    <message>
      <source>What a new terminal holds of its cable</source>
      <translation>新端子对线缆的固定方式</translation>
    </message>
    <message>
      <source>What is asked for of new cables, relative to the length</source>
      <translation>对新线缆的要求，相对于长度</translation>
    </message>
    <message>
      <source>When asked to</source>
      <translation>按需求解</translation>
    </message>
    <message>
      <source>When new cables are solved</source>
      <translation>新线缆何时求解</translation>
    </message>
    <message>
      <source>With the document</source>
      <translation>随文档</translation>
    </message>
    <message>
      <source>the first of the document</source>
      <translation>文档中的第一个</translation>
    </message>
  </context>
  <context>
    <name>CableReport</name>
    <message>
      <source>All cables</source>
      <translation>全部线缆</translation>
    </message>
    <message>
      <source>Allowance at start and end</source>
      <translation>起点和终点余量</translation>
    </message>
    <message>
      <source>Allowed</source>
      <translation>允许值</translation>
    </message>
    <message>
      <source>Allowed [mm]</source>
      <translation>允许值 [mm]</translation>
    </message>
    <message>
      <source>Allowed&lt;br&gt;[mm]</source>
      <translation>允许值&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>As the window shows it</source>
      <translation>窗口中的显示</translation>
    </message>
    <message>
      <source>Balance of forces and moments</source>
      <translation>力与力矩的平衡</translation>
    </message>
    <message>
      <source>Bend and clearance</source>
      <translation>弯曲与间隙</translation>
    </message>
    <message>
      <source>Cable</source>
      <translation>线缆</translation>
    </message>
    <message>
      <source>Cable type</source>
      <translation>线缆类型</translation>
    </message>
    <message>
      <source>Cable types</source>
      <translation>线缆类型</translation>
    </message>
    <message>
      <source>Cables</source>
      <translation>线缆</translation>
    </message>
    <message>
      <source>Cables of {document}</source>
      <translation>{document} 的线缆</translation>
    </message>
    <message>
      <source>Centre of mass</source>
      <translation>质心</translation>
    </message>
    <message>
      <source>Centre x [mm]</source>
      <translation>质心 x [mm]</translation>
    </message>
    <message>
      <source>Centre y [mm]</source>
      <translation>质心 y [mm]</translation>
    </message>
    <message>
      <source>Centre z [mm]</source>
      <translation>质心 z [mm]</translation>
    </message>
    <message>
      <source>Clearance [mm]</source>
      <translation>间隙 [mm]</translation>
    </message>
    <message>
      <source>Clearance asked for</source>
      <translation>要求的间隙</translation>
    </message>
    <message>
      <source>Clearance is the least distance of the cable's surface to any visible solid and any other cable, where one is within 20 mm of it, except where the cable is held. Coordinates, forces and moments are in the coordinates of the document; forces and moments are those of the connectors and supports on the cable.</source>
      <translation>间隙是线缆表面到任何可见实体和其他线缆的最小距离，仅计 20 mm 以内者，线缆被固定之处除外。坐标、力和力矩均采用文档坐标系；力和力矩是连接器和支撑对线缆的作用。</translation>
    </message>
    <message>
      <source>Clearance&lt;br&gt;[mm]</source>
      <translation>间隙&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Curvature [1/m] over the distance from the start [mm]; dashed: the spline route</source>
      <translation>曲率 [1/m] 随距起点距离 [mm] 的变化；虚线：样条路径</translation>
    </message>
    <message>
      <source>Cut length</source>
      <translation>下料长度</translation>
    </message>
    <message>
      <source>Cut length [mm]</source>
      <translation>下料长度 [mm]</translation>
    </message>
    <message>
      <source>Cut length&lt;br&gt;[mm]</source>
      <translation>下料长度&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Error estimate</source>
      <translation>误差估计</translation>
    </message>
    <message>
      <source>Error estimate [mm]</source>
      <translation>误差估计 [mm]</translation>
    </message>
    <message>
      <source>Error&lt;br&gt;[mm]</source>
      <translation>误差&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Fails</source>
      <translation>不满足</translation>
    </message>
    <message>
      <source>Force [N]</source>
      <translation>力 [N]</translation>
    </message>
    <message>
      <source>Force at end [N]</source>
      <translation>终点力 [N]</translation>
    </message>
    <message>
      <source>Force at start [N]</source>
      <translation>起点力 [N]</translation>
    </message>
    <message>
      <source>Forces and moments on the cable</source>
      <translation>作用于线缆的力和力矩</translation>
    </message>
    <message>
      <source>Holds</source>
      <translation>满足</translation>
    </message>
    <message>
      <source>If the strands slip</source>
      <translation>若股线滑移</translation>
    </message>
    <message>
      <source>If the strands stick</source>
      <translation>若股线粘结</translation>
    </message>
    <message>
      <source>It bends to {radius} mm; {allowed} mm is allowed.</source>
      <translation>其弯曲半径为 {radius} mm；允许 {allowed} mm。</translation>
    </message>
    <message>
      <source>It does not stay in this shape.</source>
      <translation>它不会保持这一形状。</translation>
    </message>
    <message>
      <source>It enters {other} by {depth} mm.</source>
      <translation>它侵入 {other} {depth} mm。</translation>
    </message>
    <message>
      <source>It holds, but with {stiffness} it bends to {radius} mm.</source>
      <translation>它满足要求，但取 {stiffness} 时弯曲到 {radius} mm。</translation>
    </message>
    <message>
      <source>It is out of date; recompute the document.</source>
      <translation>它已过期；请重新计算文档。</translation>
    </message>
    <message>
      <source>It is {distance} mm from {other}; its clearance is {clearance} mm.</source>
      <translation>它距 {other} {distance} mm；其间隙为 {clearance} mm。</translation>
    </message>
    <message>
      <source>Its bend radius [mm]</source>
      <translation>其弯曲半径 [mm]</translation>
    </message>
    <message>
      <source>Its bend&lt;br&gt;radius [mm]</source>
      <translation>其弯曲&lt;br&gt;半径 [mm]</translation>
    </message>
    <message>
      <source>Its distance to {other} is not known: {reason}</source>
      <translation>它到 {other} 的距离未知：{reason}</translation>
    </message>
    <message>
      <source>Its shape at the bounds of its stiffness is not known: {error}</source>
      <translation>它在刚度界限处的形状未知：{error}</translation>
    </message>
    <message>
      <source>Largest end&lt;br&gt;force [N]</source>
      <translation>最大端部&lt;br&gt;力 [N]</translation>
    </message>
    <message>
      <source>Largest end&lt;br&gt;moment [N m]</source>
      <translation>最大端部&lt;br&gt;力矩 [N m]</translation>
    </message>
    <message>
      <source>Least clearance</source>
      <translation>最小间隙</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>长度</translation>
    </message>
    <message>
      <source>Length [mm]</source>
      <translation>长度 [mm]</translation>
    </message>
    <message>
      <source>Length between the terminals</source>
      <translation>端子之间的长度</translation>
    </message>
    <message>
      <source>Length&lt;br&gt;[mm]</source>
      <translation>长度&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Margin</source>
      <translation>裕量</translation>
    </message>
    <message>
      <source>Margin [%]</source>
      <translation>裕量 [%]</translation>
    </message>
    <message>
      <source>Margin [mm]</source>
      <translation>裕量 [mm]</translation>
    </message>
    <message>
      <source>Mass</source>
      <translation>质量</translation>
    </message>
    <message>
      <source>Mass [g]</source>
      <translation>质量 [g]</translation>
    </message>
    <message>
      <source>Mass, and how it was solved</source>
      <translation>质量及求解情况</translation>
    </message>
    <message>
      <source>Mass&lt;br&gt;[g]</source>
      <translation>质量&lt;br&gt;[g]</translation>
    </message>
    <message>
      <source>Mode</source>
      <translation>方式</translation>
    </message>
    <message>
      <source>Model</source>
      <translation>模型</translation>
    </message>
    <message>
      <source>Moment [N m]</source>
      <translation>力矩 [N m]</translation>
    </message>
    <message>
      <source>Moment at end [N m]</source>
      <translation>终点力矩 [N m]</translation>
    </message>
    <message>
      <source>Moment at start [N m]</source>
      <translation>起点力矩 [N m]</translation>
    </message>
    <message>
      <source>Not solved</source>
      <translation>未求解</translation>
    </message>
    <message>
      <source>Of the spline route</source>
      <translation>样条路径的</translation>
    </message>
    <message>
      <source>Rounded up by</source>
      <translation>向上取整</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>截面</translation>
    </message>
    <message>
      <source>Shortest and longest that will do</source>
      <translation>满足要求的最短和最长</translation>
    </message>
    <message>
      <source>Slack</source>
      <translation>余量</translation>
    </message>
    <message>
      <source>Smallest bend radius</source>
      <translation>最小弯曲半径</translation>
    </message>
    <message>
      <source>Smallest bend radius [mm]</source>
      <translation>最小弯曲半径 [mm]</translation>
    </message>
    <message>
      <source>Smallest bend&lt;br&gt;radius [mm]</source>
      <translation>最小弯曲&lt;br&gt;半径 [mm]</translation>
    </message>
    <message>
      <source>Solve time [s]</source>
      <translation>求解时间 [s]</translation>
    </message>
    <message>
      <source>Solved in&lt;br&gt;[ms]</source>
      <translation>求解用时&lt;br&gt;[ms]</translation>
    </message>
    <message>
      <source>Spline route</source>
      <translation>样条路径</translation>
    </message>
    <message>
      <source>Spline route [mm]</source>
      <translation>样条路径 [mm]</translation>
    </message>
    <message>
      <source>Spline route&lt;br&gt;[mm]</source>
      <translation>样条路径&lt;br&gt;[mm]</translation>
    </message>
    <message>
      <source>Stays in this shape</source>
      <translation>保持这一形状</translation>
    </message>
    <message>
      <source>Straight way [mm]</source>
      <translation>直线路径 [mm]</translation>
    </message>
    <message>
      <source>Straight way over the supports</source>
      <translation>经过支撑的直线路径</translation>
    </message>
    <message>
      <source>The document has no cables.</source>
      <translation>文档中没有线缆。</translation>
    </message>
    <message>
      <source>The spline route is the curve through the same terminals and supports that a drawing would show, without stiffness, weight and given length. Tolerances of the cut length are those of IPC/WHMA-A-620, Table 11-1, as an industry review draft has them.</source>
      <translation>样条路径是图纸上会画出的、经过相同端子和支撑的曲线，不考虑刚度、重量和给定长度。下料长度公差取自 IPC/WHMA-A-620 表 11-1 的行业评审稿。</translation>
    </message>
    <message>
      <source>The worst cable comes first: those without an answer, those that fail, those of which something is not known; among equals the smallest margin. The margin is by how much the smallest bend radius is above the allowed one, relative to that. Bend radii are those of the centreline.</source>
      <translation>最差的线缆排在最前：没有解的、不满足的、尚有未知的；同类中裕量最小者在前。裕量是最小弯曲半径超出允许值的相对量。弯曲半径均指中心线。</translation>
    </message>
    <message>
      <source>Time of the solve</source>
      <translation>求解时间</translation>
    </message>
    <message>
      <source>To be checked</source>
      <translation>待检查</translation>
    </message>
    <message>
      <source>Together: length {length} mm, cut length {cut} mm, mass {mass} g, centre of mass {centre} mm.</source>
      <translation>合计：长度 {length} mm，下料长度 {cut} mm，质量 {mass} g，质心 {centre} mm。</translation>
    </message>
    <message>
      <source>Type</source>
      <translation>类型</translation>
    </message>
    <message>
      <source>Verdict</source>
      <translation>结论</translation>
    </message>
    <message>
      <source>What it says</source>
      <translation>说明</translation>
    </message>
    <message>
      <source>Where its numbers are from</source>
      <translation>数据来源</translation>
    </message>
    <message>
      <source>allowed</source>
      <translation>允许</translation>
    </message>
    <message>
      <source>at [mm]</source>
      <translation>位置 [mm]</translation>
    </message>
    <message>
      <source>checked</source>
      <translation>检查</translation>
    </message>
    <message>
      <source>en</source>
      <translation>zh-CN</translation>
    </message>
    <message>
      <source>enforced</source>
      <translation>强制满足</translation>
    </message>
    <message>
      <source>no</source>
      <translation>否</translation>
    </message>
    <message>
      <source>not known</source>
      <translation>未知</translation>
    </message>
    <message>
      <source>nothing within 20 mm</source>
      <translation>20 mm 内无物体</translation>
    </message>
    <message>
      <source>of it x, y, z</source>
      <translation>其 x、y、z 分量</translation>
    </message>
    <message>
      <source>straight</source>
      <translation>直</translation>
    </message>
    <message>
      <source>to</source>
      <translation>至</translation>
    </message>
    <message>
      <source>to {residual}, relative</source>
      <translation>相对 {residual}</translation>
    </message>
    <message>
      <source>yes</source>
      <translation>是</translation>
    </message>
    <message>
      <source>{distance} to {nearest}</source>
      <translation>至 {nearest} {distance}</translation>
    </message>
    <message>
      <source>{obstacle}, at {place}</source>
      <translation>{obstacle}，位置 {place}</translation>
    </message>
    <message>
      <source>{radius} at the centreline</source>
      <translation>中心线处 {radius}</translation>
    </message>
    <message>
      <source>{radius} at the inside of the bend</source>
      <translation>弯曲内侧 {radius}</translation>
    </message>
    <message>
      <source>{radius} at {place}</source>
      <translation>{radius}，位置 {place}</translation>
    </message>
    <message>
      <source>{radius}, up to {distance} beside this shape</source>
      <translation>{radius}，与此形状相距至多 {distance}</translation>
    </message>
    <message>
      <source>{type} has no smallest bend radius to compare with.</source>
      <translation>{type} 没有可供比较的最小弯曲半径。</translation>
    </message>
    <message>
      <source>{what}, from a corner</source>
      <translation>{what}，斜视</translation>
    </message>
    <message>
      <source>{what}, from above</source>
      <translation>{what}，俯视</translation>
    </message>
    <message>
      <source>{what}, from the front</source>
      <translation>{what}，前视</translation>
    </message>
    <message>
      <source>{what}, from the right</source>
      <translation>{what}，右视</translation>
    </message>
    <message>
      <source>… to {place}</source>
      <translation>… 至 {place}</translation>
    </message>
  </context>
  <context>
    <name>Cable_Cable</name>
    <message>
      <source>Cable</source>
      <translation>线缆</translation>
    </message>
    <message>
      <source>Runs a cable between two selected terminals, edges or faces</source>
      <translation>在两个所选端子、边或面之间布设线缆</translation>
    </message>
  </context>
  <context>
    <name>Cable_Check</name>
    <message>
      <source>Check All</source>
      <translation>全部检查</translation>
    </message>
    <message>
      <source>Lists what the cables come near to: solids and each other, with distances and places</source>
      <translation>列出线缆接近的实体和其他线缆，以及距离和位置</translation>
    </message>
  </context>
  <context>
    <name>Cable_Clamp</name>
    <message>
      <source>Clamp</source>
      <translation>夹具</translation>
    </message>
    <message>
      <source>Holds a cable and keeps it from twisting at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>在所选边或面处固定线缆并防止其扭转，位于同时选中的线缆的路径上</translation>
    </message>
  </context>
  <context>
    <name>Cable_Clip</name>
    <message>
      <source>Clip</source>
      <translation>卡扣</translation>
    </message>
    <message>
      <source>Grips a cable and lets it twist at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>在所选边或面处夹住线缆并允许其扭转，位于同时选中的线缆的路径上</translation>
    </message>
  </context>
  <context>
    <name>Cable_Example</name>
    <message>
      <source>Example</source>
      <translation>示例</translation>
    </message>
    <message>
      <source>Opens an equipment panel with ten cables in a new document</source>
      <translation>在新文档中打开带有十根线缆的设备面板</translation>
    </message>
  </context>
  <context>
    <name>Cable_Report</name>
    <message>
      <source>Report</source>
      <translation>报告</translation>
    </message>
    <message>
      <source>Writes a page and a spreadsheet about all cables, the worst first</source>
      <translation>生成关于所有线缆的页面和表格，风险最高者在前</translation>
    </message>
  </context>
  <context>
    <name>Cable_Ring</name>
    <message>
      <source>Leads a cable through a round hole at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>在所选边或面处引导线缆穿过圆孔，位于同时选中的线缆的路径上</translation>
    </message>
    <message>
      <source>Ring</source>
      <translation>圆环</translation>
    </message>
  </context>
  <context>
    <name>Cable_Route</name>
    <message>
      <source>Comparison Route</source>
      <translation>对比路径</translation>
    </message>
    <message>
      <source>Draws a curve without mechanics beside the selected cable, to compare with</source>
      <translation>在所选线缆旁绘制一条不含力学的曲线以供对比</translation>
    </message>
  </context>
  <context>
    <name>Cable_Shortest</name>
    <message>
      <source>Gives the selected cable the least length that keeps its bend radius and clearance</source>
      <translation>为所选线缆设定满足弯曲半径和间隙的最短长度</translation>
    </message>
    <message>
      <source>Shortest Length</source>
      <translation>最短长度</translation>
    </message>
  </context>
  <context>
    <name>Cable_Sleeve</name>
    <message>
      <source>Guides a cable in a direction and lets it twist at the selected edge or face, on the way of the cable that is selected with it</source>
      <translation>在所选边或面处沿一个方向引导线缆并允许其扭转，位于同时选中的线缆的路径上</translation>
    </message>
    <message>
      <source>Sleeve</source>
      <translation>套管</translation>
    </message>
  </context>
  <context>
    <name>Cable_Study</name>
    <message>
      <source>Makes a study of the selected cable, or runs the one that is selected</source>
      <translation>为所选线缆创建研究，或运行所选研究</translation>
    </message>
    <message>
      <source>Study</source>
      <translation>研究</translation>
    </message>
  </context>
  <context>
    <name>Cable_Terminal</name>
    <message>
      <source>Cable Terminal</source>
      <translation>线缆端子</translation>
    </message>
    <message>
      <source>Holds the end of a cable at the selected edge or face</source>
      <translation>在所选边或面处固定线缆的一端</translation>
    </message>
  </context>
  <context>
    <name>Sentence</name>
    <message>
      <source>, and neither mesh nor time allowed more</source>
      <translation>，而网格和时间都不允许更高精度</translation>
    </message>
    <message>
      <source>, line 1: {1}; the columns are {2}</source>
      <translation>，第 1 行：{1}；各列为 {2}</translation>
    </message>
    <message>
      <source>, line {1}</source>
      <translation>，第 {1} 行</translation>
    </message>
    <message>
      <source>, or empty</source>
      <translation>，或留空</translation>
    </message>
    <message>
      <source>, with elements fixed</source>
      <translation>，单元数为给定值</translation>
    </message>
    <message>
      <source>.</source>
      <translation>。</translation>
    </message>
    <message>
      <source>. </source>
      <translation>。</translation>
    </message>
    <message>
      <source>: </source>
      <translation>：</translation>
    </message>
    <message>
      <source>An equilibrium was found, but not to the tolerance asked for</source>
      <translation>找到了平衡，但未达到要求的公差</translation>
    </message>
    <message>
      <source>At {1} the cable is {2} nearer to {3} than {4} allows</source>
      <translation>在 {1} 处，线缆与{3}的距离比{4}所允许的近 {2}</translation>
    </message>
    <message>
      <source>Begins to buckle {1}</source>
      <translation>{1}开始屈曲</translation>
    </message>
    <message>
      <source>BendingStiffness lies outside of SlipBendingStiffness and StickBendingStiffness</source>
      <translation>BendingStiffness 不在 SlipBendingStiffness 和 StickBendingStiffness 之间</translation>
    </message>
    <message>
      <source>CasADi is not installed, so no cable can be solved; what was solved before can still be seen. Install it with: {1} casadi</source>
      <translation>未安装 CasADi，因此无法求解线缆；以前求解的结果仍可查看。安装命令：{1} casadi</translation>
    </message>
    <message>
      <source>Check lengths, stiffness and mass for a wrong unit</source>
      <translation>请检查长度、刚度和质量的单位是否有误</translation>
    </message>
    <message>
      <source>Check lengths, stiffness and mass for a wrong unit; a different length may be easier</source>
      <translation>请检查长度、刚度和质量的单位是否有误；换一个长度也许更容易求解</translation>
    </message>
    <message>
      <source>Diameter {1} mm, {2} g/m, {3}, GJ {4} N m²</source>
      <translation>直径 {1} mm，{2} g/m，{3}，GJ {4} N m²</translation>
    </message>
    <message>
      <source>EI {1} and {2} N m²</source>
      <translation>EI {1} 和 {2} N m²</translation>
    </message>
    <message>
      <source>Edge{1} of {2}</source>
      <translation>{2} 的 Edge{1}</translation>
    </message>
    <message>
      <source>Face{1} of {2}</source>
      <translation>{2} 的 Face{1}</translation>
    </message>
    <message>
      <source>Found anew: no equilibrium was found that the last shape becomes</source>
      <translation>重新求得：未找到由上一形状演变而来的平衡</translation>
    </message>
    <message>
      <source>From {1} mm to {2} mm it keeps its bend radius only if it is formed there, with a moment of {3} N m</source>
      <translation>从 {1} mm 到 {2} mm，只有在该处以 {3} N m 的力矩成形，才能满足弯曲半径</translation>
    </message>
    <message>
      <source>From {1} to {2} no length was found at which it is in equilibrium. At {3}: {4}</source>
      <translation>从 {1} 到 {2} 没有找到处于平衡的长度。在 {3}：{4}</translation>
    </message>
    <message>
      <source>If {1} than {2}, {3}</source>
      <translation>若比 {2} {1}，{3}</translation>
    </message>
    <message>
      <source>It bends to {1} at {2}; the limit is {3}</source>
      <translation>它在 {2} 处弯曲至 {1}；限值为 {3}</translation>
    </message>
    <message>
      <source>It is {1} s</source>
      <translation>时限为 {1} s</translation>
    </message>
    <message>
      <source>It may be too short to get past the obstacles, or have no way between them: try it longer, or with some of them left out</source>
      <translation>它可能太短，无法绕过障碍物，或者障碍物之间没有通路：请尝试加长，或去掉部分障碍物</translation>
    </message>
    <message>
      <source>It must be pushed from {1} at {2} to keep {3} clear</source>
      <translation>为保持 {3} 的间隙，必须在 {2} 处将它从{1}推开</translation>
    </message>
    <message>
      <source>Its length is only {1} % above the chord; give it more slack</source>
      <translation>其长度仅比直线距离长 {1} %；请增加余量</translation>
    </message>
    <message>
      <source>Its spreadsheet is not there; Run Study writes it anew</source>
      <translation>其表格不存在；请用“研究”命令重新写入</translation>
    </message>
    <message>
      <source>Jumps to another equilibrium {1}; its shape changes by {2} of the length</source>
      <translation>{1}跳到另一个平衡；其形状变化为长度的 {2}</translation>
    </message>
    <message>
      <source>Kept: {1}</source>
      <translation>保留：{1}</translation>
    </message>
    <message>
      <source>Left out: {1}</source>
      <translation>略去：{1}</translation>
    </message>
    <message>
      <source>No length up to {1} will do. The best is {2}, but {3}; a limit that this length keeps, other ends or supports, or a softer cable would help</source>
      <translation>{1} 以内没有可行的长度。最好的是 {2}，但{3}；放宽到该长度能满足的限值、更换端部或支撑，或使用更软的线缆会有帮助</translation>
    </message>
    <message>
      <source>No length will do everywhere. {1}</source>
      <translation>没有处处适用的长度。{1}</translation>
    </message>
    <message>
      <source>No length will do everywhere: {1} needs {2}, and {3} allows {4}</source>
      <translation>没有处处适用的长度：{1} 处需要 {2}，而 {3} 处允许 {4}</translation>
    </message>
    <message>
      <source>No results yet; Run Study makes them</source>
      <translation>尚无结果；请用“研究”命令生成</translation>
    </message>
    <message>
      <source>No shape of this cable satisfies all requirements</source>
      <translation>该线缆没有满足所有要求的形状</translation>
    </message>
    <message>
      <source>No shape yet</source>
      <translation>尚无形状</translation>
    </message>
    <message>
      <source>No shape yet: {1} cannot be computed ({2})</source>
      <translation>尚无形状：无法计算 {1}（{2}）</translation>
    </message>
    <message>
      <source>Out of date</source>
      <translation>已过期</translation>
    </message>
    <message>
      <source>Out of date: {1} cannot be computed ({2}). Shape and numbers are from before; mend it</source>
      <translation>已过期：无法计算 {1}（{2}）。形状和数值是之前的；请将其修复</translation>
    </message>
    <message>
      <source>Out of date; Run Study brings it up to date</source>
      <translation>已过期；请用“研究”命令更新</translation>
    </message>
    <message>
      <source>Recomputed from its nodes, its moments are out of balance by {1}</source>
      <translation>由节点重新计算，其力矩不平衡达 {1}</translation>
    </message>
    <message>
      <source>Row {1} is the worst: {2}</source>
      <translation>第 {1} 行最差：{2}</translation>
    </message>
    <message>
      <source>Solved by {1}, scheme {2}, {3} elements</source>
      <translation>求解器 {1}，格式 {2}，{3} 个单元</translation>
    </message>
    <message>
      <source>The arc length of node {1} is less than that of node {2}</source>
      <translation>节点 {1} 的弧长小于节点 {2} 的弧长</translation>
    </message>
    <message>
      <source>The cable bends to a radius of {1} mm at {2} mm from its start, and its section reaches farther than that to the inside of the bend: its surface would fold</source>
      <translation>线缆在距起点 {2} mm 处弯曲至半径 {1} mm，而其截面向弯曲内侧伸出更多：表面会折叠</translation>
    </message>
    <message>
      <source>The cable has {1} node(s); a shape needs at least 2</source>
      <translation>线缆有 {1} 个节点；形状至少需要 2 个</translation>
    </message>
    <message>
      <source>The cable is in equilibrium</source>
      <translation>线缆处于平衡</translation>
    </message>
    <message>
      <source>The cable is {1} mm long; a shape needs at least {2} mm</source>
      <translation>线缆长 {1} mm；形状至少需要 {2} mm</translation>
    </message>
    <message>
      <source>The cable passes through itself: its points at {1} mm and {2} mm from its start are {3} mm apart</source>
      <translation>线缆穿过自身：距起点 {1} mm 和 {2} mm 的两点相距 {3} mm</translation>
    </message>
    <message>
      <source>The cable runs through itself at {1} and {2}, {3} deep, and no equilibrium was found in which it does not; change its length or what holds it</source>
      <translation>线缆在 {1} 和 {2} 处穿过自身，深度 {3}，且未找到不穿过自身的平衡；请更改其长度或固定方式</translation>
    </message>
    <message>
      <source>The cable slides through {1} until nothing is left on one side of it; give that support an arc length, or hold the cable elsewhere</source>
      <translation>线缆在{1}中滑动，直到一侧不再有余长；请为该支撑指定位置，或在别处固定线缆</translation>
    </message>
    <message>
      <source>The cable turns by {1} rad between its nodes {2} and {3}; a shape needs less than {4} rad. Solve with more elements</source>
      <translation>线缆在节点 {2} 和 {3} 之间转过 {1} rad；形状要求小于 {4} rad。请用更多单元求解</translation>
    </message>
    <message>
      <source>The cable's shape would have {1} times the volume of its length. Solve with more elements</source>
      <translation>线缆形状的体积将是其长度对应体积的 {1} 倍。请用更多单元求解</translation>
    </message>
    <message>
      <source>The envelope is open between {1} and {2}: there shapes next to each other are up to {3} mm apart</source>
      <translation>包络在 {1} 与 {2} 之间是开口的：相邻形状在那里相距可达 {3} mm</translation>
    </message>
    <message>
      <source>The position error is estimated at {1} of the length; {2} was asked for</source>
      <translation>位置误差估计为长度的 {1}；要求为 {2}</translation>
    </message>
    <message>
      <source>The positions, tangents and arc lengths of the nodes do not belong together: two nodes are {1} mm apart and should be {2} mm apart</source>
      <translation>节点的位置、切线和弧长不一致：两个节点相距 {1} mm，应相距 {2} mm</translation>
    </message>
    <message>
      <source>The profile crosses or touches itself, so it bounds no section</source>
      <translation>轮廓与自身相交或接触，因此不能围成截面</translation>
    </message>
    <message>
      <source>The profile does not lie in its own xy-plane: z runs from {1} mm to {2} mm and must be 0</source>
      <translation>轮廓不在其自身的 xy 平面内：z 从 {1} mm 到 {2} mm，必须为 0</translation>
    </message>
    <message>
      <source>The profile has {1} faces; it must have one</source>
      <translation>轮廓有 {1} 个面；必须只有一个</translation>
    </message>
    <message>
      <source>The profile has {1} separate parts; it must have one (holes are allowed)</source>
      <translation>轮廓有 {1} 个分离的部分；必须只有一个（允许有孔）</translation>
    </message>
    <message>
      <source>The profile is empty; it must be a closed planar outline</source>
      <translation>轮廓为空；必须是封闭的平面轮廓</translation>
    </message>
    <message>
      <source>The profile is not closed; its edges must form closed outlines</source>
      <translation>轮廓未封闭；其边必须构成封闭轮廓</translation>
    </message>
    <message>
      <source>The profile is {1} mm across; it must be at least {2} mm</source>
      <translation>轮廓尺寸为 {1} mm；至少须为 {2} mm</translation>
    </message>
    <message>
      <source>The quaternion of node {1} has the length {2}; it must be 1</source>
      <translation>节点 {1} 的四元数长度为 {2}；必须为 1</translation>
    </message>
    <message>
      <source>The radius is {1} mm; it must be at least {2} mm</source>
      <translation>半径为 {1} mm；至少须为 {2} mm</translation>
    </message>
    <message>
      <source>The reference is {1}; it must be an object, or a pair of an object and the name of its edge or face, as in (connector, 'Edge7')</source>
      <translation>参照为 {1}；必须是一个对象，或一个对象与其边或面名称组成的对，例如 (connector, 'Edge7')</translation>
    </message>
    <message>
      <source>The report cannot be written: {1}: {2}; choose another folder</source>
      <translation>无法写入报告：{1}：{2}；请选择其他文件夹</translation>
    </message>
    <message>
      <source>The shape found is an equilibrium but not a stable one: the cable would leave it</source>
      <translation>找到的形状是平衡但不稳定：线缆会离开该形状</translation>
    </message>
    <message>
      <source>The shape it ended with is not held as its ends and supports say</source>
      <translation>求解结束时的形状不符合端部和支撑的固定方式</translation>
    </message>
    <message>
      <source>The solid of the cable could not be built: {1}</source>
      <translation>无法生成线缆的实体：{1}</translation>
    </message>
    <message>
      <source>The solid of the cable is not valid and closed</source>
      <translation>线缆的实体无效或未封闭</translation>
    </message>
    <message>
      <source>The solver found no equilibrium</source>
      <translation>求解器未找到平衡</translation>
    </message>
    <message>
      <source>The stretch {1}: {2}</source>
      <translation>{1}的一段：{2}</translation>
    </message>
    <message>
      <source>The time limit was reached before an equilibrium was found</source>
      <translation>在找到平衡之前已达到时限</translation>
    </message>
    <message>
      <source>The {1} of node {2} are not finite numbers</source>
      <translation>节点 {2} 的{1}不是有限数值</translation>
    </message>
    <message>
      <source>The {1} of the nodes have the shape {2}; it must be {3}</source>
      <translation>节点的{1}的维度为 {2}；必须为 {3}</translation>
    </message>
    <message>
      <source>There is no solved shape to draw. Solve the cable first</source>
      <translation>没有可绘制的求解形状。请先求解线缆</translation>
    </message>
    <message>
      <source>This CasADi has no plug-in {1}; install the casadi wheel from PyPI</source>
      <translation>此 CasADi 没有插件 {1}；请从 PyPI 安装 casadi</translation>
    </message>
    <message>
      <source>Update is {1}; Solve Now brings it up to date</source>
      <translation>Update 为 {1}；“立即求解”可将其更新</translation>
    </message>
    <message>
      <source>Vertex{1} of {2}</source>
      <translation>{2} 的 Vertex{1}</translation>
    </message>
    <message>
      <source>Warning</source>
      <translation>警告</translation>
    </message>
    <message>
      <source>a cable, which is taken as rigid: pushed with up to {1} N at a place, and that does not move it</source>
      <translation>一根线缆，视为刚性：在一处受到至多 {1} N 的推力，且不因此移动</translation>
    </message>
    <message>
      <source>a list of lists of 3 whole numbers</source>
      <translation>由 3 个整数的列表组成的列表</translation>
    </message>
    <message>
      <source>a number with the unit {1}</source>
      <translation>带单位 {1} 的数</translation>
    </message>
    <message>
      <source>a plain number</source>
      <translation>不带单位的数</translation>
    </message>
    <message>
      <source>a spline needs two points or more, each apart from the one before</source>
      <translation>样条需要两个或更多的点，且每个点与前一点不重合</translation>
    </message>
    <message>
      <source>all that holds the cable, but for one clamp at most, lets it twist</source>
      <translation>除至多一个夹具外，固定线缆的一切都允许其扭转</translation>
    </message>
    <message>
      <source>an end is free</source>
      <translation>有一端自由</translation>
    </message>
    <message>
      <source>arc lengths</source>
      <translation>弧长</translation>
    </message>
    <message>
      <source>are all {1}; at least two must differ</source>
      <translation>全部为 {1}；至少须有两个不同</translation>
    </message>
    <message>
      <source>are empty; name what varies</source>
      <translation>为空；请指明变化的量</translation>
    </message>
    <message>
      <source>are {1}, but none has an area: all corners of each are on one line or at one point</source>
      <translation>共 {1} 个，但都没有面积：每个的所有角点都在一条直线上或同一点</translation>
    </message>
    <message>
      <source>are {1}, which have {2} corners; at most {3} can be tried; draw cases at random instead</source>
      <translation>共 {1} 个，有 {2} 个角点组合；最多可试 {3} 个；请改用随机工况</translation>
    </message>
    <message>
      <source>are {1}; at most {2} can be solved; divide the cable at a clamp</source>
      <translation>共 {1} 个；最多可求解 {2} 个；请在夹具处将线缆分开</translation>
    </message>
    <message>
      <source>asks for a length, but {1}, so that any will do; give one</source>
      <translation>要求求出长度，但{1}，因此任何长度都可以；请给定一个</translation>
    </message>
    <message>
      <source>at least {1} lists of 3 numbers</source>
      <translation>至少 {1} 个由 3 个数组成的列表</translation>
    </message>
    <message>
      <source>at the centreline</source>
      <translation>在中心线处</translation>
    </message>
    <message>
      <source>at the inside of the bend</source>
      <translation>在弯曲内侧</translation>
    </message>
    <message>
      <source>at {1} it is held {2} mm inside {3}; two cables do not fit there, so hold one of them beside the other</source>
      <translation>在{1}处，它被固定在 {3} 内部 {2} mm；该处放不下两根线缆，请将其中一根固定在另一根旁边</translation>
    </message>
    <message>
      <source>bend radius</source>
      <translation>弯曲半径</translation>
    </message>
    <message>
      <source>bending</source>
      <translation>弯曲</translation>
    </message>
    <message>
      <source>bending in two directions</source>
      <translation>两个方向的弯曲</translation>
    </message>
    <message>
      <source>between {1} and {2}</source>
      <translation>在{1}与{2}之间</translation>
    </message>
    <message>
      <source>both ends are free and every support lets the cable slide, so it would slide out; hold an end or give a support an arc length</source>
      <translation>两端自由且每个支撑都允许线缆滑动，线缆会滑出；请固定一端，或为一个支撑指定位置</translation>
    </message>
    <message>
      <source>both ends are free, so nothing holds the cable; hold one of them</source>
      <translation>两端自由，线缆没有任何固定；请固定其中一端</translation>
    </message>
    <message>
      <source>do not part inside from outside at the edge from {1} to {2}: the triangles there do not all have the same side out, or one is missing; turn or add triangles</source>
      <translation>在从 {1} 到 {2} 的边处没有分开内外：该处三角形的外侧不一致，或缺少一个；请翻转或补充三角形</translation>
    </message>
    <message>
      <source>enclose {1} m³, which must be positive: they are clockwise seen from outside, or a sheet that is there twice; reverse each of them, or leave one layer out</source>
      <translation>包围的体积为 {1} m³，必须为正：从外侧看它们是顺时针，或是重复的一层；请逐个翻转，或去掉一层</translation>
    </message>
    <message>
      <source>end</source>
      <translation>终点</translation>
    </message>
    <message>
      <source>fatrop or ipopt</source>
      <translation>fatrop 或 ipopt</translation>
    </message>
    <message>
      <source>gravity</source>
      <translation>重力</translation>
    </message>
    <message>
      <source>gravity: there is none, or the cable has no mass (exact)</source>
      <translation>重力：没有重力，或线缆没有质量（精确）</translation>
    </message>
    <message>
      <source>has a column {1}</source>
      <translation>有多余的列 {1}</translation>
    </message>
    <message>
      <source>has more or fewer values than columns; put text with commas in quotes</source>
      <translation>的值数与列数不符；含逗号的文本请加引号</translation>
    </message>
    <message>
      <source>has no column {1}</source>
      <translation>没有列 {1}</translation>
    </message>
    <message>
      <source>has no one set of equilibria; give a length, and ask for each stretch alone</source>
      <translation>没有唯一的平衡集合；请给出长度，并分段求解</translation>
    </message>
    <message>
      <source>has no value at which the cable can be solved</source>
      <translation>没有可求解线缆的取值</translation>
    </message>
    <message>
      <source>has {1}</source>
      <translation>含有 {1}</translation>
    </message>
    <message>
      <source>has {1} entries; it takes one, or a vertex and a local coordinate system</source>
      <translation>有 {1} 项；应为一项，或一个顶点加一个局部坐标系</translation>
    </message>
    <message>
      <source>has {1} of {2}, which was deleted or moved</source>
      <translation>含有 {2} 的 {1}，它已被删除或移动</translation>
    </message>
    <message>
      <source>has {1} rows; it must have at least {2}</source>
      <translation>有 {1} 行；至少须有 {2} 行</translation>
    </message>
    <message>
      <source>has {1} twice; a cable passes a support once</source>
      <translation>两次含有 {1}；线缆只经过一个支撑一次</translation>
    </message>
    <message>
      <source>has {1}, which follows from the cable itself, so neither can be first; of two cables, only one can have the other as an obstacle</source>
      <translation>含有 {1}，它由线缆自身得出，因此无法确定先后；两根线缆中只能有一根以另一根为障碍物</translation>
    </message>
    <message>
      <source>has {1}, which has no solid; choose parts with solids</source>
      <translation>含有 {1}，它没有实体；请选择有实体的零件</translation>
    </message>
    <message>
      <source>has {1}, which is in another part or assembly than the cable; put both into the same</source>
      <translation>含有 {1}，它与线缆不在同一零件或装配中；请将两者放在一起</translation>
    </message>
    <message>
      <source>has {1}, which is no column; known are {2}</source>
      <translation>含有 {1}，它不是列；已知的有 {2}</translation>
    </message>
    <message>
      <source>has {1}, which is no support; choose clamps, sleeves, rings or clips</source>
      <translation>含有 {1}，它不是支撑；请选择夹具、套管、圆环或卡扣</translation>
    </message>
    <message>
      <source>has {1}; it may have {2}</source>
      <translation>含有 {1}；允许的是 {2}</translation>
    </message>
    <message>
      <source>has {1}; they must be finite numbers</source>
      <translation>包含 {1}；必须都是有限数值</translation>
    </message>
    <message>
      <source>is Enforce, but {1} has no limit; set its MinBendRadius, or use Check</source>
      <translation>为 Enforce，但 {1} 没有限值；请设置其 MinBendRadius，或使用 Check</translation>
    </message>
    <message>
      <source>is Shortest. {1}</source>
      <translation>为 Shortest。{1}</translation>
    </message>
    <message>
      <source>is an array {1} of {2}; it must be {3}</source>
      <translation>为 {2} 的数组 {1}；必须是{3}</translation>
    </message>
    <message>
      <source>is empty</source>
      <translation>为空</translation>
    </message>
    <message>
      <source>is empty: its object was deleted or never chosen. Choose an edge, a face or an object</source>
      <translation>为空：其对象已被删除或从未选择。请选择边、面或对象</translation>
    </message>
    <message>
      <source>is empty: the cable was deleted; delete this too or choose another</source>
      <translation>为空：线缆已被删除；请将此对象也删除，或另选一根</translation>
    </message>
    <message>
      <source>is empty; choose a terminal. One that is Free lets the end hang</source>
      <translation>为空；请选择端子。Free 的端子让该端悬垂</translation>
    </message>
    <message>
      <source>is empty; every type needs one</source>
      <translation>为空；每种类型都需要名称</translation>
    </message>
    <message>
      <source>is empty; it must have at least 1 row</source>
      <translation>为空；至少须有 1 行</translation>
    </message>
    <message>
      <source>is empty; name a number, as Length</source>
      <translation>为空；请指明一个数，例如 Length</translation>
    </message>
    <message>
      <source>is free; a route needs both ends held</source>
      <translation>是自由的；路径要求两端固定</translation>
    </message>
    <message>
      <source>is missing</source>
      <translation>缺失</translation>
    </message>
    <message>
      <source>is not given, so it cannot be enforced; give it</source>
      <translation>未给定，因此无法强制；请给出</translation>
    </message>
    <message>
      <source>is not known here; known are {1}</source>
      <translation>在此无法识别；可识别的有 {1}</translation>
    </message>
    <message>
      <source>is off, and there is no other tolerance; give one</source>
      <translation>已关闭，且没有其他公差；请给出一个</translation>
    </message>
    <message>
      <source>is on, but an end is free, so that any length would do; turn it off, or hold both ends</source>
      <translation>已开启，但有一端自由，任何长度都可以；请关闭它，或固定两端</translation>
    </message>
    <message>
      <source>is that of the start; a chord needs two points</source>
      <translation>与起点相同；直线需要两个点</translation>
    </message>
    <message>
      <source>is zero; a catenary needs a direction to hang in</source>
      <translation>为零；悬链线需要悬垂的方向</translation>
    </message>
    <message>
      <source>is {1} and so is From; give a range, or Values</source>
      <translation>为 {1}，From 也是；请给出范围，或给出 Values</translation>
    </message>
    <message>
      <source>is {1} and so is Start; choose two different terminals</source>
      <translation>为 {1}，Start 也是；请选择两个不同的端子</translation>
    </message>
    <message>
      <source>is {1} and the ends are {2} apart, which leaves no slack; an inextensible cable needs at least {3}, or give it an axial stiffness</source>
      <translation>为 {1}，而两端相距 {2}，没有余量；不可伸长的线缆至少需要 {3}，或为其指定轴向刚度</translation>
    </message>
    <message>
      <source>is {1} away from {2}, but the cable has only {3} on this side of it, so it does not reach; the cable must be longer or the support nearer</source>
      <translation>距{2} {1}，但线缆在这一侧只有 {3}，因此够不到；线缆须更长，或支撑须更近</translation>
    </message>
    <message>
      <source>is {1} mm; it must be greater than 0 mm, or let the cable slide (Slides)</source>
      <translation>为 {1} mm；必须大于 0 mm，或让线缆滑动（Slides）</translation>
    </message>
    <message>
      <source>is {1} mm; it must be less than the radius of {2} mm</source>
      <translation>为 {1} mm；必须小于半径 {2} mm</translation>
    </message>
    <message>
      <source>is {1} s; it must be greater than 0</source>
      <translation>为 {1} s；必须大于 0</translation>
    </message>
    <message>
      <source>is {1}, but the cable's radius is {2}, so it does not pass; take a wider ring or a thinner cable</source>
      <translation>为 {1}，但线缆半径为 {2}，因此无法通过；请用更大的圆环或更细的线缆</translation>
    </message>
    <message>
      <source>is {1}, but the points are {2} apart; make it at least that</source>
      <translation>为 {1}，但两点相距 {2}；请至少取该值</translation>
    </message>
    <message>
      <source>is {1}, but the terminals are {2} apart; the shortest possible length is {3}. Make the cable longer or bring the terminals closer</source>
      <translation>为 {1}，但端子相距 {2}；最短可能长度为 {3}。请加长线缆或将端子移近</translation>
    </message>
    <message>
      <source>is {1}, but {2} before it is at {3}; supports must be in order along the cable</source>
      <translation>为 {1}，但其前面的{2}位于 {3}；支撑须沿线缆依次排列</translation>
    </message>
    <message>
      <source>is {1}, but {2}, so there is no straight distance; use Fixed</source>
      <translation>为 {1}，但{2}，因此没有直线距离；请使用 Fixed</translation>
    </message>
    <message>
      <source>is {1}, but {2}; the shortest possible length is {3}</source>
      <translation>为 {1}，但{2}；最短可能长度为 {3}</translation>
    </message>
    <message>
      <source>is {1}, which does not change the cable; choose a number that it depends on</source>
      <translation>为 {1}，它不影响线缆；请选择线缆所依赖的数值</translation>
    </message>
    <message>
      <source>is {1}, which is in another part or assembly than the cable; put both into the same</source>
      <translation>为 {1}，它与线缆不在同一零件或装配中；请将两者放在一起</translation>
    </message>
    <message>
      <source>is {1}, which is no cable terminal; choose a terminal</source>
      <translation>为 {1}，它不是线缆端子；请选择端子</translation>
    </message>
    <message>
      <source>is {1}, which is no cable type</source>
      <translation>为 {1}，它不是线缆类型</translation>
    </message>
    <message>
      <source>is {1}, which is no cable; choose a cable</source>
      <translation>为 {1}，它不是线缆；请选择线缆</translation>
    </message>
    <message>
      <source>is {1}, which is not on the cable; its length is {2}</source>
      <translation>为 {1}，不在线缆上；线缆长度为 {2}</translation>
    </message>
    <message>
      <source>is {1}; it must be a finite number, at most {2} in size</source>
      <translation>为 {1}；必须是绝对值不超过 {2} 的有限数值</translation>
    </message>
    <message>
      <source>is {1}; it must be a list of 3 numbers</source>
      <translation>为 {1}；必须是 3 个数的列表</translation>
    </message>
    <message>
      <source>is {1}; it must be a list of {2} numbers</source>
      <translation>为 {1}；必须是 {2} 个数的列表</translation>
    </message>
    <message>
      <source>is {1}; it must be a number greater than 0 and at most {2}</source>
      <translation>为 {1}；必须是大于 0 且不超过 {2} 的数</translation>
    </message>
    <message>
      <source>is {1}; it must be a number{2}</source>
      <translation>为 {1}；必须是数值{2}</translation>
    </message>
    <message>
      <source>is {1}; it must be a whole number</source>
      <translation>为 {1}；必须是整数</translation>
    </message>
    <message>
      <source>is {1}; it must be a whole number from {2}</source>
      <translation>为 {1}；必须是不小于 {2} 的整数</translation>
    </message>
    <message>
      <source>is {1}; it must be an object</source>
      <translation>为 {1}；必须是对象</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 0</source>
      <translation>为 {1}；至少须为 0</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 1</source>
      <translation>为 {1}；至少须为 1</translation>
    </message>
    <message>
      <source>is {1}; it must be at least 2</source>
      <translation>为 {1}；至少须为 2</translation>
    </message>
    <message>
      <source>is {1}; it must be at least {2}</source>
      <translation>为 {1}；至少须为 {2}</translation>
    </message>
    <message>
      <source>is {1}; it must be between 1e-10 and 0.1</source>
      <translation>为 {1}；必须在 1e-10 与 0.1 之间</translation>
    </message>
    <message>
      <source>is {1}; it must be between 2 and 10000</source>
      <translation>为 {1}；必须在 2 与 10000 之间</translation>
    </message>
    <message>
      <source>is {1}; it must be from 0 to {2}, as there are {3} {4}</source>
      <translation>为 {1}；必须在 0 至 {2} 之间，因为共有 {3} {4}</translation>
    </message>
    <message>
      <source>is {1}; it must be greater than 0</source>
      <translation>为 {1}；必须大于 0</translation>
    </message>
    <message>
      <source>is {1}; it must be greater than {2}</source>
      <translation>为 {1}；必须大于 {2}</translation>
    </message>
    <message>
      <source>is {1}; it must be inside or centreline</source>
      <translation>为 {1}；必须是 inside 或 centreline</translation>
    </message>
    <message>
      <source>is {1}; it must be one of {2}</source>
      <translation>为 {1}；必须是 {2} 之一</translation>
    </message>
    <message>
      <source>is {1}; it must be {2}</source>
      <translation>为 {1}；必须是{2}</translation>
    </message>
    <message>
      <source>is {1}; it must begin with one of {2}, a comma, and the source</source>
      <translation>为 {1}；必须以 {2} 之一开头，后接逗号和来源</translation>
    </message>
    <message>
      <source>is {1}; it must lie between the bounds {2} (strands slip) and {3} (they stick)</source>
      <translation>为 {1}；必须在下限 {2}（股线滑移）与上限 {3}（股线粘着）之间</translation>
    </message>
    <message>
      <source>is {1}; its length is zero, so it gives no direction</source>
      <translation>为 {1}；其长度为零，因此没有方向</translation>
    </message>
    <message>
      <source>it bends to {1} at {2}, and {3} is the limit</source>
      <translation>它在 {2} 处弯曲至 {1}，而限值为 {3}</translation>
    </message>
    <message>
      <source>it does not act, the cable would be the same without it (exact)</source>
      <translation>不起作用，没有它线缆也一样（精确）</translation>
    </message>
    <message>
      <source>it does not lie as before: no equilibrium was found that its last shape becomes, and it may be too short to stay where it was. This one may be on another side of an obstacle, or have a turn more; look at it, or undo the change</source>
      <translation>它不再像之前那样放置：未找到由其上一形状演变而来的平衡，它可能太短而无法留在原处。当前形状可能位于障碍物的另一侧，或多出一圈；请查看，或撤销更改</translation>
    </message>
    <message>
      <source>it holds with the least margin</source>
      <translation>满足要求，但裕量最小</translation>
    </message>
    <message>
      <source>it is Moving, but has no MinBendRadiusMoving; MinBendRadius counts</source>
      <translation>它为 Moving，但没有 MinBendRadiusMoving；以 MinBendRadius 为准</translation>
    </message>
    <message>
      <source>it is being solved</source>
      <translation>正在求解</translation>
    </message>
    <message>
      <source>it is twisted by {1}° because {2} and {3} are Clamped, turned as the geometry of their parts happens to be; choose Swivel if the cable may turn while it is mounted, or set Roll</source>
      <translation>它扭转了 {1}°，因为 {2} 和 {3} 为 Clamped，其转角由零件几何偶然决定；若线缆在安装时可以转动，请选择 Swivel，或设置 Roll</translation>
    </message>
    <message>
      <source>it keeps clear of {1} at {2} mm from the start only because it is pushed away with {3} N, and nothing there does that: it would come nearer. Hold it there, or change its length</source>
      <translation>它在距起点 {2} mm 处与 {1} 保持间隙，只是因为被 {3} N 的力推开，而那里没有任何东西施加这个力：它会更靠近。请在该处固定它，或更改其长度</translation>
    </message>
    <message>
      <source>it must be pushed from {1} at {2} to keep {3} clear</source>
      <translation>为保持 {3} 的间隙，必须在 {2} 处将它从{1}推开</translation>
    </message>
    <message>
      <source>it passes a ring at an angle and is {1} mm inside the rim of the hole; no shape was found that keeps clear of it, so widen the hole, or change the length or the ring</source>
      <translation>它斜着穿过圆环，进入孔边缘 {1} mm；未找到避开边缘的形状，请扩孔，或更改长度或圆环</translation>
    </message>
    <message>
      <source>its ends are at one place</source>
      <translation>其两端在同一位置</translation>
    </message>
    <message>
      <source>its length</source>
      <translation>其长度</translation>
    </message>
    <message>
      <source>its length is not found yet</source>
      <translation>其长度尚未求出</translation>
    </message>
    <message>
      <source>its radius</source>
      <translation>其半径</translation>
    </message>
    <message>
      <source>its radius plus the clearance of {1}</source>
      <translation>其半径加上间隙 {1}</translation>
    </message>
    <message>
      <source>its smallest clearance is {1} mm where {2} mm is asked for: what holds the cable there leaves it no more room</source>
      <translation>其最小间隙为 {1} mm，要求为 {2} mm：该处固定线缆的部件没有留出更多空间</translation>
    </message>
    <message>
      <source>its solve was stopped; a recompute starts it again</source>
      <translation>求解已停止；重新计算会再次启动</translation>
    </message>
    <message>
      <source>leads out of its container; choose {1} anew</source>
      <translation>指向其容器之外；请重新选择 {1}</translation>
    </message>
    <message>
      <source>leads to an edge or a face of no size; choose another</source>
      <translation>指向没有大小的边或面；请另选</translation>
    </message>
    <message>
      <source>leaves {1} of cable between {2} and {3}, but {4}; the shortest possible is {5}</source>
      <translation>在{2}与{3}之间留下 {1} 线缆，但{4}；最短可能为 {5}</translation>
    </message>
    <message>
      <source>length</source>
      <translation>长度</translation>
    </message>
    <message>
      <source>longer</source>
      <translation>更长</translation>
    </message>
    <message>
      <source>longest</source>
      <translation>最长</translation>
    </message>
    <message>
      <source>moves by ({1}) mm and turns by the quaternion ({2}); give finite numbers, and the rotation an axis and an angle</source>
      <translation>移动 ({1}) mm 并按四元数 ({2}) 旋转；请给出有限的数值，并为旋转给出轴和角度</translation>
    </message>
    <message>
      <source>no length will do: {1}</source>
      <translation>没有可行的长度：{1}</translation>
    </message>
    <message>
      <source>no stiffness is given, so the cable is taken as rigid in {1}</source>
      <translation>未给定刚度，因此线缆视为不可{1}</translation>
    </message>
    <message>
      <source>obstacle {1}</source>
      <translation>障碍物 {1}</translation>
    </message>
    <message>
      <source>obstacles</source>
      <translation>障碍物</translation>
    </message>
    <message>
      <source>obstacles in reach: the cable keeps clear of them by itself (exact)</source>
      <translation>可及的障碍物：线缆自行避开（精确）</translation>
    </message>
    <message>
      <source>obstacles: all {1} are out of reach of a cable of this length (exact)</source>
      <translation>障碍物：全部 {1} 个都在此长度线缆的可及范围之外（精确）</translation>
    </message>
    <message>
      <source>obstacles: {1} of {2} are out of reach of a cable of this length (exact)</source>
      <translation>障碍物：{2} 个中有 {1} 个在此长度线缆的可及范围之外（精确）</translation>
    </message>
    <message>
      <source>of {1} became {2} where {3} was set; give values that it can take</source>
      <translation>（{1}）被设为 {3}，却变成 {2}；请给出它可以取的值</translation>
    </message>
    <message>
      <source>of {1} does not take {2}: {3}</source>
      <translation>（{1}）不接受 {2}：{3}</translation>
    </message>
    <message>
      <source>of {1} is {2}, which is no number; choose a numeric one</source>
      <translation>（{1}）为 {2}，不是数值；请选择数值属性</translation>
    </message>
    <message>
      <source>pinned, the other end free and no weight: the cable can turn freely; clamp this end or hold the other</source>
      <translation>仅固定位置，另一端自由且没有重量：线缆可自由转动；请将此端完全固定，或固定另一端</translation>
    </message>
    <message>
      <source>positions</source>
      <translation>位置</translation>
    </message>
    <message>
      <source>quaternions</source>
      <translation>四元数</translation>
    </message>
    <message>
      <source>rims of rings: no equilibrium was found that keeps clear of them; the cable passes one at an angle and is {1} nearer to it than its radius allows</source>
      <translation>圆环边缘：未找到避开边缘的平衡；线缆斜着穿过其中一个，与其距离比半径所允许的近 {1}</translation>
    </message>
    <message>
      <source>shear</source>
      <translation>剪切</translation>
    </message>
    <message>
      <source>shear and stretch</source>
      <translation>剪切和伸长</translation>
    </message>
    <message>
      <source>shorter</source>
      <translation>更短</translation>
    </message>
    <message>
      <source>shortest</source>
      <translation>最短</translation>
    </message>
    <message>
      <source>start</source>
      <translation>起点</translation>
    </message>
    <message>
      <source>stretch</source>
      <translation>伸长</translation>
    </message>
    <message>
      <source>summed along the cable they are {1} of its length, below the tolerance</source>
      <translation>沿线缆累计为其长度的 {1}，低于公差</translation>
    </message>
    <message>
      <source>support {1}</source>
      <translation>支撑 {1}</translation>
    </message>
    <message>
      <source>supports: the way through them leaves no slack between two of them; an inextensible cable needs some, or give it an axial stiffness</source>
      <translation>支撑：经过它们的路径在其中两个之间没有余量；不可伸长的线缆需要余量，或为其指定轴向刚度</translation>
    </message>
    <message>
      <source>the cable itself</source>
      <translation>线缆自身</translation>
    </message>
    <message>
      <source>the end is free to twist</source>
      <translation>终点可自由扭转</translation>
    </message>
    <message>
      <source>the ends are {1} apart</source>
      <translation>两端相距 {1}</translation>
    </message>
    <message>
      <source>the solver broke off: {1}</source>
      <translation>求解器中断：{1}</translation>
    </message>
    <message>
      <source>the start is free to twist</source>
      <translation>起点可自由扭转</translation>
    </message>
    <message>
      <source>the start of the cable</source>
      <translation>线缆的起点</translation>
    </message>
    <message>
      <source>the terminals are at the same point</source>
      <translation>两个端子在同一点</translation>
    </message>
    <message>
      <source>the tightest bend, {1} mm at {2} mm from the start, is tighter than the {3} mm that {4} allows ({5})</source>
      <translation>最急的弯曲为 {1} mm，距起点 {2} mm，小于 {4} 所允许的 {3} mm（{5}）</translation>
    </message>
    <message>
      <source>the way through its supports is {1}</source>
      <translation>经过其支撑的路径为 {1}</translation>
    </message>
    <message>
      <source>the way through the supports between them is {1}</source>
      <translation>经过其间支撑的路径为 {1}</translation>
    </message>
    <message>
      <source>there is no requirement</source>
      <translation>没有要求</translation>
    </message>
    <message>
      <source>they are {1} apart</source>
      <translation>它们相距 {1}</translation>
    </message>
    <message>
      <source>torsion</source>
      <translation>扭转</translation>
    </message>
    <message>
      <source>torsion: {1}</source>
      <translation>扭转：{1}</translation>
    </message>
    <message>
      <source>torsional</source>
      <translation>扭转</translation>
    </message>
    <message>
      <source>what it needs was deleted while it ran; all else is as it was</source>
      <translation>运行时其所需的对象被删除；其余一切保持原样</translation>
    </message>
    <message>
      <source>what the {1} stretches between clamps have to do with each other: each is solved alone (exact)</source>
      <translation>夹具之间 {1} 段的相互影响：每段单独求解（精确）</translation>
    </message>
    <message>
      <source>with this diameter, the mass means a density of {1} kg/m³, outside {2} to {3} kg/m³; check its unit and the diameter</source>
      <translation>按此直径，质量意味着密度为 {1} kg/m³，超出 {2} 至 {3} kg/m³；请检查其单位和直径</translation>
    </message>
    <message>
      <source>with this diameter, the {1} stiffness means a modulus of {2} Pa, outside {3} to {4} Pa; check its unit and the diameter</source>
      <translation>按此直径，{1}刚度意味着模量为 {2} Pa，超出 {3} 至 {4} Pa；请检查其单位和直径</translation>
    </message>
    <message>
      <source>{1} and the cable bends alike in all directions, so it carries no torque (exact)</source>
      <translation>{1}，且线缆各方向弯曲性能相同，因此不承受扭矩（精确）</translation>
    </message>
    <message>
      <source>{1} cannot be computed</source>
      <translation>{1} 无法计算</translation>
    </message>
    <message>
      <source>{1} cannot be drawn: {2}</source>
      <translation>{1} 无法绘制：{2}</translation>
    </message>
    <message>
      <source>{1} cannot be read as a table in UTF-8: {2}</source>
      <translation>{1} 无法作为 UTF-8 表格读取：{2}</translation>
    </message>
    <message>
      <source>{1} cannot be run while the document is recomputed</source>
      <translation>{1} 在文档重新计算期间无法运行</translation>
    </message>
    <message>
      <source>{1} cannot be written: {2}</source>
      <translation>{1} 无法写入：{2}</translation>
    </message>
    <message>
      <source>{1} contains {2}; refer to an edge, a face or an object inside it</source>
      <translation>{1} 包含 {2}；请引用其中的边、面或对象</translation>
    </message>
    <message>
      <source>{1} gives no direction for a cable; choose a circular edge, a flat or cylindrical face, a vertex, or an object with a placement such as a local coordinate system</source>
      <translation>{1} 不能给出线缆的方向；请选择圆形边、平面或圆柱面、顶点，或带有位置的对象，如局部坐标系</translation>
    </message>
    <message>
      <source>{1} has axes of its own; only a vertex takes a second entry</source>
      <translation>{1} 自带坐标轴；只有顶点可以有第二项</translation>
    </message>
    <message>
      <source>{1} holds the cable {2} inside {3}: hold it outside, or leave that obstacle out</source>
      <translation>{1} 将线缆固定在 {3} 内部 {2} 处：请固定在外部，或去掉该障碍物</translation>
    </message>
    <message>
      <source>{1} in {2} elements</source>
      <translation>{1}，{2} 个单元</translation>
    </message>
    <message>
      <source>{1} is an open mesh, so all that is behind its front is inside: close it if it is a solid, or leave it out</source>
      <translation>{1} 是开放网格，其正面之后的一切都算内部：如果它是实体请将其封闭，或将其去掉</translation>
    </message>
    <message>
      <source>{1} is missing: the part has changed. Choose another</source>
      <translation>{1} 不存在：零件已更改。请另选</translation>
    </message>
    <message>
      <source>{1} is not inside {2}, where {3} is, so the one cannot follow the other. Put both into the same part or assembly</source>
      <translation>{1} 不在 {3} 所在的 {2} 内，因此两者无法联动。请将两者放入同一零件或装配</translation>
    </message>
    <message>
      <source>{1} is not inside {2}: it was deleted or moved. Choose another</source>
      <translation>{1} 不在 {2} 内：它已被删除或移动。请另选</translation>
    </message>
    <message>
      <source>{1} is not solved; recompute it</source>
      <translation>{1} 未求解；请重新计算</translation>
    </message>
    <message>
      <source>{1} is stretched or mirrored by the scale of a link; let the link have one scale for all axes, greater than 0</source>
      <translation>{1} 被链接的缩放拉伸或镜像；请让链接在所有轴上使用同一个大于 0 的缩放</translation>
    </message>
    <message>
      <source>{1} is the {2} at which an equilibrium was found. At {3}: {4}</source>
      <translation>{1} 是找到平衡的{2}长度。在 {3}：{4}</translation>
    </message>
    <message>
      <source>{1} is the {2} that was tried</source>
      <translation>{1} 是尝试过的{2}长度</translation>
    </message>
    <message>
      <source>{1} is {2}, and {3} is {4}; give one</source>
      <translation>{1} 为 {2}，而 {3} 是{4}；请给出这样的数</translation>
    </message>
    <message>
      <source>{1} is {2}; it must be a number with its unit</source>
      <translation>{1} 为 {2}；必须是带单位的数</translation>
    </message>
    <message>
      <source>{1} of {2} cases hold</source>
      <translation>{2} 个工况中有 {1} 个满足要求</translation>
    </message>
    <message>
      <source>{1} of {2} stretches: unchanged since the last solution (exact)</source>
      <translation>{2} 段中的 {1} 段：自上次求解以来未变（精确）</translation>
    </message>
    <message>
      <source>{1} was stopped; the document is as it was</source>
      <translation>{1} 已停止；文档保持原样</translation>
    </message>
    <message>
      <source>{1} was stored by a later version of the Cable workbench; what this one does not know it leaves alone. Update the workbench</source>
      <translation>{1} 由更新版本的 Cable 工作台保存；本版本不认识的内容将保持不变。请更新工作台</translation>
    </message>
    <message>
      <source>{1}: only a placeholder; set what you know of this cable</source>
      <translation>{1}：仅为占位值；请填入已知的线缆数据</translation>
    </message>
    <message>
      <source>{1}; choose a cable type</source>
      <translation>{1}；请选择线缆类型</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>Cable</source>
      <translation>线缆</translation>
    </message>
  </context>
</TS>
