// The visitor's preference for reduced motion, as the browser reports it.

export const prefersReducedMotion = (): boolean =>
  matchMedia("(prefers-reduced-motion: reduce)").matches;
