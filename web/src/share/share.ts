import type { Lab } from "../lab";

export function mountShare(_lab: Lab, _place: HTMLElement): void {}
