// The essay: prose with scenes, of which the one in view is alive.

import { effect } from "@preact/signals-core";
import type { Core } from "../core/core";
import { Lab } from "../lab";
import { sceneAlone } from "../part";
import { startTicker } from "../timing";
import "./alone.css";
import "./essay.css";
import { Figure } from "./figure";
import { SCENES, writeNumbers } from "./scenes";
import { EssayStage } from "./stage";

/** Part of a scene's height that must be in sight for it to be alive. */
const IN_VIEW = 0.35;
/** The address follows the scene in view after this time, ms. */
const SETTLED = 400;
/** What ends the stay at a section that the address names, and the longest time that it lasts, ms. */
const ACTS = ["wheel", "touchstart", "pointerdown", "keydown", "hashchange"] as const;
const FILLED = 3000;
/** Waiting time before a still of a scene is made, ms. */
const IDLE = 60;

export class Essay {
  private readonly lab: Lab;
  private readonly figures: readonly Figure[];
  private stage: EssayStage | undefined;
  private active: Figure | undefined;
  private waiting = false;
  private settling: ReturnType<typeof setTimeout> | undefined;
  /** Scenes near the view, which need stills. */
  private readonly near = new Set<Figure>();
  private stills: ReturnType<typeof setTimeout> | undefined;

  constructor(
    core: Core,
    private readonly root: HTMLElement,
  ) {
    writeNumbers(core, root);
    this.lab = new Lab(core);
    startTicker(this.lab.clock);
    this.figures = SCENES.map((scene) => {
      const place = root.querySelector<HTMLElement>(`#${scene.id} figure`);
      if (!place) throw new Error(`the essay has no scene ${scene.id}`);
      const figure = new Figure(this.lab, scene, place);
      // A control that is used before its scene is in the middle.
      for (const touched of ["pointerdown", "focusin"])
        place.addEventListener(touched, () => this.show(figure));
      return figure;
    });
    const observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) {
          const figure = this.figures.find(({ place }) => place === target);
          if (!figure) continue;
          if (isIntersecting) this.near.add(figure);
          else this.near.delete(figure);
        }
        this.makeStillsSoon();
      },
      { rootMargin: "40% 0%" },
    );
    for (const { place } of this.figures) observer.observe(place);
    for (const moved of ["scroll", "resize"])
      addEventListener(moved, () => this.chooseSoon(), { passive: true });
    effect(() => {
      if (!this.lab.clock.playing.value) this.makeStillsSoon();
    });
  }

  /** Brings the essay to life, at a scene if the address has one. */
  open(hash: string): void {
    this.stage ??= new EssayStage(this.lab, () => {
      const { active } = this;
      if (active) this.place(active);
      this.makeStillsSoon();
    });
    const alone = this.figures.find(({ id }) => id === sceneAlone(hash));
    this.showAlone(alone);
    if (alone) return this.show(alone);
    const there = hash.length > 1 && document.getElementById(hash.slice(1));
    if (there && this.root.contains(there)) this.stayAt(there);
    const asked = this.figures.find(({ id }) => id === hash.slice(1));
    if (asked) this.show(asked);
    else this.choose();
  }

  /** Leaves only one scene on the page, or all if there is none. */
  private showAlone(figure: Figure | undefined): void {
    document.documentElement.classList.toggle("scene-alone", figure !== undefined);
    for (const { id } of this.figures)
      document.getElementById(id)?.classList.toggle("alone", id === figure?.id);
    for (const link of this.root.querySelectorAll<HTMLAnchorElement>("figure a"))
      link.target = figure ? "_blank" : "";
  }

  /** Stops everything and frees the graphics context. */
  close(): void {
    this.show(undefined);
    this.stage?.close();
    this.stage = undefined;
  }

  /** Keeps a section at the top while those above it fill, until the visitor does something. */
  private stayAt(section: HTMLElement): void {
    const go = () => section.scrollIntoView({ behavior: "instant" });
    go();
    const sizes = new ResizeObserver(go);
    sizes.observe(this.root);
    const end = () => {
      sizes.disconnect();
      for (const act of ACTS) removeEventListener(act, end);
    };
    for (const act of ACTS) addEventListener(act, end);
    setTimeout(end, FILLED);
  }

  private chooseSoon(): void {
    if (this.waiting || !this.stage) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      if (this.stage) this.choose();
    });
  }

  /** Brings the scene to life that is nearest to the middle of the window. */
  private choose(): void {
    const height = innerHeight;
    let best: { figure: Figure; apart: number } | undefined;
    for (const figure of this.figures) {
      const box = figure.place.getBoundingClientRect();
      const seen = Math.min(box.bottom, height) - Math.max(box.top, 0);
      const apart = Math.abs((box.top + box.bottom - height) / 2);
      if (seen >= IN_VIEW * box.height && (!best || apart < best.apart)) best = { figure, apart };
    }
    this.show(best?.figure);
  }

  private show(figure: Figure | undefined): void {
    if (figure === this.active || !this.stage) return;
    this.keep();
    this.active = figure;
    if (!figure) return;
    figure.enter(true);
    this.place(figure);
    clearTimeout(this.settling);
    this.settling = setTimeout(() => this.write(), SETTLED);
  }

  /** Keeps a still of the scene that was alive. */
  private keep(): void {
    const { active, stage } = this;
    if (!active) return;
    active.leave();
    if (!stage?.hasPicture) return;
    stage.copyTo(active.still);
    active.hasStill = true;
  }

  private place(figure: Figure): void {
    if (!this.stage) return;
    this.stage.graspable = figure.graspable;
    this.stage.moveTo(figure.place);
  }

  private makeStillsSoon(): void {
    clearTimeout(this.stills);
    this.stills = setTimeout(() => this.makeStill(), IDLE);
  }

  /** Makes the still of one scene near the view; others follow. */
  private makeStill(): void {
    const { active, lab, stage } = this;
    if (!stage?.hasPicture || lab.clock.playing.peek() || lab.held.peek()) return;
    const next = [...this.near].find((figure) => figure !== active && !figure.hasStill);
    if (!next) return;
    active?.leave();
    next.enter(false);
    this.place(next);
    stage.copyTo(next.still);
    next.hasStill = true;
    next.leave();
    if (active) {
      active.enter(false);
      this.place(active);
    }
    this.makeStillsSoon();
  }

  /** Writes the scene in view into the address. */
  private write(): void {
    const { active } = this;
    if (!active || !this.stage || location.protocol === "about:" || sceneAlone(location.hash))
      return;
    const first = active === this.figures[0] && location.hash === "";
    if (!first && location.hash !== `#${active.id}`)
      history.replaceState(null, "", `#${active.id}`);
  }
}
