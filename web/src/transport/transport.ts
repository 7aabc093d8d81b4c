import type { Lab } from "../lab";

export function mountTransport(_lab: Lab, _place: HTMLElement): void {}
