import type { Lab } from "../lab";

export function mountStory(_lab: Lab, _place: HTMLElement): void {}
