<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AccessibleNames</name>
    <message>
        <source>More menus</source>
        <translation>更多菜单</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>更多工具</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Float</source>
        <translation>浮动</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
</context>
<context>
    <name>BakeState</name>
    <message>
        <source>Follows the scene</source>
        <translation>跟随场景</translation>
    </message>
    <message>
        <source>Custom image %1</source>
        <translation>自定义图像 %1</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>Not used: its influence box reaches no visible object</source>
        <translation>未使用：其影响盒未触及任何可见物体</translation>
    </message>
    <message>
        <source>Out of date: capturing was stopped</source>
        <translation>已过期：捕捉已停止</translation>
    </message>
    <message>
        <source>Waiting for an image</source>
        <translation>等待图像</translation>
    </message>
    <message>
        <source>Out of date: waiting for capture</source>
        <translation>已过期：等待捕捉</translation>
    </message>
    <message>
        <source>Filtering the image</source>
        <translation>正在过滤图像</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translation>正在捕捉</translation>
    </message>
    <message>
        <source>Loaded from disk, up to date</source>
        <translation>已从磁盘加载，最新</translation>
    </message>
</context>
<context>
    <name>Choices</name>
    <message>
        <source>As this probe is filtered</source>
        <translation>与该探针的过滤方式一致</translation>
    </message>
    <message>
        <source>The right one: rough surfaces get the blur that belongs to them</source>
        <translation>正确的方式：粗糙表面得到与其相应的模糊</translation>
    </message>
    <message>
        <source>As Unity</source>
        <translation>同 Unity</translation>
    </message>
    <message>
        <source>To see the difference: the curve that Unity samples its probes by</source>
        <translation>用于比较差异：Unity 采样其探针所用的曲线</translation>
    </message>
    <message>
        <source>In proportion</source>
        <translation>按比例</translation>
    </message>
    <message>
        <source>To see the difference: the level in proportion to the roughness</source>
        <translation>用于比较差异：级别与粗糙度成正比</translation>
    </message>
    <message>
        <source>Unity&apos;s, exactly</source>
        <translation>与 Unity 完全一致</translation>
    </message>
    <message>
        <source>To see the difference: what Unity&apos;s curve approximates</source>
        <translation>用于比较差异：Unity 曲线所近似的原式</translation>
    </message>
    <message>
        <source>As Marmoset</source>
        <translation>同 Marmoset</translation>
    </message>
    <message>
        <source>To see the difference: Marmoset&apos;s curve, blurred sooner</source>
        <translation>用于比较差异：Marmoset 的曲线，更早变模糊</translation>
    </message>
    <message>
        <source>Three steps of blur</source>
        <translation>三级模糊</translation>
    </message>
    <message>
        <source>To see the difference: sharp, half and wholly blurred maps, mixed</source>
        <translation>用于比较差异：清晰、半模糊与全模糊贴图的混合</translation>
    </message>
    <message>
        <source>By the power above</source>
        <translation>按上方的幂次</translation>
    </message>
    <message>
        <source>The surface&apos;s own</source>
        <translation>表面自身的</translation>
    </message>
    <message>
        <source>Along the surface&apos;s lobe</source>
        <translation>沿表面的波瓣</translation>
    </message>
    <message>
        <source>Half of them towards what is bright</source>
        <translation>其中一半朝向明亮处</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
</context>
<context>
    <name>ExplanationHtml</name>
    <message>
        <source>smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Lengths in scene units, directions without, colours linear; swatches as the picture shows them.</source>
        <translation>长度以场景单位计，方向无单位，颜色为线性；色块与画面所示一致。</translation>
    </message>
</context>
<context>
    <name>FieldForm</name>
    <message>
        <source>%1 Default: %2</source>
        <translation>%1 默认：%2</translation>
    </message>
</context>
<context>
    <name>Handles</name>
    <message>
        <source>size %1 × %2 × %3 %4</source>
        <translation>尺寸 %1 × %2 × %3 %4</translation>
    </message>
    <message>
        <source>influence %1  %2 %3</source>
        <translation>影响范围 %1  %2 %3</translation>
    </message>
    <message>
        <source>blend %1  %2 %3</source>
        <translation>混合 %1  %2 %3</translation>
    </message>
    <message>
        <source>moved by %1 %2</source>
        <translation>移动了 %1 %2</translation>
    </message>
    <message>
        <source>rotation
%1°  %2°  %3°</source>
        <translation>旋转
%1°  %2°  %3°</translation>
    </message>
    <message>
        <source>origin
%1  %2  %3 %4</source>
        <translation>原点
%1  %2  %3 %4</translation>
    </message>
    <message>
        <source>steps of %1°</source>
        <translation>步长 %1°</translation>
    </message>
    <message>
        <source>on the wall under the pointer</source>
        <translation>位于指针下的墙上</translation>
    </message>
    <message>
        <source>on the wall ahead</source>
        <translation>位于前方的墙上</translation>
    </message>
    <message>
        <source>grid %1 %2</source>
        <translation>网格 %1 %2</translation>
    </message>
    <message>
        <source> Shift: finely. Ctrl: onto the wall under the pointer, or the grid. Alt: both sides.</source>
        <translation> Shift：精细。Ctrl：吸附到指针下的墙或网格。Alt：两侧同时。</translation>
    </message>
    <message>
        <source>Drag to move face %1 of %2.</source>
        <translation>拖动以移动 %2 的面 %1。</translation>
    </message>
    <message>
        <source>Drag to move face %1 of the influence box of %2.</source>
        <translation>拖动以移动 %2 影响盒的面 %1。</translation>
    </message>
    <message>
        <source>Drag to set over what distance %2 fades towards %1.</source>
        <translation>拖动以设置 %2 向 %1 淡出的距离。</translation>
    </message>
    <message>
        <source>Drag to move the capture origin of %2 along %1. Shift: finely. Ctrl: grid.</source>
        <translation>拖动以沿 %1 移动 %2 的捕捉原点。Shift：精细。Ctrl：网格。</translation>
    </message>
    <message>
        <source>Drag to move all of %2 along its %1. Shift: finely. Ctrl: grid.</source>
        <translation>拖动以沿自身 %1 轴移动整个 %2。Shift：精细。Ctrl：网格。</translation>
    </message>
    <message>
        <source>Drag to turn all of %2 about its %1. Shift: finely. Ctrl: by 15 degrees.</source>
        <translation>拖动以绕自身 %1 轴旋转整个 %2。Shift：精细。Ctrl：每次 15 度。</translation>
    </message>
    <message>
        <source>Click to select probe %1. Ctrl: beside those that are selected.</source>
        <translation>单击以选择探针 %1。Ctrl：加选。</translation>
    </message>
    <message>
        <source>Drag to move the capture origin of %1. X, Y, Z: along that axis. Shift: finely. Ctrl: grid.</source>
        <translation>拖动以移动 %1 的捕捉原点。X、Y、Z：沿该轴。Shift：精细。Ctrl：网格。</translation>
    </message>
    <message>
        <source>Move face %1 of %2</source>
        <translation>移动 %2 的面 %1</translation>
    </message>
    <message>
        <source>Move influence face %1 of %2</source>
        <translation>移动 %2 的影响面 %1</translation>
    </message>
    <message>
        <source>Set blend distance %1 of %2</source>
        <translation>设置 %2 的混合距离 %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>Move origin of %1</source>
        <translation>移动 %1 的原点</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Drag a ball, cube or arrow</source>
        <translation>拖动球、方块或箭头</translation>
    </message>
    <message>
        <source>moves a face, a blend distance, the probe; rings turn it</source>
        <translation>移动面、混合距离或探针；圆环用于旋转</translation>
    </message>
    <message>
        <source>Drag the diamond</source>
        <translation>拖动菱形</translation>
    </message>
    <message>
        <source>moves the capture origin; X, Y, Z held: along that axis</source>
        <translation>移动捕捉原点；按住 X、Y、Z：沿该轴</translation>
    </message>
    <message>
        <source>Shift, Ctrl, Alt while dragging</source>
        <translation>拖动时按 Shift、Ctrl、Alt</translation>
    </message>
    <message>
        <source>finely; onto walls or the grid; both sides</source>
        <translation>精细；吸附到墙或网格；两侧同时</translation>
    </message>
    <message>
        <source>1, 2, 3, 4</source>
        <translation>1、2、3、4</translation>
    </message>
    <message>
        <source>handles of box, influence, origin; move and turn</source>
        <translation>盒、影响范围、原点的手柄；移动和旋转</translation>
    </message>
    <message>
        <source>Arrows, Page up, Page down</source>
        <translation>方向键、Page Up、Page Down</translation>
    </message>
    <message>
        <source>nudge by 10 cm, with Shift by 1 cm; in a lesson: turn its pages</source>
        <translation>移动 10 cm，按住 Shift 为 1 cm；在课程中：翻页</translation>
    </message>
    <message>
        <source>Click; with Ctrl</source>
        <translation>单击；按住 Ctrl</translation>
    </message>
    <message>
        <source>selects a probe, an object and its material; several probes, Ctrl+A all</source>
        <translation>选择探针、物体及其材质；选择多个探针，Ctrl+A 全选</translation>
    </message>
    <message>
        <source>Double click; Shift+P</source>
        <translation>双击；Shift+P</translation>
    </message>
    <message>
        <source>selects the probe that lights this place; where the camera stands</source>
        <translation>选择照亮此处的探针；选择照亮相机所在处的探针</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ 和 ]</translation>
    </message>
    <message>
        <source>exposure: darker, brighter</source>
        <translation>曝光：变暗、变亮</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>右键单击</translation>
    </message>
    <message>
        <source>what can be done here</source>
        <translation>此处可执行的操作</translation>
    </message>
    <message>
        <source>Drag elsewhere</source>
        <translation>在别处拖动</translation>
    </message>
    <message>
        <source>turns about the point under the pointer</source>
        <translation>绕指针下的点旋转</translation>
    </message>
    <message>
        <source>Middle button, or Shift</source>
        <translation>中键，或 Shift</translation>
    </message>
    <message>
        <source>moves the view</source>
        <translation>平移视图</translation>
    </message>
    <message>
        <source>Wheel; Ctrl and drag</source>
        <translation>滚轮；Ctrl 加拖动</translation>
    </message>
    <message>
        <source>zooms to the pointer; zooms</source>
        <translation>向指针缩放；缩放</translation>
    </message>
    <message>
        <source>Right button held</source>
        <translation>按住右键</translation>
    </message>
    <message>
        <source>looks around; with W A S D, E, Q flies, the wheel sets the pace</source>
        <translation>环视；配合 W A S D、E、Q 飞行，滚轮调节速度</translation>
    </message>
    <message>
        <source>W A S D, G</source>
        <translation>W A S D、G</translation>
    </message>
    <message>
        <source>fly, Shift faster; walk at eye height on and off</source>
        <translation>飞行，Shift 加速；开关以视线高度行走</translation>
    </message>
    <message>
        <source>F, P, Home</source>
        <translation>F、P、Home</translation>
    </message>
    <message>
        <source>frame the selection; look from the probe; first camera</source>
        <translation>框显所选；从探针观察；第一个相机</translation>
    </message>
    <message>
        <source>H, Alt+H, /, Alt+B</source>
        <translation>H、Alt+H、/、Alt+B</translation>
    </message>
    <message>
        <source>hide the selection; show all; the selection alone; cut away what stands before it</source>
        <translation>隐藏所选；全部显示；仅显示所选；切除挡在前面的部分</translation>
    </message>
    <message>
        <source>Alt+X, Y, Z; with Shift</source>
        <translation>Alt+X、Y、Z；加 Shift</translation>
    </message>
    <message>
        <source>look along an axis; from its other side</source>
        <translation>沿轴观察；从另一侧观察</translation>
    </message>
    <message>
        <source>Ctrl+1 ... 9, Ctrl+K</source>
        <translation>Ctrl+1 ... 9、Ctrl+K</translation>
    </message>
    <message>
        <source>the scene&apos;s cameras; store this view</source>
        <translation>场景的相机；保存此视图</translation>
    </message>
    <message>
        <source>Ctrl+Z; Ctrl+Shift+Z, Ctrl+Y</source>
        <translation>Ctrl+Z；Ctrl+Shift+Z、Ctrl+Y</translation>
    </message>
    <message>
        <source>undo; redo</source>
        <translation>撤销；重做</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+D, Delete</source>
        <translation>Ctrl+C、Ctrl+V、Ctrl+D、Delete</translation>
    </message>
    <message>
        <source>copy, paste, duplicate, delete the selected probes</source>
        <translation>复制、粘贴、创建副本、删除所选探针</translation>
    </message>
    <message>
        <source>Ctrl+F, Ctrl+Shift+F</source>
        <translation>Ctrl+F、Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>fit the box; place probes in all rooms</source>
        <translation>拟合盒；在所有房间放置探针</translation>
    </message>
    <message>
        <source>F5, Shift+F5</source>
        <translation>F5、Shift+F5</translation>
    </message>
    <message>
        <source>bake the selected probes, all probes</source>
        <translation>烘焙所选探针、全部探针</translation>
    </message>
    <message>
        <source>Ctrl+B, Ctrl+R</source>
        <translation>Ctrl+B、Ctrl+R</translation>
    </message>
    <message>
        <source>boxes and handles, reflections on and off</source>
        <translation>开关盒与手柄、反射</translation>
    </message>
    <message>
        <source>C, Shift+C, V</source>
        <translation>C、Shift+C、V</translation>
    </message>
    <message>
        <source>compare with this picture, with all light ray traced; flip</source>
        <translation>与此画面比较、与全部光照的光线追踪比较；切换</translation>
    </message>
    <message>
        <source>Alt+C</source>
        <translation>Alt+C</translation>
    </message>
    <message>
        <source>four views side by side: techniques, ray traced, before, baked, live; with their errors</source>
        <translation>四个视图并排：各技术、光线追踪、之前、烘焙、实时；并显示误差</translation>
    </message>
    <message>
        <source>Shift+V, Ctrl+Shift+D</source>
        <translation>Shift+V、Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>the error against all light ray traced; the difference in false colours</source>
        <translation>相对全部光照光线追踪的误差；以伪彩色显示差异</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>explain the pixel under the pointer; a click pins it</source>
        <translation>解释指针下的像素；单击将其固定</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>cancels the drag, ends the comparison or stops capturing</source>
        <translation>取消拖动、结束比较或停止捕捉</translation>
    </message>
    <message>
        <source>?, F1, F11</source>
        <translation>?、F1、F11</translation>
    </message>
    <message>
        <source>these keys; the lessons; projector mode</source>
        <translation>这些按键；课程；投影模式</translation>
    </message>
    <message>
        <source>Ctrl+Shift and drag; Alt+Left, Right</source>
        <translation>Ctrl+Shift 加拖动；Alt+左、右</translation>
    </message>
    <message>
        <source>turns the sky&apos;s picture; by 5 degrees</source>
        <translation>转动天空图片；每次 5 度</translation>
    </message>
</context>
<context>
    <name>LanguageMenu</name>
    <message>
        <source>Languag&amp;e</source>
        <translation>语言 (Languag&amp;e)</translation>
    </message>
    <message>
        <source>Language: %1, when the window is opened the next time</source>
        <translation>语言：%1，将在下次打开窗口时生效</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>The language of the system, if there is a translation</source>
        <translation>系统的语言（如果有译文）</translation>
    </message>
    <message>
        <source>Not yet reviewed by a native speaker; corrections are welcome</source>
        <translation>尚未经母语者审校；欢迎指正</translation>
    </message>
</context>
<context>
    <name>PictureDifference</name>
    <message>
        <source>light %1, RMSE %2</source>
        <translation>光照 %1，RMSE %2</translation>
    </message>
    <message>
        <source>, noise %1</source>
        <translation>，噪声 %1</translation>
    </message>
</context>
<context>
    <name>PictureInset</name>
    <message>
        <source>from the side</source>
        <translation>侧面观察</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>俯视</translation>
    </message>
</context>
<context>
    <name>QMainWindow</name>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1 of HDRP&apos;s</source>
        <translation>HDRP 的 %1</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MiB</translation>
    </message>
    <message>
        <source> ms, </source>
        <translation> 毫秒，</translation>
    </message>
    <message>
        <source>%1. Quartiles: %2 to %3 ms</source>
        <translation>%1。四分位数：%2 至 %3 毫秒</translation>
    </message>
    <message>
        <source>This translation has not been reviewed by a native speaker yet.</source>
        <translation>此译文尚未经母语者审校。</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Boxprobe %1&lt;/h3&gt;&lt;p&gt;Reflection probes with box projection (parallax correction): move the box and the capture origin and watch the reflections follow.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Boxprobe %1&lt;/h3&gt;&lt;p&gt;带盒投影（视差校正）的反射探针：移动盒和捕捉原点，观察反射随之变化。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Orange: the projection box. Dashed: the probe has its full weight inside. Built on VTK, Qt, OpenEXR and GLM.</source>
        <translation>橙色：投影盒。虚线：其内部探针具有完整权重。基于 VTK、Qt、OpenEXR 和 GLM 构建。</translation>
    </message>
    <message>
        <source>About Boxprobe</source>
        <translation>关于 Boxprobe</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>鼠标与按键</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancelling</source>
        <translation>正在取消</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>正在加载 %1</translation>
    </message>
</context>
<context>
    <name>RayRig</name>
    <message>
        <source>Move the pointer over a surface with the Explain tool on (E).</source>
        <translation>打开“解释”工具（E），将指针移到表面上。</translation>
    </message>
    <message>
        <source>Click surfaces with the Explain tool on (E).</source>
        <translation>打开“解释”工具（E），单击表面。</translation>
    </message>
    <message>
        <source>Choose an object, or click one with the Explain tool on (E).</source>
        <translation>选择一个物体，或打开“解释”工具（E）单击一个。</translation>
    </message>
    <message>
        <source>Click the two ends with the Explain tool on (E).</source>
        <translation>打开“解释”工具（E），单击两个端点。</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 个点</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 个点</translation>
    </message>
    <message>
        <source>show rays in the debug dock first</source>
        <translation>请先在“调试”标签页中显示光线</translation>
    </message>
    <message>
        <source>no rays are shown that could be saved to %1; %2</source>
        <translation>没有显示可保存到 %1 的光线；%2</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>%1 in %2</source>
        <translation>%2 中的 %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Boxprobe ended without saving %1. Its changes up to %2 can be recovered.</source>
        <translation>Boxprobe 结束时未保存 %1。可以恢复截至 %2 的更改。</translation>
    </message>
    <message>
        <source>Nothing is written to the file itself until you save.</source>
        <translation>在您保存之前，文件本身不会被写入。</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Discard them</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>Ask &amp;later</source>
        <translation>稍后询问(&amp;L)</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>没有画面</translation>
    </message>
    <message>
        <source>The graphics driver was reset. Start Boxprobe again to see the scene.</source>
        <translation>图形驱动已重置。请重新启动 Boxprobe 以查看场景。</translation>
    </message>
    <message>
        <source>Unsaved changes are kept and offered after the start.</source>
        <translation>未保存的更改已保留，启动后会提示恢复。</translation>
    </message>
    <message>
        <source>Unsaved changes could not be kept. Save the scene first.</source>
        <translation>未能保留未保存的更改。请先保存场景。</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>重新启动(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>暂不(&amp;N)</translation>
    </message>
</context>
<context>
    <name>SchematicPainter</name>
    <message>
        <source>from the eye</source>
        <translation>来自眼睛</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>%1: cannot be read as settings; it is kept as %2, and settings start anew</source>
        <translation>%1：无法作为设置读取；已保留为 %2，设置重新开始</translation>
    </message>
    <message>
        <source>%1: cannot be read as settings, nor renamed to %2; settings last until the window closes</source>
        <translation>%1：无法作为设置读取，也无法重命名为 %2；设置仅保留到窗口关闭</translation>
    </message>
</context>
<context>
    <name>Tables</name>
    <message>
        <source>Name of the probe; each has its own.</source>
        <translation>探针的名称；每个探针各有其名。</translation>
    </message>
    <message>
        <source>Where the cubemap is captured.</source>
        <translation>捕捉立方体贴图的位置。</translation>
    </message>
    <message>
        <source>Projection box: its faces belong on the walls of the room.</source>
        <translation>投影盒：其各面应位于房间的墙上。</translation>
    </message>
    <message>
        <source>Turns the box about its centre: X, then Y, then Z.</source>
        <translation>绕盒中心旋转：先 X，再 Y，再 Z。</translation>
    </message>
    <message>
        <source>Box that the probe lights, in the frame of the projection box.</source>
        <translation>探针所照亮的盒，位于投影盒的坐标系中。</translation>
    </message>
    <message>
        <source>the projection box</source>
        <translation>投影盒</translation>
    </message>
    <message>
        <source>Nothing nearer to the origin is captured.</source>
        <translation>比此更靠近原点的内容不会被捕捉。</translation>
    </message>
    <message>
        <source>Nothing farther from the origin is captured; more than `near`.</source>
        <translation>比此更远离原点的内容不会被捕捉；须大于 `near`。</translation>
    </message>
    <message>
        <source>What the probe holds where it sees no object.</source>
        <translation>探针在看不到物体之处所含的内容。</translation>
    </message>
    <message>
        <source>the scene&apos;s sky, as the camera sees it</source>
        <translation>场景的天空，与相机所见相同</translation>
    </message>
    <message>
        <source>nothing: other probes, or the sky, fill in</source>
        <translation>无：由其他探针或天空填补</translation>
    </message>
    <message>
        <source>the current sky shows through, not box-projected; it may change without a recapture</source>
        <translation>透出当前的天空，不作盒投影；天空改变时无需重新捕捉</translation>
    </message>
    <message>
        <source>Distance inside the influence box over which the probe&apos;s weight rises from 0 to 1.</source>
        <translation>影响盒内的一段距离，探针的权重在其上从 0 升到 1。</translation>
    </message>
    <message>
        <source>Where probes overlap, the more important one takes its share first.</source>
        <translation>探针重叠处，较重要的先取其份额。</translation>
    </message>
    <message>
        <source>Factor on the probe&apos;s light; 1 is as captured.</source>
        <translation>探针光照的系数；1 为原捕捉值。</translation>
    </message>
    <message>
        <source>Off: looked up with the bare reflection vector, as if infinitely far away.</source>
        <translation>关：用未修正的反射向量查询，如同无限远。</translation>
    </message>
    <message>
        <source>Edge length of a cubemap face: larger is sharper and takes more memory.</source>
        <translation>立方体贴图一个面的边长：越大越清晰，占用内存越多。</translation>
    </message>
    <message>
        <source>Captures in turn, each with the last one&apos;s light; with 1, mirrors are black in their own probe.</source>
        <translation>依次捕捉，每次使用上一次的光照；为 1 时，镜面在其自身探针中为黑色。</translation>
    </message>
    <message>
        <source>until another changes the light they bring by less than 1 %, 16 at most</source>
        <translation>直到再捕捉一次带来的光照变化小于 1 %，最多 16 次</translation>
    </message>
    <message>
        <source>Where the probe&apos;s light comes from.</source>
        <translation>探针的光照来自何处。</translation>
    </message>
    <message>
        <source>captured when an input changes, and kept</source>
        <translation>输入改变时捕捉并保留</translation>
    </message>
    <message>
        <source>recaptured continuously, one face per frame; sees objects that move</source>
        <translation>持续重新捕捉，每帧一个面；能看到移动的物体</translation>
    </message>
    <message>
        <source>not captured: `image` takes the capture&apos;s place</source>
        <translation>不捕捉：由 `image` 代替捕捉</translation>
    </message>
    <message>
        <source>How the surroundings lie in the image.</source>
        <translation>环境在图像中的布局方式。</translation>
    </message>
    <message>
        <source>by the file&apos;s attributes, shape or name</source>
        <translation>按文件的属性、形状或名称</translation>
    </message>
    <message>
        <source>latitude-longitude, 2:1</source>
        <translation>经纬图，2:1</translation>
    </message>
    <message>
        <source>six faces in a row or column</source>
        <translation>六个面排成一行或一列</translation>
    </message>
    <message>
        <source>one file per face</source>
        <translation>每个面一个文件</translation>
    </message>
    <message>
        <source>From where the faces of a cube in the image are seen.</source>
        <translation>图像中立方体各面的观察方向。</translation>
    </message>
    <message>
        <source>as OpenGL and engines lay a cubemap out: right of +Z is +X</source>
        <translation>与 OpenGL 和引擎的立方体贴图布局相同：+Z 右侧为 +X</translation>
    </message>
    <message>
        <source>as in a photograph: right of +Z is -X, what a viewer in the middle has there</source>
        <translation>如同照片：+Z 右侧为 -X，即位于中心的观察者所见</translation>
    </message>
    <message>
        <source>Turns the image about the vertical, as `rotationDegrees` of the sky does: 90 takes +Z to +X.</source>
        <translation>绕竖直轴旋转图像，与天空的 `rotationDegrees` 相同：90 将 +Z 转到 +X。</translation>
    </message>
    <message>
        <source>How the image&apos;s texels hold radiance.</source>
        <translation>图像的纹素如何保存辐射亮度。</translation>
    </message>
    <message>
        <source>radiance as it is: .exr, .hdr</source>
        <translation>原样的辐射亮度：.exr、.hdr</translation>
    </message>
    <message>
        <source>multiplier * M^exponent * colour, M in alpha, colour bytes sRGB: Unity&apos;s RGBM</source>
        <translation>倍数 * M^指数 * 颜色，M 在 alpha 中，颜色字节为 sRGB：Unity 的 RGBM</translation>
    </message>
    <message>
        <source>multiplier * colour, colour bytes sRGB: Unity&apos;s double LDR</source>
        <translation>倍数 * 颜色，颜色字节为 sRGB：Unity 的双倍 LDR</translation>
    </message>
    <message>
        <source>as `rgbm`, the colour bytes linear</source>
        <translation>同 `rgbm`，颜色字节为线性</translation>
    </message>
    <message>
        <source>Decode instruction of the encoding: multiplier and exponent.</source>
        <translation>该编码的解码方式：倍数和指数。</translation>
    </message>
    <message>
        <source>How mip levels for rough surfaces are made from the capture.</source>
        <translation>如何由捕捉生成用于粗糙表面的 mip 级别。</translation>
    </message>
    <message>
        <source>as the renderer&apos;s rough surfaces reflect</source>
        <translation>与渲染器的粗糙表面反射方式一致</translation>
    </message>
    <message>
        <source>an angular Gaussian of CubeMapGen&apos;s widths: a soft, frosted look</source>
        <translation>采用 CubeMapGen 宽度的角度高斯：柔和的磨砂外观</translation>
    </message>
    <message>
        <source>Samples per captured texel: smoother edges, longer capture.</source>
        <translation>每个捕捉纹素的采样数：边缘更平滑，捕捉更久。</translation>
    </message>
    <message>
        <source>Filter samples per texel at mip level 1, doubled with each level: smoother around lamps, longer filtering.</source>
        <translation>mip 级别 1 每纹素的过滤采样数，逐级加倍：灯具周围更平滑，过滤更久。</translation>
    </message>
    <message>
        <source>Nodes this probe does not see, such as an object at its origin.</source>
        <translation>该探针看不到的节点，例如位于其原点的物体。</translation>
    </message>
    <message>
        <source>Rounds the edges of the projection box, so that reflections turn a corner instead of breaking at it.</source>
        <translation>使投影盒的棱变圆，反射在转角处平滑转过而不断裂。</translation>
    </message>
    <message>
        <source>sharp edges</source>
        <translation>锐利的棱</translation>
    </message>
    <message>
        <source>Darkens near reflections by mix(1, clamp(multiplier * d^power, 0, 1), strength), d metres along the reflected ray. A look; it makes no picture truer.</source>
        <translation>按 mix(1, clamp(倍数 * d^幂次, 0, 1), 强度) 压暗近处反射，d 为沿反射光线的米数。这是一种外观效果，不会使画面更真实。</translation>
    </message>
    <message>
        <source>Least corner.</source>
        <translation>最小角点。</translation>
    </message>
    <message>
        <source>Greatest corner; no component less than that of `min`.</source>
        <translation>最大角点；各分量不得小于 `min` 的分量。</translation>
    </message>
    <message>
        <source>Distances inside the -x, -y and -z faces.</source>
        <translation>-x、-y 和 -z 面内侧的距离。</translation>
    </message>
    <message>
        <source>Distances inside the +x, +y and +z faces.</source>
        <translation>+x、+y 和 +z 面内侧的距离。</translation>
    </message>
    <message>
        <source>Radius of the box&apos;s edges: reflections turn a corner instead of breaking at it; 0 is sharp.</source>
        <translation>盒棱的半径：反射在转角处平滑转过而不断裂；0 为锐利。</translation>
    </message>
    <message>
        <source>Radius added at roughness 1, in proportion to the roughness: rough surfaces show no edge.</source>
        <translation>粗糙度为 1 时增加的半径，与粗糙度成正比：粗糙表面不显棱线。</translation>
    </message>
    <message>
        <source>Openness at a distance of 1 m: 1 is fully open, 0.2 a fifth.</source>
        <translation>距离 1 m 处的开放度：1 为完全开放，0.2 为五分之一。</translation>
    </message>
    <message>
        <source>How fast it opens with distance: 1 in proportion, 0 not at all.</source>
        <translation>随距离开放的快慢：1 为成正比，0 为不变。</translation>
    </message>
    <message>
        <source>Share of the darkening that is applied.</source>
        <translation>所应用的压暗份额。</translation>
    </message>
    <message>
        <source>Kind of light.</source>
        <translation>光源的种类。</translation>
    </message>
    <message>
        <source>parallel light, such as the sun&apos;s</source>
        <translation>平行光，如太阳光</translation>
    </message>
    <message>
        <source>shines in every direction</source>
        <translation>向所有方向照射</translation>
    </message>
    <message>
        <source>shines in a cone</source>
        <translation>在锥体内照射</translation>
    </message>
    <message>
        <source>Direction the light travels in; any length.</source>
        <translation>光的传播方向；长度任意。</translation>
    </message>
    <message>
        <source>Where the light stands.</source>
        <translation>光源的位置。</translation>
    </message>
    <message>
        <source>Colour of the light, multiplied by its intensity.</source>
        <translation>光源的颜色，乘以其强度。</translation>
    </message>
    <message>
        <source>Directional: irradiance at normal incidence. Others: radiant intensity; irradiance falls with the square of the distance.</source>
        <translation>平行光：垂直入射时的辐照度。其他：辐射强度；辐照度随距离平方衰减。</translation>
    </message>
    <message>
        <source>Half angle of the cone within which the light is at full strength; less than `outerConeDegrees`.</source>
        <translation>光强完整的锥体半角；小于 `outerConeDegrees`。</translation>
    </message>
    <message>
        <source>Half angle of the cone beyond which it is dark.</source>
        <translation>锥体半角，超出即为黑暗。</translation>
    </message>
    <message>
        <source>Distance at which the light has faded to nothing; 0 is no limit.</source>
        <translation>光衰减为零的距离；0 为无限制。</translation>
    </message>
    <message>
        <source>What blocks the light where it stands outside of a probe&apos;s box. Ray-traced reflections trace it, but for `none`.</source>
        <translation>光源位于探针盒之外时由什么阻挡。除 `none` 外，光线追踪反射会追踪它。</translation>
    </message>
    <message>
        <source>no shadow that it asks for: where lamps are shapes, what stands still shadows it all the same; with lamps in the map it shines through walls</source>
        <translation>不要求阴影：灯具作为形状时，静止物体仍会遮挡；灯具在贴图中时光会穿墙</translation>
    </message>
    <message>
        <source>what the probe saw in the light&apos;s direction</source>
        <translation>探针在光源方向上所见的内容</translation>
    </message>
    <message>
        <source>the same, and a shadow map of the objects that move</source>
        <translation>同上，外加移动物体的阴影贴图</translation>
    </message>
    <message>
        <source>Whole angle its disc is seen under, which softens shadows; the sun&apos;s is 0.53.</source>
        <translation>其圆盘的整个视角，用于柔化阴影；太阳为 0.53。</translation>
    </message>
    <message>
        <source>Radius of the light&apos;s sphere, which softens shadows.</source>
        <translation>光源球体的半径，用于柔化阴影。</translation>
    </message>
    <message>
        <source>What chooses the mip level of the coverage: the softness.</source>
        <translation>由什么选择覆盖率的 mip 级别：即柔和度。</translation>
    </message>
    <message>
        <source>the light&apos;s size as seen from the surface</source>
        <translation>从表面看到的光源大小</translation>
    </message>
    <message>
        <source>in proportion to the distance to the wall, as published</source>
        <translation>与到墙的距离成正比，按已发表的方法</translation>
    </message>
    <message>
        <source>Mip levels per metre for `distance`; 0 spreads all levels over the longest distance in the probe&apos;s box.</source>
        <translation>`distance` 的每米 mip 级数；0 将所有级别分布在探针盒内的最长距离上。</translation>
    </message>
    <message>
        <source>Base colour, multiplied by the texture.</source>
        <translation>基础颜色，乘以纹理。</translation>
    </message>
    <message>
        <source>Perceptual roughness as in glTF: 0 is a mirror, 1 is fully rough.</source>
        <translation>与 glTF 相同的感知粗糙度：0 为镜面，1 为完全粗糙。</translation>
    </message>
    <message>
        <source>Radiance the surface emits.</source>
        <translation>表面发出的辐射亮度。</translation>
    </message>
    <message>
        <source>Strength of the normal texture.</source>
        <translation>法线纹理的强度。</translation>
    </message>
    <message>
        <source>Strength of a clear coat.</source>
        <translation>清漆层的强度。</translation>
    </message>
    <message>
        <source>Index of refraction: 1 bends nothing, water 1.33, glass 1.5, diamond 2.42. Below 1 the surroundings are denser.</source>
        <translation>折射率：1 不弯折，水 1.33，玻璃 1.5，钻石 2.42。低于 1 表示周围更致密。</translation>
    </message>
    <message>
        <source>Share of light that passes through the surface instead of being scattered: 1 is glass.</source>
        <translation>穿过表面而不被散射的光的份额：1 为玻璃。</translation>
    </message>
    <message>
        <source>Length of the path inside, for the forms that do not find it; 0 makes a thin sheet.</source>
        <translation>内部光程长度，用于无法自行求得的形态；0 为薄片。</translation>
    </message>
    <message>
        <source>Distance after which white light has `attenuationColor`; 0 absorbs nothing.</source>
        <translation>白光变为 `attenuationColor` 的距离；0 为不吸收。</translation>
    </message>
    <message>
        <source>What is left of white light after `attenuationDistance` (Beer&apos;s law).</source>
        <translation>经过 `attenuationDistance` 后白光所剩（比尔定律）。</translation>
    </message>
    <message>
        <source>A thin sheet: reflects on both sides, bends and absorbs nothing.</source>
        <translation>薄片：两面反射，不弯折也不吸收。</translation>
    </message>
    <message>
        <source>How the light&apos;s path through a transmissive material is found.</source>
        <translation>如何求得光在透射材质中的路径。</translation>
    </message>
    <message>
        <source>`two-interface` where a shell describes the object, thin walls where it is hollow, else `two-pass`</source>
        <translation>有外壳描述物体时为 `two-interface`，中空时为薄壁，否则为 `two-pass`</translation>
    </message>
    <message>
        <source>bent once, at the front, then looked up, as published</source>
        <translation>在正面弯折一次后查询，按已发表的方法</translation>
    </message>
    <message>
        <source>the same for the back faces, and the front faces blended over them, as published</source>
        <translation>背面亦然，并将正面混合在其上，按已发表的方法</translation>
    </message>
    <message>
        <source>followed through the object&apos;s shell, bent where it enters and leaves</source>
        <translation>穿过物体的外壳追踪，进出时各弯折一次</translation>
    </message>
    <message>
        <source>Drawn in the picture.</source>
        <translation>在画面中绘制。</translation>
    </message>
    <message>
        <source>Captured by probes. With `visible` false: a stand-in that only reflections show.</source>
        <translation>由探针捕捉。`visible` 为 false 时：仅在反射中出现的替身。</translation>
    </message>
    <message>
        <source>It moves: baked probes leave it out, so moving it needs no recapture; planar mirrors show it.</source>
        <translation>会移动：烘焙的探针不包含它，因此移动它无需重新捕捉；平面镜会显示它。</translation>
    </message>
    <message>
        <source>Which probes light this object. Ray-traced reflections take all for `blend+sky`.</source>
        <translation>哪些探针照亮此物体。光线追踪反射按 `blend+sky` 使用全部探针。</translation>
    </message>
    <message>
        <source>none: the sky alone</source>
        <translation>无：仅天空</translation>
    </message>
    <message>
        <source>one probe, no blending</source>
        <translation>一个探针，不混合</translation>
    </message>
    <message>
        <source>a blend of probes</source>
        <translation>混合多个探针</translation>
    </message>
    <message>
        <source>a blend of probes, and of the sky where they fade out</source>
        <translation>混合多个探针，并在其淡出处混合天空</translation>
    </message>
    <message>
        <source>Where the weights of probes are computed.</source>
        <translation>在何处计算探针的权重。</translation>
    </message>
    <message>
        <source>at each pixel</source>
        <translation>在每个像素处</translation>
    </message>
    <message>
        <source>once, from the share of its bounds inside a probe&apos;s influence box: cheaper, and wrong for large objects</source>
        <translation>一次，由其包围盒位于探针影响盒内的份额得出：更省，对大物体不准确</translation>
    </message>
    <message>
        <source>Moves the object from where its model puts it.</source>
        <translation>将物体从模型给定的位置移开。</translation>
    </message>
    <message>
        <source>Turns the object about its node&apos;s origin: X, then Y, then Z of the world.</source>
        <translation>绕节点原点旋转物体：先世界的 X，再 Y，再 Z。</translation>
    </message>
    <message>
        <source>Off: the entry is kept and does nothing.</source>
        <translation>关：保留该条目但不起作用。</translation>
    </message>
    <message>
        <source>A surface rougher than this has no mirrored picture and costs nothing.</source>
        <translation>比此更粗糙的表面没有镜像画面，也没有开销。</translation>
    </message>
    <message>
        <source>Texels of the mirrored picture per pixel of the screen, each way.</source>
        <translation>每个屏幕像素对应的镜像画面纹素数，每个方向。</translation>
    </message>
    <message>
        <source>Factor on linear light before tone mapping and the curve of sRGB.</source>
        <translation>色调映射和 sRGB 曲线之前的线性光系数。</translation>
    </message>
    <message>
        <source>How light beyond a display&apos;s white is shown. Linear pictures, errors and explanations are before it.</source>
        <translation>如何显示超出显示器白色的光。线性图像、误差和解释均在其之前。</translation>
    </message>
    <message>
        <source>Khronos PBR Neutral: base colours stay, highlights are compressed towards white</source>
        <translation>Khronos PBR 中性：基础颜色不变，高光向白色压缩</translation>
    </message>
    <message>
        <source>AgX: a long shoulder, bright colours become white</source>
        <translation>AgX：肩部较长，明亮的颜色变为白色</translation>
    </message>
    <message>
        <source>the Academy&apos;s contrast, by Hill&apos;s fit</source>
        <translation>学院（ACES）的对比度，采用 Hill 的拟合</translation>
    </message>
    <message>
        <source>What a picture shows where nothing stands; probes see the sky.</source>
        <translation>画面在没有物体处显示的内容；探针看到的是天空。</translation>
    </message>
    <message>
        <source>the sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>the sky as a rough surface reflects it</source>
        <translation>粗糙表面所反射的天空</translation>
    </message>
    <message>
        <source>a grey backdrop</source>
        <translation>灰色背景</translation>
    </message>
    <message>
        <source>one colour, `backgroundColor`</source>
        <translation>单一颜色，`backgroundColor`</translation>
    </message>
    <message>
        <source>What `color` shows, linear: the display&apos;s own colour, whatever exposure and tone.</source>
        <translation>`color` 所显示的颜色，线性：即显示器自身的颜色，与曝光和色调无关。</translation>
    </message>
    <message>
        <source>Everything together casts a soft shadow of the sky&apos;s light on a plane below it, in display colours only: no probe, mirror or linear picture shows it.</source>
        <translation>所有物体一起在下方平面上投下天空光的柔和阴影，仅用于显示颜色：探针、镜子和线性图像均不显示。</translation>
    </message>
    <message>
        <source>What stands in the scene hides the sky from its own hollows and contacts, where the sky alone lights it; probes show it without.</source>
        <translation>场景中的物体在仅由天空照亮之处，对自身的凹陷和接触处遮挡天空；探针不显示此效果。</translation>
    </message>
    <message>
        <source>What becomes of light that meets more than one microfacet of a rough surface.</source>
        <translation>照到粗糙表面不止一个微面元的光如何处理。</translation>
    </message>
    <message>
        <source>it is lost: rough metals darken</source>
        <translation>损失掉：粗糙金属变暗</translation>
    </message>
    <message>
        <source>it is added back, of lamps and probes alike (Turquin 2019)</source>
        <translation>加回，灯具和探针均如此（Turquin 2019）</translation>
    </message>
    <message>
        <source>How shining objects light diffuse surfaces.</source>
        <translation>发光物体如何照亮漫反射表面。</translation>
    </message>
    <message>
        <source>from the probe&apos;s map, alike all over its box</source>
        <translation>来自探针的贴图，盒内各处相同</translation>
    </message>
    <message>
        <source>flat lamps by their shapes, everything else by a lattice in the box</source>
        <translation>平面灯具按其形状，其余由盒内的格点提供</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Picture of linear radiance, .exr or .hdr: latitude-longitude, or a cube as a strip or a cross.</source>
        <translation>线性辐射亮度图片，.exr 或 .hdr：经纬图，或条带或十字形式的立方体。</translation>
    </message>
    <message>
        <source>The same radiance in every direction.</source>
        <translation>各方向相同的辐射亮度。</translation>
    </message>
    <message>
        <source>Radiance straight up.</source>
        <translation>正上方的辐射亮度。</translation>
    </message>
    <message>
        <source>Radiance at the horizon.</source>
        <translation>地平线处的辐射亮度。</translation>
    </message>
    <message>
        <source>Radiance straight down.</source>
        <translation>正下方的辐射亮度。</translation>
    </message>
    <message>
        <source>Turns the sky about the vertical: 90 takes +Z to +X. Probes that clear to `open` follow without a capture.</source>
        <translation>绕竖直轴旋转天空：90 将 +Z 转到 +X。清除为 `open` 的探针无需捕捉即可跟随。</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>The surfaces as drawn.</source>
        <translation>按绘制结果显示的表面。</translation>
    </message>
    <message>
        <source>Hit distance</source>
        <translation>命中距离</translation>
    </message>
    <message>
        <source>scene units</source>
        <translation>场景单位</translation>
    </message>
    <message>
        <source>From the surface along the reflected ray to where it leaves the probe&apos;s proxy: the d of the projection.</source>
        <translation>从表面沿反射光线到离开探针代理体之处：即投影中的 d。</translation>
    </message>
    <message>
        <source>True distance</source>
        <translation>真实距离</translation>
    </message>
    <message>
        <source>From the surface along the reflected ray to the captured surface, by the probe&apos;s distance cubemap.</source>
        <translation>从表面沿反射光线到所捕捉的表面，依据探针的距离立方体贴图。</translation>
    </message>
    <message>
        <source>Hit error</source>
        <translation>命中误差</translation>
    </message>
    <message>
        <source>Distance between the proxy&apos;s hit and the true hit: 0 where the scene is the box.</source>
        <translation>代理体命中点与真实命中点的距离：场景与盒一致处为 0。</translation>
    </message>
    <message>
        <source>Lookup error</source>
        <translation>查询误差</translation>
    </message>
    <message>
        <source>Angle at the capture origin between the sampled direction and the direction of the true hit.</source>
        <translation>在捕捉原点处，采样方向与真实命中点方向的夹角。</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>The sampled mip level; the mean if there are several lookups.</source>
        <translation>采样的 mip 级别；多次查询时为平均值。</translation>
    </message>
    <message>
        <source>Effective roughness</source>
        <translation>有效粗糙度</translation>
    </message>
    <message>
        <source>The roughness that the sampled mip level was filtered for.</source>
        <translation>采样的 mip 级别所对应的过滤粗糙度。</translation>
    </message>
    <message>
        <source>Lookup direction</source>
        <translation>查询方向</translation>
    </message>
    <message>
        <source>The sampled direction, x y z from -1 to 1 as red, green and blue.</source>
        <translation>采样方向，x y z 从 -1 到 1 显示为红、绿、蓝。</translation>
    </message>
    <message>
        <source>Probe weights</source>
        <translation>探针权重</translation>
    </message>
    <message>
        <source>Each probe&apos;s colour by its share of the pixel; dark grey is the sky&apos;s share.</source>
        <translation>各探针的颜色按其在像素中的份额；深灰为天空的份额。</translation>
    </message>
    <message>
        <source>Face hit</source>
        <translation>命中的面</translation>
    </message>
    <message>
        <source>The face of the box that the reflected ray hits: -x +x -y +y -z +z.</source>
        <translation>反射光线命中的盒面：-x +x -y +y -z +z。</translation>
    </message>
    <message>
        <source>Lookups</source>
        <translation>查询次数</translation>
    </message>
    <message>
        <source>Cubemap lookups at this pixel.</source>
        <translation>此像素的立方体贴图查询次数。</translation>
    </message>
    <message>
        <source>Diffuse light</source>
        <translation>漫反射光</translation>
    </message>
    <message>
        <source>Irradiance over pi of probes, lamps as shapes and sky: what a white matte surface would show.</source>
        <translation>探针、作为形状的灯具和天空的辐照度除以 π：即白色无光表面所显示的结果。</translation>
    </message>
    <message>
        <source>Node validity</source>
        <translation>节点有效性</translation>
    </message>
    <message>
        <source>Weight of lattice nodes with light of their own: 0 where all nodes around lie within things and are filled.</source>
        <translation>拥有自身光照的格点的权重：周围节点均位于物体内并被填充时为 0。</translation>
    </message>
    <message>
        <source>Diffuse error</source>
        <translation>漫反射误差</translation>
    </message>
    <message>
        <source>Distance between the diffuse light and a path tracer&apos;s, over the latter; hatched until it is traced.</source>
        <translation>漫反射光与路径追踪结果之差，除以后者；追踪完成前以阴影线显示。</translation>
    </message>
    <message>
        <source>Normal (painted on)</source>
        <translation>法线（贴附）</translation>
    </message>
    <message>
        <source>Samples along the surface normal: the picture sticks to the object.</source>
        <translation>沿表面法线采样：画面附着在物体上。</translation>
    </message>
    <message>
        <source>Infinite (no correction)</source>
        <translation>无限远（无校正）</translation>
    </message>
    <message>
        <source>Samples along the bare reflection vector: correct only for distant surroundings.</source>
        <translation>沿未修正的反射向量采样：仅对远处环境正确。</translation>
    </message>
    <message>
        <source>Sphere proxy</source>
        <translation>球形代理</translation>
    </message>
    <message>
        <source>Intersects the ray with the sphere around the box: straight walls bend.</source>
        <translation>将光线与包围盒的球求交：直墙会弯曲。</translation>
    </message>
    <message>
        <source>Box projection</source>
        <translation>盒投影</translation>
    </message>
    <message>
        <source>Box projection (parallax correction): intersects the ray with the probe&apos;s box; exact where the room is the box.</source>
        <translation>盒投影（视差校正）：将光线与探针的盒求交；房间即为该盒时精确。</translation>
    </message>
    <message>
        <source>Impostor (box refined)</source>
        <translation>替身（细化的盒）</translation>
    </message>
    <message>
        <source>Refines the box&apos;s hit by the captured distances, or follows the ray through them: for rooms that are not boxes.</source>
        <translation>用捕捉的距离细化盒上的命中点，或让光线在其中行进：用于非盒形的房间。</translation>
    </message>
    <message>
        <source>No contact hardening</source>
        <translation>无接触锐化</translation>
    </message>
    <message>
        <source>One lookup at the surface&apos;s own roughness, whatever the distance.</source>
        <translation>以表面自身的粗糙度查询一次，与距离无关。</translation>
    </message>
    <message>
        <source>Approximate hardening</source>
        <translation>近似锐化</translation>
    </message>
    <message>
        <source>Sharper where the reflected surface is nearer than the hardening length.</source>
        <translation>被反射的表面比锐化长度更近时更清晰。</translation>
    </message>
    <message>
        <source>HDRP / Frostbite hardening</source>
        <translation>HDRP / Frostbite 锐化</translation>
    </message>
    <message>
        <source>Sharper by the angle under which the capture origin sees the lobe&apos;s patch of wall.</source>
        <translation>按从捕捉原点看波瓣所覆盖墙面的角度变清晰。</translation>
    </message>
    <message>
        <source>Godot hardening</source>
        <translation>Godot 锐化</translation>
    </message>
    <message>
        <source>Sharper by distance and, by a Fresnel-like factor, at grazing angles.</source>
        <translation>按距离变清晰，并在掠射角处按类菲涅耳因子变清晰。</translation>
    </message>
    <message>
        <source>One footprint</source>
        <translation>一个足迹</translation>
    </message>
    <message>
        <source>One lookup at the mip level that matches the patch of wall under the lobe.</source>
        <translation>在与波瓣下墙面区域相符的 mip 级别查询一次。</translation>
    </message>
    <message>
        <source>Two footprints</source>
        <translation>两个足迹</translation>
    </message>
    <message>
        <source>Divides the lobe into 2 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>将波瓣分为 2 块，各按其区域的 mip 级别采样：反射在掠射角处拉长。</translation>
    </message>
    <message>
        <source>Four footprints</source>
        <translation>四个足迹</translation>
    </message>
    <message>
        <source>Divides the lobe into 4 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>将波瓣分为 4 块，各按其区域的 mip 级别采样：反射在掠射角处拉长。</translation>
    </message>
    <message>
        <source>Eight footprints</source>
        <translation>八个足迹</translation>
    </message>
    <message>
        <source>Divides the lobe into 8 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>将波瓣分为 8 块，各按其区域的 mip 级别采样：反射在掠射角处拉长。</translation>
    </message>
    <message>
        <source>Sixteen footprints</source>
        <translation>十六个足迹</translation>
    </message>
    <message>
        <source>Divides the lobe into 16 pieces, each sampled at the mip level of its patch: reflections stretch at grazing angles.</source>
        <translation>将波瓣分为 16 块，各按其区域的 mip 级别采样：反射在掠射角处拉长。</translation>
    </message>
    <message>
        <source>Ray-traced</source>
        <translation>光线追踪</translation>
    </message>
    <message>
        <source>Follows random rays of the surface&apos;s lobe to the proxy: the others approximate this; noisy with few rays.</source>
        <translation>沿表面波瓣的随机光线追踪到代理体：其他方法均为其近似；光线少时有噪声。</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Chooses for each object the cheapest evaluation whose measured error stays within the budget at its roughness.</source>
        <translation>为每个物体选择在其粗糙度下实测误差不超预算的最省的求值方法。</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>采样数</translation>
    </message>
    <message>
        <source>Reflected rays per pixel, each one lookup.</source>
        <translation>每像素的反射光线数，每条查询一次。</translation>
    </message>
    <message>
        <source>Rays in all</source>
        <translation>光线总数</translation>
    </message>
    <message>
        <source>Of an animated picture: rays per pixel of all frames that are averaged, which each ray&apos;s blur is made for. 0: of one frame, whose blur stays however many frames there are.</source>
        <translation>对动画画面：所平均的全部帧中每像素的光线数，每条光线的模糊据此确定。0：按单帧计，模糊不随帧数改变。</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>图案</translation>
    </message>
    <message>
        <source>How rays are spread: at random (white), evenly with fine-grained noise (blue), evenly with a shift per pixel (r2), or equally in every pixel (deterministic), which shows ghosts instead of noise.</source>
        <translation>光线如何分布：随机（white）、均匀且带细粒噪声（blue）、均匀且逐像素偏移（r2），或每像素相同（deterministic），后者显示重影而非噪声。</translation>
    </message>
    <message>
        <source>Animated</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>Draws a new pattern every frame and averages the frames.</source>
        <translation>每帧绘制新的图案并对各帧取平均。</translation>
    </message>
    <message>
        <source>Level offset</source>
        <translation>级别偏移</translation>
    </message>
    <message>
        <source>Blurs each ray&apos;s lookup by its share of the lobe and the distance to what it hits.</source>
        <translation>按每条光线在波瓣中的份额及其命中距离模糊其查询。</translation>
    </message>
    <message>
        <source>Filtered</source>
        <translation>已过滤</translation>
    </message>
    <message>
        <source>Blurs each ray&apos;s lookup by the patch of wall it stands for: far less noise and error.</source>
        <translation>按每条光线所代表的墙面区域模糊其查询：噪声和误差大为减少。</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Distribution of the rays: the surface&apos;s lobe, or half of them from the probe&apos;s brightness, for small lights. Blurred rays find lights by themselves and come from the lobe alone.</source>
        <translation>光线的分布：表面的波瓣，或其中一半按探针的亮度，用于小光源。经模糊的光线自会找到光源，仅来自波瓣。</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>模糊</translation>
    </message>
    <message>
        <source>Smooths the sampled picture, but not across different normals.</source>
        <translation>平滑采样的画面，但不跨越不同的法线。</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>幂次</translation>
    </message>
    <message>
        <source>Exponent of the Fresnel-like factor (1 - N.V)^power: the higher, the closer to grazing it sets in. Published: 4; 2 and 3 are cheaper forms.</source>
        <translation>类菲涅耳因子 (1 - N.V)^幂次 的指数：越高，越接近掠射才起作用。已发表值：4；2 和 3 为更省的形式。</translation>
    </message>
    <message>
        <source>Hardening length</source>
        <translation>锐化长度</translation>
    </message>
    <message>
        <source>Distance from the surface to the reflected surface at which the reflection has its full roughness. Published: 6.</source>
        <translation>反射达到完整粗糙度时，表面到被反射表面的距离。已发表值：6。</translation>
    </message>
    <message>
        <source>Fresnel</source>
        <translation>菲涅耳</translation>
    </message>
    <message>
        <source>Factor towards grazing angles: the one above, or the surface&apos;s own Fresnel reflectance.</source>
        <translation>朝向掠射角的因子：上方的因子，或表面自身的菲涅耳反射率。</translation>
    </message>
    <message>
        <source>Blur by roughness</source>
        <translation>按粗糙度模糊</translation>
    </message>
    <message>
        <source>How blurred the reflection is at each roughness: the curve to the mip level. Own is what the levels were filtered for; the others show a mismatch.</source>
        <translation>各粗糙度下反射的模糊程度：到 mip 级别的曲线。Own 为各级别过滤时所用；其他的会显示不匹配。</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步数</translation>
    </message>
    <message>
        <source>Lookups of the captured distances that refine the box&apos;s hit: 1 at the hit, 2 also on the way to it, 3 also behind it; from 4 on the most that following the ray through them may take: 24 are enough.</source>
        <translation>细化盒上命中点的捕捉距离查询次数：1 在命中点，2 还包括途中，3 还包括其后；从 4 起为沿光线行进的最大次数：24 已足够。</translation>
    </message>
    <message>
        <source>Error budget</source>
        <translation>误差预算</translation>
    </message>
    <message>
        <source>Largest accepted error, RMSE of (x/(1+x))^(1/2.2) as `boxprobe bench` measures it.</source>
        <translation>可接受的最大误差，即 `boxprobe bench` 所测的 (x/(1+x))^(1/2.2) 的 RMSE。</translation>
    </message>
    <message>
        <source>0 is a dielectric, 1 a metal.</source>
        <translation>0 为电介质，1 为金属。</translation>
    </message>
    <message>
        <source>4:3 or 3:4</source>
        <translation>4:3 或 3:4</translation>
    </message>
    <message>
        <source>reflection</source>
        <translation>反射</translation>
    </message>
    <message>
        <source>light of probes and sky: projection, lookups, harmonics, weights</source>
        <translation>探针与天空的光照：投影、查询、球谐、权重</translation>
    </message>
    <message>
        <source>light loop</source>
        <translation>光源循环</translation>
    </message>
    <message>
        <source>lamps, their shadows by coverage included</source>
        <translation>灯具，含按覆盖率的阴影</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>textures and normal maps</source>
        <translation>纹理与法线贴图</translation>
    </message>
    <message>
        <source>output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>conversion to display colours</source>
        <translation>转换为显示颜色</translation>
    </message>
    <message>
        <source>other shading</source>
        <translation>其他着色</translation>
    </message>
    <message>
        <source>what is left of the pixels&apos; programs: normals, the view vector, the split sum</source>
        <translation>像素程序的其余部分：法线、视线向量、split sum</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>pixels found, tested for depth and written, of one colour</source>
        <translation>找到、深度测试并写入的像素，单一颜色</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>vertices and VTK&apos;s calls for each object</source>
        <translation>顶点以及 VTK 对每个物体的调用</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>the sky behind everything</source>
        <translation>所有物体后面的天空</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>环境光遮蔽</translation>
    </message>
    <message>
        <source>what the scene hides of its own sky, if it is asked to</source>
        <translation>场景对自身天空的遮挡（若启用）</translation>
    </message>
    <message>
        <source>ground shadow</source>
        <translation>地面阴影</translation>
    </message>
    <message>
        <source>the soft shadow below everything, if the scene has it</source>
        <translation>所有物体下方的柔和阴影（若场景有）</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>a frame of nothing: cleared, samples resolved, VTK&apos;s own work</source>
        <translation>空帧：清除、解析采样以及 VTK 自身的工作</translation>
    </message>
    <message>
        <source>What becomes of a sun in the image, a small bright disc.</source>
        <translation>图片中的太阳（一个明亮的小圆盘）如何处理。</translation>
    </message>
    <message>
        <source>it is drawn as a directional light, with its shadow, and taken out of the image</source>
        <translation>作为平行光连同其阴影绘制，并从图片中取出</translation>
    </message>
    <message>
        <source>it stays in the image</source>
        <translation>保留在图片中</translation>
    </message>
    <message>
        <source>eye ray</source>
        <translation>视线</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>reflected ray</source>
        <translation>反射光线</translation>
    </message>
    <message>
        <source>lookup</source>
        <translation>查询</translation>
    </message>
    <message>
        <source>sample</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>true hit</source>
        <translation>真实命中点</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>within glass</source>
        <translation>玻璃内</translation>
    </message>
    <message>
        <source>refracted ray</source>
        <translation>折射光线</translation>
    </message>
    <message>
        <source>shadow ray</source>
        <translation>阴影光线</translation>
    </message>
    <message>
        <source>nodes about 1 m apart, closer where light falls steeply</source>
        <translation>节点间距约 1 m，光照变化陡处更密</translation>
    </message>
    <message>
        <source>Distance between the nodes, about: at least 2 and at most 16 of them stand along each axis.</source>
        <translation>节点之间的大致距离：每个轴上至少 2 个、至多 16 个。</translation>
    </message>
    <message>
        <source>The nodes at which diffuse light is known; with `false` there are none, and the whole map lights every place alike.</source>
        <translation>已知漫反射光的节点；设为 `false` 时没有节点，整张贴图对各处的照明相同。</translation>
    </message>
</context>
<context>
    <name>TypedNumber</name>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more than one separator: type one decimal mark and no separator of thousands</source>
        <translation>“%1”含有多个分隔符：请只输入一个小数点，不要输入千位分隔符</translation>
    </message>
    <message>
        <source>&quot;%1&quot; mixes digits of two scripts</source>
        <translation>“%1”混用了两种文字的数字</translation>
    </message>
    <message>
        <source>A number is missing</source>
        <translation>缺少数字</translation>
    </message>
</context>
<context>
    <name>WindowWords</name>
    <message>
        <source>Choose it under Model &gt; Unit and up axis</source>
        <translation>请在“模型 &gt; 单位与向上轴”中选择</translation>
    </message>
    <message>
        <source>choose it under Model &gt; Unit and up axis</source>
        <translation>请在“模型 &gt; 单位与向上轴”中选择</translation>
    </message>
    <message>
        <source>or choose Model &gt; Treat as &gt; Interior</source>
        <translation>或选择“模型 &gt; 视为 &gt; 室内”</translation>
    </message>
</context>
<context>
    <name>boxprobe</name>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>%1 已存在。要替换吗？</translation>
    </message>
</context>
<context>
    <name>boxprobe::Actions</name>
    <message>
        <source>Handles on the faces of the projection box: a filled ball at the maximum, a hollow one at the minimum</source>
        <translation>投影盒各面上的手柄：最大侧为实心球，最小侧为空心球</translation>
    </message>
    <message>
        <source>Balls on the influence box, cubes on the box inside which the probe has its full weight</source>
        <translation>球位于影响盒上，方块位于探针具有完整权重的盒上</translation>
    </message>
    <message>
        <source>Arrows at the capture origin</source>
        <translation>捕捉原点处的箭头</translation>
    </message>
    <message>
        <source>Moves and turns the whole probe</source>
        <translation>移动和旋转整个探针</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>从 %1</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>打开(&amp;O)...</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>重新加载(&amp;R)</translation>
    </message>
    <message>
        <source>S&amp;ky from a picture...</source>
        <translation>从图片设置天空(&amp;K)...</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>另存为(&amp;A)...</translation>
    </message>
    <message>
        <source>&amp;Export image...</source>
        <translation>导出图像(&amp;E)...</translation>
    </message>
    <message>
        <source>Export &amp;probes...</source>
        <translation>导出探针(&amp;P)...</translation>
    </message>
    <message>
        <source>&amp;Live link...</source>
        <translation>实时链接(&amp;L)...</translation>
    </message>
    <message>
        <source>Save &amp;baked probes...</source>
        <translation>保存烘焙的探针(&amp;B)...</translation>
    </message>
    <message>
        <source>Repor&amp;t...</source>
        <translation>报告(&amp;T)...</translation>
    </message>
    <message>
        <source>One HTML file: every camera drawn and path traced, the probes with their fit and cost</source>
        <translation>一个 HTML 文件：每个相机的绘制与路径追踪结果，以及探针的拟合与开销</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Add probe</source>
        <translation>添加探针(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Duplicate probe</source>
        <translation>创建探针副本(&amp;D)</translation>
    </message>
    <message>
        <source>De&amp;lete probe</source>
        <translation>删除探针(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Copy probe</source>
        <translation>复制探针(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste probes</source>
        <translation>粘贴探针(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Select all probes</source>
        <translation>选择所有探针(&amp;S)</translation>
    </message>
    <message>
        <source>Select the probe &amp;here</source>
        <translation>选择此处的探针(&amp;H)</translation>
    </message>
    <message>
        <source>The probe that lights the place where the camera stands</source>
        <translation>照亮相机所在处的探针</translation>
    </message>
    <message>
        <source>&amp;Fit box</source>
        <translation>拟合盒(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Place probes</source>
        <translation>放置探针(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Bake probe</source>
        <translation>烘焙探针(&amp;B)</translation>
    </message>
    <message>
        <source>Ba&amp;ke all probes</source>
        <translation>烘焙所有探针(&amp;K)</translation>
    </message>
    <message>
        <source>Cancel the drag or stop capturing</source>
        <translation>取消拖动或停止捕捉</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>重置视图(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Frame the selection</source>
        <translation>框显所选(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Look from the probe</source>
        <translation>从探针观察(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Walk at eye height</source>
        <translation>以视线高度行走(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Hide the selection</source>
        <translation>隐藏所选(&amp;H)</translation>
    </message>
    <message>
        <source>In this window alone; the scene&apos;s file, captures and exported pictures have it</source>
        <translation>仅在此窗口中；场景文件、捕捉和导出的图像仍包含它</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>显示所有隐藏项(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Isolate the selection</source>
        <translation>隔离所选(&amp;I)</translation>
    </message>
    <message>
        <source>Of a probe: with the objects that reach into its box. Once more shows the others again</source>
        <translation>对于探针：连同伸入其盒内的物体。再次执行则重新显示其他内容</translation>
    </message>
    <message>
        <source>Cu&amp;t away what hides the probe&apos;s box</source>
        <translation>切除遮挡探针盒的部分(&amp;T)</translation>
    </message>
    <message>
        <source>Looks into a room from outside. Exported pictures, errors and captures are not cut</source>
        <translation>从外部看进房间。导出的图像、误差和捕捉不受切除影响</translation>
    </message>
    <message>
        <source>&amp;Hold this picture</source>
        <translation>保留此画面(&amp;H)</translation>
    </message>
    <message>
        <source>With &amp;all light, path traced</source>
        <translation>与全部光照的路径追踪比较(&amp;A)</translation>
    </message>
    <message>
        <source>With the &amp;reflection alone ray traced</source>
        <translation>仅反射使用光线追踪(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Error against all light, path traced</source>
        <translation>相对全部光照路径追踪的误差(&amp;E)</translation>
    </message>
    <message>
        <source>The &amp;difference in false colours</source>
        <translation>以伪彩色显示差异(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Flip to the other picture</source>
        <translation>切换到另一画面(&amp;F)</translation>
    </message>
    <message>
        <source>Four &amp;views side by side</source>
        <translation>四个视图并排(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Stop comparing</source>
        <translation>停止比较(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation>变亮(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation>变暗(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Expose automatically</source>
        <translation>自动曝光(&amp;E)</translation>
    </message>
    <message>
        <source>To the &amp;left</source>
        <translation>向左(&amp;L)</translation>
    </message>
    <message>
        <source>To the &amp;right</source>
        <translation>向右(&amp;R)</translation>
    </message>
    <message>
        <source>Ground shado&amp;w</source>
        <translation>地面阴影(&amp;W)</translation>
    </message>
    <message>
        <source>Ambient occl&amp;usion</source>
        <translation>环境光遮蔽(&amp;U)</translation>
    </message>
    <message>
        <source>Probe &amp;boxes and handles</source>
        <translation>探针盒与手柄(&amp;B)</translation>
    </message>
    <message>
        <source>Re&amp;flections from probes</source>
        <translation>来自探针的反射(&amp;F)</translation>
    </message>
    <message>
        <source>C&amp;heaper techniques while moving</source>
        <translation>移动时使用更省的技术(&amp;H)</translation>
    </message>
    <message>
        <source>Draws expensive techniques by a cheaper one while the camera or a handle moves</source>
        <translation>相机或手柄移动时，用更省的技术代替开销大的技术绘制</translation>
    </message>
    <message>
        <source>Refi&amp;ne at rest</source>
        <translation>静止时精细化(&amp;N)</translation>
    </message>
    <message>
        <source>While nothing moves, reflections go on to what rays of the whole lobe show, whatever the technique</source>
        <translation>画面静止时，无论使用何种技术，反射都会继续逼近整个波瓣的光线所示结果</translation>
    </message>
    <message>
        <source>&amp;Projector: the picture and the lesson alone</source>
        <translation>投影模式：仅画面与课程(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Explain pixels</source>
        <translation>解释像素(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Copy explanation as text</source>
        <translation>将解释复制为文本(&amp;C)</translation>
    </message>
    <message>
        <source>Copy explanation as &amp;JSON</source>
        <translation>将解释复制为 JSON(&amp;J)</translation>
    </message>
    <message>
        <source>Save &amp;rays...</source>
        <translation>保存光线(&amp;R)...</translation>
    </message>
    <message>
        <source>&amp;Work counters in the status bar</source>
        <translation>在状态栏显示工作计数(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Lessons...</source>
        <translation>课程(&amp;L)...</translation>
    </message>
    <message>
        <source>&amp;Keys over the picture</source>
        <translation>在画面上显示按键(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys, about</source>
        <translation>鼠标与按键、关于(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Box</source>
        <translation>盒(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Influence</source>
        <translation>影响范围(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Origin</source>
        <translation>原点(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Move and turn</source>
        <translation>移动和旋转(&amp;M)</translation>
    </message>
    <message>
        <source>N&amp;one</source>
        <translation>无(&amp;O)</translation>
    </message>
    <message>
        <source>Khronos PBR &amp;Neutral</source>
        <translation>Khronos PBR 中性(&amp;N)</translation>
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
        <translation>环境(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Blurred environment</source>
        <translation>模糊的环境(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>灰色(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Colour...</source>
        <translation>颜色(&amp;C)...</translation>
    </message>
    <message>
        <source>As the &amp;desktop has it</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>深色(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史记录(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>相机(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Material variant</source>
        <translation>材质变体(&amp;M)</translation>
    </message>
</context>
<context>
    <name>boxprobe::AnimationTools</name>
    <message>
        <source>Animation</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>Time at which the model&apos;s animations are shown</source>
        <translation>显示模型动画的时刻</translation>
    </message>
    <message>
        <source>Animation time</source>
        <translation>动画时间</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Shows the model as it stands without its animations</source>
        <translation>显示不带动画的模型</translation>
    </message>
    <message>
        <source>%1 s / %2 s</source>
        <translation>%1 s / %2 s</translation>
    </message>
    <message>
        <source>at rest / %1 s</source>
        <translation>静止 / %1 s</translation>
    </message>
</context>
<context>
    <name>boxprobe::Autosave</name>
    <message>
        <source>Unsaved changes would not survive a crash: %1</source>
        <translation>未保存的更改在崩溃后将无法恢复：%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::AxisGizmo</name>
    <message>
        <source>Click an axis to look along it</source>
        <translation>单击一个轴以沿其方向观察</translation>
    </message>
</context>
<context>
    <name>boxprobe::BakePanel</name>
    <message>
        <source>Bake</source>
        <translation>烘焙</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Progress of the selected probe&apos;s cubemap</source>
        <translation>所选探针立方体贴图的进度</translation>
    </message>
    <message>
        <source>Recaptures and filters the selected probes (F5)</source>
        <translation>重新捕捉并过滤所选探针（F5）</translation>
    </message>
    <message>
        <source>Bake all</source>
        <translation>全部烘焙</translation>
    </message>
    <message>
        <source>Recaptures and filters every probe (Shift+F5)</source>
        <translation>重新捕捉并过滤每个探针（Shift+F5）</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the work until the scene changes again (Esc)</source>
        <translation>停止工作，直到场景再次改变（Esc）</translation>
    </message>
    <message>
        <source>Save files...</source>
        <translation>保存文件...</translation>
    </message>
    <message>
        <source>Writes every baked probe to an OpenEXR file in a folder. In the folder beside the scene they are loaded instead of captured</source>
        <translation>将每个已烘焙的探针写成文件夹中的 OpenEXR 文件。若放在场景旁的文件夹中，则加载它们而不重新捕捉</translation>
    </message>
    <message>
        <source>No probe selected</source>
        <translation>未选择探针</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <translation>烘焙%1</translation>
    </message>
    <message>
        <source>%1 of %2 baked files are missing or out of date: those probes were captured again. Save baked probes to renew the files</source>
        <translation>%2 个烘焙文件中有 %1 个缺失或过期：这些探针已重新捕捉。请保存烘焙的探针以更新文件</translation>
    </message>
    <message>
        <source>Save baked probes</source>
        <translation>保存烘焙的探针</translation>
    </message>
    <message>
        <source>Save the baked probes to %1, where the scene finds them?</source>
        <translation>将烘焙的探针保存到场景能找到的 %1 吗？</translation>
    </message>
    <message>
        <source>Another folder...</source>
        <translation>其他文件夹...</translation>
    </message>
    <message>
        <source>Save baked probes to a folder</source>
        <translation>将烘焙的探针保存到文件夹</translation>
    </message>
    <message>
        <source>Saving baked probes: %1 left</source>
        <translation>正在保存烘焙的探针：剩余 %1 个</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1</source>
        <translation>已将 1 个文件写入 %1</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2</source>
        <translation>已将 %1 个文件写入 %2</translation>
    </message>
    <message>
        <source>%1; not written because not finished: %2</source>
        <translation>%1；因未完成而未写入：%2</translation>
    </message>
</context>
<context>
    <name>boxprobe::BlendRow</name>
    <message>
        <source>- faces</source>
        <translation>负向面</translation>
    </message>
    <message>
        <source>+ faces</source>
        <translation>正向面</translation>
    </message>
    <message>
        <source>%1 The weight is 1 inside the dashed box. Sets all six faces.</source>
        <translation>%1 虚线盒内权重为 1。设置全部六个面。</translation>
    </message>
    <message>
        <source>One distance for each of the six faces</source>
        <translation>六个面各自的距离</translation>
    </message>
    <message>
        <source>up to </source>
        <translation>最多 </translation>
    </message>
</context>
<context>
    <name>boxprobe::CameraMenu</name>
    <message>
        <source>&amp;Store this view...</source>
        <translation>保存此视图(&amp;S)...</translation>
    </message>
    <message>
        <source>&amp;Move here</source>
        <translation>移到此处(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Store this view</source>
        <translation>保存此视图</translation>
    </message>
    <message>
        <source>Name of the camera</source>
        <translation>相机名称</translation>
    </message>
    <message>
        <source>view</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>重命名相机</translation>
    </message>
</context>
<context>
    <name>boxprobe::CapturePanel</name>
    <message>
        <source>Capture</source>
        <translation>捕捉</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Baked</source>
        <translation>烘焙</translation>
    </message>
    <message>
        <source>Realtime</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Custom image</source>
        <translation>自定义图像</translation>
    </message>
    <message>
        <source>Face size</source>
        <translation>面尺寸</translation>
    </message>
    <message>
        <source>%1 × %1 texels</source>
        <translation>%1 × %1 纹素</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>采样数</translation>
    </message>
    <message>
        <source>%1 per texel</source>
        <translation>每纹素 %1 个</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>反弹次数</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Mirrors and metals are black where this probe sees them. With 2 bounces they reflect, too.</source>
        <translation>该探针看到的镜面和金属为黑色。设为 2 次反弹时它们也会反射。</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>过滤</translation>
    </message>
    <message>
        <source>GGX</source>
        <translation>GGX</translation>
    </message>
    <message>
        <source>Gaussian (frosty)</source>
        <translation>高斯（磨砂）</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>过滤</translation>
    </message>
    <message>
        <source>Filter quality</source>
        <translation>过滤质量</translation>
    </message>
    <message>
        <source>%1 directions</source>
        <translation>%1 个方向</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>近</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远</translation>
    </message>
    <message>
        <source>Clear to</source>
        <translation>清除为</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>The same light from all directions</source>
        <translation>来自所有方向的相同光照</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>开放</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>linear radiance, scene units</source>
        <translation>线性辐射亮度，场景单位</translation>
    </message>
    <message>
        <source>Linear radiance where the probe sees nothing</source>
        <translation>探针什么也看不到之处的线性辐射亮度</translation>
    </message>
    <message>
        <source>clear colour</source>
        <translation>清除颜色</translation>
    </message>
    <message>
        <source>Hides</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>hidden objects</source>
        <translation>隐藏的物体</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>模式</translation>
    </message>
</context>
<context>
    <name>boxprobe::CompareViews</name>
    <message>
        <source>This view shows what you choose here. The error beside it tells how far its display colours are from those of the ray-traced view, or of the scene as it is: the mean in percent of white, and the PSNR. Once the traced view is as fine: its mean light over the traced one&apos;s, and the relative RMSE, as the benchmark of whole pictures measures them</source>
        <translation>此视图显示您在这里选择的内容。旁边的误差表示其显示颜色与光线追踪视图（或当前场景）的差距：平均值（占白色的百分比）和 PSNR。当光线追踪视图同样精细时，还显示两者平均光照之比和相对 RMSE，与整幅画面的基准测试所测一致</translation>
    </message>
</context>
<context>
    <name>boxprobe::CompareWipe</name>
    <message>
        <source>Drag: how much of each picture is shown</source>
        <translation>拖动：调整两幅画面各显示多少</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>当前画面</translation>
    </message>
</context>
<context>
    <name>boxprobe::CostPanel</name>
    <message>
        <source>Measure quickly</source>
        <translation>快速测量</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>技术</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>CPU time of a frame relative to plain box projection</source>
        <translation>一帧的 CPU 时间，相对于普通盒投影</translation>
    </message>
    <message>
        <source>RMSE of (x/(1+x))^(1/2.2) relative to the integral over the box</source>
        <translation>(x/(1+x))^(1/2.2) 的 RMSE，相对于盒上的积分</translation>
    </message>
    <message>
        <source>Double-click to use this technique for the selected probe</source>
        <translation>双击将此技术用于所选探针</translation>
    </message>
    <message>
        <source>One camera and three roughnesses; takes about a minute</source>
        <translation>一个相机和三种粗糙度；约需一分钟</translation>
    </message>
    <message>
        <source>Every camera and roughness; takes some minutes</source>
        <translation>所有相机和粗糙度；需要几分钟</translation>
    </message>
    <message>
        <source>the benchmark could not be started</source>
        <translation>无法启动基准测试</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>技术</translation>
    </message>
    <message>
        <source>Measuring the scene as it is shown now; you can go on working</source>
        <translation>正在测量当前显示的场景；您可以继续工作</translation>
    </message>
    <message>
        <source>%1 techniques measured</source>
        <translation>已测量 %1 种技术</translation>
    </message>
    <message>
        <source>Not measured yet in this scene. A measurement gives every technique&apos;s frame time and its error against the integral over the box.</source>
        <translation>此场景尚未测量。测量会给出每种技术的帧时间及其相对于盒上积分的误差。</translation>
    </message>
    <message>
        <source>%1 is on the Pareto front: no measured technique is both cheaper and more accurate.</source>
        <translation>%1 位于帕累托前沿：没有任何已测技术同时更省且更准确。</translation>
    </message>
    <message>
        <source>%1 is not on the Pareto front: another technique costs no more and has a lower error.</source>
        <translation>%1 不在帕累托前沿：另一种技术开销不更高而误差更低。</translation>
    </message>
    <message>
        <source>The probe&apos;s technique is not among those measured.</source>
        <translation>该探针的技术不在已测量的技术之中。</translation>
    </message>
    <message>
        <source>Measured in the example scene gallery, not in this one. Measure measures the scene on show. </source>
        <translation>在示例场景 gallery 中测得，而非此场景。“测量”会测量当前显示的场景。 </translation>
    </message>
    <message>
        <source>Frame time relative to plain box projection</source>
        <translation>帧时间，相对于普通盒投影</translation>
    </message>
</context>
<context>
    <name>boxprobe::DebugView</name>
    <message>
        <source>Explain pixels</source>
        <translation>解释像素</translation>
    </message>
    <message>
        <source>Plan and elevation in the picture</source>
        <translation>在画面中显示平面图与立面图</translation>
    </message>
    <message>
        <source>View of planar mirrors</source>
        <translation>平面镜的视图</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>解释</translation>
    </message>
    <message>
        <source>Explains how the pixel under the pointer gets its colour; a click pins it (E)</source>
        <translation>解释指针下像素的颜色如何得出；单击将其固定（E）</translation>
    </message>
    <message>
        <source>The same drawing stands under the explanation</source>
        <translation>解释下方也有同样的图</translation>
    </message>
    <message>
        <source>Shows each mirror&apos;s mirrored camera and its view through the mirror; for an explained pixel, the reflected ray up to the moving object</source>
        <translation>显示每面镜子的镜像相机及其透过镜子的视图；对被解释的像素，显示到移动物体的反射光线</translation>
    </message>
    <message>
        <source>Move the pointer over the picture. A click pins what it explains.</source>
        <translation>在画面上移动指针。单击固定所解释的内容。</translation>
    </message>
    <message>
        <source>Switch the Explain tool on (E), then move the pointer over the picture.</source>
        <translation>打开“解释”工具（E），然后在画面上移动指针。</translation>
    </message>
    <message>
        <source>Save rays</source>
        <translation>保存光线</translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation>VTK 多边形数据 (*.vtp)</translation>
    </message>
    <message>
        <source>Saved %1 lines to %2</source>
        <translation>已将 %1 条线保存到 %2</translation>
    </message>
    <message>
        <source>No pixel is explained yet. Press E and point at a surface</source>
        <translation>尚未解释任何像素。按 E 并指向一个表面</translation>
    </message>
    <message>
        <source>Copied the explanation as text</source>
        <translation>已将解释复制为文本</translation>
    </message>
    <message>
        <source>Copied the explanation as JSON</source>
        <translation>已将解释复制为 JSON</translation>
    </message>
</context>
<context>
    <name>boxprobe::Editor</name>
    <message>
        <source>%1 probes</source>
        <translation>%1 个探针</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>设置 %2 的%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExplainCard</name>
    <message>
        <source>Follow the pointer</source>
        <translation>跟随指针</translation>
    </message>
    <message>
        <source>Unpins the card (Esc)</source>
        <translation>取消固定卡片（Esc）</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>复制文本</translation>
    </message>
    <message>
        <source>Copies the whole calculation as text</source>
        <translation>将整个计算复制为文本</translation>
    </message>
    <message>
        <source>Copy JSON</source>
        <translation>复制 JSON</translation>
    </message>
    <message>
        <source>Copies the explanation as the command `boxprobe explain` prints it as JSON</source>
        <translation>将解释复制为 `boxprobe explain` 命令输出的 JSON</translation>
    </message>
    <message>
        <source>Mend</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>Changes the probe; undo takes it back. It mends this pixel: the lookup error in the debug view shows what it does to the others.</source>
        <translation>更改探针；可撤销。它修正此像素：调试视图中的查询误差显示对其他像素的影响。</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>已固定</translation>
    </message>
    <message>
        <source>Under the pointer</source>
        <translation>指针下</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExposureControl</name>
    <message>
        <source>%1 The slider spans %2 stops either way. Keys: [ darker, ] brighter.</source>
        <translation>%1 滑块向两侧各跨 %2 档。按键：[ 变暗，] 变亮。</translation>
    </message>
    <message>
        <source>Set exposure</source>
        <translation>设置曝光</translation>
    </message>
</context>
<context>
    <name>boxprobe::ExposureTools</name>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Sets the exposure that suits the picture as it is now; Undo takes it back</source>
        <translation>设置适合当前画面的曝光；可撤销</translation>
    </message>
    <message>
        <source>Set tone mapping</source>
        <translation>设置色调映射</translation>
    </message>
    <message>
        <source>Switch ground shadow</source>
        <translation>切换地面阴影</translation>
    </message>
    <message>
        <source>Switch ambient occlusion</source>
        <translation>切换环境光遮蔽</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Set background</source>
        <translation>设置背景</translation>
    </message>
</context>
<context>
    <name>boxprobe::FaceTags</name>
    <message>
        <source>worst spot: %1 off</source>
        <translation>最差处：偏差 %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::FileCommands</name>
    <message>
        <source>%1 in %2</source>
        <translation>%2 中的 %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes?</source>
        <translation>保存更改吗？</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>将更改保存到 %1 吗？</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Scenes and models (*.boxprobe.json *.json %1);;Scenes (*.boxprobe.json *.json);;Models (%1)</source>
        <translation>场景和模型 (*.boxprobe.json *.json %1);;场景 (*.boxprobe.json *.json);;模型 (%1)</translation>
    </message>
    <message>
        <source>New from a model</source>
        <translation>从模型新建</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <translation>模型 (%1)</translation>
    </message>
    <message>
        <source>Wait until what is being read or fitted is done</source>
        <translation>请等待读取或拟合完成</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>正在加载 %1</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>%1 (and 1 more warning)</source>
        <translation>%1（另有 1 条警告）</translation>
    </message>
    <message>
        <source>%1 (and %2 more warnings)</source>
        <translation>%1（另有 %2 条警告）</translation>
    </message>
    <message>
        <source>Loading cancelled; the scene is unchanged.</source>
        <translation>加载已取消；场景未改变。</translation>
    </message>
    <message>
        <source>Cannot open</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>No sky</source>
        <translation>无天空</translation>
    </message>
    <message>
        <source>Sky from %1</source>
        <translation>来自 %1 的天空</translation>
    </message>
    <message>
        <source>%1 is the sky; turn it under Sky and lights</source>
        <translation>%1 现为天空；可在“天空与光源”中旋转</translation>
    </message>
    <message>
        <source>Sky from a picture</source>
        <translation>从图片设置天空</translation>
    </message>
    <message>
        <source>Pictures of a sky (*.hdr *.exr)</source>
        <translation>天空图片 (*.hdr *.exr)</translation>
    </message>
    <message>
        <source>%1 changed on disk. Your changes stay; File &gt; Reload takes the file instead</source>
        <translation>%1 在磁盘上已改变。您的更改仍保留；“文件 &gt; 重新加载”将改用文件内容</translation>
    </message>
    <message>
        <source>A lesson is on show; leave it to read the file again</source>
        <translation>正在显示课程；请先离开课程再重新读取文件</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Discard your changes and read %1 again?</source>
        <translation>放弃您的更改并重新读取 %1 吗？</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>已重新读取 %1</translation>
    </message>
    <message>
        <source>Not read again: %1</source>
        <translation>未重新读取：%1</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>Scenes (*%1)</source>
        <translation>场景 (*%1)</translation>
    </message>
    <message>
        <source>%1 already exists, and is not the file that these changes were made to. Replace it?</source>
        <translation>%1 已存在，且不是这些更改所属的文件。要替换吗？</translation>
    </message>
    <message>
        <source>%1 changed on disk. Replace it by yours?</source>
        <translation>%1 在磁盘上已改变。用您的版本替换吗？</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>无法保存</translation>
    </message>
    <message>
        <source>Recovered %1; save it to keep it</source>
        <translation>已恢复 %1；保存以保留</translation>
    </message>
    <message>
        <source>Cannot recover</source>
        <translation>无法恢复</translation>
    </message>
    <message>
        <source>Export image</source>
        <translation>导出图像</translation>
    </message>
    <message>
        <source>Display colours (*.png);;Linear light (*.exr)</source>
        <translation>显示颜色 (*.png);;线性光 (*.exr)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>已写入 %1</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>无法导出</translation>
    </message>
    <message>
        <source>The file&apos;s own</source>
        <translation>文件自身的</translation>
    </message>
</context>
<context>
    <name>boxprobe::FitPanel</name>
    <message>
        <source>Mean error %1, 95 %: %2</source>
        <translation>平均误差 %1，95 %：%2</translation>
    </message>
    <message>
        <source>; light error %1%2%3 %</source>
        <translation>；光照误差 %1%2%3 %</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Fits the box of the selected probe to the walls that its origin sees (Ctrl+F)</source>
        <translation>将所选探针的盒拟合到其原点所见的墙（Ctrl+F）</translation>
    </message>
    <message>
        <source>Before and after: the angle between the sampled and the true direction, and the error of the sampled light</source>
        <translation>前后对比：采样方向与真实方向的夹角，以及采样光照的误差</translation>
    </message>
    <message>
        <source>The fit was stopped</source>
        <translation>拟合已停止</translation>
    </message>
    <message>
        <source>The probe changed meanwhile: fit it again</source>
        <translation>探针在此期间已改变：请重新拟合</translation>
    </message>
    <message>
        <source>hardly matters</source>
        <translation>影响很小</translation>
    </message>
    <message>
        <source>gains %1</source>
        <translation>改善 %1</translation>
    </message>
    <message>
        <source>, light error %1</source>
        <translation>，光照误差 %1</translation>
    </message>
    <message>
        <source>What this face alone changes: the mean angle, and the error of the sampled light (negative is better). Leave out a face that improves the angle but worsens the light.</source>
        <translation>仅此面带来的变化：平均角度和采样光照的误差（负值更好）。若某个面改善角度却使光照变差，请将其排除。</translation>
    </message>
    <message>
        <source>Set fit of %1</source>
        <translation>设置 %1 的拟合</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>停止 (%1 %)</translation>
    </message>
    <message>
        <source>Fit box</source>
        <translation>拟合盒</translation>
    </message>
    <message>
        <source>The box fits already: mean error %1</source>
        <translation>盒已贴合：平均误差 %1</translation>
    </message>
    <message>
        <source>Open: nothing to fit to; the box stays</source>
        <translation>开放：没有可拟合的对象；盒保持不变</translation>
    </message>
    <message>
        <source>The origin is inside of a wall: move it first</source>
        <translation>原点位于墙内：请先移动它</translation>
    </message>
</context>
<context>
    <name>boxprobe::FootprintView</name>
    <message>
        <source>The probe&apos;s cubemap, unfolded and seen from inside: +Z in the middle, +X to its left. Outlined: the texels that this pixel samples, magnified at the right with their shares in percent.</source>
        <translation>探针的立方体贴图，从内部展开观察：+Z 在中间，+X 在其左侧。描边处：该像素采样的纹素，右侧放大并标出其百分比份额。</translation>
    </message>
    <message>
        <source>%1 has no cubemap yet</source>
        <translation>%1 尚无立方体贴图</translation>
    </message>
    <message>
        <source>%1
mip level %2 of %3: %4² texels per face</source>
        <translation>%1
mip 级别 %2 / %3：每面 %4² 纹素</translation>
    </message>
    <message>
        <source>
no lookups here</source>
        <translation>
此处无查询</translation>
    </message>
    <message>
        <source>
one lookup, on face %1</source>
        <translation>
一次查询，位于面 %1</translation>
    </message>
    <message>
        <source>
%1 lookups, most on face %2</source>
        <translation>
%1 次查询，大多位于面 %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::FramePanel</name>
    <message>
        <source>Count lookups</source>
        <translation>统计查询</translation>
    </message>
    <message>
        <source>Heat map</source>
        <translation>热力图</translation>
    </message>
    <message>
        <source>Measure costs</source>
        <translation>测量开销</translation>
    </message>
    <message>
        <source>Draws the picture again and counts the cubemap lookups of each pixel</source>
        <translation>重新绘制画面并统计每个像素的立方体贴图查询次数</translation>
    </message>
    <message>
        <source>Colours the surfaces by their number of lookups, like the view &quot;Lookups&quot; of the Debug tab</source>
        <translation>按查询次数给表面着色，与“调试”标签页的“查询次数”视图相同</translation>
    </message>
    <message>
        <source>Draws the picture many times with parts of it left out, and tells how much time each part takes</source>
        <translation>多次绘制画面并省去其中某些部分，得出各部分耗时</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Off: the sky alone</source>
        <translation>关：仅天空</translation>
    </message>
    <message>
        <source>Simple: one probe, no blending</source>
        <translation>简单：一个探针，不混合</translation>
    </message>
    <message>
        <source>Blend probes</source>
        <translation>混合探针</translation>
    </message>
    <message>
        <source>Blend probes and sky</source>
        <translation>混合探针与天空</translation>
    </message>
    <message>
        <source>At each pixel</source>
        <translation>逐像素</translation>
    </message>
    <message>
        <source>One for the object</source>
        <translation>整个物体一个</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Set probes of %1</source>
        <translation>设置 %1 的探针</translation>
    </message>
    <message>
        <source>Set weights of %1</source>
        <translation>设置 %1 的权重</translation>
    </message>
    <message>
        <source>Lookups per pixel: mean %1, at most %2.</source>
        <translation>每像素查询：平均 %1，最多 %2。</translation>
    </message>
    <message>
        <source>A frame takes %1 ms of CPU time (all threads).</source>
        <translation>一帧耗费 %1 毫秒 CPU 时间（所有线程）。</translation>
    </message>
    <message>
        <source>A frame takes %1 ms.</source>
        <translation>一帧耗时 %1 毫秒。</translation>
    </message>
    <message>
        <source>Costs of the frame</source>
        <translation>帧的开销</translation>
    </message>
    <message>
        <source>of these, drawn over</source>
        <translation>其中被覆盖的</translation>
    </message>
    <message>
        <source>Pixels that are worked out and then covered</source>
        <translation>计算后又被遮盖的像素</translation>
    </message>
    <message>
        <source>Costs of objects&apos; pixels</source>
        <translation>物体像素的开销</translation>
    </message>
    <message>
        <source>Draws</source>
        <translation>绘制调用</translation>
    </message>
    <message>
        <source>with 1 probe</source>
        <translation>使用 1 个探针</translation>
    </message>
    <message>
        <source>with %1 probes</source>
        <translation>使用 %1 个探针</translation>
    </message>
    <message>
        <source>shader variants</source>
        <translation>着色器变体</translation>
    </message>
    <message>
        <source>Objects that share a shader variant, whatever their textures</source>
        <translation>共用一个着色器变体的物体，不论纹理</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>省去</translation>
    </message>
    <message>
        <source>Planar mirrors</source>
        <translation>平面镜</translation>
    </message>
    <message>
        <source>Objects and their probes</source>
        <translation>物体及其探针</translation>
    </message>
    <message>
        <source>unlit</source>
        <translation>不受光照</translation>
    </message>
    <message>
        <source>Material %1. Shares are for the object&apos;s whole bounds; they vary per pixel.</source>
        <translation>材质 %1。份额针对物体的整个包围盒；各像素有所不同。</translation>
    </message>
    <message>
        <source>sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>及另外 %1 个</translation>
    </message>
    <message>
        <source>Memory by probe</source>
        <translation>各探针的内存</translation>
    </message>
    <message>
        <source>all maps, including those kept for undo</source>
        <translation>全部贴图，包括为撤销保留的</translation>
    </message>
    <message>
        <source>lights %1 object, %2 of them in this frame</source>
        <translation>照亮 %1 个物体，本帧中 %2 个</translation>
    </message>
    <message>
        <source>lights %1 objects, %2 of them in this frame</source>
        <translation>照亮 %1 个物体，本帧中 %2 个</translation>
    </message>
    <message>
        <source>Measuring where the time of a frame goes ...</source>
        <translation>正在测量一帧的时间消耗在何处 ...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>boxprobe::GaugeRows</name>
    <message>
        <source>Moves face %1 alone to where the box is least wrong: the mean error falls by %2</source>
        <translation>仅将面 %1 移到盒误差最小处：平均误差降低 %2</translation>
    </message>
    <message>
        <source>Live error</source>
        <translation>实时误差</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Angle between what reflected rays look up and what they should, while the box is edited</source>
        <translation>编辑盒时，反射光线查询方向与应查询方向的夹角</translation>
    </message>
    <message>
        <source>The view from before</source>
        <translation>之前的视图</translation>
    </message>
    <message>
        <source>Look at the worst spot (%1)</source>
        <translation>查看最差处 (%1)</translation>
    </message>
    <message>
        <source>Look at the worst spot</source>
        <translation>查看最差处</translation>
    </message>
    <message>
        <source>Moves the camera to where reflections are most wrong. The error there is at least every face&apos;s mean.</source>
        <translation>将相机移到反射误差最大处。那里的误差不低于任何面的平均值。</translation>
    </message>
    <message>
        <source>Mean error %1, 95 % below %2</source>
        <translation>平均误差 %1，95 % 低于 %2</translation>
    </message>
    <message>
        <source>Face %1 alone can take %2 off the mean: click its button</source>
        <translation>仅面 %1 就能使平均误差降低 %2：单击其按钮</translation>
    </message>
    <message>
        <source>No face alone can take %1 off the mean</source>
        <translation>没有哪个面能单独使平均误差降低 %1</translation>
    </message>
    <message>
        <source>Mean error of what leaves the box through this face: %1 % of the reflections</source>
        <translation>经此面离开盒的反射的平均误差：占反射的 %1 %</translation>
    </message>
</context>
<context>
    <name>boxprobe::GlassFields</name>
    <message>
        <source>Glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation>透射</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>折射率</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>One-pass</source>
        <translation>单遍</translation>
    </message>
    <message>
        <source>Two-pass</source>
        <translation>双遍</translation>
    </message>
    <message>
        <source>Two-interface</source>
        <translation>双界面</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形态</translation>
    </message>
    <message>
        <source>Thin sheet</source>
        <translation>薄片</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Absorption</source>
        <translation>吸收</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Glass as in the model</source>
        <translation>使用模型中的玻璃</translation>
    </message>
    <message>
        <source>Removes the scene&apos;s values above; those in the model file apply again</source>
        <translation>移除上方的场景值；重新使用模型文件中的值</translation>
    </message>
    <message>
        <source>form</source>
        <translation>形态</translation>
    </message>
    <message>
        <source>thinness</source>
        <translation>薄度</translation>
    </message>
    <message>
        <source>absorption color</source>
        <translation>吸收颜色</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>设置 %2 的%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::HeldPicture</name>
    <message>
        <source>Preparing the picture...</source>
        <translation>正在准备画面...</translation>
    </message>
</context>
<context>
    <name>boxprobe::HidesList</name>
    <message>
        <source>No object</source>
        <translation>无物体</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 及另外 %2 个</translation>
    </message>
    <message>
        <source>Objects this probe does not see, such as one at its origin. Default: none</source>
        <translation>该探针看不到的物体，例如位于其原点的物体。默认：无</translation>
    </message>
    <message>
        <source>Not seen by this probe: %1</source>
        <translation>该探针看不到：%1</translation>
    </message>
    <message>
        <source>The model&apos;s objects have no names</source>
        <translation>模型的物体没有名称</translation>
    </message>
</context>
<context>
    <name>boxprobe::ImageFields</name>
    <message>
        <source>Choose...</source>
        <translation>选择...</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>OpenEXR or Radiance HDR, or PNG or JPEG with an encoding: a latitude-longitude map, a cross, a strip, or one of six face files</source>
        <translation>OpenEXR 或 Radiance HDR，或带编码的 PNG 或 JPEG：经纬图、十字图、条带，或六个面文件之一</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Detected</source>
        <translation>已检测</translation>
    </message>
    <message>
        <source>Latitude-longitude</source>
        <translation>经纬图</translation>
    </message>
    <message>
        <source>Strip of faces</source>
        <translation>面条带</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>十字</translation>
    </message>
    <message>
        <source>Six files</source>
        <translation>六个文件</translation>
    </message>
    <message>
        <source>image layout</source>
        <translation>图像布局</translation>
    </message>
    <message>
        <source>Faces seen from</source>
        <translation>面的观察方向</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>view of faces</source>
        <translation>面的观察方向</translation>
    </message>
    <message>
        <source>Image turned by</source>
        <translation>图像旋转</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>编码</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>线性</translation>
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
        <translation>RGBM，线性字节</translation>
    </message>
    <message>
        <source>encoding</source>
        <translation>编码</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>倍数</translation>
    </message>
    <message>
        <source>The brightest radiance that the encoding holds. Default: 34.4932 for RGBM, 4.5948 for dLDR, 5 for RGBM of linear bytes</source>
        <translation>该编码能容纳的最亮辐射亮度。默认：RGBM 为 34.4932，dLDR 为 4.5948，线性字节的 RGBM 为 5</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>The power of M. Default: 2.2 for RGBM, 1 for RGBM of linear bytes</source>
        <translation>M 的幂次。默认：RGBM 为 2.2，线性字节的 RGBM 为 1</translation>
    </message>
    <message>
        <source>Environment image</source>
        <translation>环境图像</translation>
    </message>
    <message>
        <source>Environment images (*.exr *.hdr *.png *.jpg *.jpeg)</source>
        <translation>环境图像 (*.exr *.hdr *.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Cannot use this image</source>
        <translation>无法使用此图像</translation>
    </message>
</context>
<context>
    <name>boxprobe::ImportBar</name>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>X up</source>
        <translation>X 向上</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y 向上</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z 向上</translation>
    </message>
    <message>
        <source>Length of one unit in the model file</source>
        <translation>模型文件中一个单位的长度</translation>
    </message>
    <message>
        <source>Axis that points up in the model file</source>
        <translation>模型文件中朝上的轴</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Reads the model that way, and finds probe, camera and light for it again. Undo takes all of it back</source>
        <translation>按此方式读取模型，并为其重新确定探针、相机和光源。撤销可全部还原</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>Model &gt; Unit and up axis asks again</source>
        <translation>“模型 &gt; 单位与向上轴”会再次询问</translation>
    </message>
    <message>
        <source>The file is in</source>
        <translation>文件单位为</translation>
    </message>
    <message>
        <source>with</source>
        <translation>且</translation>
    </message>
    <message>
        <source>How is the model file meant?</source>
        <translation>模型文件应如何理解？</translation>
    </message>
    <message>
        <source>%1. Is the file in %2, %3?</source>
        <translation>%1。文件单位是%2、%3吗？</translation>
    </message>
</context>
<context>
    <name>boxprobe::Inspectors</name>
    <message>
        <source>Inspectors</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonExerciseBox</name>
    <message>
        <source>Exercise %1. %2</source>
        <translation>练习 %1。%2</translation>
    </message>
    <message>
        <source>Show the solution</source>
        <translation>显示答案</translation>
    </message>
    <message>
        <source>Hide the solution</source>
        <translation>隐藏答案</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonListPage</name>
    <message>
        <source>Leave lessons</source>
        <translation>离开课程</translation>
    </message>
    <message>
        <source>Forget progress</source>
        <translation>清除进度</translation>
    </message>
    <message>
        <source>&lt;b&gt;Lessons&lt;/b&gt;</source>
        <translation>&lt;b&gt;课程&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Closes the lessons and shows your own scene as you left it</source>
        <translation>关闭课程，并按您离开时的样子显示您自己的场景</translation>
    </message>
    <message>
        <source>Choose a lesson. Your own scene is kept unchanged and comes back when you leave. You can move everything in a lesson: your changes are your own attempt and never change the lesson.</source>
        <translation>选择一门课程。您自己的场景保持不变，离开课程后会恢复。课程中的一切都可以移动：您的更改只是您自己的尝试，绝不会改变课程。</translation>
    </message>
    <message>
        <source>Marks all lessons as not started</source>
        <translation>将所有课程标记为未开始</translation>
    </message>
    <message>
        <source>These lessons cannot be read</source>
        <translation>这些课程无法读取</translation>
    </message>
    <message>
        <source>Faults in the lessons&apos; texts</source>
        <translation>课程文本中的错误</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>go on, %1/%2</source>
        <translation>继续，%1/%2</translation>
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
        <translation>您已回答此问题。</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Right. %1</source>
        <translation>正确。%1</translation>
    </message>
    <message>
        <source>Not this one. %1</source>
        <translation>不是这个。%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonStepPage</name>
    <message>
        <source>All lessons</source>
        <translation>所有课程</translation>
    </message>
    <message>
        <source>Shows the list of lessons; this one stays open</source>
        <translation>显示课程列表；此课程保持打开</translation>
    </message>
    <message>
        <source>Leave lessons</source>
        <translation>离开课程</translation>
    </message>
    <message>
        <source>Closes the lessons and shows your own scene as you left it</source>
        <translation>关闭课程，并按您离开时的样子显示您自己的场景</translation>
    </message>
    <message>
        <source>Lesson&apos;s scene</source>
        <translation>课程的场景</translation>
    </message>
    <message>
        <source>Shows the step as the lesson has it; your attempt is kept</source>
        <translation>按课程原样显示此步骤；您的尝试会保留</translation>
    </message>
    <message>
        <source>Your try</source>
        <translation>您的尝试</translation>
    </message>
    <message>
        <source>Shows your attempt at this step</source>
        <translation>显示您在此步骤的尝试</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Discards your attempt. Undo restores it.</source>
        <translation>丢弃您的尝试。撤销可恢复。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Previous step (Left, Page Up)</source>
        <translation>上一步（左方向键，Page Up）</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Next step (Right, Page Down)</source>
        <translation>下一步（右方向键，Page Down）</translation>
    </message>
    <message>
        <source>Try: %1</source>
        <translation>试试：%1</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>map</source>
        <translation>映射图</translation>
    </message>
    <message>
        <source>boxprobe lessons %1 -o sheet.png draws the %2.</source>
        <translation>boxprobe lessons %1 -o sheet.png 可绘制%2。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>This is the lesson&apos;s scene. Your attempt is kept.</source>
        <translation>这是课程的场景。您的尝试会保留。</translation>
    </message>
    <message>
        <source>This is your attempt. The lesson&apos;s scene is kept.</source>
        <translation>这是您的尝试。课程的场景会保留。</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonTaskBox</name>
    <message>
        <source>Show the answer</source>
        <translation>显示答案</translation>
    </message>
    <message>
        <source>Solves the task for you, as an edit that you can undo</source>
        <translation>替您完成任务，作为可撤销的编辑</translation>
    </message>
    <message>
        <source>Measuring...</source>
        <translation>正在测量...</translation>
    </message>
    <message>
        <source>You have solved this task.</source>
        <translation>您已完成此任务。</translation>
    </message>
    <message>
        <source>undefined here</source>
        <translation>此处未定义</translation>
    </message>
    <message>
        <source>what it is compared with is undefined here</source>
        <translation>比较的对象在此处未定义</translation>
    </message>
    <message>
        <source>done above %1</source>
        <translation>高于 %1 即完成</translation>
    </message>
    <message>
        <source>done below %1</source>
        <translation>低于 %1 即完成</translation>
    </message>
    <message>
        <source>solved at %1 ± %2</source>
        <translation>达到 %1 ± %2 即完成</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1：%2（%3）</translation>
    </message>
    <message>
        <source>Done. %1</source>
        <translation>完成。%1</translation>
    </message>
    <message>
        <source>Let go to measure; with Shift handles move finely</source>
        <translation>松开以测量；按住 Shift 可精细移动手柄</translation>
    </message>
    <message>
        <source>Error of the picture</source>
        <translation>画面的误差</translation>
    </message>
    <message>
        <source>Difference between the pictures</source>
        <translation>画面之间的差异</translation>
    </message>
    <message>
        <source>Mean light</source>
        <translation>平均光照</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>曲率</translation>
    </message>
    <message>
        <source>Largest jump between two pixels</source>
        <translation>两个像素之间的最大跳变</translation>
    </message>
    <message>
        <source>Share of lookups that are not a number</source>
        <translation>非数值查询所占份额</translation>
    </message>
    <message>
        <source>Angle off the right lookup, degrees</source>
        <translation>偏离正确查询的角度（度）</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonView</name>
    <message>
        <source>Forget progress</source>
        <translation>清除进度</translation>
    </message>
    <message>
        <source>Mark all lessons as not started? This cannot be undone.</source>
        <translation>将所有课程标记为未开始吗？此操作无法撤销。</translation>
    </message>
    <message>
        <source>Loading cancelled; the scene is unchanged.</source>
        <translation>加载已取消；场景未改变。</translation>
    </message>
    <message>
        <source>This lesson is done</source>
        <translation>此课程已完成</translation>
    </message>
    <message>
        <source>This lesson still has a question or a task</source>
        <translation>此课程还有问题或任务未完成</translation>
    </message>
</context>
<context>
    <name>boxprobe::LessonVisit</name>
    <message>
        <source>Show the lesson&apos;s scene</source>
        <translation>显示课程的场景</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>重新开始</translation>
    </message>
</context>
<context>
    <name>boxprobe::LightPanel</name>
    <message>
        <source>directional</source>
        <translation>平行光</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点光源</translation>
    </message>
    <message>
        <source>spot</source>
        <translation>聚光灯</translation>
    </message>
    <message>
        <source>Sky and lights</source>
        <translation>天空与光源</translation>
    </message>
    <message>
        <source>Sky turned by</source>
        <translation>天空旋转</translation>
    </message>
    <message>
        <source>Turn the sky</source>
        <translation>旋转天空</translation>
    </message>
    <message>
        <source>Faces seen from</source>
        <translation>面的观察方向</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>Set view of the sky&apos;s faces</source>
        <translation>设置天空各面的观察方向</translation>
    </message>
    <message>
        <source>Lamps</source>
        <translation>灯具</translation>
    </message>
    <message>
        <source>As shapes</source>
        <translation>作为形状</translation>
    </message>
    <message>
        <source>In the map</source>
        <translation>在贴图中</translation>
    </message>
    <message>
        <source>Set lamps</source>
        <translation>设置灯具</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光源</translation>
    </message>
    <message>
        <source>Lights in the order of the scene file</source>
        <translation>按场景文件顺序排列的光源</translation>
    </message>
    <message>
        <source>Directional: %1 Others: %2</source>
        <translation>平行光：%1 其他：%2</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Adds a light where the camera is, shining the way it looks</source>
        <translation>在相机处添加一个沿其视线方向照射的光源</translation>
    </message>
    <message>
        <source>As the view</source>
        <translation>同视图</translation>
    </message>
    <message>
        <source>Puts the light where the camera is and aims it the way the camera looks</source>
        <translation>将光源放到相机处并朝向相机的视线方向</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Removes this light</source>
        <translation>移除此光源</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Color of the light</source>
        <translation>光源的颜色</translation>
    </message>
    <message>
        <source>Add %1 light</source>
        <translation>添加%1</translation>
    </message>
    <message>
        <source>Delete light %1</source>
        <translation>删除光源 %1</translation>
    </message>
    <message>
        <source>color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>阴影</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>By coverage</source>
        <translation>按覆盖率</translation>
    </message>
    <message>
        <source>By coverage, and for moving objects</source>
        <translation>按覆盖率，并用于移动物体</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>阴影</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>By size</source>
        <translation>按尺寸</translation>
    </message>
    <message>
        <source>By distance</source>
        <translation>按距离</translation>
    </message>
    <message>
        <source>softness</source>
        <translation>柔和度</translation>
    </message>
    <message>
        <source>Levels per metre</source>
        <translation>每米级数</translation>
    </message>
    <message>
        <source>Set %1 of light %2</source>
        <translation>设置光源 %2 的%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Its sun</source>
        <translation>其中的太阳</translation>
    </message>
    <message>
        <source>As a light</source>
        <translation>作为光源</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>在图片中</translation>
    </message>
    <message>
        <source>Set the sky&apos;s sun</source>
        <translation>设置天空的太阳</translation>
    </message>
</context>
<context>
    <name>boxprobe::LiveLink</name>
    <message>
        <source>Live link to a file</source>
        <translation>实时链接到文件</translation>
    </message>
    <message>
        <source>glTF (*.glb)</source>
        <translation>glTF (*.glb)</translation>
    </message>
    <message>
        <source>%1 is the scene&apos;s model; the live link needs a file of its own</source>
        <translation>%1 是场景的模型；实时链接需要单独的文件</translation>
    </message>
    <message>
        <source>The live link to %1 ended after 1 revision</source>
        <translation>到 %1 的实时链接在 1 个修订版后结束</translation>
    </message>
    <message>
        <source>The live link to %1 ended after %2 revisions</source>
        <translation>到 %1 的实时链接在 %2 个修订版后结束</translation>
    </message>
    <message>
        <source>Live link: %1</source>
        <translation>实时链接：%1</translation>
    </message>
    <message>
        <source>%1 follows the scene</source>
        <translation>%1 正跟随场景</translation>
    </message>
</context>
<context>
    <name>boxprobe::MaterialPanel</name>
    <message>
        <source>Reset to the model&apos;s own</source>
        <translation>重置为模型自身的值</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Material of the model, by its name in the file</source>
        <translation>模型的材质，按其在文件中的名称</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗糙度</translation>
    </message>
    <message>
        <source>Removes the scene&apos;s value; the value in the model file applies again</source>
        <translation>移除场景的值；重新使用模型文件中的值</translation>
    </message>
    <message>
        <source>Reset roughness of %1</source>
        <translation>重置 %1 的粗糙度</translation>
    </message>
    <message>
        <source>Set roughness of %1</source>
        <translation>设置 %1 的粗糙度</translation>
    </message>
</context>
<context>
    <name>boxprobe::MenuBar</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Debug</source>
        <translation>调试(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Surfaces coloured by</source>
        <translation>表面着色依据(&amp;S)</translation>
    </message>
    <message>
        <source>Hel&amp;p</source>
        <translation>帮助(&amp;P)</translation>
    </message>
    <message>
        <source>Look &amp;along an axis</source>
        <translation>沿轴观察(&amp;A)</translation>
    </message>
    <message>
        <source>C&amp;ompare</source>
        <translation>比较(&amp;O)</translation>
    </message>
    <message>
        <source>E&amp;xposure</source>
        <translation>曝光(&amp;X)</translation>
    </message>
    <message>
        <source>To&amp;ne mapping</source>
        <translation>色调映射(&amp;N)</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>背景(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>手柄(&amp;H)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>%1 probes</source>
        <translation>%1 个探针</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>&amp;Duplicate %1</source>
        <translation>创建%1的副本(&amp;D)</translation>
    </message>
    <message>
        <source>De&amp;lete %1</source>
        <translation>删除%1(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Copy %1</source>
        <translation>复制%1(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Bake %1</source>
        <translation>烘焙%1(&amp;B)</translation>
    </message>
    <message>
        <source>Turn the s&amp;ky</source>
        <translation>转动天空(&amp;K)</translation>
    </message>
</context>
<context>
    <name>boxprobe::ModelFitter</name>
    <message>
        <source>Interior</source>
        <translation>室内</translation>
    </message>
    <message>
        <source>Open place</source>
        <translation>开放场所</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Lights of the file</source>
        <translation>文件中的光源</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>摄影棚</translation>
    </message>
    <message>
        <source>Lamps under the ceiling</source>
        <translation>天花板下的灯</translation>
    </message>
    <message>
        <source>Sky through the openings</source>
        <translation>透过开口的天空</translation>
    </message>
    <message>
        <source>Sky and sun</source>
        <translation>天空与太阳</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>模型(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Treat as</source>
        <translation>视为(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>光照(&amp;L)</translation>
    </message>
    <message>
        <source>As found</source>
        <translation>按检测结果</translation>
    </message>
    <message>
        <source>By the kind of model</source>
        <translation>按模型类型</translation>
    </message>
    <message>
        <source>&amp;Unit and up axis...</source>
        <translation>单位与向上轴(&amp;U)...</translation>
    </message>
    <message>
        <source>Kind of model</source>
        <translation>模型类型</translation>
    </message>
    <message>
        <source>Kind of model: %1</source>
        <translation>模型类型：%1</translation>
    </message>
    <message>
        <source>Treat as %1</source>
        <translation>视为%1</translation>
    </message>
    <message>
        <source>Treat as found</source>
        <translation>按检测结果处理</translation>
    </message>
    <message>
        <source>Replace light</source>
        <translation>替换光源</translation>
    </message>
    <message>
        <source>Read in %1, %2</source>
        <translation>以%1读取，%2</translation>
    </message>
    <message>
        <source>Fitting the model</source>
        <translation>正在拟合模型</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>自动曝光</translation>
    </message>
    <message>
        <source>As the picture asks</source>
        <translation>按画面所需</translation>
    </message>
    <message>
        <source>%1; exposure %2</source>
        <translation>%1；曝光 %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::ObjectPanel</name>
    <message>
        <source>Moving object: baked probes do not capture it</source>
        <translation>移动物体：烘焙的探针不捕捉它</translation>
    </message>
    <message>
        <source>Reflects objects that move</source>
        <translation>反射移动的物体</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Object of the model, by its node&apos;s name in the file</source>
        <translation>模型的物体，按其在文件中的节点名称</translation>
    </message>
    <message>
        <source>Moved by</source>
        <translation>平移量</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>旋转量</translation>
    </message>
    <message>
        <source>Planar mirror</source>
        <translation>平面镜</translation>
    </message>
    <message>
        <source>A second, mirrored camera draws moving objects over what the probes reflect. One flat surface only</source>
        <translation>第二个镜像相机将移动物体绘制在探针反射之上。仅适用于一个平坦表面</translation>
    </message>
    <message>
        <source>Roughness limit</source>
        <translation>粗糙度上限</translation>
    </message>
    <message>
        <source>Texels per pixel</source>
        <translation>每像素纹素数</translation>
    </message>
    <message>
        <source>Set whether %1 moves</source>
        <translation>设置 %1 是否移动</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>移动 %1</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>旋转 %1</translation>
    </message>
    <message>
        <source>Set roughness limit of mirror %1</source>
        <translation>设置镜子 %1 的粗糙度上限</translation>
    </message>
    <message>
        <source>Set resolution of mirror %1</source>
        <translation>设置镜子 %1 的分辨率</translation>
    </message>
    <message>
        <source>Make %1 a mirror</source>
        <translation>将 %1 设为镜子</translation>
    </message>
    <message>
        <source>Switch mirror %1 off</source>
        <translation>关闭镜子 %1</translation>
    </message>
    <message>
        <source>It is not one flat surface, so it cannot be a planar mirror.</source>
        <translation>它不是单一的平坦表面，因此不能作为平面镜。</translation>
    </message>
</context>
<context>
    <name>boxprobe::Outliner</name>
    <message>
        <source>Find a name</source>
        <translation>查找名称</translation>
    </message>
    <message>
        <source>Lists only what has this in its name</source>
        <translation>仅列出名称中含有此内容的项</translation>
    </message>
    <message>
        <source>Outliner</source>
        <translation>大纲</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Adds a probe captured at the centre of the view, with its box fitted to the scene</source>
        <translation>在视图中心添加一个捕捉探针，其盒已拟合到场景</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Copies the selected probes, a little aside (Ctrl+D)</source>
        <translation>复制所选探针，并稍作偏移（Ctrl+D）</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Removes the selected probes (Delete)</source>
        <translation>移除所选探针（Delete）</translation>
    </message>
    <message>
        <source>Only probes can be duplicated; select one</source>
        <translation>只有探针可以创建副本；请选择一个</translation>
    </message>
    <message>
        <source>%1 is part of the model and cannot be deleted; H hides it in this window</source>
        <translation>%1 是模型的一部分，无法删除；按 H 可在此窗口中隐藏它</translation>
    </message>
    <message>
        <source>Objects are part of the model and cannot be deleted; H hides them in this window</source>
        <translation>物体是模型的一部分，无法删除；按 H 可在此窗口中隐藏它们</translation>
    </message>
    <message>
        <source>A light is deleted in the panel Sky and lights</source>
        <translation>光源请在“天空与光源”面板中删除</translation>
    </message>
    <message>
        <source>A camera is deleted in its menu (right click)</source>
        <translation>相机请在其菜单中删除（右键单击）</translation>
    </message>
    <message>
        <source>Select a probe to delete</source>
        <translation>请选择要删除的探针</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Show</source>
        <translation>显示(&amp;S)</translation>
    </message>
    <message>
        <source>Show the &amp;others again</source>
        <translation>重新显示其他项(&amp;O)</translation>
    </message>
    <message>
        <source>Show it a&amp;lone</source>
        <translation>仅显示此项(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Unlock</source>
        <translation>解锁(&amp;U)</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>锁定(&amp;K)</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>显示所有隐藏项(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Look through it</source>
        <translation>透过它观察(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation>框显(&amp;F)</translation>
    </message>
</context>
<context>
    <name>boxprobe::OutlinerModel</name>
    <message>
        <source>directional %1</source>
        <translation>平行光 %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点光源 %1</translation>
    </message>
    <message>
        <source>spot %1</source>
        <translation>聚光灯 %1</translation>
    </message>
    <message>
        <source>Probes</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>Objects (%1)</source>
        <translation>物体 (%1)</translation>
    </message>
    <message>
        <source>Lamps (%1)</source>
        <translation>灯具 (%1)</translation>
    </message>
    <message>
        <source>Lights (%1)</source>
        <translation>光源 (%1)</translation>
    </message>
    <message>
        <source>Cameras (%1)</source>
        <translation>相机 (%1)</translation>
    </message>
    <message>
        <source>An object whose material shines</source>
        <translation>材质发光的物体</translation>
    </message>
    <message>
        <source>%1 is hidden</source>
        <translation>%1 已隐藏</translation>
    </message>
    <message>
        <source>%1 is shown</source>
        <translation>%1 已显示</translation>
    </message>
    <message>
        <source>Shows or hides it in this window (H). Ctrl+click isolates it (/). The scene file, captures, exported pictures and errors still include it.</source>
        <translation>在此窗口中显示或隐藏它（H）。Ctrl+单击将其隔离（/）。场景文件、捕捉、导出的图像和误差仍包含它。</translation>
    </message>
    <message>
        <source>%1 is locked</source>
        <translation>%1 已锁定</translation>
    </message>
    <message>
        <source>%1 is free</source>
        <translation>%1 未锁定</translation>
    </message>
    <message>
        <source>Clicks in the view pass through it and its handles do not move. In this window only; not saved in the scene file.</source>
        <translation>视图中的单击会穿过它，其手柄不会移动。仅在此窗口中；不保存到场景文件。</translation>
    </message>
</context>
<context>
    <name>boxprobe::PanelDocks</name>
    <message>
        <source>Outliner</source>
        <translation>大纲</translation>
    </message>
    <message>
        <source>Find a setting</source>
        <translation>查找设置</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>No scene</source>
        <translation>无场景</translation>
    </message>
    <message>
        <source>Open a scene or a model (Ctrl+O).</source>
        <translation>打开场景或模型（Ctrl+O）。</translation>
    </message>
    <message>
        <source>No probe</source>
        <translation>无探针</translation>
    </message>
    <message>
        <source>Add one (Ctrl+Shift+A), or place one in every room (Ctrl+Shift+F).</source>
        <translation>添加一个（Ctrl+Shift+A），或在每个房间放置一个（Ctrl+Shift+F）。</translation>
    </message>
    <message>
        <source>Select one in the outliner or in the picture.</source>
        <translation>在大纲或画面中选择一个。</translation>
    </message>
    <message>
        <source>The fields show %1; edits go to all of them.</source>
        <translation>各字段显示 %1；编辑应用于全部。</translation>
    </message>
    <message>
        <source>Probe %1 of %2</source>
        <translation>探针 %1 / %2</translation>
    </message>
    <message>
        <source>No object selected</source>
        <translation>未选择物体</translation>
    </message>
    <message>
        <source>The lists below choose an object and a material, too.</source>
        <translation>下方的列表也可选择物体和材质。</translation>
    </message>
    <message>
        <source>Its material: %1</source>
        <translation>其材质：%1</translation>
    </message>
    <message>
        <source>Below: the material %1</source>
        <translation>下方：材质 %1</translation>
    </message>
    <message>
        <source>One of %1 selected. %2</source>
        <translation>所选 %1 个之一。%2</translation>
    </message>
    <message>
        <source>Sky, lights and picture. Cameras: %1, lights: %2</source>
        <translation>天空、光源与画面。相机：%1，光源：%2</translation>
    </message>
    <message>
        <source>Cubemap</source>
        <translation>立方体贴图</translation>
    </message>
    <message>
        <source>Debug</source>
        <translation>调试</translation>
    </message>
    <message>
        <source>Explain</source>
        <translation>解释</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>开销</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
</context>
<context>
    <name>boxprobe::Phrase</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>The material is unlit: it shows its colour, no light and no probe.</source>
        <translation>该材质不受光照：只显示其颜色，没有光照和探针。</translation>
    </message>
    <message>
        <source>The surface has no normal here, so there is no reflected ray to project.</source>
        <translation>表面在此处没有法线，因此没有可投影的反射光线。</translation>
    </message>
    <message>
        <source>The shading normal points away from the eye. A ray reflected about it would start below the surface, so it goes straight on.</source>
        <translation>着色法线背离眼睛。绕它反射的光线会从表面之下出发，因此光线直行。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: its weight is 0 here, so it is not sampled.</source>
        <translation>探针“%1”：其权重在此处为 0，因此不采样。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot; has not been captured yet: it reflects nothing.</source>
        <translation>探针“%1”尚未捕捉：不反射任何内容。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: technique %2 has no box to hit, so hit point and distance are undefined; the surroundings are taken to be infinitely far away.</source>
        <translation>探针“%1”：技术 %2 没有可命中的盒，因此命中点和距离未定义；周围环境视为无限远。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: the capture origin lies outside the projection box, so a part of the sampled surfaces was never captured from inside the box.</source>
        <translation>探针“%1”：捕捉原点位于投影盒之外，因此所采样表面的一部分从未在盒内捕捉。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: the point lies outside the projection box; distances to planes behind it count as 0 and the hit is pulled on to the box.</source>
        <translation>探针“%1”：该点位于投影盒之外；到其后方平面的距离按 0 计，命中点被拉到盒上。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: its distances do not give the true hit here (open sky, or hidden from the capture origin).</source>
        <translation>探针“%1”：其距离在此处得不到真实命中点（开阔的天空，或从捕捉原点看被遮挡）。</translation>
    </message>
    <message>
        <source>The surface is translucent. What lies behind it shows through and is not explained here.</source>
        <translation>表面是半透明的。其后方的内容会透出，此处不作解释。</translation>
    </message>
    <message>
        <source>Light passes the glass nearly straight: %1 % of what the picture shows here is what is drawn behind, in place of the lookup, and is not part of this.</source>
        <translation>光几乎笔直地穿过玻璃：画面在此处所示的 %1 % 是后方所绘内容，取代了查询，不在此列。</translation>
    </message>
    <message>
        <source>Where something opaque is drawn along the refracted ray, the picture shows that in place of this lookup.</source>
        <translation>沿折射光线绘有不透明物体之处，画面显示该物体，而非此查询的结果。</translation>
    </message>
    <message>
        <source>No probe lights this object, because none reaches it or its probeMode is off. The current sky shows through, not box-projected.</source>
        <translation>没有探针照亮此物体，因为没有探针触及它，或其 probeMode 为 off。透出当前的天空，不作盒投影。</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: auto chose %2 for this object&apos;s roughness.</source>
        <translation>探针“%1”：auto 按此物体的粗糙度选择了 %2。</translation>
    </message>
    <message>
        <source>undefined</source>
        <translation>未定义</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>无限</translation>
    </message>
    <message>
        <source>-infinite</source>
        <translation>-无限</translation>
    </message>
    <message>
        <source>Surface: object &quot;%1&quot;, material &quot;%2&quot;</source>
        <translation>表面：物体“%1”，材质“%2”</translation>
    </message>
    <message>
        <source>shading point</source>
        <translation>着色点</translation>
    </message>
    <message>
        <source>shading normal, unit</source>
        <translation>着色法线，单位向量</translation>
    </message>
    <message>
        <source>the surface has no normal here</source>
        <translation>表面在此处没有法线</translation>
    </message>
    <message>
        <source>towards the eye, unit</source>
        <translation>朝向眼睛，单位向量</translation>
    </message>
    <message>
        <source>N bent towards the eye across the brushing; R is about it</source>
        <translation>N 横向于拉丝方向朝眼睛弯折；R 绕它反射</translation>
    </message>
    <message>
        <source>reflected direction, 2 max(N.V, 0) N - V</source>
        <translation>反射方向，2 max(N.V, 0) N - V</translation>
    </message>
    <message>
        <source>cosine of the view angle</source>
        <translation>视角的余弦</translation>
    </message>
    <message>
        <source>perceptual roughness; alpha = p^2 = %1</source>
        <translation>感知粗糙度；alpha = p^2 = %1</translation>
    </message>
    <message>
        <source>albedo</source>
        <translation>反照率</translation>
    </message>
    <message>
        <source>base colour; metallic %1</source>
        <translation>基础颜色；金属度 %1</translation>
    </message>
    <message>
        <source>reflectance at normal incidence: mix(%1, base colour, metallic)</source>
        <translation>垂直入射时的反射率：mix(%1, 基础颜色, 金属度)</translation>
    </message>
    <message>
        <source>the material&apos;s occlusion, a factor of all light but emission</source>
        <translation>材质的遮蔽，除自发光外所有光照的系数</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>of the surface</source>
        <translation>表面的不透明度</translation>
    </message>
    <message>
        <source>Sky: %1 of the pixel</source>
        <translation>天空：占该像素 %1</translation>
    </message>
    <message>
        <source>the share that no probe takes, sampled along R at mip level %1</source>
        <translation>没有探针占用的份额，沿 R 在 mip 级别 %1 采样</translation>
    </message>
    <message>
        <source>Glass: %1, seen from within</source>
        <translation>玻璃：%1，从内部观察</translation>
    </message>
    <message>
        <source>Glass: %1</source>
        <translation>玻璃：%1</translation>
    </message>
    <message>
        <source>index on the eye&apos;s side over that beyond; the glass has %1</source>
        <translation>眼睛一侧的折射率除以另一侧的折射率；玻璃为 %1</translation>
    </message>
    <message>
        <source>totally reflected: the view is flatter than the critical angle</source>
        <translation>全反射：视线比临界角更平</translation>
    </message>
    <message>
        <source>exact Fresnel reflectance of a dielectric at N.V</source>
        <translation>电介质在 N.V 处的精确菲涅耳反射率</translation>
    </message>
    <message>
        <source>refracted view direction, in which the probes are sampled</source>
        <translation>折射后的视线方向，沿此方向采样探针</translation>
    </message>
    <message>
        <source>%1, bent at the front and where it leaves</source>
        <translation>%1，在正面和离开处弯折</translation>
    </message>
    <message>
        <source>%1; mirrored within %2 times on the way</source>
        <translation>%1；途中在内部反射 %2 次</translation>
    </message>
    <message>
        <source>from where it is followed to the box</source>
        <translation>从此处追踪到盒</translation>
    </message>
    <message>
        <source>the way within</source>
        <translation>内部的路程</translation>
    </message>
    <message>
        <source>roughness of a mirror that would scatter as far; gives the mip level</source>
        <translation>散射程度相同的镜面的粗糙度；决定 mip 级别</translation>
    </message>
    <message>
        <source>left of white light after x</source>
        <translation>白光经过 x 后所剩</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>factor: transmission (1 - reflected) base colour Beer</source>
        <translation>系数：透射 (1 - 反射) 基础颜色 Beer</translation>
    </message>
    <message>
        <source>found along T: %1</source>
        <translation>沿 T 得到：%1</translation>
    </message>
    <message>
        <source>Planar mirror: objects that move take %1 of the reflection</source>
        <translation>平面镜：移动物体占反射的 %1</translation>
    </message>
    <message>
        <source>coverage of the mirror&apos;s picture over the lobe; the probes keep 1 - a</source>
        <translation>镜像画面在波瓣上的覆盖率；探针保留 1 - a</translation>
    </message>
    <message>
        <source>along R to what moves, by its height over the mirror</source>
        <translation>沿 R 到移动物体，按其高出镜面的高度</translation>
    </message>
    <message>
        <source>level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>whose texels are as large as the lobe at that distance; %1 fetches</source>
        <translation>其纹素与该距离处的波瓣一样大；%1 次读取</translation>
    </message>
    <message>
        <source>its light, times a</source>
        <translation>其光照，乘以 a</translation>
    </message>
    <message>
        <source>factor of L_dyn: share and intensity of the probes</source>
        <translation>L_dyn 的系数：探针的份额与强度</translation>
    </message>
    <message>
        <source>Light %1: what lets it through</source>
        <translation>光源 %1：通过的部分</translation>
    </message>
    <message>
        <source>towards the light</source>
        <translation>朝向光源</translation>
    </message>
    <message>
        <source>along L to where it leaves the box of probe &quot;%1&quot;</source>
        <translation>沿 L 到离开探针“%1”的盒之处</translation>
    </message>
    <message>
        <source>there; what the probe&apos;s coverage is looked up for</source>
        <translation>该处；为此查询探针的覆盖率</translation>
    </message>
    <message>
        <source>1 - coverage, coloured by glass, at level %1</source>
        <translation>1 - 覆盖率，由玻璃着色，级别 %1</translation>
    </message>
    <message>
        <source>factor of the shadow map of what moves</source>
        <translation>移动物体的阴影贴图的系数</translation>
    </message>
    <message>
        <source>through</source>
        <translation>透过</translation>
    </message>
    <message>
        <source>none: the surface faces away from it</source>
        <translation>无：表面背向该光源</translation>
    </message>
    <message>
        <source>factor of the light in `direct`</source>
        <translation>“直接”中该光照的系数</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>总和</translation>
    </message>
    <message>
        <source>direct</source>
        <translation>直接</translation>
    </message>
    <message>
        <source>light sources</source>
        <translation>光源</translation>
    </message>
    <message>
        <source>emissive</source>
        <translation>自发光</translation>
    </message>
    <message>
        <source>the surface&apos;s own light</source>
        <translation>表面自身的光</translation>
    </message>
    <message>
        <source>light from all directions around N, times the base colour; %1 of the pixel</source>
        <translation>N 周围各方向的光，乘以基础颜色；占该像素 %1</translation>
    </message>
    <message>
        <source>light from all directions around N, times the base colour</source>
        <translation>N 周围各方向的光，乘以基础颜色</translation>
    </message>
    <message>
        <source>diffuse</source>
        <translation>漫反射</translation>
    </message>
    <message>
        <source>reflected light times F (A + B); A = %1, B = %2 of the split sum</source>
        <translation>反射光乘以 F (A + B)；A = %1，B = %2，来自 split sum</translation>
    </message>
    <message>
        <source>reflected light times F_0 A + F_90 B; A = %1, B = %2 of the split sum</source>
        <translation>反射光乘以 F_0 A + F_90 B；A = %1，B = %2，来自 split sum</translation>
    </message>
    <message>
        <source>specular</source>
        <translation>镜面反射</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>what is looked through: passes times L_T</source>
        <translation>透视所见：通过乘以 L_T</translation>
    </message>
    <message>
        <source>sheen</source>
        <translation>织物光泽</translation>
    </message>
    <message>
        <source>the same light, sent back by cloth&apos;s fibres</source>
        <translation>同样的光，由织物纤维反射回来</translation>
    </message>
    <message>
        <source>coat</source>
        <translation>清漆</translation>
    </message>
    <message>
        <source>what the clear coat changes</source>
        <translation>清漆层带来的变化</translation>
    </message>
    <message>
        <source>color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>computed: linear light before exposure</source>
        <translation>计算值：曝光前的线性光</translation>
    </message>
    <message>
        <source>the pixel as drawn; differs by %1 of the brightest texel</source>
        <translation>所绘的像素；相差最亮纹素的 %1</translation>
    </message>
    <message>
        <source>the pixel as drawn; differs by %1 of the colour</source>
        <translation>所绘的像素；相差该颜色的 %1</translation>
    </message>
    <message>
        <source>rendered</source>
        <translation>绘制值</translation>
    </message>
    <message>
        <source>Pixel %1, %2</source>
        <translation>像素 %1, %2</translation>
    </message>
    <message>
        <source>Pixel %1, %2: the background</source>
        <translation>像素 %1, %2：背景</translation>
    </message>
    <message>
        <source>linear light before exposure</source>
        <translation>曝光前的线性光</translation>
    </message>
    <message>
        <source>what the sky shows there, linear</source>
        <translation>天空在该处所示，线性</translation>
    </message>
    <message>
        <source>probe &quot;%1&quot; %2 %</source>
        <translation>探针“%1” %2 %</translation>
    </message>
    <message>
        <source>sky %1 %</source>
        <translation>天空 %1 %</translation>
    </message>
    <message>
        <source>R has no part along %1: that pair of planes is never met</source>
        <translation>R 沿 %1 没有分量：永远不会遇到这对平面</translation>
    </message>
    <message>
        <source>counts as 0: P lies beyond that plane</source>
        <translation>按 0 计：P 位于该平面之外</translation>
    </message>
    <message>
        <source>where the probe was captured</source>
        <translation>捕捉探针之处</translation>
    </message>
    <message>
        <source>from the capture origin, along the box&apos;s own axes</source>
        <translation>从捕捉原点起，沿盒自身的轴</translation>
    </message>
    <message>
        <source>from the capture origin</source>
        <translation>从捕捉原点起</translation>
    </message>
    <message>
        <source>reflected direction along the box&apos;s own axes</source>
        <translation>沿盒自身轴的反射方向</translation>
    </message>
    <message>
        <source>box relative to C, along the box&apos;s own axes</source>
        <translation>相对于 C 的盒，沿盒自身的轴</translation>
    </message>
    <message>
        <source>box relative to C</source>
        <translation>相对于 C 的盒</translation>
    </message>
    <message>
        <source>along R to the proxy</source>
        <translation>沿 R 到代理体</translation>
    </message>
    <message>
        <source>%1: the ray leaves through the face %2</source>
        <translation>%1：光线从面 %2 离开</translation>
    </message>
    <message>
        <source>radius of the box&apos;s rounded edges at this roughness</source>
        <translation>此粗糙度下盒的圆棱半径</translation>
    </message>
    <message>
        <source>along R to the hit as the technique refines it, by %1 lookups of the captured distances</source>
        <translation>沿 R 到技术细化后的命中点，对所捕捉距离查询 %1 次</translation>
    </message>
    <message>
        <source>along R to the rounded edge</source>
        <translation>沿 R 到圆棱</translation>
    </message>
    <message>
        <source>hit point, P + d R</source>
        <translation>命中点，P + d R</translation>
    </message>
    <message>
        <source>direction in which the cubemap is sampled</source>
        <translation>采样立方体贴图的方向</translation>
    </message>
    <message>
        <source>what the cubemap is looked up with; nothing is hit</source>
        <translation>用于查询立方体贴图；没有命中</translation>
    </message>
    <message>
        <source>along R to the captured surface; the proxy is off by %1</source>
        <translation>沿 R 到所捕捉的表面；代理体偏差 %1</translation>
    </message>
    <message>
        <source>along R to the captured surface</source>
        <translation>沿 R 到所捕捉的表面</translation>
    </message>
    <message>
        <source>texel %1, %2 of face %3, level %4</source>
        <translation>面 %3 的纹素 %1, %2，级别 %4</translation>
    </message>
    <message>
        <source>%1 more texels</source>
        <translation>另有 %1 个纹素</translation>
    </message>
    <message>
        <source>level %1 of 0 to %2, baked for roughness %3</source>
        <translation>级别 %1（0 至 %2），按粗糙度 %3 烘焙</translation>
    </message>
    <message>
        <source>%1 more lookups, which bring less light: %2 together, their mean; levels %3 to %4</source>
        <translation>另有 %1 次查询，带来的光较少：合计 %2，取其平均；级别 %3 至 %4</translation>
    </message>
    <message>
        <source>lamp &quot;%1&quot; as a shape: it fills %2 of the cosine hemisphere around N</source>
        <translation>灯具“%1”作为形状：占 N 周围余弦半球的 %2</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 占 %2</translation>
    </message>
    <message>
        <source>%1 by %2 (within something: filled from its neighbours)</source>
        <translation>%1 占 %2（位于物体内：由相邻格点填充）</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>everything else, from a lattice of %1 x %2 x %3 nodes (%5 ways between them cut): %4</source>
        <translation>其余，来自 %1 x %2 x %3 个节点的格点（其间 %5 条通路被切断）：%4</translation>
    </message>
    <message>
        <source>everything else, from a lattice of %1 x %2 x %3 nodes: %4</source>
        <translation>其余，来自 %1 x %2 x %3 个节点的格点：%4</translation>
    </message>
    <message>
        <source>%1 (sharper than the surface&apos;s %2)</source>
        <translation>%1（比表面的 %2 更清晰）</translation>
    </message>
    <message>
        <source>%1 (softer than the surface&apos;s %2)</source>
        <translation>%1（比表面的 %2 更柔和）</translation>
    </message>
    <message>
        <source>fetch</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>fetch %1</source>
        <translation>读取 %1</translation>
    </message>
    <message>
        <source>the probe&apos;s reflected light: its lookups by their shares</source>
        <translation>探针的反射光：其各次查询按份额相加</translation>
    </message>
    <message>
        <source>how much of that the probe covers; the sky shows for 1 - a</source>
        <translation>探针覆盖其中的多少；其余 1 - a 显示天空</translation>
    </message>
    <message>
        <source>mean of the sky that each lookup sees</source>
        <translation>各次查询所见天空的平均</translation>
    </message>
    <message>
        <source>the sky along R, not box-projected, at mip level %1</source>
        <translation>沿 R 的天空，不作盒投影，mip 级别 %1</translation>
    </message>
    <message>
        <source>factor of L_spec: box occlusion by the distance d</source>
        <translation>L_spec 的系数：按距离 d 的盒遮蔽</translation>
    </message>
    <message>
        <source>its light from all directions around N, for the diffuse part</source>
        <translation>其来自 N 周围各方向的光，用于漫反射部分</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;: %2 of the pixel, technique %3</source>
        <translation>探针“%1”：占该像素 %2，技术 %3</translation>
    </message>
    <message>
        <source>weight of its influence box at P; intensity %1</source>
        <translation>其影响盒在 P 处的权重；强度 %1</translation>
    </message>
    <message>
        <source>weight of its influence box at P</source>
        <translation>其影响盒在 P 处的权重</translation>
    </message>
    <message>
        <source>none: its share is too small to show</source>
        <translation>无：其份额太小，看不出来</translation>
    </message>
    <message>
        <source>none: not captured yet, it gives no light</source>
        <translation>无：尚未捕捉，不提供光照</translation>
    </message>
    <message>
        <source>true</source>
        <translation>真实</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>眼睛</translation>
    </message>
    <message>
        <source>no box to hit: d and H are undefined</source>
        <translation>没有可命中的盒：d 和 H 未定义</translation>
    </message>
    <message>
        <source>d = min(t_x, t_y, t_z) = min(%1, %2, %3) = %4</source>
        <translation>d = min(t_x, t_y, t_z) = min(%1, %2, %3) = %4</translation>
    </message>
    <message>
        <source>Plan (from above)</source>
        <translation>平面图（俯视）</translation>
    </message>
    <message>
        <source>Elevation (from the front)</source>
        <translation>立面图（正面）</translation>
    </message>
    <message>
        <source>Elevation (from the side)</source>
        <translation>立面图（侧面）</translation>
    </message>
    <message>
        <source>less than 0.1 degrees</source>
        <translation>不到 0.1 度</translation>
    </message>
    <message>
        <source>%1 degrees</source>
        <translation>%1 度</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%2 处 %1</translation>
    </message>
    <message>
        <source>Widen the influence box of &quot;%1&quot;: %2</source>
        <translation>扩大“%1”的影响盒：%2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>The sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>The sky, at %1</source>
        <translation>天空，占 %1</translation>
    </message>
    <message>
        <source>%1: the scene has no probe.</source>
        <translation>%1：场景中没有探针。</translation>
    </message>
    <message>
        <source>%1, because the probeMode of &quot;%2&quot; is off.</source>
        <translation>%1，因为“%2”的 probeMode 为 off。</translation>
    </message>
    <message>
        <source>%1, because every influence box ends short of this point; the nearest, of &quot;%2&quot;, by %3 at %4.</source>
        <translation>%1，因为所有影响盒都未及此点；最近的是“%2”的影响盒，在 %4 处差 %3。</translation>
    </message>
    <message>
        <source>%1, because the influence box of &quot;%2&quot; ends %3 short of this point at %4.</source>
        <translation>%1，因为“%2”的影响盒在 %4 处距此点还差 %3。</translation>
    </message>
    <message>
        <source>%1: no probe lights this object.</source>
        <translation>%1：没有探针照亮此物体。</translation>
    </message>
    <message>
        <source>%1, because this point lies in the blend distance of &quot;%2&quot; at %3.</source>
        <translation>%1，因为此点位于“%2”在 %3 处的混合距离内。</translation>
    </message>
    <message>
        <source>Move the %1 face of &quot;%2&quot; out by %3</source>
        <translation>将“%2”的面 %1 向外移动 %3</translation>
    </message>
    <message>
        <source>Move the %1 face of &quot;%2&quot; in by %3</source>
        <translation>将“%2”的面 %1 向内移动 %3</translation>
    </message>
    <message>
        <source>Project the lookups of &quot;%1&quot; on its box</source>
        <translation>将“%1”的查询投影到其盒上</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;</source>
        <translation>探针“%1”</translation>
    </message>
    <message>
        <source>Probe &quot;%1&quot;, at %2</source>
        <translation>探针“%1”，占 %2</translation>
    </message>
    <message>
        <source>%1: not captured yet, so it reflects nothing.</source>
        <translation>%1：尚未捕捉，因此不反射任何内容。</translation>
    </message>
    <message>
        <source>%1: it captured nothing in this direction, so the sky shows through it.</source>
        <translation>%1：它在此方向上没有捕捉到任何内容，因此透出天空。</translation>
    </message>
    <message>
        <source>%1: its capture origin does not see where this ray ends, so its error is unknown.</source>
        <translation>%1：其捕捉原点看不到这条光线的终点，因此误差未知。</translation>
    </message>
    <message>
        <source>%1, right to %2.</source>
        <translation>%1，误差在 %2 以内。</translation>
    </message>
    <message>
        <source>%1, %2 off: it is sampled by the reflection vector alone, without a hit point.</source>
        <translation>%1，偏差 %2：仅按反射向量采样，没有命中点。</translation>
    </message>
    <message>
        <source>the %1 face of its box</source>
        <translation>其盒的面 %1</translation>
    </message>
    <message>
        <source>its proxy</source>
        <translation>其代理体</translation>
    </message>
    <message>
        <source>%1, %2 off: the ray meets %3 %4 before the surface that is there.</source>
        <translation>%1，偏差 %2：光线命中%3，位于实际表面之前 %4。</translation>
    </message>
    <message>
        <source>%1, %2 off: the ray meets %3 %4 behind the surface that is there.</source>
        <translation>%1，偏差 %2：光线命中%3，位于实际表面之后 %4。</translation>
    </message>
    <message>
        <source>the light sources</source>
        <translation>光源</translation>
    </message>
    <message>
        <source>the surface itself</source>
        <translation>表面自身</translation>
    </message>
    <message>
        <source>light from all around, scattered</source>
        <translation>来自四周的散射光</translation>
    </message>
    <message>
        <source>Hardly a reflection: %1 of this light is from %2, %3 is reflected.</source>
        <translation>几乎不是反射：此光的 %1 来自%2，%3 为反射光。</translation>
    </message>
    <message>
        <source>The background: no surface is drawn here.</source>
        <translation>背景：此处没有绘制表面。</translation>
    </message>
    <message>
        <source>Glass: %1 of this light came through it.</source>
        <translation>玻璃：此光的 %1 穿过它而来。</translation>
    </message>
    <message>
        <source>The planar mirror&apos;s own picture: something that moves takes %1 of the reflection.</source>
        <translation>平面镜自身的画面：移动的物体占反射的 %1。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>%1 impostor is drawn by box</source>
        <translation>%1 个替身按盒绘制</translation>
    </message>
    <message>
        <source>%1 impostors are drawn by box</source>
        <translation>%1 个替身按盒绘制</translation>
    </message>
    <message>
        <source>rays are chosen without tables of light</source>
        <translation>选择光线时不使用光照表</translation>
    </message>
    <message>
        <source>the sky is not occluded</source>
        <translation>天空不被遮蔽</translation>
    </message>
    <message>
        <source>%1 probe is left out</source>
        <translation>省去 %1 个探针</translation>
    </message>
    <message>
        <source>%1 probes are left out</source>
        <translation>省去 %1 个探针</translation>
    </message>
    <message>
        <source>moving objects throw no shadow</source>
        <translation>移动物体不投射阴影</translation>
    </message>
    <message>
        <source>%1 texture of its material is left out</source>
        <translation>省去其材质的 %1 张纹理</translation>
    </message>
    <message>
        <source>%1 textures of its material are left out</source>
        <translation>省去其材质的 %1 张纹理</translation>
    </message>
    <message>
        <source>%1 object is out of view or hidden: not drawn</source>
        <translation>%1 个物体不在视野内或被遮挡：未绘制</translation>
    </message>
    <message>
        <source>%1 objects are out of view or hidden: not drawn</source>
        <translation>%1 个物体不在视野内或被遮挡：未绘制</translation>
    </message>
    <message>
        <source>the sky behind everything shows nowhere: not drawn</source>
        <translation>背后的天空完全不可见：未绘制</translation>
    </message>
    <message>
        <source>%1 probe lights no visible object: nothing is captured for it</source>
        <translation>%1 个探针未照亮任何可见物体：不为其捕捉</translation>
    </message>
    <message>
        <source>%1 probes light no visible object: nothing is captured for it</source>
        <translation>%1 个探针未照亮任何可见物体：不为其捕捉</translation>
    </message>
    <message>
        <source>%1 probe lights only what this frame does not show</source>
        <translation>%1 个探针仅照亮此帧未显示的内容</translation>
    </message>
    <message>
        <source>%1 probes light only what this frame does not show</source>
        <translation>%1 个探针仅照亮此帧未显示的内容</translation>
    </message>
    <message>
        <source>%1 probe holds no texture</source>
        <translation>%1 个探针没有纹理</translation>
    </message>
    <message>
        <source>%1 probes hold no texture</source>
        <translation>%1 个探针没有纹理</translation>
    </message>
    <message>
        <source>%1 mip level of %2 not filtered: no material samples it</source>
        <translation>%2 个 mip 级别中有 %1 个未过滤：没有材质采样它</translation>
    </message>
    <message>
        <source>%1 mip levels of %2 not filtered: no material samples them</source>
        <translation>%2 个 mip 级别中有 %1 个未过滤：没有材质采样它们</translation>
    </message>
    <message>
        <source>%1 draw is unlit: no light, no probe</source>
        <translation>%1 次绘制调用不受光照：无光源，无探针</translation>
    </message>
    <message>
        <source>%1 draws are unlit: no light, no probe</source>
        <translation>%1 次绘制调用不受光照：无光源，无探针</translation>
    </message>
    <message>
        <source>%1 draw has no probe: only the sky, no projection</source>
        <translation>%1 次绘制调用没有探针：仅天空，无投影</translation>
    </message>
    <message>
        <source>%1 draws have no probe: only the sky, no projection</source>
        <translation>%1 次绘制调用没有探针：仅天空，无投影</translation>
    </message>
    <message>
        <source>%1 draw has one probe at full weight: no weights computed, no second lookup</source>
        <translation>%1 次绘制调用有一个权重完整的探针：不计算权重，无第二次查询</translation>
    </message>
    <message>
        <source>%1 draws have one probe at full weight: no weights computed, no second lookup</source>
        <translation>%1 次绘制调用有一个权重完整的探针：不计算权重，无第二次查询</translation>
    </message>
    <message>
        <source>%1 draw leaves nothing to the sky: the sky is not sampled</source>
        <translation>%1 次绘制调用没有给天空留下份额：不采样天空</translation>
    </message>
    <message>
        <source>%1 draws leave nothing to the sky: the sky is not sampled</source>
        <translation>%1 次绘制调用没有给天空留下份额：不采样天空</translation>
    </message>
    <message>
        <source>mirror &quot;%1&quot; has no picture: %2</source>
        <translation>镜子“%1”没有画面：%2</translation>
    </message>
    <message>
        <source>%1 object that moves</source>
        <translation>%1 个移动物体</translation>
    </message>
    <message>
        <source>%1 objects that move</source>
        <translation>%1 个移动物体</translation>
    </message>
    <message>
        <source>%1 object that may hide them in depth alone</source>
        <translation>%1 个可能遮挡它们的物体（仅深度）</translation>
    </message>
    <message>
        <source>%1 objects that may hide them in depth alone</source>
        <translation>%1 个可能遮挡它们的物体（仅深度）</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: %2 x %3 texels, %4, %5</source>
        <translation>“%1”：%2 x %3 个纹素，%4，%5</translation>
    </message>
    <message>
        <source>objects.%1: %2 probe beyond the %3 most important ones reach it and are left out; divide the object, or raise importance where it counts</source>
        <translation>物体“%1”：除最重要的 %3 个探针外，还有 %2 个探针触及它而被省去；请拆分该物体，或在需要之处提高重要性</translation>
    </message>
    <message>
        <source>objects.%1: %2 probes beyond the %3 most important ones reach it and are left out; divide the object, or raise importance where it counts</source>
        <translation>物体“%1”：除最重要的 %3 个探针外，还有 %2 个探针触及它而被省去；请拆分该物体，或在需要之处提高重要性</translation>
    </message>
    <message>
        <source>objects.%1: this OpenGL driver has too few texture units for its probes and textures; %2</source>
        <translation>物体“%1”：此 OpenGL 驱动的纹理单元不足以容纳其探针和纹理；%2</translation>
    </message>
    <message>
        <source>it is switched off, hidden, or not lit by probes</source>
        <translation>已关闭、被隐藏，或不由探针照亮</translation>
    </message>
    <message>
        <source>it is rougher than its maxRoughness</source>
        <translation>比其 maxRoughness 更粗糙</translation>
    </message>
    <message>
        <source>it faces away</source>
        <translation>背向视点</translation>
    </message>
    <message>
        <source>it is out of view</source>
        <translation>不在视野内</translation>
    </message>
    <message>
        <source>no dynamic object is in its view</source>
        <translation>其视野内没有移动物体</translation>
    </message>
    <message>
        <source>larger mirrors used up the mirrorBudget</source>
        <translation>较大的镜子已用尽 mirrorBudget</translation>
    </message>
    <message>
        <source>No surface at this pixel: it shows the sky, so there is no point, normal or reflected ray.</source>
        <translation>此像素处没有表面：它显示天空，因此没有点、法线或反射光线。</translation>
    </message>
    <message>
        <source>pictures were not compared: nobody can stand in these rooms</source>
        <translation>未比较画面：这些房间内无法站人</translation>
    </message>
    <message>
        <source>pictures were not compared: only lamps and unlit surfaces are seen</source>
        <translation>未比较画面：只看得到灯具和不受光照的表面</translation>
    </message>
    <message>
        <source>pictures were not compared: the light that reaches the rooms is too little to tell it from noise</source>
        <translation>未比较画面：进入房间的光太少，无法与噪声区分</translation>
    </message>
    <message>
        <source>pictures were not compared: the scene has no light</source>
        <translation>未比较画面：场景没有光照</translation>
    </message>
    <message>
        <source>one box around all rooms: error %1</source>
        <translation>围绕所有房间的一个盒：误差 %1</translation>
    </message>
    <message>
        <source>one box around all of the model: error %1</source>
        <translation>围绕整个模型的一个盒：误差 %1</translation>
    </message>
    <message>
        <source>the scene&apos;s own probes, bounces of light: %1; error %2</source>
        <translation>场景自身的探针，光反弹次数：%1；误差 %2</translation>
    </message>
    <message>
        <source>one box around all rooms measured better than one for each</source>
        <translation>围绕所有房间的一个盒测得优于每个房间各一个</translation>
    </message>
    <message>
        <source>one box around all of the model measured better than those of rooms</source>
        <translation>围绕整个模型的一个盒测得优于各房间的盒</translation>
    </message>
    <message>
        <source>fitted to all of the model, which measured better than its rooms</source>
        <translation>拟合到整个模型，测得优于各房间</translation>
    </message>
    <message>
        <source>no probe surely made the pictures better: none is proposed</source>
        <translation>没有探针能确定地改善画面：不作建议</translation>
    </message>
    <message>
        <source>nothing measured surely better than the scene&apos;s own probes, which stay</source>
        <translation>没有方案测得确定比场景自身探针好，保留原探针</translation>
    </message>
    <message>
        <source>the scene&apos;s own probes stay, bounces of light: %1</source>
        <translation>保留场景自身的探针，光反弹次数：%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; captured at (%2, %3, %4): error %5 -&gt; %6</source>
        <translation>“%1”在 (%2, %3, %4) 捕捉：误差 %5 -&gt; %6</translation>
    </message>
    <message>
        <source>&quot;%1&quot; captured at (%2, %3, %4): error %5 -&gt; %6, left out</source>
        <translation>“%1”在 (%2, %3, %4) 捕捉：误差 %5 -&gt; %6，未采用</translation>
    </message>
    <message>
        <source>pictures of more than %1 probes were compared with at most %2 bounces of light</source>
        <translation>探针多于 %1 个时，比较图片所用的光线反弹最多 %2 次</translation>
    </message>
    <message>
        <source>%1 probes captured from elsewhere: error %2 -&gt; %3</source>
        <translation>%1 个探针从别处捕捉：误差 %2 -&gt; %3</translation>
    </message>
    <message>
        <source>%1 probes captured from elsewhere: error %2 -&gt; %3, left out</source>
        <translation>%1 个探针从别处捕捉：误差 %2 -&gt; %3，未采用</translation>
    </message>
    <message>
        <source>bounces of light in the captures: %1; error %2 -&gt; %3</source>
        <translation>捕捉中光反弹次数：%1；误差 %2 -&gt; %3</translation>
    </message>
    <message>
        <source>bounces of light in the captures: %1; error %2 -&gt; %3, left out</source>
        <translation>捕捉中光反弹次数：%1；误差 %2 -&gt; %3，未采用</translation>
    </message>
    <message>
        <source>without &quot;%1&quot;: error %2 -&gt; %3, it stays</source>
        <translation>没有“%1”：误差 %2 -&gt; %3，予以保留</translation>
    </message>
    <message>
        <source>without &quot;%1&quot;: error %2 -&gt; %3, left out</source>
        <translation>没有“%1”：误差 %2 -&gt; %3，省去</translation>
    </message>
    <message>
        <source>%1; without it the error grows by %2</source>
        <translation>%1；没有它，误差增加 %2</translation>
    </message>
    <message>
        <source>%1; without it the error is the same</source>
        <translation>%1；没有它，误差不变</translation>
    </message>
    <message>
        <source>the origin is inside of a wall: nothing is fitted; move the origin into the room</source>
        <translation>原点位于墙内：不作拟合；请将原点移入房间</translation>
    </message>
    <message>
        <source>open: nothing to fit to; the box stays</source>
        <translation>开放：没有可拟合的对象；盒保持不变</translation>
    </message>
    <message>
        <source>no better box was found: it stays</source>
        <translation>未找到更好的盒：保持不变</translation>
    </message>
    <message>
        <source>the place is not rectangular</source>
        <translation>此处不是矩形</translation>
    </message>
    <message>
        <source>a quarter of the reflections and more stay off by over 5 degrees: use the technique impostor, or more probes</source>
        <translation>仍有四分之一以上的反射偏差超过 5 度：请使用替身技术，或增加探针</translation>
    </message>
    <message>
        <source>no better origin was found: it stays</source>
        <translation>未找到更好的原点：保持不变</translation>
    </message>
    <message>
        <source>no room was found: back sides of surfaces close in the space within; if it is a room, its faces are inverted: turn them over, or use --as interior</source>
        <translation>未找到房间：内部空间由表面的背面围成；若这是房间，则其面是反的：请翻转这些面，或选择“模型 &gt; 视为 &gt; 室内”</translation>
    </message>
    <message>
        <source>open: no room was found; nothing is closed in by a floor and walls</source>
        <translation>开放：未找到房间；没有由地面和墙围成的空间</translation>
    </message>
    <message>
        <source>the scene&apos;s probes stay</source>
        <translation>保留场景的探针</translation>
    </message>
    <message>
        <source>the walls show their back sides to the rooms: the model&apos;s faces are inverted</source>
        <translation>墙以背面朝向房间：模型的面是反的</translation>
    </message>
    <message>
        <source>%1 closed spaces are too small for a room and have no probe</source>
        <translation>%1 个封闭空间太小，不成房间，没有探针</translation>
    </message>
    <message>
        <source>the model is very large for the height of its rooms: doors may be missed</source>
        <translation>相对房间高度而言模型非常大：可能漏掉门</translation>
    </message>
    <message>
        <source>it has the probe %1, which is kept</source>
        <translation>已有探针 %1，予以保留</translation>
    </message>
    <message>
        <source>%1: its origin is in no room, inside of a wall or in the open; it is kept</source>
        <translation>%1：其原点不在任何房间内，位于墙内或露天；予以保留</translation>
    </message>
    <message>
        <source>left out: it has no ceiling, and no surface in it is smoother than roughness 0.6</source>
        <translation>省去：没有天花板，且其中没有比粗糙度 0.6 更光滑的表面</translation>
    </message>
    <message>
        <source>left out: no more than %1 probes were asked for</source>
        <translation>省去：要求的探针不超过 %1 个</translation>
    </message>
    <message>
        <source>its first probe leaves %1 of %2 degrees</source>
        <translation>第一个探针使误差由 %2 度降至 %1 度</translation>
    </message>
    <message>
        <source>of %1 more places the best gains %2 degrees; %3 are needed</source>
        <translation>另外 %1 个位置中最好的改善 %2 度；需要 %3 度</translation>
    </message>
    <message>
        <source>one more would gain %1 degrees; no more than %2 probes were asked for</source>
        <translation>再加一个可改善 %1 度；要求的探针不超过 %2 个</translation>
    </message>
    <message>
        <source>one more gains %1 degrees</source>
        <translation>再加一个改善 %1 度</translation>
    </message>
    <message>
        <source>the others cover its first probe, which gains only %1 degrees: left out</source>
        <translation>其他探针已覆盖其第一个探针，后者仅改善 %1 度：省去</translation>
    </message>
    <message>
        <source>for what is seen outside of the rooms: %1 % of all surfaces</source>
        <translation>用于房间外所见：占全部表面的 %1 %</translation>
    </message>
    <message>
        <source>the only one of %1</source>
        <translation>%1 的唯一探针</translation>
    </message>
    <message>
        <source>for all of %1</source>
        <translation>用于整个 %1</translation>
    </message>
    <message>
        <source>for a part of %1, where it lowers the lookup error by %2 degrees</source>
        <translation>用于 %1 的一部分，在那里使查询误差降低 %2 度</translation>
    </message>
    <message>
        <source>under 1 s left</source>
        <translation>剩余不到 1 s</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>剩余 %1 s</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>剩余 %1 min</translation>
    </message>
    <message>
        <source>the file has no light: %1</source>
        <translation>文件中没有光源：%1</translation>
    </message>
    <message>
        <source>as you chose, %1</source>
        <translation>按您的选择：%1</translation>
    </message>
    <message>
        <source>there is no room with a ceiling: %1</source>
        <translation>没有带天花板的房间：%1</translation>
    </message>
    <message>
        <source>there are no openings: %1</source>
        <translation>没有开口：%1</translation>
    </message>
    <message>
        <source>the file has no light, and you chose the file&apos;s</source>
        <translation>文件中没有光源，而您选择了文件的光源</translation>
    </message>
    <message>
        <source>the light is the file&apos;s</source>
        <translation>使用文件中的光源</translation>
    </message>
    <message>
        <source>the lights are the file&apos;s</source>
        <translation>使用文件中的光源</translation>
    </message>
    <message>
        <source>a studio lights it</source>
        <translation>由摄影棚照亮</translation>
    </message>
    <message>
        <source>soft lamps hang under the ceiling</source>
        <translation>天花板下悬挂柔光灯</translation>
    </message>
    <message>
        <source>the sky shines in through the openings</source>
        <translation>天空光从开口照入</translation>
    </message>
    <message>
        <source>sky and sun light it</source>
        <translation>由天空和太阳照亮</translation>
    </message>
    <message>
        <source>an open place</source>
        <translation>开阔场地</translation>
    </message>
    <message>
        <source>an interior</source>
        <translation>室内</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>treated as %1 as you chose</source>
        <translation>按您的选择视为%1</translation>
    </message>
    <message>
        <source>treated as %1 (%2)</source>
        <translation>视为%1（%2）</translation>
    </message>
    <message>
        <source>one probe within it</source>
        <translation>其中有一个探针</translation>
    </message>
    <message>
        <source>no probe, the surroundings alone are reflected</source>
        <translation>没有探针，仅反射周围环境</translation>
    </message>
    <message>
        <source>%1; %2; %3</source>
        <translation>%1；%2；%3</translation>
    </message>
    <message>
        <source>%1 m high</source>
        <translation>高 %1 m</translation>
    </message>
    <message>
        <source>%1 m wide</source>
        <translation>宽 %1 m</translation>
    </message>
    <message>
        <source>It seems to lie on its side</source>
        <translation>它似乎侧卧着</translation>
    </message>
    <message>
        <source>In metres it would be %1, and it seems to lie on its side</source>
        <translation>若以米计，则%1，而且似乎侧卧着</translation>
    </message>
    <message>
        <source>In metres it would be %1</source>
        <translation>若以米计，则%1</translation>
    </message>
    <message>
        <source>%1 of the points within it are closed in by front sides</source>
        <translation>其中 %1 的点被正面围住</translation>
    </message>
    <message>
        <source>%1 of the points within it have a floor, walls around and sky above</source>
        <translation>其中 %1 的点有地面、四周墙壁，上方为天空</translation>
    </message>
    <message>
        <source>%1 of the points within it stand over a floor, below the sky</source>
        <translation>其中 %1 的点位于地面之上、天空之下</translation>
    </message>
    <message>
        <source>%1 of the points within it lie inside of it or see back sides</source>
        <translation>其中 %1 的点位于实体内部或看到背面</translation>
    </message>
    <message>
        <source>%1 of the rays from points within it leave to the sky</source>
        <translation>从其中的点发出的光线有 %1 射向天空</translation>
    </message>
    <message>
        <source>it has no surface that hides what is behind it</source>
        <translation>没有能遮挡其后方的表面</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
</context>
<context>
    <name>boxprobe::PictureCompare</name>
    <message>
        <source>Held</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>The picture is held on the right: change something, drag the divider, V flips</source>
        <translation>画面已保留在右侧：请进行更改，拖动分隔线，V 切换</translation>
    </message>
    <message>
        <source>Path traced</source>
        <translation>路径追踪</translation>
    </message>
    <message>
        <source>Reflection traced</source>
        <translation>反射光线追踪</translation>
    </message>
    <message>
        <source>All light, path traced in the background, with as many bounces as the probes have. V flips, Esc ends it</source>
        <translation>全部光照，在后台进行路径追踪，反弹次数与探针相同。V 切换，Esc 结束</translation>
    </message>
    <message>
        <source>The picture with its reflection ray traced: all other light is the picture&apos;s own. Mirrors in mirrors stay black. V flips, Esc ends it</source>
        <translation>反射经光线追踪的画面：其余光照均为画面自身的。镜中之镜保持黑色。V 切换，Esc 结束</translation>
    </message>
    <message>
        <source>%1: preparing</source>
        <translation>%1：正在准备</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1，%2 %</translation>
    </message>
    <message>
        <source>The error against all light gets finer as more paths are traced; V shows all of it, Esc ends it</source>
        <translation>随着追踪的路径增多，相对全部光照的误差会更精细；V 显示全部，Esc 结束</translation>
    </message>
    <message>
        <source>Difference: preparing</source>
        <translation>差异：正在准备</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>无差异</translation>
    </message>
    <message>
        <source>Difference: PSNR %1 dB</source>
        <translation>差异：PSNR %1 dB</translation>
    </message>
    <message>
        <source>Difference: %1</source>
        <translation>差异：%1</translation>
    </message>
    <message>
        <source>Difference: mean %1 %, 95 % of the pixels below %2 %, PSNR %3 dB</source>
        <translation>差异：平均 %1 %，95 % 的像素低于 %2 %，PSNR %3 dB</translation>
    </message>
    <message>
        <source>. Against the traced: %1</source>
        <translation>。相对光线追踪：%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::PictureMenu</name>
    <message>
        <source>Object %1</source>
        <translation>物体 %1</translation>
    </message>
    <message>
        <source>Object %1, material %2</source>
        <translation>物体 %1，材质 %2</translation>
    </message>
    <message>
        <source>No probe lights this place; the sky does</source>
        <translation>没有探针照亮此处；由天空照亮</translation>
    </message>
    <message>
        <source>Probe %1 lights this place</source>
        <translation>探针 %1 照亮此处</translation>
    </message>
    <message>
        <source>No probe lights this place; %1 is the nearest</source>
        <translation>没有探针照亮此处；%1 最近</translation>
    </message>
    <message>
        <source>Probe %1</source>
        <translation>探针 %1</translation>
    </message>
    <message>
        <source>Show in the panels</source>
        <translation>在面板中显示</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Show the &amp;others again</source>
        <translation>重新显示其他项(&amp;O)</translation>
    </message>
    <message>
        <source>Show it a&amp;lone</source>
        <translation>仅显示此项(&amp;L)</translation>
    </message>
    <message>
        <source>Show &amp;all hidden</source>
        <translation>显示所有隐藏项(&amp;A)</translation>
    </message>
    <message>
        <source>Leave out of the capture of %1</source>
        <translation>从 %1 的捕捉中排除</translation>
    </message>
    <message>
        <source>Leave %1 out</source>
        <translation>排除 %1</translation>
    </message>
    <message>
        <source>Capture %1 again</source>
        <translation>重新捕捉 %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::PicturePanel</name>
    <message>
        <source>Picture</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
</context>
<context>
    <name>boxprobe::PlacePanel</name>
    <message>
        <source>1 room</source>
        <translation>1 个房间</translation>
    </message>
    <message>
        <source>%1 rooms</source>
        <translation>%1 个房间</translation>
    </message>
    <message>
        <source>%1: %2 x %3 x %4</source>
        <translation>%1：%2 x %3 x %4</translation>
    </message>
    <message>
        <source>error %1, %2 % hidden</source>
        <translation>误差 %1，%2 % 被遮挡</translation>
    </message>
    <message>
        <source> (%1 %)</source>
        <translation> (%1 %)</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Replace the probes there are</source>
        <translation>替换已有的探针</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>Finds the rooms of the scene, places fitted probes in them, and proposes what makes pictures better by the path tracer&apos;s measure (Ctrl+Shift+F)</source>
        <translation>查找场景中的房间，在其中放置已拟合的探针，并按路径追踪器的度量提出能改善画面的方案（Ctrl+Shift+F）</translation>
    </message>
    <message>
        <source>Relative error of the light in pictures of the rooms, before and after; mirrors count four times. 0 is what the path tracer draws</source>
        <translation>各房间画面中光照的相对误差，前后对比；镜面按四倍计。0 即路径追踪器的结果</translation>
    </message>
    <message>
        <source>Placing was stopped</source>
        <translation>放置已停止</translation>
    </message>
    <message>
        <source>Pictures were not compared: %1</source>
        <translation>未比较画面：%1</translation>
    </message>
    <message>
        <source>The scene changed meanwhile: place again</source>
        <translation>场景在此期间已改变：请重新放置</translation>
    </message>
    <message>
        <source>Error of %1 %2</source>
        <translation>%1 的误差 %2</translation>
    </message>
    <message>
        <source>As it is, but with 1 bounce of light</source>
        <translation>保持现状，但光反弹 1 次</translation>
    </message>
    <message>
        <source>As it is, but with %1 bounces of light</source>
        <translation>保持现状，但光反弹 %1 次</translation>
    </message>
    <message>
        <source>%1. Error of pictures against the path tracer&apos;s: %2. Light: %3 of the truth&apos;s, before %4</source>
        <translation>%1。画面相对路径追踪器的误差：%2。光照：为真实值的 %3，之前为 %4</translation>
    </message>
    <message>
        <source>%1. Mean error of lookups, pictures not compared: %2 → %3</source>
        <translation>%1。查询的平均误差，未比较画面：%2 → %3</translation>
    </message>
    <message>
        <source>Place 1 probe</source>
        <translation>放置 1 个探针</translation>
    </message>
    <message>
        <source>Place %1 probes</source>
        <translation>放置 %1 个探针</translation>
    </message>
    <message>
        <source>Stop (%1 %)</source>
        <translation>停止 (%1 %)</translation>
    </message>
    <message>
        <source>Place probes</source>
        <translation>放置探针</translation>
    </message>
    <message>
        <source>As it is, but with all bounces of light</source>
        <translation>保持现状，但使用全部光反弹</translation>
    </message>
</context>
<context>
    <name>boxprobe::PlacedList</name>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Drawn with the current probes</source>
        <translation>使用当前探针绘制</translation>
    </message>
    <message>
        <source>after</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>Drawn with the proposed probes</source>
        <translation>使用建议的探针绘制</translation>
    </message>
    <message>
        <source>traced</source>
        <translation>追踪</translation>
    </message>
    <message>
        <source>Path traced: all light, the truth</source>
        <translation>路径追踪：全部光照，真实结果</translation>
    </message>
    <message>
        <source>error before</source>
        <translation>之前的误差</translation>
    </message>
    <message>
        <source>Error before, up to 25 % of white</source>
        <translation>之前的误差，最大为白色的 25 %</translation>
    </message>
    <message>
        <source>error after</source>
        <translation>之后的误差</translation>
    </message>
    <message>
        <source>Error after, in the same colours</source>
        <translation>之后的误差，颜色相同</translation>
    </message>
    <message>
        <source>%1; click to enlarge</source>
        <translation>%1；单击放大</translation>
    </message>
    <message>
        <source>Untick what shall not be placed</source>
        <translation>取消勾选不放置的项</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeClipboard</name>
    <message>
        <source>Copied probe %1 as JSON</source>
        <translation>已将探针 %1 复制为 JSON</translation>
    </message>
    <message>
        <source>Copied %1 as JSON</source>
        <translation>已将%1复制为 JSON</translation>
    </message>
    <message>
        <source>No probe to paste: %1</source>
        <translation>没有可粘贴的探针：%1</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>粘贴 %1</translation>
    </message>
    <message>
        <source>Paste %1 probes</source>
        <translation>粘贴 %1 个探针</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeCommands</name>
    <message>
        <source>There is nothing to capture yet: open a model or a scene first (Ctrl+O)</source>
        <translation>还没有可捕捉的内容：请先打开模型或场景（Ctrl+O）</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>创建 %1 的副本</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>A probe needs a name; it stays %1</source>
        <translation>探针需要名称；仍为 %1</translation>
    </message>
    <message>
        <source>A probe named %1 already exists; each needs its own name</source>
        <translation>名为 %1 的探针已存在；每个探针都需要各自的名称</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>将 %1 重命名为 %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeExporter</name>
    <message>
        <source>Export probes</source>
        <translation>导出探针</translation>
    </message>
    <message>
        <source>For</source>
        <translation>用于</translation>
    </message>
    <message>
        <source>Export probes to a folder</source>
        <translation>将探针导出到文件夹</translation>
    </message>
    <message>
        <source>No probe has a finished capture to export; bake first (F5)</source>
        <translation>没有探针有可导出的完成捕捉；请先烘焙（F5）</translation>
    </message>
    <message>
        <source>Exporting 1 probe</source>
        <translation>正在导出 1 个探针</translation>
    </message>
    <message>
        <source>Exporting %1 probes</source>
        <translation>正在导出 %1 个探针</translation>
    </message>
    <message>
        <source>Not exported: another scene was opened meanwhile</source>
        <translation>未导出：期间打开了另一个场景</translation>
    </message>
    <message>
        <source>; not finished: %1</source>
        <translation>；未完成：%1</translation>
    </message>
    <message>
        <source>Wrote 1 file to %1</source>
        <translation>已将 1 个文件写入 %1</translation>
    </message>
    <message>
        <source>Wrote %1 files to %2</source>
        <translation>已将 %1 个文件写入 %2</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbeGauge</name>
    <message>
        <source>The error is still being measured</source>
        <translation>误差仍在测量中</translation>
    </message>
    <message>
        <source>Set face %1 of %2</source>
        <translation>设置 %2 的面 %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbePanel</name>
    <message>
        <source>Probe</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>%1 It is the diamond in the picture.</source>
        <translation>%1 即画面中的菱形。</translation>
    </message>
    <message>
        <source>Box min</source>
        <translation>盒最小</translation>
    </message>
    <message>
        <source>Box max</source>
        <translation>盒最大</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Extent of the box along its own axes</source>
        <translation>盒沿其自身各轴的长度</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>box min</source>
        <translation>盒最小</translation>
    </message>
    <message>
        <source>box max</source>
        <translation>盒最大</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>影响范围</translation>
    </message>
    <message>
        <source>Blend distance</source>
        <translation>混合距离</translation>
    </message>
    <message>
        <source>blend distance</source>
        <translation>混合距离</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>重要性</translation>
    </message>
    <message>
        <source>Separate influence box</source>
        <translation>独立的影响盒</translation>
    </message>
    <message>
        <source>Off: the influence box is the projection box</source>
        <translation>关：影响盒即投影盒</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>influence box</source>
        <translation>影响盒</translation>
    </message>
    <message>
        <source>influence min</source>
        <translation>影响最小</translation>
    </message>
    <message>
        <source>influence max</source>
        <translation>影响最大</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>反射</translation>
    </message>
    <message>
        <source>Technique</source>
        <translation>技术</translation>
    </message>
    <message>
        <source>Project onto the box</source>
        <translation>投影到盒上</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>technique</source>
        <translation>技术</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Bevel</source>
        <translation>倒角</translation>
    </message>
    <message>
        <source>Bevel by roughness</source>
        <translation>按粗糙度倒角</translation>
    </message>
    <message>
        <source>Box occlusion</source>
        <translation>盒遮蔽</translation>
    </message>
    <message>
        <source>box occlusion</source>
        <translation>盒遮蔽</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>倍数</translation>
    </message>
    <message>
        <source>Distance power</source>
        <translation>距离幂次</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>%1 probes are selected. What is set here is set for all; %2 stands where they differ.</source>
        <translation>已选择 %1 个探针。此处的设置对全部生效；不一致处显示 %2。</translation>
    </message>
    <message>
        <source>The selected probes have different techniques.</source>
        <translation>所选探针使用不同的技术。</translation>
    </message>
    <message>
        <source>Diffuse light</source>
        <translation>漫反射光</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>About 1 m apart, closer where light falls steeply</source>
        <translation>间距约 1 m，光照变化陡处更密</translation>
    </message>
    <message>
        <source>Spaced by hand</source>
        <translation>手动间距</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>The whole map lights every place alike</source>
        <translation>整张贴图对各处的照明相同</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>格点</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>格点</translation>
    </message>
</context>
<context>
    <name>boxprobe::ProbePreview</name>
    <message>
        <source>Cubemap of the selected probe</source>
        <translation>所选探针的立方体贴图</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>光照</translation>
    </message>
    <message>
        <source>Captured and filtered radiance at the picture&apos;s exposure</source>
        <translation>按画面曝光显示捕捉并过滤的辐射亮度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distance from the capture origin to the captured surfaces; black where nothing was captured</source>
        <translation>从捕捉原点到所捕捉表面的距离；未捕捉处为黑色</translation>
    </message>
    <message>
        <source>Which of the probe&apos;s maps is shown</source>
        <translation>显示探针的哪一张贴图</translation>
    </message>
    <message>
        <source>As</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>十字</translation>
    </message>
    <message>
        <source>The six faces: -Z +X +Z -X around, +Y above</source>
        <translation>六个面：四周 -Z +X +Z -X，上方 +Y</translation>
    </message>
    <message>
        <source>Latitude-longitude</source>
        <translation>经纬图</translation>
    </message>
    <message>
        <source>The whole sphere in one picture</source>
        <translation>将整个球面显示在一幅图中</translation>
    </message>
    <message>
        <source>Seen from the origin: +Z in the middle, +X to its left, +Y up</source>
        <translation>从原点观察：+Z 在中间，+X 在其左侧，+Y 向上</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>Mip level 0 is the capture itself; each further level is filtered for rougher surfaces</source>
        <translation>mip 级别 0 是捕捉本身；之后每级为更粗糙的表面过滤</translation>
    </message>
    <message>
        <source> stops</source>
        <translation> 档</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>Exposure of this preview on top of the picture&apos;s exposure; one stop doubles the light</source>
        <translation>此预览在画面曝光之上的附加曝光；一档使光照加倍</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Chrome</source>
        <translation>铬</translation>
    </message>
    <message>
        <source>A mirror: the capture itself</source>
        <translation>镜面：捕捉本身</translation>
    </message>
    <message>
        <source>Roughness of this mip level</source>
        <translation>此 mip 级别的粗糙度</translation>
    </message>
    <message>
        <source>A metal with the roughness above</source>
        <translation>具有上述粗糙度的金属</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>漫反射</translation>
    </message>
    <message>
        <source>Diffuse white: the probe&apos;s irradiance</source>
        <translation>漫反射白：探针的辐照度</translation>
    </message>
    <message>
        <source>Shows a sphere at the capture origin in the 3D view, lit by this probe&apos;s maps alone. Captures do not see it</source>
        <translation>在 3D 视图的捕捉原点处显示一个仅由该探针贴图照亮的球。捕捉看不到它</translation>
    </message>
    <message>
        <source>No probe selected</source>
        <translation>未选择探针</translation>
    </message>
    <message>
        <source>Reading the cubemap</source>
        <translation>正在读取立方体贴图</translation>
    </message>
    <message>
        <source>This probe has no distances: its picture was imported, or it is not captured yet</source>
        <translation>该探针没有距离：其图像是导入的，或尚未捕捉</translation>
    </message>
    <message>
        <source>Not captured yet</source>
        <translation>尚未捕捉</translation>
    </message>
    <message>
        <source>one level, %1 × %1</source>
        <translation>单级，%1 × %1</translation>
    </message>
    <message>
        <source>%1: roughness %2, %3 × %3</source>
        <translation>%1：粗糙度 %2，%3 × %3</translation>
    </message>
    <message>
        <source>Black: nothing was captured. White: %1 m and beyond.</source>
        <translation>黑：未捕捉到任何内容。白：%1 m 及更远。</translation>
    </message>
    <message>
        <source>Point at the picture to read a texel.</source>
        <translation>指向画面以读取纹素。</translation>
    </message>
    <message>
        <source>Face %1, column %2, row %3</source>
        <translation>面 %1，列 %2，行 %3</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>nothing seen</source>
        <translation>什么也没看到</translation>
    </message>
    <message>
        <source>%1
linear light %2  %3  %4   coverage %5</source>
        <translation>%1
线性光 %2  %3  %4   覆盖率 %5</translation>
    </message>
</context>
<context>
    <name>boxprobe::PublishedOverlay</name>
    <message>
        <source>Drawing the picture with the published formula...</source>
        <translation>正在用已发表的公式绘制画面...</translation>
    </message>
    <message>
        <source>The picture with the published formula, drawn on the CPU. It is drawn again when you move the view.</source>
        <translation>用已发表的公式在 CPU 上绘制的画面。移动视图时会重新绘制。</translation>
    </message>
</context>
<context>
    <name>boxprobe::RayPanel</name>
    <message>
        <source>Under the pointer</source>
        <translation>指针下</translation>
    </message>
    <message>
        <source>The point that is explained: under the pointer, or pinned by a click</source>
        <translation>被解释的点：指针下，或单击固定的点</translation>
    </message>
    <message>
        <source>Clicked points</source>
        <translation>单击的点</translation>
    </message>
    <message>
        <source>Every point clicked with the Explain tool</source>
        <translation>用“解释”工具单击过的每个点</translation>
    </message>
    <message>
        <source>Over an object</source>
        <translation>遍布物体</translation>
    </message>
    <message>
        <source>Spread evenly over the surface of one object</source>
        <translation>均匀分布在一个物体的表面上</translation>
    </message>
    <message>
        <source>Along a line</source>
        <translation>沿一条线</translation>
    </message>
    <message>
        <source>Between the last two points clicked, dropped on to what lies below</source>
        <translation>在最后单击的两点之间，落到下方的表面</translation>
    </message>
    <message>
        <source>Grid over the picture</source>
        <translation>画面网格</translation>
    </message>
    <message>
        <source>Under a grid of pixels of the picture as it is</source>
        <translation>在当前画面的像素网格下</translation>
    </message>
    <message>
        <source>Kind of line</source>
        <translation>线的种类</translation>
    </message>
    <message>
        <source>Hit distance</source>
        <translation>命中距离</translation>
    </message>
    <message>
        <source>Error of the hit</source>
        <translation>命中误差</translation>
    </message>
    <message>
        <source>Face hit</source>
        <translation>命中的面</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>探针</translation>
    </message>
    <message>
        <source>Show rays</source>
        <translation>显示光线</translation>
    </message>
    <message>
        <source>Clear points</source>
        <translation>清除点</translation>
    </message>
    <message>
        <source>Projection rays</source>
        <translation>投影光线</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Surface points that rays are drawn from</source>
        <translation>绘制光线的表面点</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Object over which the points are spread</source>
        <translation>点所分布的物体</translation>
    </message>
    <message>
        <source>Points at most</source>
        <translation>最多点数</translation>
    </message>
    <message>
        <source>Largest number of points that get rays</source>
        <translation>获得光线的点的最大数量</translation>
    </message>
    <message>
        <source>Longest ray</source>
        <translation>最长光线</translation>
    </message>
    <message>
        <source>Length of a ray that hits nothing, scene units</source>
        <translation>未命中任何物体的光线长度，场景单位</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>着色依据</translation>
    </message>
    <message>
        <source>Meaning of a line&apos;s colour</source>
        <translation>线的颜色的含义</translation>
    </message>
    <message>
        <source>Save rays...</source>
        <translation>保存光线...</translation>
    </message>
    <message>
        <source>Saves VTK poly data (.vtp) with every number in arrays, for ParaView</source>
        <translation>保存 VTK 多边形数据 (.vtp)，所有数值存于数组，供 ParaView 使用</translation>
    </message>
    <message>
        <source>Removes the clicked points</source>
        <translation>移除单击的点</translation>
    </message>
    <message>
        <source>From the eye to the surface point P</source>
        <translation>从眼睛到表面点 P</translation>
    </message>
    <message>
        <source>N, the geometric normal at P</source>
        <translation>N，P 处的几何法线</translation>
    </message>
    <message>
        <source>From P along R to the hit H on the probe&apos;s box</source>
        <translation>从 P 沿 R 到探针盒上的命中点 H</translation>
    </message>
    <message>
        <source>From the capture origin C to what is looked up: H - C</source>
        <translation>从捕捉原点 C 到查询处：H - C</translation>
    </message>
    <message>
        <source>From P to what each fetch looks up, of techniques with several</source>
        <translation>从 P 到每次读取的查询处（对有多次读取的技术）</translation>
    </message>
    <message>
        <source>From P along R to what the scene itself has there</source>
        <translation>从 P 沿 R 到场景自身在那里的内容</translation>
    </message>
    <message>
        <source>From the hit on the box to the true hit</source>
        <translation>从盒上的命中点到真实命中点</translation>
    </message>
    <message>
        <source>Of glass: from P through the object to where the light leaves it</source>
        <translation>对玻璃：从 P 穿过物体到光离开之处</translation>
    </message>
    <message>
        <source>Of glass: from there along the refracted direction to the hit on the probe&apos;s box</source>
        <translation>对玻璃：从那里沿折射方向到探针盒上的命中点</translation>
    </message>
    <message>
        <source>From P towards each light that throws shadows, to where it leaves the probe&apos;s box</source>
        <translation>从 P 朝每个投射阴影的光源，到离开探针盒之处</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>线</translation>
    </message>
    <message>
        <source>the last clicked point</source>
        <translation>最后单击的点</translation>
    </message>
</context>
<context>
    <name>boxprobe::SceneCard</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>boxprobe::SceneReporter</name>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>页面 (*.html)</translation>
    </message>
    <message>
        <source>Wait until what is being read or fitted is done</source>
        <translation>请等待读取或拟合完成</translation>
    </message>
    <message>
        <source>Drawing and path tracing the cameras for the report</source>
        <translation>正在为报告绘制并路径追踪各相机</translation>
    </message>
    <message>
        <source>The report was cancelled; nothing was written</source>
        <translation>报告已取消；未写入任何内容</translation>
    </message>
    <message>
        <source>Wrote %1; the largest error of a camera is %2</source>
        <translation>已写入 %1；相机的最大误差为 %2</translation>
    </message>
    <message>
        <source>No report: %1</source>
        <translation>无报告：%1</translation>
    </message>
</context>
<context>
    <name>boxprobe::ShownParts</name>
    <message>
        <source>Select a probe or an object to hide</source>
        <translation>请选择要隐藏的探针或物体</translation>
    </message>
    <message>
        <source>%1 is hidden in this window; Alt+H shows it</source>
        <translation>%1 在此窗口中已隐藏；Alt+H 显示它</translation>
    </message>
    <message>
        <source>%1 items are hidden in this window; Alt+H shows them</source>
        <translation>%1 项在此窗口中已隐藏；Alt+H 显示它们</translation>
    </message>
    <message>
        <source>Select a probe or an object to isolate</source>
        <translation>请选择要隔离的探针或物体</translation>
    </message>
    <message>
        <source>Only the selection is shown; press / to show the rest</source>
        <translation>仅显示所选；按 / 显示其余</translation>
    </message>
</context>
<context>
    <name>boxprobe::SkyTurn</name>
    <message>
        <source>The sky has no picture that could be turned</source>
        <translation>天空没有可以转动的图片</translation>
    </message>
    <message>
        <source>Turn the sky</source>
        <translation>转动天空</translation>
    </message>
</context>
<context>
    <name>boxprobe::StatusLine</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the capture until the scene changes again (Esc)</source>
        <translation>停止捕捉，直到场景再次改变（Esc）</translation>
    </message>
    <message>
        <source>Continue capturing</source>
        <translation>继续捕捉</translation>
    </message>
    <message>
        <source>Work since the start: cubemap faces captured, mip levels filtered, shader programs compiled, frames drawn; and how many draws of the last frame used no probe, one, two or more.</source>
        <translation>启动以来的工作：捕捉的立方体贴图面、过滤的 mip 级别、编译的着色器程序、绘制的帧；以及上一帧中使用零个、一个、两个或更多探针的绘制调用数。</translation>
    </message>
    <message>
        <source>moving preview</source>
        <translation>移动预览</translation>
    </message>
    <message>
        <source>A cheaper technique is shown while something moves (View menu)</source>
        <translation>有东西移动时显示更省的技术（“视图”菜单）</translation>
    </message>
    <message>
        <source>refining: %1 %</source>
        <translation>正在精细化：%1 %</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>已精细化</translation>
    </message>
    <message>
        <source>The picture rests and goes on to what rays of the whole lobe show (View menu)</source>
        <translation>画面静止，并继续逼近整个波瓣的光线所示结果（“视图”菜单）</translation>
    </message>
    <message>
        <source>%1 of %2 frames averaged</source>
        <translation>已平均 %1 / %2 帧</translation>
    </message>
    <message>
        <source>Mean since the last visible change</source>
        <translation>自上次可见更改以来的平均值</translation>
    </message>
    <message>
        <source>faces %1   levels %2   programs %3   renders %4   draws with 0/1/2+ probes: %5/%6/%7</source>
        <translation>面 %1   级别 %2   程序 %3   渲染 %4   使用 0/1/2+ 个探针的绘制：%5/%6/%7</translation>
    </message>
    <message>
        <source>Shadows of lamps</source>
        <translation>灯具的阴影</translation>
    </message>
    <message>
        <source>%1, coarse</source>
        <translation>%1，粗略</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>天空</translation>
    </message>
    <message>
        <source>%1, bounce %2</source>
        <translation>%1，反弹 %2</translation>
    </message>
    <message>
        <source>%1, bounce %2 of %3</source>
        <translation>%1，反弹 %2 / %3</translation>
    </message>
    <message>
        <source>Capturing</source>
        <translation>正在捕捉</translation>
    </message>
    <message>
        <source>Preparing shaders</source>
        <translation>正在准备着色器</translation>
    </message>
    <message>
        <source>%1 of %2 probes do not show their own surroundings yet: the sky or few texels stand in for them</source>
        <translation>%2 个探针中有 %1 个尚未显示其自身的环境：暂由天空或少量纹素代替</translation>
    </message>
</context>
<context>
    <name>boxprobe::SurfaceViewPanel</name>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Coloured by</source>
        <translation>着色依据</translation>
    </message>
    <message>
        <source>What the surfaces show instead of their own look</source>
        <translation>表面不显示自身外观而显示的内容</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Keeps this range. Otherwise it follows the size of the scene</source>
        <translation>保持此范围。否则随场景大小变化</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Range of the colours; typing a value locks it</source>
        <translation>颜色的范围；输入数值即锁定</translation>
    </message>
    <message>
        <source>undefined here</source>
        <translation>此处未定义</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
</context>
<context>
    <name>boxprobe::TechniqueChooser</name>
    <message>
        <source>How the reflected ray is projected</source>
        <translation>反射光线如何投影</translation>
    </message>
    <message>
        <source>How the lobe around the reflected ray is evaluated</source>
        <translation>反射光线周围的波瓣如何求值</translation>
    </message>
</context>
<context>
    <name>boxprobe::TechniqueParametersPanel</name>
    <message>
        <source>%1 Default: %2.</source>
        <translation>%1 默认：%2。</translation>
    </message>
</context>
<context>
    <name>boxprobe::ValueField</name>
    <message>
        <source>%1 is not between %2 and %3</source>
        <translation>%1 不在 %2 与 %3 之间</translation>
    </message>
</context>
<context>
    <name>boxprobe::VectorRow</name>
    <message>
        <source>Drag sideways to change %1; hold Shift for fine steps</source>
        <translation>左右拖动以更改%1；按住 Shift 精细调整</translation>
    </message>
</context>
<context>
    <name>boxprobe::ViewCommands</name>
    <message>
        <source>A wall hides the selection; Alt+B cuts it away</source>
        <translation>墙遮挡了所选；Alt+B 将其切除</translation>
    </message>
    <message>
        <source>Store camera %1</source>
        <translation>保存相机 %1</translation>
    </message>
    <message>
        <source>Move camera %1 here</source>
        <translation>将相机 %1 移到此处</translation>
    </message>
    <message>
        <source>A camera needs a name</source>
        <translation>相机需要名称</translation>
    </message>
    <message>
        <source>A camera named %1 already exists; each needs its own name</source>
        <translation>名为 %1 的相机已存在；每个相机都需要各自的名称</translation>
    </message>
    <message>
        <source>Rename camera to %1</source>
        <translation>将相机重命名为 %1</translation>
    </message>
    <message>
        <source>Delete camera %1</source>
        <translation>删除相机 %1</translation>
    </message>
</context>
<context>
    <name>boxprobe::ViewComparison</name>
    <message>
        <source>No difference</source>
        <translation>无差异</translation>
    </message>
    <message>
        <source>Error %1 %, %2 dB</source>
        <translation>误差 %1 %，%2 dB</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>As it is now</source>
        <translation>当前画面</translation>
    </message>
    <message>
        <source>The scene as it is edited</source>
        <translation>编辑中的场景</translation>
    </message>
    <message>
        <source>Path traced</source>
        <translation>路径追踪</translation>
    </message>
    <message>
        <source>All light of the scene, path traced in the background, with as many bounces as the probes have. The others are measured by it</source>
        <translation>场景的全部光照，在后台进行路径追踪，反弹次数与探针相同。其他视图以此为基准</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>The scene as it was when the views were opened</source>
        <translation>打开这些视图时的场景</translation>
    </message>
    <message>
        <source>All probes baked</source>
        <translation>全部探针烘焙</translation>
    </message>
    <message>
        <source>Every realtime probe captured and filtered as a baked one</source>
        <translation>每个实时探针按烘焙方式捕捉和过滤</translation>
    </message>
    <message>
        <source>All probes live</source>
        <translation>全部探针实时</translation>
    </message>
    <message>
        <source>Every baked probe captured as a realtime one</source>
        <translation>每个烘焙探针按实时方式捕捉</translation>
    </message>
    <message>
        <source>Every probe by this technique: %1</source>
        <translation>每个探针使用此技术：%1</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>正在准备</translation>
    </message>
    <message>
        <source>Four views: choose below each what it shows. Turn the view or edit as before; Esc ends it</source>
        <translation>四个视图：在每个视图下方选择其显示内容。可像之前一样旋转视图或编辑；Esc 结束</translation>
    </message>
    <message>
        <source>%1 % traced</source>
        <translation>已追踪 %1 %</translation>
    </message>
    <message>
        <source>The measure of the others</source>
        <translation>其他视图的基准</translation>
    </message>
</context>
<context>
    <name>boxprobe::Welcome</name>
    <message>
        <source>Room</source>
        <translation>房间</translation>
    </message>
    <message>
        <source>one box fits exactly</source>
        <translation>一个盒恰好贴合</translation>
    </message>
    <message>
        <source>Building</source>
        <translation>建筑</translation>
    </message>
    <message>
        <source>an open pavilion</source>
        <translation>开放的凉亭</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>公寓</translation>
    </message>
    <message>
        <source>furnished, evening sun</source>
        <translation>带家具，夕阳</translation>
    </message>
    <message>
        <source>Furnished</source>
        <translation>带家具</translation>
    </message>
    <message>
        <source>the limits of a box</source>
        <translation>盒的局限</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>窗户</translation>
    </message>
    <message>
        <source>light through openings</source>
        <translation>透过开口的光</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>refraction</source>
        <translation>折射</translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation>画廊</translation>
    </message>
    <message>
        <source>for measuring</source>
        <translation>用于测量</translation>
    </message>
    <message>
        <source>Mirror hall</source>
        <translation>镜厅</translation>
    </message>
    <message>
        <source>planar mirrors</source>
        <translation>平面镜</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>Open a scene or a model, or drop a file into this window.</source>
        <translation>打开场景或模型，或将文件拖入此窗口。</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Open...</source>
        <translation>打开...</translation>
    </message>
    <message>
        <source>A scene or a model (Ctrl+O)</source>
        <translation>场景或模型（Ctrl+O）</translation>
    </message>
    <message>
        <source>New from a model...</source>
        <translation>从模型新建...</translation>
    </message>
    <message>
        <source>A new scene: probe, camera, light and exposure are fitted to the model</source>
        <translation>新场景：探针、相机、光源和曝光均按模型拟合</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Reflection probes, step by step (F1)</source>
        <translation>反射探针，循序渐进（F1）</translation>
    </message>
</context>
<context>
    <name>boxprobe::Workspace</name>
    <message>
        <source>Lesson: %1</source>
        <translation>课程：%1</translation>
    </message>
    <message>
        <source>no scene</source>
        <translation>无场景</translation>
    </message>
    <message>
        <source>%1 (not saved)</source>
        <translation>%1（未保存）</translation>
    </message>
</context>
</TS>
