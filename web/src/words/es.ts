// Spanish. See en.ts for what each word is for.

import type { BodyName } from "../setup/fields";
import type { SideCount, Turned } from "./en";
import type { Table } from "./words";

/** The bodies with their articles. */
const NOUNS: Record<BodyName, string> = {
  can_2007: "la lata",
  soda_can: "la lata",
  beer_bottle: "la botella",
  coin: "la moneda",
  ring: "el anillo",
  battery: "la pila",
  euler_disk: "el disco",
  own: "el cuerpo",
  inertia: "el cuerpo",
};

const begins = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
const Noun = (body: BodyName) => begins(NOUNS[body]);
/** The body itself, with its article. */
const theBodyItself = (body: BodyName) =>
  NOUNS[body].replace(/^la /, "la propia ").replace(/^el /, "el propio ");

const leaning = (body: BodyName) => (NOUNS[body].startsWith("la") ? "inclinada" : "inclinado");

const SIDES = { left: "a la izquierda", right: "a la derecha" } as const;

export const es: Table = {
  between: " ",

  loading: "Cargando…",
  letGo: "Soltar",
  flickTimes: (count: number) => (count === 1 ? "Impulsar una vez" : `Impulsar ${count} veces`),
  flickAgain: (count: number) => `Impulsar ${count} veces más`,
  openLab: "Abrir el laboratorio",
  notStarted: (why: string) =>
    `La página no pudo iniciarse: ${why}. Quizá ayude volver a cargarla.`,

  fields: {
    body: {
      label: "Cuerpo",
      help: "El cuerpo que está sobre la mesa.",
      choices: {
        can_2007: "Lata del artículo",
        soda_can: "Lata de refresco",
        beer_bottle: "Botella de cerveza",
        coin: "Moneda (1 euro)",
        ring: "Anillo",
        battery: "Pila (AA)",
        euler_disk: "Disco de Euler",
        own: "El tuyo",
        inertia: "Por su inercia",
      },
    },
    fill: {
      label: "Llenado",
      help: "Cuánto contiene la lata o la botella. La bebida se mueve con ella como un sólido.",
    },
    radius: { label: "Radio", help: "Radio del borde." },
    length: { label: "Altura", help: "De la base a la parte superior. 0 es un disco plano." },
    mass: { label: "Masa", help: "Masa total. Ningún ángulo recorrido depende de ella." },
    wall: {
      label: "Masa en la pared",
      help: "Parte de la masa por encima de la placa de la base: 0 es un cilindro macizo, 100 un tubo delgado.",
    },
    base: {
      label: "Masa en la base",
      help: "Parte de la masa total, en una placa delgada en el fondo.",
    },
    height: {
      label: "Centro de masas",
      help: "Altura del centro de masas sobre la base. 0 es un disco plano.",
    },
    transverse: {
      label: "A/m",
      help: "Momento de inercia respecto a un eje transversal por el centro de masas, dividido entre la masa.",
    },
    axial: {
      label: "C/m",
      help: "Momento de inercia respecto al eje del cuerpo, dividido entre la masa. Ningún sólido rígido tiene más de 2 A/m.",
    },
    tilt: { label: "Inclinación", help: "Cuánto se inclina el cuerpo cuando se suelta." },
    tilt_rate: {
      label: "Velocidad de inclinación",
      help: "Con 0 el cuerpo se suelta en reposo. Un valor negativo lo impulsa hacia la vertical.",
    },
    sideways: {
      label: "Error lateral",
      help: "Con qué rapidez gira además el cuerpo en torno a la dirección en que se inclina. Ninguna mano evita este error.",
    },
    twist: {
      label: "Giro",
      help: "Con qué rapidez gira además el cuerpo en torno a la vertical.",
    },
    yaw: {
      label: "Se inclina hacia",
      help: "La dirección de la inclinación sobre la mesa. Todo el movimiento gira con ella.",
    },
    law: {
      label: "Mesa",
      help: "“Sin fricción” y “Sin deslizar” son las dos leyes ideales del artículo.",
      choices: {
        frictionless: "Sin fricción",
        coulomb: "Fricción seca",
        no_slip: "Sin deslizar",
      },
    },
    friction: {
      label: "Fricción",
      help: "Coeficiente de fricción μ: fuerza de fricción máxima dividida entre la fuerza normal.",
    },
    rolling: {
      label: "Resistencia a la rodadura",
      help: "Fuerza de resistencia dividida entre la fuerza normal: unos 0,0001 para un borde duro sobre una mesa dura. Frena el movimiento.",
    },
    restitution: {
      label: "Rebote",
      help: "Coeficiente de restitución cuando el borde cae en la mesa tras un vuelo.",
    },
    gravity: { label: "Gravedad", help: "9,81 en la Tierra, 1,62 en la Luna." },
    duration: { label: "Duración", help: "El tiempo durante el que se calcula el movimiento." },
    floor: {
      label: "Suelo",
      help: "Indica si el suelo se mueve. La mesa se mueve con él, sin girar.",
      choices: { rest: "En reposo", pulse: "Un pulso", hand: "A mano" },
    },
    start: {
      label: "Inicio",
      help: "Indica si el cuerpo empieza inclinado o apoyado de plano sobre su base.",
      choices: { tilted: "Inclinado", standing: "Apoyado" },
    },
    pulse: {
      label: "Forma",
      help: "La aceleración del suelo a lo largo del tiempo.",
      choices: {
        sine: "Seno",
        cosine: "Coseno",
        half_sine: "Semiseno",
        ricker: "Ondícula de Ricker",
        rectangular: "Rectángulo",
      },
    },
    shake: {
      label: "Amplitud",
      help: "Aceleración horizontal máxima. 9,81 es la gravedad en la Tierra, 1 g.",
    },
    vertical: {
      label: "Vertical",
      help: "Aceleración vertical máxima; si es positiva, va primero hacia arriba.",
    },
    period: {
      label: "Período",
      help: "Duración de una oscilación; en un semiseno y un rectángulo, el tiempo hasta su final.",
    },
    cycles: { label: "Ciclos", help: "Número de oscilaciones de un seno o un coseno." },
    direction: {
      label: "Dirección",
      help: "La dirección de la aceleración horizontal, medida como “Se inclina hacia”.",
    },
    flat: {
      label: "Caída de plano",
      help: "Qué pasa cuando toda la base llega a la vez. La mecánica del sólido rígido no lo determina.",
      choices: {
        stop: "El movimiento acaba",
        smooth_left: "Corre por la izquierda",
        smooth_right: "Corre por la derecha",
        housner: "Impacto de Housner",
      },
    },
    record: { label: "Registro" },
    falls: { label: "Caídas" },
    flicks: { label: "Impulsos", help: "Cuántas veces se repite el intento. En el artículo: 42." },
    unsteadiness: {
      label: "Temblor de la mano",
      help: "Con 100, un impulso se desvía del centro unos 3°.",
    },
    seed: {
      label: "Semilla",
      help: "Semilla de los números aleatorios. La misma semilla da la misma dispersión.",
    },
  },

  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label}: no existe “${text}”; elige ${[names.slice(0, -1).join(", "), ...names.slice(-1)].join(" o ")}.`,
    noRecord: (label: string) => `${label}: esto no es un registro de la página.`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label}: “${text}” se puede leer de dos maneras; escribe ${sign === "." ? "un punto" : "una coma"} antes de los decimales y nada entre los millares.`,
    empty: (label: string) => `${label}: falta un número.`,
    noNumber: (label: string, text: string) => `${label}: debe ser un número, no “${text}”.`,
    notWhole: (label: string, text: string) => `${label}: debe ser un número entero, no ${text}.`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label}: debe ser mayor que ${low} y menor que ${high}; ${text} está fuera.`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label}: debe estar entre ${low} y ${high}; ${text} está fuera.`,
  },

  playback: {
    speed: "Ritmo",
    realTime: "tiempo real",
    slow: "Lento en la colisión",
    on: "sí",
    off: "no",
    view: "Vista",
    step: "Paso",
  },

  controls: {
    title: "Montaje",
    standsFlat: "El cuerpo está apoyado de plano, en reposo.",
    undo: "Deshacer",
    reset: "Restablecer",
    more: "Más",
    hint: "Señala un ajuste para ver qué significa.",
    dryOnly: "Solo vale para la fricción seca.",
    tables: { ice: "hielo", wood: "madera", rubber: "goma" },
    losses: { none: "nula", hard: "mesa dura", soft: "mesa blanda" },
    lossesOf: (table: string, resistance: string) =>
      `Resistencia a la rodadura: ${table}, ${resistance}`,
    frictionOf: (table: string, friction: string) => `Fricción de ${table}, ${friction}`,
    neededLabel: (friction: string) =>
      `${friction}, la fricción que este cuerpo necesita para rodar durante su casi colisión`,
    neededHelp: (friction: string) =>
      `Con ${friction} o más este cuerpo rueda durante su casi colisión. Con menos, se desliza.`,
    floor: (state: string) => `El suelo: ${state.charAt(0).toLowerCase()}${state.slice(1)}`,
    notLoaded: "No se pudieron cargar estos controles. Vuelve a cargar la página.",
  },

  floor: {
    isLoading: "se está cargando la parte de la página que mueve el suelo",
    isMissing:
      "no se pudo cargar la parte de la página que mueve el suelo; vuelve a cargar la página",
    push: "Empujar",
    pushHelp: "Empuja el suelo lejos de ti durante un quinto de segundo e inicia el movimiento.",
    shake: "Sacudir",
    shakeHelp: "Inicia el movimiento del suelo y del cuerpo.",
    note: "Los impulsos y la teoría son los de un suelo en reposo. Las posiciones en las gráficas son relativas a la mesa.",
    onceOnly: "Solo vale para un seno y un coseno.",
    pad: "Mover la mesa",
    padHelp:
      "Arrastra aquí para mover la mesa, un milímetro por píxel. Cuando sueltes, el cuerpo se sacudirá con ese mismo movimiento. Las teclas de flecha también la mueven.",
    balanceTilt: "Ángulo de vuelco",
    beyondBalance: "más allá, un cuerpo en reposo vuelca",
    largestTilt: "Mayor inclinación",
    ofBalance: (ratio: string) => `${ratio} × el ángulo de vuelco`,
    uplift: "Levantamiento",
    neverRocks: "nunca empieza a balancearse",
    whenRocks: "cuando empieza a balancearse",
    leansAtStart: "el cuerpo está inclinado al principio",
    itsLargestTilt: (tilt: string) => `Su mayor inclinación es ${tilt}.`,
    overturns: (body: BodyName, after: string) => `${Noun(body)} vuelca a los ${after}.`,
    overturnsInAir: (body: BodyName, after: string) =>
      `${Noun(body)} vuelca: su borde deja el suelo a los ${after}.`,
    undecided: (after: string) =>
      `Cuando acaba el cálculo, a los ${after}, supera su ángulo de vuelco: no está decidido si vuelca.`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `No vuelca. ${
        {
          standing: "Está apoyado de plano",
          sliding_flat: "Todavía se desliza sobre su base",
          flying_level: "Está en el aire",
          moving: "Todavía se mueve",
        }[state]
      } a los ${after}, cuando acaba el cálculo.`,
    stops: (after: string) =>
      `La base llega de plano a los ${after} y el movimiento acaba, como indica “Caída de plano”. La mecánica del sólido rígido no determina qué sigue.`,
    isStill: "El suelo no se mueve.",
    moves: (far: string, strong: string) =>
      `El suelo se mueve hasta ${far}, con una aceleración de hasta ${strong}.`,
    beginsToRock: (body: BodyName, at: string) =>
      `${Noun(body)} empieza a balancearse a los ${at} (levantamiento).`,
    rocksAgain: (body: BodyName, at: string) =>
      `${Noun(body)} empieza ${leaning(body)}, queda un rato de plano y vuelve a balancearse a los ${at}.`,
    leans: (body: BodyName) => `${Noun(body)} empieza ${leaning(body)}.`,
    slides: (body: BodyName) =>
      `${Noun(body)} se desliza sobre su base y nunca empieza a balancearse.`,
    stands: (body: BodyName) =>
      `${Noun(body)} está en reposo sobre el suelo y nunca empieza a balancearse.`,
  },

  verdict: {
    turned: "El contacto recorrió",
    angleOfTurn: "Ángulo recorrido",
    itself: (body: BodyName) => begins(theBodyItself(body)),
    meanwhile: "giró entretanto",
    whenLetGo: "se verá al soltar",
    ifLetGo: "si sueltas ahora",
    theory: "En teoría",
    smallestTilt: "Menor inclinación",
    gap: (gap: string) => `una separación de ${gap}`,
    contactThen: "Contacto en ese instante",
    perSecond: "vueltas por segundo",
    perSecondAt: (speed: string) => `vueltas por segundo, a ${speed}`,
    inHand: "En tu mano",
    leansToward: (way: string) => `se inclina hacia ${way}`,
    leansInHand: (tilt: string, way: string) => `En tu mano se inclina ${tilt} hacia ${way}.`,
    toFlick: "Para impulsarlo, suelta mientras tu mano se mueve.",
    wouldBe: {
      floorMoves: "Si sueltas ahora en reposo, el suelo empezará a moverse.",
      nothing: "Si sueltas ahora en reposo, no habrá movimiento.",
      rocked: (angle: string, after: string) =>
        `Si sueltas ahora en reposo, su punto de contacto recorrerá ${angle} mientras baja y sube hasta la siguiente inclinación máxima, a los ${after}.`,
      hovered: (after: string) =>
        `Si sueltas ahora en reposo, no habrá bajado y subido de nuevo a los ${after}, cuando acaba el cálculo.`,
      toppled: (angle: string, after: string) =>
        `Si sueltas ahora en reposo, su punto de contacto recorrerá ${angle} y volcará a los ${after}.`,
      fell_back: (after: string) =>
        `Si sueltas ahora en reposo, volcará hacia el lado al que se inclina, a los ${after}.`,
      face_down: (after: string) => `Si sueltas ahora en reposo, caerá de plano a los ${after}.`,
      at_rest: (after: string) =>
        `Si sueltas ahora en reposo, quedará en reposo sobre su base a los ${after}.`,
      lifted_off: (after: string) =>
        `Si sueltas ahora en reposo, su borde dejará la mesa a los ${after}, donde acaban las leyes ideales.`,
      painleve: (after: string) =>
        `Si sueltas ahora en reposo, llegará a la paradoja de Painlevé a los ${after}, donde la mecánica del sólido rígido no tiene respuesta única.`,
      failed: "Si sueltas ahora en reposo, el cálculo fallará.",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "el inicio" : `la inclinación máxima a los ${start}`;
      const to = {
        maximum: "la siguiente inclinación máxima",
        fall: "su caída",
        end: "el final",
      }[endsWith];
      const turn = {
        none: itself,
        same: `${itself} en el mismo sentido`,
        other: `${itself} en sentido contrario`,
      };
      return `Desde ${from}, bajando y subiendo hasta ${to} a los ${end}, el punto de contacto recorre ${angle}, la mayor parte en ${time}; ${theBodyItself(body)} gira ${turn[way]}.`;
    },
    rim: {
      rolled: "La fricción basta: rueda todo el tiempo.",
      slipped: "El borde se desliza en el camino.",
      jumped: "El borde salta de la mesa en el camino.",
    },
    fullTurn: (rest: string) => `Eso es una vuelta completa y ${rest}.`,
    veers: (angle: string, side: "left" | "right") =>
      `Queda ${angle} ${SIDES[side]} de justo enfrente.`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `de ${angle} ${{ turn: "en este recorrido", fall: "cuando cae", end: "al final" }[until]}`,
    comesDownFlat: "cae de plano",
    incomplete: "el siguiente recorrido no está completo",
    staysUp: "no baja",
    limitHere: "el límite en esta mesa",
    asComputed: "igual que el calculado aquí",
    below: (angle: string) => `${angle} menos que el ángulo calculado`,
    above: (angle: string) => `${angle} más que el ángulo calculado`,
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text}; vale para un cuerpo que ${[...(flat ? ["cae de plano"] : []), ...(untwisted ? ["se suelta sin giro"] : [])].join(" y ")}`,
    noMotion: (why: string) => `No hay movimiento que mostrar: ${why}.`,
    stillComputing: (after: string) => `Todavía se está calculando el movimiento tras ${after}.`,
    stillMoves: (after: string) => `Todavía se mueve a los ${after}, cuando acaba el cálculo.`,
    fallsOver: (after: string) => `Vuelca a los ${after}.`,
    fallsBack: (after: string) => `Vuelca a los ${after}, hacia el lado de su inclinación inicial.`,
    liftsOff: (after: string | undefined) =>
      `${after === undefined ? "De inmediato" : `A los ${after}`} el borde dejaría la mesa. Las leyes ideales no abarcan el vuelo, así que el movimiento acaba aquí. Elige la fricción seca para seguirlo.`,
    comesToRest: (after: string) =>
      `Queda en reposo a los ${after}: su base está apoyada de plano y su energía se ha agotado.`,
    painleve: (after: string, friction: string) =>
      `Paradoja de Painlevé a los ${after}: con tanta fricción, la mecánica del sólido rígido no tiene respuesta única para el borde que se desliza. Para este cuerpo casi de plano, la paradoja empieza con una fricción de ${friction}. Pon menos fricción para seguir el movimiento.`,
    tooManySteps: (after: string) =>
      `El cálculo se detiene a los ${after}, porque necesita demasiados pasos. Pon una duración menor.`,
    cannotContinue: (after: string, why: string) =>
      `El cálculo no puede continuar tras ${after}: ${why}.`,
    faceDownStraight: (after: string, least: string) =>
      `De plano a los ${after}: sin movimiento lateral todo el borde llega a la mesa a la vez. La mecánica del sólido rígido no determina qué sigue. Con cualquier error lateral, por pequeño que sea, el punto de contacto da la vuelta; se puede calcular un error de ${least} o más.`,
    faceDownResisted: (after: string) =>
      `De plano a los ${after}: la resistencia a la rodadura detiene el punto de contacto y la base golpea la mesa de plano. La mecánica del sólido rígido no determina qué sigue cuando todos los puntos del borde chocan a la vez. Con menos resistencia o un error lateral mayor el punto de contacto da la vuelta.`,
    faceDownShort: (after: string) =>
      `De plano a los ${after}: cae tan de plano que la carrera del punto de contacto por el borde es demasiado breve para calcularla. Pon un error lateral mayor.`,
    computationFailed: (why: string) =>
      `el cálculo falló (${why}); cambia el montaje o vuelve a cargar la página`,
  },

  essay: {
    guess: "Tu predicción",
    time: "Tiempo",
    closer: "¿Cómo puede ser? Mira más de cerca",
    inLab: "Abrir esto en el laboratorio",
    grasp: "Toma la lata por arriba, inclínala y suéltala. Con un dedo, sujétala antes un momento.",
    askTelephone: "Usar la inclinación del teléfono",
    holdTelephone: "Mantén pulsado, inclina el teléfono y suelta",
    theCan: "La lata, que puedes inclinar",
    theBody: "El cuerpo sobre la mesa",
    noPicture:
      "Este navegador no puede mostrar la imagen, porque WebGL está desactivado o falta. Los textos, los números y las curvas funcionan sin ella.",
    atSmallest: "en la menor inclinación",
    fromSmallest: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "antes", after: "después" }[when]} de la menor inclinación`,
    range: (label: string, from: string, to: string) => `${label} de ${from} a ${to}`,
    guessedWell: "¡Buena predicción!",
    guessedOff: (angle: string, further: boolean) =>
      `Eso es ${angle} ${further ? "más" : "menos"} que tu predicción.`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `Dijiste ${said}${straight ? ", justo enfrente" : ""}. Subió a los ${turned}.`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `El punto de contacto recorrió ${angle}, la mayor parte en ${time}. ${begins(theBodyItself(body))} giró ${itself}. La separación bajo su borde se redujo a ${gap}, pero siempre tocaba la mesa algún punto del borde.`,
    straight: (angle: string) => `${angle}, justo enfrente`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}, ${aside} ${beyond ? "más allá" : "antes"} de justo enfrente`,
    sideways: "Error lateral de la mano",
    friction: "Fricción de la mesa",
    height: "Altura del cilindro",
    body: "Cuerpo",
    bodies: { coin: "Moneda", ring: "Anillo", battery: "Pila", bottle: "Botella" },
    lines: {
      turn: "ángulo recorrido",
      limit: "límite",
      here: "límite en esta mesa",
      noSlip: "sin deslizar",
      frictionless: "sin fricción",
      noSlipLimit: "límite sin deslizar",
    },
    hand: (angle: string, gap: string, time: string) =>
      `El punto de contacto recorrió ${angle}. La separación bajo el borde se redujo a ${gap}, y la mayor parte del ángulo duró ${time}.`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `El punto de contacto recorrió ${angle}, y el borde ${rolled ? "rodó todo el tiempo" : "se deslizó en el camino"}. Cuanto más de plano cae una lata, más se acerca su ángulo a ${limit} en esta mesa.`,
    cylinder: (angle: string, limit: string) =>
      `El punto de contacto recorrió ${angle}. El límite para este cilindro es ${limit}.`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `El punto de contacto recorrió ${angle}. Los límites son ${noSlip} sin deslizar y ${frictionless} sin fricción.`,
  },

  story: {
    where: (step: number, of: number) => `La historia, paso ${step} de ${of}`,
    back: "‹ Atrás",
    backLabel: "Atrás: paso anterior",
    show: "Mostrar",
    next: "Seguir ›",
    nextLabel: "Seguir: paso siguiente",
    steps: {
      looks: {
        title: "Parece un balanceo",
        text: "Inclina una lata y suéltala. Parece golpear la mesa de plano y levantarse por el otro lado. La película se detiene en lo alto de esta subida: la lata no ha subido enfrente, sino 23° a un lado.",
      },
      slower: {
        title: "Ahora más despacio",
        text: "Suéltala desde una inclinación pequeña y mírala cincuenta veces más despacio. La base nunca golpea la mesa. Queda casi de plano, pero solo toca un punto de su borde.",
      },
      rolls: {
        title: "Está rodando",
        text: "Ahora de cerca: el tiempo se estira mientras el punto de contacto corre por el borde. Los postes muestran la separación bajo el borde, dibujada unos miles de veces más alta. El punto de contacto recorre más de media vuelta en menos de una diezmilésima de segundo, pero las marcas del borde se quedan donde están: la propia lata no gira. Rueda sobre su borde.",
      },
      same: {
        title: "El ángulo es siempre el mismo",
        text: "Suéltala una y otra vez. El azar decide entre izquierda y derecha, pero no cuánto recorre el punto de contacto: siempre cerca de 202°, y tanto más cerca cuanto más de plano cae la lata. El límite solo depende de la lata:",
        symbols:
          "m es su masa, R el radio de su base, H la altura de su centro de masas y A su momento de inercia respecto a un eje transversal por ese centro.",
      },
      friction: {
        title: "Fricción",
        text: "Sobre una mesa sin fricción la lata se desliza en vez de rodar y el ángulo es de 221°. Una mesa real está entre ambos casos. Los autores del artículo impulsaron una lata 42 veces y midieron medias de 213° a la izquierda y 218° a la derecha. Prueba una fricción cerca de 0,1 y cambia la mesa para ver cómo se mueven los dos picos.",
      },
      yourTurn: {
        title: "Te toca",
        text: "Toma el cuerpo por arriba e inclínalo. Suéltalo, o impúlsalo soltándolo mientras tu mano se mueve. Cambia el cuerpo y la mesa, llena la botella, haz girar una moneda. Para guardar un movimiento o mostrarlo, usa “Compartir”, más abajo.",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `Ángulos recorridos de las caídas, de ${from} a ${to} en barras de ${width}.`,
    caption: (width: string) =>
      `Ángulos recorridos de las caídas: izquierda arriba, derecha abajo, ${width} por barra.`,
    measured: "Líneas con un punto: media y dispersión de las caídas del artículo.",
    left: (count: number) => `izquierda: ${count}`,
    right: (count: number) => `derecha: ${count}`,
  },

  flicks: {
    title: "Cuarenta y dos impulsos",
    hint: "Ninguna mano repite un movimiento con exactitud. Repite este inicio con algo de dispersión y mira hacia dónde cae el cuerpo.",
    clear: "Borrar",
    hand: "La mano",
    picture: "Direcciones en que cayó el cuerpo, vistas desde arriba",
    left: "a la izquierda de la mano",
    right: "a la derecha",
    noSlip: "límite sin deslizar",
    frictionless: "límite sin fricción",
    here: "límite en esta mesa",
    measured: (left: string, right: string) => `el artículo: ${left} y ${right}`,
    twisted: "Los límites valen para un cuerpo que se suelta sin giro.",
    initialLean: "inclinación inicial",
    own: {
      title: "Tus propias caídas",
      help: "¿Hacia dónde cayó tu lata? Escribe las direcciones en grados, en sentido antihorario desde la inclinación inicial; las caídas a tu izquierda están por encima de 180. Para reunir varios grupos, pega sus enlaces.",
      add: "Añadir",
      clear: "Quitar todas",
      refused: "Escribe números de 0 a 360 separados por espacios, o pega enlaces con caídas.",
    },
    fit: {
      ask: "¿Qué fricción encaja?",
      running: "Probando fricciones…",
      answer: (friction: string, low: string, high: string) =>
        `Una fricción de ${friction} es la que mejor encaja; de ${low} a ${high} encajan casi igual, si la mano es como la de aquí.`,
      none: "Ninguna de las fricciones hace caer el cuerpo hacia estos lados.",
    },
    running: "Impulsando…",
    none: "Este montaje no se puede impulsar.",
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const each = sides.map(({ side, count, angle }) => {
        const many = fell ? "cayeron" : "subieron";
        const one = fell ? "cayó" : "subió";
        if (count === 0) return `ninguno ${one} ${SIDES[side]}`;
        return `${count} ${count === 1 ? one : many} ${SIDES[side]} tras ${angle}`;
      });
      const rest =
        others > 0 ? `; ${others} ${others === 1 ? "acabó" : "acabaron"} de otro modo` : "";
      return `De ${made} ${made === 1 ? "impulso" : "impulsos"}, ${each.join(", ")}${rest}.`;
    },
  },

  limits: {
    title: "Lo que este modelo omite",
    unevenness: "Irregularidad de borde y mesa",
    unevennesses: {
      ground: "0,02 mm, rectificada",
      fine: "0,1 mm, fina",
      medium: "0,2 mm, media",
      coarse: "0,4 mm, basta",
      dented: "1 mm, abollada",
    },
    touches: (time: string, angle: string, whole: string) =>
      `Con esta irregularidad se tocan en varios puntos durante ${time}. Entretanto el punto de contacto recorre ${angle} de los ${whole}; esta parte depende de la forma de ambos.`,
    touchesOnce:
      "La separación siempre es mayor que esta irregularidad, así que borde y mesa se tocan en un solo punto todo el tiempo.",
    intro:
      "Aquí el cuerpo y la mesa son perfectamente rígidos y lisos, el borde es un círculo perfecto y no hay aire. En el recorrido que se muestra:",
    none: "Este cuerpo no baja, así que no hay nada que comparar.",
    trust:
      "Donde un número supera lo posible para un cuerpo real, no te fíes de la separación ni de la velocidad. Fíate del ángulo, que apenas depende de lo pequeña que llegue a ser la separación. Una mano comete un error lateral de unos 0,02 rad/s.",
    gap: "Menor separación bajo el borde",
    gapTiny:
      "Menor que la irregularidad de cualquier borde y mesa, de 0,1 a 0,4 mm: se tocan en varios puntos.",
    gapSmall:
      "No mayor que la irregularidad de borde y mesa, de 0,1 a 0,4 mm: pueden tocarse en varios puntos.",
    gapWide: "Mayor que la irregularidad de borde y mesa, de 0,1 a 0,4 mm.",
    speed: "Punto de contacto por el borde",
    speedBeyond:
      "Más rápido que el sonido en acero, aluminio o vidrio, de 5 a 6 km/s: borde y mesa no pueden apartarse a tiempo.",
    speedNear: "No mucho más lento que el sonido en acero, aluminio o vidrio, de 5 a 6 km/s.",
    speedBelow: "Más lento que el sonido en acero, aluminio o vidrio, de 5 a 6 km/s.",
    time: "Tiempo de la mayor parte del ángulo",
    bends: (sound: string) =>
      `El sonido necesita ${sound} para cruzar la base: el cuerpo se flexiona y vibra en vez de moverse como una sola pieza.`,
    isRigid: (sound: string) =>
      `El sonido necesita ${sound} para cruzar la base: el cuerpo se mueve como una sola pieza.`,
    force: "Mayor fuerza sobre la mesa",
    timesWeight: (ratio: string) => `${ratio} × el peso`,
    atOnePoint:
      "En un punto del borde. Si se abolla ahí depende del peso, del material y del canto.",
    losses: "Energía perdida en este recorrido",
    lossless:
      "Una lata real pierde energía en cada recorrido por sonido, aire y flexión, y pronto se detiene. “Resistencia a la rodadura” es una de esas pérdidas.",
    loses: "El sonido, el aire y la flexión, que se omiten, se llevan más.",
  },

  gyro: {
    title: "Un teléfono en el cuerpo",
    intro:
      "Un giroscopio que gira con el cuerpo no ve correr el punto de contacto. Perpendicularmente al eje ve rayos: el cuerpo cae a lo largo de uno y sube a lo largo del siguiente. Cada casi colisión hace girar el rayo el ángulo recorrido menos 180°.",
    save: "Guardar como CSV de phyphox",
    saved: (name: string, command: string) => `${name} guardado. Léelo con: ${command}`,
    veers: (angles: string) => `Primeros giros del rayo: ${angles}.`,
    noTurn: "No hay ningún recorrido completo, así que no gira ningún rayo.",
    picture: (largest: string) =>
      `Velocidad angular perpendicular al eje, en el sistema del cuerpo, hasta ${largest}.`,
  },

  share: {
    title: "Compartir",
    link: {
      help: "El enlace contiene todo el montaje. Ningún servidor lo ve.",
      label: "Enlace a este montaje",
      copy: "Copiar enlace",
      copied: "Enlace copiado.",
    },
    command: {
      help: "La dirección de esta página solo sirve en tu equipo. Este comando abre el mismo montaje donde rimroll esté instalado.",
      label: "Comando que abre este montaje",
      copy: "Copiar comando",
      copied: "Comando copiado.",
    },
    labTitle: "Una lata sobre una mesa",
    frame: "Ponerlo en una página o diapositiva",
    frameHelp: (isLocal: boolean) =>
      `Pega este código en el HTML de la página o la diapositiva.${isLocal ? " Copia a su lado la carpeta de esta página, con el nombre lab." : ""}`,
    copyFrame: "Copiar código",
    copiedFrame: "Código copiado.",
    python: "Código de Python",
    copyPython: "Copiar como Python",
    copiedPython: "Código de Python copiado.",
    csv: "Descargar CSV",
    saved: (name: string) => `${name} descargado, en unidades del SI y radianes.`,
    select: "Seleccionado: cópialo con Ctrl+C o ⌘C.",
    samePython: "El mismo movimiento en Python",
  },

  transport: {
    group: "Reproducción",
    shown: "Instante mostrado",
    play: "Reproducir",
    pause: "Pausa",
    rewind: "Volver al inicio",
    before: "A la colisión anterior",
    after: "A la colisión siguiente",
    back: "Fotograma anterior",
    on: "Fotograma siguiente",
    space: "Espacio",
    stretching:
      "Ralentiza el tiempo automáticamente mientras el punto de contacto corre por el borde",
    of: (time: string, end: string) => `${time} de ${end}`,
    atCollision: "en la colisión",
    fromCollision: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "antes", after: "después" }[when]} de la colisión`,
    inRealTime: "en tiempo real",
    slower: (times: string) => `${times} veces más lento que el tiempo real`,
    keys: "Teclas",
    keyPlay: "reproducir, pausar",
    keyBack: "fotograma anterior",
    keyOn: "fotograma siguiente",
    keyHome: "volver al inicio",
    keysOn: "Estas teclas funcionan en toda la página",
  },

  sound: {
    name: "Sonido",
    turnOn: "Activar el sonido del borde, ralentizado como la película",
    turnOff: "Desactivar el sonido",
    missing: "Este navegador no puede reproducir sonido",
  },

  plots: {
    absent: "No hay movimiento que representar.",
    hint: "Arrastra sobre una gráfica para ampliarla, haz clic para ir a un instante, doble clic para ver todo el movimiento. La rueda del ratón también amplía, tras un clic o con Ctrl. En una pantalla táctil un dedo va a un instante y dos dedos amplían.",
    nothing: "nada que mostrar",
    range: (low: string, high: string) => `entre ${low} y ${high}`,
    summary: (title: string, stretch: string, range: string) =>
      `${title} en función del tiempo, ${stretch}: ${range}`,
    timeLabel: (unit: string) => `tiempo, ${unit}`,
    since: (unit: string, origin: string) => `${unit} desde ${origin}`,
    collisionAt: (time: string) => `la colisión a los ${time}`,
    stretch: (from: string, to: string) => `de ${from} a ${to}`,
    about: (stretch: string, origin: string) => `${stretch} respecto a ${origin}`,
    whole: "Todo el movimiento",
    close: "Esta colisión",
    closeHelp: "Muestra la colisión más cercana al instante mostrado",
    zoom: "Zoom",
    zoomIn: "Ampliar",
    zoomOut: "Reducir",
    shown: (stretch: string) => `Mostrado: ${stretch}`,
    shaded: "Sombreado: ",
    now: (phase: string) => `En el instante mostrado: ${phase}.`,
    plot: "Gráfica",
    phases: {
      standing: "apoyado",
      rolling: "rueda",
      sliding: "desliza",
      sliding_flat: "desliza de plano",
      flying: "vuela",
      flying_level: "vuela horizontal",
      lying: "tumbado",
    },
    figures: {
      floor: {
        title: "Suelo, aceleración",
        short: "Suelo",
        x: "según x",
        y: "según y",
        z: "hacia arriba",
      },
      tilt: { title: "Inclinación", short: "Inclin.", tilt: "inclinación" },
      yaw: {
        title: "Dirección",
        short: "Dirección",
        yaw: "dirección de la inclinación",
        theory: "teoría, primer recorrido",
      },
      rates: {
        title: "Velocidades",
        short: "Veloc.",
        tilt: "inclinación",
        yaw: "dirección",
        spin: "rotación propia",
      },
      gyroscope: {
        title: "Giroscopio en el cuerpo",
        short: "Girosc.",
        x: "x",
        y: "y",
        z: "z, el eje",
      },
      friction: {
        title: "Cociente de fricción",
        short: "Fricción",
        available: "disponible μ",
        used: "usada |T|/N",
        needed: "necesaria para rodar μ*",
      },
      energy: {
        title: "Energía",
        short: "Energía",
        potential: "potencial",
        kinetic: "cinética",
        sliding: "perdida al deslizar",
        rolling: "perdida al rodar",
        impacts: "perdida en impactos",
      },
    },
  },

  compare: {
    title: "Comparar con…",
    help: "Muestra un segundo movimiento junto al primero, al mismo tiempo.",
    presets: {
      ice: "Hielo y goma",
      coin: "Lata y moneda",
      mirror: "Este inicio y su reflejo",
      keep: "Guardar este movimiento y cambiar el montaje",
    },
    keyA: "A, líneas continuas: el montaje de arriba",
    keyB: "B, líneas discontinuas: el otro",
    setup: "Montaje",
    turn: "Primer recorrido",
    difference: "B frente a A",
    rows: {
      turn: "El contacto recorrió",
      itself: "El propio cuerpo giró",
      limit: "Límite teórico",
      tilt: "Menor inclinación",
      gap: "Separación bajo el borde entonces",
      time: "Tiempo hasta entonces",
      passage: "Tiempo de la mayor parte del ángulo",
      force: "Mayor fuerza, en pesos",
      energy: "Energía conservada",
      end: "Final de todo el movimiento",
    },
    ending: "Cómo acaba",
    endings: {
      finished: "sigue moviéndose",
      toppled: "vuelca",
      lifted_off: "despega",
      face_down: "de plano",
      at_rest: "en reposo",
      painleve: "sin respuesta",
      failed: "se detiene",
    },
    same: "Ambos montajes son iguales por ahora. Cambia el montaje de arriba: B queda como está.",
    refused: (which: "A" | "B", why: string) => `${which} no tiene movimiento: ${why}.`,
    none: "Uno de los cuerpos no baja, así que no hay recorrido que comparar.",
    equal: (angle: string) => `El punto de contacto recorrió ${angle} en ambos, con un decimal.`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `El punto de contacto recorrió ${a} en A y ${b} en B: ${apart} ${further ? "más" : "menos"} en B.`,
    swap: "Intercambiar A y B",
    stop: "Dejar de comparar",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which}: ${text}`,
    drawn: (body: BodyName, times: string) => `${Noun(body)}, a escala ${times} veces mayor que A`,
    plot: (label: string) => `${label}, B`,
    total: "cinética y potencial, B",
    inLink: (message: string) => `Comparado con: ${message}`,
  },
  scene: {
    picture: "El cuerpo sobre la mesa",
    tip: "Sujeta el cuerpo un momento y luego inclínalo.",
    reset: "Vista inicial",
    places: { above: "Arriba", contact: "Contacto", below: "Abajo" },
    help: "Cómo usar esta imagen",
    gestures:
      "Arrastra el cuerpo para inclinarlo; con un dedo, sujétalo antes un momento. Suelta para dejarlo caer, o suelta en movimiento para impulsarlo. Arrastra la mesa para mirar desde otro lado. Para ampliar, separa dos dedos o gira la rueda del ratón tras un clic en la imagen o con Ctrl.",
    keysTitle: "Teclas mientras la imagen tiene el foco:",
    keys: [
      ["← → ↑ ↓", "mirar desde otro lado, también desde abajo"],
      ["Re Pág, Av Pág", "ampliar, reducir"],
      ["Inicio", "restablecer la vista"],
      ["+ y −", "tomar el cuerpo e inclinarlo 1°"],
      ["Mayús + ← →", "girar su inclinación 5° mientras lo sujetas"],
      ["Intro", "soltarlo en reposo"],
      ["Mayús + Intro", "impulsarlo con las velocidades puestas"],
      ["Esc", "devolverlo a su sitio"],
    ],
    rolls: "rueda",
    slips: "desliza",
    flies: "en el aire",
    square: (length: string) => `1 cuadro = ${length}`,
    notLoaded: "No se pudo cargar la imagen. Vuelve a cargar la página para verla.",
    noWebGL: "Este navegador no puede mostrar la imagen, porque WebGL está desactivado o falta.",
    rest: "El resto de la página funciona: el movimiento, los ángulos y las gráficas.",
    stopped:
      "Los gráficos de este navegador se han detenido. La imagen volverá cuando se reanuden.",
    ranRound: (angle: string) => `el contacto recorrió ${angle}`,
    itself: (body: BodyName, angle: string) => `${theBodyItself(body)} giró ${angle}`,
    guess: (angle: string) => `tu predicción ${angle}`,
    noSlip: "sin deslizar",
    frictionless: "sin fricción",
    theory: "teoría",
    gap: (gap: string) => `separación ${gap}`,
    gapDrawn: (gap: string, times: string) => `separación ${gap}, dibujada ${times} veces más alta`,
    unrolled: "Camino del contacto, desenrollado: ",
    table: "mesa",
    rim: "borde",
    noSlipYet: "rueda sin deslizar",
    slipped: (length: string) => `su borde se ha deslizado ${length}`,
    runs: (rim: string, table: string, slip: string) =>
      `En este recorrido el punto de contacto ha recorrido ${rim} por el borde y ${table} por la mesa: ${slip}.`,
  },

  prose: {
    title: "rimroll: inclina la lata",
    skip: "Saltar al montaje",
    tagline: "Una lata inclinada parece balancearse, pero su punto de contacto corre por el borde.",
    "part.nav": "Partes de esta página",
    "part.controls": "Montaje",
    "part.compare": "Comparar",
    "part.flicks": "Impulsos",
    "part.plots": "Gráficas",
    "part.share": "Compartir",
    "part.limits": "Límites",
    "part.gyro": "Giroscopio",
    "to-lab": "El laboratorio",
    "to-essay": "¿Qué es esto?",
    "question.title": "¿Dónde subirá?",
    "question.text":
      "Inclina una lata y suéltala. Cae hacia la vertical, su base casi llega a la mesa y vuelve a subir. Gira la línea hacia donde creas que subirá y suelta la lata.",
    "slap-or-roll.title": "¿Golpea o rueda?",
    "slap-or-roll.text":
      "No sube justo enfrente, como haría una mecedora. Sube {0} a un lado. A simple vista, parece que la base golpea la mesa y la lata rebota. No es eso lo que ocurre.",
    "slap-or-roll.slow":
      "Aquí el tiempo se frena cuando la lata está casi de plano, y los postes muestran la separación bajo el borde, dibujada más alta de lo que es. Un punto del borde toca la mesa, y ese punto recorre el borde: la mayor parte del camino en {0}. Fíjate en las marcas del borde. Se quedan donde están. La lata no gira; rueda sobre su borde.",
    "hand.title": "Por qué la mano no importa",
    "hand.text":
      "Ninguna mano suelta a la perfección. Un pequeño error lateral decide si la lata gira a la izquierda o a la derecha, y cuánto se acerca su base a la mesa. Mueve el control: la separación y el tiempo cambian en un factor de cien. El ángulo apenas cambia.",
    "hand.limit":
      "Cuanto más firme es la mano, más se acerca el ángulo a un límite, {0} para esta lata. El límite solo depende de la lata:",
    "hand.symbols":
      "Aquí {0} es su masa, {1} el radio de su base, {2} la altura de su centro de masas y {3} su momento de inercia respecto a un eje transversal por ese centro.",
    "friction.title": "Del hielo a la goma",
    "friction.text":
      "Para rodar tan deprisa, el borde debe agarrarse a la mesa. Con una fricción de {0} o más, esta lata rueda todo el tiempo. Con menos, su borde se desliza y la lata sube en otro lugar. Sin fricción alguna, el límite es {1}.",
    "friction.try":
      "Mueve el control del hielo a la goma. Donde el camino sobre la mesa es naranja, el borde se desliza.",
    "tall-and-flat.title": "Alto y plano",
    "tall-and-flat.text":
      "Un cuerpo alto se balancea casi hasta justo enfrente. Cuanto más plano es, más recorre el punto de contacto. Cambia la altura de este cilindro macizo y mira dónde sube.",
    "disks-and-coins.title": "Discos y monedas",
    "disks-and-coins.text":
      "En un disco homogéneo sin grosor, el centro de masas está en la base, y la fórmula de arriba da {0} o {1}: una vuelta completa y {2} más. La fricción no influye entonces. Una moneda se acerca a eso. Compara otros cuerpos.",
    "experiment.title": "Cuarenta y dos impulsos",
    "experiment.text":
      "Los autores del artículo impulsaron una lata 42 veces y anotaron hacia dónde caía. Los ángulos medios fueron {0} a la izquierda y {1} a la derecha, entre los límites sin deslizar y sin fricción.",
    "experiment.try":
      "Impulsa aquí la lata con una mano temblorosa y cambia después la fricción hasta que tus caídas coincidan con las suyas. ¿Qué fricción encaja mejor?",
    "left-out.title": "Lo que se omite",
    "left-out.text":
      "Esta lata y esta mesa son perfectamente rígidas y lisas, y no hay aire. ¿Hasta qué punto vale? Depende de cuánto se acerca la base a la mesa. La lista tiene los números de este movimiento, cada uno junto a lo que permite una lata real. Haz más firme la mano y mira cuáles dejan de tener sentido.",
    "your-turn.title": "Te toca",
    "your-turn.text":
      "Toma tú la lata. En el laboratorio puedes hacer más: cambiar el cuerpo, la mesa y el inicio, llenar la botella, hacer girar una moneda, sacudir el suelo, ver cada fuerza y energía, y guardar o enviar lo que encuentres.",
    "your-turn.lab": "Abrir el laboratorio",
    "section.scene": "La mesa",
    "section.transport": "Tiempo",
    "section.verdict": "Qué ocurre",
    "section.story": "La historia",
    "section.controls": "Montaje",
    "section.compare": "Comparación",
    "section.plots": "Gráficas",
    "section.flicks": "Cuarenta y dos impulsos",
    "section.share": "Compartir",
    "section.limits": "Lo que este modelo omite",
    "section.gyro": "Un teléfono en el cuerpo",
    "foot.paper":
      "La mecánica sigue a M. Srinivasan y A. Ruina, “Rocking and rolling: a can that appears to rock might actually roll”, {0}.",
    "foot.private":
      "Cada movimiento se calcula en tu propio dispositivo. No se envía nada a ningún sitio.",
    "foot.parts": "{0} de esta página y sus partes.",
    "foot.licences": "Licencias",
    "foot.languages": "Idiomas",
  },
};
