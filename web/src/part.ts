// The two parts of the page, the essay and the lab, and links to them. The address says which one is shown.

export type Part = "essay" | "lab";

/** The # part of the lab's address with its initial set-up. */
export const LAB = "lab";

/** The # parts that belong to the lab: all with a set-up, and the names of its sections. index.html has the
 * same expression, to show the right part while the page loads. */
const OF_LAB = /=|^#(lab|embed|controls|compare|flicks|plots|share|limits|gyro)$/;

/** The scene of the essay that an address shows alone, in a frame of another page: its name in `#embed/name`. */
export const sceneAlone = (hash: string): string | undefined =>
  /^#embed\/([\w-]+)$/.exec(hash)?.[1];

/** A page that rimroll.lab makes has a set-up in its first element, and shows the lab only. */
export const partOf = (hash: string): Part =>
  document.documentElement.dataset["setup"] !== undefined || OF_LAB.test(hash) ? "lab" : "essay";

export const shownPart = (): Part => document.documentElement.dataset["part"] as Part;

export function showPart(part: Part): void {
  document.documentElement.dataset["part"] = part;
}

// Links to parts of the lab. They scroll without changing the address, whose # part holds the set-up.

export function followAnchors(): void {
  document.addEventListener("click", (event) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const link = (event.target as Element).closest<HTMLAnchorElement>('a[href^="#"]');
    const part = link && document.getElementById(link.hash.slice(1));
    // The essay's scenes, and the lab as a whole, have addresses.
    if (!part || part.id === "lab" || !part.closest("#lab")) return;
    event.preventDefault();
    part.scrollIntoView();
    // The next Tab key continues from there.
    part.focus({ preventScroll: true });
  });
}
