// The renderer, the lamp and the room that metal reflects. The unit of length of the stage is the radius
// of the circle of degrees, for every body.

import {
  BackSide,
  BoxGeometry,
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  NeutralToneMapping,
  PCFShadowMap,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  WebGLRenderer,
} from "three";
import type { Palette } from "./palette";

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(30, 1, 0.1, 60);
  readonly renderer: WebGLRenderer;
  /** Drawn pixels over pixels of the screen. */
  private resolution = 1;
  private readonly sky = new HemisphereLight();
  private readonly lamp = new DirectionalLight();

  /** Throws if the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    const { shadowMap } = this.renderer;
    shadowMap.enabled = true;
    shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.camera.up.set(0, 0, 1);
    this.light();
    this.buildEnvironment();
  }

  /** Fits the picture to its place; returns whether there is room for it. */
  fit(width: number, height: number): boolean {
    if (width < 2 || height < 2) return false;
    this.renderer.setPixelRatio(this.resolution * Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    return true;
  }

  /** Draws fewer pixels on a slow machine; returns whether that was possible. */
  coarsen(): boolean {
    if (this.resolution < 0.6) return false;
    this.resolution *= 0.8;
    return true;
  }

  paint({ dark }: Palette): void {
    this.sky.color.set(dark ? "#c9dcec" : "#ffffff");
    this.sky.groundColor.set(dark ? "#2a3036" : "#b9ab93");
    this.sky.intensity = dark ? 0.75 : 0.6;
    this.lamp.color.set(dark ? "#ffe9cf" : "#fff6e8");
    this.lamp.intensity = dark ? 2.3 : 2.5;
    this.scene.environmentIntensity = dark ? 0.5 : 0.62;
  }

  /** Keeps the lamp over a spot, so that the shadow of a moving body stays sharp. */
  follow(x: number, y: number): void {
    this.lamp.position.set(x - 2.6, y - 2.2, 6.2);
    this.lamp.target.position.set(x, y, 0);
  }

  /** Frees the graphics context. */
  dispose(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  render(): void {
    this.renderer.render(this.scene, this.camera);
  }

  /** Places a lamp with a soft shadow over the viewer's left shoulder. */
  private light(): void {
    const { lamp } = this;
    this.follow(0, 0);
    lamp.castShadow = true;
    lamp.shadow.mapSize.set(1024, 1024);
    lamp.shadow.radius = 6;
    lamp.shadow.bias = -0.0004;
    lamp.shadow.normalBias = 0.006;
    Object.assign(lamp.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3, near: 1, far: 14 });
    this.scene.add(this.sky, lamp, lamp.target);
  }

  /** Builds the room that shiny bodies reflect, with a window, lamps and a dim floor. It must be built
   * again after a loss of the graphics context. */
  buildEnvironment(): void {
    const room = new Scene();
    const add = (color: string, strength: number, size: number[], at: number[], inside = false) => {
      const material = new MeshBasicMaterial({
        color: new Color(color).multiplyScalar(strength),
        ...(inside && { side: BackSide }),
      });
      const box = new Mesh(new BoxGeometry(...size), material);
      box.position.fromArray(at);
      room.add(box);
    };
    add("#8b9096", 0.75, [20, 20, 12], [0, 0, 4], true);
    add("#ffffff", 9, [7, 0.2, 4], [-3, -9, 5]);
    add("#dfeeff", 6, [0.2, 6, 5], [-9.5, 2, 4]);
    add("#fff1dc", 5, [0.2, 3, 4], [9.5, -3, 4]);
    add("#ffffff", 4, [5, 2, 0.2], [-2, -2, 9.8]);
    add("#eef3f8", 1.7, [11, 0.2, 6], [-4, 9.6, 4]);
    add("#262a2e", 1, [1.4, 0.3, 8], [4, 9, 3]);
    add("#262a2e", 1, [1.4, 0.3, 8], [-5, 9, 3]);
    add("#a59880", 0.8, [20, 20, 0.2], [0, 0, -1.9]);
    this.scene.environment?.dispose();
    const generator = new PMREMGenerator(this.renderer);
    this.scene.environment = generator.fromScene(room, 0.03, 0.1, 100, { size: 128 }).texture;
    generator.dispose();
  }
}

// Detects a machine that draws frames too slowly.

/** Number of frames over which the rate is averaged. */
const WINDOW = 24;
/** Longest average time of a frame that looks smooth, ms. */
const SLOW = 28;
/** After a longer interval than this, ms, nothing was drawn in between. */
const REST = 400;

export class FrameRate {
  private before = 0;
  private count = 0;
  private sum = 0;

  /** Registers a frame at a time, ms; returns true after WINDOW frames that were slow on average. */
  isSlow(now: number): boolean {
    const passed = now - this.before;
    this.before = now;
    if (passed > REST) {
      this.count = this.sum = 0;
      return false;
    }
    this.sum += passed;
    if (++this.count < WINDOW) return false;
    const slow = this.sum / this.count > SLOW;
    this.count = this.sum = 0;
    return slow;
  }
}
