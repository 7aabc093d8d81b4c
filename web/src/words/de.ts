// German. See en.ts for what each word is for.

import type { BodyName } from "../setup/fields";
import type { SideCount, Turned } from "./en";
import type { Table } from "./words";

/** The bodies with their articles, in the nominative. */
const NOUNS: Record<BodyName, string> = {
  can_2007: "die Dose",
  soda_can: "die Dose",
  beer_bottle: "die Flasche",
  coin: "die Münze",
  ring: "der Ring",
  battery: "die Batterie",
  euler_disk: "die Scheibe",
  own: "der Körper",
  inertia: "der Körper",
};

const begins = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
const Noun = (body: BodyName) => begins(NOUNS[body]);
const its = (body: BodyName) => (NOUNS[body].startsWith("die") ? "ihrem" : "seinem");

const SIDES = { left: "links", right: "rechts" } as const;

export const de: Table = {
  between: " ",

  loading: "Wird geladen …",
  letGo: "Loslassen",
  flickTimes: (count: number) => (count === 1 ? "Einmal anstoßen" : `${count}-mal anstoßen`),
  flickAgain: (count: number) => `Noch ${count}-mal anstoßen`,
  openLab: "Das Labor öffnen",
  notStarted: (why: string) =>
    `Die Seite konnte nicht starten: ${why}. Vielleicht hilft es, sie neu zu laden.`,

  fields: {
    body: {
      label: "Körper",
      help: "Der Körper, der auf dem Tisch steht.",
      choices: {
        can_2007: "Dose der Studie",
        soda_can: "Getränkedose",
        beer_bottle: "Bierflasche",
        coin: "Münze (1 Euro)",
        ring: "Ring",
        battery: "Batterie (AA)",
        euler_disk: "Eulersche Scheibe",
        own: "Eigener",
        inertia: "Über Trägheit",
      },
    },
    fill: {
      label: "Gefüllt",
      help: "Wie voll die Dose oder Flasche ist. Das Getränk bewegt sich mit ihr wie ein fester Körper.",
    },
    radius: { label: "Radius", help: "Radius des Randes." },
    length: { label: "Höhe", help: "Vom Boden bis zur Oberkante. 0 ist eine flache Scheibe." },
    mass: { label: "Masse", help: "Gesamtmasse. Kein Umlaufwinkel hängt von ihr ab." },
    wall: {
      label: "Masse in der Wand",
      help: "Anteil der Masse über der Bodenplatte: 0 ist ein voller Zylinder, 100 ein dünnes Rohr.",
    },
    base: {
      label: "Masse im Boden",
      help: "Anteil der Gesamtmasse in einer dünnen Platte am Boden.",
    },
    height: {
      label: "Schwerpunkt",
      help: "Höhe des Schwerpunkts über dem Boden. 0 ist eine flache Scheibe.",
    },
    transverse: {
      label: "A/m",
      help: "Trägheitsmoment um eine Achse durch den Schwerpunkt quer zum Körper, geteilt durch die Masse.",
    },
    axial: {
      label: "C/m",
      help: "Trägheitsmoment um die Körperachse, geteilt durch die Masse. Kein starrer Körper hat mehr als 2 A/m.",
    },
    tilt: { label: "Neigung", help: "Wie weit der Körper geneigt ist, wenn er losgelassen wird." },
    tilt_rate: {
      label: "Neigungsrate",
      help: "Bei 0 wird der Körper in Ruhe losgelassen. Eine negative Rate stößt ihn in Richtung der Senkrechten an.",
    },
    sideways: {
      label: "Seitlicher Fehler",
      help: "Wie schnell sich der Körper außerdem um die Linie dreht, in deren Richtung er geneigt ist. Keine Hand vermeidet diesen Fehler.",
    },
    twist: {
      label: "Drehung",
      help: "Wie schnell sich der Körper außerdem um die Senkrechte dreht.",
    },
    yaw: {
      label: "Geneigt nach",
      help: "Die Richtung der Neigung auf dem Tisch. Die ganze Bewegung dreht sich mit ihr.",
    },
    law: {
      label: "Tisch",
      help: "„Reibungsfrei“ und „Ohne Rutschen“ sind die zwei idealen Gesetze der Studie.",
      choices: {
        frictionless: "Reibungsfrei",
        coulomb: "Trockene Reibung",
        no_slip: "Ohne Rutschen",
      },
    },
    friction: {
      label: "Reibung",
      help: "Reibungszahl μ: größte Reibungskraft geteilt durch die Normalkraft.",
    },
    rolling: {
      label: "Rollwiderstand",
      help: "Widerstandskraft geteilt durch die Normalkraft: etwa 0,0001 für einen harten Rand auf einem harten Tisch. Er bremst die Bewegung.",
    },
    restitution: {
      label: "Rückprall",
      help: "Stoßzahl, wenn der Rand nach einem Flug auf dem Tisch aufkommt.",
    },
    gravity: {
      label: "Gravitation",
      help: "Fallbeschleunigung: 9,81 auf der Erde, 1,62 auf dem Mond.",
    },
    duration: { label: "Dauer", help: "Die Zeit, für die die Bewegung berechnet wird." },
    floor: {
      label: "Untergrund",
      help: "Ob sich der Untergrund bewegt. Der Tisch bewegt sich mit ihm und dreht sich nicht.",
      choices: { rest: "In Ruhe", pulse: "Ein Puls", hand: "Von Hand" },
    },
    start: {
      label: "Start",
      help: "Ob der Körper anfangs geneigt ist oder flach auf seinem Boden steht.",
      choices: { tilted: "Geneigt", standing: "Flach stehend" },
    },
    pulse: {
      label: "Form",
      help: "Die Beschleunigung des Untergrunds im Lauf der Zeit.",
      choices: {
        sine: "Sinus",
        cosine: "Kosinus",
        half_sine: "Halbsinus",
        ricker: "Ricker-Wavelet",
        rectangular: "Rechteck",
      },
    },
    shake: {
      label: "Amplitude",
      help: "Größte waagerechte Beschleunigung. 9,81 ist die Fallbeschleunigung auf der Erde, 1 g.",
    },
    vertical: {
      label: "Senkrecht",
      help: "Größte senkrechte Beschleunigung; ein positiver Wert beginnt nach oben.",
    },
    period: {
      label: "Periode",
      help: "Dauer einer Schwingung; bei Halbsinus und Rechteck die Zeit bis zu ihrem Ende.",
    },
    cycles: { label: "Zyklen", help: "Anzahl der Schwingungen eines Sinus oder Kosinus." },
    direction: {
      label: "Richtung",
      help: "Die Richtung der waagerechten Beschleunigung, gemessen wie „Geneigt nach“.",
    },
    flat: {
      label: "Flache Landung",
      help: "Was folgt, wenn der ganze Boden auf einmal aufkommt. Die Mechanik starrer Körper legt das nicht fest.",
      choices: {
        stop: "Die Bewegung endet",
        smooth_left: "Läuft links herum",
        smooth_right: "Läuft rechts herum",
        housner: "Housners Stoß",
      },
    },
    record: { label: "Aufzeichnung" },
    falls: { label: "Stürze" },
    flicks: {
      label: "Versuche",
      help: "Wie oft das Loslassen wiederholt wird. In der Studie: 42-mal.",
    },
    unsteadiness: {
      label: "Unruhe der Hand",
      help: "Bei 100 verfehlt ein Versuch die Mitte um etwa 3°.",
    },
    seed: {
      label: "Startwert",
      help: "Startwert der Zufallszahlen. Derselbe Startwert gibt dieselbe Streuung.",
    },
  },

  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label}: „${text}“ gibt es nicht; zur Wahl stehen ${[names.slice(0, -1).join(", "), ...names.slice(-1)].join(" oder ")}.`,
    noRecord: (label: string) => `${label}: Das ist keine Aufzeichnung dieser Seite.`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label}: „${text}“ lässt sich auf zwei Arten lesen; schreibe ${sign === "." ? "einen Punkt" : "ein Komma"} vor die Dezimalstellen und nichts zwischen die Tausender.`,
    empty: (label: string) => `${label}: Hier fehlt eine Zahl.`,
    noNumber: (label: string, text: string) => `${label}: „${text}“ ist keine Zahl.`,
    notWhole: (label: string, text: string) =>
      `${label}: Nötig ist eine ganze Zahl, nicht ${text}.`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label}: Der Wert muss größer als ${low} und kleiner als ${high} sein; ${text} liegt außerhalb.`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label}: Möglich sind Werte von ${low} bis ${high}; ${text} liegt außerhalb.`,
  },

  playback: {
    speed: "Tempo",
    realTime: "Echtzeit",
    slow: "Langsam beim Stoß",
    on: "an",
    off: "aus",
    view: "Ansicht",
    step: "Schritt",
  },

  controls: {
    title: "Aufbau",
    standsFlat: "Der Körper steht flach und in Ruhe.",
    undo: "Rückgängig",
    reset: "Reset",
    more: "Mehr",
    hint: "Zeige auf eine Einstellung, um zu sehen, was sie bedeutet.",
    dryOnly: "Gilt nur für trockene Reibung.",
    tables: { ice: "Eis", wood: "Holz", rubber: "Gummi" },
    losses: { none: "keiner", hard: "hart", soft: "weich" },
    lossesOf: (table: string, resistance: string) => `Rollwiderstand: ${table}, ${resistance}`,
    frictionOf: (table: string, friction: string) => `Reibung von ${table}, ${friction}`,
    neededLabel: (friction: string) =>
      `${friction}, die Reibung, die dieser Körper braucht, um durch den Beinahe-Stoß zu rollen`,
    neededHelp: (friction: string) =>
      `Ab ${friction} rollt dieser Körper durch seinen Beinahe-Stoß. Mit weniger rutscht er.`,
    floor: (state: string) => `Der Untergrund: ${state.charAt(0).toLowerCase()}${state.slice(1)}`,
    notLoaded: "Diese Regler konnten nicht geladen werden. Lade die Seite neu.",
  },

  floor: {
    isLoading: "der Teil der Seite, der den Untergrund bewegt, wird geladen",
    isMissing:
      "der Teil der Seite, der den Untergrund bewegt, konnte nicht geladen werden; lade die Seite neu",
    push: "Stoßen",
    pushHelp: "Stößt den Untergrund eine Fünftelsekunde lang von dir weg und startet die Bewegung.",
    shake: "Rütteln",
    shakeHelp: "Startet die Bewegung des Untergrunds und des Körpers.",
    note: "Die Versuche und die Theorie gelten für einen ruhenden Untergrund. Orte in den Diagrammen sind relativ zum Tisch.",
    onceOnly: "Gilt nur für Sinus und Kosinus.",
    pad: "Den Tisch bewegen",
    padHelp:
      "Ziehe hier, um den Tisch zu bewegen, einen Millimeter je Pixel. Wenn du loslässt, wird der Körper so gerüttelt, wie du gezogen hast. Die Pfeiltasten bewegen den Tisch ebenfalls.",
    balanceTilt: "Kippwinkel",
    beyondBalance: "darüber hinaus fällt ein ruhender Körper um",
    largestTilt: "Größte Neigung",
    ofBalance: (ratio: string) => `${ratio} × Kippwinkel`,
    uplift: "Kippbeginn",
    neverRocks: "er beginnt nie zu schaukeln",
    whenRocks: "wenn er zu schaukeln beginnt",
    leansAtStart: "der Körper ist anfangs geneigt",
    itsLargestTilt: (tilt: string) => `Die größte Neigung ist ${tilt}.`,
    overturns: (body: BodyName, after: string) => `${Noun(body)} fällt nach ${after} um.`,
    overturnsInAir: (body: BodyName, after: string) =>
      `${Noun(body)} fällt um: Der Rand verlässt den Untergrund nach ${after}.`,
    undecided: (after: string) =>
      `Wenn die Rechnung nach ${after} endet, ist der Kippwinkel überschritten: Ob der Körper umfällt, ist nicht entschieden.`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `Der Körper fällt nicht um. ${
        {
          standing: `Er steht nach ${after} flach`,
          sliding_flat: `Er rutscht nach ${after} noch auf seinem Boden`,
          flying_level: `Er ist nach ${after} in der Luft`,
          moving: `Er bewegt sich nach ${after} noch`,
        }[state]
      }, wenn die Rechnung endet.`,
    stops: (after: string) =>
      `Der Boden kommt nach ${after} flach auf, und die Bewegung endet, wie unter „Flache Landung“ eingestellt. Die Mechanik starrer Körper legt nicht fest, was folgt.`,
    isStill: "Der Untergrund bewegt sich nicht.",
    moves: (far: string, strong: string) =>
      `Der Untergrund bewegt sich um bis zu ${far}, mit einer Beschleunigung bis ${strong}.`,
    beginsToRock: (body: BodyName, at: string) =>
      `${Noun(body)} beginnt bei ${at} zu schaukeln (Kippbeginn).`,
    rocksAgain: (body: BodyName, at: string) =>
      `${Noun(body)} ist anfangs geneigt, steht dann eine Weile flach und beginnt bei ${at} wieder zu schaukeln.`,
    leans: (body: BodyName) => `${Noun(body)} ist anfangs geneigt.`,
    slides: (body: BodyName) =>
      `${Noun(body)} rutscht auf ${its(body)} Boden und beginnt nie zu schaukeln.`,
    stands: (body: BodyName) =>
      `${Noun(body)} steht still auf dem Untergrund und beginnt nie zu schaukeln.`,
  },

  verdict: {
    turned: "Kontaktpunkt lief",
    angleOfTurn: "Umlaufwinkel",
    itself: (body: BodyName) => `${Noun(body)} selbst`,
    meanwhile: "drehte sich dabei",
    whenLetGo: "nach dem Loslassen zu sehen",
    ifLetGo: "wenn du jetzt loslässt",
    theory: "In der Theorie",
    smallestTilt: "Kleinste Neigung",
    gap: (gap: string) => `ein Spalt von ${gap}`,
    contactThen: "Kontaktpunkt dabei",
    perSecond: "Umläufe je Sekunde",
    perSecondAt: (speed: string) => `Umläufe je Sekunde, mit ${speed}`,
    inHand: "In deiner Hand",
    leansToward: (way: string) => `geneigt nach ${way}`,
    leansInHand: (tilt: string, way: string) =>
      `In deiner Hand ist der Körper um ${tilt} nach ${way} geneigt.`,
    toFlick: "Um Schwung zu geben, lass los, während sich deine Hand bewegt.",
    wouldBe: {
      floorMoves: "Lässt du jetzt in Ruhe los, beginnt sich der Untergrund zu bewegen.",
      nothing: "Lässt du jetzt in Ruhe los, gibt es keine Bewegung.",
      rocked: (angle: string, after: string) =>
        `Lässt du jetzt in Ruhe los, läuft der Kontaktpunkt um ${angle} herum, während der Körper fällt und bis zum nächsten Neigungsmaximum nach ${after} wieder steigt.`,
      hovered: (after: string) =>
        `Lässt du jetzt in Ruhe los, ist der Körper nach ${after}, wenn die Rechnung endet, noch nicht hinunter und wieder hinauf gelangt.`,
      toppled: (angle: string, after: string) =>
        `Lässt du jetzt in Ruhe los, läuft der Kontaktpunkt um ${angle} herum, und der Körper fällt nach ${after} um.`,
      fell_back: (after: string) =>
        `Lässt du jetzt in Ruhe los, fällt der Körper nach ${after} zu der Seite um, zu der er geneigt ist.`,
      face_down: (after: string) =>
        `Lässt du jetzt in Ruhe los, kommt der Körper nach ${after} flach auf.`,
      at_rest: (after: string) =>
        `Lässt du jetzt in Ruhe los, kommt der Körper nach ${after} auf seinem Boden zur Ruhe.`,
      lifted_off: (after: string) =>
        `Lässt du jetzt in Ruhe los, verlässt der Rand nach ${after} den Tisch; dort enden die idealen Gesetze.`,
      painleve: (after: string) =>
        `Lässt du jetzt in Ruhe los, tritt nach ${after} das Painlevé-Paradoxon auf; dort gibt die Mechanik starrer Körper keine eindeutige Antwort.`,
      failed: "Lässt du jetzt in Ruhe los, scheitert die Rechnung.",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "Vom Loslassen" : `Vom Neigungsmaximum bei ${start}`;
      const to = {
        maximum: "zum nächsten Neigungsmaximum",
        fall: "zum Sturz",
        end: "zum Ende",
      }[endsWith];
      const turn = {
        none: itself,
        same: `${itself} in dieselbe Richtung`,
        other: `${itself} in die Gegenrichtung`,
      };
      return `${from}, hinunter und hinauf bis ${to} bei ${end}, läuft der Kontaktpunkt um ${angle} herum, das meiste davon in ${time};  ${NOUNS[body]} selbst dreht sich um ${turn[way]}.`;
    },
    rim: {
      rolled: "Die Reibung reicht aus: Der Körper rollt die ganze Zeit.",
      slipped: "Der Rand rutscht unterwegs.",
      jumped: "Der Rand springt unterwegs vom Tisch.",
    },
    fullTurn: (rest: string) => `Das ist ein voller Umlauf und ${rest}.`,
    veers: (angle: string, side: "left" | "right") =>
      `Das weicht um ${angle} nach ${SIDES[side]} von genau gegenüber ab.`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `von ${angle} ${{ turn: "in diesem Umlauf", fall: "beim Sturz", end: "am Ende" }[until]}`,
    comesDownFlat: "der Körper kommt flach auf",
    incomplete: "der nächste Umlauf ist nicht vollständig",
    staysUp: "der Körper kommt nicht herunter",
    limitHere: "der Grenzwert auf diesem Tisch",
    asComputed: "wie hier berechnet",
    below: (angle: string) => `${angle} unter dem berechneten Winkel`,
    above: (angle: string) => `${angle} über dem berechneten Winkel`,
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text}; gilt für einen Körper, der ${[...(flat ? ["flach aufkommt"] : []), ...(untwisted ? ["ohne Drehung startet"] : [])].join(" und ")}`,
    noMotion: (why: string) => `Es gibt keine Bewegung zu zeigen: ${why}.`,
    stillComputing: (after: string) => `Die Bewegung nach ${after} wird noch berechnet.`,
    stillMoves: (after: string) =>
      `Der Körper bewegt sich nach ${after} noch, wenn die Rechnung endet.`,
    fallsOver: (after: string) => `Der Körper fällt nach ${after} um.`,
    fallsBack: (after: string) =>
      `Der Körper fällt nach ${after} zu der Seite um, zu der er anfangs geneigt ist.`,
    liftsOff: (after: string | undefined) =>
      `${after === undefined ? "Sofort" : `Nach ${after}`} würde der Rand den Tisch verlassen. Die idealen Gesetze gelten nicht für den Flug, deshalb endet die Bewegung hier. Wähle trockene Reibung, um sie weiterzuverfolgen.`,
    comesToRest: (after: string) =>
      `Der Körper kommt nach ${after} zur Ruhe: Sein Boden liegt flach, und die Energie ist verbraucht.`,
    painleve: (after: string, friction: string) =>
      `Painlevé-Paradoxon nach ${after}: Bei so viel Reibung gibt die Mechanik starrer Körper für den rutschenden Rand keine eindeutige Antwort. Wenn der Boden dieses Körpers fast flach liegt, beginnt das Paradoxon bei einer Reibung von ${friction}. Stelle weniger Reibung ein, um der Bewegung zu folgen.`,
    tooManySteps: (after: string) =>
      `Die Rechnung bricht nach ${after} ab, weil sie zu viele Schritte braucht. Stelle eine kürzere Dauer ein.`,
    cannotContinue: (after: string, why: string) =>
      `Die Rechnung kann nach ${after} nicht weitergehen: ${why}.`,
    faceDownStraight: (after: string, least: string) =>
      `Flach nach ${after}: Ohne seitliche Bewegung trifft der ganze Rand auf einmal auf den Tisch. Die Mechanik starrer Körper legt nicht fest, was folgt. Mit einem noch so kleinen seitlichen Fehler läuft stattdessen der Kontaktpunkt herum; ein Fehler ab ${least} lässt sich berechnen.`,
    faceDownResisted: (after: string) =>
      `Flach nach ${after}: Der Rollwiderstand hält den Kontaktpunkt an, und der Boden schlägt flach auf den Tisch. Die Mechanik starrer Körper legt nicht fest, was folgt, wenn alle Punkte des Randes auf einmal aufschlagen. Mit weniger Widerstand oder einem größeren seitlichen Fehler läuft der Kontaktpunkt herum.`,
    faceDownShort: (after: string) =>
      `Flach nach ${after}: Der Körper kommt so flach auf, dass der Lauf des Kontaktpunkts um den Rand zu kurz ist, um berechnet zu werden. Stelle einen größeren seitlichen Fehler ein.`,
    computationFailed: (why: string) =>
      `die Rechnung ist gescheitert (${why}); ändere den Aufbau oder lade die Seite neu`,
  },

  essay: {
    guess: "Deine Schätzung",
    time: "Zeit",
    closer: "Wie kann das sein? Sieh genauer hin",
    inLab: "Das im Labor öffnen",
    grasp:
      "Fasse die Dose oben an, kippe sie und lass los. Mit dem Finger halte sie zuerst einen Moment.",
    askTelephone: "Mit dem Telefon kippen",
    holdTelephone: "Hier halten, Telefon kippen, loslassen",
    theCan: "Die Dose, die du kippen kannst",
    theBody: "Der Körper auf dem Tisch",
    noPicture:
      "Dieser Browser kann das Bild nicht zeigen, weil WebGL ausgeschaltet ist oder fehlt. Texte, Zahlen und Kurven funktionieren ohne Bild.",
    atSmallest: "bei der kleinsten Neigung",
    fromSmallest: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "vor", after: "nach" }[when]} der kleinsten Neigung`,
    range: (label: string, from: string, to: string) => `${label} von ${from} bis ${to}`,
    guessedWell: "Gut geschätzt!",
    guessedOff: (angle: string, further: boolean) =>
      `Das sind ${angle} ${further ? "mehr" : "weniger"}, als du geschätzt hast.`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `Du hast ${said} geschätzt${straight ? ", genau gegenüber" : ""}. Die Dose kam bei ${turned} hoch.`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `Der Kontaktpunkt lief um ${angle} herum, das meiste davon in ${time}. ${Noun(body)} selbst drehte sich um ${itself}. Der Spalt unter ${its(body)} Rand schrumpfte auf ${gap}, aber ein Punkt des Randes berührte immer den Tisch.`,
    straight: (angle: string) => `${angle}, genau gegenüber`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}, ${aside} ${beyond ? "weiter als" : "vor"} genau gegenüber`,
    sideways: "Seitlicher Fehler der Hand",
    friction: "Reibung des Tisches",
    height: "Höhe des Zylinders",
    body: "Körper",
    bodies: { coin: "Münze", ring: "Ring", battery: "Batterie", bottle: "Flasche" },
    lines: {
      turn: "Umlaufwinkel",
      limit: "Grenzwert",
      here: "Grenzwert auf diesem Tisch",
      noSlip: "ohne Rutschen",
      frictionless: "reibungsfrei",
      noSlipLimit: "Grenzwert ohne Rutschen",
    },
    hand: (angle: string, gap: string, time: string) =>
      `Der Kontaktpunkt lief um ${angle} herum. Der Spalt unter dem Rand schrumpfte auf ${gap}, und der größte Teil des Winkels dauerte ${time}.`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `Der Kontaktpunkt lief um ${angle} herum, und der Rand ${rolled ? "rollte die ganze Zeit" : "rutschte unterwegs"}. Je flacher eine Dose aufkommt, desto näher kommt ihr Winkel auf diesem Tisch an ${limit}.`,
    cylinder: (angle: string, limit: string) =>
      `Der Kontaktpunkt lief um ${angle} herum. Der Grenzwert für diesen Zylinder ist ${limit}.`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `Der Kontaktpunkt lief um ${angle} herum. Die Grenzwerte sind ${noSlip} ohne Rutschen und ${frictionless} ohne Reibung.`,
  },

  story: {
    where: (step: number, of: number) => `Die Geschichte, Schritt ${step} von ${of}`,
    back: "‹ Zurück",
    backLabel: "Zurück zum vorigen Schritt",
    show: "Zeigen",
    next: "Weiter ›",
    nextLabel: "Weiter zum nächsten Schritt",
    steps: {
      looks: {
        title: "Es sieht aus wie Schaukeln",
        text: "Kippe eine Dose und lass sie los. Sie scheint flach auf den Tisch zu schlagen und auf der anderen Seite hochzuschaukeln. Der Film hält am höchsten Punkt an: Die Dose ist nicht gegenüber hochgekommen, sondern 23° daneben.",
      },
      slower: {
        title: "Noch einmal langsamer",
        text: "Lass sie aus einer kleinen Neigung los und sieh fünfzigmal langsamer zu. Der Boden schlägt nie auf den Tisch. Er kommt ihm sehr nahe, aber nur ein Punkt seines Randes berührt den Tisch.",
      },
      rolls: {
        title: "Sie rollt",
        text: "Jetzt aus der Nähe: Die Zeit dehnt sich, während der Kontaktpunkt um den Rand rast. Die Stäbe zeigen den Spalt unter dem Rand, einige tausendmal höher gezeichnet. Der Kontaktpunkt läuft in weniger als einer Zehntausendstelsekunde mehr als halb herum, aber die Marken am Rand bleiben, wo sie sind: Die Dose selbst dreht sich nicht. Sie rollt auf ihrem Rand.",
      },
      same: {
        title: "Der Winkel ist jedes Mal derselbe",
        text: "Lass sie wieder und wieder los. Der Zufall entscheidet zwischen links und rechts, aber nicht, wie weit der Kontaktpunkt läuft. Es sind jedes Mal etwa 202°, und je flacher die Dose aufkommt, desto genauer. Der Grenzwert hängt nur von der Dose ab:",
        symbols:
          "m ist ihre Masse, R der Radius ihres Bodens, H die Höhe ihres Schwerpunkts und A ihr Trägheitsmoment für das Kippen um diesen Punkt.",
      },
      friction: {
        title: "Reibung",
        text: "Auf einem Tisch ohne Reibung rutscht die Dose, statt zu rollen, und der Winkel ist 221°. Ein echter Tisch liegt dazwischen. Die Autoren der Studie stießen eine Dose 42-mal an und maßen Mittelwerte von 213° nach links und 218° nach rechts. Versuche eine Reibung nahe 0,1 und ändere den Tisch, um die beiden Buckel wandern zu sehen.",
      },
      yourTurn: {
        title: "Jetzt du",
        text: "Fasse den Körper oben an und neige ihn. Lass ihn los oder gib ihm Schwung, indem du loslässt, während sich deine Hand bewegt. Ändere den Körper und den Tisch, fülle die Flasche, drehe eine Münze. Um eine Bewegung zu behalten oder zu zeigen, nimm „Teilen“ weiter unten.",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `Umlaufwinkel der Stürze, von ${from} bis ${to} in Balken von ${width}.`,
    caption: (width: string) =>
      `Umlaufwinkel der Stürze: links oben, rechts unten, ${width} je Balken.`,
    measured: "Linien mit Punkt: Mittelwert und Streuung der Stürze in der Studie.",
    left: (count: number) => `links: ${count}`,
    right: (count: number) => `rechts: ${count}`,
  },

  flicks: {
    title: "Zweiundvierzig Versuche",
    hint: "Keine Hand wiederholt eine Bewegung genau. Wiederhole dieses Loslassen mit etwas Streuung und sieh, wohin der Körper fällt.",
    clear: "Löschen",
    hand: "Die Hand",
    picture: "Richtungen, in die der Körper fiel, von oben gesehen",
    left: "links von der Hand",
    right: "rechts davon",
    noSlip: "Grenzwert ohne Rutschen",
    frictionless: "Grenzwert ohne Reibung",
    here: "Grenzwert auf diesem Tisch",
    measured: (left: string, right: string) => `die Studie: ${left} und ${right}`,
    twisted: "Die Grenzwerte gelten für einen Körper, der ohne Drehung startet.",
    initialLean: "anfängliche Neigung",
    own: {
      title: "Eigene Stürze",
      help: "Wohin fiel deine Dose? Gib die Richtungen in Grad ein, gegen den Uhrzeigersinn von der anfänglichen Neigung aus; Stürze auf deiner linken Seite liegen über 180. Um mehrere Gruppen zusammenzulegen, füge ihre Links ein.",
      add: "Hinzufügen",
      clear: "Alle entfernen",
      refused:
        "Gib Zahlen von 0 bis 360 mit Leerzeichen dazwischen ein oder füge Links mit Stürzen ein.",
    },
    fit: {
      ask: "Welche Reibung passt?",
      running: "Reibungswerte werden probiert …",
      answer: (friction: string, low: string, high: string) =>
        `Eine Reibung von ${friction} passt am besten; ${low} bis ${high} passen fast ebenso gut, wenn die Hand so ruhig ist wie hier eingestellt.`,
      none: "Bei keinem Reibungswert fällt der Körper zu diesen Seiten.",
    },
    running: "Die Versuche laufen …",
    none: "Dieser Aufbau lässt sich nicht anstoßen.",
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const each = sides.map(({ side, count, angle }) => {
        const to = fell ? `fielen nach ${SIDES[side]}` : `kamen ${SIDES[side]} hoch`;
        const one = fell ? `fiel nach ${SIDES[side]}` : `kam ${SIDES[side]} hoch`;
        if (count === 0) return `keiner ${one}`;
        return `${count} ${count === 1 ? one : to}, nach ${angle}`;
      });
      const rest = others > 0 ? `; ${others} ${others === 1 ? "endete" : "endeten"} anders` : "";
      return `Von ${made} ${made === 1 ? "Versuch" : "Versuchen"}: ${each.join("; ")}${rest}.`;
    },
  },

  limits: {
    title: "Was dieses Modell weglässt",
    unevenness: "Unebenheit von Rand und Tisch",
    unevennesses: {
      ground: "0,02 mm, geschliffen",
      fine: "0,1 mm, fein",
      medium: "0,2 mm, mittel",
      coarse: "0,4 mm, grob",
      dented: "1 mm, verbeult",
    },
    touches: (time: string, angle: string, whole: string) =>
      `Bei dieser Unebenheit berühren sie sich ${time} lang an mehreren Stellen. Währenddessen läuft der Kontaktpunkt um ${angle} der ${whole} herum; dieser Teil hängt von der Form beider ab.`,
    touchesOnce:
      "Der Spalt bleibt größer als diese Unebenheit, deshalb berühren sich Rand und Tisch die ganze Zeit an einem Punkt.",
    intro:
      "Körper und Tisch sind hier vollkommen starr und glatt, der Rand ist ein perfekter Kreis, und es gibt keine Luft. In dem gezeigten Umlauf:",
    none: "Dieser Körper kommt nicht herunter, deshalb gibt es nichts zu vergleichen.",
    trust:
      "Wo eine Zahl über das hinausgeht, was ein echter Körper kann, traue weder dem Spalt noch der Geschwindigkeit. Traue dem Winkel: Er hängt kaum davon ab, wie klein der Spalt wird. Eine Hand macht einen seitlichen Fehler von etwa 0,02 rad/s.",
    gap: "Kleinster Spalt unter dem Rand",
    gapTiny:
      "Kleiner als die Unebenheit jedes Randes und Tisches, 0,1 bis 0,4 mm: Sie berühren sich an mehreren Stellen.",
    gapSmall:
      "Nicht größer als die Unebenheit von Rand und Tisch, 0,1 bis 0,4 mm: Sie berühren sich vielleicht an mehreren Stellen.",
    gapWide: "Größer als die Unebenheit von Rand und Tisch, 0,1 bis 0,4 mm.",
    speed: "Kontaktpunkt entlang des Randes",
    speedBeyond:
      "Schneller als der Schall in Stahl, Aluminium oder Glas, 5 bis 6 km/s: Rand und Tisch können ihm nicht rechtzeitig ausweichen.",
    speedNear: "Nicht viel langsamer als der Schall in Stahl, Aluminium oder Glas, 5 bis 6 km/s.",
    speedBelow: "Langsamer als der Schall in Stahl, Aluminium oder Glas, 5 bis 6 km/s.",
    time: "Zeit für den Großteil des Winkels",
    bends: (sound: string) =>
      `Der Schall braucht ${sound} quer durch den Boden: Der Körper verbiegt sich und schwingt, statt sich als Ganzes zu bewegen.`,
    isRigid: (sound: string) =>
      `Der Schall braucht ${sound} quer durch den Boden: Der Körper bewegt sich als Ganzes.`,
    force: "Größte Kraft auf den Tisch",
    timesWeight: (ratio: string) => `${ratio} × das Gewicht`,
    atOnePoint:
      "An einem Punkt des Randes. Ob er dort eine Delle bekommt, hängt von Gewicht, Material und Kante ab.",
    losses: "Energieverlust in diesem Umlauf",
    lossless:
      "Eine echte Dose verliert in jedem Umlauf Energie durch Schall, Luft und Biegung und steht bald still. „Rollwiderstand“ ist ein solcher Verlust.",
    loses: "Schall, Luft und Biegung, die hier fehlen, nehmen mehr weg.",
  },

  gyro: {
    title: "Ein Smartphone im Körper",
    intro:
      "Ein Gyroskop, das sich mit dem Körper dreht, sieht nichts davon, wie der Kontaktpunkt rast. Quer zur Achse sieht es Strahlen: Der Körper fällt entlang eines Strahls und steigt entlang des nächsten. Jeder Beinahe-Stoß dreht den Strahl um den Umlaufwinkel minus 180°.",
    save: "Als phyphox-CSV speichern",
    saved: (name: string, command: string) => `${name} gespeichert. Lies es mit: ${command}`,
    veers: (angles: string) => `Erste Drehungen des Strahls: ${angles}.`,
    noTurn: "Es gibt keinen vollständigen Umlauf, deshalb dreht sich kein Strahl.",
    picture: (largest: string) =>
      `Winkelgeschwindigkeit quer zur Achse, im Bezugssystem des Körpers, bis ${largest}.`,
  },

  share: {
    title: "Teilen",
    link: {
      help: "Der Link enthält den ganzen Aufbau. Kein Server sieht ihn.",
      label: "Link zu diesem Aufbau",
      copy: "Link kopieren",
      copied: "Link kopiert.",
    },
    command: {
      help: "Die Adresse dieser Seite funktioniert nur auf deinem Rechner. Dieser Befehl öffnet denselben Aufbau überall, wo rimroll installiert ist.",
      label: "Befehl, der diesen Aufbau öffnet",
      copy: "Befehl kopieren",
      copied: "Befehl kopiert.",
    },
    labTitle: "Eine Dose auf einem Tisch",
    frame: "Auf eine Seite oder Folie setzen",
    frameHelp: (isLocal: boolean) =>
      `Füge diesen Code in das HTML der Seite oder der Folie ein.${isLocal ? " Kopiere den Ordner dieser Seite daneben, unter dem Namen lab." : ""}`,
    copyFrame: "Code kopieren",
    copiedFrame: "Code kopiert.",
    python: "Python-Code",
    copyPython: "Als Python kopieren",
    copiedPython: "Python-Code kopiert.",
    csv: "CSV herunterladen",
    saved: (name: string) => `${name} heruntergeladen, in SI-Einheiten und Radiant.`,
    select: "Ausgewählt: Kopiere es mit Strg+C oder ⌘C.",
    samePython: "Dieselbe Bewegung in Python",
  },

  transport: {
    group: "Wiedergabe",
    shown: "Gezeigte Zeit",
    play: "Abspielen",
    pause: "Pause",
    rewind: "Zurück zum Loslassen",
    before: "Zum vorigen Stoß",
    after: "Zum nächsten Stoß",
    back: "Voriges Bild",
    on: "Nächstes Bild",
    space: "Leertaste",
    stretching: "Verlangsamt die Zeit automatisch, während der Kontaktpunkt um den Rand rast",
    of: (time: string, end: string) => `${time} von ${end}`,
    atCollision: "beim Stoß",
    fromCollision: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "vor", after: "nach" }[when]} dem Stoß`,
    inRealTime: "in Echtzeit",
    slower: (times: string) => `${times}-mal langsamer als Echtzeit`,
    keys: "Tasten",
    keyPlay: "abspielen, anhalten",
    keyBack: "voriges Bild",
    keyOn: "nächstes Bild",
    keyHome: "zurück zum Loslassen",
    keysOn: "Diese Tasten wirken überall auf der Seite",
  },

  sound: {
    name: "Ton",
    turnOn: "Den Ton des Randes einschalten, verlangsamt wie der Film",
    turnOff: "Den Ton ausschalten",
    missing: "Dieser Browser kann keinen Ton abspielen",
  },

  plots: {
    absent: "Es gibt keine Bewegung, die sich darstellen lässt.",
    hint: "Ziehe über ein Diagramm, um es zu vergrößern; klicke, um zu einer Zeit zu gehen; doppelklicke für die ganze Bewegung. Auch das Mausrad vergrößert, nach einem Klick oder mit Strg. Auf einem Touchscreen geht ein Finger zu einer Zeit, und zwei Finger vergrößern.",
    nothing: "nichts zu zeigen",
    range: (low: string, high: string) => `zwischen ${low} und ${high}`,
    summary: (title: string, stretch: string, range: string) =>
      `${title} über der Zeit ${stretch}: ${range}`,
    timeLabel: (unit: string) => `Zeit, ${unit}`,
    since: (unit: string, origin: string) => `${unit} ab ${origin}`,
    collisionAt: (time: string) => `dem Stoß bei ${time}`,
    stretch: (from: string, to: string) => `von ${from} bis ${to}`,
    about: (stretch: string, origin: string) => `${stretch}, gemessen ab ${origin}`,
    whole: "Ganze Bewegung",
    close: "Dieser Stoß",
    closeHelp: "Zeigt den Stoß, der der gezeigten Zeit am nächsten ist",
    zoom: "Zoom",
    zoomIn: "Vergrößern",
    zoomOut: "Verkleinern",
    shown: (stretch: string) => `Gezeigt: ${stretch}`,
    shaded: "Schattiert: ",
    now: (phase: string) => `Zur gezeigten Zeit: ${phase}.`,
    plot: "Diagramm",
    phases: {
      standing: "steht",
      rolling: "rollt",
      sliding: "rutscht",
      sliding_flat: "rutscht flach",
      flying: "fliegt",
      flying_level: "fliegt waagerecht",
      lying: "liegt",
    },
    figures: {
      floor: {
        title: "Untergrund, Beschleunigung",
        short: "Untergrund",
        x: "längs x",
        y: "längs y",
        z: "nach oben",
      },
      tilt: { title: "Neigung", short: "Neigung", tilt: "Neigung" },
      yaw: {
        title: "Richtung",
        short: "Richtung",
        yaw: "Richtung der Neigung",
        theory: "Theorie, erster Umlauf",
      },
      rates: {
        title: "Raten",
        short: "Raten",
        tilt: "Neigung",
        yaw: "Richtung",
        spin: "Eigendrehung",
      },
      gyroscope: {
        title: "Gyroskop im Körper",
        short: "Gyroskop",
        x: "x",
        y: "y",
        z: "z, die Achse",
      },
      friction: {
        title: "Reibungsverhältnis",
        short: "Reibung",
        available: "verfügbar μ",
        used: "genutzt |T|/N",
        needed: "zum Rollen nötig μ*",
      },
      energy: {
        title: "Energie",
        short: "Energie",
        potential: "potentiell",
        kinetic: "kinetisch",
        sliding: "durch Rutschen verloren",
        rolling: "durch Rollen verloren",
        impacts: "durch Stöße verloren",
      },
    },
  },

  compare: {
    title: "Vergleichen mit …",
    help: "Zeigt eine zweite Bewegung gleichzeitig neben der ersten.",
    presets: {
      ice: "Eis und Gummi",
      coin: "Dose und Münze",
      mirror: "Dieser Start und sein Spiegelbild",
      keep: "Diese Bewegung behalten und den Aufbau ändern",
    },
    keyA: "A, durchgezogen: der Aufbau oben",
    keyB: "B, gestrichelt: der andere",
    setup: "Aufbau",
    turn: "Erster Umlauf",
    difference: "B gegen A",
    rows: {
      turn: "Kontaktpunkt lief",
      itself: "Körper selbst drehte sich",
      limit: "Grenzwert der Theorie",
      tilt: "Kleinste Neigung",
      gap: "Spalt unter dem Rand dabei",
      time: "Zeit bis dahin",
      passage: "Zeit für den Großteil des Winkels",
      force: "Größte Kraft, in Gewichten",
      energy: "Verbliebene Energie",
      end: "Ende der ganzen Bewegung",
    },
    ending: "Wie es endet",
    endings: {
      finished: "bewegt sich noch",
      toppled: "fällt um",
      lifted_off: "hebt ab",
      face_down: "kommt flach auf",
      at_rest: "in Ruhe",
      painleve: "keine Antwort",
      failed: "bricht ab",
    },
    same: "Beide Aufbauten sind noch gleich. Ändere den Aufbau oben: B bleibt, wie es ist.",
    refused: (which: "A" | "B", why: string) => `${which} hat keine Bewegung: ${why}.`,
    none: "Einer der Körper kommt nicht herunter, deshalb gibt es keinen Umlauf zu vergleichen.",
    equal: (angle: string) =>
      `Der Kontaktpunkt lief in beiden um ${angle} herum, auf eine Nachkommastelle genau.`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `Der Kontaktpunkt lief in A um ${a} und in B um ${b} herum: ${apart} ${further ? "mehr" : "weniger"} in B.`,
    swap: "A und B tauschen",
    stop: "Vergleich beenden",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which}: ${text}`,
    drawn: (body: BodyName, times: string) =>
      `${Noun(body)}, ${times}-mal so groß gezeichnet wie A`,
    plot: (label: string) => `${label}, B`,
    total: "kinetisch und potentiell, B",
    inLink: (message: string) => `Verglichen mit: ${message}`,
  },
  scene: {
    picture: "Der Körper auf dem Tisch",
    tip: "Halte den Körper einen Moment, dann kippe ihn.",
    reset: "Startansicht",
    places: { above: "Von oben", contact: "Kontakt", below: "Von unten" },
    help: "So bedienst du dieses Bild",
    gestures:
      "Ziehe den Körper, um ihn zu kippen; mit einem Finger halte ihn zuerst einen Moment. Lass ihn los, oder lass ihn in der Bewegung los, um ihm Schwung zu geben. Ziehe den Tisch, um von einer anderen Seite zu schauen. Zum Vergrößern ziehe zwei Finger auseinander oder drehe das Mausrad, nach einem Klick auf das Bild oder mit Strg.",
    keysTitle: "Tasten, solange das Bild den Fokus hat:",
    keys: [
      ["← → ↑ ↓", "von einer anderen Seite schauen, auch von unten"],
      ["Bild auf, Bild ab", "vergrößern, verkleinern"],
      ["Pos1", "Ansicht zurücksetzen"],
      ["+ und −", "den Körper nehmen und um 1° kippen"],
      ["Umschalt + ← →", "seine Neigung um 5° herumdrehen, während du ihn hältst"],
      ["Eingabe", "ihn in Ruhe loslassen"],
      ["Umschalt + Eingabe", "ihn mit den eingestellten Raten anstoßen"],
      ["Esc", "ihn zurückstellen"],
    ],
    rolls: "rollt",
    slips: "rutscht",
    flies: "in der Luft",
    square: (length: string) => `1 Kästchen = ${length}`,
    notLoaded: "Das Bild konnte nicht geladen werden. Lade die Seite neu, um es zu sehen.",
    noWebGL: "Dieser Browser kann das Bild nicht zeigen, weil WebGL ausgeschaltet ist oder fehlt.",
    rest: "Der Rest der Seite funktioniert: die Bewegung, die Winkel und die Diagramme.",
    stopped:
      "Die Grafik dieses Browsers hat angehalten. Das Bild kommt zurück, wenn sie wieder läuft.",
    ranRound: (angle: string) => `Kontaktpunkt lief um ${angle}`,
    itself: (body: BodyName, angle: string) => `${NOUNS[body]} selbst drehte sich um ${angle}`,
    guess: (angle: string) => `deine Schätzung ${angle}`,
    noSlip: "ohne Rutschen",
    frictionless: "reibungsfrei",
    theory: "Theorie",
    gap: (gap: string) => `Spalt ${gap}`,
    gapDrawn: (gap: string, times: string) => `Spalt ${gap}, ${times}-mal so hoch gezeichnet`,
    unrolled: "Weg des Kontaktpunkts, abgerollt: ",
    table: "Tisch",
    rim: "Rand",
    noSlipYet: "er rollt, ohne zu rutschen",
    slipped: (length: string) => `der Rand ist ${length} gerutscht`,
    runs: (rim: string, table: string, slip: string) =>
      `In diesem Umlauf ist der Kontaktpunkt ${rim} am Rand und ${table} auf dem Tisch entlanggelaufen: ${slip}.`,
  },

  prose: {
    title: "rimroll: Kippe die Dose",
    skip: "Zum Aufbau springen",
    tagline: "Eine gekippte Dose scheint zu schaukeln, aber ihr Kontaktpunkt läuft um den Rand.",
    "part.nav": "Teile dieser Seite",
    "part.controls": "Aufbau",
    "part.compare": "Vergleich",
    "part.flicks": "Versuche",
    "part.plots": "Diagramme",
    "part.share": "Teilen",
    "part.limits": "Grenzen",
    "part.gyro": "Gyroskop",
    "to-lab": "Das Labor",
    "to-essay": "Was ist das?",
    "question.title": "Wo kommt sie hoch?",
    "question.text":
      "Kippe eine Dose und lass sie los. Sie fällt zurück, ihr Boden trifft beinahe den Tisch, und sie steigt wieder. Drehe die Linie dorthin, wo sie deiner Meinung nach hochkommt, dann lass los.",
    "slap-or-roll.title": "Schlagen oder rollen?",
    "slap-or-roll.text":
      "Sie kommt nicht genau gegenüber hoch, wie es ein Schaukelstuhl täte. Sie kommt {0} daneben hoch. Es sieht so aus, als schlüge der Boden auf den Tisch und die Dose prallte ab. Das geschieht aber nicht.",
    "slap-or-roll.slow":
      "Hier läuft die Zeit langsamer, wenn die Dose fast flach ist, und die Stäbe zeigen den Spalt unter dem Rand, höher gezeichnet, als er ist. Ein Punkt des Randes berührt den Tisch, und dieser Punkt läuft herum: den größten Teil des Weges in {0}. Achte auf die Marken am Rand. Sie bleiben, wo sie sind. Die Dose dreht sich nicht; sie rollt auf ihrem Rand.",
    "hand.title": "Warum die Hand keine Rolle spielt",
    "hand.text":
      "Keine Hand lässt perfekt los. Ein kleiner seitlicher Fehler entscheidet, ob der Kontaktpunkt links oder rechts herum läuft und wie nahe der Boden dem Tisch kommt. Bewege den Regler: Spalt und Zeit ändern sich hundertfach. Der Winkel ändert sich kaum.",
    "hand.limit":
      "Je ruhiger die Hand, desto näher liegt der Winkel an einem Grenzwert, {0} für diese Dose. Der Grenzwert hängt nur von der Dose ab:",
    "hand.symbols":
      "Dabei ist {0} ihre Masse, {1} der Radius ihres Bodens, {2} die Höhe ihres Schwerpunkts und {3} ihr Trägheitsmoment für das Kippen um diesen Punkt.",
    "friction.title": "Von Eis bis Gummi",
    "friction.text":
      "Um so schnell zu rollen, muss der Rand auf dem Tisch haften. Ab einer Reibung von {0} rollt diese Dose die ganze Zeit. Mit weniger rutscht ihr Rand, und sie kommt woanders hoch. Ganz ohne Reibung ist der Grenzwert {1}.",
    "friction.try":
      "Bewege den Regler von Eis bis Gummi. Wo der Weg auf dem Tisch orange ist, rutscht der Rand.",
    "tall-and-flat.title": "Hoch und flach",
    "tall-and-flat.text":
      "Ein hoher Körper schaukelt fast genau nach gegenüber. Je flacher er ist, desto weiter läuft der Kontaktpunkt. Ändere die Höhe dieses vollen Zylinders und sieh, wo er hochkommt.",
    "disks-and-coins.title": "Scheiben und Münzen",
    "disks-and-coins.text":
      "Bei einer homogenen Scheibe ohne Höhe liegt der Schwerpunkt im Boden, und die Formel oben ergibt {0} oder {1}: einen vollen Umlauf und {2} mehr. Die Reibung spielt dann keine Rolle. Eine Münze kommt dem nahe. Vergleiche andere Körper.",
    "experiment.title": "Zweiundvierzig Versuche",
    "experiment.text":
      "Die Autoren der Studie stießen eine Dose 42-mal an und notierten, wohin sie fiel. Die mittleren Umlaufwinkel waren {0} nach links und {1} nach rechts, zwischen den Grenzwerten ohne Rutschen und ohne Reibung.",
    "experiment.try":
      "Stoße die Dose hier mit unruhiger Hand an und ändere dann die Reibung, bis deine Stürze dort liegen, wo die der Autoren lagen. Welche Reibung passt am besten?",
    "left-out.title": "Was hier fehlt",
    "left-out.text":
      "Diese Dose und dieser Tisch sind vollkommen starr und glatt, und es gibt keine Luft. Wie gut stimmt das? Es hängt davon ab, wie nahe der Boden dem Tisch kommt. Die Liste zeigt die Zahlen dieser Bewegung, jede neben dem, was eine echte Dose zulässt. Lass die Hand ruhiger werden und sieh, welche keinen Sinn mehr ergeben.",
    "your-turn.title": "Jetzt du",
    "your-turn.text":
      "Nimm die Dose selbst in die Hand. Im Labor kannst du mehr: den Körper, den Tisch und den Start ändern, die Flasche füllen, eine Münze drehen, den Untergrund rütteln, alle Kräfte und Energien sehen und behalten oder verschicken, was du findest.",
    "your-turn.lab": "Das Labor öffnen",
    "section.scene": "Der Tisch",
    "section.transport": "Zeit",
    "section.verdict": "Was geschieht",
    "section.story": "Die Geschichte",
    "section.controls": "Aufbau",
    "section.compare": "Vergleich",
    "section.plots": "Diagramme",
    "section.flicks": "Zweiundvierzig Versuche",
    "section.share": "Teilen",
    "section.limits": "Was dieses Modell weglässt",
    "section.gyro": "Ein Smartphone im Körper",
    "foot.paper":
      "Die Mechanik folgt M. Srinivasan und A. Ruina, „Rocking and rolling: a can that appears to rock might actually roll“, {0}.",
    "foot.private":
      "Jede Bewegung wird auf deinem eigenen Gerät berechnet. Nichts wird irgendwohin gesendet.",
    "foot.parts": "{0} dieser Seite und ihrer Teile.",
    "foot.licences": "Lizenzen",
    "foot.languages": "Sprachen",
  },
};
