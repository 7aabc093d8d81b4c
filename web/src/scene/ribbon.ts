// Lines on the table that are as wide on the screen at any distance.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Mesh,
  ShaderMaterial,
} from "three";

/** Shared by all that is as large on the screen at any distance: the length (of the stage) of a pixel
 * at distance 1. */
export const PIXEL = { value: 0.001 };

const VERTEX = `
attribute vec2 way;
attribute float side;
attribute float place;
attribute vec3 color;
uniform float pixel, width;
varying float at;
varying float across;
varying vec3 paint;
void main() {
  at = place;
  across = side;
  paint = color;
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  vec3 along = (modelViewMatrix * vec4(way, 0.0, 0.0)).xyz;
  float size = length(along);
  gl_Position = projectionMatrix * seen;
  if (size == 0.0) return;
  vec4 next = projectionMatrix * vec4(seen.xyz + along / size * 1e-3, 1.0);
  // In pixels: the screen is not as high as it is wide.
  vec2 shape = vec2(projectionMatrix[1][1] / projectionMatrix[0][0], 1.0);
  vec2 run = (next.xy / next.w - gl_Position.xy / gl_Position.w) * shape;
  vec2 beside = normalize(vec2(-run.y, run.x)) / shape;
  gl_Position.xy +=
    beside * side * 0.5 * width * pixel * projectionMatrix[1][1] * gl_Position.w;
}`;

// Cut where it ends just now, paler where it is old, its edges soft.
const FRAGMENT = `
uniform float end, recent, old, opacity;
varying float at;
varying float across;
varying vec3 paint;
void main() {
  if (at > end) discard;
  float age = at < old ? 0.12 : at < recent ? 0.34 : 1.0;
  float soft = 1.0 - smoothstep(0.72, 1.0, abs(across));
  gl_FragColor = vec4(paint, opacity * age * soft);
  #include <colorspace_fragment>
}`;

/** A straight piece of a line. */
export interface Stroke {
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
  color: string;
}

export class Ribbon {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private room = 0;
  private positions = new Float32Array(0);
  private ways = new Float32Array(0);
  private colors = new Float32Array(0);
  private count = 0;

  constructor(width: number, opacity = 1) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        pixel: PIXEL,
        width: { value: width },
        opacity: { value: opacity },
        end: { value: Infinity },
        recent: { value: -1 },
        old: { value: -1 },
      },
    });
    this.mesh = new Mesh(new BufferGeometry(), material);
    this.mesh.frustumCulled = false;
  }

  /** How far it is drawn, and where it becomes paler, counted in its points. */
  show(end: number, recent = -1, old = -1): void {
    const { uniforms } = this.mesh.material;
    uniforms.end!.value = end;
    uniforms.recent!.value = recent;
    uniforms.old!.value = old;
    const pieces = Math.min(Math.max(Math.ceil(end), 0), Math.max(this.count - 1, 0));
    this.mesh.geometry.setDrawRange(0, 6 * pieces);
  }

  /** Lays it through `count` points of the table; `paint` gives each its colour. */
  lay(count: number, x: ArrayLike<number>, y: ArrayLike<number>, paint: (k: number) => Color) {
    this.begin(count);
    for (let k = 0; k < count; k++) {
      const a = k > 0 ? k - 1 : 0;
      const b = k < count - 1 ? k + 1 : k;
      this.put(k, x[k]!, y[k]!, x[b]! - x[a]!, y[b]! - y[a]!, paint(k));
    }
  }

  /** Lays it in straight pieces that do not hang together. */
  layStrokes(strokes: readonly Stroke[]): void {
    this.begin(6 * strokes.length);
    strokes.forEach(({ from, to, color }, k) => {
      const paint = new Color(color);
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      // It is without width on the way from one piece to the next.
      this.put(6 * k, ...from, 0, 0, paint);
      this.put(6 * k + 1, ...from, 0, 0, paint);
      this.put(6 * k + 2, ...from, dx, dy, paint);
      this.put(6 * k + 3, ...to, dx, dy, paint);
      this.put(6 * k + 4, ...to, 0, 0, paint);
      this.put(6 * k + 5, ...to, 0, 0, paint);
    });
  }

  private begin(count: number): void {
    this.count = count;
    if (count > this.room) this.grow(count);
    for (const name of ["position", "way", "color"])
      this.mesh.geometry.getAttribute(name).needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, 6 * Math.max(count - 1, 0));
  }

  /** Puts down both sides of a point. */
  private put(k: number, x: number, y: number, dx: number, dy: number, paint: Color): void {
    const { positions, ways, colors } = this;
    for (let v = 2 * k; v < 2 * k + 2; v++) {
      positions[3 * v] = x;
      positions[3 * v + 1] = y;
      ways[2 * v] = dx;
      ways[2 * v + 1] = dy;
      colors[3 * v] = paint.r;
      colors[3 * v + 1] = paint.g;
      colors[3 * v + 2] = paint.b;
    }
  }

  private grow(count: number): void {
    this.mesh.geometry.dispose();
    this.room = Math.ceil(count * 1.3);
    const geometry = new BufferGeometry();
    const floats = (name: string, size: number) => {
      const numbers = new Float32Array(2 * this.room * size);
      geometry.setAttribute(name, new BufferAttribute(numbers, size).setUsage(DynamicDrawUsage));
      return numbers;
    };
    this.positions = floats("position", 3);
    this.ways = floats("way", 2);
    this.colors = floats("color", 3);
    const [sides, places] = [floats("side", 1), floats("place", 1)];
    for (let v = 0; v < 2 * this.room; v++) {
      sides[v] = v % 2 ? 1 : -1;
      places[v] = v >> 1;
    }
    const index = new Uint32Array(6 * (this.room - 1));
    for (let k = 0; k < this.room - 1; k++) {
      const a = 2 * k;
      index[6 * k] = a;
      index[6 * k + 1] = index[6 * k + 4] = a + 2;
      index[6 * k + 2] = index[6 * k + 3] = a + 1;
      index[6 * k + 5] = a + 3;
    }
    geometry.setIndex(new BufferAttribute(index, 1));
    this.mesh.geometry = geometry;
  }
}
