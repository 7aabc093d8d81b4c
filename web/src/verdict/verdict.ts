import type { Lab } from "../lab";

export function mountVerdict(_lab: Lab, _place: HTMLElement): void {}
