// Portuguese, as in Brazil. See en.ts for what each word is for.

import type { BodyName } from "../setup/fields";
import type { SideCount, Turned } from "./en";
import type { Table } from "./words";

/** The bodies with their articles. */
const NOUNS: Record<BodyName, string> = {
  can_2007: "a lata",
  soda_can: "a lata",
  beer_bottle: "a garrafa",
  coin: "a moeda",
  ring: "o anel",
  battery: "a pilha",
  euler_disk: "o disco",
  own: "o corpo",
  inertia: "o corpo",
};

const begins = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
const Noun = (body: BodyName) => begins(NOUNS[body]);
/** The body itself, with its article. */
const theBodyItself = (body: BodyName) =>
  NOUNS[body].replace(/^a /, "a própria ").replace(/^o /, "o próprio ");

const leaning = (body: BodyName) => (NOUNS[body].startsWith("a ") ? "inclinada" : "inclinado");

const SIDES = { left: "à esquerda", right: "à direita" } as const;

export const pt: Table = {
  between: " ",

  loading: "Carregando…",
  letGo: "Soltar",
  flickTimes: (count: number) =>
    count === 1 ? "Impulsionar uma vez" : `Impulsionar ${count} vezes`,
  flickAgain: (count: number) => `Impulsionar mais ${count} vezes`,
  openLab: "Abrir o laboratório",
  notStarted: (why: string) => `A página não pôde ser iniciada: ${why}. Recarregá-la pode ajudar.`,

  fields: {
    body: {
      label: "Corpo",
      help: "O corpo que está sobre a mesa.",
      choices: {
        can_2007: "Lata do artigo",
        soda_can: "Lata de refrigerante",
        beer_bottle: "Garrafa de cerveja",
        coin: "Moeda (1 euro)",
        ring: "Anel",
        battery: "Pilha (AA)",
        euler_disk: "Disco de Euler",
        own: "O seu",
        inertia: "Pela inércia",
      },
    },
    fill: {
      label: "Enchimento",
      help: "Quanto da lata ou da garrafa está cheio. A bebida se move com ela como um sólido.",
    },
    radius: { label: "Raio", help: "Raio da borda." },
    length: { label: "Altura", help: "Da base ao topo. 0 é um disco plano." },
    mass: { label: "Massa", help: "Massa total. Nenhum ângulo percorrido depende dela." },
    wall: {
      label: "Massa na parede",
      help: "Parte da massa acima da placa da base: 0 é um cilindro maciço, 100 um tubo fino.",
    },
    base: {
      label: "Massa na base",
      help: "Parte da massa total em uma placa fina no fundo.",
    },
    height: {
      label: "Centro de massa",
      help: "Altura do centro de massa acima da base. 0 é um disco plano.",
    },
    transverse: {
      label: "A/m",
      help: "Momento de inércia em relação a um eixo transversal pelo centro de massa, dividido pela massa.",
    },
    axial: {
      label: "C/m",
      help: "Momento de inércia em relação ao eixo do corpo, dividido pela massa. Nenhum corpo rígido tem mais de 2 A/m.",
    },
    tilt: { label: "Inclinação", help: "Quanto o corpo está inclinado quando é solto." },
    tilt_rate: {
      label: "Velocidade de inclinação",
      help: "Com 0 o corpo é solto em repouso. Um valor negativo o impulsiona para a vertical.",
    },
    sideways: {
      label: "Erro lateral",
      help: "A rapidez com que o corpo também gira em torno da direção em que se inclina. Nenhuma mão evita esse erro.",
    },
    twist: {
      label: "Giro",
      help: "A rapidez com que o corpo também gira em torno da vertical.",
    },
    yaw: {
      label: "Inclinado para",
      help: "A direção da inclinação sobre a mesa. Todo o movimento gira com ela.",
    },
    law: {
      label: "Mesa",
      help: "“Sem atrito” e “Sem deslizar” são as duas leis ideais do artigo.",
      choices: {
        frictionless: "Sem atrito",
        coulomb: "Atrito seco",
        no_slip: "Sem deslizar",
      },
    },
    friction: {
      label: "Atrito",
      help: "Coeficiente de atrito μ: força de atrito máxima dividida pela força normal.",
    },
    rolling: {
      label: "Resistência ao rolamento",
      help: "Força de resistência dividida pela força normal: cerca de 0,0001 para uma borda dura sobre uma mesa dura. Ela freia o movimento.",
    },
    restitution: {
      label: "Quique",
      help: "Coeficiente de restituição quando a borda cai na mesa depois de um voo.",
    },
    gravity: { label: "Gravidade", help: "9,81 na Terra, 1,62 na Lua." },
    duration: { label: "Duração", help: "O tempo durante o qual o movimento é calculado." },
    floor: {
      label: "Chão",
      help: "Indica se o chão se move. A mesa se move com ele, sem girar.",
      choices: { rest: "Em repouso", pulse: "Um pulso", hand: "À mão" },
    },
    start: {
      label: "Início",
      help: "Indica se o corpo começa inclinado ou apoiado na base.",
      choices: { tilted: "Inclinado", standing: "Apoiado" },
    },
    pulse: {
      label: "Forma",
      help: "A aceleração do chão ao longo do tempo.",
      choices: {
        sine: "Seno",
        cosine: "Cosseno",
        half_sine: "Meio seno",
        ricker: "Ondaleta de Ricker",
        rectangular: "Retângulo",
      },
    },
    shake: {
      label: "Amplitude",
      help: "Aceleração horizontal máxima. 9,81 é a gravidade na Terra, 1 g.",
    },
    vertical: {
      label: "Vertical",
      help: "Aceleração vertical máxima; se for positiva, é primeiro para cima.",
    },
    period: {
      label: "Período",
      help: "Duração de uma oscilação; em um meio seno e em um retângulo, o tempo até o fim.",
    },
    cycles: { label: "Ciclos", help: "Número de oscilações de um seno ou cosseno." },
    direction: {
      label: "Direção",
      help: "A direção da aceleração horizontal, como em “Inclinado para”.",
    },
    flat: {
      label: "Queda de chapa",
      help: "O que acontece quando toda a base chega ao mesmo tempo. A mecânica dos corpos rígidos não o determina.",
      choices: {
        stop: "O movimento termina",
        smooth_left: "Corre pela esquerda",
        smooth_right: "Corre pela direita",
        housner: "Impacto de Housner",
      },
    },
    record: { label: "Registro" },
    falls: { label: "Quedas" },
    flicks: { label: "Impulsos", help: "Quantas vezes se repete a tentativa. No artigo: 42." },
    unsteadiness: {
      label: "Tremor da mão",
      help: "Com 100, um impulso se desvia do meio cerca de 3°.",
    },
    seed: {
      label: "Semente",
      help: "Semente dos números aleatórios. A mesma semente dá a mesma dispersão.",
    },
  },

  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label}: não existe “${text}”; as opções são ${[names.slice(0, -1).join(", "), ...names.slice(-1)].join(" ou ")}.`,
    noRecord: (label: string) => `${label}: isto não é um registro desta página.`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label}: “${text}” pode ser lido de duas maneiras; use ${sign === "." ? "um ponto" : "uma vírgula"} antes das casas decimais e nada entre os milhares.`,
    empty: (label: string) => `${label}: falta um número.`,
    noNumber: (label: string, text: string) => `${label}: deve ser um número, não “${text}”.`,
    notWhole: (label: string, text: string) => `${label}: deve ser um número inteiro, não ${text}.`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label}: deve ser maior que ${low} e menor que ${high}; ${text} está fora.`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label}: deve estar entre ${low} e ${high}; ${text} está fora.`,
  },

  playback: {
    speed: "Ritmo",
    realTime: "tempo real",
    slow: "Lento na colisão",
    on: "sim",
    off: "não",
    view: "Vista",
    step: "Passo",
  },

  controls: {
    title: "Montagem",
    standsFlat: "O corpo está apoiado na base, em repouso.",
    undo: "Desfazer",
    reset: "Redefinir",
    more: "Mais",
    hint: "Aponte para um ajuste para ver o que ele significa.",
    dryOnly: "Só vale para o atrito seco.",
    tables: { ice: "gelo", wood: "madeira", rubber: "borracha" },
    losses: { none: "nula", hard: "mesa dura", soft: "mesa macia" },
    lossesOf: (table: string, resistance: string) =>
      `Resistência ao rolamento: ${table}, ${resistance}`,
    frictionOf: (table: string, friction: string) => `Atrito de ${table}, ${friction}`,
    neededLabel: (friction: string) =>
      `${friction}, o atrito de que este corpo precisa para rolar durante a quase colisão`,
    neededHelp: (friction: string) =>
      `Com ${friction} ou mais, este corpo rola durante a quase colisão. Com menos, desliza.`,
    floor: (state: string) => `O chão: ${state.charAt(0).toLowerCase()}${state.slice(1)}`,
    notLoaded: "Não foi possível carregar estes controles. Recarregue a página.",
  },

  floor: {
    isLoading: "a parte da página que move o chão está sendo carregada",
    isMissing: "não foi possível carregar a parte da página que move o chão; recarregue a página",
    push: "Empurrar",
    pushHelp: "Empurra o chão para longe durante um quinto de segundo e inicia o movimento.",
    shake: "Sacudir",
    shakeHelp: "Inicia o movimento do chão e do corpo.",
    note: "Os impulsos e a teoria são os de um chão em repouso. As posições nos gráficos são relativas à mesa.",
    onceOnly: "Só vale para um seno e um cosseno.",
    pad: "Mover a mesa",
    padHelp:
      "Arraste aqui para mover a mesa, um milímetro por pixel. Ao soltar, o corpo é sacudido por esse mesmo movimento. As setas do teclado também movem a mesa.",
    balanceTilt: "Ângulo de tombamento",
    beyondBalance: "além dele, um corpo em repouso tomba",
    largestTilt: "Maior inclinação",
    ofBalance: (ratio: string) => `${ratio} × o ângulo de tombamento`,
    uplift: "Levantamento",
    neverRocks: "nunca começa a balançar",
    whenRocks: "quando começa a balançar",
    leansAtStart: "o corpo começa inclinado",
    itsLargestTilt: (tilt: string) => `A maior inclinação é ${tilt}.`,
    overturns: (body: BodyName, after: string) => `${Noun(body)} tomba após ${after}.`,
    overturnsInAir: (body: BodyName, after: string) =>
      `${Noun(body)} tomba: a borda deixa o chão após ${after}.`,
    undecided: (after: string) =>
      `Quando o cálculo termina, após ${after}, passou do ângulo de tombamento: não está decidido se tomba.`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `Não tomba. ${
        {
          standing: "Está apoiado na base",
          sliding_flat: "Ainda desliza sobre a base",
          flying_level: "Está no ar",
          moving: "Ainda se move",
        }[state]
      } após ${after}, quando o cálculo termina.`,
    stops: (after: string) =>
      `A base cai de chapa após ${after} e o movimento termina, como indica “Queda de chapa”. A mecânica dos corpos rígidos não determina o que se segue.`,
    isStill: "O chão não se move.",
    moves: (far: string, strong: string) =>
      `O chão se move até ${far}, com aceleração de até ${strong}.`,
    beginsToRock: (body: BodyName, at: string) =>
      `${Noun(body)} começa a balançar aos ${at} (levantamento).`,
    rocksAgain: (body: BodyName, at: string) =>
      `${Noun(body)} começa ${leaning(body)}, fica um tempo sobre a base e volta a balançar aos ${at}.`,
    leans: (body: BodyName) => `${Noun(body)} começa ${leaning(body)}.`,
    slides: (body: BodyName) => `${Noun(body)} desliza sobre a base e nunca começa a balançar.`,
    stands: (body: BodyName) =>
      `${Noun(body)} fica em repouso sobre o chão e nunca começa a balançar.`,
  },

  verdict: {
    turned: "O contato percorreu",
    angleOfTurn: "Ângulo percorrido",
    itself: (body: BodyName) => begins(theBodyItself(body)),
    meanwhile: "girou enquanto isso",
    whenLetGo: "visível ao soltar",
    ifLetGo: "se soltar agora",
    theory: "Em teoria",
    smallestTilt: "Menor inclinação",
    gap: (gap: string) => `uma fresta de ${gap}`,
    contactThen: "Contato nesse instante",
    perSecond: "voltas por segundo",
    perSecondAt: (speed: string) => `voltas por segundo, a ${speed}`,
    inHand: "Na sua mão",
    leansToward: (way: string) => `inclinado para ${way}`,
    leansInHand: (tilt: string, way: string) =>
      `Na sua mão, o corpo se inclina ${tilt} para ${way}.`,
    toFlick: "Para impulsionar, solte enquanto a mão se move.",
    wouldBe: {
      floorMoves: "Se soltar agora em repouso, o chão começará a se mover.",
      nothing: "Se soltar agora em repouso, não haverá movimento.",
      rocked: (angle: string, after: string) =>
        `Se soltar agora em repouso, o ponto de contato percorrerá ${angle} ao descer e subir até a próxima inclinação máxima, após ${after}.`,
      hovered: (after: string) =>
        `Se soltar agora em repouso, o corpo não terá descido e subido de novo após ${after}, quando o cálculo termina.`,
      toppled: (angle: string, after: string) =>
        `Se soltar agora em repouso, o ponto de contato percorrerá ${angle} e o corpo tombará após ${after}.`,
      fell_back: (after: string) =>
        `Se soltar agora em repouso, o corpo tombará para o lado em que se inclina, após ${after}.`,
      face_down: (after: string) =>
        `Se soltar agora em repouso, o corpo cairá de chapa após ${after}.`,
      at_rest: (after: string) =>
        `Se soltar agora em repouso, o corpo ficará em repouso na base após ${after}.`,
      lifted_off: (after: string) =>
        `Se soltar agora em repouso, a borda deixará a mesa após ${after}, onde terminam as leis ideais.`,
      painleve: (after: string) =>
        `Se soltar agora em repouso, o corpo encontrará o paradoxo de Painlevé após ${after}, onde a mecânica dos corpos rígidos não tem resposta única.`,
      failed: "Se soltar agora em repouso, o cálculo falhará.",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "Do início" : `Da inclinação máxima aos ${start}`;
      const to = {
        maximum: "a próxima inclinação máxima",
        fall: "a queda",
        end: "o fim",
      }[endsWith];
      const turn = {
        none: itself,
        same: `${itself} no mesmo sentido`,
        other: `${itself} no sentido oposto`,
      };
      return `${from}, descendo e subindo até ${to} aos ${end}, o ponto de contato percorre ${angle}, a maior parte em ${time}; ${theBodyItself(body)} gira ${turn[way]}.`;
    },
    rim: {
      rolled: "O atrito basta: rola o tempo todo.",
      slipped: "A borda desliza no caminho.",
      jumped: "A borda salta da mesa no caminho.",
    },
    fullTurn: (rest: string) => `É uma volta completa e ${rest}.`,
    veers: (angle: string, side: "left" | "right") =>
      `Fica ${angle} ${SIDES[side]} do lado exatamente oposto.`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `de ${angle} ${{ turn: "neste percurso", fall: "quando cai", end: "no fim" }[until]}`,
    comesDownFlat: "cai de chapa",
    incomplete: "o próximo percurso não está completo",
    staysUp: "não desce",
    limitHere: "o limite nesta mesa",
    asComputed: "igual ao calculado aqui",
    below: (angle: string) => `${angle} abaixo do ângulo calculado`,
    above: (angle: string) => `${angle} acima do ângulo calculado`,
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text}; vale para um corpo que ${[...(flat ? ["cai de chapa"] : []), ...(untwisted ? ["é solto sem giro"] : [])].join(" e ")}`,
    noMotion: (why: string) => `Não há movimento para mostrar: ${why}.`,
    stillComputing: (after: string) => `O movimento após ${after} ainda está sendo calculado.`,
    stillMoves: (after: string) => `Ainda se move após ${after}, quando o cálculo termina.`,
    fallsOver: (after: string) => `Tomba após ${after}.`,
    fallsBack: (after: string) => `Tomba após ${after}, para o lado da inclinação inicial.`,
    liftsOff: (after: string | undefined) =>
      `${after === undefined ? "De imediato" : `Após ${after}`} a borda deixaria a mesa. As leis ideais não abrangem o voo, por isso o movimento termina aqui. Escolha o atrito seco para segui-lo.`,
    comesToRest: (after: string) =>
      `Fica em repouso após ${after}: a base está apoiada e a energia se esgotou.`,
    painleve: (after: string, friction: string) =>
      `Paradoxo de Painlevé após ${after}: com tanto atrito, a mecânica dos corpos rígidos não tem resposta única para a borda que desliza. Para este corpo, quase sem inclinação, o paradoxo começa com um atrito de ${friction}. Escolha menos atrito para seguir o movimento.`,
    tooManySteps: (after: string) =>
      `O cálculo para após ${after}, porque precisa de passos demais. Escolha uma duração menor.`,
    cannotContinue: (after: string, why: string) =>
      `O cálculo não pode continuar após ${after}: ${why}.`,
    faceDownStraight: (after: string, least: string) =>
      `De chapa após ${after}: sem movimento lateral, toda a borda chega à mesa ao mesmo tempo. A mecânica dos corpos rígidos não determina o que se segue. Com qualquer erro lateral, por menor que seja, o ponto de contato dá a volta; um erro de ${least} ou mais pode ser calculado.`,
    faceDownResisted: (after: string) =>
      `De chapa após ${after}: a resistência ao rolamento detém o ponto de contato, e a base bate de chapa na mesa. A mecânica dos corpos rígidos não determina o que se segue quando todos os pontos da borda batem ao mesmo tempo. Com menos resistência ou um erro lateral maior, o ponto de contato dá a volta.`,
    faceDownShort: (after: string) =>
      `De chapa após ${after}: cai tão de chapa que a corrida do ponto de contato pela borda é curta demais para ser calculada. Escolha um erro lateral maior.`,
    computationFailed: (why: string) =>
      `o cálculo falhou (${why}); mude a montagem ou recarregue a página`,
  },

  essay: {
    guess: "Seu palpite",
    time: "Tempo",
    closer: "Como pode ser? Veja mais de perto",
    inLab: "Abrir isto no laboratório",
    grasp: "Pegue a lata por cima, incline-a e solte. Com um dedo, segure-a antes por um momento.",
    askTelephone: "Usar a inclinação do celular",
    holdTelephone: "Segure aqui, incline o celular e solte",
    theCan: "A lata, que você pode inclinar",
    theBody: "O corpo sobre a mesa",
    noPicture:
      "Este navegador não pode mostrar a imagem, porque o WebGL está desativado ou ausente. Os textos, os números e as curvas funcionam sem ela.",
    atSmallest: "na menor inclinação",
    fromSmallest: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "antes", after: "depois" }[when]} da menor inclinação`,
    range: (label: string, from: string, to: string) => `${label} de ${from} a ${to}`,
    guessedWell: "Bom palpite!",
    guessedOff: (angle: string, further: boolean) =>
      `São ${angle} ${further ? "a mais" : "a menos"} que o seu palpite.`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `Seu palpite foi ${said}${straight ? ", bem do outro lado" : ""}. A lata subiu em ${turned}.`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `O ponto de contato percorreu ${angle}, a maior parte em ${time}. ${begins(theBodyItself(body))} girou ${itself}. A fresta sob a borda diminuiu para ${gap}, mas algum ponto da borda sempre tocava a mesa.`,
    straight: (angle: string) => `${angle}, bem do outro lado`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}, ${aside} ${beyond ? "além" : "aquém"} do lado exatamente oposto`,
    sideways: "Erro lateral da mão",
    friction: "Atrito da mesa",
    height: "Altura do cilindro",
    body: "Corpo",
    bodies: { coin: "Moeda", ring: "Anel", battery: "Pilha", bottle: "Garrafa" },
    lines: {
      turn: "ângulo percorrido",
      limit: "limite",
      here: "limite nesta mesa",
      noSlip: "sem deslizar",
      frictionless: "sem atrito",
      noSlipLimit: "limite sem deslizar",
    },
    hand: (angle: string, gap: string, time: string) =>
      `O ponto de contato percorreu ${angle}. A fresta sob a borda diminuiu para ${gap}, e a maior parte do ângulo levou ${time}.`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `O ponto de contato percorreu ${angle}, e a borda ${rolled ? "rolou o tempo todo" : "deslizou no caminho"}. Quanto mais de chapa cai uma lata, mais o ângulo se aproxima de ${limit} nesta mesa.`,
    cylinder: (angle: string, limit: string) =>
      `O ponto de contato percorreu ${angle}. O limite para este cilindro é ${limit}.`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `O ponto de contato percorreu ${angle}. Os limites são ${noSlip} sem deslizar e ${frictionless} sem atrito.`,
  },

  story: {
    where: (step: number, of: number) => `A história, passo ${step} de ${of}`,
    back: "‹ Voltar",
    backLabel: "Voltar ao passo anterior",
    show: "Mostrar",
    next: "Próximo ›",
    nextLabel: "Próximo passo",
    steps: {
      looks: {
        title: "Parece um balanço",
        text: "Incline uma lata e solte-a. Ela parece bater de chapa na mesa e se levantar do outro lado. O filme para no alto desta subida: a lata não subiu do lado oposto, mas a 23° dele.",
      },
      slower: {
        title: "Agora mais devagar",
        text: "Solte-a de uma inclinação pequena e veja cinquenta vezes mais devagar. A base nunca bate na mesa. Chega muito perto, mas só um ponto da borda toca a mesa.",
      },
      rolls: {
        title: "Ela está rolando",
        text: "Agora de perto: o tempo se estica enquanto o ponto de contato corre pela borda. Os postes mostram a fresta sob a borda, desenhada alguns milhares de vezes mais alta. O ponto de contato corre mais de meia volta em menos de um décimo de milésimo de segundo, mas as marcas da borda ficam onde estão: a própria lata não gira. Ela rola sobre a borda.",
      },
      same: {
        title: "O ângulo é sempre o mesmo",
        text: "Solte-a várias vezes. O acaso decide entre esquerda e direita, mas não até onde corre o ponto de contato: sempre perto de 202°, e tanto mais perto quanto mais de chapa a lata cai. O limite depende só da lata:",
        symbols:
          "m é a sua massa, R o raio da base, H a altura do centro de massa e A o momento de inércia em relação a um eixo transversal por esse centro.",
      },
      friction: {
        title: "Atrito",
        text: "Em uma mesa sem atrito, a lata desliza em vez de rolar e o ângulo é de 221°. Uma mesa real fica no meio. Os autores do artigo impulsionaram uma lata 42 vezes e mediram médias de 213° à esquerda e 218° à direita. Experimente um atrito perto de 0,1 e mude a mesa para ver os dois picos se moverem.",
      },
      yourTurn: {
        title: "Sua vez",
        text: "Pegue o corpo por cima e incline-o. Solte-o, ou impulsione-o soltando enquanto a mão se move. Mude o corpo e a mesa, encha a garrafa, gire uma moeda. Para guardar ou mostrar um movimento, use “Compartilhar”, mais abaixo.",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `Ângulos percorridos das quedas, de ${from} a ${to} em barras de ${width}.`,
    caption: (width: string) =>
      `Ângulos percorridos das quedas: esquerda em cima, direita embaixo, ${width} por barra.`,
    measured: "Linhas com um ponto: média e dispersão das quedas do artigo.",
    left: (count: number) => `esquerda: ${count}`,
    right: (count: number) => `direita: ${count}`,
  },

  flicks: {
    title: "Quarenta e dois impulsos",
    hint: "Nenhuma mão repete um movimento exatamente. Repita este início com alguma dispersão e veja para onde o corpo cai.",
    clear: "Apagar",
    hand: "A mão",
    picture: "Direções em que o corpo caiu, vistas de cima",
    left: "à esquerda da mão",
    right: "à direita",
    noSlip: "limite sem deslizar",
    frictionless: "limite sem atrito",
    here: "limite nesta mesa",
    measured: (left: string, right: string) => `o artigo: ${left} e ${right}`,
    twisted: "Os limites valem para um corpo solto sem giro.",
    initialLean: "inclinação inicial",
    own: {
      title: "Suas próprias quedas",
      help: "Para onde caiu a sua lata? Escreva as direções em graus, no sentido anti-horário a partir da inclinação inicial; as quedas à sua esquerda ficam acima de 180. Para juntar vários grupos, cole os links deles.",
      add: "Adicionar",
      clear: "Remover todas",
      refused: "Escreva números de 0 a 360 com espaços entre eles, ou cole links com quedas.",
    },
    fit: {
      ask: "Qual atrito se ajusta?",
      running: "Testando atritos…",
      answer: (friction: string, low: string, high: string) =>
        `Um atrito de ${friction} se ajusta melhor; de ${low} a ${high}, quase tão bem, se a mão for como a daqui.`,
      none: "Nenhum dos atritos faz o corpo cair para estes lados.",
    },
    running: "Impulsionando…",
    none: "Esta montagem não pode ser impulsionada.",
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const each = sides.map(({ side, count, angle }) => {
        const one = fell ? "caiu" : "subiu";
        const many = fell ? "caíram" : "subiram";
        if (count === 0) return `nenhum ${one} ${SIDES[side]}`;
        return `${count} ${count === 1 ? one : many} ${SIDES[side]} após ${angle}`;
      });
      const rest =
        others > 0 ? `; ${others} ${others === 1 ? "terminou" : "terminaram"} de outro modo` : "";
      return `De ${made} ${made === 1 ? "impulso" : "impulsos"}, ${each.join(", ")}${rest}.`;
    },
  },

  limits: {
    title: "O que este modelo omite",
    unevenness: "Irregularidade da borda e da mesa",
    unevennesses: {
      ground: "0,02 mm, retificada",
      fine: "0,1 mm, fina",
      medium: "0,2 mm, média",
      coarse: "0,4 mm, grosseira",
      dented: "1 mm, amassada",
    },
    touches: (time: string, angle: string, whole: string) =>
      `Com esta irregularidade, elas se tocam em vários pontos durante ${time}. Enquanto isso, o ponto de contato percorre ${angle} dos ${whole}; essa parte depende da forma das duas.`,
    touchesOnce:
      "A fresta é sempre maior que esta irregularidade, por isso borda e mesa se tocam em um só ponto o tempo todo.",
    intro:
      "Aqui o corpo e a mesa são perfeitamente rígidos e lisos, a borda é um círculo perfeito e não há ar. No percurso mostrado:",
    none: "Este corpo não desce, por isso não há nada para comparar.",
    trust:
      "Onde um número ultrapassa o possível para um corpo real, não confie na fresta nem na velocidade. Confie no ângulo, que quase não depende do tamanho da fresta. Uma mão comete um erro lateral de cerca de 0,02 rad/s.",
    gap: "Menor fresta sob a borda",
    gapTiny:
      "Menor que a irregularidade de qualquer borda e mesa, 0,1 a 0,4 mm: elas se tocam em vários pontos.",
    gapSmall:
      "Não maior que a irregularidade da borda e da mesa, 0,1 a 0,4 mm: elas podem se tocar em vários pontos.",
    gapWide: "Maior que a irregularidade da borda e da mesa, 0,1 a 0,4 mm.",
    speed: "Ponto de contato ao longo da borda",
    speedBeyond:
      "Mais rápido que o som em aço, alumínio ou vidro, 5 a 6 km/s: borda e mesa não conseguem ceder a tempo.",
    speedNear: "Não muito mais lento que o som em aço, alumínio ou vidro, 5 a 6 km/s.",
    speedBelow: "Mais lento que o som em aço, alumínio ou vidro, 5 a 6 km/s.",
    time: "Tempo da maior parte do ângulo",
    bends: (sound: string) =>
      `O som precisa de ${sound} para atravessar a base: o corpo se flexiona e vibra em vez de se mover como uma só peça.`,
    isRigid: (sound: string) =>
      `O som precisa de ${sound} para atravessar a base: o corpo se move como uma só peça.`,
    force: "Maior força sobre a mesa",
    timesWeight: (ratio: string) => `${ratio} × o peso`,
    atOnePoint: "Em um ponto da borda. Se ela amassa ali depende do peso, do material e da aresta.",
    losses: "Energia perdida neste percurso",
    lossless:
      "Uma lata real perde energia em cada percurso, por som, ar e flexão, e logo para. “Resistência ao rolamento” é uma dessas perdas.",
    loses: "O som, o ar e a flexão, que são omitidos, levam mais.",
  },

  gyro: {
    title: "Um celular no corpo",
    intro:
      "Um giroscópio que gira com o corpo não vê o ponto de contato correr. Perpendicularmente ao eixo, ele vê raios: o corpo cai ao longo de um e sobe ao longo do seguinte. Cada quase colisão gira o raio de um ângulo igual ao percorrido menos 180°.",
    save: "Salvar como CSV do phyphox",
    saved: (name: string, command: string) => `${name} salvo. Leia-o com: ${command}`,
    veers: (angles: string) => `Primeiros giros do raio: ${angles}.`,
    noTurn: "Não há nenhum percurso completo, por isso nenhum raio gira.",
    picture: (largest: string) =>
      `Velocidade angular perpendicular ao eixo, no referencial do corpo, até ${largest}.`,
  },

  share: {
    title: "Compartilhar",
    link: {
      help: "O link contém toda a montagem. Nenhum servidor o vê.",
      label: "Link para esta montagem",
      copy: "Copiar link",
      copied: "Link copiado.",
    },
    command: {
      help: "O endereço desta página só funciona no seu computador. Este comando abre a mesma montagem onde o rimroll estiver instalado.",
      label: "Comando que abre esta montagem",
      copy: "Copiar comando",
      copied: "Comando copiado.",
    },
    labTitle: "Uma lata sobre uma mesa",
    frame: "Colocar em uma página ou slide",
    frameHelp: (isLocal: boolean) =>
      `Cole este código no HTML da página ou do slide.${isLocal ? " Copie a pasta desta página para o mesmo lugar, com o nome lab." : ""}`,
    copyFrame: "Copiar código",
    copiedFrame: "Código copiado.",
    python: "Código Python",
    copyPython: "Copiar como Python",
    copiedPython: "Código Python copiado.",
    csv: "Baixar CSV",
    saved: (name: string) => `${name} baixado, em unidades SI e radianos.`,
    select: "Selecionado: copie com Ctrl+C ou ⌘C.",
    samePython: "O mesmo movimento em Python",
  },

  transport: {
    group: "Reprodução",
    shown: "Instante mostrado",
    play: "Reproduzir",
    pause: "Pausa",
    rewind: "Voltar ao início",
    before: "Para a colisão anterior",
    after: "Para a próxima colisão",
    back: "Quadro anterior",
    on: "Próximo quadro",
    space: "Espaço",
    stretching: "Desacelera o tempo automaticamente enquanto o ponto de contato corre pela borda",
    of: (time: string, end: string) => `${time} de ${end}`,
    atCollision: "na colisão",
    fromCollision: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "antes", after: "depois" }[when]} da colisão`,
    inRealTime: "em tempo real",
    slower: (times: string) => `${times} vezes mais lento que o tempo real`,
    keys: "Teclas",
    keyPlay: "reproduzir, pausar",
    keyBack: "quadro anterior",
    keyOn: "próximo quadro",
    keyHome: "voltar ao início",
    keysOn: "Estas teclas funcionam em toda a página",
  },

  sound: {
    name: "Som",
    turnOn: "Ligar o som da borda, desacelerado como o filme",
    turnOff: "Desligar o som",
    missing: "Este navegador não consegue reproduzir som",
  },

  plots: {
    absent: "Não há movimento para representar.",
    hint: "Arraste sobre um gráfico para ampliá-lo, clique para ir a um instante, clique duas vezes para ver todo o movimento. A roda do mouse também amplia, após um clique ou com Ctrl. Em uma tela sensível ao toque, um dedo vai a um instante e dois dedos ampliam.",
    nothing: "nada para mostrar",
    range: (low: string, high: string) => `entre ${low} e ${high}`,
    summary: (title: string, stretch: string, range: string) =>
      `${title} em função do tempo, ${stretch}: ${range}`,
    timeLabel: (unit: string) => `tempo, ${unit}`,
    since: (unit: string, origin: string) => `${unit} desde ${origin}`,
    collisionAt: (time: string) => `a colisão aos ${time}`,
    stretch: (from: string, to: string) => `de ${from} a ${to}`,
    about: (stretch: string, origin: string) => `${stretch}, em relação a ${origin}`,
    whole: "Todo o movimento",
    close: "Esta colisão",
    closeHelp: "Mostra a colisão mais próxima do instante mostrado",
    zoom: "Zoom",
    zoomIn: "Ampliar",
    zoomOut: "Reduzir",
    shown: (stretch: string) => `Mostrado: ${stretch}`,
    shaded: "Sombreado: ",
    now: (phase: string) => `No instante mostrado: ${phase}.`,
    plot: "Gráfico",
    phases: {
      standing: "apoiado",
      rolling: "rola",
      sliding: "desliza",
      sliding_flat: "desliza na base",
      flying: "voa",
      flying_level: "voa na horizontal",
      lying: "deitado",
    },
    figures: {
      floor: {
        title: "Chão, aceleração",
        short: "Chão",
        x: "ao longo de x",
        y: "ao longo de y",
        z: "para cima",
      },
      tilt: { title: "Inclinação", short: "Inclin.", tilt: "inclinação" },
      yaw: {
        title: "Direção",
        short: "Direção",
        yaw: "direção da inclinação",
        theory: "teoria, primeiro percurso",
      },
      rates: {
        title: "Velocidades",
        short: "Veloc.",
        tilt: "inclinação",
        yaw: "direção",
        spin: "rotação própria",
      },
      gyroscope: {
        title: "Giroscópio no corpo",
        short: "Girosc.",
        x: "x",
        y: "y",
        z: "z, o eixo",
      },
      friction: {
        title: "Razão de atrito",
        short: "Atrito",
        available: "disponível μ",
        used: "usado |T|/N",
        needed: "necessário para rolar μ*",
      },
      energy: {
        title: "Energia",
        short: "Energia",
        potential: "potencial",
        kinetic: "cinética",
        sliding: "perdida ao deslizar",
        rolling: "perdida ao rolar",
        impacts: "perdida em impactos",
      },
    },
  },

  compare: {
    title: "Comparar com…",
    help: "Mostra um segundo movimento ao lado do primeiro, ao mesmo tempo.",
    presets: {
      ice: "Gelo e borracha",
      coin: "Lata e moeda",
      mirror: "Este início e seu reflexo",
      keep: "Guardar este movimento e mudar a montagem",
    },
    keyA: "A, linhas cheias: a montagem acima",
    keyB: "B, linhas tracejadas: a outra",
    setup: "Montagem",
    turn: "Primeiro percurso",
    difference: "B em relação a A",
    rows: {
      turn: "O contato percorreu",
      itself: "O próprio corpo girou",
      limit: "Limite em teoria",
      tilt: "Menor inclinação",
      gap: "Fresta sob a borda então",
      time: "Tempo até então",
      passage: "Tempo da maior parte do ângulo",
      force: "Maior força, em pesos",
      energy: "Energia conservada",
      end: "Fim de todo o movimento",
    },
    ending: "Como termina",
    endings: {
      finished: "ainda se move",
      toppled: "tomba",
      lifted_off: "decola",
      face_down: "cai de chapa",
      at_rest: "em repouso",
      painleve: "sem resposta",
      failed: "para",
    },
    same: "As duas montagens são iguais por enquanto. Mude a montagem acima: B fica como está.",
    refused: (which: "A" | "B", why: string) => `${which} não tem movimento: ${why}.`,
    none: "Um dos corpos não desce, por isso não há percurso para comparar.",
    equal: (angle: string) =>
      `O ponto de contato percorreu ${angle} em ambos, com uma casa decimal.`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `O ponto de contato percorreu ${a} em A e ${b} em B: ${apart} ${further ? "a mais" : "a menos"} em B.`,
    swap: "Trocar A e B",
    stop: "Parar de comparar",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which}: ${text}`,
    drawn: (body: BodyName, times: string) => `${Noun(body)}, em escala ${times} vezes a de A`,
    plot: (label: string) => `${label}, B`,
    total: "cinética e potencial, B",
    inLink: (message: string) => `Comparado com: ${message}`,
  },
  scene: {
    picture: "O corpo sobre a mesa",
    tip: "Segure o corpo por um momento e depois incline-o.",
    reset: "Vista inicial",
    places: { above: "De cima", contact: "Contato", below: "De baixo" },
    help: "Como usar esta imagem",
    gestures:
      "Arraste o corpo para incliná-lo; com um dedo, segure-o antes por um momento. Solte-o, ou solte-o em movimento para impulsioná-lo. Arraste a mesa para olhar de outro lado. Para ampliar, afaste dois dedos ou gire a roda do mouse após um clique na imagem ou com Ctrl.",
    keysTitle: "Teclas enquanto a imagem tem o foco:",
    keys: [
      ["← → ↑ ↓", "olhar de outro lado, também de baixo"],
      ["Page Up, Page Down", "ampliar, reduzir"],
      ["Home", "redefinir a vista"],
      ["+ e −", "pegar o corpo e incliná-lo 1°"],
      ["Shift + ← →", "girar a inclinação 5° enquanto o segura"],
      ["Enter", "soltá-lo em repouso"],
      ["Shift + Enter", "impulsioná-lo com as velocidades escolhidas"],
      ["Esc", "colocá-lo de volta"],
    ],
    rolls: "rola",
    slips: "desliza",
    flies: "no ar",
    square: (length: string) => `1 quadrado = ${length}`,
    notLoaded: "Não foi possível carregar a imagem. Recarregue a página para vê-la.",
    noWebGL: "Este navegador não pode mostrar a imagem, porque o WebGL está desativado ou ausente.",
    rest: "O resto da página funciona: o movimento, os ângulos e os gráficos.",
    stopped: "Os gráficos deste navegador pararam. A imagem volta quando recomeçarem.",
    ranRound: (angle: string) => `o contato percorreu ${angle}`,
    itself: (body: BodyName, angle: string) => `${theBodyItself(body)} girou ${angle}`,
    guess: (angle: string) => `seu palpite ${angle}`,
    noSlip: "sem deslizar",
    frictionless: "sem atrito",
    theory: "teoria",
    gap: (gap: string) => `fresta ${gap}`,
    gapDrawn: (gap: string, times: string) => `fresta ${gap}, desenhada ${times} vezes mais alta`,
    unrolled: "Caminho do contato, desenrolado: ",
    table: "mesa",
    rim: "borda",
    noSlipYet: "rola sem deslizar",
    slipped: (length: string) => `a borda deslizou ${length}`,
    runs: (rim: string, table: string, slip: string) =>
      `Neste percurso, o ponto de contato correu ${rim} ao longo da borda e ${table} ao longo da mesa: ${slip}.`,
  },

  prose: {
    title: "rimroll: incline a lata",
    skip: "Pular para a montagem",
    tagline: "Uma lata inclinada parece balançar, mas seu ponto de contato corre pela borda.",
    "part.nav": "Partes desta página",
    "part.controls": "Montagem",
    "part.compare": "Comparar",
    "part.flicks": "Impulsos",
    "part.plots": "Gráficos",
    "part.share": "Compartilhar",
    "part.limits": "Limites",
    "part.gyro": "Giroscópio",
    "to-lab": "O laboratório",
    "to-essay": "O que é isto?",
    "question.title": "Onde vai subir?",
    "question.text":
      "Incline uma lata e solte-a. Ela cai para a vertical, a base quase encontra a mesa, e ela sobe de novo. Gire a linha para onde você acha que ela vai subir e solte.",
    "slap-or-roll.title": "Bate ou rola?",
    "slap-or-roll.text":
      "Ela não sobe exatamente do outro lado, como faria uma cadeira de balanço. Sobe a {0} dali. À primeira vista, a base bate na mesa e a lata quica. Não é isso que acontece.",
    "slap-or-roll.slow":
      "Aqui o tempo desacelera quando a lata está quase em pé, e os postes mostram a fresta sob a borda, desenhada mais alta do que é. Um ponto da borda toca a mesa, e esse ponto percorre a borda: a maior parte do caminho em {0}. Repare nas marcas da borda. Ficam onde estão. A lata não gira; rola sobre a borda.",
    "hand.title": "Por que a mão não importa",
    "hand.text":
      "Nenhuma mão solta com perfeição. Um pequeno erro lateral decide se a lata gira para a esquerda ou para a direita, e quão perto a base chega da mesa. Mova o controle: a fresta e o tempo mudam por um fator de cem. O ângulo quase não muda.",
    "hand.limit":
      "Quanto mais firme a mão, mais perto o ângulo fica de um limite, {0} para esta lata. O limite depende só da lata:",
    "hand.symbols":
      "Aqui {0} é a massa, {1} o raio da base, {2} a altura do centro de massa e {3} o momento de inércia em relação a um eixo transversal por esse centro.",
    "friction.title": "Do gelo à borracha",
    "friction.text":
      "Para rolar tão depressa, a borda precisa aderir à mesa. Com um atrito de {0} ou mais, esta lata rola o tempo todo. Com menos, a borda desliza e a lata sobe em outro lugar. Sem atrito nenhum o limite é {1}.",
    "friction.try":
      "Mova o controle do gelo à borracha. Onde o caminho na mesa é laranja, a borda desliza.",
    "tall-and-flat.title": "Alto e plano",
    "tall-and-flat.text":
      "Um corpo alto balança quase exatamente para o lado oposto. Quanto mais plano é, mais longe corre o ponto de contato. Mude a altura deste cilindro maciço e veja onde ele sobe.",
    "disks-and-coins.title": "Discos e moedas",
    "disks-and-coins.text":
      "Em um disco homogêneo sem espessura, o centro de massa fica na base, e a fórmula acima dá {0} ou {1}: uma volta completa e mais {2}. O atrito então não faz diferença. Uma moeda chega perto disso. Compare outros corpos.",
    "experiment.title": "Quarenta e dois impulsos",
    "experiment.text":
      "Os autores do artigo impulsionaram uma lata 42 vezes e anotaram para onde ela caiu. Os ângulos médios foram {0} à esquerda e {1} à direita, entre os limites sem deslizar e sem atrito.",
    "experiment.try":
      "Impulsione aqui a lata com uma mão trêmula e depois mude o atrito até suas quedas ficarem onde ficaram as deles. Qual atrito se ajusta melhor?",
    "left-out.title": "O que é omitido",
    "left-out.text":
      "Esta lata e esta mesa são perfeitamente rígidas e lisas, e não há ar. Até que ponto vale? Depende de quão perto a base chega da mesa. A lista tem os números deste movimento, cada um ao lado do que uma lata real permite. Torne a mão mais firme e veja quais deixam de fazer sentido.",
    "your-turn.title": "Sua vez",
    "your-turn.text":
      "Agora pegue a lata. No laboratório você pode fazer mais: mudar o corpo, a mesa e o início, encher a garrafa, girar uma moeda, sacudir o chão, ver cada força e energia, e guardar ou enviar o que encontrar.",
    "your-turn.lab": "Abrir o laboratório",
    "section.scene": "A mesa",
    "section.transport": "Tempo",
    "section.verdict": "O que acontece",
    "section.story": "A história",
    "section.controls": "Montagem",
    "section.compare": "Comparação",
    "section.plots": "Gráficos",
    "section.flicks": "Quarenta e dois impulsos",
    "section.share": "Compartilhar",
    "section.limits": "O que este modelo omite",
    "section.gyro": "Um celular no corpo",
    "foot.paper":
      "A mecânica segue M. Srinivasan e A. Ruina, “Rocking and rolling: a can that appears to rock might actually roll”, {0}.",
    "foot.private":
      "Cada movimento é calculado no seu próprio aparelho. Nada é enviado a lugar nenhum.",
    "foot.parts": "{0} desta página e de suas partes.",
    "foot.licences": "Licenças",
    "foot.languages": "Idiomas",
  },
};
