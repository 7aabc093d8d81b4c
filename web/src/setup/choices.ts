// What is said of a choice that there is not.

/** Of what is called so, with the names that a visitor reads, not those of the link. */
export function noSuchChoice(label: string, names: readonly string[], text: string): string {
  const all = [names.slice(0, -1).join(", "), ...names.slice(-1)].join(" or ");
  return `${label}: there is no “${text}”; choose ${all}.`;
}
