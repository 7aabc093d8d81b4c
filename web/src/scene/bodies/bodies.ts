// The models of the bodies, with the base at z = 0, the axis along z, and lengths in metres.

import {
  type BufferGeometry,
  CircleGeometry,
  Group,
  type Material,
  Mesh,
  MeshStandardMaterial,
  type MeshStandardMaterialParameters,
  type Texture,
} from "three";
import type { Preset } from "../../core/core";
import type { Setup } from "../../setup/setup";
import { batteryPrint, beerLabel, coinFace, diskFace, ringPrint, sodaPrint, tinLabel } from "./art";
import {
  arc,
  markOn,
  type Outline,
  ownBody,
  plainBody,
  revolved,
  type Size,
  sizeOf,
} from "./shapes";

export function pictureOf(setup: Readonly<Setup>): Group {
  const size = sizeOf(setup);
  const body = modelOf(setup, size);
  body.add(markOn(size, setup.body === "ring" ? HOLLOW * size.widest : 0));
  body.traverse((part) => {
    part.castShadow = true;
    part.receiveShadow = true;
  });
  return body;
}

function modelOf(setup: Readonly<Setup>, size: Size): Group {
  if (setup.body === "own") return ownBody(setup, size);
  return setup.body === "inertia" ? plainBody(size) : PICTURES[setup.body](setup);
}

/** Makes a body transparent, so that what is under it is visible, or opaque again. */
export function setSeeThrough(body: Group, through: boolean): void {
  body.traverse((part) => {
    part.castShadow = !through;
    if (!(part instanceof Mesh)) return;
    const look = part.material as Material;
    const was = (look.userData["was"] ??= {
      transparent: look.transparent,
      opacity: look.opacity,
      depthWrite: look.depthWrite,
    }) as Partial<Material>;
    Object.assign(look, was);
    if (through) Object.assign(look, { transparent: true, opacity: GHOST, depthWrite: false });
    look.needsUpdate = true;
  });
}

/** Opacity of a transparent body. */
const GHOST = 0.13;

/** Frees the graphics memory of a body. */
export function dispose(body: Group): void {
  body.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    (part.geometry as BufferGeometry).dispose();
    const material = part.material as Material & { map?: Texture | null };
    material.map?.dispose();
    material.dispose();
  });
}

/** Inner over outer radius of the ring. */
const HOLLOW = 0.95;

const material = (parameters: MeshStandardMaterialParameters) =>
  new MeshStandardMaterial(parameters);
const steel = () => material({ color: "#c9ced3", metalness: 1, roughness: 0.28 });
const aluminium = () => material({ color: "#d9dde0", metalness: 1, roughness: 0.36 });
const lathe = (outline: Outline, look: Material) => new Mesh(revolved(outline), look);

/** A flat face that is visible from above (or below). */
function face(radius: number, z: number, look: Material, below = false): Mesh {
  const mesh = new Mesh(new CircleGeometry(radius, 96), look);
  mesh.position.z = z;
  if (below) mesh.rotation.x = Math.PI;
  return mesh;
}

const PICTURES: Record<Preset, (setup: Readonly<Setup>) => Group> = {
  can_2007: () => tin(0.051, 0.138),
  soda_can: sodaCan,
  beer_bottle: bottle,
  coin,
  ring,
  battery,
  euler_disk: eulersDisk,
};

/** A tin with seams at both ends, recessed lids with rings, and a paper label. */
function tin(radius: number, length: number): Group {
  const [seam, wall] = [0.0042, radius - 0.0013];
  const end = (sign: 1 | -1): [number, number][] => {
    // From the axis out to the seam at the lower end; the upper end is a mirror image.
    const z = (from: number) => (sign < 0 ? from : length - from);
    return [
      [0, z(0.0038)],
      [0.42 * radius, z(0.0038)],
      [0.45 * radius, z(0.003)],
      [0.6 * radius, z(0.003)],
      [0.63 * radius, z(0.0038)],
      [0.78 * radius, z(0.0038)],
      [0.81 * radius, z(0.0028)],
      [0.9 * radius, z(0.0028)],
      [radius - 0.003, z(0.0042)],
      [radius - 0.0022, z(0.0006)],
      [radius - 0.0014, z(0)],
      [radius - 0.0004, z(0)],
      [radius, z(0.0008)],
      [radius, z(seam - 0.001)],
      [wall, z(seam)],
    ];
  };
  const body = lathe([...end(-1), ...end(1).reverse()], steel());
  const paper = material({ map: tinLabel(), roughness: 0.62 });
  const margin = seam + 0.0035;
  const label = lathe(
    [
      [wall + 0.0003, margin],
      [wall + 0.0003, length - margin],
    ],
    paper,
  );
  return new Group().add(body, label);
}

function sodaCan(): Group {
  const wall = 0.033;
  const shoulder = 0.0955;
  const base: Outline = [
    [0, 0.0095],
    [0.009, 0.0088],
    [0.016, 0.0062],
    [0.0212, 0.0018],
    ...arc(0.0233, 0.0011, 0.0011, -Math.PI * 0.8, -Math.PI * 0.2, 5),
    [0.0262, 0.0035],
    [0.0295, 0.0068],
    [0.0318, 0.0098],
    [wall, 0.0135],
  ];
  const top: Outline = [
    [wall, shoulder],
    [0.0326, shoulder + 0.003],
    [0.0308, shoulder + 0.009],
    [0.0285, shoulder + 0.0135],
    [0.027, shoulder + 0.0155],
    [0.0266, 0.1128],
    ...arc(0.0262, 0.1138, 0.0012, -0.5, Math.PI * 0.9, 6),
    [0.0246, 0.108],
    [0.0228, 0.1072],
    [0.0222, 0.109],
    [0, 0.1092],
  ];
  const print = material({ map: sodaPrint(), metalness: 0.55, roughness: 0.34 });
  const wallOnly = lathe(
    [
      [wall, 0.0135],
      [wall, shoulder],
    ],
    print,
  );
  const tab = face(0.0062, 0, aluminium());
  tab.scale.set(1.5, 0.85, 1);
  tab.position.set(0.004, 0, 0.1103);
  const mouth = face(0.0068, 0.1094, material({ color: "#8f979c", metalness: 1, roughness: 0.5 }));
  mouth.position.x = 0.0135;
  return new Group().add(lathe(base, aluminium()), lathe(top, aluminium()), wallOnly, tab, mouth);
}

function bottle(setup: Readonly<Setup>): Group {
  const wall = 0.0305;
  const glass = material({
    color: "#4a2106",
    roughness: 0.08,
    transparent: true,
    opacity: 0.86,
    envMapIntensity: 1.4,
  });
  const outline: Outline = [
    [0, 0.005],
    [0.019, 0.0035],
    [0.0245, 0.0004],
    [0.026, 0],
    [0.0288, 0.0022],
    [0.0302, 0.0055],
    [wall, 0.009],
    [wall, 0.122],
    [0.0301, 0.13],
    [0.0283, 0.1405],
    [0.0246, 0.152],
    [0.0203, 0.1645],
    [0.0172, 0.177],
    [0.0152, 0.191],
    [0.0141, 0.206],
    [0.0138, 0.215],
    [0.0152, 0.2165],
    [0.0152, 0.2195],
    [0.0138, 0.221],
    [0.0133, 0.2255],
    [0.0126, 0.2268],
    [0, 0.2268],
  ];
  const cap = lathe(
    [
      [0.0133, 0.2225],
      [0.0162, 0.2222],
      [0.0158, 0.2245],
      [0.0146, 0.2285],
      [0.0125, 0.23],
      [0, 0.23],
    ],
    material({ color: "#d6a431", metalness: 0.9, roughness: 0.35 }),
  );
  const label = lathe(
    [
      [wall + 0.0002, 0.03],
      [wall + 0.0002, 0.103],
    ],
    material({ map: beerLabel(), roughness: 0.6 }),
  );
  const body = new Group().add(lathe(outline, glass), cap, label);
  const level = 0.006 + 0.124 * (setup.fill / 100);
  if (setup.fill > 0) {
    const drink = lathe(
      [
        [0, 0.006],
        [wall - 0.0024, 0.006],
        [wall - 0.0024, level],
        [0, level],
      ],
      material({ color: "#b8640c", roughness: 0.3 }),
    );
    body.add(drink);
  }
  return body;
}

function coin(): Group {
  const [radius, thick] = [0.5 * 23.25e-3, 2.33e-3];
  const gold = material({ color: "#d9b45a", metalness: 0.9, roughness: 0.32 });
  const edge = lathe(
    [
      [radius - 1.3e-3, 0.2e-3],
      [radius - 1.1e-3, 0],
      [radius - 0.2e-3, 0],
      [radius, 0.2e-3],
      [radius, thick - 0.2e-3],
      [radius - 0.2e-3, thick],
      [radius - 1.1e-3, thick],
      [radius - 1.3e-3, thick - 0.2e-3],
    ],
    gold,
  );
  const picture = material({ map: coinFace(), metalness: 0.75, roughness: 0.38 });
  return new Group().add(
    edge,
    face(radius - 1.2e-3, thick - 0.2e-3, picture),
    face(radius - 1.2e-3, 0.2e-3, picture, true),
  );
}

function ring(): Group {
  const { widest: outer, length: height } = sizeOf({ body: "ring" } as Setup);
  const inner = HOLLOW * outer;
  const look = material({ map: ringPrint(), metalness: 0.7, roughness: 0.35 });
  return new Group().add(
    lathe(
      [
        [inner, height],
        [inner, 0],
        [outer, 0],
        [outer, height],
        [inner, height],
      ],
      look,
    ),
  );
}

function battery(): Group {
  const [radius, length] = [7.25e-3, 50.5e-3];
  const top = length - 1.2e-3;
  const body = lathe(
    [
      [0, 0.15e-3],
      [radius - 1.2e-3, 0.15e-3],
      [radius - 1e-3, 0],
      [radius - 0.3e-3, 0],
      [radius, 0.3e-3],
      [radius, 1.2e-3],
    ],
    steel(),
  );
  const print = lathe(
    [
      [radius, 1.2e-3],
      [radius, top - 0.8e-3],
      [radius - 0.6e-3, top],
    ],
    material({ map: batteryPrint(), metalness: 0.25, roughness: 0.42 }),
  );
  const pole = lathe(
    [
      [radius - 0.6e-3, top],
      [radius - 1.2e-3, top - 0.3e-3],
      [2.75e-3, top - 0.3e-3],
      [2.75e-3, length - 0.25e-3],
      [2.5e-3, length],
      [0, length],
    ],
    steel(),
  );
  return new Group().add(body, print, pole);
}

function eulersDisk(): Group {
  const [radius, thick, bevel] = [0.0375, 12.7e-3, 1.6e-3];
  const body = lathe(
    [
      [0, 0],
      [radius - 0.3e-3, 0],
      [radius, 0.3e-3],
      [radius, thick - bevel],
      [radius - bevel, thick],
      [0, thick],
    ],
    material({ color: "#dfe4e8", metalness: 1, roughness: 0.12 }),
  );
  const foil = material({ map: diskFace(), metalness: 0.65, roughness: 0.25 });
  return new Group().add(body, face(radius - bevel - 0.6e-3, thick + 0.05e-3, foil));
}
