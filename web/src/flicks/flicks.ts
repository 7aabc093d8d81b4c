import type { Lab } from "../lab";

export function mountFlicks(_lab: Lab, _place: HTMLElement): void {}
