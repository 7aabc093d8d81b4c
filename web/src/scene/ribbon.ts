// Lines on the table with a constant width on the screen.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Mesh,
  ShaderMaterial,
} from "three";

/** Length of a pixel at distance 1, in units of the stage. Everything with a constant size on the screen
 * uses it. */
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
  // Directions in pixels, because the screen is not square.
  vec2 shape = vec2(projectionMatrix[1][1] / projectionMatrix[0][0], 1.0);
  vec2 run = (next.xy / next.w - gl_Position.xy / gl_Position.w) * shape;
  vec2 beside = normalize(vec2(-run.y, run.x)) / shape;
  gl_Position.xy +=
    beside * side * 0.5 * width * pixel * projectionMatrix[1][1] * gl_Position.w;
}`;

// The line is cut at its current end, paler in its older parts, and has soft edges.
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

/** A straight segment. */
export interface Stroke {
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
  color: string;
}

export class Ribbon {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private capacity = 0;
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
      side: DoubleSide, // also from below a table of glass
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

  /** Sets the end of the line and where it becomes paler, counted in points. */
  show(end: number, recent = -1, old = -1): void {
    const { uniforms } = this.mesh.material;
    uniforms.end!.value = end;
    uniforms.recent!.value = recent;
    uniforms.old!.value = old;
    const segments = Math.min(Math.max(Math.ceil(end), 0), Math.max(this.count - 1, 0));
    this.mesh.geometry.setDrawRange(0, 6 * segments);
  }

  /** Draws the line through `count` points of the table; `paint` gives the colour of each. */
  lay(count: number, x: ArrayLike<number>, y: ArrayLike<number>, paint: (k: number) => Color) {
    this.begin(count);
    for (let k = 0; k < count; k++) {
      const a = k > 0 ? k - 1 : 0;
      const b = k < count - 1 ? k + 1 : k;
      this.put(k, x[k]!, y[k]!, x[b]! - x[a]!, y[b]! - y[a]!, paint(k));
    }
  }

  /** Draws separate segments. */
  layStrokes(strokes: readonly Stroke[]): void {
    this.begin(6 * strokes.length);
    strokes.forEach(({ from, to, color }, k) => {
      const paint = new Color(color);
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      // The line has no width between one segment and the next.
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
    if (count > this.capacity) this.grow(count);
    for (const name of ["position", "way", "color"])
      this.mesh.geometry.getAttribute(name).needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, 6 * Math.max(count - 1, 0));
  }

  /** Writes both sides of a point. */
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
    this.capacity = Math.ceil(count * 1.3);
    const geometry = new BufferGeometry();
    const floats = (name: string, size: number) => {
      const numbers = new Float32Array(2 * this.capacity * size);
      geometry.setAttribute(name, new BufferAttribute(numbers, size).setUsage(DynamicDrawUsage));
      return numbers;
    };
    this.positions = floats("position", 3);
    this.ways = floats("way", 2);
    this.colors = floats("color", 3);
    const [sides, places] = [floats("side", 1), floats("place", 1)];
    for (let v = 0; v < 2 * this.capacity; v++) {
      sides[v] = v % 2 ? 1 : -1;
      places[v] = v >> 1;
    }
    const index = new Uint32Array(6 * (this.capacity - 1));
    for (let k = 0; k < this.capacity - 1; k++) {
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
