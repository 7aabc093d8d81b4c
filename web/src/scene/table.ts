// The table: a round patch that fades into the page, with a grid of known length.

import {
  CircleGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Mesh,
  MeshStandardMaterial,
  type Texture,
  Vector2,
} from "three";
import type { Palette } from "./palette";

/** Radius of the table, in radii of the circle of degrees. */
const EDGE = 7;
/** Half the side of a table without visible edges. */
const ENDLESS = 1e3;
/** Opacity of a table of glass. */
const GLASS = 0.3;

export class Table {
  readonly mesh: Mesh;
  private readonly material = new MeshStandardMaterial({
    roughness: 0.92,
    transparent: true,
  });
  private readonly grid = {
    cell: { value: 1 },
    ink: { value: new Color() },
    depth: { value: 0 },
    grain: { value: 0 },
    edge: { value: ENDLESS },
    shift: { value: new Vector2() },
  };

  constructor() {
    this.mesh = new Mesh(new CircleGeometry(EDGE, 96), this.material);
    this.mesh.receiveShadow = true;
    this.mesh.renderOrder = -10;
    this.material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.grid);
      shader.vertexShader = shader.vertexShader
        .replace(
          "#include <common>",
          "#include <common>\nvarying vec2 spot, off;\nuniform vec2 shift;",
        )
        .replace(
          "#include <begin_vertex>",
          "#include <begin_vertex>\noff = position.xy;\nspot = (modelMatrix * vec4(position, 1.0)).xy + shift;",
        );
      shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", `#include <common>\n${FUNCTIONS}`)
        .replace("#include <color_fragment>", COLOUR);
    };
  }

  /** Sets the room whose light falls on the table. */
  setEnvironment(room: Texture | null): void {
    this.material.envMap = room;
    this.material.envMapIntensity = 0.3;
  }

  /** Sets the side of a square, in radii of the circle of degrees. */
  setCell(cell: number): void {
    this.grid.cell.value = cell;
  }

  /** Makes the table of glass, which is visible from both sides and hides nothing. */
  setGlass(glass: boolean): void {
    const side = glass ? DoubleSide : FrontSide;
    if (this.material.side === side) return;
    Object.assign(this.material, { side, depthWrite: !glass, opacity: glass ? GLASS : 1 });
    this.mesh.receiveShadow = !glass;
    this.material.needsUpdate = true;
  }

  /** Moves the patch with the camera, while the grid stays. */
  follow(x: number, y: number, z = 0): void {
    this.mesh.position.set(x, y, z);
  }

  /** Moves the grid. */
  slide(x: number, y: number): void {
    this.grid.shift.value.set(-x, -y);
  }

  /** Cuts a square out of the patch, with half a side; without it the patch has no edges. */
  cut(half = ENDLESS): void {
    this.grid.edge.value = half;
  }

  paint({ table, ink, dark }: Palette, color = table): void {
    this.material.color.set(color);
    this.grid.ink.value.set(ink);
    this.grid.depth.value = dark ? 0.085 : 0.17;
    this.grid.grain.value = dark ? 0.035 : 0.075;
  }
}

// Lines are one pixel wide at any distance and fade where they would overlap.
const FUNCTIONS = `
varying vec2 spot, off;
uniform float cell, depth, grain, edge;
uniform vec3 ink;
float lines(vec2 p) {
  vec2 w = fwidth(p);
  vec2 d = abs(fract(p - 0.5) - 0.5) / w;
  vec2 seen = (1.0 - smoothstep(0.4, 1.3, d)) * (1.0 - smoothstep(0.08, 0.35, w));
  return max(seen.x, seen.y);
}
float chance(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float smoothed(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(
    mix(chance(i), chance(i + vec2(1, 0)), f.x),
    mix(chance(i + vec2(0, 1)), chance(i + vec2(1, 1)), f.x),
    f.y
  );
}
// Wood has long fibres, with slow bands across them.
float wood(vec2 p) {
  float bend = smoothed(p * vec2(0.35, 1.1)) * 2.2;
  float bands = smoothed(vec2(p.x * 0.12, p.y * 5.0 + bend));
  float fibres = smoothed(vec2(p.x * 3.0, p.y * 70.0)) * 0.6 + smoothed(vec2(p.x * 7.0, p.y * 160.0)) * 0.4;
  return bands * 0.7 + fibres * 0.45 - 0.55;
}`;

const COLOUR = `
diffuseColor.rgb *= 1.0 + grain * 2.0 * wood(spot);
vec2 squares = spot / cell;
float drawn = max(0.45 * lines(squares), lines(squares / 10.0));
diffuseColor.rgb = mix(diffuseColor.rgb, ink, depth * drawn);
if (max(abs(spot.x), abs(spot.y)) > edge) discard;
float away = length(off);
diffuseColor.a *= 1.0 - smoothstep(1.9, ${EDGE.toFixed(1)}, away);`;
