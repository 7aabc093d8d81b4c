import type { Lab } from "../lab";

export function mountPlots(_lab: Lab, _place: HTMLElement): void {}
