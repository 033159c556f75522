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
      <source>The number: Length, Placement.Base.x, Constraints.width, or a cell of a spreadsheet</source>
      <translation>数值：Length、Placement.Base.x、Constraints.width 或表格的单元格</translation>
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
    <name>Workbench</name>
    <message>
      <source>Cable</source>
      <translation>线缆</translation>
    </message>
  </context>
</TS>
