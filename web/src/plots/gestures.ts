// Gestures on a plot. Mouse: drag across to zoom, click or drag the time line to scrub, turn the wheel to
// zoom about the pointer. The wheel zooms only after a click on the plot or with Ctrl, so that the page
// still scrolls past it. Touch: one finger scrubs, two zoom.

/** Actions of the plot; places are 0 at its left end and 1 at its right. */
export interface Handlers {
  scrub(place: number): void;
  /** Place of the time line. */
  now(): number;
  /** Marks the range to zoom to, or nothing if undefined. */
  select(range: [number, number] | undefined): void;
  zoomTo(range: [number, number]): void;
  zoom(factor: number, about: number): void;
  canZoomOut(): boolean;
  reset(): void;
}

/** Largest movement during a click, CSS px. */
const JITTER = 4;
/** Largest distance from the time line at which it is grabbed, CSS px. */
const REACH = 7;

export function attachGestures(pad: HTMLElement, focused: HTMLElement, handlers: Handlers): void {
  const fingers = new Map<number, number>();
  let begun: { place: number; scrubs: boolean } | undefined;

  const placeOf = (event: MouseEvent) => {
    const { left, width } = pad.getBoundingClientRect();
    return Math.min(Math.max((event.clientX - left) / width, 0), 1);
  };
  const wide = (part: number) => Math.abs(part) * pad.clientWidth;

  pad.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const place = placeOf(event);
    pad.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place);
    const onLine = wide(place - handlers.now()) <= REACH;
    begun = { place, scrubs: event.pointerType === "touch" || onLine };
    if (fingers.size > 1) begun = undefined;
  });

  pad.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    const place = placeOf(event);
    pad.classList.toggle("on-line", wide(place - handlers.now()) <= REACH);
    if (before === undefined) return;
    if (fingers.size === 2) pinch(event.pointerId, place);
    else if (begun?.scrubs) handlers.scrub(place);
    else if (begun && wide(place - begun.place) > JITTER) handlers.select([begun.place, place]);
    fingers.set(event.pointerId, place);
  });

  pad.addEventListener("pointerup", (event) => {
    const place = placeOf(event);
    handlers.select(undefined);
    if (begun && !begun.scrubs && wide(place - begun.place) > JITTER)
      handlers.zoomTo([Math.min(begun.place, place), Math.max(begun.place, place)]);
    else if (begun) handlers.scrub(place);
    lift(event);
  });

  pad.addEventListener("pointercancel", (event) => {
    handlers.select(undefined);
    lift(event);
  });

  pad.addEventListener("dblclick", () => handlers.reset());

  pad.addEventListener(
    "wheel",
    (event) => {
      const meant = event.ctrlKey || focused.contains(document.activeElement);
      const zoomsOut = event.deltaY > 0;
      if (!meant || event.deltaY === 0 || (zoomsOut && !handlers.canZoomOut())) return;
      event.preventDefault();
      // A notch of a wheel is about 100 px; a touch pad sends many smaller steps.
      const notches = Math.max(-1, Math.min(1, event.deltaY / (event.ctrlKey ? 20 : 100)));
      handlers.zoom(1.6 ** -notches, placeOf(event));
    },
    { passive: false },
  );

  function pinch(moved: number, to: number): void {
    const [first, second] = [...fingers.keys()] as [number, number];
    const still = fingers.get(moved === first ? second : first) as number;
    const apart = Math.abs(still - (fingers.get(moved) as number));
    const factor = Math.abs(still - to) / Math.max(apart, 1e-3);
    handlers.zoom(Math.min(Math.max(factor, 0.5), 2), still);
  }

  function lift(event: PointerEvent): void {
    fingers.delete(event.pointerId);
    begun = undefined;
  }
}
