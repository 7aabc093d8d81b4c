// The camera.

import { PerspectiveCamera, Vector3 } from "three";
import { afterEach, describe, expect, test, vi } from "vitest";
import { View } from "../../src/scene/view";

afterEach(() => vi.unstubAllGlobals());

/** A view of a can whose rim has half the radius of the circle of degrees. */
function viewOf(aspect: number, still = false) {
  vi.stubGlobal("matchMedia", () => ({ matches: still }));
  const camera = new PerspectiveCamera(30, aspect, 0.1, 60);
  const view = new View(camera);
  view.frame(1.33, 0.5);
  const contactAt = (angle: number) => {
    const spot = new Vector3(0.5 * Math.cos(angle), 0.5 * Math.sin(angle), 0);
    view.aim(spot, { x: 0, y: 0 });
    return spot;
  };
  /** How far from the middle of the picture a spot is: 1 is its edge. */
  const aside = (spot: Vector3) => {
    view.update(0);
    camera.updateMatrixWorld();
    const { x, y, z } = spot.clone().project(camera);
    expect(z).toBeLessThan(1);
    return Math.max(Math.abs(x), Math.abs(y));
  };
  return { view, contactAt, aside };
}

describe("zoomed in, the camera sees the contact point", () => {
  test.each([
    ["a telephone", 360 / 318],
    ["a laptop", 900 / 430],
    ["a tall picture", 0.5],
  ])("on %s, from every side and height, wherever it is", (_, aspect) => {
    for (const azimuth of [0, 1, 2.5, 4])
      for (const height of [-15, 0, 15])
        for (const angle of [0, 1.5, 3, 4.5]) {
          const { view, contactAt, aside } = viewOf(aspect);
          const spot = contactAt(angle);
          view.turn(azimuth, 0.06 * height);
          for (let press = 0; press < 15; press++) view.zoom(0.9);
          expect(aside(spot)).toBeLessThan(0.1);
          // Also while it runs round the rim.
          expect(aside(contactAt(angle + 2))).toBeLessThan(0.1);
        }
  });

  test("the contact point never leaves the picture while zooming in", () => {
    const { view, contactAt, aside } = viewOf(2);
    const spot = contactAt(2);
    for (let press = 0; press < 25; press++) {
      expect(aside(spot)).toBeLessThan(0.9);
      view.zoom(0.9);
    }
  });
});

test("from afar the camera stays still while the contact point runs round", () => {
  const { contactAt, aside } = viewOf(2);
  const before = aside(contactAt(0));
  contactAt(2);
  expect(aside(new Vector3(0.5, 0, 0))).toBe(before);
});

test("with reduced motion the camera moves only when the visitor zooms", () => {
  const { view, contactAt, aside } = viewOf(2, true);
  const first = contactAt(0);
  for (let press = 0; press < 15; press++) view.zoom(0.9);
  const second = contactAt(2);
  expect(aside(first)).toBeLessThan(0.1);
  expect(aside(second)).toBeGreaterThan(0.5);
  view.zoom(0.9);
  expect(aside(second)).toBeLessThan(0.1);
});

describe("where the rim fills the picture", () => {
  test.each(["contact", "below"] as const)(
    "%s: the camera stays still, and the contact point is seen to run round",
    (place) => {
      for (const aspect of [360 / 340, 900 / 430]) {
        const { view, contactAt, aside } = viewOf(aspect);
        const fixed = contactAt(0).multiplyScalar(0.4);
        view.cut(place);
        const before = aside(fixed);
        for (let angle = 0; angle < 6.3; angle += 0.3) {
          expect(aside(contactAt(angle))).toBeLessThan(0.9);
          expect(aside(fixed)).toBe(before);
        }
        // The point runs far over the picture.
        expect(aside(contactAt(0.2))).toBeGreaterThan(place === "contact" ? 0.4 : 0.25);
      }
    },
  );

  test("the camera goes along with a body that rolls away", () => {
    const { view, aside } = viewOf(2);
    view.cut("contact");
    view.aim({ x: 4.5, y: 3 }, { x: 4, y: 3 });
    expect(aside(new Vector3(4, 3, 0))).toBeLessThan(0.01);
  });
});
