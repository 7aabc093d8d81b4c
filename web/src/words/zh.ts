// Chinese, simplified. See en.ts for what each word is for.

import type { BodyName } from "../setup/fields";
import type { SideCount, Turned } from "./en";
import type { Table } from "./words";

const NOUNS: Record<BodyName, string> = {
  can_2007: "罐子",
  soda_can: "罐子",
  beer_bottle: "瓶子",
  coin: "硬币",
  ring: "圆环",
  battery: "电池",
  euler_disk: "圆盘",
  own: "物体",
  inertia: "物体",
};

const SIDES = { left: "左", right: "右" } as const;

export const zh: Table = {
  between: "",

  loading: "正在加载…",
  letGo: "松手",
  flickTimes: (count: number) => `轻弹 ${count} 次`,
  flickAgain: (count: number) => `再轻弹 ${count} 次`,
  openLab: "打开实验室",
  notStarted: (why: string) => `页面无法启动：${why}。重新加载也许有用。`,

  fields: {
    body: {
      label: "物体",
      help: "放在桌上的物体。",
      choices: {
        can_2007: "论文中的罐子",
        soda_can: "汽水罐",
        beer_bottle: "啤酒瓶",
        coin: "硬币（1 欧元）",
        ring: "圆环",
        battery: "电池（AA）",
        euler_disk: "欧拉圆盘",
        own: "自定义",
        inertia: "按惯量",
      },
    },
    fill: { label: "装满程度", help: "罐子或瓶子装了多少。饮料像固体一样随它运动。" },
    radius: { label: "半径", help: "底缘的半径。" },
    length: { label: "高度", help: "从底面到顶端。0 是扁平圆盘。" },
    mass: { label: "质量", help: "总质量。任何绕行角都与它无关。" },
    wall: {
      label: "壁的质量",
      help: "底板以上的质量中壁所占的比例：0 是实心圆柱，100 是薄管。",
    },
    base: { label: "底的质量", help: "总质量中底部薄板所占的比例。" },
    height: { label: "质心", help: "质心离底面的高度。0 是扁平圆盘。" },
    transverse: { label: "A/m", help: "绕过质心的横轴的转动惯量，除以质量。" },
    axial: {
      label: "C/m",
      help: "绕物体轴线的转动惯量，除以质量。任何刚体都不超过 2 A/m。",
    },
    tilt: { label: "倾角", help: "松手时物体倾斜多少。" },
    tilt_rate: {
      label: "倾角变化率",
      help: "0 表示静止松手。负值表示把物体朝直立方向轻弹。",
    },
    sideways: {
      label: "侧向误差",
      help: "物体同时绕指向倾斜方向的轴转得多快。谁的手都免不了这种误差。",
    },
    twist: { label: "旋转", help: "物体同时绕竖直轴转得多快。" },
    yaw: { label: "倾斜朝向", help: "在桌面上倾斜的方向。整个运动随它一起转。" },
    law: {
      label: "桌面",
      help: "“无摩擦”和“无滑动”是论文中的两条理想定律。",
      choices: { frictionless: "无摩擦", coulomb: "干摩擦", no_slip: "无滑动" },
    },
    friction: { label: "摩擦", help: "摩擦系数 μ：最大摩擦力与法向力之比。" },
    rolling: {
      label: "滚动阻力",
      help: "阻力与法向力之比：硬底缘在硬桌面上约为 0.0001。它使运动变慢。",
    },
    restitution: { label: "反弹", help: "底缘离开桌面后落下时的恢复系数。" },
    gravity: { label: "重力加速度", help: "地球上为 9.81，月球上为 1.62。" },
    duration: { label: "时长", help: "所计算的运动持续多久。" },
    floor: {
      label: "地面",
      help: "地面是否运动。桌子随它平移，但不转动。",
      choices: { rest: "静止", pulse: "脉冲", hand: "用手" },
    },
    start: {
      label: "初始状态",
      help: "物体开始时是倾斜的，还是平放在底面上。",
      choices: { tilted: "倾斜", standing: "平放" },
    },
    pulse: {
      label: "波形",
      help: "地面加速度随时间的变化。",
      choices: {
        sine: "正弦",
        cosine: "余弦",
        half_sine: "半正弦",
        ricker: "Ricker 子波",
        rectangular: "矩形",
      },
    },
    shake: { label: "幅度", help: "最大水平加速度。9.81 是地球的重力加速度，即 1 g。" },
    vertical: { label: "竖直", help: "最大竖直加速度；正值表示先向上。" },
    period: { label: "周期", help: "一次振荡的时间；半正弦和矩形则是到结束的时间。" },
    cycles: { label: "周期数", help: "正弦或余弦的振荡次数。" },
    direction: { label: "方向", help: "水平加速度的方向，与“倾斜朝向”同样计量。" },
    flat: {
      label: "平落",
      help: "整个底面同时落下之后会怎样。刚体力学不能确定这一点。",
      choices: {
        stop: "运动结束",
        smooth_left: "向左绕行",
        smooth_right: "向右绕行",
        housner: "Housner 碰撞",
      },
    },
    record: { label: "记录" },
    falls: { label: "倒向" },
    flicks: { label: "次数", help: "重复松手多少次。论文中为 42。" },
    unsteadiness: { label: "手的不稳程度", help: "为 100 时，轻弹会偏离正中约 3°。" },
    seed: { label: "种子", help: "随机数的种子。相同的种子给出相同的散布。" },
  },

  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label}：没有“${text}”；可选：${[names.slice(0, -1).join("、"), ...names.slice(-1)].join("或")}。`,
    noRecord: (label: string) => `${label}：这不是本页面的记录。`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label}：“${text}”有两种读法；请用${sign === "." ? "点号" : "逗号"}作小数点，千位之间不加符号。`,
    empty: (label: string) => `${label}：需要一个数。`,
    noNumber: (label: string, text: string) => `${label}：必须是数，而不是“${text}”。`,
    notWhole: (label: string, text: string) => `${label}：必须是整数，而不是 ${text}。`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label}：必须大于 ${low} 且小于 ${high}；${text} 超出范围。`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label}：必须在 ${low} 到 ${high} 之间；${text} 超出范围。`,
  },

  playback: {
    speed: "速度",
    realTime: "实时",
    slow: "碰撞时放慢",
    on: "开",
    off: "关",
    view: "视角",
    step: "步骤",
  },

  controls: {
    title: "设置",
    standsFlat: "物体静止平放。",
    undo: "撤销",
    reset: "重置",
    more: "更多",
    hint: "指向一项设置，查看它的含义。",
    dryOnly: "只适用于干摩擦。",
    tables: { ice: "冰", wood: "木", rubber: "橡胶" },
    losses: { none: "无", hard: "硬桌面", soft: "软桌面" },
    lossesOf: (table: string, resistance: string) => `滚动阻力：${table}，${resistance}`,
    frictionOf: (table: string, friction: string) => `${table}的摩擦，${friction}`,
    neededLabel: (friction: string) => `${friction}，这个物体滚过近碰撞所需的摩擦`,
    neededHelp: (friction: string) =>
      `摩擦达到 ${friction} 时，这个物体能滚过近碰撞。不足时它会滑动。`,
    floor: (state: string) => `地面：${state}`,
    notLoaded: "这些控件无法加载。请重新加载页面。",
  },

  floor: {
    isLoading: "正在加载使地面运动的部分",
    isMissing: "使地面运动的部分无法加载；请重新加载页面",
    push: "推",
    pushHelp: "用五分之一秒把地面推离你，并开始运动。",
    shake: "摇动",
    shakeHelp: "开始地面和物体的运动。",
    note: "轻弹和理论都针对静止的地面。图中的位置相对于桌子。",
    onceOnly: "只适用于正弦和余弦。",
    pad: "移动桌子",
    padHelp:
      "在这里拖动来移动桌子，每像素一毫米。松开后，物体就按同样的运动受到摇动。方向键也可以移动桌子。",
    balanceTilt: "临界倾角",
    beyondBalance: "超过它，静止的物体会倒下",
    largestTilt: "最大倾角",
    ofBalance: (ratio: string) => `临界倾角的 ${ratio} 倍`,
    uplift: "抬起",
    neverRocks: "它始终不摇摆",
    whenRocks: "当它开始摇摆时",
    leansAtStart: "物体开始时是倾斜的",
    itsLargestTilt: (tilt: string) => `它的最大倾角是 ${tilt}。`,
    overturns: (body: BodyName, after: string) => `${NOUNS[body]}在 ${after} 时翻倒。`,
    overturnsInAir: (body: BodyName, after: string) =>
      `${NOUNS[body]}翻倒：它的底缘在 ${after} 时离开地面。`,
    undecided: (after: string) => `计算到 ${after} 结束时它已超过临界倾角：是否翻倒尚无定论。`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `它没有翻倒。计算到 ${after} 结束时，${
        {
          standing: "它平放着",
          sliding_flat: "它的底面还贴着地面滑动",
          flying_level: "它在空中",
          moving: "它还在运动",
        }[state]
      }。`,
    stops: (after: string) =>
      `底面在 ${after} 时平落；按“平落”的设定，运动就此结束。刚体力学不能确定之后的运动。`,
    isStill: "地面不动。",
    moves: (far: string, strong: string) => `地面最多移动 ${far}，加速度最大为 ${strong}。`,
    beginsToRock: (body: BodyName, at: string) => `${NOUNS[body]}在 ${at} 时开始摇摆（抬起）。`,
    rocksAgain: (body: BodyName, at: string) =>
      `${NOUNS[body]}开始时倾斜；平放一会儿之后，在 ${at} 时又开始摇摆。`,
    leans: (body: BodyName) => `${NOUNS[body]}开始时倾斜。`,
    slides: (body: BodyName) => `${NOUNS[body]}的底面贴着地面滑动，始终不摇摆。`,
    stands: (body: BodyName) => `${NOUNS[body]}在地面上静止不动，始终不摇摆。`,
  },

  verdict: {
    turned: "接触点绕行",
    angleOfTurn: "绕行角",
    itself: (body: BodyName) => `${NOUNS[body]}本身`,
    meanwhile: "其间转了",
    whenLetGo: "松手后可见",
    ifLetGo: "如果现在松手",
    theory: "理论值",
    smallestTilt: "最小倾角",
    gap: (gap: string) => `缝隙 ${gap}`,
    contactThen: "当时的接触点",
    perSecond: "圈/秒",
    perSecondAt: (speed: string) => `圈/秒，速度 ${speed}`,
    inHand: "在你手中",
    leansToward: (way: string) => `倾斜朝向 ${way}`,
    leansInHand: (tilt: string, way: string) => `在你手中它倾斜 ${tilt}，朝向 ${way}。`,
    toFlick: "要轻弹它，就在手移动时松开。",
    wouldBe: {
      floorMoves: "如果现在静止松手，地面开始运动。",
      nothing: "如果现在静止松手，就没有运动。",
      rocked: (angle: string, after: string) =>
        `如果现在静止松手，在它落下又升到下一个倾角极大值的过程中，接触点会绕行 ${angle}，用时 ${after}。`,
      hovered: (after: string) => `如果现在静止松手，计算到 ${after} 结束时，它还没有落下又升起。`,
      toppled: (angle: string, after: string) =>
        `如果现在静止松手，接触点会绕行 ${angle}，它在 ${after} 后倒下。`,
      fell_back: (after: string) => `如果现在静止松手，它会在 ${after} 后倒向倾斜的一侧。`,
      face_down: (after: string) => `如果现在静止松手，它会在 ${after} 后平落。`,
      at_rest: (after: string) => `如果现在静止松手，它会在 ${after} 后平放静止。`,
      lifted_off: (after: string) =>
        `如果现在静止松手，底缘会在 ${after} 后离开桌面，理想定律到此为止。`,
      painleve: (after: string) =>
        `如果现在静止松手，它会在 ${after} 后遇到 Painlevé 悖论，刚体力学在那里没有唯一的答案。`,
      failed: "如果现在静止松手，计算会失败。",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "松手" : `${start} 时的倾角极大值`;
      const to = {
        maximum: `${end} 时的下一个倾角极大值为止`,
        fall: `${end} 时倒下为止`,
        end: `${end} 时结束为止`,
      }[endsWith];
      const turn = { none: itself, same: `${itself}，方向相同`, other: `${itself}，方向相反` };
      return `从${start === undefined ? from : ` ${from}`}起，它落下又升起，到 ${to}，接触点绕行 ${angle}，其中大部分只用 ${time}；${NOUNS[body]}本身转了 ${turn[way]}。`;
    },
    rim: {
      rolled: "摩擦足够：它一路滚动。",
      slipped: "底缘在途中滑动。",
      jumped: "底缘在途中跳离桌面。",
    },
    fullTurn: (rest: string) => `也就是一整圈加 ${rest}。`,
    veers: (angle: string, side: "left" | "right") => `它相对正对面向${SIDES[side]}偏 ${angle}。`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `${{ turn: "这次绕行", fall: "到倒下时", end: "到结束时" }[until]}共 ${angle}`,
    comesDownFlat: "它平落下来",
    incomplete: "下一次绕行不完整",
    staysUp: "它没有落下",
    limitHere: "这个桌面上的极限",
    asComputed: "与这里算出的相同",
    below: (angle: string) => `比算出的绕行角小 ${angle}`,
    above: (angle: string) => `比算出的绕行角大 ${angle}`,
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text}；适用于${[...(flat ? ["平落"] : []), ...(untwisted ? ["不旋转"] : [])].join("且")}的物体`,
    noMotion: (why: string) => `没有可以显示的运动：${why}。`,
    stillComputing: (after: string) => `${after} 之后的运动还在计算。`,
    stillMoves: (after: string) => `计算到 ${after} 结束时它还在运动。`,
    fallsOver: (after: string) => `它在 ${after} 后倒下。`,
    fallsBack: (after: string) => `它在 ${after} 后倒向开始时倾斜的一侧。`,
    liftsOff: (after: string | undefined) =>
      `底缘${after === undefined ? "会立刻" : `会在 ${after} 后`}离开桌面。理想定律不包括飞行，所以运动到此为止。选择干摩擦可以继续。`,
    comesToRest: (after: string) => `它在 ${after} 后静止：底面平放，能量耗尽。`,
    painleve: (after: string, friction: string) =>
      `${after} 后出现 Painlevé 悖论：摩擦这样大时，刚体力学对滑动的底缘没有唯一的答案。对这个几乎平放的物体，悖论从摩擦 ${friction} 开始。减小摩擦可以继续。`,
    tooManySteps: (after: string) => `计算在 ${after} 停止，因为需要太多步。请缩短时长。`,
    cannotContinue: (after: string, why: string) => `计算在 ${after} 之后无法继续：${why}。`,
    faceDownStraight: (after: string, least: string) =>
      `${after} 后平落：没有任何侧向运动时，整个底缘同时碰到桌面。刚体力学不能确定之后的运动。只要有侧向误差，无论多小，接触点就会绕行；${least} 以上的误差可以计算。`,
    faceDownResisted: (after: string) =>
      `${after} 后平落：滚动阻力使接触点停下，底面平拍在桌上。底缘所有点同时碰撞时，刚体力学不能确定之后的运动。阻力小一些或侧向误差大一些，接触点就会绕行。`,
    faceDownShort: (after: string) =>
      `${after} 后平落：它落得太平，接触点绕底缘的行程太短，无法计算。请加大侧向误差。`,
    computationFailed: (why: string) => `计算失败（${why}）；请改变设置或重新加载页面`,
  },

  essay: {
    guess: "你的猜测",
    time: "时间",
    closer: "怎么会这样？走近看看",
    inLab: "在实验室中打开",
    grasp: "抓住罐子的顶部，把它弄斜，然后松手。用手指时先按住片刻。",
    askTelephone: "使用手机的倾斜",
    holdTelephone: "按住此处，倾斜手机，然后松手",
    theCan: "罐子，你可以把它弄斜",
    theBody: "桌上的物体",
    noPicture: "这个浏览器无法显示图像，因为 WebGL 已关闭或不存在。文字、数字和曲线不受影响。",
    atSmallest: "在最小倾角时",
    fromSmallest: (time: string, when: "before" | "after") =>
      `最小倾角${{ before: "之前", after: "之后" }[when]} ${time}`,
    range: (label: string, from: string, to: string) => `${label}，从 ${from} 到 ${to}`,
    guessedWell: "猜得好！",
    guessedOff: (angle: string, further: boolean) =>
      `比你的猜测${further ? "多" : "少"}绕了 ${angle}。`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `你猜的是 ${said}${straight ? "，正对面" : ""}。它在 ${turned} 处升起。`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `接触点绕行了 ${angle}，其中大部分只用 ${time}。${NOUNS[body]}本身转了 ${itself}。底缘下的缝隙缩小到 ${gap}，但底缘总有一点接触桌面。`,
    straight: (angle: string) => `${angle}，正对面`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}，${beyond ? "超过" : "不到"}正对面 ${aside}`,
    sideways: "手的侧向误差",
    friction: "桌面的摩擦",
    height: "圆柱的高度",
    body: "物体",
    bodies: { coin: "硬币", ring: "圆环", battery: "电池", bottle: "瓶子" },
    lines: {
      turn: "绕行角",
      limit: "极限",
      here: "这个桌面上的极限",
      noSlip: "无滑动",
      frictionless: "无摩擦",
      noSlipLimit: "无滑动极限",
    },
    hand: (angle: string, gap: string, time: string) =>
      `接触点绕行了 ${angle}。底缘下的缝隙缩小到 ${gap}，绕行角的大部分只用 ${time}。`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `接触点绕行了 ${angle}，底缘${rolled ? "一路滚动" : "在途中滑动"}。罐子落得越平，绕行角在这个桌面上就越接近 ${limit}。`,
    cylinder: (angle: string, limit: string) =>
      `接触点绕行了 ${angle}。这个圆柱的极限是 ${limit}。`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `接触点绕行了 ${angle}。极限是无滑动 ${noSlip}，无摩擦 ${frictionless}。`,
  },

  story: {
    where: (step: number, of: number) => `讲解，第 ${step} 步，共 ${of} 步`,
    back: "‹ 返回",
    backLabel: "返回上一步",
    show: "演示",
    next: "下一步 ›",
    nextLabel: "下一步",
    steps: {
      looks: {
        title: "看起来像摇摆",
        text: "把一个罐子弄斜，再松手。它好像平拍在桌上，又在另一侧翘起。影片停在这次升起的最高点：罐子没有在正对面升起，而是偏了 23°。",
      },
      slower: {
        title: "放慢再看",
        text: "让它从小倾角落下，放慢五十倍来看。底面从不拍击桌面。它几乎平放，但只有底缘的一点接触桌面。",
      },
      rolls: {
        title: "它在滚动",
        text: "现在凑近看：接触点绕底缘飞驰时，时间被拉长。小柱表示底缘下的缝隙，画得高了几千倍。接触点在不到万分之一秒内绕行超过半圈，但底缘上的标记留在原处：罐子本身没有转。它沿着底缘滚动。",
      },
      same: {
        title: "每次的角度都一样",
        text: "一次又一次松手。向左还是向右由偶然决定，接触点走多远却不是：每次都接近 202°，罐子落得越平就越接近。极限只取决于罐子：",
        symbols: "m 是质量，R 是底面半径，H 是质心高度，A 是绕过质心的横轴的转动惯量。",
      },
      friction: {
        title: "摩擦",
        text: "在没有摩擦的桌面上，罐子滑动而不滚动，绕行角为 221°。真实的桌面介于两者之间。论文作者把一个罐子轻弹了 42 次，测得平均值向左 213°，向右 218°。试试接近 0.1 的摩擦，再改变桌面，看两个峰怎样移动。",
      },
      yourTurn: {
        title: "轮到你了",
        text: "抓住物体的顶部，把它弄斜。松手，或在手移动时松开来轻弹它。改变物体和桌面，装满瓶子，旋转硬币。要保存一个运动或给朋友看，请用下面的“分享”。",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `各次倒下的绕行角，从 ${from} 到 ${to}，每柱 ${width}。`,
    caption: (width: string) => `各次倒下的绕行角：上为左，下为右，每柱 ${width}。`,
    measured: "带点的线：论文中各次倒下的平均值和散布。",
    left: (count: number) => `左：${count}`,
    right: (count: number) => `右：${count}`,
  },

  flicks: {
    title: "四十二次轻弹",
    hint: "没有哪只手能精确重复一个动作。让这次松手略有差异地重复多次，看物体倒向哪里。",
    clear: "清除",
    hand: "手",
    picture: "从上方看物体倒下的方向",
    left: "手的左边",
    right: "右边",
    noSlip: "无滑动极限",
    frictionless: "无摩擦极限",
    here: "这个桌面上的极限",
    measured: (left: string, right: string) => `论文：${left} 和 ${right}`,
    twisted: "这些极限适用于松手时不旋转的物体。",
    initialLean: "初始倾斜方向",
    own: {
      title: "你自己的数据",
      help: "你的罐子倒向哪里？输入以度为单位的方向，从初始倾斜方向逆时针计；倒向你左边的大于 180。要合并几个小组的数据，粘贴他们的链接。",
      add: "添加",
      clear: "全部删除",
      refused: "请输入 0 到 360 之间的数，用空格分开，或粘贴带数据的链接。",
    },
    fit: {
      ask: "哪个摩擦最吻合？",
      running: "正在尝试各种摩擦…",
      answer: (friction: string, low: string, high: string) =>
        `摩擦 ${friction} 最吻合；如果手像这里设定的那样，${low} 到 ${high} 也几乎同样吻合。`,
      none: "没有哪个摩擦值使物体倒向这些方向。",
    },
    running: "正在轻弹…",
    none: "这个设置不能轻弹。",
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const each = sides.map(({ side, count, angle }) => {
        const did = fell ? `倒向${SIDES[side]}边` : `在${SIDES[side]}边升起`;
        return count === 0 ? `没有一次${did}` : `${count} 次${did}，绕行角 ${angle}`;
      });
      const rest = others > 0 ? `；${others} 次是别的结果` : "";
      return `${made} 次轻弹中，${each.join("；")}${rest}。`;
    },
  },

  limits: {
    title: "这个模型忽略了什么",
    unevenness: "底缘和桌面的不平度",
    unevennesses: {
      ground: "0.02 mm，磨削",
      fine: "0.1 mm，精",
      medium: "0.2 mm，中等",
      coarse: "0.4 mm，粗",
      dented: "1 mm，有凹痕",
    },
    touches: (time: string, angle: string, whole: string) =>
      `在这样的不平度下，它们在 ${time} 内有多点接触。其间接触点绕行 ${whole} 中的 ${angle}；这一部分取决于两者的形状。`,
    touchesOnce: "缝隙始终大于这个不平度，所以底缘和桌面一直只在一点接触。",
    intro: "这里的物体和桌面是完全刚性且光滑的，底缘是完美的圆，也没有空气。在所示的这次绕行中：",
    none: "这个物体没有落下，所以没有可比较的。",
    trust:
      "如果一个数超出了真实物体的可能，就不要相信缝隙和速度。可以相信角度，它几乎不受缝隙大小的影响。手的侧向误差约为 0.02 rad/s。",
    gap: "底缘下的最小缝隙",
    gapTiny: "小于任何底缘和桌面的不平度（0.1 到 0.4 mm）：它们在多点接触。",
    gapSmall: "不大于底缘和桌面的不平度（0.1 到 0.4 mm）：它们可能在多点接触。",
    gapWide: "大于底缘和桌面的不平度（0.1 到 0.4 mm）。",
    speed: "接触点沿底缘的速度",
    speedBeyond: "快于钢、铝或玻璃中的声速（5 到 6 km/s）：底缘和桌面来不及给它让路。",
    speedNear: "比钢、铝或玻璃中的声速（5 到 6 km/s）慢不了多少。",
    speedBelow: "慢于钢、铝或玻璃中的声速（5 到 6 km/s）。",
    time: "绕行角大部分所用的时间",
    bends: (sound: string) =>
      `声音穿过底面需要 ${sound}：物体会弯曲和振动，而不是作为一个整体运动。`,
    isRigid: (sound: string) => `声音穿过底面需要 ${sound}：物体作为一个整体运动。`,
    force: "对桌面的最大力",
    timesWeight: (ratio: string) => `重量的 ${ratio} 倍`,
    atOnePoint: "作用在底缘的一点。那里会不会被压出凹痕，取决于重量、材料和边缘。",
    losses: "这次绕行中损失的能量",
    lossless:
      "真实的罐子每次绕行都会因声音、空气和弯曲损失能量，很快就静止。“滚动阻力”就是这样一种损失。",
    loses: "这里忽略的声音、空气和弯曲会带走更多。",
  },

  gyro: {
    title: "物体里的手机",
    intro:
      "随物体转动的陀螺仪看不到接触点绕行。在垂直于轴线的平面内，它看到一条条射线：物体沿一条落下，沿下一条升起。每次近碰撞都使射线转过绕行角减去 180° 的角度。",
    save: "保存为 phyphox CSV",
    saved: (name: string, command: string) => `${name} 已保存。用这个命令读取：${command}`,
    veers: (angles: string) => `射线最初的几次转动：${angles}。`,
    noTurn: "没有完整的绕行，所以没有射线转动。",
    picture: (largest: string) => `物体参考系中垂直于轴线的角速度，最大 ${largest}。`,
  },

  share: {
    title: "分享",
    link: {
      help: "链接包含全部设置。任何服务器都看不到它。",
      label: "这个设置的链接",
      copy: "复制链接",
      copied: "链接已复制。",
    },
    command: {
      help: "这个页面的地址只在你自己的电脑上有效。这条命令可在任何装有 rimroll 的地方打开相同的设置。",
      label: "打开这个设置的命令",
      copy: "复制命令",
      copied: "命令已复制。",
    },
    labTitle: "桌上的罐子",
    frame: "放到网页或幻灯片中",
    frameHelp: (isLocal: boolean) =>
      `把这段代码粘贴到网页或幻灯片的 HTML 中。${isLocal ? "再把本页面的文件夹复制到旁边，命名为 lab。" : ""}`,
    copyFrame: "复制代码",
    copiedFrame: "代码已复制。",
    python: "Python 代码",
    copyPython: "复制为 Python",
    copiedPython: "Python 代码已复制。",
    csv: "下载 CSV",
    saved: (name: string) => `${name} 已下载，采用国际单位制和弧度。`,
    select: "已选中：用 Ctrl+C 或 ⌘C 复制。",
    samePython: "用 Python 表示的同一运动",
  },

  transport: {
    group: "播放",
    shown: "所示时刻",
    play: "播放",
    pause: "暂停",
    rewind: "回到松手时",
    before: "到上一次碰撞",
    after: "到下一次碰撞",
    back: "上一帧",
    on: "下一帧",
    space: "空格",
    stretching: "接触点绕底缘飞驰时自动放慢时间",
    of: (time: string, end: string) => `${time}，共 ${end}`,
    atCollision: "碰撞时",
    fromCollision: (time: string, when: "before" | "after") =>
      `碰撞${{ before: "之前", after: "之后" }[when]} ${time}`,
    inRealTime: "实时",
    slower: (times: string) => `放慢 ${times} 倍`,
    keys: "按键",
    keyPlay: "播放，暂停",
    keyBack: "上一帧",
    keyOn: "下一帧",
    keyHome: "回到松手时",
    keysOn: "这些按键在页面任何地方都有效",
  },

  sound: {
    name: "声音",
    turnOn: "打开底缘的声音，与影片同样放慢",
    turnOff: "关闭声音",
    missing: "这个浏览器无法播放声音",
  },

  plots: {
    absent: "没有可以绘制的运动。",
    hint: "在图上拖动可放大，单击可到某一时刻，双击显示整个运动。单击之后或按住 Ctrl，鼠标滚轮也可缩放。在触摸屏上，单指到某一时刻，双指缩放。",
    nothing: "没有可显示的",
    range: (low: string, high: string) => `在 ${low} 和 ${high} 之间`,
    summary: (title: string, stretch: string, range: string) =>
      `${title}随时间的变化，${stretch}：${range}`,
    timeLabel: (unit: string) => `时间，${unit}`,
    since: (unit: string, origin: string) => `${unit}，相对于 ${origin}`,
    collisionAt: (time: string) => `${time} 的碰撞`,
    stretch: (from: string, to: string) => `从 ${from} 到 ${to}`,
    about: (stretch: string, origin: string) => `${stretch}，相对于 ${origin}`,
    whole: "整个运动",
    close: "这次碰撞",
    closeHelp: "显示离所示时刻最近的碰撞",
    zoom: "缩放",
    zoomIn: "放大",
    zoomOut: "缩小",
    shown: (stretch: string) => `所示：${stretch}`,
    shaded: "阴影：",
    now: (phase: string) => `在所示时刻：${phase}。`,
    plot: "图",
    phases: {
      standing: "静立",
      rolling: "滚动",
      sliding: "滑动",
      sliding_flat: "平放滑动",
      flying: "飞行",
      flying_level: "水平飞行",
      lying: "躺倒",
    },
    figures: {
      floor: { title: "地面加速度", short: "地面", x: "沿 x", y: "沿 y", z: "向上" },
      tilt: { title: "倾角", short: "倾角", tilt: "倾角" },
      yaw: { title: "方位角", short: "方位", yaw: "倾斜方向", theory: "理论，首次绕行" },
      rates: { title: "角速度", short: "角速度", tilt: "倾角", yaw: "方位角", spin: "自转" },
      gyroscope: { title: "物体中的陀螺仪", short: "陀螺仪", x: "x", y: "y", z: "z，轴线" },
      friction: {
        title: "摩擦比",
        short: "摩擦",
        available: "可用 μ",
        used: "已用 |T|/N",
        needed: "滚动所需 μ*",
      },
      energy: {
        title: "能量",
        short: "能量",
        potential: "势能",
        kinetic: "动能",
        sliding: "滑动损失",
        rolling: "滚动损失",
        impacts: "碰撞损失",
      },
    },
  },

  compare: {
    title: "比较…",
    help: "在第一个运动旁边同时显示第二个。",
    presets: {
      ice: "冰和橡胶",
      coin: "罐子和硬币",
      mirror: "这个初始状态和它的镜像",
      keep: "保留这个运动，改变设置",
    },
    keyA: "A，实线：上面的设置",
    keyB: "B，虚线：另一个",
    setup: "设置",
    turn: "首次绕行",
    difference: "B 比 A",
    rows: {
      turn: "接触点绕行",
      itself: "物体本身转了",
      limit: "理论极限",
      tilt: "最小倾角",
      gap: "当时底缘下的缝隙",
      time: "到那时所用的时间",
      passage: "绕行角大部分所用的时间",
      force: "最大力，以重量计",
      energy: "保留的能量",
      end: "整个运动的结束时刻",
    },
    ending: "怎样结束",
    endings: {
      finished: "还在运动",
      toppled: "倒下",
      lifted_off: "离开桌面",
      face_down: "平落",
      at_rest: "静止",
      painleve: "没有答案",
      failed: "停止",
    },
    same: "两个设置目前相同。改变上面的设置：B 保持不变。",
    refused: (which: "A" | "B", why: string) => `${which} 没有运动：${why}。`,
    none: "其中一个物体没有落下，所以没有绕行角可以比较。",
    equal: (angle: string) => `两者的接触点都绕行了 ${angle}（精确到一位小数）。`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `接触点在 A 中绕行 ${a}，在 B 中绕行 ${b}：B 中${further ? "多" : "少"} ${apart}。`,
    swap: "交换 A 和 B",
    stop: "停止比较",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which}：${text}`,
    drawn: (body: BodyName, times: string) => `${NOUNS[body]}，绘图比例为 A 的 ${times} 倍`,
    plot: (label: string) => `${label}，B`,
    total: "动能和势能，B",
    inLink: (message: string) => `与之比较：${message}`,
  },
  scene: {
    picture: "桌上的物体",
    tip: "先按住物体片刻，再把它弄斜。",
    reset: "重置视角",
    places: { above: "从上看", contact: "接触点", below: "从下看" },
    help: "怎样使用这幅图",
    gestures:
      "拖动物体，把它弄斜；用手指时先按住片刻。松手就放开它，在运动中松手就轻弹它。拖动桌子可以从另一侧看。要缩放，用两指张合，或在单击图像之后或按住 Ctrl 时转动鼠标滚轮。",
    keysTitle: "焦点在图上时的按键：",
    keys: [
      ["← → ↑ ↓", "从另一侧看，也可从下面看"],
      ["Page Up, Page Down", "放大，缩小"],
      ["Home", "重置视角"],
      ["+ 和 −", "拿住物体，倾斜 1°"],
      ["Shift + ← →", "拿着它时，把倾斜方向转 5°"],
      ["Enter", "静止松手"],
      ["Shift + Enter", "按设定的速度轻弹"],
      ["Esc", "放回去"],
    ],
    rolls: "滚动",
    slips: "滑动",
    flies: "在空中",
    square: (length: string) => `1 格 = ${length}`,
    notLoaded: "图像无法加载。请重新加载页面。",
    noWebGL: "这个浏览器无法显示图像，因为 WebGL 已关闭或不存在。",
    rest: "页面的其余部分可用：运动、角度和图。",
    stopped: "这个浏览器的图形功能已停止。恢复后图像会重新出现。",
    ranRound: (angle: string) => `接触点绕行 ${angle}`,
    itself: (body: BodyName, angle: string) => `${NOUNS[body]}本身转了 ${angle}`,
    guess: (angle: string) => `你的猜测 ${angle}`,
    noSlip: "无滑动",
    frictionless: "无摩擦",
    theory: "理论",
    gap: (gap: string) => `缝隙 ${gap}`,
    gapDrawn: (gap: string, times: string) => `缝隙 ${gap}，画成 ${times} 倍高`,
    unrolled: "展开的接触点路径：",
    table: "桌面",
    rim: "底缘",
    noSlipYet: "它无滑动地滚动",
    slipped: (length: string) => `底缘滑动了 ${length}`,
    runs: (rim: string, table: string, slip: string) =>
      `在这次绕行中，接触点沿底缘走了 ${rim}，沿桌面走了 ${table}：${slip}。`,
  },

  prose: {
    title: "rimroll：倾斜的罐子",
    skip: "跳到设置",
    tagline: "倾斜的罐子好像在摇摆，其实是接触点绕底缘飞驰。",
    "part.nav": "本页面的各部分",
    "part.controls": "设置",
    "part.compare": "比较",
    "part.flicks": "轻弹",
    "part.plots": "图表",
    "part.share": "分享",
    "part.limits": "局限",
    "part.gyro": "陀螺仪",
    "to-lab": "实验室",
    "to-essay": "这是什么？",
    "question.title": "它会在哪里升起？",
    "question.text":
      "把一个罐子弄斜，再松手。它倒回直立，底面几乎碰到桌面，然后又升起。把线转到你认为它会升起的地方，再松手。",
    "slap-or-roll.title": "拍击还是滚动？",
    "slap-or-roll.text":
      "它不像摇椅那样在正对面升起，而是偏了 {0}。看上去，底面拍击桌面，罐子随即弹起。事实并非如此。",
    "slap-or-roll.slow":
      "在这里，罐子几乎平放时时间变慢，小柱表示底缘下的缝隙，画得比实际高。底缘只有一点接触桌面，这一点沿底缘绕行：大部分路程只用 {0}。看底缘上的标记。它们留在原处。罐子没有转；它沿着底缘滚动。",
    "hand.title": "为什么与手无关",
    "hand.text":
      "松手不可能毫无误差。一个小小的侧向误差决定罐子向左还是向右绕，以及底面离桌面多近。移动滑块：缝隙和时间变化上百倍，角度几乎不变。",
    "hand.limit": "手越稳，角度就越接近一个极限，对这个罐子是 {0}。极限只取决于罐子：",
    "hand.symbols":
      "其中 {0} 是质量，{1} 是底面半径，{2} 是质心高度，{3} 是绕过质心的横轴的转动惯量。",
    "friction.title": "从冰到橡胶",
    "friction.text":
      "要滚得这样快，底缘必须抓牢桌面。摩擦达到 {0} 时，这个罐子一路滚动。不足时底缘滑动，它在别处升起。完全没有摩擦时，极限是 {1}。",
    "friction.try": "把滑块从冰移到橡胶。桌面上的路径呈橙色之处，底缘在滑动。",
    "tall-and-flat.title": "高和扁",
    "tall-and-flat.text":
      "高的物体几乎摇到正对面。物体越扁，接触点走得越远。改变这个实心圆柱的高度，看它在哪里升起。",
    "disks-and-coins.title": "圆盘和硬币",
    "disks-and-coins.text":
      "没有高度的均匀圆盘，质心就在底面上，上面的公式给出 {0}，即 {1}：一整圈再加 {2}。这时摩擦毫无影响。硬币接近这种情形。比较其他物体。",
    "experiment.title": "四十二次轻弹",
    "experiment.text":
      "论文作者把一个罐子轻弹了 42 次，记下它倒向哪里。平均绕行角向左为 {0}，向右为 {1}，介于无滑动和无摩擦的极限之间。",
    "experiment.try":
      "在这里用不稳的手轻弹罐子，然后改变摩擦，直到你的结果与他们的重合。哪个摩擦最吻合？",
    "left-out.title": "忽略了什么",
    "left-out.text":
      "这个罐子和这张桌子是完全刚性且光滑的，也没有空气。这样近似有多好？这取决于底面离桌面多近。下表列出这个运动的数值，旁边是真实罐子所允许的。让手更稳，看哪些数值变得没有意义。",
    "your-turn.title": "轮到你了",
    "your-turn.text":
      "亲手试试罐子。在实验室里你可以做得更多：改变物体、桌面和初始状态，装满瓶子，旋转硬币，摇动地面，查看各种力和能量，并保存或发送你的发现。",
    "your-turn.lab": "打开实验室",
    "section.scene": "桌子",
    "section.transport": "时间",
    "section.verdict": "发生了什么",
    "section.story": "讲解",
    "section.controls": "设置",
    "section.compare": "比较",
    "section.plots": "图表",
    "section.flicks": "四十二次轻弹",
    "section.share": "分享",
    "section.limits": "这个模型忽略了什么",
    "section.gyro": "物体里的手机",
    "foot.paper":
      "力学依据 M. Srinivasan 和 A. Ruina，“Rocking and rolling: a can that appears to rock might actually roll”，{0}。",
    "foot.private": "每个运动都在你自己的设备上计算。不会发送任何数据。",
    "foot.parts": "本页面及其各部分的{0}。",
    "foot.licences": "许可证",
    "foot.languages": "语言",
  },
};
