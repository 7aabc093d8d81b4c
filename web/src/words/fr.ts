// French. See en.ts for what each word is for.

import type { BodyName } from "../setup/fields";
import type { SideCount, Turned } from "./en";
import type { Table } from "./words";

/** The bodies with their articles. */
const NOUNS: Record<BodyName, string> = {
  can_2007: "la canette",
  soda_can: "la canette",
  beer_bottle: "la bouteille",
  coin: "la pièce",
  ring: "l’anneau",
  battery: "la pile",
  euler_disk: "le disque",
  own: "le corps",
  inertia: "le corps",
};

const Noun = (body: BodyName) => NOUNS[body].charAt(0).toUpperCase() + NOUNS[body].slice(1);
/** “Itself”, with the gender of the body. */
const self = (body: BodyName) => (NOUNS[body].startsWith("la ") ? "elle-même" : "lui-même");

const SIDES = { left: "à gauche", right: "à droite" } as const;

export const fr: Table = {
  between: " ",

  loading: "Chargement…",
  letGo: "Lâcher",
  flickTimes: (count: number) => (count === 1 ? "Faire un essai" : `Faire ${count} essais`),
  flickAgain: (count: number) => `Refaire ${count} essais`,
  openLab: "Ouvrir le labo",
  notStarted: (why: string) => `Cette page n’a pas pu démarrer : ${why}. La recharger peut aider.`,

  fields: {
    body: {
      label: "Corps",
      help: "Le corps posé sur la table.",
      choices: {
        can_2007: "Canette de l’article",
        soda_can: "Canette de soda",
        beer_bottle: "Bouteille de bière",
        coin: "Pièce (1 euro)",
        ring: "Anneau",
        battery: "Pile (AA)",
        euler_disk: "Disque d’Euler",
        own: "Le vôtre",
        inertia: "Par son inertie",
      },
    },
    fill: {
      label: "Remplissage",
      help: "Niveau de remplissage de la canette ou de la bouteille. La boisson bouge avec elle comme un solide.",
    },
    radius: { label: "Rayon", help: "Rayon du bord." },
    length: { label: "Hauteur", help: "De la base au sommet. 0 est un disque plat." },
    mass: { label: "Masse", help: "Masse totale. Aucun angle parcouru n’en dépend." },
    wall: {
      label: "Masse de la paroi",
      help: "Part de la masse au-dessus du fond : 0 est un cylindre plein, 100 un tube mince.",
    },
    base: {
      label: "Masse du fond",
      help: "Part de la masse totale, dans une plaque mince au fond.",
    },
    height: {
      label: "Centre de masse",
      help: "Hauteur du centre de masse au-dessus de la base. 0 est un disque plat.",
    },
    transverse: {
      label: "A/m",
      help: "Moment d’inertie par rapport à un axe transversal passant par le centre de masse, divisé par la masse.",
    },
    axial: {
      label: "C/m",
      help: "Moment d’inertie par rapport à l’axe du corps, divisé par la masse. Aucun solide indéformable n’a plus de 2 A/m.",
    },
    tilt: { label: "Inclinaison", help: "L’inclinaison du corps quand on le lâche." },
    tilt_rate: {
      label: "Vitesse d’inclinaison",
      help: "À 0, le corps est lâché au repos. Une valeur négative le pousse vers la verticale.",
    },
    sideways: {
      label: "Erreur latérale",
      help: "La vitesse à laquelle le corps tourne aussi autour de la direction dans laquelle il penche. Aucune main n’évite cette erreur.",
    },
    twist: {
      label: "Rotation",
      help: "La vitesse à laquelle le corps tourne aussi autour de la verticale.",
    },
    yaw: {
      label: "Penche vers",
      help: "La direction de l’inclinaison sur la table. Tout le mouvement tourne avec elle.",
    },
    law: {
      label: "Table",
      help: "« Sans frottement » et « Sans glissement » sont les deux lois idéales de l’article.",
      choices: {
        frictionless: "Sans frottement",
        coulomb: "Frottement sec",
        no_slip: "Sans glissement",
      },
    },
    friction: {
      label: "Frottement",
      help: "Coefficient de frottement μ : force de frottement maximale divisée par la force normale.",
    },
    rolling: {
      label: "Résistance au roulement",
      help: "Force de résistance divisée par la force normale : environ 0,0001 pour un bord dur sur une table dure. Elle freine le mouvement.",
    },
    restitution: {
      label: "Rebond",
      help: "Coefficient de restitution quand le bord retombe après avoir quitté la table.",
    },
    gravity: { label: "Pesanteur", help: "9,81 sur la Terre, 1,62 sur la Lune." },
    duration: { label: "Durée", help: "Le temps pendant lequel le mouvement est calculé." },
    floor: {
      label: "Sol",
      help: "Indique si le sol bouge. La table bouge avec lui, sans tourner.",
      choices: { rest: "Au repos", pulse: "Une impulsion", hand: "À la main" },
    },
    start: {
      label: "Départ",
      help: "Indique si le corps penche au départ ou repose à plat sur sa base.",
      choices: { tilted: "Penché", standing: "Posé à plat" },
    },
    pulse: {
      label: "Forme",
      help: "L’accélération du sol au cours du temps.",
      choices: {
        sine: "Sinus",
        cosine: "Cosinus",
        half_sine: "Demi-sinus",
        ricker: "Ondelette de Ricker",
        rectangular: "Rectangle",
      },
    },
    shake: {
      label: "Amplitude",
      help: "Accélération horizontale maximale. 9,81 est la pesanteur sur la Terre, 1 g.",
    },
    vertical: {
      label: "Verticale",
      help: "Accélération verticale maximale ; positive, elle va d’abord vers le haut.",
    },
    period: {
      label: "Période",
      help: "Durée d’une oscillation ; pour un demi-sinus et un rectangle, le temps jusqu’à leur fin.",
    },
    cycles: { label: "Cycles", help: "Nombre d’oscillations d’un sinus ou d’un cosinus." },
    direction: {
      label: "Direction",
      help: "La direction de l’accélération horizontale, comme dans « Penche vers ».",
    },
    flat: {
      label: "Retombée à plat",
      help: "Ce qui suit quand toute la base arrive en même temps. La mécanique du solide indéformable ne le détermine pas.",
      choices: {
        stop: "Le mouvement s’arrête",
        smooth_left: "Fait le tour à gauche",
        smooth_right: "Fait le tour à droite",
        housner: "Choc de Housner",
      },
    },
    record: { label: "Enregistrement" },
    falls: { label: "Chutes" },
    flicks: { label: "Essais", help: "Combien de fois on répète le lâcher. Dans l’article : 42." },
    unsteadiness: {
      label: "Tremblement de la main",
      help: "À 100, un essai manque le milieu d’environ 3°.",
    },
    seed: {
      label: "Graine",
      help: "Graine des nombres aléatoires. La même graine donne la même dispersion.",
    },
  },

  refusals: {
    noSuchChoice: (label: string, names: readonly string[], text: string) =>
      `${label} : « ${text} » n’existe pas ; choisissez ${[names.slice(0, -1).join(", "), ...names.slice(-1)].join(" ou ")}.`,
    noRecord: (label: string) => `${label} : ce n’est pas un enregistrement de cette page.`,
    twoReadings: (label: string, text: string, sign: "." | ",") =>
      `${label} : « ${text} » peut se lire de deux façons ; écrivez ${sign === "." ? "un point" : "une virgule"} avant les décimales et rien entre les milliers.`,
    empty: (label: string) => `${label} : il manque un nombre.`,
    noNumber: (label: string, text: string) => `${label} : il faut un nombre, et non « ${text} ».`,
    notWhole: (label: string, text: string) =>
      `${label} : il faut un nombre entier, et non ${text}.`,
    between: (label: string, low: string, high: string, text: string) =>
      `${label} : il faut plus de ${low} et moins de ${high} ; ${text} est en dehors.`,
    fromTo: (label: string, low: string, high: string, text: string) =>
      `${label} : il faut une valeur de ${low} à ${high} ; ${text} est en dehors.`,
  },

  playback: {
    speed: "Vitesse",
    realTime: "temps réel",
    slow: "Lent à la collision",
    on: "oui",
    off: "non",
    view: "Vue",
    step: "Étape",
  },

  controls: {
    title: "Montage",
    standsFlat: "Le corps repose à plat, immobile.",
    undo: "Annuler",
    reset: "Réinitialiser",
    more: "Plus",
    hint: "Pointez un réglage pour voir ce qu’il signifie.",
    dryOnly: "Ne vaut que pour le frottement sec.",
    tables: { ice: "glace", wood: "bois", rubber: "caoutchouc" },
    losses: { none: "nulle", hard: "dure", soft: "molle" },
    lossesOf: (table: string, resistance: string) =>
      `Résistance au roulement : ${table}, ${resistance}`,
    frictionOf: (table: string, friction: string) => `Frottement sur ${table}, ${friction}`,
    neededLabel: (friction: string) =>
      `${friction}, le frottement qu’il faut à ce corps pour rouler pendant sa quasi-collision`,
    neededHelp: (friction: string) =>
      `Avec ${friction} ou plus, ce corps roule pendant sa quasi-collision. Avec moins, il glisse.`,
    floor: (state: string) => `Le sol : ${state.charAt(0).toLowerCase()}${state.slice(1)}`,
    notLoaded: "Ces réglages n’ont pas pu être chargés. Rechargez la page.",
  },

  floor: {
    isLoading: "la partie de la page qui fait bouger le sol est en cours de chargement",
    isMissing:
      "la partie de la page qui fait bouger le sol n’a pas pu être chargée ; rechargez la page",
    push: "Pousser",
    pushHelp: "Pousse le sol loin de vous pendant un cinquième de seconde et lance le mouvement.",
    shake: "Secouer",
    shakeHelp: "Lance le mouvement du sol et du corps.",
    note: "Les essais et la théorie valent pour un sol au repos. Les positions des graphiques sont relatives à la table.",
    onceOnly: "Ne vaut que pour un sinus et un cosinus.",
    pad: "Bouger la table",
    padHelp:
      "Faites glisser ici pour bouger la table, un millimètre par pixel. Quand vous lâchez, le corps est secoué par ce même mouvement. Les flèches du clavier bougent aussi la table.",
    balanceTilt: "Angle de renversement",
    beyondBalance: "au-delà, un corps au repos se renverse",
    largestTilt: "Plus grande inclinaison",
    ofBalance: (ratio: string) => `${ratio} × l’angle de renversement`,
    uplift: "Soulèvement",
    neverRocks: "il ne commence jamais à se balancer",
    whenRocks: "quand il commence à se balancer",
    leansAtStart: "le corps penche au départ",
    itsLargestTilt: (tilt: string) => `Sa plus grande inclinaison est ${tilt}.`,
    overturns: (body: BodyName, after: string) => `${Noun(body)} se renverse à ${after}.`,
    overturnsInAir: (body: BodyName, after: string) =>
      `${Noun(body)} se renverse : son bord quitte le sol à ${after}.`,
    undecided: (after: string) =>
      `L’angle de renversement est dépassé à ${after}, quand le calcul s’arrête : on ne sait pas si le corps se renverse.`,
    survives: (state: "standing" | "sliding_flat" | "flying_level" | "moving", after: string) =>
      `Le corps ne se renverse pas. ${
        {
          standing: "Il repose à plat",
          sliding_flat: "Il glisse encore sur sa base",
          flying_level: "Il est en l’air",
          moving: "Il bouge encore",
        }[state]
      } à ${after}, quand le calcul s’arrête.`,
    stops: (after: string) =>
      `La base arrive à plat à ${after} et le mouvement s’arrête, comme le veut « Retombée à plat ». La mécanique du solide indéformable ne détermine pas la suite.`,
    isStill: "Le sol ne bouge pas.",
    moves: (far: string, strong: string) =>
      `Le sol bouge de ${far} au plus, avec une accélération de ${strong} au plus.`,
    beginsToRock: (body: BodyName, at: string) =>
      `${Noun(body)} commence à se balancer à ${at} (soulèvement).`,
    rocksAgain: (body: BodyName, at: string) =>
      `${Noun(body)} penche au départ, repose à plat un moment et recommence à se balancer à ${at}.`,
    leans: (body: BodyName) => `${Noun(body)} penche au départ.`,
    slides: (body: BodyName) =>
      `${Noun(body)} glisse sur sa base et ne commence jamais à se balancer.`,
    stands: (body: BodyName) =>
      `${Noun(body)} reste immobile sur le sol et ne commence jamais à se balancer.`,
  },

  verdict: {
    turned: "Le contact a parcouru",
    angleOfTurn: "Angle parcouru",
    itself: (body: BodyName) => `${Noun(body)} ${self(body)}`,
    meanwhile: "a tourné entre-temps",
    whenLetGo: "visible quand vous lâchez",
    ifLetGo: "si vous lâchez maintenant",
    theory: "En théorie",
    smallestTilt: "Plus petite inclinaison",
    gap: (gap: string) => `un interstice de ${gap}`,
    contactThen: "Contact à cet instant",
    perSecond: "tours par seconde",
    perSecondAt: (speed: string) => `tours par seconde, à ${speed}`,
    inHand: "Dans votre main",
    leansToward: (way: string) => `penche vers ${way}`,
    leansInHand: (tilt: string, way: string) =>
      `Dans votre main, le corps penche de ${tilt} vers ${way}.`,
    toFlick: "Pour lui donner de l’élan, lâchez pendant que votre main bouge.",
    wouldBe: {
      floorMoves: "Si vous lâchez maintenant au repos, le sol commencera à bouger.",
      nothing: "Si vous lâchez maintenant au repos, il n’y aura aucun mouvement.",
      rocked: (angle: string, after: string) =>
        `Si vous lâchez maintenant au repos, le point de contact parcourra ${angle} pendant la descente et la remontée jusqu’à la prochaine inclinaison maximale, à ${after}.`,
      hovered: (after: string) =>
        `Si vous lâchez maintenant au repos, le corps ne sera pas encore descendu et remonté à ${after}, quand le calcul s’arrête.`,
      toppled: (angle: string, after: string) =>
        `Si vous lâchez maintenant au repos, le point de contact parcourra ${angle} et le corps se renversera à ${after}.`,
      fell_back: (after: string) =>
        `Si vous lâchez maintenant au repos, le corps se renversera du côté où il penche, à ${after}.`,
      face_down: (after: string) =>
        `Si vous lâchez maintenant au repos, le corps arrivera à plat à ${after}.`,
      at_rest: (after: string) =>
        `Si vous lâchez maintenant au repos, le corps s’immobilisera sur sa base à ${after}.`,
      lifted_off: (after: string) =>
        `Si vous lâchez maintenant au repos, le bord quittera la table à ${after}, où s’arrêtent les lois idéales.`,
      painleve: (after: string) =>
        `Si vous lâchez maintenant au repos, le corps rencontrera le paradoxe de Painlevé à ${after}, où la mécanique du solide indéformable n’a pas de réponse unique.`,
      failed: "Si vous lâchez maintenant au repos, le calcul échouera.",
    },
    story: ({ start, end, endsWith, angle, time, body, itself, way }: Turned) => {
      const from = start === undefined ? "Du lâcher" : `De l’inclinaison maximale à ${start}`;
      const to = {
        maximum: "la prochaine inclinaison maximale",
        fall: "sa chute",
        end: "la fin",
      }[endsWith];
      const turn = {
        none: itself,
        same: `${itself} dans le même sens`,
        other: `${itself} dans l’autre sens`,
      };
      return `${from}, en descendant puis remontant jusqu’à ${to} à ${end}, le point de contact parcourt ${angle}, presque tout en ${time} ; ${NOUNS[body]} ${self(body)} tourne de ${turn[way]}.`;
    },
    rim: {
      rolled: "Le frottement suffit : le corps roule tout du long.",
      slipped: "Le bord glisse en chemin.",
      jumped: "Le bord saute de la table en chemin.",
    },
    fullTurn: (rest: string) => `C’est un tour complet et ${rest}.`,
    veers: (angle: string, side: "left" | "right") =>
      `C’est à ${angle} ${SIDES[side]} du point juste en face.`,
    ofAngle: (angle: string, until: "turn" | "fall" | "end") =>
      `sur ${angle} ${{ turn: "dans ce parcours", fall: "à la chute", end: "à la fin" }[until]}`,
    comesDownFlat: "le corps arrive à plat",
    incomplete: "le parcours suivant n’est pas complet",
    staysUp: "le corps ne redescend pas",
    limitHere: "la limite sur cette table",
    asComputed: "égale à l’angle calculé ici",
    below: (angle: string) => `${angle} de moins que l’angle calculé`,
    above: (angle: string) => `${angle} de plus que l’angle calculé`,
    holds: (text: string, flat: boolean, untwisted: boolean) =>
      `${text} ; vaut pour un corps qui ${[...(flat ? ["arrive à plat"] : []), ...(untwisted ? ["est lâché sans rotation"] : [])].join(" et ")}`,
    noMotion: (why: string) => `Il n’y a pas de mouvement à montrer : ${why}.`,
    stillComputing: (after: string) => `Le mouvement après ${after} est en cours de calcul.`,
    stillMoves: (after: string) => `Le corps bouge encore à ${after}, quand le calcul s’arrête.`,
    fallsOver: (after: string) => `Le corps se renverse à ${after}.`,
    fallsBack: (after: string) =>
      `Le corps se renverse à ${after}, du côté où il penche au départ.`,
    liftsOff: (after: string | undefined) =>
      `${after === undefined ? "Aussitôt" : `À ${after}`}, le bord quitterait la table. Les lois idéales ne couvrent pas le vol, donc le mouvement s’arrête ici. Choisissez le frottement sec pour le suivre.`,
    comesToRest: (after: string) =>
      `Le corps s’immobilise à ${after} : sa base est à plat et son énergie est épuisée.`,
    painleve: (after: string, friction: string) =>
      `Paradoxe de Painlevé à ${after} : avec tant de frottement, la mécanique du solide indéformable n’a pas de réponse unique pour le bord qui glisse. Pour ce corps, presque à plat, le paradoxe commence à un frottement de ${friction}. Réduisez le frottement pour suivre le mouvement.`,
    tooManySteps: (after: string) =>
      `Le calcul s’arrête à ${after}, car il lui faut trop de pas. Choisissez une durée plus courte.`,
    cannotContinue: (after: string, why: string) =>
      `Le calcul ne peut pas continuer après ${after} : ${why}.`,
    faceDownStraight: (after: string, least: string) =>
      `À plat à ${after} : sans mouvement latéral, tout le bord rencontre la table en même temps. La mécanique du solide indéformable ne détermine pas la suite. Avec la moindre erreur latérale, le point de contact fait le tour ; une erreur de ${least} ou plus peut être calculée.`,
    faceDownResisted: (after: string) =>
      `À plat à ${after} : la résistance au roulement arrête le point de contact, et la base frappe la table à plat. La mécanique du solide indéformable ne détermine pas la suite quand tous les points du bord frappent en même temps. Avec moins de résistance ou une plus grande erreur latérale, le point de contact fait le tour.`,
    faceDownShort: (after: string) =>
      `À plat à ${after} : le corps arrive si à plat que la course du point de contact autour du bord est trop brève pour être calculée. Choisissez une plus grande erreur latérale.`,
    computationFailed: (why: string) =>
      `le calcul a échoué (${why}) ; changez le montage ou rechargez la page`,
  },

  essay: {
    guess: "Votre pari",
    time: "Temps",
    closer: "Comment est-ce possible ? Regardez de plus près",
    inLab: "Ouvrir ceci dans le labo",
    grasp:
      "Prenez la canette par le haut, inclinez-la et lâchez. Avec un doigt, tenez-la d’abord un instant.",
    askTelephone: "Utiliser l’inclinaison du téléphone",
    holdTelephone: "Maintenez, inclinez le téléphone, relâchez",
    theCan: "La canette, que vous pouvez incliner",
    theBody: "Le corps sur la table",
    noPicture:
      "Ce navigateur ne peut pas montrer l’image, car WebGL est désactivé ou absent. Les textes, les nombres et les courbes s’en passent.",
    atSmallest: "à la plus petite inclinaison",
    fromSmallest: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "avant", after: "après" }[when]} la plus petite inclinaison`,
    range: (label: string, from: string, to: string) => `${label} de ${from} à ${to}`,
    guessedWell: "Bien vu !",
    guessedOff: (angle: string, further: boolean) =>
      `C’est ${angle} de ${further ? "plus" : "moins"} que votre pari.`,
    cameUp: (said: string, straight: boolean, turned: string) =>
      `Vous avez dit ${said}${straight ? ", juste en face" : ""}. Elle est remontée à ${turned}.`,
    ranRound: (angle: string, time: string, body: BodyName, itself: string, gap: string) =>
      `Le point de contact a parcouru ${angle}, presque tout en ${time}. ${Noun(body)} ${self(body)} a tourné de ${itself}. L’interstice sous son bord s’est réduit à ${gap}, mais un point du bord touchait toujours la table.`,
    straight: (angle: string) => `${angle}, juste en face`,
    notStraight: (angle: string, aside: string, beyond: boolean) =>
      `${angle}, ${aside} ${beyond ? "au-delà" : "en deçà"} du point juste en face`,
    sideways: "Erreur latérale de la main",
    friction: "Frottement de la table",
    height: "Hauteur du cylindre",
    body: "Corps",
    bodies: { coin: "Pièce", ring: "Anneau", battery: "Pile", bottle: "Bouteille" },
    lines: {
      turn: "angle parcouru",
      limit: "limite",
      here: "limite sur cette table",
      noSlip: "sans glissement",
      frictionless: "sans frottement",
      noSlipLimit: "limite sans glissement",
    },
    hand: (angle: string, gap: string, time: string) =>
      `Le point de contact a parcouru ${angle}. L’interstice sous le bord s’est réduit à ${gap}, et presque tout l’angle a pris ${time}.`,
    table: (angle: string, rolled: boolean, limit: string) =>
      `Le point de contact a parcouru ${angle}, et le bord ${rolled ? "a roulé tout du long" : "a glissé en chemin"}. Plus une canette arrive à plat, plus son angle est proche de ${limit} sur cette table.`,
    cylinder: (angle: string, limit: string) =>
      `Le point de contact a parcouru ${angle}. La limite pour ce cylindre est ${limit}.`,
    limits: (angle: string, noSlip: string, frictionless: string) =>
      `Le point de contact a parcouru ${angle}. Les limites sont ${noSlip} sans glissement et ${frictionless} sans frottement.`,
  },

  story: {
    where: (step: number, of: number) => `L’histoire, étape ${step} sur ${of}`,
    back: "‹ Retour",
    backLabel: "Retour à l’étape précédente",
    show: "Voir",
    next: "Suite ›",
    nextLabel: "Suite : étape suivante",
    steps: {
      looks: {
        title: "On dirait un balancement",
        text: "Inclinez une canette et lâchez-la. Elle semble frapper la table à plat et remonter de l’autre côté. Le film s’arrête en haut de cette remontée : la canette n’est pas remontée en face, mais à 23° de là.",
      },
      slower: {
        title: "Au ralenti",
        text: "Lâchez-la d’une petite inclinaison et regardez cinquante fois plus lentement. La base ne frappe jamais la table. Elle est presque à plat, mais un seul point de son bord touche la table.",
      },
      rolls: {
        title: "Elle roule",
        text: "Maintenant de près : le temps s’étire pendant que le point de contact file autour du bord. Les tiges montrent l’interstice sous le bord, dessiné quelques milliers de fois plus haut. Le point de contact fait plus d’un demi-tour en moins d’un dix-millième de seconde, mais les repères du bord restent où ils sont : la canette elle-même ne tourne pas. Elle roule sur son bord.",
      },
      same: {
        title: "L’angle est chaque fois le même",
        text: "Lâchez-la encore et encore. Le hasard décide entre gauche et droite, mais pas jusqu’où va le point de contact : près de 202° chaque fois, et d’autant plus près que la canette arrive plus à plat. La limite ne dépend que de la canette :",
        symbols:
          "m est sa masse, R le rayon de sa base, H la hauteur de son centre de masse et A son moment d’inertie par rapport à un axe transversal passant par ce centre.",
      },
      friction: {
        title: "Le frottement",
        text: "Sur une table sans frottement, la canette glisse au lieu de rouler et l’angle est de 221°. Une vraie table est entre les deux. Les auteurs de l’article ont donné 42 fois une chiquenaude à une canette et mesuré des moyennes de 213° à gauche et 218° à droite. Essayez un frottement proche de 0,1, et changez la table pour voir bouger les deux bosses.",
      },
      yourTurn: {
        title: "À vous",
        text: "Prenez le corps par le haut et inclinez-le. Lâchez-le, ou donnez-lui de l’élan en lâchant pendant que votre main bouge. Changez le corps et la table, remplissez la bouteille, faites tourner une pièce. Pour garder ou montrer un mouvement, utilisez « Partager », plus bas.",
      },
    },
    histogram: (from: string, to: string, width: string) =>
      `Angles parcourus des chutes, de ${from} à ${to} par barres de ${width}.`,
    caption: (width: string) =>
      `Angles parcourus des chutes : gauche en haut, droite en bas, ${width} par barre.`,
    measured: "Lignes avec un point : moyenne et dispersion des chutes de l’article.",
    left: (count: number) => `gauche : ${count}`,
    right: (count: number) => `droite : ${count}`,
  },

  flicks: {
    title: "Quarante-deux essais",
    hint: "Aucune main ne répète un geste exactement. Répétez ce lâcher avec un peu de dispersion et voyez où tombe le corps.",
    clear: "Effacer",
    hand: "La main",
    picture: "Directions dans lesquelles le corps est tombé, vues d’en haut",
    left: "à gauche de la main",
    right: "à droite",
    noSlip: "limite sans glissement",
    frictionless: "limite sans frottement",
    here: "limite sur cette table",
    measured: (left: string, right: string) => `l’article : ${left} et ${right}`,
    twisted: "Les limites valent pour un corps lâché sans rotation.",
    initialLean: "inclinaison initiale",
    own: {
      title: "Vos propres chutes",
      help: "Où votre canette est-elle tombée ? Tapez les directions en degrés, dans le sens inverse des aiguilles d’une montre depuis l’inclinaison initiale ; les chutes à votre gauche dépassent 180. Pour réunir plusieurs groupes, collez leurs liens.",
      add: "Ajouter",
      clear: "Tout enlever",
      refused:
        "Tapez des nombres de 0 à 360 séparés par des espaces, ou collez des liens avec des chutes.",
    },
    fit: {
      ask: "Quel frottement convient ?",
      running: "Essai des frottements…",
      answer: (friction: string, low: string, high: string) =>
        `Un frottement de ${friction} convient le mieux ; de ${low} à ${high}, il convient presque aussi bien, si la main est comme celle réglée ici.`,
      none: "Aucun des frottements ne fait tomber le corps de ces côtés.",
    },
    running: "Essais en cours…",
    none: "Ce montage ne permet pas d’essais.",
    summary: (made: number, sides: readonly SideCount[], fell: boolean, others: number) => {
      const each = sides.map(({ side, count, angle }) => {
        const one = fell ? "est tombé" : "est remonté";
        const many = fell ? "sont tombés" : "sont remontés";
        if (count === 0) return `aucun n’${one} ${SIDES[side]}`;
        return `${count} ${count === 1 ? one : many} ${SIDES[side]} après ${angle}`;
      });
      const rest = others > 0 ? ` ; ${others} ${others === 1 ? "a" : "ont"} fini autrement` : "";
      return `Sur ${made} ${made === 1 ? "essai" : "essais"}, ${each.join(", ")}${rest}.`;
    },
  },

  limits: {
    title: "Ce que ce modèle néglige",
    unevenness: "Défaut de planéité du bord et de la table",
    unevennesses: {
      ground: "0,02 mm, rectifié",
      fine: "0,1 mm, fin",
      medium: "0,2 mm, moyen",
      coarse: "0,4 mm, grossier",
      dented: "1 mm, bosselé",
    },
    touches: (time: string, angle: string, whole: string) =>
      `Avec ce défaut de planéité, ils se touchent en plusieurs points pendant ${time}. Pendant ce temps, le point de contact parcourt ${angle} sur ${whole} ; cette part dépend de la forme des deux.`,
    touchesOnce:
      "L’interstice reste plus grand que ce défaut de planéité, donc le bord et la table se touchent toujours en un seul point.",
    intro:
      "Ici le corps et la table sont parfaitement rigides et lisses, le bord est un cercle parfait et il n’y a pas d’air. Dans le parcours montré :",
    none: "Ce corps ne redescend pas, donc il n’y a rien à comparer.",
    trust:
      "Là où un nombre dépasse ce que peut un corps réel, ne vous fiez ni à l’interstice ni à la vitesse. Fiez-vous à l’angle, qui dépend à peine de la taille de l’interstice. Une main fait une erreur latérale d’environ 0,02 rad/s.",
    gap: "Plus petit interstice sous le bord",
    gapTiny:
      "Plus petit que le défaut de planéité de tout bord et de toute table, 0,1 à 0,4 mm : ils se touchent en plusieurs points.",
    gapSmall:
      "Pas plus grand que le défaut de planéité du bord et de la table, 0,1 à 0,4 mm : ils peuvent se toucher en plusieurs points.",
    gapWide: "Plus grand que le défaut de planéité du bord et de la table, 0,1 à 0,4 mm.",
    speed: "Point de contact le long du bord",
    speedBeyond:
      "Plus rapide que le son dans l’acier, l’aluminium ou le verre, 5 à 6 km/s : le bord et la table n’ont pas le temps de s’écarter.",
    speedNear: "Guère plus lent que le son dans l’acier, l’aluminium ou le verre, 5 à 6 km/s.",
    speedBelow: "Plus lent que le son dans l’acier, l’aluminium ou le verre, 5 à 6 km/s.",
    time: "Temps pour presque tout l’angle",
    bends: (sound: string) =>
      `Le son met ${sound} à traverser la base : le corps fléchit et vibre au lieu de bouger d’un bloc.`,
    isRigid: (sound: string) =>
      `Le son met ${sound} à traverser la base : le corps bouge d’un bloc.`,
    force: "Plus grande force sur la table",
    timesWeight: (ratio: string) => `${ratio} × le poids`,
    atOnePoint:
      "En un point du bord. Qu’il s’y déforme ou non dépend du poids, du matériau et de l’arête.",
    losses: "Énergie perdue dans ce parcours",
    lossless:
      "Une vraie canette perd de l’énergie à chaque parcours, par le son, l’air et la flexion, et s’arrête vite. « Résistance au roulement » est une de ces pertes.",
    loses: "Le son, l’air et la flexion, qui sont négligés, en prennent davantage.",
  },

  gyro: {
    title: "Un téléphone dans le corps",
    intro:
      "Un gyroscope qui tourne avec le corps ne voit pas courir le point de contact. Perpendiculairement à l’axe, il voit des rayons : le corps tombe le long de l’un et remonte le long du suivant. Chaque quasi-collision fait tourner le rayon de l’angle parcouru moins 180°.",
    save: "Enregistrer en CSV phyphox",
    saved: (name: string, command: string) => `${name} enregistré. Lisez-le avec : ${command}`,
    veers: (angles: string) => `Premières rotations du rayon : ${angles}.`,
    noTurn: "Il n’y a pas de parcours complet, donc aucun rayon ne tourne.",
    picture: (largest: string) =>
      `Vitesse angulaire perpendiculaire à l’axe, dans le repère du corps, jusqu’à ${largest}.`,
  },

  share: {
    title: "Partager",
    link: {
      help: "Le lien contient tout le montage. Aucun serveur ne le voit.",
      label: "Lien vers ce montage",
      copy: "Copier le lien",
      copied: "Lien copié.",
    },
    command: {
      help: "L’adresse de cette page ne fonctionne que sur votre ordinateur. Cette commande ouvre le même montage partout où rimroll est installé.",
      label: "Commande qui ouvre ce montage",
      copy: "Copier la commande",
      copied: "Commande copiée.",
    },
    labTitle: "Une canette sur une table",
    frame: "Mettre ceci sur une page ou une diapo",
    frameHelp: (isLocal: boolean) =>
      `Collez ce code dans le HTML de la page ou de la diapositive.${isLocal ? " Copiez à côté le dossier de cette page, sous le nom lab." : ""}`,
    copyFrame: "Copier le code",
    copiedFrame: "Code copié.",
    python: "Code Python",
    copyPython: "Copier en Python",
    copiedPython: "Code Python copié.",
    csv: "Télécharger le CSV",
    saved: (name: string) => `${name} téléchargé, en unités SI et radians.`,
    select: "Sélectionné : copiez avec Ctrl+C ou ⌘C.",
    samePython: "Le même mouvement en Python",
  },

  transport: {
    group: "Lecture",
    shown: "Instant montré",
    play: "Lecture",
    pause: "Pause",
    rewind: "Retour au lâcher",
    before: "À la collision précédente",
    after: "À la collision suivante",
    back: "Image précédente",
    on: "Image suivante",
    space: "Espace",
    stretching:
      "Ralentit le temps automatiquement pendant que le point de contact file autour du bord",
    of: (time: string, end: string) => `${time} sur ${end}`,
    atCollision: "à la collision",
    fromCollision: (time: string, when: "before" | "after") =>
      `${time} ${{ before: "avant", after: "après" }[when]} la collision`,
    inRealTime: "en temps réel",
    slower: (times: string) => `${times} fois plus lent que le temps réel`,
    keys: "Touches",
    keyPlay: "lecture, pause",
    keyBack: "image précédente",
    keyOn: "image suivante",
    keyHome: "retour au lâcher",
    keysOn: "Ces touches fonctionnent partout sur la page",
  },

  sound: {
    name: "Son",
    turnOn: "Activer le son du bord, ralenti comme le film",
    turnOff: "Couper le son",
    missing: "Ce navigateur ne peut pas jouer de son",
  },

  plots: {
    absent: "Il n’y a pas de mouvement à tracer.",
    hint: "Faites glisser sur un graphique pour l’agrandir, cliquez pour aller à un instant, double-cliquez pour tout le mouvement. La molette agrandit aussi, après un clic ou avec Ctrl. Sur un écran tactile, un doigt va à un instant et deux doigts agrandissent.",
    nothing: "rien à montrer",
    range: (low: string, high: string) => `entre ${low} et ${high}`,
    summary: (title: string, stretch: string, range: string) =>
      `${title} en fonction du temps, ${stretch} : ${range}`,
    timeLabel: (unit: string) => `temps, ${unit}`,
    since: (unit: string, origin: string) => `${unit} depuis ${origin}`,
    collisionAt: (time: string) => `la collision à ${time}`,
    stretch: (from: string, to: string) => `de ${from} à ${to}`,
    about: (stretch: string, origin: string) => `${stretch} autour de ${origin}`,
    whole: "Tout le mouvement",
    close: "Cette collision",
    closeHelp: "Montre la collision la plus proche de l’instant montré",
    zoom: "Zoom",
    zoomIn: "Agrandir",
    zoomOut: "Réduire",
    shown: (stretch: string) => `Montré : ${stretch}`,
    shaded: "Ombré : ",
    now: (phase: string) => `À l’instant montré : ${phase}.`,
    plot: "Graphique",
    phases: {
      standing: "posé à plat",
      rolling: "roule",
      sliding: "glisse",
      sliding_flat: "glisse à plat",
      flying: "vole",
      flying_level: "vole à l’horizontale",
      lying: "couché",
    },
    figures: {
      floor: {
        title: "Sol, accélération",
        short: "Sol",
        x: "selon x",
        y: "selon y",
        z: "vers le haut",
      },
      tilt: { title: "Inclinaison", short: "Inclin.", tilt: "inclinaison" },
      yaw: {
        title: "Direction",
        short: "Direction",
        yaw: "direction de l’inclinaison",
        theory: "théorie, premier parcours",
      },
      rates: {
        title: "Vitesses",
        short: "Vitesses",
        tilt: "inclinaison",
        yaw: "direction",
        spin: "rotation propre",
      },
      gyroscope: {
        title: "Gyroscope dans le corps",
        short: "Gyro.",
        x: "x",
        y: "y",
        z: "z, l’axe",
      },
      friction: {
        title: "Rapport de frottement",
        short: "Frottem.",
        available: "disponible μ",
        used: "utilisé |T|/N",
        needed: "nécessaire pour rouler μ*",
      },
      energy: {
        title: "Énergie",
        short: "Énergie",
        potential: "potentielle",
        kinetic: "cinétique",
        sliding: "perdue en glissant",
        rolling: "perdue en roulant",
        impacts: "perdue aux chocs",
      },
    },
  },

  compare: {
    title: "Comparer avec…",
    help: "Montre un second mouvement à côté du premier, en même temps.",
    presets: {
      ice: "Glace et caoutchouc",
      coin: "Canette et pièce",
      mirror: "Ce départ et son reflet",
      keep: "Garder ce mouvement et changer le montage",
    },
    keyA: "A, traits pleins : le montage ci-dessus",
    keyB: "B, tirets : l’autre",
    setup: "Montage",
    turn: "Premier parcours",
    difference: "B face à A",
    rows: {
      turn: "Le contact a parcouru",
      itself: "Le corps lui-même a tourné",
      limit: "Limite en théorie",
      tilt: "Plus petite inclinaison",
      gap: "Interstice sous le bord alors",
      time: "Temps jusque-là",
      passage: "Temps pour presque tout l’angle",
      force: "Plus grande force, en poids",
      energy: "Énergie conservée",
      end: "Fin de tout le mouvement",
    },
    ending: "Comment il finit",
    endings: {
      finished: "bouge encore",
      toppled: "se renverse",
      lifted_off: "décolle",
      face_down: "à plat",
      at_rest: "au repos",
      painleve: "pas de réponse",
      failed: "s’arrête",
    },
    same: "Les deux montages sont encore pareils. Changez celui du dessus : B reste comme il est.",
    refused: (which: "A" | "B", why: string) => `${which} n’a pas de mouvement : ${why}.`,
    none: "Un des corps ne redescend pas, donc il n’y a pas de parcours à comparer.",
    equal: (angle: string) =>
      `Le point de contact a parcouru ${angle} dans les deux, à une décimale près.`,
    turns: (a: string, b: string, apart: string, further: boolean) =>
      `Le point de contact a parcouru ${a} dans A et ${b} dans B : ${apart} de ${further ? "plus" : "moins"} dans B.`,
    swap: "Échanger A et B",
    stop: "Ne plus comparer",
    times: (ratio: string) => `× ${ratio}`,
    label: (which: "A" | "B", text: string) => `${which} : ${text}`,
    drawn: (body: BodyName, times: string) => `${Noun(body)}, à l’échelle ${times} fois celle de A`,
    plot: (label: string) => `${label}, B`,
    total: "cinétique et potentielle, B",
    inLink: (message: string) => `Comparé avec : ${message}`,
  },
  scene: {
    picture: "Le corps sur la table",
    tip: "Tenez le corps un instant, puis inclinez-le.",
    reset: "Vue initiale",
    places: { above: "D’en haut", contact: "Contact", below: "D’en bas" },
    help: "Comment utiliser cette image",
    gestures:
      "Faites glisser le corps pour l’incliner ; avec un doigt, tenez-le d’abord un instant. Lâchez-le, ou lâchez-le en mouvement pour lui donner de l’élan. Faites glisser la table pour regarder d’un autre côté. Pour agrandir, écartez deux doigts, ou tournez la molette après un clic sur l’image ou avec Ctrl.",
    keysTitle: "Touches tant que l’image a le focus :",
    keys: [
      ["← → ↑ ↓", "regarder d’un autre côté, aussi d’en bas"],
      ["Pg préc., Pg suiv.", "agrandir, réduire"],
      ["Début", "rétablir la vue"],
      ["+ et −", "prendre le corps et l’incliner de 1°"],
      ["Maj + ← →", "tourner son inclinaison de 5° pendant que vous le tenez"],
      ["Entrée", "le lâcher au repos"],
      ["Maj + Entrée", "le pousser avec les vitesses réglées"],
      ["Échap", "le remettre en place"],
    ],
    rolls: "roule",
    slips: "glisse",
    flies: "en l’air",
    square: (length: string) => `1 carreau = ${length}`,
    notLoaded: "L’image n’a pas pu être chargée. Rechargez la page pour la voir.",
    noWebGL: "Ce navigateur ne peut pas montrer l’image, car WebGL est désactivé ou absent.",
    rest: "Le reste de la page fonctionne : le mouvement, les angles et les graphiques.",
    stopped:
      "L’affichage graphique de ce navigateur s’est arrêté. L’image revient quand il reprend.",
    ranRound: (angle: string) => `le contact a parcouru ${angle}`,
    itself: (body: BodyName, angle: string) => `${NOUNS[body]} ${self(body)} a tourné de ${angle}`,
    guess: (angle: string) => `votre pari ${angle}`,
    noSlip: "sans glissement",
    frictionless: "sans frottement",
    theory: "théorie",
    gap: (gap: string) => `interstice ${gap}`,
    gapDrawn: (gap: string, times: string) => `interstice ${gap}, dessiné ${times} fois plus haut`,
    unrolled: "Chemin du contact, déroulé : ",
    table: "table",
    rim: "bord",
    noSlipYet: "il roule sans glisser",
    slipped: (length: string) => `le bord a glissé de ${length}`,
    runs: (rim: string, table: string, slip: string) =>
      `Dans ce parcours, le point de contact a parcouru ${rim} le long du bord et ${table} sur la table : ${slip}.`,
  },

  prose: {
    title: "rimroll : inclinez la canette",
    skip: "Aller au montage",
    tagline:
      "Une canette inclinée semble se balancer, mais son point de contact file autour du bord.",
    "part.nav": "Parties de cette page",
    "part.controls": "Montage",
    "part.compare": "Comparer",
    "part.flicks": "Essais",
    "part.plots": "Graphiques",
    "part.share": "Partager",
    "part.limits": "Limites",
    "part.gyro": "Gyroscope",
    "to-lab": "Le labo",
    "to-essay": "À propos",
    "question.title": "Où remontera-t-elle ?",
    "question.text":
      "Inclinez une canette et lâchez-la. Elle se redresse, sa base rejoint presque la table, et elle remonte. Tournez la ligne vers l’endroit où vous pensez qu’elle remontera, puis lâchez.",
    "slap-or-roll.title": "Frapper ou rouler ?",
    "slap-or-roll.text":
      "Elle ne remonte pas juste en face, comme le ferait un fauteuil à bascule. Elle remonte à {0} de là. À l’œil nu, la base semble frapper la table et la canette rebondir. Ce n’est pas ce qui se passe.",
    "slap-or-roll.slow":
      "Ici le temps ralentit quand la canette est presque à plat, et les tiges montrent l’interstice sous le bord, dessiné plus haut qu’il n’est. Un point du bord touche la table, et ce point fait le tour : la plus grande part du chemin en {0}. Regardez les repères du bord. Ils restent où ils sont. La canette ne tourne pas ; elle roule sur son bord.",
    "hand.title": "Pourquoi la main ne compte pas",
    "hand.text":
      "Aucune main ne lâche parfaitement. Une petite erreur latérale décide si la canette part à gauche ou à droite, et à quel point sa base s’approche de la table. Bougez le curseur : l’interstice et le temps changent d’un facteur cent. L’angle ne change presque pas.",
    "hand.limit":
      "Plus la main est sûre, plus l’angle est proche d’une limite, {0} pour cette canette. La limite ne dépend que de la canette :",
    "hand.symbols":
      "Ici {0} est sa masse, {1} le rayon de sa base, {2} la hauteur de son centre de masse et {3} son moment d’inertie par rapport à un axe transversal passant par ce centre.",
    "friction.title": "De la glace au caoutchouc",
    "friction.text":
      "Pour rouler si vite, le bord doit adhérer à la table. Avec un frottement de {0} ou plus, cette canette roule tout du long. Avec moins, son bord glisse et elle remonte ailleurs. Sans aucun frottement, la limite est {1}.",
    "friction.try":
      "Bougez le curseur de la glace au caoutchouc. Là où le chemin sur la table est orange, le bord glisse.",
    "tall-and-flat.title": "Haut et plat",
    "tall-and-flat.text":
      "Un corps haut se balance presque droit en face. Plus il est plat, plus le point de contact va loin. Changez la hauteur de ce cylindre plein et voyez où il remonte.",
    "disks-and-coins.title": "Disques et pièces",
    "disks-and-coins.text":
      "Dans un disque homogène sans épaisseur, le centre de masse est dans la base, et la formule ci-dessus donne {0} ou {1} : un tour complet et {2} de plus. Le frottement ne joue alors aucun rôle. Une pièce s’en approche. Comparez d’autres corps.",
    "experiment.title": "Quarante-deux essais",
    "experiment.text":
      "Les auteurs de l’article ont donné 42 fois une chiquenaude à une canette et noté où elle tombait. Les angles moyens étaient de {0} à gauche et {1} à droite, entre les limites sans glissement et sans frottement.",
    "experiment.try":
      "Poussez ici la canette d’une main peu sûre, puis changez le frottement jusqu’à ce que vos chutes rejoignent les leurs. Quel frottement convient le mieux ?",
    "left-out.title": "Ce qui est négligé",
    "left-out.text":
      "Cette canette et cette table sont parfaitement rigides et lisses, et il n’y a pas d’air. Qu’est-ce que cela vaut ? Cela dépend de la distance minimale entre la base et la table. La liste donne les nombres de ce mouvement, chacun à côté de ce que permet une vraie canette. Rendez la main plus sûre et voyez lesquels perdent leur sens.",
    "your-turn.title": "À vous",
    "your-turn.text":
      "Prenez vous-même la canette. Le labo permet davantage : changer le corps, la table et le départ, remplir la bouteille, faire tourner une pièce, secouer le sol, voir chaque force et chaque énergie, et garder ou envoyer ce que vous trouvez.",
    "your-turn.lab": "Ouvrir le labo",
    "section.scene": "La table",
    "section.transport": "Temps",
    "section.verdict": "Ce qui se passe",
    "section.story": "L’histoire",
    "section.controls": "Montage",
    "section.compare": "Comparaison",
    "section.plots": "Graphiques",
    "section.flicks": "Quarante-deux essais",
    "section.share": "Partager",
    "section.limits": "Ce que ce modèle néglige",
    "section.gyro": "Un téléphone dans le corps",
    "foot.paper":
      "La mécanique suit M. Srinivasan et A. Ruina, « Rocking and rolling: a can that appears to rock might actually roll », {0}.",
    "foot.private":
      "Chaque mouvement est calculé sur votre propre machine. Rien n’est envoyé nulle part.",
    "foot.parts": "{0} de cette page et de ses parties.",
    "foot.licences": "Licences",
    "foot.languages": "Langues",
  },
};
