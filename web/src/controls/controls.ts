import type { Lab } from "../lab";

export function mountControls(_lab: Lab, _place: HTMLElement): void {}
