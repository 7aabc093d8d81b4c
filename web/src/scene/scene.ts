import type { Lab } from "../lab";

export function mountScene(_lab: Lab, _place: HTMLElement): void {}
